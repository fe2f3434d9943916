// OpenMesh: a half-edge structure, built by add_face.
#include "bench/peers/peer.hpp"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Utils/StripifierT.hh>

#include <memory>
#include <stdexcept>

namespace
{

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

void build(Mesh &mesh, const ::mesh &from)
{
    mesh.clear();
    mesh.reserve(static_cast<std::size_t>(from.vertex_count),
                 static_cast<std::size_t>(from.triangle_count) * 3 / 2 + 1000,
                 static_cast<std::size_t>(from.triangle_count));
    for (std::int32_t v = 0; v < from.vertex_count; v++) {
        const float *p = from.positions + 3 * std::int64_t{v};
        mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
    }
    for (std::int32_t t = 0; t < from.triangle_count; t++) {
        const std::int32_t *c = from.triangles + 3 * std::int64_t{t};
        mesh.add_face(Mesh::VertexHandle(c[0]), Mesh::VertexHandle(c[1]), Mesh::VertexHandle(c[2]));
    }
}

struct state {
    const ::mesh *from;
    std::string path;
    std::unique_ptr<Mesh> fresh, built;
    std::vector<std::int32_t> edges;
    std::unique_ptr<OpenMesh::StripifierT<Mesh>> stripifier;
    double area = 0;

    Mesh &need_built()
    {
        if (!built) {
            built = std::make_unique<Mesh>();
            build(*built, *from);
            built->request_face_normals();
            built->request_vertex_normals();
        }
        return *built;
    }

    void build_fresh()
    {
        fresh = std::make_unique<Mesh>();
        build(*fresh, *from);
    }

    void list_edges()
    {
        build_fresh();
        edges.resize(2 * fresh->n_edges());
        std::size_t at = 0;
        for (auto edge : fresh->edges()) {
            edges[at++] = edge.v0().idx();
            edges[at++] = edge.v1().idx();
        }
    }

    void tell_neighbours(worker_answer &answer)
    {
        std::vector<std::int32_t> neighbours(3 * fresh->n_faces());
        for (auto face : fresh->faces()) {
            const std::int32_t *corner = from->triangles + 3 * std::int64_t{face.idx()};
            for (auto half : face.halfedges())
                for (std::size_t k = 0; k < 3; k++)
                    if (half.from().idx() == corner[k])
                        neighbours[3 * static_cast<std::size_t>(face.idx()) + k] =
                            half.opp().face().idx();
        }
        answer_neighbours(&answer, neighbours.data(), from->triangle_count);
    }

    void sum_area()
    {
        area = 0;
        for (auto face : built->faces())
            area += static_cast<double>(built->calc_face_area(face));
    }

    void stripify()
    {
        stripifier = std::make_unique<OpenMesh::StripifierT<Mesh>>(*built);
        stripifier->stripify();
    }

    void tell_strips(worker_answer &answer)
    {
        std::vector<std::int32_t> indices;
        for (const auto &strip : *stripifier) {
            if (!indices.empty())
                indices.push_back(STRIP_RESTART);
            for (auto vertex : strip)
                indices.push_back(static_cast<std::int32_t>(vertex));
        }
        answer_strips(&answer, indices.data(), static_cast<std::int64_t>(indices.size()));
    }

    void tell_read(worker_answer &answer)
    {
        std::vector<float> corners;
        for (auto face : fresh->faces())
            for (auto vertex : face.vertices())
                for (int k = 0; k < 3; k++)
                    corners.push_back(fresh->point(vertex)[static_cast<std::size_t>(k)]);
        answer_read_mesh(&answer, corners.data(), static_cast<std::int64_t>(corners.size() / 9));
    }

    void read(const std::string &extension)
    {
        fresh = std::make_unique<Mesh>();
        if (!OpenMesh::IO::mesh_file_read(*fresh, peer::file_beside(path, extension)))
            throw std::runtime_error("OpenMesh could not read the file");
    }
};

peer::operation reading(const std::shared_ptr<state> &s, const char *name, const char *extension)
{
    return {name, [s, extension] { s->read(extension); }, [s] { s->fresh.reset(); },
            [s](worker_answer &answer) { s->tell_read(answer); }};
}

void tell_normals(worker_answer &answer, const OpenMesh::Vec3f *normals, std::size_t count)
{
    answer_normals(&answer, normals->data(), static_cast<std::int64_t>(count));
}

std::vector<peer::operation> make(const snapshot &snapshot, const std::string &path)
{
    auto s = std::make_shared<state>();
    s->from = &snapshot.mesh;
    s->path = path;
    return {
        {"edges-any", [s] { s->list_edges(); }, [s] { s->fresh.reset(); },
         [s](worker_answer &answer) {
             answer_edges(&answer, s->edges.data(), static_cast<std::int64_t>(s->edges.size() / 2));
         }},
        {"twins", [s] { s->build_fresh(); }, [s] { s->fresh.reset(); },
         [s](worker_answer &answer) { s->tell_neighbours(answer); }},
        {"area",
         [s] { s->need_built(), s->sum_area(); },
         {},
         [s](worker_answer &answer) { answer_area(&answer, s->area); }},
        {"face-normals",
         [s] { s->need_built().update_face_normals(); },
         {},
         [s](worker_answer &answer) {
             tell_normals(answer, s->built->property(s->built->face_normals_pph()).data(),
                          s->built->n_faces());
         }},
        {"vertex-normals",
         [s] { s->need_built().update_normals(); },
         {},
         [s](worker_answer &answer) {
             // the mean of unit normals, ours is weighted by area
             answer_normals_about(&answer,
                                  s->built->property(s->built->vertex_normals_pph()).data()->data(),
                                  s->from);
         }},
        {"stripify",
         [s] { s->need_built(), s->stripify(); },
         {},
         [s](worker_answer &answer) { s->tell_strips(answer); }},
        reading(s, "read-ply-binary", ".ply"),
        reading(s, "read-ply-ascii", ".ascii.ply"),
        reading(s, "read-obj", ".obj"),
        reading(s, "read-off", ".off")};
}

} // namespace

int main(int argc, char **argv)
{
    return peer::serve(argc, argv, make);
}
