/* Reads and applies changes; see change.h. */
#include "graders/known/change.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_BYTES = 60 };

/* A line without its end. */
struct line {
    const char *text;
    size_t length;
};

/* A text: its first comment, and the lines behind it. */
struct source {
    const char *name;
    const char *comment;
    size_t comment_bytes;
    int comment_lines;
    struct line *lines; /* owned */
    int count;
};

/* ----------------------------------------------------------------- reading */

static int count_line_ends(const char *text, size_t count)
{
    int found = 0;
    for (size_t i = 0; i < count; i++)
        found += text[i] == '\n';
    return found;
}

/* The end of the comment that the text begins with; NULL when it does not begin with one. */
static const char *comment_end(const char *text, size_t count)
{
    if (count < 4 || memcmp(text, "/*", 2) != 0)
        return NULL;
    const char *end = memmem(text + 2, count - 2, "*/", 2);
    return end ? end + 2 : NULL;
}

static int split_lines(struct source *source, const char *at, size_t left, struct error *err)
{
    source->lines = calloc((size_t)count_line_ends(at, left) + 1, sizeof *source->lines);
    if (!source->lines)
        return error_set(err, "%s: out of memory", source->name);
    while (left > 0) {
        const char *end = memchr(at, '\n', left);
        size_t length = end ? (size_t)(end - at) : left, taken = length + (end != NULL);
        source->lines[source->count++] = (struct line){at, length};
        at += taken;
        left -= taken;
    }
    return 0;
}

static int read_source(const struct change_text *text, struct source *source, struct error *err)
{
    *source = (struct source){.name = text->name, .comment = text->bytes};
    if (text->count > INT_MAX / 2)
        return error_set(err, "%s: too large for a submission", text->name);
    const char *end = comment_end(text->bytes, text->count);
    if (!end)
        return error_set(err,
                         "%s:1: does not begin with a comment; put one there that says what "
                         "the submission does",
                         text->name);
    source->comment_bytes = (size_t)(end - text->bytes);
    source->comment_lines = count_line_ends(text->bytes, source->comment_bytes) + 1;
    size_t left = text->count - source->comment_bytes;
    if (left > 0 && *end != '\n')
        return error_set(err, "%s:%d: text behind the first comment; begin a new line there",
                         text->name, source->comment_lines);
    return left > 0 ? split_lines(source, end + 1, left - 1, err)
                    : split_lines(source, end, 0, err);
}

/* Whether it is <kind>/<file>.c: no way out of the exercise's folder. */
static bool is_file_of_exercise(const char *name)
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "._-";
    size_t kind = strspn(name, allowed), length = strlen(name);
    if (kind == 0 || name[kind] != '/' || name[0] == '.')
        return false;
    size_t file = strspn(name + kind + 1, allowed);
    return file > 2 && kind + 1 + file == length && name[kind + 1] != '.' &&
           strcmp(name + length - 2, ".c") == 0;
}

int change_find_base(const struct change_text *change, char base[CHANGE_BASE_BYTES],
                     struct error *err)
{
    const char *at = change->bytes, *end = comment_end(change->bytes, change->count);
    for (int number = 1; end && at < end; number++) {
        const char *line_end = memchr(at, '\n', (size_t)(end - at));
        const char *next = line_end ? line_end + 1 : end;
        while (at < next && (*at == ' ' || *at == '*' || *at == '/'))
            at++;
        if (next - at > 3 && memcmp(at, "of:", 3) == 0) {
            at += 3 + strspn(at + 3, " ");
            size_t length = strcspn(at, " *\r\n");
            snprintf(base, CHANGE_BASE_BYTES, "%.*s", (int)length, at);
            if (length < CHANGE_BASE_BYTES &&
                (strcmp(base, "reference") == 0 || is_file_of_exercise(base)))
                return 0;
            return error_set(err,
                             "%s:%d: of: \"%.60s\"; name a whole file as right/sort.c, or "
                             "reference",
                             change->name, number, base);
        }
        at = next;
    }
    return error_set(err,
                     "%s:1: its first comment needs a line `of: right/FILE.c` or "
                     "`of: reference`",
                     change->name);
}

/* --------------------------------------------------------------- one place */

/* A place: lines first ... end - 1 of the change. */
struct place {
    int first, end;
};

static bool is_rule(struct line line)
{
    return line.length == 2 && memcmp(line.text, "@@", 2) == 0;
}

/* What column 1 says: ' ', '-' or '+'; 0 when it is none of these. */
static char mark_of(struct line line)
{
    if (line.length == 0)
        return ' ';
    return line.text[0] == ' ' || line.text[0] == '-' || line.text[0] == '+' ? line.text[0] : 0;
}

/* The line without its mark. */
static struct line without_mark(struct line line)
{
    return line.length == 0 ? line : (struct line){line.text + 1, line.length - 1};
}

static bool is_same(struct line a, struct line b)
{
    return a.length == b.length && (a.length == 0 || memcmp(a.text, b.text, a.length) == 0);
}

static int line_number(const struct source *change, int line)
{
    return change->comment_lines + line + 1;
}

static int check_place(const struct source *change, struct place place, struct error *err)
{
    int old = 0, changed = 0, number = line_number(change, place.first);
    for (int i = place.first; i < place.end; i++) {
        char mark = mark_of(change->lines[i]);
        if (!mark)
            return error_set(err,
                             "%s:%d: begins with neither a space nor - nor +; a line that both "
                             "have gets a space in front",
                             change->name, line_number(change, i));
        old += mark != '+';
        changed += mark != ' ';
    }
    if (changed == 0)
        return error_set(err,
                         "%s:%d: nothing is changed here; mark lines by - and +, or take the "
                         "place out",
                         change->name, number);
    if (old == 0)
        return error_set(err,
                         "%s:%d: only adds lines; put a line of the base beside them, so that "
                         "their place is known",
                         change->name, number);
    return 0;
}

/* How many of the place's old lines stand in the base from line `at` on, up to the first that does
 * not; *differing is the change's line that does not, or place.end. */
static int match_at(const struct source *change, struct place place, const struct source *base,
                    int at, int *differing)
{
    int matched = 0;
    for (*differing = place.first; *differing < place.end; (*differing)++) {
        struct line line = change->lines[*differing];
        if (mark_of(line) == '+')
            continue;
        if (at + matched >= base->count || !is_same(without_mark(line), base->lines[at + matched]))
            break;
        matched++;
    }
    return matched;
}

static int refuse_missing(const struct source *change, int line, const struct source *base,
                          struct error *err)
{
    struct line text = without_mark(change->lines[line]);
    int shown = text.length < SHOWN_BYTES ? (int)text.length : SHOWN_BYTES;
    return error_set(err, "%s:%d: \"%.*s\" does not stand there in %s; copy the lines as they are",
                     change->name, line_number(change, line), shown, text.text, base->name);
}

/* Finds the one place of the base that is meant.
 *
 * from     lines before it belong to the place before
 * at, end  its lines of the base are at ... end - 1 */
static int find_place(const struct source *change, struct place place, const struct source *base,
                      int from, int *at, int *end, struct error *err)
{
    int found = 0, best = -1, best_line = place.first;
    for (int i = 0; i < base->count && found < 2; i++) {
        int differing, matched = match_at(change, place, base, i, &differing);
        if (differing == place.end && ++found == 1) {
            *at = i;
            *end = i + matched;
        }
        if (matched > best) {
            best = matched;
            best_line = differing;
        }
    }
    if (found == 0)
        return refuse_missing(change, best_line, base, err);
    if (found > 1)
        return error_set(err,
                         "%s:%d: these lines stand more than once in %s; add lines before or "
                         "after them",
                         change->name, line_number(change, place.first), base->name);
    if (*at < from)
        return error_set(err,
                         "%s:%d: stands in %s before the place above; keep the base's order, "
                         "and make one of two places that touch",
                         change->name, line_number(change, place.first), base->name);
    return 0;
}

/* ---------------------------------------------------------------- applying */

static void put(char *text, size_t *count, struct line line)
{
    if (line.length > 0)
        memcpy(text + *count, line.text, line.length);
    *count += line.length;
    text[(*count)++] = '\n';
}

static void put_base(char *text, size_t *count, const struct source *base, int from, int end)
{
    for (int i = from; i < end; i++)
        put(text, count, base->lines[i]);
}

static void put_place(char *text, size_t *count, const struct source *change, struct place place)
{
    for (int i = place.first; i < place.end; i++)
        if (mark_of(change->lines[i]) != '-')
            put(text, count, without_mark(change->lines[i]));
}

static int apply(const struct source *change, const struct source *base, char *text, size_t *count,
                 struct error *err)
{
    int done = 0; /* lines of the base */
    put(text, count, (struct line){change->comment, change->comment_bytes});
    if (change->count == 0)
        return error_set(err, "%s:%d: no change follows the comment; add the lines that differ",
                         change->name, change->comment_lines);
    for (int first = 0; first <= change->count;) {
        struct place place = {first, first};
        int at = 0, end = 0;
        while (place.end < change->count && !is_rule(change->lines[place.end]))
            place.end++;
        if (check_place(change, place, err) != 0 ||
            find_place(change, place, base, done, &at, &end, err) != 0)
            return -1;
        put_base(text, count, base, done, at);
        put_place(text, count, change, place);
        done = end;
        first = place.end + 1;
    }
    put_base(text, count, base, done, base->count);
    text[*count] = '\0';
    return 0;
}

int change_apply(const struct change_text *change, const struct change_text *base, char **text,
                 size_t *count, struct error *err)
{
    struct source from = {0}, difference = {0};
    char *room = NULL;
    int result = read_source(change, &difference, err);
    if (result == 0)
        result = read_source(base, &from, err);
    if (result == 0 && !(room = malloc(change->count + base->count + 4)))
        result = error_set(err, "%s: out of memory", change->name);
    *count = 0;
    if (result == 0)
        result = apply(&difference, &from, room, count, err);
    free(difference.lines);
    free(from.lines);
    if (result == 0)
        *text = room;
    else
        free(room);
    return result;
}
