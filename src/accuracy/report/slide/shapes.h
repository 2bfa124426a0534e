// The marks of a slide and their places. Internal to the slide; no library.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "src/accuracy/report/slide/slide.h"

namespace snell::accuracy {

// In pixels from the top left.
struct SlideBox {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    double width() const { return x1 - x0; }
    double height() const { return y1 - y0; }
    bool meets(const SlideBox& b) const { return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1; }
    bool holds(const SlideBox& b) const { return x0 <= b.x0 && b.x1 <= x1 && y0 <= b.y0 && b.y1 <= y1; }
};

enum class ShapeKind : std::uint8_t { line, box, disc, text, image };

struct SlideShape {
    ShapeKind kind = ShapeKind::box;
    SlideBox at;         // lines run from its first corner to its second; letters of text are inside
    unsigned color = 0;  // 0xRRGGBB
    double stroke = 0;   // the width of lines; 0: boxes and discs are filled
    double size = 0;     // of text: pixels of an em
    bool bold = false;
    std::string text = {};
    Raster picture = {};
};

// The width of a line of text, in pixels, for a size and weight.
using TextWidth = std::function<double(const std::string& text, double size, bool bold)>;

// The least size of text: legible from the last row.
inline constexpr double small_text = 32, large_text = 44, name_text = 28;

namespace ink {
inline constexpr unsigned text = 0x1a1a1a, weak = 0x555555, axis = 0x1a1a1a, grid = 0xdcdcdc, band = 0xd9d9d9,
                          other = 0x8a8a8a, own = 0xd55e00;
// Okabe and Ito's colours, which people who see few colours tell apart.
inline constexpr std::array<unsigned, 5> columns{0x0072b2, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9};
}  // namespace ink

// Collects shapes.
class SlidePage {
public:
    explicit SlidePage(TextWidth width) : width_(std::move(width)) {}

    void line(double x0, double y0, double x1, double y1, double stroke, unsigned color);
    void box(const SlideBox& at, double stroke, unsigned color);
    void disc(double x, double y, double radius, double stroke, unsigned color);
    void image(const SlideBox& at, Raster picture);
    void text(const SlideBox& at, std::string words, unsigned color, double size = small_text, bool bold = false);

    // The box of a line of text, whose top left is at x, y.
    SlideBox text_box(double x, double y, const std::string& words, double size = small_text, bool bold = false) const;
    // The text as it can be shown, cut with "…" if it is wider.
    std::string cut(std::string_view words, double most, double size = small_text, bool bold = false) const;
    // The same on several lines, broken at blanks; the last one is cut.
    std::vector<std::string> lines(std::string_view words, double most, std::size_t count, double size) const;

    std::vector<SlideShape> shapes;

private:
    TextWidth width_;
};

// The height of a line of text, relative to its size.
inline constexpr double line_height = 1.17, ascent = .93;

// Draws the plot with its axes and labels between the corners of `at`.
void plot_points(SlidePage& page, const Slide& slide, const SlideBox& at);
// The colour of a column and of its point.
unsigned column_color(const Slide& slide, std::size_t column);
// The mark of a point: a square for the scene's own rung.
void point_mark(SlidePage& page, double x, double y, double radius, bool own, double stroke, unsigned color);
// An error in two digits.
std::string error_number(double error);

// Everything on the slide, in the order in which it is drawn.
std::vector<SlideShape> slide_shapes(const Slide& slide, const TextWidth& width);

}  // namespace snell::accuracy
