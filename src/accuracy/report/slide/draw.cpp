// What is where on a slide, the plot and the whole picture above, a column for each picture below; and slides as files:
// SVG as text, PNG and PDF by the Cairo module, which also knows how wide letters are.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "src/accuracy/report/slide/cairo/api.h"
#include "src/accuracy/report/slide/slide.h"
#include "src/content/image/image.h"
#include "src/content/load_module.h"
#include "src/plan/locate.h"

namespace snell::accuracy {

namespace {

using content::Area, content::Mark, content::MarkKind, content::Ink, content::Page, content::line_height;

// The least sizes of text are legible from the last row.
constexpr double text_size = 32, title_size = 44, name_size = 28, row = line_height * text_size;
constexpr double margin = 40, crop_width = 288, crop_height = 192, gap = 22, frame_width = 6;
constexpr double crops_top = 630, maps_top = crops_top + crop_height + 8, numbers_top = maps_top + crop_height + 6;
constexpr double dot_radius = 11, name_indent = 3 * dot_radius;
constexpr std::size_t most_lines = 3;  // of a column's name

class SlideLayout {
public:
    SlideLayout(const Slide& slide, const content::TextWidth& width) : slide_(slide), page_(width) {}

    std::vector<content::Mark> marks() {
        std::size_t most = 1;
        for (const SlideColumn& column : slide_.columns) most = std::max(most, name_of(column).lines.size());
        // Names stand on the pictures, and brackets on the names.
        const double brackets = crops_top - 84 - static_cast<double>(most - 1) * line_height * name_size;
        const double right = slide_.whole.width > 0 ? 1466 : slide_width - margin;
        page_.text(margin, 14, page_.cut(slide_.title, 760, title_size, true), title_size, Ink::text, 0, true);
        page_.text(slide_width - margin, 26, page_.cut(slide_.note, 1000, text_size), text_size, Ink::weak, 1);
        const Area plot{margin, 78, right, brackets - 10};
        if (slide_.plot.points.empty())
            page_.text((plot.x0 + plot.x1) / 2, (plot.y0 + plot.y1) / 2, slide_.plot.stamp, text_size, Ink::weak, .5);
        else
            draw_plot(page_, slide_.plot, plot, text_size);
        if (slide_.whole.width > 0) whole({right + 34, 84, slide_width - margin, 464});
        if (slide_.columns.empty()) return std::move(page_.marks);
        bracket(brackets, &SlideColumn::equal_time, "about equal time");
        bracket(brackets, &SlideColumn::equal_error, "about equal error");
        for (std::size_t i = 0; i < slide_.columns.size(); ++i) column(slide_.columns[i], left(i));
        reference(left(slide_.columns.size()));
        return std::move(page_.marks);
    }

private:
    struct Name {
        std::vector<std::string> lines;
        double size;
    };
    // On one line if it fits, otherwise on some of smaller text.
    Name name_of(const SlideColumn& column) const {
        constexpr double most = crop_width - name_indent;
        Name name{{page_.cut(column.name, most, text_size)}, text_size};
        if (name.lines[0].ends_with("…")) name = {page_.lines(column.name, most, most_lines, name_size), name_size};
        return name;
    }

    double left(std::size_t column) const {
        const auto count = static_cast<double>(slide_.columns.size() + 1);  // and the reference
        const double all = count * crop_width + (count - 1) * gap;
        return (slide_width - all) / 2 + static_cast<double>(column) * (crop_width + gap);
    }

    // A line above the columns of a group, with its name in the middle. Own columns belong to two groups, half to each.
    void bracket(double top, bool SlideColumn::*member, std::string_view words) {
        std::size_t first = slide_.columns.size(), last = 0;
        for (std::size_t i = 0; i < slide_.columns.size(); ++i)
            if (slide_.columns[i].*member) {
                first = std::min(first, i);
                last = i;
            }
        if (first >= last) return;
        const auto half = [&](std::size_t i) {
            const SlideColumn& column = slide_.columns[i];
            return column.equal_time && column.equal_error ? (crop_width + gap) / 2 : 0;
        };
        const double x0 = left(first) + half(first), x1 = left(last) + crop_width - half(last), y = top + row / 2;
        const Area text = page_.text((x0 + x1) / 2, top, words, text_size, Ink::text, .5);
        page_.line(x0, y, text.x0 - 14, y, 4, Ink::text);
        page_.line(text.x1 + 14, y, x1, y, 4, Ink::text);
        for (const double x : {x0, x1}) page_.line(x, y - 2, x, y + 14, 4, Ink::text);
    }

    // Every pixel becomes as large a square as fits.
    void framed(const content::Image& picture, double x, double y, Ink ink) {
        const double factor = std::max(1., std::floor(std::min(crop_width / std::max(picture.width, 1),
                                                               crop_height / std::max(picture.height, 1))));
        const double w = factor * picture.width, h = factor * picture.height;
        const double x0 = x + std::floor((crop_width - w) / 2), y0 = y + std::floor((crop_height - h) / 2);
        const Area frame{x0, y0, x0 + w, y0 + h};
        page_.image(frame, picture);
        page_.box(frame, frame_width, ink);
    }

    void column(const SlideColumn& column, double x) {
        const Name name = name_of(column);
        double y = crops_top - 5 - static_cast<double>(name.lines.size()) * line_height * name.size;
        page_.dot(x + dot_radius + 1, y + line_height * name.size / 2, dot_radius, column.own, 0, column.ink);
        for (const std::string& line : name.lines) y = page_.text(x + name_indent, y, line, name.size).y1;
        framed(column.picture, x, crops_top, column.ink);
        framed(column.map, x, maps_top, column.ink);
        // What differs from the scene's own rung stands out. Below the residual, the number would be the reference's.
        const bool below = slide_.plot.floor > 0 && column.error <= slide_.plot.floor;
        page_.text(x + crop_width, numbers_top, fmt::format("{}{:.2g}", below ? "<" : "", column.error), text_size,
                   Ink::text, 1, column.equal_time && !column.own);
        const double ms = column.milliseconds;
        if (ms > 0)
            page_.text(x, numbers_top, ms >= 100 ? fmt::format("{:.0f} ms", ms) : fmt::format("{:#.3g} ms", ms),
                       text_size, Ink::text, 0, column.equal_error && !column.own);
    }

    // With the scale of the maps, where the reference would have its own.
    void reference(double x) {
        page_.text(x, crops_top - 5 - row, "reference", text_size);
        framed(slide_.reference, x, crops_top, Ink::text);
        constexpr int steps = static_cast<int>(crop_width);
        const Area scale{x, maps_top + 56, x + crop_width, maps_top + 100};
        page_.text(x, scale.y0 - row - 6, "error seen (FLIP)", text_size);
        page_.image(scale, content::reduced(steps, 1, steps, 1, [](int i, int, std::size_t c) {
                        return content::heat(i / (crop_width - 1))[c];
                    }));
        page_.box(scale, 2, Ink::text);
        page_.text(x, scale.y1 + 4, "0", text_size);
        page_.text(scale.x1, scale.y1 + 4, fmt::format("{:g}{}", slide_.scale, slide_.scale < 1 ? " or more" : ""),
                   text_size, Ink::text, 1);
    }

    // The whole picture, and from where the others are.
    void whole(const Area& at) {
        const double factor = std::min(at.width() / slide_.whole.width, at.height() / slide_.whole.height);
        const double x = at.x1 - factor * slide_.whole.width;
        const Area all{x, at.y0, at.x1, at.y0 + factor * slide_.whole.height};
        page_.image(all, slide_.whole);
        page_.box(all, 2, Ink::text);
        if (slide_.columns.empty()) return;
        const Window& w = slide_.window;
        const Area frame{x + factor * w.x, at.y0 + factor * w.y, x + factor * (w.x + w.width),
                         at.y0 + factor * (w.y + w.height)};
        page_.box(frame, 8, Ink::paper);
        page_.box(frame, 4, Ink::text);
    }

    const Slide& slide_;
    Page page_;
};

}  // namespace

std::vector<content::Mark> slide_marks(const Slide& slide, const content::TextWidth& width) {
    return SlideLayout(slide, width).marks();
}

namespace {

struct CairoModule {
    decltype(&snell_cairo_draw) draw = nullptr;
    decltype(&snell_cairo_text_width) width = nullptr;
    std::string error;
};

CairoModule open_cairo() {
    CairoModule result;
    result.error = content::open_functions("snell_cairo.so", "Cairo", "snell_cairo_api_version", snell_cairo_version,
                                           std::pair{"snell_cairo_draw", &result.draw},
                                           std::pair{"snell_cairo_text_width", &result.width});
    return result;
}

const CairoModule& cairo_module() {
    static const CairoModule module = open_cairo();
    return module;
}

std::vector<Mark> measured_marks(const Slide& slide) {
    return slide_marks(slide, [](const std::string& text, double size, bool bold) {
        const CairoModule& module = cairo_module();
        const double width = module.error.empty() ? module.width(text.c_str(), size, bold ? 1 : 0) : -1;
        return width < 0 ? content::estimated_width(text, size, bold) : width;
    });
}

SnellCairoShape for_module(const Mark& mark) {
    constexpr std::array kinds{snell_cairo_line, snell_cairo_box, snell_cairo_disc, snell_cairo_text,
                               snell_cairo_image};  // as MarkKind
    const std::string_view color = content::print_colors[static_cast<std::size_t>(mark.ink)];
    return {.kind = kinds[static_cast<std::size_t>(mark.kind)],
            .x0 = mark.at.x0,
            .y0 = mark.kind == MarkKind::text ? mark.at.y0 + content::ascent * mark.size : mark.at.y0,
            .x1 = mark.at.x1,
            .y1 = mark.at.y1,
            .color = static_cast<unsigned>(std::stoul(std::string(color.substr(1)), nullptr, 16)),
            .stroke = mark.stroke,
            .size = mark.size,
            .bold = mark.bold ? 1 : 0,
            .text = mark.text.c_str(),
            .pixels = reinterpret_cast<const unsigned char*>(mark.picture.pixels.data()),
            .width = mark.picture.width,
            .height = mark.picture.height};
}

std::string slide_svg(const Slide& slide, std::string_view attributes) {
    std::vector<Mark> marks = measured_marks(slide);
    marks.insert(marks.begin(), {.at = {0, 0, slide_width, slide_height}, .ink = content::Ink::paper});
    return content::svg(marks, slide_width, slide_height, content::print_colors, attributes);
}

}  // namespace

SlideFile draw_slide(const Slide& slide, SlideFormat format) {
    if (format == SlideFormat::svg) return {slide_svg(slide, {}) + "\n", {}};
    const CairoModule& module = cairo_module();
    if (!module.error.empty()) return {{}, module.error};
    const std::vector<Mark> marks = measured_marks(slide);
    std::vector<SnellCairoShape> plain;
    for (const Mark& mark : marks) plain.push_back(for_module(mark));
    const auto write = [](void* to, const unsigned char* bytes, unsigned int count) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    };
    SlideFile file;
    std::array<char, 256> message{};
    if (module.draw(format == SlideFormat::pdf, slide_width, slide_height, plain.data(), plain.size(), write,
                    &file.bytes, message.data(), message.size()) != 0)
        return {{}, message.data()};
    return file;
}

std::string slide_element(const Slide& slide) {
    if (slide.plot.points.empty() && slide.columns.empty()) return {};
    return slide_svg(
        slide, "class=\"slide\" role=\"img\" aria-label=\"Error against time, and where the pictures differ most\"");
}

std::optional<SlideFormat> slide_format(std::string_view path) {
    if (has_extension(path, "png")) return SlideFormat::png;
    if (has_extension(path, "svg")) return SlideFormat::svg;
    if (has_extension(path, "pdf")) return SlideFormat::pdf;
    return std::nullopt;
}

}  // namespace snell::accuracy
