/* What an exercise's function answers, declared once: from the declaration an answer is read,
 * bounded and looked through for what no right answer has, with the same words everywhere.
 *
 *     static const struct answer_rule edges = {
 *         .function = "edge_table_any",
 *         .result = RESULT_COUNT,
 *         .counted = {"edges", "aristas"},
 *         .most = {.per_face = 3},
 *         .parts = {{.argument = "*edges", .row = {"edge", "arista"}, .columns = 2,
 *                    .of = OF_VERTEX, .rows = ROWS_RESULT}}};
 *
 * The runner's side of the same answer is graders/runner/shapes.h. Packet: the result (8 bytes),
 * then, unless it is a refusal, every part as write_table writes it; a part of rows of unequal
 * length is two tables, the offsets and the values. */
#ifndef GRADERS_LIBRARY_ANSWER_H
#define GRADERS_LIBRARY_ANSWER_H

#include "graders/library/judgement.h"
#include "graders/wire/packet.h"

/* How large an input is. */
struct input_sizes {
    int64_t vertices, faces, corners; /* corners: of all faces together */
};

/* A number that follows from these sizes; all zero: 0. */
struct room {
    int64_t once, per_vertex, per_face, per_corner;
};
int64_t answer_room(struct room room, struct input_sizes sizes);

/* What the function itself returns. */
enum answer_result {
    RESULT_STATUS, /* 0, or a refusal */
    RESULT_COUNT,  /* 0 or more, or a refusal */
    RESULT_REAL    /* a double; there are no refusals */
};

/* How many rows a part has. */
enum part_rows {
    ROWS_RESULT, /* as many as the function returned; made by the student with malloc */
    ROWS_FIXED,  /* exactly `most`: an array of the caller's, or one block of known size */
    ROWS_OF_ROWS /* RESULT rows of unequal length: offsets (one more than rows), then values; for no
                    row both may be NULL, and are not looked at */
};

enum part_type { TYPE_INT32, TYPE_FLOAT, TYPE_DOUBLE, TYPE_BYTE };

/* What the numbers of a part name; what is out of range is refused before the judge sees it. */
enum index_of { OF_NOTHING, OF_VERTEX, OF_FACE, OF_CORNER, OF_RESULT };

enum { ANSWER_PARTS = 4, ANSWER_COLUMNS = 8, ANSWER_CODES = 4 };

/* A column with a name of its own, where columns differ. */
struct answer_column {
    const char *name; /* "vi" */
    enum index_of of;
    bool may_be_none; /* -1 is "there is none" */
};

struct answer_part {
    const char *argument;         /* as the header writes it, "*edges"; NULL ends the list */
    struct phrase row;            /* one row: {"edge", "arista"} */
    const char *offsets, *values; /* of ROWS_OF_ROWS: its two tables by name; NULL: as argument */
    enum part_type type;
    int columns;                                 /* values a row; of ROWS_OF_ROWS: 1 */
    enum index_of of;                            /* of every column */
    bool may_be_none;                            /* -1 is "there is none", in every column */
    struct answer_column column[ANSWER_COLUMNS]; /* or each by itself; without names: as above */
    enum part_rows rows;
    struct room most; /* ROWS_FIXED: rows; ROWS_OF_ROWS: values of a right answer at most */
};

/* An attribute that the function writes into an array of the caller's: normals, colours, labels.
 * Reals that are not finite are refused before the judge sees them, here as in every part.
 *
 *     .parts = {ANSWER_PER_CORNER("normals", TYPE_FLOAT, 3)} */
#define ANSWER_PER_VERTEX(array, type_, columns_)                                                  \
    {                                                                                              \
        .argument = (array), .row = {"vertex", "vértice"}, .type = (type_), .columns = (columns_), \
        .rows = ROWS_FIXED, .most = {                                                              \
            .per_vertex = 1                                                                        \
        }                                                                                          \
    }
#define ANSWER_PER_CORNER(array, type_, columns_)                                                  \
    {                                                                                              \
        .argument = (array), .row = {"corner", "esquina"}, .type = (type_), .columns = (columns_), \
        .rows = ROWS_FIXED, .most = {                                                              \
            .per_corner = 1                                                                        \
        }                                                                                          \
    }
#define ANSWER_PER_FACE(array, type_, columns_)                                                    \
    {                                                                                              \
        .argument = (array), .row = {"face", "cara"}, .type = (type_), .columns = (columns_),      \
        .rows = ROWS_FIXED, .most = {                                                              \
            .per_face = 1                                                                          \
        }                                                                                          \
    }

/* A refusal that the exercise knows, besides OUT_OF_MEMORY. */
struct answer_code {
    int value;        /* -2; 0 ends the list */
    const char *name; /* "NOT_MANIFOLD" */
};

struct answer_rule {
    const char *function;
    enum answer_result result;
    struct phrase counted; /* what RESULT_COUNT counts, in the plural */
    struct room most;      /* that a right answer counts at most */
    struct answer_part parts[ANSWER_PARTS];
    struct answer_code codes[ANSWER_CODES];
};

/* A table of an answer, in place. */
struct answer_table {
    const void *cells; /* of the part's type; NULL only when there are no rows */
    int64_t count;     /* rows; of ROWS_OF_ROWS: values */
    int columns;
    /* of ROWS_OF_ROWS: row r is values first[r] ... first[r + 1] - 1; rises, within the values */
    const int32_t *first;
    int64_t row_count;
};

/* An answer that was read. */
struct answer {
    int64_t result;                    /* a count or status; a refusal's code */
    double real;                       /* of RESULT_REAL */
    const struct answer_code *refusal; /* NULL: it answers */
    struct answer_table table[ANSWER_PARTS];
};

/* Bytes that an answer can take: twice what a right one takes at most, and sixteen rows more, so
 * that also wrong answers have room and are told by what is wrong with them. */
size_t answer_bound(const struct answer_rule *rule, struct input_sizes sizes);

/* Reads an answer. Rejects one that is cut short or that no right answer can look like: a count
 * below zero or far too large, a table that is NULL, offsets that do not rise, an index out of
 * range. Returns whether the judge can go on; otherwise `out` has the rejection. */
bool answer_read(const struct answer_rule *rule, struct input_sizes sizes, struct span bytes,
                 struct answer *answer, struct judgement *out);

/* Names a place in the tables of an answer, as the student knows it: "entry 3 of *edges", "vf of row
 * 2 of *edges", "what edge_table_any returns".
 *
 * rule    NULL: the judge declares none
 * table   0: what was returned; else the how-manieth table of the packet
 * byte    of the table */
void answer_place(const struct answer_rule *rule, uint32_t table, int64_t byte,
                  struct message *place);

/* Shorthands for tables of int32 and of floats and doubles: the value in a row and column, which must exist. */
static inline int32_t answer_int(const struct answer_table *table, int64_t row, int column)
{
    return ((const int32_t *)table->cells)[row * table->columns + column];
}

static inline double answer_float(const struct answer_table *table, int64_t row, int column)
{
    return (double)((const float *)table->cells)[row * table->columns + column];
}

static inline double answer_double(const struct answer_table *table, int64_t row, int column)
{
    return ((const double *)table->cells)[row * table->columns + column];
}

/* Answers a question that many contracts have: is the input one that must be refused?
 *
 * wanted    the refusal that is right, by its name in the rule's codes; NULL: an answer is
 * why       why it is right, both languages: "vertex 3 has two fans"; empty when wanted is NULL
 * returns   whether the judge goes on to the answer's tables: it answered and should. Otherwise out
 *           is accepted (rightly refused) or rejected */
bool answer_refuses_rightly(const struct answer_rule *rule, const struct answer *answer,
                            const char *wanted, const struct message *why, struct judgement *out);

#endif
