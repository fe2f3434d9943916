/* The names of the layers, and the bookkeeping of which are active and why the others are not. */
#include "graders/box/inside.h"

#include <stdio.h>
#include <string.h>

static const char *const names[BOX_LAYER_COUNT] = {
    [BOX_USER_NAMESPACE] = "user-namespace",
    [BOX_PID_NAMESPACE] = "pid-namespace",
    [BOX_MOUNT_NAMESPACE] = "mount-namespace",
    [BOX_NET_NAMESPACE] = "net-namespace",
    [BOX_IPC_NAMESPACE] = "ipc-namespace",
    [BOX_UTS_NAMESPACE] = "uts-namespace",
    [BOX_PRIVATE_ROOT] = "private-root",
    [BOX_OTHER_USER] = "other-user",
    [BOX_NO_NEW_PRIVILEGES] = "no-new-privileges",
    [BOX_LANDLOCK] = "landlock",
    [BOX_SECCOMP] = "seccomp",
    [BOX_SECCOMP_NAMES] = "seccomp-names",
    [BOX_RLIMITS] = "rlimits",
    [BOX_CGROUP_MEMORY] = "cgroup-memory",
    [BOX_CGROUP_PIDS] = "cgroup-pids",
    [BOX_CGROUP_CPU] = "cgroup-cpu",
};

const char *box_layer_name(enum box_layer layer)
{
    return (unsigned)layer < BOX_LAYER_COUNT ? names[layer] : "unknown";
}

/* Layers that this process does without: a machine that lacks them is being played. */
static uint32_t switched_off;

int box_switch_off(const char *list, struct error *err)
{
    const char *at = list;
    while (*at) {
        size_t length = strcspn(at, ",");
        int layer = 0;
        while (layer < BOX_LAYER_COUNT &&
               (strlen(names[layer]) != length || strncmp(names[layer], at, length) != 0))
            layer++;
        if (layer == BOX_LAYER_COUNT)
            return error_set(err, "there is no protection \"%.*s\"; see meshgrade doctor",
                             (int)length, at);
        switched_off |= 1u << layer;
        at += length + (at[length] == ',');
    }
    return 0;
}

bool layer_wanted(const struct box_plan *plan, enum box_layer layer)
{
    return !((plan->disabled_layers | switched_off) >> layer & 1);
}

bool layer_waived(const struct box_plan *plan, enum box_layer layer)
{
    return plan->disabled_layers >> layer & 1;
}

bool layer_active(const struct report *report, enum box_layer layer)
{
    return report->active >> layer & 1;
}

void layer_works(struct report *report, enum box_layer layer)
{
    report->active |= 1u << layer;
    report->reason[layer][0] = '\0';
}

void layer_fails(struct report *report, enum box_layer layer, const char *what, int error)
{
    report->active &= ~(1u << layer);
    /* strerrordesc_np, since strerror takes locks and this may run in a freshly cloned process. */
    const char *text = error ? strerrordesc_np(error) : NULL;
    snprintf(report->reason[layer], sizeof report->reason[layer], "%s%s%s", what, text ? ": " : "",
             text ? text : "");
}
