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

/* Runs the renderer on a job file and waits for it, at most 30 s and 10 s a picture; then it is
 * killed. Its own talk goes nowhere.
 *
 * program        may be NULL: useless
 * picture_count  pictures in the job
 * reason         set when not everything was drawn, else left alone; static text */
enum renderer_end renderer_run(const char *program, const char *job_path, size_t picture_count,
                               struct words *reason);

/* Why pictures are missing: when the program is not there, and when nothing else is known. */
struct words renderer_absent_reason(void);
struct words renderer_default_reason(void);

#endif
