/* Problem 4.1: the memory of a sphere as voxels and as a mesh. Sizes are sphere_sizes.h's, what was
 * built is judged by voxels.h and sphere.h; here are numbers and cases. */
#include "graders/library/questions.h"
#include "graders/library/sphere.h"
#include "graders/library/sphere_sizes.h"
#include "graders/library/voxels.h"

#include <inttypes.h>
#include <math.h>

/* What of something built decides about a case. */
enum { VOXELS = 1, VERTICES = 2, TRIANGLES = 4, SHAPE = VERTICES | TRIANGLES, MEMORY = 8 };

/* ------------------------------------------------------------------------- formulas and numbers */

static const struct formula voxel_formula = {"voxel_sphere_bytes",
                                             {"k", NULL},
                                             {"bytes", "bytes"},
                                             sphere_voxel_bytes,
                                             sphere_voxel_mistakes};
static const struct formula mesh_formula = {
    "mesh_sphere_bytes", {"k", NULL}, {"bytes", "bytes"}, sphere_mesh_bytes, sphere_mesh_mistakes};

/* Pairs of k and 0. */
static const int32_t few[] = {3, 0, 4, 0, 16, 0};
static const int32_t many[] = {
    3,    0, 4,    0, 5,     0, 6,     0, 7,      0, 8,      0, 9,       0, 10,      0,
    11,   0, 15,   0, 17,    0, 31,    0, 32,     0, 33,     0, 64,      0, 99,      0,
    100,  0, 128,  0, 256,   0, 287,   0, 288,    0, 512,    0, 777,     0, 1024,    0,
    2048, 0, 7777, 0, 10000, 0, 10923, 0, 100000, 0, 299999, 0, 1000000, 0, 2000000, 0};
static const struct question_rows few_rows = QUESTION_ROWS(few);
static const struct question_rows many_rows = QUESTION_ROWS(many);

static const struct number_mistake voxel_kilobyte_mistakes[] = {
    MISTAKE_KILOBYTE(0.512), MISTAKE_BYTE_A_CELL(4), MISTAKE_IN_BYTES(512), MISTAKES_END};
static const struct number_mistake mesh_kilobyte_mistakes[] = {
    MISTAKE_CLOSED_GRID(9),
    MISTAKE_SHARED_POLES(8088.0 / 1024),
    MISTAKE_REPLICATED_SEAM(8472.0 / 1024),
    MISTAKE_NO_FLAT_TRIANGLES(8448.0 / 1024),
    MISTAKE_KILOBYTE(8.832),
    MISTAKE_IN_BYTES(8832),
    MISTAKES_END};
static const struct number_mistake voxel_megabyte_mistakes[] = {
    MISTAKE_MEGABYTE(134.217728), MISTAKE_BYTE_A_CELL(1024), MISTAKES_END};
static const struct number_mistake mesh_megabyte_mistakes[] = {
    MISTAKE_CLOSED_GRID(36), MISTAKE_SHARED_POLES(37675032.0 / 1048576),
    MISTAKE_REPLICATED_SEAM(37699608.0 / 1048576), MISTAKE_MEGABYTE(37.72416), MISTAKES_END};
static const struct number_mistake crossover_mistakes[] = {
    MISTAKE(CAUSE_BYTE_A_CELL, 36, "That is where it would be if a cell took a byte.",
            "Ahí estaría si una celda ocupara un byte."),
    MISTAKE(CAUSE("one-too-few", "one too few", "uno de menos"), 287,
            "With k = 287 the voxels are still smaller: compare whole bytes.",
            "Con k = 287 los vóxeles aún ocupan menos: compara bytes enteros."),
    MISTAKE(CAUSE("one-too-many", "one too many", "uno de más"), 289,
            "With a k one smaller the mesh is smaller already.",
            "Con un k una unidad menor la malla ya ocupa menos."),
    MISTAKES_END};

#define KILOBYTE_RULE "It is not the size in KB for k = 16.", "No es el tamaño en KB con k = 16."
#define MEGABYTE_RULE                                                                              \
    "It is not the size in MB for k = 1024.", "No es el tamaño en MB con k = 1024."
static const struct number voxel_kilobytes =
    NUMBER("voxel_sphere_kilobytes", 0.5, TWO_DECIMALS, voxel_kilobyte_mistakes, KILOBYTE_RULE);
static const struct number mesh_kilobytes =
    NUMBER("mesh_sphere_kilobytes", 8.625, TWO_DECIMALS, mesh_kilobyte_mistakes, KILOBYTE_RULE);
static const struct number voxel_megabytes =
    NUMBER("voxel_sphere_megabytes", 128, TWO_DECIMALS, voxel_megabyte_mistakes, MEGABYTE_RULE);
static const struct number mesh_megabytes =
    NUMBER("mesh_sphere_megabytes", 37724160.0 / 1048576, TWO_DECIMALS, mesh_megabyte_mistakes,
           MEGABYTE_RULE);
static const struct number smallest_k =
    NUMBER("smallest_k_for_mesh", 288, 0, crossover_mistakes,
           "It is not the smallest k with which the mesh takes fewer bytes.",
           "No es el menor k con el que la malla ocupa menos bytes.");

/* ------------------------------------------------------------------------------- what was built */

static int judge_voxels(const int64_t asked[4], struct reader *said, const struct usage *usage,
                        struct judgement *out, struct error *err)
{
    int64_t byte_count;
    if (!built_status(said, out))
        return 0;
    const uint8_t *bits = read_table(said, &byte_count, 1);
    struct size_claim claim = {"voxel_sphere_build", "voxel_sphere_bytes", 0, read_int(said),
                               sphere_voxel_bytes(asked[0], 0)};
    if (!built_is_complete(said, out) ||
        !built_count_is_right(&sphere_byte_count, asked, byte_count, out) ||
        !built_has_table("bits", bits, out))
        return 0;
    if (asked[2] != MEMORY)
        return voxels_judge((int32_t)asked[0], bits, out, err);
    formula_judge_size(&claim, usage, out);
    return 0;
}

static int judge_mesh(const int64_t asked[4], struct reader *said, const struct usage *usage,
                      struct judgement *out, struct error *err)
{
    struct built_mesh mesh;
    int32_t k = (int32_t)asked[0];
    if (!built_mesh_read(said, &mesh, out) ||
        !built_count_is_right(&sphere_vertex_count, asked, mesh.vertex_count, out) ||
        !built_has_table("vertices", mesh.vertices, out))
        return built_mesh_show(&mesh, &out->scene, err);
    struct size_claim claim = {"mesh_sphere_build", "mesh_sphere_bytes", 0, mesh.own_bytes,
                               sphere_mesh_bytes(k, 0)};
    if (asked[2] == MEMORY) {
        formula_judge_size(&claim, usage, out);
        return 0;
    }
    if ((asked[2] & VERTICES) && sphere_judge_vertices(k, &mesh, out, err))
        return -1;
    if (!out->cause[0] && (asked[2] & TRIANGLES)) {
        if (!built_count_is_right(&sphere_triangle_count, asked, mesh.triangle_count, out) ||
            !built_has_table("triangles", mesh.triangles, out))
            return built_mesh_show(&mesh, &out->scene, err);
        if (sphere_judge_triangles(k, &mesh, out, err))
            return -1;
    }
    out->accepted = !out->cause[0];
    return 0;
}

static size_t voxel_bound(const int64_t asked[4])
{
    return built_bound(sphere_voxel_bytes(asked[0], 0), 1);
}

static size_t mesh_bound(const int64_t asked[4])
{
    return built_bound(sphere_mesh_bytes(asked[0], 0), 2);
}

/* ---------------------------------------------------------------------------------------- cases */

static const struct question voxels = {"voxel_sphere_build", .judge = judge_voxels,
                                       .bound = voxel_bound};
static const struct question mesh = {"mesh_sphere_build", .judge = judge_mesh, .bound = mesh_bound};
static const struct question few_voxels = {"voxel_sphere_bytes", .formula = &voxel_formula,
                                           .rows = &few_rows};
static const struct question many_voxels = {"voxel_sphere_bytes", .formula = &voxel_formula,
                                            .rows = &many_rows};
static const struct question few_meshes = {"mesh_sphere_bytes", .formula = &mesh_formula,
                                           .rows = &few_rows};
static const struct question many_meshes = {"mesh_sphere_bytes", .formula = &mesh_formula,
                                            .rows = &many_rows};
static const struct question voxel_kb = {"voxel_sphere_kilobytes", .number = &voxel_kilobytes};
static const struct question mesh_kb = {"mesh_sphere_kilobytes", .number = &mesh_kilobytes};
static const struct question voxel_mb = {"voxel_sphere_megabytes", .number = &voxel_megabytes};
static const struct question mesh_mb = {"mesh_sphere_megabytes", .number = &mesh_megabytes};
static const struct question crossover = {"smallest_k_for_mesh", .number = &smallest_k};

/* number: k, 0, and what is looked at */
static const struct judge_case cases[] = {
    {"voxels-4", "voxels", 1, PUBLIC | QUICK, .ask = &voxels, .number = {4, 0, VOXELS}},
    {"voxels-2", "voxels", 2, HIDDEN, .ask = &voxels, .number = {2, 0, VOXELS}},
    {"voxels-16", "voxels", 3, PUBLIC, .ask = &voxels, .number = {16, 0, VOXELS}},
    {"voxels-30", "voxels", 4, HIDDEN, .ask = &voxels, .number = {30, 0, VOXELS}},
    {"voxels-32", "voxels", 5, HIDDEN, .ask = &voxels, .number = {32, 0, VOXELS}},
    {"voxels-3", "voxels-odd", 6, PUBLIC | QUICK, .ask = &voxels, .number = {3, 0, VOXELS}},
    {"voxels-1", "voxels-odd", 7, HIDDEN, .ask = &voxels, .number = {1, 0, VOXELS}},
    {"voxels-17", "voxels-odd", 8, HIDDEN, .ask = &voxels, .number = {17, 0, VOXELS}},
    {"voxels-33", "voxels-odd", 9, HIDDEN, .ask = &voxels, .number = {33, 0, VOXELS}},
    {"vertices-6", "mesh-vertices", 10, PUBLIC | QUICK, .ask = &mesh, .number = {6, 0, VERTICES}},
    {"vertices-3", "mesh-vertices", 11, HIDDEN, .ask = &mesh, .number = {3, 0, VERTICES}},
    {"vertices-16", "mesh-vertices", 12, HIDDEN, .ask = &mesh, .number = {16, 0, VERTICES}},
    {"vertices-48", "mesh-vertices", 13, HIDDEN, .ask = &mesh, .number = {48, 0, VERTICES}},
    {"triangles-6", "mesh-triangles", 14, PUBLIC | QUICK, .ask = &mesh,
     .number = {6, 0, TRIANGLES}},
    {"triangles-3", "mesh-triangles", 15, HIDDEN, .ask = &mesh, .number = {3, 0, TRIANGLES}},
    {"triangles-16", "mesh-triangles", 16, HIDDEN, .ask = &mesh, .number = {16, 0, TRIANGLES}},
    {"triangles-48", "mesh-triangles", 17, HIDDEN, .ask = &mesh, .number = {48, 0, TRIANGLES}},
    {"voxel-memory-16", "measured-memory", 18, PUBLIC | QUICK, .ask = &voxels,
     .number = {16, 0, MEMORY}},
    {"mesh-memory-16", "measured-memory", 19, PUBLIC | QUICK, .ask = &mesh,
     .number = {16, 0, MEMORY}},
    {"voxel-memory-36", "measured-memory", 20, HIDDEN, .ask = &voxels, .number = {36, 0, MEMORY}},
    {"mesh-memory-50", "measured-memory", 21, HIDDEN, .ask = &mesh, .number = {50, 0, MEMORY}},
    {"voxel-bytes-of-few", "voxel-formula", 22, PUBLIC | QUICK, .ask = &few_voxels},
    {"voxel-bytes-of-many", "voxel-formula", 23, QUICK, .ask = &many_voxels},
    {"mesh-bytes-of-few", "mesh-formula", 24, PUBLIC | QUICK, .ask = &few_meshes},
    {"mesh-bytes-of-many", "mesh-formula", 25, QUICK, .ask = &many_meshes},
    {"voxel-kilobytes-of-16", "sizes", 26, PUBLIC | QUICK, .ask = &voxel_kb},
    {"mesh-kilobytes-of-16", "sizes", 27, PUBLIC | QUICK, .ask = &mesh_kb},
    {"voxel-megabytes-of-1024", "sizes", 28, PUBLIC | QUICK, .ask = &voxel_mb},
    {"mesh-megabytes-of-1024", "sizes", 29, PUBLIC | QUICK, .ask = &mesh_mb},
    {"smallest-k", "crossover", 30, PUBLIC | QUICK, .ask = &crossover},
};

enum { FAMILY_VOXELS, FAMILY_MESH };
static const struct size_family families[] = {
    [FAMILY_VOXELS] = {"voxels", FAMILY_OWN, 0}, [FAMILY_MESH] = {"mesh", FAMILY_OWN, 0}, {NULL}};

/* k is whole. */
static int64_t size_near(int family, int64_t size)
{
    int64_t k = llround(family == FAMILY_VOXELS ? cbrt((double)size) : sqrt((double)size));
    return family == FAMILY_VOXELS ? k * k * k : k * k;
}

/* `size` cells or vertices. There is one sphere for a k. */
static int make_sized(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err)
{
    bool of_voxels = family == FAMILY_VOXELS;
    double k = round(of_voxels ? cbrt((double)size) : sqrt((double)size));
    const int64_t asked[4] = {(int64_t)k, 0, of_voxels ? VOXELS : SHAPE};
    (void)seed;
    if (!(k >= 3 && k <= 4096))
        return error_set(err, "no sphere of %" PRId64 " cells or vertices is made", size);
    return question_write(of_voxels ? &voxels : &mesh, asked, input, err);
}

const struct judge judge_memory_voxels_vs_mesh = {
    .exercise = "memory-voxels-vs-mesh",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_QUESTION,
    .families = families,
    .make_sized = make_sized,
    .size_near = size_near,
};
