/* What a reader left out; see reading.h. */
#include "reference/formats/reading.h"

static const char *const slugs[READING_KINDS] = {[READING_LOST_VERTEX] = "lost-vertex",
                                                 [READING_SHORT_FACE] = "short-face",
                                                 [READING_STATEMENT] = "unknown-statement",
                                                 [READING_NO_KEYWORD] = "no-keyword",
                                                 [READING_REST] = "bytes-behind-the-end"};

const char *reading_slug(enum reading_kind kind)
{
    return slugs[kind];
}

static void say_place(const struct reading_note *note, struct message *message)
{
    long long place = (long long)note->place;
    bool many = note->count > 1;
    if (note->is_byte)
        message_add(message, many ? ", first at byte %lld." : ", at byte %lld.",
                    many ? ", primero en el byte %lld." : ", en el byte %lld.", place);
    else
        message_add(message, many ? ", first in line %lld." : ", in line %lld.",
                    many ? ", primero en la línea %lld." : ", en la línea %lld.", place);
}

void reading_say(const struct reading *reading, enum reading_kind kind, struct message *message)
{
    const struct reading_note *note = &reading->notes[kind];
    long long count = (long long)note->count;
    bool many = count > 1;
    switch (kind) {
    case READING_LOST_VERTEX:
        message_say(message,
                    many ? "%lld vertices that are not finite and that no face uses are left out"
                         : "%lld vertex that is not finite and that no face uses is left out",
                    many ? "Se omiten %lld vértices no finitos que ninguna cara usa"
                         : "Se omite %lld vértice no finito que ninguna cara usa",
                    count);
        break;
    case READING_SHORT_FACE:
        message_say(message,
                    many ? "%lld faces of fewer than 3 corners are left out"
                         : "%lld face of fewer than 3 corners is left out",
                    many ? "Se omiten %lld caras de menos de 3 esquinas"
                         : "Se omite %lld cara de menos de 3 esquinas",
                    count);
        break;
    case READING_STATEMENT:
        message_say(message,
                    many ? "%lld lines with other statements (\"%s\") are skipped"
                         : "%lld line with another statement (\"%s\") is skipped",
                    many ? "Se saltan %lld líneas con otras sentencias («%s»)"
                         : "Se salta %lld línea con otra sentencia («%s»)",
                    count, note->text);
        break;
    case READING_NO_KEYWORD:
        message_say(message, "The file begins without the word OFF and is read as one that has it",
                    "El archivo empieza sin la palabra OFF y se lee como si la tuviera");
        break;
    default:
        message_say(message,
                    many ? "%lld bytes behind the end of the mesh are not read"
                         : "%lld byte behind the end of the mesh is not read",
                    many ? "No se leen %lld bytes que siguen al final de la malla"
                         : "No se lee %lld byte que sigue al final de la malla",
                    count);
    }
    say_place(note, message);
}
