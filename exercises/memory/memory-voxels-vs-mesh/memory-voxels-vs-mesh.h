/* Problem 4.1: memory used by a sphere as voxels and as a mesh.
 *
 * The sphere has radius 1/2 and its centre at the origin. k says how finely it is stored.
 *
 * Voxels: the cube around the sphere is cut into k x k x k cells, each 1/k wide. Cell (x, y, z),
 * with x, y, z in 0 ... k - 1, has its centre at x' = (x + 0.5) / k - 0.5, and y' and z' likewise.
 * It takes one bit: 1 when its centre is in the sphere (inside or on it), else 0. Bits are packed 8
 * to a byte.
 *
 * Mesh: vertices stand where meridians and parallels cross. There are k meridians, and each has k
 * vertices from the north pole (0, 0, 1/2) to the south pole (0, 0, -1/2): both poles belong to
 * every meridian, so k vertices lie at each pole. Neighbouring meridians (the last and the first,
 * too) are joined by k - 1 cells of two triangles; the cells at the poles have two as well,
 * although one of them has no area: that keeps the table regular. Only two tables are stored:
 * vertices (three float each) and triangles (three int32_t each: indices of vertices, from 0 on).
 *
 * Sizes: a float and an int32_t take 4 bytes, 1 KB is 1024 bytes, 1 MB is 1024 KB.
 *
 * You write the nine functions. The file needs nothing but this header and the C library. */
#ifndef MEMORY_VOXELS_VS_MESH_H
#define MEMORY_VOXELS_VS_MESH_H

#include <stdint.h>

/* What a builder returns when malloc gave NULL. */
enum { OUT_OF_MEMORY = -1 };

struct voxel_sphere {
    uint8_t *bits; /* cell (x, y, z) is bit number x + k * (y + k * z); bit number b is bit b % 8 of
                      byte b / 8, where bit 0 is the lowest (value 1); unused bits of the last
                      byte are 0 */
    int64_t byte_count; /* of bits: no byte more than needed */
};

struct mesh_sphere {
    float *vertices;    /* x y z of vertex 0, x y z of vertex 1, ... */
    int32_t *triangles; /* three indices of triangle 0, three of triangle 1, ... */
    int32_t vertex_count;
    int32_t triangle_count;
};

/* Bytes of the voxels, and bytes of both tables of the mesh.
 *
 * k        voxels: 1 ... 2 000 000; mesh: 3 ... 2 000 000
 * returns  the exact number: mind that it does not always fit into 32 bits */
int64_t voxel_sphere_bytes(int32_t k);
int64_t mesh_sphere_bytes(int32_t k);

/* The same in KB for k = 16 and in MB for k = 1024. Two decimals are enough. */
double voxel_sphere_kilobytes(void);
double mesh_sphere_kilobytes(void);
double voxel_sphere_megabytes(void);
double mesh_sphere_megabytes(void);

/* The smallest k (at least 3) with which the mesh takes fewer bytes than the voxels. */
int32_t smallest_k_for_mesh(void);

/* Builds the voxels.
 *
 * k        1 or more
 * sphere   comes in with unknown contents; fill both fields. bits is one block of byte_count bytes
 * from malloc; the caller frees it with free returns  0, or OUT_OF_MEMORY; then nothing stays
 * allocated and the fields do not matter
 *
 * The time must be linear in the number of cells. */
int voxel_sphere_build(int32_t k, struct voxel_sphere *sphere);

/* Builds the mesh.
 *
 * Meridian j, for j in 0 ... k - 1, lies at angle 2 pi j / k around the z axis, from x towards y;
 * its vertex i, for i in 0 ... k - 1, lies at angle pi i / (k - 1) from the north pole. Every place
 * must be met within 0.00001. Triangles are counter-clockwise seen from outside (those without area
 * may be either way). Vertices may be numbered, and triangles listed, in any order, and cells cut
 * by either diagonal.
 *
 * k        3 or more
 * sphere   comes in with unknown contents; fill all four fields. Each table is one block of exactly
 *          its size, from malloc; the caller frees both with free
 * returns  0, or OUT_OF_MEMORY; then nothing stays allocated and the fields do not matter
 *
 * The time must be linear in the number of vertices. */
int mesh_sphere_build(int32_t k, struct mesh_sphere *sphere);

#endif
