/* Golden scenes of what a mesh carries, and of two meshes. */
#include "tests/golden/golden.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static float *new_floats(int64_t count)
{
    float *floats = calloc((size_t)count, sizeof *floats);
    if (!floats)
        stop("out of memory");
    return floats;
}

/* A number a vertex on a fine mesh; the worst is a spike. */
static void values_of_a_torus(struct golden *golden)
{
    static const struct phrase unit = {"mean curvature", "curvatura media"};
    struct scene scene = {0};
    struct error err = {""};
    struct mesh mesh = torus(96, 40);
    float *values = new_floats(mesh.vertex_count);
    for (int32_t v = 0; v < mesh.vertex_count; v++) {
        const float *p = mesh.positions + 3 * (size_t)v;
        values[v] = sqrtf(p[0] * p[0] + p[1] * p[1]);
    }
    const int32_t worst = 85 * 40 + 6;
    values[worst] = 2.5F;
    put_mesh(&scene, &mesh);
    must(scene_set_values(&scene, SCENE_PER_VERTEX, values, .5, 1.5, unit, worst, &err), &err);
    free(values);
    finish(golden, &scene, "values", "Vertex 3406: the curvature is 2.5, and 1.36 is right",
           "3840 vertices; 1 is wrong");
}

/* A number a polygon of a coarse mesh, one of them absent. */
static void values_of_polygons(struct golden *golden)
{
    enum { SIDE = 4, ROW = SIDE + 1, FACES = SIDE * SIDE };
    static const struct phrase unit = {"smallest angle in degrees", "menor ángulo en grados"};
    struct scene scene = {0};
    struct error err = {""};
    float positions[3 * ROW * ROW], values[FACES];
    int32_t first[FACES + 1] = {0}, corners[4 * FACES];
    for (int32_t v = 0; v < ROW * ROW; v++) {
        positions[3 * v] = (float)(v % ROW) + (v == 12 ? .4F : 0);
        int32_t across = v / ROW;
        positions[3 * v + 1] = (float)across + (v == 12 ? .3F : 0);
        positions[3 * v + 2] = .25F * (float)(v % 3);
    }
    for (int32_t f = 0; f < FACES; f++) {
        int32_t low = f / SIDE * ROW + f % SIDE;
        const int32_t quad[] = {low, low + 1, low + ROW + 1, low + ROW};
        memcpy(corners + 4 * (size_t)f, quad, sizeof quad);
        first[f + 1] = 4 * (f + 1);
        values[f] = f == 3 ? NAN : (float)(90 - 5 * f);
    }
    must(scene_set_polygons(&scene, positions, (int64_t)ROW * ROW, first, corners, FACES, &err),
         &err);
    must(scene_set_values(&scene, SCENE_PER_FACE, values, 0, 90, unit, 14, &err), &err);
    scene_label_face(&scene, corners + 4 * 14, 4, 14);
    scene_label_face(&scene, corners + 4 * 3, 4, 3);
    finish(golden, &scene, "values-faces", "Face 14 has an angle of 20 degrees",
           "face 3 has no value; 16 faces");
}

/* Normals: those of the answer, and what would be right; one is turned over, one is zero. */
static void vectors_of_a_sphere(struct golden *golden, int32_t around, const char *name)
{
    static const struct phrase answered = {"normals of the answer", "normales de la respuesta"};
    struct scene scene = {0};
    struct error err = {""};
    struct mesh mesh = sphere(around, around / 2);
    float *answer = new_floats(3 * (int64_t)mesh.vertex_count);
    float *right = new_floats(3 * (int64_t)mesh.vertex_count);
    const int32_t named = 2 + around + around / 3;
    for (int32_t v = 0; v < mesh.vertex_count; v++)
        for (int k = 0; k < 3; k++) {
            float p = 2 * mesh.positions[3 * v + k];
            right[3 * v + k] = p;
            answer[3 * v + k] = v == named ? -p : v == named + 1 ? 0 : p + (k == 2 ? .3F : 0);
        }
    scene_mark_vertex(&scene, MARK_WRONG, named);
    put_mesh(&scene, &mesh);
    must(scene_add_vectors(&scene, MARK_DEGENERATE, answer, &err), &err);
    must(scene_add_vectors(&scene, MARK_RIGHT, right, &err), &err);
    scene_name_marks(&scene, MARK_DEGENERATE, answered);
    free(answer);
    free(right);
    finish(golden, &scene, name, "The normal of a vertex points inwards",
           "and the one beside it is zero");
}

/* The parts of a whole mesh. */
static void groups_of_a_torus(struct golden *golden)
{
    static const struct phrase parts = {"parts", "partes"};
    struct scene scene = {0};
    struct error err = {""};
    struct mesh mesh = torus(60, 24);
    int32_t *group = calloc((size_t)mesh.triangle_count, sizeof *group);
    if (!group)
        stop("out of memory");
    for (int32_t t = 0; t < mesh.triangle_count; t++)
        group[t] = t / 2 / 24 / 7 - (t / 2 % 24 > 20 ? 100 : 0);
    scene_mark_triangle(&scene, MARK_WRONG, mesh.triangles[3 * 2586], mesh.triangles[3 * 2586 + 1],
                        mesh.triangles[3 * 2586 + 2]);
    put_mesh(&scene, &mesh);
    must(scene_set_groups(&scene, group, &err), &err);
    scene_name_turns(&scene, parts, 9);
    free(group);
    finish(golden, &scene, "groups", "Triangle 2586 belongs to part 7",
           "9 parts; some triangles are in none");
}

/* The input, and an answer that lost some triangles and turned one over. */
static void answer_beside(struct golden *golden, int32_t around, const char *name)
{
    struct scene scene = {0};
    struct error err = {""};
    struct mesh input = sphere(around, around / 2), mesh = sphere(around, around / 2);
    struct scene *answer = scene_answer(&scene, &err);
    if (!answer)
        stop("out of memory");
    int32_t kept = 0, lost = 2 * around;
    int32_t *t = mesh.triangles;
    scene_mark_triangle(&scene, MARK_MISSING, t[3 * lost], t[3 * lost + 1], t[3 * lost + 2]);
    scene_mark_triangle(answer, MARK_FLIPPED, t[3 * lost - 2], t[3 * lost - 3], t[3 * lost - 1]);
    for (int32_t i = 0; i < mesh.triangle_count; i++) {
        if (i == lost)
            continue;
        int32_t turned = i == lost - 1;
        int32_t corners[3] = {t[3 * i + turned], t[3 * i + !turned], t[3 * i + 2]};
        memcpy(t + 3 * (size_t)kept++, corners, sizeof corners);
    }
    mesh.triangle_count = kept;
    put_mesh(&scene, &input);
    must(scene_set_answer_mesh(&scene, mesh.positions, mesh.vertex_count, mesh.triangles,
                               mesh.triangle_count, &err),
         &err);
    mesh_release(&mesh);
    finish(golden, &scene, name, "Triangle 11 is clockwise, and one is lost",
           "the answer has one triangle less");
}

/* An answer without triangles. */
static void empty_answer(struct golden *golden)
{
    struct scene scene = {0};
    struct error err = {""};
    struct mesh input = sphere(12, 6);
    put_mesh(&scene, &input);
    must(scene_set_answer_mesh(&scene, NULL, 0, NULL, 0, &err), &err);
    finish(golden, &scene, "answer-empty", "The answer is empty", "84 triangles are expected");
}

void valued_scenes(struct golden *golden)
{
    values_of_a_torus(golden);
    values_of_polygons(golden);
    vectors_of_a_sphere(golden, 8, "vectors");
    vectors_of_a_sphere(golden, 90, "vectors-fine");
    groups_of_a_torus(golden);
    answer_beside(golden, 6, "answer");
    answer_beside(golden, 60, "answer-fine");
    empty_answer(golden);
}
