/* Comparing connected structures with their faces; see structure.h. Words: structure_words.c. */
#include "graders/library/structure.h"

#include <inttypes.h>
#include <stdlib.h>

enum { NOT_KNOWN = -2 }; /* an entry that names a row which is not known */

struct comparison {
    const struct structure_truth *truth;
    const struct structure_answer *answer;
    struct structure_fault *fault;
    int64_t *side_of;   /* of each row: the side that it stands for; -1 */
    int32_t *row_of;    /* of each side: the row that stands for it; -1 */
    int64_t side_count; /* numbers of sides: twice the corners, not all of them in use */
};

int32_t structure_winged_get(const void *rows, int64_t row, int column)
{
    return ((const int32_t *)rows)[8 * row + column];
}

int32_t structure_half_get(const void *rows, int64_t row, int column)
{
    return ((const int32_t *)rows)[5 * row + column];
}

static bool is_winged(const struct comparison *c)
{
    return c->answer->kind == STRUCTURE_WINGED_EDGE;
}

static int32_t entry(const struct comparison *c, int64_t row, int column)
{
    return c->answer->get(c->answer->rows, row, column);
}

static int column_count(const struct comparison *c)
{
    return is_winged(c) ? WINGED_AIS + 1 : HALF_PREVIOUS + 1;
}

/* --------------------------------------------------------------------------- what a row must hold
 */

/* The number of the row of a side; along a hole a winged edge has no links. */
static int32_t link_to(const struct comparison *c, int64_t from, int64_t to)
{
    if (is_winged(c) && structure_face(c->truth, from) == STRUCTURE_NONE)
        return STRUCTURE_NONE;
    return c->row_of[to] >= 0 ? c->row_of[to] : NOT_KNOWN;
}

static int32_t right_winged_entry(const struct comparison *c, int64_t side, int column)
{
    int64_t twin = structure_twin(c->truth, side);
    switch (column) {
    case WINGED_VI:
        return structure_from(c->truth, side);
    case WINGED_VF:
        return structure_from(c->truth, twin);
    case WINGED_CD:
        return structure_face(c->truth, side);
    case WINGED_CI:
        return structure_face(c->truth, twin);
    case WINGED_ADA:
        return link_to(c, side, structure_previous(c->truth, side));
    case WINGED_ADS:
        return link_to(c, side, structure_next(c->truth, side));
    case WINGED_AIA:
        return link_to(c, twin, structure_previous(c->truth, twin));
    default:
        return link_to(c, twin, structure_next(c->truth, twin));
    }
}

static int32_t right_half_entry(const struct comparison *c, int64_t side, int column)
{
    switch (column) {
    case HALF_ORIGIN:
        return structure_from(c->truth, side);
    case HALF_TWIN:
        return link_to(c, side, structure_twin(c->truth, side));
    case HALF_FACE:
        return structure_face(c->truth, side);
    case HALF_NEXT:
        return link_to(c, side, structure_next(c->truth, side));
    default:
        return link_to(c, side, structure_previous(c->truth, side));
    }
}

/* What a row holds that stands for a side, or NOT_KNOWN. */
static int32_t right_entry(const struct comparison *c, int64_t side, int column)
{
    return is_winged(c) ? right_winged_entry(c, side, column) : right_half_entry(c, side, column);
}

/* How many entries of a row agree with a side. */
static int agreement(const struct comparison *c, int64_t row, int64_t side)
{
    int count = 0;
    for (int column = 0; column < column_count(c); column++) {
        int32_t right = right_entry(c, side, column);
        count += right != NOT_KNOWN && entry(c, row, column) == right;
    }
    return count;
}

/* --------------------------------------------------------------------------- what is told first */

/* How many things there are of the kind that a column names. */
static int64_t limit_of_column(const struct comparison *c, int column)
{
    const struct face_table *table = &c->truth->topology.table;
    bool is_vertex = is_winged(c) ? column <= WINGED_VF : column == HALF_ORIGIN;
    bool is_face = is_winged(c) ? column == WINGED_CD || column == WINGED_CI : column == HALF_FACE;
    return is_vertex ? table->vertex_count : is_face ? table->face_count : c->answer->row_count;
}

static void tell_entry(struct comparison *c, int64_t row, int column, int32_t found)
{
    c->fault->kind = STRUCTURE_WRONG_ENTRY;
    c->fault->row = row;
    c->fault->column = column;
    c->fault->found = found;
    c->fault->is_out_of_range = found < STRUCTURE_NONE || found >= limit_of_column(c, column);
}

static void tell_side(struct comparison *c, int64_t side)
{
    c->fault->from = structure_from(c->truth, side);
    c->fault->to = structure_to(c->truth, side);
    c->fault->face = structure_face(c->truth, side);
}

static void tell_right(struct comparison *c, int32_t right)
{
    c->fault->wanted[0] = right;
    c->fault->wanted_count = 1;
}

/* ----------------------------------------------------------------------- which row is which edge
 */

/* The side that the identity of a row names: its two vertices, or its face and origin. */
static int64_t named_side(const struct comparison *c, int64_t row)
{
    if (is_winged(c))
        return structure_find_step(c->truth, entry(c, row, WINGED_VI), entry(c, row, WINGED_VF));
    return structure_find_corner(c->truth, entry(c, row, HALF_FACE), entry(c, row, HALF_ORIGIN));
}

static void claim(struct comparison *c, int64_t row, int64_t side)
{
    c->row_of[side] = (int32_t)row;
    if (is_winged(c))
        c->row_of[structure_twin(c->truth, side)] = (int32_t)row;
}

static void claim_sides(struct comparison *c)
{
    for (int64_t side = 0; side < c->side_count; side++)
        c->row_of[side] = -1;
    for (int64_t row = 0; row < c->answer->row_count; row++) {
        int64_t side = c->side_of[row] = named_side(c, row);
        if (side < 0) {
            c->fault->marks[row] = STRUCTURE_NO_ELEMENT;
            c->fault->no_element_count++;
        } else if (c->row_of[side] >= 0) {
            c->fault->marks[row] = STRUCTURE_REPEATED;
            c->fault->repeated_count++;
        } else {
            claim(c, row, side);
        }
    }
}

/* Of two rows that name one side, the one that fits it worse is told as the repeated one. Every
 * repeated row is looked at once, with the row that has the side by then. */
static void settle_claims(struct comparison *c)
{
    for (int64_t row = 0; c->fault->repeated_count > 0 && row < c->answer->row_count; row++) {
        if (c->fault->marks[row] != STRUCTURE_REPEATED)
            continue;
        int64_t other = c->row_of[c->side_of[row]];
        if (agreement(c, row, c->side_of[row]) <= agreement(c, other, c->side_of[other]))
            continue;
        claim(c, row, c->side_of[row]);
        c->fault->marks[row] = STRUCTURE_FINE;
        c->fault->marks[other] = STRUCTURE_REPEATED;
    }
}

static bool is_side(const struct comparison *c, int64_t side)
{
    int64_t corners = c->side_count / 2;
    return side < corners || topology_twin(&c->truth->topology, side - corners) < 0;
}

static void count_missing(struct comparison *c)
{
    int64_t first = -1;
    for (int64_t side = 0; side < c->side_count; side++) {
        if (!is_side(c, side) || c->row_of[side] >= 0)
            continue;
        /* A winged edge has two sides, and is missed at the first. */
        if (is_winged(c) && structure_twin(c->truth, side) < side)
            continue;
        if (c->fault->missing_count++ == 0)
            first = side;
    }
    if (first < 0 || c->fault->kind != STRUCTURE_FINE)
        return;
    c->fault->kind = STRUCTURE_MISSING;
    tell_side(c, first);
}

/* ------------------------------------------------------------------------- the first row at fault
 */

/* A side that nobody names and that a row may mean: the best so far. */
struct guess {
    int64_t row, side;
    int agreement, column;
    bool is_tied;
};

static void consider(const struct comparison *c, struct guess *guess, int64_t side, int column)
{
    if (side < 0 || c->row_of[side] >= 0)
        return;
    int agrees = agreement(c, guess->row, side);
    if (agrees > guess->agreement)
        *guess = (struct guess){guess->row, side, agrees, column, false};
    else if (agrees == guess->agreement && side != guess->side)
        guess->is_tied = true;
}

/* The sides that start (or end) at a vertex, any number. */
static void consider_vertex(const struct comparison *c, struct guess *guess, int32_t vertex,
                            bool starts, int column)
{
    const struct structure_truth *truth = c->truth;
    int64_t used = topology_find_vertex(&truth->topology, vertex);
    if (used < 0)
        return;
    for (int64_t i = truth->first_of[used]; i < truth->first_of[used + 1]; i++) {
        int64_t side = truth->by_vertex[i];
        consider(c, guess, starts ? side : structure_previous(truth, side), column);
    }
    int32_t rim = starts ? truth->rim_ends_at[used] : truth->rim_starts_at[used];
    if (rim >= 0)
        consider(c, guess, c->side_count / 2 + rim, column);
}

static void consider_face(const struct comparison *c, struct guess *guess, int32_t face, int column)
{
    const struct face_topology *t = &c->truth->topology;
    if (face < 0 || face >= t->table.face_count)
        return;
    int64_t count, first = topology_face(t, face, &count);
    for (int64_t side = first; side < first + count; side++)
        consider(c, guess, side, column);
}

/* Finds the one entry of a row's identity that explains it, if there is one: then most other
 * entries agree. */
static bool explain_row(struct comparison *c, int64_t row)
{
    struct guess guess = {.row = row, .side = -1};
    if (is_winged(c)) {
        consider_vertex(c, &guess, entry(c, row, WINGED_VI), true, WINGED_VF);
        consider_vertex(c, &guess, entry(c, row, WINGED_VF), false, WINGED_VI);
    } else {
        consider_vertex(c, &guess, entry(c, row, HALF_ORIGIN), true, HALF_FACE);
        consider_face(c, &guess, entry(c, row, HALF_FACE), HALF_ORIGIN);
    }
    if (guess.side < 0 || guess.is_tied || 2 * guess.agreement <= column_count(c))
        return false;
    tell_entry(c, row, guess.column, entry(c, row, guess.column));
    tell_right(c, right_entry(c, guess.side, guess.column));
    tell_side(c, guess.side);
    return true;
}

static void find_row_at_fault(struct comparison *c)
{
    struct structure_fault *fault = c->fault;
    int64_t row = 0;
    while (row < c->answer->row_count && fault->marks[row] == STRUCTURE_FINE)
        row++;
    if (row == c->answer->row_count)
        return;
    fault->row = row;
    if (explain_row(c, row))
        return;
    fault->kind = (enum structure_fault_kind)fault->marks[row];
    if (fault->kind == STRUCTURE_REPEATED) {
        fault->repeated_of = c->row_of[c->side_of[row]];
        tell_side(c, c->side_of[row]);
    }
}

/* -------------------------------------------------------------------------------------- entries */

static bool is_first_wrong(struct comparison *c, int column)
{
    c->fault->wrong_count++;
    c->fault->column_counts[column]++;
    return c->fault->wrong_count == 1;
}

static void look_at_rows(struct comparison *c)
{
    for (int64_t row = 0; row < c->answer->row_count; row++)
        for (int column = 0; column < column_count(c); column++) {
            int64_t side = c->side_of[row];
            int32_t found = entry(c, row, column), right = right_entry(c, side, column);
            if (found == right)
                continue;
            c->fault->marks[row] = STRUCTURE_WRONG_ENTRY;
            if (!is_first_wrong(c, column))
                continue;
            tell_entry(c, row, column, found);
            tell_right(c, right);
            tell_side(c, side);
        }
}

/* Adds the row of a side to what would be right; the smallest are kept, in order. A winged edge is
 * at a vertex, or in a face, with one side only, so that no row comes twice. */
static void want(struct comparison *c, int64_t side)
{
    struct structure_fault *fault = c->fault;
    int32_t row = c->row_of[side];
    int64_t place = fault->wanted_count++;
    if (place >= STRUCTURE_WANTED_MOST) {
        place = STRUCTURE_WANTED_MOST - 1;
        if (fault->wanted[place] < row)
            return;
    }
    for (; place > 0 && fault->wanted[place - 1] > row; place--)
        fault->wanted[place] = fault->wanted[place - 1];
    fault->wanted[place] = row;
}

static void want_at_vertex(struct comparison *c, int64_t used)
{
    const struct structure_truth *truth = c->truth;
    for (int64_t i = truth->first_of[used]; i < truth->first_of[used + 1]; i++)
        want(c, truth->by_vertex[i]);
    if (truth->rim_ends_at[used] >= 0)
        want(c, c->side_count / 2 + truth->rim_ends_at[used]);
}

/* Whether a row has a side that starts at the vertex. */
static bool row_is_at(const struct comparison *c, int32_t row, int64_t vertex)
{
    if (row < 0 || row >= c->answer->row_count)
        return false;
    int64_t side = c->side_of[row];
    return structure_from(c->truth, side) == vertex ||
           (is_winged(c) && structure_to(c->truth, side) == vertex);
}

static void look_at_vertices(struct comparison *c)
{
    const struct face_topology *t = &c->truth->topology;
    int column = is_winged(c) ? WINGED_VERTEX_EDGE : HALF_OF_VERTEX;
    for (int64_t v = 0; c->answer->of_vertex && v < t->table.vertex_count; v++) {
        int32_t found = c->answer->of_vertex[v];
        int64_t used = topology_find_vertex(t, (int32_t)v);
        if (used < 0 ? found == STRUCTURE_NONE : row_is_at(c, found, v))
            continue;
        if (!is_first_wrong(c, column))
            continue;
        tell_entry(c, v, column, found);
        if (used >= 0)
            want_at_vertex(c, used);
        else
            tell_right(c, STRUCTURE_NONE);
    }
}

static bool row_is_in(const struct comparison *c, int32_t row, int64_t face)
{
    if (row < 0 || row >= c->answer->row_count)
        return false;
    int64_t side = c->side_of[row];
    return structure_face(c->truth, side) == face ||
           (is_winged(c) && structure_face(c->truth, structure_twin(c->truth, side)) == face);
}

static void look_at_faces(struct comparison *c)
{
    const struct face_topology *t = &c->truth->topology;
    int column = is_winged(c) ? WINGED_FACE_EDGE : HALF_OF_FACE;
    for (int64_t f = 0; c->answer->of_face && f < t->table.face_count; f++) {
        if (row_is_in(c, c->answer->of_face[f], f) || !is_first_wrong(c, column))
            continue;
        tell_entry(c, f, column, c->answer->of_face[f]);
        int64_t count, first = topology_face(t, f, &count);
        for (int64_t side = first; side < first + count; side++)
            want(c, side);
    }
}

/* ------------------------------------------------------------------------------------ comparing */

static void compare(struct comparison *c)
{
    claim_sides(c);
    settle_claims(c);
    find_row_at_fault(c);
    count_missing(c);
    if (c->fault->kind != STRUCTURE_FINE)
        return;
    look_at_rows(c);
    look_at_vertices(c);
    look_at_faces(c);
}

int structure_compare(const struct structure_truth *truth, const struct structure_answer *answer,
                      struct structure_fault *fault, struct error *err)
{
    *fault = (struct structure_fault){.structure = answer->kind,
                                      .row = -1,
                                      .repeated_of = -1,
                                      .from = STRUCTURE_NONE,
                                      .to = STRUCTURE_NONE,
                                      .face = STRUCTURE_NONE};
    if (answer->row_count < 0 || answer->row_count >= INT32_MAX)
        return error_set(err, "%" PRId64 " rows cannot be compared: check the count first",
                         answer->row_count);
    struct comparison c = {.truth = truth, .answer = answer, .fault = fault};
    c.side_count = 2 * truth->topology.table.corner_count;
    c.side_of = calloc((size_t)answer->row_count + 1, sizeof *c.side_of);
    c.row_of = calloc((size_t)c.side_count + 1, sizeof *c.row_of);
    fault->marks = calloc((size_t)answer->row_count + 1, 1);
    bool has_memory = c.side_of && c.row_of && fault->marks;
    if (has_memory)
        compare(&c);
    else
        structure_fault_release(fault);
    free(c.side_of);
    free(c.row_of);
    return has_memory
               ? 0
               : error_set(err, "out of memory: comparing %" PRId64 " rows", answer->row_count);
}

void structure_fault_release(struct structure_fault *fault)
{
    free(fault->marks);
    *fault = (struct structure_fault){0};
}
