/* Judging winged edges; see winged_judge.h. */
#include "graders/library/winged_judge.h"

#include <inttypes.h>

static const struct phrase edge_noun = {"edge", "arista"};
static const struct phrase vertex_noun = {"vertex", "vértice"};
static const struct phrase face_noun = {"face", "cara"};
static const struct phrase of_the_answer = {"in the answer", "en la respuesta"};
static const struct phrase what_is_right = {"right", "lo correcto"};
static const struct phrase other_wings = {"its other wings", "sus otras alas"};
static const struct phrase at_fault = {"at fault", "con un fallo"};
static const struct phrase no_face = {
    "There is no face on that side: the face and its two links are NONE.",
    "En ese lado no hay cara: la cara y sus dos enlaces son NONE."};
static const struct phrase swapped = {
    "It is the other link of that side: are before and after swapped?",
    "Es el otro enlace de ese lado: ¿están intercambiadas la anterior y la posterior?"};
static const struct phrase other_side = {"It is a link of the other side.",
                                         "Es un enlace del otro lado."};

enum { WINGS = 4 };
static const enum mark_kind of_fault = MARK_TURN_0;
static const enum mark_kind of_wing = (enum mark_kind)(MARK_TURN_0 + 1);

struct view {
    const struct structure_truth *truth;
    const struct structure_answer *answer;
    const struct structure_fault *fault;
    struct scene *scene;
};

/* --------------------------------------------------------------------------------------- marks */

static int32_t entry(const struct view *view, int64_t row, int column)
{
    return view->answer->get(view->answer->rows, row, column);
}

/* The edge of a row of the answer, with the number of the row; NONE marks nothing. */
static void mark_row(const struct view *view, enum mark_kind kind, int64_t row)
{
    if (row < 0 || row >= view->answer->row_count)
        return;
    scene_mark_edge(view->scene, kind, entry(view, row, WINGED_VI), entry(view, row, WINGED_VF));
    scene_label_edge(view->scene, entry(view, row, WINGED_VI), entry(view, row, WINGED_VF), row);
}

/* The corners of a face; NULL when there is no such face. */
static const int32_t *corners_of(const struct view *view, int64_t face, int64_t *count)
{
    const struct face_topology *t = &view->truth->topology;
    if (face < 0 || face >= t->table.face_count)
        return NULL;
    return t->table.corners + topology_face(t, face, count);
}

static void number_face(const struct view *view, int64_t face)
{
    int64_t count;
    const int32_t *corners = corners_of(view, face, &count);
    if (corners)
        scene_label_face(view->scene, corners, count, face);
}

static void mark_face(const struct view *view, enum mark_kind kind, int64_t face)
{
    int64_t count;
    const int32_t *corners = corners_of(view, face, &count);
    if (corners)
        scene_mark_face(view->scene, kind, corners, count);
    number_face(view, face);
}

static void mark_side(const struct view *view, enum mark_kind kind, int64_t side)
{
    int64_t count, face = structure_face(view->truth, side);
    const int32_t *corners = corners_of(view, face, &count);
    if (corners)
        scene_mark_half_edge(view->scene, kind, corners, count,
                             side - (corners - view->truth->topology.table.corners));
}

/* -------------------------------------------------------------------------------------- faults */

/* Whether a row of the answer stands for the edge of a side. */
static bool row_is(const struct view *view, int32_t row, int64_t side)
{
    if (row < 0 || row >= view->answer->row_count)
        return false;
    int32_t vi = entry(view, row, WINGED_VI), vf = entry(view, row, WINGED_VF);
    int32_t a = structure_from(view->truth, side), b = structure_to(view->truth, side);
    return (vi == a && vf == b) || (vi == b && vf == a);
}

/* The sides that ada, ads, aia and ais of the row at fault stand for. */
static void find_wings(const struct view *view, int64_t wings[WINGS])
{
    int64_t side = structure_find_step(view->truth, view->fault->from, view->fault->to);
    int64_t twin = structure_twin(view->truth, side);
    wings[0] = structure_previous(view->truth, side);
    wings[1] = structure_next(view->truth, side);
    wings[2] = structure_previous(view->truth, twin);
    wings[3] = structure_next(view->truth, twin);
}

/* What the wrong link is instead; no phrase: nothing in particular. */
static struct phrase explain_entry(const struct view *view, const int64_t wings[WINGS])
{
    const struct structure_fault *fault = view->fault;
    int place = fault->column - WINGED_ADA;
    if (fault->column >= WINGED_CD && fault->wanted[0] == STRUCTURE_NONE)
        return no_face;
    if (place < 0)
        return (struct phrase){NULL, NULL};
    if (row_is(view, fault->found, wings[place ^ 1]))
        return swapped;
    if (row_is(view, fault->found, wings[place ^ 2]) ||
        row_is(view, fault->found, wings[place ^ 3]))
        return other_side;
    return (struct phrase){NULL, NULL};
}

/* The edge, its two faces and its wings. */
static void show_entry(const struct view *view, const int64_t wings[WINGS])
{
    const struct structure_fault *fault = view->fault;
    scene_mark_arrow(view->scene, of_fault, fault->from, fault->to);
    scene_label_edge(view->scene, fault->from, fault->to, fault->row);
    if (fault->column <= WINGED_VF) {
        scene_mark_vertex(view->scene, MARK_WRONG, fault->found);
        scene_mark_vertex(view->scene, MARK_RIGHT, fault->wanted[0]);
    } else if (fault->column <= WINGED_CI) {
        mark_face(view, MARK_WRONG, fault->found);
        mark_face(view, MARK_RIGHT, fault->wanted[0]);
    } else {
        mark_row(view, MARK_WRONG, fault->found);
    }
    for (int i = 0; i < WINGS; i++) {
        number_face(view, structure_face(view->truth, wings[i]));
        mark_side(view, i == fault->column - WINGED_ADA ? MARK_RIGHT : of_wing, wings[i]);
        for (int64_t row = 0; row < view->answer->row_count; row++)
            if (row_is(view, (int32_t)row, wings[i]) &&
                structure_face(view->truth, wings[i]) != STRUCTURE_NONE)
                scene_label_edge(view->scene, entry(view, row, WINGED_VI),
                                 entry(view, row, WINGED_VF), row);
    }
}

/* A vertex or a face, the edge that its table names, and those that it might. */
static void show_table(const struct view *view)
{
    const struct structure_fault *fault = view->fault;
    if (fault->column == WINGED_VERTEX_EDGE)
        scene_mark_vertex(view->scene, of_fault, (int32_t)fault->row);
    else
        mark_face(view, of_fault, fault->row);
    mark_row(view, MARK_WRONG, fault->found);
    for (int64_t i = 0; i < fault->wanted_count && i < STRUCTURE_WANTED_MOST; i++)
        mark_row(view, MARK_RIGHT, fault->wanted[i]);
}

/* ---------------------------------------------------------------------------------- rejecting */

static void name_element(const struct structure_fault *fault, struct judgement *out)
{
    if (fault->kind == STRUCTURE_WRONG_ENTRY && fault->column >= WINGED_VERTEX_EDGE)
        judge_name_one(out, fault->column == WINGED_VERTEX_EDGE ? vertex_noun : face_noun,
                       "%" PRId64, fault->row);
    else if (fault->kind == STRUCTURE_MISSING)
        judge_name_one(out, edge_noun, "(%d,%d)", fault->from, fault->to);
    else if (fault->from == STRUCTURE_NONE)
        judge_name_one(out, edge_noun, "%" PRId64, fault->row);
    else
        judge_name_one(out, edge_noun, "%" PRId64 " (%d,%d)", fault->row, fault->from, fault->to);
}

static void reject(const struct view *view, struct judgement *out)
{
    const struct structure_fault *fault = view->fault;
    struct message said;
    int64_t wings[WINGS];
    structure_fault_say(fault, &said);
    judge_reject_for(out, structure_fault_cause(fault));
    judge_en(out, "%s.", said.en);
    judge_es(out, "%s.", said.es);
    name_element(fault, out);
    out->scene.ok_count = -1;
    scene_name_marks(view->scene, of_fault, at_fault);
    scene_name_marks(view->scene, of_wing, other_wings);
    scene_name_marks(view->scene, MARK_WRONG, of_the_answer);
    scene_name_marks(view->scene, MARK_RIGHT, what_is_right);
    if (fault->kind == STRUCTURE_MISSING) {
        scene_mark_edge(view->scene, MARK_MISSING, fault->from, fault->to);
    } else if (fault->kind != STRUCTURE_WRONG_ENTRY) {
        mark_row(view, fault->kind == STRUCTURE_REPEATED ? MARK_DUPLICATE : MARK_EXTRA, fault->row);
    } else if (fault->column >= WINGED_VERTEX_EDGE) {
        show_table(view);
    } else {
        find_wings(view, wings);
        show_entry(view, wings);
        judge_hint(out, explain_entry(view, wings));
    }
}

int winged_judge(const struct face_table *faces, const struct structure_answer *answer,
                 struct judgement *out, struct error *err)
{
    struct structure_truth truth;
    struct structure_fault fault;
    if (structure_truth_build(faces, &truth, err))
        return -1;
    int failed = structure_compare(&truth, answer, &fault, err);
    const struct view view = {&truth, answer, &fault, &out->scene};
    if (!failed) {
        if (fault.kind == STRUCTURE_FINE)
            judge_accept(out);
        else
            reject(&view, out);
        structure_fault_release(&fault);
    }
    structure_truth_release(&truth);
    return failed;
}
