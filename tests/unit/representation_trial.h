/* One representation of one mesh, beside the plain truth about it. */
#ifndef TESTS_UNIT_REPRESENTATION_TRIAL_H
#define TESTS_UNIT_REPRESENTATION_TRIAL_H

#include "reference/representation/representation.h"
#include "tests/unit/mesh_oracle.h"

struct representation_trial {
    const struct representation *kind;
    void *self;           /* built from `mesh` */
    struct mesh mesh;     /* of the corpus */
    struct mesh back;     /* what to_mesh gave */
    struct oracle oracle; /* of `back` */
    int32_t *names;       /* of each vertex of `back`: its lowest number in the representation */
    int32_t *vertex_of;   /* of each number in the representation: its vertex of `back` */
    int32_t number_count; /* numbers in the representation (vertex_count) */
};

/* Mesh i of the corpus (mesh_corpus.h) in that representation. Returns false, with nothing to
 * release, when the mesh has what the kind does not hold; whatever else happens fails the test. */
bool trial_init(struct representation_trial *trial, const struct representation *kind, int i);
void trial_release(struct representation_trial *trial);

/* Calls `test` with a trial for each mesh of the corpus, `random_count` random ones included, in
 * each representation that holds it. Names what it was at when the test fails. */
void for_each_trial(int random_count, void (*test)(struct representation_trial *trial));

/* Fails the test unless it holds; says what does not hold for which kind and mesh. */
void require(bool holds, const char *what);

#endif
