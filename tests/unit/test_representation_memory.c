/* Memory of every representation: what it holds is what it says, and whichever allocation fails,
 * the operation says so and nothing is lost. The functions of malloc are replaced for this program.
 */
#include "reference/mesh/generate.h"
#include "reference/representation/representation.h"

#include <errno.h>
#include <malloc.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* -- counting and failing allocations --------------------------------------------------------- */

void *__libc_malloc(size_t bytes);
void *__libc_calloc(size_t count, size_t bytes);
void *__libc_realloc(void *old, size_t bytes);
void *__libc_memalign(size_t alignment, size_t bytes);
void __libc_free(void *old);

static bool is_watching;
static int64_t until_failure; /* allocations that still succeed; negative: all do */
static int64_t live_count, live_bytes;

#ifndef __SANITIZE_ADDRESS__ /* which brings its own */

static bool may_allocate(void)
{
    if (!is_watching || until_failure < 0)
        return true;
    if (until_failure > 0) {
        until_failure--;
        return true;
    }
    errno = ENOMEM;
    return false;
}

static void *noted(void *memory, int64_t sign)
{
    if (is_watching && memory) {
        live_count += sign;
        live_bytes += sign * (int64_t)malloc_usable_size(memory);
    }
    return memory;
}

void *malloc(size_t bytes)
{
    return may_allocate() ? noted(__libc_malloc(bytes), 1) : NULL;
}

void *calloc(size_t count, size_t bytes)
{
    return may_allocate() ? noted(__libc_calloc(count, bytes), 1) : NULL;
}

void *realloc(void *old, size_t bytes)
{
    if (!may_allocate())
        return NULL;
    noted(old, -1);
    return noted(__libc_realloc(old, bytes), 1);
}

void *aligned_alloc(size_t alignment, size_t bytes)
{
    return may_allocate() ? noted(__libc_memalign(alignment, bytes), 1) : NULL;
}

void free(void *old)
{
    noted(old, -1);
    __libc_free(old);
}

#endif

static void watch(int64_t allowed)
{
    until_failure = allowed;
    live_count = live_bytes = 0;
    is_watching = true;
}

static void skip_under_sanitizers(void)
{
#ifdef __SANITIZE_ADDRESS__
    skip();
#endif
}

/* -- tests ------------------------------------------------------------------------------------ */

/* Beyond its tables a structure may have what malloc rounds up, and some bytes so that no table is
 * asked for with none. */
static void tables_take_the_bytes_that_are_told(void **state)
{
    (void)state;
    skip_under_sanitizers();
    struct mesh mesh;
    mallopt(M_MMAP_THRESHOLD, 1 << 28); /* large blocks too are then rounded to 16 bytes only */
    assert_int_equal(generate_torus(&mesh, 1, 30000, NULL), 0);
    for (int i = 0; representation_table[i]; i++) {
        const struct representation *kind = representation_table[i];
        void *self;
        watch(-1);
        int code = representation_new(kind, &self, &mesh, NULL);
        is_watching = false;
        assert_int_equal(code, 0);
        int64_t tables = live_bytes - (int64_t)kind->struct_bytes;
        if (tables < kind->bytes(self) - 8 || tables > kind->bytes(self) + 64 * live_count)
            fail_msg("%s takes %lld bytes and says %lld", kind->name, (long long)tables,
                     (long long)kind->bytes(self));
        representation_delete(kind, self);
    }
    mesh_release(&mesh);
}

static void a_build_that_lacks_memory_says_so(void **state)
{
    (void)state;
    skip_under_sanitizers();
    struct mesh mesh;
    assert_int_equal(generate_grid(&mesh, 4, 5, NULL), 0);
    for (int i = 0; representation_table[i]; i++) {
        const struct representation *kind = representation_table[i];
        int code = -1;
        for (int64_t allowed = 0; code; allowed++) {
            assert_true(allowed < 100);
            struct error err = {0};
            void *self;
            watch(allowed);
            code = representation_new(kind, &self, &mesh, &err);
            is_watching = false;
            if (code && (self || live_count != 0 || !strstr(err.text, "memory")))
                fail_msg("%s, allocation %lld fails: \"%s\", %lld blocks are lost", kind->name,
                         (long long)allowed, err.text, (long long)live_count);
            if (code == 0)
                representation_delete(kind, self);
        }
    }
    mesh_release(&mesh);
}

enum { TRANSIENT_COUNT = 8 };

/* Operation number `which` on a grid of 4 x 5; -1 when it lacks memory. */
static int64_t operate(const struct representation *kind, void *self, int which, int32_t *room,
                       struct error *err)
{
    struct mesh mesh;
    int32_t starts[64];
    switch (which) {
    case 0:
        return kind->check(self, err);
    case 1:
        if (kind->to_mesh(self, &mesh, err))
            return -1;
        mesh_release(&mesh);
        return 0;
    case 2:
        return kind->vertex_normals(self, (float *)room, err);
    case 3:
        return kind->edges(self, room, err);
    case 4:
        return kind->boundary_loops(self, room, starts, err);
    case 5:
        return kind->smooth(self, err);
    case 6:
        return kind->vertices_around_vertex(self, 7, room, 64);
    default:
        return kind->faces_around_vertex(self, 7, room, 64);
    }
}

static void operations_that_lack_memory_say_so(void **state)
{
    (void)state;
    skip_under_sanitizers();
    struct mesh mesh;
    int32_t room[1000];
    assert_int_equal(generate_grid(&mesh, 4, 5, NULL), 0);
    for (int i = 0; representation_table[i]; i++)
        for (int which = 0; which < TRANSIENT_COUNT; which++) {
            const struct representation *kind = representation_table[i];
            void *self;
            assert_int_equal(representation_new(kind, &self, &mesh, NULL), 0);
            int64_t code = -1;
            for (int64_t allowed = 0; code < 0; allowed++) {
                assert_true(allowed < 100);
                struct error err = {0};
                watch(allowed);
                code = operate(kind, self, which, room, &err);
                is_watching = false;
                if (live_count != 0 || (code < 0 && which < 6 && !strstr(err.text, "memory")))
                    fail_msg("%s, operation %d, allocation %lld fails: \"%s\", %lld blocks lost",
                             kind->name, which, (long long)allowed, err.text,
                             (long long)live_count);
            }
            representation_delete(kind, self);
        }
    mesh_release(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_take_the_bytes_that_are_told),
        cmocka_unit_test(a_build_that_lacks_memory_says_so),
        cmocka_unit_test(operations_that_lack_memory_say_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
