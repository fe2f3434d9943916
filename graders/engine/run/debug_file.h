/* The one debug file without which valgrind does not start a dynamic program. */
#ifndef GRADERS_ENGINE_RUN_DEBUG_FILE_H
#define GRADERS_ENGINE_RUN_DEBUG_FILE_H

#include <stdbool.h>
#include <stddef.h>

/* Where distributions put the debug files of the system's libraries. */
#define DEBUG_FILE_FOLDER "/usr/lib/debug"

/* The debug file of the dynamic linker, by its build id, as Debian's libc6-dbg lays it out.
 *
 * Valgrind reads every debug file that it finds for the libraries of its program, and reading
 * libc's takes as long as all the rest of its start; but it needs none except this one.
 *
 * path     gets its absolute name, below DEBUG_FILE_FOLDER
 * returns  false when there is none: another layout, or not installed */
bool debug_file_of_linker(char *path, size_t capacity);

#endif
