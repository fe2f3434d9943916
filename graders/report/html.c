/* The writer of HTML; see html.h. */
#include "graders/report/html.h"

#include "graders/report/clean.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static void fail(struct html *page, const char *fault)
{
    if (!page->fault)
        page->fault = fault;
}

int html_start(struct html *page, struct error *err)
{
    *page = (struct html){0};
    page->to = open_memstream(&page->text, &page->length);
    if (!page->to)
        return error_set(err, "out of memory for a page");
    fputs("<!DOCTYPE html>\n", page->to);
    return 0;
}

int html_finish(struct html *page, struct error *err)
{
    if (page->depth != 0)
        fail(page, "an element was left open");
    if (fclose(page->to) != 0)
        fail(page, "out of memory");
    page->to = NULL;
    if (page->fault)
        return error_set(err, "a page cannot be written: %s", page->fault);
    return 0;
}

void html_release(struct html *page)
{
    if (page->to)
        fclose(page->to);
    free(page->text);
    *page = (struct html){0};
}

/* Ends the start tag that still takes attributes. */
static void end_tag(struct html *page)
{
    if (page->in_tag)
        fputc('>', page->to);
    page->in_tag = false;
}

static bool is_void(const char *tag)
{
    static const char *const names[] = {"meta", "link", "img", "input", "br"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(names[i], tag) == 0)
            return true;
    return false;
}

/* Elements before whose start tag a new line does no harm: the source of a page stays readable. */
static bool is_block(const char *tag)
{
    static const char names[] =
        " html head body meta link script title header main footer section div table thead tbody "
        "tfoot tr ul ol li h1 h2 h3 h4 p figure svg details dl ";
    char padded[24];
    snprintf(padded, sizeof padded, " %s ", tag);
    return strstr(names, padded) != NULL;
}

void html_open(struct html *page, const char *tag)
{
    end_tag(page);
    if (page->depth == HTML_DEPTH) {
        fail(page, "elements are nested too deep");
        return;
    }
    if (is_block(tag))
        fputc('\n', page->to);
    fprintf(page->to, "<%s", tag);
    page->open[page->depth++] = tag;
    page->in_tag = true;
}

void html_close(struct html *page, const char *tag)
{
    end_tag(page);
    if (page->depth == 0 || strcmp(page->open[page->depth - 1], tag) != 0) {
        fail(page, "an element was closed that is not the innermost");
        return;
    }
    page->depth--;
    if (!is_void(tag))
        fprintf(page->to, "</%s>", tag);
}

static void put_escaped(struct html *page, const char *text, size_t length, size_t limit_bytes)
{
    char *clean = clean_text(text, length, CLEAN_BLOCK, limit_bytes);
    if (!clean)
        fail(page, "out of memory");
    for (const char *c = clean ? clean : ""; *c; c++) {
        switch (*c) {
        case '&':
            fputs("&amp;", page->to);
            break;
        case '<':
            fputs("&lt;", page->to);
            break;
        case '>':
            fputs("&gt;", page->to);
            break;
        case '"':
            fputs("&quot;", page->to);
            break;
        case '\'':
            fputs("&#39;", page->to);
            break;
        default:
            fputc(*c, page->to);
        }
    }
    free(clean);
}

static void open_attribute(struct html *page, const char *name)
{
    if (!page->in_tag)
        fail(page, "an attribute stands outside of a start tag");
    fprintf(page->to, " %s=\"", name);
}

void html_attribute(struct html *page, const char *name, const char *value)
{
    open_attribute(page, name);
    put_escaped(page, value, strlen(value), HTML_TEXT_LIMIT_BYTES);
    fputc('"', page->to);
}

void html_attribute_format(struct html *page, const char *name, const char *format, ...)
{
    char *value = NULL;
    va_list arguments;
    va_start(arguments, format);
    if (vasprintf(&value, format, arguments) < 0)
        value = NULL;
    va_end(arguments);
    if (!value)
        fail(page, "out of memory");
    html_attribute(page, name, value ? value : "");
    free(value);
}

void html_path(struct html *page, const char *name, const char *path)
{
    static const char plain[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-/#";
    open_attribute(page, name);
    for (const char *c = path; *c; c++) {
        if (strchr(plain, *c))
            fputc(*c, page->to);
        else
            fprintf(page->to, "%%%02X", (unsigned char)*c);
    }
    fputc('"', page->to);
}

void html_flag(struct html *page, const char *name)
{
    if (!page->in_tag)
        fail(page, "an attribute stands outside of a start tag");
    fprintf(page->to, " %s", name);
}

void html_text(struct html *page, const char *text)
{
    end_tag(page);
    put_escaped(page, text, strlen(text), HTML_TEXT_LIMIT_BYTES);
}

void html_format(struct html *page, const char *format, ...)
{
    char *text = NULL;
    va_list arguments;
    va_start(arguments, format);
    if (vasprintf(&text, format, arguments) < 0)
        text = NULL;
    va_end(arguments);
    if (!text)
        fail(page, "out of memory");
    html_text(page, text ? text : "");
    free(text);
}

void html_json(struct html *page, const json_t *string)
{
    end_tag(page);
    put_escaped(page, json_string_value(string), json_string_length(string), HTML_TEXT_LIMIT_BYTES);
}

void html_leaf(struct html *page, const char *tag, const char *class_name, const char *text)
{
    html_open(page, tag);
    if (class_name)
        html_attribute(page, "class", class_name);
    html_text(page, text);
    html_close(page, tag);
}

void html_both(struct html *page, struct phrase words)
{
    html_open(page, "span");
    html_attribute(page, "lang", "en");
    html_text(page, words.en);
    html_close(page, "span");
    html_open(page, "span");
    html_attribute(page, "lang", "es");
    html_text(page, words.es);
    html_close(page, "span");
}

void html_both_leaf(struct html *page, const char *tag, const char *class_name, struct phrase words)
{
    html_open(page, tag);
    if (class_name)
        html_attribute(page, "class", class_name);
    html_both(page, words);
    html_close(page, tag);
}

void html_both_attribute(struct html *page, const char *name, struct phrase words)
{
    char spanish[48];
    snprintf(spanish, sizeof spanish, "data-es-%s", name);
    html_attribute(page, name, words.en);
    html_attribute(page, spanish, words.es);
}
