/* The journal of a bench run; see journal.h. */
#include "bench/compare/journal.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const schema = "meshgrade-bench-journal-1";

/* Reads the next line as an object; NULL at the end, or when the line was cut or is none. */
static json_t *read_entry(FILE *file, char **line, size_t *capacity)
{
    ssize_t length = getline(line, capacity, file);
    if (length <= 0 || (*line)[length - 1] != '\n')
        return NULL;
    json_t *entry = json_loadb(*line, (size_t)length, 0, NULL);
    if (entry && !json_is_object(entry)) {
        json_decref(entry);
        return NULL;
    }
    return entry;
}

static bool is_ours(const json_t *first, const char *fingerprint)
{
    const char *said = json_string_value(json_object_get(first, "fingerprint"));
    const char *kind = json_string_value(json_object_get(first, "schema"));
    return said && kind && strcmp(said, fingerprint) == 0 && strcmp(kind, schema) == 0;
}

/* Reads what is there and leaves the file at the end of its last whole line. Returns whether the
 * journal is one of ours. */
static bool read_all(struct journal *journal, const char *fingerprint)
{
    char *line = NULL;
    size_t capacity = 0;
    json_t *entry = read_entry(journal->file, &line, &capacity);
    bool ours = is_ours(entry, fingerprint);
    long end = ftell(journal->file);
    json_decref(entry);
    while (ours && (entry = read_entry(journal->file, &line, &capacity)) != NULL) {
        json_array_append_new(journal->entries, entry);
        end = ftell(journal->file);
    }
    free(line);
    if (ours &&
        (fseek(journal->file, end, SEEK_SET) != 0 || ftruncate(fileno(journal->file), end) != 0))
        ours = false;
    return ours;
}

static int write_line(struct journal *journal, const json_t *entry, struct error *err)
{
    char *text = json_dumps(entry, JSON_COMPACT | JSON_REAL_PRECISION(10));
    int result = text && fprintf(journal->file, "%s\n", text) > 0 && fflush(journal->file) == 0
                     ? 0
                     : error_set(err, "the journal cannot be written: %s", strerror(errno));
    free(text);
    return result;
}

static int begin_anew(struct journal *journal, const char *path, const char *fingerprint,
                      struct error *err)
{
    journal->file = fopen(path, "w+e");
    if (!journal->file)
        return error_set(err, "%s: %s", path, strerror(errno));
    json_t *first = json_pack("{s:s, s:s}", "schema", schema, "fingerprint", fingerprint);
    int result = first ? write_line(journal, first, err) : error_set(err, "out of memory");
    json_decref(first);
    return result;
}

int journal_open(struct journal *journal, const char *folder, const char *fingerprint,
                 struct error *err)
{
    char path[PATH_MAX], old[PATH_MAX];
    *journal = (struct journal){.entries = json_array()};
    if (snprintf(path, sizeof path, "%s/journal.jsonl", folder) >= (int)sizeof path - 4)
        return error_set(err, "%s: too long a name", folder);
    snprintf(old, sizeof old, "%.*s.old", (int)sizeof path - 5, path);
    journal->file = fopen(path, "r+e");
    if (journal->file && read_all(journal, fingerprint)) {
        journal->is_resumed = json_array_size(journal->entries) > 0;
        return 0;
    }
    if (journal->file) {
        fclose(journal->file);
        journal->file = NULL;
        journal->was_other = rename(path, old) == 0;
        json_array_clear(journal->entries);
    }
    if (begin_anew(journal, path, fingerprint, err) == 0)
        return 0;
    journal_close(journal);
    return -1;
}

int journal_add(struct journal *journal, json_t *entry, struct error *err)
{
    if (!entry || json_array_append_new(journal->entries, entry) != 0)
        return error_set(err, "out of memory: the journal");
    return write_line(journal, entry, err);
}

const json_t *journal_find(const struct journal *journal, const char *job, int block)
{
    size_t i;
    const json_t *entry;
    json_array_foreach(journal->entries, i, entry)
    {
        const char *name = json_string_value(json_object_get(entry, "job"));
        if (name && strcmp(name, job) == 0 &&
            json_integer_value(json_object_get(entry, "block")) == block)
            return entry;
    }
    return NULL;
}

void journal_close(struct journal *journal)
{
    if (journal->file)
        fclose(journal->file);
    json_decref(journal->entries);
    *journal = (struct journal){0};
}
