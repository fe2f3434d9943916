/* OBJ files; see obj.h. */
#include "reference/formats/obj.h"

#include "reference/formats/growing_mesh.h"
#include "reference/formats/lost_vertices.h"
#include "reference/formats/scan.h"
#include "reference/formats/scan_plain.h"
#include "reference/formats/text_out.h"

#include <string.h>

struct reader {
    struct scan scan;
    struct growing_mesh mesh;
    struct lost_vertices lost;
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
    return lost_vertices_add(&r->lost, &r->mesh, position, &r->scan);
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
    if (polygon.corner_count < 3 && r->scan.reading)
        scan_note(&r->scan, READING_SHORT_FACE, 1);
    else if (polygon.corner_count < 3)
        return scan_error(&r->scan, "a face of %lld corners: at least 3 expected",
                          (long long)polygon.corner_count);
    return 0;
}

static bool is_one_of(const struct token *keyword, const char *const words[])
{
    for (size_t i = 0; words[i]; i++)
        if (scan_token_is(keyword, words[i]))
            return true;
    return false;
}

/* The format's statements that say nothing about vertices and faces: of names, and of numbers. */
static bool is_of_names(const struct token *keyword)
{
    static const char *const words[] = {"g",        "s",          "o",         "mg",    "usemtl",
                                        "mtllib",   "usemap",     "maplib",    "bevel", "c_interp",
                                        "d_interp", "lod",        "call",      "csh",   "ctech",
                                        "stech",    "shadow_obj", "trace_obj", NULL};
    return is_one_of(keyword, words);
}

static bool is_of_numbers(const struct token *keyword)
{
    static const char *const words[] = {"vt",   "vn",   "vp",   "l",     "p",    "cstype", "deg",
                                        "bmat", "step", "curv", "curv2", "surf", "parm",   "trim",
                                        "hole", "scrv", "sp",   "end",   "con",  NULL};
    return is_one_of(keyword, words);
}

/* Whether what stands in the place of a statement may be one: a word. */
static bool is_word(const struct token *keyword)
{
    bool ok = keyword->length > 0 && keyword->length <= 40;
    for (size_t i = 0; ok && i < keyword->length; i++) {
        char c = keyword->text[i];
        bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        ok = is_letter || (i > 0 && ((c >= '0' && c <= '9') || c == '-' || c == '.' || c == ':'));
    }
    return ok;
}

/* A statement that the format does not know: skipped, where there is a reading to tell it. */
static int skip_unknown(struct reader *r, const struct token *keyword)
{
    if (scan_token_is_marked(keyword))
        return scan_error(&r->scan,
                          "a byte order mark (BOM) stands before the statement \"%s\": take "
                          "it out (bytes EF BB BF)",
                          scan_quote(&(struct token){keyword->text + 3, keyword->length - 3}).text);
    if (!r->scan.reading || !is_word(keyword))
        return scan_error(&r->scan, "\"%s\" is no statement of an OBJ file (v, f, vt, ...)",
                          scan_quote(keyword).text);
    struct reading_note *note = &r->scan.reading->notes[READING_STATEMENT];
    scan_note(&r->scan, READING_STATEMENT, 1);
    if (note->count == 1)
        snprintf(note->text, sizeof note->text, "%s", scan_quote(keyword).text);
    return 0;
}

/* Whether only ends of files of long ago (control Z) and zero bytes stand behind `at`. */
static bool is_rest(const struct scan *scan, size_t at)
{
    while (at < scan->byte_count && (scan->bytes[at] == '\x1a' || scan->bytes[at] == '\0' ||
                                     scan->bytes[at] == '\n' || scan->bytes[at] == '\r'))
        at++;
    return at == scan->byte_count;
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

/* Goes behind the line; unknown statements may hold names, too. */
static void end_statement(struct reader *r, const struct token *keyword)
{
    bool is_ours =
        scan_token_is(keyword, "v") || scan_token_is(keyword, "f") || scan_token_is(keyword, "fo");
    r->scan.holds_a_name = !is_ours && !is_of_numbers(keyword);
    scan_end_line(&r->scan);
    r->scan.holds_a_name = false;
}

static int read_statements(struct reader *r)
{
    for (;;) {
        struct token keyword;
        int result = 0;
        if (read_plain_lines(r))
            return -1;
        if (!scan_find_token(&r->scan))
            break;
        if (r->scan.reading && is_rest(&r->scan, r->scan.at)) {
            scan_note(&r->scan, READING_REST, (int64_t)scan_left(&r->scan));
            break;
        }
        scan_token(&r->scan, &keyword);
        if (scan_token_is(&keyword, "v"))
            result = read_vertex(r);
        else if (scan_token_is(&keyword, "f") || scan_token_is(&keyword, "fo"))
            result = read_face(r);
        else if (!is_of_numbers(&keyword) && !is_of_names(&keyword))
            result = skip_unknown(r, &keyword);
        if (result)
            return -1;
        end_statement(r, &keyword);
    }
    return 0;
}

/* What can be told at the end of the file only. */
static int end_reading(struct reader *r)
{
    if (r->highest_index >= r->mesh.vertex_count)
        return scan_error_at(&r->scan, r->highest_line,
                             "a face names vertex %lld, the file has %lld",
                             (long long)r->highest_index + 1, (long long)r->mesh.vertex_count);
    const struct reading *reading = r->scan.reading;
    if (reading && reading->notes[READING_STATEMENT].count > 0 && r->mesh.vertex_count == 0)
        return scan_error_at(&r->scan, reading->notes[READING_STATEMENT].place,
                             "\"%s\" is no statement of an OBJ file (v, f, vt, ...)",
                             reading->notes[READING_STATEMENT].text);
    return lost_vertices_take_out(&r->lost, &r->mesh, &r->scan);
}

int obj_read(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
             struct reading *reading, struct error *err)
{
    *mesh = (struct mesh){0};
    struct reader r = {.highest_index = -1};
    if (scan_init(&r.scan, bytes, byte_count, name, err))
        return -1;
    r.scan.comment = '#';
    r.scan.is_continued = true;
    r.scan.reading = reading;
    int result = read_statements(&r);
    if (result == 0)
        result = end_reading(&r);
    if (result == 0)
        growing_mesh_finish(&r.mesh, mesh);
    growing_mesh_release(&r.mesh);
    lost_vertices_release(&r.lost);
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
