/* What is made from a finished folder of results (README.md here): pictures, pages, gradebooks.
 * Nothing here knows how grading is done; the results and scenes on disk are all the input there
 * is, and each is checked before it is used. */
#ifndef GRADERS_REPORT_REPORT_H
#define GRADERS_REPORT_REPORT_H

#include "reference/base/error.h"
#include "reference/base/phrase.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

/* Every result of the class, sorted by folder and exercise: a new array. A result that cannot be
 * read or is not sound is an error that names it, as is a class without any: NULL and *err. */
json_t *report_results(const char *out, struct error *err) MUST_CHECK;

/* Draws every scene below OUT/pictures whose picture is absent or older than it, charts of growth
 * and memory (OUT/pictures/<student>/<exercise>/growth.json and memory.json are written here), a
 * contact sheet a student (sheet.png) and one of the class (class.png).
 *
 * renderer_path  the program meshgrade-render; may be NULL or absent
 * returns        how many pictures were drawn now, sheets included; -1 and *err when OUT cannot be
 * read or written. That there is no renderer or no GL is no error: it is written into
 *                OUT/pictures/status.json, and the pages say it
 * cost           one process of the renderer a student, each ended after 30 s and 10 s a picture, of CPU time */
int report_pictures(const char *out, const char *renderer_path, struct error *err) MUST_CHECK;

/* The reason why the last report_pictures of this folder left pictures undrawn, in English, into
 * `text` (empty: all are drawn). For the command line to print. */
void report_pictures_reason(const char *out, char *text, size_t capacity);

/* Writes OUT/index.html, OUT/students/<student_folder>.html, OUT/assets/ and, beside each scene,
 * the script that the interactive view loads. The folder is complete in itself and opens from
 * file://.
 *
 * root  the tree that holds graders/report/page.css, page.js, viewer.js and viewer_scene.js.
 * Debian's libjs-three is copied into assets/ when it is installed; without it the pages have
 * pictures and no interactive views. */
int report_pages(const char *out, const char *root, struct error *err) MUST_CHECK;

struct export_selection {
    const char *student;    /* name or folder; NULL: every student */
    enum language language; /* of the texts */
};

/* Writes the results in a format to `to`.
 *
 *   csv         RFC 4180, a header, one row a student: student, each exercise's score, total. A
 * cell is empty where nothing was submitted or is not scored; the total is empty when any answer is
 * not scored. Cells that a spreadsheet would take for a formula start with an apostrophe gradescope
 * results.json of one student, else an object of them keyed by student junit       JUnit XML: a
 * suite for each student and exercise, a case for each case and check vpl         Moodle VPL:
 * comments and a last line `Grade :=>> N`; of one student only json        the results as they are,
 * in one array
 *
 * returns  0; -1 and *err for an unknown format or student, unsound results, or a failed write */
int report_export(const char *out, const char *format, const struct export_selection *selection,
                  FILE *to, struct error *err) MUST_CHECK;

/* The formats of report_export, NULL-terminated, for help texts. */
extern const char *const report_formats[];

/* Writes OUT/grades.csv: report_export's csv of the class. */
int report_grades(const char *out, struct error *err) MUST_CHECK;

#endif
