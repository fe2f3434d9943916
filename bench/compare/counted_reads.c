/* The functions that instrumented code calls; see counted_reads.h. */
#include "bench/compare/counted_reads.h"

#include <malloc.h>
#include <string.h>

static struct counted_table {
    uintptr_t begin;
    size_t bytes, row_bytes;
    size_t last_row; /* SIZE_MAX: none yet */
} tables[REPRESENTATION_TABLES_MAX];
static int table_count; /* 0: nothing is counted */
static int64_t accesses;

void counted_reads_begin(const struct representation *kind, const void *self)
{
    accesses = 0;
    table_count = 0;
    for (int i = 0; i < REPRESENTATION_TABLES_MAX && kind->tables[i].row_bytes; i++) {
        void *rows;
        memcpy(&rows, (const char *)self + kind->tables[i].offset, sizeof rows);
        tables[table_count++] = (struct counted_table){(uintptr_t)rows, malloc_usable_size(rows),
                                                       kind->tables[i].row_bytes, SIZE_MAX};
    }
}

int64_t counted_reads_end(void)
{
    table_count = 0;
    return accesses;
}

static void count_read(const void *address, size_t bytes)
{
    for (struct counted_table *table = tables; table < tables + table_count; table++) {
        size_t from = (uintptr_t)address - table->begin;
        if (bytes == 0 || from >= table->bytes)
            continue;
        for (size_t row = from / table->row_bytes; row <= (from + bytes - 1) / table->row_bytes;
             row++) {
            accesses += row != table->last_row;
            table->last_row = row;
        }
        return;
    }
}

/* -- called by the compiler's instrumentation, under the names that it knows ------------------- */

#define READ_HOOK(bytes)                                                                           \
    void hook_read_##bytes(const void *address) __asm__("__tsan_read" #bytes);                     \
    void hook_read_##bytes(const void *address)                                                    \
    {                                                                                              \
        count_read(address, bytes);                                                                \
    }                                                                                              \
    void hook_unaligned_##bytes(const void *address) __asm__("__tsan_unaligned_read" #bytes);      \
    void hook_unaligned_##bytes(const void *address)                                               \
    {                                                                                              \
        count_read(address, bytes);                                                                \
    }
#define IDLE_HOOK(name, label)                                                                     \
    void name(void) __asm__(label);                                                                \
    void name(void)                                                                                \
    {                                                                                              \
    }

READ_HOOK(1)
READ_HOOK(2)
READ_HOOK(4)
READ_HOOK(8)
READ_HOOK(16)

void hook_read_range(const void *address, size_t bytes) __asm__("__tsan_read_range");
void hook_read_range(const void *address, size_t bytes)
{
    count_read(address, bytes);
}

/* Their arguments are of no interest. */
IDLE_HOOK(hook_init, "__tsan_init")
IDLE_HOOK(hook_entry, "__tsan_func_entry")
IDLE_HOOK(hook_exit, "__tsan_func_exit")
IDLE_HOOK(hook_write_1, "__tsan_write1")
IDLE_HOOK(hook_write_2, "__tsan_write2")
IDLE_HOOK(hook_write_4, "__tsan_write4")
IDLE_HOOK(hook_write_8, "__tsan_write8")
IDLE_HOOK(hook_write_16, "__tsan_write16")
IDLE_HOOK(hook_unaligned_write_2, "__tsan_unaligned_write2")
IDLE_HOOK(hook_unaligned_write_4, "__tsan_unaligned_write4")
IDLE_HOOK(hook_unaligned_write_8, "__tsan_unaligned_write8")
IDLE_HOOK(hook_unaligned_write_16, "__tsan_unaligned_write16")
IDLE_HOOK(hook_write_range, "__tsan_write_range")

/* -- copies, which the compiler does not instrument: the Makefile gives them these names --------
 */

void *counted_memcpy(void *to, const void *from, size_t bytes);
void *counted_memcpy(void *to, const void *from, size_t bytes)
{
    count_read(from, bytes);
    return memcpy(to, from, bytes);
}

int counted_memcmp(const void *left, const void *right, size_t bytes);
int counted_memcmp(const void *left, const void *right, size_t bytes)
{
    count_read(left, bytes);
    count_read(right, bytes);
    return memcmp(left, right, bytes);
}

/* Clang's names for them. */
void *hook_memcpy(void *to, const void *from, size_t bytes) __asm__("__tsan_memcpy");
void *hook_memcpy(void *to, const void *from, size_t bytes)
{
    return counted_memcpy(to, from, bytes);
}

void *hook_memset(void *to, int value, size_t bytes) __asm__("__tsan_memset");
void *hook_memset(void *to, int value, size_t bytes)
{
    return memset(to, value, bytes);
}
