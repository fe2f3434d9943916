/* Problem 4.3: the memory of a grid as triangle strips, and the vertices that are processed to draw
 * it. What was built is judged by built_strips.h, here are formulas, numbers and cases. */
#include "graders/library/built_strips.h"
#include "graders/library/mistakes.h"

#include <inttypes.h>

/* What of the built strips decides about a case. */
enum { COVER = BUILT_COVER, WINDING = BUILT_WINDING, SHAPE = COVER | WINDING };
enum { MEMORY = 4, PROCESSED = 8 };

enum { INT_BYTES = 4 }; /* of the table's int, which lies in the caller's struct */

/* ------------------------------------------------------------------------------------- formulas */

static int64_t right_bytes(int64_t m, int64_t n)
{
    return 4 + 8 * m + 12 * built_strips_vertices(m, n);
}

static int64_t bytes_with_short_pointers(int64_t m, int64_t n)
{
    return right_bytes(m, n) - 4 * m;
}

static int64_t bytes_without_table(int64_t m, int64_t n)
{
    return 12 * built_strips_vertices(m, n);
}

static int64_t bytes_without_count(int64_t m, int64_t n)
{
    return right_bytes(m, n) - 4;
}

static int64_t bytes_with_2n_vertices(int64_t m, int64_t n)
{
    return 4 + 8 * m + 24 * m * n;
}

static int64_t bytes_exchanged(int64_t m, int64_t n)
{
    return right_bytes(n, m);
}

static int64_t processed_each_corner(int64_t m, int64_t n)
{
    return 6 * m * n;
}

#define STRIP_RULE                                                                                 \
    "A strip of 2n triangles has 2n + 2 vertices.",                                                \
        "Una tira de 2n triángulos tiene 2n + 2 vértices."
#define POINTER_RULE "A pointer takes 8 bytes, not 4.", "Un puntero ocupa 8 bytes, no 4."

static const struct formula_mistake byte_mistakes[] = {
    MISTAKE(CAUSE_SHORT_POINTERS, bytes_with_short_pointers, POINTER_RULE),
    MISTAKE(CAUSE_TABLE_FORGOTTEN, bytes_without_table,
            "The table of strips (one int and m pointers) counts too.",
            "La tabla de tiras (un entero y m punteros) también cuenta."),
    MISTAKE(CAUSE("count-forgotten", "count forgotten", "contador olvidado"), bytes_without_count,
            "The int of the table counts too.", "El entero de la tabla también cuenta."),
    MISTAKE(CAUSE_FENCE_POST, bytes_with_2n_vertices, STRIP_RULE),
    MISTAKE(CAUSE("exchanged", "m and n exchanged", "m y n intercambiados"), bytes_exchanged,
            "m and n are exchanged: there are m strips of n cells.",
            "m y n están cambiados: hay m tiras de n celdas."),
    MISTAKES_END};
static const struct formula_mistake strips_mistakes[] = {
    MISTAKE(CAUSE_FENCE_POST, lattice_triangles, STRIP_RULE),
    MISTAKE(CAUSE_EACH_CORNER, processed_each_corner, "That is three vertices for each triangle.",
            "Eso son tres vértices por cada triángulo."),
    MISTAKES_END};
static const struct formula_mistake indexed_mistakes[] = {
    MISTAKE(CAUSE_EACH_CORNER, processed_each_corner,
            "An indexed mesh processes each vertex of its table once, not once for each triangle.",
            "Una malla indexada procesa cada vértice de su tabla una vez, no una por triángulo."),
    MISTAKES_END};
static const struct formula bytes = {
    "strips_bytes", {"m", "n"}, {"bytes", "bytes"}, right_bytes, byte_mistakes};
static const struct formula in_strips = {
    "strips_processed_vertices", {"m", "n"}, UNIT_VERTICES, built_strips_vertices, strips_mistakes};
static const struct formula in_mesh = {
    "indexed_processed_vertices", {"m", "n"}, UNIT_VERTICES, lattice_vertices, indexed_mistakes};

/* -------------------------------------------------------------------------------------- numbers */

static const struct number_mistake kilobyte_mistakes[] = {
    MISTAKE_KILOBYTE(397.316),
    MISTAKE(CAUSE_SHORT_POINTERS, 396804.0 / 1024, POINTER_RULE),
    MISTAKE(CAUSE_TABLE_FORGOTTEN, 387, "The table of strips counts too.",
            "La tabla de tiras también cuenta."),
    MISTAKE(CAUSE_FENCE_POST, 394244.0 / 1024, "A strip of 256 triangles has 258 vertices.",
            "Una tira de 256 triángulos tiene 258 vértices."),
    MISTAKE_IN_BYTES(397316),
    MISTAKES_END};
static const struct number_mistake memory_mistakes[] = {
    MISTAKE(CAUSE_UPSIDE_DOWN, 2.0 / 3, "That is strips / indexed.", "Eso es tiras / indexada."),
    MISTAKE(CAUSE("wrong-ratio", "wrong ratio", "cociente incorrecto"), 2,
            "Compare the bytes of both formulas, not their vertices.",
            "Compara los bytes de ambas fórmulas, no sus vértices."),
    MISTAKES_END};
static const struct number_mistake time_mistakes[] = {
    MISTAKE(CAUSE_UPSIDE_DOWN, 0.5, "That is indexed / strips.", "Eso es indexada / tiras."),
    MISTAKE(CAUSE_EACH_CORNER, 6, "The strips share vertices between their triangles.",
            "Los triángulos de una tira comparten vértices."),
    MISTAKES_END};
static const struct number kilobytes =
    NUMBER("strips_kilobytes", 397316.0 / 1024, TWO_DECIMALS, kilobyte_mistakes,
           "It is not the size in KB for m = n = 128.", "No es el tamaño en KB para m = n = 128.");
static const struct number memory_ratio =
    NUMBER("strips_memory_ratio", 1.5, 1e-3, memory_mistakes,
           "It is not bytes of the indexed mesh / bytes of the strips for very large m and n.",
           "No es bytes de la malla indexada / bytes de las tiras para m y n muy grandes.");
static const struct number time_ratio =
    NUMBER("strips_time_ratio", 2, 1e-3, time_mistakes,
           "It is not vertices processed for strips / for the indexed mesh for very large m and n.",
           "No es vértices procesados con tiras / con malla indexada para m y n muy grandes.");

/* --------------------------------------------------------------------------------- built strips */

static const struct cause processed_differs =
    CAUSE("processed-differs", "processed vertices differ", "vértices procesados distintos");

/* The student's functions of vertices against the strips that were built. */
static void judge_processed(const struct built_strips *built, int64_t own, struct judgement *out)
{
    int64_t present = built->strip_count * built->vertices_per_strip;
    if (own == present)
        judge_accept(out);
    else
        judge_reject(out, &processed_differs,
                     "strips_processed_vertices says %" PRId64 ", but the strips that were built "
                     "hold %" PRId64 " vertices.",
                     "strips_processed_vertices dice %" PRId64 ", pero las tiras construidas "
                     "tienen %" PRId64 " vértices.",
                     own, present);
}

static int judge_built(const int64_t asked[4], struct reader *said, const struct usage *usage,
                       struct judgement *out, struct error *err)
{
    struct built_strips built;
    if (!built_status(said, out))
        return 0;
    int64_t own_bytes = read_int(said), own_processed = read_int(said);
    if (built_strips_read(said, asked, &built, out, err))
        return -1;
    struct size_claim claim = {"strips_build", "strips_bytes", INT_BYTES, own_bytes,
                               right_bytes(asked[0], asked[1])};
    int failed = 0;
    if (!out->cause[0] && asked[2] == MEMORY)
        formula_judge_size(&claim, usage, out);
    else if (!out->cause[0] && asked[2] == PROCESSED)
        judge_processed(&built, own_processed, out);
    else if (!out->cause[0])
        failed = built_strips_judge(asked, &built, out, err);
    built_strips_release(&built);
    return failed;
}

static size_t strips_bound(const int64_t asked[4])
{
    return built_bound(right_bytes(asked[0], asked[1]), asked[0]);
}

/* ---------------------------------------------------------------------------------------- cases */

static const struct question build = {"strips_build", .judge = judge_built, .bound = strips_bound};
static const struct question few = {"strips_bytes", .formula = &bytes, .rows = &lattice_few};
static const struct question many = {"strips_bytes", .formula = &bytes, .rows = &lattice_many};
static const struct question large = {"strips_bytes", .formula = &bytes, .rows = &lattice_large};
static const struct question few_in_strips = {"strips_processed_vertices", .formula = &in_strips,
                                              .rows = &lattice_few};
static const struct question many_in_strips = {"strips_processed_vertices", .formula = &in_strips,
                                               .rows = &lattice_many};
static const struct question few_in_mesh = {"indexed_processed_vertices", .formula = &in_mesh,
                                            .rows = &lattice_few};
static const struct question many_in_mesh = {"indexed_processed_vertices", .formula = &in_mesh,
                                             .rows = &lattice_many};
static const struct question in_kilobytes = {"strips_kilobytes", .number = &kilobytes};
static const struct question of_memory = {"strips_memory_ratio", .number = &memory_ratio};
static const struct question of_time = {"strips_time_ratio", .number = &time_ratio};

/* number: m, n, and what is looked at */
static const struct judge_case cases[] = {
    {"course-figure", "strips", 1, PUBLIC | QUICK, .ask = &build, .number = {4, 8, COVER}},
    {"wide-grid", "strips", 2, HIDDEN, .ask = &build, .number = {3, 17, COVER}},
    {"tall-grid", "strips", 3, HIDDEN, .ask = &build, .number = {40, 9, COVER}},
    {"one-column", "strips", 4, HIDDEN, .ask = &build, .number = {6, 1, COVER}},
    {"very-wide-grid", "strips", 5, HIDDEN, .ask = &build, .number = {2, 5000, COVER}},
    {"course-figure-winding", "winding", 6, PUBLIC | QUICK, .ask = &build,
     .number = {4, 8, WINDING}},
    {"tall-grid-winding", "winding", 7, HIDDEN, .ask = &build, .number = {40, 9, WINDING}},
    {"one-column-winding", "winding", 8, HIDDEN, .ask = &build, .number = {6, 1, WINDING}},
    {"one-cell", "smallest", 9, PUBLIC | QUICK, .ask = &build, .number = {1, 1, SHAPE}},
    {"one-row", "smallest", 10, HIDDEN, .ask = &build, .number = {1, 6, SHAPE}},
    {"memory-of-8", "measured-memory", 11, PUBLIC | QUICK, .ask = &build, .number = {8, 8, MEMORY}},
    {"memory-of-23", "measured-memory", 12, HIDDEN, .ask = &build, .number = {23, 23, MEMORY}},
    {"memory-of-128", "measured-memory", 13, HIDDEN, .ask = &build, .number = {128, 128, MEMORY}},
    {"bytes-of-course-figure", "formula", 14, PUBLIC | QUICK, .ask = &few},
    {"bytes-of-many", "formula", 15, QUICK, .ask = &many},
    {"bytes-of-large", "formula-large", 16, QUICK, .ask = &large},
    {"kilobytes-of-128", "kilobytes", 17, PUBLIC | QUICK, .ask = &in_kilobytes},
    {"processed-in-course-figure", "vertices-processed", 18, PUBLIC | QUICK, .ask = &few_in_strips},
    {"processed-in-many", "vertices-processed", 19, QUICK, .ask = &many_in_strips},
    {"indexed-in-course-figure", "vertices-processed", 23, PUBLIC | QUICK, .ask = &few_in_mesh},
    {"indexed-in-many", "vertices-processed", 24, QUICK, .ask = &many_in_mesh},
    {"processed-in-built", "vertices-processed", 20, HIDDEN, .ask = &build,
     .number = {9, 14, PROCESSED}},
    {"limit-of-memory", "limits", 21, PUBLIC | QUICK, .ask = &of_memory},
    {"limit-of-time", "limits", 22, PUBLIC | QUICK, .ask = &of_time},
};

static int make_sized(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err)
{
    (void)seed; /* there is one grid of each size and shape */
    return lattice_make_sized(&build, SHAPE, family, size, input, err);
}

const struct judge judge_memory_strips = {
    .exercise = "memory-strips",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_QUESTION,
    .families = lattice_families,
    .make_sized = make_sized,
    .size_near = lattice_size_near,
};
