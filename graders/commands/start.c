/* meshgrade start: statement, header and starter of an exercise, for a student. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/engine/base/exercise.h"
#include "graders/engine/base/files.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* Copies one file unless it is there already: a student's work is never overwritten. */
static int copy(const struct exercise *exercise, const char *from_name, const char *folder,
                const char *to_name, struct error *err)
{
    char from[PATH_MAX + 128], to[PATH_MAX + 128];
    char *bytes;
    size_t count;
    snprintf(from, sizeof from, "%s/%s", exercise->folder, from_name);
    snprintf(to, sizeof to, "%s/%s", folder, to_name);
    if (access(to, F_OK) == 0) {
        fprintf(stderr, "%s is there already: left as it is\n", to);
        return 0;
    }
    if (file_read(from, 1 << 20, &bytes, &count, err) != 0)
        return -1;
    int result = file_write(to, bytes, count, err);
    free(bytes);
    if (result == 0)
        printf("%s\n", to);
    return result;
}

/* Names by exercise: several can be in one folder. */
static int copy_all(const struct exercise *exercise, const char *folder, struct error *err)
{
    char header[EXERCISE_NAME + 8], source[EXERCISE_NAME + 8];
    char english[EXERCISE_NAME + 8], spanish[EXERCISE_NAME + 8];
    snprintf(header, sizeof header, "%s.h", exercise->name);
    snprintf(source, sizeof source, "%s.c", exercise->name);
    snprintf(english, sizeof english, "%s.md", exercise->name);
    snprintf(spanish, sizeof spanish, "%s.es.md", exercise->name);
    return folder_make(folder, err) != 0 ||
                   copy(exercise, "README.md", folder, english, err) != 0 ||
                   copy(exercise, "README.es.md", folder, spanish, err) != 0 ||
                   copy(exercise, header, folder, header, err) != 0 ||
                   copy(exercise, "starter.c", folder, source, err) != 0
               ? -1
               : 0;
}

static int run(int argc, char **argv)
{
    const struct option_rule rules[] = {{0}};
    struct exercise *exercises = NULL;
    struct error err = {""};
    int count = 0;
    int at = options_parse(&command_start, rules, argc, argv);
    if (at < 0 || at >= argc || argc - at > 2) {
        fprintf(stderr, "usage: meshgrade start EXERCISE [FOLDER]\n");
        return EXIT_USAGE;
    }
    if (load_exercises(&exercises, &count) != 0)
        return EXIT_FAULT;
    const struct exercise *exercise = need_exercise(exercises, count, argv[at]);
    int code = exercise ? EXIT_PASSED : EXIT_USAGE;
    if (exercise) {
        const char *folder = at + 1 < argc ? argv[at + 1] : exercise->name;
        if (copy_all(exercise, folder, &err) != 0) {
            code = report_fault(&err);
        } else {
            printf("Write %s/%s.c, then: meshgrade check %s %s/%s.c\n", folder, exercise->name,
                   exercise->name, folder, exercise->name);
        }
    }
    free(exercises);
    return code;
}

const struct command command_start = {"start", "EXERCISE [FOLDER]",
                                      "statement, header and starter for a student", run};
