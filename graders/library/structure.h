/* Connected structures of an answer, winged edges and half edges, compared with the faces that they
 * must hold. Faces have any number of corners; surfaces may be open, of several components, with
 * isolated vertices.
 *
 * Given the faces, a row that stands for a known edge can hold only one thing: so every wrong entry
 * is found, whatever the answer holds, and told with what is right there.
 *
 *     struct structure_truth truth;
 *     if (structure_truth_build(&faces, &truth, err))
 *         return -1;
 *     struct structure_answer answer = {STRUCTURE_WINGED_EDGE, rows, structure_winged_get,
 *                                       edge_count, vertex_edge, face_edge};
 *     struct structure_fault fault;
 *     if (!structure_compare(&truth, &answer, &fault, err)) {
 *         if (fault.kind != STRUCTURE_FINE)
 *             structure_fault_say(&fault, &message);  "ads of edge 3 (1,2) is 7; right is 4"
 *         structure_fault_release(&fault);
 *     }
 *     structure_truth_release(&truth);
 *
 * Winged edges are those of course document 001: cd runs vi -> vf and ci runs vf -> vi; ada and ads
 * are the edges before and after it in cd, aia and ais those in ci. On a boundary that face and its
 * two links are NONE. A half edge on a boundary has a twin whose face is NONE; these outer ones are
 * linked along the hole. */
#ifndef GRADERS_LIBRARY_STRUCTURE_H
#define GRADERS_LIBRARY_STRUCTURE_H

#include "graders/library/topology.h"
#include "reference/base/phrase.h"

enum { STRUCTURE_NONE = -1, STRUCTURE_COLUMNS_MOST = 10, STRUCTURE_WANTED_MOST = 6 };

enum structure_kind { STRUCTURE_WINGED_EDGE, STRUCTURE_HALF_EDGE };

/* Columns of a row, and behind them the two tables beside. */
enum winged_edge_column {
    WINGED_VI,
    WINGED_VF,
    WINGED_CD,
    WINGED_CI,
    WINGED_ADA,
    WINGED_ADS,
    WINGED_AIA,
    WINGED_AIS,
    WINGED_VERTEX_EDGE, /* any edge at the vertex; NONE: isolated */
    WINGED_FACE_EDGE    /* any edge of the face */
};
enum half_edge_column {
    HALF_ORIGIN,
    HALF_TWIN,
    HALF_FACE,
    HALF_NEXT,
    HALF_PREVIOUS,
    HALF_OF_VERTEX, /* any half edge that leaves the vertex; NONE: isolated */
    HALF_OF_FACE    /* any half edge of the face */
};

/* The tables of an answer, borrowed; they may hold anything, but are really there. */
struct structure_answer {
    enum structure_kind kind;
    const void *rows;
    int32_t (*get)(const void *rows, int64_t row, int column);
    int64_t row_count;
    const int32_t *of_vertex; /* an entry a vertex of the faces; NULL: not looked at */
    const int32_t *of_face;   /* an entry a face; NULL: not looked at */
};

/* `get` for rows that are int32_t tables in the order of the columns: 8 a winged edge; 5 a half
 * edge. */
int32_t structure_winged_get(const void *rows, int64_t row, int column);
int32_t structure_half_get(const void *rows, int64_t row, int column);

/* What the faces say. A side is a step along a face, numbered as its corner c, or the other way
 * round along a hole, numbered corner_count + c for the boundary side c. */
struct structure_truth {
    struct face_topology topology;
    int32_t *by_face;       /* corners, face after face, within a face by vertex */
    int32_t *by_vertex;     /* corners, by vertex, then by number */
    int64_t *first_of;      /* of used vertex i: by_vertex[first_of[i]] ... [first_of[i + 1] - 1] */
    int32_t *rim_starts_at; /* of used vertex i: the boundary side that starts there; -1 */
    int32_t *rim_ends_at;   /* ... that ends there */
};

/* Builds it. `faces` must outlive it and be proper, coherent and manifold, which are not the
 * student's matter: anything else is an error. Returns 0, or -1 and *err. O(n log n). */
int structure_truth_build(const struct face_table *faces, struct structure_truth *truth,
                          struct error *err) MUST_CHECK;
void structure_truth_release(struct structure_truth *truth);

/* Sides, as above; the tables of an answer are told by these. */
int32_t structure_from(const struct structure_truth *truth, int64_t side);
int32_t structure_to(const struct structure_truth *truth, int64_t side);
int32_t structure_face(const struct structure_truth *truth, int64_t side); /* NONE: a hole */
int64_t structure_next(const struct structure_truth *truth, int64_t side);
int64_t structure_previous(const struct structure_truth *truth, int64_t side);
int64_t structure_twin(const struct structure_truth *truth, int64_t side);

/* The side from one vertex to another, and the one that leaves a vertex in a face (NONE: along a
 * hole); -1: there is none. Any numbers may be asked. O(log n). */
int64_t structure_find_step(const struct structure_truth *truth, int32_t from, int32_t to);
int64_t structure_find_corner(const struct structure_truth *truth, int32_t face, int32_t vertex);

enum structure_fault_kind {
    STRUCTURE_FINE,
    STRUCTURE_WRONG_ENTRY, /* an entry is wrong, and `wanted` says what is right */
    STRUCTURE_NO_ELEMENT,  /* the row stands for no edge (or side) of the faces */
    STRUCTURE_REPEATED,    /* the row stands for the same edge (or side) as another one */
    STRUCTURE_MISSING      /* no row stands for an edge (or side) */
};

/* The first fault: of rows, by number; then a missing edge, in the order of the corners; then
 * entries, row after row and column after column; then of_vertex and of_face. Entries are looked at
 * only when the rows are one for each edge. Where a row stands for nothing, or for what another row
 * stands for, and one entry of its identity (vi, vf; origin, face) explains that, this entry is
 * told as wrong. */
struct structure_fault {
    enum structure_kind structure;
    enum structure_fault_kind kind;
    int64_t row; /* or the vertex or face of of_vertex, of_face; -1 with STRUCTURE_MISSING */
    int column;  /* of STRUCTURE_WRONG_ENTRY */
    int32_t found;
    bool is_out_of_range; /* no vertex, face or row has the number that was found */
    int32_t wanted[STRUCTURE_WANTED_MOST]; /* any of these */
    int64_t wanted_count;   /* of all that would be right; may be more than are told */
    int64_t repeated_of;    /* of STRUCTURE_REPEATED: the other row */
    int32_t from, to, face; /* the side that the row stands for, or that is missing; else NONE */
    int64_t no_element_count, repeated_count, missing_count; /* of rows, rows and edges (sides) */
    int64_t wrong_count;                                     /* entries */
    int64_t column_counts[STRUCTURE_COLUMNS_MOST]; /* wrong entries by column: for hints */
    uint8_t *marks; /* of each row: enum structure_fault_kind, fine ... repeated */
};

extern const struct cause structure_wrong_vertex, structure_wrong_face, structure_wrong_link,
    structure_out_of_range, structure_extra, structure_repeated, structure_missing,
    structure_wrong_vertex_table, structure_wrong_face_table;

/* Compares. On success the caller owns the fault (structure_fault_release). Returns 0, or -1 and
 * *err (out of memory, negative count). O(n log n) for n rows and corners. */
int structure_compare(const struct structure_truth *truth, const struct structure_answer *answer,
                      struct structure_fault *fault, struct error *err) MUST_CHECK;
void structure_fault_release(struct structure_fault *fault);

/* The cause of the first fault; NULL: nothing is wrong. */
const struct cause *structure_fault_cause(const struct structure_fault *fault);

/* The name of a column, as in the headers of the exercises. */
const char *structure_column_name(enum structure_kind kind, int column);

/* Sets the message to the first fault, without a full stop. */
void structure_fault_say(const struct structure_fault *fault, struct message *message);

#endif
