/* What the compiler says of itself; see compiler.h. The same command as in the build box. */
#include "graders/engine/build/compiler.h"

#include <limits.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FOLDERS_MOST = 15, LIBERTIES_SINCE = 14 };

static pthread_once_t asked = PTHREAD_ONCE_INIT;
static char rooms[FOLDERS_MOST][PATH_MAX + 2];
static const char *folders[FOLDERS_MOST + 1];
static int version;
static char chosen[16] = "gcc";

int compiler_choose(const char *name, struct error *err)
{
    char path[sizeof chosen + sizeof "/usr/bin/"];
    bool is_named = strcmp(name, "gcc") == 0 ||
                    (strncmp(name, "gcc-", 4) == 0 && strlen(name) < sizeof chosen &&
                     name[4 + strspn(name + 4, "0123456789")] == '\0');
    snprintf(path, sizeof path, "/usr/bin/%.*s", (int)sizeof chosen - 1, name);
    if (!is_named || access(path, X_OK) != 0)
        return error_set(err, "%s: no such compiler; name one in /usr/bin, as gcc-12", name);
    snprintf(chosen, sizeof chosen, "%s", name);
    return 0;
}

const char *compiler_name(void)
{
    return chosen;
}

/* What it answers to these arguments; NULL when it cannot be asked. */
static FILE *put_question(const char *arguments)
{
    char command[256];
    snprintf(command, sizeof command, "PATH=/usr/bin:/bin LC_ALL=C %s %s", chosen, arguments);
    return popen(command, "r");
}

/* gcc -v: each folder on a line of its own that begins with a blank. */
static void ask_folders(void)
{
    char line[PATH_MAX + 2];
    int count = 0;
    FILE *gcc = put_question("-E -Wp,-v -xc /dev/null 2>&1 >/dev/null");
    while (gcc && fgets(line, sizeof line, gcc)) {
        line[strcspn(line, "\n")] = '\0';
        if (line[0] == ' ' && line[1] == '/' && count < FOLDERS_MOST) {
            snprintf(rooms[count], sizeof rooms[count], "%s", line + 1);
            folders[count] = rooms[count];
            count++;
        }
    }
    if (gcc)
        pclose(gcc);
    if (count == 0) {
        folders[0] = "/usr/include";
        folders[1] = "/usr/lib/gcc";
    }
}

static void ask_version(void)
{
    char line[64];
    FILE *gcc = put_question("-dumpversion 2>/dev/null");
    if (gcc && fgets(line, sizeof line, gcc))
        version = atoi(line);
    if (gcc)
        pclose(gcc);
}

static void ask(void)
{
    ask_folders();
    ask_version();
}

const char *const *compiler_system_folders(void)
{
    pthread_once(&asked, ask);
    return folders;
}

const char *compiler_liberties(void)
{
    pthread_once(&asked, ask);
    return version >= LIBERTIES_SINCE
               ? "-Wno-return-mismatch -Wno-declaration-missing-parameter-type"
               : "";
}
