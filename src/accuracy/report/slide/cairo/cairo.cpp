// The only file of snell that includes Cairo. The font is opened by its path: what a user's settings of fonts say has
// no influence on the picture.
#include <cairo/cairo-ft.h>
#include <cairo/cairo-pdf.h>
#include <cairo/cairo.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "src/accuracy/report/slide/cairo/api.h"

#define SNELL_EXPORT __attribute__((visibility("default")))

namespace {

struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
using Surface = std::unique_ptr<cairo_surface_t, Free>;
using Page = std::unique_ptr<cairo_t, Free>;

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

// They stay open: Cairo keeps glyphs of a font for as long as it wants.
struct Fonts {
    std::array<cairo_font_face_t*, 2> faces{};

    Fonts() {
        FT_Library library = nullptr;
        if (FT_Init_FreeType(&library) != 0) return;
        for (const std::string folder :
             {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu-sans-fonts/", "/usr/share/fonts/TTF/"}) {
            FT_Face plain = nullptr, bold = nullptr;
            if (FT_New_Face(library, (folder + "DejaVuSans.ttf").c_str(), 0, &plain) != 0 ||
                FT_New_Face(library, (folder + "DejaVuSans-Bold.ttf").c_str(), 0, &bold) != 0)
                continue;
            faces = {cairo_ft_font_face_create_for_ft_face(plain, FT_LOAD_NO_HINTING),
                     cairo_ft_font_face_create_for_ft_face(bold, FT_LOAD_NO_HINTING)};
            return;
        }
    }
};

void set_font(cairo_t* page, double size, bool bold) {
    static const Fonts fonts;
    if (!fonts.faces[0])
        throw std::runtime_error("the font DejaVu Sans is missing (on Debian: apt-get install fonts-dejavu-core)");
    cairo_set_font_face(page, fonts.faces[bold ? 1 : 0]);
    cairo_set_font_size(page, size);
    const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
        cairo_font_options_create(), cairo_font_options_destroy);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(page, options.get());
}

void set_color(cairo_t* page, unsigned color) {
    cairo_set_source_rgb(page, (color >> 16 & 255U) / 255., (color >> 8 & 255U) / 255., (color & 255U) / 255.);
}

void draw_image(cairo_t* page, const SnellCairoShape& shape) {
    if (shape.width <= 0 || shape.height <= 0) return;
    const Surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, shape.width, shape.height));
    check(cairo_surface_status(image.get()));
    unsigned char* const rows = cairo_image_surface_get_data(image.get());
    const int stride = cairo_image_surface_get_stride(image.get());
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x) {
            const unsigned char* p = shape.pixels + 3 * (static_cast<std::ptrdiff_t>(y) * shape.width + x);
            const std::uint32_t color = std::uint32_t{p[0]} << 16 | std::uint32_t{p[1]} << 8 | p[2];
            std::memcpy(rows + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, &color, sizeof color);
        }
    cairo_surface_mark_dirty(image.get());
    cairo_save(page);
    cairo_translate(page, shape.x0, shape.y0);
    cairo_scale(page, (shape.x1 - shape.x0) / shape.width, (shape.y1 - shape.y0) / shape.height);
    cairo_set_source_surface(page, image.get(), 0, 0);
    const bool smaller = shape.x1 - shape.x0 < shape.width;
    cairo_pattern_set_filter(cairo_get_source(page), smaller ? CAIRO_FILTER_BILINEAR : CAIRO_FILTER_NEAREST);
    cairo_pattern_set_extend(cairo_get_source(page), CAIRO_EXTEND_PAD);
    cairo_rectangle(page, 0, 0, shape.width, shape.height);
    cairo_fill(page);
    cairo_restore(page);
}

void draw_disc(cairo_t* page, const SnellCairoShape& shape) {
    cairo_save(page);
    cairo_translate(page, (shape.x0 + shape.x1) / 2, (shape.y0 + shape.y1) / 2);
    cairo_scale(page, (shape.x1 - shape.x0) / 2, (shape.y1 - shape.y0) / 2);
    cairo_new_sub_path(page);
    cairo_arc(page, 0, 0, 1, 0, 6.283185307179586);
    cairo_restore(page);
}

void draw(cairo_t* page, const SnellCairoShape& shape) {
    set_color(page, shape.color);
    cairo_set_line_width(page, shape.stroke);
    switch (shape.kind) {
        case snell_cairo_line:
            cairo_move_to(page, shape.x0, shape.y0);
            cairo_line_to(page, shape.x1, shape.y1);
            cairo_stroke(page);
            return;
        case snell_cairo_text:
            set_font(page, shape.size, shape.bold != 0);
            cairo_move_to(page, shape.x0, shape.y0);
            cairo_show_text(page, shape.text);
            return;
        case snell_cairo_image:
            draw_image(page, shape);
            return;
        case snell_cairo_box:
            cairo_rectangle(page, shape.x0, shape.y0, shape.x1 - shape.x0, shape.y1 - shape.y0);
            break;
        case snell_cairo_disc:
            draw_disc(page, shape);
            break;
    }
    if (shape.stroke > 0)
        cairo_stroke(page);
    else
        cairo_fill(page);
}

struct Sink {
    SnellCairoWrite write;
    void* context;
};

cairo_status_t take(void* sink, const unsigned char* bytes, unsigned int count) {
    const Sink& to = *static_cast<Sink*>(sink);
    to.write(to.context, bytes, count);
    return CAIRO_STATUS_SUCCESS;
}

void draw_page(bool pdf, int width, int height, const SnellCairoShape* shapes, std::size_t count, Sink sink) {
    const Surface surface(pdf ? cairo_pdf_surface_create_for_stream(take, &sink, width, height)
                              : cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
    check(cairo_surface_status(surface.get()));
    // The date that Cairo would write is that of the drawing.
    if (pdf) cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    const Page page(cairo_create(surface.get()));
    cairo_set_source_rgb(page.get(), 1, 1, 1);
    cairo_paint(page.get());
    for (std::size_t i = 0; i < count; ++i) draw(page.get(), shapes[i]);
    check(cairo_status(page.get()));
    if (!pdf) check(cairo_surface_write_to_png_stream(surface.get(), take, &sink));
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
}

}  // namespace

extern "C" {

SNELL_EXPORT int snell_cairo_draw(int pdf, int width, int height, const SnellCairoShape* shapes, size_t count,
                                  SnellCairoWrite write, void* context, char* message, size_t message_size) {
    // Exceptions must not cross the C interface.
    try {
        draw_page(pdf != 0, width, height, shapes, count, {write, context});
        return 0;
    } catch (const std::exception& e) {
        std::snprintf(message, message_size, "%s", e.what());
    } catch (...) {
        std::snprintf(message, message_size, "an unknown error");
    }
    return 1;
}

SNELL_EXPORT double snell_cairo_text_width(const char* text, double size, int bold) {
    try {
        const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
        const Page page(cairo_create(surface.get()));
        set_font(page.get(), size, bold != 0);
        cairo_text_extents_t extents;
        cairo_text_extents(page.get(), text, &extents);
        return cairo_status(page.get()) == CAIRO_STATUS_SUCCESS ? extents.x_advance : -1;
    } catch (...) {
        return -1;
    }
}

SNELL_EXPORT int snell_cairo_api_version(void) { return snell_cairo_version; }
}
