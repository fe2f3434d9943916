/* Judges memory-voxels-vs-mesh (problem 4.1). Voxels are compared with an exact test of every
 * cell's centre; the mesh is judged by where its vertices lie (graders/library/sphere.h). What
 * books do otherwise at the poles and the seam is known by name, and a student who did that is told
 * so.
 */
#include "graders/judges/judge.h"
#include "graders/library/formula.h"
#include "graders/library/sphere.h"
#include "graders/runner/memory/questions.h"
#include "graders/scene/show.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What of something built decides about a case. */
enum aspect { LOOK_AT_VOXELS = 1, LOOK_AT_VERTICES = 2, LOOK_AT_TRIANGLES = 4, LOOK_AT_MEMORY = 8 };
enum { SHAPE = LOOK_AT_VERTICES | LOOK_AT_TRIANGLES, SHOWN_VOXELS_PER_SIDE = 128 };

/* ----------------------------------------------------------------- formulas */

static int64_t right_voxel_bytes(int64_t k, int64_t unused)
{
    (void)unused;
    return (k * k * k + 7) / 8;
}

static int64_t right_mesh_bytes(int64_t k, int64_t unused)
{
    (void)unused;
    return 36 * k * k - 24 * k;
}

static int64_t byte_a_cell(int64_t k, int64_t unused)
{
    (void)unused;
    return k * k * k;
}

static int64_t rounded_down(int64_t k, int64_t unused)
{
    (void)unused;
    return k * k * k / 8;
}

static int64_t padded_slices(int64_t k, int64_t unused)
{
    (void)unused;
    return (k * k + 7) / 8 * k;
}

static int64_t closed_grid(int64_t k, int64_t unused)
{
    (void)unused;
    return 36 * k * k;
}

static int64_t shared_poles(int64_t k, int64_t unused)
{
    (void)unused;
    return 12 * (k * (k - 2) + 2) + 24 * k * (k - 2);
}

static int64_t replicated_seam(int64_t k, int64_t unused)
{
    (void)unused;
    return 12 * k * k + 24 * (k - 1) * (k - 1);
}

static int64_t no_flat_triangles(int64_t k, int64_t unused)
{
    (void)unused;
    return 12 * k * k + 24 * k * (k - 2);
}

#define CLOSED_GRID_HINT                                                                           \
    "That is with 2k^2 triangles: there are only k - 1 rows of cells between k parallels.",        \
        "Eso es con 2k^2 triángulos: entre k paralelos solo hay k - 1 filas de celdas."
#define SHARED_POLES_HINT                                                                          \
    "That is with one vertex at each pole; here each pole belongs to all k meridians.",            \
        "Eso es con un vértice en cada polo; aquí cada polo pertenece a los k meridianos."
#define REPLICATED_SEAM_HINT                                                                       \
    "That is with k - 1 cells around; here the last meridian is joined to the first, k cells.",    \
        "Eso es con k - 1 celdas alrededor; aquí el último meridiano se une al primero: k celdas."
#define NO_FLAT_HINT                                                                               \
    "That is without the triangles at the poles that have no area; here they stay.",               \
        "Eso es sin los triángulos de los polos que no tienen área; aquí se quedan."

static const struct formula_mistake voxel_mistakes[] = {
    {"byte-a-cell", byte_a_cell, "A cell takes a bit, not a byte.",
     "Una celda ocupa un bit, no un byte."},
    {"rounded-down", rounded_down, "The last byte counts even when it is not full.",
     "El último byte cuenta aunque no esté lleno."},
    {"padded-slices", padded_slices, "Only the last byte of all may be partly used.",
     "Solo el último byte de todos puede quedar a medias."},
    {0}};
static const struct formula_mistake mesh_mistakes[] = {
    {"closed-grid", closed_grid, CLOSED_GRID_HINT},
    {"shared-poles", shared_poles, SHARED_POLES_HINT},
    {"replicated-seam", replicated_seam, REPLICATED_SEAM_HINT},
    {"no-flat-triangles", no_flat_triangles, NO_FLAT_HINT},
    {0}};
static const struct formula voxel_formula = {"voxel_sphere_bytes", {"k", NULL},   "bytes", "bytes",
                                             right_voxel_bytes,    voxel_mistakes};
static const struct formula mesh_formula = {"mesh_sphere_bytes", {"k", NULL},  "bytes", "bytes",
                                            right_mesh_bytes,    mesh_mistakes};

/* Pairs of k and 0. */
static const int32_t few_rows[] = {3, 0, 4, 0, 16, 0};
static const int32_t many_rows[] = {
    3,    0, 4,    0, 5,     0, 6,     0, 7,      0, 8,      0, 9,       0, 10,      0,
    11,   0, 15,   0, 17,    0, 31,    0, 32,     0, 33,     0, 64,      0, 99,      0,
    100,  0, 128,  0, 256,   0, 287,   0, 288,    0, 512,    0, 777,     0, 1024,    0,
    2048, 0, 7777, 0, 10000, 0, 10923, 0, 100000, 0, 299999, 0, 1000000, 0, 2000000, 0};
struct rows {
    const int32_t *pairs;
    int64_t count;
};
static const struct rows row_sets[] = {{few_rows, sizeof few_rows / 8},
                                       {many_rows, sizeof many_rows / 8}};

/* ------------------------------------------------------------------ numbers */

static const struct number_mistake voxel_kilobyte_mistakes[] = {
    {"kilobyte-of-1000", 0.512, "1 KB is 1024 bytes.", "1 KB son 1024 bytes."},
    {"byte-a-cell", 4, "A cell takes a bit, not a byte.", "Una celda ocupa un bit, no un byte."},
    {"bytes", 512, "That is in bytes, not in KB.", "Eso está en bytes, no en KB."},
    {0}};
static const struct number_mistake mesh_kilobyte_mistakes[] = {
    {"closed-grid", 9, CLOSED_GRID_HINT},
    {"shared-poles", 8088.0 / 1024, SHARED_POLES_HINT},
    {"replicated-seam", 8472.0 / 1024, REPLICATED_SEAM_HINT},
    {"no-flat-triangles", 8448.0 / 1024, NO_FLAT_HINT},
    {"kilobyte-of-1000", 8.832, "1 KB is 1024 bytes.", "1 KB son 1024 bytes."},
    {"bytes", 8832, "That is in bytes, not in KB.", "Eso está en bytes, no en KB."},
    {0}};
static const struct number_mistake voxel_megabyte_mistakes[] = {
    {"megabyte-of-1000000", 134.217728, "1 MB is 1024 KB.", "1 MB son 1024 KB."},
    {"byte-a-cell", 1024, "A cell takes a bit, not a byte.", "Una celda ocupa un bit, no un byte."},
    {0}};
static const struct number_mistake mesh_megabyte_mistakes[] = {
    {"closed-grid", 36, CLOSED_GRID_HINT},
    {"shared-poles", 37675032.0 / 1048576, SHARED_POLES_HINT},
    {"replicated-seam", 37699608.0 / 1048576, REPLICATED_SEAM_HINT},
    {"megabyte-of-1000000", 37.72416, "1 MB is 1024 KB.", "1 MB son 1024 KB."},
    {0}};
static const struct number_mistake crossover_mistakes[] = {
    {"byte-a-cell", 36, "That is where it would be if a cell took a byte.",
     "Ahí estaría si una celda ocupara un byte."},
    {"one-too-few", 287, "With k = 287 the voxels are still smaller: compare whole bytes.",
     "Con k = 287 los vóxeles aún ocupan menos: compara bytes enteros."},
    {"one-too-many", 289, "With a k one smaller the mesh is smaller already.",
     "Con un k una unidad menor la malla ya ocupa menos."},
    {0}};

#define SIZE_RULE(unit, k)                                                                         \
    "It is not the size in " unit " for k = " k ".", "No es el tamaño en " unit " con k = " k "."

static const struct number numbers[] = {
    [ASK_VOXEL_KILOBYTES] = {"voxel_sphere_kilobytes", 0.5, TWO_DECIMALS, SIZE_RULE("KB", "16"),
                             voxel_kilobyte_mistakes},
    [ASK_MESH_KILOBYTES] = {"mesh_sphere_kilobytes", 8.625, TWO_DECIMALS, SIZE_RULE("KB", "16"),
                            mesh_kilobyte_mistakes},
    [ASK_VOXEL_MEGABYTES] = {"voxel_sphere_megabytes", 128, TWO_DECIMALS, SIZE_RULE("MB", "1024"),
                             voxel_megabyte_mistakes},
    [ASK_MESH_MEGABYTES] = {"mesh_sphere_megabytes", 37724160.0 / 1048576, TWO_DECIMALS,
                            SIZE_RULE("MB", "1024"), mesh_megabyte_mistakes},
    [ASK_CROSSOVER] = {"smallest_k_for_mesh", 288, 0,
                       "It is not the smallest k with which the mesh takes fewer bytes.",
                       "No es el menor k con el que la malla ocupa menos bytes.",
                       crossover_mistakes}};

/* -------------------------------------------------------------------- cases */

/* parameter: question, then k and aspect, or the set of rows */
static const struct judge_case cases[] = {
    {"voxels-4", "voxels", 1, {ASK_VOXEL_BUILD, 4, LOOK_AT_VOXELS, 0}, true, true},
    {"voxels-2", "voxels", 2, {ASK_VOXEL_BUILD, 2, LOOK_AT_VOXELS, 0}, false, false},
    {"voxels-16", "voxels", 3, {ASK_VOXEL_BUILD, 16, LOOK_AT_VOXELS, 0}, true, false},
    {"voxels-30", "voxels", 4, {ASK_VOXEL_BUILD, 30, LOOK_AT_VOXELS, 0}, false, false},
    {"voxels-32", "voxels", 5, {ASK_VOXEL_BUILD, 32, LOOK_AT_VOXELS, 0}, false, false},
    {"voxels-3", "voxels-odd", 6, {ASK_VOXEL_BUILD, 3, LOOK_AT_VOXELS, 0}, true, true},
    {"voxels-1", "voxels-odd", 7, {ASK_VOXEL_BUILD, 1, LOOK_AT_VOXELS, 0}, false, false},
    {"voxels-17", "voxels-odd", 8, {ASK_VOXEL_BUILD, 17, LOOK_AT_VOXELS, 0}, false, false},
    {"voxels-33", "voxels-odd", 9, {ASK_VOXEL_BUILD, 33, LOOK_AT_VOXELS, 0}, false, false},
    {"vertices-6", "mesh-vertices", 10, {ASK_MESH_BUILD, 6, LOOK_AT_VERTICES, 0}, true, true},
    {"vertices-3", "mesh-vertices", 11, {ASK_MESH_BUILD, 3, LOOK_AT_VERTICES, 0}, false, false},
    {"vertices-16", "mesh-vertices", 12, {ASK_MESH_BUILD, 16, LOOK_AT_VERTICES, 0}, false, false},
    {"vertices-48", "mesh-vertices", 13, {ASK_MESH_BUILD, 48, LOOK_AT_VERTICES, 0}, false, false},
    {"triangles-6", "mesh-triangles", 14, {ASK_MESH_BUILD, 6, LOOK_AT_TRIANGLES, 0}, true, true},
    {"triangles-3", "mesh-triangles", 15, {ASK_MESH_BUILD, 3, LOOK_AT_TRIANGLES, 0}, false, false},
    {"triangles-16",
     "mesh-triangles",
     16,
     {ASK_MESH_BUILD, 16, LOOK_AT_TRIANGLES, 0},
     false,
     false},
    {"triangles-48",
     "mesh-triangles",
     17,
     {ASK_MESH_BUILD, 48, LOOK_AT_TRIANGLES, 0},
     false,
     false},
    {"voxel-memory-16",
     "measured-memory",
     18,
     {ASK_VOXEL_BUILD, 16, LOOK_AT_MEMORY, 0},
     true,
     true},
    {"mesh-memory-16", "measured-memory", 19, {ASK_MESH_BUILD, 16, LOOK_AT_MEMORY, 0}, true, true},
    {"voxel-memory-36",
     "measured-memory",
     20,
     {ASK_VOXEL_BUILD, 36, LOOK_AT_MEMORY, 0},
     false,
     false},
    {"mesh-memory-50",
     "measured-memory",
     21,
     {ASK_MESH_BUILD, 50, LOOK_AT_MEMORY, 0},
     false,
     false},
    {"voxel-bytes-of-few", "voxel-formula", 22, {ASK_VOXEL_BYTES, 0, 0, 0}, true, true},
    {"voxel-bytes-of-many", "voxel-formula", 23, {ASK_VOXEL_BYTES, 1, 0, 0}, false, true},
    {"mesh-bytes-of-few", "mesh-formula", 24, {ASK_MESH_BYTES, 0, 0, 0}, true, true},
    {"mesh-bytes-of-many", "mesh-formula", 25, {ASK_MESH_BYTES, 1, 0, 0}, false, true},
    {"voxel-kilobytes-of-16", "sizes", 26, {ASK_VOXEL_KILOBYTES, 0, 0, 0}, true, true},
    {"mesh-kilobytes-of-16", "sizes", 27, {ASK_MESH_KILOBYTES, 0, 0, 0}, true, true},
    {"voxel-megabytes-of-1024", "sizes", 28, {ASK_VOXEL_MEGABYTES, 0, 0, 0}, true, true},
    {"mesh-megabytes-of-1024", "sizes", 29, {ASK_MESH_MEGABYTES, 0, 0, 0}, true, true},
    {"smallest-k", "crossover", 30, {ASK_CROSSOVER, 0, 0, 0}, true, true}};

static bool asks_rows(int64_t question)
{
    return question == ASK_VOXEL_BYTES || question == ASK_MESH_BYTES;
}

static void write_build(struct writer *input, int64_t question, int64_t k, int64_t aspect)
{
    write_int(input, question);
    write_int(input, k);
    write_int(input, aspect);
}

static int make(const struct judge_case *c, const char *models, struct writer *input,
                struct error *err)
{
    (void)models;
    if (asks_rows(c->parameter[0])) {
        const struct rows *rows = &row_sets[c->parameter[1]];
        write_int(input, c->parameter[0]);
        write_int(input, rows->count);
        write_array(input, rows->pairs, rows->count, 2 * sizeof *rows->pairs);
    } else {
        write_build(input, c->parameter[0], c->parameter[1], c->parameter[2]);
    }
    return input->failed ? error_set(err, "out of memory for case %s", c->name) : 0;
}

static const char *const families[] = {"voxels", "mesh", NULL};

/* About `size` cells or vertices: k is whole. There is one sphere for a k: the seed changes
 * nothing. */
static int make_sized(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err)
{
    (void)seed;
    double k = round(family == 0 ? cbrt((double)size) : sqrt((double)size));
    if (!(k >= 3 && k <= 4096))
        return error_set(err, "no sphere of %" PRId64 " cells or vertices is made", size);
    if (family == 0)
        write_build(input, ASK_VOXEL_BUILD, (int64_t)k, LOOK_AT_VOXELS);
    else
        write_build(input, ASK_MESH_BUILD, (int64_t)k, SHAPE);
    return input->failed ? error_set(err, "out of memory for size %" PRId64, size) : 0;
}

static void reject_malformed(struct judgement *out)
{
    judge_reject(out, "malformed-answer", "The answer is incomplete.",
                 "La respuesta está incompleta.");
}

/* Reads the status. Returns whether the builder says that it built something. */
static bool read_status(struct reader *answer, struct judgement *out)
{
    int64_t status = read_int(answer);
    if (answer->failed)
        reject_malformed(out);
    else if (status != 0)
        judge_reject(out, "unknown-status", "The builder returned %" PRId64 ", not 0.",
                     "El constructor ha devuelto %" PRId64 ", no 0.", status);
    return !out->cause[0];
}

/* ------------------------------------------------------------------- voxels */

static bool bit_at(const uint8_t *bits, int64_t number)
{
    return bits[number / 8] >> number % 8 & 1;
}

/* Whether a cell belongs to the sphere whose squared radius, scaled by 2k, is radius_squared. */
static bool cell_in_sphere(int32_t k, int64_t number, int64_t offset, int64_t radius_squared)
{
    int64_t x = 2 * (number % k) + offset - k;
    int64_t y = 2 * (number / k % k) + offset - k;
    int64_t z = 2 * (number / k / k) + offset - k;
    return x * x + y * y + z * z <= radius_squared;
}

/* How a wrong bitmap may have come about: all its bits agree with one of these. */
struct bitmap_mistake {
    const char *cause;
    int64_t offset;        /* 1: centres of cells, 0: their lower corners */
    int64_t radius_factor; /* of k * k */
    int flip;              /* number ^ flip is the bit: 7 is the highest bit first */
    const char *hint, *hint_es;
};
static const struct bitmap_mistake bitmap_mistakes[] = {
    {"corner-not-centre", 0, 1, 0, "The corner of each cell was tested, not its centre.",
     "Se ha comprobado la esquina de cada celda, no su centro."},
    {"radius-times-two", 1, 4, 0,
     "The squared distance was compared with r * 2, not with r squared.",
     "El cuadrado de la distancia se ha comparado con r * 2, no con r al cuadrado."},
    {"highest-bit-first", 1, 1, 7, "Bit 0 of a byte is its lowest bit, not its highest.",
     "El bit 0 de un byte es el más bajo, no el más alto."}};

static const struct bitmap_mistake *find_bitmap_mistake(int32_t k, const uint8_t *bits)
{
    int64_t cell_count = (int64_t)k * k * k;
    for (size_t m = 0; m < sizeof bitmap_mistakes / sizeof *bitmap_mistakes; m++) {
        const struct bitmap_mistake *mistake = &bitmap_mistakes[m];
        int64_t number = 0;
        while (number < cell_count && bit_at(bits, number ^ mistake->flip) ==
                                          cell_in_sphere(k, number, mistake->offset,
                                                         mistake->radius_factor * (int64_t)k * k))
            number++;
        if (number == cell_count)
            return mistake;
    }
    return NULL;
}

/* Says which bits of the cells are wrong, and which one is named. */
static int show_wrong_cells(int32_t k, const uint8_t *bits, int64_t named, struct scene *scene,
                            struct error *err)
{
    int64_t cell_count = (int64_t)k * k * k;
    uint8_t *wrong = calloc((size_t)(cell_count / 8 + 1), 1);
    if (!wrong)
        return error_set(err, "out of memory for %" PRId64 " cells", cell_count);
    for (int64_t i = 0; i < cell_count; i++)
        if (bit_at(bits, i) != cell_in_sphere(k, i, 1, (int64_t)k * k))
            wrong[i / 8] = (uint8_t)(wrong[i / 8] | 1U << i % 8);
    int failed = scene_set_wrong_voxels(scene, wrong, named, err);
    free(wrong);
    return failed;
}

/* The voxels as they are, with the named cell and all that are wrong, and beside them the mesh as
 * it should be. named: the number of a cell, -1: none. */
static int show_voxels(int32_t k, const uint8_t *bits, int64_t named, struct scene *scene,
                       struct error *err)
{
    struct mesh mesh = {0};
    if (k > SHOWN_VOXELS_PER_SIDE)
        return 0;
    if (k >= 3) {
        if (sphere_make(&mesh, k, err))
            return -1;
        int failed = scene_set_mesh(scene, mesh.positions, mesh.vertex_count, mesh.triangles,
                                    mesh.triangle_count, err);
        mesh_release(&mesh);
        if (failed)
            return -1;
    }
    if (scene_set_voxels(scene, bits, k, err))
        return -1;
    return show_wrong_cells(k, bits, named, scene, err);
}

static int judge_bits(int32_t k, const uint8_t *bits, struct judgement *out, struct error *err)
{
    int64_t cell_count = (int64_t)k * k * k, bit_count = (cell_count + 7) / 8 * 8, number = 0;
    while (number < cell_count &&
           bit_at(bits, number) == cell_in_sphere(k, number, 1, (int64_t)k * k))
        number++;
    if (number < cell_count) {
        const struct bitmap_mistake *mistake = find_bitmap_mistake(k, bits);
        int x = (int)(number % k), y = (int)(number / k % k), z = (int)(number / k / k);
        bool set = bit_at(bits, number);
        judge_name_element(out, "cell (%d, %d, %d)", x, y, z);
        judge_reject(
            out,
            mistake ? mistake->cause
            : set   ? "cell-outside"
                    : "cell-inside",
            "Cell (%d, %d, %d), bit %" PRId64
            ", is %d, but its centre is %s%.0s the sphere.%s%s%.0s",
            "La celda (%d, %d, %d), bit %" PRId64 ", vale %d, pero su centro está %.0s%s de la"
            " esfera.%s%.0s%s",
            x, y, z, number, set, set ? "outside" : "inside", set ? "fuera" : "dentro",
            mistake ? " " : "", mistake ? mistake->hint : "", mistake ? mistake->hint_es : "");
        return show_voxels(k, bits, number, &out->scene, err);
    }
    for (; number < bit_count; number++) {
        if (!bit_at(bits, number))
            continue;
        judge_name_element(out, "bit %" PRId64, number);
        judge_reject(out, "unused-bits", "Bit %" PRId64 " belongs to no cell and must be 0.",
                     "El bit %" PRId64 " no es de ninguna celda y tiene que ser 0.", number);
        return show_voxels(k, bits, -1, &out->scene, err);
    }
    judge_accept(out);
    return 0;
}

static int judge_voxels(int32_t k, int64_t aspect, struct reader *answer, const struct usage *usage,
                        struct judgement *out, struct error *err)
{
    int64_t byte_count, right_count = right_voxel_bytes(k, 0);
    if (!read_status(answer, out))
        return 0;
    const uint8_t *bits = read_table(answer, &byte_count, 1);
    int64_t own_bytes = read_int(answer);
    if (answer->failed) {
        reject_malformed(out);
    } else if (byte_count != right_count) {
        judge_reject(
            out, "byte-count",
            "byte_count is %" PRId64 "; %" PRId64 " cells of a bit each take %" PRId64 " bytes.",
            "byte_count es %" PRId64 "; %" PRId64 " celdas de un bit ocupan %" PRId64 " bytes.",
            byte_count, (int64_t)k * k * k, right_count);
    } else if (!bits) {
        judge_reject(out, "table-missing", "bits is NULL.", "bits es NULL.");
    } else if (aspect & LOOK_AT_MEMORY) {
        struct size_claim claim = {"voxel_sphere_build", "voxel_sphere_bytes", 0, own_bytes,
                                   right_count};
        size_judge(&claim, usage, out);
    } else {
        return judge_bits(k, bits, out, err);
    }
    return 0;
}

/* --------------------------------------------------------------------- mesh */

/* Names what a wrong number of vertices or triangles would be right for. */
static void reject_count(const char *field, int64_t count, int64_t right, const char *cause,
                         const char *hint, const char *hint_es, struct judgement *out)
{
    judge_reject(out, cause, "%s is %" PRId64 "; it must be %" PRId64 ".%s%s%.0s",
                 "%s es %" PRId64 "; tiene que ser %" PRId64 ".%s%.0s%s", field, count, right,
                 hint[0] ? " " : "", hint, hint_es);
}

static void reject_vertex_count(int64_t k, int64_t count, struct judgement *out)
{
    if (count == k * (k - 2) + 2)
        reject_count("vertex_count", count, k * k, "shared-poles", SHARED_POLES_HINT, out);
    else if (count == k * (k + 1) || count == (k + 1) * (k + 1))
        reject_count("vertex_count", count, k * k, "meridian-stored-twice",
                     "The last meridian is not a copy of the first: there are k in all.",
                     "El último meridiano no es una copia del primero: hay k en total.", out);
    else
        reject_count("vertex_count", count, k * k, "vertex-count", "", "", out);
}

static void reject_triangle_count(int64_t k, int64_t count, struct judgement *out)
{
    int64_t right = 2 * k * (k - 1);
    if (count == 2 * k * k)
        reject_count("triangle_count", count, right, "closed-grid", CLOSED_GRID_HINT, out);
    else if (count == 2 * (k - 1) * (k - 1))
        reject_count("triangle_count", count, right, "replicated-seam", REPLICATED_SEAM_HINT, out);
    else if (count == 2 * k * (k - 2))
        reject_count("triangle_count", count, right, "no-flat-triangles", NO_FLAT_HINT, out);
    else
        reject_count("triangle_count", count, right, "triangle-count", "", "", out);
}

static int judge_shape(const struct sphere_mesh *mesh, int64_t aspect, struct judgement *out,
                       struct error *err)
{
    if ((aspect & LOOK_AT_VERTICES) && sphere_judge_vertices(mesh, out, err))
        return -1;
    if (!(aspect & LOOK_AT_TRIANGLES) || out->cause[0])
        return 0;
    if (mesh->triangle_count == 2 * (int64_t)mesh->k * (mesh->k - 1))
        return sphere_judge_triangles(mesh, out, err);
    reject_triangle_count(mesh->k, mesh->triangle_count, out);
    return show_mesh(&out->scene, mesh->vertices, (int64_t)mesh->k * mesh->k, mesh->triangles,
                     mesh->triangle_count, err);
}

static int judge_mesh(int32_t k, int64_t aspect, struct reader *answer, const struct usage *usage,
                      struct judgement *out, struct error *err)
{
    struct sphere_mesh mesh = {.k = k};
    int64_t vertex_count;
    if (!read_status(answer, out))
        return 0;
    mesh.vertices = read_table(answer, &vertex_count, 3 * sizeof *mesh.vertices);
    mesh.triangles = read_table(answer, &mesh.triangle_count, 3 * sizeof *mesh.triangles);
    int64_t own_bytes = read_int(answer);
    int64_t triangle_count = 2 * (int64_t)k * (k - 1);
    if (answer->failed) {
        reject_malformed(out);
    } else if (vertex_count != (int64_t)k * k) {
        reject_vertex_count(k, vertex_count, out);
        if (mesh.vertices && vertex_count > 0)
            return show_mesh(&out->scene, mesh.vertices, vertex_count, mesh.triangles,
                             mesh.triangles ? mesh.triangle_count : 0, err);
    } else if (!mesh.vertices || (!mesh.triangles && mesh.triangle_count == triangle_count)) {
        judge_reject(out, "table-missing", "A table is NULL.", "Una tabla es NULL.");
    } else if (!mesh.triangles) {
        reject_triangle_count(k, mesh.triangle_count, out);
    } else if (aspect & LOOK_AT_MEMORY) {
        struct size_claim claim = {"mesh_sphere_build", "mesh_sphere_bytes", 0, own_bytes,
                                   right_mesh_bytes(k, 0)};
        size_judge(&claim, usage, out);
    } else {
        return judge_shape(&mesh, aspect, out, err);
    }
    return 0;
}

/* -------------------------------------------------------------------- judge */

static int judge_rows(const struct formula *formula, struct reader *input, struct reader *answer,
                      struct judgement *out, struct error *err)
{
    int64_t row_count = read_int(input);
    const int32_t *rows = read_array(input, row_count, 2 * sizeof *rows);
    const int64_t *answers = read_array(answer, row_count, sizeof *answers);
    if (!rows)
        return error_set(err, "the input of memory-voxels-vs-mesh is broken");
    if (answers)
        return formula_judge(formula, rows, row_count, answers, out, err);
    reject_malformed(out);
    return 0;
}

static int judge(struct span input, struct span answer, const struct usage *usage,
                 struct judgement *out, struct error *err)
{
    struct reader in = reader_of(input.bytes, input.count);
    struct reader said = reader_of(answer.bytes, answer.count);
    int64_t question = read_int(&in);
    if (asks_rows(question))
        return judge_rows(question == ASK_VOXEL_BYTES ? &voxel_formula : &mesh_formula, &in, &said,
                          out, err);
    int32_t k = (int32_t)read_int(&in);
    int64_t aspect = read_int(&in);
    if (question == ASK_VOXEL_BUILD)
        return judge_voxels(k, aspect, &said, usage, out, err);
    if (question == ASK_MESH_BUILD)
        return judge_mesh(k, aspect, &said, usage, out, err);
    double value = read_real(&said);
    number_judge(&numbers[question], said.failed ? (double)NAN : value, out);
    return 0;
}

static size_t answer_bound(struct span input)
{
    struct reader in = reader_of(input.bytes, input.count);
    int64_t question = read_int(&in);
    int64_t k = read_int(&in);
    if (asks_rows(question))
        return sizeof(int64_t) * (size_t)k; /* that is the count of rows */
    if (question == ASK_VOXEL_BUILD)
        return (size_t)right_voxel_bytes(k, 0) + 64;
    return question == ASK_MESH_BUILD ? (size_t)closed_grid(k + 1, 0) + 64 : sizeof(double);
}

const struct judge judge_memory_voxels_vs_mesh = {.exercise = "memory-voxels-vs-mesh",
                                                  .cases = cases,
                                                  .case_count = sizeof cases / sizeof *cases,
                                                  .make = make,
                                                  .families = families,
                                                  .make_sized = make_sized,
                                                  .judge = judge,
                                                  .answer_bound = answer_bound};
