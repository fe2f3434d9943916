/* What a bench run measures; see plan.h. */
#include "bench/compare/plan.h"

#include "bench/compare/sieger_botsch.h"
#include "reference/kernels/kernel.h"
#include "reference/representation/representation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const what_names[] = {"representations", "kernels", "paper", "readers",
                                         "claims"};
enum { WHAT_COUNT = sizeof what_names / sizeof *what_names };

unsigned bench_what_find(const char *name)
{
    for (int i = 0; i < WHAT_COUNT; i++)
        if (strcmp(what_names[i], name) == 0)
            return 1u << i;
    return strcmp(name, "all") == 0 ? BENCH_ALL : 0;
}

const char *bench_what_name(unsigned what)
{
    for (int i = 0; i < WHAT_COUNT; i++)
        if (what == 1u << i)
            return what_names[i];
    return "";
}

/* ---- meshes ---- */

enum { REPRESENTATIONS_TOO = 1, QUICK = 2, WITH_PEERS = 4, FILES_TOO = 8 };

/* The meshes of all comparisons, the most telling ones first: when time runs out the others stay
 * undone. */
static const struct {
    const char *name;
    unsigned flags;
} meshes[] = {
    {"torus-100k-generated", REPRESENTATIONS_TOO | QUICK | WITH_PEERS},
    {"torus-100k-scrambled", REPRESENTATIONS_TOO | QUICK | WITH_PEERS},
    {"bunny-100k-generated", REPRESENTATIONS_TOO | QUICK | WITH_PEERS | FILES_TOO},
    {"torus-10k-generated", REPRESENTATIONS_TOO | WITH_PEERS},
    {"torus-10k-scrambled", REPRESENTATIONS_TOO | WITH_PEERS},
    {"bunny-100k-scrambled", REPRESENTATIONS_TOO | WITH_PEERS},
    {"torus-100k-cache", REPRESENTATIONS_TOO | WITH_PEERS},
    {"bipyramid-100k-generated", REPRESENTATIONS_TOO},
    {"torus-1M-generated", REPRESENTATIONS_TOO | WITH_PEERS},
    {"torus-1M-scrambled", REPRESENTATIONS_TOO | WITH_PEERS},
    {"horse-1M-generated", REPRESENTATIONS_TOO | WITH_PEERS | FILES_TOO},
    {"horse-1M-scrambled", WITH_PEERS},
    {"grid-100k-generated", REPRESENTATIONS_TOO},
    {"uv-sphere-100k-generated", REPRESENTATIONS_TOO},
    {"icosphere-100k-generated", REPRESENTATIONS_TOO},
    {"icosphere-100k-scrambled", 0},
    {"disc-100k-generated", 0},
    {"grid-100k-scrambled", 0},
    {"uv-sphere-100k-scrambled", 0},
    {"mug-100k-generated", 0},
    {"torus-2M-generated", REPRESENTATIONS_TOO | WITH_PEERS},
    {"torus-2M-scrambled", REPRESENTATIONS_TOO | WITH_PEERS},
    {"grid-2M-generated", 0},
    {"torus-1M-cache", 0},
    {"uv-sphere-1M-scrambled", 0},
    {"torus-10M-generated", 0},
    {"torus-10M-scrambled", 0},
};
enum { MESH_COUNT = sizeof meshes / sizeof *meshes };

static bool wants_mesh(const struct plan_wish *wish, unsigned what, unsigned flags)
{
    if (wish->quick && !(flags & QUICK))
        return false;
    if (what == BENCH_REPRESENTATIONS || what == BENCH_PAPER)
        return flags & REPRESENTATIONS_TOO;
    return what == BENCH_KERNELS || (what == BENCH_READERS && flags & FILES_TOO);
}

/* ---- contenders ---- */

static const struct {
    const char *name, *title;
    unsigned what;
} peers[] = {{"openmesh", "OpenMesh", BENCH_KERNELS | BENCH_READERS},
             {"cgal", "CGAL Surface_mesh", BENCH_KERNELS | BENCH_READERS},
             {"vtk", "VTK", BENCH_KERNELS | BENCH_READERS},
             {"meshoptimizer", "meshoptimizer", BENCH_KERNELS},
             {"assimp", "assimp", BENCH_READERS},
             {"openmesh-paper", "OpenMesh", BENCH_PAPER},
             {"cgal-paper", "CGAL Surface_mesh", BENCH_PAPER},
             {"standard", "C++ standard library", BENCH_KERNELS}};
enum { PEER_COUNT = sizeof peers / sizeof *peers };

static struct contender *add_contender(struct job *job, enum contender_kind kind, const char *name,
                                       const char *title)
{
    if (job->contender_count == BLOCK_PROGRAMS_MAX)
        return NULL;
    struct contender *contender = &job->contenders[job->contender_count++];
    *contender = (struct contender){.kind = kind, .thread_count = 1};
    snprintf(contender->name, sizeof contender->name, "%s", name);
    snprintf(contender->title, sizeof contender->title, "%s", title);
    return contender;
}

static void add_ours(struct job *job, const struct plan_wish *wish, enum contender_kind kind,
                     const char *group, const char *name, const char *title)
{
    bool is_baseline = job->contender_count == job->baseline;
    if (wish->subject && !is_baseline && !strstr(name, wish->subject))
        return;
    struct contender *contender = add_contender(job, kind, name, title);
    if (!contender)
        return;
    snprintf(contender->worker, sizeof contender->worker, "%s/%s", group, name);
    snprintf(contender->program, sizeof contender->program, "%s", wish->program);
    if (strcmp(name, "threads") == 0)
        contender->thread_count = kernel_thread_count();
}

static void add_peers(struct job *job, const struct plan_wish *wish)
{
    for (int i = 0; i < PEER_COUNT && wish->peers; i++) {
        char program[PATH_MAX];
        if (!(peers[i].what & job->what) ||
            (wish->subject && !strstr(peers[i].name, wish->subject)))
            continue;
        int length = snprintf(program, sizeof program, "%s/%s", wish->peers_folder, peers[i].name);
        if (length >= (int)sizeof program || access(program, X_OK) != 0)
            continue;
        struct contender *peer = add_contender(job, CONTENDER_PEER, peers[i].name, peers[i].title);
        if (peer)
            memcpy(peer->program, program, sizeof program);
    }
}

/* The indexed mesh is what the others are held against. */
static void add_representations(struct job *job, const struct plan_wish *wish)
{
    const struct representation *indexed = representation_find("indexed-mesh");
    if (indexed)
        add_ours(job, wish, CONTENDER_REPRESENTATION, "representation", indexed->name,
                 indexed->title);
    for (int i = 0; representation_table[i]; i++)
        if (representation_table[i] != indexed)
            add_ours(job, wish, CONTENDER_REPRESENTATION, "representation",
                     representation_table[i]->name, representation_table[i]->title);
}

static void add_paper(struct job *job, const struct plan_wish *wish)
{
    for (int i = 0; paper_structures[i]; i++)
        add_ours(job, wish, CONTENDER_REPRESENTATION, "paper", paper_structures[i]->name,
                 paper_structures[i]->title);
}

static void add_kernels(struct job *job, const struct plan_wish *wish)
{
    static const char *const variants[] = {"plain", "avx2", "avx512", "threads"};
    for (size_t i = 0; i < sizeof variants / sizeof *variants; i++) {
        bool found = false;
        for (const struct kernel *k = kernel_table; k->name && !found; k++)
            found = strcmp(k->variant, variants[i]) == 0 && k->available();
        if (found)
            add_ours(job, wish, CONTENDER_KERNEL, "kernels", variants[i], variants[i]);
    }
}

/* ---- the plan ---- */

/* Peers' programs know all operations; each comparison has its own. */
static const char *operations_of(unsigned what)
{
    if (what == BENCH_KERNELS)
        return " edges-closed edges-any twins area face-normals vertex-normals stripify "
               "vertex-cache ";
    if (what == BENCH_PAPER)
        return " circulator barycentre normals smoothing subdivision collapse ";
    return what == BENCH_READERS ? " read-ply-binary read-ply-ascii read-obj read-off " : NULL;
}

static int blocks_for(const struct plan_wish *wish, int64_t triangles)
{
    if (wish->blocks)
        return wish->blocks;
    if (wish->quick)
        return 6;
    return triangles <= 100000 ? 12 : triangles <= 1000000 ? 8 : 6;
}

static void fill_job(struct job *job, const struct plan_wish *wish, unsigned what,
                     const struct bench_mesh *mesh, unsigned flags)
{
    char mesh_name[48];
    *job = (struct job){.what = what, .mesh = *mesh};
    bench_mesh_name(mesh, mesh_name, sizeof mesh_name);
    job->blocks = blocks_for(wish, mesh->triangles);
    job->rounds = wish->quick ? 2 : 3;
    job->cold_rounds = 1;
    job->only = operations_of(what);
    if (what == BENCH_REPRESENTATIONS)
        add_representations(job, wish);
    if (what == BENCH_PAPER)
        add_paper(job, wish);
    if (what == BENCH_KERNELS)
        add_kernels(job, wish);
    if (what == BENCH_READERS)
        add_ours(job, wish, CONTENDER_READER, "reader", "meshgrade", "meshgrade");
    if (flags & WITH_PEERS || wish->mesh)
        add_peers(job, wish);
    bool with_peers = job->contender_count > 0 &&
                      job->contenders[job->contender_count - 1].kind == CONTENDER_PEER;
    snprintf(job->name, sizeof job->name, "%s%s %s%s", wish->quick ? "quick " : "",
             bench_what_name(what), mesh_name, with_peers ? " with peers" : "");
}

static void add_job(struct plan *plan, const struct plan_wish *wish, unsigned what,
                    const struct bench_mesh *mesh, unsigned flags)
{
    struct job *job = &plan->jobs[plan->job_count];
    fill_job(job, wish, what, mesh, flags);
    plan->job_count += job->contender_count > 0;
}

int plan_make(struct plan *plan, const struct plan_wish *wish, struct error *err)
{
    struct bench_mesh mesh;
    *plan = (struct plan){.jobs = calloc((MESH_COUNT + 1) * WHAT_COUNT, sizeof *plan->jobs)};
    if (!plan->jobs)
        return error_set(err, "out of memory: the plan");
    for (int i = 0; i < MESH_COUNT && !wish->mesh; i++)
        for (unsigned what = 1; what < BENCH_CLAIMS; what <<= 1) {
            if (!(wish->what & what) || !wants_mesh(wish, what, meshes[i].flags))
                continue;
            if (bench_mesh_find(meshes[i].name, &mesh, err) != 0) {
                plan_release(plan);
                return -1;
            }
            add_job(plan, wish, what, &mesh, meshes[i].flags);
        }
    if (wish->mesh && bench_mesh_find(wish->mesh, &mesh, err) != 0) {
        plan_release(plan);
        return -1;
    }
    for (unsigned what = 1; what < BENCH_CLAIMS && wish->mesh; what <<= 1)
        if (wish->what & what)
            add_job(plan, wish, what, &mesh, WITH_PEERS);
    return 0;
}

void plan_release(struct plan *plan)
{
    free(plan->jobs);
    *plan = (struct plan){0};
}
