/* Bytes of a mesh; see sizes.h. */
#include "reference/survey/sizes.h"

/* Makes it where its size depends on more than counts. */
static int measure(const struct representation *kind, const struct mesh *mesh,
                   const struct topology *topology, int64_t *bytes, struct error *err)
{
    if (!kind->count_strips) {
        struct mesh_counts counts = representation_counts(kind, NULL, topology);
        *bytes = kind->formula_bytes(&counts);
        return 0;
    }
    void *self;
    if (representation_new(kind, &self, mesh, err))
        return -1;
    *bytes = kind->bytes(self);
    representation_delete(kind, self);
    return 0;
}

int survey_sizes(const struct mesh *mesh, const struct topology *topology,
                 struct representation_size sizes[SURVEY_SIZES], struct error *err)
{
    unsigned features = mesh_features(topology);
    int count = 0;
    for (; count < SURVEY_SIZES && representation_table[count]; count++) {
        const struct representation *kind = representation_table[count];
        unsigned obstacles = features & ~kind->holds;
        sizes[count] = (struct representation_size){kind, -1, obstacles & -obstacles};
        if (obstacles == 0 && measure(kind, mesh, topology, &sizes[count].bytes, err))
            return -1;
    }
    return count;
}

struct phrase survey_obstacle(unsigned feature)
{
    switch (feature) {
    case FEATURE_BOUNDARY:
        return (struct phrase){"a boundary", "un borde"};
    case FEATURE_ISOLATED_VERTEX:
        return (struct phrase){"an isolated vertex", "un vértice aislado"};
    case FEATURE_DEGENERATE_TRIANGLE:
        return (struct phrase){"a degenerate triangle", "un triángulo degenerado"};
    case FEATURE_INCOHERENT_EDGE:
        return (struct phrase){"an incoherent edge", "una arista incoherente"};
    case FEATURE_NONMANIFOLD_EDGE:
        return (struct phrase){"a non-manifold edge", "una arista no variedad"};
    case FEATURE_NONMANIFOLD_VERTEX:
        return (struct phrase){"a non-manifold vertex", "un vértice no variedad"};
    default:
        return (struct phrase){"", ""};
    }
}
