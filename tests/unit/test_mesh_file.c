/* Meshes in files: the extension chooses the format, and what cannot be read is named. */
#include "reference/formats/mesh_file.h"
#include "reference/mesh/generate.h"
#include "tests/unit/mesh_measures.h"

#include <locale.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[] = "/tmp/meshgrade-test-XXXXXX";
static char path[200];

static const char *in_folder(const char *name)
{
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    (void)state;
    return rmdir(folder);
}

static void every_format_comes_back(void **state)
{
    (void)state;
    static const char *const names[] = {"torus.ply", "torus.OBJ", "a.b.off"};
    struct mesh torus, back;
    assert_int_equal(generate_torus(&torus, 1, 500, NULL), 0);
    for (size_t i = 0; i < 3; i++) {
        struct error err = {0};
        assert_int_equal(mesh_file_write(in_folder(names[i]), &torus, &err), 0);
        assert_int_equal(mesh_file_read(path, &back, &err), 0);
        assert_true(same_mesh(&torus, &back));
        mesh_release(&back);
        assert_int_equal(unlink(path), 0);
    }
    mesh_release(&torus);
}

static void the_locale_changes_nothing(void **state)
{
    (void)state;
    /* Whichever of these exists writes 0,5; without any, the test says so. */
    if (!setlocale(LC_ALL, "es_ES.UTF-8") && !setlocale(LC_ALL, "de_DE.UTF-8") &&
        !setlocale(LC_ALL, "fr_FR.UTF-8"))
        skip();
    struct mesh cube, back;
    assert_int_equal(generate_cube(&cube, NULL), 0);
    assert_int_equal(mesh_file_write(in_folder("cube.off"), &cube, NULL), 0);
    assert_int_equal(mesh_file_read(path, &back, NULL), 0);
    assert_true(same_mesh(&cube, &back));
    char text[8];
    snprintf(text, sizeof text, "%.1f", 0.5);
    assert_string_equal(text, "0,5"); /* the program's own locale is as it was */
    setlocale(LC_ALL, "C");
    assert_int_equal(unlink(path), 0);
    mesh_release(&back);
    mesh_release(&cube);
}

static void assert_unreadable(const char *name, const char *error)
{
    struct mesh mesh;
    struct error err = {0};
    assert_int_equal(mesh_file_read(name, &mesh, &err), -1);
    assert_non_null(strstr(err.text, error));
    assert_null(mesh.positions);
}

static void what_is_no_mesh_file_is_refused(void **state)
{
    (void)state;
    assert_unreadable("bunny", "bunny: the name of a mesh ends with .ply, .obj or .off");
    assert_unreadable("bunny.stl", "the name of a mesh ends with");
    assert_unreadable(in_folder("absent.ply"), "absent.ply: No such file or directory");
    assert_int_equal(mkdir(in_folder("folder.ply"), 0700), 0);
    assert_unreadable(path, "folder.ply is not a regular file");
    assert_int_equal(rmdir(path), 0);
    assert_int_equal(mkfifo(in_folder("pipe.off"), 0600), 0);
    assert_unreadable(path, "pipe.off is not a regular file");
    assert_int_equal(unlink(path), 0);
}

static void errors_name_the_file_and_the_line(void **state)
{
    (void)state;
    FILE *file = fopen(in_folder("bad.obj"), "w");
    assert_non_null(file);
    fputs("v 0 0 0\nv 1 0\n", file);
    assert_int_equal(fclose(file), 0);
    assert_unreadable(path, "bad.obj:2: z is missing");
    assert_int_equal(unlink(path), 0);
}

static void what_cannot_be_written_is_named(void **state)
{
    (void)state;
    struct mesh cube;
    struct error err = {0};
    assert_int_equal(generate_cube(&cube, NULL), 0);
    assert_int_equal(mesh_file_write("cube.stl", &cube, &err), -1);
    assert_non_null(strstr(err.text, "ends with .ply, .obj or .off"));
    err.text[0] = '\0';
    assert_int_equal(mesh_file_write(in_folder("no/such/cube.ply"), &cube, &err), -1);
    assert_non_null(strstr(err.text, "cube.ply: No such file or directory"));
    err.text[0] = '\0';
    assert_int_equal(symlink("/dev/full", in_folder("full.ply")), 0);
    assert_int_equal(mesh_file_write(path, &cube, &err), -1);
    assert_non_null(strstr(err.text, "full.ply: writing a mesh: No space left on device"));
    assert_int_equal(unlink(path), 0);
    mesh_release(&cube);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_comes_back),
        cmocka_unit_test(the_locale_changes_nothing),
        cmocka_unit_test(what_is_no_mesh_file_is_refused),
        cmocka_unit_test(errors_name_the_file_and_the_line),
        cmocka_unit_test(what_cannot_be_written_is_named),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
