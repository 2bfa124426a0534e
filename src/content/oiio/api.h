/* The interface between snell and its OpenImageIO module. It is plain C, so that neither side needs the other's headers
   or run-time library. No function throws or prints. */
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

/* An image of tightly packed pixels, top row first. */
typedef struct SnellOiioShape {
    int width, height, depth, channels;
    SnellOiioType type;
    int has_alpha;   /* the last channel is alpha */
    int orientation; /* EXIF's 1..8: how to rotate and mirror the image */
    char format[32]; /* OpenImageIO's name of the detected format */
} SnellOiioShape;

/* Allocates memory for the pixels; returns null to cancel. Called once, after the header was read. */
typedef void* (*SnellOiioAllocate)(void* context, const SnellOiioShape* shape);

/* Functions that return int return 0 on success. After an error, `message` (of `message_size` bytes) describes it. */

/* Reads an image: 8-bit images as u8, all others as f32. `format` may be null. Returns 1 if nothing could be read, 2 if
   `allocate` returned null, and 3 if the file ended within the pixels, of which those before its end were read. */
int snell_oiio_read(const char* path, const char* format, SnellOiioAllocate allocate, void* context, char* message,
                    size_t message_size);
/* Begins an image that is written row by row, top first. `format` is an extension or OpenImageIO's name of a format.
   Channels that the format does not support are left out. Returns null after an error. */
void* snell_oiio_begin(const char* path, const char* format, const SnellOiioShape* shape, char* message,
                       size_t message_size);
int snell_oiio_rows(void* picture, const void* rows, int count, char* message, size_t message_size);
/* Completes the image, or abandons it if `whole` is 0, and frees it. */
int snell_oiio_end(void* picture, int whole, char* message, size_t message_size);
int snell_oiio_api_version(void);

#ifdef __cplusplus
}
#endif
#endif
