/* Reading callgrind's dumps; see callgrind.h.
 *
 * The lines that matter, in the order in which they come:
 *     part: 7
 *     desc: Trigger: Client Request: label
 *     positions: line
 *     events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw
 *     summary: 30554 2107 11074 33 0 190 33 0 190      what was collected; trailing zeros left out
 *     fn=(104) edge_table_any                          a function; later just fn=(104)
 *     17 5 2 1                                         its own cost at line 17; also +3, -2, *
 *     cfn=(226) calloc                                 a function that it calls
 *     calls=1 12                                       and then one line with the cost in there */
#include "bench/measure/callgrind.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EVENTS_MAX = 32, FUNCTIONS_MAX = 65536 };

static const int64_t COUNT_MAX = 1000000000000000;

/* The events that are wanted, by what they add to. */
enum event { EVENT_OTHER, EVENT_IR, EVENT_DR, EVENT_DW, EVENT_L1, EVENT_LL };

static const struct {
    const char *name;
    enum event event;
} known_events[] = {{"Ir", EVENT_IR},   {"Dr", EVENT_DR},   {"Dw", EVENT_DW},
                    {"I1mr", EVENT_L1}, {"D1mr", EVENT_L1}, {"D1mw", EVENT_L1},
                    {"ILmr", EVENT_LL}, {"DLmr", EVENT_LL}, {"DLmw", EVENT_LL}};

/* A piece of the text. */
struct slice {
    const char *at, *end;
};

struct function {
    struct slice name;
    int64_t instructions;
};

struct parser {
    struct slice rest;
    int line_number;
    enum event events[EVENTS_MAX];
    int event_count, position_count;
    bool has_part, has_summary;
    bool is_call;                        /* the next cost line is what a call took */
    int64_t callee;                      /* the function that it calls */
    const struct callgrind_calls *calls; /* that are looked for */
    struct function *functions;          /* by number */
    int64_t function_capacity, current;
    struct callgrind_dump *dump;
    struct error *err;
};

static int fail(struct parser *parser, const char *what)
{
    return error_set(parser->err, "callgrind dump, line %d: %s", parser->line_number, what);
}

static bool next_line(struct parser *parser, struct slice *line)
{
    if (parser->rest.at == parser->rest.end)
        return false;
    const char *end = memchr(parser->rest.at, '\n', (size_t)(parser->rest.end - parser->rest.at));
    line->at = parser->rest.at;
    line->end = end ? end : parser->rest.end;
    parser->rest.at = end ? end + 1 : parser->rest.end;
    parser->line_number++;
    return true;
}

/* Removes `prefix` from the front of the line, and the blanks after it, if it is there. */
static bool take(struct slice *line, const char *prefix)
{
    size_t length = strlen(prefix);
    if ((size_t)(line->end - line->at) < length || memcmp(line->at, prefix, length) != 0)
        return false;
    line->at += length;
    while (line->at < line->end && *line->at == ' ')
        line->at++;
    return true;
}

static bool next_word(struct slice *line, struct slice *word)
{
    while (line->at < line->end && *line->at == ' ')
        line->at++;
    word->at = line->at;
    while (line->at < line->end && *line->at != ' ')
        line->at++;
    word->end = line->at;
    return word->at < word->end;
}

/* Takes a decimal number from the front. */
static bool take_number(struct slice *text, int64_t *value)
{
    const char *start = text->at;
    *value = 0;
    while (text->at < text->end && *text->at >= '0' && *text->at <= '9') {
        *value = *value * 10 + (*text->at - '0');
        if (*value > COUNT_MAX)
            return false;
        text->at++;
    }
    return text->at > start;
}

static bool next_count(struct slice *line, int64_t *value)
{
    struct slice word;
    return next_word(line, &word) && take_number(&word, value) && word.at == word.end;
}

static void copy_name(char *out, size_t capacity, struct slice name)
{
    size_t length = (size_t)(name.end - name.at);
    if (length >= capacity)
        length = capacity - 1;
    for (size_t i = 0; i < length; i++)
        out[i] = name.at[i] >= ' ' && name.at[i] <= '~' ? name.at[i] : '?';
    out[length] = '\0';
}

static int read_events(struct parser *parser, struct slice line)
{
    struct slice word;
    bool has_instructions = false;
    parser->event_count = 0;
    while (next_word(&line, &word)) {
        if (parser->event_count == EVENTS_MAX)
            return fail(parser, "too many events");
        enum event event = EVENT_OTHER;
        for (size_t i = 0; i < sizeof known_events / sizeof known_events[0]; i++)
            if (strlen(known_events[i].name) == (size_t)(word.end - word.at) &&
                memcmp(known_events[i].name, word.at, (size_t)(word.end - word.at)) == 0)
                event = known_events[i].event;
        has_instructions |= event == EVENT_IR;
        parser->dump->has_misses |= event == EVENT_L1;
        parser->events[parser->event_count++] = event;
    }
    return has_instructions ? 0 : fail(parser, "no Ir among the events");
}

static int64_t *count_of(struct callgrind_counts *counts, enum event event)
{
    switch (event) {
    case EVENT_IR:
        return &counts->instructions;
    case EVENT_DR:
        return &counts->data_reads;
    case EVENT_DW:
        return &counts->data_writes;
    case EVENT_L1:
        return &counts->l1_misses;
    case EVENT_LL:
        return &counts->ll_misses;
    case EVENT_OTHER:
        break;
    }
    return NULL;
}

/* Adds a line of one count an event, trailing zeros left out. */
static int add_counts(struct parser *parser, struct slice line, struct callgrind_counts *counts)
{
    for (int i = 0; i < parser->event_count; i++) {
        int64_t value = 0;
        struct slice left = line, word;
        if (!next_word(&left, &word))
            break;
        if (!next_count(&line, &value))
            return fail(parser, "not a count, or above 10^15");
        int64_t *sum = count_of(counts, parser->events[i]);
        if (sum && __builtin_add_overflow(*sum, value, sum))
            return fail(parser, "counts that overflow");
    }
    return 0;
}

static int read_summary(struct parser *parser, struct slice line)
{
    if (!parser->event_count)
        return fail(parser, "summary before events");
    if (parser->has_summary)
        return fail(parser, "a second dump in the same file");
    parser->has_summary = true;
    return add_counts(parser, line, &parser->dump->counts);
}

static int read_positions(struct parser *parser, struct slice line)
{
    struct slice word;
    parser->position_count = 0;
    while (next_word(&line, &word))
        parser->position_count++;
    return parser->position_count == 1 || parser->position_count == 2
               ? 0
               : fail(parser, "positions should be line, instr or both");
}

/* The function of that number, with room made for it; NULL after an error. */
static struct function *function_at(struct parser *parser, int64_t number)
{
    if (number >= FUNCTIONS_MAX) {
        fail(parser, "a function number above 65,535");
        return NULL;
    }
    if (number >= parser->function_capacity) {
        int64_t capacity = parser->function_capacity ? parser->function_capacity : 256;
        while (capacity <= number)
            capacity *= 2;
        struct function *larger = realloc(parser->functions, (size_t)capacity * sizeof *larger);
        if (!larger) {
            fail(parser, "out of memory");
            return NULL;
        }
        memset(larger + parser->function_capacity, 0,
               (size_t)(capacity - parser->function_capacity) * sizeof *larger);
        parser->functions = larger;
        parser->function_capacity = capacity;
    }
    return &parser->functions[number];
}

/* `(104) edge_table_any`, `(104)`: remembers the name. */
static int read_function(struct parser *parser, struct slice line, int64_t *number)
{
    int64_t at;
    if (!take(&line, "(") || !take_number(&line, &at) || !take(&line, ")"))
        return fail(parser,
                    "a function without a number (run callgrind with --compress-strings=yes)");
    struct function *function = function_at(parser, at);
    if (!function)
        return -1;
    if (line.at < line.end)
        function->name = line;
    *number = at;
    return 0;
}

static bool is_name(struct slice slice, const char *name)
{
    size_t length = strlen(name);
    return slice.at && (size_t)(slice.end - slice.at) == length &&
           memcmp(slice.at, name, length) == 0;
}

/* Whether the function that was just called is in a list. */
static bool calls_one_of(const struct parser *parser, const char *const *names)
{
    for (; names && *names; names++)
        if (is_name(parser->functions[parser->callee].name, *names))
            return true;
    return false;
}

/* Where the call that was just read is added up; NULL: nowhere. */
static struct callgrind_counts *sum_of_call(const struct parser *parser)
{
    const struct callgrind_calls *calls = parser->calls;
    struct slice caller = parser->functions[parser->current].name;
    if (!calls_one_of(parser, calls->callees))
        return NULL;
    if (calls->caller && is_name(caller, calls->caller))
        return &parser->dump->called;
    return calls->preparer && is_name(caller, calls->preparer) ? &parser->dump->prepared : NULL;
}

/* `calls=2 17`: so many calls of the function that was named before, at line 17. */
static int read_calls(struct parser *parser, struct slice line)
{
    int64_t count;
    parser->is_call = true;
    if (parser->callee < 0)
        return fail(parser, "a call of no function");
    if (!calls_one_of(parser, parser->calls->accessors))
        return 0;
    if (!next_count(&line, &count))
        return fail(parser, "not a count of calls, or above 10^15");
    if (__builtin_add_overflow(parser->dump->access_count, count, &parser->dump->access_count))
        return fail(parser, "counts that overflow");
    return 0;
}

static int read_cost(struct parser *parser, struct slice line)
{
    struct slice word;
    bool is_call = parser->is_call;
    parser->is_call = false;
    for (int i = 0; i < parser->position_count; i++)
        if (!next_word(&line, &word))
            return fail(parser, "a cost line without a position");
    if (parser->current < 0)
        return fail(parser, "a cost before any function");
    if (is_call) {
        struct callgrind_counts *sum = sum_of_call(parser);
        return sum ? add_counts(parser, line, sum) : 0;
    }
    for (int i = 0; i < parser->event_count && next_word(&line, &word); i++) {
        int64_t value;
        if (!take_number(&word, &value))
            return fail(parser, "not a count, or above 10^15");
        int64_t *own = &parser->functions[parser->current].instructions;
        if (parser->events[i] == EVENT_IR && __builtin_add_overflow(*own, value, own))
            return fail(parser, "counts that overflow");
    }
    return 0;
}

static int read_line(struct parser *parser, struct slice line)
{
    if (take(&line, "events:"))
        return read_events(parser, line);
    if (take(&line, "positions:"))
        return read_positions(parser, line);
    if (take(&line, "summary:"))
        return read_summary(parser, line);
    if (take(&line, "part:")) {
        parser->has_part = next_count(&line, &parser->dump->part);
        return parser->has_part ? 0 : fail(parser, "not a part number");
    }
    if (take(&line, "desc: Trigger:")) {
        copy_name(parser->dump->trigger, sizeof parser->dump->trigger, line);
        if (take(&line, "Client Request:"))
            copy_name(parser->dump->label, sizeof parser->dump->label, line);
        return 0;
    }
    if (take(&line, "fn="))
        return read_function(parser, line, &parser->current);
    if (take(&line, "cfn="))
        return read_function(parser, line, &parser->callee);
    if (take(&line, "calls="))
        return read_calls(parser, line);
    if (line.at < line.end && strchr("0123456789+-*", *line.at) && *line.at)
        return read_cost(parser, line);
    return 0; /* objects, files, jumps and headers that are of no use here */
}

/* The functions with the most instructions of their own, most first; equal ones by number. */
static void find_hottest(struct parser *parser)
{
    struct callgrind_dump *dump = parser->dump;
    for (int64_t i = 0; i < parser->function_capacity; i++) {
        const struct function *function = &parser->functions[i];
        int at = dump->hottest_count;
        while (at > 0 && dump->hottest[at - 1].instructions < function->instructions)
            at--;
        if (function->instructions == 0 || at == CALLGRIND_HOTTEST)
            continue;
        int last =
            dump->hottest_count < CALLGRIND_HOTTEST ? dump->hottest_count++ : CALLGRIND_HOTTEST - 1;
        memmove(&dump->hottest[at + 1], &dump->hottest[at],
                (size_t)(last - at) * sizeof dump->hottest[0]);
        copy_name(dump->hottest[at].name, CALLGRIND_NAME, function->name);
        dump->hottest[at].instructions = function->instructions;
    }
}

int callgrind_parse_calls(const char *text, size_t bytes, const struct callgrind_calls *calls,
                          struct callgrind_dump *dump, struct error *err)
{
    *dump = (struct callgrind_dump){0};
    if (!bytes)
        text = "";
    struct parser parser = {.rest = {text, text + bytes},
                            .position_count = 1,
                            .current = -1,
                            .callee = -1,
                            .calls = calls,
                            .dump = dump,
                            .err = err};
    struct slice line;
    int result = 0;
    while (result == 0 && next_line(&parser, &line))
        result = read_line(&parser, line);
    if (result == 0 && (!parser.has_part || !parser.has_summary))
        result = fail(&parser, "the dump ends before its part: and summary: lines");
    if (result == 0)
        find_hottest(&parser);
    free(parser.functions);
    return result;
}

int callgrind_parse(const char *text, size_t bytes, struct callgrind_dump *dump, struct error *err)
{
    static const struct callgrind_calls none = {0};
    return callgrind_parse_calls(text, bytes, &none, dump, err);
}

int64_t callgrind_cost(const struct callgrind_counts *counts)
{
    return counts->instructions + 10 * counts->l1_misses + 100 * counts->ll_misses;
}
