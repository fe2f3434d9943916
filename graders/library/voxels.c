/* The sphere as voxels; see voxels.h. */
#include "graders/library/voxels.h"

#include "graders/library/sphere.h"

#include <inttypes.h>
#include <stdlib.h>

enum { SHOWN_VOXELS_PER_SIDE = 128 };

static const struct cause cell_outside = {"cell-outside",
                                          {"cell outside is 1", "celda exterior a 1"}};
static const struct cause cell_inside = {"cell-inside", {"cell inside is 0", "celda interior a 0"}};
static const struct cause unused_bits = {"unused-bits", {"unused bits", "bits sobrantes"}};

static bool bit_at(const uint8_t *bits, int64_t number)
{
    return bits[number / 8] >> number % 8 & 1;
}

/* A way to fill the bits. All is scaled by 2k, so that it is exact. */
struct filling {
    int64_t offset;        /* 1: centres of cells, 0: their lower corners */
    int64_t radius_factor; /* of k * k, the squared radius */
    int flip;              /* number ^ flip is the bit: 7 is the highest bit first */
};
static const struct filling right = {1, 1, 0};

static bool is_set(int32_t k, int64_t number, const struct filling *filling)
{
    int64_t x = 2 * (number % k) + filling->offset - k;
    int64_t y = 2 * (number / k % k) + filling->offset - k;
    int64_t z = 2 * (number / k / k) + filling->offset - k;
    return x * x + y * y + z * z <= filling->radius_factor * k * k;
}

/* The first cell, from `number` on, that is not filled so; k^3 when all are. */
static int64_t first_other(int32_t k, const uint8_t *bits, const struct filling *filling)
{
    int64_t cell_count = (int64_t)k * k * k, number = 0;
    while (number < cell_count &&
           bit_at(bits, number ^ filling->flip) == is_set(k, number, filling))
        number++;
    return number;
}

/* How wrong bits may have come about: all agree with one of these. */
struct filling_mistake {
    struct cause cause;
    struct filling filling;
    struct phrase hint;
};

static const struct filling_mistake *find_mistake(int32_t k, const uint8_t *bits)
{
    static const struct filling_mistake mistakes[] = {
        {{"corner-not-centre", {"corner, not centre", "esquina en lugar de centro"}},
         {0, 1, 0},
         {"The corner of each cell was tested, not its centre.",
          "Se ha comprobado la esquina de cada celda, no su centro."}},
        {{"radius-times-two", {"radius times two", "radio por dos"}},
         {1, 4, 0},
         {"The squared distance was compared with r * 2, not with r squared.",
          "El cuadrado de la distancia se ha comparado con r * 2, no con r al cuadrado."}},
        {{"highest-bit-first", {"highest bit first", "primero el bit más alto"}},
         {1, 1, 7},
         {"Bit 0 of a byte is its lowest bit, not its highest.",
          "El bit 0 de un byte es el más bajo, no el más alto."}}};
    for (size_t m = 0; m < sizeof mistakes / sizeof *mistakes; m++)
        if (first_other(k, bits, &mistakes[m].filling) == (int64_t)k * k * k)
            return &mistakes[m];
    return NULL;
}

/* -------------------------------------------------------------------------------------- showing */

/* Says which bits of the cells are wrong, and which one is named. */
static int show_wrong_cells(int32_t k, const uint8_t *bits, int64_t named, struct scene *scene,
                            struct error *err)
{
    int64_t cell_count = (int64_t)k * k * k;
    uint8_t *wrong = calloc((size_t)(cell_count / 8 + 1), 1);
    if (!wrong)
        return error_set(err, "out of memory for %" PRId64 " cells", cell_count);
    for (int64_t i = 0; i < cell_count; i++)
        if (bit_at(bits, i) != is_set(k, i, &right))
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

/* -------------------------------------------------------------------------------------- judging */

static void reject_cell(int32_t k, const uint8_t *bits, int64_t number, struct judgement *out)
{
    const struct filling_mistake *mistake = find_mistake(k, bits);
    int x = (int)(number % k), y = (int)(number / k % k), z = (int)(number / k / k);
    bool set = bit_at(bits, number);
    judge_name(out, "cell (%d, %d, %d)", "celda (%d, %d, %d)", x, y, z);
    if (!judge_reject_for(out, mistake ? &mistake->cause : set ? &cell_outside : &cell_inside))
        return;
    judge_en(out, "Cell (%d, %d, %d), bit %" PRId64 ", is %d, but its centre is %s the sphere.", x,
             y, z, number, set, set ? "outside" : "inside");
    judge_es(out,
             "La celda (%d, %d, %d), bit %" PRId64 ", vale %d, pero su centro está %s de la "
             "esfera.",
             x, y, z, number, set, set ? "fuera" : "dentro");
    if (mistake)
        judge_hint(out, mistake->hint);
}

int voxels_judge(int32_t k, const uint8_t *bits, struct judgement *out, struct error *err)
{
    int64_t cell_count = (int64_t)k * k * k, bit_count = (cell_count + 7) / 8 * 8;
    int64_t number = first_other(k, bits, &right);
    if (number < cell_count) {
        reject_cell(k, bits, number, out);
        return show_voxels(k, bits, number, &out->scene, err);
    }
    while (number < bit_count && !bit_at(bits, number))
        number++;
    if (number == bit_count) {
        judge_accept(out);
        return 0;
    }
    judge_name(out, "bit %" PRId64, "bit %" PRId64, number);
    judge_reject(out, &unused_bits, "Bit %" PRId64 " belongs to no cell and must be 0.",
                 "El bit %" PRId64 " no es de ninguna celda y tiene que ser 0.", number);
    return show_voxels(k, bits, -1, &out->scene, err);
}
