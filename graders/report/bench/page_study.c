/* What a run says of itself: method, machine, limits, how to cite and repeat; see page.h. */
#include "graders/report/bench/page.h"

#include <math.h>
#include <string.h>

/* Sums over the rows of the run. */
struct totals {
    double fewest_blocks, most_blocks;
    double least_confidence;
    size_t row_count, noisy_count, refused_count, peer_count;
    size_t equal_count, different_count; /* answers */
};

static struct totals totals_of(const struct study *study)
{
    struct totals totals = {.fewest_blocks = (double)INFINITY, .least_confidence = 1};
    size_t i;
    const json_t *row;
    json_array_foreach(study->rows, i, row)
    {
        const json_t *ratio = json_object_get(row, "ratio");
        double blocks = study_number(row, "blocks");
        totals.row_count++;
        totals.different_count += strcmp(study_text(row, "answer"), "different") == 0;
        totals.equal_count += strcmp(study_text(row, "answer"), "equal") == 0;
        totals.refused_count += *study_text(row, "error") != '\0';
        totals.noisy_count += json_is_true(json_object_get(row, "noisy")) ||
                              json_is_true(json_object_get(ratio, "too_noisy"));
        totals.peer_count += strcmp(study_text(row, "kind"), "peer") == 0;
        if (isnan(study_time(row)))
            continue;
        totals.fewest_blocks = fmin(totals.fewest_blocks, blocks);
        totals.most_blocks = fmax(totals.most_blocks, blocks);
        totals.least_confidence = fmin(totals.least_confidence, study_number(ratio, "confidence"));
    }
    return totals;
}

static void write_blocks(struct html *page, const struct totals *totals)
{
    if (isinf(totals->fewest_blocks))
        return;
    html_open(page, "p");
    html_text(page, "What is compared is measured together: in each block every contender runs in "
                    "a fresh process of its own, in an order that changes, on the same mesh, and "
                    "only times of the same block are divided. ");
    if (totals->fewest_blocks < totals->most_blocks)
        html_format(page, "Rows have %.0f to %.0f blocks. ", totals->fewest_blocks,
                    totals->most_blocks);
    else
        html_format(page, "Each row has %.0f block%s. ", totals->most_blocks,
                    totals->most_blocks > 1 ? "s" : "");
    html_text(page, "Within a process the least time counts; over the blocks, the median, and the "
                    "interval is that of the sign test");
    if (totals->most_blocks < 2)
        html_text(page, ", which a single block does not have");
    else if (totals->least_confidence < 1)
        html_format(page, ", of at least %.0f %% confidence", 100 * totals->least_confidence);
    html_text(page, ".");
    html_close(page, "p");
}

static void write_samples(struct html *page, const struct study *study)
{
    const json_t *noise = json_object_get(study->document, "noise");
    double samples = study_number(noise, "samples"), dropped = study_number(noise, "dropped");
    if (!(samples > 0) || isnan(dropped))
        return;
    html_open(page, "p");
    html_format(
        page,
        "Each sample stands between two short loops of known cost. Where these ran slow, a "
        "neighbour had slowed the core, and the sample was dropped: %.0f of %.0f (%.1f %%).",
        dropped, samples, 100 * dropped / samples);
    html_close(page, "p");
}

void page_method(struct html *page, const struct bench_page *context)
{
    struct totals totals = totals_of(context->study);
    html_open(page, "section");
    html_attribute(page, "id", "method");
    html_leaf(page, "h2", NULL, "Method");
    write_blocks(page, &totals);
    write_samples(page, context->study);
    html_open(page, "p");
    html_text(page, "Times are warm (output and scratch memory were touched before) unless they "
                    "are called cold. ");
    if (totals.equal_count + totals.different_count > 0)
        html_format(page,
                    "The answers of %zu rows were compared with those that they are held against: "
                    "%zu differ.",
                    totals.equal_count + totals.different_count, totals.different_count);
    html_close(page, "p");
    html_close(page, "section");
}

/* ---------------------------------------------------------------- the machine */

static void fact(struct html *page, const char *name, const char *text)
{
    if (!*text)
        return;
    html_leaf(page, "dt", NULL, name);
    html_leaf(page, "dd", NULL, text);
}

static void write_caches(struct html *page, const json_t *machine)
{
    const json_t *caches = json_object_get(machine, "caches"), *cache;
    size_t i;
    if (json_array_size(caches) == 0)
        return;
    html_leaf(page, "dt", NULL, "caches");
    html_open(page, "dd");
    json_array_foreach(caches, i, cache)
    {
        double bytes = study_number(cache, "bytes");
        html_format(page, bytes < 1048576 ? "%sL%.0f %s %.0f KB" : "%sL%.0f %s %.0f MB",
                    i ? ", " : "", study_number(cache, "level"), study_text(cache, "type"),
                    bytes < 1048576 ? bytes / 1024 : bytes / 1048576);
    }
    html_close(page, "dd");
}

static void write_copies(struct html *page, const json_t *machine)
{
    const json_t *copies = json_object_get(machine, "copy"), *copy;
    size_t i;
    if (json_array_size(copies) == 0)
        return;
    html_leaf(page, "dt", NULL, "copies, in the same run");
    html_open(page, "dd");
    json_array_foreach(copies, i, copy)
    {
        html_format(page, "%s%.0f MB at %.1f GB/s (%s)", i ? ", " : "",
                    study_number(copy, "bytes") / 1048576,
                    study_number(copy, "gigabytes_per_second"), study_text(copy, "method"));
    }
    html_close(page, "dd");
}

/* What kernels could use, and why when that is less than the processor has. */
static void write_vectors(struct html *page, const json_t *machine)
{
    const char *vectors = study_text(machine, "vectors");
    const char *most = study_text(machine, "processor_vectors");
    char words[120];
    if (strcmp(vectors, most) == 0)
        snprintf(words, sizeof words, "%s", vectors);
    else
        snprintf(words, sizeof words, "%s, by MESHGRADE_CPU; the processor has %s", vectors, most);
    fact(page, "vectors", words);
}

void page_machine(struct html *page, struct bench_page *context)
{
    const json_t *machine = json_object_get(context->study->document, "machine");
    char cores[80], memory[40] = "";
    double ram = study_number(machine, "ram_bytes");
    html_open(page, "section");
    html_attribute(page, "id", "machine");
    html_leaf(page, "h2", NULL, "Machine and meshes");
    html_open(page, "dl");
    html_attribute(page, "class", "machine");
    fact(page, "processor", study_text(machine, "cpu"));
    write_vectors(page, machine);
    if (!isnan(study_number(machine, "cores"))) {
        snprintf(cores, sizeof cores, "%.0f%s", study_number(machine, "cores"),
                 json_is_true(json_object_get(machine, "hypervisor")) ? ", of a virtual machine"
                                                                      : "");
        fact(page, "cores", cores);
    }
    if (ram > 0)
        snprintf(memory, sizeof memory, "%.0f GB", ram / 1073741824);
    fact(page, "memory", memory);
    write_caches(page, machine);
    write_copies(page, machine);
    fact(page, "kernel", study_text(machine, "kernel"));
    fact(page, "compiler", study_text(machine, "compiler"));
    fact(page, "flags", study_text(machine, "flags"));
    fact(page, "huge pages", study_text(machine, "huge_pages"));
    html_close(page, "dl");
    page_meshes(page, context);
    html_close(page, "section");
}

/* ---------------------------------------------------------------- limits, citing */

void page_limits(struct html *page, const struct bench_page *context)
{
    const struct study *study = context->study;
    const json_t *machine = json_object_get(study->document, "machine");
    struct totals totals = totals_of(study);
    html_open(page, "section");
    html_attribute(page, "id", "limits");
    html_leaf(page, "h2", NULL, "Limits of this study");
    html_open(page, "ul");
    html_leaf(page, "li", NULL,
              "One machine: ratios between contenders carry over to others better than times, and "
              "neither carries over exactly. No time is compared across runs.");
    if (json_is_true(json_object_get(machine, "hypervisor")))
        html_leaf(page, "li", NULL,
                  "The machine is virtual: neighbours share its caches and its memory, and what "
                  "they take cannot be seen from within.");
    if (strcmp(study_text(study->document, "mode"), "quick") == 0)
        html_leaf(page, "li", NULL,
                  "A quick run: few meshes of one size, few blocks. Conclusions about growth need "
                  "the full one.");
    if (totals.noisy_count > 0) {
        html_open(page, "li");
        html_format(page, "%zu of %zu rows are noisy or too noisy for a median.",
                    totals.noisy_count, totals.row_count);
        html_close(page, "li");
    }
    if (totals.refused_count > 0) {
        html_open(page, "li");
        html_format(page,
                    "%zu rows have no time: the structure cannot hold the mesh, as bench.json says "
                    "of each.",
                    totals.refused_count);
        html_close(page, "li");
    }
    if (totals.peer_count == 0)
        html_leaf(page, "li", NULL, "No peer library took part in this run.");
    html_leaf(page, "li", NULL,
              "The structures are ours, written to be read as well as to be fast; another "
              "implementation of the same structure may be faster.");
    html_close(page, "ul");
    html_close(page, "section");
}

void page_repeat(struct html *page, const struct bench_page *context)
{
    const struct study *study = context->study;
    bool quick = strcmp(study_text(study->document, "mode"), "quick") == 0;
    bool peers = totals_of(study).peer_count > 0;
    html_open(page, "section");
    html_attribute(page, "id", "repeat");
    html_leaf(page, "h2", NULL, "Repeating and citing");
    html_leaf(page, "p", NULL,
              "Every number of this page stands in bench.json and bench.csv beside it. To measure "
              "again, and to draw this page again without measuring:");
    html_open(page, "pre");
    html_format(page,
                "make all%s\nbuild/meshgrade bench%s%s -o DIR\nbuild/meshgrade bench --page DIR",
                peers ? " peers" : "", quick ? " --quick" : "", peers ? " --peers" : "");
    html_close(page, "pre");
    html_leaf(page, "p", NULL, "To cite this run:");
    html_open(page, "pre");
    html_format(page,
                "meshgrade %s: mesh representations and kernels, %s run of %s on %s. bench.json, "
                "schema %s.",
                study_text(study->document, "version"), study_text(study->document, "mode"),
                study_text(study->document, "date"),
                study_text(json_object_get(study->document, "machine"), "cpu"),
                study_text(study->document, "schema"));
    html_close(page, "pre");
    html_close(page, "section");
}
