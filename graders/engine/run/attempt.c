/* One call in a fresh box; see attempt.h. */
#include "graders/engine/run/attempt.h"

#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct cause called_abort = {"abort", {"abort or assert", "abort o assert"}};
static const struct cause integer_division = {"division",
                                              {"division by zero", "división por cero"}};
static const struct cause illegal_instruction = {
    "illegal-instruction", {"unknown instruction", "instrucción desconocida"}};
static const struct cause broken_pipe = {"broken-pipe", {"broken pipe", "tubería rota"}};
static const struct cause wild_pointer = {"wild-pointer", {"invalid pointer", "puntero inválido"}};
static const struct cause stack_overflow = {"stack-overflow",
                                            {"stack overflow", "desbordamiento de pila"}};
static const struct cause input_misused = {
    "input", {"input changed or overrun", "entrada modificada o rebasada"}};
static const struct cause null_pointer = {"null-pointer", {"null pointer", "puntero nulo"}};
static const struct cause segmentation_fault = {
    "segmentation-fault", {"access to foreign memory", "acceso a memoria ajena"}};
static const struct cause memory_limit = {"memory-limit", {"memory limit", "límite de memoria"}};
static const struct cause output_limit = {"output-limit", {"output limit", "límite de salida"}};
static const struct cause disk_limit = {"disk-limit", {"disk limit", "límite de disco"}};
static const struct cause idle_limit = {"idle-limit",
                                        {"idle time limit", "límite de tiempo de espera"}};
static const struct cause called_exit = {"exit", {"ended the program", "terminó el programa"}};
static const struct cause broken_protocol = {"broken-protocol",
                                             {"damaged program", "programa dañado"}};
static const struct cause not_allocated = {
    "not-allocated", {"pointer not from malloc", "puntero que no es de malloc"}};
static const struct cause claims_out_of_memory = {
    "claims-out-of-memory", {"says that memory ran out", "dice que faltó memoria"}};
static const struct cause answer_too_long = {"answer-too-long",
                                             {"answer too long", "respuesta demasiado larga"}};

enum { BOX_OVERHEAD_BYTES = 64 << 20 };

const struct cause attempt_budget_spent = {"time-budget",
                                           {"time for all runs", "tiempo para todo"}};
const struct cause attempt_cpu_limit = {"cpu-limit", {"CPU time limit", "límite de tiempo de CPU"}};

static void set_cause(struct attempt *attempt, const struct cause *cause)
{
    snprintf(attempt->cause, sizeof attempt->cause, "%s", cause->slug);
    message_set_phrase(&attempt->cause_name, cause->name);
}

void attempt_say(struct attempt *attempt, enum verdict verdict, const struct cause *cause,
                 const char *en, const char *es, ...)
{
    va_list arguments;
    attempt->verdict = verdict;
    set_cause(attempt, cause);
    va_start(arguments, es);
    message_say_list(&attempt->message, en, es, arguments);
    va_end(arguments);
}

struct cause attempt_cause(const struct attempt *attempt)
{
    return (struct cause){attempt->cause, message_phrase(&attempt->cause_name)};
}

/* ------------------------------------------------------------------ deaths */

static void explain_signal(int signal_number, const struct control *claims, struct attempt *attempt)
{
    bool in_answer = claims->phase == PHASE_ANSWER;
    if (signal_number == SIGABRT)
        attempt_say(attempt, VERDICT_CRASH, &called_abort,
                    "Your function stopped the program with abort or a failed assert.",
                    "Tu función detuvo el programa con abort o con un assert que falla.");
    else if (signal_number == SIGFPE)
        attempt_say(attempt, VERDICT_CRASH, &integer_division,
                    "Your function divided an integer by zero.",
                    "Tu función dividió un entero por cero.");
    else if (signal_number == SIGILL || signal_number == SIGTRAP)
        attempt_say(attempt, VERDICT_CRASH, &illegal_instruction,
                    "Your function executed an instruction that this machine does not have.",
                    "Tu función ejecutó una instrucción que esta máquina no tiene.");
    else if (signal_number == SIGPIPE)
        attempt_say(attempt, VERDICT_CRASH, &broken_pipe,
                    "Your function wrote to a pipe that nobody reads.",
                    "Tu función escribió en una tubería que nadie lee.");
    else if (in_answer)
        attempt_say(attempt, VERDICT_CRASH, &wild_pointer,
                    "The pointer that your function returned cannot be read as far as its count "
                    "says.",
                    "El puntero que devuelve tu función no se puede leer hasta donde dice el "
                    "número de elementos.");
    else if (claims->fault == FAULT_STACK)
        attempt_say(attempt, VERDICT_CRASH, &stack_overflow,
                    "Your function used up the stack: recursion without end, or a huge local "
                    "array.",
                    "Tu función agotó la pila: recursión sin fin o una variable local enorme.");
    else if (claims->fault == FAULT_INPUT)
        attempt_say(attempt, VERDICT_CRASH, &input_misused,
                    "Your function wrote to its input, which is const, or read beyond its end.",
                    "Tu función escribió en su entrada, que es const, o leyó más allá de su fin.");
    else if (claims->fault == FAULT_NULL)
        attempt_say(attempt, VERDICT_CRASH, &null_pointer, "Your function followed a null pointer.",
                    "Tu función siguió un puntero nulo.");
    else
        attempt_say(attempt, VERDICT_CRASH, &segmentation_fault,
                    "Your function read or wrote memory that is not its own.",
                    "Tu función leyó o escribió memoria que no le pertenece.");
}

static void explain_refused_call(const struct box_outcome *outcome, struct attempt *attempt)
{
    const char *call = outcome->refused_call[0] ? outcome->refused_call : "?";
    const struct cause cause = {call, {call, call}};
    if (outcome->refused_is_process)
        attempt_say(attempt, VERDICT_TOO_MANY_PROCESSES, &cause,
                    "Your function tried to start a process or thread (system call %s).",
                    "Tu función intentó crear un proceso o hilo (llamada al sistema %s).", call);
    else
        attempt_say(attempt, VERDICT_FORBIDDEN_OPERATION, &cause,
                    "Your function asked the system for something that is not allowed: %s.",
                    "Tu función pidió al sistema algo que no está permitido: %s.",
                    outcome->refused_detail[0] ? outcome->refused_detail : call);
}

static void explain_out_of_memory(struct attempt *attempt)
{
    attempt_say(attempt, VERDICT_OUT_OF_MEMORY, &memory_limit,
                "Your function asked for more memory than it may have.",
                "Tu función pidió más memoria de la permitida.");
}

/* What a program's own doing can end it with: it may send itself no others. Under the tools it can
 * make pipes. */
static bool is_own_signal(int signal_number)
{
    static const int own[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGSYS, SIGPIPE};
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (own[i] == signal_number)
            return true;
    return false;
}

/* What kept the runner from getting ready and was not the submission's: NULL when nothing did. A
 * submission of odd static data can make libc itself give up before main. */
static const char *what_was_missing(const struct box_outcome *outcome)
{
    if (outcome->end == BOX_ENDED_KILLED)
        return "the runner was not ready in time; is the machine overloaded?";
    if (outcome->end != BOX_ENDED_EXIT)
        return NULL;
    if (outcome->exit_code == EXIT_NO_REGIONS)
        return "the runner could not map its memory; is memory short?";
    if (outcome->exit_code == EXIT_NOT_SECLUDED)
        return "the runner could not give up exec; does this kernel have seccomp filters?";
    return NULL;
}

int attempt_explain_death(enum call_end end, const struct control *claims,
                          const struct box_outcome *outcome, struct attempt *attempt,
                          struct error *err)
{
    bool killed_by_us = end == CALL_CPU || end == CALL_IDLE || end == CALL_SPENT;
    const char *missing = end == CALL_NOT_READY ? what_was_missing(outcome) : NULL;
    if (missing)
        return error_set(err, "%s", missing);
    if (outcome->end == BOX_ENDED_SIGNAL && !killed_by_us && !is_own_signal(outcome->signal))
        return error_set(err,
                         "the submission's program was killed by signal %d from outside its box; "
                         "is something on this machine ending processes, or is memory short?",
                         outcome->signal);
    if (outcome->end == BOX_ENDED_FORBIDDEN)
        explain_refused_call(outcome, attempt);
    else if (outcome->end == BOX_ENDED_MEMORY || claims->refused_count > 0)
        explain_out_of_memory(attempt);
    else if (outcome->end == BOX_ENDED_OUTPUT)
        attempt_say(attempt, VERDICT_TOO_MUCH_OUTPUT, &output_limit,
                    "Your function printed more than 1 MB.", "Tu función imprimió más de 1 MB.");
    else if (outcome->end == BOX_ENDED_DISK)
        attempt_say(attempt, VERDICT_TOO_MUCH_DISK, &disk_limit,
                    "Your function wrote too much to files.",
                    "Tu función escribió demasiado en archivos.");
    else if (end == CALL_SPENT)
        attempt_say(attempt, VERDICT_CPU_TIME, &attempt_budget_spent, ATTEMPT_SPENT_EN,
                    ATTEMPT_SPENT_ES, BUDGET_SECONDS);
    else if (end == CALL_CPU || outcome->end == BOX_ENDED_CPU)
        attempt_say(attempt, VERDICT_CPU_TIME, &attempt_cpu_limit,
                    "Your function did not end in time: a loop without end, or far too much work.",
                    "Tu función no terminó a tiempo: un bucle sin fin o demasiado trabajo.");
    else if (end == CALL_IDLE)
        attempt_say(attempt, VERDICT_IDLE_TIME, &idle_limit,
                    "Your function waited without working.", "Tu función esperó sin trabajar.");
    else if (outcome->end == BOX_ENDED_SIGNAL)
        explain_signal(outcome->signal, claims, attempt);
    else if (outcome->end == BOX_ENDED_EXIT)
        attempt_say(attempt, VERDICT_CRASH, &called_exit,
                    "Your function ended the program (exit code %d) instead of returning.",
                    "Tu función terminó el programa (código %d) en vez de retornar.",
                    outcome->exit_code);
    else
        attempt_say(attempt, VERDICT_CRASH, &broken_protocol,
                    "Your function damaged the program that called it.",
                    "Tu función dañó el programa que la llamó.");
    return 0;
}

/* ----------------------------------------------------------------- answers */

/* What the claims alone decide. Returns true when the judge need not be asked. */
static bool settle_by_claims(const struct session *session, struct attempt *attempt)
{
    const struct control *claims = &attempt->claims;
    if (claims->out_of_memory && claims->refused_count > 0)
        explain_out_of_memory(attempt);
    else if (claims->bad_free_count > 0)
        attempt_say(attempt, VERDICT_UNDEFINED_BEHAVIOUR, &not_allocated,
                    "A pointer that was not obtained from malloc (or was freed already) was freed: "
                    "return memory from malloc.",
                    "Se liberó un puntero que no procede de malloc (o ya liberado): devuelve "
                    "memoria obtenida con malloc.");
    else if (claims->out_of_memory)
        attempt_say(attempt, VERDICT_WRONG_ANSWER, &claims_out_of_memory,
                    "Your function says that memory ran out, but every request was granted.",
                    "Tu función dice que faltó memoria, pero se concedieron todas las peticiones.");
    else if (claims->answer_bytes > session->answer.capacity)
        attempt_say(attempt, VERDICT_WRONG_ANSWER, &answer_too_long,
                    "The answer has more elements than any right one can have.",
                    "La respuesta tiene más elementos de los que puede tener una correcta.");
    else
        return false;
    return true;
}

static struct usage usage_of(const struct control *claims)
{
    return (struct usage){.heap_peak_bytes = claims->heap_peak_bytes,
                          .heap_held_bytes = claims->heap_held_bytes,
                          .heap_left_bytes = claims->heap_left_bytes,
                          .allocation_count = claims->allocation_count,
                          .known = true,
                          .access_count = claims->access_count};
}

void attempt_take(struct attempt *attempt, struct examination *examination)
{
    const struct judgement *judgement = &examination->judgement;
    attempt->verdict = judgement->accepted      ? VERDICT_PASSED
                       : judgement->has_quality ? VERDICT_POOR_QUALITY
                                                : VERDICT_WRONG_ANSWER;
    attempt->quality = judgement->quality;
    attempt->has_quality = judgement->has_quality;
    snprintf(attempt->cause, sizeof attempt->cause, "%s", judgement->cause);
    attempt->cause_name = judgement->cause_name;
    attempt->element = judgement->element;
    attempt->message = judgement->message;
    attempt->scene = examination->scene;
    examination->scene = NULL;
}

/* `c` is the case whose class's band counts, NULL: none. */
static int judge_call(const struct inputs *inputs, const struct judge_case *c,
                      const struct input *input, const struct session *session,
                      struct attempt *attempt, struct error *err)
{
    if (settle_by_claims(session, attempt))
        return 0;
    size_t count = (size_t)attempt->claims.answer_bytes;
    unsigned char *copy = malloc(count + 1);
    if (!copy)
        return error_set(err, "out of memory for an answer of %zu bytes", count);
    memcpy(copy, session->answer.bytes, count);
    struct usage usage = usage_of(&attempt->claims);
    usage.known = !attempt->uncounted;
    struct examination examination;
    int result = examine(inputs->judge, c, (struct span){input->region.bytes, input->bytes},
                         (struct span){copy, count}, &usage, &examination, err);
    free(copy);
    if (result != 0)
        return -1;
    attempt_take(attempt, &examination);
    examination_release(&examination);
    return 0;
}

int attempt_judge(const struct inputs *inputs, const struct input *input,
                  const struct session *session, struct attempt *attempt, struct error *err)
{
    return judge_call(inputs, NULL, input, session, attempt, err);
}

/* --------------------------------------------------------------------- run */

static int start(const struct inputs *inputs, const struct build *build, const struct input *input,
                 struct session *session, struct error *err)
{
    int64_t heap_limit = inputs->exercise->memory_limit_bytes;
    struct session_plan plan = {
        .profile = BOX_RUN,
        .program_fd = build->program_fd[PROGRAM_PLAIN],
        .input = &input->region,
        .answer_bytes = input->answer_bound,
        .mode = MODE_PLAIN,
        .heap_limit_bytes = heap_limit,
        .memory_limit_bytes = (uint64_t)heap_limit + input->region.capacity + input->answer_bound +
                              BOX_OVERHEAD_BYTES,
        .cpu_seconds = 300,
        .budget = build->budget,
        .cpu = -1,
    };
    return session_start(session, &plan, err);
}

int attempt_run(const struct inputs *inputs, const struct build *build, size_t index,
                const struct call_limits *limits, struct attempt *attempt, struct error *err)
{
    const struct judge_case *c = &inputs->judge->cases[index];
    const struct input *input = &inputs->cases[index];
    struct session session;
    memset(attempt, 0, sizeof *attempt);
    if (start(inputs, build, input, &session, err) != 0)
        return -1;
    enum call_end end = session_call(&session, input->bytes, 0, limits);
    attempt->claims = session.claims;
    attempt->cpu_ns = session.call_cpu_ns;
    int result = session_end(&session, &attempt->outcome, err);
    session_output(&session, attempt->output, sizeof attempt->output);
    if (result == 0 && end == CALL_ANSWERED)
        result = judge_call(inputs, c, input, &session, attempt, err);
    else if (result == 0)
        result = attempt_explain_death(end, &attempt->claims, &attempt->outcome, attempt, err);
    session_release(&session);
    return result;
}

void attempt_release(struct attempt *attempt)
{
    json_decref(attempt->scene);
    attempt->scene = NULL;
}
