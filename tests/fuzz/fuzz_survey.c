/* Fuzz target: any bytes as a mesh, which is surveyed. The first byte says how many vertices there are, then
 * a byte each for their coordinates, then a byte a corner. What is counted agrees with what is kept; every
 * element is one of the mesh and is what it is said to be; and the survey of the mesh with its triangles in
 * reverse order counts the same. */
#include "reference/survey/crossing.h"
#include "reference/survey/exact.h"
#include "reference/survey/survey.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t byte_count);

enum { MOST_VERTICES = 60, MOST_TRIANGLES = 150 };

static void require(bool holds, const char *what)
{
    if (holds)
        return;
    fprintf(stderr, "fuzz: it does not hold that %s\n", what);
    abort();
}

/* Few values, so that points coincide and planes are shared; some far away. */
static float coordinate_of(uint8_t byte)
{
    static const float factors[] = {1, 1, 1, 0x1p-20F, 0x1p-140F, 0x1p100F, -1, 0.1F};
    return factors[byte >> 5] * (float)(byte & 7);
}

static struct mesh mesh_of(const uint8_t *bytes, size_t byte_count)
{
    struct mesh mesh;
    size_t vertices = byte_count > 0 ? bytes[0] % (MOST_VERTICES + 1) : 0;
    if (1 + 3 * vertices > byte_count)
        vertices = byte_count > 0 ? (byte_count - 1) / 3 : 0;
    size_t corners = vertices > 0 ? byte_count - 1 - 3 * vertices : 0;
    size_t triangles = corners / 3 < MOST_TRIANGLES ? corners / 3 : MOST_TRIANGLES;
    require(mesh_init(&mesh, (int64_t)vertices, (int64_t)triangles, NULL) == 0, "memory");
    for (size_t i = 0; i < 3 * vertices; i++)
        mesh.positions[i] = coordinate_of(bytes[1 + i]);
    for (size_t i = 0; i < 3 * triangles; i++)
        mesh.triangles[i] = (int32_t)(bytes[1 + 3 * vertices + i] % vertices);
    return mesh;
}

static bool is_vertex(const struct mesh *mesh, int32_t v)
{
    return v >= 0 && v < mesh->vertex_count;
}

static bool is_triangle(const struct mesh *mesh, int32_t t)
{
    return t >= 0 && t < mesh->triangle_count;
}

static void corners_of(const struct mesh *mesh, int32_t triangle, const float *corner[3])
{
    for (int i = 0; i < 3; i++)
        corner[i] = mesh->positions + 3 * (int64_t)mesh->triangles[3 * triangle + i];
}

static void check_element(const struct mesh *mesh, enum survey_kind kind, const int32_t at[4])
{
    const float *p[3], *q[3];
    switch (kind) {
    case SURVEY_DEGENERATE:
    case SURVEY_FLAT:
        require(is_triangle(mesh, at[0]), "it is a triangle");
        corners_of(mesh, at[0], p);
        require(exact_on_line(p[0], p[1], p[2]), "it has no area");
        break;
    case SURVEY_DUPLICATE:
        require(is_triangle(mesh, at[0]) && at[1] >= 0 && at[1] < at[0], "an earlier one is named");
        break;
    case SURVEY_ISOLATED:
    case SURVEY_NONMANIFOLD_VERTEX:
        require(is_vertex(mesh, at[0]), "it is a vertex");
        break;
    case SURVEY_CROSSING:
        require(at[0] < at[1] && is_triangle(mesh, at[0]) && is_triangle(mesh, at[1]),
                "two triangles cross");
        corners_of(mesh, at[0], p);
        corners_of(mesh, at[1], q);
        require(triangles_cross(p, q) && triangles_cross(q, p), "they do, both ways");
        break;
    case SURVEY_T_VERTEX:
        require(is_vertex(mesh, at[0]) && at[0] != at[1] && at[0] != at[2] &&
                    is_vertex(mesh, at[1]) && is_vertex(mesh, at[2]),
                "a vertex lies on an edge of others");
        break;
    default:
        require(at[0] < at[1] && is_vertex(mesh, at[0]) && is_vertex(mesh, at[1]), "it is an edge");
    }
}

static void check_survey(const struct mesh *mesh, const struct mesh_survey *survey)
{
    for (int kind = 0; kind < SURVEY_KINDS; kind++) {
        const struct survey_fault *fault = &survey->faults[kind];
        struct message message;
        require(fault->kept_count == (fault->count < SURVEY_KEPT ? fault->count : SURVEY_KEPT),
                "what is counted is kept");
        for (int32_t i = 0; i < fault->kept_count; i++) {
            check_element(mesh, (enum survey_kind)kind, fault->kept[i].at);
            require(i == 0 ||
                        memcmp(&fault->kept[i - 1], &fault->kept[i], sizeof fault->kept[i]) != 0,
                    "once");
        }
        if (fault->count > 0) {
            survey_say((enum survey_kind)kind, fault->kept, &message);
            require(message.en[0] && message.es[0], "it can be said");
        }
    }
    require(!survey->has_genus || survey->genus >= 0, "a genus is not negative");
    require(survey->area >= 0, "an area is not negative");
}

static void reverse_triangles(struct mesh *mesh)
{
    for (int32_t i = 0, k = mesh->triangle_count - 1; i < k; i++, k--)
        for (int c = 0; c < 3; c++) {
            int32_t corner = mesh->triangles[3 * i + c];
            mesh->triangles[3 * i + c] = mesh->triangles[3 * k + c];
            mesh->triangles[3 * k + c] = corner;
        }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t byte_count)
{
    struct mesh mesh = mesh_of(bytes, byte_count);
    struct mesh_survey survey, other;
    const struct survey_wish wish = {0};
    require(mesh_survey_make(&survey, &mesh, &wish, NULL) == 0, "memory");
    check_survey(&mesh, &survey);
    reverse_triangles(&mesh);
    require(mesh_survey_make(&other, &mesh, &wish, NULL) == 0, "memory");
    for (int kind = 0; kind < SURVEY_KINDS; kind++)
        require(survey.faults[kind].count == other.faults[kind].count,
                "the order of triangles changes no count");
    require(survey.genus == other.genus, "nor the genus");
    mesh_survey_release(&survey);
    mesh_survey_release(&other);
    mesh_release(&mesh);
    return 0;
}
