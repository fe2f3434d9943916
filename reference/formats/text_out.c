/* What the format writers share; see text_out.h. */
#include "reference/formats/text_out.h"

#include <errno.h>
#include <string.h>

int text_out_begin(struct text_out *text, FILE *out, struct error *err)
{
    text->out = out;
    text->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!text->c_locale)
        return error_set(err, "out of memory: writing a mesh");
    text->previous = uselocale(text->c_locale);
    return 0;
}

int text_out_end(struct text_out *text, struct error *err)
{
    uselocale(text->previous);
    freelocale(text->c_locale);
    errno = 0;
    if (fflush(text->out) || ferror(text->out))
        return error_set(err, "writing a mesh: %s", strerror(errno ? errno : EIO));
    return 0;
}

void text_out_positions(FILE *out, const char *line_start, const struct mesh *mesh)
{
    for (int64_t v = 0; v < mesh->vertex_count; v++) {
        const float *p = mesh->positions + 3 * v;
        fprintf(out, "%s%.9g %.9g %.9g\n", line_start, (double)p[0], (double)p[1], (double)p[2]);
    }
}
