/* Names of the verdicts; see verdict.h. */
#include "graders/engine/base/verdict.h"

#include <string.h>

static const struct {
    const char *name;
    struct phrase words;
    enum standing standing;
} verdicts[VERDICT_COUNT] = {
    [VERDICT_FAULT] = {"fault", {"fault of the grader", "fallo del corrector"}, STANDING_UNSCORED},
    [VERDICT_FLAGGED] = {"flagged",
                         {"held for a person", "pendiente de revisión"},
                         STANDING_UNSCORED},
    [VERDICT_COMPILE_ERROR] = {"compile-error",
                               {"does not compile", "no compila"},
                               STANDING_FAILED},
    [VERDICT_FORBIDDEN_OPERATION] = {"forbidden-operation",
                                     {"forbidden operation", "operación prohibida"},
                                     STANDING_FAILED},
    [VERDICT_OUT_OF_MEMORY] = {"out-of-memory",
                               {"out of memory", "memoria agotada"},
                               STANDING_FAILED},
    [VERDICT_TOO_MANY_PROCESSES] = {"too-many-processes",
                                    {"too many processes", "demasiados procesos"},
                                    STANDING_FAILED},
    [VERDICT_TOO_MUCH_OUTPUT] = {"too-much-output",
                                 {"too much output", "demasiada salida"},
                                 STANDING_FAILED},
    [VERDICT_TOO_MUCH_DISK] = {"too-much-disk",
                               {"too much disk", "demasiado disco"},
                               STANDING_FAILED},
    [VERDICT_CPU_TIME] = {"cpu-time",
                          {"CPU time limit", "límite de tiempo de CPU"},
                          STANDING_FAILED},
    [VERDICT_IDLE_TIME] = {"idle-time",
                           {"idle time limit", "límite de tiempo de espera"},
                           STANDING_FAILED},
    [VERDICT_CRASH] = {"crash", {"crash", "el programa se rompió"}, STANDING_FAILED},
    [VERDICT_UNDEFINED_BEHAVIOUR] = {"undefined-behaviour",
                                     {"undefined behaviour", "comportamiento indefinido"},
                                     STANDING_FAILED},
    [VERDICT_WRONG_ANSWER] = {"wrong-answer",
                              {"wrong answer", "respuesta incorrecta"},
                              STANDING_FAILED},
    [VERDICT_LEAK] = {"leak", {"memory leak", "fuga de memoria"}, STANDING_FAILED},
    [VERDICT_GROWS_TOO_FAST] = {"grows-too-fast",
                                {"grows too fast", "crece demasiado"},
                                STANDING_FAILED},
    [VERDICT_TOO_MUCH_WORK] = {"too-much-work",
                               {"too much work", "demasiado trabajo"},
                               STANDING_FAILED},
    [VERDICT_TOO_MUCH_MEMORY] = {"too-much-memory",
                                 {"too much memory", "demasiada memoria"},
                                 STANDING_FAILED},
    [VERDICT_POOR_QUALITY] = {"poor-quality", {"poor quality", "poca calidad"}, STANDING_FAILED},
    [VERDICT_PASSED] = {"passed", {"passed", "superado"}, STANDING_PASSED},
    [VERDICT_NOT_MEASURED] = {"not-measured", {"not measured", "no medido"}, STANDING_ABSENT},
    [VERDICT_NOT_REACHED] = {"not-reached", {"not reached", "no se llegó"}, STANDING_ABSENT},
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

struct phrase verdict_words(enum verdict verdict)
{
    return verdicts[verdict].words;
}

enum standing verdict_standing(enum verdict verdict)
{
    return verdicts[verdict].standing;
}
