/* What a mesh is, in words; see mesh_report.h. */
#include "graders/report/mesh/mesh_report.h"

#include <stdio.h>

int mesh_report_make(struct mesh_report *report, const struct survey_wish *wish, struct error *err)
{
    if (mesh_survey_make(&report->survey, &report->mesh, wish, err))
        return -1;
    report->size_count = survey_sizes(&report->mesh, &report->survey.topology, report->sizes, err);
    return report->size_count < 0 ? -1 : 0;
}

void mesh_report_release(struct mesh_report *report)
{
    mesh_survey_release(&report->survey);
    mesh_release(&report->mesh);
    *report = (struct mesh_report){0};
}

bool mesh_report_is_clean(const struct mesh_report *report)
{
    const struct reading_note *notes = report->reading.notes;
    return mesh_survey_fault_count(&report->survey) == 0 && notes[READING_LOST_VERTEX].count == 0 &&
           notes[READING_SHORT_FACE].count == 0;
}

void mesh_report_say_fault(const struct mesh_report *report, enum survey_kind kind,
                           struct message *message)
{
    long long count = (long long)report->survey.faults[kind].count;
    bool is_cut = report->survey.is_cut[kind];
    struct phrase name = survey_kind_name(kind, count != 1);
    message_clear(message);
    message_en(message, "%s%lld %s", is_cut ? "at least " : "", count, name.en);
    message_es(message, "%s%lld %s", is_cut ? "al menos " : "", count, name.es);
}

/* -- facts ------------------------------------------------------------------------------------ */

static struct message *add_fact(struct mesh_fact *facts, int *count, const char *en, const char *es)
{
    struct mesh_fact *fact = &facts[(*count)++];
    fact->name = (struct phrase){en, es};
    message_clear(&fact->text);
    return &fact->text;
}

/* "3 components", "1 componente". */
static void add_count(struct message *text, long long count, struct phrase one, struct phrase many)
{
    message_en(text, "%lld %s", count, count == 1 ? one.en : many.en);
    message_es(text, "%lld %s", count, count == 1 ? one.es : many.es);
}

static void say_counts(const struct topology *t, struct message *text)
{
    add_count(text, t->vertex_count, (struct phrase){"vertex", "vértice"},
              (struct phrase){"vertices", "vértices"});
    message_add(text, ", ", ", ");
    add_count(text, t->edge_count, (struct phrase){"edge", "arista"},
              (struct phrase){"edges", "aristas"});
    message_add(text, ", ", ", ");
    add_count(text, t->triangle_count, (struct phrase){"triangle", "triángulo"},
              (struct phrase){"triangles", "triángulos"});
}

static void say_topology(const struct mesh_survey *survey, struct message *text)
{
    const struct topology *t = &survey->topology;
    add_count(text, t->component_count, (struct phrase){"component", "componente"},
              (struct phrase){"components", "componentes"});
    message_add(text, ", ", ", ");
    add_count(text, t->boundary_loop_count, (struct phrase){"boundary loop", "bucle de borde"},
              (struct phrase){"boundary loops", "bucles de borde"});
    message_add(text, ", V - E + F = %lld", ", V - A + C = %lld",
                (long long)t->euler_characteristic);
    if (survey->has_genus)
        message_add(text, ", genus %lld", ", género %lld", (long long)survey->genus);
}

static void say_shape(const struct mesh_survey *survey, struct message *text)
{
    const struct topology *t = &survey->topology;
    message_say(text, survey->is_closed ? "closed" : "open",
                survey->is_closed ? "cerrada" : "abierta");
    message_add(text, survey->is_manifold ? ", manifold" : ", not manifold",
                survey->is_manifold ? ", variedad" : ", no variedad");
    if (!t->is_orientable)
        message_add(text, ", not orientable", ", no orientable");
    else if (survey->is_coherent)
        message_add(text, ", coherently oriented", ", orientada con coherencia");
    else
        message_add(text, ", not coherently oriented (it can be)",
                    ", orientada sin coherencia (puede serlo)");
    if (survey->has_volume && survey->volume < 0)
        message_add(text, ", facing inwards", ", mirando hacia dentro");
}

static void say_box(const struct bounds *box, struct message *text)
{
    double size[3];
    for (int i = 0; i < 3; i++)
        size[i] = (double)box->high[i] - (double)box->low[i];
    message_say(text, "%.4g x %.4g x %.4g, from (%.4g, %.4g, %.4g)",
                "%.4g x %.4g x %.4g, desde (%.4g, %.4g, %.4g)", size[0], size[1], size[2],
                (double)box->low[0], (double)box->low[1], (double)box->low[2]);
}

static void say_size(const struct mesh_survey *survey, struct message *text)
{
    message_say(text, "%.6g", "%.6g", survey->area);
    if (survey->has_volume)
        message_add(text, ", volume %.6g", ", volumen %.6g", survey->volume);
    else
        message_add(text, ", no volume: it is not a closed, coherent manifold",
                    ", sin volumen: no es una variedad cerrada y coherente");
}

/* "3 to 12, mean 5.93, most often 6 (62 %)" */
static void say_valence(const struct mesh_survey *survey, struct message *text)
{
    int64_t used = 0;
    int usual = 0;
    for (int v = 0; v <= SURVEY_VALENCES; v++) {
        used += survey->valence_counts[v];
        if (survey->valence_counts[v] > survey->valence_counts[usual])
            usual = v;
    }
    message_say(text, "%d to %d, mean %.4g", "de %d a %d, media %.4g", survey->least_valence,
                survey->most_valence, survey->mean_valence);
    if (usual > 0 && usual < SURVEY_VALENCES) {
        double share = 100 * (double)survey->valence_counts[usual] / (double)used;
        message_add(text, ", most often %d (%.3g %%)", ", lo más frecuente %d (%.3g %%)", usual,
                    share);
    }
}

int mesh_report_facts(const struct mesh_report *report, struct mesh_fact facts[MESH_REPORT_FACTS])
{
    const struct mesh_survey *survey = &report->survey;
    int count = 0;
    say_counts(&survey->topology, add_fact(facts, &count, "size", "tamaño"));
    say_topology(survey, add_fact(facts, &count, "topology", "topología"));
    if (survey->topology.triangle_count > 0)
        say_shape(survey, add_fact(facts, &count, "surface", "superficie"));
    if (survey->topology.vertex_count > 0)
        say_box(&survey->box, add_fact(facts, &count, "box", "caja"));
    if (survey->topology.triangle_count > 0)
        say_size(survey, add_fact(facts, &count, "area", "área"));
    if (survey->topology.edge_count > 0)
        say_valence(survey, add_fact(facts, &count, "valence", "valencia"));
    return count;
}
