/* Names of the verdicts; see verdict.h. */
#include "graders/engine/base/verdict.h"

#include <string.h>

static const struct {
    const char *name, *english, *spanish;
} verdicts[VERDICT_COUNT] = {
    [VERDICT_FAULT] = {"fault", "fault of the grader", "fallo del corrector"},
    [VERDICT_FLAGGED] = {"flagged", "held for review", "pendiente de revisión"},
    [VERDICT_COMPILE_ERROR] = {"compile-error", "does not compile", "no compila"},
    [VERDICT_FORBIDDEN_OPERATION] = {"forbidden-operation", "forbidden operation",
                                     "operación prohibida"},
    [VERDICT_OUT_OF_MEMORY] = {"out-of-memory", "out of memory", "memoria agotada"},
    [VERDICT_TOO_MANY_PROCESSES] = {"too-many-processes", "starts processes", "crea procesos"},
    [VERDICT_TOO_MUCH_OUTPUT] = {"too-much-output", "prints too much", "imprime demasiado"},
    [VERDICT_TOO_MUCH_DISK] = {"too-much-disk", "writes too much", "escribe demasiado"},
    [VERDICT_CPU_TIME] = {"cpu-time", "does not end in time", "no termina a tiempo"},
    [VERDICT_IDLE_TIME] = {"idle-time", "waits for ever", "espera sin fin"},
    [VERDICT_CRASH] = {"crash", "crashes", "se interrumpe"},
    [VERDICT_UNDEFINED_BEHAVIOUR] = {"undefined-behaviour", "undefined behaviour",
                                     "comportamiento indefinido"},
    [VERDICT_WRONG_ANSWER] = {"wrong-answer", "wrong answer", "respuesta incorrecta"},
    [VERDICT_LEAK] = {"leak", "leaks memory", "pierde memoria"},
    [VERDICT_GROWS_TOO_FAST] = {"grows-too-fast", "work grows too fast",
                                "el trabajo crece demasiado"},
    [VERDICT_TOO_MUCH_WORK] = {"too-much-work", "too much work", "demasiado trabajo"},
    [VERDICT_TOO_MUCH_MEMORY] = {"too-much-memory", "too much memory", "demasiada memoria"},
    [VERDICT_PASSED] = {"passed", "passed", "superado"},
    [VERDICT_NOT_MEASURED] = {"not-measured", "not measured", "no medido"},
    [VERDICT_NOT_REACHED] = {"not-reached", "not reached", "no alcanzado"},
};

const char *verdict_name(enum verdict verdict)
{
    return verdicts[verdict].name;
}

enum verdict verdict_of_name(const char *name)
{
    int verdict = 0;
    while (verdict < VERDICT_COUNT && strcmp(verdicts[verdict].name, name) != 0)
        verdict++;
    return (enum verdict)verdict;
}

const char *verdict_english(enum verdict verdict)
{
    return verdicts[verdict].english;
}

const char *verdict_spanish(enum verdict verdict)
{
    return verdicts[verdict].spanish;
}

enum verdict verdict_worse(enum verdict a, enum verdict b)
{
    return a < b ? a : b;
}
