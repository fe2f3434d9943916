/* Vertices of a file that are not finite points. A mesh has no place for them: while the file is
 * read they stand in the table of positions, so that indices stay right, and at its end they are
 * taken out, unless a face uses one. */
#ifndef REFERENCE_FORMATS_LOST_VERTICES_H
#define REFERENCE_FORMATS_LOST_VERTICES_H

#include "reference/formats/growing_mesh.h"
#include "reference/formats/scan.h"

struct lost_vertex {
    int64_t vertex; /* its number in the file, from 0 */
    int64_t place;  /* its line, in binary data its byte */
};

/* By number. Start with zero. */
struct lost_vertices {
    struct lost_vertex *list;
    int64_t count, capacity;
};

/* Appends the vertex and remembers it as lost when it is not finite. Only a scan with a reading
 * lets such coordinates pass. Returns 0, or -1 and the scan's error (out of memory). */
int lost_vertices_add(struct lost_vertices *lost, struct growing_mesh *mesh,
                      const float position[3], const struct scan *scan) MUST_CHECK;

/* Takes the lost vertices out of the mesh, renumbers its triangles, and notes it in the scan's
 * reading. Every index must be one of the mesh. Returns 0, or -1 and the scan's error: a triangle
 * uses one of them. */
int lost_vertices_take_out(const struct lost_vertices *lost, struct growing_mesh *mesh,
                           const struct scan *scan) MUST_CHECK;

void lost_vertices_release(struct lost_vertices *lost);

#endif
