/* Names and elements of judgements in both languages; see judgement_words.h. */
#include "graders/engine/run/judgement_words.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

struct translation {
    const char *english, *spanish;
};

static const struct translation causes[] = {
    {"beyond-32-bits", "más de 32 bits"},
    {"beyond-64-bits", "más de 64 bits"},
    {"byte-a-cell", "un byte por celda"},
    {"byte-count", "número de bytes"},
    {"cell-inside", "celda interior a 0"},
    {"cell-outside", "celda exterior a 1"},
    {"cell-uncovered", "celda sin cubrir"},
    {"closed-grid", "rejilla cerrada"},
    {"corner-not-centre", "esquina en lugar de centro"},
    {"count-forgotten", "contador olvidado"},
    {"degenerate-triangle", "triángulo degenerado"},
    {"duplicate-edge", "arista duplicada"},
    {"duplicate-triangle", "triángulo duplicado"},
    {"each-corner", "cada esquina"},
    {"exchanged", "intercambiados"},
    {"extra-edge", "sobra una arista"},
    {"fence-post", "error por uno en los extremos"},
    {"formula-differs", "la fórmula no es lo construido"},
    {"half-the-triangles", "la mitad de los triángulos"},
    {"highest-bit-first", "primero el bit más alto"},
    {"impossible-accepted", "acepta lo imposible"},
    {"impossible-count", "número imposible"},
    {"index-out-of-range", "índice fuera de rango"},
    {"kilobyte-of-1000", "KB de 1000 bytes"},
    {"malformed-answer", "respuesta mal formada"},
    {"measured-size", "tamaño medido"},
    {"megabyte-of-1000000", "MB de 1000000 bytes"},
    {"meridian-stored-twice", "meridiano guardado dos veces"},
    {"mesh-formula", "fórmula de la malla"},
    {"missing-edge", "falta una arista"},
    {"negative-area", "área negativa"},
    {"no-table", "sin tabla"},
    {"not-a-number", "no es un número"},
    {"not-euler", "no cumple la fórmula de Euler"},
    {"not-triangles", "las caras no son triángulos"},
    {"one-too-few", "uno de menos"},
    {"one-too-many", "uno de más"},
    {"only-points", "solo los puntos"},
    {"only-vertices", "solo los vértices"},
    {"overflow", "desbordamiento"},
    {"overflow-accepted", "acepta un desbordamiento"},
    {"padded-slices", "capas con relleno"},
    {"pole-crowded", "polo con vértices de más"},
    {"pole-not-closed", "polo sin cerrar"},
    {"processed-differs", "vértices procesados distintos"},
    {"radius-times-two", "radio por dos"},
    {"refused", "rechaza lo posible"},
    {"replicated-seam", "costura duplicada"},
    {"rounded", "redondeado"},
    {"rounded-down", "redondeado hacia abajo"},
    {"seam-open", "costura abierta"},
    {"self-edge", "arista degenerada"},
    {"shared-poles", "polos compartidos"},
    {"short-pointers", "punteros de 4 bytes"},
    {"sphere-inside-out", "esfera del revés"},
    {"square-only", "solo rejillas cuadradas"},
    {"strip-count", "número de tiras"},
    {"strip-leaves-row", "tira que sale de su fila"},
    {"strip-missing", "falta una tira"},
    {"table-forgotten", "tabla de tiras olvidada"},
    {"table-missing", "falta la tabla"},
    {"too-small", "demasiado pequeño"},
    {"torus", "como en un toro"},
    {"transposed", "traspuesto"},
    {"triangle-count", "número de triángulos"},
    {"triangle-flipped", "triángulo invertido"},
    {"triangle-not-in-cell", "triángulo fuera de su celda"},
    {"triangle-repeated", "triángulo repetido"},
    {"triangles-forgotten", "triángulos olvidados"},
    {"triangles-overlap", "triángulos solapados"},
    {"unknown-status", "estado desconocido"},
    {"unused-bits", "bits sobrantes"},
    {"upside-down", "cociente invertido"},
    {"vertex-count", "número de vértices"},
    {"vertex-off-grid", "vértice fuera de la rejilla"},
    {"vertex-off-sphere", "vértice fuera de la esfera"},
    {"vertex-repeated", "vértice repetido"},
    {"vertices-per-strip", "vértices por tira"},
    {"voxel-formula", "fórmula de los vóxeles"},
    {"wrong-area", "área incorrecta"},
    {"wrong-formula", "fórmula incorrecta"},
    {"wrong-number", "número incorrecto"},
    {"wrong-ratio", "cociente incorrecto"},
};

/* What elements are made of; longer texts first. */
static const struct translation nouns[] = {{"total area", "área total"},
                                           {"triangles", "triángulos"},
                                           {"triangle", "triángulo"},
                                           {"vertices", "vértices"},
                                           {"vertex", "vértice"},
                                           {"edges", "aristas"},
                                           {"edge", "arista"},
                                           {"faces", "caras"},
                                           {"face", "cara"},
                                           {"strip", "tira"},
                                           {"cells", "celdas"},
                                           {"cell", "celda"},
                                           {"entry", "entrada"},
                                           {"bit", "bit"},
                                           {"byte", "byte"}};

static bool is_word_part(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

static const struct translation *noun_at(const char *at)
{
    for (size_t i = 0; i < sizeof nouns / sizeof *nouns; i++) {
        size_t length = strlen(nouns[i].english);
        if (strncmp(at, nouns[i].english, length) == 0 && !is_word_part(at[length]))
            return &nouns[i];
    }
    return NULL;
}

static void say_element(const char *element, struct message *message)
{
    bool is_start = true; /* of a word */
    message_set_phrase(message, (struct phrase){element, NULL});
    for (const char *at = element; *at;) {
        const struct translation *noun = is_start ? noun_at(at) : NULL;
        if (noun)
            message_es(message, "%s", noun->spanish);
        else
            message_es(message, "%c", *at);
        is_start = !noun && !is_word_part(*at);
        at += noun ? strlen(noun->english) : 1;
    }
}

static void say_cause(const char *slug, struct message *name)
{
    const char *spanish = NULL;
    message_set_phrase(
        name, (struct phrase){strcmp(slug, "self-edge") == 0 ? "degenerate-edge" : slug, NULL});
    for (char *c = name->en; *c; c++)
        if (*c == '-')
            *c = ' ';
    for (size_t i = 0; i < sizeof causes / sizeof *causes; i++)
        if (strcmp(causes[i].english, slug) == 0)
            spanish = causes[i].spanish;
    message_es(name, "%s", spanish ? spanish : name->en);
}

void judgement_words(const struct judgement *judgement, struct attempt *attempt)
{
    snprintf(attempt->cause, sizeof attempt->cause, "%s", judgement->cause);
    say_cause(judgement->cause, &attempt->cause_name);
    say_element(judgement->element, &attempt->element);
    message_set_phrase(&attempt->message,
                       (struct phrase){judgement->message, judgement->message_es});
}
