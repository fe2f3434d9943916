/* The sample class below tests/unit/data (made by make_class.py there) for the tests of reports. */
#ifndef TESTS_UNIT_REPORT_SAMPLE_H
#define TESTS_UNIT_REPORT_SAMPLE_H

#include <jansson.h>
#include <stddef.h>

/* One result of the sample, a new reference. */
json_t *sample_result(const char *student_folder, const char *exercise);

/* Turns the last `count` cases of a class of a result into ones that were not run. */
void sample_leave_out(json_t *result, const char *class_name, size_t count);

/* Copies results/ and pictures/ into a new folder, whose path of at most 63 bytes goes to `out`. */
void sample_copy(char *out);

/* Removes such a folder. */
void sample_remove(const char *out);

/* Replaces a result in such a folder. */
void sample_store(const char *out, const json_t *result);

/* What a file holds, as a string that the caller frees. */
char *sample_read(const char *out, const char *name);

#endif
