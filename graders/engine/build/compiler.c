/* What the compiler says of itself; see compiler.h. The same command as in the build box. */
#include "graders/engine/build/compiler.h"

#include <limits.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FOLDERS_MOST = 15, LIBERTIES_SINCE = 14 };

#define ASK "PATH=/usr/bin:/bin LC_ALL=C gcc "

static pthread_once_t asked = PTHREAD_ONCE_INIT;
static char rooms[FOLDERS_MOST][PATH_MAX + 2];
static const char *folders[FOLDERS_MOST + 1];
static int version;

/* gcc -v: each folder on a line of its own that begins with a blank. */
static void ask_folders(void)
{
    char line[PATH_MAX + 2];
    int count = 0;
    FILE *gcc = popen(ASK "-E -Wp,-v -xc /dev/null 2>&1 >/dev/null", "r");
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
    FILE *gcc = popen(ASK "-dumpversion 2>/dev/null", "r");
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
