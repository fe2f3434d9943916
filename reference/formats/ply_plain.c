/* Plain rows of PLY files; see ply_plain.h. */
#include "reference/formats/ply_plain.h"

#include "reference/formats/scan_plain.h"

#include <endian.h>
#include <math.h>
#include <string.h>

/* Where x, y and z stand in the row of a vertex. */
struct vertex_layout {
    size_t row_bytes;            /* in binary */
    size_t offset[3];            /* in binary: from the start of the row */
    int column[3], column_count; /* in text */
    bool is_double[3];
};

/* False when the vertices have no plain layout. */
static bool find_layout(const struct ply_element *element, struct vertex_layout *layout)
{
    *layout = (struct vertex_layout){.column_count = element->property_count};
    for (int p = 0; p < element->property_count; p++) {
        const struct ply_property *property = &element->properties[p];
        if (property->count_type != PLY_NO_TYPE)
            return false;
        if (property->role != PLY_SKIPPED) {
            int axis = (int)(property->role - PLY_X);
            layout->offset[axis] = layout->row_bytes;
            layout->column[axis] = p;
            layout->is_double[axis] = property->type == PLY_FLOAT64;
            if (ply_type_is_integer(property->type))
                return false;
        }
        layout->row_bytes += ply_type_bytes(property->type);
    }
    return true;
}

/* -- text ------------------------------------------------------------------------------------- */

static int read_text_vertices(struct scan *scan, const struct ply_element *element, int64_t *row,
                              struct growing_mesh *mesh)
{
    struct vertex_layout layout;
    if (!find_layout(element, &layout))
        return 0;
    for (; *row < element->count; ++*row) {
        struct scan_plain_floats values;
        const char *behind = scan_plain_floats(scan, 0, &values);
        if (!behind || values.count != layout.column_count)
            return 0;
        float position[3];
        for (int axis = 0; axis < 3; axis++)
            position[axis] = values.values[layout.column[axis]];
        if (growing_mesh_add_vertex(mesh, position, scan->err))
            return -1;
        scan_pass_row(scan, behind);
    }
    return 0;
}

/* Whether the row is a length and so many indices, each of [0, index_count). */
static bool is_polygon(const struct scan_plain_integers *row, int64_t index_count)
{
    bool ok = row->count >= 4 && row->values[0] == row->count - 1;
    for (int i = 1; ok && i < row->count; i++)
        ok = row->values[i] >= 0 && row->values[i] < index_count;
    return ok;
}

static int read_text_faces(struct scan *scan, const struct ply_element *element,
                           int64_t vertex_count, int64_t *row, struct growing_mesh *mesh)
{
    enum ply_type type = element->properties[0].type;
    if (element->property_count != 1 || !ply_type_is_integer(type))
        return 0;
    int64_t index_count = ply_type_most(type) < vertex_count ? ply_type_most(type) : vertex_count;
    for (; *row < element->count; ++*row) {
        struct scan_plain_integers face;
        const char *behind = scan_plain_integers(scan, 0, &face);
        if (!behind || !is_polygon(&face, index_count))
            return 0;
        for (int i = 3; i < face.count; i++)
            if (growing_mesh_add_triangle(mesh, (int32_t)face.values[1],
                                          (int32_t)face.values[i - 1], (int32_t)face.values[i],
                                          scan->err))
                return -1;
        scan_pass_row(scan, behind);
    }
    return 0;
}

/* -- binary ----------------------------------------------------------------------------------- */

static inline uint32_t word_at(const char *bytes, bool is_big_endian)
{
    uint32_t word;
    memcpy(&word, bytes, sizeof word);
    return is_big_endian ? be32toh(word) : le32toh(word);
}

static inline float coordinate_at(const char *bytes, bool is_double, bool is_big_endian)
{
    if (is_double) {
        uint64_t bits;
        double value;
        memcpy(&bits, bytes, sizeof bits);
        bits = is_big_endian ? be64toh(bits) : le64toh(bits);
        memcpy(&value, &bits, sizeof value);
        return (float)value;
    }
    uint32_t bits = word_at(bytes, is_big_endian);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static int read_binary_vertices(struct scan *scan, const struct ply_element *element,
                                bool is_big_endian, int64_t *row, struct growing_mesh *mesh)
{
    struct vertex_layout layout;
    if (!find_layout(element, &layout))
        return 0;
    for (; *row < element->count && scan_left(scan) >= layout.row_bytes; ++*row) {
        const char *bytes = scan->bytes + scan->at;
        float position[3];
        for (int axis = 0; axis < 3; axis++)
            position[axis] =
                coordinate_at(bytes + layout.offset[axis], layout.is_double[axis], is_big_endian);
        if (!isfinite(position[0]) || !isfinite(position[1]) || !isfinite(position[2]))
            return 0;
        if (growing_mesh_add_vertex(mesh, position, scan->err))
            return -1;
        scan->at += layout.row_bytes;
    }
    return 0;
}

/* Whether `count` indices are all below the number of vertices; a negative one is not. */
static bool are_indices(const char *indices, size_t count, uint32_t vertex_count,
                        bool is_big_endian)
{
    bool ok = true;
    for (size_t i = 0; i < count; i++)
        ok &= word_at(indices + 4 * i, is_big_endian) < vertex_count;
    return ok;
}

static int read_binary_faces(struct scan *scan, const struct ply_element *element,
                             uint32_t vertex_count, bool is_big_endian, int64_t *row,
                             struct growing_mesh *mesh)
{
    const struct ply_property *list = &element->properties[0];
    if (element->property_count != 1 || ply_type_bytes(list->count_type) != 1 ||
        !ply_type_is_integer(list->type) || ply_type_bytes(list->type) != 4)
        return 0;
    for (; *row < element->count && scan_left(scan) > 0; ++*row) {
        size_t length = (unsigned char)scan->bytes[scan->at];
        const char *indices = scan->bytes + scan->at + 1;
        if (length < 3 || length > INT8_MAX || scan_left(scan) < 1 + 4 * length ||
            !are_indices(indices, length, vertex_count, is_big_endian))
            return 0;
        int32_t first = (int32_t)word_at(indices, is_big_endian);
        int32_t last = (int32_t)word_at(indices + 4, is_big_endian);
        for (size_t i = 2; i < length; i++) {
            int32_t next = (int32_t)word_at(indices + 4 * i, is_big_endian);
            if (growing_mesh_add_triangle(mesh, first, last, next, scan->err))
                return -1;
            last = next;
        }
        scan->at += 1 + 4 * length;
    }
    return 0;
}

/* -- both ------------------------------------------------------------------------------------- */

int ply_read_plain_rows(struct scan *scan, const struct ply_header *header,
                        const struct ply_element *element, int64_t *row, struct growing_mesh *mesh)
{
    bool is_text = header->encoding == PLY_ASCII;
    bool is_big_endian = header->encoding == PLY_BIG_ENDIAN;
    if (element->kind == PLY_VERTEX && is_text)
        return read_text_vertices(scan, element, row, mesh);
    if (element->kind == PLY_FACE && is_text)
        return read_text_faces(scan, element, header->vertex_count, row, mesh);
    if (element->kind == PLY_VERTEX)
        return read_binary_vertices(scan, element, is_big_endian, row, mesh);
    if (element->kind == PLY_FACE)
        return read_binary_faces(scan, element, (uint32_t)header->vertex_count, is_big_endian, row,
                                 mesh);
    return 0;
}
