/* The sphere of problem 4.1 as a mesh; see sphere.h.
 *
 * Parallels are numbered 0 (north pole) ... k - 1 (south pole); those between are rings. A cell
 * (i, j) lies between parallels i and i + 1 and meridians j and j + 1. */
#include "graders/library/sphere.h"

#include "graders/scene/show.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;
static const double PLACE_TOLERANCE = 1e-5;

/* Where a vertex stands. */
struct place {
    int32_t parallel; /* -1: nowhere (it is not finite) */
    int32_t column;   /* on a ring: the meridian; at a pole: the how-manieth vertex there, 0 ... */
};

/* ----------------------------------------------------------------- vertices */

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

static int show(const struct sphere_mesh *mesh, struct scene *scene, struct error *err)
{
    return show_mesh(scene, mesh->vertices, (int64_t)mesh->k * mesh->k, mesh->triangles,
                     mesh->triangle_count, err);
}

static void reject_place(const struct sphere_mesh *mesh, int32_t v, struct judgement *out)
{
    const float *p = mesh->vertices + 3 * (int64_t)v;
    double x = (double)p[0], y = (double)p[1], z = (double)p[2];
    double radius = sqrt(x * x + y * y + z * z);
    judge_name_element(out, "vertex %d (%.6g, %.6g, %.6g)", v, x, y, z);
    if (!(fabs(radius - 0.5) <= PLACE_TOLERANCE))
        judge_reject(
            out, "vertex-off-sphere",
            "Vertex %d at (%.6g, %.6g, %.6g) is %.6g away from the centre; the radius is 0.5.",
            "El vértice %d, en (%.6g, %.6g, %.6g), dista %.6g del centro; el radio es 0.5.", v, x,
            y, z, radius);
    else
        judge_reject(
            out, "vertex-off-grid",
            "Vertex %d at (%.6g, %.6g, %.6g) is on the sphere but not on a meridian 2 pi j / %d"
            " and a parallel pi i / %d.",
            "El vértice %d, en (%.6g, %.6g, %.6g), está en la esfera pero no en un meridiano"
            " 2 pi j / %d y un paralelo pi i / %d.",
            v, x, y, z, mesh->k, mesh->k - 1);
}

static void reject_repeated(const struct sphere_mesh *mesh, struct place place, int32_t v,
                            int32_t earlier, struct judgement *out)
{
    judge_name_element(out, "vertex %d", v);
    if (place.parallel == 0 || place.parallel == mesh->k - 1)
        judge_reject(out, "pole-crowded", "Vertex %d is one more than %d at this pole.",
                     "El vértice %d es uno más de los %d de este polo.", v, mesh->k);
    else
        judge_reject(
            out, "vertex-repeated",
            "Vertices %d and %d are at the same place: is a meridian stored twice?",
            "Los vértices %d y %d están en el mismo lugar: ¿se guarda dos veces un meridiano?",
            earlier, v);
    scene_mark_vertex(&out->scene, MARK_DUPLICATE, v);
}

int sphere_judge_vertices(const struct sphere_mesh *mesh, struct judgement *out, struct error *err)
{
    int32_t k = mesh->k, vertex_count = k * k;
    int32_t at_pole[2] = {0, 0};
    int32_t *vertex_at = malloc(sizeof *vertex_at * (size_t)vertex_count);
    if (!vertex_at)
        return error_set(err, "out of memory for %d vertices", vertex_count);
    memset(vertex_at, 0xFF, sizeof *vertex_at * (size_t)vertex_count);
    for (int32_t v = 0; v < vertex_count; v++) {
        struct place place = nearest_place(k, mesh->vertices + 3 * (int64_t)v);
        if (!is_at(k, place, mesh->vertices + 3 * (int64_t)v)) {
            if (!out->cause[0])
                reject_place(mesh, v, out);
            scene_mark_vertex(&out->scene, MARK_WRONG, v);
            continue;
        }
        bool polar = place.parallel == 0 || place.parallel == k - 1;
        if (polar)
            place.column = at_pole[place.parallel != 0]++;
        if (place.column >= k || vertex_at[place.parallel * k + place.column] >= 0) {
            int32_t earlier = polar ? 0 : vertex_at[place.parallel * k + place.column];
            if (!out->cause[0])
                reject_repeated(mesh, place, v, earlier, out);
            continue;
        }
        vertex_at[place.parallel * k + place.column] = v;
        out->scene.ok_count++;
    }
    free(vertex_at);
    if (out->cause[0])
        return show(mesh, &out->scene, err);
    judge_accept(out);
    return 0;
}

/* ---------------------------------------------------------------- triangles */

enum fit { FIT, FLIPPED, REPEATED, CROSSED, OUTSIDE };

/* What the triangles seen so far cover. */
struct cover {
    const struct sphere_mesh *mesh;
    struct place *place; /* of every vertex */
    uint8_t
        *halves;   /* [i * k + j] of the cells between rings: bit of the corner that is left out */
    uint8_t *caps; /* [pole * k + j]: the triangle with area of a cell at a pole */
    uint8_t
        *spokes; /* [pole][column][j]: triangles at the edge from a pole's vertex to ring place j */
    int64_t flat_count[2]; /* triangles without area at each pole */
};

static void cover_release(struct cover *cover)
{
    free(cover->place);
    free(cover->halves);
    free(cover->caps);
    free(cover->spokes);
}

static int cover_init(struct cover *cover, const struct sphere_mesh *mesh, struct error *err)
{
    size_t k = (size_t)mesh->k;
    int32_t at_pole[2] = {0, 0};
    *cover = (struct cover){.mesh = mesh};
    cover->place = calloc(k * k, sizeof *cover->place);
    cover->halves = calloc(k * k, 1);
    cover->caps = calloc(2 * k, 1);
    cover->spokes = calloc(2 * k * k, 1);
    if (!cover->place || !cover->halves || !cover->caps || !cover->spokes) {
        cover_release(cover);
        error_set(err, "out of memory for a sphere of %d meridians", mesh->k);
        return -1;
    }
    for (int32_t v = 0; v < mesh->k * mesh->k; v++) {
        struct place place = nearest_place(mesh->k, mesh->vertices + 3 * (int64_t)v);
        if (place.parallel == 0 || place.parallel == mesh->k - 1)
            place.column = at_pole[place.parallel != 0]++;
        if (place.column >= mesh->k)
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

/* A triangle between two rings. */
static enum fit add_between_rings(struct cover *cover, const struct place *corner)
{
    int32_t k = cover->mesh->k, north = k, west = -1;
    for (int i = 0; i < 3; i++)
        north = corner[i].parallel < north ? corner[i].parallel : north;
    for (int i = 0; i < 3; i++) {
        bool is_west = true;
        for (int j = 0; j < 3; j++)
            is_west = is_west && steps_east(k, corner[i].column, corner[j].column) <= 1;
        west = is_west ? corner[i].column : west;
    }
    if (west < 0)
        return OUTSIDE;
    int32_t down[3], along[3];
    unsigned corners = 0;
    for (int i = 0; i < 3; i++) {
        down[i] = corner[i].parallel - north;
        along[i] = steps_east(k, west, corner[i].column);
        if (down[i] > 1)
            return OUTSIDE;
        corners |= 1u << (2 * down[i] + along[i]);
    }
    unsigned missing = ~corners & 15u;
    if (missing == 0 || (missing & (missing - 1)) != 0)
        return OUTSIDE;
    uint8_t *halves = &cover->halves[(int64_t)north * k + west];
    if (*halves & missing)
        return REPEATED;
    if (*halves & (missing == 1u || missing == 8u ? 6u : 9u))
        return CROSSED;
    *halves |= (uint8_t)missing;
    int32_t turn =
        (down[1] - down[0]) * (along[2] - along[0]) - (down[2] - down[0]) * (along[1] - along[0]);
    return turn > 0 ? FIT : FLIPPED;
}

static void add_spoke(struct cover *cover, int pole, int32_t column, int32_t meridian)
{
    size_t k = (size_t)cover->mesh->k;
    uint8_t *spoke = &cover->spokes[((size_t)pole * k + (size_t)column) * k + (size_t)meridian];
    *spoke = (uint8_t)(*spoke < 3 ? *spoke + 1 : 3);
}

/* A triangle with one or two vertices at a pole; `corner` begins with a vertex at the pole that
 * follows one that is not (so it is the first of its run). */
static enum fit add_at_pole(struct cover *cover, const struct place *corner)
{
    int32_t k = cover->mesh->k;
    int pole = corner[0].parallel != 0;
    int32_t ring = pole == 0 ? 1 : k - 2;
    if (corner[2].parallel != ring)
        return OUTSIDE;
    if (corner[1].parallel == corner[0].parallel) { /* no area */
        if (corner[1].column == corner[0].column || cover->flat_count[pole] == k)
            return corner[1].column == corner[0].column ? OUTSIDE : REPEATED;
        cover->flat_count[pole]++;
        add_spoke(cover, pole, corner[0].column, corner[2].column);
        add_spoke(cover, pole, corner[1].column, corner[2].column);
        return FIT;
    }
    bool east = steps_east(k, corner[1].column, corner[2].column) == 1;
    bool west = steps_east(k, corner[2].column, corner[1].column) == 1;
    if (corner[1].parallel != ring || (!east && !west))
        return OUTSIDE;
    uint8_t *cap = &cover->caps[pole * k + (east ? corner[1].column : corner[2].column)];
    if (*cap)
        return REPEATED;
    *cap = 1;
    add_spoke(cover, pole, corner[0].column, corner[1].column);
    add_spoke(cover, pole, corner[0].column, corner[2].column);
    return east == (pole == 0) ? FIT : FLIPPED;
}

static enum fit add_triangle(struct cover *cover, const int32_t *triangle)
{
    int32_t k = cover->mesh->k;
    struct place corner[3];
    bool polar[3];
    int polar_count = 0;
    for (int i = 0; i < 3; i++) {
        corner[i] = cover->place[triangle[i]];
        if (corner[i].parallel < 0)
            return OUTSIDE;
        polar[i] = corner[i].parallel == 0 || corner[i].parallel == k - 1;
        polar_count += polar[i];
    }
    if (polar_count == 0)
        return add_between_rings(cover, corner);
    if (polar_count == 3)
        return OUTSIDE;
    int first = 0; /* the polar corner after one that is not */
    while (!polar[first] || polar[(first + 2) % 3])
        first++;
    const struct place turned[3] = {corner[first], corner[(first + 1) % 3],
                                    corner[(first + 2) % 3]};
    return add_at_pole(cover, turned);
}

/* --------------------------------------------------------------- explanations */

static void reject_triangle(enum fit fit, int64_t t, const int32_t *corner, struct judgement *out)
{
    static const struct {
        const char *cause, *text, *text_es;
    } faults[] = {
        [FLIPPED] = {"triangle-flipped",
                     "is clockwise seen from outside; all must be counter-clockwise.",
                     "va en sentido horario visto desde fuera; todos van en antihorario."},
        [REPEATED] = {"triangle-repeated", "covers what an earlier one covers.",
                      "cubre lo mismo que otro anterior."},
        [CROSSED] = {"triangles-overlap", "overlaps an earlier one: both diagonals cut its cell.",
                     "se solapa con otro: las dos diagonales parten su celda."},
        [OUTSIDE] = {"triangle-not-in-cell",
                     "is not half of one cell between neighbouring meridians and parallels.",
                     "no es la mitad de una celda entre meridianos y paralelos vecinos."}};
    judge_name_element(out, "triangle %" PRId64 " (%d, %d, %d)", t, corner[0], corner[1],
                       corner[2]);
    judge_reject(out, faults[fit].cause, "Triangle %" PRId64 " (%d, %d, %d) %s%.0s",
                 "El triángulo %" PRId64 " (%d, %d, %d) %.0s%s", t, corner[0], corner[1], corner[2],
                 faults[fit].text, faults[fit].text_es);
}

static void judge_each_triangle(struct cover *cover, struct judgement *out)
{
    const struct sphere_mesh *mesh = cover->mesh;
    int64_t vertex_count = (int64_t)mesh->k * mesh->k;
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        const int32_t *corner = mesh->triangles + 3 * t;
        if (!triangle_in_range(corner, vertex_count)) {
            judge_name_element(out, "triangle %" PRId64 " (%d, %d, %d)", t, corner[0], corner[1],
                               corner[2]);
            judge_reject(out, "index-out-of-range",
                         "Triangle %" PRId64
                         " (%d, %d, %d) names a vertex that is not in 0 ... %" PRId64 ".",
                         "El triángulo %" PRId64
                         " (%d, %d, %d) nombra un vértice fuera de 0 ... %" PRId64 ".",
                         t, corner[0], corner[1], corner[2], vertex_count - 1);
            return;
        }
        enum fit fit = add_triangle(cover, corner);
        if (fit == FIT) {
            out->scene.ok_count++;
            continue;
        }
        if (!out->cause[0])
            reject_triangle(fit, t, corner, out);
        enum mark_kind mark = fit == FLIPPED    ? MARK_FLIPPED
                              : fit == REPEATED ? MARK_DUPLICATE
                                                : MARK_WRONG;
        scene_mark_triangle(&out->scene, mark, corner[0], corner[1], corner[2]);
    }
}

/* Whether cell (i, j) lacks a triangle with area. */
static bool is_bare(const struct cover *cover, int32_t i, int32_t j)
{
    int32_t k = cover->mesh->k;
    if (i == 0 || i == k - 2)
        return !cover->caps[(i == 0 ? 0 : k) + j];
    uint8_t halves = cover->halves[(int64_t)i * k + j];
    return halves != 6u && halves != 9u;
}

static void judge_cells(const struct cover *cover, struct judgement *out)
{
    int32_t k = cover->mesh->k, first_i = -1, first_j = -1;
    bool only_seam = true;
    for (int32_t i = 0; i < k - 1; i++) {
        for (int32_t j = 0; j < k; j++) {
            if (!is_bare(cover, i, j))
                continue;
            only_seam = only_seam && j == k - 1;
            if (first_i < 0) {
                first_i = i;
                first_j = j;
            }
        }
    }
    if (first_i < 0)
        return;
    judge_name_element(out, "cell of parallel %d, meridian %d", first_i, first_j);
    if (only_seam)
        judge_reject(
            out, "seam-open",
            "The seam is open: meridian %d is not joined to meridian 0 (first at parallel %d).",
            "La costura está abierta: el meridiano %d no se une al 0 (primero en el paralelo %d).",
            first_j, first_i);
    else
        judge_reject(
            out, "cell-uncovered",
            "The cell between parallels %d and %d and meridians %d and %d is not covered.",
            "La celda entre los paralelos %d y %d y los meridianos %d y %d no está cubierta.",
            first_i, first_i + 1, first_j, (first_j + 1) % k);
}

/* Around a pole, each edge from one of its vertices to the ring has two triangles, and each of its
 * k vertices has such edges. */
static void judge_poles(const struct cover *cover, struct judgement *out)
{
    int32_t k = cover->mesh->k;
    for (int32_t v = 0; v < k * k; v++) {
        struct place place = cover->place[v];
        if (place.parallel != 0 && place.parallel != k - 1)
            continue;
        const uint8_t *spokes =
            cover->spokes + ((int64_t)(place.parallel != 0) * k + place.column) * k;
        int32_t used = 0;
        bool closed = true;
        for (int32_t j = 0; j < k; j++) {
            used += spokes[j] > 0;
            closed = closed && (spokes[j] == 0 || spokes[j] == 2);
        }
        if (used > 0 && closed)
            continue;
        judge_name_element(out, "vertex %d", v);
        judge_reject(
            out, "pole-not-closed",
            "The triangles around vertex %d, at a pole, do not join: each of its edges to the next"
            " parallel must have two.",
            "Los triángulos alrededor del vértice %d, en un polo, no encajan: cada arista suya al"
            " paralelo siguiente debe tener dos.",
            v);
        scene_mark_vertex(&out->scene, MARK_WRONG, v);
        return;
    }
}

int sphere_judge_triangles(const struct sphere_mesh *mesh, struct judgement *out, struct error *err)
{
    struct cover cover;
    if (cover_init(&cover, mesh, err))
        return -1;
    judge_each_triangle(&cover, out);
    if (!out->cause[0])
        judge_cells(&cover, out);
    if (!out->cause[0])
        judge_poles(&cover, out);
    cover_release(&cover);
    if (out->cause[0])
        return show(mesh, &out->scene, err);
    judge_accept(out);
    return 0;
}

/* --------------------------------------------------------------- as it should be */

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
