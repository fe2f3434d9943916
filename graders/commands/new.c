/* meshgrade new: the skeleton of an exercise, made from one that is there. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/commands/skeleton.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char USUAL[] = "edge-table-closed"; /* the one with the least of its own */

static void tell_path(const char *path)
{
    printf("%s\n", path);
}

/* Behind all others of the group, or of all when it is the group's first; the ten between two
 * exercises leave room. */
static int free_order(const struct exercise *exercises, int count, const char *group)
{
    int last = 0, of_group = 0;
    for (int i = 0; i < count; i++) {
        last = exercises[i].order > last ? exercises[i].order : last;
        if (strcmp(exercises[i].group, group) == 0 && exercises[i].order > of_group)
            of_group = exercises[i].order;
    }
    int order = of_group > 0 ? of_group : last;
    for (bool taken = true; taken;) {
        order++;
        taken = false;
        for (int i = 0; i < count; i++)
            taken |= exercises[i].order == order;
    }
    return order;
}

static void tell_what_next(const struct skeleton *skeleton)
{
    const char *group = skeleton->group, *name = skeleton->name;
    printf("\nThis is %s under the name %s: it builds and validates as it stands.\n"
           "  make && build/meshgrade validate %s\n\n"
           "Then, from the contract to its proof:\n",
           skeleton->like->name, name, name);
    printf("  1. exercises/%s/%s/\n"
           "     %s.h: what the function gets and gives back; exercise.json: title, classes and\n"
           "     points, which sum to 10; README.md, README.es.md, starter.c: the statement\n",
           group, name, name);
    printf("  2. reference/answers/%s/%s.c\n     a right, clear answer\n", group, name);
    printf("  3. graders/runner/%s/%s.c\n     how it is called: graders/runner/shapes.h\n", group,
           name);
    printf("  4. graders/judges/%s/%s.c\n     cases, what is answered, what is right: "
           "graders/library/library.h leads through\n",
           group, name);
    printf("  5. tests/submissions/%s/%s/\n     right answers in three ways; each mistake, as a "
           ".change of one\n"
           "     build/meshgrade validate %s --only wrong/NAME, then make mutants NAME=%s\n",
           group, name, name, name);
}

static int make_exercise(const struct exercise *exercises, int count, const char *like,
                         const char *text)
{
    struct skeleton skeleton = {.tell = tell_path};
    struct error err = {""};
    if (skeleton_name(text, &skeleton, &err) != 0) {
        fprintf(stderr, "meshgrade: %s\n", err.text);
        return EXIT_USAGE;
    }
    for (int i = 0; i < count; i++)
        if (strcmp(exercises[i].name, skeleton.name) == 0) {
            fprintf(stderr, "meshgrade: there is an exercise %s already, in group %s\n",
                    skeleton.name, exercises[i].group);
            return EXIT_USAGE;
        }
    skeleton.like = need_exercise(exercises, count, like);
    if (!skeleton.like)
        return EXIT_USAGE;
    skeleton.order = free_order(exercises, count, skeleton.group);
    if (skeleton_write(&skeleton, &err) != 0)
        return report_fault(&err);
    tell_what_next(&skeleton);
    return EXIT_PASSED;
}

static int run(int argc, char **argv)
{
    const char *like = USUAL;
    const struct option_rule rules[] = {
        {"like", 0, "EXERCISE", "what to begin from (edge-table-closed)", &like, NULL}, {0}};
    struct exercise *exercises = NULL;
    int count = 0, at = options_parse(&command_new, rules, argc, argv);
    if (at < 0 || argc - at != 1) {
        if (at >= 0)
            fprintf(stderr, "usage: meshgrade new GROUP/NAME [--like EXERCISE]\n");
        return EXIT_USAGE;
    }
    if (load_exercises(&exercises, &count) != 0)
        return EXIT_FAULT;
    int code = make_exercise(exercises, count, like, argv[at]);
    free(exercises);
    return code;
}

const struct command command_new = {"new", "GROUP/NAME", "the skeleton of an exercise", run};
