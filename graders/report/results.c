/* Reading a class's results into a table; see results.h. */
#include "graders/report/results.h"

#include "graders/report/check.h"
#include "graders/report/documents.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *result_text(const json_t *object, const char *key)
{
    const char *text = json_string_value(json_object_get(object, key));
    return text ? text : "";
}

double result_number(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

enum standing result_standing(const json_t *result)
{
    if (!result)
        return STANDING_ABSENT;
    enum standing standing = words_standing(result_text(result, "verdict"));
    double score = result_number(result, "score");
    if (standing == STANDING_UNSCORED)
        return standing;
    if (score >= result_number(result, "max_score"))
        return STANDING_PASSED;
    return score > 0 ? STANDING_PARTIAL : STANDING_FAILED;
}

/* ---------------------------------------------------------------- classes of cases */

struct not_run result_not_run(const json_t *result, const char *class_name)
{
    struct not_run not_run = {.reason = {"", ""}};
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        if (strcmp(result_text(one, "verdict"), "not-reached") != 0 ||
            (class_name && strcmp(result_text(one, "class"), class_name) != 0))
            continue;
        if (not_run.count++ == 0)
            not_run.reason = words_in(one, "message");
    }
    return not_run;
}

/* How many cases of a class there are, how many were run, and how many passed. */
struct tally {
    long long cases, run, passed;
};

static struct tally tally_of(const json_t *result, const json_t *class_entry)
{
    long long cases = json_integer_value(json_object_get(class_entry, "cases"));
    struct not_run not_run = result_not_run(result, result_text(class_entry, "name"));
    return (struct tally){cases, cases - (long long)not_run.count,
                          json_integer_value(json_object_get(class_entry, "passed"))};
}

enum standing result_class_standing(const json_t *result, const json_t *class_entry)
{
    double points = result_number(class_entry, "points");
    if (points >= result_number(class_entry, "max_points"))
        return STANDING_PASSED;
    if (points > 0)
        return STANDING_PARTIAL;
    return tally_of(result, class_entry).run <= 0 ? STANDING_ABSENT : STANDING_FAILED;
}

void result_class_tally(const json_t *result, const json_t *class_entry, struct message *tally)
{
    struct tally cases = tally_of(result, class_entry);
    if (cases.run <= 0)
        message_set_phrase(tally, (struct phrase){"not run", "sin ejecutar"});
    else if (cases.run < cases.cases)
        message_say(tally, "%lld of %lld, %lld not run", "%lld de %lld, %lld sin ejecutar",
                    cases.passed, cases.run, cases.cases - cases.run);
    else
        message_say(tally, "%lld of %lld", "%lld de %lld", cases.passed, cases.cases);
}

/* ---------------------------------------------------------------- the files */

static int load_file(const char *out, const char *folder, const char *file, json_t *all,
                     struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    struct error why = {""};
    if (document_path(path, err, "%s/results/%s/%s", out, folder, file) != 0)
        return -1;
    json_t *result = document_read_json(path, &why);
    if (result && result_check(result, &why) == 0) {
        char expected_file[160];
        snprintf(expected_file, sizeof expected_file, "%s.json", result_text(result, "exercise"));
        if (strcmp(expected_file, file) != 0 ||
            strcmp(result_text(result, "student_folder"), folder) != 0)
            error_set(&why, "is the result of %s/%s", result_text(result, "student_folder"),
                      expected_file);
    }
    if (why.text[0] == '\0' && json_array_append(all, result) != 0)
        error_set(&why, "out of memory");
    json_decref(result);
    if (why.text[0] == '\0')
        return 0;
    bool names_file = strncmp(why.text, path, strlen(path)) == 0;
    return error_set(err, "%s%s%s (not a sound result: delete it and run `meshgrade grade` again)",
                     names_file ? "" : path, names_file ? "" : ": ", why.text);
}

static int load_folder(const char *out, const char *folder, json_t *all, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    if (document_path(path, err, "%s/results/%s", out, folder) != 0)
        return -1;
    char **files = document_list(path, ".json", err);
    int status = files ? 0 : -1;
    for (size_t i = 0; status == 0 && files[i]; i++)
        status = load_file(out, folder, files[i], all, err);
    free(files);
    return status;
}

int gradebook_load(const char *out, struct gradebook *book, struct error *err)
{
    *book = (struct gradebook){0};
    char path[DOCUMENT_PATH_BYTES];
    if (document_path(path, err, "%s/results", out) != 0)
        return -1;
    char **folders = document_folders(path, err);
    json_t *all = json_array();
    int status = folders && all ? 0 : error_set(err, "out of memory for the results");
    for (size_t i = 0; status == 0 && folders && folders[i]; i++)
        status = load_folder(out, folders[i], all, err);
    if (status == 0 && json_array_size(all) == 0)
        status = error_set_request(
            err, "%s holds no results; run `meshgrade grade PATH... -o %s` first", path, out);
    if (status == 0)
        status = gradebook_from(all, book, err);
    json_decref(all);
    free(folders);
    return status;
}

/* ---------------------------------------------------------------- the table */

static int by_problem(const void *a, const void *b)
{
    const struct book_exercise *one = a;
    const struct book_exercise *other = b;
    int order = strverscmp(one->problem, other->problem);
    return order ? order : strcmp(one->name, other->name);
}

static int by_name(const void *a, const void *b)
{
    const struct student *one = a;
    const struct student *other = b;
    int order = strcasecmp(json_string_value(one->name), json_string_value(other->name));
    return order ? order : strcmp(one->folder, other->folder);
}

static struct book_exercise *find_exercise(struct gradebook *book, const char *name)
{
    for (size_t i = 0; i < book->exercise_count; i++)
        if (strcmp(book->exercises[i].name, name) == 0)
            return &book->exercises[i];
    return NULL;
}

static struct student *find_student(struct gradebook *book, const char *folder)
{
    for (size_t i = 0; i < book->student_count; i++)
        if (strcmp(book->students[i].folder, folder) == 0)
            return &book->students[i];
    return NULL;
}

static int collect(struct gradebook *book, struct error *err)
{
    size_t count = json_array_size(book->all);
    book->exercises = calloc(count + 1, sizeof *book->exercises);
    book->students = calloc(count + 1, sizeof *book->students);
    if (!book->exercises || !book->students)
        return error_set(err, "out of memory for %zu results", count);
    size_t i;
    json_t *result;
    json_array_foreach(book->all, i, result)
    {
        const char *name = result_text(result, "exercise");
        if (!find_exercise(book, name))
            book->exercises[book->exercise_count++] = (struct book_exercise){
                .name = name,
                .problem = result_text(result, "problem"),
                .title = words_in(result, "title"),
                .max_score = result_number(result, "max_score"),
            };
        if (!find_student(book, result_text(result, "student_folder")))
            book->students[book->student_count++] =
                (struct student){.name = json_object_get(result, "student"),
                                 .folder = result_text(result, "student_folder")};
    }
    qsort(book->exercises, book->exercise_count, sizeof *book->exercises, by_problem);
    qsort(book->students, book->student_count, sizeof *book->students, by_name);
    return 0;
}

static int place(struct gradebook *book, json_t *result, struct error *err)
{
    struct book_exercise *exercise = find_exercise(book, result_text(result, "exercise"));
    struct student *student = find_student(book, result_text(result, "student_folder"));
    if (!exercise || !student)
        return error_set(err, "a result is neither of a student nor of an exercise of the class");
    json_t **cell = &student->results[exercise - book->exercises];
    if (*cell)
        return error_set(err, "two results of %s for %s", exercise->name, student->folder);
    if (result_number(result, "max_score") != exercise->max_score)
        return error_set(
            err,
            "%s: the maximum score of %s is not the same as in other results (graded by "
            "another version? run `meshgrade grade --rejudge`)",
            student->folder, exercise->name);
    *cell = result;
    if (result_standing(result) == STANDING_UNSCORED)
        student->unscored++;
    return 0;
}

int gradebook_from(json_t *results, struct gradebook *book, struct error *err)
{
    *book = (struct gradebook){.all = json_incref(results)};
    int status = collect(book, err);
    if (status == 0) {
        book->cells = calloc(book->student_count * book->exercise_count + 1, sizeof(json_t *));
        if (!book->cells)
            status = error_set(err, "out of memory for %zu students", book->student_count);
    }
    for (size_t s = 0; status == 0 && s < book->student_count; s++)
        book->students[s].results = book->cells + s * book->exercise_count;
    size_t i;
    json_t *result;
    json_array_foreach(results, i, result)
    {
        if (status == 0)
            status = place(book, result, err);
    }
    for (size_t e = 0; status == 0 && e < book->exercise_count; e++) {
        book->max_score += book->exercises[e].max_score;
        for (size_t s = 0; s < book->student_count; s++)
            book->students[s].score += result_number(book->students[s].results[e], "score");
    }
    if (status != 0)
        gradebook_release(book);
    return status;
}

void gradebook_release(struct gradebook *book)
{
    free(book->cells);
    free(book->students);
    free(book->exercises);
    json_decref(book->all);
    *book = (struct gradebook){0};
}
