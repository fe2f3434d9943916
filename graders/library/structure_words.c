/* Causes and words for connected structures; see structure.h. */
#include "graders/library/structure.h"

#include <inttypes.h>
#include <stddef.h>

const struct cause structure_wrong_vertex = {"wrong-vertex",
                                             {"wrong vertex", "vértice equivocado"}};
const struct cause structure_wrong_face = {"wrong-face", {"wrong face", "cara equivocada"}};
const struct cause structure_wrong_link = {"wrong-link", {"wrong link", "enlace equivocado"}};
const struct cause structure_out_of_range = {"link-out-of-range",
                                             {"link out of range", "enlace fuera de rango"}};
const struct cause structure_extra = {"not-an-edge",
                                      {"not an edge of the mesh", "no es arista de la malla"}};
const struct cause structure_repeated = {"repeated-row", {"repeated row", "fila repetida"}};
const struct cause structure_missing = {"missing-row", {"missing row", "falta una fila"}};
const struct cause structure_wrong_vertex_table = {
    "wrong-entry-of-vertex", {"wrong entry of a vertex", "entrada de vértice equivocada"}};
const struct cause structure_wrong_face_table = {
    "wrong-entry-of-face", {"wrong entry of a face", "entrada de cara equivocada"}};

const char *structure_column_name(enum structure_kind kind, int column)
{
    static const char *const winged[] = {"vi",  "vf",  "cd",  "ci",          "ada",
                                         "ads", "aia", "ais", "vertex_edge", "face_edge"};
    static const char *const half[] = {
        "origin", "twin", "face", "next", "previous", "vertex_half_edge", "face_half_edge"};
    int count = kind == STRUCTURE_WINGED_EDGE ? WINGED_FACE_EDGE + 1 : HALF_OF_FACE + 1;
    if (column < 0 || column >= count)
        return "";
    return kind == STRUCTURE_WINGED_EDGE ? winged[column] : half[column];
}

static const struct cause *cause_of_entry(const struct structure_fault *fault)
{
    if (fault->structure == STRUCTURE_WINGED_EDGE)
        switch (fault->column) {
        case WINGED_VI:
        case WINGED_VF:
            return &structure_wrong_vertex;
        case WINGED_CD:
        case WINGED_CI:
            return &structure_wrong_face;
        case WINGED_VERTEX_EDGE:
            return &structure_wrong_vertex_table;
        case WINGED_FACE_EDGE:
            return &structure_wrong_face_table;
        default:
            return &structure_wrong_link;
        }
    switch (fault->column) {
    case HALF_ORIGIN:
        return &structure_wrong_vertex;
    case HALF_FACE:
        return &structure_wrong_face;
    case HALF_OF_VERTEX:
        return &structure_wrong_vertex_table;
    case HALF_OF_FACE:
        return &structure_wrong_face_table;
    default:
        return &structure_wrong_link;
    }
}

const struct cause *structure_fault_cause(const struct structure_fault *fault)
{
    switch (fault->kind) {
    case STRUCTURE_FINE:
        return NULL;
    case STRUCTURE_NO_ELEMENT:
        return &structure_extra;
    case STRUCTURE_REPEATED:
        return &structure_repeated;
    case STRUCTURE_MISSING:
        return &structure_missing;
    case STRUCTURE_WRONG_ENTRY:
        break;
    }
    return fault->is_out_of_range ? &structure_out_of_range : cause_of_entry(fault);
}

static struct phrase row_noun(const struct structure_fault *fault)
{
    static const struct phrase edge = {"edge", "la arista"};
    static const struct phrase half_edge = {"half edge", "la semiarista"};
    return fault->structure == STRUCTURE_WINGED_EDGE ? edge : half_edge;
}

/* A number of a table, as students write it: their constant where nothing is. */
static void add_number(struct message *message, int32_t number)
{
    if (number == STRUCTURE_NONE)
        message_add(message, "NONE", "NONE");
    else
        message_add(message, "%" PRId32, "%" PRId32, number);
}

/* "7", or "any of 7, 9, 11". */
static void say_wanted(const struct structure_fault *fault, struct message *message)
{
    if (fault->wanted_count > 1)
        message_add(message, "any of ", "cualquiera de ");
    for (int64_t i = 0; i < fault->wanted_count && i < STRUCTURE_WANTED_MOST; i++) {
        message_add(message, "%s", "%s", i > 0 ? ", " : "");
        add_number(message, fault->wanted[i]);
    }
    if (fault->wanted_count > STRUCTURE_WANTED_MOST)
        message_add(message, " ...", " ...");
}

static void say_entry(const struct structure_fault *fault, struct message *message)
{
    const char *name = structure_column_name(fault->structure, fault->column);
    bool is_row = fault->from != STRUCTURE_NONE;
    struct phrase noun = row_noun(fault);
    if (is_row) {
        message_en(message, "%s of %s %" PRId64 " (%" PRId32 ",%" PRId32 ") is ", name, noun.en,
                   fault->row, fault->from, fault->to);
        message_es(message, "%s de %s %" PRId64 " (%" PRId32 ",%" PRId32 ") es ", name, noun.es,
                   fault->row, fault->from, fault->to);
    } else {
        message_add(message, "%s[%" PRId64 "] is ", "%s[%" PRId64 "] es ", name, fault->row);
    }
    add_number(message, fault->found);
    message_add(message, "; right is ", "; lo correcto es ");
    say_wanted(fault, message);
}

void structure_fault_say(const struct structure_fault *fault, struct message *message)
{
    struct phrase noun = row_noun(fault);
    *message = (struct message){0};
    switch (fault->kind) {
    case STRUCTURE_FINE:
        break;
    case STRUCTURE_WRONG_ENTRY:
        say_entry(fault, message);
        break;
    case STRUCTURE_NO_ELEMENT:
        message_en(message, "%s %" PRId64 " is not in the mesh", noun.en, fault->row);
        message_es(message, "%s %" PRId64 " no está en la malla", noun.es, fault->row);
        break;
    case STRUCTURE_REPEATED:
        message_en(message, "%s %" PRId64 " (%" PRId32 ",%" PRId32 ") is in row %" PRId64 " too",
                   noun.en, fault->row, fault->from, fault->to, fault->repeated_of);
        message_es(message,
                   "%s %" PRId64 " (%" PRId32 ",%" PRId32 ") está también en la fila %" PRId64,
                   noun.es, fault->row, fault->from, fault->to, fault->repeated_of);
        break;
    case STRUCTURE_MISSING:
        message_en(message, "%s (%" PRId32 ",%" PRId32 ") is missing", noun.en, fault->from,
                   fault->to);
        message_es(message, "falta %s (%" PRId32 ",%" PRId32 ")", noun.es, fault->from, fault->to);
        break;
    }
}
