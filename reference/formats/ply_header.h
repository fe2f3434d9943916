/* The header of a PLY file: which elements follow, and what each row of them holds. */
#ifndef REFERENCE_FORMATS_PLY_HEADER_H
#define REFERENCE_FORMATS_PLY_HEADER_H

#include "reference/formats/ply.h"
#include "reference/formats/scan.h"

enum ply_type {
    PLY_NO_TYPE,
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT32,
    PLY_FLOAT64
};

enum ply_role { PLY_SKIPPED, PLY_X, PLY_Y, PLY_Z, PLY_INDICES };

enum ply_kind { PLY_OTHER, PLY_VERTEX, PLY_FACE };

enum { PLY_ELEMENT_LIMIT = 32, PLY_PROPERTY_LIMIT = 128 };

struct ply_property {
    enum ply_type type;       /* of the value, or of each entry of a list */
    enum ply_type count_type; /* of the length of a list; PLY_NO_TYPE: no list */
    enum ply_role role;
};

struct ply_element {
    enum ply_kind kind;
    int64_t count; /* rows */
    int64_t line;  /* of the header that declares it */
    int property_count;
    struct ply_property properties[PLY_PROPERTY_LIMIT];
};

struct ply_header {
    enum ply_encoding encoding;
    int64_t vertex_count;
    int element_count;
    struct ply_element elements[PLY_ELEMENT_LIMIT];
};

/* Bytes of a scalar in binary files. */
size_t ply_type_bytes(enum ply_type type);

/* Whether the type is one of whole numbers, and its least and greatest value. */
bool ply_type_is_integer(enum ply_type type);
int64_t ply_type_least(enum ply_type type);
int64_t ply_type_most(enum ply_type type);

/* Reads the header and leaves the scan at the first byte of data. Checks that the data that the
 * header promises can lie in the rest of the file. Returns 0, or -1 and the scan's error. */
int ply_header_read(struct scan *scan, struct ply_header *header) MUST_CHECK;

#endif
