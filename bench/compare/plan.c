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

enum {
    REPRESENTATIONS = BENCH_REPRESENTATIONS,
    KERNELS = BENCH_KERNELS,
    PAPER = BENCH_PAPER,
    READERS = BENCH_READERS
};

/* When other libraries take part: where they need a second a call, only in a thorough run; where a
 * vertex of half the edges makes one of them quadratic (nine minutes a block), never. */
enum peers_in { FULL_RUN, THOROUGH_RUN, NO_RUN };

/* The meshes of all comparisons, the most telling ones first: when time runs out the others stay
 * undone. `full` is measured in half an hour, `thorough` beside it when asked for. */
static const struct {
    const char *name;
    unsigned quick, full, thorough; /* comparisons on it */
    enum peers_in peers;
} meshes[] = {
    {"torus-100k-generated", KERNELS, REPRESENTATIONS | KERNELS, 0, FULL_RUN},
    {"torus-100k-scrambled", KERNELS, REPRESENTATIONS | KERNELS | PAPER, 0, FULL_RUN},
    {"bunny-100k-generated", 0, REPRESENTATIONS | KERNELS | PAPER | READERS, 0, FULL_RUN},
    {"bunny-10k-generated", REPRESENTATIONS | PAPER | READERS, 0, 0, FULL_RUN},
    {"torus-10k-scrambled", REPRESENTATIONS, REPRESENTATIONS | KERNELS, 0, FULL_RUN},
    {"torus-10k-generated", 0, REPRESENTATIONS | KERNELS, 0, FULL_RUN},
    {"torus-100k-flipped", 0, KERNELS, 0, FULL_RUN},
    {"torus-1M-generated", 0, KERNELS, 0, FULL_RUN},
    {"torus-1M-scrambled", 0, KERNELS, REPRESENTATIONS, FULL_RUN},
    {"bunny-100k-scrambled", 0, KERNELS, REPRESENTATIONS, FULL_RUN},
    {"torus-100k-cache", 0, KERNELS, REPRESENTATIONS, FULL_RUN},
    {"bunny-100k-flipped", 0, KERNELS, 0, FULL_RUN},
    {"bipyramid-100k-generated", 0, KERNELS, REPRESENTATIONS, NO_RUN},
    {"grid-100k-generated", 0, KERNELS, REPRESENTATIONS, FULL_RUN},
    {"uv-sphere-100k-generated", 0, KERNELS, REPRESENTATIONS, FULL_RUN},
    {"icosphere-100k-generated", 0, KERNELS, REPRESENTATIONS, FULL_RUN},
    {"mug-100k-generated", 0, KERNELS, 0, FULL_RUN},
    {"disc-100k-generated", 0, KERNELS, 0, FULL_RUN},
    {"horse-1M-generated", 0, KERNELS, REPRESENTATIONS | PAPER | READERS, FULL_RUN},
    {"torus-2M-generated", 0, KERNELS, REPRESENTATIONS, THOROUGH_RUN},
    {"torus-2M-scrambled", 0, KERNELS, REPRESENTATIONS, THOROUGH_RUN},
    {"torus-10M-generated", 0, KERNELS, 0, THOROUGH_RUN},
    {"torus-10M-scrambled", 0, KERNELS, 0, THOROUGH_RUN},
    {"icosphere-100k-scrambled", 0, KERNELS, 0, FULL_RUN},
    {"grid-100k-scrambled", 0, KERNELS, 0, FULL_RUN},
    {"uv-sphere-100k-scrambled", 0, KERNELS, 0, FULL_RUN},
    {"torus-1M-generated", 0, REPRESENTATIONS, 0, FULL_RUN},
    {"horse-1M-scrambled", 0, 0, KERNELS | PAPER, THOROUGH_RUN},
    {"horse-1M-cache", 0, 0, KERNELS, THOROUGH_RUN},
    {"torus-1M-cache", 0, 0, KERNELS, THOROUGH_RUN},
    {"grid-2M-generated", 0, 0, KERNELS, THOROUGH_RUN},
    {"uv-sphere-1M-scrambled", 0, 0, KERNELS, THOROUGH_RUN},
    {"bipyramid-100k-scrambled", 0, 0, KERNELS, NO_RUN},
};
enum { MESH_COUNT = sizeof meshes / sizeof *meshes };

/* ---- contenders ---- */

static const struct {
    const char *name, *title;
    unsigned what;
    bool holds_flipped; /* meshes without coherent orientation; half edges cannot */
} peers[] = {{"openmesh", "OpenMesh", BENCH_KERNELS | BENCH_READERS, false},
             {"cgal", "CGAL Surface_mesh", BENCH_KERNELS | BENCH_READERS, false},
             {"vtk", "VTK", BENCH_KERNELS | BENCH_READERS, true},
             {"meshoptimizer", "meshoptimizer", BENCH_KERNELS, false},
             {"assimp", "assimp", BENCH_READERS, true},
             {"openmesh-paper", "OpenMesh", BENCH_PAPER, false},
             {"cgal-paper", "CGAL Surface_mesh", BENCH_PAPER, false},
             {"standard", "C++ standard library", BENCH_KERNELS, true}};
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
            ((job->mesh.order == MESH_FLIPPED || job->mesh.is_irregular) &&
             !peers[i].holds_flipped) ||
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

/* Programs know all operations; each comparison has its own. Without coherent orientation only the
 * edge table means something; strips alone are for meshes in cache order. */
#define ALL_KERNELS                                                                                \
    " edges-closed edges-any twins area face-normals vertex-normals stripify vertex-cache "        \
    "vertex-fetch "
static const char *operations_of(unsigned what, const struct bench_mesh *mesh)
{
    if (what == BENCH_KERNELS && (mesh->order == MESH_FLIPPED || mesh->is_irregular))
        return " edges-any ";
    if (what == BENCH_KERNELS)
        return mesh->order == MESH_CACHE ? ALL_KERNELS "strips-in-order " : ALL_KERNELS;
    if (what == BENCH_PAPER)
        return " circulator barycentre normals smoothing subdivision collapse ";
    return what == BENCH_READERS ? " read-ply-binary read-ply-ascii read-obj read-off " : NULL;
}

/* Six blocks are the least from which an interval has a confidence above 95 % (interval.h). */
static int blocks_for(const struct plan_wish *wish)
{
    enum { USUAL_BLOCKS = 6, THOROUGH_BLOCKS = 12 };
    if (wish->blocks)
        return wish->blocks;
    return wish->thorough ? THOROUGH_BLOCKS : USUAL_BLOCKS;
}

static void fill_job(struct job *job, const struct plan_wish *wish, unsigned what,
                     const struct bench_mesh *mesh, bool with_peers)
{
    char mesh_name[48];
    *job = (struct job){.what = what, .mesh = *mesh};
    bench_mesh_name(mesh, mesh_name, sizeof mesh_name);
    job->blocks = blocks_for(wish);
    job->rounds = wish->quick ? 2 : 3;
    job->cold_rounds = 1;
    job->only = operations_of(what, mesh);
    if (what == BENCH_REPRESENTATIONS)
        add_representations(job, wish);
    if (what == BENCH_PAPER)
        add_paper(job, wish);
    if (what == BENCH_KERNELS)
        add_kernels(job, wish);
    if (what == BENCH_READERS)
        add_ours(job, wish, CONTENDER_READER, "reader", "meshgrade", "meshgrade");
    if (with_peers)
        add_peers(job, wish);
    bool has_peers = job->contender_count > 0 &&
                     job->contenders[job->contender_count - 1].kind == CONTENDER_PEER;
    snprintf(job->name, sizeof job->name, "%s%s %s%s", wish->quick ? "quick " : "",
             bench_what_name(what), mesh_name, has_peers ? " with peers" : "");
}

static void add_job(struct plan *plan, const struct plan_wish *wish, unsigned what,
                    const struct bench_mesh *mesh, bool with_peers)
{
    struct job *job = &plan->jobs[plan->job_count];
    fill_job(job, wish, what, mesh, with_peers);
    plan->job_count += job->contender_count > 0;
}

/* The jobs on one mesh. */
static int add_mesh(struct plan *plan, const struct plan_wish *wish, const char *name,
                    unsigned wanted, bool with_peers, struct error *err)
{
    struct bench_mesh mesh;
    if (bench_mesh_find(name, &mesh, err) != 0)
        return -1;
    for (unsigned what = 1; what < BENCH_CLAIMS; what <<= 1)
        if (wish->what & wanted & what)
            add_job(plan, wish, what, &mesh, with_peers);
    return 0;
}

int plan_make(struct plan *plan, const struct plan_wish *wish, struct error *err)
{
    *plan = (struct plan){.jobs = calloc((size_t)MESH_COUNT * WHAT_COUNT, sizeof *plan->jobs)};
    if (!plan->jobs)
        return error_set(err, "out of memory: the plan");
    plan->blocks_at_once = wish->quick ? 1 : blocks_for(wish);
    int result = wish->mesh ? add_mesh(plan, wish, wish->mesh, BENCH_ALL, true, err) : 0;
    for (int i = 0; i < MESH_COUNT && result == 0 && !wish->mesh; i++) {
        unsigned what = wish->quick ? meshes[i].quick : meshes[i].full;
        if (wish->thorough)
            what |= meshes[i].thorough;
        bool with_peers =
            meshes[i].peers == FULL_RUN || (meshes[i].peers == THOROUGH_RUN && wish->thorough);
        result = add_mesh(plan, wish, meshes[i].name, what, with_peers, err);
    }
    if (result != 0)
        plan_release(plan);
    return result;
}

void plan_release(struct plan *plan)
{
    free(plan->jobs);
    *plan = (struct plan){0};
}
