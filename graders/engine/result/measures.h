/* The `measures` of a result: what was counted, as JSON. */
#ifndef GRADERS_ENGINE_RESULT_MEASURES_H
#define GRADERS_ENGINE_RESULT_MEASURES_H

#include "graders/engine/run/trial.h"

#include <jansson.h>

/* A new object with the keys growth, work, memory and quality, each only when it was measured. */
json_t *measures_json(const struct trial *trial);

#endif
