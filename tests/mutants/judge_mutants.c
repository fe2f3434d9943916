/* Judges mutants on the real path: built in the box, run case by case, then looked at by the
 * checks, until the first of these rejects.
 *
 *   judge_mutants EXERCISE JOBS [quick] <list-of-files
 *
 * With "quick" only the cases are run, and nothing is measured. Prints a line a file, in no order:
 * the file, a tab, the verdict, a tab, what decided. Exit code 2: the harness failed (a mutant
 * whose grading failed is a line "fault"). */
#include "graders/engine/base/files.h"
#include "graders/engine/run/cases.h"
#include "graders/engine/run/sized.h"
#include "graders/engine/run/sweep.h"
#include "graders/engine/run/trial.h"
#include "graders/engine/run/undefined.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { EXIT_FAULT = 2, SOURCE_BYTES = 1 << 20 };

/* What rejected a mutant. */
struct finding {
    enum verdict verdict;
    const char *by; /* name of a case or a check */
};

typedef int check_step(struct trial *trial, struct error *err);

static const struct {
    enum check_kind kind;
    check_step *step;
} steps[] = {{CHECK_UNDEFINED_BEHAVIOUR, undefined_check},
             {CHECK_ALLOCATION_FAILURE, sweep_check},
             {CHECK_GROWTH, sized_check}};

static int run_cases(struct trial *trial, struct finding *finding, struct error *err)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    for (size_t i = 0; i < judge->case_count; i++) {
        const struct attempt *attempt = &trial->cases[i].attempt;
        trial->scope.only_case = finding->by = judge->cases[i].name;
        if (cases_run(trial, err) != 0)
            return -1;
        finding->verdict = attempt->verdict;
        if (attempt->verdict == VERDICT_PASSED && attempt->claims.heap_left_bytes > 0)
            finding->verdict = VERDICT_LEAK;
        if (finding->verdict != VERDICT_PASSED)
            break;
    }
    trial->scope.only_case = NULL;
    return 0;
}

static int run_checks(struct trial *trial, struct finding *finding, struct error *err)
{
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        if (!trial->yardstick->inputs.exercise->checked[steps[i].kind])
            continue;
        if (steps[i].step(trial, err) != 0)
            return -1;
        for (int check = 0; check < CHECK_COUNT; check++) {
            enum verdict verdict = trial->checks[check].verdict;
            if (verdict == VERDICT_PASSED || verdict >= VERDICT_NOT_MEASURED)
                continue;
            *finding = (struct finding){verdict, check_name((enum check_kind)check)};
            return 0;
        }
    }
    return 0;
}

static int judge_one(struct yardstick *yardstick, const struct source *source,
                     struct finding *finding, struct error *err)
{
    struct trial trial = {
        .yardstick = yardstick, .student = "mutant", .sources = source, .source_count = 1};
    trial.cases = calloc(yardstick->inputs.judge->case_count, sizeof *trial.cases);
    if (!trial.cases)
        return error_set(err, "out of memory");
    for (int check = 0; check < CHECK_COUNT; check++)
        trial.checks[check].verdict = VERDICT_NOT_REACHED;
    *finding = (struct finding){VERDICT_COMPILE_ERROR, "build"};
    int result = build_submission(yardstick->inputs.exercise, source, 1,
                                  yardstick->quick ? BUILD_PLAIN : BUILD_ALL, &trial.build, err);
    if (result == 0 && !trial.build.refusal.refused) {
        result = run_cases(&trial, finding, err);
        if (result == 0 && finding->verdict == VERDICT_PASSED && !yardstick->quick)
            result = run_checks(&trial, finding, err);
    }
    trial_release(&trial);
    return result;
}

static void judge_file(struct yardstick *yardstick, const char *path)
{
    struct source source = {.name = "answer.c"};
    struct finding finding = {VERDICT_FAULT, ""};
    struct error err = {""};
    char *text = NULL, line[1024];
    if (file_read(path, SOURCE_BYTES, &text, &source.count, &err) == 0) {
        source.bytes = text;
        if (judge_one(yardstick, &source, &finding, &err) != 0)
            finding = (struct finding){VERDICT_FAULT, err.text};
    }
    int count = snprintf(line, sizeof line, "%s\t%s\t%.200s\n", path, verdict_name(finding.verdict),
                         finding.verdict == VERDICT_FAULT ? err.text : finding.by);
    if (write(STDOUT_FILENO, line, (size_t)count) != count)
        _exit(EXIT_FAULT);
    free(text);
}

/* One of the workers: every jobs-th file. */
_Noreturn static void work(struct yardstick *yardstick, char **paths, int count, int first,
                           int jobs)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (int i = first; i < count; i += jobs)
        judge_file(yardstick, paths[i]);
    _exit(0);
}

static int judge_all(struct yardstick *yardstick, char **paths, int count, int jobs)
{
    int code = 0, status;
    fflush(NULL);
    for (int job = 0; job < jobs; job++) {
        pid_t pid = fork();
        if (pid == 0)
            work(yardstick, paths, count, job, jobs);
        if (pid < 0)
            code = EXIT_FAULT;
    }
    while (wait(&status) > 0)
        if (status != 0)
            code = EXIT_FAULT;
    return code;
}

/* The lines of the standard input. The caller ends the process, which frees them. */
static char **read_paths(int *count)
{
    char **paths = NULL, *line = NULL;
    size_t capacity = 0;
    *count = 0;
    while (getline(&line, &capacity, stdin) > 0) {
        char **more = realloc(paths, (size_t)(*count + 1) * sizeof *paths);
        if (!more)
            return NULL;
        paths = more;
        line[strcspn(line, "\n")] = '\0';
        paths[(*count)++] = strdup(line);
    }
    free(line);
    return paths;
}

int main(int argc, char **argv)
{
    struct exercise *exercises;
    struct yardstick yardstick;
    struct error err = {""};
    int exercise_count, path_count;
    const char *root = project_root(&err);
    bool quick = argc == 4 && strcmp(argv[3], "quick") == 0;
    if ((argc != 3 && !quick) || !root ||
        exercises_read(root, &exercises, &exercise_count, &err) != 0) {
        fprintf(stderr, "usage: judge_mutants EXERCISE JOBS [quick] <list-of-files %s\n", err.text);
        return EXIT_FAULT;
    }
    const struct exercise *exercise = exercise_find(exercises, exercise_count, argv[1]);
    char **paths = read_paths(&path_count);
    int code = EXIT_FAULT;
    if (!exercise || !paths)
        fprintf(stderr, "judge_mutants: no exercise %s, or no files\n", argv[1]);
    else if (yardstick_make(&yardstick, exercise, seeds_of_class(SEED_PUBLISHED), quick, &err) !=
                 0 ||
             yardstick_make_cases(&yardstick, false, &err) != 0)
        fprintf(stderr, "judge_mutants: %s\n", err.text);
    else
        code = judge_all(&yardstick, paths, path_count, atoi(argv[2]));
    if (exercise && paths)
        yardstick_release(&yardstick);
    free(exercises);
    return code;
}
