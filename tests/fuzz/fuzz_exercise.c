/* Any bytes as an exercise.json: refused with the file's name, or points and sizes within their
 * bounds and names that can stand in paths and scripts. */
#include "graders/engine/base/exercise.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

static void require(bool holds)
{
    if (!holds)
        abort();
}

static void check_points(const struct exercise *exercise)
{
    double sum = 0;
    for (int i = 0; i < exercise->class_count; i++) {
        require(exercise->classes[i].points >= 0 && exercise->classes[i].points <= 10);
        sum += exercise->classes[i].points;
    }
    for (int check = 0; check < CHECK_COUNT; check++) {
        require(exercise->checked[check] || exercise->check_points[check] == 0);
        sum += exercise->check_points[check];
    }
    require(sum > exercise->max_score - 1e-9 && sum < exercise->max_score + 1e-9);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    static struct exercise exercise;
    struct error err = {""};
    static const char path[] = "exercises/edges/edge-table-any/exercise.json";
    if (exercise_parse((const char *)bytes, count, path, &exercise, &err) != 0) {
        require(strncmp(err.text, path, strlen(path)) == 0);
        return 0;
    }
    require(strcmp(exercise.name, "edge-table-any") == 0);
    require(exercise.function_count >= 1 && exercise.class_count >= 1);
    for (int i = 0; i < exercise.function_count; i++)
        require(exercise.functions[i][0] && !strpbrk(exercise.functions[i], " ;&|$`'\"\\\n/"));
    require(exercise.memory_limit_bytes >= 1 << 20 && exercise.memory_limit_bytes <= (int64_t)4096
                                                                                         << 20);
    if (exercise.checked[CHECK_GROWTH])
        require(exercise.growth_first_size >= 1 && exercise.growth_doublings <= 12);
    check_points(&exercise);
    return 0;
}
