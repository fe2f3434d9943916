// What a C++ programmer writes with the standard library alone: sort and unique for the edge table,
// a hash table for the twins.
#include "bench/peers/peer.hpp"

#include <algorithm>
#include <memory>
#include <unordered_map>

namespace
{

struct state {
    const ::mesh *mesh;
    std::vector<std::int32_t> edges, neighbours;

    void list_edges()
    {
        std::vector<std::uint64_t> sides;
        sides.reserve(3 * static_cast<std::size_t>(mesh->triangle_count));
        for (std::int64_t side = 0; side < 3 * std::int64_t{mesh->triangle_count}; side++) {
            std::int64_t next = side % 3 == 2 ? side - 2 : side + 1;
            std::uint64_t a = static_cast<std::uint32_t>(mesh->triangles[side]);
            std::uint64_t b = static_cast<std::uint32_t>(mesh->triangles[next]);
            sides.push_back(a < b ? a << 32 | b : b << 32 | a);
        }
        std::sort(sides.begin(), sides.end());
        sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
        edges.clear();
        for (std::uint64_t side : sides) {
            edges.push_back(static_cast<std::int32_t>(side >> 32));
            edges.push_back(static_cast<std::int32_t>(side & 0xFFFFFFFF));
        }
    }

    void find_twins()
    {
        const std::int64_t sides = 3 * std::int64_t{mesh->triangle_count};
        std::unordered_map<std::uint64_t, std::int32_t> side_of;
        side_of.reserve(static_cast<std::size_t>(sides));
        auto key = [&](std::int64_t side, bool backwards) {
            std::int64_t next = side % 3 == 2 ? side - 2 : side + 1;
            std::uint64_t a = static_cast<std::uint32_t>(mesh->triangles[side]);
            std::uint64_t b = static_cast<std::uint32_t>(mesh->triangles[next]);
            return backwards ? b << 32 | a : a << 32 | b;
        };
        for (std::int64_t side = 0; side < sides; side++)
            side_of.emplace(key(side, false), static_cast<std::int32_t>(side));
        neighbours.resize(static_cast<std::size_t>(sides));
        for (std::int64_t side = 0; side < sides; side++) {
            auto twin = side_of.find(key(side, true));
            neighbours[static_cast<std::size_t>(side)] =
                twin == side_of.end() ? -1 : twin->second / 3;
        }
    }
};

std::vector<peer::operation> make(const snapshot &snapshot, const std::string &)
{
    auto s = std::make_shared<state>();
    s->mesh = &snapshot.mesh;
    return {{"edges-any",
             [s] { s->list_edges(); },
             {},
             [s](worker_answer &answer) {
                 answer_edges(&answer, s->edges.data(),
                              static_cast<std::int64_t>(s->edges.size() / 2));
             }},
            {"twins",
             [s] { s->find_twins(); },
             {},
             [s](worker_answer &answer) {
                 answer_neighbours(&answer, s->neighbours.data(), s->mesh->triangle_count);
             }}};
}

} // namespace

int main(int argc, char **argv)
{
    return peer::serve(argc, argv, make);
}
