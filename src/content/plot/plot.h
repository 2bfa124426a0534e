// Marks on a page: lines, boxes, discs, texts and pictures, once for every output. SVG is written here; Cairo
// (src/accuracy/report/slide) and the window (src/ui) paint the same list.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/content/image/image.h"

namespace snell::content {

// Between two corners, in pixels from the top left.
struct Area {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    double width() const { return x1 - x0; }
    double height() const { return y1 - y0; }
    bool meets(const Area& b) const { return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1; }
    bool holds(const Area& b) const { return x0 <= b.x0 && b.x1 <= x1 && y0 <= b.y0 && b.y1 <= y1; }
};

// What a colour means: every output has its own colours. From `series` on, those of things side by side.
enum class Ink : std::uint8_t { text, weak, paper, grid, band, front, other, own, wrong, series };
inline constexpr std::size_t series_inks = 5, inks = static_cast<std::size_t>(Ink::series) + series_inks;
inline Ink series(std::size_t i) { return static_cast<Ink>(static_cast<std::size_t>(Ink::series) + i % series_inks); }

// As CSS has colours, by Ink.
using InkColors = std::array<std::string_view, inks>;
// On white. Those of series are Okabe and Ito's, which people who see few colours tell apart.
inline constexpr InkColors print_colors{"#1a1a1a", "#555555", "#ffffff", "#dcdcdc", "#d9d9d9", "#1a1a1a", "#8a8a8a",
                                        "#d55e00", "#c00000", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

enum class MarkKind : std::uint8_t { line, box, disc, text, image };

struct Mark {
    MarkKind kind = MarkKind::box;
    Area at;  // lines run from its first corner to its second; letters of text are inside
    Ink ink = Ink::text;
    double stroke = 0;  // the width of lines; 0: boxes and discs are filled
    double size = 0;    // of text: pixels of an em
    bool bold = false;
    std::string text = {};  // of boxes and discs: what is said where they are pointed at
    Image picture = {};     // RGB; it fills the area
    double part = 0;        // of text: which part of its width is left of where it was put
};

// The height of a line of text, and of its letters above the baseline, relative to its size.
inline constexpr double line_height = 1.17, ascent = .93;

// The width of a line of text, in pixels, for a size and weight.
using TextWidth = std::function<double(const std::string& text, double size, bool bold)>;
// For fonts that are not known: few have wider letters.
double estimated_width(const std::string& text, double size, bool bold);

// Collects marks.
class Page {
public:
    explicit Page(TextWidth width = estimated_width) : width_(std::move(width)) {}

    void line(double x0, double y0, double x1, double y1, double stroke, Ink ink);
    void box(const Area& at, double stroke, Ink ink, std::string tip = {});
    // A disc, or a square of the same size.
    void dot(double x, double y, double radius, bool square, double stroke, Ink ink, std::string tip = {});
    void image(const Area& at, Image picture);
    // A line of text at the right of x; with `part` .5 in the middle of it, with 1 at its left. Hidden characters are
    // escaped. Returns its area.
    Area text(double x, double top, std::string_view words, double size, Ink ink = Ink::text, double part = 0,
              bool bold = false);

    double width(std::string_view words, double size, bool bold = false) const;
    // The text as it can be shown, cut with "…" if it is wider.
    std::string cut(std::string_view words, double most, double size, bool bold = false) const;
    // The same on several lines, broken at blanks; the last one is cut.
    std::vector<std::string> lines(std::string_view words, double most, std::size_t count, double size) const;

    std::vector<Mark> marks;

private:
    TextWidth width_;
};

// An <svg> element with these attributes besides its size.
std::string svg(const std::vector<Mark>& marks, int width, int height, const InkColors& colors,
                std::string_view attributes = {});

// The plot of error against time, both logarithmic, once for reports, slides and the window.

struct PlotPoint {
    std::string name;
    double error = 0;                            // 0: equal to the reference; infinite: pixels that are not finite
    double milliseconds = 0, low = 0, high = 0;  // and the interval of the time; infinite if it is not known
    bool front = false, beaten = false;          // filled and large; hollow
    bool own = false;                            // as the scene sets it: a square
    bool chosen = false;                         // has a ring
    std::optional<Ink> ink = {};                 // if it is one of the page's other things, too
    std::optional<int> label = {};               // labels are placed in this order where there is room; none: no label
    std::string tip = {};                        // what is said where it is pointed at

    bool has_interval() const;
};

struct Plot {
    std::vector<PlotPoint> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges = {};  // in red if the more expensive one is worse
    std::string errors, times;                                    // of the axes, with their units
    std::string stamp = {};                                       // what else is to be known
    double floor = 0;                                             // errors below it can't be told apart; 0: unknown
    std::string floor_words = {};
    double decades = 0;  // that axes span at least
};

// Draws the mark of a point alone, as in the plot, and returns its radius.
double draw_point(Page& page, const PlotPoint& point, double x, double y, double em);
// Draws a bar from `low` to `high`, with the colour of the point.
void draw_bar(Page& page, const PlotPoint& point, double low, double high, double y, double em);
// Draws it with text of this size. Returns the places of the points, whose errors and times must be known.
std::vector<std::pair<double, double>> draw_plot(Page& page, const Plot& plot, const Area& at, double em);

// A logarithmic axis.

// Maps values to places between `from` and `to`, with margins at both ends. Values from `low` to `high` are shown.
class Axis {
public:
    Axis(double low, double high, double from, double to, double decades = 0);
    double at(double value) const;
    bool shows(double value) const;
    // 1, 2 and 5 in each decade; only 1 if these are too many, even steps if they are too few.
    std::vector<double> ticks() const;

private:
    std::vector<double> even_ticks() const;

    double from_, to_, low_ = 0, high_ = 1;
};

}  // namespace snell::content
