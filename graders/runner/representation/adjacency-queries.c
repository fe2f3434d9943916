/* The runner of adjacency-queries: answers the student's accesses from the table in the packet, and
 * asks the queries that the judge wrote beside the mesh (graders/judges/.../adjacency-queries.c). */
#include "adjacency-queries.h"
#include "graders/runner/shapes.h"

/* What the given functions read. */
static struct {
    const struct winged_edge *rows;
    const int32_t *of_vertex, *of_face;
    int32_t edge_count, vertex_count, face_count;
} mesh;

struct winged_edge row_of_edge(int32_t edge)
{
    static const struct winged_edge none = {-1, -1, -1, -1, -1, -1, -1, -1};
    count_access();
    return edge >= 0 && edge < mesh.edge_count ? mesh.rows[edge] : none;
}

int32_t edge_of_vertex(int32_t vertex)
{
    count_access();
    return vertex >= 0 && vertex < mesh.vertex_count ? mesh.of_vertex[vertex] : -1;
}

int32_t edge_of_face(int32_t face)
{
    count_access();
    return face >= 0 && face < mesh.face_count ? mesh.of_face[face] : -1;
}

/* A query of the packet. */
struct asked {
    int32_t kind, element, capacity;
};

static int32_t (*const queries[])(int32_t, int32_t *, int32_t) = {
    edges_of_face,   vertices_of_face,   faces_of_face, edges_of_vertex,
    faces_of_vertex, vertices_of_vertex, edges_of_edge};

void run_call(struct reader *input, struct writer *answer)
{
    struct given given = given_polygons(input);
    mesh.vertex_count = given.vertex_count;
    mesh.face_count = given.face_count;
    mesh.edge_count = (int32_t)read_int(input);
    mesh.rows = read_array(input, mesh.edge_count, sizeof *mesh.rows);
    mesh.of_vertex = read_array(input, mesh.vertex_count, sizeof *mesh.of_vertex);
    mesh.of_face = read_array(input, mesh.face_count, sizeof *mesh.of_face);
    int64_t count = read_int(input), room = read_int(input);
    const struct asked *asked = read_array(input, count, sizeof *asked);
    int32_t *returned = given_array(count, sizeof *returned);
    int32_t *first = given_array(count + 1, sizeof *first);
    int32_t *out = given_array(room, sizeof *out);
    first[0] = 0;
    measure_begin();
    for (int64_t i = 0; i < count; i++) {
        int32_t most = asked[i].capacity, *lent = lend_room(out + first[i], most);
        returned[i] = queries[asked[i].kind](asked[i].element, lent, most);
        first[i + 1] = first[i] + (returned[i] < 0 ? 0 : returned[i] < most ? returned[i] : most);
        take_room(out + first[i], lent, first[i + 1] - first[i]);
    }
    measure_end();
    answer_result(answer, count);
    answer_given(answer, count, returned, sizeof *returned);
    answer_given(answer, count + 1, first, sizeof *first);
    answer_given(answer, first[count], out, sizeof *out);
}
