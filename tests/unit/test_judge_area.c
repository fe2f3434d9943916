/* The judge of the area: its own sum against areas known by formula, answers of every kind, and
 * known submissions. */
#include "graders/library/judge.h"
#include "graders/library/mesh_area.h"
#include "reference/base/random.h"
#include "reference/mesh/generate.h"
#include "tests/unit/submissions.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

extern const struct judge judge_mesh_area;

static void assert_area(const struct mesh *mesh, double wanted, double relative_error)
{
    struct mesh_view view = mesh_input_view(mesh);
    double area = mesh_area_exact(&view);
    if (!(fabs(area - wanted) <= relative_error * wanted))
        fail_msg("the area is %.17g, wanted %.17g", area, wanted);
}

static void areas_known_by_formula_come_out(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_cube(&mesh, NULL), 0);
    assert_area(&mesh, 6, 0);
    change_translate(&mesh, 1e6F, -1e6F, 1e6F); /* the corners are exact there too */
    assert_area(&mesh, 6, 0);
    change_scale(&mesh, 0x1p-40F);
    assert_area(&mesh, 6 * 0x1p-80, 0);
    mesh_release(&mesh);
    assert_int_equal(generate_tetrahedron(&mesh, NULL), 0);
    assert_area(&mesh, 2 * sqrt(3), 1e-15);
    mesh_release(&mesh);
    assert_int_equal(generate_icosphere(&mesh, 6, NULL), 0);
    assert_area(&mesh, M_PI, 1e-3); /* inscribed */
    mesh_release(&mesh);
    assert_int_equal(generate_empty(&mesh, NULL), 0);
    assert_area(&mesh, 0, 0);
}

/* Needles lie along x with one height: their bases tell the area. */
static void needles_keep_their_digits(void **state)
{
    (void)state;
    static const double ratios[] = {1, 1e-3, 1e-6, 1e-9};
    for (size_t i = 0; i < sizeof ratios / sizeof *ratios; i++) {
        struct mesh mesh;
        double bases = 0;
        assert_int_equal(generate_needles(&mesh, 500, ratios[i], 1, NULL), 0);
        for (int32_t t = 0; t < mesh.triangle_count; t++)
            bases += (double)mesh.positions[3 * (t + 2)] - (double)mesh.positions[3 * t];
        double height = (double)mesh.positions[4];
        assert_area(&mesh, bases * height / 2, 1e-12);
        mesh_release(&mesh);
    }
}

static void order_and_orientation_do_not_matter(void **state)
{
    (void)state;
    struct mesh mesh;
    assert_int_equal(generate_torus(&mesh, 3, 5000, NULL), 0);
    struct mesh_view view = mesh_input_view(&mesh);
    double area = mesh_area_exact(&view);
    for (uint64_t seed = 0; seed < 10; seed++) {
        assert_int_equal(change_scramble(&mesh, seed, NULL), 0);
        assert_int_equal(change_flip(&mesh, 0.5, seed, NULL), 0);
        assert_area(&mesh, area, 1e-15);
    }
    mesh_release(&mesh);
}

/* -------------------------------------------------------------------------------------- answers */

static bool judge_packet(const struct writer *input, const void *bytes, size_t count,
                         struct judgement *judgement)
{
    struct error err = {0};
    *judgement = (struct judgement){0};
    struct span in = {input->bytes, input->count}, answer = {bytes, count};
    assert_int_equal(judge_answer(&judge_mesh_area, in, answer, NULL, judgement, &err), 0);
    if (!judgement->accepted) {
        assert_true(judgement->cause[0] && judgement->message.en[0] && judgement->message.es[0]);
        assert_true(strlen(judgement->message.en) + 1 < sizeof judgement->message.en);
        assert_true(strlen(judgement->message.es) + 1 < sizeof judgement->message.es);
    }
    json_t *scene = scene_to_json(&judgement->scene);
    assert_non_null(scene);
    json_decref(scene);
    scene_release(&judgement->scene);
    return judgement->accepted;
}

static void make_input(const struct judge_case *c, struct writer *input)
{
    struct error err = {0};
    *input = writer_growing();
    if (judge_make(&judge_mesh_area, c, "exercises/models", input, &err))
        fail_msg("%s", err.text);
}

static const struct judge_case cube = {.name = "cube", .mesh = {SHAPE_CUBE}};
static const struct judge_case points = {.name = "points",
                                         .mesh = {SHAPE_POINT_TRIANGLES, .count = 3}};
static const struct judge_case spiky = {.name = "spiky",
                                        .mesh = {SHAPE_CUBE, .changes = WITH_SPIKES}};

static struct mesh_view view_of(const struct writer *input)
{
    struct reader reader = reader_of(input->bytes, input->count);
    return mesh_input_read(&reader);
}

static void only_areas_within_the_tolerance_are_accepted(void **state)
{
    (void)state;
    static const struct {
        double area;
        bool accepted;
    } answers[] = {
        {6, true},
        {6 * (1 + 0.99e-6), true},
        {6 * (1 - 0.99e-6), true},
        {6 * (1 + 1.01e-6), false},
        {6 * (1 - 1.01e-6), false},
        {-6, false},
        {0, false},
        {-0.0, false},
        {(double)NAN, false},
        {-(double)NAN, false},
        {HUGE_VAL, false},
        {-HUGE_VAL, false},
        {1e308, false},
        {5e-324, false},
        {12, false},
    };
    struct writer input;
    struct judgement judgement;
    make_input(&cube, &input);
    for (size_t i = 0; i < sizeof answers / sizeof *answers; i++)
        assert_int_equal(judge_packet(&input, &answers[i].area, sizeof(double), &judgement),
                         answers[i].accepted);
    writer_release(&input);
    make_input(&points, &input);
    for (size_t i = 0; i < sizeof answers / sizeof *answers; i++)
        assert_int_equal(judge_packet(&input, &answers[i].area, sizeof(double), &judgement),
                         answers[i].area == 0);
    writer_release(&input);
}

static void any_bytes_are_survived(void **state)
{
    (void)state;
    struct random rng;
    struct writer input;
    struct judgement judgement;
    make_input(&spiky, &input);
    struct mesh_view view = view_of(&input);
    double exact = mesh_area_exact(&view);
    random_init(&rng, 1);
    for (int round = 0; round < 4000; round++) {
        double area = exact;
        unsigned char bytes[sizeof area];
        memcpy(bytes, &area, sizeof area);
        for (uint64_t changes = 1 + random_below(&rng, 3); changes > 0; changes--)
            bytes[random_below(&rng, sizeof bytes)] = (unsigned char)random_below(&rng, 256);
        memcpy(&area, bytes, sizeof area);
        bool is_right = isfinite(area) && fabs(area - exact) <= 1e-6 * exact;
        assert_int_equal(judge_packet(&input, bytes, sizeof bytes, &judgement), is_right);
        size_t cut = (size_t)random_below(&rng, sizeof bytes);
        assert_false(judge_packet(&input, bytes, cut, &judgement));
        assert_string_equal(judgement.cause, "malformed-answer");
    }
    writer_release(&input);
}

static void assert_says(const struct judge_case *c, double factor, const char *cause,
                        const char *in_message)
{
    struct writer input;
    struct judgement judgement;
    make_input(c, &input);
    struct mesh_view view = view_of(&input);
    double area = factor * mesh_area_exact(&view);
    assert_false(judge_packet(&input, &area, sizeof area, &judgement));
    assert_string_equal(judgement.cause, cause);
    if (!strstr(judgement.message.en, in_message))
        fail_msg("\"%s\" does not say \"%s\"", judgement.message.en, in_message);
    writer_release(&input);
}

static void usual_mistakes_are_guessed(void **state)
{
    (void)state;
    assert_says(&cube, 2, "wrong-area", "the area is 12 instead of 6: relative error 1");
    assert_says(&cube, 2, "wrong-area", "It is twice the area");
    assert_says(&cube, -1, "negative-area", "its sign reversed");
    assert_says(&cube, 11.0 / 12, "wrong-area", "The last triangle is missing");
    assert_says(&cube, 1.0 / 12, "wrong-area", "the mean area");
    assert_says(&cube, 0.7, "wrong-area", "allowed 1e-06.");
    assert_says(&spiky, (double)NAN, "not-a-number", "Triangle 12 has area 0");
    assert_says(&cube, HUGE_VAL, "not-a-number", "the area is infinity instead of 6");
}

/* What is not counted is marked when the area tells it; all pictures tell both areas. */
static void what_is_not_counted_is_shown(void **state)
{
    (void)state;
    const double areas[] = {1, 4.2};
    struct writer input;
    make_input(&cube, &input);
    for (int i = 0; i < 2; i++) {
        struct judgement judgement = {0};
        struct span answer = {(const unsigned char *)&areas[i], sizeof areas[i]};
        assert_int_equal(judge_answer(&judge_mesh_area, (struct span){input.bytes, input.count},
                                      answer, NULL, &judgement, NULL),
                         0);
        assert_int_equal(judgement.scene.kind, SCENE_MESH);
        assert_int_equal(judgement.scene.mark_count[MARK_MISSING], i == 0 ? 10 : 0);
        assert_int_equal(judgement.scene.ok_count, i == 0 ? 2 : -1);
        assert_int_equal(judgement.scene.fact_count, 2);
        assert_string_equal(judgement.scene.facts[0].value, "6");
        assert_string_equal(judgement.scene.facts[1].value, i == 0 ? "1" : "4.2");
        scene_release(&judgement.scene);
    }
    writer_release(&input);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas_known_by_formula_come_out),
        cmocka_unit_test(needles_keep_their_digits),
        cmocka_unit_test(order_and_orientation_do_not_matter),
        cmocka_unit_test(only_areas_within_the_tolerance_are_accepted),
        cmocka_unit_test(any_bytes_are_survived),
        cmocka_unit_test(usual_mistakes_are_guessed),
        cmocka_unit_test(what_is_not_counted_is_shown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
