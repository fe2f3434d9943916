/* Quality of right answers: the number of each case as a bar beside the limits of the bands. */
#include "graders/report/page.h"

#include "reference/base/decimal.h"

#include <string.h>

static bool has_quality(const json_t *one)
{
    return json_object_get(one, "quality") != NULL;
}

/* The longest bar. */
static double most_of(const json_t *result, const json_t *bands)
{
    double most = 0;
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, "cases"), i, part)
    {
        if (has_quality(part) && result_number(part, "quality") > most)
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
    char en[WORDS_QUALITY_BYTES], es[WORDS_QUALITY_BYTES];
    words_of_quality(quality, false, en);
    words_of_quality(quality, true, es);
    html_both_leaf(page, "p", NULL, (struct phrase){en, es});
}

static void write_table(struct html *page, const json_t *result, const json_t *quality)
{
    const json_t *bands = json_object_get(quality, "bands");
    bool less = json_is_true(json_object_get(quality, "less_is_better"));
    double most = most_of(result, bands);
    size_t i;
    json_t *part;
    html_open(page, "table");
    html_attribute(page, "class", "bars");
    html_open(page, "tbody");
    json_array_foreach(json_object_get(result, "cases"), i, part)
    {
        if (has_quality(part))
            write_case(page, part, bands, most);
    }
    json_array_foreach(bands, i, part)
    {
        write_band(page, part, less, most);
    }
    html_close(page, "tbody");
    html_close(page, "table");
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
    html_open(page, "div");
    html_attribute(page, "class", "scroll");
    html_attribute(page, "tabindex", "0");
    write_table(page, result, quality);
    html_close(page, "div");
    html_close(page, "div");
    html_close(page, "details");
}
