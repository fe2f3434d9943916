/* Reading the header of a PLY file; see ply_header.h. */
#include "reference/formats/ply_header.h"

#include <string.h>

struct type_facts {
    const char *name, *sized_name; /* "uchar", "uint8" */
    size_t bytes;
    bool is_integer;
    int64_t least, most;
};

static const struct type_facts types[] = {
    [PLY_NO_TYPE] = {"", "", 0, false, 0, 0},
    [PLY_INT8] = {"char", "int8", 1, true, INT8_MIN, INT8_MAX},
    [PLY_UINT8] = {"uchar", "uint8", 1, true, 0, UINT8_MAX},
    [PLY_INT16] = {"short", "int16", 2, true, INT16_MIN, INT16_MAX},
    [PLY_UINT16] = {"ushort", "uint16", 2, true, 0, UINT16_MAX},
    [PLY_INT32] = {"int", "int32", 4, true, INT32_MIN, INT32_MAX},
    [PLY_UINT32] = {"uint", "uint32", 4, true, 0, UINT32_MAX},
    [PLY_FLOAT32] = {"float", "float32", 4, false, 0, 0},
    [PLY_FLOAT64] = {"double", "float64", 8, false, 0, 0},
};

size_t ply_type_bytes(enum ply_type type)
{
    return types[type].bytes;
}

bool ply_type_is_integer(enum ply_type type)
{
    return types[type].is_integer;
}

int64_t ply_type_least(enum ply_type type)
{
    return types[type].least;
}

int64_t ply_type_most(enum ply_type type)
{
    return types[type].most;
}

static int next_word(struct scan *scan, const char *what, struct token *token)
{
    if (scan_token(scan, token))
        return 0;
    return scan_error(scan, "%s is missing: the line ends before it", what);
}

static int read_type(struct scan *scan, enum ply_type *type)
{
    struct token token;
    if (next_word(scan, "the type of the property", &token))
        return -1;
    for (enum ply_type t = PLY_INT8; t <= PLY_FLOAT64; t++)
        if (scan_token_is(&token, types[t].name) || scan_token_is(&token, types[t].sized_name)) {
            *type = t;
            return 0;
        }
    return scan_error(scan,
                      "\"%s\" is no type: char, uchar, short, ushort, int, uint, float or "
                      "double expected",
                      scan_quote(&token).text);
}

static int read_format(struct scan *scan, struct ply_header *header, bool *has_format)
{
    struct token token;
    if (next_word(scan, "the format", &token))
        return -1;
    if (scan_token_is(&token, "ascii"))
        header->encoding = PLY_ASCII;
    else if (scan_token_is(&token, "binary_little_endian"))
        header->encoding = PLY_LITTLE_ENDIAN;
    else if (scan_token_is(&token, "binary_big_endian"))
        header->encoding = PLY_BIG_ENDIAN;
    else
        return scan_error(scan,
                          "format \"%s\": ascii, binary_little_endian or binary_big_endian "
                          "expected",
                          scan_quote(&token).text);
    if (next_word(scan, "the version of the format", &token))
        return -1;
    if (!scan_token_is(&token, "1.0"))
        return scan_error(scan, "format version \"%s\": only 1.0 exists", scan_quote(&token).text);
    *has_format = true;
    return 0;
}

static bool has_kind(const struct ply_header *header, enum ply_kind kind)
{
    for (int e = 0; e < header->element_count; e++)
        if (header->elements[e].kind == kind)
            return true;
    return false;
}

static int read_element(struct scan *scan, struct ply_header *header)
{
    struct token name;
    if (next_word(scan, "the name of the element", &name))
        return -1;
    if (header->element_count == PLY_ELEMENT_LIMIT)
        return scan_error(scan, "more than %d elements", PLY_ELEMENT_LIMIT);
    struct ply_element element = {.line = scan->line};
    if (scan_token_is(&name, "vertex"))
        element.kind = PLY_VERTEX;
    else if (scan_token_is(&name, "face"))
        element.kind = PLY_FACE;
    else if (scan_token_is(&name, "tristrips"))
        return scan_error(scan, "the faces are triangle strips (tristrips), which are not read: "
                                "write the file with single faces");
    if (element.kind != PLY_OTHER && has_kind(header, element.kind))
        return scan_error(scan, "element %s is declared twice", scan_quote(&name).text);
    if (scan_next_integer(scan, "the count of the element", &element.count))
        return -1;
    if (element.count < 0)
        return scan_error(scan, "%s count %lld is negative", scan_quote(&name).text,
                          (long long)element.count);
    if (element.kind == PLY_VERTEX)
        header->vertex_count = element.count;
    header->elements[header->element_count++] = element;
    return 0;
}

static bool has_role(const struct ply_element *element, enum ply_role role)
{
    for (int p = 0; p < element->property_count; p++)
        if (element->properties[p].role == role)
            return true;
    return false;
}

/* What a property of this name means in its element. */
static enum ply_role role_of(const struct ply_element *element, const struct token *name)
{
    if (element->kind == PLY_VERTEX && name->length == 1 && name->text[0] >= 'x' &&
        name->text[0] <= 'z')
        return PLY_X + (enum ply_role)(name->text[0] - 'x');
    if (element->kind == PLY_FACE &&
        (scan_token_is(name, "vertex_indices") || scan_token_is(name, "vertex_index")))
        return PLY_INDICES;
    return PLY_SKIPPED;
}

static int read_property(struct scan *scan, struct ply_header *header)
{
    if (header->element_count == 0)
        return scan_error(scan, "a property before any element: \"element vertex COUNT\" expected");
    struct ply_element *element = &header->elements[header->element_count - 1];
    if (element->property_count == PLY_PROPERTY_LIMIT)
        return scan_error(scan, "more than %d properties in one element", PLY_PROPERTY_LIMIT);
    struct ply_property property = {0};
    struct scan before = *scan;
    struct token token;
    if (scan_token(scan, &token) && scan_token_is(&token, "list")) {
        if (read_type(scan, &property.count_type))
            return -1;
        if (!ply_type_is_integer(property.count_type))
            return scan_error(scan, "the length of a list cannot be a %s: an integer type expected",
                              types[property.count_type].name);
    } else {
        *scan = before;
    }
    if (read_type(scan, &property.type) || next_word(scan, "the name of the property", &token))
        return -1;
    property.role = role_of(element, &token);
    bool is_list = property.count_type != PLY_NO_TYPE;
    if (property.role != PLY_SKIPPED && is_list != (property.role == PLY_INDICES))
        return scan_error(scan, "property %s must %s a list", scan_quote(&token).text,
                          is_list ? "not be" : "be");
    if (property.role != PLY_SKIPPED && has_role(element, property.role))
        return scan_error(scan, "property %s is declared twice", scan_quote(&token).text);
    element->properties[element->property_count++] = property;
    return 0;
}

/* One line; *is_end after end_header. */
static int read_header_line(struct scan *scan, struct ply_header *header, bool *has_format,
                            bool *is_end)
{
    struct token keyword, extra;
    if (!scan_token(scan, &keyword) || scan_token_is(&keyword, "comment") ||
        scan_token_is(&keyword, "obj_info"))
        return 0;
    int result;
    if (scan_token_is(&keyword, "format"))
        result = read_format(scan, header, has_format);
    else if (scan_token_is(&keyword, "element"))
        result = read_element(scan, header);
    else if (scan_token_is(&keyword, "property"))
        result = read_property(scan, header);
    else if ((*is_end = scan_token_is(&keyword, "end_header")))
        result = 0;
    else
        result = scan_error(scan,
                            "\"%s\" in a PLY header: format, comment, element, property or "
                            "end_header expected",
                            scan_quote(&keyword).text);
    if (result == 0 && scan_token(scan, &extra))
        result =
            scan_error(scan, "\"%s\" behind the end of the statement", scan_quote(&extra).text);
    return result;
}

/* Least bytes of a row: in text a digit and a separator for each value. */
static size_t least_row_bytes(const struct ply_header *header, const struct ply_element *element)
{
    size_t sum = 0;
    for (int p = 0; p < element->property_count; p++) {
        const struct ply_property *property = &element->properties[p];
        bool is_list = property->count_type != PLY_NO_TYPE;
        sum += header->encoding == PLY_ASCII
                   ? 2
                   : ply_type_bytes(is_list ? property->count_type : property->type);
    }
    return sum;
}

static int check_element(const struct scan *scan, const struct ply_header *header,
                         const struct ply_element *element)
{
    static const char *const names[] = {"row", "vertex", "face"};
    if (element->property_count == 0 && element->count > 0)
        return scan_error_at(scan, element->line, "the element has no property");
    if (element->kind == PLY_VERTEX && element->count > 0)
        for (enum ply_role role = PLY_X; role <= PLY_Z; role++)
            if (!has_role(element, role))
                return scan_error_at(scan, element->line, "the vertices have no property %c",
                                     (char)('x' + role - PLY_X));
    if (element->kind == PLY_FACE && element->count > 0 && !has_role(element, PLY_INDICES))
        return scan_error_at(scan, element->line,
                             "the faces have no list vertex_indices or vertex_index");
    /* The last line of a text may lack its end. */
    size_t room = scan_left(scan) + (header->encoding == PLY_ASCII);
    size_t least = least_row_bytes(header, element);
    uint64_t rows = (uint64_t)element->count;
    if (rows > room || rows * least > room)
        return scan_error_at(scan, element->line,
                             "%s count %lld is more than the file can hold (it has %zu bytes): "
                             "the header lies or the file is cut",
                             names[element->kind], (long long)element->count, scan->byte_count);
    if (element->count > INT32_MAX / 3)
        return scan_error_at(scan, element->line, "%s count %lld is more than the possible %d",
                             names[element->kind], (long long)element->count, INT32_MAX / 3);
    return 0;
}

int ply_header_read(struct scan *scan, struct ply_header *header)
{
    memset(header, 0, sizeof *header);
    struct token magic = {0};
    if (!scan_token(scan, &magic) || !scan_token_is(&magic, "ply"))
        return scan_error(scan, "a PLY file starts with the line \"ply\", this one with \"%s\"",
                          scan_quote(&magic).text);
    bool has_format = false, is_end = false;
    while (!is_end) {
        scan_end_line(scan);
        if (scan_left(scan) == 0)
            return scan_error(scan, "the file ends within the header: it is cut, or end_header is "
                                    "missing");
        if (read_header_line(scan, header, &has_format, &is_end))
            return -1;
    }
    if (!has_format)
        return scan_error(scan, "the header has no format line: \"format ascii 1.0\" expected");
    if (!has_kind(header, PLY_VERTEX))
        return scan_error(scan, "the header has no element vertex");
    int64_t line = scan->line;
    scan_end_line(scan);
    if (scan->line == line && scan_left(scan) > 0)
        return scan_error(scan, "end_header must end its line");
    for (int e = 0; e < header->element_count; e++)
        if (check_element(scan, header, &header->elements[e]))
            return -1;
    return 0;
}
