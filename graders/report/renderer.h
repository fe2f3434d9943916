/* Starting meshgrade-render on a job, within bounds. */
#ifndef GRADERS_REPORT_RENDERER_H
#define GRADERS_REPORT_RENDERER_H

#include "graders/report/words.h"

#include <stddef.h>

enum renderer_end {
    RENDERER_DREW,   /* it ran to its end; some pictures may be missing */
    RENDERER_FAILED, /* it crashed or was stopped on this job */
    RENDERER_USELESS /* it cannot draw here at all: no GL, cannot be started */
};

/* How long it may draw is no matter of the clock: on a busy machine it draws slowly. */
struct renderer_limits {
    int cpu_seconds; /* of all its threads together */
    int idle_ms;     /* for so long it may use no CPU at all */
};

/* Those for a job of that many pictures: 30 s, and 10 s a picture; idle for a minute. */
struct renderer_limits renderer_limits(size_t picture_count);

/* Runs the renderer on a job file and waits for it; beyond a limit it is killed. Its own talk goes
 * nowhere.
 *
 * program  may be NULL: useless
 * reason   set when it did not end well, else left alone; static text */
enum renderer_end renderer_run(const char *program, const char *job_path,
                               struct renderer_limits limits, struct phrase *reason);

/* Why pictures are missing: when the program is not there, and when nothing else is known. */
struct phrase renderer_absent_reason(void);
struct phrase renderer_default_reason(void);

#endif
