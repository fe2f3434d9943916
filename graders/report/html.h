/* A writer of HTML that escapes by construction: tag and attribute names are literals of our own,
 * and whatever stands between or inside them passes through here, cleaned (clean.h) and escaped.
 * There is no way to write raw markup from a variable.
 *
 *     html_open(page, "a");
 *     html_path(page, "href", path);
 *     html_text(page, name);
 *     html_close(page, "a");
 *
 * Errors (out of memory, wrong nesting) are remembered and told by html_finish. */
#ifndef GRADERS_REPORT_HTML_H
#define GRADERS_REPORT_HTML_H

#include "graders/report/words.h"
#include "reference/base/error.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

enum { HTML_DEPTH = 32, HTML_TEXT_LIMIT_BYTES = 20000 };

struct html {
    FILE *to;   /* a memory stream */
    char *text; /* what was written, valid after html_finish */
    size_t length;
    const char *open[HTML_DEPTH]; /* the elements that are open, outermost first */
    int depth;
    bool in_tag; /* the last start tag still takes attributes */
    const char *fault;
};

/* Starts a document with its doctype. */
int html_start(struct html *page, struct error *err) MUST_CHECK;

/* Ends it. On success page->text holds it until html_release; -1 when anything went wrong. */
int html_finish(struct html *page, struct error *err) MUST_CHECK;
void html_release(struct html *page);

/* Opens an element, and ends it; the name must be the innermost open one's. Void elements (meta,
 * link, img, input, br) are closed like the others and get no end tag. */
void html_open(struct html *page, const char *tag);
void html_close(struct html *page, const char *tag);

/* Attributes of the element just opened. A path is relative; it is percent-encoded, so it can hold
 * neither a scheme nor a query. A flag has no value. */
void html_attribute(struct html *page, const char *name, const char *value);
void html_attribute_format(struct html *page, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void html_path(struct html *page, const char *name, const char *path);
void html_flag(struct html *page, const char *name);

/* Text. Of untrusted JSON strings (which may hold NUL) at most HTML_TEXT_LIMIT_BYTES are shown. */
void html_text(struct html *page, const char *text);
void html_format(struct html *page, const char *format, ...) __attribute__((format(printf, 2, 3)));
void html_json(struct html *page, const json_t *string);

/* An element with a class (or NULL) and a text. */
void html_leaf(struct html *page, const char *tag, const char *class_name, const char *text);

/* The text in both languages, one <span lang> each: the page shows one of them. */
void html_both(struct html *page, struct phrase words);
void html_both_leaf(struct html *page, const char *tag, const char *class_name,
                    struct phrase words);

/* An attribute in both languages: name="en" data-es-name="es"; page.js swaps them. */
void html_both_attribute(struct html *page, const char *name, struct phrase words);

#endif
