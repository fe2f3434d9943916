/* Surfaces by formula: open sheets and closed bodies without handles. See generate.h. */
#include "reference/mesh/generate.h"

#include "reference/base/random.h"
#include "reference/mesh/builder.h"
#include "reference/mesh/circle.h"

/* Refuses a size out of its range; also what keeps the products of two sizes within int64. */
static int check_size(const char *what, int64_t value, int64_t least, struct error *err)
{
    if (value < least || value > INT32_MAX / 3)
        return error_set(err, "generating a mesh: %s is %lld and must be %lld to %d", what,
                         (long long)value, (long long)least, INT32_MAX / 3);
    return 0;
}

int generate_grid(struct mesh *mesh, int64_t m, int64_t n, struct error *err)
{
    *mesh = (struct mesh){0};
    if (check_size("the number of rows", m, 1, err) ||
        check_size("the number of columns", n, 1, err) ||
        mesh_init(mesh, (m + 1) * (n + 1), 2 * m * n, err))
        return -1;
    struct builder b = {.mesh = mesh};
    for (int64_t r = 0; r <= m; r++)
        for (int64_t c = 0; c <= n; c++)
            add_vertex(&b, (double)c / (double)n - 0.5, (double)r / (double)m - 0.5,
                       0.08 * circle_point(c, n).sine * circle_point(r, m).cosine);
    for (int64_t r = 0; r < m; r++)
        for (int64_t c = 0; c < n; c++) {
            int64_t low = r * (n + 1) + c, high = low + n + 1;
            add_triangle(&b, high, low, high + 1);
            add_triangle(&b, high + 1, low, low + 1);
        }
    return 0;
}

int generate_uv_sphere(struct mesh *mesh, int64_t meridians, int64_t parallels, struct error *err)
{
    *mesh = (struct mesh){0};
    if (check_size("the number of meridians", meridians, 3, err) ||
        check_size("the number of parallels", parallels, 1, err) ||
        mesh_init(mesh, parallels * meridians + 2, 2 * parallels * meridians, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_vertex(&b, 0.0, 0.0, 0.5);
    for (int64_t j = 1; j <= parallels; j++) {
        struct circle_point row = circle_point(j, 2 * (parallels + 1));
        for (int64_t i = 0; i < meridians; i++) {
            struct circle_point p = circle_point(i, meridians);
            add_vertex(&b, 0.5 * row.sine * p.cosine, 0.5 * row.sine * p.sine, 0.5 * row.cosine);
        }
    }
    add_vertex(&b, 0.0, 0.0, -0.5);
    int64_t south = parallels * meridians + 1;
    for (int64_t i = 0; i < meridians; i++)
        add_triangle(&b, 0, 1 + i, 1 + (i + 1) % meridians);
    for (int64_t j = 0; j + 1 < parallels; j++)
        for (int64_t i = 0; i < meridians; i++) {
            int64_t upper = 1 + j * meridians, lower = upper + meridians;
            int64_t next = (i + 1) % meridians;
            add_quad(&b, upper + i, lower + i, lower + next, upper + next);
        }
    for (int64_t i = 0; i < meridians; i++)
        add_triangle(&b, south, south - meridians + (i + 1) % meridians, south - meridians + i);
    return 0;
}

int generate_disc(struct mesh *mesh, int64_t rings, int64_t sectors, struct error *err)
{
    *mesh = (struct mesh){0};
    if (check_size("the number of rings", rings, 1, err) ||
        check_size("the number of sectors", sectors, 3, err) ||
        mesh_init(mesh, rings * sectors + 1, (2 * rings - 1) * sectors, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_vertex(&b, 0.0, 0.0, 0.0);
    for (int64_t r = 1; r <= rings; r++)
        for (int64_t s = 0; s < sectors; s++) {
            double radius = 0.5 * (double)r / (double)rings;
            struct circle_point p = circle_point(s, sectors);
            add_vertex(&b, radius * p.cosine, radius * p.sine, 0.0);
        }
    for (int64_t s = 0; s < sectors; s++)
        add_triangle(&b, 0, 1 + s, 1 + (s + 1) % sectors);
    for (int64_t r = 0; r + 1 < rings; r++)
        for (int64_t s = 0; s < sectors; s++) {
            int64_t inner = 1 + r * sectors, outer = inner + sectors, next = (s + 1) % sectors;
            add_quad(&b, inner + s, outer + s, outer + next, inner + next);
        }
    return 0;
}

int generate_fan(struct mesh *mesh, int64_t triangles, struct error *err)
{
    *mesh = (struct mesh){0};
    if (check_size("the number of triangles", triangles, 1, err) ||
        mesh_init(mesh, triangles + 2, triangles, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_vertex(&b, 0.0, 0.0, 0.0);
    for (int64_t i = 0; i <= triangles; i++) {
        /* Less than a full turn, so that first and last vertex never meet. */
        struct circle_point p = circle_point(i, triangles + 2);
        add_vertex(&b, 0.5 * p.cosine, 0.5 * p.sine, 0.0);
    }
    for (int64_t i = 1; i <= triangles; i++)
        add_triangle(&b, 0, i, i + 1);
    return 0;
}

int generate_bipyramid(struct mesh *mesh, int64_t valence, struct error *err)
{
    *mesh = (struct mesh){0};
    if (check_size("the valence", valence, 3, err) ||
        mesh_init(mesh, valence + 2, 2 * valence, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_vertex(&b, 0.0, 0.0, 0.5);
    for (int64_t i = 0; i < valence; i++) {
        struct circle_point p = circle_point(i, valence);
        add_vertex(&b, 0.5 * p.cosine, 0.5 * p.sine, 0.0);
    }
    add_vertex(&b, 0.0, 0.0, -0.5);
    for (int64_t i = 0; i < valence; i++)
        add_triangle(&b, 0, 1 + i, 1 + (i + 1) % valence);
    for (int64_t i = 0; i < valence; i++)
        add_triangle(&b, valence + 1, 1 + (i + 1) % valence, 1 + i);
    return 0;
}

int generate_moebius(struct mesh *mesh, int64_t quads, struct error *err)
{
    *mesh = (struct mesh){0};
    if (check_size("the number of quads", quads, 3, err) ||
        mesh_init(mesh, 2 * quads, 2 * quads, err))
        return -1;
    struct builder b = {.mesh = mesh};
    for (int64_t i = 0; i < quads; i++)
        for (int side = -1; side <= 1; side += 2) {
            struct circle_point around = circle_point(i, quads), twist = circle_point(i, 2 * quads);
            double radius = 0.38 + side * 0.12 * twist.cosine;
            add_vertex(&b, radius * around.cosine, radius * around.sine, side * 0.12 * twist.sine);
        }
    for (int64_t i = 0; i + 1 < quads; i++)
        add_quad(&b, 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2);
    add_quad(&b, 2 * quads - 2, 2 * quads - 1, 0, 1); /* joined with half a twist */
    return 0;
}

int generate_soup(struct mesh *mesh, int64_t triangles, uint64_t seed, struct error *err)
{
    *mesh = (struct mesh){0};
    if (check_size("the number of triangles", triangles, 0, err) ||
        mesh_init(mesh, 3 * triangles, triangles, err))
        return -1;
    struct random rng;
    random_init(&rng, seed);
    for (int64_t t = 0; t < triangles; t++) {
        float centre[3];
        for (int axis = 0; axis < 3; axis++)
            centre[axis] = random_float(&rng, -0.45F, 0.45F);
        for (int corner = 0; corner < 3; corner++) {
            int64_t v = 3 * t + corner;
            mesh->triangles[v] = (int32_t)v;
            for (int axis = 0; axis < 3; axis++)
                mesh->positions[3 * v + axis] = centre[axis] + random_float(&rng, -0.05F, 0.05F);
        }
    }
    return 0;
}

int generate_needles(struct mesh *mesh, int64_t triangles, double ratio, uint64_t seed,
                     struct error *err)
{
    *mesh = (struct mesh){0};
    if (!(ratio > 0.0 && ratio <= 1.0))
        return error_set(err, "generating needles: the ratio is %g and must be above 0, at most 1",
                         ratio);
    if (check_size("the number of triangles", triangles, 1, err) ||
        mesh_init(mesh, triangles + 2, triangles, err))
        return -1;
    struct random rng;
    random_init(&rng, seed);
    struct builder b = {.mesh = mesh};
    double step = 1.0 / (double)(triangles + 1); /* half a base */
    for (int64_t i = 0; i < triangles + 2; i++) {
        double jitter = 0.4 * (random_real(&rng) - 0.5); /* bases keep 0.8 to 1.2 of their length */
        add_vertex(&b, ((double)i + jitter) * step - 0.5, i % 2 == 0 ? 0.0 : 2 * step * ratio, 0.0);
    }
    for (int64_t i = 0; i < triangles; i++) {
        if (i % 2 == 0)
            add_triangle(&b, i, i + 2, i + 1);
        else
            add_triangle(&b, i, i + 1, i + 2);
    }
    return 0;
}

int generate_tetrahedron(struct mesh *mesh, struct error *err)
{
    if (mesh_init(mesh, 4, 4, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_vertex(&b, 0.5, 0.5, 0.5);
    add_vertex(&b, 0.5, -0.5, -0.5);
    add_vertex(&b, -0.5, 0.5, -0.5);
    add_vertex(&b, -0.5, -0.5, 0.5);
    add_triangle(&b, 0, 1, 2);
    add_triangle(&b, 0, 2, 3);
    add_triangle(&b, 0, 3, 1);
    add_triangle(&b, 1, 3, 2);
    return 0;
}

int generate_cube(struct mesh *mesh, struct error *err)
{
    if (mesh_init(mesh, 8, 12, err))
        return -1;
    struct builder b = {.mesh = mesh};
    for (int v = 0; v < 8; v++)
        add_vertex(&b, (v & 1) - 0.5, (v >> 1 & 1) - 0.5, (v >> 2) - 0.5);
    add_quad(&b, 0, 2, 3, 1);
    add_quad(&b, 4, 5, 7, 6);
    add_quad(&b, 0, 1, 5, 4);
    add_quad(&b, 2, 6, 7, 3);
    add_quad(&b, 0, 4, 6, 2);
    add_quad(&b, 1, 3, 7, 5);
    return 0;
}

int generate_one_triangle(struct mesh *mesh, struct error *err)
{
    if (mesh_init(mesh, 3, 1, err))
        return -1;
    struct builder b = {.mesh = mesh};
    add_vertex(&b, -0.5, -0.5, 0.0);
    add_vertex(&b, 0.5, -0.5, 0.0);
    add_vertex(&b, 0.0, 0.5, 0.0);
    add_triangle(&b, 0, 1, 2);
    return 0;
}

int generate_empty(struct mesh *mesh, struct error *err)
{
    return mesh_init(mesh, 0, 0, err);
}
