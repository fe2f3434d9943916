/* The tree of a bundle; see upload_tree.h. */
#include "graders/engine/upload/tree.h"

#include "graders/engine/upload/names.h"

#include <stdlib.h>
#include <string.h>

struct building {
    struct bundle *bundle;
    const char *const *exercises;
    int only;
    struct folder_tree *tree;
    int capacity;
    struct error *err;
};

static void tree_claims_add(struct tree_claims *claims, int exercise)
{
    claims->bits[exercise / 64] |= (uint64_t)1 << exercise % 64;
}

bool tree_claims_has(const struct tree_claims *claims, int exercise)
{
    return claims->bits[exercise / 64] >> exercise % 64 & 1;
}

bool tree_claims_is_empty(const struct tree_claims *claims)
{
    uint64_t any = 0;
    for (size_t i = 0; i < sizeof claims->bits / sizeof claims->bits[0]; i++)
        any |= claims->bits[i];
    return any == 0;
}

static void tree_claims_join(struct tree_claims *to, const struct tree_claims *from)
{
    for (size_t i = 0; i < sizeof to->bits / sizeof to->bits[0]; i++)
        to->bits[i] |= from->bits[i];
}

size_t tree_stem(const struct tree_node *node)
{
    return node->length > 2 ? node->length - 2 : 0;
}

static int find_exercise(const struct building *b, const char *stem, size_t length)
{
    for (int i = 0; b->exercises[i]; i++)
        if (names_match(b->exercises[i], stem, length))
            return i;
    return -1;
}

/* The child of that name; they are added in order, so only the last can be it. */
static int child_named(struct building *b, int parent, const char *name, size_t length)
{
    struct folder_tree *tree = b->tree;
    int last = parent >= 0 ? tree->nodes[parent].last_child : -1;
    if (last >= 0 && tree->nodes[last].length == length &&
        memcmp(tree->nodes[last].name, name, length) == 0)
        return last;
    if (tree->count == b->capacity) {
        int capacity = b->capacity ? 2 * b->capacity : 256;
        struct tree_node *larger = realloc(tree->nodes, (size_t)capacity * sizeof *tree->nodes);
        if (!larger)
            return error_set(b->err, "out of memory");
        tree->nodes = larger;
        b->capacity = capacity;
    }
    int node = tree->count++;
    tree->nodes[node] = (struct tree_node){.name = name,
                                           .length = length,
                                           .parent = parent,
                                           .first_child = -1,
                                           .last_child = -1,
                                           .next = -1,
                                           .file = -1,
                                           .exercise = -1};
    if (parent >= 0 && last < 0)
        tree->nodes[parent].first_child = node;
    else if (parent >= 0)
        tree->nodes[last].next = node;
    if (parent >= 0)
        tree->nodes[parent].last_child = node;
    return node;
}

static int add_path(struct building *b, int file)
{
    const char *at = b->bundle->files[file].path;
    int node = 0;
    while (*at) {
        size_t length = strcspn(at, "/");
        b->tree->nodes[node].is_folder = true;
        node = child_named(b, node, at, length);
        if (node < 0)
            return -1;
        at += length + (at[length] == '/');
    }
    /* The same path twice: the first stays, and refuses, so that nobody has to choose. */
    struct tree_node *leaf = &b->tree->nodes[node];
    if (leaf->file >= 0) {
        char shown[REFUSAL_NAME];
        refusal_name(shown, leaf->name, leaf->length);
        refuse(&b->bundle->files[leaf->file].refusal, &upload_file_twice, "%s was handed in twice.",
               "%s se entregó dos veces.", shown);
        return 0;
    }
    leaf->file = file;
    return 0;
}

/* What the node is by itself. */
static void classify(struct building *b, struct tree_node *node)
{
    if (node->file >= 0)
        node->has_refusal = bundle_refuses_all(&b->bundle->files[node->file]);
    if (node->is_folder) {
        node->exercise = find_exercise(b, node->name, node->length);
        if (names_moodle(node->name, node->length))
            node->is_marked = true;
        return;
    }
    const char *path = node->file >= 0 ? b->bundle->files[node->file].path : "";
    if (bundle_kind(path) == BUNDLE_SOURCE) {
        node->exercise = find_exercise(b, node->name, tree_stem(node));
        node->has_source = node->length && (node->name[node->length - 1] | 32) == 'c';
    }
}

/* A folder named after an exercise, with no source of its own and several folders that hand it in,
 * is a class by exercise: <exercise>/<student>/<exercise>.c. */
static bool is_class_of_exercise(const struct building *b, const struct tree_node *node)
{
    int folders = 0;
    for (int c = node->first_child; c >= 0; c = b->tree->nodes[c].next) {
        const struct tree_node *child = &b->tree->nodes[c];
        if (child->has_source && !child->is_folder)
            return false;
        folders += child->is_folder && !tree_claims_is_empty(&child->below);
    }
    return folders > 1;
}

/* Tells the parent; children come before their parent here. */
static void propagate(struct building *b, struct tree_node *node)
{
    tree_claims_join(&node->below, &node->own);
    if (node->parent < 0)
        return;
    struct tree_node *parent = &b->tree->nodes[node->parent];
    parent->has_source |= node->has_source;
    parent->has_refusal |= node->has_refusal;
    parent->has_marked |= node->is_marked || node->has_marked;
    if (node->is_folder && node->exercise >= 0 && is_class_of_exercise(b, node))
        node->exercise = -1;
    if (node->exercise < 0)
        tree_claims_join(&parent->below, &node->below);
    if (node->has_source && node->exercise >= 0 && (b->only < 0 || node->exercise == b->only))
        tree_claims_add(&parent->own, node->exercise);
    if (node->has_source && !node->is_folder && b->only >= 0)
        tree_claims_add(&parent->own, b->only);
}

/* Gradescope: folders submission_<id> beside a submission_metadata.yml. */
static void mark_gradescope(struct building *b)
{
    static const char prefix[] = "submission_";
    for (int i = 0; i < b->tree->count; i++) {
        struct tree_node *meta = &b->tree->nodes[i];
        if (meta->is_folder || meta->file < 0 ||
            bundle_kind(b->bundle->files[meta->file].path) != BUNDLE_METADATA)
            continue;
        int child = b->tree->nodes[meta->parent].first_child;
        for (; child >= 0; child = b->tree->nodes[child].next) {
            struct tree_node *node = &b->tree->nodes[child];
            if (node->is_folder && node->length > sizeof prefix - 1 &&
                memcmp(node->name, prefix, sizeof prefix - 1) == 0)
                node->is_marked = true;
        }
    }
}

int tree_build(struct bundle *bundle, const char *const *exercises, int only,
               struct folder_tree *tree, struct error *err)
{
    *tree = (struct folder_tree){0};
    struct building b = {
        .bundle = bundle, .exercises = exercises, .only = only, .tree = tree, .err = err};
    int result = child_named(&b, -1, "", 0) < 0 ? -1 : 0;
    for (int i = 0; result == 0 && i < bundle->count; i++)
        result = add_path(&b, i);
    if (result) {
        tree_release(tree);
        return -1;
    }
    tree->nodes[0].is_folder = true;
    for (int i = 1; i < tree->count; i++)
        classify(&b, &tree->nodes[i]);
    mark_gradescope(&b);
    for (int i = tree->count - 1; i >= 0; i--)
        propagate(&b, &tree->nodes[i]);
    return 0;
}

void tree_release(struct folder_tree *tree)
{
    free(tree->nodes);
    *tree = (struct folder_tree){0};
}

bool tree_is_candidate(const struct folder_tree *tree, int node)
{
    const struct tree_node *n = &tree->nodes[node];
    return n->exercise < 0 && (n->has_refusal || (n->is_folder && n->has_source));
}

bool tree_is_group(const struct folder_tree *tree, int node)
{
    struct tree_claims once = {0};
    for (int c = tree->nodes[node].first_child; c >= 0; c = tree->nodes[c].next) {
        const struct tree_claims *below = &tree->nodes[c].below;
        if (!tree_is_candidate(tree, c))
            continue;
        for (size_t i = 0; i < sizeof once.bits / sizeof once.bits[0]; i++)
            if (once.bits[i] & below->bits[i])
                return true;
        tree_claims_join(&once, below);
    }
    return false;
}
