/* Packets: the bytes that go into a box and come out of it.
 *
 * A packet is a plain sequence of little-endian values without tags: whoever reads it knows what
 * stands where. Writer and reader both stick at their first error, so that calls need no checks in
 * between and one test at the end tells. The runner uses this file inside the box and the judge
 * outside; it needs nothing but libc.
 *
 * Arrays are written as they lie in memory and start at a multiple of 8 bytes, so that a reader may
 * use them in place. Every other value takes 8 bytes. */
#ifndef GRADERS_WIRE_PACKET_H
#define GRADERS_WIRE_PACKET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct span {
    const unsigned char *bytes;
    size_t count;
};

/* Reads a packet that may hold anything. */
struct reader {
    const unsigned char *bytes; /* borrowed; 8-byte aligned */
    size_t count;
    size_t at;
    bool failed; /* something asked for lies beyond the end; every later read gives 0 or NULL */
};

struct reader reader_of(const void *bytes, size_t count);
int64_t read_int(struct reader *reader);
double read_real(struct reader *reader);

/* An array of `count` elements of `element_bytes` each, in place (borrowed from the packet).
 * Returns NULL, and fails the reader, when count is negative or the packet is too short. A count of
 * 0 gives a pointer that must not be followed. */
const void *read_array(struct reader *reader, int64_t count, size_t element_bytes);

/* Reads what write_table wrote. *count gets the claimed count, whatever it is. Returns the elements
 * in place, or NULL when they were left out (the reader goes on) or the packet is broken (it
 * fails). */
const void *read_table(struct reader *reader, int64_t *count, size_t element_bytes);

/* Writes a packet, either into memory that the caller gives (writer_into) or into memory that grows
 * (writer_growing; release with writer_release). */
struct writer {
    unsigned char *bytes;
    size_t count; /* bytes written; keeps counting past capacity so that the need can be told */
    size_t capacity;
    bool growing;
    bool failed; /* out of memory, or more than the capacity was written */
};

struct writer writer_into(void *bytes, size_t capacity);
struct writer writer_growing(void);
void writer_release(struct writer *writer);
void write_int(struct writer *writer, int64_t value);
void write_real(struct writer *writer, double value);

/* Copies `count` elements from `array`; NULL is allowed when count is 0. */
void write_array(struct writer *writer, const void *array, int64_t count, size_t element_bytes);

/* Writes a table as untrusted code returned it: the count that it claims, the count of elements
 * that follow, and these. All follow when the pointer is not NULL, the count is not negative and
 * the room suffices, otherwise none: a wild count ends as a claim that the judge reads, not as a
 * crash. */
void write_table(struct writer *writer, const void *table, int64_t count, size_t element_bytes);

#endif
