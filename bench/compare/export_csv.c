/* The rows and the accesses of bench.json as CSV; see document.h. */
#include "bench/compare/document.h"

#include <string.h>

/* Column, and where in a row its value stands. */
static const struct {
    const char *name, *key, *inner;
} columns[] = {{"what", "what", NULL},
               {"kind", "kind", NULL},
               {"subject", "subject", NULL},
               {"variant", "variant", NULL},
               {"threads", "threads", NULL},
               {"operation", "operation", NULL},
               {"mesh", "mesh", NULL},
               {"mesh_kind", "mesh_kind", NULL},
               {"order", "order", NULL},
               {"triangles", "triangles", NULL},
               {"vertices", "vertices", NULL},
               {"ns_per_triangle", "ns_per_triangle", "median"},
               {"ns_per_triangle_low", "ns_per_triangle", "low"},
               {"ns_per_triangle_high", "ns_per_triangle", "high"},
               {"ns_per_triangle_least", "ns_per_triangle", "least"},
               {"cold_ns_per_triangle", "cold_ns_per_triangle", "median"},
               {"ns_per_query", "ns_per_query", "median"},
               {"ratio_to", "ratio", "to"},
               {"ratio", "ratio", "median"},
               {"ratio_low", "ratio", "low"},
               {"ratio_high", "ratio", "high"},
               {"ratio_confidence", "ratio", "confidence"},
               {"cold_ratio", "cold_ratio", "median"},
               {"cold_ratio_low", "cold_ratio", "low"},
               {"cold_ratio_high", "cold_ratio", "high"},
               {"cold_ratio_confidence", "cold_ratio", "confidence"},
               {"blocks", "blocks", NULL},
               {"samples", "samples", NULL},
               {"dropped", "dropped", NULL},
               {"instructions", "counts", "instructions"},
               {"l1_misses", "counts", "l1_misses"},
               {"ll_misses", "counts", "ll_misses"},
               {"allocations", "counts", "allocations"},
               {"peak_bytes", "counts", "peak_bytes"},
               {"bytes_per_triangle_formula", "bytes_per_triangle", "formula"},
               {"bytes_per_triangle", "bytes_per_triangle", "measured"},
               {"limit_fraction", "limit", "fraction"},
               {"answer", "answer", NULL},
               {"error", "error", NULL}};
enum { COLUMN_COUNT = sizeof columns / sizeof *columns };

/* Text in quotes where it needs them, quotes doubled. */
static void write_text(FILE *to, const char *text)
{
    if (!text[strcspn(text, ",\"\r\n")]) {
        fputs(text, to);
        return;
    }
    fputc('"', to);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', to);
        fputc(*text, to);
    }
    fputc('"', to);
}

static void write_value(FILE *to, const json_t *value)
{
    if (json_is_string(value))
        write_text(to, json_string_value(value));
    else if (json_is_integer(value))
        fprintf(to, "%lld", (long long)json_integer_value(value));
    else if (json_is_real(value))
        fprintf(to, "%.6g", json_real_value(value));
}

void bench_document_csv(const json_t *document, FILE *to)
{
    size_t i;
    const json_t *row;
    for (int k = 0; k < COLUMN_COUNT; k++)
        fprintf(to, "%s%s", k ? "," : "", columns[k].name);
    fputs("\r\n", to);
    json_array_foreach(json_object_get(document, "rows"), i, row)
    {
        for (int k = 0; k < COLUMN_COUNT; k++) {
            const json_t *value = json_object_get(row, columns[k].key);
            if (k)
                fputc(',', to);
            write_value(to, columns[k].inner ? json_object_get(value, columns[k].inner) : value);
        }
        fputs("\r\n", to);
    }
}

void bench_accesses_csv(const json_t *document, FILE *to)
{
    static const char *const texts[] = {"subject", "query", "claim", "growth"};
    size_t i, k;
    const json_t *row, *at;
    fputs("subject,query,claim,growth,holds,triangles,valence,accesses\r\n", to);
    json_array_foreach(json_object_get(document, "accesses"), i, row)
    {
        for (int by_valence = 0; by_valence < 2; by_valence++)
            json_array_foreach(json_object_get(row, by_valence ? "by_valence" : "by_size"), k, at)
            {
                for (size_t t = 0; t < sizeof texts / sizeof *texts; t++) {
                    write_value(to, json_object_get(row, texts[t]));
                    fputc(',', to);
                }
                fputs(json_is_true(json_object_get(row, "holds")) ? "true," : "false,", to);
                write_value(to, json_object_get(at, "triangles"));
                fputc(',', to);
                write_value(to, json_object_get(at, "valence"));
                fputc(',', to);
                write_value(to, json_object_get(at, "accesses"));
                fputs("\r\n", to);
            }
    }
}
