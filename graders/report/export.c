/* Chooses the exporter and the students; see report.h. */
#include "graders/report/export.h"

#include "graders/report/clean.h"
#include "graders/report/documents.h"
#include "graders/report/report.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    int (*write)(const struct export_job *job, struct error *err);
} formats[] = {
    {"csv", export_csv},     {"gradescope", export_gradescope},
    {"junit", export_junit}, {"vpl", export_vpl},
    {"json", export_json},
};
enum { FORMAT_COUNT = sizeof formats / sizeof *formats };

const char *const report_formats[] = {"csv", "gradescope", "junit", "vpl", "json", NULL};

json_t *report_results(const char *out, struct error *err)
{
    struct gradebook book;
    if (gradebook_load(out, &book, err) != 0)
        return NULL;
    json_t *all = json_incref(book.all);
    gradebook_release(&book);
    return all;
}

char *export_clean(const json_t *string, bool keep_lines)
{
    enum { LIMIT_BYTES = 20000 };
    return clean_text(json_string_value(string), json_string_length(string),
                      keep_lines ? CLEAN_BLOCK : CLEAN_LINE, LIMIT_BYTES);
}

int export_json(const struct export_job *job, struct error *err)
{
    json_t *all = json_array();
    for (size_t s = 0; all && s < job->book->student_count; s++)
        for (size_t e = 0; e < job->book->exercise_count; e++)
            if (job->book->students[s].results[e])
                json_array_append(all, job->book->students[s].results[e]);
    int status =
        all ? json_dumpf(all, job->to, JSON_INDENT(1) | JSON_ENSURE_ASCII | JSON_REAL_PRECISION(15))
            : -1;
    json_decref(all);
    fputc('\n', job->to);
    return status == 0 ? 0 : error_set(err, "the results cannot be written as JSON");
}

/* Keeps only the student of that name (or, rather, folder) in the book. */
static int select_student(struct gradebook *book, const char *wanted, struct error *err)
{
    size_t found = book->student_count;
    size_t matches = 0;
    for (size_t s = 0; s < book->student_count; s++) {
        if (strcmp(book->students[s].folder, wanted) == 0) {
            found = s;
            matches = 1;
            break;
        }
        if (strcmp(json_string_value(book->students[s].name), wanted) == 0) {
            found = s;
            matches++;
        }
    }
    if (matches != 1) {
        char *shown = clean_text(wanted, strlen(wanted), CLEAN_LINE, 100);
        error_set_request(
            err,
            matches
                ? "\"%s\" is the name of several students; give the folder's name below results/"
                : "no student is named \"%s\"",
            shown ? shown : "");
        free(shown);
        return -1;
    }
    book->students[0] = book->students[found];
    book->student_count = 1;
    return 0;
}

int report_export(const char *out, const char *format, const struct export_selection *selection,
                  FILE *to, struct error *err)
{
    size_t chosen = 0;
    while (chosen < FORMAT_COUNT && strcmp(formats[chosen].name, format) != 0)
        chosen++;
    if (chosen == FORMAT_COUNT)
        return error_set_request(
            err, "no export format \"%.40s\"; there are csv, gradescope, junit, vpl, json", format);
    struct gradebook book;
    if (gradebook_load(out, &book, err) != 0)
        return -1;
    struct export_job job = {.book = &book,
                             .one_student = selection->student != NULL,
                             .language = selection->language,
                             .to = to};
    int status = selection->student ? select_student(&book, selection->student, err) : 0;
    if (status == 0)
        status = formats[chosen].write(&job, err);
    if (status == 0 && (fflush(to) != 0 || ferror(to)))
        status = error_set(err, "the export cannot be written: %s", strerror(errno));
    gradebook_release(&book);
    return status;
}

int report_grades(const char *out, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    char *text = NULL;
    size_t length = 0;
    struct export_selection everyone = {0};
    FILE *to = open_memstream(&text, &length);
    if (!to)
        return error_set(err, "out of memory for grades.csv");
    int status = report_export(out, "csv", &everyone, to, err);
    if (fclose(to) != 0 && status == 0)
        status = error_set(err, "out of memory for grades.csv");
    if (status == 0)
        status = document_path(path, err, "%s/grades.csv", out);
    if (status == 0)
        status = document_write(path, text, length, err);
    free(text);
    return status;
}
