/* CSV after RFC 4180: one row a student. */
#include "graders/report/export.h"

#include <stdlib.h>
#include <string.h>

/* Whether a spreadsheet would compute a cell instead of showing it. Blanks before it do not save
 * it: some programs trim them. The full-width forms count too. */
static bool is_formula(const char *cell)
{
    static const char *const starts[] = {"=",  "+",  "-",  "@",  "\t", "\r",
                                         "\n", "＝", "＋", "－", "＠"};
    cell += strspn(cell, " ");
    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++)
        if (strncmp(cell, starts[i], strlen(starts[i])) == 0)
            return true;
    return false;
}

static int write_text(FILE *to, const json_t *string)
{
    char *cell = export_clean(string, false);
    if (!cell)
        return -1;
    bool quoted = is_formula(json_string_value(string)) || strpbrk(cell, ",\" '\r\n");
    if (quoted)
        fputc('"', to);
    if (is_formula(json_string_value(string)) || is_formula(cell))
        fputc('\'', to);
    for (const char *c = cell; *c; c++) {
        if (*c == '"')
            fputc('"', to);
        fputc(*c, to);
    }
    if (quoted)
        fputc('"', to);
    free(cell);
    return 0;
}

int export_csv(const struct export_job *job, struct error *err)
{
    const struct gradebook *book = job->book;
    char points[32];
    fputs("student", job->to);
    for (size_t e = 0; e < book->exercise_count; e++)
        fprintf(job->to, ",%s", book->exercises[e].name);
    fputs(",total\r\n", job->to);
    for (size_t s = 0; s < book->student_count; s++) {
        const struct student *student = &book->students[s];
        if (write_text(job->to, student->name) != 0)
            return error_set(err, "out of memory for a row of CSV");
        for (size_t e = 0; e < book->exercise_count; e++) {
            const json_t *score = json_object_get(student->results[e], "score");
            words_of_points(json_number_value(score), points, sizeof points);
            fprintf(job->to, ",%s", json_is_number(score) ? points : "");
        }
        words_of_points(student->score, points, sizeof points);
        fprintf(job->to, ",%s\r\n", student->unscored == 0 ? points : "");
    }
    return 0;
}
