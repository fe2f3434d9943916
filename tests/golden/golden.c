/* See golden.h. */
#include "tests/golden/golden.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const double pi = 3.14159265358979323846;

void stop(const char *what)
{
    fprintf(stderr, "scenes: %s\n", what);
    exit(1);
}

void must(int result, const struct error *err)
{
    if (result != 0)
        stop(err->text);
}

void write_json(const struct golden *golden, const char *name, const json_t *json)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s.json", golden->folder, name);
    if (json_dump_file(json, path, JSON_COMPACT) != 0)
        stop(path);
}

void finish(struct golden *golden, struct scene *scene, const char *name, const char *title,
            const char *subtitle)
{
    json_t *json = scene_to_json(scene);
    if (!json)
        stop("out of memory");
    json_object_set_new(json, "title", json_string(title));
    json_object_set_new(json, "subtitle", json_string(subtitle));
    json_object_set_new(json, "metadata",
                        json_pack("{s:s, s:s, s:s, s:s, s:s}", "exercise", "golden", "case", name,
                                  "verdict", "wrong-answer", "seed", "7", "student",
                                  "Zo\xc3\xab \xce\xa9\n\x1b[31mred"));
    write_json(golden, name, json);
    char scene_file[64], picture_file[64];
    snprintf(scene_file, sizeof scene_file, "%s.json", name);
    snprintf(picture_file, sizeof picture_file, "%s.png", name);
    json_array_append_new(golden->pictures, json_pack("{s:s, s:s, s:i, s:i}", "scene", scene_file,
                                                      "out", picture_file, "width", PICTURE_WIDTH,
                                                      "height", PICTURE_HEIGHT));
    json_decref(json);
    scene_release(scene);
}

/* -- shapes ----------------------------------------------------------------------------------- */

struct mesh new_mesh(int64_t vertices, int64_t triangles)
{
    struct mesh mesh;
    struct error err = {""};
    must(mesh_init(&mesh, vertices, triangles, &err), &err);
    return mesh;
}

void set_vertex(struct mesh *mesh, int32_t v, double x, double y, double z)
{
    mesh->positions[3 * v] = (float)x;
    mesh->positions[3 * v + 1] = (float)y;
    mesh->positions[3 * v + 2] = (float)z;
}

void set_triangle(struct mesh *mesh, int32_t t, int32_t a, int32_t b, int32_t c)
{
    mesh->triangles[3 * t] = a;
    mesh->triangles[3 * t + 1] = b;
    mesh->triangles[3 * t + 2] = c;
}

struct mesh torus(int32_t m, int32_t n)
{
    struct mesh mesh = new_mesh((int64_t)m * n, 2 * (int64_t)m * n);
    for (int32_t i = 0; i < m; i++)
        for (int32_t j = 0; j < n; j++) {
            double u = 2 * pi * i / m, v = 2 * pi * j / n, radius = 1 + .42 * cos(v);
            int32_t here = i * n + j, next = (i + 1) % m * n + j;
            int32_t above = i * n + (j + 1) % n, both = (i + 1) % m * n + (j + 1) % n;
            set_vertex(&mesh, here, radius * cos(u), radius * sin(u), .42 * sin(v));
            set_triangle(&mesh, 2 * here, here, next, both);
            set_triangle(&mesh, 2 * here + 1, here, both, above);
        }
    return mesh;
}

struct mesh sheet(int32_t m, int32_t n, double wave)
{
    struct mesh mesh = new_mesh((int64_t)(m + 1) * (n + 1), 2 * (int64_t)m * n);
    for (int32_t r = 0; r <= m; r++)
        for (int32_t c = 0; c <= n; c++) {
            double x = (double)c / n, y = (double)r / m;
            set_vertex(&mesh, r * (n + 1) + c, x, y, wave * sin(2 * pi * x) * cos(pi * y));
        }
    for (int32_t r = 0; r < m; r++)
        for (int32_t c = 0; c < n; c++) {
            int32_t a = r * (n + 1) + c, b = a + 1, d = a + n + 1, e = d + 1, t = 2 * (r * n + c);
            set_triangle(&mesh, t, a, b, e);
            set_triangle(&mesh, t + 1, a, e, d);
        }
    return mesh;
}

struct mesh sphere(int32_t n, int32_t rows)
{
    struct mesh mesh = new_mesh(2 + (int64_t)n * rows, 2 * (int64_t)n * rows);
    set_vertex(&mesh, 0, 0, 0, .5);
    set_vertex(&mesh, 1, 0, 0, -.5);
    int32_t t = 0;
    for (int32_t r = 0; r < rows; r++)
        for (int32_t i = 0; i < n; i++) {
            double polar = pi * (r + 1) / (rows + 1), around = 2 * pi * i / n;
            int32_t a = 2 + r * n + i, b = 2 + r * n + (i + 1) % n;
            set_vertex(&mesh, a, .5 * sin(polar) * cos(around), .5 * sin(polar) * sin(around),
                       .5 * cos(polar));
            if (r == 0)
                set_triangle(&mesh, t++, 0, a, b);
            if (r + 1 == rows)
                set_triangle(&mesh, t++, 1, b, a);
            else {
                set_triangle(&mesh, t++, a, a + n, b + n);
                set_triangle(&mesh, t++, a, b + n, b);
            }
        }
    return mesh;
}

void put_mesh(struct scene *scene, struct mesh *mesh)
{
    struct error err = {""};
    must(scene_set_mesh(scene, mesh->positions, mesh->vertex_count, mesh->triangles,
                        mesh->triangle_count, &err),
         &err);
    mesh_release(mesh);
}
