/* Reading the data of a PLY file; see ply.h. */
#include "reference/formats/ply.h"

#include "reference/formats/growing_mesh.h"
#include "reference/formats/lost_vertices.h"
#include "reference/formats/ply_header.h"
#include "reference/formats/ply_plain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct reader {
    struct scan scan;
    struct ply_header header;
    struct growing_mesh mesh;
    struct lost_vertices lost;
    const char *element_name; /* of the row being read, for errors */
    int64_t row, row_count;
};

static int row_error_at_end(const struct reader *r)
{
    return scan_error(&r->scan, "the file ends in %s %lld of %lld: it is cut, or the header lies",
                      r->element_name, (long long)r->row, (long long)r->row_count);
}

/* -- one value -------------------------------------------------------------------------------- */

/* The next `count` bytes of binary data, NULL (and an error) when there are fewer. */
static const unsigned char *take_bytes(struct reader *r, uint64_t count)
{
    r->scan.item = r->scan.at;
    if (count > scan_left(&r->scan)) {
        row_error_at_end(r);
        return NULL;
    }
    const char *bytes = r->scan.bytes + r->scan.at;
    r->scan.at += (size_t)count;
    return (const unsigned char *)bytes;
}

/* The 1, 2, 4 or 8 bytes of a scalar as an unsigned number. */
static uint64_t assemble(const unsigned char *bytes, size_t count, bool is_big_endian)
{
    uint64_t value = 0;
    for (size_t i = 0; i < count; i++)
        value = value << 8 | bytes[is_big_endian ? i : count - 1 - i];
    return value;
}

/* The scalar that these bits are; each type fits a double exactly. */
static double interpret(uint64_t bits, enum ply_type type)
{
    uint32_t low = (uint32_t)bits;
    float f;
    double d;
    switch (type) {
    case PLY_INT8:
        return (int8_t)bits;
    case PLY_INT16:
        return (int16_t)bits;
    case PLY_INT32:
        return (int32_t)bits;
    case PLY_FLOAT32:
        memcpy(&f, &low, sizeof f);
        return (double)f;
    case PLY_FLOAT64:
        memcpy(&d, &bits, sizeof d);
        return d;
    default:
        return (double)bits;
    }
}

static int read_binary(struct reader *r, enum ply_type type, double *value)
{
    size_t count = ply_type_bytes(type);
    const unsigned char *bytes = take_bytes(r, count);
    if (!bytes)
        return -1;
    *value = interpret(assemble(bytes, count, r->header.encoding == PLY_BIG_ENDIAN), type);
    return 0;
}

static int read_text(struct reader *r, enum ply_type type, const char *what, double *value)
{
    struct token token;
    if (!scan_token(&r->scan, &token) &&
        scan_row_goes_on(&r->scan, &token, "%s is missing: %s %lld ends before it", what,
                         r->element_name, (long long)r->row))
        return -1;
    if (type == PLY_FLOAT64)
        return scan_double(&r->scan, &token, what, value);
    if (type == PLY_FLOAT32) {
        float f;
        int result = scan_float(&r->scan, &token, what, &f);
        if (result == 0)
            *value = (double)f;
        return result;
    }
    int64_t integer;
    if (scan_integer(&r->scan, &token, what, &integer))
        return -1;
    if (integer < ply_type_least(type) || integer > ply_type_most(type))
        return scan_error(&r->scan, "%s is %lld, its type reaches from %lld to %lld", what,
                          (long long)integer, (long long)ply_type_least(type),
                          (long long)ply_type_most(type));
    *value = (double)integer;
    return 0;
}

static int read_value(struct reader *r, enum ply_type type, const char *what, double *value)
{
    if (r->header.encoding == PLY_ASCII)
        return read_text(r, type, what, value);
    return read_binary(r, type, value);
}

static int read_list_length(struct reader *r, enum ply_type type, int64_t *length)
{
    double value = 0.0;
    if (read_value(r, type, "the length of the list", &value))
        return -1;
    if (value < 0)
        return scan_error(&r->scan, "%s %lld: a list of length %lld", r->element_name,
                          (long long)r->row, (long long)value);
    *length = (int64_t)value;
    return 0;
}

/* -- one row ---------------------------------------------------------------------------------- */

static int skip_property(struct reader *r, const struct ply_property *property)
{
    int64_t count = 1;
    if (property->count_type != PLY_NO_TYPE && read_list_length(r, property->count_type, &count))
        return -1;
    if (r->header.encoding != PLY_ASCII)
        return take_bytes(r, (uint64_t)count * ply_type_bytes(property->type)) ? 0 : -1;
    struct token token;
    for (int64_t i = 0; i < count; i++)
        if (!scan_token(&r->scan, &token) &&
            scan_row_goes_on(&r->scan, &token, "%s %lld ends before all of its values",
                             r->element_name, (long long)r->row))
            return -1;
    return 0;
}

static int read_coordinate(struct reader *r, const struct ply_property *property, float *to)
{
    static const char *const what[] = {"x", "y", "z"};
    double value = 0.0;
    if (read_value(r, property->type, what[property->role - PLY_X], &value))
        return -1;
    *to = (float)value;
    if (!isfinite(*to) && !r->scan.reading)
        return scan_error(&r->scan, "%s of vertex %lld is %s: a finite number expected",
                          what[property->role - PLY_X], (long long)r->row,
                          isnan(value)      ? "NaN"
                          : isfinite(value) ? "too large for a float"
                                            : "infinite");
    return 0;
}

static int read_vertex(struct reader *r, const struct ply_element *element)
{
    float position[3];
    for (int p = 0; p < element->property_count; p++) {
        const struct ply_property *property = &element->properties[p];
        int result = property->role == PLY_SKIPPED
                         ? skip_property(r, property)
                         : read_coordinate(r, property, &position[property->role - PLY_X]);
        if (result)
            return -1;
    }
    return lost_vertices_add(&r->lost, &r->mesh, position, &r->scan);
}

static int read_polygon(struct reader *r, const struct ply_property *property)
{
    int64_t length;
    if (read_list_length(r, property->count_type, &length))
        return -1;
    if (length < 3 && r->scan.reading)
        scan_note(&r->scan, READING_SHORT_FACE, 1);
    else if (length < 3)
        return scan_error(&r->scan, "face %lld has %lld corners: at least 3 expected",
                          (long long)r->row, (long long)length);
    struct polygon polygon = {0};
    for (int64_t corner = 0; corner < length; corner++) {
        double value = 0.0;
        if (read_value(r, property->type, "the index of a vertex", &value))
            return -1;
        /* Written so that NaN fails too. */
        if (!(value >= 0 && value < (double)r->header.vertex_count && value == floor(value)))
            return scan_error(&r->scan,
                              "face %lld: corner %lld names vertex %.17g, the file has %lld, "
                              "counted from 0",
                              (long long)r->row, (long long)corner, value,
                              (long long)r->header.vertex_count);
        if (polygon_add_corner(&polygon, &r->mesh, (int32_t)value, r->scan.err))
            return -1;
    }
    return 0;
}

static int read_face(struct reader *r, const struct ply_element *element)
{
    for (int p = 0; p < element->property_count; p++) {
        const struct ply_property *property = &element->properties[p];
        if (property->role == PLY_INDICES ? read_polygon(r, property) : skip_property(r, property))
            return -1;
    }
    return 0;
}

static int skip_row(struct reader *r, const struct ply_element *element)
{
    for (int p = 0; p < element->property_count; p++)
        if (skip_property(r, &element->properties[p]))
            return -1;
    return 0;
}

/* -- the whole -------------------------------------------------------------------------------- */

static int read_row(struct reader *r, const struct ply_element *element)
{
    bool is_text = r->header.encoding == PLY_ASCII;
    if (is_text && !scan_find_token(&r->scan))
        return row_error_at_end(r);
    int result;
    scan_begin_row(&r->scan);
    if (element->kind == PLY_VERTEX)
        result = read_vertex(r, element);
    else if (element->kind == PLY_FACE)
        result = read_face(r, element);
    else
        result = skip_row(r, element);
    struct token extra;
    if (result == 0 && is_text && scan_token(&r->scan, &extra))
        result = scan_row_error(&r->scan, "\"%s\" behind the last value of %s %lld",
                                scan_quote(&extra).text, r->element_name, (long long)r->row);
    return result;
}

static int read_elements(struct reader *r)
{
    static const char *const names[] = {"row", "vertex", "face"};
    for (int e = 0; e < r->header.element_count; e++) {
        const struct ply_element *element = &r->header.elements[e];
        /* The header's check has found the counts to fit the file. */
        if (growing_mesh_reserve(&r->mesh, element->kind == PLY_VERTEX ? element->count : 0,
                                 element->kind == PLY_FACE ? element->count : 0, r->scan.err))
            return -1;
        r->element_name = names[element->kind];
        r->row_count = element->count;
        for (r->row = 0;; r->row++) {
            if (ply_read_plain_rows(&r->scan, &r->header, element, &r->row, &r->mesh))
                return -1;
            if (r->row == element->count)
                break;
            if (read_row(r, element))
                return -1;
            if (r->header.encoding == PLY_ASCII)
                scan_end_line(&r->scan);
        }
    }
    return 0;
}

/* Looks at what stands behind the last element, and takes out what no face uses. */
static int end_reading(struct reader *r)
{
    if (scan_find_token(&r->scan)) {
        r->scan.item = r->scan.at;
        if (!r->scan.reading)
            return scan_error(&r->scan,
                              "the file goes on behind its last element: the header lies");
        scan_note(&r->scan, READING_REST, (int64_t)scan_left(&r->scan));
    }
    return lost_vertices_take_out(&r->lost, &r->mesh, &r->scan);
}

int ply_read(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
             struct reading *reading, struct error *err)
{
    *mesh = (struct mesh){0};
    struct reader *r = calloc(1, sizeof *r);
    if (!r)
        return error_set(err, "%s: out of memory", name);
    int result = scan_init(&r->scan, bytes, byte_count, name, err);
    if (result == 0)
        result = ply_header_read(&r->scan, &r->header);
    if (result == 0) {
        r->scan.reading = reading;
        r->scan.is_binary = r->header.encoding != PLY_ASCII;
        result = read_elements(r);
    }
    if (result == 0)
        result = end_reading(r);
    if (result == 0)
        growing_mesh_finish(&r->mesh, mesh);
    growing_mesh_release(&r->mesh);
    lost_vertices_release(&r->lost);
    scan_release(&r->scan);
    free(r);
    return result;
}
