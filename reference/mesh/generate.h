/* Meshes made by formula, and changes that make a mesh harder. Everything random has an explicit
 * seed; the same arguments give the same bytes on every machine.
 *
 * Every generate_ function makes a new mesh that the caller owns (mesh_release); every change works
 * in place on a mesh that the caller owns. All return 0, or -1 and *err (out of memory, or an
 * argument out of the range that stands with it), and then leave the empty mesh (generators) or the
 * mesh as it was (changes). Cost is linear in the mesh made unless it says otherwise. Closed meshes
 * are coherently oriented with normals outwards. Positions are about one unit wide around the
 * origin.
 */
#ifndef REFERENCE_MESH_GENERATE_H
#define REFERENCE_MESH_GENERATE_H

#include "reference/mesh/mesh.h"

/* The course's grid (problem 4.2): m rows of n pairs of triangles, (m+1)(n+1) vertices, 2mn
 * triangles, open, on a gently waved sheet. m, n >= 1. Vertex of row r, column c: r * (n+1) + c. */
int generate_grid(struct mesh *mesh, int64_t m, int64_t n, struct error *err) MUST_CHECK;

/* Closed sphere of radius 1/2 along meridians and parallels: meridians >= 3 around, parallels >= 1
 * rows of vertices between two shared poles; parallels * meridians + 2 vertices. */
int generate_uv_sphere(struct mesh *mesh, int64_t meridians, int64_t parallels,
                       struct error *err) MUST_CHECK;

/* Icosahedron, each triangle split in 4, `levels` times (0 ... 9), on the sphere of radius 1/2. */
int generate_icosphere(struct mesh *mesh, int levels, struct error *err) MUST_CHECK;

/* Closed surface of the given genus (0 ... 1000000; 0 gives a sphere, 1 the torus): a row of
 * `genus` tori joined by necks, about `triangles` (>= 1) triangles but never fewer than the genus
 * needs (some 28 a torus). V - E + F = 2 - 2 genus. */
int generate_torus(struct mesh *mesh, int genus, int64_t triangles, struct error *err) MUST_CHECK;

/* Flat disc: a centre, `rings` rings of `sectors` vertices. Open, one boundary loop. */
int generate_disc(struct mesh *mesh, int64_t rings, int64_t sectors, struct error *err) MUST_CHECK;

/* Fan: `triangles` (>= 1) triangles around vertex 0, which has valence triangles + 1. Open. */
int generate_fan(struct mesh *mesh, int64_t triangles, struct error *err) MUST_CHECK;

/* Bipyramid: closed, 2 * valence triangles, two apexes of the given valence (>= 3). */
int generate_bipyramid(struct mesh *mesh, int64_t valence, struct error *err) MUST_CHECK;

/* Moebius strip of `quads` (>= 3) pairs of triangles: open, one boundary loop, not orientable. */
int generate_moebius(struct mesh *mesh, int64_t quads, struct error *err) MUST_CHECK;

/* Two closed cones of `sectors` (>= 3) that share only their apex: a non-manifold vertex. */
int generate_two_cones(struct mesh *mesh, int64_t sectors, struct error *err) MUST_CHECK;

/* Two closed cubes that share one edge, which then has four triangles: a non-manifold edge. */
int generate_two_cubes(struct mesh *mesh, struct error *err) MUST_CHECK;

/* `leaves` (>= 3) triangles around one common edge: the smallest non-manifold edge. */
int generate_book(struct mesh *mesh, int64_t leaves, struct error *err) MUST_CHECK;

/* `triangles` separate random triangles: 3 vertices each, nothing shared. */
int generate_soup(struct mesh *mesh, int64_t triangles, uint64_t seed,
                  struct error *err) MUST_CHECK;

/* `triangles` needles: a strip of triangles whose height is `ratio` (0 < ratio <= 1) of their base.
 */
int generate_needles(struct mesh *mesh, int64_t triangles, double ratio, uint64_t seed,
                     struct error *err) MUST_CHECK;

/* The tetrahedron, the cube (12 triangles), one triangle, and nothing at all. */
int generate_tetrahedron(struct mesh *mesh, struct error *err) MUST_CHECK;
int generate_cube(struct mesh *mesh, struct error *err) MUST_CHECK;
int generate_one_triangle(struct mesh *mesh, struct error *err) MUST_CHECK;
int generate_empty(struct mesh *mesh, struct error *err) MUST_CHECK;

/* -- changes -------------------------------------------------------------------------------- */

/* Renumbers the vertices, permutes the triangles and rotates their corners at random; orientation
 * and shape stay. What a scanner or another program would have written. */
int change_scramble(struct mesh *mesh, uint64_t seed, struct error *err) MUST_CHECK;

/* Renumbers so that hash tables with masks or small multipliers collide: neighbouring vertices get
 * numbers that differ by large powers of two, as far as vertex_count allows; triangles permuted. */
int change_adversarial_numbering(struct mesh *mesh, uint64_t seed, struct error *err) MUST_CHECK;

/* Reverses each triangle with the given probability (0 ... 1): incoherent orientation. */
int change_flip(struct mesh *mesh, double probability, uint64_t seed, struct error *err) MUST_CHECK;

/* Appends a copy of `other`, moved by (dx, dy, dz), its vertices numbered after the present ones.
 */
int change_append(struct mesh *mesh, const struct mesh *other, float dx, float dy, float dz,
                  struct error *err) MUST_CHECK;

/* Inserts `count` vertices that no triangle uses, at random places of the numbering. */
int change_add_isolated_vertices(struct mesh *mesh, int64_t count, uint64_t seed,
                                 struct error *err) MUST_CHECK;

/* Lists `count` random triangles once more (rotated, some reversed). */
int change_add_duplicate_triangles(struct mesh *mesh, int64_t count, uint64_t seed,
                                   struct error *err) MUST_CHECK;

/* Adds `count` degenerate triangles on existing vertices: (a,a,b), (a,b,a), (a,a,a) in turn; the
 * two different vertices of each are joined by an edge of the mesh already. */
int change_add_degenerate_triangles(struct mesh *mesh, int64_t count, uint64_t seed,
                                    struct error *err) MUST_CHECK;

/* Removes `count` random triangles: holes. */
int change_remove_triangles(struct mesh *mesh, int64_t count, uint64_t seed,
                            struct error *err) MUST_CHECK;

/* Moves every vertex by (dx, dy, dz) in binary32: far from the origin, precision is lost. */
void change_translate(struct mesh *mesh, float dx, float dy, float dz);

/* Scales every coordinate. */
void change_scale(struct mesh *mesh, float factor);

#endif
