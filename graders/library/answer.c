/* Reading answers by their declaration; see answer.h. */
#include "graders/library/answer.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

enum { SPARE_ROWS = 16, WORD = 8 };

static const struct cause malformed = {"malformed-answer",
                                       {"incomplete answer", "respuesta incompleta"}};
static const struct cause impossible_count = {"impossible-count",
                                              {"impossible count", "número imposible"}};
static const struct cause no_table = {"no-table", {"no table", "sin tabla"}};
static const struct cause bad_offsets = {"offsets-wrong",
                                         {"wrong offsets", "desplazamientos incorrectos"}};
static const struct cause out_of_range = {"index-out-of-range",
                                          {"index out of range", "índice fuera de rango"}};
static const struct cause not_finite = {"not-finite", {"not a number", "no es un número"}};
static const struct cause unknown_status = {"unknown-status",
                                            {"unknown status", "estado desconocido"}};
static const struct cause wrongly_refused = {"wrongly-refused",
                                             {"wrongly refused", "rechazada sin motivo"}};
static const struct cause not_refused = {"not-refused", {"not refused", "no rechazada"}};
static const struct cause other_refusal = {"other-refusal",
                                           {"refused for another reason", "otro rechazo"}};

/* ------------------------------------------------------------------------------------- bounds */

int64_t answer_room(struct room room, struct input_sizes sizes)
{
    return room.once + room.per_vertex * sizes.vertices + room.per_face * sizes.faces +
           room.per_corner * sizes.corners;
}

static size_t value_bytes(const struct answer_part *part)
{
    static const size_t bytes[] = {
        [TYPE_INT32] = 4, [TYPE_FLOAT] = 4, [TYPE_DOUBLE] = 8, [TYPE_BYTE] = 1};
    return bytes[part->type];
}

static int64_t with_spare(int64_t rows)
{
    return 2 * rows + SPARE_ROWS;
}

/* A table in a packet: its count, the count that follows, and the rows. */
static size_t table_bytes(int64_t rows, size_t row_bytes)
{
    return 2 * WORD + ((size_t)rows * row_bytes + WORD - 1) / WORD * WORD;
}

static size_t part_bound(const struct answer_rule *rule, const struct answer_part *part,
                         struct input_sizes sizes)
{
    int64_t most = answer_room(part->most, sizes), counted = answer_room(rule->most, sizes);
    size_t row_bytes = value_bytes(part) * (size_t)part->columns;
    if (part->rows == ROWS_OF_ROWS)
        return table_bytes(with_spare(counted) + 1, sizeof(int32_t)) +
               table_bytes(with_spare(most), value_bytes(part));
    return table_bytes(part->rows == ROWS_FIXED ? most : with_spare(counted), row_bytes);
}

size_t answer_bound(const struct answer_rule *rule, struct input_sizes sizes)
{
    size_t bytes = WORD;
    for (int i = 0; i < ANSWER_PARTS && rule->parts[i].argument; i++)
        bytes += part_bound(rule, &rule->parts[i], sizes);
    return bytes;
}

/* ------------------------------------------------------------------------------------- result */

static void reject_malformed(const struct answer_rule *rule, struct judgement *out)
{
    judge_reject(out, &malformed, "The answer of %s is incomplete.",
                 "La respuesta de %s está incompleta.", rule->function);
}

static const struct answer_code *find_code(const struct answer_rule *rule, int64_t result)
{
    for (int i = 0; i < ANSWER_CODES && rule->codes[i].value != 0; i++)
        if (rule->codes[i].value == result)
            return &rule->codes[i];
    return NULL;
}

static void reject_count(const struct answer_rule *rule, int64_t result, int64_t most,
                         struct judgement *out)
{
    if (!judge_reject_for(out, &impossible_count))
        return;
    if (result < 0) {
        judge_en(out,
                 "%s returned %" PRId64 " %s; a count is 0 or more, and only OUT_OF_MEMORY "
                 "(-1) says that memory ran out.",
                 rule->function, result, rule->counted.en);
        judge_es(out,
                 "%s ha devuelto %" PRId64 " %s; un número es 0 o más, y solo OUT_OF_MEMORY "
                 "(-1) indica que se agotó la memoria.",
                 rule->function, result, rule->counted.es);
    } else {
        judge_en(out, "%s returned %" PRId64 " %s; with this input there are at most %" PRId64 ".",
                 rule->function, result, rule->counted.en, most);
        judge_es(out, "%s ha devuelto %" PRId64 " %s; con esta entrada hay como mucho %" PRId64 ".",
                 rule->function, result, rule->counted.es, most);
    }
}

/* The function's own result. Returns whether the parts follow. */
static bool read_result(const struct answer_rule *rule, struct input_sizes sizes,
                        struct reader *reader, struct answer *answer, struct judgement *out)
{
    if (rule->result == RESULT_REAL) {
        answer->real = read_real(reader);
        if (reader->failed)
            reject_malformed(rule, out);
        return !reader->failed;
    }
    answer->result = read_int(reader);
    answer->refusal = find_code(rule, answer->result);
    int64_t most = answer_room(rule->most, sizes);
    if (reader->failed)
        reject_malformed(rule, out);
    else if (answer->refusal)
        return true;
    else if (rule->result == RESULT_STATUS && answer->result != 0)
        judge_reject(out, &unknown_status, "%s returned %" PRId64 ", not 0.",
                     "%s ha devuelto %" PRId64 ", no 0.", rule->function, answer->result);
    else if (rule->result == RESULT_COUNT &&
             (answer->result < 0 || answer->result > with_spare(most)))
        reject_count(rule, answer->result, most, out);
    return !out->cause[0];
}

/* -------------------------------------------------------------------------------------- places */

/* Which part the how-manieth table belongs to; NULL: none. *name gets the table's own. */
static const struct answer_part *part_of_table(const struct answer_rule *rule, uint32_t table,
                                               const char **name)
{
    for (int i = 0; i < ANSWER_PARTS && rule->parts[i].argument; i++) {
        const struct answer_part *part = &rule->parts[i];
        const char *const names[] = {part->rows == ROWS_OF_ROWS ? part->offsets : NULL,
                                     part->values};
        uint32_t tables = part->rows == ROWS_OF_ROWS ? 2 : 1;
        if (table > tables) {
            table -= tables;
            continue;
        }
        *name = names[table - 1] ? names[table - 1] : part->argument;
        return part;
    }
    return NULL;
}

void answer_place(const struct answer_rule *rule, uint32_t table, int64_t byte,
                  struct message *place)
{
    const char *name = NULL;
    const struct answer_part *part = rule && table > 0 ? part_of_table(rule, table, &name) : NULL;
    if (table == 0 && rule) {
        message_say(place, "what %s returns", "lo que devuelve %s", rule->function);
    } else if (table == 0) {
        message_say(place, "what the function returns", "lo que devuelve la función");
    } else if (!part) {
        message_say(place, "byte %" PRId64 " of array %" PRIu32 " of the answer",
                    "el byte %" PRId64 " de la tabla %" PRIu32 " de la respuesta", byte, table);
    } else {
        int64_t cell = byte / (int64_t)value_bytes(part);
        const char *column = part->column[cell % part->columns].name;
        if (column)
            message_say(place, "%s of row %" PRId64 " of %s", "%s de la fila %" PRId64 " de %s",
                        column, cell / part->columns, name);
        else
            message_say(place, "entry %" PRId64 " of %s", "la entrada %" PRId64 " de %s", cell,
                        name);
    }
}

/* -------------------------------------------------------------------------------------- parts */

/* One table of the packet. Returns its rows, NULL when there are none to look at. */
static const void *read_rows(struct reader *reader, int64_t wanted, size_t row_bytes,
                             const char *argument, const struct answer_rule *rule,
                             struct judgement *out)
{
    int64_t claimed;
    const void *rows = read_table(reader, &claimed, row_bytes);
    if (reader->failed || claimed != wanted)
        reject_malformed(rule, out);
    else if (!rows)
        judge_reject(out, &no_table, "%s needs %" PRId64 " rows, but %s is NULL.",
                     "%s necesita %" PRId64 " filas, pero %s es NULL.", rule->function, wanted,
                     argument);
    return out->cause[0] ? NULL : rows;
}

static void reject_offsets(const struct answer_part *part, const struct answer_table *table,
                           int64_t row, struct judgement *out)
{
    judge_name_one(out, part->row, "%" PRId64, row);
    if (row == 0 && table->first[0] != 0)
        judge_reject(out, &bad_offsets, "The first offset is %d; it is always 0.",
                     "El primer desplazamiento es %d; siempre es 0.", table->first[0]);
    else
        judge_reject(out, &bad_offsets,
                     "Offset %" PRId64 " is %d and the next one is %d: offsets never fall, and end "
                     "at the number of values.",
                     "El desplazamiento %" PRId64 " es %d y el siguiente es %d: nunca disminuyen y "
                     "acaban en el número de valores.",
                     row, table->first[row], table->first[row + 1]);
}

static bool read_offsets(const struct answer_rule *rule, const struct answer_part *part,
                         struct input_sizes sizes, struct reader *reader, struct answer *answer,
                         struct answer_table *table, struct judgement *out)
{
    static const int32_t nothing = 0;
    int64_t offsets = answer->result > 0 ? answer->result + 1 : 0;
    table->row_count = answer->result;
    table->first = read_rows(reader, offsets, sizeof *table->first, part->argument, rule, out);
    if (!table->first)
        return false;
    table->first = offsets > 0 ? table->first : &nothing;
    int64_t most = with_spare(answer_room(part->most, sizes));
    for (int64_t r = 0; r < table->row_count; r++) {
        int64_t from = table->first[r], to = table->first[r + 1];
        if ((r == 0 && from != 0) || to < from || to > most) {
            reject_offsets(part, table, r, out);
            return false;
        }
    }
    table->count = table->first[table->row_count];
    return true;
}

static bool read_part(const struct answer_rule *rule, const struct answer_part *part,
                      struct input_sizes sizes, struct reader *reader, struct answer *answer,
                      struct answer_table *table, struct judgement *out)
{
    table->columns = part->columns;
    table->count = part->rows == ROWS_FIXED ? answer_room(part->most, sizes) : answer->result;
    if (part->rows == ROWS_OF_ROWS && !read_offsets(rule, part, sizes, reader, answer, table, out))
        return false;
    size_t row_bytes = value_bytes(part) * (size_t)part->columns;
    table->cells = read_rows(reader, table->count, row_bytes, part->argument, rule, out);
    return !out->cause[0];
}

/* ------------------------------------------------------------------------------------ indices */

static int64_t index_limit(enum index_of of, struct input_sizes sizes, const struct answer *answer)
{
    const int64_t limits[] = {[OF_NOTHING] = 0,
                              [OF_VERTEX] = sizes.vertices,
                              [OF_FACE] = sizes.faces,
                              [OF_CORNER] = sizes.corners,
                              [OF_RESULT] = answer->result};
    return limits[of];
}

static struct phrase index_noun(enum index_of of, const struct answer_rule *rule)
{
    static const struct phrase nouns[] = {[OF_NOTHING] = {"values", "valores"},
                                          [OF_VERTEX] = {"vertices", "vértices"},
                                          [OF_FACE] = {"faces", "caras"},
                                          [OF_CORNER] = {"corners", "esquinas"}};
    return of == OF_RESULT ? rule->counted : nouns[of];
}

static struct answer_column column_of(const struct answer_part *part, int column)
{
    if (part->column[column].name)
        return part->column[column];
    return (struct answer_column){NULL, part->of, part->may_be_none};
}

static bool fits(int32_t value, struct answer_column column, int64_t limit)
{
    return column.of == OF_NOTHING || (value >= 0 && value < limit) ||
           (column.may_be_none && value == -1);
}

/* What the value looks like; each of these holds for the very value that is told. */
static struct phrase range_hint(int32_t value, struct answer_column column, int64_t limit)
{
    if (value == -1 && !column.may_be_none)
        return (struct phrase){"Is -1 a mark of the program for 'none'?",
                               "¿Es -1 una marca del programa para decir 'ninguno'?"};
    if (value == limit && column.of != OF_RESULT) /* of its own rows: the count may be wrong */
        return (struct phrase){"Is counting from 1?", "¿Se cuenta desde 1?"};
    if (limit > INT16_MAX + 1 && value < 0)
        return (struct phrase){"Does a number overflow? Here they need more than 15 bits.",
                               "¿Se desborda un número? Aquí ocupan más de 15 bits."};
    return (struct phrase){NULL, NULL};
}

/* " (3,9)": the row, or its first values. */
static void print_row(const struct answer_table *table, int64_t row, char *text, size_t capacity)
{
    struct message m;
    message_clear(&m);
    for (int c = 0; c < table->columns; c++)
        message_en(&m, "%s%d", c ? "," : " (", answer_int(table, row, c));
    message_en(&m, ")");
    strncpy(text, m.en, capacity - 1);
    text[capacity - 1] = '\0';
}

/* The row of unequal length that has the value. */
static int64_t row_of_value(const struct answer_table *table, int64_t value)
{
    int64_t row = 0;
    while (table->first[row + 1] <= value)
        row++;
    return row;
}

static void reject_range(const struct answer_rule *rule, const struct answer_part *part,
                         const struct answer_table *table, int64_t row, int column, int64_t limit,
                         struct judgement *out)
{
    struct answer_column kind = column_of(part, column);
    struct phrase noun = index_noun(kind.of, rule);
    int32_t value = answer_int(table, row, column);
    char text[120] = "";
    if (table->first) /* a value of a row: rows are what the student counts */
        row = row_of_value(table, row);
    else
        print_row(table, row, text, sizeof text);
    judge_name_one(out, part->row, "%" PRId64 "%s", row, text);
    if (!judge_reject_for(out, &out_of_range))
        return;
    judge_en(out, "%s %" PRId64 "%s: ", part->row.en, row, text);
    judge_es(out, "%s %" PRId64 "%s: ", part->row.es, row, text);
    if (kind.name) {
        judge_en(out, "%s is ", kind.name);
        judge_es(out, "%s es ", kind.name);
    }
    judge_en(out, kind.name ? "%d, out of range; " : "%d is out of range; ", value);
    judge_es(out, kind.name ? "%d, fuera de rango; " : "%d está fuera de rango; ", value);
    if (limit > 0) {
        judge_en(out, "%s are numbered 0 to %" PRId64 ".", noun.en, limit - 1);
        judge_es(out, "los números de %s van de 0 a %" PRId64 ".", noun.es, limit - 1);
    } else {
        judge_en(out, "there are no %s.", noun.en);
        judge_es(out, "no hay %s.", noun.es);
    }
    judge_hint(out, range_hint(value, kind, limit));
}

static bool check_indices(const struct answer_rule *rule, const struct answer_part *part,
                          const struct answer_table *table, struct input_sizes sizes,
                          const struct answer *answer, struct judgement *out)
{
    for (int64_t row = 0; part->type == TYPE_INT32 && row < table->count; row++)
        for (int c = 0; c < table->columns; c++) {
            struct answer_column column = column_of(part, c);
            int64_t limit = index_limit(column.of, sizes, answer);
            if (fits(answer_int(table, row, c), column, limit))
                continue;
            reject_range(rule, part, table, row, c, limit, out);
            return false;
        }
    return true;
}

/* -------------------------------------------------------------------------------------- reals */

/* No right answer holds a NaN or an infinity. */
static bool check_reals(const struct answer_part *part, const struct answer_table *table,
                        struct judgement *out)
{
    bool is_float = part->type == TYPE_FLOAT;
    for (int64_t row = 0; (is_float || part->type == TYPE_DOUBLE) && row < table->count; row++)
        for (int c = 0; c < table->columns; c++) {
            double value = is_float ? answer_float(table, row, c) : answer_double(table, row, c);
            if (isfinite(value))
                continue;
            int64_t named = table->first ? row_of_value(table, row) : row;
            judge_name_one(out, part->row, "%" PRId64, named);
            judge_reject_for(out, &not_finite);
            judge_en(out, "%s %" PRId64 ": %s holds %g, which is no number.", part->row.en, named,
                     part->argument, value);
            judge_es(out, "%s %" PRId64 ": %s contiene %g, que no es un número.", part->row.es,
                     named, part->argument, value);
            return false;
        }
    return true;
}

/* ------------------------------------------------------------------------------------- whole */

bool answer_read(const struct answer_rule *rule, struct input_sizes sizes, struct span bytes,
                 struct answer *answer, struct judgement *out)
{
    struct reader reader = reader_of(bytes.bytes, bytes.count);
    memset(answer, 0, sizeof *answer);
    if (!read_result(rule, sizes, &reader, answer, out))
        return false;
    for (int i = 0; i < ANSWER_PARTS && rule->parts[i].argument && !answer->refusal; i++)
        if (!read_part(rule, &rule->parts[i], sizes, &reader, answer, &answer->table[i], out))
            return false;
    for (int i = 0; i < ANSWER_PARTS && rule->parts[i].argument && !answer->refusal; i++)
        if (!check_indices(rule, &rule->parts[i], &answer->table[i], sizes, answer, out) ||
            !check_reals(&rule->parts[i], &answer->table[i], out))
            return false;
    return true;
}

bool answer_refuses_rightly(const struct answer_rule *rule, const struct answer *answer,
                            const char *wanted, const struct message *why, struct judgement *out)
{
    const char *said = answer->refusal ? answer->refusal->name : NULL;
    if (!wanted && !said)
        return true;
    if (wanted && said && strcmp(wanted, said) == 0) {
        judge_accept(out);
    } else if (!wanted) {
        judge_reject(out, &wrongly_refused, "%s returned %s, but this input is no such case.",
                     "%s ha devuelto %s, pero esta entrada no es ese caso.", rule->function, said);
    } else if (judge_reject_for(out, said ? &other_refusal : &not_refused)) {
        judge_en(out, "%s returned %s; right is %s: %s.", rule->function, said ? said : "an answer",
                 wanted, why->en);
        judge_es(out, "%s ha devuelto %s; lo correcto es %s: %s.", rule->function,
                 said ? said : "una respuesta", wanted, why->es);
    }
    return false;
}
