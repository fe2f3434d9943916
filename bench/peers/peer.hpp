// What the programs that measure other libraries share: they open a mesh snapshot and serve as
// workers (bench/measure/worker.h), so that they are measured in turns with ours and their answers
// are held against ours. One program a library, through the calls that its own manual shows.
//
// A structure is built inside of the measured call where the question starts from an indexed mesh
// (edges-any, twins), and before it where the library's users have it already (area, normals).
#ifndef BENCH_PEERS_PEER_HPP
#define BENCH_PEERS_PEER_HPP

extern "C" {
#include "bench/compare/answers.h"
#include "bench/compare/snapshot.h"
#include "bench/measure/worker.h"
#include "reference/kernels/stripify.h"
}

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace peer
{

struct operation {
    std::string name;
    std::function<void()> run;                   // measured
    std::function<void()> reset;                 // after each call, not measured; may be empty
    std::function<void(worker_answer &)> answer; // of the last run; may be empty
};

// The file of the same mesh in another format: "x/torus.mesh" and ".obj" give "x/torus.obj".
std::string file_beside(const std::string &snapshot_path, const std::string &extension);

using maker =
    std::function<std::vector<operation>(const snapshot &mesh, const std::string &snapshot_path)>;

// The whole main: PROGRAM SNAPSHOT. What an operation throws is told as its error.
int serve(int argc, char **argv, const maker &make);

} // namespace peer

#endif
