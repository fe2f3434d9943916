/* The reference kernels of one variant, to be measured; see subjects.h.
 *
 * Operations bear the kernels' names. What a kernel answers is compared bit for bit with the other
 * variants (all but the area) and, where order is free, in an order-free form with peers. */
#include "bench/compare/answers.h"
#include "bench/compare/subject.h"

#include "reference/kernels/kernel.h"

#include <stdlib.h>
#include <string.h>

enum { KERNELS_MAX = 24 };

/* One kernel on the mesh, with its memory. */
struct call {
    const struct kernel *kernel;
    const struct snapshot *snapshot;
    void *scratch, *output;
    int64_t record_count;
};

static int run_call(void *context, struct error *err)
{
    struct call *call = context;
    (void)err;
    call->record_count = call->kernel->run(&call->snapshot->mesh, call->scratch, call->output);
    return 0;
}

/* Twins, as neighbours: side / 3 is the triangle. Costs a table. */
static int answer_twins(struct worker_answer *answer, const int32_t *twins, int64_t triangle_count,
                        struct error *err)
{
    int32_t *neighbours = malloc(12 * (size_t)triangle_count + 1);
    if (!neighbours)
        return error_set(err, "out of memory: neighbours");
    for (int64_t side = 0; side < 3 * triangle_count; side++)
        neighbours[side] = twins[side] < 0 ? -1 : twins[side] / 3;
    answer_neighbours(answer, neighbours, triangle_count);
    free(neighbours);
    return 0;
}

/* The strips must hold the mesh's own triangles: peers are only held against them. */
static int answer_stripify(struct worker_answer *answer, const struct mesh *mesh,
                           const int32_t *indices, int64_t index_count, struct error *err)
{
    struct worker_answer meant = {.hash = 0};
    answer_triangles(&meant, mesh->triangles, mesh->triangle_count);
    answer_strips(answer, indices, index_count);
    return answers_agree(answer, &meant) == 1
               ? 0
               : error_set(err, "the strips do not hold the mesh's triangles");
}

static int answer_call(void *context, struct worker_answer *answer, struct error *err)
{
    const struct call *call = context;
    const struct mesh *mesh = &call->snapshot->mesh;
    const char *name = call->kernel->name;
    int result = 0;
    if (strncmp(name, "edges", 5) == 0)
        answer_edges(answer, call->output, call->record_count);
    else if (strcmp(name, "twins") == 0)
        result = answer_twins(answer, call->output, mesh->triangle_count, err);
    else if (strcmp(name, "area") == 0)
        answer_area(answer, *(const double *)call->output);
    else if (strstr(name, "normals"))
        answer_normals(answer, call->output, call->record_count);
    else if (strncmp(name, "strip", 5) == 0) /* stripify, strips-in-order */
        result = answer_stripify(answer, mesh, call->output, call->record_count, err);
    else if (strcmp(name, "vertex-cache") == 0)
        answer_order(answer, call->output, mesh->triangle_count, mesh->vertex_count);
    else
        answer_count(answer, call->record_count);
    worker_fact(answer, "records", (double)call->record_count);
    worker_fact(answer, "limit_bytes",
                (double)call->kernel->moved_bytes(mesh->vertex_count, mesh->triangle_count,
                                                  call->record_count));
    return result;
}

/* Fastest variant on one thread of a kernel; the kernels of the table come variant after variant.
 */
static const struct kernel *choose(const struct kernel *entry, const char *variant)
{
    const struct kernel *kernel =
        kernel_find(entry->name, strcmp(variant, "fastest") == 0 ? NULL : variant);
    bool first_of_its_name = entry == kernel_table || strcmp(entry[-1].name, entry->name) != 0;
    return first_of_its_name ? kernel : NULL;
}

static int prepare(struct call *call, const struct kernel *kernel, const struct snapshot *snapshot,
                   struct worker_memory *memory, struct error *err)
{
    int64_t vertices = snapshot->mesh.vertex_count, triangles = snapshot->mesh.triangle_count;
    *call = (struct call){.kernel = kernel, .snapshot = snapshot};
    call->scratch = worker_memory_take(memory, kernel->scratch_bytes(vertices, triangles), err);
    call->output = worker_memory_take(memory, kernel->output_bytes(vertices, triangles), err);
    return call->scratch && call->output ? 0 : -1;
}

int subject_serve_kernels(const char *variant, const struct snapshot *snapshot, FILE *in, FILE *out,
                          struct error *err)
{
    struct call calls[KERNELS_MAX];
    struct worker_operation operations[KERNELS_MAX];
    struct worker_memory memory = {.piece_count = 0};
    int count = 0, result = 0;
    for (const struct kernel *entry = kernel_table; entry->name && result == 0; entry++) {
        const struct kernel *kernel = choose(entry, variant);
        if (!kernel || count == KERNELS_MAX ||
            (kernel->needs_closed_mesh && snapshot->boundary_edge_count > 0))
            continue;
        result = prepare(&calls[count], kernel, snapshot, &memory, err);
        operations[count] = (struct worker_operation){
            .name = kernel->name, .context = &calls[count], .run = run_call, .answer = answer_call};
        count += result == 0;
    }
    struct worker_subject subject = {
        .operations = operations,
        .operation_count = count,
        .thread_count = strcmp(variant, "threads") == 0 ? kernel_thread_count() : 1,
        .memory = &memory};
    if (result == 0 && count == 0)
        worker_refuse(out, "no kernel has that variant here");
    else if (result == 0)
        result = worker_serve(&subject, in, out, err);
    worker_memory_release(&memory);
    return result;
}
