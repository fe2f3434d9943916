/* The most frequent causes of lost points, an exercise at a time: how many students, an example in
 * the words that they read, and links to them. */
#include "graders/report/page.h"

#include "graders/report/causes.h"

#include <stdlib.h>

/* A few names stand open, many behind a line to open. */
static void write_students(struct html *page, const struct gradebook *book,
                           const struct book_exercise *exercise, const struct causes *causes,
                           const struct class_cause *cause)
{
    enum { OPEN_NAMES = 4 };
    bool is_long = cause->student_count > OPEN_NAMES;
    html_open(page, is_long ? "details" : "div");
    html_attribute(page, "class", "who");
    if (is_long)
        html_both_leaf(page, "summary", NULL, (struct phrase){"who", "quiénes"});
    bool is_first = true;
    for (size_t s = 0; s < book->student_count; s++) {
        if (!causes_touch(causes, cause, s))
            continue;
        char path[400];
        snprintf(path, sizeof path, "students/%s.html#%s", book->students[s].folder,
                 exercise->name);
        html_text(page, is_first ? "" : ", ");
        html_open(page, "a");
        html_path(page, "href", path);
        html_open(page, "bdi");
        html_json(page, book->students[s].name);
        html_close(page, "bdi");
        html_close(page, "a");
        is_first = false;
    }
    html_close(page, is_long ? "details" : "div");
}

static void write_cause(struct html *page, const struct gradebook *book,
                        const struct book_exercise *exercise, const struct causes *causes,
                        const struct class_cause *cause)
{
    char label[64];
    html_open(page, "li");
    html_open(page, "span");
    html_attribute(page, "class", "tally");
    html_format(page, "%zu", cause->student_count);
    html_both(page, (struct phrase){" of ", " de "});
    html_format(page, "%zu", causes->answer_count);
    html_close(page, "span");
    html_open(page, "div");
    html_both_leaf(page, "b", NULL, causes_name(cause, label, sizeof label));
    if (*cause->example.en) {
        html_open(page, "span");
        html_attribute(page, "class", "example");
        if (cause->student_count > 1)
            html_both(page, (struct phrase){"For example: ", "Por ejemplo: "});
        html_both(page, cause->example);
        html_close(page, "span");
    }
    write_students(page, book, exercise, causes, cause);
    html_close(page, "div");
    html_close(page, "li");
}

static int write_exercise(struct html *page, const struct gradebook *book, size_t exercise)
{
    enum { SHOWN = 6 };
    struct causes causes;
    struct error err = {""};
    if (causes_of(book, exercise, &causes, &err) != 0)
        return -1;
    if (causes.count > 0) {
        html_open(page, "section");
        html_open(page, "h3");
        html_format(page, "%s ", book->exercises[exercise].problem);
        html_both(page, book->exercises[exercise].title);
        html_close(page, "h3");
        html_open(page, "ol");
        html_attribute(page, "class", "causes");
        for (size_t i = 0; i < causes.count && i < SHOWN; i++)
            write_cause(page, book, &book->exercises[exercise], &causes, &causes.list[i]);
        html_close(page, "ol");
        html_close(page, "section");
    }
    causes_release(&causes);
    return 0;
}

void page_causes(struct html *page, const struct gradebook *book)
{
    html_both_leaf(page, "h2", NULL,
                   (struct phrase){"Most frequent causes", "Causas más frecuentes"});
    html_open(page, "div");
    html_attribute(page, "class", "cards");
    for (size_t e = 0; e < book->exercise_count; e++)
        if (write_exercise(page, book, e) != 0)
            page->fault = "out of memory for the causes";
    html_close(page, "div");
}
