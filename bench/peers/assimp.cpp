// assimp: reads files of many formats into its scene; without any of its later steps.
#include "bench/peers/peer.hpp"

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <memory>
#include <stdexcept>

namespace
{

peer::operation reading(const char *name, const std::string &file, bool is_text)
{
    auto importer = std::make_shared<Assimp::Importer>();
    return {name,
            [importer, file] {
                if (!importer->ReadFile(file, 0))
                    throw std::runtime_error(importer->GetErrorString());
            },
            [importer] { importer->FreeScene(); },
            [importer, is_text](worker_answer &answer) {
                std::vector<float> corners;
                const aiScene *scene = importer->GetScene();
                for (unsigned i = 0; i < scene->mNumMeshes; i++)
                    for (unsigned f = 0; f < scene->mMeshes[i]->mNumFaces; f++)
                        for (unsigned k = 0; k < scene->mMeshes[i]->mFaces[f].mNumIndices; k++) {
                            const aiMesh *part = scene->mMeshes[i];
                            const aiVector3D &at = part->mVertices[part->mFaces[f].mIndices[k]];
                            corners.insert(corners.end(), {at.x, at.y, at.z});
                        }
                answer_read_mesh(&answer, corners.data(),
                                 static_cast<std::int64_t>(corners.size() / 9));
                if (is_text) // its decimals are not always the nearest floats
                    answer.hash = 0;
            }};
}

std::vector<peer::operation> make(const snapshot &, const std::string &path)
{
    return {reading("read-ply-binary", peer::file_beside(path, ".ply"), false),
            reading("read-ply-ascii", peer::file_beside(path, ".ascii.ply"), true),
            reading("read-obj", peer::file_beside(path, ".obj"), true),
            reading("read-off", peer::file_beside(path, ".off"), true)};
}

} // namespace

int main(int argc, char **argv)
{
    return peer::serve(argc, argv, make);
}
