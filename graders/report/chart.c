/* Charts from measures, and their drawing as SVG; see chart.h. */
#include "graders/report/chart.h"

#include "bench/measure/growth.h"
#include "graders/report/results.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---------------------------------------------------------------- scenes from measures */

/* Whether a sentence names a family, as a word of its own. */
static bool names_family(const char *sentence, const char *family)
{
    size_t length = strlen(family);
    for (const char *at = sentence; length > 0 && (at = strstr(at, family)) != NULL; at++)
        if ((at == sentence || at[-1] == ' ') && (at[length] == '\0' || strchr(" ;,.", at[length])))
            return true;
    return false;
}

/* What the growth check says; "" when there is no such check. */
static const char *growth_message(const json_t *result)
{
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(result, "checks"), i, check)
    {
        const char *message = words_in(check, "message").en;
        if (strcmp(result_text(check, "name"), "growth") == 0)
            return message ? message : "";
    }
    return "";
}

const json_t *chart_growth_family(const json_t *result)
{
    const char *message = growth_message(result);
    const json_t *growth = json_object_get(json_object_get(result, "measures"), "growth");
    const json_t *worst = NULL;
    double worst_excess = 0;
    double worst_exponent = 0;
    size_t i;
    json_t *family;
    json_array_foreach(json_object_get(growth, "families"), i, family)
    {
        const json_t *fit = json_object_get(family, "fit");
        double excess = result_number(fit, "excess_percent");
        double exponent = result_number(fit, "exponent");
        if (names_family(message, result_text(family, "name")))
            return family;
        if (worst &&
            (excess < worst_excess || (excess == worst_excess && exponent <= worst_exponent)))
            continue;
        worst = family;
        worst_excess = excess;
        worst_exponent = exponent;
    }
    return worst;
}

struct phrase chart_elements(const json_t *result)
{
    const json_t *growth = json_object_get(json_object_get(result, "measures"), "growth");
    struct phrase elements = words_in(growth, "elements");
    if (!*elements.en)
        elements = words_in(growth, "element");
    return *elements.en ? elements : (struct phrase){"size", "tamaño"};
}

static json_t *phrase_json(struct phrase phrase)
{
    return json_pack("{s:s, s:s}", "en", phrase.en, "es", phrase.es);
}

/* The points of a curve that have a place on logarithmic axes. */
static json_t *curve_of(const json_t *family, const char *key, const char *name, double exponent)
{
    json_t *x = json_array();
    json_t *y = json_array();
    size_t i;
    json_t *size;
    json_array_foreach(json_object_get(family, "sizes"), i, size)
    {
        json_t *value = json_array_get(json_object_get(family, key), i);
        if (!(json_number_value(size) > 0 && json_number_value(value) > 0))
            continue;
        json_array_append(x, size);
        json_array_append(y, value);
    }
    return json_pack("{s:s, s:o, s:o, s:f}", "name", name, "x", x, "y", y, "exponent", exponent);
}

/* "Edge table of any mesh: growth of the work". */
static json_t *title_of(const json_t *result, struct phrase what)
{
    struct message title;
    struct phrase exercise = words_in(result, "title");
    message_set_phrase(&title, exercise);
    message_en(&title, ": %s", what.en);
    message_es(&title, ": %s", what.es);
    return phrase_json(message_phrase(&title));
}

/* Where the submission would be if it grew from its first size on as is allowed: a guide for the
 * eye, no limit. NULL when there is nothing to start from. */
static json_t *allowed_curve(const json_t *own, const char *allowed)
{
    enum growth_class class;
    const json_t *sizes = json_object_get(own, "x");
    double first_size = json_number_value(json_array_get(sizes, 0));
    double first = json_number_value(json_array_get(json_object_get(own, "y"), 0));
    if (growth_class_find(allowed, &class) != 0 || json_array_size(sizes) < 2 || first_size < 2)
        return NULL;
    json_t *y = json_array();
    size_t i;
    json_t *size;
    json_array_foreach(sizes, i, size)
    {
        double term = growth_term(class, json_number_value(size));
        json_array_append_new(y, json_real(first * term / growth_term(class, first_size)));
    }
    return json_pack("{s:s, s:s, s:O, s:o}", "name", "allowed", "guide", allowed, "x", sizes, "y",
                     y);
}

/* What two curves are of. */
struct pair {
    const char *own_key, *reference_key; /* of the family */
    struct phrase title, y_label;
    const char *allowed; /* class of the guide; NULL: none */
};

/* A scene of submission and reference over the sizes of a family; NULL when there is no curve. */
static json_t *two_curves(const json_t *result, const json_t *family, const struct pair *pair)
{
    json_t *own = curve_of(family, pair->own_key, "submission",
                           result_number(json_object_get(family, "fit"), "exponent"));
    json_t *reference = curve_of(family, pair->reference_key, "reference", 0);
    json_t *curves = json_array();
    if (json_array_size(json_object_get(own, "x")) >= 2)
        json_array_append(curves, own);
    if (json_array_size(json_object_get(reference, "x")) >= 2)
        json_array_append(curves, reference);
    json_t *guide = pair->allowed ? allowed_curve(own, pair->allowed) : NULL;
    if (guide)
        json_array_append_new(curves, guide);
    json_decref(own);
    json_decref(reference);
    if (json_array_size(curves) == 0) {
        json_decref(curves);
        return NULL;
    }
    return json_pack("{s:s, s:o, s:s, s:o, s:o, s:o, s:{s:O, s:s, s:O}}", "kind", "chart", "title",
                     title_of(result, pair->title), "subtitle", result_text(family, "name"),
                     "curves", curves, "x_label", phrase_json(chart_elements(result)), "y_label",
                     phrase_json(pair->y_label), "metadata", "exercise",
                     json_object_get(result, "exercise"), "case", pair->title.en, "verdict",
                     json_object_get(result, "verdict"));
}

json_t *chart_of_growth(const json_t *result)
{
    const json_t *family = chart_growth_family(result);
    if (!family)
        return NULL;
    const json_t *growth = json_object_get(json_object_get(result, "measures"), "growth");
    const struct pair pair = {"instructions",
                              "reference_instructions",
                              {"growth of the work", "crecimiento del trabajo"},
                              {"instructions", "instrucciones"},
                              result_text(growth, "allowed")};
    return two_curves(result, family, &pair);
}

json_t *chart_of_memory(const json_t *result)
{
    static const struct pair pair = {"peak_bytes",
                                     "reference_peak_bytes",
                                     {"peak memory", "máximo de memoria"},
                                     {"bytes", "bytes"},
                                     NULL};
    const json_t *memory = json_object_get(json_object_get(result, "measures"), "memory");
    const json_t *family = json_array_get(json_object_get(memory, "families"), 0);
    return family ? two_curves(result, family, &pair) : NULL;
}

/* ---------------------------------------------------------------- drawing */

enum { WIDTH = 560, HEIGHT = 340, LEFT = 66, RIGHT = 18, TOP = 18, BOTTOM = 52, MAX_CURVES = 6 };

struct axis {
    double low, high; /* log10 of the ends */
    double from, to;  /* where they lie, in SVG units */
};

static double on_axis(const struct axis *axis, double value)
{
    double share = (log10(value) - axis->low) / (axis->high - axis->low);
    return axis->from + share * (axis->to - axis->from);
}

static void extend(struct axis *axis, const json_t *values)
{
    size_t i;
    json_t *value;
    json_array_foreach(values, i, value)
    {
        double number = json_number_value(value);
        if (!(number > 0))
            continue;
        axis->low = fmin(axis->low, log10(number));
        axis->high = fmax(axis->high, log10(number));
    }
}

void chart_number(double value, char *text, size_t capacity)
{
    static const char *const units[] = {"", "k", "M", "G", "T", "P", "E"};
    size_t unit = 0;
    while (fabs(value) >= (unit == 0 ? 9999.5 : 999.5) && unit + 1 < sizeof units / sizeof *units) {
        value /= 1000;
        unit++;
    }
    int decimals = value == rint(value) || fabs(value) >= 99.95 ? 0 : fabs(value) >= 9.995 ? 1 : 2;
    snprintf(text, capacity, "%.*f%s", decimals, value, units[unit]);
}

static void attribute(struct html *page, const char *name, double value)
{
    html_attribute_format(page, name, "%.1f", value);
}

static void draw_line(struct html *page, const char *class_name, double x1, double y1, double x2,
                      double y2)
{
    html_open(page, "line");
    html_attribute(page, "class", class_name);
    attribute(page, "x1", x1);
    attribute(page, "y1", y1);
    attribute(page, "x2", x2);
    attribute(page, "y2", y2);
    html_close(page, "line");
}

static void draw_text(struct html *page, const char *anchor, double x, double y, const char *text)
{
    html_open(page, "text");
    html_attribute(page, "text-anchor", anchor);
    attribute(page, "x", x);
    attribute(page, "y", y);
    html_text(page, text);
    html_close(page, "text");
}

/* Lines and labels at powers of ten, and at 2 and 5 times them on a short axis. */
static void draw_ticks(struct html *page, const struct axis *axis, bool is_x)
{
    static const double steps[] = {1, 2, 5};
    double decades = axis->high - axis->low;
    int stride = decades > 7 ? (int)ceil(decades / 7) : 1;
    for (int power = (int)floor(axis->low); power <= (int)ceil(axis->high); power++) {
        for (size_t i = 0; i < (decades < 2.2 ? 3 : 1); i++) {
            double value = steps[i] * pow(10, power);
            double at = log10(value);
            if (at < axis->low - 1e-9 || at > axis->high + 1e-9 || power % stride != 0)
                continue;
            char label[24];
            chart_number(value, label, sizeof label);
            double where = on_axis(axis, value);
            if (is_x) {
                draw_line(page, "grid", where, TOP, where, HEIGHT - BOTTOM);
                draw_text(page, "middle", where, HEIGHT - BOTTOM + 17, label);
            } else {
                draw_line(page, "grid", LEFT, where, WIDTH - RIGHT, where);
                draw_text(page, "end", LEFT - 7, where + 4, label);
            }
        }
    }
}

/* A point of a curve: discs, squares and diamonds, so that no curve is told by its colour alone. */
static void draw_point(struct html *page, size_t number, double x, double y)
{
    enum { RADIUS = 4 };
    if (number % 3 == 0) {
        html_open(page, "circle");
        attribute(page, "cx", x);
        attribute(page, "cy", y);
        attribute(page, "r", RADIUS);
        html_close(page, "circle");
        return;
    }
    html_open(page, "rect");
    attribute(page, "x", x - RADIUS + 0.5);
    attribute(page, "y", y - RADIUS + 0.5);
    attribute(page, "width", 2 * RADIUS - 1);
    attribute(page, "height", 2 * RADIUS - 1);
    if (number % 3 == 2)
        html_attribute_format(page, "transform", "rotate(45 %.1f %.1f)", x, y);
    html_close(page, "rect");
}

static bool is_guide(const json_t *curve)
{
    return *result_text(curve, "guide") != '\0';
}

/* The reference lies wide and pale below the others: where curves are equal, both are seen. */
static void write_curve_class(struct html *page, const json_t *curve, size_t number)
{
    const char *name = result_text(curve, "name");
    bool below = strcmp(name, "reference") == 0 || strcmp(name, "right") == 0;
    if (is_guide(curve))
        html_attribute(page, "class", "curve guide");
    else
        html_attribute_format(page, "class", "curve curve-%zu%s", number, below ? " below" : "");
}

static void draw_curve(struct html *page, const json_t *curve, size_t number, const struct axis *x,
                       const struct axis *y)
{
    const json_t *xs = json_object_get(curve, "x");
    const json_t *ys = json_object_get(curve, "y");
    bool guide = is_guide(curve);
    html_open(page, "g");
    write_curve_class(page, curve, number);
    double last_x = 0;
    double last_y = 0;
    bool has_last = false;
    for (size_t i = 0; i < json_array_size(xs) && i < json_array_size(ys); i++) {
        double x_value = json_number_value(json_array_get(xs, i));
        double y_value = json_number_value(json_array_get(ys, i));
        if (!(x_value > 0 && y_value > 0))
            continue;
        double px = on_axis(x, x_value);
        double py = on_axis(y, y_value);
        if (has_last)
            draw_line(page, "stroke", last_x, last_y, px, py);
        if (!guide)
            draw_point(page, number, px, py);
        last_x = px;
        last_y = py;
        has_last = true;
    }
    html_close(page, "g");
}

/* The curve's name; those that play a part have their words here. */
static struct phrase curve_name(const json_t *curve)
{
    const char *name = result_text(curve, "name");
    if (strcmp(name, "submission") == 0)
        return (struct phrase){"submission", "entrega"};
    if (strcmp(name, "reference") == 0)
        return (struct phrase){"reference", "referencia"};
    if (strcmp(name, "allowed") == 0)
        return (struct phrase){"allowed growth", "crecimiento permitido"};
    if (strcmp(name, "right") == 0)
        return (struct phrase){"right", "correcto"};
    return words_in(curve, "name");
}

static void draw_words(struct html *page, struct phrase words, const char *tail)
{
    const char *const texts[] = {words.en, words.es};
    const char *const languages[] = {"en", "es"};
    for (int i = 0; i < 2; i++) {
        html_open(page, "tspan");
        html_attribute(page, "lang", languages[i]);
        html_format(page, "%s%s", texts[i], tail);
        html_close(page, "tspan");
    }
}

static void draw_legend(struct html *page, const json_t *curves)
{
    for (size_t i = 0; i < json_array_size(curves) && i < MAX_CURVES; i++) {
        const json_t *curve = json_array_get(curves, i);
        double y = TOP + 16 + 20.0 * (double)i;
        html_open(page, "g");
        write_curve_class(page, curve, i);
        draw_line(page, "stroke", LEFT + 14, y, LEFT + 40, y);
        if (!is_guide(curve))
            draw_point(page, i, LEFT + 27, y);
        html_close(page, "g");
        char tail[40] = "";
        double exponent = result_number(curve, "exponent");
        if (exponent > 0)
            snprintf(tail, sizeof tail, " ~ n^%.2f", exponent);
        else if (is_guide(curve))
            snprintf(tail, sizeof tail, ": %s", result_text(curve, "guide"));
        html_open(page, "text");
        attribute(page, "x", LEFT + 48);
        attribute(page, "y", y + 4);
        draw_words(page, curve_name(curve), tail);
        html_close(page, "text");
    }
}

static void draw_axis_names(struct html *page, const json_t *scene)
{
    html_open(page, "text");
    html_attribute(page, "class", "axis-name");
    html_attribute(page, "text-anchor", "middle");
    attribute(page, "x", (LEFT + WIDTH - RIGHT) / 2.0);
    attribute(page, "y", HEIGHT - 12);
    draw_words(page, words_in(scene, "x_label"), "");
    html_close(page, "text");
    html_open(page, "text");
    html_attribute(page, "class", "axis-name");
    html_attribute(page, "text-anchor", "middle");
    html_attribute_format(page, "transform", "translate(16 %.1f) rotate(-90)",
                          (TOP + HEIGHT - BOTTOM) / 2.0);
    draw_words(page, words_in(scene, "y_label"), "");
    html_close(page, "text");
}

/* Gives an axis of a single value some room. Returns whether there is any value. */
static bool open_up(struct axis *axis)
{
    const double least_decades = 0.1;
    if (axis->high - axis->low < least_decades) {
        axis->low -= 0.3;
        axis->high += 0.3;
    }
    return axis->low < axis->high;
}

void chart_draw(struct html *page, const json_t *scene, struct phrase label)
{
    const json_t *curves = json_object_get(scene, "curves");
    struct axis x = {INFINITY, -INFINITY, LEFT + 16, WIDTH - RIGHT - 10};
    struct axis y = {INFINITY, -INFINITY, HEIGHT - BOTTOM - 10, TOP + 10};
    for (size_t i = 0; i < json_array_size(curves) && i < MAX_CURVES; i++) {
        extend(&x, json_object_get(json_array_get(curves, i), "x"));
        extend(&y, json_object_get(json_array_get(curves, i), "y"));
    }
    if (!open_up(&x) || !open_up(&y))
        return;

    html_open(page, "svg");
    html_attribute(page, "class", "chart");
    html_attribute(page, "role", "img");
    html_attribute_format(page, "viewBox", "0 0 %d %d", WIDTH, HEIGHT);
    html_both_attribute(page, "aria-label", label);
    draw_ticks(page, &x, true);
    draw_ticks(page, &y, false);
    draw_line(page, "axis", LEFT, HEIGHT - BOTTOM, WIDTH - RIGHT, HEIGHT - BOTTOM);
    draw_line(page, "axis", LEFT, TOP, LEFT, HEIGHT - BOTTOM);
    for (size_t i = json_array_size(curves); i-- > 0;)
        if (i < MAX_CURVES)
            draw_curve(page, json_array_get(curves, i), i, &x, &y);
    draw_legend(page, curves);
    draw_axis_names(page, scene);
    html_close(page, "svg");
}
