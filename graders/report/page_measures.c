/* Work and memory of a result: charts, the doubling table, memory beside the reference's. */
#include "graders/report/page.h"

#include "bench/measure/growth.h"
#include "graders/report/chart.h"

#include <math.h>

static double number_at(const json_t *family, const char *key, size_t i)
{
    return json_number_value(json_array_get(json_object_get(family, key), i));
}

static void write_number_cell(struct html *page, const char *format, double value)
{
    html_open(page, "td");
    if (value > 0) {
        if (*format) {
            html_format(page, "× %.2f", value);
        } else {
            char text[32];
            chart_number(value, text, sizeof text);
            html_text(page, text);
        }
    }
    html_close(page, "td");
}

static void write_ratio_cell(struct html *page, double value, double by)
{
    write_number_cell(page, "x", value > 0 && by > 0 ? value / by : 0);
}

/* How much more a count is than at the size before, for each doubling that lies between. */
static void write_step_cell(struct html *page, const json_t *family, const char *key, size_t i)
{
    double before = i ? number_at(family, key, i - 1) : 0, value = number_at(family, key, i);
    double doublings =
        i ? log2(number_at(family, "sizes", i) / number_at(family, "sizes", i - 1)) : 0;
    bool is_step = before > 0 && value > 0 && doublings > 0;
    write_number_cell(page, "x", is_step ? pow(value / before, 1 / doublings) : 0);
}

static void write_heads(struct html *page, const struct phrase *heads, size_t count)
{
    html_open(page, "thead");
    html_open(page, "tr");
    for (size_t i = 0; i < count; i++) {
        html_open(page, "th");
        html_attribute(page, "scope", "col");
        html_both(page, heads[i]);
        html_close(page, "th");
    }
    html_close(page, "tr");
    html_close(page, "thead");
}

/* The size that a row is about. */
static void write_size_cell(struct html *page, const json_t *family, size_t i)
{
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    html_format(page, "%.0f", number_at(family, "sizes", i));
    html_close(page, "th");
}

/* Work at growing sizes: how much more each doubling costs, and how much more than the reference.
 */
static void write_doubling_table(struct html *page, const json_t *family, struct phrase element)
{
    html_open(page, "table");
    html_attribute(page, "class", "doubling");
    const struct phrase heads[] = {element,
                                   {"your instructions", "tus instrucciones"},
                                   {"per doubling", "al doblar"},
                                   {"reference", "referencia"},
                                   {"per doubling", "al doblar"},
                                   {"you / reference", "tú / referencia"}};
    write_heads(page, heads, sizeof heads / sizeof *heads);
    html_open(page, "tbody");
    size_t count = json_array_size(json_object_get(family, "sizes"));
    for (size_t i = 0; i < count; i++) {
        double own = number_at(family, "instructions", i);
        double reference = number_at(family, "reference_instructions", i);
        html_open(page, "tr");
        write_size_cell(page, family, i);
        write_number_cell(page, "", own);
        write_step_cell(page, family, "instructions", i);
        write_number_cell(page, "", reference);
        write_step_cell(page, family, "reference_instructions", i);
        write_ratio_cell(page, own, reference);
        html_close(page, "tr");
    }
    html_close(page, "tbody");
    html_close(page, "table");
}

/* A share that steps explain as well is not told: the class that was found is allowed then. */
static bool is_above(const char *class_name, const char *allowed_name)
{
    enum growth_class class, allowed;
    return growth_class_find(class_name, &class) != 0 || /* n^3, which cannot be allowed */
           (growth_class_find(allowed_name, &allowed) == 0 && class > allowed);
}

static void write_family_title(struct html *page, const json_t *family, const json_t *growth)
{
    const json_t *fit = json_object_get(family, "fit");
    html_open(page, "p");
    html_leaf(page, "code", NULL, result_text(family, "name"));
    if (fit) {
        html_both(page, (struct phrase){": grows like ", ": crece como "});
        html_leaf(page, "b", NULL, result_text(fit, "class"));
    }
    html_both(page, (struct phrase){"; allowed: ", "; se permite: "});
    const json_t *of = json_object_get(family, "allowed") ? family : growth; /* of queries: own */
    html_leaf(page, "b", NULL, result_text(of, "allowed"));
    double excess = result_number(fit, "excess_percent");
    if (excess >= 1 && is_above(result_text(fit, "class"), result_text(growth, "allowed"))) {
        struct message share;
        message_say(&share, "; %.0f %% of the work at the largest size grows faster",
                    "; el %.0f %% del trabajo en el tamaño mayor crece más deprisa", excess);
        html_both(page, message_phrase(&share));
    }
    html_close(page, "p");
}

static void write_growth(struct html *page, const json_t *result)
{
    const json_t *growth = json_object_get(json_object_get(result, "measures"), "growth");
    const json_t *decides = chart_growth_family(result);
    struct phrase elements = chart_elements(result);
    json_t *scene = chart_of_growth(result);
    html_open(page, "div");
    html_attribute(page, "class", "measure");
    html_both_leaf(page, "h3", NULL,
                   (struct phrase){"Growth of the work", "Crecimiento del trabajo"});
    write_family_title(page, decides, growth);
    html_open(page, "div");
    html_attribute(page, "class", "two");
    if (scene)
        chart_draw(page, scene,
                   (struct phrase){"Instructions of submission and reference against size",
                                   "Instrucciones de la entrega y la referencia según el tamaño"});
    html_open(page, "div");
    html_attribute(page, "class", "scroll");
    html_attribute(page, "tabindex", "0");
    write_doubling_table(page, decides, elements);
    html_close(page, "div");
    html_close(page, "div");
    html_both_leaf(
        page, "p", "note",
        (struct phrase){"Sizes are about these: each class has its own, drawn at random.",
                        "Los tamaños son más o menos estos: cada clase tiene los suyos, "
                        "al azar."});
    size_t i;
    json_t *family;
    json_array_foreach(json_object_get(growth, "families"), i, family)
    {
        if (family == decides)
            continue;
        html_open(page, "details");
        html_open(page, "summary");
        html_leaf(page, "code", NULL, result_text(family, "name"));
        html_close(page, "summary");
        write_family_title(page, family, growth);
        write_doubling_table(page, family, elements);
        html_close(page, "details");
    }
    html_close(page, "div");
    json_decref(scene);
}

/* ---------------------------------------------------------------- memory and work */

void page_bar(struct html *page, const char *class_name, double value, double most)
{
    enum { WIDTH = 300, HEIGHT = 16 };
    double share = most > 0 && value > 0 ? value / most : 0;
    html_open(page, "td");
    html_open(page, "svg");
    html_attribute(page, "class", "bar-line");
    html_attribute(page, "aria-hidden", "true");
    html_attribute_format(page, "viewBox", "0 0 %d %d", WIDTH, HEIGHT);
    html_open(page, "rect");
    html_attribute(page, "class", class_name);
    html_attribute_format(page, "width", "%.1f", most > 0 ? 2 + (WIDTH - 2) * share : 0);
    html_attribute_format(page, "height", "%d", HEIGHT);
    html_attribute(page, "rx", "3");
    html_close(page, "rect");
    html_close(page, "svg");
    html_close(page, "td");
}

static void write_bar(struct html *page, const char *class_name, struct phrase label, double bytes,
                      double most)
{
    char text[32];
    words_of_bytes(bytes, text, sizeof text);
    html_open(page, "tr");
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    html_both(page, label);
    html_close(page, "th");
    page_bar(page, class_name, bytes, most);
    html_leaf(page, "td", NULL, text);
    html_close(page, "tr");
}

/* Which input the measure is of: "mesh, n = 27648". */
static void write_memory_input(struct html *page, const json_t *memory)
{
    const json_t *decides = json_array_get(json_object_get(memory, "families"), 0);
    size_t size_count = json_array_size(json_object_get(decides, "peak_bytes"));
    if (size_count > 0 &&
        number_at(decides, "peak_bytes", size_count - 1) == result_number(memory, "peak_bytes")) {
        html_leaf(page, "code", NULL, result_text(decides, "name"));
        html_text(page, ", ");
    }
    html_format(page, "n = %.0f", result_number(memory, "size"));
}

static void write_memory_chart(struct html *page, const json_t *result)
{
    json_t *scene = chart_of_memory(result);
    if (!scene)
        return;
    html_open(page, "div");
    html_open(page, "p");
    html_both(page, (struct phrase){"The same at all sizes of ", "Lo mismo en cada tamaño de "});
    html_leaf(page, "code", NULL, result_text(scene, "subtitle"));
    html_close(page, "p");
    chart_draw(page, scene,
               (struct phrase){"Peak memory of submission and reference against size",
                               "Memoria máxima de la entrega y la referencia según el tamaño"});
    html_close(page, "div");
    json_decref(scene);
}

/* `result` has the chart of building; NULL: there is none. */
static void write_memory(struct html *page, const json_t *memory, const json_t *result,
                         struct phrase title)
{
    double own = result_number(memory, "peak_bytes");
    double reference = result_number(memory, "reference_peak_bytes");
    double limit = reference * result_number(memory, "band");
    double most = own > limit ? own : limit;
    html_open(page, "div");
    html_attribute(page, "class", "measure");
    html_both_leaf(page, "h3", NULL, title);
    html_open(page, "p");
    write_memory_input(page, memory);
    html_format(page, ": %.2f ", result_number(memory, "ratio"));
    html_both(page, (struct phrase){"times the reference; allowed: ",
                                    "veces la referencia; se permiten: "});
    html_format(page, "%.6g", result_number(memory, "band"));
    if (json_object_get(memory, "allocations")) {
        double count = result_number(memory, "allocations");
        html_format(page, "; %.0f ", count);
        html_both(page, count == 1 ? (struct phrase){"allocation", "reserva"}
                                   : (struct phrase){"allocations", "reservas"});
    }
    html_close(page, "p");
    html_open(page, "div");
    html_attribute(page, "class", "two");
    html_open(page, "table");
    html_attribute(page, "class", "bars");
    html_open(page, "tbody");
    write_bar(page, "own", (struct phrase){"submission", "entrega"}, own, most);
    write_bar(page, "reference", (struct phrase){"reference", "referencia"}, reference, most);
    write_bar(page, "limit", (struct phrase){"allowed", "permitida"}, limit, most);
    html_close(page, "tbody");
    html_close(page, "table");
    if (result)
        write_memory_chart(page, result);
    html_close(page, "div");
    html_close(page, "div");
}

static void write_work(struct html *page, const json_t *work, struct phrase title)
{
    html_open(page, "p");
    html_attribute(page, "class", "work");
    html_both(page, title);
    html_format(page, "%.2f ", result_number(work, "ratio"));
    html_both(page, (struct phrase){"times the reference; allowed: ",
                                    "veces la referencia; se permiten: "});
    html_format(page, "%.6g", result_number(work, "band"));
    if (json_object_get(work, "instruction_ratio")) {
        html_both(page, (struct phrase){"; instructions × ", "; instrucciones × "});
        html_format(page, "%.2f", result_number(work, "instruction_ratio"));
    }
    if (json_object_get(work, "miss_ratio")) {
        html_both(page, (struct phrase){", cache misses × ", ", fallos de caché × "});
        html_format(page, "%.2f", result_number(work, "miss_ratio"));
    }
    html_close(page, "p");
}

/* What submission and reference accessed at the sizes of a family. */
static void write_access_table(struct html *page, const json_t *family, struct phrase elements)
{
    const struct phrase heads[] = {
        elements, {"accesses", "accesos"}, {"reference", "referencia"}, {"ratio", "cociente"}};
    html_open(page, "table");
    write_heads(page, heads, sizeof heads / sizeof *heads);
    html_open(page, "tbody");
    size_t count = json_array_size(json_object_get(family, "sizes"));
    for (size_t i = 0; i < count; i++) {
        double own = number_at(family, "accesses", i);
        double reference = number_at(family, "reference_accesses", i);
        html_open(page, "tr");
        write_size_cell(page, family, i);
        write_number_cell(page, "", own);
        write_number_cell(page, "", reference);
        write_ratio_cell(page, own, reference);
        html_close(page, "tr");
    }
    html_close(page, "tbody");
    html_close(page, "table");
}

static void write_accesses(struct html *page, const json_t *result, const json_t *accesses)
{
    size_t i;
    json_t *family;
    html_open(page, "div");
    html_attribute(page, "class", "measure");
    html_both_leaf(page, "h3", NULL,
                   (struct phrase){"Accesses to the structure", "Accesos a la estructura"});
    html_open(page, "p");
    html_attribute(page, "class", "accesses");
    html_both(page, (struct phrase){"At the largest size: ", "En el tamaño mayor: "});
    html_format(page, "%.2f ", result_number(accesses, "ratio"));
    html_both(page, (struct phrase){"times the reference; allowed: ",
                                    "veces la referencia; se permiten: "});
    html_format(page, "%.6g", result_number(accesses, "band"));
    html_close(page, "p");
    json_array_foreach(json_object_get(accesses, "families"), i, family)
    {
        html_open(page, "details");
        if (i == 0)
            html_flag(page, "open");
        html_open(page, "summary");
        html_leaf(page, "code", NULL, result_text(family, "name"));
        html_close(page, "summary");
        write_access_table(page, family, chart_elements(result));
        html_close(page, "details");
    }
    html_close(page, "div");
}

void page_measures(struct html *page, const json_t *result)
{
    const json_t *measures = json_object_get(result, "measures");
    bool has_growth = chart_growth_family(result) != NULL;
    const json_t *memory = json_object_get(measures, "memory");
    const json_t *work = json_object_get(measures, "work");
    const json_t *accesses = json_object_get(measures, "accesses");
    const json_t *query_work = json_object_get(measures, "query_work");
    const json_t *query_memory = json_object_get(measures, "query_memory");
    if (!has_growth && !memory && !work && !accesses)
        return;
    html_open(page, "details");
    html_attribute(page, "class", "measures");
    html_flag(page, "open");
    html_both_leaf(page, "summary", NULL, (struct phrase){"Work and memory", "Trabajo y memoria"});
    if (has_growth)
        write_growth(page, result);
    if (work)
        write_work(page, work,
                   (struct phrase){"Work at the largest size: ", "Trabajo en el tamaño mayor: "});
    if (query_work)
        write_work(page, query_work,
                   (struct phrase){"Work of queries at the largest size: ",
                                   "Trabajo de las consultas en el tamaño mayor: "});
    if (accesses)
        write_accesses(page, result, accesses);
    if (memory)
        write_memory(page, memory, result, (struct phrase){"Peak memory", "Memoria máxima"});
    if (query_memory)
        write_memory(page, query_memory, NULL,
                     (struct phrase){"Peak memory of queries", "Memoria máxima de las consultas"});
    html_close(page, "details");
}
