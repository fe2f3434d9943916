/* One structure with the operations of Sieger and Botsch, to be measured; see subjects.h.
 *
 * The measured structure goes on from where the last call left it, as in the paper; answers are of
 * one call on the mesh as it was. */
#include "bench/compare/answers.h"
#include "bench/compare/sieger_botsch.h"
#include "bench/compare/subject.h"

#include "reference/mesh/edges.h"

#include <stdlib.h>

struct task {
    struct paper_run *run;
    enum paper_operation operation;
    bool is_undone; /* the last undo succeeded */
};

static int run_task(void *context, struct error *err)
{
    struct task *task = context;
    if (!task->is_undone)
        return error_set(err, "out of memory: the mesh as it was");
    return paper_do(task->run, task->operation, err);
}

static void reset_task(void *context)
{
    struct task *task = context;
    task->is_undone = paper_undo(task->run, task->operation, NULL) == 0;
}

static int answer_connectivity(struct worker_answer *answer, const struct mesh *mesh,
                               struct error *err)
{
    struct edge_list list;
    if (edge_list_init(&list, mesh, err))
        return -1;
    int32_t *pairs = malloc(2 * (size_t)list.edge_count * sizeof *pairs + 1);
    for (int64_t e = 0; pairs && e < list.edge_count; e++) {
        pairs[2 * e] = list.edges[e].low;
        pairs[2 * e + 1] = list.edges[e].high;
    }
    if (pairs)
        answer_edges(answer, pairs, list.edge_count);
    int result = pairs ? 0 : error_set(err, "out of memory: edges");
    free(pairs);
    edge_list_release(&list);
    return result;
}

static int answer_once(const struct paper_run *run, enum paper_operation operation,
                       struct worker_answer *answer, struct error *err)
{
    struct mesh mesh;
    const float *normals;
    if (operation == PAPER_CIRCULATOR) {
        answer_count(answer, run->sum);
        return 0;
    }
    if (paper_result(run, &mesh, &normals, err))
        return -1;
    int result = 0;
    if (operation == PAPER_NORMALS)
        answer_normals(answer, normals, mesh.vertex_count);
    else if (operation == PAPER_COLLAPSE)
        result = answer_connectivity(answer, &mesh, err);
    else
        answer_positions(answer, mesh.positions, mesh.vertex_count);
    mesh_release(&mesh);
    return result;
}

static int answer_task(void *context, struct worker_answer *answer, struct error *err)
{
    const struct task *task = context;
    struct paper_run once;
    if (paper_open(&once, task->run->structure, task->run->mesh, err))
        return -1;
    int result = paper_do(&once, task->operation, err);
    if (result == 0)
        result = answer_once(&once, task->operation, answer, err);
    paper_close(&once);
    return result;
}

int subject_serve_paper(const char *name, const struct snapshot *snapshot, FILE *in, FILE *out,
                        struct error *err)
{
    const struct paper_structure *structure = paper_structure_find(name);
    struct paper_run run;
    struct error refusal = {""};
    if (!structure)
        return error_set(err, "there is no structure \"%.60s\" in the paper's benchmark", name);
    if (paper_open(&run, structure, &snapshot->mesh, &refusal)) {
        worker_refuse(out, refusal.text);
        return 0;
    }
    struct worker_memory memory = {.piece_count = 0};
    struct task tasks[PAPER_OPERATION_COUNT];
    struct worker_operation operations[PAPER_OPERATION_COUNT];
    for (int i = 0; i < PAPER_OPERATION_COUNT; i++) {
        bool edits = i == PAPER_SUBDIVISION || i == PAPER_COLLAPSE;
        tasks[i] = (struct task){&run, (enum paper_operation)i, true};
        operations[i] = (struct worker_operation){paper_operation_names[i], &tasks[i], run_task,
                                                  edits ? reset_task : NULL, answer_task};
    }
    const struct worker_subject subject = {.operations = operations,
                                           .operation_count = PAPER_OPERATION_COUNT,
                                           .thread_count = 1,
                                           .memory = &memory};
    int result = worker_serve(&subject, in, out, err);
    paper_close(&run);
    worker_memory_release(&memory);
    return result;
}
