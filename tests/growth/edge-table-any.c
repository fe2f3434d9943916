/* Edge tables of known growth. BASE, EXTRA and SHARE are defined in front of this text by known.c,
 * which lists what they mean. Sides become 64-bit keys; BASE keeps each key once; EXTRA adds work
 * that grows in a known way and changes nothing. */
#include "edge-table-any.h"

#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------ hash tables */

struct table {
    uint64_t *slots; /* 0: free */
    size_t capacity, used;
};

static size_t slot_of(const struct table *table, uint64_t key)
{
    uint64_t mixed = key * 0x9E3779B97F4A7C15u;
    size_t at = (size_t)((mixed ^ mixed >> 32) % table->capacity);
    while (table->slots[at] != 0 && table->slots[at] != key)
        at = at + 1 == table->capacity ? 0 : at + 1;
    return at;
}

static int table_grow(struct table *table, size_t capacity)
{
    struct table larger = {calloc(capacity, sizeof *larger.slots), capacity, table->used};
    if (!larger.slots)
        return OUT_OF_MEMORY;
    for (size_t i = 0; i < table->capacity; i++)
        if (table->slots[i])
            larger.slots[slot_of(&larger, table->slots[i])] = table->slots[i];
    free(table->slots);
    *table = larger;
    return 0;
}

/* Capacity `first`, then times numerator/2 whenever more than `percent` are used. */
static int64_t distinct_by_table(uint64_t *keys, size_t count, size_t first, size_t numerator,
                                 size_t percent)
{
    struct table table = {0};
    int64_t kept = 0;
    if (table_grow(&table, first) != 0)
        return OUT_OF_MEMORY;
    for (size_t i = 0; i < count; i++) {
        size_t at = slot_of(&table, keys[i]);
        if (table.slots[at])
            continue;
        table.slots[at] = keys[i];
        keys[kept++] = keys[i];
        if (100 * ++table.used > percent * table.capacity &&
            table_grow(&table, table.capacity * numerator / 2) != 0) {
            free(table.slots);
            return OUT_OF_MEMORY;
        }
    }
    free(table.slots);
    return kept;
}

struct link {
    struct link *next;
    uint64_t key;
};

static void chains_release(struct link **chains, size_t chain_count)
{
    for (size_t c = 0; chains && c < chain_count; c++)
        while (chains[c]) {
            struct link *next = chains[c]->next;
            free(chains[c]);
            chains[c] = next;
        }
    free(chains);
}

static int64_t distinct_by_chains(uint64_t *keys, size_t count)
{
    size_t chain_count = count / 2 + 1;
    struct link **chains = calloc(chain_count, sizeof *chains);
    int64_t kept = chains ? 0 : OUT_OF_MEMORY;
    for (size_t i = 0; i < count && kept >= 0; i++) {
        struct link **at = &chains[keys[i] * 0x9E3779B97F4A7C15u % chain_count];
        while (*at && (*at)->key != keys[i])
            at = &(*at)->next;
        if (*at)
            continue;
        *at = malloc(sizeof **at);
        if (!*at) {
            kept = OUT_OF_MEMORY;
            break;
        }
        **at = (struct link){NULL, keys[i]};
        keys[kept++] = keys[i];
    }
    chains_release(chains, chain_count);
    return kept;
}

/* ----------------------------------------------------------------------- sorts */

static int64_t keep_first_of_runs(uint64_t *keys, size_t count)
{
    int64_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (i == 0 || keys[i] != keys[i - 1])
            keys[kept++] = keys[i];
    return kept;
}

static int compare(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

static void sift_down(uint64_t *keys, size_t root, size_t count)
{
    uint64_t key = keys[root];
    for (size_t child; (child = 2 * root + 1) < count; root = child) {
        if (child + 1 < count && keys[child + 1] > keys[child])
            child++;
        if (keys[child] <= key)
            break;
        keys[root] = keys[child];
    }
    keys[root] = key;
}

static void heap_sort(uint64_t *keys, size_t count)
{
    for (size_t i = count / 2; i-- > 0;)
        sift_down(keys, i, count);
    for (size_t i = count; i-- > 1;) {
        uint64_t largest = keys[0];
        keys[0] = keys[i];
        keys[i] = largest;
        sift_down(keys, 0, i);
    }
}

static int merge_sort(uint64_t *keys, size_t count)
{
    uint64_t *other = malloc(count * sizeof *other + 1);
    if (!other)
        return OUT_OF_MEMORY;
    for (size_t width = 1; width < count; width *= 2) {
        for (size_t from = 0; from < count; from += 2 * width) {
            size_t middle = from + width < count ? from + width : count;
            size_t end = from + 2 * width < count ? from + 2 * width : count;
            size_t a = from, b = middle;
            for (size_t i = from; i < end; i++)
                other[i] = a < middle && (b == end || keys[a] <= keys[b]) ? keys[a++] : keys[b++];
        }
        memcpy(keys, other, count * sizeof *keys);
    }
    free(other);
    return 0;
}

static int radix_sort(uint64_t *keys, size_t count)
{
    uint64_t *other = malloc(count * sizeof *other + 1);
    if (!other)
        return OUT_OF_MEMORY;
    for (int shift = 0; shift < 64; shift += 8) {
        size_t start[257] = {0};
        for (size_t i = 0; i < count; i++)
            start[(keys[i] >> shift & 255) + 1]++;
        for (int digit = 0; digit < 256; digit++)
            start[digit + 1] += start[digit];
        for (size_t i = 0; i < count; i++)
            other[start[keys[i] >> shift & 255]++] = keys[i];
        memcpy(keys, other, count * sizeof *keys);
    }
    free(other);
    return 0;
}

/* ------------------------------------------------------------------------ tree */

/* A treap: a search tree by key, a heap by a mixed key; depth is logarithmic as by chance. */
struct node {
    struct node *left, *right;
    uint64_t key;
};

static uint64_t priority(uint64_t key)
{
    key = (key ^ key >> 31) * 0x7FB5D329728EA185u;
    return (key ^ key >> 27) * 0x81DADEF4BC2DD44Du;
}

/* Splits by key into smaller and larger ones, without recursion. */
static void split(struct node *node, uint64_t key, struct node **smaller, struct node **larger)
{
    while (node) {
        if (node->key < key) {
            *smaller = node;
            smaller = &node->right;
            node = node->right;
        } else {
            *larger = node;
            larger = &node->left;
            node = node->left;
        }
    }
    *smaller = *larger = NULL;
}

static int64_t distinct_by_tree(uint64_t *keys, size_t count)
{
    struct node *nodes = malloc(count * sizeof *nodes + 1), *root = NULL;
    int64_t kept = 0;
    if (!nodes)
        return OUT_OF_MEMORY;
    for (size_t i = 0; i < count; i++) {
        struct node *found = root;
        while (found && found->key != keys[i])
            found = keys[i] < found->key ? found->left : found->right;
        if (found)
            continue;
        struct node **at = &root, *fresh = &nodes[kept];
        fresh->key = keys[i];
        while (*at && priority((*at)->key) > priority(keys[i]))
            at = keys[i] < (*at)->key ? &(*at)->left : &(*at)->right;
        split(*at, keys[i], &fresh->left, &fresh->right);
        *at = fresh;
        keys[kept++] = keys[i];
    }
    free(nodes);
    return kept;
}

/* -------------------------------------------------------------------- the parts */

static int64_t keep_distinct(uint64_t *keys, size_t count)
{
    switch (BASE) {
    case 0:
        return distinct_by_table(keys, count, 2 * count + 16, 4, 90);
    case 1:
        return distinct_by_table(keys, count, 16, 4, 50);
    case 2:
        return distinct_by_table(keys, count, 16, 8, 75);
    case 3:
        return distinct_by_table(keys, count, 16, 3, 60);
    case 4:
        return distinct_by_table(keys, count, 100, 4, 85);
    case 5:
        return distinct_by_chains(keys, count);
    case 6:
        qsort(keys, count, sizeof *keys, compare);
        break;
    case 7:
        heap_sort(keys, count);
        break;
    case 8:
        if (merge_sort(keys, count) != 0)
            return OUT_OF_MEMORY;
        break;
    case 9:
        if (radix_sort(keys, count) != 0)
            return OUT_OF_MEMORY;
        break;
    default:
        return distinct_by_tree(keys, count);
    }
    return keep_first_of_runs(keys, count);
}

static int64_t work_of(const int32_t *triangles, size_t count)
{
    int64_t equal = 0;
    size_t root = 1;
    while (root * root < count)
        root++;
    for (size_t i = 0; i < count; i++) {
        size_t first = EXTRA == 1 ? i % SHARE : 0, step = EXTRA == 1 ? SHARE : 1;
        size_t end = EXTRA == 1 ? count : EXTRA == 2 ? root * SHARE : EXTRA == 3 ? i / SHARE : 0;
        if (EXTRA == 4) /* from SHARE triangles on, a further pass */
            end = count >= SHARE ? 8 : 0;
        for (size_t j = first; j < end && j < count; j += step)
            equal += triangles[3 * i] == triangles[3 * j];
    }
    return equal;
}

static volatile int64_t sink;

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)vertex_count;
    size_t side_count = 3 * (size_t)triangle_count, count = 0;
    uint64_t *keys = malloc(side_count * sizeof *keys + 1);
    if (!keys)
        return OUT_OF_MEMORY;
    for (size_t s = 0; s < side_count; s++) {
        uint32_t i = (uint32_t)triangles[s], j = (uint32_t)triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i != j)
            keys[count++] = (uint64_t)(i < j ? i : j) << 32 | (i < j ? j : i);
    }
    if (EXTRA)
        sink = work_of(triangles, (size_t)triangle_count);
    int64_t kept = keep_distinct(keys, count);
    int32_t *table = kept < 0 ? NULL : malloc((size_t)kept * 8 + 1);
    for (int64_t e = 0; table && e < kept; e++) {
        table[2 * e] = (int32_t)(keys[e] >> 32);
        table[2 * e + 1] = (int32_t)keys[e];
    }
    free(keys);
    *edges = table;
    return table ? kept : OUT_OF_MEMORY;
}
