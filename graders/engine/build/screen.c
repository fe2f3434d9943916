/* The screen of object files; see screen.h. Nothing in the file is believed: every offset, size and
 * index is checked before use, and structures are copied out, so their place need not be aligned.
 */
#include "graders/engine/build/screen.h"

#include "graders/engine/build/instruction.h"
#include "graders/engine/build/names.h"

#include <elf.h>
#include <stdlib.h>
#include <string.h>

static const struct cause object_malformed = {
    "object-malformed", {"malformed object file", "archivo objeto incorrecto"}};
static const struct cause tool_request = {"tool-request",
                                          {"request to a tool", "petición a una herramienta"}};
static const struct cause system_call_instruction = {
    "system-call-instruction", {"direct system call", "llamada directa al sistema"}};
static const struct cause executable_stack = {"executable-stack",
                                              {"executable stack", "pila ejecutable"}};
static const struct cause constructor = {"constructor", {"constructor", "constructor"}};
static const struct cause forbidden_section = {"forbidden-section",
                                               {"forbidden section", "sección no permitida"}};
static const struct cause static_data = {"static-data", {"static data", "datos estáticos"}};
static const struct cause forbidden_symbol = {"forbidden-symbol",
                                              {"forbidden symbol", "símbolo no permitido"}};
static const struct cause unknown_symbol = {"unknown-symbol",
                                            {"unknown name", "nombre desconocido"}};
static const struct cause sanitizer_symbol = {"sanitizer-symbol",
                                              {"symbol of a tool", "símbolo de una herramienta"}};
static const struct cause indirect_function = {"indirect-function",
                                               {"indirect function", "función indirecta"}};
static const struct cause missing_function = {"missing-function",
                                              {"missing function", "falta la función"}};
static const struct cause given_function = {
    "given-function", {"function given by the exercise", "función dada por el ejercicio"}};
static const struct cause not_a_function = {"not-a-function",
                                            {"not a function", "no es una función"}};

enum { NAME_BYTES_MAX = 4096 };

/* What is being screened. */
struct object {
    const unsigned char *bytes;
    size_t count;
    Elf64_Ehdr header;
    Elf64_Shdr section_names, symbols, symbol_names;
    bool has_symbols, has_stack_note;
    const struct screen_rules *rules;
    struct screen *screen;
    int64_t all_static_bytes; /* read-only data as well */
    uint64_t code_bytes;
    char shown[REFUSAL_NAME];
    const char *other_function; /* first global function that the exercise does not know */
};

/* ---------------------------------------------------------------- what is refused */

static const char *const allowed_sections[] = {".text",
                                               ".data",
                                               ".bss",
                                               ".rodata",
                                               ".tdata",
                                               ".tbss",
                                               ".data.rel.ro",
                                               ".eh_frame",
                                               ".comment",
                                               ".symtab",
                                               ".strtab",
                                               ".shstrtab",
                                               ".symtab_shndx",
                                               ".group",
                                               ".note.GNU-stack",
                                               ".note.gnu.property",
                                               ".rela.text",
                                               ".rela.data",
                                               ".rela.rodata",
                                               ".rela.tdata",
                                               ".rela.data.rel.ro",
                                               ".rela.eh_frame",
                                               NULL};

/* Also with anything after them: -ffunction-sections, merged strings, debugging. */
static const char *const allowed_section_prefixes[] = {
    ".text.",       ".data.",       ".bss.",       ".rodata.",    ".tdata.",
    ".tbss.",       ".debug_",      ".rela.text.", ".rela.data.", ".rela.rodata.",
    ".rela.tdata.", ".rela.debug_", NULL};

static const char *const constructor_prefixes[] = {".init",  ".fini",  ".preinit_array",
                                                   ".ctors", ".dtors", NULL};

static const char *const sanitizer_prefixes[] = {
    "__asan_",   "__ubsan_",     "__lsan_",        "__tsan_",         "__msan_",
    "__hwasan_", "__sanitizer_", "__interceptor_", "__interception_", NULL};

/* What gcc makes of honest code under ASan and UBSan. */
static const char *const made_by_sanitizers[] = {"__asan_handle_no_return",
                                                 "__asan_init",
                                                 "__asan_register_globals",
                                                 "__asan_option_detect_stack_use_after_return",
                                                 "__asan_unregister_globals",
                                                 "__asan_version_mismatch_check_v8",
                                                 "__asan_alloca_poison",
                                                 "__asan_allocas_unpoison",
                                                 "__asan_poison_stack_memory",
                                                 "__asan_unpoison_stack_memory",
                                                 NULL};

static const char *const made_by_sanitizers_prefixes[] = {
    "__asan_report_",  "__asan_load", "__asan_store", "__asan_stack_malloc_", "__asan_stack_free_",
    "__ubsan_handle_", NULL};

/* Valgrind's request preamble: rol $3, $13, $61, $51 on rdi. */
static const unsigned char request_preamble[] = {0x48, 0xc1, 0xc7, 0x03, 0x48, 0xc1, 0xc7, 0x0d,
                                                 0x48, 0xc1, 0xc7, 0x3d, 0x48, 0xc1, 0xc7, 0x33};

static bool is_listed(const char *name, const char *const *list)
{
    for (; *list; list++)
        if (strcmp(name, *list) == 0)
            return true;
    return false;
}

static bool begins_as_listed(const char *name, const char *const *list)
{
    for (; *list; list++)
        if (strncmp(name, *list, strlen(*list)) == 0)
            return true;
    return false;
}

static int refuse_malformed(struct object *o, const char *what)
{
    return refuse(&o->screen->refusal, &object_malformed,
                  "The compiled file is not a proper object file (%s).",
                  "El archivo compilado no es un archivo objeto correcto (%s).", what);
}

/* The name as it may stand in a message; good until the next call. */
static const char *shown(struct object *o, const char *name)
{
    return refusal_name(o->shown, name, strlen(name));
}

/* ---------------------------------------------------------------- bounded reading */

static bool lies_within(const struct object *o, uint64_t offset, uint64_t bytes)
{
    return offset <= o->count && bytes <= o->count - offset;
}

/* The string at `offset` of a string table, or NULL when it does not end within the table or is
 * longer than any name that a compiler makes. */
static const char *string_at(const struct object *o, const Elf64_Shdr *table, uint64_t offset)
{
    if (table->sh_type != SHT_STRTAB || !lies_within(o, table->sh_offset, table->sh_size) ||
        offset >= table->sh_size)
        return NULL;
    const char *string = (const char *)o->bytes + table->sh_offset + offset;
    uint64_t room = table->sh_size - offset;
    return memchr(string, '\0', room < NAME_BYTES_MAX ? room : NAME_BYTES_MAX) ? string : NULL;
}

static bool get_section(const struct object *o, uint64_t index, Elf64_Shdr *section)
{
    if (index >= o->header.e_shnum)
        return false;
    memcpy(section, o->bytes + o->header.e_shoff + index * sizeof *section, sizeof *section);
    return true;
}

static int read_header(struct object *o)
{
    const Elf64_Ehdr *h = &o->header;
    if (o->count < sizeof *h)
        return refuse_malformed(o, "too short");
    memcpy(&o->header, o->bytes, sizeof *h);
    if (memcmp(h->e_ident, ELFMAG, SELFMAG) != 0 || h->e_ident[EI_CLASS] != ELFCLASS64 ||
        h->e_ident[EI_DATA] != ELFDATA2LSB || h->e_type != ET_REL || h->e_machine != EM_X86_64)
        return refuse_malformed(o, "not a relocatable x86-64 ELF file");
    if (h->e_shentsize != sizeof(Elf64_Shdr) || h->e_shnum == 0 || h->e_phnum != 0 ||
        !lies_within(o, h->e_shoff, (uint64_t)h->e_shnum * sizeof(Elf64_Shdr)))
        return refuse_malformed(o, "its section table lies outside the file");
    if (!get_section(o, h->e_shstrndx, &o->section_names))
        return refuse_malformed(o, "it names no sections");
    return 0;
}

/* ---------------------------------------------------------------- code */

/* Refuses bytes that make a request to valgrind. */
static int check_requests(const void *bytes, size_t count, struct refusal *refusal)
{
    if (!memmem(bytes, count, request_preamble, sizeof request_preamble))
        return 0;
    return refuse(refusal, &tool_request,
                  "The code speaks to valgrind, which measures it; that is not allowed.",
                  "El código habla con valgrind, que lo mide; no está permitido.");
}

static int refuse_kernel_entry(struct object *o, const char *section)
{
    return refuse(&o->screen->refusal, &system_call_instruction,
                  "The code in section %s calls the operating system directly.",
                  "El código de la sección %s llama directamente al sistema operativo.",
                  shown(o, section));
}

/* Looks for instructions that enter the kernel, at instruction boundaries. What the decoder does
 * not know is stepped over byte by byte, and there any such pattern counts. */
static int check_code(struct object *o, const char *name, const Elf64_Shdr *section)
{
    const unsigned char *code = o->bytes + section->sh_offset;
    o->code_bytes += section->sh_size;
    if (o->code_bytes > o->count)
        return refuse_malformed(o, "its sections overlap");
    if (check_requests(code, section->sh_size, &o->screen->refusal))
        return -1;
    for (size_t at = 0; at < section->sh_size;) {
        struct instruction next = instruction_decode(code + at, section->sh_size - at);
        if (next.enters_kernel)
            return refuse_kernel_entry(o, name);
        at += next.bytes ? next.bytes : 1;
    }
    return 0;
}

/* ---------------------------------------------------------------- sections */

static int check_stack_note(struct object *o, const Elf64_Shdr *section)
{
    o->has_stack_note = true;
    if (!(section->sh_flags & SHF_EXECINSTR))
        return 0;
    return refuse(&o->screen->refusal, &executable_stack,
                  "The code needs an executable stack (a pointer to a nested function?); write the "
                  "inner function outside.",
                  "El código necesita una pila ejecutable (¿un puntero a una función anidada?); "
                  "escribe fuera la función interior.");
}

static bool type_fits(const char *name, const Elf64_Shdr *section)
{
    switch (section->sh_type) {
    case SHT_NULL:
    case SHT_PROGBITS:
    case SHT_NOBITS:
    case SHT_STRTAB:
    case SHT_SYMTAB:
    case SHT_SYMTAB_SHNDX:
    case SHT_GROUP:
    case SHT_NOTE:
    case SHT_X86_64_UNWIND:
        return strncmp(name, ".rela.", 6) != 0;
    case SHT_RELA:
        return strncmp(name, ".rela.", 6) == 0;
    default:
        return false;
    }
}

static int refuse_section(struct object *o, const char *name)
{
    if (begins_as_listed(name, constructor_prefixes))
        return refuse(&o->screen->refusal, &constructor,
                      "Section %s holds code that runs before or after main (a constructor or "
                      "destructor); only the exercise's functions may run.",
                      "La sección %s contiene código que se ejecuta antes o después de main (un "
                      "constructor o destructor); solo pueden ejecutarse las funciones del "
                      "ejercicio.",
                      shown(o, name));
    return refuse(&o->screen->refusal, &forbidden_section,
                  "The code makes a section %s; only the compiler's usual sections are allowed.",
                  "El código crea una sección %s; solo se permiten las habituales del compilador.",
                  shown(o, name));
}

static int count_static_data(struct object *o, uint64_t bytes, bool is_writable)
{
    const int64_t limit = o->rules->static_limit_bytes;
    if (bytes > INT64_MAX / 4)
        bytes = INT64_MAX / 4;
    if (o->all_static_bytes < INT64_MAX / 4)
        o->all_static_bytes += (int64_t)bytes;
    if (is_writable && o->screen->static_bytes < INT64_MAX / 4)
        o->screen->static_bytes += (int64_t)bytes;
    if (o->all_static_bytes <= limit)
        return 0;
    return refuse(&o->screen->refusal, &static_data,
                  "Static variables and constants take %lld bytes; the limit is %lld.",
                  "Las variables estáticas y constantes ocupan %lld bytes; el límite es %lld.",
                  (long long)o->all_static_bytes, (long long)limit);
}

/* Of the sanitizers' object: its code, and where its symbols are. */
static int check_sanitized_section(struct object *o, const Elf64_Shdr *section, const char *name)
{
    if (section->sh_type == SHT_SYMTAB) {
        if (o->has_symbols || !get_section(o, section->sh_link, &o->symbol_names))
            return refuse_malformed(o, "it has no proper symbol table");
        o->symbols = *section;
        o->has_symbols = true;
    }
    bool is_code = section->sh_flags & SHF_EXECINSTR && section->sh_type != SHT_NOBITS;
    return is_code ? check_code(o, name, section) : 0;
}

static int check_section(struct object *o, const Elf64_Shdr *section)
{
    const char *name = string_at(o, &o->section_names, section->sh_name);
    const bool is_code = section->sh_flags & SHF_EXECINSTR;
    const bool is_writable = section->sh_flags & SHF_WRITE;
    if (!name)
        return refuse_malformed(o, "a section's name lies outside the file");
    if (section->sh_type != SHT_NOBITS && section->sh_type != SHT_NULL &&
        !lies_within(o, section->sh_offset, section->sh_size))
        return refuse_malformed(o, "a section lies outside the file");
    if (section->sh_type == SHT_NULL)
        return 0;
    if (o->rules->sanitized)
        return check_sanitized_section(o, section, name);
    if (strcmp(name, ".note.GNU-stack") == 0)
        return check_stack_note(o, section);
    if (!type_fits(name, section) ||
        (!is_listed(name, allowed_sections) && !begins_as_listed(name, allowed_section_prefixes)))
        return refuse_section(o, name);
    const bool is_text = strcmp(name, ".text") == 0 || strncmp(name, ".text.", 6) == 0;
    if (is_code != is_text || (is_code && (is_writable || section->sh_type != SHT_PROGBITS)))
        return refuse_section(o, name);
    if (section->sh_type == SHT_SYMTAB) {
        if (o->has_symbols || !get_section(o, section->sh_link, &o->symbol_names))
            return refuse_malformed(o, "it has no proper symbol table");
        o->symbols = *section;
        o->has_symbols = true;
    }
    if (is_code)
        return check_code(o, name, section);
    if (section->sh_flags & SHF_ALLOC && section->sh_type != SHT_NOTE &&
        strcmp(name, ".eh_frame") != 0)
        return count_static_data(o, section->sh_size, is_writable);
    return 0;
}

static int check_sections(struct object *o)
{
    for (unsigned i = 0; i < o->header.e_shnum; i++) {
        Elf64_Shdr section;
        if (!get_section(o, i, &section) || check_section(o, &section))
            return -1;
    }
    if (!o->has_symbols)
        return refuse_malformed(o, "it has no symbol table");
    if (!o->has_stack_note && !o->rules->sanitized)
        return refuse(&o->screen->refusal, &executable_stack,
                      "The object file does not say that its stack is not executable.",
                      "El archivo objeto no declara que su pila no es ejecutable.");
    return 0;
}

/* ---------------------------------------------------------------- symbols */

static int check_tool_name(struct object *o, const char *name)
{
    bool is_made = o->rules->sanitized && (is_listed(name, made_by_sanitizers) ||
                                           begins_as_listed(name, made_by_sanitizers_prefixes));
    if (is_made)
        return 0;
    return refuse(&o->screen->refusal, &sanitizer_symbol,
                  "The code uses %s, which belongs to the tools that check it.",
                  "El código usa %s, que pertenece a las herramientas que lo revisan.",
                  shown(o, name));
}

/* A name that is not there is then no error: it tells what is beside the code, the tools too. */
static int refuse_weak(struct object *o, const char *name)
{
    return refuse(&o->screen->refusal, &forbidden_symbol,
                  "The code names %s weakly (`weak`) and does not define it; that is not allowed.",
                  "El código nombra %s de forma débil (`weak`) y no lo define; no está permitido.",
                  shown(o, name));
}

static int refuse_name(struct object *o, const char *name)
{
    if (name_is_forbidden(name))
        return refuse(&o->screen->refusal, &forbidden_symbol,
                      "The code uses %s, which is not allowed here.",
                      "El código usa %s, que aquí no está permitido.", shown(o, name));
    return refuse(
        &o->screen->refusal, &unknown_symbol,
        "The code uses %s, which it does not define, and which is not among the functions "
        "of C17 and POSIX that are allowed here.",
        "El código usa %s, que no define y que no está entre las funciones de C17 y POSIX "
        "que aquí se permiten.",
        shown(o, name));
}

static int check_undefined(struct object *o, const char *name, const Elf64_Sym *symbol)
{
    const bool is_of_tool = begins_as_listed(name, sanitizer_prefixes);
    const bool is_given = is_listed(name, o->rules->functions) || /* missed further down */
                          is_listed(name, o->rules->given);
    if (is_of_tool && check_tool_name(o, name))
        return -1;
    if (ELF64_ST_BIND(symbol->st_info) == STB_WEAK)
        return refuse_weak(o, name);
    if (!is_of_tool && !is_given && !name_is_allowed(name))
        return refuse_name(o, name);
    char *copy = strdup(name);
    if (copy)
        o->screen->undefined[o->screen->undefined_count++] = copy;
    return copy ? 0 : 1;
}

static int check_defined(struct object *o, const char *name, const Elf64_Sym *symbol)
{
    if (is_listed(name, o->rules->given))
        return refuse(&o->screen->refusal, &given_function,
                      "The code defines %s, which the exercise gives: call it, and leave it out.",
                      "El código define %s, que la da el ejercicio: llámela, sin definirla.",
                      shown(o, name));
    if (ELF64_ST_BIND(symbol->st_info) == STB_LOCAL)
        return 0;
    if (begins_as_listed(name, sanitizer_prefixes))
        return refuse(&o->screen->refusal, &sanitizer_symbol,
                      "The code defines %s, which belongs to the tools that check it.",
                      "El código define %s, que pertenece a las herramientas que lo revisan.",
                      shown(o, name));
    if (strncmp(name, "__wrap_", 7) == 0 || strncmp(name, "__real_", 7) == 0)
        return refuse(&o->screen->refusal, &forbidden_symbol,
                      "The code defines %s, which is not allowed here.",
                      "El código define %s, que aquí no está permitido.", shown(o, name));
    if (ELF64_ST_TYPE(symbol->st_info) == STT_FUNC && !o->other_function &&
        !is_listed(name, o->rules->functions))
        o->other_function = name;
    return 0;
}

/* Returns 0, -1 when refused, 1 when memory runs out. */
static int check_symbol(struct object *o, const Elf64_Sym *symbol)
{
    const char *name = string_at(o, &o->symbol_names, symbol->st_name);
    if (!name)
        return refuse_malformed(o, "a symbol's name lies outside the file");
    if (ELF64_ST_TYPE(symbol->st_info) == STT_GNU_IFUNC ||
        ELF64_ST_BIND(symbol->st_info) == STB_GNU_UNIQUE)
        return refuse(&o->screen->refusal, &indirect_function,
                      "%s is an indirect function: its resolver would run before main.",
                      "%s es una función indirecta: su resolvedor se ejecutaría antes de "
                      "main.",
                      shown(o, name));
    if (symbol->st_shndx == SHN_COMMON)
        return count_static_data(o, symbol->st_size, true);
    if (!name[0])
        return 0;
    return symbol->st_shndx == SHN_UNDEF ? check_undefined(o, name, symbol)
                                         : check_defined(o, name, symbol);
}

static int check_sanitized_symbol(struct object *o, const Elf64_Sym *symbol)
{
    const char *name = string_at(o, &o->symbol_names, symbol->st_name);
    if (!name)
        return refuse_malformed(o, "a symbol's name lies outside the file");
    return name[0] && symbol->st_shndx == SHN_UNDEF ? check_undefined(o, name, symbol) : 0;
}

static void get_symbol(const struct object *o, uint64_t index, Elf64_Sym *symbol)
{
    memcpy(symbol, o->bytes + o->symbols.sh_offset + index * sizeof *symbol, sizeof *symbol);
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static void sort_undefined(struct screen *screen)
{
    int kept = 0;
    qsort(screen->undefined, (size_t)screen->undefined_count, sizeof *screen->undefined,
          compare_names);
    for (int i = 0; i < screen->undefined_count; i++)
        if (kept && strcmp(screen->undefined[i], screen->undefined[kept - 1]) == 0)
            free(screen->undefined[i]);
        else
            screen->undefined[kept++] = screen->undefined[i];
    screen->undefined_count = kept;
}

/* Returns 0, -1 when refused, 1 when memory runs out. */
static int check_symbols(struct object *o)
{
    uint64_t count = o->symbols.sh_size / sizeof(Elf64_Sym);
    o->screen->undefined = calloc(count + 1, sizeof *o->screen->undefined);
    if (!o->screen->undefined)
        return 1;
    int result = 0;
    for (uint64_t i = 0; i < count && result == 0; i++) {
        Elf64_Sym symbol;
        get_symbol(o, i, &symbol);
        result =
            o->rules->sanitized ? check_sanitized_symbol(o, &symbol) : check_symbol(o, &symbol);
    }
    sort_undefined(o->screen);
    return result;
}

/* ---------------------------------------------------------------- the exercise's functions */

static bool is_in_code(const struct object *o, const Elf64_Sym *symbol)
{
    Elf64_Shdr section;
    return get_section(o, symbol->st_shndx, &section) && (section.sh_flags & SHF_EXECINSTR) &&
           symbol->st_value < section.sh_size;
}

static int refuse_missing(struct object *o, const char *function)
{
    if (!o->other_function)
        return refuse(&o->screen->refusal, &missing_function,
                      "%s is not defined: did you rename it?",
                      "%s no está definida: ¿le cambió el nombre?", function);
    return refuse(&o->screen->refusal, &missing_function,
                  "%s is not defined: did you rename it? The file defines %s.",
                  "%s no está definida: ¿le cambió el nombre? El archivo define %s.", function,
                  shown(o, o->other_function));
}

static int check_function(struct object *o, const char *function)
{
    uint64_t count = o->symbols.sh_size / sizeof(Elf64_Sym);
    for (uint64_t i = 0; i < count; i++) {
        Elf64_Sym symbol;
        get_symbol(o, i, &symbol);
        const char *name = string_at(o, &o->symbol_names, symbol.st_name);
        if (!name || strcmp(name, function) != 0 || symbol.st_shndx == SHN_UNDEF)
            continue;
        if (ELF64_ST_BIND(symbol.st_info) == STB_LOCAL)
            return refuse(&o->screen->refusal, &not_a_function,
                          "%s is static: the grader cannot call it. Remove `static`.",
                          "%s es static: el corrector no puede llamarla. Quite `static`.",
                          function);
        if (ELF64_ST_TYPE(symbol.st_info) != STT_FUNC || !is_in_code(o, &symbol))
            return refuse(&o->screen->refusal, &not_a_function,
                          "%s is defined, but not as a function.",
                          "%s está definida, pero no como función.", function);
        return 0;
    }
    return refuse_missing(o, function);
}

int screen_object(const void *bytes, size_t count, const struct screen_rules *rules,
                  struct screen *screen, struct error *err)
{
    *screen = (struct screen){0};
    struct object o = {.bytes = bytes, .count = count, .rules = rules, .screen = screen};
    if (read_header(&o) || check_sections(&o))
        return 0;
    int result = check_symbols(&o);
    if (result > 0) {
        screen_release(screen);
        return error_set(err, "screening an object of %zu bytes: out of memory", count);
    }
    for (const char *const *f = rules->functions; result == 0 && *f; f++)
        result = check_function(&o, *f);
    return 0;
}

void screen_program(const void *bytes, size_t count, struct refusal *refusal)
{
    (void)check_requests(bytes, count, refusal);
}

void screen_release(struct screen *screen)
{
    for (int i = 0; i < screen->undefined_count; i++)
        free(screen->undefined[i]);
    free(screen->undefined);
    *screen = (struct screen){0};
}
