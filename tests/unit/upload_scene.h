/* What the tests of uploads share: a folder in which uploads are made, and what they must be read
 * as. One scene at a time. */
#ifndef TESTS_UNIT_UPLOAD_SCENE_H
#define TESTS_UNIT_UPLOAD_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/* The exercises that there are in a scene, NULL-terminated. */
extern const char *const upload_scene_exercises[];

/* An entry of an archive. */
struct upload_item {
    const char *path, *content; /* content: of a link, where it points to */
    mode_t type;                /* 0: regular file */
    size_t bytes;               /* 0: strlen(content) */
    bool is_hardlink;
};

/* Makes and removes the folder of the scene: cmocka's setup and teardown. */
int upload_scene_make(void **state);
int upload_scene_remove(void **state);

/* Where a name in the folder lies; good for the next three calls. */
const char *upload_scene_path(const char *name);

/* Writes a whole file, by its path. */
void upload_scene_write(const char *path, const void *bytes, size_t count);

/* Writes a text below the folder, making folders on the way. */
void upload_scene_put(const char *name, const char *content);

/* Packs items, up to one without a path; the format by the ending of `name`. Returns the size. */
size_t upload_scene_pack(const char *name, const struct upload_item *items, void *into,
                         size_t capacity);

/* The same to a file below the folder. */
void upload_scene_put_archive(const char *name, const struct upload_item *items);

/* Reads paths below the folder (with blanks between) and renders the list: "student/exercise: file
 * file; ...", with the cause in brackets for what is refused. Good until the next call. */
const char *upload_scene_summary(const char *exercise, const char *names);

/* Expects that summary. */
void upload_scene_expect(const char *exercise, const char *names, const char *summary);

#endif
