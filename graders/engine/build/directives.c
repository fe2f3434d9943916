/* Directives as they stand in the source; see directives.h. */
#include "graders/engine/build/directives.h"

#include <string.h>

static const struct cause forbidden_line = {"forbidden-line",
                                            {"forbidden #line", "#line no permitido"}};
static const struct cause forbidden_directive = {"forbidden-directive",
                                                 {"forbidden directive", "directiva no permitida"}};
static const struct cause forbidden_include = {"forbidden-include",
                                               {"forbidden include", "inclusión no permitida"}};
static const struct cause raw_string = {"raw-string", {"raw string", "cadena en bruto"}};

static const struct phrase no_markers = {
    "lines of this kind are the preprocessor's; they may not be written by hand.",
    "las líneas de este tipo son del preprocesador; no pueden escribirse a mano."};
static const struct phrase no_assembler = {"this directive speaks to the assembler.",
                                           "esta directiva habla con el ensamblador."};
static const struct phrase no_odd_header = {"a header's name may hold no comment and no quote.",
                                            "el nombre de una cabecera no puede contener "
                                            "comentarios ni comillas."};
static const struct phrase no_raw_strings = {"raw strings are not allowed.",
                                             "no se permiten cadenas en bruto (raw strings)."};

/* A place in the text, where a backslash at the end of a line joins it with the next. */
struct cursor {
    const char *at, *end;
    int line;
};

struct scan {
    struct cursor here;
    bool at_line_start; /* nothing but blanks and comments since the line began */
    bool in_directive, in_include;
    const char *name;
    struct refusal *refusal;
};

/* Bytes of a joined line end at `at`: the backslash, blanks, the end; 0 when there is none. */
static size_t joint_bytes(const char *at, const char *end)
{
    size_t count = 0;
    if (end - at >= 3 && memcmp(at, "?\?/", 3) == 0)
        count = 3;
    else if (at < end && *at == '\\')
        count = 1;
    else
        return 0;
    while (at + count < end && strchr(" \t\v\f\r", at[count]) && at[count])
        count++;
    return at + count < end && at[count] == '\n' ? count + 1 : 0;
}

static void pass_joints(struct cursor *c)
{
    for (size_t bytes; (bytes = joint_bytes(c->at, c->end)) > 0; c->line++)
        c->at += bytes;
}

/* The character here, '\0' at the end. */
static char peek(struct cursor *c)
{
    pass_joints(c);
    return c->at < c->end ? *c->at : '\0';
}

static bool is_at_end(struct cursor *c)
{
    pass_joints(c);
    return c->at >= c->end;
}

static char take(struct cursor *c)
{
    char taken = peek(c);
    if (c->at < c->end)
        c->at++;
    c->line += taken == '\n';
    return taken;
}

static char peek_second(struct cursor c)
{
    take(&c);
    return peek(&c);
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\0';
}

static bool is_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '$' || (unsigned char)c >= 0x80;
}

static bool refuse_here(struct scan *s, const struct cause *cause, struct phrase phrase)
{
    struct message message;
    message_say(&message, "%s:%d: ", "%s:%d: ", s->name, s->here.line);
    message_add_phrase(&message, phrase);
    refuse_saying(s->refusal, cause, &message);
    return true;
}

/* Passes a comment, if one begins here. */
static bool pass_comment(struct cursor *c)
{
    if (peek(c) != '/')
        return false;
    const char second = peek_second(*c);
    if (second != '*' && second != '/')
        return false;
    take(c);
    take(c);
    if (second == '/') {
        while (!is_at_end(c) && peek(c) != '\n')
            take(c);
        return true;
    }
    for (char before = '\0'; !is_at_end(c);) {
        char now = take(c);
        if (before == '*' && now == '/')
            break;
        before = now;
    }
    return true;
}

static void pass_blanks(struct cursor *c)
{
    while (!is_at_end(c) && (pass_comment(c) || is_blank(peek(c))))
        if (is_blank(peek(c)) && !is_at_end(c))
            take(c);
}

/* Up to the closing quote, or to the end of the line. */
static void pass_quoted(struct cursor *c)
{
    const char quote = take(c);
    while (!is_at_end(c) && peek(c) != '\n') {
        const char now = take(c);
        if (now == quote)
            return;
        if (now == '\\' && peek(c) != '\n')
            take(c);
    }
}

/* `#`, `%:` or `??=`, and passes it. */
static bool pass_hash(struct cursor *c)
{
    struct cursor ahead = *c;
    const char first = take(&ahead);
    bool is_hash = first == '#' || (first == '%' && take(&ahead) == ':') ||
                   (first == '?' && take(&ahead) == '?' && take(&ahead) == '=');
    if (is_hash)
        *c = ahead;
    return is_hash;
}

static size_t read_word(struct cursor *c, char *word, size_t room)
{
    size_t count = 0;
    while (is_word(peek(c))) {
        const char now = take(c);
        if (count + 1 < room)
            word[count++] = now;
    }
    word[count] = '\0';
    return count;
}

/* Those after which `<` begins a name, in which nothing is a comment. */
static bool names_headers(const char *word)
{
    return strstr(word, "include") || strstr(word, "embed") || strcmp(word, "import") == 0 ||
           strcmp(word, "dependency") == 0;
}

/* Behind the hash: its word decides. */
static bool check_directive(struct scan *s)
{
    char word[64];
    struct cursor ahead = s->here;
    s->in_directive = true;
    s->in_include = false;
    pass_blanks(&ahead);
    if (peek(&ahead) >= '0' && peek(&ahead) <= '9')
        return refuse_here(s, &forbidden_line, no_markers);
    read_word(&ahead, word, sizeof word);
    if (strcmp(word, "ident") == 0 || strcmp(word, "sccs") == 0)
        return refuse_here(s, &forbidden_directive, no_assembler);
    return false;
}

/* `<...>` where it may be the name of a header. */
static bool check_header_name(struct scan *s)
{
    struct cursor ahead = s->here;
    for (char now = '\0', before = '\0'; !is_at_end(&ahead); before = now) {
        now = take(&ahead);
        if (now == '>' || now == '\n')
            return false;
        if (now == '"' || now == '\'' || (before == '/' && (now == '*' || now == '/')))
            return refuse_here(s, &forbidden_include, no_odd_header);
    }
    return false;
}

static bool check_word(struct scan *s)
{
    char word[64] = "";
    while (is_word(peek(&s->here))) {
        read_word(&s->here, word, sizeof word);
        s->in_include |= s->in_directive && names_headers(word);
    }
    size_t length = strlen(word);
    if (length && word[length - 1] == 'R' && peek(&s->here) == '"')
        return refuse_here(s, &raw_string, no_raw_strings);
    return false;
}

/* One thing: blanks, a comment, a string, a word, a directive's beginning, any other character. */
static bool check_next(struct scan *s)
{
    struct cursor *here = &s->here;
    if (pass_comment(here))
        return false;
    const char now = peek(here);
    if (now == '\n') {
        take(here);
        s->at_line_start = true;
        s->in_directive = s->in_include = false;
        return false;
    }
    if (is_blank(now)) {
        take(here);
        return false;
    }
    if (s->at_line_start) {
        s->at_line_start = false;
        if (pass_hash(here))
            return check_directive(s);
    }
    if (now == '"' || now == '\'')
        return pass_quoted(here), false;
    if (is_word(now))
        return check_word(s);
    if (now == '<' && s->in_include && check_header_name(s))
        return true;
    take(here);
    return false;
}

int directives_check(const char *name, const char *text, size_t bytes, struct refusal *refusal)
{
    if (!bytes)
        text = "";
    if (bytes >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
        text += 3;
        bytes -= 3;
    }
    struct scan scan = {
        .here = {text, text + bytes, 1}, .at_line_start = true, .name = name, .refusal = refusal};
    while (!is_at_end(&scan.here))
        if (check_next(&scan))
            return scan.here.line;
    return 0;
}
