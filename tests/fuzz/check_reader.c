/* What must hold for every reader; see check_reader.h. */
#include "tests/fuzz/check_reader.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static void require(bool holds, const char *what)
{
    if (holds)
        return;
    fprintf(stderr, "fuzz: it does not hold that %s\n", what);
    abort();
}

static bool same_table(const void *a, const void *b, int32_t count)
{
    return count == 0 || memcmp(a, b, 12 * (size_t)count) == 0;
}

/* The functions of a format. */
struct format {
    int (*read)(const void *, size_t, const char *, struct mesh *, struct reading *,
                struct error *);
    int (*write)(FILE *, const struct mesh *, struct error *);
};

static void check_reading(const struct format *format, const uint8_t *bytes, size_t byte_count,
                          struct reading *reading)
{
    struct mesh mesh, back;
    struct error err = {0};
    if (format->read(bytes, byte_count, "input", &mesh, reading, &err)) {
        require(strncmp(err.text, "input:", 6) == 0, "an error names the file");
        require(!mesh.positions && !mesh.triangles, "a failure leaves the empty mesh");
        return;
    }
    require(err.text[0] == '\0', "success records no error");
    require(mesh_check(&mesh, &err) == 0, "the mesh is valid");
    require((uint64_t)mesh.vertex_count + (uint64_t)mesh.triangle_count <= byte_count,
            "each element takes a byte of the file at least");
    char *text = NULL;
    size_t text_count;
    FILE *out = open_memstream(&text, &text_count);
    require(out && format->write(out, &mesh, &err) == 0 && fclose(out) == 0,
            "the mesh can be written");
    require(format->read(text, text_count, "written", &back, NULL, &err) == 0,
            "what was written can be read");
    require(back.vertex_count == mesh.vertex_count && back.triangle_count == mesh.triangle_count &&
                same_table(back.positions, mesh.positions, mesh.vertex_count) &&
                same_table(back.triangles, mesh.triangles, mesh.triangle_count),
            "what was written comes back");
    mesh_release(&back);
    mesh_release(&mesh);
    free(text);
}

void check_reader(int (*read)(const void *, size_t, const char *, struct mesh *, struct reading *,
                              struct error *),
                  int (*write)(FILE *, const struct mesh *, struct error *), const uint8_t *bytes,
                  size_t byte_count)
{
    const struct format format = {read, write};
    struct reading reading = {0};
    check_reading(&format, bytes, byte_count, NULL);
    check_reading(&format, bytes, byte_count, &reading);
    for (int kind = 0; kind < READING_KINDS; kind++)
        require(reading.notes[kind].count >= 0 &&
                    (uint64_t)reading.notes[kind].count <= byte_count + 1,
                "what is left out stood in the file");
}
