/* Trials of representations; see representation_trial.h. */
#include "tests/unit/representation_trial.h"

#include "reference/mesh/check.h"
#include "tests/unit/mesh_corpus.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char *current_kind = "", *current_mesh = "";

void require(bool holds, const char *what)
{
    if (!holds)
        fail_msg("%s, %s: it does not hold that %s", current_kind, current_mesh, what);
}

/* The error of a refusal says which element it is about. */
static bool names_an_element(const char *text)
{
    static const char *const words[] = {"vertex ", "edge {", "triangle ", "face "};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        const char *found = strstr(text, words[i]);
        if (found && strspn(found + strlen(words[i]), "0123456789") > 0)
            return true;
    }
    return false;
}

/* Which vertex of `back` each number is, and the lowest number of each vertex. */
static void map_numbers(struct representation_trial *trial)
{
    const struct representation *kind = trial->kind;
    trial->number_count = kind->vertex_count(trial->self);
    trial->names = calloc((size_t)trial->back.vertex_count + 1, sizeof *trial->names);
    trial->vertex_of = calloc((size_t)trial->number_count + 1, sizeof *trial->vertex_of);
    require(trial->names && trial->vertex_of, "there is memory");
    for (int32_t v = 0; v < trial->number_count; v++)
        trial->vertex_of[v] = kind->vertex_names ? -1 : v;
    for (int32_t v = 0; v < trial->back.vertex_count; v++)
        trial->names[v] = v;
    if (!kind->vertex_names) {
        require(trial->number_count == trial->back.vertex_count, "vertex_count is to_mesh's");
        return;
    }
    require(kind->vertex_names(trial->self, &trial->back, trial->names, NULL) == 0,
            "vertices can be named");
    for (int32_t f = 0; f < trial->back.triangle_count; f++) {
        int32_t corners[3];
        kind->face_vertices(trial->self, f, 1, corners);
        for (int i = 0; i < 3; i++) {
            int32_t v = trial->back.triangles[3 * (int64_t)f + i];
            require(corners[i] >= 0 && corners[i] < trial->number_count, "corners are numbers");
            require(trial->vertex_of[corners[i]] == -1 || trial->vertex_of[corners[i]] == v,
                    "a number belongs to one vertex");
            require(trial->names[v] <= corners[i], "a name is the lowest number");
            trial->vertex_of[corners[i]] = v;
        }
    }
    for (int32_t v = 0; v < trial->back.vertex_count; v++)
        require(trial->names[v] >= 0 && trial->names[v] < trial->number_count &&
                    trial->vertex_of[trial->names[v]] == v,
                "a name belongs to its vertex");
}

/* Builds, and holds the promise about what is refused. */
static bool build_trial(struct representation_trial *trial)
{
    const struct representation *kind = trial->kind;
    struct topology topology;
    struct error err = {0};
    require(mesh_topology(&trial->mesh, &topology, NULL) == 0, "there is memory");
    bool can_hold = (mesh_features(&topology) & ~kind->holds) == 0;
    int code = representation_new(kind, &trial->self, &trial->mesh, &err);
    if (code == 0 && can_hold)
        return true;
    if (code == 0)
        fail_msg("%s, %s: it has what cannot be held and is not refused", kind->name, current_mesh);
    if (can_hold)
        fail_msg("%s, %s: refused: %s", kind->name, current_mesh, err.text);
    if (!names_an_element(err.text))
        fail_msg("%s, %s: refused without an element: %s", kind->name, current_mesh, err.text);
    require(trial->self == NULL, "nothing is left after a refusal");
    return false;
}

bool representation_trial_init(struct representation_trial *trial,
                               const struct representation *kind, int i)
{
    *trial = (struct representation_trial){.kind = kind, .mesh = corpus_mesh(i)};
    current_kind = kind->name;
    current_mesh = corpus_name(i);
    if (!build_trial(trial)) {
        mesh_release(&trial->mesh);
        return false;
    }
    struct error err = {0};
    if (kind->check(trial->self, &err))
        fail_msg("%s, %s: check fails after build: %s", kind->name, current_mesh, err.text);
    require(kind->to_mesh(trial->self, &trial->back, &err) == 0, "to_mesh works");
    require(mesh_check(&trial->back, NULL) == 0, "to_mesh gives a valid mesh");
    require(kind->face_count(trial->self) == trial->mesh.triangle_count, "no face is lost");
    oracle_init(&trial->oracle, &trial->back);
    map_numbers(trial);
    return true;
}

void representation_trial_release(struct representation_trial *trial)
{
    representation_delete(trial->kind, trial->self);
    oracle_release(&trial->oracle);
    mesh_release(&trial->mesh);
    mesh_release(&trial->back);
    free(trial->names);
    free(trial->vertex_of);
}

void for_each_trial(int random_count, void (*test)(struct representation_trial *trial))
{
    for (int kind = 0; representation_table[kind]; kind++)
        for (int i = 0; i < CORPUS_GENERATED + random_count; i++) {
            struct representation_trial trial;
            if (!representation_trial_init(&trial, representation_table[kind], i))
                continue;
            test(&trial);
            representation_trial_release(&trial);
        }
}
