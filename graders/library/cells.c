/* Triangles as halves of cells; see cells.h. */
#include "graders/library/cells.h"

#include "graders/scene/show.h"

#include <inttypes.h>

/* Both halves of a cell: those without corners 1 and 2, those without corners 0 and 3. */
enum { CUT_UP = 6, CUT_DOWN = 9 };

static const struct phrase triangle_noun = {"triangle", "triángulo"};
static const struct cause out_of_range = {"index-out-of-range",
                                          {"index out of range", "índice fuera de rango"}};

/* What is wrong with a triangle, behind its name. */
static const struct {
    struct cause cause;
    struct phrase what;
} faults[] = {
    [CELL_HALF_FLIPPED] = {{"triangle-flipped", {"flipped triangle", "triángulo invertido"}},
                           {"is clockwise; all must be counter-clockwise, seen from",
                            "va en sentido horario; todos deben ir en antihorario, vistos desde"}},
    [CELL_REPEATED] = {{"triangle-repeated", {"repeated triangle", "triángulo repetido"}},
                       {"covers what an earlier triangle covers",
                        "cubre lo mismo que un triángulo anterior"}},
    [CELL_CROSSED] = {{"triangles-overlap", {"overlapping triangles", "triángulos solapados"}},
                      {"overlaps an earlier one: its cell is cut by both diagonals",
                       "se solapa con otro anterior: su celda está partida por las dos "
                       "diagonales"}},
    [CELL_OUTSIDE] = {{"triangle-not-in-cell",
                       {"triangle not in a cell", "triángulo fuera de su celda"}},
                      {"is not half of one cell", "no es la mitad de una celda"}},
};

enum cell_fit cell_add(uint8_t *halves, const int32_t x[3], const int32_t y[3])
{
    unsigned corners = 0;
    for (int i = 0; i < 3; i++) {
        if (x[i] < 0 || x[i] > 1 || y[i] < 0 || y[i] > 1)
            return CELL_OUTSIDE;
        corners |= 1u << (2 * y[i] + x[i]);
    }
    unsigned missing = ~corners & 15u;
    if (missing == 0 || (missing & (missing - 1)) != 0) /* not just one corner of four */
        return CELL_OUTSIDE;
    if (*halves & missing)
        return CELL_REPEATED;
    if (*halves & (missing & CUT_UP ? CUT_DOWN : CUT_UP))
        return CELL_CROSSED;
    *halves |= (uint8_t)missing;
    int32_t turn = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    return turn > 0 ? CELL_HALF : CELL_HALF_FLIPPED;
}

bool cell_is_covered(uint8_t halves)
{
    return halves == CUT_UP || halves == CUT_DOWN;
}

enum mark_kind cell_mark(enum cell_fit fit)
{
    if (fit == CELL_HALF_FLIPPED)
        return MARK_FLIPPED;
    return fit == CELL_REPEATED ? MARK_DUPLICATE : MARK_WRONG;
}

void cell_reject(enum cell_fit fit, const struct message *subject, const struct cell_cover *cover,
                 struct judgement *out)
{
    if (!judge_reject_for(out, &faults[fit].cause))
        return;
    judge_en(out, "%s %s", subject->en, faults[fit].what.en);
    judge_es(out, "%s %s", subject->es, faults[fit].what.es);
    if (fit == CELL_HALF_FLIPPED)
        judge_hint(out, cover->seen_from);
    message_add(&out->message, ".", ".");
    if (fit == CELL_OUTSIDE)
        judge_hint(out, cover->hint);
}

/* Rejects the first triangle that does not fit. */
static void reject_first(const struct built_mesh *mesh, const struct cell_cover *cover, int64_t t,
                         enum cell_fit fit, struct judgement *out)
{
    const int32_t *corner = mesh->triangles + 3 * t;
    struct message subject = {0};
    if (out->cause[0])
        return;
    message_say(&subject, "Triangle %" PRId64 " (%d, %d, %d)",
                "El triángulo %" PRId64 " (%d, %d, %d)", t, corner[0], corner[1], corner[2]);
    judge_name_one(out, triangle_noun, "%" PRId64 " (%d, %d, %d)", t, corner[0], corner[1],
                   corner[2]);
    if (scene_triangle_in_range(corner, mesh->vertex_count)) {
        cell_reject(fit, &subject, cover, out);
    } else if (judge_reject_for(out, &out_of_range)) {
        int64_t last = mesh->vertex_count - 1;
        judge_en(out, "%s names a vertex that is not in 0 ... %" PRId64 ".", subject.en, last);
        judge_es(out, "%s nombra un vértice fuera de 0 ... %" PRId64 ".", subject.es, last);
    }
}

void cells_judge(const struct built_mesh *mesh, const struct cell_cover *cover,
                 struct judgement *out)
{
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        const int32_t *corner = mesh->triangles + 3 * t;
        bool in_range = scene_triangle_in_range(corner, mesh->vertex_count);
        enum cell_fit fit = in_range ? cover->add(cover->cells, corner) : CELL_OUTSIDE;
        if (fit == CELL_HALF) {
            out->scene.ok_count++;
            continue;
        }
        reject_first(mesh, cover, t, fit, out);
        if (!in_range)
            return;
        scene_mark_triangle(&out->scene, cell_mark(fit), corner[0], corner[1], corner[2]);
    }
}
