/* Disjoint groups; see groups.h. */
#include "reference/mesh/groups.h"

#include <stdlib.h>

int groups_init(struct groups *groups, int64_t count, struct error *err)
{
    groups->parent = malloc((size_t)count * sizeof *groups->parent + 1);
    groups->parity = calloc((size_t)count + 1, 1);
    if (!groups->parent || !groups->parity) {
        groups_release(groups);
        return error_set(err, "out of memory: grouping %lld elements", (long long)count);
    }
    for (int64_t i = 0; i < count; i++)
        groups->parent[i] = (int32_t)i;
    return 0;
}

void groups_release(struct groups *groups)
{
    free(groups->parent);
    free(groups->parity);
    *groups = (struct groups){0};
}

/* The root of i's group; *parity says whether i is opposite to it. Halves the path as it goes. */
static int32_t find_root(struct groups *groups, int32_t i, uint8_t *parity)
{
    int32_t *parent = groups->parent;
    uint8_t sum = 0;
    while (parent[i] != i) {
        int32_t above = parent[i];
        groups->parity[i] ^= groups->parity[above]; /* a root's parity is 0 */
        parent[i] = parent[above];
        sum ^= groups->parity[i];
        i = parent[i];
    }
    *parity = sum;
    return i;
}

int32_t groups_root(struct groups *groups, int32_t i)
{
    uint8_t parity;
    return find_root(groups, i, &parity);
}

bool groups_join_parity(struct groups *groups, int32_t a, int32_t b, bool opposite)
{
    uint8_t parity_a, parity_b;
    int32_t root_a = find_root(groups, a, &parity_a);
    int32_t root_b = find_root(groups, b, &parity_b);
    uint8_t between = parity_a ^ parity_b ^ (uint8_t)opposite;
    if (root_a == root_b)
        return between == 0;
    groups->parent[root_a] = root_b;
    groups->parity[root_a] = between;
    return true;
}

bool groups_join(struct groups *groups, int32_t a, int32_t b)
{
    uint8_t parity;
    int32_t root_a = find_root(groups, a, &parity);
    int32_t root_b = find_root(groups, b, &parity);
    if (root_a == root_b)
        return false;
    groups->parent[root_a] = root_b;
    groups->parity[root_a] = 0;
    return true;
}
