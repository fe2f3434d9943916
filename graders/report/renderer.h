/* Starting meshgrade-render on a job, for a bounded time. */
#ifndef GRADERS_REPORT_RENDERER_H
#define GRADERS_REPORT_RENDERER_H

#include "graders/report/words.h"

#include <stddef.h>

enum renderer_end {
    RENDERER_DREW,   /* it ran to its end; some pictures may be missing */
    RENDERER_FAILED, /* it crashed or ran out of time on this job */
    RENDERER_USELESS /* it cannot draw here at all: no GL, cannot be started */
};

/* Runs the renderer on a job file and waits for it, at most limit_ms; then it is killed. Its own
 * talk goes nowhere.
 *
 * program  may be NULL: useless
 * reason   set when it did not end well, else left alone; static text */
enum renderer_end renderer_run(const char *program, const char *job_path, int limit_ms,
                               struct phrase *reason);

/* The limit for a job of that many pictures: 30 s, and 10 s a picture. */
int renderer_limit_ms(size_t picture_count);

/* Why pictures are missing: when the program is not there, and when nothing else is known. */
struct phrase renderer_absent_reason(void);
struct phrase renderer_default_reason(void);

#endif
