/* The files of a bundle as a tree, with what each folder has to do with the exercises: where
 * students' folders and their submissions are found (upload.c). */
#ifndef GRADERS_ENGINE_UPLOAD_TREE_H
#define GRADERS_ENGINE_UPLOAD_TREE_H

#include "graders/engine/upload/bundle.h"

#include <stdbool.h>

enum { TREE_EXERCISES = 256 };

/* A set of exercises. */
struct tree_claims {
    uint64_t bits[TREE_EXERCISES / 64];
};

struct tree_node {
    const char *name; /* borrowed from the bundle's path; not zero-terminated */
    size_t length;
    int parent, first_child, last_child, next; /* -1: none */
    int file; /* index in the bundle, -1: a folder without a refusal of its own */
    bool is_folder;
    bool has_source;          /* a .c file at or below */
    bool has_refusal;         /* at or below, of an archive or of what it holds */
    int exercise;             /* whose name the folder or the file's stem is, or -1 */
    struct tree_claims own;   /* exercises handed in right here */
    struct tree_claims below; /* here or deeper */
    bool is_marked;           /* a platform's folder of one student */
    bool has_marked;          /* such folders below */
};

struct folder_tree {
    struct tree_node *nodes; /* 0 is the root; a parent comes before its children */
    int count;
};

/* Builds the tree of a sorted bundle. A path that stands there twice gets a refusal.
 *
 * exercises  NULL-terminated names, at most TREE_EXERCISES
 * only       index of the exercise that every .c file is for, or -1: told by names
 * returns    0, or -1 and *err when memory runs out */
int tree_build(struct bundle *bundle, const char *const *exercises, int only,
               struct folder_tree *tree, struct error *err) MUST_CHECK;

void tree_release(struct folder_tree *tree);

bool tree_claims_has(const struct tree_claims *claims, int exercise);
bool tree_claims_is_empty(const struct tree_claims *claims);

/* Do two of the node's folders claim the same exercise? Then it is no student but a group. */
bool tree_is_group(const struct folder_tree *tree, int node);

/* What may be a student's: a folder not named after an exercise with a source in it, or an archive
 * that could not be read. */
bool tree_is_candidate(const struct folder_tree *tree, int node);

/* Length of a source's name without its ending. */
size_t tree_stem(const struct tree_node *node);

#endif
