// meshoptimizer: strips for the renderer.
#include "bench/peers/peer.hpp"

#include <meshoptimizer.h>

#include <memory>

namespace
{

struct state {
    std::vector<unsigned int> indices, ordered, strip;
    std::size_t vertex_count = 0, strip_count = 0;

    void order()
    {
        ordered.resize(indices.size());
        meshopt_optimizeVertexCacheFifo(ordered.data(), indices.data(), indices.size(),
                                        vertex_count, 16);
    }

    // As its manual says: first an order for the vertex cache that suits strips, then the strips,
    // with restarts.
    void stripify()
    {
        ordered.resize(indices.size());
        meshopt_optimizeVertexCacheStrip(ordered.data(), indices.data(), indices.size(),
                                         vertex_count);
        strips_of(ordered);
    }

    // The strips alone, of the triangles in the order that they have.
    void strips_of(const std::vector<unsigned int> &triangles)
    {
        strip.resize(meshopt_stripifyBound(triangles.size()));
        strip_count =
            meshopt_stripify(strip.data(), triangles.data(), triangles.size(), vertex_count, ~0u);
    }

    // ~0u is STRIP_RESTART.
    void tell_strips(worker_answer &answer) const
    {
        std::vector<std::int32_t> found(strip.begin(),
                                        strip.begin() + static_cast<std::ptrdiff_t>(strip_count));
        answer_strips(&answer, found.data(), static_cast<std::int64_t>(found.size()));
    }
};

std::vector<peer::operation> make(const snapshot &snapshot, const std::string &)
{
    auto s = std::make_shared<state>();
    const std::int32_t *first = snapshot.mesh.triangles;
    s->indices.assign(first, first + 3 * std::int64_t{snapshot.mesh.triangle_count});
    s->vertex_count = static_cast<std::size_t>(snapshot.mesh.vertex_count);
    return {{"stripify",
             [s] { s->stripify(); },
             {},
             [s](worker_answer &answer) { s->tell_strips(answer); }},
            {"strips-in-order",
             [s] { s->strips_of(s->indices); },
             {},
             [s](worker_answer &answer) { s->tell_strips(answer); }},
            {"vertex-cache",
             [s] { s->order(); },
             {},
             [s](worker_answer &answer) {
                 std::vector<std::int32_t> triangles(s->ordered.begin(), s->ordered.end());
                 answer_order(&answer, triangles.data(),
                              static_cast<std::int32_t>(triangles.size() / 3),
                              static_cast<std::int32_t>(s->vertex_count));
             }}};
}

} // namespace

int main(int argc, char **argv)
{
    return peer::serve(argc, argv, make);
}
