/* Winged edges and half edges against their faces: the course's tables and every change of one
 * entry of them, random surfaces against a slow reading of the definitions, and garbage. */
#include "graders/library/structure.h"
#include "reference/base/random.h"
#include "tests/unit/course_prism.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_FACES = 40, MOST_CORNERS = 4 * MOST_FACES, MOST_VERTICES = 40 };

/* Faces, and the tables of either structure. */
struct sample {
    int32_t starts[MOST_FACES + 1], corners[MOST_CORNERS];
    struct face_table table;
    int32_t winged[MOST_CORNERS][8], half[2 * MOST_CORNERS][5];
    int32_t vertex_edge[MOST_VERTICES], face_edge[MOST_FACES];
    int32_t vertex_half[MOST_VERTICES], face_half[MOST_FACES];
    int32_t edge_count, half_count;
};

/* -- a slow reading of the definitions -------------------------------------------------------- */

/* The corner of a face at a vertex, or -1. */
static int32_t corner_of(const struct sample *s, int32_t face, int32_t v)
{
    for (int32_t c = s->starts[face]; c < s->starts[face + 1]; c++)
        if (s->corners[c] == v)
            return c;
    return -1;
}

static int32_t after(const struct sample *s, int32_t face, int32_t v, int step)
{
    int32_t c = corner_of(s, face, v), first = s->starts[face];
    int32_t count = s->starts[face + 1] - first;
    return s->corners[first + (c - first + step + count) % count];
}

/* The face that runs from u to v, or -1. */
static int32_t face_of_step(const struct sample *s, int32_t u, int32_t v)
{
    for (int32_t f = 0; f < s->table.face_count; f++)
        if (corner_of(s, f, u) >= 0 && after(s, f, u, 1) == v)
            return f;
    return -1;
}

/* The vertex after v, having come from u, along a face or along a hole: the vertex w to which no
 * face runs from v, but from which one runs to v. */
static int32_t step_on(const struct sample *s, int32_t u, int32_t v)
{
    int32_t face = face_of_step(s, u, v);
    if (face >= 0)
        return after(s, face, v, 1);
    for (int32_t w = 0; w < s->table.vertex_count; w++)
        if (face_of_step(s, w, v) >= 0 && face_of_step(s, v, w) < 0)
            return w;
    return -1;
}

static int32_t step_back(const struct sample *s, int32_t u, int32_t v)
{
    int32_t face = face_of_step(s, u, v);
    if (face >= 0)
        return after(s, face, u, -1);
    for (int32_t w = 0; w < s->table.vertex_count; w++)
        if (face_of_step(s, u, w) >= 0 && face_of_step(s, w, u) < 0)
            return w;
    return -1;
}

static int32_t winged_row(const struct sample *s, int32_t u, int32_t v)
{
    for (int32_t e = 0; e < s->edge_count; e++)
        if ((s->winged[e][0] == u && s->winged[e][1] == v) ||
            (s->winged[e][0] == v && s->winged[e][1] == u))
            return e;
    return -1;
}

static int32_t half_row(const struct sample *s, int32_t u, int32_t v)
{
    int32_t face = face_of_step(s, u, v);
    for (int32_t h = 0; h < s->half_count; h++)
        if (s->half[h][HALF_ORIGIN] == u && s->half[h][HALF_FACE] == face)
            return h;
    return -1;
}

static void right_winged(const struct sample *s, int32_t u, int32_t v, int32_t row[8])
{
    int32_t cd = face_of_step(s, u, v), ci = face_of_step(s, v, u);
    const int32_t right[8] = {u,
                              v,
                              cd,
                              ci,
                              cd < 0 ? -1 : winged_row(s, step_back(s, u, v), u),
                              cd < 0 ? -1 : winged_row(s, v, step_on(s, u, v)),
                              ci < 0 ? -1 : winged_row(s, step_back(s, v, u), v),
                              ci < 0 ? -1 : winged_row(s, u, step_on(s, v, u))};
    memcpy(row, right, sizeof right);
}

static void right_half(const struct sample *s, int32_t u, int32_t v, int32_t row[5])
{
    row[HALF_ORIGIN] = u;
    row[HALF_FACE] = face_of_step(s, u, v);
    row[HALF_TWIN] = half_row(s, v, u);
    row[HALF_NEXT] = half_row(s, v, step_on(s, u, v));
    row[HALF_PREVIOUS] = half_row(s, step_back(s, u, v), u);
}

static bool is_edge(const struct sample *s, int32_t u, int32_t v)
{
    return face_of_step(s, u, v) >= 0 || face_of_step(s, v, u) >= 0;
}

static int32_t count_edges(const struct sample *s)
{
    int32_t count = 0;
    for (int32_t u = 0; u < s->table.vertex_count; u++)
        for (int32_t v = 0; v < u; v++)
            count += is_edge(s, u, v);
    return count;
}

static bool is_used(const struct sample *s, int32_t v)
{
    for (int32_t f = 0; f < s->table.face_count; f++)
        if (corner_of(s, f, v) >= 0)
            return true;
    return false;
}

static bool winged_is_right(const struct sample *s)
{
    if (s->edge_count != count_edges(s))
        return false;
    for (int32_t e = 0; e < s->edge_count; e++) {
        int32_t u = s->winged[e][0], v = s->winged[e][1], row[8];
        if (u < 0 || v < 0 || u >= s->table.vertex_count || v >= s->table.vertex_count ||
            !is_edge(s, u, v) || winged_row(s, u, v) != e)
            return false;
        right_winged(s, u, v, row);
        if (memcmp(row, s->winged[e], sizeof row))
            return false;
    }
    for (int32_t v = 0; v < s->table.vertex_count; v++) {
        int32_t e = s->vertex_edge[v];
        if (!is_used(s, v)
                ? e != -1
                : e < 0 || e >= s->edge_count || (s->winged[e][0] != v && s->winged[e][1] != v))
            return false;
    }
    for (int32_t f = 0; f < s->table.face_count; f++) {
        int32_t e = s->face_edge[f];
        if (e < 0 || e >= s->edge_count || (s->winged[e][2] != f && s->winged[e][3] != f))
            return false;
    }
    return true;
}

/* The end of a half edge, by its face or its hole. */
static int32_t half_end(const struct sample *s, int32_t h)
{
    int32_t u = s->half[h][HALF_ORIGIN], face = s->half[h][HALF_FACE];
    if (u < 0 || u >= s->table.vertex_count || face < -1 || face >= s->table.face_count)
        return -1;
    if (face >= 0)
        return corner_of(s, face, u) < 0 ? -1 : after(s, face, u, 1);
    for (int32_t w = 0; w < s->table.vertex_count; w++)
        if (face_of_step(s, w, u) >= 0 && face_of_step(s, u, w) < 0)
            return w;
    return -1;
}

static bool half_is_right(const struct sample *s)
{
    if (s->half_count != 2 * count_edges(s))
        return false;
    for (int32_t h = 0; h < s->half_count; h++) {
        int32_t v = half_end(s, h), row[5];
        if (v < 0 || half_row(s, s->half[h][HALF_ORIGIN], v) != h)
            return false;
        right_half(s, s->half[h][HALF_ORIGIN], v, row);
        if (memcmp(row, s->half[h], sizeof row))
            return false;
    }
    for (int32_t v = 0; v < s->table.vertex_count; v++) {
        int32_t h = s->vertex_half[v];
        if (!is_used(s, v) ? h != -1 : h < 0 || h >= s->half_count || s->half[h][HALF_ORIGIN] != v)
            return false;
    }
    for (int32_t f = 0; f < s->table.face_count; f++) {
        int32_t h = s->face_half[f];
        if (h < 0 || h >= s->half_count || s->half[h][HALF_FACE] != f)
            return false;
    }
    return true;
}

/* -- samples ---------------------------------------------------------------------------------- */

/* Fills the tables, rows in random order, winged edges in random directions. */
static void fill_tables(struct sample *s, struct random *rng)
{
    int32_t order[2 * MOST_CORNERS], at = 0;
    s->edge_count = count_edges(s);
    s->half_count = 2 * s->edge_count;
    random_permutation(rng, order, s->edge_count);
    for (int32_t u = 0; u < s->table.vertex_count; u++)
        for (int32_t v = 0; v < u; v++)
            if (is_edge(s, u, v)) {
                bool swap = random_below(rng, 2);
                int32_t *row = s->winged[order[at++]];
                row[0] = swap ? v : u;
                row[1] = swap ? u : v;
            }
    for (int32_t e = 0; e < s->edge_count; e++)
        right_winged(s, s->winged[e][0], s->winged[e][1], s->winged[e]);
    random_permutation(rng, order, s->half_count);
    for (int32_t e = 0; e < s->edge_count; e++)
        for (int way = 0; way < 2; way++) {
            int32_t *row = s->half[order[2 * e + way]];
            row[HALF_ORIGIN] = s->winged[e][way];
            row[HALF_FACE] = s->winged[e][2 + way];
        }
    for (int32_t h = 0; h < s->half_count; h++)
        right_half(s, s->half[h][HALF_ORIGIN], half_end(s, h), s->half[h]);
    for (int32_t v = 0; v < s->table.vertex_count; v++)
        s->vertex_edge[v] = s->vertex_half[v] = -1;
    for (int32_t e = 0; e < s->edge_count; e++)
        for (int end = 0; end < 2; end++) {
            s->vertex_edge[s->winged[e][end]] = e;
            if (s->winged[e][2 + end] >= 0)
                s->face_edge[s->winged[e][2 + end]] = e;
        }
    for (int32_t h = 0; h < s->half_count; h++) {
        s->vertex_half[s->half[h][HALF_ORIGIN]] = h;
        if (s->half[h][HALF_FACE] >= 0)
            s->face_half[s->half[h][HALF_FACE]] = h;
    }
}

static void finish(struct sample *s, int32_t face_count, int32_t vertex_count)
{
    s->table =
        (struct face_table){s->starts, s->corners, face_count, s->starts[face_count], vertex_count};
}

static void add_face(struct sample *s, int32_t *count, int corners, const int32_t *v)
{
    memcpy(s->corners + s->starts[*count], v, (size_t)corners * sizeof *v);
    s->starts[*count + 1] = s->starts[*count] + corners;
    ++*count;
}

/* A grid of quads, open or closed to a torus, some lost, some cut. May be non-manifold. */
static void random_surface(struct sample *s, struct random *rng)
{
    enum { SIDE = 4 };
    *s = (struct sample){.starts = {0}};
    bool is_torus = random_below(rng, 3) == 0;
    uint64_t loss = random_below(rng, 3) ? 100 : 5;
    int32_t count = 0;
    for (int32_t i = 0; i < SIDE; i++)
        for (int32_t j = 0; j < SIDE; j++) {
            int32_t last = is_torus ? SIDE : SIDE + 1, k = (i + 1) % last, l = (j + 1) % last;
            const int32_t quad[4] = {i * last + j, i * last + l, k * last + l, k * last + j};
            const int32_t other[3] = {quad[0], quad[2], quad[3]};
            if (random_below(rng, loss) == 0)
                continue;
            bool is_cut = random_below(rng, 3) == 0;
            add_face(s, &count, is_cut ? 3 : 4, quad);
            if (is_cut)
                add_face(s, &count, 3, other);
        }
    finish(s, count, (SIDE + 1) * (SIDE + 1));
}

static bool truth_of(const struct sample *s, struct structure_truth *truth)
{
    struct error err = {0};
    if (!structure_truth_build(&s->table, truth, &err))
        return true;
    assert_non_null(strstr(err.text, "cannot be held by a connected structure"));
    return false;
}

static struct structure_answer winged_answer(const struct sample *s)
{
    return (struct structure_answer){STRUCTURE_WINGED_EDGE, s->winged,      structure_winged_get,
                                     s->edge_count,         s->vertex_edge, s->face_edge};
}

static struct structure_answer half_answer(const struct sample *s)
{
    return (struct structure_answer){STRUCTURE_HALF_EDGE, s->half,        structure_half_get,
                                     s->half_count,       s->vertex_half, s->face_half};
}

static struct structure_fault compare(const struct structure_truth *truth,
                                      const struct structure_answer *answer)
{
    struct structure_fault fault;
    assert_int_equal(structure_compare(truth, answer, &fault, NULL), 0);
    struct message message;
    structure_fault_say(&fault, &message);
    assert_int_equal(message.en[0] != '\0', fault.kind != STRUCTURE_FINE);
    assert_int_equal(message.es[0] != '\0', fault.kind != STRUCTURE_FINE);
    assert_int_equal(structure_fault_cause(&fault) != NULL, fault.kind != STRUCTURE_FINE);
    return fault;
}

static bool is_accepted(const struct structure_truth *truth, const struct structure_answer *answer)
{
    struct structure_fault fault = compare(truth, answer);
    bool accepted = fault.kind == STRUCTURE_FINE;
    structure_fault_release(&fault);
    return accepted;
}

static void prism(struct sample *s)
{
    *s = (struct sample){.edge_count = PRISM_EDGES, .half_count = PRISM_HALF_EDGES};
    memcpy(s->corners, prism_polygons.corners, PRISM_HALF_EDGES * sizeof *s->corners);
    memcpy(s->starts, prism_polygons.face_starts, (PRISM_FACES + 1) * sizeof *s->starts);
    /* The tables number faces as the document does, not as it reads them. */
    int32_t count = 0;
    for (int32_t face = 0; face < PRISM_FACES; face++)
        for (int32_t read = 0; read < PRISM_FACES; read++)
            if (prism_reading[read] == face) {
                int32_t start = prism_polygons.face_starts[read];
                add_face(s, &count, prism_polygons.face_starts[read + 1] - start,
                         prism_polygons.corners + start);
            }
    finish(s, PRISM_FACES, PRISM_VERTICES);
    memcpy(s->winged, prism_winged_edges, sizeof prism_winged_edges);
    memcpy(s->vertex_edge, prism_vertex_edge, sizeof prism_vertex_edge);
    memcpy(s->face_edge, prism_face_edge, sizeof prism_face_edge);
    for (int32_t h = 0; h < PRISM_HALF_EDGES; h++) {
        s->half[h][HALF_ORIGIN] = prism_half_edges[h][0];
        s->half[h][HALF_TWIN] = (h + 9) % 18;
        s->half[h][HALF_FACE] = prism_half_edges[h][3];
        s->half[h][HALF_PREVIOUS] = prism_half_edge_links[h][0];
        s->half[h][HALF_NEXT] = prism_half_edge_links[h][1];
        s->vertex_half[s->half[h][HALF_ORIGIN]] = h;
        s->face_half[s->half[h][HALF_FACE]] = h;
    }
}

/* -- tests ------------------------------------------------------------------------------------ */

/* Changes each entry to every other small number: each is refused, and told at its place when it is
 * a link. */
static void change_entries(const struct structure_truth *truth,
                           const struct structure_answer *answer, int32_t *entries, int rows,
                           int columns, int first_link, int64_t limit)
{
    int told = 0, changed = 0;
    for (int i = 0; i < rows * columns; i++)
        for (int32_t value = -2; value <= limit; value++) {
            int32_t was = entries[i];
            if (value == was)
                continue;
            entries[i] = value;
            struct structure_fault fault = compare(truth, answer);
            assert_int_not_equal(fault.kind, STRUCTURE_FINE);
            bool is_told = fault.kind == STRUCTURE_WRONG_ENTRY && fault.row == i / columns &&
                           fault.column == i % columns && fault.found == value &&
                           fault.wanted_count == 1 && fault.wanted[0] == was;
            if (answer->kind == STRUCTURE_WINGED_EDGE && i % columns >= first_link)
                assert_true(is_told);
            told += is_told;
            changed++;
            structure_fault_release(&fault);
            entries[i] = was;
        }
    assert_true(100 * told >= 99 * changed);
}

static void every_change_of_the_prism_is_refused(void **state)
{
    (void)state;
    struct sample s;
    struct structure_truth truth;
    prism(&s);
    assert_true(truth_of(&s, &truth));
    struct structure_answer answer = winged_answer(&s);
    assert_true(winged_is_right(&s));
    assert_true(is_accepted(&truth, &answer));
    change_entries(&truth, &answer, s.winged[0], PRISM_EDGES, 8, WINGED_CD, PRISM_EDGES + 1);
    answer = half_answer(&s);
    assert_true(half_is_right(&s));
    assert_true(is_accepted(&truth, &answer));
    change_entries(&truth, &answer, s.half[0], PRISM_HALF_EDGES, 5, 0, PRISM_HALF_EDGES + 1);
    structure_truth_release(&truth);
    structure_truth_release(&truth);
}

static void faults_have_words(void **state)
{
    (void)state;
    struct sample s;
    struct structure_truth truth;
    prism(&s);
    assert_true(truth_of(&s, &truth));
    struct structure_answer answer = winged_answer(&s);
    s.winged[3][WINGED_AIS] = 5;
    struct structure_fault fault = compare(&truth, &answer);
    struct message message;
    structure_fault_say(&fault, &message);
    assert_string_equal(message.en, "ais of edge 3 (3,0) is 5; right is 7");
    assert_string_equal(message.es, "ais de la arista 3 (3,0) es 5; lo correcto es 7");
    assert_ptr_equal(structure_fault_cause(&fault), &structure_wrong_link);
    assert_int_equal(fault.column_counts[WINGED_AIS], 1);
    structure_fault_release(&fault);
    s.winged[3][WINGED_AIS] = INT32_MIN;
    fault = compare(&truth, &answer);
    assert_ptr_equal(structure_fault_cause(&fault), &structure_out_of_range);
    structure_fault_release(&fault);
    prism(&s);
    s.vertex_edge[1] = -1;
    fault = compare(&truth, &answer);
    structure_fault_say(&fault, &message);
    assert_string_equal(message.en, "vertex_edge[1] is NONE; right is any of 0, 1, 4");
    structure_fault_release(&fault);
    prism(&s);
    answer.row_count = 8;
    fault = compare(&truth, &answer);
    structure_fault_say(&fault, &message);
    assert_string_equal(message.en, "edge (5,0) is missing");
    assert_string_equal(message.es, "falta la arista (5,0)");
    structure_fault_release(&fault);
    answer.row_count = 9;
    memcpy(s.winged[8], s.winged[2], sizeof s.winged[2]);
    fault = compare(&truth, &answer);
    structure_fault_say(&fault, &message);
    assert_string_equal(message.en, "edge 8 (2,3) is in row 2 too");
    assert_int_equal(fault.missing_count, 1);
    structure_fault_release(&fault);
    structure_truth_release(&truth);
}

/* One entry or a few, changed to something near or to garbage. */
static void damage(int32_t *entries, uint64_t count, struct random *rng)
{
    static const int32_t wild[] = {INT32_MIN, INT32_MAX, -1, -2, 0};
    uint64_t times = random_below(rng, 4) ? 1 : 1 + random_below(rng, count);
    for (; count > 0 && times > 0; times--)
        entries[random_below(rng, count)] =
            random_below(rng, 5) ? (int32_t)random_below(rng, 70) : wild[random_below(rng, 5)];
}

static void random_surfaces_are_judged_as_slowly(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 51);
    static struct sample s, kept;
    int surfaces = 0, still_right = 0;
    for (int trial = 0; trial < 120; trial++) {
        struct structure_truth truth;
        random_surface(&s, &rng);
        if (!truth_of(&s, &truth))
            continue;
        surfaces++;
        fill_tables(&s, &rng);
        assert_true(winged_is_right(&s) && half_is_right(&s));
        struct structure_answer winged = winged_answer(&s), half = half_answer(&s);
        assert_true(is_accepted(&truth, &winged));
        assert_true(is_accepted(&truth, &half));
        kept = s;
        for (int change = 0; change < 30; change++) {
            int which = (int)random_below(&rng, 6);
            int32_t *tables[] = {s.winged[0], s.half[0],     s.vertex_edge,
                                 s.face_edge, s.vertex_half, s.face_half};
            const int64_t counts[] = {8 * s.edge_count,     5 * s.half_count,
                                      s.table.vertex_count, s.table.face_count,
                                      s.table.vertex_count, s.table.face_count};
            damage(tables[which], (uint64_t)counts[which], &rng);
            bool is_right = winged_is_right(&s) && half_is_right(&s);
            assert_int_equal(is_accepted(&truth, &winged) && is_accepted(&truth, &half), is_right);
            still_right += is_right;
            s = kept;
        }
        structure_truth_release(&truth);
    }
    assert_true(surfaces > 40);
    assert_true(still_right > 10);
}

static void garbage_is_bounded(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 52);
    struct sample s;
    struct structure_truth truth;
    prism(&s);
    assert_true(truth_of(&s, &truth));
    for (int trial = 0; trial < 3000; trial++) {
        int32_t rows = (int32_t)random_below(&rng, 40);
        int32_t *table = malloc(8 * (size_t)rows * sizeof *table + 1);
        int32_t beside[PRISM_VERTICES];
        assert_non_null(table);
        for (int32_t i = 0; i < 8 * rows; i++)
            table[i] = random_below(&rng, 3) ? (int32_t)random_below(&rng, 9) - 1
                                             : (int32_t)random_next(&rng);
        for (int32_t i = 0; i < PRISM_VERTICES; i++)
            beside[i] = (int32_t)random_next(&rng);
        struct structure_answer winged = {
            STRUCTURE_WINGED_EDGE, table, structure_winged_get, rows, beside, beside};
        struct structure_answer half = {
            STRUCTURE_HALF_EDGE, table, structure_half_get, rows, beside, beside};
        assert_false(is_accepted(&truth, &winged));
        assert_false(is_accepted(&truth, &half));
        free(table);
    }
    struct structure_answer negative = {
        STRUCTURE_HALF_EDGE, NULL, structure_half_get, -1, NULL, NULL};
    struct structure_fault fault;
    assert_int_equal(structure_compare(&truth, &negative, &fault, NULL), -1);
    structure_truth_release(&truth);
}

/* A polygon of many corners and rows that all claim it: quadratic searches would not end. */
static void a_large_polygon_is_no_trouble(void **state)
{
    (void)state;
    enum { COUNT = 100000 };
    int32_t *corners = malloc(COUNT * sizeof *corners);
    int32_t *rows = calloc(5 * (size_t)COUNT, sizeof *rows);
    assert_true(corners && rows);
    for (int32_t i = 0; i < COUNT; i++)
        corners[i] = COUNT - 1 - i;
    const int32_t starts[] = {0, COUNT};
    struct face_table table = {starts, corners, 1, COUNT, COUNT};
    struct structure_truth truth;
    assert_int_equal(structure_truth_build(&table, &truth, NULL), 0);
    struct structure_answer answer = {
        STRUCTURE_HALF_EDGE, rows, structure_half_get, COUNT, NULL, NULL};
    struct structure_fault fault = compare(&truth, &answer);
    assert_int_equal(fault.repeated_count, COUNT - 1);
    assert_int_equal(fault.missing_count, 2 * COUNT - 1);
    structure_fault_release(&fault);
    structure_truth_release(&truth);
    free(corners);
    free(rows);
}

static void other_faces_are_our_error(void **state)
{
    (void)state;
    struct structure_truth truth;
    struct error err = {0};
    const int32_t incoherent[] = {0, 1, 2, 0, 1, 3}, bow_tie[] = {0, 1, 2, 2, 3, 4},
                  broken[] = {0, 1, 9};
    struct face_table table = {NULL, incoherent, 2, 6, 4};
    assert_int_equal(structure_truth_build(&table, &truth, &err), -1);
    assert_non_null(strstr(err.text, "not coherent"));
    table = (struct face_table){NULL, bow_tie, 2, 6, 5};
    assert_int_equal(structure_truth_build(&table, &truth, NULL), -1);
    table = (struct face_table){NULL, broken, 1, 3, 5};
    assert_int_equal(structure_truth_build(&table, &truth, NULL), -1);
    table = (struct face_table){NULL, NULL, 0, 0, 2};
    assert_int_equal(structure_truth_build(&table, &truth, NULL), 0);
    const int32_t none[] = {-1, -1}, some[] = {-1, 0};
    struct structure_answer answer = {STRUCTURE_HALF_EDGE, NULL, structure_half_get, 0, none, NULL};
    assert_true(is_accepted(&truth, &answer));
    answer.of_vertex = some;
    struct structure_fault fault = compare(&truth, &answer);
    struct message message;
    structure_fault_say(&fault, &message);
    assert_string_equal(message.en, "vertex_half_edge[1] is 0; right is NONE");
    structure_fault_release(&fault);
    structure_truth_release(&truth);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_change_of_the_prism_is_refused),
        cmocka_unit_test(faults_have_words),
        cmocka_unit_test(random_surfaces_are_judged_as_slowly),
        cmocka_unit_test(garbage_is_bounded),
        cmocka_unit_test(a_large_polygon_is_no_trouble),
        cmocka_unit_test(other_faces_are_our_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
