/* Reading what is given and writing what was answered; see shapes.h. */
#include "graders/runner/shapes.h"

#include <stdlib.h>
#include <string.h>

enum { KEPT_MOST = 16 };

/* Blocks of the runner's that live until the next call: what the student was given. */
static void *kept[KEPT_MOST];
static int kept_count;

static void release_kept(void)
{
    while (kept_count > 0)
        free(kept[--kept_count]);
}

static void *keep(size_t bytes)
{
    void *block = kept_count < KEPT_MOST ? malloc(bytes) : NULL;
    if (!block)
        abort(); /* no code of a submission has run in this call: the engine sees the phase */
    kept[kept_count++] = block;
    return block;
}

/* A table of the packet. Behind it the packet goes on, and what lies there can be read: so where a
 * sanitizer or memcheck looks, the student gets a copy in a block of its own. */
static const void *given_table(struct reader *input, int64_t count, size_t row_bytes)
{
    const void *table = read_array(input, count, row_bytes);
#ifdef RUNNER_WITHOUT_SHIM
    if (!table)
        return NULL;
    void *copy = keep((size_t)count * row_bytes);
    if (count > 0)
        memcpy(copy, table, (size_t)count * row_bytes);
    return copy;
#else
    return table;
#endif
}

/* The attributes that follow when more than numbers does. */
static void read_attributes(struct reader *input, struct given *given)
{
    int64_t count = input->at < input->count ? read_int(input) : 0;
    for (int64_t i = 0; i < count && i < SHAPES_ATTRIBUTES; i++) {
        int64_t rows = read_int(input), columns = read_int(input);
        given->attribute[i] = given_table(input, rows, sizeof(float) * (size_t)columns);
    }
}

/* What a judge writes behind a mesh: the numbers of the case, as far as there are any. */
static void read_numbers(struct reader *input, struct given *given)
{
    for (int i = 0; i < SHAPES_NUMBERS && input->at < input->count; i++)
        given->number[i] = read_int(input);
    read_attributes(input, given);
}

struct given given_triangles(struct reader *input)
{
    struct given given = {0};
    release_kept();
    given.vertex_count = (int32_t)read_int(input);
    given.face_count = (int32_t)read_int(input);
    given.corner_count = 3 * (int64_t)given.face_count;
    if (read_int(input))
        given.positions = given_table(input, given.vertex_count, 3 * sizeof(float));
    given.triangles = given_table(input, given.face_count, 3 * sizeof(int32_t));
    read_numbers(input, &given);
    return given;
}

struct given given_polygons(struct reader *input)
{
    struct given given = {0};
    release_kept();
    given.vertex_count = (int32_t)read_int(input);
    given.face_count = (int32_t)read_int(input);
    given.first_corner = given_table(input, (int64_t)given.face_count + 1, sizeof(int32_t));
    given.corner_count = given.first_corner ? given.first_corner[given.face_count] : 0;
    given.corners = given_table(input, given.corner_count, sizeof(int32_t));
    given.positions = given_table(input, given.vertex_count, 3 * sizeof(float));
    read_numbers(input, &given);
    return given;
}

struct given given_soup(struct reader *input)
{
    struct given given = {0};
    release_kept();
    given.face_count = (int32_t)read_int(input);
    given.points = given_table(input, given.face_count, 9 * sizeof(float));
    read_numbers(input, &given);
    return given;
}

struct given given_line(struct reader *input)
{
    struct given given = {0};
    release_kept();
    given.point_count = (int32_t)read_int(input);
    given.is_closed = (int32_t)read_int(input);
    int64_t dimension = read_int(input);
    given.points = given_table(input, given.point_count * dimension, sizeof(float));
    read_numbers(input, &given);
    return given;
}

struct given given_field(struct reader *input)
{
    struct given given = {0};
    release_kept();
    given.rows = (int32_t)read_int(input);
    given.columns = (int32_t)read_int(input);
    given.layers = (int32_t)read_int(input);
    int64_t layers = given.layers > 0 ? given.layers : 1;
    given.points = given_table(input, (int64_t)given.rows * given.columns * layers, sizeof(float));
    read_numbers(input, &given);
    return given;
}

void *given_array(int64_t count, size_t row_bytes)
{
    size_t bytes = (size_t)count * row_bytes;
    return keep(bytes ? bytes : 1);
}

#ifdef RUNNER_WITHOUT_SHIM
int32_t *lend_room(int32_t *place, int32_t capacity)
{
    int32_t *lent = malloc(capacity > 0 ? (size_t)capacity * sizeof *lent : 1);
    return lent ? lent : place;
}

void take_room(int32_t *place, int32_t *lent, int32_t used)
{
    if (lent == place)
        return;
    memcpy(place, lent, (size_t)used * sizeof *lent);
    free(lent);
}
#endif

bool answer_result(struct writer *answer, int64_t result)
{
    write_int(answer, result);
    return result >= 0;
}

static void look_at_rows(const void *table, int64_t count, size_t row_bytes)
{
    bool is_wild = count < 0 || (uint64_t)count > SIZE_MAX / row_bytes;
    look_at_table(table, is_wild ? 0 : (size_t)count * row_bytes);
}

void answer_table(struct writer *answer, int64_t count, void *table, size_t row_bytes)
{
    look_at_rows(table, count, row_bytes);
    write_table(answer, table, count, row_bytes);
    free(table);
}

/* The values are as many as the last offset says. It is followed only where the offsets could be
 * copied, and the values are written only when they fit: a wild offset ends as a claim. For no row
 * there are no offsets either. */
void answer_rows(struct writer *answer, int64_t count, int32_t *first, int32_t *values)
{
    size_t before = answer->count;
    look_at_rows(first, count > 0 ? count + 1 : 0, sizeof *first);
    write_table(answer, first, count > 0 ? count + 1 : 0, sizeof *first);
    bool copied = answer->count - before > 2 * sizeof(int64_t);
    look_at_rows(values, copied ? first[count] : 0, sizeof *values);
    write_table(answer, values, copied ? first[count] : 0, sizeof *values);
    free(first);
    free(values);
}

void answer_given(struct writer *answer, int64_t count, void *array, size_t row_bytes)
{
    look_at_rows(array, count, row_bytes);
    write_table(answer, array, count, row_bytes);
}
