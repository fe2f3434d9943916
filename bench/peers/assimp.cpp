// assimp: reads files of many formats into its scene; without any of its later steps.
#include "bench/peers/peer.hpp"

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <memory>
#include <stdexcept>

namespace
{

peer::operation reading(const char *name, const std::string &file)
{
    auto importer = std::make_shared<Assimp::Importer>();
    return {name,
            [importer, file] {
                if (!importer->ReadFile(file, 0))
                    throw std::runtime_error(importer->GetErrorString());
            },
            [importer] { importer->FreeScene(); },
            [importer](worker_answer &answer) {
                std::int64_t triangles = 0;
                const aiScene *scene = importer->GetScene();
                for (unsigned i = 0; i < scene->mNumMeshes; i++)
                    triangles += scene->mMeshes[i]->mNumFaces;
                answer_count(&answer, triangles);
            }};
}

std::vector<peer::operation> make(const snapshot &, const std::string &path)
{
    return {reading("read-ply-binary", peer::file_beside(path, ".ply")),
            reading("read-ply-ascii", peer::file_beside(path, ".ascii.ply")),
            reading("read-obj", peer::file_beside(path, ".obj")),
            reading("read-off", peer::file_beside(path, ".off"))};
}

} // namespace

int main(int argc, char **argv)
{
    return peer::serve(argc, argv, make);
}
