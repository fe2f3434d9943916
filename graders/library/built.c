/* What a builder returns; see built.h. */
#include "graders/library/built.h"

#include "graders/scene/show.h"

#include <inttypes.h>

enum { TABLE_HEAD_BYTES = 24, OTHER_BYTES = 256 }; /* two counts of a table and its padding */

static const struct cause malformed = {"malformed-answer",
                                       {"incomplete answer", "respuesta incompleta"}};
static const struct cause unknown_status = {"unknown-status",
                                            {"unknown status", "estado desconocido"}};
static const struct cause table_missing = {"table-missing", {"table missing", "falta la tabla"}};

bool built_count_is_right(const struct built_count *count, const int64_t asked[2], int64_t said,
                          struct judgement *out)
{
    int64_t right = count->right(asked[0], asked[1]);
    if (said == right)
        return true;
    const struct formula_mistake *mistake = count->mistakes;
    while (mistake && mistake->cause.slug && mistake->value(asked[0], asked[1]) != said)
        mistake++;
    bool is_usual = mistake && mistake->cause.slug;
    judge_reject(out, is_usual ? &mistake->cause : &count->cause,
                 "%s is %" PRId64 "; it must be %" PRId64 ".",
                 "%s es %" PRId64 "; tiene que ser %" PRId64 ".", count->field, said, right);
    judge_hint(out, is_usual ? mistake->hint : count->rule);
    return false;
}

bool built_has_table(const char *field, const void *table, struct judgement *out)
{
    if (!table)
        judge_reject(out, &table_missing, "%s is NULL.", "%s es NULL.", field);
    return table;
}

bool built_is_complete(const struct reader *said, struct judgement *out)
{
    if (said->failed)
        judge_reject(out, &malformed, "The answer is incomplete.", "La respuesta está incompleta.");
    return !said->failed;
}

bool built_status(struct reader *said, struct judgement *out)
{
    int64_t status = read_int(said);
    if (!built_is_complete(said, out))
        return false;
    if (status != 0)
        judge_reject(out, &unknown_status,
                     "The builder returned %" PRId64 ", not 0 or OUT_OF_MEMORY.",
                     "El constructor ha devuelto %" PRId64 ", no 0 ni OUT_OF_MEMORY.", status);
    return status == 0;
}

bool built_mesh_read(struct reader *said, struct built_mesh *mesh, struct judgement *out)
{
    *mesh = (struct built_mesh){0};
    if (!built_status(said, out))
        return false;
    struct built_mesh read = {0};
    read.vertices = read_table(said, &read.vertex_count, 3 * sizeof *read.vertices);
    read.triangles = read_table(said, &read.triangle_count, 3 * sizeof *read.triangles);
    read.own_bytes = read_int(said);
    if (!built_is_complete(said, out))
        return false;
    *mesh = read;
    return true;
}

int built_mesh_show(const struct built_mesh *mesh, struct scene *scene, struct error *err)
{
    if (!mesh->vertices || mesh->vertex_count <= 0)
        return 0;
    return show_mesh(scene, mesh->vertices, mesh->vertex_count, mesh->triangles,
                     mesh->triangles ? mesh->triangle_count : 0, err);
}

size_t built_bound(int64_t right_bytes, int64_t table_count)
{
    return (size_t)(2 * right_bytes + TABLE_HEAD_BYTES * table_count + OTHER_BYTES);
}
