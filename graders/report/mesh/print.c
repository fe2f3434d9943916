/* A mesh on a terminal; see mesh_report.h. */
#include "graders/report/clean.h"
#include "graders/report/mesh/mesh_report.h"
#include "graders/report/terminal_text.h"

#include <stdlib.h>
#include <string.h>

static const char margin[] = "  ";

static void print_facts(FILE *to, const struct mesh_report *report, enum language language)
{
    struct mesh_fact facts[MESH_REPORT_FACTS];
    int count = mesh_report_facts(report, facts);
    for (int i = 0; i < count; i++) {
        fputs(margin, to);
        terminal_cell(to, phrase_text(facts[i].name, language), 11, false);
        terminal_line(to, "", message_text(&facts[i].text, language), TERMINAL_COLUMNS - 13);
    }
}

static void print_notes(FILE *to, const struct mesh_report *report,
                        const struct terminal_style *style)
{
    for (int kind = 0; kind < READING_KINDS; kind++) {
        struct message message;
        if (report->reading.notes[kind].count == 0)
            continue;
        reading_say(&report->reading, (enum reading_kind)kind, &message);
        bool is_fault = kind == READING_LOST_VERTEX || kind == READING_SHORT_FACE;
        terminal_colour(to, style, is_fault ? STANDING_FAILED : STANDING_PARTIAL);
        fputs(is_fault ? "✗ " : "! ", to);
        terminal_plain(to, style);
        terminal_paragraph(to, "", message_text(&message, style->language));
    }
}

static void print_faults(FILE *to, const struct mesh_report *report,
                         const struct terminal_style *style)
{
    for (int kind = 0; kind < SURVEY_KINDS; kind++) {
        const struct survey_fault *fault = &report->survey.faults[kind];
        struct message message;
        if (fault->count == 0)
            continue;
        mesh_report_say_fault(report, (enum survey_kind)kind, &message);
        terminal_colour(to, style, STANDING_FAILED);
        fputs("✗ ", to);
        terminal_plain(to, style);
        fprintf(to, "%s\n", message_text(&message, style->language));
        survey_say((enum survey_kind)kind, &fault->kept[0], &message);
        terminal_paragraph(to, "    ", message_text(&message, style->language));
    }
}

static void print_unsearched(FILE *to, const struct mesh_report *report, enum language language)
{
    static const struct phrase unsearched = {"Self-intersections were not searched.",
                                             "No se buscaron autointersecciones."};
    static const struct phrase cut = {"Not searched to the end, too many pairs lie close: ",
                                      "Sin buscar hasta el final, hay demasiados pares cercanos: "};
    if (!report->survey.crossings_were_searched)
        fprintf(to, "! %s\n", phrase_text(unsearched, language));
    for (int kind = 0; kind < SURVEY_KINDS; kind++)
        if (report->survey.is_cut[kind])
            fprintf(to, "! %s%s.\n", phrase_text(cut, language),
                    phrase_text(survey_kind_name((enum survey_kind)kind, true), language));
}

static void print_sizes(FILE *to, const struct mesh_report *report, enum language language)
{
    static const struct phrase title = {"bytes in each representation, and per triangle",
                                        "bytes en cada representación, y por triángulo"};
    static const struct phrase cannot = {"cannot hold ", "no admite "};
    double triangles = (double)report->mesh.triangle_count;
    fprintf(to, "%s%s\n", margin, phrase_text(title, language));
    for (int i = 0; i < report->size_count; i++) {
        const struct representation_size *size = &report->sizes[i];
        fputs("    ", to);
        terminal_cell(to, size->kind->title, 26, false);
        if (size->bytes < 0)
            fprintf(to, "%14s  %s%s\n", "-", phrase_text(cannot, language),
                    phrase_text(survey_obstacle(size->obstacle), language));
        else if (triangles > 0)
            fprintf(to, "%14lld %8.1f\n", (long long)size->bytes, (double)size->bytes / triangles);
        else
            fprintf(to, "%14lld\n", (long long)size->bytes);
    }
}

static void print_name(FILE *to, const char *name)
{
    char *clean = clean_text(name, strlen(name), CLEAN_LINE, TERMINAL_COLUMNS);
    fprintf(to, "%s\n", clean ? clean : "");
    free(clean);
}

void mesh_report_print(FILE *to, const struct mesh_report *report,
                       const struct terminal_style *style)
{
    static const struct phrase clean = {"clean: nothing is wrong", "limpia: no hay nada mal"};
    print_name(to, report->name);
    print_facts(to, report, style->language);
    if (mesh_report_is_clean(report)) {
        terminal_colour(to, style, STANDING_PASSED);
        fputs("✓ ", to);
        terminal_plain(to, style);
        fprintf(to, "%s\n", phrase_text(clean, style->language));
    }
    print_faults(to, report, style);
    print_notes(to, report, style);
    print_unsearched(to, report, style->language);
    print_sizes(to, report, style->language);
}
