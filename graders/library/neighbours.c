/* Judging what a query for neighbours lists; see neighbours.h. */
#include "graders/library/neighbours.h"

#include "graders/library/cycles.h"
#include "graders/library/tuples.h"
#include "reference/representation/winged_edge_queries.h"

#include <inttypes.h>
#include <stdlib.h>

static const struct phrase nouns[] = {{"face", "cara"}, {"vertex", "vértice"}, {"edge", "arista"}};
static const struct phrase definite[] = {
    {"face", "la cara"}, {"vertex", "el vértice"}, {"edge", "la arista"}};

static int32_t vertices_of_vertex(const struct winged_edge_mesh *we, int32_t vertex, int32_t *out,
                                  int32_t capacity)
{
    int32_t count = winged_edge_edges_of_vertex(we, vertex, out, capacity);
    for (int32_t i = 0; i < count && i < capacity; i++)
        out[i] = we->edges[out[i]].vertex[we->edges[out[i]].vertex[0] == vertex];
    return count;
}

const struct neighbour_query neighbour_queries[NEIGHBOUR_KINDS] = {
    {"edges_of_face", AT_FACE, AT_EDGE, 4, winged_edge_edges_of_face},
    {"vertices_of_face", AT_FACE, AT_VERTEX, 2, winged_edge_vertices_of_face},
    {"faces_of_face", AT_FACE, AT_FACE, 2, winged_edge_faces_of_face},
    {"edges_of_vertex", AT_VERTEX, AT_EDGE, 4, winged_edge_edges_of_vertex},
    {"faces_of_vertex", AT_VERTEX, AT_FACE, 2, winged_edge_faces_of_vertex},
    {"vertices_of_vertex", AT_VERTEX, AT_VERTEX, 2, vertices_of_vertex},
    {"edges_of_edge", AT_EDGE, AT_EDGE, 4, winged_edge_edges_of_edge}};

static const struct cause impossible_count = {"impossible-count",
                                              {"impossible count", "número imposible"}};
static const struct cause no_element = {"no-such-element",
                                        {"no such element", "elemento inexistente"}};
static const struct cause itself = {"lists-itself", {"lists itself", "se incluye a sí mismo"}};
static const struct cause wrong_element = {"wrong-element",
                                           {"wrong element", "elemento incorrecto"}};
static const struct cause repeated = {"listed-twice", {"listed twice", "aparece dos veces"}};
static const struct cause missing = {"neighbour-missing", {"neighbour missing", "falta un vecino"}};
static const struct cause clockwise = {"clockwise", {"clockwise", "en sentido horario"}};
static const struct cause wrong_order = {"wrong-order", {"wrong order", "orden incorrecto"}};
static const struct phrase asked_for = {"asked for", "elemento de la consulta"};
static const struct phrase rightly_listed = {"rightly listed", "bien incluido"};
static const enum mark_kind of_asked = MARK_TURN_0;
static const enum mark_kind of_listed = (enum mark_kind)(MARK_TURN_0 + 1);

/* ------------------------------------------------------------------------------------ showing */

/* What was answered, and what is right. */
struct reply {
    const struct neighbour_asked *asked;
    const struct winged_edge_mesh *we;
    const struct neighbour_query *query;
    const int32_t *got, *right;
    int32_t got_count, right_count;
};

static void mark(const struct reply *reply, struct scene *scene, enum mark_kind kind,
                 enum neighbour_element element, int32_t number)
{
    const struct winged_edge_mesh *we = reply->we;
    const int32_t counts[] = {we->face_count, we->vertex_count, we->edge_count};
    if (number < 0 || number >= counts[element])
        return;
    if (element == AT_VERTEX) {
        scene_mark_vertex(scene, kind, number);
        scene_label_vertex(scene, number, number);
    } else if (element == AT_EDGE) {
        const int32_t *ends = we->edges[number].vertex;
        scene_mark_edge(scene, kind, ends[0], ends[1]);
        scene_label_edge(scene, ends[0], ends[1], number);
    } else {
        int32_t count;
        const int32_t *corners = polygon_view_face(reply->asked->faces, number, &count);
        scene_mark_face(scene, kind, corners, count);
        scene_label_face(scene, corners, count, number);
    }
}

static bool is_among(int32_t number, const int32_t *list, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        if (list[i] == number)
            return true;
    return false;
}

enum { NONE = -1 };

/* What the verdict names is marked by now: the element that is asked for, and what else is listed
 * rightly. */
static void show_rest(const struct reply *reply, int32_t named, struct scene *scene)
{
    const struct neighbour_query *query = reply->query;
    mark(reply, scene, of_asked, query->of, reply->asked->element);
    for (int32_t i = 0; i < reply->got_count; i++)
        if (reply->got[i] != named && is_among(reply->got[i], reply->right, reply->right_count))
            mark(reply, scene, of_listed, query->finds, reply->got[i]);
    scene_name_marks(scene, of_asked, asked_for);
    scene_name_marks(scene, of_listed, rightly_listed);
}

/* ------------------------------------------------------------------------------------- judging */

enum { SHOWN_MOST = 12 };

/* " Right is 3 1 2." or, where they are many, nothing. */
static void say_right(const struct reply *reply, struct judgement *out)
{
    if (reply->right_count > SHOWN_MOST)
        return;
    judge_en(out, " Right is");
    judge_es(out, " Lo correcto es");
    for (int32_t i = 0; i < reply->right_count; i++) {
        judge_en(out, " %d", reply->right[i]);
        judge_es(out, " %d", reply->right[i]);
    }
    judge_en(out, ".");
    judge_es(out, ".");
}

/* Begins a sentence: "edges_of_face(3) ". */
static void begin(const struct reply *reply, const struct cause *cause, struct judgement *out)
{
    const char *function = reply->query->function;
    judge_name_one(out, nouns[reply->query->of], "%d", reply->asked->element);
    judge_reject_for(out, cause);
    judge_en(out, "%s(%d) ", function, reply->asked->element);
    judge_es(out, "%s(%d) ", function, reply->asked->element);
}

static void reject_count(const struct reply *reply, struct judgement *out)
{
    begin(reply, &impossible_count, out);
    judge_en(out, "returned %d, but there are %d.", reply->asked->returned, reply->right_count);
    judge_es(out, "ha devuelto %d, pero hay %d.", reply->asked->returned, reply->right_count);
    show_rest(reply, NONE, &out->scene);
}

/* Something that is listed is no neighbour. */
static void reject_extra(const struct reply *reply, int32_t found, struct judgement *out)
{
    const struct neighbour_query *query = reply->query;
    const struct winged_edge_mesh *we = reply->we;
    const int32_t counts[] = {we->face_count, we->vertex_count, we->edge_count};
    struct phrase noun = definite[query->finds];
    bool exists = found >= 0 && found < counts[query->finds];
    bool is_itself = query->of == query->finds && found == reply->asked->element;
    begin(reply, !exists ? &no_element : is_itself ? &itself : &wrong_element, out);
    judge_en(out, "lists %s %d, ", noun.en, found);
    judge_es(out, "incluye %s %d, ", noun.es, found);
    if (!exists) {
        judge_en(out, "which does not exist: the last one is %d.", counts[query->finds] - 1);
        judge_es(out, "que no existe: el último número es %d.", counts[query->finds] - 1);
    } else if (is_itself) {
        judge_en(out, "which is the one that was asked for.");
        judge_es(out, "que es el propio elemento de la consulta.");
    } else {
        judge_en(out, "which is not one of them.");
        judge_es(out, "que no corresponde.");
    }
    say_right(reply, out);
    mark(reply, &out->scene, MARK_EXTRA, query->finds, found);
    show_rest(reply, found, &out->scene);
}

static void reject_repeated(const struct reply *reply, const struct set_fault *fault,
                            struct judgement *out)
{
    static const struct phrase closes = {"Is the first one listed again at the end?",
                                         "¿Se repite al final el primero?"};
    const struct neighbour_query *query = reply->query;
    int32_t found = reply->got[fault->repeated];
    begin(reply, &repeated, out);
    judge_en(out, "lists %s %d more than once.", definite[query->finds].en, found);
    judge_es(out, "incluye %s %d más de una vez.", definite[query->finds].es, found);
    if (fault->repeated_count == 1 && fault->repeated_of == 0 &&
        fault->repeated == reply->got_count - 1)
        judge_hint(out, closes);
    mark(reply, &out->scene, MARK_DUPLICATE, query->finds, found);
    show_rest(reply, found, &out->scene);
}

/* Whether all edges that an answer of edges_of_edge lacks are at one end of the edge. */
static bool lacks_one_end(const struct reply *reply, const struct set_fault *fault)
{
    const struct winged_edge *edges = reply->we->edges, *asked = &edges[reply->asked->element];
    for (int end = 0; reply->query->of == AT_EDGE && end < 2; end++) {
        bool fits = true;
        for (int32_t i = 0; i < reply->right_count; i++) {
            const int32_t *ends = edges[reply->right[i]].vertex;
            bool at_end = ends[0] == asked->vertex[end] || ends[1] == asked->vertex[end];
            fits &= at_end == (fault->right_marks[i] == SET_MISSING);
        }
        if (fits)
            return true;
    }
    return false;
}

static void reject_missing(const struct reply *reply, const struct set_fault *fault,
                           struct judgement *out)
{
    static const struct phrase one_end = {
        "All edges at one end of it are missing, and none else: it has two ends.",
        "Faltan todas las de uno de sus extremos, y ninguna otra: tiene dos extremos."};
    const struct neighbour_query *query = reply->query;
    int32_t wanted = reply->right[fault->missing];
    begin(reply, &missing, out);
    judge_en(out, "does not list %s %d (missing: %" PRId64 " of %d).", definite[query->finds].en,
             wanted, fault->missing_count, reply->right_count);
    judge_es(out, "no incluye %s %d (faltan: %" PRId64 " de %d).", definite[query->finds].es,
             wanted, fault->missing_count, reply->right_count);
    if (lacks_one_end(reply, fault))
        judge_hint(out, one_end);
    for (int32_t i = 0; i < reply->right_count; i++)
        if (fault->right_marks[i] == SET_MISSING)
            mark(reply, &out->scene, MARK_MISSING, query->finds, reply->right[i]);
    show_rest(reply, NONE, &out->scene);
}

/* The right ones, but in another order than around the face. */
static void reject_order(const struct reply *reply, const struct cycle_fault *fault,
                         struct judgement *out)
{
    const struct neighbour_query *query = reply->query;
    bool reversed = fault->set.reversed >= 0;
    begin(reply, reversed ? &clockwise : &wrong_order, out);
    if (reversed) {
        int32_t count;
        const int32_t *corners =
            polygon_view_face(reply->asked->faces, reply->asked->element, &count);
        for (int32_t i = 0; i < count; i++)
            scene_mark_arrow(&out->scene, MARK_WRONG, corners[(i + 1) % count], corners[i]);
        judge_en(out, "lists the right ones clockwise; faces are run counter-clockwise.");
        judge_es(out,
                 "da los correctos en sentido horario; las caras se recorren en el contrario.");
    } else {
        struct message step;
        message_clear(&step);
        cycle_step_say(&fault->step, &step);
        judge_en(out, "lists the right ones, but not in their order around the face. %s", step.en);
        judge_es(out, "da los correctos, pero no en su orden alrededor de la cara. %s", step.es);
        mark(reply, &out->scene, MARK_WRONG, query->finds, fault->step.found);
        mark(reply, &out->scene, MARK_RIGHT, query->finds, fault->step.wanted);
    }
    show_rest(reply, reversed ? NONE : fault->step.found, &out->scene);
}

static int judge_order(const struct reply *reply, struct judgement *out, struct error *err)
{
    const int32_t first[] = {0, reply->got_count};
    const struct cycle_rows got = {first, reply->got, 1, reply->got_count};
    const struct cycle_rows right = {first, reply->right, 1, reply->right_count};
    struct cycle_fault fault;
    if (cycles_compare(&got, &right, &fault, err))
        return -1;
    if (set_fault_found(&fault.set))
        reject_order(reply, &fault, out);
    cycle_fault_release(&fault);
    return 0;
}

static int judge_reply(const struct reply *reply, struct judgement *out, struct error *err)
{
    struct set_fault fault;
    if (reply->asked->returned < 0 || reply->asked->returned > reply->asked->capacity) {
        reject_count(reply, out);
        return 0;
    }
    if (tuples_compare(reply->got, reply->got_count, reply->right, reply->right_count, 1,
                       TUPLES_EXACT, &fault, err))
        return -1;
    int failed = 0;
    if (fault.extra >= 0)
        reject_extra(reply, reply->got[fault.extra], out);
    else if (fault.repeated >= 0)
        reject_repeated(reply, &fault, out);
    else if (fault.missing >= 0)
        reject_missing(reply, &fault, out);
    else if (reply->query->of == AT_FACE)
        failed = judge_order(reply, out, err);
    set_fault_release(&fault);
    return failed;
}

int neighbours_build(const struct polygon_view *faces, struct winged_edge_mesh *we,
                     struct error *err)
{
    const struct polygons polygons = {faces->corners, faces->first_corner, faces->vertex_count,
                                      faces->face_count};
    return winged_edge_build(we, &polygons, faces->positions, err);
}

int32_t neighbours_count(const struct winged_edge_mesh *we, int kind, int32_t element)
{
    return neighbour_queries[kind].right(we, element, NULL, 0);
}

int64_t neighbours_least_accesses(const struct winged_edge_mesh *we, int kind, int32_t element)
{
    int shows = neighbour_queries[kind].shows;
    return (neighbours_count(we, kind, element) + shows - 1) / shows;
}

int neighbours_judge(const struct neighbour_asked *asked, struct judgement *out, struct error *err)
{
    const struct neighbour_query *query = &neighbour_queries[asked->kind];
    int32_t count = neighbours_count(asked->we, asked->kind, asked->element);
    int32_t *right = malloc(sizeof *right * ((size_t)count + 1));
    if (!right)
        return error_set(err, "out of memory for an answer");
    query->right(asked->we, asked->element, right, count);
    struct reply reply = {.asked = asked, .we = asked->we, .query = query, .right = right};
    reply.got = asked->listed;
    reply.got_count = asked->listed_count;
    reply.right_count = count;
    int failed = judge_reply(&reply, out, err);
    free(right);
    return failed;
}

void neighbours_show(const struct neighbour_asked *asked, struct scene *scene)
{
    const struct reply reply = {.asked = asked,
                                .we = asked->we,
                                .query = &neighbour_queries[asked->kind],
                                .got = asked->listed,
                                .right = asked->listed,
                                .got_count = asked->listed_count,
                                .right_count = asked->listed_count};
    show_rest(&reply, NONE, scene);
}
