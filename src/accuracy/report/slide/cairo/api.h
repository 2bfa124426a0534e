/* The interface between snell and its Cairo module. It is plain C, so that neither side needs the other's headers or
   run-time library. No function throws or prints. */
#ifndef SNELL_ACCURACY_REPORT_SLIDE_CAIRO_API_H
#define SNELL_ACCURACY_REPORT_SLIDE_CAIRO_API_H

#ifdef __cplusplus
#include <cstddef>
extern "C" {
#else
#include <stddef.h>
#endif

enum { snell_cairo_version = 2 };

typedef enum SnellCairoKind {
    snell_cairo_line,  /* from the first to the second corner */
    snell_cairo_box,   /* between the corners */
    snell_cairo_disc,  /* the ellipse in that box */
    snell_cairo_text,  /* its baseline begins at the first corner */
    snell_cairo_image, /* fills the box; pixels that become larger are squares */
} SnellCairoKind;

/* One mark on the page; y points down. */
typedef struct SnellCairoShape {
    SnellCairoKind kind;
    double x0, y0, x1, y1;
    unsigned color; /* 0xRRGGBB */
    double stroke;  /* the width of the line; 0: boxes and discs are filled */
    double size;    /* of text: pixels of an em */
    int bold;
    const char* text;            /* UTF-8 */
    const unsigned char* pixels; /* RGB, top row first */
    int width, height;           /* of the pixels */
} SnellCairoShape;

/* Takes the next bytes of the file. */
typedef void (*SnellCairoWrite)(void* context, const unsigned char* bytes, unsigned int count);

/* Draws the shapes in this order on a white page, as PNG or PDF. Equal shapes give equal files. Returns 0 on success;
   after an error, `message` (of `message_size` bytes) describes it. */
int snell_cairo_draw(int pdf, int width, int height, const SnellCairoShape* shapes, size_t count, SnellCairoWrite write,
                     void* context, char* message, size_t message_size);
/* The width of a line of text, in pixels; negative if the font is missing. */
double snell_cairo_text_width(const char* text, double size, int bold);
int snell_cairo_api_version(void);

#ifdef __cplusplus
}
#endif
#endif
