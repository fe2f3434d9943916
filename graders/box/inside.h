/* What the files of the box share: the box as its own processes see it, and what they report to the
 * engine. Private to graders/box.
 *
 * Everything that needs memory or locks is made by the engine before it clones (box_start). The
 * processes of the box only make system calls on what they inherited, so that an engine with
 * threads may start boxes. */
#ifndef GRADERS_BOX_INSIDE_H
#define GRADERS_BOX_INSIDE_H

#include "graders/box/box.h"

#include <linux/filter.h>
#include <stddef.h>

/* Where the box's processes keep the descriptors that the program must not have. All are
 * close-on-exec; the program cannot open any with so high a number. */
enum {
    SLOT_PROGRAM = 200, /* the program's file */
    SLOT_NOTES = 201,   /* program to engine: ready, or why not */
    SLOT_INIT = 202,    /* init to engine and back */
    SLOT_WORK = 203,    /* O_PATH on the host's writable folder */
    SLOT_TREE = 204,    /* what the private root is made of, one a tree */
    SLOT_FREE = 300     /* above all of them */
};

enum { TREE_LIMIT = BOX_PATH_LIMIT + 8 };

enum {
    SPARE_ID = 47011, /* user and group of programs when the engine is root: Debian gives ids from
                         30000 to 59999 to nobody */
    INNER_ID = 1000   /* the same, as seen inside the user namespace; not 0, so that exec drops all
                         capabilities */
};

/* One part of the private root. */
struct bound_tree {
    const char *source; /* on the host; NULL: an empty folder that covers what is there */
    const char *target; /* inside, absolute */
    int fd;             /* detached mount; -1: not taken yet, a link, or a cover */
    bool is_folder;
    uint64_t attributes;
    char link[256]; /* where source is a symbolic link: its text */
};

enum report_kind { REPORT_READY = 1, REPORT_EXIT, REPORT_FAILED };

/* What init and program tell the engine, one message. */
struct report {
    enum report_kind kind;
    uint32_t active;
    struct box_reason reason[BOX_LAYER_COUNT];
    int landlock_abi;
    int status;          /* of the program */
    struct rusage usage; /* of all processes that were waited for */
    char failure[200];
};

/* Runs in place of a program, after every layer is on; returns its exit code. For box_probe_layers.
 */
typedef int probe_function(const void *argument);

struct inside {
    const struct box_plan *plan;
    struct report report;
    int engine_notes, engine_init; /* the engine's ends */
    int notes, init;               /* the box's ends */
    int null_fd, work_fd;
    uint64_t namespaces; /* CLONE_NEW... that this box really has */
    bool other_user;     /* mapped to another user id */
    struct bound_tree trees[TREE_LIMIT];
    int tree_count;
    struct sock_filter *filter; /* borrowed from filter.c */
    size_t filter_count;
    probe_function *probe; /* NULL: the plan's program */
    const void *probe_argument;
};

/* ---- layers.c */
bool layer_wanted(const struct box_plan *plan, enum box_layer layer);

/* Whether the plan itself does without the layer, and so takes the risk. */
bool layer_waived(const struct box_plan *plan, enum box_layer layer);
bool layer_active(const struct report *report, enum box_layer layer);
void layer_works(struct report *report, enum box_layer layer);

/* Says why a layer is not active: what failed (a system call or a path) and the text of errno; or
 * what the layer lacks. */
void layer_fails(struct report *report, enum box_layer layer, const char *what, int error);
void layer_lacks(struct report *report, enum box_layer layer, struct phrase why);

/* ---- namespaces.c */
/* Clones the box's init into as many namespaces as the machine grants and maps its user. */
int namespaces_spawn(struct inside *inside, struct box *box, struct error *err);

/* ---- init.c, program.c */
_Noreturn void init_main(struct inside *inside);
_Noreturn void program_main(struct inside *inside);

/* ---- root.c */
void root_plan(struct inside *inside);
/* Detaches copies of the trees not taken yet. The engine does it when it is root, since it may pass
 * folders that the box's user may not; otherwise the box's init does. */
int root_take_trees(struct inside *inside);
void root_enter(struct inside *inside);
void root_close_trees(struct inside *inside);

/* ---- landlock.c, limits.c */
void landlock_apply(struct inside *inside);
void limits_apply(struct inside *inside);
void limits_apply_address_space(struct inside *inside);

/* ---- filter.c, calls.c */
/* Finds or builds the filter of the plan's profile. */
int filter_build(struct inside *inside, struct error *err);
/* Loads it for the calling process. Returns the descriptor on which refused calls are told, or -1.
 */
int filter_load(struct inside *inside);

/* The calls of each profile: lists that end with NULL. */
extern const char *const calls_run[];       /* RUN may make these */
extern const char *const calls_tools[];     /* TOOLS and BUILD may make these */
extern const char *const calls_processes[]; /* BUILD may make these as well */
extern const char
    *const calls_forbidden[];           /* they end a TOOLS or BUILD; others are unknown calls */
extern const char *const calls_quiet[]; /* TOOLS and BUILD get EPERM */

/* ---- cgroup.c */
void cgroup_make(const struct box_plan *plan, struct box *box);
void cgroup_join(struct box *box);
void cgroup_kill(const struct box *box);
uint64_t cgroup_oom_kills(const struct box *box);
uint64_t cgroup_peak_bytes(const struct box *box);
int64_t cgroup_cpu_ns(const struct box *box); /* -1: not known */
bool cgroup_remove(struct box *box);          /* true: nothing is left */

/* ---- leftovers.c */
enum { LEFTOVERS_NAME = 80 };

/* The name of this process's group of that number. */
void leftovers_name(char out[LEFTOVERS_NAME], unsigned number);

/* Removes, in and below the folder `root`, the empty groups of processes that are no more. */
void leftovers_sweep(const char *root);

/* ---- refusal.c */
/* Reads one refused call from box->notify. Returns true when it must end the program. */
bool refusal_take(struct box *box);
bool refusal_is_process(const char *call);

/* ---- measure.c */
int64_t measure_now_ns(void);
int64_t measure_resident_bytes(const struct box *box); /* -1: gone */

/* ---- tree.c */
/* CPU time of all processes of the box, ended ones included, to a clock tick each. */
int64_t tree_cpu_ns(const struct box *box);

/* ---- disk.c */
/* What the box takes of the host's disk now; more than any limit when it cannot be told. */
int64_t disk_bytes(const struct box *box);

/* ---- start.c */
int start_with_probe(const struct box_plan *plan, probe_function *probe, const void *argument,
                     struct box *box, struct error *err);

/* ---- box.c */
/* Kills, reaps, removes, closes. Returns true when nothing is left. */
bool box_release(struct box *box);

/* ---- text.c */
/* Writes `text` into the file `name` in `folder` (a path). Returns 0, or -1 with errno. */
int text_put(const char *folder, const char *name, const char *text);
/* Reads a whole small file, NUL-terminated. Returns its length, or -1 with errno. */
int text_get(const char *folder, const char *name, char *out, size_t capacity);
/* The number after `key` ("" or NULL: at the start). 0 when the file or the key is not there. */
uint64_t text_get_number(const char *folder, const char *name, const char *key);

#endif
