/* Exercises as exercise.json describes them: names, points, limits. */
#ifndef GRADERS_ENGINE_BASE_EXERCISE_H
#define GRADERS_ENGINE_BASE_EXERCISE_H

#include "reference/base/error.h"
#include "reference/base/phrase.h"

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    EXERCISE_NAME = 64,
    EXERCISE_FUNCTIONS = 12,
    EXERCISE_GIVEN = 8,
    EXERCISE_CLASSES = 24,
    FAMILIES_MAX = 4 /* of inputs on which growth is counted */
};

struct exercise_class {
    char name[EXERCISE_NAME];
    struct message title;
    double points;
};

/* What is measured on sized inputs. An exercise that builds a structure and then asks it queries has
 * both measured apart; any other has only the first. */
enum exercise_part { PART_BUILD, PART_QUERY, PART_COUNT };

/* What is checked beside the answers. */
enum check_kind {
    CHECK_UNDEFINED_BEHAVIOUR,
    CHECK_LEAK,
    CHECK_GROWTH,
    CHECK_QUERY_GROWTH,
    CHECK_WORK,
    CHECK_QUERY_WORK,
    CHECK_ACCESSES,
    CHECK_MEMORY,
    CHECK_QUERY_MEMORY,
    CHECK_ALLOCATION_FAILURE,
    CHECK_COUNT
};

struct exercise {
    char name[EXERCISE_NAME], group[EXERCISE_NAME], problem[EXERCISE_NAME];
    struct message title;
    int order;
    char functions[EXERCISE_FUNCTIONS][EXERCISE_NAME];
    int function_count;
    char given[EXERCISE_GIVEN][EXERCISE_NAME]; /* functions that the runner gives to students: */
    int given_count;                           /* each of their calls is counted as an access */
    struct exercise_class classes[EXERCISE_CLASSES];
    int class_count;
    bool checked[CHECK_COUNT];
    double check_points[CHECK_COUNT];
    char growth_allowed[PART_COUNT][16]; /* "n lg n" */
    struct message growth_elements;      /* what its sizes count: "triangles" */
    int64_t growth_first_size;
    int growth_doublings; /* sizes: first, 2 first, ... 2^doublings first */
    double work_band[PART_COUNT], memory_band[PART_COUNT]; /* multiples of the reference */
    double access_band;
    int64_t memory_limit_bytes;
    double max_score;
    char folder[PATH_MAX]; /* exercises/<group>/<name>, absolute */
};

/* "growth", "undefined-behaviour", ... */
const char *check_name(enum check_kind check);
struct phrase check_title(enum check_kind check);

/* Reads <folder>/exercise.json. Returns 0, or -1 and *err that names file, key and remedy. */
int exercise_read(const char *folder, struct exercise *exercise, struct error *err) MUST_CHECK;

/* Reads the text of an exercise.json.
 *
 * path      of the file, for errors; the exercise must bear its folder's name */
int exercise_parse(const char *text, size_t count, const char *path, struct exercise *exercise,
                   struct error *err) MUST_CHECK;

/* Every exercise below <root>/exercises, sorted by `order`. The caller frees *exercises. */
int exercises_read(const char *root, struct exercise **exercises, int *count,
                   struct error *err) MUST_CHECK;

/* NULL when there is none of that name. */
const struct exercise *exercise_find(const struct exercise *exercises, int count, const char *name);

#endif
