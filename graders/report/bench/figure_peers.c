/* Our kernels against peer libraries, as ratios with their intervals. */
#include "graders/report/bench/figures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct wanted peers = {.what = "kernels", .kind = "peer"};

enum { PEERS_MAX = 16 };

struct comparison {
    const char *title;
    double median, low, high;
    bool too_noisy, decided;
};

static int by_ratio(const void *a, const void *b)
{
    const struct comparison *x = a, *y = b;
    return (x->median > y->median) - (x->median < y->median);
}

/* Peer over ours for one operation, smallest ratio first. */
static size_t collect(const struct study *study, const struct wanted *wanted,
                      struct comparison list[PEERS_MAX])
{
    size_t i, count = 0;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        const json_t *ratio = json_object_get(row, "ratio");
        struct comparison one = {.title = study_text(row, "title"),
                                 .median = study_number(ratio, "median"),
                                 .low = study_number(ratio, "low"),
                                 .high = study_number(ratio, "high"),
                                 .too_noisy = json_is_true(json_object_get(ratio, "too_noisy")),
                                 .decided = study_is_decided(ratio)};
        if (study_matches(row, wanted) && one.median > 0 && count < PEERS_MAX)
            list[count++] = one;
    }
    qsort(list, count, sizeof *list, by_ratio);
    return count;
}

static json_t *bar_of(const struct comparison *one)
{
    char label[80];
    if (one->too_noisy)
        snprintf(label, sizeof label, "× %.3g to %.3g", one->low, one->high);
    else if (!one->decided)
        snprintf(label, sizeof label, "× %.3g", one->median);
    else
        snprintf(label, sizeof label, "× %.3g  (%.3g – %.3g)", one->median, one->low, one->high);
    enum look look = one->low > 1 ? LOOK_BLUE : one->high < 1 ? LOOK_ORANGE : LOOK_GREY;
    json_t *bar = json_pack("{s:s, s:s, s:i, s:f}", "name", one->title, "label", label, "look",
                            (int)look, "value", one->median);
    if (one->decided || one->too_noisy) {
        figure_number(bar, "low", one->low);
        figure_number(bar, "high", one->high);
    }
    return bar;
}

static json_t *scene(const struct study *study)
{
    struct wanted wanted = peers;
    const char *operations[STUDY_NAMES_MAX];
    char words[100];
    wanted.mesh = study_mesh(study, &peers);
    if (!wanted.mesh)
        return NULL;
    size_t count = study_names(study, &wanted, "operation", operations);
    json_t *groups = json_array();
    for (size_t k = 0; k < count; k++) {
        struct comparison list[PEERS_MAX] = {{0}};
        char title[80];
        wanted.operation = operations[k];
        figure_operation_title(operations[k], title, sizeof title);
        size_t found = collect(study, &wanted, list);
        json_t *bars = json_array();
        for (size_t i = 0; i < found; i++)
            json_array_append_new(bars, bar_of(&list[i]));
        json_array_append_new(groups, json_pack("{s:s, s:o}", "title", title, "bars", bars));
    }
    study_mesh_words(wanted.mesh, words, sizeof words);
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:[o], s:o, s:[o, o, o]}", "kind", "bars", "title",
                     "How many times as long the peer libraries take", "subtitle", words, "scale",
                     "log", "x_label", "time of the peer / time of our kernel, one thread each",
                     "guides", figure_guide("x", 1, "as fast as ours"), "groups", groups, "legend",
                     figure_key("bar", LOOK_BLUE, "peer slower"),
                     figure_key("bar", LOOK_ORANGE, "peer faster"),
                     figure_key("bar", LOOK_GREY, "undecided: the interval holds 1"));
}

/* All comparisons of the run, on every mesh. */
static void finding(const struct study *study, FILE *to)
{
    size_t i, count = 0, slower = 0, faster = 0, undecided = 0;
    double least = (double)INFINITY, most = 0;
    const json_t *row, *exception = NULL;
    json_array_foreach(study->rows, i, row)
    {
        const json_t *ratio = json_object_get(row, "ratio");
        double median = study_number(ratio, "median");
        if (!study_matches(row, &peers) || !(median > 0))
            continue;
        count++;
        /* a wide interval says little of how much, and yet on which side of 1 it lies */
        bool is_sure = study_number(ratio, "confidence") >= STUDY_CONFIDENCE;
        bool is_slower = is_sure && study_number(ratio, "low") > 1;
        bool is_faster = is_sure && study_number(ratio, "high") < 1;
        slower += is_slower;
        faster += is_faster;
        undecided += !is_slower && !is_faster;
        if (json_is_true(json_object_get(ratio, "too_noisy")))
            continue;
        if (median < least) {
            least = median;
            exception = row;
        }
        most = fmax(most, median);
    }
    fprintf(to,
            "In %zu of %zu comparisons on all meshes of the run the peer takes longer, with 95 "
            "percent confidence; ",
            slower, count);
    fprintf(to, "in %zu it is faster, and %zu are undecided. ", faster, undecided);
    if (exception)
        fprintf(to, "The ratios go from %.2f (%s, %s, on %s) to %.0f.", least,
                study_text(exception, "title"), study_operation(study_text(exception, "operation")),
                study_text(exception, "mesh"), most);
}

const struct figure figure_peers = {.name = "peers",
                                    .label = "Peer libraries against our kernels",
                                    .width = 1200,
                                    .height = 1100,
                                    .scene = scene,
                                    .finding = finding,
                                    .absent = "no peer library took part (make peers, then "
                                              "meshgrade bench --peers)"};
