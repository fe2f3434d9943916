/* A mesh as JSON; see mesh_report.h. */
#include "graders/report/clean.h"
#include "graders/report/mesh/mesh_report.h"

#include <stdlib.h>
#include <string.h>

static json_t *message_json(const struct message *message)
{
    return json_pack("{s:s, s:s}", "en", message->en, "es", message->es);
}

static json_t *notes_json(const struct reading *reading)
{
    json_t *notes = json_array();
    for (int kind = 0; kind < READING_KINDS; kind++) {
        const struct reading_note *note = &reading->notes[kind];
        struct message message;
        if (note->count == 0)
            continue;
        reading_say(reading, (enum reading_kind)kind, &message);
        json_array_append_new(
            notes, json_pack("{s:s, s:I, s:I, s:o}", "kind", reading_slug((enum reading_kind)kind),
                             "count", (json_int_t)note->count, note->is_byte ? "byte" : "line",
                             (json_int_t)note->place, "message", message_json(&message)));
    }
    return notes;
}

static json_t *element_json(const struct survey_element *element)
{
    json_t *numbers = json_array();
    for (int i = 0; i < 4 && element->at[i] >= 0; i++)
        json_array_append_new(numbers, json_integer(element->at[i]));
    return numbers;
}

static json_t *fault_json(const struct mesh_survey *survey, enum survey_kind kind)
{
    const struct survey_fault *fault = &survey->faults[kind];
    bool is_searched = kind != SURVEY_CROSSING || survey->crossings_were_searched;
    json_t *json =
        json_pack("{s:s, s:I, s:b}", "kind", survey_kind_slug(kind), "count",
                  (json_int_t)fault->count, "complete", is_searched && !survey->is_cut[kind]);
    json_t *elements = json_array();
    for (int32_t i = 0; i < fault->kept_count; i++)
        json_array_append_new(elements, element_json(&fault->kept[i]));
    json_object_set_new(json, "elements", elements);
    if (fault->kept_count > 0) {
        struct message message;
        survey_say(kind, &fault->kept[0], &message);
        json_object_set_new(json, "first", message_json(&message));
    }
    return json;
}

static json_t *faults_json(const struct mesh_survey *survey)
{
    json_t *faults = json_array();
    for (int kind = 0; kind < SURVEY_KINDS; kind++)
        json_array_append_new(faults, fault_json(survey, (enum survey_kind)kind));
    return faults;
}

static json_t *sizes_json(const struct mesh_report *report)
{
    json_t *sizes = json_array();
    for (int i = 0; i < report->size_count; i++) {
        const struct representation_size *size = &report->sizes[i];
        json_t *json =
            json_pack("{s:s, s:s, s:o}", "name", size->kind->name, "title", size->kind->title,
                      "bytes", size->bytes < 0 ? json_null() : json_integer(size->bytes));
        struct phrase obstacle = survey_obstacle(size->obstacle);
        if (size->bytes < 0)
            json_object_set_new(json, "cannot_hold",
                                json_pack("{s:s, s:s}", "en", obstacle.en, "es", obstacle.es));
        json_array_append_new(sizes, json);
    }
    return sizes;
}

static json_t *point_json(const float point[3])
{
    return json_pack("[f, f, f]", (double)point[0], (double)point[1], (double)point[2]);
}

static json_t *valence_json(const struct mesh_survey *survey)
{
    json_t *counts = json_array();
    for (int v = 0; v <= SURVEY_VALENCES; v++)
        json_array_append_new(counts, json_integer(survey->valence_counts[v]));
    return json_pack("{s:i, s:i, s:f, s:o}", "least", survey->least_valence, "most",
                     survey->most_valence, "mean", survey->mean_valence, "counts", counts);
}

/* The name as valid UTF-8. */
static json_t *name_json(const char *name)
{
    enum { NAME_LIMIT_BYTES = 4096 };
    char *clean = clean_text(name, strlen(name), CLEAN_LINE, NAME_LIMIT_BYTES);
    json_t *json = json_string(clean ? clean : "");
    free(clean);
    return json;
}

static void add_topology(json_t *json, const struct mesh_survey *survey)
{
    const struct topology *t = &survey->topology;
    json_object_update_new(json, json_pack("{s:I, s:I, s:I, s:I, s:I, s:I, s:I}", "vertices",
                                           (json_int_t)t->vertex_count, "edges",
                                           (json_int_t)t->edge_count, "triangles",
                                           (json_int_t)t->triangle_count, "euler",
                                           (json_int_t)t->euler_characteristic, "components",
                                           (json_int_t)t->component_count, "boundary_loops",
                                           (json_int_t)t->boundary_loop_count, "boundary_edges",
                                           (json_int_t)t->boundary.count));
    json_object_set_new(json, "genus",
                        survey->has_genus ? json_integer(survey->genus) : json_null());
    json_object_update_new(json, json_pack("{s:b, s:b, s:b, s:b}", "closed", survey->is_closed,
                                           "manifold", survey->is_manifold, "coherent",
                                           survey->is_coherent, "orientable", t->is_orientable));
}

static void add_measures(json_t *json, const struct mesh_survey *survey)
{
    bool has_box = survey->topology.vertex_count > 0;
    json_object_set_new(json, "area", json_real(survey->area));
    json_object_set_new(json, "volume",
                        survey->has_volume ? json_real(survey->volume) : json_null());
    json_object_set_new(json, "box",
                        has_box ? json_pack("{s:o, s:o}", "low", point_json(survey->box.low),
                                            "high", point_json(survey->box.high))
                                : json_null());
    json_object_set_new(json, "valence", valence_json(survey));
    json_object_set_new(json, "tolerance", json_real(survey->tolerance));
}

json_t *mesh_report_json(const struct mesh_report *report)
{
    json_t *json = json_object();
    json_object_set_new(json, "file", name_json(report->name));
    json_object_set_new(json, "clean", json_boolean(mesh_report_is_clean(report)));
    add_topology(json, &report->survey);
    add_measures(json, &report->survey);
    json_object_set_new(json, "notes", notes_json(&report->reading));
    json_object_set_new(json, "faults", faults_json(&report->survey));
    json_object_set_new(json, "representations", sizes_json(report));
    return json;
}
