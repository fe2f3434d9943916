/* Writing PLY files; see ply.h. */
#include "reference/formats/ply.h"

#include "reference/formats/text_out.h"

#include <stdbool.h>
#include <string.h>

static void write_header(FILE *out, const struct mesh *mesh, enum ply_encoding encoding)
{
    static const char *const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    fprintf(out,
            "ply\nformat %s 1.0\ncomment written by meshgrade\n"
            "element vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
            formats[encoding], mesh->vertex_count, mesh->triangle_count);
}

static void write_text(FILE *out, const struct mesh *mesh)
{
    text_out_positions(out, "", mesh);
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        fprintf(out, "3 %d %d %d\n", mesh->triangles[3 * t], mesh->triangles[3 * t + 1],
                mesh->triangles[3 * t + 2]);
}

/* The four bytes of a float or an int. */
static void put_word(unsigned char *to, const void *word, bool is_big_endian)
{
    uint32_t bits;
    memcpy(&bits, word, sizeof bits);
    for (int i = 0; i < 4; i++)
        to[is_big_endian ? 3 - i : i] = (unsigned char)(bits >> 8 * i);
}

static void write_binary(FILE *out, const struct mesh *mesh, bool is_big_endian)
{
    unsigned char row[13] = {3};
    for (int64_t v = 0; v < mesh->vertex_count; v++) {
        for (size_t axis = 0; axis < 3; axis++)
            put_word(row + 1 + 4 * axis, mesh->positions + 3 * v + axis, is_big_endian);
        fwrite(row + 1, 1, 12, out);
    }
    for (int64_t t = 0; t < mesh->triangle_count; t++) {
        for (size_t corner = 0; corner < 3; corner++)
            put_word(row + 1 + 4 * corner, mesh->triangles + 3 * t + corner, is_big_endian);
        fwrite(row, 1, 13, out);
    }
}

int ply_write(FILE *out, const struct mesh *mesh, enum ply_encoding encoding, struct error *err)
{
    struct text_out text;
    if (text_out_begin(&text, out, err))
        return -1;
    write_header(out, mesh, encoding);
    if (encoding == PLY_ASCII)
        write_text(out, mesh);
    else
        write_binary(out, mesh, encoding == PLY_BIG_ENDIAN);
    return text_out_end(&text, err);
}
