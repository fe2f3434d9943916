/* Quality of right answers: the number of each case as a bar beside the limits of the bands. */
#include "graders/report/page.h"

#include "reference/base/decimal.h"

#include <string.h>

/* The longest bar. */
static double most_of(const json_t *result, const json_t *bands)
{
    double most = 0;
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, "cases"), i, part)
    {
        if (result_number(part, "quality") > most)
            most = result_number(part, "quality");
    }
    json_array_foreach(bands, i, part)
    {
        if (result_number(part, "limit") > most)
            most = result_number(part, "limit");
    }
    return most;
}

static const json_t *band_of(const json_t *bands, const char *class_name)
{
    size_t i;
    json_t *band;
    json_array_foreach(bands, i, band)
    {
        if (strcmp(result_text(band, "class"), class_name) == 0)
            return band;
    }
    return NULL;
}

/* "torus-2  [bar]  1.31  ✗ good" */
static void write_case(struct html *page, const json_t *one, const json_t *bands, double most)
{
    const json_t *band = band_of(bands, result_text(one, "class"));
    double value = result_number(one, "quality");
    char text[DECIMAL_BYTES];
    decimal_write(value, band ? result_number(band, "limit") : value, text);
    html_open(page, "tr");
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    html_leaf(page, "code", NULL, result_text(one, "name"));
    html_close(page, "th");
    page_bar(page, "own", value, most);
    html_leaf(page, "td", NULL, text);
    html_open(page, "td");
    if (band) {
        page_symbol(page, words_standing(result_text(one, "verdict")));
        html_text(page, " ");
        html_both(page, words_in(band, "name"));
    }
    html_close(page, "td");
    html_close(page, "tr");
}

static void write_band(struct html *page, const json_t *band, bool less, double most)
{
    char text[DECIMAL_BYTES];
    decimal_write(result_number(band, "limit"), result_number(band, "limit"), text);
    html_open(page, "tr");
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    html_both(page, words_in(band, "name"));
    html_close(page, "th");
    page_bar(page, "limit", result_number(band, "limit"), most);
    html_leaf(page, "td", NULL, text);
    html_both_leaf(page, "td", NULL,
                   less ? (struct phrase){"at most", "como máximo"}
                        : (struct phrase){"at least", "como mínimo"});
    html_close(page, "tr");
}

static void write_sentence(struct html *page, const json_t *quality)
{
    struct message text;
    words_of_quality(quality, &text);
    html_open(page, "p");
    html_both(page, (struct phrase){"At worst: ", "En el peor caso: "});
    html_both(page, message_phrase(&text));
    html_close(page, "p");
}

/* Whether a case stands in the table of cases with a band, or in that of the others. */
static bool belongs(const json_t *one, const json_t *bands, bool with_band)
{
    return json_object_get(one, "quality") &&
           (band_of(bands, result_text(one, "class")) != NULL) == with_band;
}

static size_t count_cases(const json_t *result, const json_t *bands, bool with_band)
{
    size_t count = 0;
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        count += belongs(one, bands, with_band);
    }
    return count;
}

/* The cases with a band and the limits, or the others. */
static void write_table(struct html *page, const json_t *result, const json_t *quality,
                        bool with_band)
{
    const json_t *bands = json_object_get(quality, "bands");
    bool less = json_is_true(json_object_get(quality, "less_is_better"));
    double most = most_of(result, bands);
    size_t i;
    json_t *part;
    html_open(page, "div");
    html_attribute(page, "class", "scroll");
    html_attribute(page, "tabindex", "0");
    html_open(page, "table");
    html_attribute(page, "class", "bars");
    html_open(page, "tbody");
    json_array_foreach(json_object_get(result, "cases"), i, part)
    {
        if (belongs(part, bands, with_band))
            write_case(page, part, bands, most);
    }
    if (with_band)
        json_array_foreach(bands, i, part)
        {
            write_band(page, part, less, most);
        }
    html_close(page, "tbody");
    html_close(page, "table");
    html_close(page, "div");
}

/* Cases whose number is only told: closed, unless there are no others. */
static void write_others(struct html *page, const json_t *result, const json_t *quality)
{
    const json_t *bands = json_object_get(quality, "bands");
    if (count_cases(result, bands, false) == 0)
        return;
    html_open(page, "details");
    if (count_cases(result, bands, true) == 0)
        html_flag(page, "open");
    html_both_leaf(page, "summary", NULL,
                   (struct phrase){"Cases without a limit", "Casos sin límite"});
    write_table(page, result, quality, false);
    html_close(page, "details");
}

void page_quality(struct html *page, const json_t *result)
{
    const json_t *quality = json_object_get(json_object_get(result, "measures"), "quality");
    if (!quality)
        return;
    html_open(page, "details");
    html_attribute(page, "class", "measures");
    html_flag(page, "open");
    html_both_leaf(page, "summary", NULL, (struct phrase){"Quality", "Calidad"});
    html_open(page, "div");
    html_attribute(page, "class", "measure");
    write_sentence(page, quality);
    if (json_array_size(json_object_get(quality, "bands")) > 0)
        write_table(page, result, quality, true);
    write_others(page, result, quality);
    html_close(page, "div");
    html_close(page, "details");
}
