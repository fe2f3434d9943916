/* Voxels row by row, where the cells inside form one run; the mesh by turning a point step by step
 * in double, from the last vertex to the first. */
#include "memory-voxels-vs-mesh.h"

#include <math.h>
#include <stdlib.h>

int64_t voxel_sphere_bytes(int32_t k)
{
    return ((int64_t)k * k * k + 7) >> 3;
}

int64_t mesh_sphere_bytes(int32_t k)
{
    int64_t side = k;
    return 12 * side * (3 * side - 2);
}

double voxel_sphere_kilobytes(void)
{
    return 16.0 * 16 * 16 / 8 / 1024;
}

double mesh_sphere_kilobytes(void)
{
    return 8832.0 / 1024;
}

double voxel_sphere_megabytes(void)
{
    return 1024.0 / 8;
}

double mesh_sphere_megabytes(void)
{
    return 36 - 24.0 / 1024;
}

/* By halving: from some k on the mesh stays the smaller one. */
int32_t smallest_k_for_mesh(void)
{
    int32_t low = 3, high = 100000;
    while (low < high) {
        int32_t middle = (low + high) / 2;
        if (mesh_sphere_bytes(middle) < voxel_sphere_bytes(middle))
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

int voxel_sphere_build(int32_t k, struct voxel_sphere *sphere)
{
    sphere->byte_count = voxel_sphere_bytes(k);
    uint8_t *bits = sphere->bits = calloc(1, (size_t)sphere->byte_count);
    if (!bits)
        return OUT_OF_MEMORY;
    for (int64_t row = 0; row < (int64_t)k * k; row++) {
        int64_t y = 2 * (row % k) + 1 - k, z = 2 * (row / k) + 1 - k;
        int64_t left = (int64_t)k * k - y * y - z * z;
        int32_t first = 0;
        while (first < k && (2 * first + 1 - (int64_t)k) * (2 * first + 1 - (int64_t)k) > left)
            first++;
        for (int64_t bit = row * k + first; bit < row * k + k - first; bit++)
            bits[bit / 8] = (uint8_t)(bits[bit / 8] | 1 << bit % 8);
    }
    return 0;
}

static void turn(double *a, double *b, double cosine, double sine)
{
    double old = *a;
    *a = old * cosine - *b * sine;
    *b = old * sine + *b * cosine;
}

static void place(int32_t k, float *vertices)
{
    const double half_turn = acos(-1);
    double across = 0.5, up = 0; /* the equator; a pole is a quarter turn away */
    turn(&across, &up, cos(half_turn / 2), sin(half_turn / 2));
    for (int32_t i = 0; i < k; i++) {
        double x = across, y = 0;
        for (int32_t j = 0; j < k; j++) {
            float *vertex = vertices + 3 * (k * k - 1 - (j * k + i));
            vertex[0] = (float)x;
            vertex[1] = (float)y;
            vertex[2] = (float)up;
            turn(&x, &y, cos(2 * half_turn / k), sin(2 * half_turn / k));
        }
        turn(&across, &up, cos(half_turn / (k - 1)), -sin(half_turn / (k - 1)));
    }
}

int mesh_sphere_build(int32_t k, struct mesh_sphere *sphere)
{
    int32_t last = k * k - 1;
    int32_t *corner = malloc((size_t)k * (size_t)(k - 1) * 6 * sizeof *corner);
    float *vertices = calloc((size_t)k * (size_t)k, 3 * sizeof *vertices);
    if (!corner || !vertices) {
        free(corner);
        free(vertices);
        return OUT_OF_MEMORY;
    }
    *sphere = (struct mesh_sphere){vertices, corner, k * k, 2 * k * (k - 1)};
    place(k, vertices);
    for (int32_t cell = 0; cell < k * (k - 1); cell++, corner += 6) {
        int32_t i = cell / k, j = cell % k, east = (j + 1) % k;
        corner[0] = corner[5] = last - (east * k + i + 1);
        corner[1] = last - (east * k + i);
        corner[2] = corner[3] = last - (j * k + i);
        corner[4] = last - (j * k + i + 1);
    }
    return 0;
}
