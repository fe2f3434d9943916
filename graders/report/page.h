/* The parts that the class page and the student pages share, and the two pages. */
#ifndef GRADERS_REPORT_PAGE_H
#define GRADERS_REPORT_PAGE_H

#include "graders/report/html.h"
#include "graders/report/results.h"

/* Where a page stands and what it needs. */
struct page_context {
    const char *out;               /* the report's folder */
    const char *up;                /* from the page to it: "" or "../" */
    bool has_three;                /* the library of the interactive view is in assets/ */
    const json_t *pictures_status; /* what report_pictures left, or NULL */
};

/* Everything from <html> to the start of <main>; `course` stands in the header. */
void page_begin(struct html *page, const struct page_context *context, const char *title,
                struct phrase course, bool has_views);
void page_end(struct html *page, const struct gradebook *book);

/* The symbol of an standing, with its word for those who do not see it. */
void page_symbol(struct html *page, enum standing standing);

/* "7.5 / 10" with the standing's colour; "not scored" for fault and flagged. */
void page_score(struct html *page, const json_t *result);

/* A label made from a verdict, coloured by its standing. */
void page_verdict(struct html *page, const char *verdict);

/* Whether a file below the report's folder exists. */
bool page_has_file(const struct page_context *context, const char *path);

/* An <img> in a link to itself, "<stem>.png" below the report's folder; where there is a
 * "<stem>.es.png", too, the page shows the one of its language. */
void page_picture(struct html *page, const struct page_context *context, const char *stem,
                  struct phrase alt);

/* The report's line when pictures are missing: "3 pictures of this class are missing: ...". */
void page_pictures_note(struct html *page, const struct page_context *context);

/* Layers that were active and inactive, and probes that were missing, over some results. */
void page_protections(struct html *page, json_t *const *results, size_t count);

/* Which results were made with other tools than the others (engine in the result): nothing where all
 * were made with the same. */
void page_tools(struct html *page, const struct gradebook *book);

/* The course that the results name, "Triangle meshes" where they name none. */
struct phrase page_course(const struct gradebook *book);

/* The two pages, from <html> to </html>. */
void page_class(struct html *page, const struct page_context *context,
                const struct gradebook *book);
void page_student(struct html *page, const struct page_context *context,
                  const struct gradebook *book, const struct student *student);

/* The section of most frequent causes of the class page. */
void page_causes(struct html *page, const struct gradebook *book);

/* A scene: its picture "<stem>.png" where there is one, the view, whose data is written beside it, and
 * the legend. */
void page_scene(struct html *page, const struct page_context *context, const char *stem,
                const json_t *scene, struct phrase message);

/* Makes OUT/assets, with all that pages load. *has_three: the library of the view is there, too.
 * root: the project's folder. Returns 0, or -1 and *err. */
int page_assets(const char *out, const char *root, bool *has_three, struct error *err) MUST_CHECK;

/* A rejected case of a student page: message, picture, view, command. */
void page_case(struct html *page, const struct page_context *context, const json_t *result,
               const json_t *one);

/* A cell with a bar: `value` of `most`; class_name is "own", "reference" or "limit". */
void page_bar(struct html *page, const char *class_name, double value, double most);

/* Quality of a result: each case beside the bands. Nothing when none was measured. */
void page_quality(struct html *page, const json_t *result);

/* Work and memory of a result: charts, doubling table, bars. Nothing when nothing was measured. */
void page_measures(struct html *page, const json_t *result);

#endif
