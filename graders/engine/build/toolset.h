/* The tools that marks rest on: with another compiler, libc or valgrind the same file may cost
 * another count, with other layers of the box it may get another verdict. Each result records them,
 * so that a class that is continued elsewhere is not mixed in silence. */
#ifndef GRADERS_ENGINE_BUILD_TOOLSET_H
#define GRADERS_ENGINE_BUILD_TOOLSET_H

#include "graders/box/box.h"

enum { TOOLSET_TEXT = 160, TOOLSET_LAYERS = 400 };

/* As each tells it itself; empty: not there. */
struct toolset {
    char compiler[TOOLSET_TEXT]; /* "gcc (Debian 12.2.0-14) 12.2.0" */
    char libc[TOOLSET_TEXT];     /* "ldd (Debian GLIBC 2.36-9+deb12u8) 2.36" */
    char valgrind[TOOLSET_TEXT]; /* "valgrind-3.19.0" */
    char layers[TOOLSET_LAYERS]; /* "all", or "all but landlock, cgroup-pids": of a build's box;
                                    empty: no box can be started */
};

/* Those of this machine, asked once; lives for ever. */
const struct toolset *toolset_here(void);

/* The layers of a bit set (1 << layer) as `layers` tells them. */
void toolset_name_layers(uint32_t active, char text[TOOLSET_LAYERS]);

#endif
