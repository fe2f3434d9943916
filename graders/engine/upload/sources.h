/* The source files of one submission: what may be taken, under which names. */
#ifndef GRADERS_ENGINE_UPLOAD_SOURCES_H
#define GRADERS_ENGINE_UPLOAD_SOURCES_H

#include "graders/engine/upload/upload.h"

/* Takes a copy of a source under its base name, whose ending becomes lower case (gcc takes .C for
 * C++). Refuses the upload when the name is not plain, is there already, or is one too many.
 *
 * name     `length` bytes ending in .c or .h
 * returns  0, also when refused; -1 and *err when memory runs out */
int upload_take_source(struct upload *upload, const char *name, size_t length, const void *bytes,
                       size_t count, struct error *err) MUST_CHECK;

/* When all are taken: sorts them, and refuses an upload without a .c file. A refused upload keeps
 * no files. */
void upload_settle(struct upload *upload);

#endif
