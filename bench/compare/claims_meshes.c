/* The meshes on which the claims are measured; see claims.h. */
#include "bench/compare/claims.h"

#include "reference/formats/mesh_file.h"
#include "reference/mesh/generate.h"

#include <stdio.h>
#include <string.h>

/* -- real models ---------------------------------------------------------------------------- */

static int about_model(struct claims *claims, const char *models, const char *name,
                       bool is_coherent, struct error *err)
{
    char path[4096];
    struct mesh mesh;
    int length = snprintf(path, sizeof path, "%s/%s.ply", models, name);
    if (length >= (int)sizeof path)
        return error_set(err, "the name of the folder of models is too long");
    if (mesh_file_read(path, &mesh, err))
        return -1;
    int result = claims_about_mesh(claims, name, &mesh, err);
    if (result == 0 && is_coherent) {
        struct polygons polygons = polygons_of_mesh(&mesh);
        result = claims_about_accesses(claims, name, &polygons, err);
    }
    mesh_release(&mesh);
    return result;
}

static int about_models(struct claims *claims, const char *models, struct error *err)
{
    return about_model(claims, models, "bunny", true, err) ||
                   about_model(claims, models, "horse", true, err) ||
                   about_model(claims, models, "mug", true, err) ||
                   about_model(claims, models, "spider", false, err)
               ? -1
               : 0;
}

/* -- generated meshes ----------------------------------------------------------------------- */

static int make_grid(struct mesh *mesh, struct error *err)
{
    return generate_grid(mesh, 128, 128, err);
}

static int make_uv_sphere(struct mesh *mesh, struct error *err)
{
    return generate_uv_sphere(mesh, 100, 50, err);
}

static int make_torus(struct mesh *mesh, struct error *err)
{
    return generate_torus(mesh, 1, 20000, err);
}

static int make_scrambled_torus(struct mesh *mesh, struct error *err)
{
    if (generate_torus(mesh, 1, 20000, err))
        return -1;
    if (change_scramble(mesh, 1, err) == 0)
        return 0;
    mesh_release(mesh);
    return -1;
}

static int about_generated(struct claims *claims, struct error *err)
{
    static const struct {
        const char *name;
        int (*make)(struct mesh *mesh, struct error *err);
    } generated[] = {{"grid-128x128", make_grid},
                     {"uv-sphere-10k", make_uv_sphere},
                     {"torus-20k", make_torus},
                     {"torus-scrambled", make_scrambled_torus}};
    for (size_t i = 0; i < sizeof generated / sizeof *generated; i++) {
        struct mesh mesh;
        if (generated[i].make(&mesh, err))
            return -1;
        int result = claims_about_mesh(claims, generated[i].name, &mesh, err);
        mesh_release(&mesh);
        if (result)
            return -1;
    }
    return 0;
}

/* -- polyhedra with large faces and large valences ------------------------------------------ */

enum { PRISM_MOST = 16 };

/* The prism over a polygon of `sides` corners: two large faces, `sides` quads. */
static int about_prism(struct claims *claims, int32_t sides, struct error *err)
{
    int32_t corners[6 * PRISM_MOST], starts[PRISM_MOST + 3] = {0}, count = 0, faces = 0;
    for (int32_t i = 0; i < sides; i++)
        corners[count++] = sides - 1 - i; /* below, seen from below */
    starts[++faces] = count;
    for (int32_t i = 0; i < sides; i++)
        corners[count++] = sides + i;
    starts[++faces] = count;
    for (int32_t i = 0; i < sides; i++) {
        int32_t next = (i + 1) % sides;
        corners[count++] = i;
        corners[count++] = next;
        corners[count++] = sides + next;
        corners[count++] = sides + i;
        starts[++faces] = count;
    }
    const struct polygons polygons = {corners, starts, 2 * sides, faces};
    char name[32];
    snprintf(name, sizeof name, "prism-%d", (int)sides);
    return claims_about_accesses(claims, name, &polygons, err);
}

/* A vertex of valence 64 on either end. */
static int about_bipyramid(struct claims *claims, struct error *err)
{
    struct mesh mesh;
    if (generate_bipyramid(&mesh, 64, err))
        return -1;
    struct polygons polygons = polygons_of_mesh(&mesh);
    int result = claims_about_accesses(claims, "bipyramid-64", &polygons, err);
    mesh_release(&mesh);
    return result;
}

/* Rows of one claim together, in the order in which they came; by insertion, there are few. */
static void group_by_claim(struct claims *claims)
{
    for (int i = 1; i < claims->count; i++) {
        struct claim row = claims->rows[i];
        int after = i - 1; /* the last earlier row of the same claim, else the row before */
        while (after > 0 && strcmp(claims->rows[after].name, row.name) != 0)
            after--;
        if (strcmp(claims->rows[after].name, row.name) != 0)
            after = i - 1;
        for (int j = i; j > after + 1; j--)
            claims->rows[j] = claims->rows[j - 1];
        claims->rows[after + 1] = row;
    }
}

int claims_collect(struct claims *claims, const char *models, struct error *err)
{
    if (about_models(claims, models, err) || about_generated(claims, err) ||
        claims_about_sizes(claims, err))
        return -1;
    for (int32_t sides = 4; sides <= PRISM_MOST; sides *= 2)
        if (about_prism(claims, sides, err))
            return -1;
    if (about_bipyramid(claims, err))
        return -1;
    group_by_claim(claims);
    return 0;
}
