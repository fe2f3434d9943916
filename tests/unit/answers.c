/* Answers of any bytes; see answers.h. */
#include "tests/unit/answers.h"

#include "reference/base/random.h"
#include "tests/unit/submissions.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { ANSWER_BYTES_MAX = 1 << 16, INPUT_BYTES_MAX = 1 << 18, CHANGES_MAX = 4 };

static const uint64_t EXTREMES[] = {0,
                                    1,
                                    UINT64_MAX,
                                    INT64_MAX,
                                    (uint64_t)INT64_MAX + 1,
                                    INT32_MAX,
                                    0x80000000u,
                                    0xFFFFFFFFu,
                                    0x7FC000007FC00000u, /* two binary32 NaN */
                                    0x7FF8000000000000u, /* NaN */
                                    0x7F8000007F800000u, /* two binary32 infinities */
                                    0xFFF0000000000000u, /* minus infinity */
                                    0x7F7FFFFF7F7FFFFFu};
enum { EXTREME_COUNT = sizeof EXTREMES / sizeof *EXTREMES };

static void change_once(struct random *rng, unsigned char *bytes, size_t *count)
{
    uint64_t kind = random_below(rng, 6);
    size_t words = *count / 8;
    if (kind == 0 || words == 0) {
        *count = (size_t)random_below(rng, *count + 1);
        return;
    }
    size_t at = 8 * (size_t)random_below(rng, words);
    uint64_t value = EXTREMES[random_below(rng, EXTREME_COUNT)];
    if (kind == 1)
        bytes[random_below(rng, *count)] ^= (unsigned char)(1u << random_below(rng, 8));
    else if (kind == 2)
        memcpy(bytes + 4 * random_below(rng, 2 * words), &value, 4);
    else if (kind == 3)
        memcpy(bytes + at, bytes + 8 * random_below(rng, words), 8);
    else
        memcpy(bytes + (kind == 4 ? at : 8 * random_below(rng, words < 8 ? words : 8)), &value, 8);
}

/* Judges a copy of exactly `count` bytes, so that a sanitizer sees a read beyond. */
static void judge_bytes(const struct judge *judge, const struct judge_case *c, struct span input,
                        const unsigned char *bytes, size_t count, const struct usage *usage,
                        struct judgement *judgement)
{
    struct error err = {0};
    unsigned char *copy = malloc(count ? count : 1);
    assert_non_null(copy);
    memcpy(copy, bytes, count);
    memset(judgement, 0, sizeof *judgement);
    if (judge_case_answer(judge, c, input, (struct span){copy, count}, usage, judgement, &err))
        fail_msg("%s: the judge failed: %s", judge->exercise, err.text);
    if (!judgement->accepted &&
        !(judgement->cause[0] && judgement->message.en[0] && judgement->message.es[0]))
        fail_msg("%s: an answer was rejected without a reason", judge->exercise);
    json_t *scene = scene_to_json(&judgement->scene);
    assert_non_null(scene);
    json_decref(scene);
    scene_release(&judgement->scene);
    free(copy);
}

static void fuzz_case(const struct judge *judge, const struct judge_case *c, struct span input,
                      const struct submission_answer *right, int rounds, uint64_t seed)
{
    struct random rng;
    random_init(&rng, seed);
    unsigned char *bytes = malloc(right->count + 8);
    assert_non_null(bytes);
    for (int round = 0; round < rounds; round++) {
        struct judgement first, second;
        struct usage usage = right->usage;
        size_t count = right->count;
        memcpy(bytes, right->bytes, count);
        usage.known = random_below(&rng, 2) == 0;
        if (random_below(&rng, 8) == 0)
            usage.heap_held_bytes = (int64_t)random_next(&rng);
        if (random_below(&rng, 16) == 0)
            for (size_t i = 0; i < count; i++)
                bytes[i] = (unsigned char)random_next(&rng);
        for (uint64_t i = 0, changes = random_below(&rng, CHANGES_MAX); i <= changes; i++)
            change_once(&rng, bytes, &count);
        judge_bytes(judge, c, input, bytes, count, &usage, &first);
        judge_bytes(judge, c, input, bytes, count, &usage, &second);
        assert_int_equal(first.accepted, second.accepted);
        assert_string_equal(first.message.en, second.message.en);
    }
    free(bytes);
}

static void refuse(const struct judge *judge, const struct judge_case *c, struct span input,
                   const struct submission_answer *right, const unsigned char *bytes, size_t count,
                   const char *what)
{
    struct judgement judgement;
    judge_bytes(judge, NULL, input, bytes, count, &right->usage, &judgement);
    if (judgement.accepted)
        fail_msg("%s, case %s: accepts %s", judge->exercise, c->name, what);
}

static void refuse_garbage(const struct judge *judge, const struct judge_case *c, struct span input,
                           const struct submission_answer *right)
{
    struct random rng;
    unsigned char *bytes = malloc(right->count + 1);
    assert_non_null(bytes);
    random_init(&rng, c->seed);
    refuse(judge, c, input, right, right->bytes, 0, "no bytes");
    refuse(judge, c, input, right, right->bytes, right->count - 1, "all bytes but one");
    refuse(judge, c, input, right, right->bytes, right->count / 2, "half of the bytes");
    for (size_t i = 0; i < right->count; i++)
        bytes[i] = (unsigned char)random_next(&rng);
    refuse(judge, c, input, right, bytes, right->count, "random bytes");
    memset(bytes, 0x7F, right->count);
    refuse(judge, c, input, right, bytes, right->count, "huge counts");
    free(bytes);
}

/* Calls `use` with the reference's answer to every case, or to every public one. */
static void for_each_answer(const struct judge *judge, const char *group, bool public_only,
                            void (*use)(const struct judge *, size_t, struct span,
                                        const struct submission_answer *, int),
                            int rounds)
{
    char source[256];
    struct submission reference;
    snprintf(source, sizeof source, "reference/answers/%s/%s.c", group, judge->exercise);
    submission_build(&reference, group, judge->exercise, source);
    for (size_t i = 0; i < judge->case_count; i++) {
        struct writer input = writer_growing();
        struct error err = {0};
        struct submission_answer right;
        if (public_only && !judge_case_is_public(&judge->cases[i]))
            continue;
        assert_int_equal(judge_make(judge, &judge->cases[i], "exercises/models", &input, &err), 0);
        struct span span = {input.bytes, input.count};
        submission_run(&reference, span, judge_answer_bound(judge, span), 0, &right);
        assert_int_equal(right.end, SUBMISSION_ANSWERED);
        use(judge, i, span, &right, rounds);
        submission_answer_release(&right);
        writer_release(&input);
    }
    submission_release(&reference);
}

static void fuzz_one(const struct judge *judge, size_t i, struct span input,
                     const struct submission_answer *right, int rounds)
{
    if (right->count <= ANSWER_BYTES_MAX && input.count <= INPUT_BYTES_MAX)
        fuzz_case(judge, &judge->cases[i], input, right, rounds / (int)judge->case_count + 1,
                  i + 1);
}

void answers_fuzz(const struct judge *judge, const char *group, int rounds)
{
    for_each_answer(judge, group, false, fuzz_one, rounds);
}

static void refuse_one(const struct judge *judge, size_t i, struct span input,
                       const struct submission_answer *right, int rounds)
{
    (void)rounds;
    refuse_garbage(judge, &judge->cases[i], input, right);
}

void answers_refuse_garbage(const struct judge *judge, const char *group)
{
    for_each_answer(judge, group, true, refuse_one, 0);
}
