/* See known_program.h. */
#include "tests/unit/known_program.h"

#include "graders/engine/base/files.h"
#include "graders/engine/build/wrapped.h"

#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { ANSWER_BYTES = 4096, MEMORY_BYTES = 256 << 20, CPU_SECONDS = 30 };

static const char COMMAND[] =
    "cd '%s' && gcc -O1 -w -static %s -I'%s/exercises/edges/edge-table-any' -c known.c -o known.o "
    "&& objcopy" WRAPPED_OBJECT " known.o && gcc -static known.o "
    "'%s/build/runner/edges/edge-table-any.plain.o' -o known " WRAPPED_LINK;

void known_program_build(struct known_program *program, const char *source, const char *options)
{
    char path[PATH_MAX + 16], command[4 * PATH_MAX];
    struct error err = {""};
    const char *root = project_root(&err);
    assert_non_null(root);
    assert_int_equal(folder_make_work(program->folder, &err), 0);
    snprintf(path, sizeof path, "%s/known.c", program->folder);
    assert_int_equal(file_write(path, source, strlen(source), &err), 0);
    snprintf(command, sizeof command, COMMAND, program->folder, options, root, root);
    assert_int_equal(system(command), 0);
    snprintf(path, sizeof path, "%s/known", program->folder);
    program->fd = open(path, O_RDONLY | O_CLOEXEC);
    assert_true(program->fd >= 0);
    assert_int_equal(region_make(&program->input, KNOWN_INPUT_BYTES, true, &err), 0);
}

void known_program_release(struct known_program *program)
{
    region_release(&program->input);
    close(program->fd);
    folder_remove_work(program->folder);
}

struct session_plan known_program_plan(const struct known_program *program)
{
    return (struct session_plan){.profile = BOX_RUN,
                                 .program_fd = program->fd,
                                 .input = &program->input,
                                 .answer_bytes = ANSWER_BYTES,
                                 .memory_limit_bytes = MEMORY_BYTES,
                                 .cpu_seconds = CPU_SECONDS,
                                 .cpu = -1};
}
