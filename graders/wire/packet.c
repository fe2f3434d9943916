/* Packets; see packet.h. */
#include "graders/wire/packet.h"

#include <stdlib.h>
#include <string.h>

enum { ALIGNMENT = 8, FIRST_CAPACITY = 4096 };

static size_t padded(size_t bytes)
{
    return (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

struct reader reader_of(const void *bytes, size_t count)
{
    return (struct reader){.bytes = bytes, .count = count};
}

const void *read_array(struct reader *reader, int64_t count, size_t element_bytes)
{
    size_t left = reader->count - reader->at;
    bool fits = count >= 0 && (!element_bytes || (uint64_t)count <= left / element_bytes) &&
                padded((size_t)count * element_bytes) <= left;
    if (reader->failed || !fits) {
        reader->failed = true;
        return NULL;
    }
    const void *array = reader->bytes + reader->at;
    reader->at += padded((size_t)count * element_bytes);
    return array;
}

int64_t read_int(struct reader *reader)
{
    int64_t value = 0;
    const void *at = read_array(reader, 1, sizeof value);
    if (at)
        memcpy(&value, at, sizeof value);
    return value;
}

double read_real(struct reader *reader)
{
    double value = 0;
    const void *at = read_array(reader, 1, sizeof value);
    if (at)
        memcpy(&value, at, sizeof value);
    return value;
}

const void *read_table(struct reader *reader, int64_t *count, size_t element_bytes)
{
    *count = read_int(reader);
    int64_t kept = read_int(reader);
    if (kept != 0 && kept != *count)
        reader->failed = true;
    const void *table = read_array(reader, kept, element_bytes);
    return kept == *count ? table : NULL;
}

struct writer writer_into(void *bytes, size_t capacity)
{
    return (struct writer){.bytes = bytes, .capacity = capacity};
}

struct writer writer_growing(void)
{
    return (struct writer){.growing = true};
}

void writer_release(struct writer *writer)
{
    if (writer->growing)
        free(writer->bytes);
    *writer = (struct writer){.growing = writer->growing};
}

static void make_room(struct writer *writer, size_t bytes)
{
    if (writer->count + bytes <= writer->capacity)
        return;
    if (!writer->growing) {
        writer->failed = true;
        return;
    }
    size_t capacity = writer->capacity ? writer->capacity : FIRST_CAPACITY;
    while (capacity < writer->count + bytes)
        capacity *= 2;
    unsigned char *larger = realloc(writer->bytes, capacity);
    if (!larger) {
        writer->failed = true;
        return;
    }
    writer->bytes = larger;
    writer->capacity = capacity;
}

void write_array(struct writer *writer, const void *array, int64_t count, size_t element_bytes)
{
    if (count < 0 || (element_bytes && (uint64_t)count > SIZE_MAX / 4 / element_bytes)) {
        writer->failed = true;
        return;
    }
    size_t bytes = (size_t)count * element_bytes;
    size_t room = padded(bytes);
    if (!writer->failed)
        make_room(writer, room);
    if (!writer->failed && bytes) {
        memcpy(writer->bytes + writer->count, array, bytes);
        memset(writer->bytes + writer->count + bytes, 0, room - bytes);
    }
    writer->count += room;
}

void write_int(struct writer *writer, int64_t value)
{
    write_array(writer, &value, 1, sizeof value);
}

void write_real(struct writer *writer, double value)
{
    write_array(writer, &value, 1, sizeof value);
}

void write_table(struct writer *writer, const void *table, int64_t count, size_t element_bytes)
{
    write_int(writer, count);
    size_t taken = writer->count + sizeof(int64_t);
    size_t room = writer->growing            ? SIZE_MAX / 4
                  : taken < writer->capacity ? writer->capacity - taken
                                             : 0;
    bool follows = table && count >= 0 && (uint64_t)count <= room / element_bytes &&
                   padded((size_t)count * element_bytes) <= room;
    write_int(writer, follows ? count : 0);
    write_array(writer, table, follows ? count : 0, element_bytes);
}
