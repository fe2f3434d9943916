/* Every number of a table changed in turn; see damage.h. */
#include "tests/unit/damage.h"

#include "reference/mesh/generate.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

struct mesh damage_mesh(int index)
{
    struct mesh mesh;
    int code = index == 0   ? generate_tetrahedron(&mesh, NULL)
               : index == 1 ? generate_one_triangle(&mesh, NULL)
               : index == 2 ? generate_grid(&mesh, 2, 3, NULL)
               : index == 3 ? generate_disc(&mesh, 1, 5, NULL)
                            : generate_cube(&mesh, NULL);
    assert_int_equal(code, 0);
    if (index == 3)
        assert_int_equal(change_add_isolated_vertices(&mesh, 2, 7, NULL), 0);
    return mesh;
}

static void try_value(const struct damage *damage, const char *table, int32_t *number,
                      int64_t index, int32_t value, enum choice choice)
{
    int32_t right = *number;
    uint64_t shape = choice == SOME_CHOICE ? damage->shape_of(damage->self) : 0;
    struct error err = {0};
    *number = value;
    if (damage->check(damage->self, &err) == 0) {
        if (choice == NO_CHOICE)
            fail_msg("%s[%lld]: %d instead of %d is not found", table, (long long)index, value,
                     right);
        if (damage->shape_of(damage->self) != shape)
            fail_msg("%s[%lld]: %d instead of %d is accepted and changes the mesh", table,
                     (long long)index, value, right);
    } else if (!strpbrk(err.text, "0123456789")) {
        fail_msg("%s[%lld]: no element is named: %s", table, (long long)index, err.text);
    }
    *number = right;
}

void damage_every_number(const struct damage *damage, const char *table, int32_t *numbers,
                         int64_t count, enum choice choice)
{
    assert_int_equal(damage->check(damage->self, NULL), 0);
    for (int64_t i = 0; i < count; i++) {
        static const int32_t strange[] = {-1, -2, -3, INT32_MIN, INT32_MAX, 1000};
        for (size_t s = 0; s < sizeof strange / sizeof *strange; s++)
            if (strange[s] != numbers[i])
                try_value(damage, table, numbers + i, i, strange[s], choice);
        for (int32_t value = 0; value < 40; value++)
            if (value != numbers[i])
                try_value(damage, table, numbers + i, i, value, choice);
    }
    assert_int_equal(damage->check(damage->self, NULL), 0);
}
