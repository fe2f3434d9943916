/* What the queries of every representation cost, counted in accesses (counted_reads.h), against
 * what its header claims (representation.h, `cost`; course document 001 for winged edges).
 *
 * Each query is asked on two sizes of a torus, where every vertex has valence 6, and about vertices
 * of two valences of one bipyramid, so that n (all faces or edges are looked at) and k (valence)
 * are told apart. Queries about faces are asked about an ordinary face and about one that has both
 * apexes, an edge between these having been flipped in. Where a query searches, elements are taken
 * evenly from the whole mesh, and pairs of vertices share no edge. */
#ifndef BENCH_COMPARE_ACCESSES_H
#define BENCH_COMPARE_ACCESSES_H

#include "reference/representation/representation.h"

#include <jansson.h>

enum { ACCESS_SMALL = 2000, ACCESS_LARGE = 4 * ACCESS_SMALL, ACCESS_VALENCE = 256 };

struct access_count {
    const struct representation *kind;
    enum query query;
    double by_size[2];    /* mean accesses of a query on a torus of about ACCESS_SMALL and
                             ACCESS_LARGE triangles */
    double by_valence[2]; /* around a vertex of valence 4, and of valence ACCESS_VALENCE */
    const char *growth;   /* counted: "1", "lg s", "k", "k^2" or "n"; static */
    bool holds;           /* the growth is the one that is claimed. k of a face is 3 here, so that
                             there "k" may be constant; "k^2", k times the valence of each
                             neighbour, and "lg s" are bounds */
};

struct access_counts {
    struct access_count *rows; /* a representation's queries together, in order */
    int count;
    int32_t triangles[2], valences[2]; /* that were made */
};

/* Counts all queries of all representations. The caller owns the rows (accesses_release), also
 * after an error. Not for several threads.
 *
 * returns  0, or -1 and *err: out of memory
 * cost     some tenths of a second */
int accesses_count(struct access_counts *counts, struct error *err) MUST_CHECK;
void accesses_release(struct access_counts *counts);

/* "faces-around-vertex": static. */
const char *query_name(enum query query);

/* The rows as in bench.json (README.md). The caller owns the array. NULL: out of memory. */
json_t *accesses_to_json(const struct access_counts *counts);

#endif
