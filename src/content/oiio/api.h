/* The interface between snell and its OpenImageIO module: plain C, so that neither side needs the other's
   headers or run-time library. No function throws or prints. */
#ifndef SNELL_CONTENT_OIIO_API_H
#define SNELL_CONTENT_OIIO_API_H

#ifdef __cplusplus
#include <cstddef>
extern "C" {
#else
#include <stddef.h>
#endif

enum { snell_oiio_version = 3 };

typedef enum SnellOiioType { snell_oiio_u8 = 1, snell_oiio_f16 = 2, snell_oiio_f32 = 4 } SnellOiioType;

/* Tightly packed pixels, top row first. */
typedef struct SnellOiioShape {
    int width, height, depth, channels;
    SnellOiioType type;
    int has_alpha;   /* the last channel is alpha */
    int orientation; /* EXIF's 1..8: how the picture is to be turned */
    char format[32]; /* OpenImageIO's name of the format that was found */
} SnellOiioShape;

/* Asked once, from the header alone: room for the pixels, or null to give up. */
typedef void* (*SnellOiioAllocate)(void* context, const SnellOiioShape* shape);

/* All return 0 when done; else `message` (of `message_size` bytes) says what went wrong. */

/* 8-bit pictures come as u8, all others as f32. `format` may be null. 1: nothing could be read; 2: allocate gave
   up; 3: the file ended or broke off within the pixels, of which those before it are there. */
int snell_oiio_read(const char* path, const char* format, SnellOiioAllocate allocate, void* context, char* message,
                    size_t message_size);
/* A picture that is written row by row, top first. `format` is an extension or OpenImageIO's name. Channels that the
   format can't hold are left out. Null when it failed. */
void* snell_oiio_begin(const char* path, const char* format, const SnellOiioShape* shape, char* message,
                       size_t message_size);
int snell_oiio_rows(void* picture, const void* rows, int count, char* message, size_t message_size);
/* Frees it; `whole` 0: gives it up. */
int snell_oiio_end(void* picture, int whole, char* message, size_t message_size);
int snell_oiio_api_version(void);

#ifdef __cplusplus
}
#endif
#endif
