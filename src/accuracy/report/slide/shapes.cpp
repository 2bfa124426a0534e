#include "src/accuracy/report/slide/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/report/slide/crops.h"

namespace snell::accuracy {

namespace {

constexpr double margin = 40, crop_width = 288, crop_height = 192, gap = 22, row = line_height * small_text;
constexpr double crops_top = 630, maps_top = crops_top + crop_height + 8, numbers_top = maps_top + crop_height + 6;
constexpr double mark_radius = 11, name_row = line_height * name_text;
constexpr std::size_t most_lines = 3;  // of a column's name

// On one line if it fits, otherwise on some of smaller text.
std::vector<std::string> name_lines(const SlidePage& page, const SlideColumn& column, double& size) {
    const double most = crop_width - 3 * mark_radius;
    size = small_text;
    std::vector<std::string> lines{page.cut(column.name, most)};
    if (!lines[0].ends_with("…")) return lines;
    size = name_text;
    return page.lines(column.name, most, most_lines, size);
}

// Names stand on the pictures, and take as much height as the longest.
double names_top(const SlidePage& page, const Slide& slide) {
    std::size_t most = 1;
    double size = 0;
    for (const SlideColumn& column : slide.columns) most = std::max(most, name_lines(page, column, size).size());
    return crops_top - 42 - static_cast<double>(most - 1) * name_row;
}
double brackets_top(const SlidePage& page, const Slide& slide) { return names_top(page, slide) - 42; }

double column_left(const Slide& slide, std::size_t column) {
    const auto count = static_cast<double>(slide.columns.size() + 1);  // and the reference
    const double all = count * crop_width + (count - 1) * gap;
    return (slide_width - all) / 2 + static_cast<double>(column) * (crop_width + gap);
}

// A line above the columns of a group, with its name in the middle. Own columns belong to two groups, half to each.
void bracket(SlidePage& page, const Slide& slide, bool SlideColumn::*member, const std::string& words) {
    const auto inside = [&](std::size_t i) { return slide.columns[i].*member; };
    std::size_t first = slide.columns.size(), last = 0;
    for (std::size_t i = 0; i < slide.columns.size(); ++i)
        if (inside(i)) {
            first = std::min(first, i);
            last = i;
        }
    if (first >= last) return;
    const auto shared = [&](std::size_t i) { return slide.columns[i].equal_time && slide.columns[i].equal_error; };
    const double half = crop_width / 2 + gap / 2;
    const double x0 = column_left(slide, first) + (shared(first) ? half : 0);
    const double x1 = column_left(slide, last) + crop_width - (shared(last) ? half : 0);
    const SlideBox size = page.text_box(0, 0, words);
    const double top = brackets_top(page, slide);
    const double x = (x0 + x1 - size.width()) / 2, y = top + row / 2;
    page.text(page.text_box(x, top, words), words, ink::text);
    page.line(x0, y, x - 14, y, 4, ink::axis);
    page.line(x + size.width() + 14, y, x1, y, 4, ink::axis);
    page.line(x0, y - 2, x0, y + 14, 4, ink::axis);
    page.line(x1, y - 2, x1, y + 14, 4, ink::axis);
}

void framed(SlidePage& page, const Raster& raster, double x, double y, unsigned color, double stroke) {
    Raster large = magnified(raster, static_cast<int>(crop_width), static_cast<int>(crop_height));
    const double left = x + std::floor((crop_width - large.width) / 2),
                 top = y + std::floor((crop_height - large.height) / 2);
    const SlideBox frame{left, top, left + large.width, top + large.height};
    page.image(frame, std::move(large));
    page.box(frame, stroke, color);
}

std::string time_number(double milliseconds) {
    return milliseconds >= 100 ? fmt::format("{:.0f}", milliseconds) : fmt::format("{:#.3g}", milliseconds);
}

void column(SlidePage& page, const Slide& slide, std::size_t i) {
    const SlideColumn& column = slide.columns[i];
    const double x = column_left(slide, i);
    const unsigned color = column_color(slide, i);
    double name_size = 0;
    const std::vector<std::string> name = name_lines(page, column, name_size);
    double y = crops_top - 5 - static_cast<double>(name.size()) * line_height * name_size;
    point_mark(page, x + mark_radius + 1, y + line_height * name_size / 2, mark_radius, column.own, 0, color);
    for (const std::string& line : name) {
        page.text(page.text_box(x + 3 * mark_radius, y, line, name_size), line, ink::text, name_size);
        y += line_height * name_size;
    }
    framed(page, column.picture, x, crops_top, color, 6);
    framed(page, column.map, x, maps_top, color, 6);
    // What differs from the scene's own rung stands out.
    const bool bold_error = column.equal_time && !column.own, bold_time = column.equal_error && !column.own;
    const std::string error = error_number(column.error);
    const SlideBox size = page.text_box(0, 0, error, small_text, bold_error);
    page.text(page.text_box(x + crop_width - size.width(), numbers_top, error, small_text, bold_error), error,
              ink::text, small_text, bold_error);
    if (!(column.milliseconds > 0)) return;
    const std::string time = time_number(column.milliseconds) + " ms";
    page.text(page.text_box(x, numbers_top, time, small_text, bold_time), time, ink::text, small_text, bold_time);
}

// The scale of the maps, where the reference would have its own.
void scale(SlidePage& page, const Slide& slide, double x) {
    Raster bar{static_cast<int>(crop_width), 44, {}};
    for (int y = 0; y < bar.height; ++y)
        for (int i = 0; i < bar.width; ++i) {
            const auto color = map_color(i / (crop_width - 1));
            bar.rgb.insert(bar.rgb.end(), color.begin(), color.end());
        }
    const double top = maps_top + 56;
    const SlideBox frame{x, top, x + crop_width, top + bar.height};
    page.text(page.text_box(x, top - row - 6, "error seen (FLIP)"), "error seen (FLIP)", ink::text);
    page.image(frame, std::move(bar));
    page.box(frame, 2, ink::axis);
    page.text(page.text_box(x, frame.y1 + 4, "0"), "0", ink::text);
    const std::string most = fmt::format("{:g}{}", slide.scale, slide.scale < 1 ? " or more" : "");
    const SlideBox size = page.text_box(0, 0, most);
    page.text(page.text_box(frame.x1 - size.width(), frame.y1 + 4, most), most, ink::text);
}

void reference_column(SlidePage& page, const Slide& slide) {
    const double x = column_left(slide, slide.columns.size());
    page.text(page.text_box(x, crops_top - 5 - row, "reference"), "reference", ink::text);
    framed(page, slide.reference, x, crops_top, ink::axis, 6);
    scale(page, slide, x);
}

// The whole picture, and from where the others are.
void whole(SlidePage& page, const Slide& slide, const SlideBox& at) {
    if (slide.whole.width == 0) return;
    const double factor = std::min(at.width() / slide.whole.width, at.height() / slide.whole.height);
    const double x = at.x1 - factor * slide.whole.width, y = at.y0;
    const SlideBox all{x, y, at.x1, y + factor * slide.whole.height};
    page.image(all, slide.whole);
    page.box(all, 2, ink::axis);
    if (slide.columns.empty()) return;
    const Window& w = slide.window;
    const SlideBox frame{x + factor * w.x, y + factor * w.y, x + factor * (w.x + w.width),
                         y + factor * (w.y + w.height)};
    page.box(frame, 8, 0xffffff);
    page.box(frame, 4, ink::axis);
}

void heading(SlidePage& page, const Slide& slide) {
    const std::string title = page.cut(slide.title, 760, large_text, true);
    const std::string note = page.cut(slide.note, 1000);
    page.text(page.text_box(margin, 14, title, large_text, true), title, ink::text, large_text, true);
    const SlideBox size = page.text_box(0, 0, note);
    page.text(page.text_box(slide_width - margin - size.width(), 26, note), note, ink::weak);
}

}  // namespace

void SlidePage::line(double x0, double y0, double x1, double y1, double stroke, unsigned color) {
    shapes.push_back({ShapeKind::line, {x0, y0, x1, y1}, color, stroke});
}
void SlidePage::box(const SlideBox& at, double stroke, unsigned color) {
    shapes.push_back({ShapeKind::box, at, color, stroke});
}
void SlidePage::disc(double x, double y, double radius, double stroke, unsigned color) {
    shapes.push_back({ShapeKind::disc, {x - radius, y - radius, x + radius, y + radius}, color, stroke});
}
void SlidePage::image(const SlideBox& at, Raster picture) {
    shapes.push_back({.kind = ShapeKind::image, .at = at, .picture = std::move(picture)});
}
void SlidePage::text(const SlideBox& at, std::string words, unsigned color, double size, bool bold) {
    if (!words.empty()) shapes.push_back({ShapeKind::text, at, color, 0, size, bold, std::move(words)});
}

SlideBox SlidePage::text_box(double x, double y, const std::string& words, double size, bool bold) const {
    return {x, y, x + width_(words, size, bold), y + line_height * size};
}

std::string SlidePage::cut(std::string_view words, double most, double size, bool bold) const {
    const std::string all = utf8::printable(words);
    if (width_(all, size, bold) <= most) return all;
    std::string kept;
    for (std::size_t at = 0; at < all.size();) {
        const std::size_t length = utf8::decode(all, at).length;
        const std::string longer = kept + all.substr(at, length);
        if (width_(longer + "…", size, bold) > most) break;
        kept = longer;
        at += length;
    }
    return kept + "…";
}

std::vector<std::string> SlidePage::lines(std::string_view words, double most, std::size_t count, double size) const {
    std::vector<std::string> result;
    std::string rest = utf8::printable(words);
    while (result.size() + 1 < count && width_(rest, size, false) > most) {
        std::size_t end = rest.npos;
        for (std::size_t at = 0;
             (at = rest.find(' ', at)) != rest.npos && width_(rest.substr(0, at), size, false) <= most; ++at)
            end = at;
        if (end == rest.npos) break;  // a word that is wider
        result.push_back(rest.substr(0, end));
        rest.erase(0, end + 1);
    }
    result.push_back(cut(rest, most, size));
    return result;
}

unsigned column_color(const Slide& slide, std::size_t column) {
    if (slide.columns[column].own) return ink::own;
    std::size_t others = 0;
    for (std::size_t i = 0; i < column; ++i) others += slide.columns[i].own ? 0 : 1;
    return ink::columns[others % ink::columns.size()];
}

void point_mark(SlidePage& page, double x, double y, double radius, bool own, double stroke, unsigned color) {
    if (own)
        page.box({x - radius, y - radius, x + radius, y + radius}, stroke, color);
    else
        page.disc(x, y, radius, stroke, color);
}

std::string error_number(double error) { return fmt::format("{:.2g}", error); }

std::vector<SlideShape> slide_shapes(const Slide& slide, const TextWidth& width) {
    SlidePage page(width);
    const double plot_right = slide.whole.width > 0 ? 1466 : slide_width - margin;
    heading(page, slide);
    plot_points(page, slide, {margin, 78, plot_right, brackets_top(page, slide) - 10});
    whole(page, slide, {plot_right + 34, 84, slide_width - margin, 84 + 380});
    if (!slide.columns.empty()) {
        bracket(page, slide, &SlideColumn::equal_time, "equal time");
        bracket(page, slide, &SlideColumn::equal_error, "equal error");
        for (std::size_t i = 0; i < slide.columns.size(); ++i) column(page, slide, i);
        reference_column(page, slide);
    }
    return std::move(page.shapes);
}

}  // namespace snell::accuracy
