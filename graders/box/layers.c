/* The names of the layers, and the bookkeeping of which are active and why the others are not. */
#include "graders/box/inside.h"

#include <errno.h>
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

static const struct phrase titles[BOX_LAYER_COUNT] = {
    [BOX_USER_NAMESPACE] = {"user namespace", "espacio de usuarios propio"},
    [BOX_PID_NAMESPACE] = {"process namespace", "espacio de procesos propio"},
    [BOX_MOUNT_NAMESPACE] = {"mount namespace", "espacio de montajes propio"},
    [BOX_NET_NAMESPACE] = {"network namespace", "espacio de red propio"},
    [BOX_IPC_NAMESPACE] = {"IPC namespace", "espacio de IPC propio"},
    [BOX_UTS_NAMESPACE] = {"host name namespace", "espacio de nombres de host propio"},
    [BOX_PRIVATE_ROOT] = {"private root folder", "carpeta raíz privada"},
    [BOX_OTHER_USER] = {"another user", "otro usuario"},
    [BOX_NO_NEW_PRIVILEGES] = {"no new privileges", "sin nuevos privilegios"},
    [BOX_LANDLOCK] = {"Landlock (files)", "Landlock (archivos)"},
    [BOX_SECCOMP] = {"seccomp (system calls)", "seccomp (llamadas al sistema)"},
    [BOX_SECCOMP_NAMES] = {"names of refused system calls", "nombres de las llamadas rechazadas"},
    [BOX_RLIMITS] = {"resource limits", "límites de recursos"},
    [BOX_CGROUP_MEMORY] = {"control group for memory", "grupo de control de memoria"},
    [BOX_CGROUP_PIDS] = {"control group for processes", "grupo de control de procesos"},
    [BOX_CGROUP_CPU] = {"control group for CPU time", "grupo de control de tiempo de CPU"},
};

const char *box_layer_name(enum box_layer layer)
{
    return (unsigned)layer < BOX_LAYER_COUNT ? names[layer] : "unknown";
}

struct phrase box_layer_title(enum box_layer layer)
{
    static const struct phrase unknown = {"unknown", "desconocida"};
    return (unsigned)layer < BOX_LAYER_COUNT ? titles[layer] : unknown;
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
    report->reason[layer] = (struct box_reason){"", ""};
}

/* In English libc's words, in Spanish ours for the errors that layers meet, else the error's name.
 * Nothing here takes locks, as strerror does: this may run in a freshly cloned process. */
static struct phrase words_of_error(int error)
{
    static const struct {
        int error;
        const char *es;
    } spanish[] = {
        {EPERM, "operación no permitida"},
        {EACCES, "permiso denegado"},
        {ENOENT, "no existe"},
        {ENOSYS, "el núcleo no tiene esa función"},
        {EOPNOTSUPP, "operación no admitida"},
        {EINVAL, "argumento no válido"},
        {EROFS, "el sistema de archivos es de solo lectura"},
        {ENOSPC, "no queda espacio"},
        {ENOMEM, "no hay memoria"},
        {EBUSY, "está en uso"},
        {EUSERS, "demasiados usuarios"},
    };
    struct phrase words = {strerrordesc_np(error), strerrorname_np(error)};
    for (size_t i = 0; i < sizeof spanish / sizeof *spanish; i++)
        if (spanish[i].error == error)
            words.es = spanish[i].es;
    return words;
}

void layer_fails(struct report *report, enum box_layer layer, const char *what, int error)
{
    struct phrase words = words_of_error(error);
    struct box_reason *reason = &report->reason[layer];
    report->active &= ~(1u << layer);
    snprintf(reason->en, sizeof reason->en, "%.40s: %s", what, phrase_text(words, LANGUAGE_EN));
    snprintf(reason->es, sizeof reason->es, "%.40s: %s", what, phrase_text(words, LANGUAGE_ES));
}

void layer_lacks(struct report *report, enum box_layer layer, struct phrase why)
{
    struct box_reason *reason = &report->reason[layer];
    report->active &= ~(1u << layer);
    snprintf(reason->en, sizeof reason->en, "%s", why.en);
    snprintf(reason->es, sizeof reason->es, "%s", why.es);
}
