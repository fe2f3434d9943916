// CGAL: Surface_mesh, a half-edge structure of index arrays, built by add_face.
#include "bench/peers/peer.hpp"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO.h>

#include <memory>
#include <stdexcept>

namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
namespace processing = CGAL::Polygon_mesh_processing;

void build(Mesh &mesh, const ::mesh &from)
{
    mesh.reserve(static_cast<Mesh::size_type>(from.vertex_count),
                 static_cast<Mesh::size_type>(from.triangle_count * std::int64_t{3} / 2 + 1000),
                 static_cast<Mesh::size_type>(from.triangle_count));
    for (std::int32_t v = 0; v < from.vertex_count; v++) {
        const float *p = from.positions + 3 * std::int64_t{v};
        mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
    }
    for (std::int32_t t = 0; t < from.triangle_count; t++) {
        const std::int32_t *c = from.triangles + 3 * std::int64_t{t};
        mesh.add_face(Vertex(static_cast<Mesh::size_type>(c[0])),
                      Vertex(static_cast<Mesh::size_type>(c[1])),
                      Vertex(static_cast<Mesh::size_type>(c[2])));
    }
}

struct state {
    const ::mesh *from;
    std::string path;
    std::unique_ptr<Mesh> fresh, built;
    Mesh::Property_map<Mesh::Face_index, Kernel::Vector_3> face_normals;
    Mesh::Property_map<Vertex, Kernel::Vector_3> vertex_normals;
    std::vector<std::int32_t> edges;
    double area = 0;

    Mesh &need_built()
    {
        if (!built) {
            built = std::make_unique<Mesh>();
            build(*built, *from);
            const Kernel::Vector_3 zero(0, 0, 0);
            face_normals =
                built->add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:n", zero).first;
            vertex_normals = built->add_property_map<Vertex, Kernel::Vector_3>("v:n", zero).first;
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
        edges.resize(2 * static_cast<std::size_t>(fresh->number_of_edges()));
        std::size_t at = 0;
        for (Mesh::Edge_index edge : fresh->edges()) {
            edges[at++] = static_cast<std::int32_t>(fresh->vertex(edge, 0));
            edges[at++] = static_cast<std::int32_t>(fresh->vertex(edge, 1));
        }
    }

    void tell_neighbours(worker_answer &answer)
    {
        std::vector<std::int32_t> neighbours(3 * static_cast<std::size_t>(from->triangle_count),
                                             -1);
        for (Mesh::Face_index face : fresh->faces()) {
            const auto number = static_cast<std::size_t>(face);
            for (Mesh::Halfedge_index half : fresh->halfedges_around_face(fresh->halfedge(face)))
                for (std::size_t k = 0; k < 3; k++) {
                    Mesh::Halfedge_index twin = fresh->opposite(half);
                    if (static_cast<std::int32_t>(fresh->source(half)) ==
                            from->triangles[3 * number + k] &&
                        !fresh->is_border(twin))
                        neighbours[3 * number + k] = static_cast<std::int32_t>(fresh->face(twin));
                }
        }
        answer_neighbours(&answer, neighbours.data(), from->triangle_count);
    }

    void read(const std::string &extension)
    {
        fresh = std::make_unique<Mesh>();
        if (!CGAL::IO::read_polygon_mesh(peer::file_beside(path, extension), *fresh))
            throw std::runtime_error("CGAL could not read the file");
    }

    void tell_read(worker_answer &answer)
    {
        std::vector<float> corners;
        for (Mesh::Face_index face : fresh->faces())
            for (Vertex vertex : fresh->vertices_around_face(fresh->halfedge(face)))
                for (int k = 0; k < 3; k++)
                    corners.push_back(static_cast<float>(fresh->point(vertex)[k]));
        answer_read_mesh(&answer, corners.data(), static_cast<std::int64_t>(corners.size() / 9));
    }
};

template <typename Map, typename Range>
std::vector<float> to_floats(const Map &map, const Range &range)
{
    std::vector<float> normals;
    for (auto element : range)
        for (int k = 0; k < 3; k++)
            normals.push_back(static_cast<float>(map[element][k]));
    return normals;
}

peer::operation reading(const std::shared_ptr<state> &s, const char *name, const char *extension)
{
    return {name, [s, extension] { s->read(extension); }, [s] { s->fresh.reset(); },
            [s](worker_answer &answer) { s->tell_read(answer); }};
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
         [s] { s->area = processing::area(s->need_built()); },
         {},
         [s](worker_answer &answer) { answer_area(&answer, s->area); }},
        {"face-normals",
         [s] { processing::compute_face_normals(s->need_built(), s->face_normals); },
         {},
         [s](worker_answer &answer) {
             const auto normals = to_floats(s->face_normals, s->built->faces());
             answer_normals(&answer, normals.data(), static_cast<std::int64_t>(normals.size() / 3));
         }},
        {"vertex-normals",
         [s] { processing::compute_vertex_normals(s->need_built(), s->vertex_normals); },
         {},
         [s](worker_answer &answer) {
             // the most visible direction, ours is weighted by area
             const auto normals = to_floats(s->vertex_normals, s->built->vertices());
             answer_normals_about(&answer, normals.data(), s->from);
         }},
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
