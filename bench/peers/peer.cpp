// What the programs that measure other libraries share; see peer.hpp.
#include "bench/peers/peer.hpp"

#include <cstdio>
#include <exception>

namespace peer
{

namespace
{

// Calls what may throw; the error then has its text.
template <typename Call> int guard(error *err, const Call &call)
{
    try {
        call();
        return 0;
    } catch (const std::exception &trouble) {
        return error_set(err, "%s", trouble.what());
    } catch (...) {
        return error_set(err, "an exception of unknown type");
    }
}

int run(void *context, error *err)
{
    return guard(err, static_cast<operation *>(context)->run);
}

void reset(void *context)
{
    static_cast<operation *>(context)->reset();
}

int tell(void *context, worker_answer *answer, error *err)
{
    return guard(err, [&] { static_cast<operation *>(context)->answer(*answer); });
}

int serve_operations(std::vector<operation> &operations)
{
    std::vector<worker_operation> table;
    error err = {""};
    for (operation &one : operations)
        table.push_back({one.name.c_str(), &one, run, one.reset ? reset : nullptr,
                         one.answer ? tell : nullptr});
    worker_subject subject = {table.data(), static_cast<int>(table.size()), 1, nullptr};
    return worker_serve(&subject, stdin, stdout, &err) == 0 ? 0 : 2;
}

} // namespace

std::string file_beside(const std::string &snapshot_path, const std::string &extension)
{
    const std::string own = ".mesh";
    std::string stem = snapshot_path;
    if (stem.size() > own.size() && stem.compare(stem.size() - own.size(), own.size(), own) == 0)
        stem.resize(stem.size() - own.size());
    return stem + extension;
}

int serve(int argc, char **argv, const maker &make)
{
    snapshot mesh;
    error err = {""};
    std::vector<operation> operations;
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s SNAPSHOT    (started by meshgrade bench --peers)\n",
                     argv[0]);
        return 64;
    }
    worker_keep_memory();
    if (snapshot_read(argv[1], &mesh, &err) != 0 ||
        guard(&err, [&] { operations = make(mesh, argv[1]); }) != 0) {
        worker_refuse(stdout, err.text);
        return 2;
    }
    int result = serve_operations(operations);
    operations.clear();
    snapshot_release(&mesh);
    return result;
}

} // namespace peer
