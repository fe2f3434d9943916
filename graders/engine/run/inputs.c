/* Makes inputs; see inputs.h. */
#include "graders/engine/run/inputs.h"

#include "graders/engine/base/files.h"
#include "graders/engine/run/soundness.h"
#include "graders/judges/table.h"
#include "reference/base/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const uint64_t SIZED_SEED = 20260411;

/* ------------------------------------------------------------------- seeds */

/* A seed that only the class's number leads to. */
static uint64_t mix_seed(uint64_t published, uint32_t class_seed)
{
    struct random rng;
    random_init(&rng, published ^ (uint64_t)class_seed << 32);
    return random_next(&rng);
}

struct seeds seeds_of_class(uint32_t number)
{
    return (struct seeds){number, number};
}

/* The judge with its own copy of the cases, those that are not public under seeds of the class. */
static int seed_judge(struct inputs *inputs, const struct judge *judge, struct error *err)
{
    inputs->seeded_cases = calloc(judge->case_count, sizeof *inputs->seeded_cases);
    if (!inputs->seeded_cases)
        return error_set(err, "out of memory for %zu cases", judge->case_count);
    memcpy(inputs->seeded_cases, judge->cases, judge->case_count * sizeof *inputs->seeded_cases);
    for (size_t i = 0; i < judge->case_count && inputs->seeds.cases != SEED_PUBLISHED; i++)
        if (!judge_case_is_public(&judge->cases[i]))
            inputs->seeded_cases[i].seed = mix_seed(judge->cases[i].seed, inputs->seeds.cases);
    inputs->seeded = *judge;
    inputs->seeded.cases = inputs->seeded_cases;
    inputs->judge = &inputs->seeded;
    return 0;
}

/* ------------------------------------------------------------------ inputs */

/* Moves a written packet into sealed memory. */
static int seal_input(const struct judge *judge, struct writer *writer, struct input *input,
                      struct error *err)
{
    if (writer->failed)
        return error_set(err, "judge %s: out of memory for an input", judge->exercise);
    if (region_make(&input->region, writer->count, true, err) != 0)
        return -1;
    memcpy(input->region.bytes, writer->bytes, writer->count);
    input->bytes = writer->count;
    struct span packet = {input->region.bytes, input->bytes};
    input->answer_bound = judge_answer_bound(judge, packet);
    input->weight = judge_input_weight(judge, packet);
    return 0;
}

static int make_case(struct inputs *inputs, size_t index, struct error *err)
{
    const struct judge *judge = inputs->judge;
    struct writer writer = writer_growing();
    int result = judge_make(judge, &judge->cases[index], inputs->models, &writer, err);
    if (result == 0)
        result = seal_input(judge, &writer, &inputs->cases[index], err);
    writer_release(&writer);
    return result;
}

int inputs_case(struct inputs *inputs, size_t index, const struct input **input, struct error *err)
{
    *input = &inputs->cases[index];
    return inputs->cases[index].bytes != 0 ? 0 : make_case(inputs, index, err);
}

int inputs_sized(struct inputs *inputs, int family, int size_index, const struct input **input,
                 struct error *err)
{
    struct input *made = &inputs->sized[family][size_index];
    *input = made;
    if (made->bytes != 0)
        return 0;
    struct writer writer = writer_growing();
    int result = judge_make_sized(inputs->judge, family, inputs->sizes[family][size_index],
                                  inputs->seed, &writer, err);
    if (result == 0)
        result = seal_input(inputs->judge, &writer, made, err);
    writer_release(&writer);
    return result;
}

/* -------------------------------------------------------------------- life */

/* Uniform, from 0 to below 1. */
static double draw(struct random *rng)
{
    return (double)(random_next(rng) >> 11) / 0x1p53;
}

/* The sizes at which growth is counted, and those beyond: about first_size times powers of two. One
 * factor from 3/4 to 3/2 is drawn for all, so that the steps stay doublings, and 1.5 % up or down for
 * each, so that one size does not tell the next. */
static void choose_sizes(struct inputs *inputs)
{
    const struct exercise *exercise = inputs->exercise;
    struct random rng;
    if (!exercise->checked[CHECK_GROWTH])
        return;
    inputs->family_count = judge_family_count(inputs->judge);
    inputs->size_count = exercise->growth_doublings + 1;
    random_init(&rng, ~inputs->seed);
    double factor = 0.75 * exp2(draw(&rng));
    for (int i = 0; i < inputs->size_count + EXTRA_DOUBLINGS; i++) {
        inputs->told_sizes[i] = exercise->growth_first_size << i;
        double size = factor * (0.985 + 0.03 * draw(&rng)) * (double)inputs->told_sizes[i];
        for (int family = 0; family < inputs->family_count; family++)
            inputs->sizes[family][i] = judge_size_near(inputs->judge, family, (int64_t)ceil(size));
    }
}

int inputs_beyond(const struct inputs *inputs)
{
    return inputs->size_count;
}

int inputs_prepare(struct inputs *inputs, const struct exercise *exercise, struct seeds seeds,
                   struct error *err)
{
    memset(inputs, 0, sizeof *inputs);
    for (int family = 0; family < FAMILIES_MAX; family++)
        for (int i = 0; i < SIZES_MAX; i++)
            inputs->sized[family][i].region.fd = -1;
    inputs->exercise = exercise;
    inputs->seeds = seeds;
    inputs->seed = mix_seed(SIZED_SEED, seeds.sizes);
    const struct judge *judge = judge_find(exercise->name);
    if (soundness_check(exercise, judge, err) != 0)
        return -1;
    const char *root = project_root(err);
    if (!root || seed_judge(inputs, judge, err) != 0)
        return -1;
    inputs->cases = calloc(judge->case_count, sizeof *inputs->cases);
    if (!inputs->cases)
        return error_set(err, "out of memory for %zu cases", judge->case_count);
    for (size_t i = 0; i < judge->case_count; i++)
        inputs->cases[i].region.fd = -1;
    snprintf(inputs->models, sizeof inputs->models, "%s/exercises/models", root);
    choose_sizes(inputs);
    return 0;
}

void inputs_release(struct inputs *inputs)
{
    size_t count = inputs->cases ? inputs->judge->case_count : 0;
    for (size_t i = 0; i < count; i++)
        region_release(&inputs->cases[i].region);
    for (int family = 0; family < FAMILIES_MAX; family++)
        for (int i = 0; i < SIZES_MAX; i++)
            region_release(&inputs->sized[family][i].region);
    free(inputs->cases);
    free(inputs->seeded_cases);
    memset(inputs, 0, sizeof *inputs);
}
