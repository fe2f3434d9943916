/* What `meshgrade mesh` tells of a file: on a terminal, as JSON, as a picture, as a page. */
#ifndef GRADERS_REPORT_MESH_MESH_REPORT_H
#define GRADERS_REPORT_MESH_MESH_REPORT_H

#include "graders/report/terminal.h"
#include "reference/formats/reading.h"
#include "reference/survey/sizes.h"
#include "reference/survey/survey.h"

#include <jansson.h>

/* A file, what was left out of it, and what was found. */
struct mesh_report {
    const char *name; /* of the file; "-" is the standard input */
    struct mesh mesh;
    struct reading reading;
    struct mesh_survey survey;
    struct representation_size sizes[SURVEY_SIZES];
    int size_count;
};

/* Looks at the mesh and the reading, which are there already. Returns 0, or -1 and *err; either way
 * mesh_report_release releases all, the mesh too. */
int mesh_report_make(struct mesh_report *report, const struct survey_wish *wish,
                     struct error *err) MUST_CHECK;
void mesh_report_release(struct mesh_report *report);

/* Whether nothing is wrong: no fault of the mesh, and no vertex or face was left out. */
bool mesh_report_is_clean(const struct mesh_report *report);

/* At most 80 columns. The name is cleaned. */
void mesh_report_print(FILE *to, const struct mesh_report *report,
                       const struct terminal_style *style);

/* A new reference; NULL when memory is out. The format stands in graders/report/README.md. */
json_t *mesh_report_json(const struct mesh_report *report);

/* The kinds of faults and notes as sentences, for terminal and page. A fault: "4
 * self-intersections", with "at least" where the search was cut. */
void mesh_report_say_fault(const struct mesh_report *report, enum survey_kind kind,
                           struct message *message);

/* Lines of "what it is": size, shape, box, area, valence. Returns how many there are. */
enum { MESH_REPORT_FACTS = 8 };
struct mesh_fact {
    struct phrase name;
    struct message text;
};
int mesh_report_facts(const struct mesh_report *report, struct mesh_fact facts[MESH_REPORT_FACTS]);

/* The scene: the mesh with its faults and its boundary marked (graders/render/README.md), a new
 * reference; NULL and *err on failure. */
json_t *mesh_report_scene(const struct mesh_report *report, struct error *err);

/* Draws the scene to a file; the format follows from the extension. Returns 0, or -1 and *err, which
 * says in the end why the renderer did not. */
int mesh_report_picture(const struct mesh_report *report, const char *path, const char *renderer,
                        enum language language, struct error *err) MUST_CHECK;

/* Writes FOLDER/index.html, in both languages, with the interactive view, a picture where it can be
 * drawn, and all that they load. root: the project's folder. Returns 0, or -1 and *err. */
int mesh_report_page(const struct mesh_report *report, const char *folder, const char *root,
                     const char *renderer, struct error *err) MUST_CHECK;

#endif
