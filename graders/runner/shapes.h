/* The runner's side of answers that a judge declares (graders/library/answer.h): two lines an
 * exercise, in graders/runner/<group>/<name>.c.
 *
 *     #include "edge-table-any.h"
 *     #include "graders/runner/shapes.h"
 *
 *     CALL_TABLE(edge_table_any, TRIANGLES, int32_t, 2)
 *
 * The first word says what the function returns and makes, the second what it gets, in the order of
 * the headers' arguments:
 *
 *     TRIANGLES   triangles, triangle_count, vertex_count
 *     MESH        positions, vertex_count, triangles, triangle_count
 *     POLYGONS    first_corner, corners, face_count, vertex_count
 *     SOUP        corners, triangle_count
 *     LINE        points, point_count, is_closed
 *
 * and more arguments may follow in parentheses' stead: `MESH, NUMBER(0)`, written GIVEN(MESH,
 * NUMBER(0)); of what a judge's `attributes` declare, GIVEN(MESH, ATTRIBUTE(0)). What has none of these shapes is written by hand: see call.h and the functions here.
 */
#ifndef GRADERS_RUNNER_SHAPES_H
#define GRADERS_RUNNER_SHAPES_H

#include "graders/runner/call.h"

enum { SHAPES_NUMBERS = 4, SHAPES_ATTRIBUTES = 2 };

/* What a packet gives; what the exercise's input does not have stays zero. */
struct given {
    int32_t vertex_count, face_count;
    const float *positions;
    const int32_t *triangles;
    const int32_t *first_corner, *corners;
    int64_t corner_count;
    const float *points; /* of a line, of a field its samples, of a soup its corners */
    int32_t point_count, is_closed, rows, columns, layers;
    int64_t number[SHAPES_NUMBERS];
    const float *attribute[SHAPES_ATTRIBUTES]; /* in the order in which the judge declares them */
};

/* Read what the judge's inputs write: INPUT_MESH and INPUT_TOPOLOGY, INPUT_POLYGONS, and so on. What
 * the judge writes beside (judge.h, write_beside) is next in the packet. */
struct given given_triangles(struct reader *input);
struct given given_polygons(struct reader *input);
struct given given_soup(struct reader *input);  /* points, face_count */
struct given given_line(struct reader *input);  /* points, point_count, is_closed */
struct given given_field(struct reader *input); /* points, rows, columns, layers */

/* An array that the caller gives to the student, of `count` rows; from the heap, so that tools see a
 * step outside. It lives until the next call. Ends the process when memory runs out, before the
 * student's code was called. */
void *given_array(int64_t count, size_t row_bytes);

/* Room for one of many answers, each behind the one before: for one call it is lent to the student,
 * and then taken back with what he used of it. It is the place itself; where tools look, it is a block
 * of its own, so that they see a step outside. */
#ifdef RUNNER_WITHOUT_SHIM
int32_t *lend_room(int32_t *place, int32_t capacity);
void take_room(int32_t *place, int32_t *lent, int32_t used);
#else
static inline int32_t *lend_room(int32_t *place, int32_t capacity)
{
    (void)capacity;
    return place;
}

static inline void take_room(int32_t *place, int32_t *lent, int32_t used)
{
    (void)place;
    (void)lent;
    (void)used;
}
#endif

/* Writes the result. Returns whether tables follow: it is no refusal. */
bool answer_result(struct writer *answer, int64_t result);

/* Writes a table that the student made, or offsets and values, and frees them. */
void answer_table(struct writer *answer, int64_t count, void *table, size_t row_bytes);
void answer_rows(struct writer *answer, int64_t count, int32_t *first, int32_t *values);

/* Writes an array of the caller's, which given_array made. */
void answer_given(struct writer *answer, int64_t count, void *array, size_t row_bytes);

#define TRIANGLES given_triangles, given.triangles, given.face_count, given.vertex_count
#define MESH given_triangles, given.positions, given.vertex_count, given.triangles, given.face_count
#define POLYGONS                                                                                   \
    given_polygons, given.first_corner, given.corners, given.face_count, given.vertex_count
#define SOUP given_soup, given.points, given.face_count
#define LINE given_line, given.points, given.point_count, given.is_closed
#define GIVEN(...) __VA_ARGS__
#define NUMBER(i) given.number[i]
#define ATTRIBUTE(i) given.attribute[i]

/* The first of what is given reads the packet, the others are arguments. */
#define SHAPES_READER(reader, ...) reader
#define SHAPES_ARGUMENTS(reader, ...) __VA_ARGS__
#define SHAPES_EXPAND(macro, ...) macro(__VA_ARGS__)
#define SHAPES_READ(...) SHAPES_EXPAND(SHAPES_READER, __VA_ARGS__)(input)
#define SHAPES_PASS(...) SHAPES_EXPAND(SHAPES_ARGUMENTS, __VA_ARGS__)

/* A number that is never below 0, an area or a length: double f(given), or OUT_OF_MEMORY. */
#define CALL_REAL(function, ...)                                                                   \
    void run_call(struct reader *input, struct writer *answer)                                     \
    {                                                                                              \
        struct given given = SHAPES_READ(__VA_ARGS__);                                             \
        measure_begin();                                                                           \
        double result = function(SHAPES_PASS(__VA_ARGS__));                                        \
        measure_end();                                                                             \
        look_at_result(&result, sizeof result);                                                    \
        if (result == OUT_OF_MEMORY)                                                               \
            call_out_of_memory();                                                                  \
        else                                                                                       \
            write_real(answer, result);                                                            \
    }

#define SHAPES_CALL(what, ...)                                                                     \
    measure_begin();                                                                               \
    int64_t result = what(__VA_ARGS__);                                                            \
    measure_end();                                                                                 \
    look_at_result(&result, sizeof result);                                                        \
    if (result == OUT_OF_MEMORY) {                                                                 \
        call_out_of_memory();                                                                      \
        return;                                                                                    \
    }

/* A table with as many rows as are returned: count f(given, type **table). */
#define CALL_TABLE(function, what, type, columns)                                                  \
    void run_call(struct reader *input, struct writer *answer)                                     \
    {                                                                                              \
        struct given given = SHAPES_READ(what);                                                    \
        type *table = NULL;                                                                        \
        SHAPES_CALL(function, SHAPES_PASS(what), &table)                                           \
        if (answer_result(answer, result))                                                         \
            answer_table(answer, result, table, sizeof(type) * (columns));                         \
    }

/* Rows of unequal length: count f(given, int32_t **first, int32_t **values). */
#define CALL_ROWS(function, what)                                                                  \
    void run_call(struct reader *input, struct writer *answer)                                     \
    {                                                                                              \
        struct given given = SHAPES_READ(what);                                                    \
        int32_t *first = NULL, *values = NULL;                                                     \
        SHAPES_CALL(function, SHAPES_PASS(what), &first, &values)                                  \
        if (answer_result(answer, result))                                                         \
            answer_rows(answer, result, first, values);                                            \
    }

/* An array of the caller's: result f(given, type *array), with `count` rows. */
#define CALL_GIVEN(function, what, type, columns, count)                                           \
    void run_call(struct reader *input, struct writer *answer)                                     \
    {                                                                                              \
        struct given given = SHAPES_READ(what);                                                    \
        type *array = given_array((count), sizeof(type) * (columns));                              \
        SHAPES_CALL(function, SHAPES_PASS(what), array)                                            \
        if (answer_result(answer, result))                                                         \
            answer_given(answer, (count), array, sizeof(type) * (columns));                        \
    }

/* A table and an array: count f(given, type **table, type2 *array). */
#define CALL_TABLE_GIVEN(function, what, type, columns, type2, count2)                             \
    void run_call(struct reader *input, struct writer *answer)                                     \
    {                                                                                              \
        struct given given = SHAPES_READ(what);                                                    \
        type *table = NULL;                                                                        \
        type2 *array = given_array((count2), sizeof(type2));                                       \
        SHAPES_CALL(function, SHAPES_PASS(what), &table, array)                                    \
        if (!answer_result(answer, result))                                                        \
            return;                                                                                \
        answer_table(answer, result, table, sizeof(type) * (columns));                             \
        answer_given(answer, (count2), array, sizeof(type2));                                      \
    }

/* A table and two arrays: count f(given, type **table, type2 *array, type3 *other). */
#define CALL_TABLE_GIVEN_TWO(function, what, type, columns, type2, count2, type3, count3)          \
    void run_call(struct reader *input, struct writer *answer)                                     \
    {                                                                                              \
        struct given given = SHAPES_READ(what);                                                    \
        type *table = NULL;                                                                        \
        type2 *array = given_array((count2), sizeof(type2));                                       \
        type3 *other = given_array((count3), sizeof(type3));                                       \
        SHAPES_CALL(function, SHAPES_PASS(what), &table, array, other)                             \
        if (!answer_result(answer, result))                                                        \
            return;                                                                                \
        answer_table(answer, result, table, sizeof(type) * (columns));                             \
        answer_given(answer, (count2), array, sizeof(type2));                                      \
        answer_given(answer, (count3), other, sizeof(type3));                                      \
    }

#endif
