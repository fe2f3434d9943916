/* What the memory exercises are asked: the first integer of an input packet. Shared by the runner's
 * calls and the judges. */
#ifndef GRADERS_RUNNER_MEMORY_QUESTIONS_H
#define GRADERS_RUNNER_MEMORY_QUESTIONS_H

/* Packets in: ASK_..._BYTES and ASK_STRIPS_PROCESSED: row count, then pairs of int32 (m and n, or k
 * and 0). Builders: m, n (or k), then what the judge looks at, which is no business of the
 * runner's. Numbers: nothing more. Packets out: an int64 a row (processed: all of the strips, then
 * all of the indexed mesh), or one real, or status, tables and what the student's own formulas say.
 */
enum grid_question {
    ASK_GRID_BYTES,
    ASK_GRID_KILOBYTES,
    ASK_GRID_FACES_PER_VERTEX,
    ASK_GRID_BUILD
};

enum strips_question {
    ASK_STRIPS_BYTES,
    ASK_STRIPS_PROCESSED,
    ASK_STRIPS_KILOBYTES,
    ASK_STRIPS_MEMORY_RATIO,
    ASK_STRIPS_TIME_RATIO,
    ASK_STRIPS_BUILD
};

enum sphere_question {
    ASK_VOXEL_BYTES,
    ASK_MESH_BYTES,
    ASK_VOXEL_KILOBYTES,
    ASK_MESH_KILOBYTES,
    ASK_VOXEL_MEGABYTES,
    ASK_MESH_MEGABYTES,
    ASK_CROSSOVER,
    ASK_VOXEL_BUILD,
    ASK_MESH_BUILD
};

#endif
