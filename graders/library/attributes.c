/* Attributes of a mesh as inputs; see attributes.h. */
#include "graders/library/attributes.h"

#include "reference/base/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WHOLE_NUMBERS = 8 };

int64_t attribute_rows(enum attribute_of of, struct input_sizes sizes)
{
    const int64_t rows[] = {[PER_NOTHING] = 0,
                            [PER_VERTEX] = sizes.vertices,
                            [PER_CORNER] = sizes.corners,
                            [PER_FACE] = sizes.faces};
    return rows[of];
}

/* Numbers at random; of a unit row drawn again while it is too short to be turned into one. */
static void draw_row(const struct attribute_rule *rule, struct random *rng, float *row)
{
    double square;
    do {
        square = 0;
        for (int c = 0; c < rule->columns; c++) {
            row[c] = rule->values == ATTRIBUTE_WHOLE ? (float)random_below(rng, WHOLE_NUMBERS)
                                                     : random_float(rng, -1, 1);
            square += (double)row[c] * (double)row[c];
        }
    } while (rule->values == ATTRIBUTE_UNIT && square < 0.01);
    for (int c = 0; rule->values == ATTRIBUTE_UNIT && c < rule->columns; c++)
        row[c] = (float)((double)row[c] / sqrt(square));
}

int attributes_write(const struct attribute_rule rules[ATTRIBUTES_MOST], struct input_sizes sizes,
                     uint64_t seed, struct writer *input, struct error *err)
{
    struct random rng;
    int count = 0;
    while (count < ATTRIBUTES_MOST && rules[count].of != PER_NOTHING)
        count++;
    random_init(&rng, seed);
    write_int(input, count);
    for (int i = 0; i < count; i++) {
        const struct attribute_rule *rule = &rules[i];
        int64_t rows = attribute_rows(rule->of, sizes);
        if (rule->columns < 1 || rule->columns > ATTRIBUTE_COLUMNS_MOST)
            return error_set(err, "an attribute has 1 to %d columns, not %d",
                             ATTRIBUTE_COLUMNS_MOST, rule->columns);
        float *values = malloc(sizeof *values * (size_t)(rows * rule->columns + 1));
        if (!values)
            return error_set(err, "out of memory for an attribute");
        for (int64_t r = 0; r < rows; r++)
            draw_row(rule, &rng, values + r * rule->columns);
        write_int(input, rows);
        write_int(input, rule->columns);
        write_array(input, values, rows, sizeof *values * (size_t)rule->columns);
        free(values);
    }
    return input->failed ? error_set(err, "out of memory for an input") : 0;
}

void attributes_read(struct reader *input, struct attribute_view views[ATTRIBUTES_MOST])
{
    memset(views, 0, ATTRIBUTES_MOST * sizeof *views);
    int64_t count = read_int(input);
    for (int64_t i = 0; i < count && i < ATTRIBUTES_MOST; i++) {
        views[i].row_count = read_int(input);
        views[i].columns = (int)read_int(input);
        views[i].values =
            read_array(input, views[i].row_count, sizeof(float) * (size_t)views[i].columns);
    }
}
