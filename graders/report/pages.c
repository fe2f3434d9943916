/* Writes the pages and what they load; see report.h. */
#include "graders/report/report.h"

#include "graders/report/documents.h"
#include "graders/report/page.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { ASSET_LIMIT_BYTES = 8 << 20 };

/* Debian's libjs-three, in the order in which the scripts are loaded; the last is its licence. */
static const struct {
    const char *from, *to;
} three_files[] = {
    {"/usr/share/javascript/three/three.min.js", "three.min.js"},
    {"/usr/share/javascript/three/examples/js/controls/OrbitControls.js", "OrbitControls.js"},
    {"/usr/share/javascript/three/examples/js/lines/LineSegmentsGeometry.js",
     "LineSegmentsGeometry.js"},
    {"/usr/share/javascript/three/examples/js/lines/LineMaterial.js", "LineMaterial.js"},
    {"/usr/share/javascript/three/examples/js/lines/LineSegments2.js", "LineSegments2.js"},
    {"/usr/share/doc/libjs-three/copyright", "three-copyright.txt"},
};
enum { THREE_FILE_COUNT = sizeof three_files / sizeof *three_files };

static int copy_asset(const char *from, const char *out, const char *name, struct error *err)
{
    char to[DOCUMENT_PATH_BYTES];
    size_t length = 0;
    char *bytes = document_read(from, ASSET_LIMIT_BYTES, &length, err);
    int status = bytes && document_path(to, err, "%s/assets/%s", out, name) == 0
                     ? document_write(to, bytes, length, err)
                     : -1;
    free(bytes);
    return status;
}

static int copy_own_assets(const char *out, const char *root, struct error *err)
{
    static const char *const names[] = {"page.css", "page.js", "viewer.js", "viewer_scene.js"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char from[DOCUMENT_PATH_BYTES];
        if (document_path(from, err, "%s/graders/report/%s", root, names[i]) != 0 ||
            copy_asset(from, out, names[i], err) != 0)
            return -1;
    }
    return 0;
}

/* Copies the library. Returns whether all of it is there. */
static bool copy_three(const char *out)
{
    for (size_t i = 0; i < THREE_FILE_COUNT; i++) {
        /* Debian installs links to other names of the same file; what they lead to is copied. */
        char *real = realpath(three_files[i].from, NULL);
        struct error ignored = {""};
        int status = real ? copy_asset(real, out, three_files[i].to, &ignored) : -1;
        free(real);
        if (status != 0)
            return false;
    }
    return true;
}

int page_assets(const char *out, const char *root, bool *has_three, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    if (document_path(path, err, "%s/assets", out) != 0 || document_make_folders(path, err) != 0 ||
        copy_own_assets(out, root, err) != 0)
        return -1;
    *has_three = copy_three(out);
    return 0;
}

static int write_page(struct html *page, const char *path, struct error *err)
{
    int status = html_finish(page, err);
    if (status == 0)
        status = document_write(path, page->text, page->length, err);
    html_release(page);
    return status;
}

static int write_class_page(const struct page_context *context, const struct gradebook *book,
                            struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    struct html page;
    if (document_path(path, err, "%s/index.html", context->out) != 0 || html_start(&page, err) != 0)
        return -1;
    page_class(&page, context, book);
    return write_page(&page, path, err);
}

static int write_student_page(const struct page_context *context, const struct gradebook *book,
                              const struct student *student, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    struct html page;
    if (document_path(path, err, "%s/students/%s.html", context->out, student->folder) != 0 ||
        html_start(&page, err) != 0)
        return -1;
    page_student(&page, context, book, student);
    return write_page(&page, path, err);
}

static int write_pages(const char *out, const char *root, const struct gradebook *book,
                       struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    bool has_three = false;
    if (document_path(path, err, "%s/students", out) != 0 ||
        document_make_folders(path, err) != 0 || page_assets(out, root, &has_three, err) != 0 ||
        document_path(path, err, "%s/pictures/status.json", out) != 0)
        return -1;
    struct error ignored = {""};
    json_t *pictures_status = access(path, R_OK) == 0 ? document_read_json(path, &ignored) : NULL;
    struct page_context context = {
        .out = out, .up = "", .has_three = has_three, .pictures_status = pictures_status};
    int status = write_class_page(&context, book, err);
    context.up = "../";
    for (size_t s = 0; status == 0 && s < book->student_count; s++)
        status = write_student_page(&context, book, &book->students[s], err);
    json_decref(pictures_status);
    return status;
}

int report_pages(const char *out, const char *root, struct error *err)
{
    struct gradebook book;
    if (gradebook_load(out, &book, err) != 0)
        return -1;
    int status = write_pages(out, root, &book, err);
    gradebook_release(&book);
    return status;
}
