/* Faces of strips and fans; see strip_faces.h. */
#include "reference/representation/strip_faces.h"

#include <stdbool.h>

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

static void run_faces(const int32_t *starts, int32_t run_count, int32_t first, int32_t count,
                      bool is_fan, int32_t *corners)
{
    int32_t run = run_of_face(starts, run_count, first);
    int32_t at = starts[run] + first - (starts[run] - 2 * run);
    for (int32_t i = 0; i < count; i++, at++, corners += 3) {
        if (at + 2 >= starts[run + 1])
            at = starts[++run];
        int32_t odd = is_fan ? 0 : (at - starts[run]) % 2;
        corners[0] = is_fan ? starts[run] : at + odd;
        corners[1] = at + 1 - odd;
        corners[2] = at + 2;
    }
}

void strip_faces(const int32_t *starts, int32_t run_count, int32_t first, int32_t count,
                 int32_t *corners)
{
    run_faces(starts, run_count, first, count, false, corners);
}

void fan_faces(const int32_t *starts, int32_t run_count, int32_t first, int32_t count,
               int32_t *corners)
{
    run_faces(starts, run_count, first, count, true, corners);
}
