/* Judges euler-closed-mesh (problem 4.4): exact numbers, and refusal of those that no mesh has. */
#include "graders/library/judge.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* As in the exercise's header. */
enum given { VERTICES, EDGES, FACES };
enum { ANSWERED = 0, IMPOSSIBLE = -1, ROW_NUMBERS = 4 };

static const struct phrase nouns[] = {
    {"vertices", "vértices"}, {"edges", "aristas"}, {"faces", "caras"}};

/* -------------------------------------------------------------------- cases */

/* A row: which number is given, and the number. Rows of the first three classes rise. */
#define ROWS(...)                                                                                  \
    {                                                                                              \
        (const int64_t[]){__VA_ARGS__}, sizeof((int64_t[]){__VA_ARGS__}) / 16                      \
    }
struct rows {
    const int64_t *pairs;
    int64_t count;
};
enum {
    ROWS_SOLIDS_V,
    ROWS_SOLIDS_E,
    ROWS_SOLIDS_F,
    ROWS_MESHES_V,
    ROWS_MESHES_E,
    ROWS_MESHES_F,
    ROWS_TOO_SMALL,
    ROWS_ODD,
    ROWS_LARGE,
    ROWS_BEYOND
};
static const struct rows row_sets[] = {
    /* tetrahedron, triangular bipyramid, octahedron, cube with diagonals, icosahedron */
    [ROWS_SOLIDS_V] = ROWS(VERTICES, 4, VERTICES, 5, VERTICES, 6, VERTICES, 8, VERTICES, 12),
    [ROWS_SOLIDS_E] = ROWS(EDGES, 6, EDGES, 9, EDGES, 12, EDGES, 18, EDGES, 30),
    [ROWS_SOLIDS_F] = ROWS(FACES, 4, FACES, 6, FACES, 8, FACES, 12, FACES, 20),
    /* bipyramid of 5, icospheres of 1 to 6 subdivisions with uv-spheres between them */
    [ROWS_MESHES_V] = ROWS(VERTICES, 7, VERTICES, 42, VERTICES, 162, VERTICES, 226, VERTICES, 642,
                           VERTICES, 2562, VERTICES, 10242, VERTICES, 40962, VERTICES, 1000002),
    [ROWS_MESHES_E] = ROWS(EDGES, 15, EDGES, 120, EDGES, 480, EDGES, 672, EDGES, 1920, EDGES, 7680,
                           EDGES, 30720, EDGES, 122880, EDGES, 3000000),
    [ROWS_MESHES_F] = ROWS(FACES, 10, FACES, 80, FACES, 320, FACES, 448, FACES, 1280, FACES, 5120,
                           FACES, 20480, FACES, 81920, FACES, 2000000),
    [ROWS_TOO_SMALL] =
        ROWS(VERTICES, 3, VERTICES, 2, VERTICES, 1, VERTICES, 0, VERTICES, -1, EDGES, 3, EDGES, 0,
             EDGES, -6, FACES, 2, FACES, 0, FACES, -4, VERTICES, -1000000, EDGES, -9, FACES, -2),
    [ROWS_ODD] =
        ROWS(FACES, 5, FACES, 7, FACES, 3, FACES, 1, FACES, -1, FACES, 1000001, EDGES, 7, EDGES, 8,
             EDGES, 10, EDGES, 4, EDGES, 5, EDGES, 1, EDGES, 1000000, EDGES, 999998),
    [ROWS_LARGE] =
        ROWS(VERTICES, 715827885, VERTICES, 1073741826, VERTICES, 2147483647, VERTICES, 2147483648,
             EDGES, 3221225472, FACES, 4294967296, FACES, 6000000000, EDGES, 9007199254740993,
             VERTICES, 9007199254740993, FACES, 9007199254740994, VERTICES, 3074457345618258604,
             EDGES, 9223372036854775806, FACES, 6148914691236517204),
    [ROWS_BEYOND] =
        ROWS(VERTICES, 3074457345618258605, VERTICES, 4611686018427387906, VERTICES,
             6148914691236517207, VERTICES, INT64_MAX, FACES, 6148914691236517206, FACES,
             INT64_MAX - 1, VERTICES, INT64_MIN, EDGES, INT64_MIN, FACES, INT64_MIN)};

static const struct judge_case cases[] = {
    {"solids-by-vertices", "vertices", 1, PUBLIC | QUICK, .number = {ROWS_SOLIDS_V}},
    {"meshes-by-vertices", "vertices", 2, QUICK, .number = {ROWS_MESHES_V}},
    {"solids-by-edges", "edges", 3, PUBLIC | QUICK, .number = {ROWS_SOLIDS_E}},
    {"meshes-by-edges", "edges", 4, QUICK, .number = {ROWS_MESHES_E}},
    {"solids-by-faces", "faces", 5, PUBLIC | QUICK, .number = {ROWS_SOLIDS_F}},
    {"meshes-by-faces", "faces", 6, QUICK, .number = {ROWS_MESHES_F}},
    {"too-small", "impossible", 7, PUBLIC | QUICK, .number = {ROWS_TOO_SMALL}},
    {"odd-faces-and-edges", "impossible", 8, QUICK, .number = {ROWS_ODD}},
    {"beyond-32-bits", "large", 9, PUBLIC | QUICK, .number = {ROWS_LARGE}},
    {"beyond-64-bits", "overflow", 10, QUICK, .number = {ROWS_BEYOND}},
};

static int make(const struct judge_case *c, const char *models, struct writer *input,
                struct error *err)
{
    (void)models;
    const struct rows *rows = &row_sets[c->number[0]];
    write_int(input, rows->count);
    write_array(input, rows->pairs, rows->count, 2 * sizeof *rows->pairs);
    return input->failed ? error_set(err, "out of memory for case %s", c->name) : 0;
}

/* -------------------------------------------------------------------- truth */

/* Status and the three numbers, as an answer holds them. */
static void right_answer(enum given given, int64_t count, int64_t answer[ROW_NUMBERS])
{
    static const int64_t step[] = {1, 3, 2}; /* what one vertex more adds */
    memset(answer, 0, ROW_NUMBERS * sizeof *answer);
    answer[0] = IMPOSSIBLE;
    int64_t above = given == VERTICES          ? count
                    : count % step[given] == 0 ? count / step[given] + 2
                                               : 0;
    if (above < 4 || above - 2 > INT64_MAX / 3)
        return;
    answer[0] = ANSWERED;
    answer[1] = above;
    answer[2] = 3 * (above - 2);
    answer[3] = 2 * (above - 2);
}

static bool agrees(const int64_t *answer, const int64_t *right)
{
    if (right[0] == IMPOSSIBLE)
        return answer[0] == IMPOSSIBLE;
    return memcmp(answer, right, ROW_NUMBERS * sizeof *right) == 0;
}

/* -------------------------------------------------------------- explanations */

static const struct cause malformed = {"malformed-answer",
                                       {"incomplete answer", "respuesta incompleta"}};
static const struct cause unknown_status = {"unknown-status",
                                            {"unknown status", "estado desconocido"}};
static const struct cause refused = {"refused", {"refused", "rechazada"}};
static const struct cause overflow_accepted = {"overflow-accepted",
                                               {"overflow accepted", "desbordamiento aceptado"}};
static const struct cause impossible_accepted = {
    "impossible-accepted", {"impossible mesh accepted", "malla imposible aceptada"}};

/* Whether another number would be needed that no int64_t holds, of a count that is no problem
 * otherwise. */
static bool overflows(enum given given, int64_t count)
{
    return given == VERTICES ? count >= 4 : given == FACES && count >= 4 && count % 2 == 0;
}

static void reject_status(enum given given, int64_t count, const int64_t *answer,
                          const int64_t *right, struct judgement *out)
{
    struct phrase noun = nouns[given];
    if (answer[0] != ANSWERED && answer[0] != IMPOSSIBLE) {
        judge_reject_for(out, &unknown_status);
        judge_en(out,
                 "For %" PRId64 " %s the function returned %" PRId64 ", neither 0 nor IMPOSSIBLE.",
                 count, noun.en, answer[0]);
        judge_es(out, "Con %" PRId64 " %s la función ha devuelto %" PRId64 ", ni 0 ni IMPOSSIBLE.",
                 count, noun.es, answer[0]);
    } else if (right[0] == ANSWERED) {
        judge_reject_for(out, &refused);
        judge_en(out, "There is a mesh with %" PRId64 " %s, but the function returned IMPOSSIBLE.",
                 count, noun.en);
        judge_es(out, "Hay una malla con %" PRId64 " %s, pero la función ha devuelto IMPOSSIBLE.",
                 count, noun.es);
    } else if (overflows(given, count)) {
        judge_reject_for(out, &overflow_accepted);
        judge_en(out,
                 "With %" PRId64 " %s another number does not fit into an int64_t: the answer "
                 "is IMPOSSIBLE.",
                 count, noun.en);
        judge_es(out,
                 "Con %" PRId64 " %s otro de los números no cabe en un int64_t: la respuesta "
                 "es IMPOSSIBLE.",
                 count, noun.es);
    } else {
        judge_reject_for(out, &impossible_accepted);
        judge_en(out,
                 "No closed simply connected mesh has %" PRId64 " %s: the answer is IMPOSSIBLE.",
                 count, noun.en);
        judge_es(out,
                 "Ninguna malla cerrada simplemente conexa tiene %" PRId64
                 " %s: la respuesta es IMPOSSIBLE.",
                 count, noun.es);
    }
}

/* A cause, and the sentence that says why; each is computed from the numbers that it names. */
struct reason {
    struct cause cause;
    struct phrase hint;
};

static const struct reason exchanged = {
    {"exchanged", {"exchanged", "cambiadas"}},
    {"Edges and faces are exchanged.", "Aristas y caras están cambiadas."}};
static const struct reason as_torus = {{"torus", {"torus", "toro"}},
                                       {"V - E + F is 0, as on a torus; here it must be 2.",
                                        "V - E + F es 0, como en un toro; aquí tiene que ser 2."}};
static const struct reason overflow = {
    {"overflow", {"overflow", "desbordamiento"}},
    {"The number does not fit into 32 bits.", "El número no cabe en 32 bits."}};
static const struct reason not_euler = {
    {"not-euler", {"not Euler's formula", "no es la fórmula de Euler"}},
    {"V - E + F is not 2.", "V - E + F no es 2."}};
static const struct reason not_triangles = {
    {"not-triangles", {"not triangles", "no son triángulos"}},
    {"Euler's formula holds, but 3F is not 2E.",
     "Se cumple la fórmula de Euler, pero 3F no es 2E."}};
static const struct reason other_mesh = {
    {"other-mesh", {"numbers of another mesh", "números de otra malla"}},
    {"These are the numbers of another mesh: the count that was given is not among them.",
     "Son los números de otra malla: el dado no está entre ellos."}};

static const struct reason *reason_for(const int64_t *answer, const int64_t *right)
{
    uint64_t v = (uint64_t)answer[1], e = (uint64_t)answer[2], f = (uint64_t)answer[3];
    uint64_t characteristic = v - e + f;
    if (answer[1] == right[1] && answer[2] == right[3] && answer[3] == right[2])
        return &exchanged;
    if (characteristic == 0)
        return &as_torus;
    for (int i = 1; i < ROW_NUMBERS; i++)
        if (right[i] > INT32_MAX && (uint32_t)answer[i] == (uint32_t)right[i] &&
            answer[i] != right[i])
            return &overflow;
    if (characteristic != 2)
        return &not_euler;
    return 3 * f != 2 * e ? &not_triangles : &other_mesh;
}

static void reject_numbers(enum given given, int64_t count, const int64_t *answer,
                           const int64_t *right, struct judgement *out)
{
    const struct reason *reason = reason_for(answer, right);
    judge_reject_for(out, &reason->cause);
    judge_en(out, "For %" PRId64 " %s: ", count, nouns[given].en);
    judge_es(out, "Con %" PRId64 " %s: ", count, nouns[given].es);
    message_add(&out->message,
                "V = %" PRId64 ", E = %" PRId64 ", F = %" PRId64 "; right is V = %" PRId64
                ", E = %" PRId64 ", F = %" PRId64 ".",
                "V = %" PRId64 ", E = %" PRId64 ", F = %" PRId64 "; lo correcto es V = %" PRId64
                ", E = %" PRId64 ", F = %" PRId64 ".",
                answer[1], answer[2], answer[3], right[1], right[2], right[3]);
    judge_hint(out, reason->hint);
}

/* -------------------------------------------------------------------- chart */

/* One curve of number `which` (1 V, 2 E, 3 F) over the given number; what is not positive is left
 * out. answers NULL: the right numbers. */
static int add_curve(struct scene *scene, const char *name, const int64_t *rows, int64_t row_count,
                     const int64_t *answers, int which, struct error *err)
{
    double *x = calloc(2 * (size_t)row_count + 1, sizeof *x);
    if (!x)
        return error_set(err, "out of memory for a chart of %" PRId64 " points", row_count);
    double *y = x + row_count;
    int count = 0;
    for (int64_t i = 0; i < row_count; i++) {
        int64_t row[ROW_NUMBERS];
        if (answers)
            memcpy(row, answers + ROW_NUMBERS * i, sizeof row);
        else
            right_answer((enum given)rows[2 * i], rows[2 * i + 1], row);
        if (row[0] != ANSWERED || row[which] <= 0)
            continue;
        x[count] = (double)rows[2 * i + 1];
        y[count++] = (double)row[which];
    }
    int failed = count > 0 ? scene_add_curve(scene, name, x, y, count, 0, err) : 0;
    free(x);
    return failed;
}

/* Charts the first wrong number where all rows give the same number and each has a mesh. */
static int show_curves(const int64_t *rows, int64_t row_count, const int64_t *answers,
                       int64_t first, struct scene *scene, struct error *err)
{
    int64_t right[ROW_NUMBERS];
    for (int64_t i = 0; i < row_count; i++) {
        right_answer((enum given)rows[2 * i], rows[2 * i + 1], right);
        if (rows[2 * i] != rows[0] || right[0] != ANSWERED)
            return 0;
    }
    right_answer((enum given)rows[2 * first], rows[2 * first + 1], right);
    int which = 1;
    while (which < ROW_NUMBERS - 1 && answers[ROW_NUMBERS * first + which] == right[which])
        which++;
    snprintf(scene->x_label, sizeof scene->x_label, "%s", nouns[rows[0]].en);
    snprintf(scene->y_label, sizeof scene->y_label, "%s", nouns[which - 1].en);
    if (add_curve(scene, "submission", rows, row_count, answers, which, err))
        return -1;
    return add_curve(scene, "right", rows, row_count, NULL, which, err);
}

/* -------------------------------------------------------------------- judge */

static int judge(const struct task *task, struct judgement *out, struct error *err)
{
    struct reader in = reader_of(task->input.bytes, task->input.count);
    struct reader said = reader_of(task->said.bytes, task->said.count);
    int64_t row_count = read_int(&in);
    const int64_t *rows = read_array(&in, row_count, 2 * sizeof *rows);
    const int64_t *answers = read_array(&said, row_count, ROW_NUMBERS * sizeof *answers);
    if (!rows)
        return error_set(err, "the input of euler-closed-mesh is broken");
    if (!answers) {
        judge_reject(out, &malformed, "The answer is incomplete.", "La respuesta está incompleta.");
        return 0;
    }
    for (int64_t i = 0; i < row_count; i++) {
        const int64_t *row = answers + ROW_NUMBERS * i;
        int64_t right[ROW_NUMBERS];
        enum given given = (enum given)rows[2 * i];
        right_answer(given, rows[2 * i + 1], right);
        if (agrees(row, right))
            continue;
        judge_name(out, "%" PRId64 " ", "%" PRId64 " ", rows[2 * i + 1]);
        message_add_phrase(&out->element, nouns[given]);
        if (row[0] != right[0])
            reject_status(given, rows[2 * i + 1], row, right, out);
        else
            reject_numbers(given, rows[2 * i + 1], row, right, out);
        return show_curves(rows, row_count, answers, i, &out->scene, err);
    }
    judge_accept(out);
    return 0;
}

static size_t bound(struct span input)
{
    struct reader in = reader_of(input.bytes, input.count);
    return (size_t)read_int(&in) * ROW_NUMBERS * sizeof(int64_t);
}

const struct judge judge_euler_closed_mesh = {
    .exercise = "euler-closed-mesh",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .make = make,
    .judge = judge,
    .bound = bound,
};
