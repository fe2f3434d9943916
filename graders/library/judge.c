/* Inputs and answers by their declaration; see judge.h. */
#include "graders/library/judge.h"

#include "graders/library/questions.h"

#include <string.h>

enum { VERTEX_BYTES = 12 };

int judge_family_count(const struct judge *judge)
{
    int count = 0;
    while (judge->families && judge->families[count].name)
        count++;
    return count;
}

const char *judge_family_name(const struct judge *judge, int family)
{
    return judge->families[family].name;
}

/* ------------------------------------------------------------------------------------- inputs */

static bool takes_polygons(const struct judge *judge)
{
    return judge->input == INPUT_POLYGONS;
}

static int mesh_file_write(const struct judge *judge, const struct judge_case *c,
                           const char *models, struct writer *input, struct error *err)
{
    /* Vast numbers: 200 MB of positions that no function of INPUT_TOPOLOGY reads are left out. */
    bool vast = judge->input == INPUT_TOPOLOGY && (c->mesh.changes & VAST_NUMBERS);
    struct mesh mesh;
    if (recipe_make(&c->mesh, c->seed, models, &mesh, err) != 0)
        return -1;
    int failed = judge->input == INPUT_SOUP ? soup_input_write(&mesh, input, err)
                                            : mesh_input_write(&mesh, !vast, input, err);
    mesh_release(&mesh);
    return failed;
}

static int write_polygons(const struct judge_case *c, const char *models, struct writer *input,
                          struct error *err)
{
    struct polygon_mesh mesh;
    if (polygon_mesh_make(&c->mesh, c->seed, models, &mesh, err) != 0)
        return -1;
    int failed = polygon_mesh_write(&mesh, input, err);
    polygon_mesh_release(&mesh);
    return failed;
}

static int write_input(const struct judge *judge, const struct judge_case *c, const char *models,
                       struct writer *input, struct error *err)
{
    switch (judge->input) {
    case INPUT_OWN:
        return judge->make(c, models, input, err);
    case INPUT_QUESTION:
        return question_write(c->ask, c->number, input, err);
    case INPUT_POLYGONS:
        return write_polygons(c, models, input, err);
    case INPUT_LINE:
        return line_write(&c->line, c->seed, input, err);
    case INPUT_FIELD:
        return field_write(&c->field, c->seed, input, err);
    case INPUT_MESH:
    case INPUT_TOPOLOGY:
    case INPUT_SOUP:
        break;
    }
    return mesh_file_write(judge, c, models, input, err);
}

/* Whether more follows behind the numbers: attributes, and what the judge writes beside. */
static bool has_more(const struct judge *judge)
{
    return judge->write_beside || judge->attributes[0].of != PER_NOTHING;
}

/* A runner reads as many numbers as there are, and four when more follows. */
static int number_count(const struct judge *judge)
{
    return has_more(judge) ? 4 : judge->numbers;
}

static int write_numbers(const struct judge *judge, const int64_t number[4], struct writer *input,
                         struct error *err)
{
    for (int i = 0; i < number_count(judge); i++)
        write_int(input, number[i]);
    return input->failed ? error_set(err, "out of memory for an input") : 0;
}

/* Reads what judge_make and judge_make_sized write. */
static struct task read_input(const struct judge *judge, struct span input)
{
    struct task task = {.judge = judge, .input = input};
    struct reader reader = reader_of(input.bytes, input.count);
    switch (judge->input) {
    case INPUT_OWN:
    case INPUT_QUESTION:
        return task;
    case INPUT_POLYGONS:
        task.polygons = polygon_view_read(&reader);
        task.sizes = (struct input_sizes){task.polygons.vertex_count, task.polygons.face_count,
                                          polygon_view_corner_count(&task.polygons)};
        break;
    case INPUT_SOUP:
        task.soup = soup_input_read(&reader);
        task.sizes =
            (struct input_sizes){3 * (int64_t)task.soup.triangle_count, task.soup.triangle_count,
                                 3 * (int64_t)task.soup.triangle_count};
        break;
    case INPUT_LINE:
        task.line = line_read(&reader);
        task.sizes = (struct input_sizes){task.line.point_count, 0, task.line.point_count};
        break;
    case INPUT_FIELD:
        task.field = field_read(&reader);
        task.sizes = (struct input_sizes){task.field.sample_count, 0, 0};
        break;
    case INPUT_MESH:
    case INPUT_TOPOLOGY:
        task.mesh = mesh_input_read(&reader);
        task.sizes = (struct input_sizes){task.mesh.vertex_count, task.mesh.triangle_count,
                                          3 * (int64_t)task.mesh.triangle_count};
        break;
    }
    for (int i = 0; i < number_count(judge); i++)
        task.number[i] = read_int(&reader);
    if (has_more(judge) && reader.at < reader.count)
        attributes_read(&reader, task.attribute);
    task.beside = reader;
    return task;
}

/* Writes what is given behind the input and the numbers that `input` holds so far. */
static int write_more(const struct judge *judge, uint64_t seed, struct writer *input,
                      struct error *err)
{
    if (!has_more(judge))
        return 0;
    struct writer more = writer_growing(); /* `input` may move when it grows */
    struct task task = read_input(judge, (struct span){input->bytes, input->count});
    int failed = attributes_write(judge->attributes, task.sizes, seed, &more, err);
    if (!failed && judge->write_beside)
        failed = judge->write_beside(&task, seed, &more, err);
    if (!failed)
        write_array(input, more.bytes, (int64_t)more.count, 1);
    if (!failed && (more.failed || input->failed))
        failed = error_set(err, "out of memory for an input");
    writer_release(&more);
    return failed;
}

int judge_make(const struct judge *judge, const struct judge_case *c, const char *models,
               struct writer *input, struct error *err)
{
    if (write_input(judge, c, models, input, err) != 0)
        return -1;
    if (write_numbers(judge, c->number, input, err) != 0)
        return -1;
    return write_more(judge, c->seed, input, err);
}

/* A size of a family that is made of triangles or polygons. */
static int write_sized(const struct judge *judge, const struct size_family *family, int64_t size,
                       uint64_t seed, struct writer *input, struct error *err)
{
    struct polygon_mesh polygons;
    struct mesh mesh;
    int failed;
    if (takes_polygons(judge)) {
        if (polygon_mesh_make_sized(family, size, seed, &polygons, err) != 0)
            return -1;
        failed = polygon_mesh_write(&polygons, input, err);
        polygon_mesh_release(&polygons);
        return failed;
    }
    if (family_make(family, size, seed, &mesh, err) != 0)
        return -1;
    failed = judge->input == INPUT_SOUP ? soup_input_write(&mesh, input, err)
                                        : mesh_input_write(&mesh, true, input, err);
    mesh_release(&mesh);
    return failed;
}

int64_t judge_size_near(const struct judge *judge, int family, int64_t size)
{
    return judge->size_near ? judge->size_near(family, size) : size;
}

int judge_make_sized(const struct judge *judge, int family, int64_t size, uint64_t seed,
                     struct writer *input, struct error *err)
{
    static const int64_t none[4] = {0};
    const struct size_family *shape = &judge->families[family];
    if (shape->shape == FAMILY_OWN)
        return judge->make_sized(family, size, seed, input, err);
    if (write_sized(judge, shape, size, seed, input, err) != 0)
        return -1;
    if (write_numbers(judge, shape->has_number ? shape->number : none, input, err) != 0)
        return -1;
    return write_more(judge, seed, input, err);
}

size_t judge_answer_bound(const struct judge *judge, struct span input)
{
    if (judge->input == INPUT_QUESTION)
        return question_answer_bound(judge, input);
    if (!judge->answer)
        return judge->bound(input);
    struct task task = read_input(judge, input);
    return answer_bound(judge->answer, task.sizes);
}

size_t judge_input_weight(const struct judge *judge, struct span input)
{
    size_t vertices = VERTEX_BYTES * (size_t)read_input(judge, input).sizes.vertices;
    return vertices > input.count ? vertices : input.count;
}

/* ------------------------------------------------------------------------------------ answers */

int task_show(const struct task *task, struct judgement *out, struct error *err)
{
    if (takes_polygons(task->judge))
        return polygon_view_show(&task->polygons, &out->scene, err);
    return mesh_input_show(&task->mesh, &out->scene, err);
}

/* A rejection shows at least the input. */
static int show_something(const struct task *task, struct judgement *out, struct error *err)
{
    bool has_mesh = takes_polygons(task->judge) || task->mesh.triangles;
    if (out->accepted || out->scene.kind != SCENE_NONE || !has_mesh)
        return 0;
    out->scene.ok_count = -1;
    return task_show(task, out, err);
}

/* Whether the answer is right. */
static int judge_task(struct task *task, struct judgement *out, struct error *err)
{
    const struct judge *judge = task->judge;
    if (judge->input == INPUT_QUESTION)
        return question_judge(task, out, err);
    if (judge->answer && !answer_read(judge->answer, task->sizes, task->said, &task->answer, out))
        return 0;
    return judge->judge(task, out, err);
}

int judge_case_answer(const struct judge *judge, const struct judge_case *c, struct span input,
                      struct span answer, const struct usage *usage, struct judgement *out,
                      struct error *err)
{
    struct task task = read_input(judge, input);
    task.said = answer;
    task.usage = usage;
    if (judge_task(&task, out, err) != 0 ||
        quality_judge(&judge->quality, c ? c->class_name : NULL, out, err) != 0)
        return -1;
    return show_something(&task, out, err);
}

int judge_answer(const struct judge *judge, struct span input, struct span answer,
                 const struct usage *usage, struct judgement *out, struct error *err)
{
    return judge_case_answer(judge, NULL, input, answer, usage, out, err);
}
