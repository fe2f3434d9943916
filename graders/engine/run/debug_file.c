/* Finds the debug file of the dynamic linker; see debug_file.h. */
#include "graders/engine/run/debug_file.h"

#include <elf.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { HEADERS_MAX = 32, NOTES_BYTES = 4096, NAME_OF_GNU = 4 };
static const char LINKER[] = "/lib64/ld-linux-x86-64.so.2";

static size_t padded(size_t bytes)
{
    return (bytes + 3) / 4 * 4;
}

/* The build id among the notes: its place, and its length in *length; NULL when there is none. */
static const unsigned char *find_build_id(const unsigned char *notes, size_t count, size_t *length)
{
    size_t at = 0;
    while (count - at >= sizeof(Elf64_Nhdr)) {
        Elf64_Nhdr note;
        memcpy(&note, notes + at, sizeof note);
        size_t name = at + sizeof note, content = name + padded(note.n_namesz);
        if (content > count || note.n_descsz > count - content)
            return NULL;
        *length = note.n_descsz;
        if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == NAME_OF_GNU &&
            memcmp(notes + name, "GNU", NAME_OF_GNU) == 0)
            return notes + content;
        at = content + padded(note.n_descsz);
        if (at > count)
            return NULL;
    }
    return NULL;
}

/* /usr/lib/debug/.build-id/7e/bc65...aba9.debug */
static bool name_file(const unsigned char *id, size_t length, char *path, size_t capacity)
{
    size_t used = (size_t)snprintf(path, capacity, DEBUG_FILE_FOLDER "/.build-id/");
    for (size_t i = 0; i < length && used < capacity; i++)
        used += (size_t)snprintf(path + used, capacity - used, i == 0 ? "%02x/" : "%02x", id[i]);
    if (used < capacity)
        used += (size_t)snprintf(path + used, capacity - used, ".debug");
    return used < capacity && access(path, R_OK) == 0;
}

static bool find_by_notes(int file, char *path, size_t capacity)
{
    Elf64_Ehdr elf;
    Elf64_Phdr headers[HEADERS_MAX];
    unsigned char notes[NOTES_BYTES];
    size_t length;
    if (pread(file, &elf, sizeof elf, 0) != (ssize_t)sizeof elf || elf.e_phnum > HEADERS_MAX ||
        memcmp(elf.e_ident, ELFMAG, SELFMAG) != 0 || elf.e_ident[EI_CLASS] != ELFCLASS64)
        return false;
    size_t bytes = elf.e_phnum * sizeof headers[0];
    if (pread(file, headers, bytes, (off_t)elf.e_phoff) != (ssize_t)bytes)
        return false;
    for (int i = 0; i < elf.e_phnum; i++) {
        if (headers[i].p_type != PT_NOTE)
            continue;
        size_t wanted = headers[i].p_filesz < NOTES_BYTES ? headers[i].p_filesz : NOTES_BYTES;
        ssize_t count = pread(file, notes, wanted, (off_t)headers[i].p_offset);
        const unsigned char *id = count > 0 ? find_build_id(notes, (size_t)count, &length) : NULL;
        if (id)
            return name_file(id, length, path, capacity);
    }
    return false;
}

bool debug_file_of_linker(char *path, size_t capacity)
{
    int file = open(LINKER, O_RDONLY | O_CLOEXEC);
    bool found = file >= 0 && find_by_notes(file, path, capacity);
    if (file >= 0)
        close(file);
    return found;
}
