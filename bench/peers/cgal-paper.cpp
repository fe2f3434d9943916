// CGAL's Surface_mesh with the operations of Sieger and Botsch (bench/compare/sieger_botsch.h).
#include "bench/peers/peer.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

extern "C" {
#include "bench/compare/sieger_botsch.h"
}

#include <cmath>
#include <memory>
#include <stdexcept>

namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;
using size = Mesh::size_type;

struct held {
    Mesh mesh;
    Mesh::Property_map<Face, Vector> face_normals;
    Mesh::Property_map<Vertex, Vector> vertex_normals;
};

std::unique_ptr<held> build(const ::mesh &from)
{
    auto made = std::make_unique<held>();
    Mesh &mesh = made->mesh;
    mesh.reserve(static_cast<size>(from.vertex_count),
                 static_cast<size>(from.triangle_count * std::int64_t{3} / 2 + 1000),
                 static_cast<size>(from.triangle_count));
    for (std::int32_t v = 0; v < from.vertex_count; v++) {
        const float *p = from.positions + 3 * std::int64_t{v};
        mesh.add_vertex(Point(p[0], p[1], p[2]));
    }
    for (std::int32_t t = 0; t < from.triangle_count; t++) {
        const std::int32_t *c = from.triangles + 3 * std::int64_t{t};
        mesh.add_face(Vertex(static_cast<size>(c[0])), Vertex(static_cast<size>(c[1])),
                      Vertex(static_cast<size>(c[2])));
    }
    made->face_normals = mesh.add_property_map<Face, Vector>("f:n", CGAL::NULL_VECTOR).first;
    made->vertex_normals = mesh.add_property_map<Vertex, Vector>("v:n", CGAL::NULL_VECTOR).first;
    return made;
}

std::int64_t circulate(const Mesh &mesh)
{
    std::int64_t sum = 0;
    for (Vertex vertex : mesh.vertices())
        if (mesh.halfedge(vertex) != Mesh::null_halfedge())
            for (Face face : CGAL::faces_around_target(mesh.halfedge(vertex), mesh))
                sum += face == Mesh::null_face() ? 0 : static_cast<std::int64_t>(face);
    for (Face face : mesh.faces())
        for (Vertex vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
            sum -= static_cast<std::int64_t>(vertex);
    return sum;
}

void centre(held &h)
{
    Mesh &mesh = h.mesh;
    Vector sum = CGAL::NULL_VECTOR;
    for (Vertex vertex : mesh.vertices())
        sum = sum + (mesh.point(vertex) - CGAL::ORIGIN);
    const Vector mean = sum / static_cast<double>(mesh.number_of_vertices());
    for (Vertex vertex : mesh.vertices())
        mesh.point(vertex) = mesh.point(vertex) - mean;
}

Vector unit(const Vector &v)
{
    const double length = std::sqrt(v.squared_length());
    return length > 0 ? v / length : v;
}

void find_normals(held &h)
{
    Mesh &mesh = h.mesh;
    for (Face face : mesh.faces()) {
        Halfedge half = mesh.halfedge(face);
        const Point &p = mesh.point(mesh.source(half)), &q = mesh.point(mesh.target(half));
        const Point &r = mesh.point(mesh.target(mesh.next(half)));
        h.face_normals[face] = unit(CGAL::cross_product(q - p, r - p));
    }
    for (Vertex vertex : mesh.vertices()) {
        Vector sum = CGAL::NULL_VECTOR;
        if (mesh.halfedge(vertex) != Mesh::null_halfedge())
            for (Face face : CGAL::faces_around_target(mesh.halfedge(vertex), mesh))
                if (face != Mesh::null_face())
                    sum = sum + h.face_normals[face];
        h.vertex_normals[vertex] = unit(sum);
    }
}

// Sum of the vertices around one inside; counts them.
Vector sum_around(const Mesh &mesh, Vertex vertex, std::int32_t &count)
{
    Vector sum = CGAL::NULL_VECTOR;
    count = 0;
    for (Vertex neighbour : CGAL::vertices_around_target(mesh.halfedge(vertex), mesh)) {
        sum = sum + (mesh.point(neighbour) - CGAL::ORIGIN);
        count++;
    }
    return sum;
}

void smooth(held &h)
{
    Mesh &mesh = h.mesh;
    for (Vertex vertex : mesh.vertices()) {
        std::int32_t count;
        if (mesh.is_border(vertex))
            continue;
        const Vector sum = sum_around(mesh, vertex, count);
        mesh.point(vertex) = CGAL::ORIGIN + sum / count;
    }
}

void reserve_splits(Mesh &mesh)
{
    mesh.reserve(mesh.number_of_vertices() + mesh.number_of_faces(),
                 mesh.number_of_edges() + 3 * mesh.number_of_faces(), 3 * mesh.number_of_faces());
}

void subdivide(held &h)
{
    Mesh &mesh = h.mesh;
    std::vector<Point> moved;
    reserve_splits(mesh);
    moved.reserve(mesh.number_of_vertices());
    for (Vertex vertex : mesh.vertices()) {
        std::int32_t count;
        if (mesh.is_border(vertex)) {
            moved.push_back(mesh.point(vertex));
            continue;
        }
        const Vector sum = sum_around(mesh, vertex, count);
        const double weight = paper_sqrt3_weight(count);
        moved.push_back(CGAL::ORIGIN + (mesh.point(vertex) - CGAL::ORIGIN) * (1 - weight) +
                        sum * (weight / count));
    }
    const size faces = mesh.number_of_faces(), edges = mesh.number_of_edges();
    for (size f = 0; f < faces; f++) {
        Halfedge half = mesh.halfedge(Face(f));
        const Point centroid =
            CGAL::centroid(mesh.point(mesh.source(half)), mesh.point(mesh.target(half)),
                           mesh.point(mesh.target(mesh.next(half))));
        mesh.point(mesh.target(CGAL::Euler::add_center_vertex(half, mesh))) = centroid;
    }
    for (size v = 0; v < moved.size(); v++)
        mesh.point(Vertex(v)) = moved[v];
    for (size e = 0; e < edges; e++)
        if (!mesh.is_border(Mesh::Edge_index(e)))
            CGAL::Euler::flip_edge(mesh.halfedge(Mesh::Edge_index(e)), mesh);
}

// An edge of a new vertex that collapse_edge shrinks away from it.
Mesh::Edge_index leaving_edge(const Mesh &mesh, Vertex vertex)
{
    for (Halfedge in : CGAL::halfedges_around_target(mesh.halfedge(vertex), mesh)) {
        const Halfedge out = mesh.opposite(in);
        if (mesh.halfedge(mesh.edge(out)) == out)
            return mesh.edge(out);
    }
    throw std::runtime_error("no edge of a new vertex starts there");
}

void collapse(held &h)
{
    Mesh &mesh = h.mesh;
    reserve_splits(mesh);
    const size vertices = mesh.number_of_vertices(), faces = mesh.number_of_faces();
    for (size f = 0; f < faces; f++)
        mesh.point(mesh.target(CGAL::Euler::add_center_vertex(mesh.halfedge(Face(f)), mesh))) =
            Point(0, 0, 0);
    for (size v = vertices; v < vertices + faces; v++)
        CGAL::Euler::collapse_edge(leaving_edge(mesh, Vertex(v)), mesh);
    mesh.collect_garbage();
}

void tell_points(const held &h, worker_answer &answer)
{
    std::vector<float> positions;
    for (Vertex vertex : h.mesh.vertices())
        for (int k = 0; k < 3; k++)
            positions.push_back(static_cast<float>(h.mesh.point(vertex)[k]));
    answer_positions(&answer, positions.data(), static_cast<std::int64_t>(positions.size() / 3));
}

void tell_normals(const held &h, worker_answer &answer)
{
    std::vector<float> normals;
    for (Vertex vertex : h.mesh.vertices())
        for (int k = 0; k < 3; k++)
            normals.push_back(static_cast<float>(h.vertex_normals[vertex][k]));
    answer_normals(&answer, normals.data(), static_cast<std::int64_t>(normals.size() / 3));
}

void tell_edges(const held &h, worker_answer &answer)
{
    std::vector<std::int32_t> pairs;
    for (Mesh::Edge_index edge : h.mesh.edges())
        for (unsigned int end = 0; end < 2; end++)
            pairs.push_back(static_cast<std::int32_t>(h.mesh.vertex(edge, end)));
    answer_edges(&answer, pairs.data(), static_cast<std::int64_t>(pairs.size() / 2));
}

// An operation goes on from where the last call left the mesh, but for edits, which start from the
// mesh as it was; its answer is that of one call on it.
peer::operation change(const std::shared_ptr<std::unique_ptr<held>> &holder, const ::mesh &from,
                       const char *name, void (*run)(held &), bool edits,
                       void (*tell)(const held &, worker_answer &))
{
    std::function<void()> reset;
    if (edits)
        reset = [holder, &from] { *holder = build(from); };
    return {name, [holder, run] { run(**holder); }, reset,
            [&from, run, tell](worker_answer &answer) {
                auto once = build(from);
                run(*once);
                tell(*once, answer);
            }};
}

std::vector<peer::operation> make(const snapshot &snapshot, const std::string &)
{
    const ::mesh &from = snapshot.mesh;
    auto holder = std::make_shared<std::unique_ptr<held>>(build(from));
    auto sum = std::make_shared<std::int64_t>(0);
    return {{"circulator",
             [holder, sum] { *sum = circulate((*holder)->mesh); },
             {},
             [sum](worker_answer &answer) { answer_count(&answer, *sum); }},
            change(holder, from, "barycentre", centre, false, tell_points),
            change(holder, from, "normals", find_normals, false, tell_normals),
            change(holder, from, "smoothing", smooth, false, tell_points),
            change(holder, from, "subdivision", subdivide, true, tell_points),
            change(holder, from, "collapse", collapse, true, tell_edges)};
}

} // namespace

int main(int argc, char **argv)
{
    return peer::serve(argc, argv, make);
}
