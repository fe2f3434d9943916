/* What a reader left out of a file, so that who asked for the mesh can be told.
 *
 *     struct reading reading = {0};
 *     if (mesh_file_read_told(path, &mesh, &reading, err))
 *         return -1;
 *     for (int kind = 0; kind < READING_KINDS; kind++)
 *         if (reading.notes[kind].count > 0)
 *             ... reading_say(&reading, kind, &message) ...
 *
 * A reader that is given no reading (NULL) leaves out nothing: then all of these are errors. */
#ifndef REFERENCE_FORMATS_READING_H
#define REFERENCE_FORMATS_READING_H

#include "reference/base/phrase.h"

#include <stdbool.h>
#include <stdint.h>

enum reading_kind {
    READING_LOST_VERTEX, /* vertices with a coordinate that is not finite, which no face uses. The
                            vertices after such a one have lower numbers in the mesh */
    READING_SHORT_FACE,  /* faces with fewer than 3 corners */
    READING_STATEMENT,   /* OBJ: lines whose statement is none that the format knows */
    READING_NO_KEYWORD,  /* OFF: the file begins with its counts; nothing is left out */
    READING_REST,        /* bytes behind the end of the mesh */
    READING_KINDS
};

struct reading_note {
    int64_t count; /* how many; 0: none, and the rest has no meaning */
    int64_t place; /* line of the first (from 1), in binary data its byte */
    bool is_byte;
    char text[48]; /* of READING_STATEMENT: the first one's keyword; printable ASCII */
};

struct reading {
    struct reading_note notes[READING_KINDS];
};

/* A machine's word for a kind: "lost-vertex". */
const char *reading_slug(enum reading_kind kind);

/* Says in one sentence what was left out, how often, and where first. */
void reading_say(const struct reading *reading, enum reading_kind kind, struct message *message);

#endif
