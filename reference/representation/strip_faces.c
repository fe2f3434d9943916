/* Faces of strips and fans; see strip_faces.h. */
#include "reference/representation/strip_faces.h"

/* The run that has the face: before run r stand starts[r] - 2 r faces. */
static int32_t run_of_face(const int32_t *starts, int32_t run_count, int32_t face)
{
    int32_t low = 0, high = run_count;
    while (high - low > 1) {
        int32_t middle = low + (high - low) / 2;
        if (starts[middle] - 2 * middle <= face)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Where a walk over faces stands: at entry `at` of a run, the first of a face. */
struct walk {
    const int32_t *starts;
    int32_t run, at;
};

static struct walk walk_to(const int32_t *starts, int32_t run_count, int32_t face)
{
    int32_t run = run_of_face(starts, run_count, face);
    return (struct walk){starts, run, face + 2 * run};
}

/* How many of `count` faces are left in this run. */
static int32_t left_in_run(const struct walk *walk, int32_t count)
{
    int32_t left = walk->starts[walk->run + 1] - 2 - walk->at;
    return left < count ? left : count;
}

static void next_run(struct walk *walk)
{
    walk->at = walk->starts[++walk->run];
}

void strip_faces(const int32_t *starts, int32_t run_count, int32_t first, int32_t count,
                 int32_t *corners)
{
    struct walk walk = walk_to(starts, run_count, first);
    while (count > 0) {
        int32_t left = left_in_run(&walk, count), odd = (walk.at - starts[walk.run]) & 1;
        for (int32_t i = walk.at; i < walk.at + left; i++, corners += 3) {
            corners[0] = i + odd;
            corners[1] = i + 1 - odd;
            corners[2] = i + 2;
            odd = 1 - odd;
        }
        count -= left;
        if (count > 0)
            next_run(&walk);
    }
}

void strip_faces_of_fans(const int32_t *starts, int32_t run_count, int32_t first, int32_t count,
                         int32_t *corners)
{
    struct walk walk = walk_to(starts, run_count, first);
    while (count > 0) {
        int32_t left = left_in_run(&walk, count);
        for (int32_t i = walk.at; i < walk.at + left; i++, corners += 3) {
            corners[0] = starts[walk.run];
            corners[1] = i + 1;
            corners[2] = i + 2;
        }
        count -= left;
        if (count > 0)
            next_run(&walk);
    }
}
