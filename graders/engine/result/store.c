/* The SQLite store; see store.h. */
#include "graders/engine/result/store.h"

#include "graders/engine/base/files.h"
#include "reference/base/listing.h"

#include <errno.h>
#include <limits.h>
#include <nettle/sha2.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>

enum { STORE_VERSION = 3 };

static const char SCHEMA[] = "BEGIN IMMEDIATE;"
                             "CREATE TABLE IF NOT EXISTS result ("
                             " student_folder TEXT NOT NULL, exercise TEXT NOT NULL,"
                             " digest TEXT NOT NULL, result TEXT NOT NULL, scenes TEXT NOT NULL,"
                             " seal TEXT NOT NULL,"
                             " PRIMARY KEY (student_folder, exercise));"
                             "CREATE TABLE IF NOT EXISTS class ("
                             " one INTEGER PRIMARY KEY CHECK (one = 1),"
                             " seed TEXT NOT NULL, seal TEXT NOT NULL);"
                             "PRAGMA user_version = 3;"
                             "COMMIT;";

static int complain(const struct store *store, struct error *err)
{
    return error_set(err, "meshgrade.sqlite: %s (move the file away to grade the class anew)",
                     store->database ? sqlite3_errmsg(store->database) : "out of memory");
}

static int read_version(struct store *store, int *version, struct error *err)
{
    sqlite3_stmt *query = NULL;
    int result = -1;
    if (sqlite3_prepare_v2(store->database, "PRAGMA user_version", -1, &query, NULL) == SQLITE_OK &&
        sqlite3_step(query) == SQLITE_ROW) {
        *version = sqlite3_column_int(query, 0);
        result = 0;
    } else {
        complain(store, err);
    }
    sqlite3_finalize(query);
    return result;
}

int store_open(struct store *store, const char *out, struct error *err)
{
    char path[PATH_MAX];
    int version;
    store->database = NULL;
    if (folder_make(out, err) != 0)
        return -1;
    if (file_path(path, err, "%s/meshgrade.sqlite", out) != 0)
        return -1;
    if (sqlite3_open_v2(path, &store->database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, NULL) !=
        SQLITE_OK)
        return complain(store, err);
    sqlite3_busy_timeout(store->database, 10000);
    if (read_version(store, &version, err) != 0)
        return -1;
    if (version != 0 && version != STORE_VERSION)
        return error_set(
            err,
            "%s: written by %s meshgrade (store version %d); move the file away to grade "
            "the class anew",
            path, version > STORE_VERSION ? "a newer" : "an older", version);
    if (sqlite3_exec(store->database, "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;", NULL,
                     NULL, NULL) != SQLITE_OK ||
        (version == 0 && sqlite3_exec(store->database, SCHEMA, NULL, NULL, NULL) != SQLITE_OK))
        return complain(store, err);
    return 0;
}

void store_close(struct store *store)
{
    sqlite3_close(store->database);
    store->database = NULL;
}

/* ------------------------------------------------------------------- rows */

/* The columns of a row, in the order of the table. */
enum column { STUDENT, EXERCISE, DIGEST, RESULT, SCENES, SEAL, COLUMNS };

#define SELECT_ROW "SELECT student_folder, exercise, digest, result, scenes, seal FROM result "

static void add_part(struct sha256_ctx *hash, const char *bytes, size_t count)
{
    uint64_t length = count;
    sha256_update(hash, sizeof length, (const uint8_t *)&length);
    sha256_update(hash, count, (const uint8_t *)bytes);
}

static void finish_digest(struct sha256_ctx *hash, char digest[STORE_DIGEST])
{
    uint8_t bytes[SHA256_DIGEST_SIZE];
    sha256_digest(hash, sizeof bytes, bytes);
    for (size_t i = 0; i < sizeof bytes; i++)
        snprintf(digest + 2 * i, 3, "%02x", bytes[i]);
}

/* SQLite notices a damaged page only where its own bookkeeping breaks. The seal, a hash of the
 * other columns, notices every changed byte: no mark comes from one. */
static void seal_row(const char *const columns[SEAL], char seal[STORE_DIGEST])
{
    struct sha256_ctx hash;
    sha256_init(&hash);
    for (int i = 0; i < SEAL; i++)
        add_part(&hash, columns[i], strlen(columns[i]));
    finish_digest(&hash, seal);
}

/* ------------------------------------------------------------------- seed */

static void seal_seed(const char *seed, char seal[STORE_DIGEST])
{
    struct sha256_ctx hash;
    sha256_init(&hash);
    add_part(&hash, seed, strlen(seed));
    finish_digest(&hash, seal);
}

/* Keeps a seed, unless there is one. */
static int put_seed(struct store *store, uint32_t seed, struct error *err)
{
    char text[16], seal[STORE_DIGEST];
    sqlite3_stmt *insert = NULL;
    snprintf(text, sizeof text, "%u", seed);
    seal_seed(text, seal);
    if (sqlite3_prepare_v2(store->database, "INSERT OR IGNORE INTO class VALUES (1, ?1, ?2)", -1,
                           &insert, NULL) != SQLITE_OK)
        return complain(store, err);
    sqlite3_bind_text(insert, 1, text, -1, SQLITE_STATIC);
    sqlite3_bind_text(insert, 2, seal, -1, SQLITE_STATIC);
    int result = sqlite3_step(insert) == SQLITE_DONE ? 0 : complain(store, err);
    sqlite3_finalize(insert);
    return result;
}

static int read_seed(struct store *store, uint32_t *seed, struct error *err)
{
    sqlite3_stmt *query = NULL;
    char seal[STORE_DIGEST];
    if (sqlite3_prepare_v2(store->database, "SELECT seed, seal FROM class", -1, &query, NULL) !=
        SQLITE_OK)
        return complain(store, err);
    bool found = sqlite3_step(query) == SQLITE_ROW;
    const char *text = found ? (const char *)sqlite3_column_text(query, 0) : NULL;
    const char *stored = found ? (const char *)sqlite3_column_text(query, 1) : NULL;
    int result = -1;
    if (text && stored)
        seal_seed(text, seal);
    if (text && stored && strcmp(seal, stored) == 0) {
        *seed = (uint32_t)strtoul(text, NULL, 10);
        result = 0;
    } else {
        error_set(err, "meshgrade.sqlite: the seed of the class is damaged (move the file away to "
                       "grade the class anew)");
    }
    sqlite3_finalize(query);
    return result;
}

int store_seed(struct store *store, uint32_t wanted, uint32_t *seed, struct error *err)
{
    uint32_t drawn = wanted;
    while (drawn == SEED_PUBLISHED)
        if (getrandom(&drawn, sizeof drawn, 0) != sizeof drawn)
            return error_set(err, "no random number for the seed of the class: %s",
                             strerror(errno));
    if (put_seed(store, drawn, err) != 0 || read_seed(store, seed, err) != 0)
        return -1;
    if (wanted != SEED_PUBLISHED && wanted != *seed)
        return error_set(err,
                         "--seed %u: the results in this folder are of seed %u; leave --seed out, "
                         "or take another folder",
                         wanted, *seed);
    return 0;
}

/* -------------------------------------------------------------------- read */

/* The texts of a row, borrowed from the statement. Returns 0, or -1 and *err when it is damaged. */
static int read_row(sqlite3_stmt *query, const char *columns[COLUMNS], struct error *err)
{
    char seal[STORE_DIGEST];
    for (int i = 0; i < COLUMNS; i++) {
        columns[i] = (const char *)sqlite3_column_text(query, i);
        if (columns[i])
            continue;
        error_set(err, "meshgrade.sqlite: a row lacks a text, or memory is short (move the file "
                       "away to grade the class anew)");
        return -1;
    }
    seal_row(columns, seal);
    if (strcmp(seal, columns[SEAL]) == 0)
        return 0;
    return error_set(
        err,
        "meshgrade.sqlite: the result of %.80s for %.80s is damaged (move the file away "
        "to grade the class anew)",
        columns[STUDENT], columns[EXERCISE]);
}

static int parse_result(const char *text, json_t **result, struct error *err)
{
    json_error_t why;
    *result = json_loads(text, 0, &why);
    return *result ? 0 : error_set(err, "meshgrade.sqlite: a result: %s", why.text);
}

int store_find(struct store *store, const char *student_folder, const char *exercise,
               const char *digest, json_t **result, struct error *err)
{
    sqlite3_stmt *query = NULL;
    const char *columns[COLUMNS];
    int found = 0;
    *result = NULL;
    if (sqlite3_prepare_v2(store->database,
                           SELECT_ROW "WHERE student_folder = ?1 AND exercise = ?2 "
                                      "AND (?3 IS NULL OR digest = ?3)",
                           -1, &query, NULL) != SQLITE_OK)
        return complain(store, err);
    sqlite3_bind_text(query, 1, student_folder, -1, SQLITE_STATIC);
    sqlite3_bind_text(query, 2, exercise, -1, SQLITE_STATIC);
    sqlite3_bind_text(query, 3, digest, -1, SQLITE_STATIC);
    int step = sqlite3_step(query);
    if (step == SQLITE_ROW) {
        found = read_row(query, columns, err);
        if (found == 0)
            found = parse_result(columns[RESULT], result, err);
    } else if (step != SQLITE_DONE) {
        found = complain(store, err);
    }
    sqlite3_finalize(query);
    return found;
}

/* Whether one result was made with other tools; tells how, unless something is told already. */
static bool has_other_tools(const json_t *result, const struct toolset *here, char *difference)
{
    const struct {
        const char *key, *here;
    } parts[] = {{"compiler", here->compiler},
                 {"libc", here->libc},
                 {"valgrind", here->valgrind},
                 {"layers", here->layers}};
    const json_t *engine = json_object_get(result, "engine");
    const char *verdict = json_string_value(json_object_get(result, "verdict"));
    if (!json_object_get(engine, "libc") || !verdict ||
        strcmp(verdict, verdict_name(VERDICT_FAULT)) == 0)
        return false;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        const char *there = json_string_value(json_object_get(engine, parts[i].key));
        if (!there || strcmp(there, parts[i].here) == 0)
            continue;
        if (!difference[0])
            snprintf(difference, STORE_DIFFERENCE, "%s: %.300s there, %.400s here", parts[i].key,
                     there[0] ? there : "none", parts[i].here[0] ? parts[i].here : "none");
        return true;
    }
    return false;
}

int store_compare_tools(struct store *store, const struct toolset *here,
                        char difference[STORE_DIFFERENCE], struct error *err)
{
    sqlite3_stmt *query = NULL;
    int count = 0, step = SQLITE_DONE;
    difference[0] = '\0';
    if (sqlite3_prepare_v2(store->database, SELECT_ROW "ORDER BY student_folder, exercise", -1,
                           &query, NULL) != SQLITE_OK)
        return complain(store, err);
    while (count >= 0 && (step = sqlite3_step(query)) == SQLITE_ROW) {
        const char *columns[COLUMNS];
        json_t *result = NULL;
        if (read_row(query, columns, err) != 0 || parse_result(columns[RESULT], &result, err) != 0)
            count = -1;
        else
            count += has_other_tools(result, here, difference);
        json_decref(result);
    }
    if (count >= 0 && step != SQLITE_DONE)
        count = complain(store, err);
    sqlite3_finalize(query);
    return count;
}

int store_put(struct store *store, const char *student_folder, const char *exercise,
              const char *digest, const struct outcome *outcome, struct error *err)
{
    sqlite3_stmt *insert = NULL;
    char *result = json_dumps(outcome->result, JSON_INDENT(2) | JSON_REAL_PRECISION(15));
    char seal[STORE_DIGEST];
    int done = -1;
    if (!result || !outcome->scenes) {
        error_set(err, "out of memory for a result");
    } else if (sqlite3_prepare_v2(store->database,
                                  "INSERT OR REPLACE INTO result VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
                                  -1, &insert, NULL) != SQLITE_OK) {
        complain(store, err);
    } else {
        const char *values[COLUMNS] = {student_folder, exercise,        digest,
                                       result,         outcome->scenes, seal};
        seal_row(values, seal);
        for (int i = 0; i < COLUMNS; i++)
            sqlite3_bind_text(insert, i + 1, values[i], -1, SQLITE_STATIC);
        done = sqlite3_step(insert) == SQLITE_DONE ? 0 : complain(store, err);
    }
    sqlite3_finalize(insert);
    free(result);
    return done;
}

int store_prune(struct store *store, const json_t *keep, struct error *err)
{
    sqlite3_stmt *query = NULL, *removal = NULL;
    if (sqlite3_prepare_v2(store->database, SELECT_ROW, -1, &query, NULL) != SQLITE_OK ||
        sqlite3_prepare_v2(store->database,
                           "DELETE FROM result WHERE student_folder = ?1 AND exercise = ?2", -1,
                           &removal, NULL) != SQLITE_OK) {
        sqlite3_finalize(query);
        return complain(store, err);
    }
    int result = 0, step = SQLITE_DONE;
    while (result == 0 && (step = sqlite3_step(query)) == SQLITE_ROW) {
        char key[PATH_MAX];
        const char *columns[COLUMNS];
        result = read_row(query, columns, err);
        if (result != 0)
            break;
        snprintf(key, sizeof key, "%s/%s", columns[STUDENT], columns[EXERCISE]);
        if (json_object_get(keep, key))
            continue;
        sqlite3_bind_text(removal, 1, columns[STUDENT], -1, SQLITE_TRANSIENT);
        sqlite3_bind_text(removal, 2, columns[EXERCISE], -1, SQLITE_TRANSIENT);
        if (sqlite3_step(removal) != SQLITE_DONE)
            result = complain(store, err);
        sqlite3_reset(removal);
    }
    if (result == 0 && step != SQLITE_DONE)
        result = complain(store, err);
    sqlite3_finalize(query);
    sqlite3_finalize(removal);
    return result;
}

/* ------------------------------------------------------------------- files */

/* Removes files of a folder that end in `ending` and are not in `kept` (path -> true). */
static int remove_others(const char *folder, const char *ending, const json_t *kept,
                         struct error *err)
{
    char **names = listing_files(folder, ending, err);
    int result = names ? 0 : -1;
    for (size_t i = 0; result == 0 && names[i]; i++) {
        char path[PATH_MAX];
        result = file_path(path, err, "%s/%s", folder, names[i]);
        if (result == 0 && !json_object_get(kept, path) && unlink(path) != 0)
            result = error_set(err, "%s: cannot be removed: %s", path, strerror(errno));
    }
    free(names);
    return result;
}

/* A student's folder of scenes and pictures: one folder an exercise. */
static int remove_other_pictures(const char *student, const json_t *kept, struct error *err)
{
    char **exercises = listing_folders(student, err);
    int result = exercises ? 0 : -1;
    for (size_t i = 0; result == 0 && exercises[i]; i++) {
        char folder[PATH_MAX];
        if (file_path(folder, err, "%s/%s", student, exercises[i]) != 0 ||
            remove_others(folder, ".json", kept, err) != 0 ||
            remove_others(folder, ".png", kept, err) != 0)
            result = -1;
    }
    free(exercises);
    return result;
}

static int remove_other_results(const char *student, const json_t *kept, struct error *err)
{
    return remove_others(student, ".json", kept, err);
}

/* Calls `remove` for each student's folder below OUT/part. */
static int for_each_student(const char *out, const char *part, const json_t *kept,
                            int (*remove)(const char *, const json_t *, struct error *),
                            struct error *err)
{
    char folder[PATH_MAX], student[PATH_MAX];
    if (file_path(folder, err, "%s/%s", out, part) != 0)
        return -1;
    char **students = listing_folders(folder, err);
    int result = students ? 0 : -1;
    for (size_t i = 0; result == 0 && students[i]; i++) {
        result = file_path(student, err, "%s/%s", folder, students[i]);
        if (result == 0)
            result = remove(student, kept, err);
    }
    free(students);
    return result;
}

/* Writes a file unless it holds just that already, so that pictures made from it stay fresh. */
static int write_kept(const char *path, const char *text, json_t *kept, struct error *err)
{
    char *present;
    size_t count;
    json_object_set_new(kept, path, json_true());
    if (file_read(path, 64 << 20, &present, &count, NULL) == 0) {
        bool same = count == strlen(text) && memcmp(present, text, count) == 0;
        free(present);
        if (same)
            return 0;
    }
    return file_write(path, text, strlen(text), err);
}

static int write_scenes(const char *out, const char *student, const char *exercise,
                        const char *text, json_t *kept, struct error *err)
{
    static const char *const endings[] = {".png", ".es.png"}; /* a picture in each language */
    char folder[PATH_MAX], path[PATH_MAX];
    const char *name;
    json_t *scene;
    json_auto_t *scenes = json_loads(text, 0, NULL);
    if (json_object_size(scenes) == 0)
        return 0;
    if (file_path(folder, err, "%s/pictures/%s/%s", out, student, exercise) != 0 ||
        folder_make(folder, err) != 0)
        return -1;
    json_object_foreach(scenes, name, scene)
    {
        if (file_path(path, err, "%s/%s.json", folder, name) != 0)
            return -1;
        char *bytes = json_dumps(scene, JSON_COMPACT | JSON_REAL_PRECISION(9));
        int written = bytes ? write_kept(path, bytes, kept, err)
                            : error_set(err, "out of memory for a scene");
        free(bytes);
        if (written != 0)
            return -1;
        for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
            if (file_path(path, err, "%s/%s%s", folder, name, endings[i]) != 0)
                return -1;
            json_object_set_new(kept, path, json_true());
        }
    }
    return 0;
}

static int write_row(sqlite3_stmt *row, const char *out, json_t *kept, struct error *err)
{
    char path[PATH_MAX];
    const char *columns[COLUMNS];
    if (read_row(row, columns, err) != 0)
        return -1;
    const char *student = columns[STUDENT], *exercise = columns[EXERCISE];
    if (file_path(path, err, "%s/results/%s", out, student) != 0 || folder_make(path, err) != 0 ||
        file_path(path, err, "%s/results/%s/%s.json", out, student, exercise) != 0)
        return -1;
    if (write_kept(path, columns[RESULT], kept, err) != 0)
        return -1;
    return write_scenes(out, student, exercise, columns[SCENES], kept, err);
}

int store_write_files(struct store *store, const char *out, struct error *err)
{
    sqlite3_stmt *query = NULL;
    int result = 0, step = SQLITE_DONE;
    json_auto_t *kept = json_object();
    if (sqlite3_prepare_v2(store->database, SELECT_ROW "ORDER BY student_folder, exercise", -1,
                           &query, NULL) != SQLITE_OK)
        return complain(store, err);
    while (result == 0 && (step = sqlite3_step(query)) == SQLITE_ROW)
        result = write_row(query, out, kept, err);
    if (result == 0 && step != SQLITE_DONE)
        result = complain(store, err);
    sqlite3_finalize(query);
    if (result == 0)
        result = for_each_student(out, "results", kept, remove_other_results, err);
    if (result == 0)
        result = for_each_student(out, "pictures", kept, remove_other_pictures, err);
    return result;
}

/* ------------------------------------------------------------------ digest */

void store_digest(const struct source *sources, int source_count, const char *refusal,
                  char digest[STORE_DIGEST])
{
    struct sha256_ctx hash;
    sha256_init(&hash);
    for (int i = 0; i < source_count; i++) {
        add_part(&hash, sources[i].name, strlen(sources[i].name));
        add_part(&hash, sources[i].bytes, sources[i].count);
    }
    add_part(&hash, refusal, strlen(refusal));
    finish_digest(&hash, digest);
}
