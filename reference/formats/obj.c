/* OBJ files; see obj.h. */
#include "reference/formats/obj.h"

#include "reference/formats/growing_mesh.h"
#include "reference/formats/scan.h"
#include "reference/formats/scan_plain.h"
#include "reference/formats/text_out.h"

#include <string.h>

struct reader {
    struct scan scan;
    struct growing_mesh mesh;
    int64_t highest_index; /* that a face names, from 0; -1: none. It may come before its vertex */
    int64_t highest_line;  /* where */
};

static int read_vertex(struct reader *r)
{
    float position[3], ignored;
    if (scan_next_float(&r->scan, "x", &position[0]) ||
        scan_next_float(&r->scan, "y", &position[1]) ||
        scan_next_float(&r->scan, "z", &position[2]))
        return -1;
    struct token token;
    while (scan_token(&r->scan, &token))
        if (scan_float(&r->scan, &token, "a weight or colour", &ignored))
            return -1;
    return growing_mesh_add_vertex(&r->mesh, position, r->scan.err);
}

/* The numbers between the slashes of a corner; only the first has to be there. */
static int read_corner(struct reader *r, const struct token *corner, int64_t *vertex)
{
    static const char *const what[] = {"the number of a vertex", "the number of a texture vertex",
                                       "the number of a normal"};
    struct token rest = *corner;
    for (int part = 0;; part++) {
        const char *slash = memchr(rest.text, '/', rest.length);
        struct token number = {rest.text, slash ? (size_t)(slash - rest.text) : rest.length};
        int64_t value;
        if (part == 3)
            return scan_error(&r->scan, "corner \"%s\": at most two slashes expected",
                              scan_quote(corner).text);
        if ((part == 0 || number.length > 0) && scan_integer(&r->scan, &number, what[part], &value))
            return -1;
        if (part == 0)
            *vertex = value;
        if (!slash)
            return 0;
        rest = (struct token){slash + 1, rest.length - number.length - 1};
    }
}

/* From the file's way of counting to an index from 0: of a number that is not plainly one of those
 * named before. */
static int resolve_new(struct reader *r, int64_t number, int64_t *index)
{
    if (number == 0)
        return scan_error(&r->scan, "vertex 0: OBJ files count from 1 (or back from -1)");
    if (number < 0 && -number > r->mesh.vertex_count)
        return scan_error(&r->scan, "vertex %lld counts back behind the first of %lld vertices",
                          (long long)number, (long long)r->mesh.vertex_count);
    *index = number < 0 ? r->mesh.vertex_count + number : number - 1;
    if (*index >= INT32_MAX / 3)
        return scan_error(&r->scan, "vertex %lld is more than the possible %d", (long long)number,
                          INT32_MAX / 3);
    if (*index > r->highest_index) {
        r->highest_index = *index;
        r->highest_line = r->scan.line;
    }
    return 0;
}

static inline int resolve(struct reader *r, int64_t number, int64_t *index)
{
    *index = number - 1;
    return number > 0 && number - 1 <= r->highest_index ? 0 : resolve_new(r, number, index);
}

static int add_corner(struct reader *r, struct polygon *polygon, int64_t number)
{
    int64_t index = 0;
    if (resolve(r, number, &index))
        return -1;
    return polygon_add_corner(polygon, &r->mesh, (int32_t)index, r->scan.err);
}

static int read_face(struct reader *r)
{
    struct polygon polygon = {0};
    struct token corner;
    while (scan_token(&r->scan, &corner)) {
        int64_t number = 0;
        if (read_corner(r, &corner, &number) || add_corner(r, &polygon, number))
            return -1;
    }
    if (polygon.corner_count < 3)
        return scan_error(&r->scan, "a face of %lld corners: at least 3 expected",
                          (long long)polygon.corner_count);
    return 0;
}

/* The format's statements that say nothing about vertices and faces. */
static bool is_known(const struct token *keyword)
{
    static const char *const known[] = {
        "vt",   "vn",     "vp",     "l",          "p",        "g",        "s",    "o",
        "mg",   "usemtl", "mtllib", "usemap",     "maplib",   "cstype",   "deg",  "bmat",
        "step", "curv",   "curv2",  "surf",       "parm",     "trim",     "hole", "scrv",
        "sp",   "end",    "con",    "bevel",      "c_interp", "d_interp", "lod",  "call",
        "csh",  "ctech",  "stech",  "shadow_obj", "trace_obj"};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (scan_token_is(keyword, known[i]))
            return true;
    return false;
}

/* -- plain lines ------------------------------------------------------------------------------ */

static int add_plain_face(struct reader *r, const struct scan_plain_integers *row)
{
    int64_t first, last, next;
    if (resolve(r, row->values[0], &first) || resolve(r, row->values[1], &last))
        return -1;
    for (int i = 2; i < row->count; i++) {
        if (resolve(r, row->values[i], &next) ||
            growing_mesh_add_triangle(&r->mesh, (int32_t)first, (int32_t)last, (int32_t)next,
                                      r->scan.err))
            return -1;
        last = next;
    }
    return 0;
}

/* Reads "v" and "f" lines as long as they are plain. */
static int read_plain_lines(struct reader *r)
{
    while (may_be_plain(&r->scan, 2)) {
        const char *line = r->scan.bytes + r->scan.at, *behind = NULL;
        struct scan_plain_floats floats;
        struct scan_plain_integers corners;
        int result = 0;
        if (line[0] == 'v' && line[1] == ' ') {
            behind = scan_plain_floats(&r->scan, 2, &floats);
            if (!behind || floats.count < 3)
                return 0;
            result = growing_mesh_add_vertex(&r->mesh, floats.values, r->scan.err);
        } else if (line[0] == 'f' && line[1] == ' ') {
            behind = scan_plain_corners(&r->scan, 2, &corners);
            if (!behind || corners.count < 3)
                return 0;
            result = add_plain_face(r, &corners);
        }
        if (!behind || result)
            return result;
        scan_pass_row(&r->scan, behind);
    }
    return 0;
}

/* -- the whole -------------------------------------------------------------------------------- */

static int read_statements(struct reader *r)
{
    for (;;) {
        struct token keyword;
        int result = 0;
        if (read_plain_lines(r))
            return -1;
        if (!scan_find_token(&r->scan))
            break;
        scan_token(&r->scan, &keyword);
        if (scan_token_is(&keyword, "v"))
            result = read_vertex(r);
        else if (scan_token_is(&keyword, "f") || scan_token_is(&keyword, "fo"))
            result = read_face(r);
        else if (!is_known(&keyword))
            result = scan_error(&r->scan, "\"%s\" is no statement of an OBJ file (v, f, vt, ...)",
                                scan_quote(&keyword).text);
        if (result)
            return -1;
        scan_end_line(&r->scan);
    }
    if (r->highest_index >= r->mesh.vertex_count)
        return scan_error_at(&r->scan, r->highest_line,
                             "a face names vertex %lld, the file has %lld",
                             (long long)r->highest_index + 1, (long long)r->mesh.vertex_count);
    return 0;
}

int obj_read(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
             struct error *err)
{
    *mesh = (struct mesh){0};
    struct reader r = {.highest_index = -1};
    if (scan_init(&r.scan, bytes, byte_count, name, err))
        return -1;
    r.scan.comment = '#';
    r.scan.is_continued = true;
    int result = read_statements(&r);
    if (result == 0)
        growing_mesh_finish(&r.mesh, mesh);
    growing_mesh_release(&r.mesh);
    scan_release(&r.scan);
    return result;
}

int obj_write(FILE *out, const struct mesh *mesh, struct error *err)
{
    struct text_out text;
    if (text_out_begin(&text, out, err))
        return -1;
    fprintf(out, "# written by meshgrade\n");
    text_out_positions(out, "v ", mesh);
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        fprintf(out, "f %d %d %d\n", mesh->triangles[3 * t] + 1, mesh->triangles[3 * t + 1] + 1,
                mesh->triangles[3 * t + 2] + 1);
    return text_out_end(&text, err);
}
