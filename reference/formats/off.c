/* OFF files; see off.h. */
#include "reference/formats/off.h"

#include "reference/formats/growing_mesh.h"
#include "reference/formats/lost_vertices.h"
#include "reference/formats/scan.h"
#include "reference/formats/scan_plain.h"
#include "reference/formats/text_out.h"

#include <string.h>
#include <strings.h>

struct reader {
    struct scan scan;
    struct growing_mesh mesh;
    struct lost_vertices lost;
    bool has_attributes; /* more than a position on the line of a vertex */
    int64_t vertex_count, face_count;
};

/* Takes `prefix`, in any case, off the front of the token. */
static bool take_prefix(struct token *token, const char *prefix)
{
    size_t length = strlen(prefix);
    if (token->length < length || strncasecmp(token->text, prefix, length) != 0)
        return false;
    token->text += length;
    token->length -= length;
    return true;
}

static bool is_number(const struct token *token)
{
    for (size_t i = 0; i < token->length; i++)
        if (token->text[i] < '0' || token->text[i] > '9')
            return false;
    return token->length > 0;
}

/* Looks at the first word; what follows it begins at *rest, which may be the first count. */
static int take_keyword(struct reader *r, const struct token *keyword, struct token *rest)
{
    *rest = *keyword;
    bool has_texture = take_prefix(rest, "ST"), has_colour = take_prefix(rest, "C");
    /* "nOFF" is another keyword than NOFF or noff. */
    bool has_normal = !scan_token_is(rest, "nOFF") && take_prefix(rest, "N");
    r->has_attributes = has_texture || has_colour || has_normal;
    if (scan_token_is(rest, "4OFF") || scan_token_is(rest, "nOFF") || scan_token_is(rest, "4nOFF"))
        return scan_error(&r->scan, "%s: only three dimensions are read", scan_quote(keyword).text);
    if (take_prefix(rest, "OFF") && (rest->length == 0 || is_number(rest)))
        return 0;
    *rest = *keyword;
    r->has_attributes = false;
    if (is_number(keyword) && r->scan.reading) {
        scan_note(&r->scan, READING_NO_KEYWORD, 1);
        return 0;
    }
    return scan_error(&r->scan,
                      "an OFF file starts with \"OFF\" (or COFF, NOFF, ...), this one with \"%s\"",
                      scan_quote(keyword).text);
}

static int read_keyword(struct reader *r)
{
    struct token keyword = {"", 0}, rest, following;
    if (scan_find_token(&r->scan))
        scan_token(&r->scan, &keyword);
    if (take_keyword(r, &keyword, &rest))
        return -1;
    r->scan.at -= rest.length; /* of "OFF4" the 4 is a count */
    struct scan before = r->scan;
    if (scan_token(&r->scan, &following) && scan_token_is(&following, "BINARY"))
        return scan_error(&r->scan, "binary OFF files are not read: write it as text");
    r->scan = before;
    return 0;
}

/* A count is only believed when that many rows of at least `row_bytes` can lie in what is left. */
static int check_count(const struct reader *r, const char *what, int64_t count, size_t row_bytes)
{
    if (count < 0)
        return scan_error(&r->scan, "%s count %lld is negative", what, (long long)count);
    if ((uint64_t)count > (scan_left(&r->scan) + 1) / row_bytes)
        return scan_error(&r->scan,
                          "%s count %lld is more than the file can hold (it has %zu bytes): the "
                          "header lies or the file is cut",
                          what, (long long)count, r->scan.byte_count);
    if (count > INT32_MAX / 3)
        return scan_error(&r->scan, "%s count %lld is more than the possible %d", what,
                          (long long)count, INT32_MAX / 3);
    return 0;
}

static int read_counts(struct reader *r)
{
    if (!scan_find_token(&r->scan))
        return scan_error(&r->scan, "the file ends before its counts: \"VERTICES FACES EDGES\" "
                                    "expected");
    struct token token;
    int64_t ignored;
    if (scan_next_integer(&r->scan, "the number of vertices", &r->vertex_count) ||
        scan_next_integer(&r->scan, "the number of faces", &r->face_count) ||
        (scan_token(&r->scan, &token) &&
         scan_integer(&r->scan, &token, "the number of edges", &ignored)))
        return -1;
    if (scan_token(&r->scan, &token))
        return scan_error(&r->scan, "\"%s\" behind the counts of vertices, faces and edges",
                          scan_quote(&token).text);
    /* The shortest rows are "0 0 0" and "3 0 0 0" with their line ends. */
    if (check_count(r, "vertex", r->vertex_count, 6) || check_count(r, "face", r->face_count, 8))
        return -1;
    scan_end_line(&r->scan);
    return 0;
}

/* Goes to the line of the next vertex or face. */
static int find_row(struct reader *r, const char *what, int64_t row, int64_t count)
{
    scan_begin_row(&r->scan);
    if (scan_find_token(&r->scan))
        return 0;
    return scan_error(&r->scan,
                      "the file ends before %s %lld of %lld: it is cut, or its counts lie", what,
                      (long long)row, (long long)count);
}

/* The vertex when its row is plain: then *is_read. */
static int read_plain_vertex(struct reader *r, bool *is_read)
{
    struct scan_plain_floats row;
    const char *behind = scan_plain_floats(&r->scan, 0, &row);
    *is_read = behind && (row.count == 3 || (r->has_attributes && row.count > 3));
    if (!*is_read)
        return 0;
    scan_pass_row(&r->scan, behind);
    return growing_mesh_add_vertex(&r->mesh, row.values, r->scan.err);
}

/* The face when its row is plain and right: then *is_read. */
static int read_plain_face(struct reader *r, bool *is_read)
{
    struct scan_plain_integers row;
    const char *behind = scan_plain_integers(&r->scan, 0, &row);
    *is_read = behind && row.count >= 4 && row.values[0] == row.count - 1;
    for (int i = 1; *is_read && i < row.count; i++)
        *is_read = row.values[i] >= 0 && row.values[i] < r->vertex_count;
    if (!*is_read)
        return 0;
    struct polygon polygon = {0};
    for (int i = 1; i < row.count; i++)
        if (polygon_add_corner(&polygon, &r->mesh, (int32_t)row.values[i], r->scan.err))
            return -1;
    scan_pass_row(&r->scan, behind);
    return 0;
}

static int read_vertices(struct reader *r)
{
    for (int64_t v = 0; v < r->vertex_count; v++) {
        float position[3];
        bool is_read;
        if (read_plain_vertex(r, &is_read))
            return -1;
        if (is_read)
            continue;
        struct token extra;
        if (find_row(r, "vertex", v, r->vertex_count) ||
            scan_row_float(&r->scan, "x", &position[0]) ||
            scan_row_float(&r->scan, "y", &position[1]) ||
            scan_row_float(&r->scan, "z", &position[2]) ||
            lost_vertices_add(&r->lost, &r->mesh, position, &r->scan))
            return -1;
        if (!r->has_attributes && scan_token(&r->scan, &extra))
            return scan_row_error(&r->scan,
                                  "\"%s\" behind the z of vertex %lld: a file with colours "
                                  "starts with COFF, one with normals with NOFF",
                                  scan_quote(&extra).text, (long long)v);
        scan_end_line(&r->scan);
    }
    return 0;
}

static int read_face(struct reader *r, int64_t face)
{
    int64_t corner_count;
    struct polygon polygon = {0};
    if (scan_next_integer(&r->scan, "the number of corners", &corner_count))
        return -1;
    if (corner_count < 3 && corner_count >= 0 && r->scan.reading)
        scan_note(&r->scan, READING_SHORT_FACE, 1);
    else if (corner_count < 3)
        return scan_error(&r->scan, "face %lld has %lld corners: at least 3 expected",
                          (long long)face, (long long)corner_count);
    for (int64_t corner = 0; corner < corner_count; corner++) {
        int64_t vertex;
        if (scan_row_integer(&r->scan, "the index of a vertex", &vertex))
            return -1;
        if (vertex < 0 || vertex >= r->vertex_count)
            return scan_error(&r->scan,
                              "face %lld: corner %lld names vertex %lld, the file has %lld, "
                              "counted from 0",
                              (long long)face, (long long)corner, (long long)vertex,
                              (long long)r->vertex_count);
        if (polygon_add_corner(&polygon, &r->mesh, (int32_t)vertex, r->scan.err))
            return -1;
    }
    scan_end_line(&r->scan);
    return 0;
}

static int read_everything(struct reader *r)
{
    if (read_keyword(r) || read_counts(r) ||
        growing_mesh_reserve(&r->mesh, r->vertex_count, r->face_count, r->scan.err) ||
        read_vertices(r))
        return -1;
    for (int64_t face = 0; face < r->face_count; face++) {
        bool is_read;
        if (read_plain_face(r, &is_read))
            return -1;
        if (!is_read && (find_row(r, "face", face, r->face_count) || read_face(r, face)))
            return -1;
    }
    if (scan_find_token(&r->scan) && !r->scan.reading)
        return scan_error(&r->scan, "the file goes on behind its last face: its counts lie");
    if (scan_find_token(&r->scan))
        scan_note(&r->scan, READING_REST, (int64_t)scan_left(&r->scan));
    return lost_vertices_take_out(&r->lost, &r->mesh, &r->scan);
}

int off_read(const void *bytes, size_t byte_count, const char *name, struct mesh *mesh,
             struct reading *reading, struct error *err)
{
    *mesh = (struct mesh){0};
    struct reader r = {0};
    if (scan_init(&r.scan, bytes, byte_count, name, err))
        return -1;
    r.scan.comment = '#';
    r.scan.reading = reading;
    int result = read_everything(&r);
    if (result == 0)
        growing_mesh_finish(&r.mesh, mesh);
    growing_mesh_release(&r.mesh);
    lost_vertices_release(&r.lost);
    scan_release(&r.scan);
    return result;
}

int off_write(FILE *out, const struct mesh *mesh, struct error *err)
{
    struct text_out text;
    if (text_out_begin(&text, out, err))
        return -1;
    fprintf(out, "OFF\n%d %d 0\n", mesh->vertex_count, mesh->triangle_count);
    text_out_positions(out, "", mesh);
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        fprintf(out, "3 %d %d %d\n", mesh->triangles[3 * t], mesh->triangles[3 * t + 1],
                mesh->triangles[3 * t + 2]);
    return text_out_end(&text, err);
}
