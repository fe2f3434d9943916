/* What holds for every representation; see representation.h. */
#include "reference/representation/representation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct representation *representation_find(const char *name)
{
    for (int i = 0; representation_table[i]; i++)
        if (strcmp(representation_table[i]->name, name) == 0)
            return representation_table[i];
    return NULL;
}

int representation_new(const struct representation *kind, void **self, const struct mesh *mesh,
                       struct error *err)
{
    *self = calloc(1, kind->struct_bytes);
    if (!*self)
        return error_set(err, "out of memory: a %s", kind->name);
    if (kind->build(*self, mesh, err) == 0)
        return 0;
    free(*self);
    *self = NULL;
    return -1;
}

void representation_delete(const struct representation *kind, void *self)
{
    if (self)
        kind->release(self);
    free(self);
}

unsigned mesh_features(const struct topology *topology)
{
    return (topology->boundary.count ? FEATURE_BOUNDARY : 0u) |
           (topology->isolated.count ? FEATURE_ISOLATED_VERTEX : 0u) |
           (topology->degenerate.count ? FEATURE_DEGENERATE_TRIANGLE : 0u) |
           (topology->incoherent.count ? FEATURE_INCOHERENT_EDGE : 0u) |
           (topology->nonmanifold_edge.count ? FEATURE_NONMANIFOLD_EDGE : 0u) |
           (topology->nonmanifold_vertex.count ? FEATURE_NONMANIFOLD_VERTEX : 0u);
}

struct mesh_counts representation_counts(const struct representation *kind, const void *self,
                                         const struct topology *topology)
{
    struct mesh_counts counts = {.vertices = topology->vertex_count,
                                 .edges = topology->edge_count,
                                 .triangles = topology->triangle_count,
                                 .boundary_edges = topology->boundary.count};
    if (kind->count_strips)
        kind->count_strips(self, &counts);
    return counts;
}

void representation_formula(const struct representation *kind, char *text, size_t capacity)
{
    static const struct {
        const char *letter;
        struct mesh_counts one;
    } terms[] = {{"V", {.vertices = 1}},       {"E", {.edges = 1}},  {"F", {.triangles = 1}},
                 {"B", {.boundary_edges = 1}}, {"S", {.strips = 1}}, {"N", {.strip_vertices = 1}}};
    int64_t constant = kind->formula_bytes(&(struct mesh_counts){0});
    size_t used = 0;
    if (capacity > 0)
        text[0] = '\0';
    for (size_t i = 0; i <= sizeof terms / sizeof *terms && used < capacity; i++) {
        bool is_last = i == sizeof terms / sizeof *terms;
        int64_t factor = is_last ? constant : kind->formula_bytes(&terms[i].one) - constant;
        if (factor == 0)
            continue;
        int written =
            snprintf(text + used, capacity - used, "%s%lld%s%s", used ? " + " : "",
                     (long long)factor, is_last ? "" : " ", is_last ? "" : terms[i].letter);
        used += written > 0 ? (size_t)written : 0;
    }
}
