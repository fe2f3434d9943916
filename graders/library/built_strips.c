/* Strips of a grid; see built_strips.h. */
#include "graders/library/built_strips.h"

#include "graders/library/mistakes.h"
#include "graders/scene/show.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_STRIP_LIMIT = 256 };

static const struct cause table_missing = {"table-missing", {"table missing", "falta la tabla"}};
static const struct cause strip_missing = {"strip-missing", {"missing strip", "falta una tira"}};
static const struct cause leaves_row = {"strip-leaves-row",
                                        {"strip leaves its row", "tira que sale de su fila"}};

/* -------------------------------------------------------------------------------------- reading */

int64_t built_strips_vertices(int64_t m, int64_t n)
{
    return 2 * m * (n + 1);
}

static int64_t one_a_row(int64_t m, int64_t n)
{
    (void)n;
    return m;
}

static int64_t vertices_of_one(int64_t m, int64_t n)
{
    (void)m;
    return built_strips_vertices(1, n);
}

static const struct built_count strip_count =
    COUNT("strip_count", CAUSE("strip-count", "number of strips", "número de tiras"), one_a_row,
          NULL, "There is one strip for each row.", "Hay una tira por cada fila.");
static const struct built_count vertices_per_strip = COUNT(
    "vertices_per_strip", CAUSE("vertices-per-strip", "vertices per strip", "vértices por tira"),
    vertices_of_one, NULL, "A strip of 2n triangles has 2n + 2 vertices.",
    "Una tira de 2n triángulos tiene 2n + 2 vértices.");

static bool read_each(struct reader *said, struct built_strips *built, struct judgement *out)
{
    int64_t kept = read_int(said);
    if (!built_is_complete(said, out))
        return false;
    if (kept != built->strip_count) {
        judge_reject(out, &table_missing, "The table of strips is NULL.",
                     "La tabla de tiras es NULL.");
        return false;
    }
    for (int64_t i = 0; i < built->strip_count; i++) {
        int64_t count;
        built->strips[i] = read_table(said, &count, 3 * sizeof(float));
        said->failed = said->failed || count != built->vertices_per_strip;
        if (!built_is_complete(said, out))
            return false;
        if (built->strips[i])
            continue;
        judge_name(out, "strip %" PRId64, "tira %" PRId64, i);
        judge_reject(out, &strip_missing, "Strip %" PRId64 " is NULL.",
                     "La tira %" PRId64 " es NULL.", i);
        return false;
    }
    return true;
}

int built_strips_read(struct reader *said, const int64_t asked[2], struct built_strips *built,
                      struct judgement *out, struct error *err)
{
    *built = (struct built_strips){0};
    built->vertices_per_strip = read_int(said);
    built->strip_count = read_int(said);
    if (!built_is_complete(said, out) ||
        !built_count_is_right(&strip_count, asked, built->strip_count, out) ||
        !built_count_is_right(&vertices_per_strip, asked, built->vertices_per_strip, out))
        return 0;
    built->strips = calloc((size_t)built->strip_count, sizeof *built->strips);
    if (!built->strips)
        return error_set(err, "out of memory for %" PRId64 " strips", built->strip_count);
    if (!read_each(said, built, out))
        built_strips_release(built);
    return 0;
}

void built_strips_release(struct built_strips *built)
{
    free(built->strips);
    *built = (struct built_strips){0};
}

/* -------------------------------------------------------------------------------------- showing */

/* Strips that are judged, and which of them the picture shows when it cannot show all. */
struct shown {
    const struct built_strips *built;
    int32_t first; /* SHOWN_STRIP_LIMIT strips from this one on */
};

/* The three corners of triangle i of a strip, as places among its vertices, in drawing order. */
static void corners_of(int32_t i, int32_t corner[3])
{
    corner[0] = i % 2 == 0 ? i : i + 1;
    corner[1] = i % 2 == 0 ? i + 1 : i;
    corner[2] = i + 2;
}

/* The first fault decides which strips are shown. */
static void show_around(struct shown *shown, int32_t strip)
{
    int32_t last = (int32_t)shown->built->strip_count - SHOWN_STRIP_LIMIT;
    shown->first = strip < SHOWN_STRIP_LIMIT ? 0 : strip < last ? strip : last;
}

/* The number of a strip's vertex in the scene's mesh, -1 when the strip is not shown. */
static int32_t shown_vertex(const struct shown *shown, int32_t strip, int32_t vertex)
{
    int32_t place = strip - shown->first;
    bool is_shown = place >= 0 && place < SHOWN_STRIP_LIMIT;
    return is_shown ? place * (int32_t)shown->built->vertices_per_strip + vertex : -1;
}

/* The strips, and the mesh that the marks speak of: all strips' vertices one after the other, and
 * the triangles as they are decoded. */
static int show_strips(const struct shown *shown, struct scene *scene, struct error *err)
{
    int64_t per_strip = shown->built->vertices_per_strip, count = shown->built->strip_count;
    struct mesh mesh;
    count = count < SHOWN_STRIP_LIMIT ? count : SHOWN_STRIP_LIMIT;
    if (mesh_init(&mesh, per_strip * count, (per_strip - 2) * count, err))
        return -1;
    int failed = 0;
    int32_t *triangle = mesh.triangles;
    for (int64_t s = 0; s < count && !failed; s++) {
        const float *positions = shown->built->strips[shown->first + s];
        memcpy(mesh.positions + 3 * per_strip * s, positions,
               3 * sizeof *positions * (size_t)per_strip);
        for (int32_t i = 0; i < per_strip - 2; i++, triangle += 3) {
            corners_of(i, triangle);
            for (int j = 0; j < 3; j++)
                triangle[j] += (int32_t)(s * per_strip);
        }
        failed = show_strip(scene, positions, per_strip, err);
    }
    if (!failed)
        failed = show_mesh(scene, mesh.positions, mesh.vertex_count, mesh.triangles,
                           mesh.triangle_count, err);
    mesh_release(&mesh);
    return failed;
}

/* -------------------------------------------------------------------------------------- judging */

/* A vertex that is no lattice point is rejected. */
static void judge_place(const struct lattice *lattice, struct shown *shown, int32_t strip,
                        int32_t vertex, struct judgement *out)
{
    const float *p = shown->built->strips[strip] + 3 * (int64_t)vertex;
    double x = (double)p[0], y = (double)p[1], z = (double)p[2];
    struct message subject = {0};
    if (lattice_point_at(lattice, p) >= 0)
        return;
    judge_name(out, "strip %d, vertex %d (%.6g, %.6g, %.6g)",
               "tira %d, vértice %d (%.6g, %.6g, %.6g)", strip, vertex, x, y, z);
    message_say(&subject, "Vertex %d of strip %d", "El vértice %d de la tira %d", vertex, strip);
    lattice_reject_place(lattice, &subject, p, out);
    show_around(shown, strip);
    scene_mark_vertex(&out->scene, MARK_WRONG, shown_vertex(shown, strip, vertex));
}

/* fit: CELL_HALF when the triangle only leaves the row. */
static void reject_triangle(enum cell_fit fit, int32_t strip, int32_t i, struct judgement *out)
{
    static const struct cell_cover cover = {.seen_from = {"above", "arriba"}};
    struct message subject = {0};
    message_say(&subject, "Triangle %d of strip %d (vertices %d, %d, %d of it)",
                "El triángulo %d de la tira %d (sus vértices %d, %d, %d)", i, strip, i, i + 1,
                i + 2);
    judge_name(out, "strip %d, triangle %d", "tira %d, triángulo %d", strip, i);
    if (fit != CELL_HALF)
        cell_reject(fit, &subject, &cover, out);
    else if (judge_reject_for(out, &leaves_row)) {
        judge_en(out, "%s is in another row than the strip's first.", subject.en);
        judge_es(out, "%s está en otra fila que el primero de la tira.", subject.es);
    }
    if (fit == CELL_HALF_FLIPPED)
        judge_hint(out, (struct phrase){"Odd ones change their first two vertices.",
                                        "Los impares cambian sus dos primeros vértices."});
}

static void judge_triangle(struct shown *shown, int32_t strip, int32_t i, enum cell_fit fit,
                           struct judgement *out)
{
    int32_t corner[3];
    if (!out->cause[0]) {
        reject_triangle(fit, strip, i, out);
        show_around(shown, strip);
    }
    corners_of(i, corner);
    scene_mark_triangle(&out->scene, cell_mark(fit), shown_vertex(shown, strip, corner[0]),
                        shown_vertex(shown, strip, corner[1]),
                        shown_vertex(shown, strip, corner[2]));
}

/* Adds a strip's triangles to the lattice; the first fault is named, all are marked. */
static void judge_strip(struct lattice *lattice, struct shown *shown, int32_t strip, int64_t aspect,
                        struct judgement *out)
{
    int32_t vertex_count = (int32_t)shown->built->vertices_per_strip, strip_row = -1;
    for (int32_t v = 0; v < vertex_count && (aspect & BUILT_COVER) && !out->cause[0]; v++)
        judge_place(lattice, shown, strip, v, out);
    for (int32_t i = 0; i + 2 < vertex_count; i++) {
        int32_t corner[3], point[3], cell;
        corners_of(i, corner);
        for (int j = 0; j < 3; j++)
            point[j] =
                lattice_nearest(lattice, shown->built->strips[strip] + 3 * (int64_t)corner[j]);
        enum cell_fit fit = lattice_add(lattice, point, &cell);
        int32_t row = cell < 0 ? -1 : cell / lattice->n;
        strip_row = strip_row < 0 ? row : strip_row;
        if (fit == CELL_HALF_FLIPPED && !(aspect & BUILT_WINDING))
            fit = CELL_HALF;
        if (fit == CELL_HALF && row == strip_row)
            out->scene.ok_count++;
        else
            judge_triangle(shown, strip, i, fit, out);
    }
}

int built_strips_judge(const int64_t asked[3], const struct built_strips *built,
                       struct judgement *out, struct error *err)
{
    struct shown shown = {.built = built};
    struct lattice lattice;
    if (lattice_init(&lattice, (int32_t)asked[0], (int32_t)asked[1], err))
        return -1;
    for (int32_t s = 0; s < built->strip_count; s++)
        judge_strip(&lattice, &shown, s, asked[2], out);
    lattice_judge_cover(&lattice, out);
    lattice_release(&lattice);
    out->accepted = !out->cause[0];
    return out->accepted ? 0 : show_strips(&shown, &out->scene, err);
}
