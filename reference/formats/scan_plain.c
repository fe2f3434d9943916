/* Plain rows; see scan_plain.h. Nothing here asks where the bytes end: every loop stops at the line
 * end at scan->plain_end at the latest. */
#include "reference/formats/scan_plain.h"

#include "reference/formats/number.h"

static inline const char *pass_blanks(const char *at)
{
    while (*at == ' ' || *at == '\t')
        at++;
    return at;
}

/* The place behind a line end, NULL when there is none or not a plain one. */
static inline const char *pass_line_end(const struct scan *scan, const char *at)
{
    if (*at == '\n')
        return at + 1;
    return *at == '\r' && at[1] == '\n' && scan->line_end != LINE_END_CR ? at + 2 : NULL;
}

static inline const char *row_start(const struct scan *scan, size_t skipped)
{
    return may_be_plain(scan, skipped) ? pass_blanks(scan->bytes + scan->at + skipped) : NULL;
}

const char *scan_plain_floats(const struct scan *scan, size_t skipped,
                              struct scan_plain_floats *row)
{
    const char *at = row_start(scan, skipped);
    for (row->count = 0; at && row->count < PLAIN_LIMIT;) {
        at = number_float(at, &row->values[row->count]);
        if (!at || *at > ' ')
            return NULL;
        row->count++;
        at = pass_blanks(at);
        if (*at < ' ')
            return pass_line_end(scan, at);
    }
    return NULL;
}

/* Goes over "/7", "/7/8", "//8". */
static const char *pass_slashes(const char *at)
{
    int64_t ignored;
    for (int slashes = 0; at && *at == '/' && slashes < 2; slashes++) {
        at++;
        if (*at != '/' && *at > ' ')
            at = number_integer(at, &ignored);
    }
    return at;
}

static inline const char *integers(const struct scan *scan, size_t skipped, bool may_have_slashes,
                                   struct scan_plain_integers *row)
{
    const char *at = row_start(scan, skipped);
    for (row->count = 0; at && row->count < PLAIN_LIMIT;) {
        at = number_integer(at, &row->values[row->count]);
        if (may_have_slashes && at && *at == '/')
            at = pass_slashes(at);
        if (!at || *at > ' ')
            return NULL;
        row->count++;
        at = pass_blanks(at);
        if (*at < ' ')
            return pass_line_end(scan, at);
    }
    return NULL;
}

const char *scan_plain_integers(const struct scan *scan, size_t skipped,
                                struct scan_plain_integers *row)
{
    return integers(scan, skipped, false, row);
}

const char *scan_plain_corners(const struct scan *scan, size_t skipped,
                               struct scan_plain_integers *row)
{
    return integers(scan, skipped, true, row);
}
