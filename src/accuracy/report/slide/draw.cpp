// Slides as files: SVG as text, PNG and PDF by the Cairo module, which also knows how wide letters are.
#include <array>
#include <string>

#include "src/accuracy/report/slide/cairo/api.h"
#include "src/accuracy/report/slide/slide.h"
#include "src/content/load_module.h"
#include "src/plan/locate.h"

namespace snell::accuracy {

namespace {

using content::Mark, content::MarkKind;

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
