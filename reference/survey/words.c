/* The words of a survey; see survey.h. */
#include "reference/survey/survey.h"

static const struct {
    const char *slug;
    struct phrase one, many;
} kinds[SURVEY_KINDS] = {
    [SURVEY_DEGENERATE] = {"degenerate-triangle",
                           {"degenerate triangle", "triángulo degenerado"},
                           {"degenerate triangles", "triángulos degenerados"}},
    [SURVEY_FLAT] = {"flat-triangle",
                     {"triangle without area", "triángulo sin área"},
                     {"triangles without area", "triángulos sin área"}},
    [SURVEY_DUPLICATE] = {"duplicate-triangle",
                          {"duplicate triangle", "triángulo repetido"},
                          {"duplicate triangles", "triángulos repetidos"}},
    [SURVEY_ISOLATED] = {"isolated-vertex",
                         {"isolated vertex", "vértice aislado"},
                         {"isolated vertices", "vértices aislados"}},
    [SURVEY_NONMANIFOLD_EDGE] = {"non-manifold-edge",
                                 {"non-manifold edge", "arista no variedad"},
                                 {"non-manifold edges", "aristas no variedad"}},
    [SURVEY_NONMANIFOLD_VERTEX] = {"non-manifold-vertex",
                                   {"non-manifold vertex", "vértice no variedad"},
                                   {"non-manifold vertices", "vértices no variedad"}},
    [SURVEY_INCOHERENT] = {"incoherent-edge",
                           {"incoherent edge", "arista incoherente"},
                           {"incoherent edges", "aristas incoherentes"}},
    [SURVEY_CRACK] = {"crack",
                      {"edge of a crack", "arista de una grieta"},
                      {"edges of cracks", "aristas de grietas"}},
    [SURVEY_T_VERTEX] = {"t-vertex", {"T-vertex", "vértice en T"}, {"T-vertices", "vértices en T"}},
    [SURVEY_CROSSING] = {"self-intersection",
                         {"self-intersection", "autointersección"},
                         {"self-intersections", "autointersecciones"}},
};

const char *survey_kind_slug(enum survey_kind kind)
{
    return kinds[kind].slug;
}

struct phrase survey_kind_name(enum survey_kind kind, bool many)
{
    return many ? kinds[kind].many : kinds[kind].one;
}

static void say_of_edge(enum survey_kind kind, const int32_t at[4], struct message *message)
{
    if (kind == SURVEY_NONMANIFOLD_EDGE)
        message_say(message, "Edge {%d,%d} has %d triangles.",
                    "La arista {%d,%d} tiene %d triángulos.", at[0], at[1], at[2]);
    else if (kind == SURVEY_INCOHERENT)
        message_say(message, "Edge {%d,%d} is run the same way by triangles %d and %d.",
                    "La arista {%d,%d} la recorren en el mismo sentido los triángulos %d y %d.",
                    at[0], at[1], at[2], at[3]);
    else
        message_say(message, "Edge {%d,%d} lies on edge {%d,%d} and has other vertices.",
                    "La arista {%d,%d} coincide con la arista {%d,%d} y tiene otros vértices.",
                    at[0], at[1], at[2], at[3]);
}

void survey_say(enum survey_kind kind, const struct survey_element *element,
                struct message *message)
{
    const int32_t *at = element->at;
    switch (kind) {
    case SURVEY_DEGENERATE:
        message_say(message, "Triangle %d names a vertex twice.",
                    "El triángulo %d nombra dos veces un vértice.", at[0]);
        break;
    case SURVEY_FLAT:
        message_say(message, "The vertices of triangle %d lie on a line.",
                    "Los vértices del triángulo %d están en una recta.", at[0]);
        break;
    case SURVEY_DUPLICATE:
        message_say(message, "Triangle %d has the vertices of triangle %d.",
                    "El triángulo %d tiene los vértices del triángulo %d.", at[0], at[1]);
        break;
    case SURVEY_ISOLATED:
        message_say(message, "Vertex %d is in no triangle.",
                    "El vértice %d no está en ningún triángulo.", at[0]);
        break;
    case SURVEY_NONMANIFOLD_VERTEX:
        message_say(message, "The triangles at vertex %d are not one fan or umbrella.",
                    "Los triángulos del vértice %d no forman un solo abanico.", at[0]);
        break;
    case SURVEY_T_VERTEX:
        message_say(message, "Vertex %d lies on edge {%d,%d}, between its ends.",
                    "El vértice %d está en la arista {%d,%d}, entre sus extremos.", at[0], at[1],
                    at[2]);
        break;
    case SURVEY_CROSSING:
        message_say(message, "Triangles %d and %d run through each other.",
                    "Los triángulos %d y %d se atraviesan.", at[0], at[1]);
        break;
    default:
        say_of_edge(kind, at, message);
    }
}
