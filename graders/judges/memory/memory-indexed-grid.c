/* Problem 4.2: the memory of a grid as an indexed mesh. Vertices and triangles are judged by where
 * they lie (lattice.h), so that any numbering, any order and either diagonal is right. */
#include "graders/library/lattice.h"
#include "graders/library/mistakes.h"

/* What of a built grid decides about a case. */
enum { VERTICES = LATTICE_VERTICES, TRIANGLES = LATTICE_TRIANGLES, SHAPE = VERTICES | TRIANGLES };
enum { MEMORY = 4 };

/* ------------------------------------------------------------------------------------- formulas */

static int64_t bytes_without_last_row(int64_t m, int64_t n)
{
    return 36 * m * n;
}

static int64_t bytes_one_triangle_a_cell(int64_t m, int64_t n)
{
    return 12 * lattice_vertices(m, n) + 12 * m * n;
}

static int64_t bytes_of_square(int64_t m, int64_t n)
{
    (void)m;
    return lattice_mesh_bytes(n, n);
}

static int64_t bytes_without_triangles(int64_t m, int64_t n)
{
    return 12 * lattice_vertices(m, n);
}

#define TWO_TRIANGLES "Every cell has two triangles.", "Cada celda tiene dos triángulos."

static const struct formula_mistake byte_mistakes[] = {
    MISTAKE(CAUSE_FENCE_POST, bytes_without_last_row,
            "n cells in a row have n + 1 vertices, not n.",
            "n celdas en una fila tienen n + 1 vértices, no n."),
    MISTAKE(CAUSE_HALF_THE_TRIANGLES, bytes_one_triangle_a_cell, TWO_TRIANGLES),
    MISTAKE(CAUSE("square-only", "square grids only", "solo rejillas cuadradas"), bytes_of_square,
            "That is the size of an n x n grid: m is not looked at.",
            "Ese es el tamaño de una rejilla de n x n: no se tiene en cuenta m."),
    MISTAKE(CAUSE("triangles-forgotten", "triangles forgotten", "triángulos olvidados"),
            bytes_without_triangles, "The table of triangles counts too.",
            "La tabla de triángulos también cuenta."),
    MISTAKES_END};
static const struct formula bytes = {
    "indexed_grid_bytes", {"m", "n"}, {"bytes", "bytes"}, lattice_mesh_bytes, byte_mistakes};

static const struct number_mistake kilobyte_mistakes[] = {
    MISTAKE_KILOBYTE(592.908),
    MISTAKE(CAUSE_FENCE_POST, 576, "128 cells in a row have 129 vertices.",
            "128 celdas en una fila tienen 129 vértices."),
    MISTAKE_IN_BYTES(592908), MISTAKES_END};
static const struct number kilobytes =
    NUMBER("indexed_grid_kilobytes", 592908.0 / 1024, TWO_DECIMALS, kilobyte_mistakes,
           "It is not the size in KB for m = n = 128.", "No es el tamaño en KB para m = n = 128.");

static const struct number_mistake limit_mistakes[] = {
    MISTAKE(CAUSE_UPSIDE_DOWN, 0.5, "That is vertices for each face.",
            "Eso son vértices por cada cara."),
    MISTAKE(CAUSE_HALF_THE_TRIANGLES, 1, TWO_TRIANGLES), MISTAKES_END};
static const struct number limit = NUMBER("indexed_grid_faces_per_vertex", 2, 1e-3, limit_mistakes,
                                          "It is not F / V when m and n are very large.",
                                          "No es F / V cuando m y n son muy grandes.");

/* ----------------------------------------------------------------------------------- built grid */

static int judge_grid(const int64_t asked[4], struct reader *said, const struct usage *usage,
                      struct judgement *out, struct error *err)
{
    struct built_mesh mesh;
    if (!built_mesh_read(said, &mesh, out) ||
        !built_count_is_right(&lattice_vertex_count, asked, mesh.vertex_count, out) ||
        !built_count_is_right(&lattice_triangle_count, asked, mesh.triangle_count, out) ||
        !built_has_table("vertices", mesh.vertices, out) ||
        !built_has_table("triangles", mesh.triangles, out))
        return built_mesh_show(&mesh, &out->scene, err);
    if (!(asked[2] & MEMORY))
        return lattice_judge_mesh(asked, &mesh, out, err);
    struct size_claim claim = {"indexed_grid_build", "indexed_grid_bytes", 0, mesh.own_bytes,
                               lattice_mesh_bytes(asked[0], asked[1])};
    formula_judge_size(&claim, usage, out);
    return 0;
}

static size_t grid_bound(const int64_t asked[4])
{
    return built_bound(lattice_mesh_bytes(asked[0], asked[1]), 2);
}

/* ---------------------------------------------------------------------------------------- cases */

static const struct question build = {"indexed_grid_build", .judge = judge_grid,
                                      .bound = grid_bound};
static const struct question few = {"indexed_grid_bytes", .formula = &bytes, .rows = &lattice_few};
static const struct question many = {"indexed_grid_bytes", .formula = &bytes,
                                     .rows = &lattice_many};
static const struct question large = {"indexed_grid_bytes", .formula = &bytes,
                                      .rows = &lattice_large};
static const struct question in_kilobytes = {"indexed_grid_kilobytes", .number = &kilobytes};
static const struct question in_the_limit = {"indexed_grid_faces_per_vertex", .number = &limit};

/* number: m, n, and what is looked at */
static const struct judge_case cases[] = {
    {"course-figure", "vertices", 1, PUBLIC | QUICK, .ask = &build, .number = {4, 8, VERTICES}},
    {"wide-grid", "vertices", 2, HIDDEN, .ask = &build, .number = {3, 17, VERTICES}},
    {"tall-grid", "vertices", 3, HIDDEN, .ask = &build, .number = {40, 9, VERTICES}},
    {"very-wide-grid", "vertices", 4, HIDDEN, .ask = &build, .number = {2, 5000, VERTICES}},
    {"course-figure-triangles", "triangles", 5, PUBLIC | QUICK, .ask = &build,
     .number = {4, 8, TRIANGLES}},
    {"two-cells-a-side", "triangles", 6, PUBLIC, .ask = &build, .number = {2, 2, TRIANGLES}},
    {"wide-grid-triangles", "triangles", 7, HIDDEN, .ask = &build, .number = {3, 17, TRIANGLES}},
    {"tall-grid-triangles", "triangles", 8, HIDDEN, .ask = &build, .number = {40, 9, TRIANGLES}},
    {"large-grid-triangles", "triangles", 9, HIDDEN, .ask = &build,
     .number = {190, 180, TRIANGLES}},
    {"one-cell", "smallest", 10, PUBLIC | QUICK, .ask = &build, .number = {1, 1, SHAPE}},
    {"one-row", "smallest", 11, HIDDEN, .ask = &build, .number = {1, 6, SHAPE}},
    {"one-column", "smallest", 12, HIDDEN, .ask = &build, .number = {6, 1, SHAPE}},
    {"memory-of-8", "measured-memory", 13, PUBLIC | QUICK, .ask = &build, .number = {8, 8, MEMORY}},
    {"memory-of-23", "measured-memory", 14, HIDDEN, .ask = &build, .number = {23, 23, MEMORY}},
    {"memory-of-128", "measured-memory", 15, HIDDEN, .ask = &build, .number = {128, 128, MEMORY}},
    {"bytes-of-course-figure", "formula", 16, PUBLIC | QUICK, .ask = &few},
    {"bytes-of-many", "formula", 17, QUICK, .ask = &many},
    {"bytes-of-large", "formula-large", 18, QUICK, .ask = &large},
    {"kilobytes-of-128", "kilobytes", 19, PUBLIC | QUICK, .ask = &in_kilobytes},
    {"limit-of-faces", "limit", 20, PUBLIC | QUICK, .ask = &in_the_limit},
};

static int make_sized(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err)
{
    (void)seed; /* there is one grid of each size and shape */
    return lattice_make_sized(&build, SHAPE, family, size, input, err);
}

const struct judge judge_memory_indexed_grid = {
    .exercise = "memory-indexed-grid",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_QUESTION,
    .families = lattice_families,
    .make_sized = make_sized,
    .size_near = lattice_size_near,
};
