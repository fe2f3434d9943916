/* Causes and elements in both languages; see words.h. Results name them in English. */
#include "graders/report/words.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct translation {
    const char *english, *spanish;
};

/* In the order of strcmp. */
static const struct translation causes[] = {
    {"abort", "abort o assert"},
    {"allocation-failure", "reserva denegada"},
    {"answer-too-long", "respuesta demasiado larga"},
    {"archive-broken", "archivo comprimido dañado"},
    {"archive-device", "archivo comprimido con dispositivos"},
    {"archive-encrypted", "archivo comprimido cifrado"},
    {"archive-kind", "tipo de archivo comprimido"},
    {"archive-link", "archivo comprimido con enlaces"},
    {"archive-nested", "archivos comprimidos anidados"},
    {"archive-path", "ruta no permitida"},
    {"archive-ratio", "compresión excesiva"},
    {"archive-too-large", "archivo comprimido demasiado grande"},
    {"archive-too-many", "archivo comprimido con demasiados archivos"},
    {"archive-unread", "archivo comprimido sin leer"},
    {"archive-unreadable", "archivo comprimido ilegible"},
    {"basic-class", "clase básica"},
    {"behaves-differently", "se comporta de otro modo"},
    {"beyond-32-bits", "más de 32 bits"},
    {"beyond-64-bits", "más de 64 bits"},
    {"broken-pipe", "tubería rota"},
    {"broken-protocol", "programa dañado"},
    {"byte-a-cell", "un byte por celda"},
    {"byte-count", "número de bytes"},
    {"cell-inside", "celda interior a 0"},
    {"cell-outside", "celda exterior a 1"},
    {"cell-uncovered", "celda sin cubrir"},
    {"claims-out-of-memory", "dice que faltó memoria"},
    {"closed-grid", "rejilla cerrada"},
    {"compiler-memory", "memoria del compilador"},
    {"compiler-output", "salida del compilador"},
    {"compiler-time", "tiempo del compilador"},
    {"constructor", "constructor"},
    {"corner-not-centre", "esquina en lugar de centro"},
    {"count-forgotten", "contador olvidado"},
    {"cpu-limit", "límite de tiempo de CPU"},
    {"degenerate-triangle", "triángulo degenerado"},
    {"device", "dispositivo"},
    {"division", "división por cero"},
    {"duplicate-edge", "arista duplicada"},
    {"duplicate-triangle", "triángulo duplicado"},
    {"each-corner", "cada esquina"},
    {"exchanged", "intercambiados"},
    {"executable-stack", "pila ejecutable"},
    {"exit", "terminó el programa"},
    {"extra-edge", "sobra una arista"},
    {"fence-post", "error por uno en los extremos"},
    {"file-name", "nombre de archivo"},
    {"file-too-large", "archivo demasiado grande"},
    {"file-twice", "entregado dos veces"},
    {"folder-path", "ruta de la carpeta"},
    {"folder-too-large", "carpeta demasiado grande"},
    {"folder-unreadable", "carpeta ilegible"},
    {"forbidden-attribute", "atributo no permitido"},
    {"forbidden-include", "inclusión no permitida"},
    {"forbidden-line", "línea no permitida"},
    {"forbidden-pragma", "pragma no permitido"},
    {"forbidden-section", "sección no permitida"},
    {"forbidden-symbol", "símbolo no permitido"},
    {"formula-differs", "la fórmula no es lo construido"},
    {"found", "encontrado"},
    {"half-the-triangles", "la mitad de los triángulos"},
    {"harness", "corrector"},
    {"highest-bit-first", "primero el bit más alto"},
    {"idle-limit", "límite de tiempo de espera"},
    {"illegal-instruction", "instrucción desconocida"},
    {"impossible-accepted", "acepta lo imposible"},
    {"impossible-count", "número imposible"},
    {"index-out-of-range", "índice fuera de rango"},
    {"indirect-function", "función indirecta"},
    {"inline-assembly", "ensamblador en línea"},
    {"input", "entrada modificada o rebasada"},
    {"kilobyte-of-1000", "KB de 1000 bytes"},
    {"leak", "fuga de memoria"},
    {"link", "enlace"},
    {"malformed-answer", "respuesta mal formada"},
    {"measured-size", "tamaño medido"},
    {"megabyte-of-1000000", "MB de 1000000 bytes"},
    {"memory-band", "margen de memoria"},
    {"memory-limit", "límite de memoria"},
    {"memory-outside-heap", "memoria fuera de malloc"},
    {"meridian-stored-twice", "meridiano guardado dos veces"},
    {"mesh-formula", "fórmula de la malla"},
    {"missing-edge", "falta una arista"},
    {"missing-function", "falta la función"},
    {"negative-area", "área negativa"},
    {"no-counts", "cuentas increíbles"},
    {"no-source", "sin fuentes"},
    {"no-table", "sin tabla"},
    {"no-valgrind", "sin valgrind"},
    {"not-a-function", "no es una función"},
    {"not-a-number", "no es un número"},
    {"not-allocated", "puntero no reservado"},
    {"not-euler", "no cumple la fórmula de Euler"},
    {"not-reached", "sin examinar"},
    {"not-triangles", "las caras no son triángulos"},
    {"null-pointer", "puntero nulo"},
    {"object-malformed", "archivo objeto incorrecto"},
    {"one-too-few", "uno de menos"},
    {"one-too-many", "uno de más"},
    {"only-points", "solo los puntos"},
    {"only-vertices", "solo los vértices"},
    {"output-limit", "límite de salida"},
    {"overflow", "desbordamiento"},
    {"overflow-accepted", "acepta un desbordamiento"},
    {"padded-slices", "capas con relleno"},
    {"pole-crowded", "polo con vértices de más"},
    {"pole-not-closed", "polo sin cerrar"},
    {"processed-differs", "vértices procesados distintos"},
    {"radius-times-two", "radio por dos"},
    {"raw-string", "cadena sin procesar"},
    {"refused", "rechaza lo posible"},
    {"replicated-seam", "costura duplicada"},
    {"rounded", "redondeado"},
    {"rounded-down", "redondeado hacia abajo"},
    {"sanitizer-symbol", "símbolo de las herramientas"},
    {"seam-open", "costura abierta"},
    {"segmentation-fault", "acceso a memoria ajena"},
    {"self-edge", "arista degenerada"},
    {"shared-poles", "polos compartidos"},
    {"short-pointers", "punteros de 4 bytes"},
    {"sphere-inside-out", "esfera del revés"},
    {"square-only", "solo rejillas cuadradas"},
    {"stack-overflow", "pila agotada"},
    {"static-data", "datos estáticos"},
    {"strip-count", "número de tiras"},
    {"strip-leaves-row", "tira que sale de su fila"},
    {"strip-missing", "falta una tira"},
    {"syntax", "sintaxis"},
    {"system-call-instruction", "llamada directa al sistema"},
    {"table-forgotten", "tabla de tiras olvidada"},
    {"table-missing", "falta la tabla"},
    {"time-denies-counts", "el tiempo desmiente las cuentas"},
    {"too-many-files", "demasiados archivos"},
    {"too-much-for-tool", "demasiado para la herramienta"},
    {"too-small", "demasiado pequeño"},
    {"tool-request", "petición a la herramienta"},
    {"torus", "como en un toro"},
    {"transposed", "traspuesto"},
    {"triangle-count", "número de triángulos"},
    {"triangle-flipped", "triángulo invertido"},
    {"triangle-not-in-cell", "triángulo fuera de su celda"},
    {"triangle-repeated", "triángulo repetido"},
    {"triangles-forgotten", "triángulos olvidados"},
    {"triangles-overlap", "triángulos solapados"},
    {"unknown-status", "estado desconocido"},
    {"unreadable", "ilegible"},
    {"unused-bits", "bits sobrantes"},
    {"upside-down", "cociente invertido"},
    {"vertex-count", "número de vértices"},
    {"vertex-off-grid", "vértice fuera de la rejilla"},
    {"vertex-off-sphere", "vértice fuera de la esfera"},
    {"vertex-repeated", "vértice repetido"},
    {"vertices-per-strip", "vértices por tira"},
    {"voxel-formula", "fórmula de los vóxeles"},
    {"wild-pointer", "puntero inválido"},
    {"work-band", "margen de trabajo"},
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

static int by_english(const void *slug, const void *entry)
{
    return strcmp(slug, ((const struct translation *)entry)->english);
}

struct words words_cause(const char *slug, char *text, size_t capacity)
{
    if (words_know_verdict(slug))
        return words_verdict(slug);
    words_of_slug(slug, text, capacity);
    const struct translation *found =
        bsearch(slug, causes, sizeof causes / sizeof *causes, sizeof *causes, by_english);
    return (struct words){text, found ? found->spanish : text};
}

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

struct words words_element(const char *element, char *spanish, size_t capacity)
{
    size_t used = 0;
    bool is_start = true; /* of a word */
    spanish[0] = '\0';
    for (const char *at = element; *at && used + 1 < capacity;) {
        const struct translation *noun = is_start ? noun_at(at) : NULL;
        int written = noun ? snprintf(spanish + used, capacity - used, "%s", noun->spanish)
                           : snprintf(spanish + used, capacity - used, "%c", *at);
        used += (size_t)written;
        is_start = !noun && !is_word_part(*at);
        at += noun ? strlen(noun->english) : 1;
    }
    return (struct words){element, spanish};
}
