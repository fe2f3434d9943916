/* Golden scenes of directions, polygons and numbers. */
#include "tests/golden/golden.h"

#include <math.h>
#include <string.h>

static void set_polygons(struct scene *scene, const float *positions, int64_t vertices,
                         const int32_t *first, const int32_t *corners, int64_t faces)
{
    struct error err = {""};
    must(scene_set_polygons(scene, positions, vertices, first, corners, faces, &err), &err);
}

/* The boundary of a window of a sheet, `side` cells wide and high: vertices in order, so that the
 * mesh lies on the left. Returns their number. */
static int32_t window_loop(int32_t columns, int32_t row, int32_t column, int32_t side,
                           int32_t *loop)
{
    int32_t count = 0, width = columns + 1;
    for (int32_t i = 0; i < side; i++)
        loop[count++] = (row + i) * width + column;
    for (int32_t i = 0; i < side; i++)
        loop[count++] = (row + side) * width + column + i;
    for (int32_t i = side; i > 0; i--)
        loop[count++] = (row + i) * width + column + side;
    for (int32_t i = side; i > 0; i--)
        loop[count++] = row * width + column + i;
    return count;
}

static void cut_window(struct mesh *mesh, int32_t columns, int32_t row, int32_t column,
                       int32_t side)
{
    int32_t kept = 0;
    for (int32_t t = 0; t < mesh->triangle_count; t++) {
        int32_t low = mesh->triangles[3 * t]; /* of its cell */
        int32_t r = low / (columns + 1), c = low % (columns + 1);
        if (r < row || r >= row + side || c < column || c >= column + side)
            memmove(mesh->triangles + 3 * (size_t)kept++, mesh->triangles + 3 * (size_t)t,
                    3 * sizeof *mesh->triangles);
    }
    mesh->triangle_count = kept;
}

/* Drops the vertices that no triangle uses; gives the new number of each. */
static void drop_isolated(struct mesh *mesh, int32_t *number)
{
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        number[v] = -1;
    for (int32_t i = 0; i < 3 * mesh->triangle_count; i++)
        number[mesh->triangles[i]] = 0;
    int32_t count = 0;
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        if (number[v] == 0) {
            memmove(mesh->positions + 3 * (size_t)count, mesh->positions + 3 * (size_t)v,
                    3 * sizeof *mesh->positions);
            number[v] = count++;
        }
    for (int32_t i = 0; i < 3 * mesh->triangle_count; i++)
        mesh->triangles[i] = number[mesh->triangles[i]];
    mesh->vertex_count = count;
}

/* Loops in turn colours, one of them the wrong way round: on a coarse and on a fine mesh. */
static void loops_of_a_sheet(struct golden *golden, int32_t cells, const char *name)
{
    enum { MOST = 1000, MOST_CELLS = 96 };
    static const struct phrase loops = {"loops", "bucles"}, backwards = {"backwards", "al revés"};
    int32_t side = cells / 4, at = cells / 8, loop[MOST], turned[MOST];
    struct mesh mesh = sheet(cells, cells, .06);
    struct scene scene = {0};
    static int32_t number[(MOST_CELLS + 1) * (MOST_CELLS + 1)];
    for (int32_t w = 0; w < 4; w++)
        cut_window(&mesh, cells, at + w / 2 * cells / 2, at + w % 2 * cells / 2, side);
    drop_isolated(&mesh, number);
    for (int32_t w = 0; w < 4; w++) {
        int32_t count =
            window_loop(cells, at + w / 2 * cells / 2, at + w % 2 * cells / 2, side, loop);
        for (int32_t i = 0; i < count; i++)
            turned[count - 1 - i] = loop[i] = number[loop[i]];
        scene_mark_path(&scene, w == 0 ? MARK_WRONG : mark_turn(w), w == 0 ? turned : loop, count,
                        true);
    }
    int32_t count = 0;
    for (int32_t s = 0; s < 4; s++)
        for (int32_t i = 0; i < cells; i++) {
            const int32_t row[4] = {0, i, cells, cells - i}, column[4] = {i, cells, cells - i, 0};
            loop[count++] = number[row[s] * (cells + 1) + column[s]];
        }
    scene_mark_path(&scene, mark_turn(4), loop, count, true);
    scene_name_marks(&scene, MARK_WRONG, backwards);
    scene_name_turns(&scene, loops, 4);
    put_mesh(&scene, &mesh);
    finish(golden, &scene, name, "Loop 0 runs the wrong way round",
           "the mesh must lie on the left of each loop");
}

/* A prism over an L: concave polygons, with the numbers of its faces and edges. */
static void winged_edge_of_a_prism(struct golden *golden)
{
    enum { CORNERS = 6, FACES = CORNERS + 2 };
    static const float plan[CORNERS][2] = {{0, 0},       {3, 0},    {3, 1.2F},
                                           {1.2F, 1.2F}, {1.2F, 3}, {0, 3}};
    float positions[2 * CORNERS * 3];
    int32_t first[FACES + 1] = {0}, corners[4 * CORNERS + 2 * CORNERS], count = 0;
    for (int32_t v = 0; v < 2 * CORNERS; v++) {
        positions[3 * v] = plan[v % CORNERS][0];
        positions[3 * v + 1] = plan[v % CORNERS][1];
        positions[3 * v + 2] = v < CORNERS ? 0 : 1.4F;
    }
    for (int32_t f = 0; f < CORNERS; f++) {
        int32_t next = (f + 1) % CORNERS;
        const int32_t side[4] = {f, next, CORNERS + next, CORNERS + f};
        memcpy(corners + count, side, sizeof side);
        first[f + 1] = count += 4;
    }
    for (int32_t f = CORNERS; f < FACES; f++) {
        for (int32_t i = 0; i < CORNERS; i++)
            corners[count++] = f == CORNERS ? CORNERS - 1 - i : CORNERS + i;
        first[f + 1] = count;
    }
    struct scene scene = {0};
    set_polygons(&scene, positions, 2L * CORNERS, first, corners, FACES);
    const int32_t *roof = corners + first[7];
    scene_mark_arrow(&scene, MARK_WRONG, 7, 8);
    scene_mark_face(&scene, mark_turn(0), corners + first[1], 4);
    scene_mark_face(&scene, mark_turn(5), roof, CORNERS);
    scene_mark_half_edge(&scene, MARK_RIGHT, roof, CORNERS, 2);
    scene_mark_half_edge(&scene, MARK_RIGHT, corners + first[1], 4, 3);
    for (int32_t f = 0; f < FACES; f++)
        scene_label_face(&scene, corners + first[f], first[f + 1] - first[f], f);
    scene_label_edge(&scene, 7, 8, 0);
    scene_label_edge(&scene, 8, 9, 12);
    scene_label_edge(&scene, 7, 1, 3);
    scene_name_marks(&scene, MARK_WRONG, (struct phrase){"next edge found", "siguiente hallada"});
    scene_name_marks(&scene, MARK_RIGHT, (struct phrase){"right", "correcta"});
    scene_name_marks(&scene, mark_turn(0), (struct phrase){"left face", "cara izquierda"});
    scene_name_marks(&scene, mark_turn(5), (struct phrase){"right face", "cara derecha"});
    finish(golden, &scene, "polygons", "The next edge of edge 3 is wrong",
           "edge 3 (1,7) of faces 1 and 7: the next one is edge 12 and not 0");
}

/* Half edges round each face of a coarse mesh, arrows and a path over it. */
static void half_edges_of_a_mesh(struct golden *golden)
{
    struct scene scene = {0};
    struct mesh mesh = sphere(6, 3);
    scene_mark_half_edge(&scene, MARK_WRONG, mesh.triangles + 3 * 17, 3, 1);
    for (int32_t t = 0; t < 18; t++)
        for (int32_t s = 0; s < 3; s++)
            if (t != 17 || s != 1)
                scene_mark_half_edge(&scene, mark_turn(t), mesh.triangles + 3 * (size_t)t, 3, s);
    scene_mark_arrow(&scene, MARK_MISSING, 3, 0);
    scene_mark_path(&scene, MARK_RIGHT, (const int32_t[]){15, 9, 10, 4, 5, 0}, 6, false);
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "half-edges", "Half edge 52 has no twin", "18 of 32 triangles");
}

/* Fans and parts: triangles of a fine mesh in turn colours, one at fault. */
static void parts_of_a_sphere(struct golden *golden)
{
    struct scene scene = {0};
    struct mesh mesh = sphere(36, 18);
    for (int32_t t = 0; t < mesh.triangle_count; t++) {
        const int32_t *v = mesh.triangles + 3 * (size_t)t;
        const float *p = mesh.positions + 3 * (size_t)v[0];
        int64_t part = (int64_t)(6 * (atan2(p[1], p[0]) + pi) / (2 * pi));
        if (t == 100)
            continue;
        if (p[2] > -.2F)
            scene_mark_triangle(&scene, mark_turn(part), v[0], v[1], v[2]);
    }
    scene_mark_triangle(&scene, MARK_WRONG, mesh.triangles[300], mesh.triangles[301],
                        mesh.triangles[302]);
    scene_name_turns(&scene, (struct phrase){"parts of the answer", "partes de la respuesta"}, 6);
    put_mesh(&scene, &mesh);
    finish(golden, &scene, "parts", "Triangle 100 is in no part", "6 parts; 1296 triangles");
}

void marked_scenes(struct golden *golden)
{
    loops_of_a_sheet(golden, 8, "loops-coarse");
    loops_of_a_sheet(golden, 96, "loops-fine");
    winged_edge_of_a_prism(golden);
    half_edges_of_a_mesh(golden);
    parts_of_a_sphere(golden);
}
