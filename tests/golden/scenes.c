/* Writes the golden scenes and the job that draws them into a folder:
 *
 *     scenes FOLDER */
#include "tests/golden/golden.h"

#include <math.h>
#include <string.h>

/* Every way of drawing an edge, on a torus with a hole. */
static void edges_of_a_torus(struct golden *golden)
{
    enum { AROUND = 64, TUBE = 28, HOLE_I = 53, HOLE_J = 3, HOLE = 4 };
    struct scene scene = {.ok_count = 5328};
    struct mesh mesh = torus(AROUND, TUBE);
    int32_t kept = 0;
    for (int32_t t = 0; t < mesh.triangle_count; t++) {
        int32_t i = t / 2 / TUBE, j = t / 2 % TUBE;
        if (i >= HOLE_I && i < HOLE_I + HOLE && j >= HOLE_J && j < HOLE_J + HOLE)
            continue;
        memmove(mesh.triangles + 3 * (size_t)kept++, mesh.triangles + 3 * (size_t)t,
                3 * sizeof *mesh.triangles);
    }
    mesh.triangle_count = kept;
    for (int32_t k = 0; k < 24; k++) {
        int32_t v = k * 71 % (AROUND * TUBE), i = v / TUBE, j = v % TUBE;
        int32_t across = (i + 1) % AROUND * TUBE + j, along = i * TUBE + (j + 1) % TUBE;
        if (k % 3 == 0)
            scene_mark_edge(&scene, MARK_MISSING, v, across);
        else if (k % 3 == 1)
            scene_mark_edge(&scene, MARK_DUPLICATE, v, along);
        else if (k % 4 == 0)
            scene_mark_edge(&scene, MARK_EXTRA, v, (i + 5) % AROUND * TUBE + (j + 4) % TUBE);
    }
    for (int32_t s = 0; s < HOLE; s++) {
        int32_t low = (HOLE_I + s) * TUBE + HOLE_J, left = HOLE_I * TUBE + HOLE_J + s;
        scene_mark_edge(&scene, MARK_BOUNDARY, low, low + TUBE);
        scene_mark_edge(&scene, MARK_BOUNDARY, low + HOLE, low + HOLE + TUBE);
        scene_mark_edge(&scene, MARK_BOUNDARY, left, left + 1);
        scene_mark_edge(&scene, MARK_BOUNDARY, left + HOLE * TUBE, left + HOLE * TUBE + 1);
    }
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "edges", "Edge table of a torus with a hole",
           "edge 1 (0,28) is missing; 1792 vertices, 3552 triangles");
}

/* Every other mark on a mesh small enough for the vertices' numbers. */
static void marks_of_a_small_mesh(struct golden *golden)
{
    struct scene scene = {.ok_count = 20};
    struct mesh mesh = sphere(6, 3);
    int32_t swapped = mesh.triangles[3 * 9];
    mesh.triangles[3 * 9] = mesh.triangles[3 * 9 + 1];
    mesh.triangles[3 * 9 + 1] = swapped;
    scene_mark_triangle(&scene, MARK_FLIPPED, mesh.triangles[27], mesh.triangles[28],
                        mesh.triangles[29]);
    scene_mark_triangle(&scene, MARK_MISSING, 10, 16, 17);
    scene_mark_edge(&scene, MARK_DEGENERATE, 0, 6);
    scene_mark_edge(&scene, MARK_WRONG, 12, 13);
    scene_mark_vertex(&scene, MARK_EXTRA, 7);
    scene_mark_vertex(&scene, MARK_DEGENERATE, 15);
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "marks", "Winding and degenerate elements",
           "triangle 9 is clockwise seen from outside");
}

static void flat_sheet(struct golden *golden)
{
    struct scene scene = {.ok_count = 700};
    struct mesh mesh = sheet(12, 18, 0);
    mesh.vertex_count -= 1; /* one corner is gone: its triangles with it */
    mesh.triangle_count -= 2;
    for (int32_t c = 0; c < 18; c++)
        scene_mark_edge(&scene, MARK_MISSING, c, c + 1);
    for (int32_t r = 0; r < 11; r++)
        scene_mark_edge(&scene, MARK_BOUNDARY, r * 19, (r + 1) * 19);
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "flat", "Boundary edges of the grid are lost",
           "18 of 59 boundary edges are missing; 246 vertices, 430 triangles");
}

static void far_needles(struct golden *golden)
{
    enum { NEEDLES = 60 };
    struct scene scene = {0};
    struct mesh mesh = new_mesh(NEEDLES + 2 + 3, NEEDLES);
    for (int32_t v = 0; v < NEEDLES + 2; v++)
        set_vertex(&mesh, v, 1e6 + (v % 2 ? 500 : 0), -2e6 + 4 * v, 3e6 + 40 * sin(v * .2));
    for (int32_t t = 0; t < NEEDLES; t++)
        set_triangle(&mesh, t, t, t + 1 + t % 2, t + 2 - t % 2);
    for (int32_t i = 0; i < 3; i++)
        set_vertex(&mesh, NEEDLES + 2 + i, 1e6 + 120 * i, -2e6 - 60, 3e6);
    scene_mark_edge(&scene, MARK_WRONG, 20, 21);
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "needles", "Needles a million units from the origin",
           "62 vertices and 3 that no triangle uses");
}

static void one_triangle(struct golden *golden)
{
    struct scene scene = {0};
    struct mesh mesh = new_mesh(3, 1);
    set_vertex(&mesh, 1, 1, 0, 0);
    set_vertex(&mesh, 2, 0, 0, 1);
    set_triangle(&mesh, 0, 0, 1, 2);
    scene_mark_edge(&scene, MARK_DUPLICATE, 1, 2);
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "triangle", "One triangle has three edges",
           "edge 1 (1,2) is listed twice");
}

static void empty_mesh(struct golden *golden)
{
    struct scene scene = {0};
    struct error err = {""};
    must(scene_set_mesh(&scene, NULL, 0, NULL, 0, &err), &err);
    finish(golden, &scene, "empty", "The empty mesh has no edges", "3 edges were listed");
}

static void strips_of_a_sheet(struct golden *golden)
{
    enum { ROWS = 7, COLUMNS = 12 };
    struct scene scene = {0};
    struct mesh mesh = sheet(ROWS, COLUMNS, .09);
    struct error err = {""};
    for (int32_t r = 0; r < ROWS; r++) {
        float positions[3 * 2 * (COLUMNS + 1)];
        for (int32_t i = 0; i < 2 * (COLUMNS + 1); i++) {
            int32_t upper = r == 3 ? i % 2 == 0 : i % 2 == 1; /* strip 3 starts on the wrong side */
            int32_t v = (r + !upper) * (COLUMNS + 1) + i / 2;
            memcpy(positions + 3 * (size_t)i, mesh.positions + 3 * (size_t)v, 3 * sizeof(float));
        }
        must(scene_add_strip(&scene, positions, 2 * (COLUMNS + 1), &err), &err);
    }
    for (int32_t c = 0; c < COLUMNS; c++) {
        int32_t low = 3 * (COLUMNS + 1) + c, high = low + COLUMNS + 1;
        scene_mark_triangle(&scene, MARK_FLIPPED, low, high, low + 1);
        scene_mark_triangle(&scene, MARK_FLIPPED, low + 1, high, high + 1);
    }
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "strips", "Strip 3 is wound the wrong way",
           "7 strips of 24 triangles; its 24 triangles are clockwise");
}

static void voxels_beside_a_mesh(struct golden *golden)
{
    enum { SIDE = 16 };
    uint8_t bits[SIDE * SIDE * SIDE / 8] = {0};
    for (int32_t i = 0; i < SIDE * SIDE * SIDE; i++) {
        double x = i % SIDE + .5 - SIDE / 2, y = i / SIDE % SIDE + .5 - SIDE / 2;
        double z = i / SIDE / SIDE + .5 - SIDE / 2;
        if (x * x + y * y + z * z <= SIDE * SIDE / 4)
            bits[i / 8] = (uint8_t)(bits[i / 8] | 1 << i % 8);
    }
    struct scene scene = {0};
    struct error err = {""};
    struct mesh mesh = sphere(SIDE, SIDE - 2);
    must(scene_set_voxels(&scene, bits, SIDE, &err), &err);
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "voxels", "A sphere as voxels and as a mesh",
           "k = 16: the voxels take less; the mesh from k = 288 on");
}

static void growth_chart(struct golden *golden)
{
    enum { POINTS = 7 };
    struct scene scene = {.x_label = "triangles", .y_label = "instructions"};
    struct error err = {""};
    double n[POINTS], submission[POINTS], reference[POINTS];
    for (int i = 0; i < POINTS; i++) {
        n[i] = 128 << i;
        submission[i] = 900 * n[i] + 3.1 * n[i] * n[i];
        reference[i] = 60 * n[i] + 4000;
    }
    must(scene_add_curve(&scene, "submission", n, submission, POINTS, 1.72, &err), &err);
    must(scene_add_curve(&scene, "reference", n, reference, POINTS, 0.91, &err), &err);
    finish(golden, &scene, "growth", "Instructions grow as n\xc2\xb2 beyond 1024 triangles",
           "family grid-scrambled; allowed: n lg n");
}

static void memory_chart(struct golden *golden)
{
    enum { POINTS = 13 };
    struct scene scene = {.x_label = "k", .y_label = "bytes"};
    struct error err = {""};
    double k[POINTS], voxels[POINTS], mesh[POINTS], formula[POINTS], flat[POINTS];
    for (int i = 0; i < POINTS; i++) {
        k[i] = round(8 * pow(2, i * .6));
        voxels[i] = ceil(k[i] * k[i] * k[i] / 8);
        mesh[i] = 36 * k[i] * k[i];
        formula[i] = 40 * k[i] * k[i] + 900;
    }
    for (int i = 0; i < POINTS; i++)
        flat[i] = 2.5e8 / (1 + i % 2);
    must(scene_add_curve(&scene, "limit", k, flat, POINTS, 0, &err), &err);
    must(scene_add_curve(&scene, "voxels", k, voxels, POINTS, 0, &err), &err);
    must(scene_add_curve(&scene, "mesh", k, mesh, POINTS, 0, &err), &err);
    must(scene_add_curve(&scene, "mesh, measured", k, formula, POINTS, 0, &err), &err);
    finish(golden, &scene, "memory", "Voxels against meshes",
           "the mesh as formula and as measured heap");
}

/* A scene that lies: README.md of the renderer promises a tile with the reason. */
static void write_lie(struct golden *golden)
{
    json_t *json =
        json_pack("{s:s, s:s, s:{s:i, s:i, s:s, s:s}}", "kind", "mesh", "title",
                  "A scene that lies about its size", "mesh", "vertex_count", 3, "triangle_count",
                  1, "positions", "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA", "triangles",
                  "AAAAAAEAAAAHAAAA");
    write_json(golden, "lie", json);
    json_decref(json);
    json_array_append_new(golden->pictures,
                          json_pack("{s:s, s:s, s:i, s:i}", "scene", "lie.json", "out", "lie.png",
                                    "width", PICTURE_WIDTH, "height", PICTURE_HEIGHT));
}

static json_t *contact_sheet(void)
{
    return json_pack("{s:s, s:s, s:s, s:i, s:[{s:s, s:s}, {s:s, s:s}, {s:s, s:s}, {s:s, s:s}]}",
                     "title", "Zo\xc3\xab M\xc3\xbcller-\xce\xa9: rejected cases", "subtitle",
                     "4 cases of 2 exercises", "out", "sheet.png", "columns", 2, "cells", "picture",
                     "edges.png", "caption", "torus-with-hole\nwrong answer: missing-edge",
                     "picture", "strips.png", "caption", "strips-of-grid\nwrong answer: flipped",
                     "picture", "absent.png", "caption", "no-picture\nfault: $x$ | y \\ z",
                     "picture", "growth.png", "caption", "growth\ngrows too fast");
}

int main(int argc, char **argv)
{
    if (argc != 2)
        stop("usage: scenes FOLDER");
    struct golden golden = {.folder = argv[1], .pictures = json_array()};
    edges_of_a_torus(&golden);
    marks_of_a_small_mesh(&golden);
    flat_sheet(&golden);
    far_needles(&golden);
    one_triangle(&golden);
    empty_mesh(&golden);
    strips_of_a_sheet(&golden);
    voxels_beside_a_mesh(&golden);
    growth_chart(&golden);
    memory_chart(&golden);
    write_lie(&golden);
    marked_scenes(&golden);
    json_t *job = json_pack("{s:o, s:[o]}", "pictures", golden.pictures, "sheets", contact_sheet());
    write_json(&golden, "job", job);
    json_decref(job);
    return 0;
}
