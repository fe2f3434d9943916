/* Asks the tools what they are; see toolset.h. */
#include "graders/engine/build/toolset.h"

#include "graders/engine/build/compiler.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

#define QUIETLY " --version 2>/dev/null"
#define HERE "PATH=/usr/bin:/bin LC_ALL=C "

static pthread_once_t asked = PTHREAD_ONCE_INIT;
static struct toolset here;

/* The first line that a command prints. */
static void ask_line(const char *command, char text[TOOLSET_TEXT])
{
    FILE *tool = popen(command, "r");
    if (!tool)
        return;
    if (!fgets(text, TOOLSET_TEXT, tool))
        text[0] = '\0';
    text[strcspn(text, "\n")] = '\0';
    pclose(tool);
}

void toolset_name_layers(uint32_t active, char text[TOOLSET_LAYERS])
{
    size_t used = (size_t)snprintf(text, TOOLSET_LAYERS, "all");
    const char *before = " but ";
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++) {
        if (active >> layer & 1 || used >= TOOLSET_LAYERS)
            continue;
        used += (size_t)snprintf(text + used, TOOLSET_LAYERS - used, "%s%s", before,
                                 box_layer_name((enum box_layer)layer));
        before = ", ";
    }
}

static void ask_layers(void)
{
    char name[] = "/bin/true";
    char *argv[] = {name, NULL};
    const struct box_plan plan = {.profile = BOX_BUILD,
                                  .argv = argv,
                                  .program_fd = -1,
                                  .input_fd = -1,
                                  .output_fd = -1,
                                  .error_fd = -1,
                                  .memory_bytes = 256 << 20,
                                  .file_bytes = 1 << 20,
                                  .scratch_bytes = 1 << 20,
                                  .stack_bytes = 8 << 20,
                                  .cpu_seconds = 5,
                                  .wall_ms = 60000,
                                  .process_count = 4,
                                  .cpu = -1};
    struct box_outcome outcome;
    struct error err = {""};
    if (box_run(&plan, &outcome, &err) == 0)
        toolset_name_layers(outcome.active, here.layers);
}

static void ask(void)
{
    char question[128];
    snprintf(question, sizeof question, HERE "%s" QUIETLY, compiler_name());
    ask_line(question, here.compiler);
    ask_line(HERE "ldd" QUIETLY, here.libc);
    ask_line(HERE "valgrind" QUIETLY, here.valgrind);
    ask_layers();
}

const struct toolset *toolset_here(void)
{
    pthread_once(&asked, ask);
    return &here;
}
