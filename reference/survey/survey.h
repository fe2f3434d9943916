/* What a mesh is, and everything that is wrong with it, in one call.
 *
 *     struct mesh_survey survey;
 *     if (mesh_survey_make(&survey, &mesh, &(struct survey_wish){0}, err))
 *         return -1;
 *     if (survey.faults[SURVEY_T_VERTEX].count > 0) {
 *         const struct survey_element *first = survey.faults[SURVEY_T_VERTEX].kept;
 *         ... vertex first->at[0] lies on the edge {first->at[1], first->at[2]} ...
 *     }
 *     mesh_survey_release(&survey);
 *
 * Cost: O(n log n) for n vertices and triangles, but for the searches in space (T-vertices and crossings),
 * which look at pairs whose boxes meet: about linear where triangles are of like size, and ended at a
 * limit where they are not (survey_wish). A million triangles take 0.25 s in order and 1.5 s
 * scrambled, and crossings 1.1 s more (Zen, one core). About 120 bytes a triangle while it runs, and 150 more
 * for crossings. */
#ifndef REFERENCE_SURVEY_SURVEY_H
#define REFERENCE_SURVEY_SURVEY_H

#include "reference/base/phrase.h"
#include "reference/mesh/check.h"
#include "reference/survey/box_tree.h"

/* Kinds of faults, and what the numbers of an element are (`at`). */
enum survey_kind {
    SURVEY_DEGENERATE,         /* {triangle}: it names a vertex twice */
    SURVEY_FLAT,               /* {triangle}: three vertices on a line, exactly */
    SURVEY_DUPLICATE,          /* {triangle, the first one of the same three vertices} */
    SURVEY_ISOLATED,           /* {vertex}: in no triangle */
    SURVEY_NONMANIFOLD_EDGE,   /* {low, high, how many triangles it has}: more than two */
    SURVEY_NONMANIFOLD_VERTEX, /* {vertex}: its triangles are not one fan or umbrella */
    SURVEY_INCOHERENT,         /* {low, high, triangle, triangle}: both run it the same way */
    SURVEY_CRACK,    /* {low, high, low, high of another}: a boundary edge, of which another
                                  has the same places of ends and other vertices */
    SURVEY_T_VERTEX, /* {vertex, low, high}: a vertex of the boundary that lies on a boundary
                                  edge, between its ends */
    SURVEY_CROSSING, /* {triangle, triangle}: their insides meet (crossing.h). Flat ones and
                                  pairs of the same three vertices are not looked at */
    SURVEY_KINDS
};

struct survey_element {
    int32_t at[4]; /* what is not used is -1 */
};

/* At most SURVEY_KEPT of the elements, those that come first by their numbers. */
enum { SURVEY_KEPT = 2000, SURVEY_VALENCES = 16 };
struct survey_fault {
    int64_t count;
    struct survey_element *kept;
    int32_t kept_count;
};

struct survey_wish {
    bool without_crossings; /* do not search them */
    double tolerance;   /* how near a T-vertex lies to its edge; 0: a millionth of the diagonal of
                               the mesh's box, and not below the rounding of its coordinates */
    int64_t pair_limit; /* pairs that a search in space looks at, at most; 0: 20 million and 50 a
                               triangle, some seconds */
};

struct mesh_survey {
    struct topology topology; /* check.h */
    bool is_closed;           /* no boundary edge, and some triangle */
    bool is_manifold;         /* no non-manifold edge or vertex */
    bool is_coherent;         /* no two triangles disagree about the outside */
    int64_t genus;            /* of all components together; -1: it has none, see has_genus */
    double area;              /* of all triangles */
    double volume;            /* inside; negative when the triangles face inwards. See has_volume */
    bool has_genus;           /* manifold, orientable, nothing degenerate */
    bool has_volume;          /* closed, manifold and coherent */
    struct bounds box;        /* of all vertices; low > high when there is none */
    /* Valence: edges at a vertex, of vertices that are not isolated. */
    int32_t least_valence, most_valence;
    double mean_valence;
    int64_t valence_counts[SURVEY_VALENCES + 1]; /* of each valence; the last: more */
    double tolerance;                            /* that was used */
    bool crossings_were_searched;
    bool is_cut[SURVEY_KINDS]; /* the search ended at its limit: there may be more */
    struct survey_fault faults[SURVEY_KINDS];
};

/* Looks at a valid mesh (mesh_check). The caller owns the survey (mesh_survey_release). Returns 0, or
 * -1 and *err (out of memory); then the survey is empty. */
int mesh_survey_make(struct mesh_survey *survey, const struct mesh *mesh,
                     const struct survey_wish *wish, struct error *err) MUST_CHECK;
void mesh_survey_release(struct mesh_survey *survey);

/* Faults of all kinds together; 0: the mesh is clean. A boundary is no fault. */
int64_t mesh_survey_fault_count(const struct mesh_survey *survey);

/* -- words ------------------------------------------------------------------------------------- */

/* A machine's word for a kind ("t-vertex"), and its name for people, one and many. */
const char *survey_kind_slug(enum survey_kind kind);
struct phrase survey_kind_name(enum survey_kind kind, bool many);

/* What an element of that kind is, in a sentence: "Vertex 7 lies on edge {3,9}, between its ends." */
void survey_say(enum survey_kind kind, const struct survey_element *element,
                struct message *message);

#endif
