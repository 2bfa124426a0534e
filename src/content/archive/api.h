/* The interface between snell and its libarchive module. It is plain C, so that neither side needs the other's headers
   or run-time library. No function throws or prints, and none writes a file. */
#ifndef SNELL_CONTENT_ARCHIVE_API_H
#define SNELL_CONTENT_ARCHIVE_API_H

#ifdef __cplusplus
#include <cstddef>
extern "C" {
#else
#include <stddef.h>
#endif

enum { snell_archive_version = 1 };

typedef enum SnellArchiveKind {
    snell_archive_file = 1,
    snell_archive_folder = 2,
    snell_archive_other = 3
} SnellArchiveKind;

typedef struct SnellArchiveEntry {
    const char* name; /* as the archive spells it, in any encoding; valid until the next entry */
    SnellArchiveKind kind;
} SnellArchiveEntry;

/* After an error, `message` (of `message_size` bytes) describes it. */

/* Returns null after an error. */
void* snell_archive_open(const char* path, char* message, size_t message_size);
/* Returns 1 for an entry, 0 at the end, -1 after an error. */
int snell_archive_next(void* archive, SnellArchiveEntry* entry, char* message, size_t message_size);
/* Reads the bytes of the current entry; returns how many, 0 at its end, -1 after an error. */
long long snell_archive_read(void* archive, void* bytes, size_t size, char* message, size_t message_size);
void snell_archive_close(void* archive);
int snell_archive_api_version(void);

#ifdef __cplusplus
}
#endif
#endif
