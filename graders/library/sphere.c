/* The sphere of problem 4.1 as a mesh; see sphere.h.
 *
 * Parallels are numbered 0 (north pole) ... k - 1 (south pole); those between are rings. A cell
 * (i, j) lies between parallels i and i + 1 and meridians j and j + 1. */
#include "graders/library/sphere.h"

#include "graders/library/cells.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;
static const double PLACE_TOLERANCE = 1e-5;

static const struct phrase vertex_noun = {"vertex", "vértice"};
static const struct cause off_sphere = {"vertex-off-sphere",
                                        {"vertex off the sphere", "vértice fuera de la esfera"}};
static const struct cause off_grid = {"vertex-off-grid",
                                      {"vertex off the grid", "vértice fuera de la rejilla"}};
static const struct cause pole_crowded = {"pole-crowded",
                                          {"crowded pole", "polo con vértices de más"}};
static const struct cause repeated = {"vertex-repeated", {"repeated vertex", "vértice repetido"}};
static const struct cause seam_open = {"seam-open", {"open seam", "costura abierta"}};
static const struct cause uncovered = {"cell-uncovered", {"uncovered cell", "celda sin cubrir"}};
static const struct cause pole_open = {"pole-not-closed", {"pole not closed", "polo sin cerrar"}};

/* Where a vertex stands. */
struct place {
    int32_t parallel; /* -1: nowhere (it is not finite, or one too many at a pole) */
    int32_t column;   /* on a ring: the meridian; at a pole: the how-manieth vertex there, 0 ... */
};

static bool is_polar(int32_t k, struct place place)
{
    return place.parallel == 0 || place.parallel == k - 1;
}

/* ------------------------------------------------------------------------------------- vertices */

static struct place nearest_place(int32_t k, const float *p)
{
    double x = (double)p[0], y = (double)p[1], z = (double)p[2];
    if (!isfinite(x) || !isfinite(y) || !isfinite(z))
        return (struct place){-1, 0};
    double from_pole = atan2(hypot(x, y), z);
    double around = atan2(y, x);
    int32_t parallel = (int32_t)lround(from_pole * (k - 1) / PI);
    int32_t column = (int32_t)((lround(around * k / (2 * PI)) + k) % k);
    return (struct place){parallel, parallel == 0 || parallel == k - 1 ? 0 : column};
}

static bool is_at(int32_t k, struct place place, const float *p)
{
    if (place.parallel < 0)
        return false;
    double from_pole = PI * place.parallel / (k - 1);
    double around = 2 * PI * place.column / k;
    double radius = 0.5 * sin(from_pole);
    return fabs((double)p[0] - radius * cos(around)) <= PLACE_TOLERANCE &&
           fabs((double)p[1] - radius * sin(around)) <= PLACE_TOLERANCE &&
           fabs((double)p[2] - 0.5 * cos(from_pole)) <= PLACE_TOLERANCE;
}

static void reject_place(int32_t k, const float *p, int32_t v, struct judgement *out)
{
    double x = (double)p[0], y = (double)p[1], z = (double)p[2];
    double radius = sqrt(x * x + y * y + z * z);
    judge_name_one(out, vertex_noun, "%d (%.6g, %.6g, %.6g)", v, x, y, z);
    if (!(fabs(radius - 0.5) <= PLACE_TOLERANCE))
        judge_reject(
            out, &off_sphere,
            "Vertex %d at (%.6g, %.6g, %.6g) is %.6g away from the centre; the radius is 0.5.",
            "El vértice %d, en (%.6g, %.6g, %.6g), dista %.6g del centro; el radio es 0.5.", v, x,
            y, z, radius);
    else
        judge_reject(out, &off_grid,
                     "Vertex %d at (%.6g, %.6g, %.6g) is on the sphere but not on a meridian "
                     "2 pi j / %d and a parallel pi i / %d.",
                     "El vértice %d, en (%.6g, %.6g, %.6g), está en la esfera pero no en un "
                     "meridiano 2 pi j / %d y un paralelo pi i / %d.",
                     v, x, y, z, k, k - 1);
}

static void reject_repeated(int32_t k, bool polar, int32_t v, int32_t earlier,
                            struct judgement *out)
{
    judge_name_one(out, vertex_noun, "%d", v);
    if (polar)
        judge_reject(out, &pole_crowded, "Vertex %d is one more than %d at this pole.",
                     "El vértice %d es uno más de los %d de este polo.", v, k);
    else
        judge_reject(
            out, &repeated, "Vertices %d and %d are at the same place: is a meridian stored twice?",
            "Los vértices %d y %d están en el mismo lugar: ¿se guarda dos veces un meridiano?",
            earlier, v);
}

/* Gives a vertex its place, unless another has it. at_pole counts the vertices of each pole. */
static void place_vertex(int32_t k, const struct built_mesh *mesh, int32_t v, int32_t *vertex_at,
                         int32_t at_pole[2], struct judgement *out)
{
    const float *p = mesh->vertices + 3 * (int64_t)v;
    struct place place = nearest_place(k, p);
    if (!is_at(k, place, p)) {
        if (!out->cause[0])
            reject_place(k, p, v, out);
        scene_mark_vertex(&out->scene, MARK_WRONG, v);
        return;
    }
    bool polar = is_polar(k, place);
    if (polar)
        place.column = at_pole[place.parallel != 0]++;
    int32_t *holder = place.column < k ? &vertex_at[place.parallel * k + place.column] : NULL;
    if (!holder || *holder >= 0) {
        if (!out->cause[0])
            reject_repeated(k, polar, v, holder ? *holder : -1, out);
        scene_mark_vertex(&out->scene, MARK_DUPLICATE, v);
        return;
    }
    *holder = v;
    out->scene.ok_count++;
}

int sphere_judge_vertices(int32_t k, const struct built_mesh *mesh, struct judgement *out,
                          struct error *err)
{
    int32_t vertex_count = k * k, at_pole[2] = {0, 0};
    int32_t *vertex_at = malloc(sizeof *vertex_at * (size_t)vertex_count);
    if (!vertex_at)
        return error_set(err, "out of memory for %d vertices", vertex_count);
    memset(vertex_at, 0xFF, sizeof *vertex_at * (size_t)vertex_count);
    for (int32_t v = 0; v < vertex_count; v++)
        place_vertex(k, mesh, v, vertex_at, at_pole, out);
    free(vertex_at);
    if (out->cause[0])
        return built_mesh_show(mesh, &out->scene, err);
    out->scene.ok_count = 0; /* triangles are counted next */
    return 0;
}

/* ------------------------------------------------------------------------------------ triangles */

/* What the triangles seen so far cover. */
struct cover {
    int32_t k;
    struct place *place;   /* of every vertex */
    uint8_t *halves;       /* [i * k + j] of the cells between rings (cells.h) */
    uint8_t *caps;         /* [pole * k + j]: the triangle with area of a cell at a pole */
    uint8_t *spokes;       /* [pole][column][j]: triangles at the edge from a pole's vertex to ring
                              place j; 3 stands for more than two */
    int64_t flat_count[2]; /* triangles without area at each pole */
};

static void cover_release(struct cover *cover)
{
    free(cover->place);
    free(cover->halves);
    free(cover->caps);
    free(cover->spokes);
}

static int cover_init(struct cover *cover, int32_t side, const struct built_mesh *mesh,
                      struct error *err)
{
    size_t k = (size_t)side;
    int32_t at_pole[2] = {0, 0};
    *cover = (struct cover){.k = side};
    cover->place = calloc(k * k, sizeof *cover->place);
    cover->halves = calloc(k * k, 1);
    cover->caps = calloc(2 * k, 1);
    cover->spokes = calloc(2 * k * k, 1);
    if (!cover->place || !cover->halves || !cover->caps || !cover->spokes) {
        cover_release(cover);
        return error_set(err, "out of memory for a sphere of %d meridians", side);
    }
    for (int32_t v = 0; v < side * side; v++) {
        struct place place = nearest_place(side, mesh->vertices + 3 * (int64_t)v);
        if (is_polar(side, place))
            place.column = at_pole[place.parallel != 0]++;
        if (place.column >= side)
            place.parallel = -1;
        cover->place[v] = place;
    }
    return 0;
}

/* Steps from meridian `from` to meridian `to`, eastwards, 0 ... k - 1. */
static int32_t steps_east(int32_t k, int32_t from, int32_t to)
{
    return (to - from + k) % k;
}

/* A triangle between two rings. Its western meridian is the one from which the others are no more
 * than a step away; seen from outside, counter-clockwise is from south to east. */
static enum cell_fit add_between_rings(struct cover *cover, const struct place corner[3])
{
    int32_t k = cover->k, north = k, west = -1, south[3], east[3];
    for (int i = 0; i < 3; i++) {
        bool is_west = true;
        for (int j = 0; j < 3; j++)
            is_west = is_west && steps_east(k, corner[i].column, corner[j].column) <= 1;
        west = is_west ? corner[i].column : west;
        north = corner[i].parallel < north ? corner[i].parallel : north;
    }
    if (west < 0)
        return CELL_OUTSIDE;
    for (int i = 0; i < 3; i++) {
        south[i] = corner[i].parallel - north;
        east[i] = steps_east(k, west, corner[i].column);
    }
    return cell_add(&cover->halves[(int64_t)north * k + west], south, east);
}

static void add_spoke(struct cover *cover, int pole, int32_t column, int32_t meridian)
{
    size_t k = (size_t)cover->k;
    uint8_t *spoke = &cover->spokes[((size_t)pole * k + (size_t)column) * k + (size_t)meridian];
    *spoke = (uint8_t)(*spoke < 3 ? *spoke + 1 : 3);
}

/* A triangle with one or two vertices at a pole; `corner` begins with a vertex at the pole that
 * follows one that is not (so it is the first of its run). */
static enum cell_fit add_at_pole(struct cover *cover, const struct place *corner)
{
    int32_t k = cover->k;
    int pole = corner[0].parallel != 0;
    int32_t ring = pole == 0 ? 1 : k - 2;
    if (corner[2].parallel != ring)
        return CELL_OUTSIDE;
    if (corner[1].parallel == corner[0].parallel) { /* no area */
        if (corner[1].column == corner[0].column || cover->flat_count[pole] == k)
            return corner[1].column == corner[0].column ? CELL_OUTSIDE : CELL_REPEATED;
        cover->flat_count[pole]++;
        add_spoke(cover, pole, corner[0].column, corner[2].column);
        add_spoke(cover, pole, corner[1].column, corner[2].column);
        return CELL_HALF;
    }
    bool east = steps_east(k, corner[1].column, corner[2].column) == 1;
    bool west = steps_east(k, corner[2].column, corner[1].column) == 1;
    if (corner[1].parallel != ring || (!east && !west))
        return CELL_OUTSIDE;
    uint8_t *cap = &cover->caps[pole * k + (east ? corner[1].column : corner[2].column)];
    if (*cap)
        return CELL_REPEATED;
    *cap = 1;
    add_spoke(cover, pole, corner[0].column, corner[1].column);
    add_spoke(cover, pole, corner[0].column, corner[2].column);
    return east == (pole == 0) ? CELL_HALF : CELL_HALF_FLIPPED;
}

static enum cell_fit add_triangle(void *cells, const int32_t triangle[3])
{
    struct cover *cover = cells;
    struct place corner[3];
    int polar_count = 0, first = 0;
    for (int i = 0; i < 3; i++) {
        corner[i] = cover->place[triangle[i]];
        if (corner[i].parallel < 0)
            return CELL_OUTSIDE;
        polar_count += is_polar(cover->k, corner[i]);
    }
    if (polar_count == 0)
        return add_between_rings(cover, corner);
    if (polar_count == 3)
        return CELL_OUTSIDE;
    /* the polar corner after one that is not */
    while (!is_polar(cover->k, corner[first]) || is_polar(cover->k, corner[(first + 2) % 3]))
        first++;
    const struct place turned[3] = {corner[first], corner[(first + 1) % 3],
                                    corner[(first + 2) % 3]};
    return add_at_pole(cover, turned);
}

/* Whether cell (i, j) lacks a triangle with area. */
static bool is_bare(const struct cover *cover, int32_t i, int32_t j)
{
    int32_t k = cover->k;
    if (i == 0 || i == k - 2)
        return !cover->caps[(i == 0 ? 0 : k) + j];
    return !cell_is_covered(cover->halves[(int64_t)i * k + j]);
}

static void judge_cells(const struct cover *cover, struct judgement *out)
{
    int32_t k = cover->k, first_i = -1, first_j = -1;
    bool only_seam = true;
    for (int32_t i = 0; i < k - 1; i++) {
        for (int32_t j = 0; j < k; j++) {
            if (!is_bare(cover, i, j))
                continue;
            only_seam = only_seam && j == k - 1;
            first_j = first_i < 0 ? j : first_j;
            first_i = first_i < 0 ? i : first_i;
        }
    }
    if (first_i < 0)
        return;
    judge_name(out, "cell of parallel %d, meridian %d", "celda del paralelo %d, meridiano %d",
               first_i, first_j);
    if (only_seam)
        judge_reject(
            out, &seam_open,
            "The seam is open: meridian %d is not joined to meridian 0 (first at parallel %d).",
            "La costura está abierta: el meridiano %d no se une al 0 (primero en el paralelo %d).",
            first_j, first_i);
    else
        judge_reject(
            out, &uncovered,
            "The cell between parallels %d and %d and meridians %d and %d is not covered.",
            "La celda entre los paralelos %d y %d y los meridianos %d y %d no está cubierta.",
            first_i, first_i + 1, first_j, (first_j + 1) % k);
}

/* Whether a pole's vertex has edges to the ring, and two triangles at each. */
static bool is_closed(const struct cover *cover, struct place place)
{
    int64_t k = cover->k, row = (place.parallel != 0) * k + place.column;
    bool used = false;
    for (int64_t j = 0; j < k; j++) {
        uint8_t spokes = cover->spokes[row * k + j];
        if (spokes != 0 && spokes != 2)
            return false;
        used = used || spokes == 2;
    }
    return used;
}

static void judge_poles(const struct cover *cover, struct judgement *out)
{
    int32_t k = cover->k, v = 0;
    while (v < k * k && (!is_polar(k, cover->place[v]) || is_closed(cover, cover->place[v])))
        v++;
    if (v == k * k)
        return;
    judge_name_one(out, vertex_noun, "%d", v);
    judge_reject(out, &pole_open,
                 "The triangles around vertex %d, at a pole, do not join: each of its edges to "
                 "the next parallel must have two.",
                 "Los triángulos alrededor del vértice %d, en un polo, no encajan: cada arista "
                 "suya al paralelo siguiente debe tener dos.",
                 v);
    scene_mark_vertex(&out->scene, MARK_WRONG, v);
}

int sphere_judge_triangles(int32_t k, const struct built_mesh *mesh, struct judgement *out,
                           struct error *err)
{
    struct cover cover;
    if (cover_init(&cover, k, mesh, err))
        return -1;
    const struct cell_cover surface = {
        .cells = &cover,
        .add = add_triangle,
        .seen_from = {"outside", "fuera"},
        .hint = {"A cell lies between neighbouring meridians and parallels.",
                 "Una celda está entre meridianos y paralelos vecinos."}};
    cells_judge(mesh, &surface, out);
    if (!out->cause[0])
        judge_cells(&cover, out);
    if (!out->cause[0])
        judge_poles(&cover, out);
    cover_release(&cover);
    return out->cause[0] ? built_mesh_show(mesh, &out->scene, err) : 0;
}

/* ------------------------------------------------------------------------------ as it should be */

int sphere_make(struct mesh *mesh, int32_t k, struct error *err)
{
    if (mesh_init(mesh, (int64_t)k * k, 2 * (int64_t)k * (k - 1), err))
        return -1;
    int32_t *corner = mesh->triangles;
    for (int32_t j = 0; j < k; j++) {
        int32_t here = j * k, next = (j + 1) % k * k;
        for (int32_t i = 0; i < k; i++) {
            float *p = mesh->positions + 3 * (int64_t)(here + i);
            double from_pole = PI * i / (k - 1), around = 2 * PI * j / k;
            p[0] = (float)(0.5 * sin(from_pole) * cos(around));
            p[1] = (float)(0.5 * sin(from_pole) * sin(around));
            p[2] = (float)(0.5 * cos(from_pole));
            if (i == 0)
                continue;
            const int32_t cell[6] = {here + i - 1, here + i, next + i,
                                     here + i - 1, next + i, next + i - 1};
            memcpy(corner, cell, sizeof cell);
            corner += 6;
        }
    }
    return 0;
}
