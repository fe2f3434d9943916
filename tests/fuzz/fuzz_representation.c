/* Fuzz target: any bytes read as a mesh, then built in every representation. A byte says how many
 * vertices there are, each further byte is a corner; positions follow from the numbers, several
 * vertices share one. Either a build fails and says why, leaving nothing; or the structure is in
 * order and gives the mesh back, and its queries stay within it and agree with each other. */
#include "reference/representation/representation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t byte_count);

enum { LARGEST = 3 * 200 }; /* corners: searches through all faces for all vertices stay quick */

static void require(bool holds, const char *what)
{
    if (holds)
        return;
    fprintf(stderr, "fuzz: it does not hold that %s\n", what);
    abort();
}

static struct mesh mesh_file_read(const uint8_t *bytes, size_t byte_count)
{
    struct mesh mesh;
    int32_t vertex_count = byte_count > 0 ? bytes[0] : 0;
    size_t corner_count = vertex_count > 0 ? byte_count - 1 : 0;
    corner_count = corner_count < LARGEST ? corner_count : LARGEST;
    require(mesh_init(&mesh, vertex_count, (int64_t)(corner_count / 3), NULL) == 0, "memory");
    for (int32_t v = 0; v < vertex_count; v++) {
        mesh.positions[3 * v] = (float)(v % 7);
        mesh.positions[3 * v + 1] = (float)(v / 7 % 5);
        mesh.positions[3 * v + 2] = v % 2 ? 0.0F : -0.0F;
    }
    for (int64_t i = 0; i < 3 * (int64_t)mesh.triangle_count; i++)
        mesh.triangles[i] = bytes[1 + i] % vertex_count;
    return mesh;
}

/* Answers about one vertex are within the structure, and its neighbours share edges with it. */
static void check_vertex(const struct representation *kind, const void *self, int32_t vertex,
                         int32_t *answer)
{
    int32_t count = kind->faces_around_vertex(self, vertex, answer, LARGEST);
    require(count >= 0 && count <= kind->face_count(self), "faces around a vertex are faces");
    for (int32_t i = 0; i < count; i++)
        require(answer[i] >= 0 && answer[i] < kind->face_count(self), "each is a face");
    count = kind->vertices_around_vertex(self, vertex, answer, LARGEST);
    require(count >= 0 && count < LARGEST, "a vertex has neighbours");
    for (int32_t i = 0; i < count; i++) {
        require(answer[i] >= 0 && answer[i] < kind->vertex_count(self), "each is a vertex");
        require(kind->is_edge(self, vertex, answer[i]), "neighbours share an edge");
        require(kind->is_edge(self, answer[i], vertex), "both ways");
    }
}

/* Neighbours of a face have it as a neighbour, where edges have two sides at most. */
static void check_face(const struct representation *kind, const void *self, int32_t face)
{
    int32_t neighbours[3], back[3];
    kind->face_neighbours(self, face, neighbours);
    for (int i = 0; i < 3; i++) {
        if (neighbours[i] < 0 || (kind->holds & FEATURE_NONMANIFOLD_EDGE))
            continue;
        require(neighbours[i] < kind->face_count(self), "a neighbour is a face");
        kind->face_neighbours(self, neighbours[i], back);
        require(back[0] == face || back[1] == face || back[2] == face, "neighbours are mutual");
    }
}

static void check_sweeps(const struct representation *kind, void *self, int32_t *answer)
{
    struct error err = {0};
    int64_t edges = kind->edges(self, answer, &err);
    require(edges >= 0 && edges <= 3 * (int64_t)kind->face_count(self), "edges are sides");
    int32_t starts[LARGEST + 1];
    int32_t loops = kind->boundary_loops(self, answer, starts, &err);
    require(loops >= 0 || err.text[0], "boundary loops are found, or not for a reason");
    require(kind->smooth(self, NULL) == 0 && kind->check(self, NULL) == 0,
            "smoothing keeps it in order");
}

static void try_kind(const struct representation *kind, const struct mesh *mesh, bool can_hold)
{
    void *self;
    struct error err = {0};
    struct mesh back;
    int32_t answer[2 * LARGEST];
    if (representation_new(kind, &self, mesh, &err)) {
        require(!can_hold && err.text[0] && !self, "what can be held is not refused");
        return;
    }
    require(can_hold, "what cannot be held is refused");
    require(kind->check(self, &err) == 0, "what was built is in order");
    require(kind->to_mesh(self, &back, &err) == 0 && mesh_check(&back, &err) == 0,
            "the mesh comes back");
    require(back.triangle_count == mesh->triangle_count, "with all its triangles");
    require(kind->vertex_names || back.vertex_count == mesh->vertex_count, "and its vertices");
    mesh_release(&back);
    for (int32_t v = 0; v < kind->vertex_count(self); v += 1 + kind->vertex_count(self) / 16)
        check_vertex(kind, self, v, answer);
    for (int32_t f = 0; f < kind->face_count(self); f += 1 + kind->face_count(self) / 16)
        check_face(kind, self, f);
    check_sweeps(kind, self, answer);
    representation_delete(kind, self);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t byte_count)
{
    struct mesh mesh = mesh_file_read(bytes, byte_count);
    struct topology topology;
    require(mesh_topology(&mesh, &topology, NULL) == 0, "memory");
    unsigned features = mesh_features(&topology);
    for (int i = 0; representation_table[i]; i++)
        try_kind(representation_table[i], &mesh, !(features & ~representation_table[i]->holds));
    mesh_release(&mesh);
    return 0;
}
