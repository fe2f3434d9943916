/* The policy on preprocessed text; see policy.h.
 *
 * A lexer of C tokens, just fine enough to tell identifiers from strings, with a little memory:
 * where it stands (line markers), how deep in braces, whether inside an attribute. */
#include "graders/engine/build/policy.h"

#include "graders/engine/build/compiler.h"

#include <stdio.h>
#include <string.h>

static const struct cause forbidden_include = {"forbidden-include",
                                               {"forbidden include", "inclusión no permitida"}};
static const struct cause forbidden_line = {"forbidden-line",
                                            {"forbidden #line", "#line no permitido"}};
static const struct cause forbidden_directive = {"forbidden-directive",
                                                 {"forbidden directive", "directiva no permitida"}};
static const struct cause forbidden_pragma = {"forbidden-pragma",
                                              {"forbidden pragma", "pragma no permitido"}};
static const struct cause forbidden_attribute = {"forbidden-attribute",
                                                 {"forbidden attribute", "atributo no permitido"}};
static const struct cause raw_string = {"raw-string", {"raw string", "cadena en bruto"}};
static const struct cause inline_assembly = {"inline-assembly",
                                             {"inline assembly", "ensamblador en línea"}};

struct slice {
    const char *at;
    size_t count;
};

enum token_kind { TOKEN_END, TOKEN_NAME, TOKEN_STRING, TOKEN_PUNCTUATION };

struct token {
    enum token_kind kind;
    struct slice text; /* of a string: what stands between the quotes */
};

struct reader {
    const char *at, *end;
    bool at_line_start;
    int line;
    struct slice file, main_file; /* names as in the line markers, without quotes */
    bool is_system;
    const char *public_folder;
    struct policy *policy;
};

/* ---------------------------------------------------------------- words */

static const char *const assembly_words[] = {"asm", "__asm", "__asm__", NULL};

/* Without the underscores around them: what not even a system header may say. */
static const char *const forbidden_attributes[] = {"constructor",
                                                   "destructor",
                                                   "naked",
                                                   "ifunc",
                                                   "target_clones",
                                                   "section",
                                                   "symver",
                                                   "alias",
                                                   "weakref",
                                                   "optimize",
                                                   "target",
                                                   "no_sanitize",
                                                   "no_address_safety_analysis",
                                                   "no_icf",
                                                   NULL};

static const char *const system_attributes[] = {"target", NULL};

/* What a right answer may want. All others, those of later compilers too, are refused: some reach
 * the assembler or the linker, some change how the function is compiled, `copy` takes over others.
 */
static const char *const allowed_attributes[] = {"access",
                                                 "aligned",
                                                 "alloc_align",
                                                 "alloc_size",
                                                 "always_inline",
                                                 "artificial",
                                                 "assume",
                                                 "assume_aligned",
                                                 "cleanup",
                                                 "cold",
                                                 "const",
                                                 "__const",
                                                 "counted_by",
                                                 "deprecated",
                                                 "designated_init",
                                                 "error",
                                                 "fallthrough",
                                                 "flatten",
                                                 "format",
                                                 "format_arg",
                                                 "gnu",
                                                 "gnu_inline",
                                                 "hot",
                                                 "leaf",
                                                 "malloc",
                                                 "may_alias",
                                                 "maybe_unused",
                                                 "mode",
                                                 "noclone",
                                                 "nodiscard",
                                                 "noinline",
                                                 "noipa",
                                                 "nonnull",
                                                 "nonstring",
                                                 "noreturn",
                                                 "_Noreturn",
                                                 "nothrow",
                                                 "packed",
                                                 "pure",
                                                 "reproducible",
                                                 "returns_nonnull",
                                                 "returns_twice",
                                                 "scalar_storage_order",
                                                 "sentinel",
                                                 "transparent_union",
                                                 "unavailable",
                                                 "unsequenced",
                                                 "unused",
                                                 "used",
                                                 "vector_size",
                                                 "visibility",
                                                 "volatile",
                                                 "warn_if_not_aligned",
                                                 "warn_unused_result",
                                                 "warning",
                                                 "weak",
                                                 NULL};

/* The rest tells the compiler, the assembler or the linker something that others are not told. Those
 * of other compilers are passed over by ours. */
static const char *const allowed_pragmas[] = {"STDC",
                                              "GCC diagnostic",
                                              "GCC error",
                                              "GCC ivdep",
                                              "GCC novector",
                                              "GCC poison",
                                              "GCC unroll",
                                              "GCC warning",
                                              "acc",
                                              "clang",
                                              "comment",
                                              "endregion",
                                              "mark",
                                              "message",
                                              "omp",
                                              "once",
                                              "pack",
                                              "pop_macro",
                                              "push_macro",
                                              "region",
                                              "scalar_storage_order",
                                              "warning",
                                              NULL};

static const char *const system_pragmas[] = {"GCC target",      "GCC push_options",
                                             "GCC pop_options", "GCC system_header",
                                             "GCC visibility",  NULL};

/* Templates in gcc's headers of intrinsics, which <immintrin.h> brings along. */
static const char *const system_templates[] = {
    "pconfig\\n\\t",   "encls\\n\\t",     "enclu\\n\\t", "enclv\\n\\t",
    "ldtilecfg\\t%X0", "sttilecfg\\t%X0", "tilerelease", NULL};

static bool is(struct slice text, const char *word)
{
    return strlen(word) == text.count && memcmp(text.at, word, text.count) == 0;
}

static bool begins(struct slice text, const char *word)
{
    size_t length = strlen(word);
    return text.count >= length && memcmp(text.at, word, length) == 0;
}

static bool is_listed(struct slice text, const char *const *list)
{
    for (; *list; list++)
        if (is(text, *list))
            return true;
    return false;
}

static bool is_name_byte(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '$' || (unsigned char)c >= 0x80;
}

static struct slice without_underscores(struct slice name)
{
    if (name.count > 4 && begins(name, "__") && memcmp(name.at + name.count - 2, "__", 2) == 0)
        return (struct slice){name.at + 2, name.count - 4};
    return name;
}

/* ---------------------------------------------------------------- refusals */

static void refuse_here(struct reader *r, const struct cause *cause, struct slice what,
                        const char *en, const char *es)
{
    struct policy *p = r->policy;
    char named[REFUSAL_NAME];
    struct message message;
    if (p->refusal.refused)
        return;
    refusal_name(p->file, r->file.at, r->file.count);
    p->line = r->line;
    message_say(&message, "%s:%d: `%s`: ", "%s:%d: `%s`: ", p->file, p->line,
                refusal_name(named, what.at, what.count));
    message_add_phrase(&message, (struct phrase){en, es});
    refuse_saying(&p->refusal, cause, &message);
}

/* ---------------------------------------------------------------- lines that begin with # */

static struct slice rest_of_line(struct reader *r)
{
    const char *end = memchr(r->at, '\n', (size_t)(r->end - r->at));
    struct slice line = {r->at, (size_t)((end ? end : r->end) - r->at)};
    r->at += line.count;
    return line;
}

static void skip_blanks(struct slice *line)
{
    while (line->count && (*line->at == ' ' || *line->at == '\t')) {
        line->at++;
        line->count--;
    }
}

static bool has_parent_step(struct slice path)
{
    for (size_t i = 0; i + 1 < path.count; i++)
        if (path.at[i] == '.' && path.at[i + 1] == '.' && (i == 0 || path.at[i - 1] == '/') &&
            (i + 2 == path.count || path.at[i + 2] == '/'))
            return true;
    return false;
}

/* Is `path` below the folder? */
static bool is_below(struct slice path, struct slice folder)
{
    return folder.count > 0 && path.count > folder.count &&
           memcmp(path.at, folder.at, folder.count) == 0 &&
           (folder.at[folder.count - 1] == '/' || path.at[folder.count] == '/');
}

static struct slice folder_of(struct slice path)
{
    while (path.count && path.at[path.count - 1] != '/')
        path.count--;
    return path;
}

/* Where the real ones stand; what else gcc calls a system header is not believed. */
static bool is_in_system_folder(struct slice path)
{
    for (const char *const *folder = compiler_system_folders(); *folder; folder++)
        if (is_below(path, (struct slice){*folder, strlen(*folder)}))
            return !has_parent_step(path);
    return false;
}

static void check_included(struct reader *r, struct slice name, bool is_system)
{
    struct slice public_folder = {r->public_folder,
                                  r->public_folder ? strlen(r->public_folder) : 0};
    bool is_absolute = name.count && name.at[0] == '/';
    bool is_ours = is_system
                       ? is_in_system_folder(name)
                       : is_below(name, public_folder) || is_below(name, folder_of(r->main_file));
    if (has_parent_step(name) || (is_absolute && !is_ours))
        refuse_here(r, &forbidden_include, name,
                    "files may not be included by an absolute path or from a parent folder.",
                    "no se pueden incluir archivos por ruta absoluta ni de una carpeta superior.");
}

/* `# 12 "file" flags`: flag 1 enters a file, 2 returns to it, 3 is a system header. */
static void follow_marker(struct reader *r, struct slice line)
{
    int number = 0;
    while (line.count && *line.at >= '0' && *line.at <= '9') {
        number = number < 100000000 ? number * 10 + (*line.at - '0') : number;
        line.at++;
        line.count--;
    }
    skip_blanks(&line);
    if (!line.count || *line.at != '"')
        return;
    struct slice name = {line.at + 1, 0};
    const char *end = line.at + line.count;
    while (name.at + name.count < end && name.at[name.count] != '"')
        name.count += name.at[name.count] == '\\' && name.at + name.count + 1 < end ? 2 : 1;
    bool enters = false, returns = false, is_system = false;
    for (const char *flag = name.at + name.count; flag < end; flag++) {
        enters |= *flag == '1';
        returns |= *flag == '2';
        is_system |= *flag == '3';
    }
    if (name.count > 2 && memcmp(name.at + name.count - 2, "//", 2) == 0)
        return; /* with -g: the working folder, which is no file */
    if (!r->main_file.at)
        r->main_file = name;
    bool is_known =
        is(name, "<built-in>") || is(name, "<command-line>") ||
        (name.count == r->main_file.count && memcmp(name.at, r->main_file.at, name.count) == 0) ||
        (r->file.at && name.count == r->file.count && memcmp(name.at, r->file.at, name.count) == 0);
    if (!enters && !returns && !is_known)
        refuse_here(r, &forbidden_line, name, "#line may not rename the file.",
                    "#line no puede cambiar el nombre del archivo.");
    if (enters)
        check_included(r, name, is_system);
    r->file = name;
    r->is_system = is_system && is_in_system_folder(name);
    r->line = number - 1; /* the end of this line counts one */
}

static bool is_pragma_of(struct slice line, const char *const *list)
{
    for (; *list; list++) {
        size_t length = strlen(*list);
        if (begins(line, *list) && (line.count == length || !is_name_byte(line.at[length])))
            return true;
    }
    return false;
}

static void check_pragma(struct reader *r, struct slice line)
{
    if (!line.count || is_pragma_of(line, allowed_pragmas) ||
        (r->is_system && is_pragma_of(line, system_pragmas)))
        return;
    refuse_here(r, &forbidden_pragma, line,
                "this pragma is not allowed; all are compiled with the same options.",
                "este pragma no está permitido; todos se compilan con las mismas opciones.");
}

/* After preprocessing nothing else begins with # than its own markers and pragmas; the text of an
 * #ident goes to the assembler. */
static void read_directive(struct reader *r)
{
    struct slice line = rest_of_line(r);
    line.at++;
    line.count--;
    skip_blanks(&line);
    if (begins(line, "pragma") && !(line.count > 6 && is_name_byte(line.at[6]))) {
        line.at += strlen("pragma");
        line.count -= strlen("pragma");
        skip_blanks(&line);
        check_pragma(r, line);
    } else if (line.count && *line.at >= '0' && *line.at <= '9') {
        follow_marker(r, line);
    } else if (line.count) {
        refuse_here(r, &forbidden_directive, line, "this directive is not allowed.",
                    "esta directiva no está permitida.");
    }
}

/* ---------------------------------------------------------------- tokens */

/* Reads up to the closing quote, or to the end of the line. */
static struct slice read_quoted(struct reader *r)
{
    const char quote = *r->at++;
    const char *start = r->at;
    while (r->at < r->end && *r->at != quote && *r->at != '\n')
        r->at += *r->at == '\\' && r->end - r->at > 1 ? 2 : 1;
    struct slice text = {start, (size_t)(r->at - start)};
    if (r->at < r->end && *r->at == quote)
        r->at++;
    return text;
}

static struct slice read_name(struct reader *r)
{
    struct slice name = {r->at, 0};
    while (r->at < r->end && is_name_byte(*r->at))
        r->at++;
    name.count = (size_t)(r->at - name.at);
    return name;
}

static struct token next_token(struct reader *r)
{
    while (r->at < r->end) {
        if (r->at_line_start && *r->at == '#') {
            read_directive(r);
            continue;
        }
        r->at_line_start = *r->at == '\n';
        if (*r->at == '\n')
            r->line++;
        if (*r->at == '"' || *r->at == '\'')
            return (struct token){TOKEN_STRING, read_quoted(r)};
        if (is_name_byte(*r->at))
            return (struct token){TOKEN_NAME, read_name(r)};
        if (!strchr(" \t\n\v\f\r", *r->at) || !*r->at) {
            size_t pair =
                r->end - r->at > 1 && (memcmp(r->at, "<:", 2) == 0 || memcmp(r->at, ":>", 2) == 0);
            struct token token = {TOKEN_PUNCTUATION,
                                  {pair ? r->at[0] == '<' ? "[" : "]" : r->at, 1}};
            r->at += pair ? 2 : 1;
            return token;
        }
        r->at++;
    }
    return (struct token){0};
}

static bool is_punctuation(struct token token, char c)
{
    return token.kind == TOKEN_PUNCTUATION && *token.text.at == c;
}

/* ---------------------------------------------------------------- attributes */

static void check_attribute(struct reader *r, struct slice name)
{
    struct slice bare = without_underscores(name);
    bool is_refused =
        r->is_system ? !is_listed(bare, system_attributes) &&
                           (is_listed(bare, forbidden_attributes) || begins(bare, "no_sanitize"))
                     : !is_listed(bare, allowed_attributes);
    if (is_refused)
        refuse_here(r, &forbidden_attribute, name, "this attribute is not allowed.",
                    "este atributo no está permitido.");
}

/* Where in `__attribute__((name(argument)))` or `[[name(argument)]]` the reader stands. */
struct attribute {
    bool in_parentheses;
    int depth;    /* of __attribute__'s parentheses */
    int brackets; /* 0; 1: one [ just read; 2: inside [[ ]] */
    int inner;    /* parentheses and brackets inside [[ ]] */
};

static void follow_attribute(struct reader *r, struct attribute *a, struct token token)
{
    bool opens = is_punctuation(token, '('), closes = is_punctuation(token, ')');
    if (a->in_parentheses) {
        if (opens)
            a->depth++;
        else if (closes && a->depth > 0)
            a->in_parentheses = --a->depth > 0;
        else if (a->depth == 0)
            a->in_parentheses = false;
        else if (a->depth <= 2 && token.kind == TOKEN_NAME)
            check_attribute(r, token.text);
    }
    if (token.kind == TOKEN_NAME &&
        (is(token.text, "__attribute__") || is(token.text, "__attribute")))
        *a = (struct attribute){.in_parentheses = true};
    if (a->brackets == 2) {
        if (opens || is_punctuation(token, '['))
            a->inner++;
        else if ((closes || is_punctuation(token, ']')) && a->inner-- == 0)
            a->brackets = a->inner = 0;
        else if (a->inner == 0 && token.kind == TOKEN_NAME)
            check_attribute(r, token.text);
    } else {
        a->brackets = is_punctuation(token, '[') ? a->brackets + 1 : 0;
    }
}

/* ---------------------------------------------------------------- assembly */

/* In a system header: is what follows `asm` the name of a declaration, `asm ("" "name")`, or one of
 * the intrinsics' templates? Reads up to the end of the strings. */
static bool is_system_assembly(struct reader *r, bool after_declarator)
{
    struct token token = next_token(r);
    bool is_volatile =
        token.kind == TOKEN_NAME && (is(token.text, "volatile") || is(token.text, "__volatile__"));
    if (is_volatile)
        token = next_token(r);
    if (!is_punctuation(token, '('))
        return false;
    bool is_name = after_declarator && !is_volatile;
    token = next_token(r);
    if (token.kind == TOKEN_STRING && is_volatile && is_listed(token.text, system_templates))
        return next_token(r).kind == TOKEN_PUNCTUATION;
    for (; token.kind == TOKEN_STRING; token = next_token(r))
        for (size_t i = 0; i < token.text.count; i++)
            is_name &= is_name_byte(token.text.at[i]);
    return is_name && is_punctuation(token, ')');
}

void policy_check(const char *text, size_t bytes, const char *public_folder, struct policy *policy)
{
    *policy = (struct policy){0};
    if (!bytes)
        text = "";
    struct reader r = {.at = text,
                       .end = text + bytes,
                       .at_line_start = true,
                       .line = 1,
                       .file = {"", 0},
                       .public_folder = public_folder,
                       .policy = policy};
    struct attribute attribute = {0};
    struct token before = {0};
    int braces = 0;
    for (struct token token = next_token(&r); token.kind != TOKEN_END && !policy->refusal.refused;
         before = token, token = next_token(&r)) {
        follow_attribute(&r, &attribute, token);
        braces += is_punctuation(token, '{') ? 1 : is_punctuation(token, '}') ? -1 : 0;
        if (token.kind != TOKEN_NAME)
            continue;
        if (r.at < r.end && *r.at == '"' && token.text.at[token.text.count - 1] == 'R')
            refuse_here(&r, &raw_string, token.text, "raw strings are not allowed.",
                        "no se permiten cadenas en bruto (raw strings).");
        if (!is_listed(token.text, assembly_words))
            continue;
        struct reader here = r;
        if (!r.is_system || !is_system_assembly(&r, braces == 0 && is_punctuation(before, ')')))
            refuse_here(&here, &inline_assembly, token.text, "inline assembly is not allowed.",
                        "no se permite ensamblador en línea.");
    }
}
