/* The class page's word on results that were made with different tools, such as another compiler:
 * which of them, so that nobody takes their marks for one measure. */
#include "graders/report/page.h"

static void name_tools(const json_t *engine, char *text, size_t capacity)
{
    const char *valgrind = result_text(engine, "valgrind");
    snprintf(text, capacity, "%s · %s · %s · layers: %s", result_text(engine, "compiler"),
             result_text(engine, "libc"), valgrind[0] ? valgrind : "no valgrind",
             result_text(engine, "layers"));
}

/* Adds a result to those of its tools; results of earlier versions do not tell theirs. */
static void add_result(json_t *sets, const json_t *result)
{
    char tools[2048], name[512];
    const json_t *engine = json_object_get(result, "engine");
    if (!json_object_get(engine, "libc"))
        return;
    name_tools(engine, tools, sizeof tools);
    snprintf(name, sizeof name, "%s (%s)", result_text(result, "student"),
             result_text(result, "exercise"));
    if (!json_object_get(sets, tools))
        json_object_set_new(sets, tools, json_array());
    json_array_append_new(json_object_get(sets, tools), json_string(name));
}

/* The tools of most results; of several, the first. */
static const char *usual_tools(json_t *sets)
{
    const char *tools, *usual = NULL;
    size_t most = 0;
    json_t *names;
    json_object_foreach(sets, tools, names)
    {
        if (json_array_size(names) <= most)
            continue;
        most = json_array_size(names);
        usual = tools;
    }
    return usual;
}

/* Who has the usual ones need not be named. */
static void write_set(struct html *page, const char *tools, const json_t *names, bool usual)
{
    struct message count;
    size_t i;
    const json_t *name;
    message_say(&count, " (%zu of the results)", " (%zu de los resultados)",
                json_array_size(names));
    html_open(page, "li");
    html_text(page, tools);
    html_both(page, message_phrase(&count));
    json_array_foreach(names, i, name)
    {
        if (usual)
            break;
        html_text(page, i ? ", " : ": ");
        html_text(page, json_string_value(name));
    }
    html_close(page, "li");
}

void page_tools(struct html *page, const struct gradebook *book)
{
    json_auto_t *sets = json_object();
    const char *tools;
    json_t *names;
    for (size_t s = 0; s < book->student_count; s++)
        for (size_t e = 0; e < book->exercise_count; e++)
            if (book->students[s].results[e])
                add_result(sets, book->students[s].results[e]);
    if (json_object_size(sets) < 2)
        return;
    const char *usual = usual_tools(sets);
    html_both_leaf(
        page, "h3", NULL,
        (struct phrase){"Made with different tools", "Hechos con herramientas distintas"});
    html_both_leaf(
        page, "p", NULL,
        (struct phrase){"These results are of more than one measure: near a limit, the same answer "
                        "could get another mark with other tools.",
                        "Estos resultados no son de una sola medida: cerca de un límite, la misma "
                        "respuesta podría tener otra nota con otras herramientas."});
    html_open(page, "ul");
    json_object_foreach(sets, tools, names)
    {
        write_set(page, tools, names, tools == usual);
    }
    html_close(page, "ul");
}
