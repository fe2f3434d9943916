/* The meshes that every representation is tried with. */
#ifndef TESTS_UNIT_MESH_CORPUS_H
#define TESTS_UNIT_MESH_CORPUS_H

#include "reference/mesh/mesh.h"

/* Small meshes of every generator, some of them changed; none has more than 300 vertices. */
enum { CORPUS_GENERATED = 34 };

/* Mesh number i of the corpus: generated ones first, any number of random ones behind them (valid,
 * often with holes, flips, isolated vertices, duplicate and degenerate triangles, wild
 * connectivity). Aborts when memory runs out. The caller owns it. */
struct mesh corpus_mesh(int i);

/* Its name, for messages. */
const char *corpus_name(int i);

#endif
