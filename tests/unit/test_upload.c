/* From paths to submissions: every layout, every archive, and what hostile ones try. */
#include "graders/engine/upload/archive.h"
#include "graders/engine/upload/upload.h"
#include "tests/unit/upload_scene.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <ftw.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

/* ---------------------------------------------------------------- layouts */

static void folders_of_students_are_read(void **state)
{
    (void)state;
    upload_scene_put("class/ana/edge-table-any.c", "int a;");
    upload_scene_put("class/ana/Mesh_Area.C", "int b;");
    upload_scene_put("class/ana/list.h", "int c;");
    upload_scene_put("class/ana/mesh-area.h", "the public header");
    upload_scene_put("class/ana/notes.txt", "hello");
    upload_scene_put("class/bea/edge_table_any/main.c", "int a;");
    upload_scene_put("class/bea/edge_table_any/list.c", "int a;");
    upload_scene_put("class/bea/edge_table_any/deep/list.h", "int a;");
    upload_scene_put("class/bea/edge_table_any/edge-table-any.h", "the public header");
    upload_scene_put("class/bea/edge_table_any/Makefile", "all:");
    upload_scene_put("class/carla/homework 1/memory-strips.c", "int a;");
    upload_scene_put("class/README.md", "hello");
    upload_scene_put("class/.git/HEAD", "hello");
    upload_scene_expect(
        NULL, "class",
        "ana/edge-table-any: edge-table-any.c list.h; ana/mesh-area: Mesh_Area.c list.h; "
        "bea/edge-table-any: list.c list.h main.c; carla/memory-strips: memory-strips.c");
    upload_scene_expect(NULL, "class/ana",
                        "ana/edge-table-any: edge-table-any.c list.h; "
                        "ana/mesh-area: Mesh_Area.c list.h");
    upload_scene_expect(
        NULL, "class/ana class/carla",
        "ana/edge-table-any: edge-table-any.c list.h; ana/mesh-area: Mesh_Area.c list.h; "
        "carla/memory-strips: memory-strips.c");
}

static void contents_and_notes_are_kept(void **state)
{
    (void)state;
    upload_scene_put("class/ana/mesh-area.c", "int a;");
    upload_scene_put("class/ana/notes.txt", "hello");
    upload_scene_put("class/ana/mesh-area.h", "mine");
    upload_scene_put("class/ana/other.c", "int b;");
    upload_scene_put("class/bea/mesh-area.c", "");
    const char *path = upload_scene_path("class");
    struct upload_list list;
    assert_int_equal(upload_read(&path, 1, upload_scene_exercises, NULL, &list, NULL), 0);
    assert_int_equal(list.count, 2);
    assert_string_equal(list.uploads[0].student, "ana");
    assert_ptr_equal(list.uploads[0].exercise, upload_scene_exercises[1]);
    assert_int_equal(list.uploads[0].files[0].count, 6);
    assert_memory_equal(list.uploads[0].files[0].bytes, "int a;", 6);
    assert_int_equal(list.uploads[1].files[0].count, 0);
    assert_int_equal(list.note_count, 3);
    assert_string_equal(list.notes[1], "class/ana/notes.txt: not taken (no .c or .h file)");
    upload_list_release(&list);
}

static const struct upload_item one_class[] = {
    {.path = "./", .type = AE_IFDIR},
    {.path = "./homework/", .type = AE_IFDIR},
    {.path = "./homework/zoe/mesh-area.c", .content = "int a;"},
    {.path = "./homework/__MACOSX/zoe/._mesh-area.c", .content = "x"},
    {.path = "./homework/zoe/.DS_Store", .content = "x"},
    {.path = "./homework/ana/edge-table-any/x.c", .content = "int a;"},
    {0}};

static void archives_are_read(void **state)
{
    (void)state;
    static const char *const names[] = {"class.zip", "class.tar",     "class.tar.gz",
                                        "class.tgz", "class.tar.bz2", "class.tar.xz"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        upload_scene_put_archive(names[i], one_class);
        upload_scene_expect(NULL, names[i], "ana/edge-table-any: x.c; zoe/mesh-area: mesh-area.c");
    }
}

static void one_archive_a_student_is_read(void **state)
{
    (void)state;
    const struct upload_item flat[] = {{.path = "mesh-area.c", .content = "int a;"}, {0}};
    const struct upload_item deep[] = {{.path = "entrega/mesh-area.c", .content = "int a;"},
                                       {.path = "entrega/edge-table-any.c", .content = "int a;"},
                                       {0}};
    upload_scene_put_archive("class/ana.zip", flat);
    upload_scene_put_archive("class/bea.tar.gz", deep);
    upload_scene_put("class/carla/mesh-area.c", "int a;");
    upload_scene_expect(NULL, "class",
                        "ana/mesh-area: mesh-area.c; bea/edge-table-any: edge-table-any.c; "
                        "bea/mesh-area: mesh-area.c; carla/mesh-area: mesh-area.c");
    upload_scene_expect(NULL, "class/ana.zip class/bea.tar.gz",
                        "ana/mesh-area: mesh-area.c; bea/edge-table-any: edge-table-any.c; "
                        "bea/mesh-area: mesh-area.c");
    upload_scene_expect(NULL, "class/ana.zip", "ana/mesh-area: mesh-area.c");
    char inner[4096];
    size_t count = upload_scene_pack(".zip", deep, inner, sizeof inner);
    const struct upload_item outer[] = {{.path = "g/ana.zip", .content = inner, .bytes = count},
                                        {.path = "g/bea/mesh-area.c", .content = "int a;"},
                                        {0}};
    upload_scene_put_archive("outer.zip", outer);
    upload_scene_expect(NULL, "outer.zip",
                        "ana/edge-table-any: edge-table-any.c; ana/mesh-area: mesh-area.c; "
                        "bea/mesh-area: mesh-area.c");
}

static void groups_of_students_are_looked_through(void **state)
{
    (void)state;
    upload_scene_put("class/group-1/ana/mesh-area.c", "int a;");
    upload_scene_put("class/group-1/bea/mesh-area.c", "int a;");
    upload_scene_put("class/group-2/carla/mesh-area.c", "int a;");
    upload_scene_put("class/group-2/dora/mesh-area.c", "int a;");
    upload_scene_expect(NULL, "class",
                        "ana/mesh-area: mesh-area.c; bea/mesh-area: mesh-area.c; "
                        "carla/mesh-area: mesh-area.c; dora/mesh-area: mesh-area.c");
    upload_scene_put("by/mesh-area/ana/mesh-area.c", "int a;");
    upload_scene_put("by/mesh-area/bea/mesh-area.c", "int a;");
    upload_scene_expect(NULL, "by", "ana/mesh-area: mesh-area.c; bea/mesh-area: mesh-area.c");
}

static void moodle_and_gradescope_are_read(void **state)
{
    (void)state;
    char inner[4096];
    const struct upload_item zipped[] = {{.path = "tarea/mesh-area.c", .content = "int a;"}, {0}};
    size_t count = upload_scene_pack(".zip", zipped, inner, sizeof inner);
    const struct upload_item moodle[] = {
        {.path = "Ana Pérez_11_assignsubmission_file_/mesh-area.c", .content = "int a;"},
        {.path = "Ana Pérez_12_assignsubmission_file_/mesh-area.c", .content = "int a;"},
        {.path = "Ana Pérez_11_assignsubmission_onlinetext_/onlinetext.html", .content = "x"},
        {.path = "Bruno Conti_13_assignsubmission_file_/entrega.zip",
         .content = inner,
         .bytes = count},
        {.path = "Carla_14_assignsubmission_file_edge-table-any.c", .content = "int a;"},
        {0}};
    upload_scene_put_archive("mesh-area-1234.zip", moodle);
    upload_scene_expect(
        NULL, "mesh-area-1234.zip",
        "Ana-Perez/mesh-area: mesh-area.c; Ana-Perez-2/mesh-area: mesh-area.c; "
        "Bruno-Conti/mesh-area: mesh-area.c; Carla/edge-table-any: edge-table-any.c");
    static const char metadata[] =
        "---\nsubmission_501:\n  :submitters:\n  - :name: Dora Núñez\n"
        "    :sid: '1'\n    :email: d@x\n  - :name: \"Eva\"\n  :score: 1.0\n"
        "submission_502:\n  :submitters:\n  - :name: Fabio\n";
    const struct upload_item gradescope[] = {
        {.path = "assignment_9_export/submission_metadata.yml", .content = metadata},
        {.path = "assignment_9_export/submission_501/mesh-area.c", .content = "int a;"},
        {.path = "assignment_9_export/submission_502/src/mesh-area.c", .content = "int a;"},
        {.path = "assignment_9_export/submission_503/mesh-area.c", .content = "int a;"},
        {0}};
    upload_scene_put_archive("export.zip", gradescope);
    upload_scene_expect(NULL, "export.zip",
                        "Dora-Nunez-Eva/mesh-area: mesh-area.c; Fabio/mesh-area: mesh-area.c; "
                        "submission_503/mesh-area: mesh-area.c");
}

static void single_files_are_read(void **state)
{
    (void)state;
    upload_scene_put("class/ana.c", "int a;");
    upload_scene_put("class/bea.c", "int a;");
    upload_scene_put("class/carla/x.c", "int a;");
    upload_scene_put("class/carla/y.h", "int a;");
    upload_scene_put("dora/mesh-area.c", "int a;");
    upload_scene_put("dora/edge-table-any.c", "int a;");
    upload_scene_expect("mesh-area", "class",
                        "ana/mesh-area: ana.c; bea/mesh-area: bea.c; carla/mesh-area: x.c y.h");
    upload_scene_expect("mesh-area", "class/ana.c", "ana/mesh-area: ana.c");
    upload_scene_expect("mesh-area", "dora/mesh-area.c", "dora/mesh-area: mesh-area.c");
    upload_scene_expect(NULL, "dora/mesh-area.c dora/edge-table-any.c",
                        "dora/edge-table-any: edge-table-any.c; dora/mesh-area: mesh-area.c");
    upload_scene_expect(NULL, "class/ana.c", "ana/?: [no-source]");
    const char *paths[] = {upload_scene_path("class/carla/x.c"),
                           upload_scene_path("class/carla/y.h")};
    struct upload upload;
    assert_int_equal(upload_read_files(paths, 2, "mesh-area", &upload, NULL), 0);
    assert_int_equal(upload.file_count, 2);
    assert_string_equal(upload.student, "");
    assert_false(upload.refusal.refused);
    upload_release(&upload);
    assert_int_equal(upload_read_files(paths + 1, 1, "mesh-area", &upload, NULL), 0);
    assert_string_equal(upload.refusal.cause, "no-source");
    upload_release(&upload);
}

static void the_order_is_always_the_same(void **state)
{
    (void)state;
    upload_scene_put("a/x/mesh-area.c", "int a;");
    upload_scene_put("a/y/mesh-area.c", "int a;");
    upload_scene_put("b/x/mesh-area.c", "int b;");
    upload_scene_put("b/y-2/mesh-area.c", "int b;");
    char first[512];
    snprintf(first, sizeof first, "%s", upload_scene_summary(NULL, "a b"));
    upload_scene_expect(NULL, "b a", first);
    upload_scene_expect(NULL, "b a b a", first);
    assert_string_equal(first, "x/mesh-area: mesh-area.c; x-2/mesh-area: mesh-area.c; "
                               "y/mesh-area: mesh-area.c; y-2/mesh-area: mesh-area.c");
}

static void wrong_paths_are_errors(void **state)
{
    (void)state;
    const char *missing = upload_scene_path("missing");
    struct upload_list list;
    struct error err = {0};
    assert_int_equal(upload_read(&missing, 1, upload_scene_exercises, NULL, &list, &err), -1);
    assert_non_null(strstr(err.text, "missing"));
    upload_list_release(&list);
    upload_scene_put("x.txt", "x");
    const char *text = upload_scene_path("x.txt");
    assert_int_equal(upload_read(&text, 1, upload_scene_exercises, NULL, &list, NULL), -1);
    upload_list_release(&list);
    assert_int_equal(upload_read(&text, 1, upload_scene_exercises, "no-such", &list, NULL), -1);
    upload_list_release(&list);
    assert_int_equal(upload_read(&text, 0, upload_scene_exercises, NULL, &list, NULL), 0);
    assert_int_equal(list.count, 0);
    upload_list_release(&list);
}

static void refuses_a_name_for_what_is_wrong_with_it(const char *name, const char *why,
                                                     const char *why_es)
{
    struct upload upload;
    struct error err = {""};
    const char *path = upload_scene_path(name);
    upload_scene_put(name, "int a;");
    assert_int_equal(upload_read_files(&path, 1, "mesh-area", &upload, &err), 0);
    assert_int_equal(upload.refusal.refused, why != NULL);
    if (why) {
        assert_string_equal(upload.refusal.cause, "file-name");
        assert_non_null(strstr(upload.refusal.message.en, why));
        assert_non_null(strstr(upload.refusal.message.es, why_es));
    }
    upload_release(&upload);
}

static void names_that_are_refused(void **state)
{
    char name[UPLOAD_NAME_BYTES + 2];
    (void)state;
    memset(name, 'a', sizeof name);
    memcpy(name + UPLOAD_NAME_BYTES - 2, ".c", 3);
    refuses_a_name_for_what_is_wrong_with_it(name, NULL, NULL);
    memcpy(name + UPLOAD_NAME_BYTES - 2, "a.c", 4);
    refuses_a_name_for_what_is_wrong_with_it(name, "too long: it has 64 characters, at most 63",
                                             "demasiado largo: tiene 64 caracteres");
    refuses_a_name_for_what_is_wrong_with_it("mesh area.c", "use letters", "use solo letras");
}

/* ---------------------------------------------------------------- refusals */

static void refusals_stay_with_their_student(void **state)
{
    (void)state;
    static char large[UPLOAD_FILE_BYTES + 1];
    memset(large, 'x', sizeof large);
    upload_scene_put("class/ana/mesh-area.c", "int a;");
    upload_scene_put("class/bea/mesh-area.c", "");
    upload_scene_write(upload_scene_path("class/bea/mesh-area.c"), large, sizeof large);
    upload_scene_put("class/bea/edge-table-any.c", "int a;");
    upload_scene_put("class/carla/mesh-area/x.c", "int a;");
    assert_int_equal(symlink("/etc/passwd", upload_scene_path("class/carla/mesh-area/y.h")), 0);
    upload_scene_put("class/dora/x", "");
    assert_int_equal(symlink("/etc/passwd", upload_scene_path("class/dora/mesh-area.c")), 0);
    upload_scene_put("class/eva/x", "");
    assert_int_equal(mkfifo(upload_scene_path("class/eva/mesh-area.c"), 0600), 0);
    upload_scene_put("class/fabio/tabla.c", "int a;");
    upload_scene_put("class/gina/mesh-area/a;rm -rf ~.c", "int a;");
    upload_scene_put("class/hugo/mesh-area/-o.c", "int a;");
    upload_scene_put("class/iris/mesh-area.c", "int a;");
    upload_scene_put("class/iris/mesh-area/x.c", "int a;");
    upload_scene_put("class/jan/mesh-area/a/x.c", "int a;");
    upload_scene_put("class/jan/mesh-area/b/X.c", "int a;");
    upload_scene_put("class/kim/mesh-area/x.h", "int a;");
    upload_scene_expect(
        NULL, "class",
        "ana/mesh-area: mesh-area.c; bea/edge-table-any: edge-table-any.c; "
        "bea/mesh-area: [file-too-large]; carla/mesh-area: [link]; dora/mesh-area: [link]; "
        "eva/mesh-area: [device]; fabio/?: [no-source]; gina/mesh-area: [file-name]; "
        "hugo/mesh-area: [file-name]; iris/mesh-area: [file-twice]; jan/mesh-area: [file-twice]");
    for (int i = 0; i <= UPLOAD_FILES; i++) {
        char name[64];
        snprintf(name, sizeof name, "many/lea/mesh-area/f%d.c", i);
        upload_scene_put(name, "int a;");
    }
    upload_scene_expect(NULL, "many", "lea/mesh-area: [too-many-files]");
}

/* Reads as somebody who may not read everything, though the test be root. */
static void expect_as_nobody(const char *names, const char *summary)
{
    bool is_root = geteuid() == 0;
    if (is_root)
        assert_int_equal(seteuid(65534), 0);
    char found[512];
    snprintf(found, sizeof found, "%s", upload_scene_summary(NULL, names));
    if (is_root)
        assert_int_equal(seteuid(0), 0);
    assert_string_equal(found, summary);
}

static void what_cannot_be_read_stays_with_its_student(void **state)
{
    (void)state;
    static const char *const open_to_all[] = {"", "class", "class/ana", "class/bea", "class/carla"};
    static const char *const closed[] = {"class/bea/mesh-area.c", "class/bea/notes.txt",
                                         "class/carla/x", "class/dora", "class/eva.zip"};
    upload_scene_put("class/ana/mesh-area.c", "int a;");
    upload_scene_put("class/bea/mesh-area.c", "int a;");
    upload_scene_put("class/bea/notes.txt", "hello");
    upload_scene_put("class/carla/mesh-area.c", "int a;");
    upload_scene_put("class/carla/x/y.c", "int a;");
    upload_scene_put("class/dora/mesh-area.c", "int a;");
    upload_scene_put("class/eva.zip", "");
    for (size_t i = 0; i < sizeof open_to_all / sizeof open_to_all[0]; i++)
        assert_int_equal(chmod(upload_scene_path(open_to_all[i]), 0755), 0);
    for (size_t i = 0; i < sizeof closed / sizeof closed[0]; i++)
        assert_int_equal(chmod(upload_scene_path(closed[i]), 0), 0);
    static const char summary[] =
        "ana/mesh-area: mesh-area.c; bea/mesh-area: [unreadable]; "
        "carla/mesh-area: [folder-unreadable]; dora/?: [folder-unreadable]; "
        "eva/?: [archive-unreadable]";
    expect_as_nobody("class", summary);
    assert_int_equal(chmod(upload_scene_path("class/dora"), 0444),
                     0); /* may be listed, not entered */
    expect_as_nobody("class", summary);
    assert_int_equal(chmod(upload_scene_path("class/dora"), 0755), 0);
    assert_int_equal(chmod(upload_scene_path("class/carla/x"), 0755), 0);
}

static void odd_paths_stay_with_their_student(void **state)
{
    (void)state;
    upload_scene_put("class/ana/mesh-area.c", "int a;");
    upload_scene_put("class/bea/mesh-area.c", "int a;");
    upload_scene_put("class/bea/src\\main.c", "int a;");
    upload_scene_put("class/carla/mesh-area.c", "int a;");
    upload_scene_put("class/carla/a/a/a/a/a/a/a/a/a/a/a/a/a/a/a/a/a/a/a/x.c", "int a;");
    upload_scene_put("class/dora\\1/mesh-area.c", "int a;");
    upload_scene_expect(NULL, "class",
                        "ana/mesh-area: mesh-area.c; bea/mesh-area: [folder-path]; "
                        "carla/mesh-area: [folder-path]; dora_1/?: [folder-path]");
}

/* One student's hostile archive beside an honest one: only the hostile is refused. */
static void expect_hostile(const char *ending, const struct upload_item *items, const char *cause)
{
    char name[64], summary[128];
    snprintf(name, sizeof name, "hostile/mallory%s", ending);
    upload_scene_put("hostile/ana/mesh-area.c", "int a;");
    upload_scene_put_archive(name, items);
    snprintf(summary, sizeof summary, "ana/mesh-area: mesh-area.c; mallory/%s: [%s]",
             items[0].path && strcmp(items[0].path, "mesh-area.c") == 0 ? "mesh-area" : "?", cause);
    upload_scene_expect(NULL, "hostile", summary);
    unlink(upload_scene_path(name));
}

static void hostile_entries_are_refused(void **state)
{
    (void)state;
#define HONEST {.path = "mesh-area.c", .content = "int a;"}
    expect_hostile(".tar",
                   (struct upload_item[]){HONEST, {.path = "../evil.c", .content = "x"}, {0}},
                   "archive-path");
    expect_hostile(".zip",
                   (struct upload_item[]){HONEST, {.path = "a/../../evil.c", .content = "x"}, {0}},
                   "archive-path");
    expect_hostile(".tar",
                   (struct upload_item[]){HONEST, {.path = "/etc/evil.c", .content = "x"}, {0}},
                   "archive-path");
    expect_hostile(".tar",
                   (struct upload_item[]){HONEST, {.path = "C:\\evil.c", .content = "x"}, {0}},
                   "archive-path");
    expect_hostile(
        ".tar", (struct upload_item[]){HONEST, {.path = "x\\..\\..\\evil.c", .content = "x"}, {0}},
        "archive-path");
    expect_hostile(
        ".tar",
        (struct upload_item[]){HONEST, {.path = "l", .content = "/etc", .type = AE_IFLNK}, {0}},
        "archive-link");
    expect_hostile(
        ".zip",
        (struct upload_item[]){HONEST, {.path = "l", .content = "/etc", .type = AE_IFLNK}, {0}},
        "archive-link");
    expect_hostile(".tar",
                   (struct upload_item[]){
                       HONEST, {.path = "h.c", .content = "mesh-area.c", .is_hardlink = true}, {0}},
                   "archive-link");
    expect_hostile(".tar", (struct upload_item[]){HONEST, {.path = "d", .type = AE_IFCHR}, {0}},
                   "archive-device");
    expect_hostile(".tar", (struct upload_item[]){HONEST, {.path = "p", .type = AE_IFIFO}, {0}},
                   "archive-device");
    expect_hostile(".tar.gz",
                   (struct upload_item[]){HONEST, {.path = "x.rar", .content = "x"}, {0}},
                   "archive-kind");
    expect_hostile(".tar.gz", (struct upload_item[]){HONEST, HONEST, {0}}, "file-twice");
    expect_hostile(".zip", (struct upload_item[]){{0}}, "archive-broken");
#undef HONEST
}

static void bombs_and_damage_are_refused(void **state)
{
    (void)state;
    enum { ZEROS = 64 << 20 };
    char *zeros = calloc(1, ZEROS);
    assert_non_null(zeros);
    expect_hostile(
        ".tar.gz",
        (struct upload_item[]){{.path = "zeros.bin", .content = zeros, .bytes = ZEROS}, {0}},
        "archive-ratio");
    expect_hostile(
        ".zip",
        (struct upload_item[]){{.path = "zeros.bin", .content = zeros, .bytes = ZEROS}, {0}},
        "archive-ratio");
    expect_hostile(
        ".tar.xz",
        (struct upload_item[]){{.path = "zeros.bin", .content = zeros, .bytes = ZEROS}, {0}},
        "archive-ratio");
    free(zeros);
    static struct upload_item many[ARCHIVE_NESTED_ENTRIES + 3];
    for (int i = 0; i < ARCHIVE_NESTED_ENTRIES + 2; i++)
        many[i] = (struct upload_item){.path = "d", .type = AE_IFDIR};
    char *inner = malloc(4 << 20), *middle = malloc(4 << 20);
    assert_non_null(inner);
    assert_non_null(middle);
    size_t count = upload_scene_pack(".tar.gz", many, inner, 4 << 20);
    expect_hostile(
        ".zip", (struct upload_item[]){{.path = "n.tar.gz", .content = inner, .bytes = count}, {0}},
        "archive-too-many");
    count = upload_scene_pack(
        ".zip", (struct upload_item[]){{.path = "mesh-area.c", .content = "int a;"}, {0}}, inner,
        4 << 20);
    count = upload_scene_pack(
        ".zip", (struct upload_item[]){{.path = "i.zip", .content = inner, .bytes = count}, {0}},
        middle, 4 << 20);
    expect_hostile(
        ".zip", (struct upload_item[]){{.path = "m.zip", .content = middle, .bytes = count}, {0}},
        "archive-nested");
    count = upload_scene_pack(
        ".tar.gz", (struct upload_item[]){{.path = "mesh-area.c", .content = "int a;"}, {0}}, inner,
        4 << 20);
    upload_scene_put("hostile/cut.tar.gz", "");
    upload_scene_write(upload_scene_path("hostile/cut.tar.gz"), inner, count / 2);
    upload_scene_put("hostile/text.zip", "this is no archive");
    upload_scene_put("hostile/empty.zip", "");
    upload_scene_expect(
        NULL, "hostile",
        "ana/mesh-area: mesh-area.c; cut/?: [archive-broken]; empty/?: [archive-broken]; "
        "text/?: [archive-broken]");
    upload_scene_expect(NULL, "hostile/text.zip", "text/?: [archive-broken]");
    free(inner);
    free(middle);
}

int main(void)
{
#define TEST(function)                                                                             \
    cmocka_unit_test_setup_teardown(function, upload_scene_make, upload_scene_remove)
    const struct CMUnitTest tests[] = {
        TEST(folders_of_students_are_read),
        TEST(contents_and_notes_are_kept),
        TEST(archives_are_read),
        TEST(one_archive_a_student_is_read),
        TEST(groups_of_students_are_looked_through),
        TEST(moodle_and_gradescope_are_read),
        TEST(single_files_are_read),
        TEST(the_order_is_always_the_same),
        TEST(wrong_paths_are_errors),
        TEST(names_that_are_refused),
        TEST(refusals_stay_with_their_student),
        TEST(what_cannot_be_read_stays_with_its_student),
        TEST(odd_paths_stay_with_their_student),
        TEST(hostile_entries_are_refused),
        TEST(bombs_and_damage_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
