/* Rows for tables of formulas, numbers and counts (formula.h, built.h), flat as one reads them, and
 * the mistakes that are usual in sizes.
 *
 *     static const struct number_mistake kilobyte_mistakes[] = {
 *         MISTAKE_KILOBYTE(592.908),
 *         MISTAKE(CAUSE_FENCE_POST, 576, "128 cells have 129 vertices.", "128 celdas tienen ..."),
 *         MISTAKES_END};
 *     static const struct number kilobytes =
 *         NUMBER("indexed_grid_kilobytes", 592908.0 / 1024, TWO_DECIMALS, kilobyte_mistakes,
 *                "It is not the size.", "No es el tamaño."); */
#ifndef GRADERS_LIBRARY_MISTAKES_H
#define GRADERS_LIBRARY_MISTAKES_H

#include "graders/library/built.h"

/* clang-format off */

/* cause: CAUSE("slug", "name", "nombre") or one of those below; value: what the mistake leads to, a
 * function or a number; then the hint or rule in both languages */
#define MISTAKE(cause, value, ...) {cause, (value), {__VA_ARGS__}}
#define MISTAKES_END {.cause = {.slug = NULL}}
#define NUMBER(function, value, tolerance, mistakes, ...) \
    {(function), (value), (tolerance), {__VA_ARGS__}, (mistakes)}
#define COUNT(field, cause, right, mistakes, ...) {(field), cause, (right), {__VA_ARGS__}, (mistakes)}

#define CAUSE(slug, en, es) {slug, {en, es}}
#define CAUSE_BYTE_A_CELL CAUSE("byte-a-cell", "a byte for each cell", "un byte por celda")
#define CAUSE_EACH_CORNER CAUSE("each-corner", "each corner counted", "cada esquina contada")
#define CAUSE_FENCE_POST CAUSE("fence-post", "fence-post error", "error por uno en los extremos")
#define CAUSE_HALF_THE_TRIANGLES \
    CAUSE("half-the-triangles", "half the triangles", "la mitad de los triángulos")
#define CAUSE_SHORT_POINTERS CAUSE("short-pointers", "pointers of 4 bytes", "punteros de 4 bytes")
#define CAUSE_TABLE_FORGOTTEN \
    CAUSE("table-forgotten", "table of strips forgotten", "tabla de tiras olvidada")
#define CAUSE_TRIANGLE_COUNT \
    CAUSE("triangle-count", "number of triangles", "número de triángulos")
#define CAUSE_UPSIDE_DOWN CAUSE("upside-down", "upside down", "cociente invertido")
#define CAUSE_VERTEX_COUNT CAUSE("vertex-count", "number of vertices", "número de vértices")

/* Numbers in another unit. */
#define MISTAKE_KILOBYTE(value) \
    MISTAKE(CAUSE("kilobyte-of-1000", "KB of 1000 bytes", "KB de 1000 bytes"), value, \
            "1 KB is 1024 bytes.", "1 KB son 1024 bytes.")
#define MISTAKE_MEGABYTE(value) \
    MISTAKE(CAUSE("megabyte-of-1000000", "MB of 1000000 bytes", "MB de 1000000 bytes"), value, \
            "1 MB is 1024 KB.", "1 MB son 1024 KB.")
#define MISTAKE_IN_BYTES(value) \
    MISTAKE(CAUSE("bytes", "bytes, not KB", "bytes, no KB"), value, \
            "That is in bytes, not in KB.", "Eso está en bytes, no en KB.")

/* clang-format on */

#endif
