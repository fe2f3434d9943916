/* The parts of a survey (survey.h): each finds the faults of some kinds. All return 0, or -1 and *err
 * (out of memory), and leave what they found to mesh_survey_release. */
#ifndef REFERENCE_SURVEY_FAULTS_H
#define REFERENCE_SURVEY_FAULTS_H

#include "reference/survey/survey.h"

/* Counts a fault and keeps it if it is one of the first. */
int survey_note(struct survey_fault *fault, struct survey_element element,
                struct error *err) MUST_CHECK;

/* Puts what was kept in order. */
void survey_sort(struct survey_fault *fault);

/* Triangles, vertices and edges that topology.h has counted: which they are. */
int survey_list_connectivity(struct mesh_survey *survey, const struct mesh *mesh,
                             const struct edge_list *list, struct error *err) MUST_CHECK;

int survey_find_flat(struct mesh_survey *survey, const struct mesh *mesh,
                     struct error *err) MUST_CHECK;

int survey_find_cracks(struct mesh_survey *survey, const struct mesh *mesh,
                       const struct edge_list *list, struct error *err) MUST_CHECK;

int survey_find_t_vertices(struct mesh_survey *survey, const struct mesh *mesh,
                           const struct edge_list *list, int64_t pair_limit,
                           struct error *err) MUST_CHECK;

int survey_find_crossings(struct mesh_survey *survey, const struct mesh *mesh, int64_t pair_limit,
                          struct error *err) MUST_CHECK;

#endif
