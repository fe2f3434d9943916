// OpenMesh with the operations of Sieger and Botsch (bench/compare/sieger_botsch.h).
#include "bench/peers/peer.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

extern "C" {
#include "bench/compare/sieger_botsch.h"
}

#include <memory>
#include <utility>

namespace
{

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

std::unique_ptr<Mesh> build(const ::mesh &from)
{
    auto mesh = std::make_unique<Mesh>();
    mesh->reserve(static_cast<std::size_t>(from.vertex_count),
                  static_cast<std::size_t>(from.triangle_count) * 3 / 2 + 1000,
                  static_cast<std::size_t>(from.triangle_count));
    for (std::int32_t v = 0; v < from.vertex_count; v++) {
        const float *p = from.positions + 3 * std::int64_t{v};
        mesh->add_vertex(Mesh::Point(p[0], p[1], p[2]));
    }
    for (std::int32_t t = 0; t < from.triangle_count; t++) {
        const std::int32_t *c = from.triangles + 3 * std::int64_t{t};
        mesh->add_face(Mesh::VertexHandle(c[0]), Mesh::VertexHandle(c[1]),
                       Mesh::VertexHandle(c[2]));
    }
    mesh->request_face_normals();
    mesh->request_vertex_normals();
    mesh->request_vertex_status();
    mesh->request_edge_status();
    mesh->request_halfedge_status();
    mesh->request_face_status();
    return mesh;
}

std::int64_t circulate(const Mesh &mesh)
{
    std::int64_t sum = 0;
    for (auto vertex : mesh.vertices())
        for (auto face : mesh.vf_range(vertex))
            sum += face.idx();
    for (auto face : mesh.faces())
        for (auto vertex : mesh.fv_range(face))
            sum -= vertex.idx();
    return sum;
}

void centre(Mesh &mesh)
{
    OpenMesh::Vec3d sum(0, 0, 0);
    for (auto vertex : mesh.vertices())
        sum += OpenMesh::vector_cast<OpenMesh::Vec3d>(mesh.point(vertex));
    const auto mean = OpenMesh::vector_cast<Mesh::Point>(
        sum / static_cast<double>(mesh.n_vertices() ? mesh.n_vertices() : 1));
    for (auto vertex : mesh.vertices())
        mesh.point(vertex) -= mean;
}

void smooth(Mesh &mesh)
{
    for (auto vertex : mesh.vertices()) {
        if (mesh.is_boundary(vertex))
            continue;
        Mesh::Point sum(0, 0, 0);
        float count = 0;
        for (auto neighbour : mesh.vv_range(vertex)) {
            sum += mesh.point(neighbour);
            count++;
        }
        mesh.set_point(vertex, sum / count);
    }
}

void reserve_splits(Mesh &mesh)
{
    mesh.reserve(mesh.n_vertices() + mesh.n_faces(), mesh.n_edges() + 3 * mesh.n_faces(),
                 3 * mesh.n_faces());
}

std::vector<Mesh::Point> relaxed_points(const Mesh &mesh)
{
    std::vector<Mesh::Point> moved;
    moved.reserve(mesh.n_vertices());
    for (auto vertex : mesh.vertices()) {
        Mesh::Point here = mesh.point(vertex), sum(0, 0, 0);
        if (!mesh.is_boundary(vertex)) {
            std::int32_t count = 0;
            for (auto neighbour : mesh.vv_range(vertex)) {
                sum += mesh.point(neighbour);
                count++;
            }
            const auto weight = static_cast<float>(paper_sqrt3_weight(count));
            here = here * (1 - weight) + sum * (weight / static_cast<float>(count));
        }
        moved.push_back(here);
    }
    return moved;
}

void subdivide(Mesh &mesh)
{
    reserve_splits(mesh);
    const auto moved = relaxed_points(mesh);
    const int faces = static_cast<int>(mesh.n_faces()), edges = static_cast<int>(mesh.n_edges());
    for (int f = 0; f < faces; f++) {
        const Mesh::FaceHandle face(f);
        mesh.split(face, mesh.calc_face_centroid(face));
    }
    for (std::size_t v = 0; v < moved.size(); v++)
        mesh.set_point(Mesh::VertexHandle(static_cast<int>(v)), moved[v]);
    for (int e = 0; e < edges; e++)
        if (mesh.is_flip_ok(Mesh::EdgeHandle(e)))
            mesh.flip(Mesh::EdgeHandle(e));
}

void collapse(Mesh &mesh)
{
    reserve_splits(mesh);
    const int vertices = static_cast<int>(mesh.n_vertices());
    const int faces = static_cast<int>(mesh.n_faces());
    for (int f = 0; f < faces; f++)
        mesh.split(Mesh::FaceHandle(f), Mesh::Point(0, 0, 0));
    for (int v = vertices; v < vertices + faces; v++)
        mesh.collapse(mesh.halfedge_handle(Mesh::VertexHandle(v)));
    mesh.garbage_collection();
}

void find_normals(Mesh &mesh)
{
    mesh.update_normals();
}

void tell_points(const Mesh &mesh, worker_answer &answer)
{
    answer_positions(&answer, mesh.points()->data(), static_cast<std::int64_t>(mesh.n_vertices()));
}

void tell_normals(const Mesh &mesh, worker_answer &answer)
{
    answer_normals(&answer, mesh.vertex_normals()->data(),
                   static_cast<std::int64_t>(mesh.n_vertices()));
}

void tell_edges(const Mesh &mesh, worker_answer &answer)
{
    std::vector<std::int32_t> pairs;
    for (auto edge : mesh.edges()) {
        pairs.push_back(edge.v0().idx());
        pairs.push_back(edge.v1().idx());
    }
    answer_edges(&answer, pairs.data(), static_cast<std::int64_t>(mesh.n_edges()));
}

// An operation goes on from where the last call left the mesh, but for edits, which start from the
// mesh as it was; its answer is that of one call on it.
peer::operation change(const std::shared_ptr<std::unique_ptr<Mesh>> &held, const ::mesh &from,
                       const char *name, void (*run)(Mesh &), bool edits,
                       void (*tell)(const Mesh &, worker_answer &))
{
    std::function<void()> reset;
    if (edits)
        reset = [held, &from] { *held = build(from); };
    return {name, [held, run] { run(**held); }, reset,
            [&from, run, tell](worker_answer &answer) {
                auto once = build(from);
                run(*once);
                tell(*once, answer);
            }};
}

std::vector<peer::operation> make(const snapshot &snapshot, const std::string &)
{
    const ::mesh &from = snapshot.mesh;
    auto held = std::make_shared<std::unique_ptr<Mesh>>(build(from));
    auto sum = std::make_shared<std::int64_t>(0);
    return {{"circulator",
             [held, sum] { *sum = circulate(**held); },
             {},
             [sum](worker_answer &answer) { answer_count(&answer, *sum); }},
            change(held, from, "barycentre", centre, false, tell_points),
            change(held, from, "normals", find_normals, false, tell_normals),
            change(held, from, "smoothing", smooth, false, tell_points),
            change(held, from, "subdivision", subdivide, true, tell_points),
            change(held, from, "collapse", collapse, true, tell_edges)};
}

} // namespace

int main(int argc, char **argv)
{
    return peer::serve(argc, argv, make);
}
