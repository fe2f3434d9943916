/* The table of the kernels; see kernel.h. */
#include "reference/kernels/kernel.h"

#include "reference/kernels/area.h"
#include "reference/kernels/cpu.h"
#include "reference/kernels/edges_any.h"
#include "reference/kernels/edges_closed.h"
#include "reference/kernels/normals.h"
#include "reference/kernels/stripify.h"
#include "reference/kernels/strips_in_order.h"
#include "reference/kernels/threads.h"
#include "reference/kernels/twins.h"
#include "reference/kernels/vertex_cache.h"

#include <sched.h>
#include <string.h>

static bool always(void)
{
    return true;
}

static size_t no_scratch(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    (void)triangle_count;
    return 0;
}

static int64_t edges_closed_threads(const struct mesh *mesh, void *scratch, void *output)
{
    return edges_closed_on_threads(mesh, scratch, output, threads_worth(mesh->triangle_count));
}

static int64_t area_threads(const struct mesh *mesh, void *scratch, void *output)
{
    return area_on_threads(mesh, scratch, output, threads_worth(mesh->triangle_count));
}

static int64_t face_normals_threads(const struct mesh *mesh, void *scratch, void *output)
{
    return face_normals_on_threads(mesh, scratch, output, threads_worth(mesh->triangle_count));
}

static int64_t edges_any_threads(const struct mesh *mesh, void *scratch, void *output)
{
    return edges_any_on_threads(mesh, scratch, output, threads_worth(mesh->triangle_count));
}

static int64_t twins_threads(const struct mesh *mesh, void *scratch, void *output)
{
    return twins_on_threads(mesh, scratch, output, threads_worth(mesh->triangle_count));
}

const struct kernel kernel_table[] = {
    {"edges-closed", "plain", "edge", true, always, no_scratch, edges_closed_output_bytes,
     edges_closed_moved_bytes, edges_closed_plain, NULL},
#if defined(__x86_64__)
    {"edges-closed", "avx2", "edge", true, cpu_has_avx2, no_scratch, edges_closed_output_bytes,
     edges_closed_moved_bytes, edges_closed_avx2, NULL},
    {"edges-closed", "avx512", "edge", true, cpu_has_avx512, no_scratch, edges_closed_output_bytes,
     edges_closed_moved_bytes, edges_closed_avx512, NULL},
#endif
    {"edges-closed", "threads", "edge", true, always, edges_closed_threads_scratch_bytes,
     edges_closed_output_bytes, edges_closed_moved_bytes, edges_closed_threads,
     edges_closed_on_threads},
    {"edges-any", "plain", "edge", false, always, edges_any_scratch_bytes, edges_any_output_bytes,
     edges_any_moved_bytes, edges_any_plain, NULL},
#if defined(__x86_64__)
    {"edges-any", "avx2", "edge", false, cpu_has_avx2, edges_any_scratch_bytes,
     edges_any_output_bytes, edges_any_moved_bytes, edges_any_avx2, NULL},
    {"edges-any", "avx512", "edge", false, cpu_has_avx512, edges_any_scratch_bytes,
     edges_any_output_bytes, edges_any_moved_bytes, edges_any_avx512, NULL},
#endif
    {"edges-any", "threads", "edge", false, always, edges_any_threads_scratch_bytes,
     edges_any_output_bytes, edges_any_moved_bytes, edges_any_threads, edges_any_on_threads},
    {"twins", "plain", "side", false, always, twins_scratch_bytes, twins_output_bytes,
     twins_moved_bytes, twins_plain, NULL},
#if defined(__x86_64__)
    {"twins", "avx2", "side", false, cpu_has_avx2, twins_scratch_bytes, twins_output_bytes,
     twins_moved_bytes, twins_avx2, NULL},
    {"twins", "avx512", "side", false, cpu_has_avx512, twins_scratch_bytes, twins_output_bytes,
     twins_moved_bytes, twins_avx512, NULL},
#endif
    {"twins", "threads", "side", false, always, twins_scratch_bytes, twins_output_bytes,
     twins_moved_bytes, twins_threads, twins_on_threads},
    {"area", "plain", "area", false, always, no_scratch, area_output_bytes, area_moved_bytes,
     area_plain, NULL},
#if defined(__x86_64__)
    {"area", "avx2", "area", false, cpu_has_avx2, no_scratch, area_output_bytes, area_moved_bytes,
     area_avx2, NULL},
    {"area", "avx512", "area", false, cpu_has_avx512, no_scratch, area_output_bytes,
     area_moved_bytes, area_avx512, NULL},
#endif
    {"area", "threads", "area", false, always, area_threads_scratch_bytes, area_output_bytes,
     area_moved_bytes, area_threads, area_on_threads},
    {"face-normals", "plain", "normal", false, always, no_scratch, face_normals_output_bytes,
     face_normals_moved_bytes, face_normals_plain, NULL},
#if defined(__x86_64__)
    {"face-normals", "avx2", "normal", false, cpu_has_avx2, no_scratch, face_normals_output_bytes,
     face_normals_moved_bytes, face_normals_avx2, NULL},
    {"face-normals", "avx512", "normal", false, cpu_has_avx512, no_scratch,
     face_normals_output_bytes, face_normals_moved_bytes, face_normals_avx512, NULL},
#endif
    {"face-normals", "threads", "normal", false, always, no_scratch, face_normals_output_bytes,
     face_normals_moved_bytes, face_normals_threads, face_normals_on_threads},
    {"vertex-normals", "plain", "normal", false, always, vertex_normals_scratch_bytes,
     vertex_normals_output_bytes, vertex_normals_moved_bytes, vertex_normals_plain, NULL},
#if defined(__x86_64__)
    {"vertex-normals", "avx2", "normal", false, cpu_has_avx2, vertex_normals_scratch_bytes,
     vertex_normals_output_bytes, vertex_normals_moved_bytes, vertex_normals_avx2, NULL},
#endif
    {"stripify", "plain", "index", false, always, stripify_scratch_bytes, stripify_output_bytes,
     stripify_moved_bytes, stripify_plain, NULL},
#if defined(__x86_64__)
    {"stripify", "avx512", "index", false, cpu_has_avx512, stripify_scratch_bytes,
     stripify_output_bytes, stripify_moved_bytes, stripify_avx512, NULL},
#endif
    {"strips-in-order", "plain", "index", false, always, no_scratch, stripify_output_bytes,
     stripify_moved_bytes, strips_in_order_plain, NULL},
#if defined(__x86_64__)
    {"strips-in-order", "avx512", "index", false, cpu_has_avx512, no_scratch, stripify_output_bytes,
     stripify_moved_bytes, strips_in_order_avx512, NULL},
#endif
    {"vertex-cache", "plain", "triangle", false, always, vertex_cache_scratch_bytes,
     vertex_cache_output_bytes, vertex_cache_moved_bytes, vertex_cache_plain, NULL},
    {"vertex-fetch", "plain", "vertex", false, always, no_scratch, vertex_fetch_output_bytes,
     vertex_fetch_moved_bytes, vertex_fetch_plain, NULL},
    {0},
};

const struct kernel *kernel_find(const char *name, const char *variant)
{
    const struct kernel *best = NULL;
    for (const struct kernel *k = kernel_table; k->name; k++) {
        if (strcmp(k->name, name) != 0 || !k->available())
            continue;
        if (variant ? strcmp(k->variant, variant) == 0 : strcmp(k->variant, "threads") != 0)
            best = k;
    }
    return best;
}

int kernel_thread_count(void)
{
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) != 0)
        return 1;
    int count = CPU_COUNT(&set);
    return count < KERNEL_MOST_THREADS ? count : KERNEL_MOST_THREADS;
}
