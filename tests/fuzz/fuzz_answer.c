/* Any bytes as an answer, to every judge: accepted, or rejected with a reason and a scene that can
 * be drawn; never a crash, and twice the same.
 *
 * An input is "<exercise>/<case>" and a line feed, then the answer. Names that are none choose a
 * judge and a case by their hash, so that no input is without use. */
#include "graders/judges/table.h"
#include "graders/scene/scene.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

enum { INPUTS_MAX = 1024 };

/* The work of judging goes with the input, which is ours: large ones only make fuzzing slow. */
static const size_t INPUT_BYTES_MAX = 1 << 18;

/* The input of a case, made once; empty when it is too large. */
struct made {
    const struct judge_case *c;
    struct writer input;
};

static size_t hash_of(const uint8_t *bytes, size_t count)
{
    size_t hash = 14695981039346656037u;
    for (size_t i = 0; i < count; i++)
        hash = (hash ^ bytes[i]) * 1099511628211u;
    return hash;
}

static bool is_named(const struct judge *judge, const struct judge_case *c, const uint8_t *name,
                     size_t count)
{
    size_t exercise = strlen(judge->exercise), length = strlen(c->name);
    return count == exercise + 1 + length && memcmp(name, judge->exercise, exercise) == 0 &&
           name[exercise] == '/' && memcmp(name + exercise + 1, c->name, length) == 0;
}

static void choose(const uint8_t *name, size_t count, const struct judge **judge,
                   const struct judge_case **c)
{
    size_t judge_count = 0, hash = hash_of(name, count);
    for (; judge_table[judge_count]; judge_count++) {
        *judge = judge_table[judge_count];
        for (size_t i = 0; i < (*judge)->case_count; i++)
            if (is_named(*judge, *c = &(*judge)->cases[i], name, count))
                return;
    }
    *judge = judge_table[hash % judge_count];
    *c = &(*judge)->cases[hash / judge_count % (*judge)->case_count];
}

static struct span input_of(const struct judge *judge, const struct judge_case *c)
{
    static struct made inputs[INPUTS_MAX];
    struct error err = {""};
    int i = 0;
    while (inputs[i].c && inputs[i].c != c)
        if (++i == INPUTS_MAX)
            abort();
    if (!inputs[i].c) {
        inputs[i] = (struct made){c, writer_growing()};
        if (judge_make(judge, c, "exercises/models", &inputs[i].input, &err) != 0)
            abort(); /* run in the root of the tree */
        if (inputs[i].input.count > INPUT_BYTES_MAX) {
            writer_release(&inputs[i].input);
            inputs[i].input = writer_growing();
        }
    }
    return (struct span){inputs[i].input.bytes, inputs[i].input.count};
}

static void judge_once(const struct judge *judge, struct span input, struct span answer,
                       struct judgement *judgement)
{
    struct usage usage = {.heap_peak_bytes = 4096,
                          .heap_held_bytes = (int64_t)hash_of(answer.bytes, answer.count) >> 48,
                          .known = answer.count % 2 == 0};
    struct error err = {""};
    memset(judgement, 0, sizeof *judgement);
    if (judge_answer(judge, input, answer, &usage, judgement, &err) != 0)
        abort();
    if (!judgement->accepted &&
        !(judgement->cause[0] && judgement->message.en[0] && judgement->message.es[0]))
        abort();
    json_t *scene = scene_to_json(&judgement->scene);
    if (!scene)
        abort();
    json_decref(scene);
    scene_release(&judgement->scene);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    const struct judge *judge;
    const struct judge_case *c;
    const uint8_t *line_end = count ? memchr(bytes, '\n', count) : NULL;
    size_t name_count = line_end ? (size_t)(line_end - bytes) : 0;
    size_t skipped = line_end ? name_count + 1 : 0;
    struct judgement first, second;
    choose(bytes, name_count, &judge, &c);
    struct span input = input_of(judge, c);
    if (input.count == 0)
        return 0;
    /* As the engine does: aligned, and of just its size, so that a read beyond it is seen. */
    size_t answer_bytes = count - skipped;
    unsigned char *copy = malloc(answer_bytes ? answer_bytes : 1);
    if (!copy)
        return 0;
    memcpy(copy, bytes + skipped, answer_bytes);
    struct span answer = {copy, answer_bytes};
    judge_once(judge, input, answer, &first);
    judge_once(judge, input, answer, &second);
    free(copy);
    if (first.accepted != second.accepted || strcmp(first.message.en, second.message.en) != 0)
        abort();
    return 0;
}
