/* The error object; see error.h, which has macros of these names for analyzers. */
#include "reference/base/error.h"

#include <stdarg.h>
#include <stdio.h>

/* The last byte of the text says whether it is about the request. */
__attribute__((format(printf, 3, 0))) static void set(struct error *err, bool is_request,
                                                      const char *format, va_list arguments)
{
    if (!err || err->text[0] != '\0')
        return;
    vsnprintf(err->text, sizeof err->text - 1, format, arguments);
    err->text[sizeof err->text - 1] = (char)is_request;
}

int(error_set)(struct error *err, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    set(err, false, format, arguments);
    va_end(arguments);
    return -1;
}

int(error_set_request)(struct error *err, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    set(err, true, format, arguments);
    va_end(arguments);
    return -1;
}

bool error_is_request(const struct error *err)
{
    return err->text[0] != '\0' && err->text[sizeof err->text - 1] != 0;
}
