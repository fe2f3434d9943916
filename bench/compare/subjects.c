/* What of ours can be measured; see subjects.h. */
#include "bench/compare/subjects.h"

#include "bench/compare/subject.h"

#include <string.h>

int subject_serve(const char *name, const char *snapshot_path, FILE *in, FILE *out,
                  struct error *err)
{
    struct snapshot snapshot;
    const char *slash = strchr(name, '/');
    size_t length = slash ? (size_t)(slash - name) : strlen(name);
    worker_keep_memory();
    if (strcmp(name, "reader/meshgrade") == 0)
        return subject_serve_reader(snapshot_path, in, out, err);
    if (snapshot_read(snapshot_path, &snapshot, err) != 0)
        return -1;
    int result;
    if (slash && strncmp(name, "representation", length) == 0)
        result = subject_serve_representation(slash + 1, &snapshot, in, out, err);
    else if (slash && strncmp(name, "kernels", length) == 0)
        result = subject_serve_kernels(slash + 1, &snapshot, in, out, err);
    else if (slash && strncmp(name, "paper", length) == 0)
        result = subject_serve_paper(slash + 1, &snapshot, in, out, err);
    else
        result = error_set(err, "there is no subject \"%.60s\"", name);
    snapshot_release(&snapshot);
    return result;
}
