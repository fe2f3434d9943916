/* The runner of own-structure: a call either builds, and the structure is then asked unmeasured so
 * that the judge can tell whether it is right, or asks a structure that was built unmeasured. What is
 * not the call is done in run_prepare. */
#include "own-structure.h"
#include "graders/runner/shapes.h"

enum { BUILDING, ASKING };
enum { OF_VERTICES, OF_FACES };

/* What is asked, and the answers. */
struct round {
    int64_t kind;
    int32_t count, capacity; /* elements, and room for the answer of each */
    int32_t *returned, *first, *out;
};

/* Each of them is called by name from the function that is counted. */
#define ASK_ALL(structure, round)                                                                  \
    for (int32_t i = 0; i < (round)->count; i++) {                                                 \
        int32_t *place = (round)->out + (round)->first[i], most = (round)->capacity;               \
        int32_t *out = lend_room(place, most);                                                     \
        int32_t n = (round)->kind == OF_VERTICES ? faces_of_vertex(structure, i, out, most)        \
                                                 : faces_of_face(structure, i, out, most);         \
        (round)->returned[i] = n;                                                                  \
        (round)->first[i + 1] = (round)->first[i] + (n < 0 ? 0 : n < most ? n : most);             \
        take_room(place, out, (round)->first[i + 1] - (round)->first[i]);                          \
    }

/* Builds and returns the structure; or, given one, asks it when there is a round, and releases it. */
__attribute__((noipa)) static struct structure *
run_prepare(const struct given *given, struct structure *built, struct round *round)
{
    if (!built)
        return structure_build(given->first_corner, given->corners, given->face_count,
                               given->vertex_count);
    if (round)
        ASK_ALL(built, round)
    structure_release(built);
    return NULL;
}

static struct round make_round(const struct given *given, struct reader *input)
{
    struct round round = {.kind = given->number[1], .capacity = (int32_t)read_int(input)};
    round.count = round.kind == OF_VERTICES ? given->vertex_count : given->face_count;
    round.returned = given_array(round.count, sizeof *round.returned);
    round.first = given_array((int64_t)round.count + 1, sizeof *round.first);
    round.out = given_array((int64_t)round.count * round.capacity, sizeof *round.out);
    round.first[0] = 0;
    return round;
}

void run_call(struct reader *input, struct writer *answer)
{
    struct given given = given_polygons(input);
    struct round round = make_round(&given, input);
    struct structure *built = NULL;
    if (given.number[0] == ASKING) {
        prepare_begin();
        built = run_prepare(&given, NULL, NULL);
        prepare_end();
    }
    bool asks = built != NULL;
    measure_begin();
    if (given.number[0] == BUILDING)
        built = structure_build(given.first_corner, given.corners, given.face_count,
                                given.vertex_count);
    else if (asks)
        ASK_ALL(built, &round)
    measure_end();
    if (!built) {
        call_out_of_memory();
        return;
    }
    prepare_begin();
    run_prepare(&given, built, asks ? NULL : &round);
    prepare_end();
    answer_result(answer, round.count);
    answer_given(answer, round.count, round.returned, sizeof *round.returned);
    answer_given(answer, (int64_t)round.count + 1, round.first, sizeof *round.first);
    answer_given(answer, round.first[round.count], round.out, sizeof *round.out);
}
