/* Running the operations of the paper; see sieger_botsch.h. */
#include "bench/compare/sieger_botsch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

extern const struct paper_structure paper_half_edge, paper_winged_edge, paper_indexed_csr;

const struct paper_structure *const paper_structures[] = {&paper_half_edge, &paper_winged_edge,
                                                          &paper_indexed_csr, NULL};

const char *const paper_operation_names[PAPER_OPERATION_COUNT] = {
    [PAPER_CIRCULATOR] = "circulator",   [PAPER_BARYCENTRE] = "barycentre",
    [PAPER_NORMALS] = "normals",         [PAPER_SMOOTHING] = "smoothing",
    [PAPER_SUBDIVISION] = "subdivision", [PAPER_COLLAPSE] = "collapse"};

const struct paper_structure *paper_structure_find(const char *name)
{
    for (int i = 0; paper_structures[i]; i++)
        if (strcmp(paper_structures[i]->name, name) == 0)
            return paper_structures[i];
    return NULL;
}

int paper_open(struct paper_run *run, const struct paper_structure *structure,
               const struct mesh *mesh, struct error *err)
{
    *run = (struct paper_run){
        .structure = structure, .mesh = mesh, .self = calloc(1, structure->struct_bytes)};
    if (!run->self)
        return error_set(err, "out of memory: %s", structure->name);
    if (structure->build(run->self, mesh, err) == 0)
        return 0;
    free(run->self);
    run->self = NULL;
    return -1;
}

void paper_close(struct paper_run *run)
{
    if (run->self)
        run->structure->release(run->self);
    free(run->self);
    *run = (struct paper_run){0};
}

int paper_do(struct paper_run *run, enum paper_operation operation, struct error *err)
{
    switch (operation) {
    case PAPER_CIRCULATOR:
        run->sum = run->structure->circulate(run->self);
        return 0;
    case PAPER_BARYCENTRE:
        run->structure->centre(run->self);
        return 0;
    case PAPER_NORMALS:
        run->structure->normals(run->self);
        return 0;
    case PAPER_SMOOTHING:
        run->structure->smooth(run->self);
        return 0;
    case PAPER_SUBDIVISION:
        return run->structure->subdivide(run->self, err);
    case PAPER_COLLAPSE:
        return run->structure->collapse(run->self, err);
    case PAPER_OPERATION_COUNT:
        break;
    }
    return error_set(err, "there is no operation %d", (int)operation);
}

int paper_undo(struct paper_run *run, enum paper_operation operation, struct error *err)
{
    if (operation != PAPER_SUBDIVISION && operation != PAPER_COLLAPSE)
        return 0;
    run->structure->release(run->self);
    return run->structure->build(run->self, run->mesh, err);
}

int paper_result(const struct paper_run *run, struct mesh *mesh, const float **vertex_normals,
                 struct error *err)
{
    *vertex_normals = run->structure->vertex_normals(run->self);
    return run->structure->to_mesh(run->self, mesh, err);
}

double paper_sqrt3_weight(int32_t n)
{
    return (4.0 - 2.0 * cos(2.0 * 3.14159265358979323846 / n)) / 9.0;
}
