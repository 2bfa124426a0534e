// Slides as files, by the Cairo module.
#include <array>
#include <cctype>
#include <map>

#include "src/accuracy/report/slide/cairo/api.h"
#include "src/accuracy/report/slide/shapes.h"
#include "src/content/load_module.h"

namespace snell::accuracy {

namespace {

struct CairoModule {
    decltype(&snell_cairo_draw) draw = nullptr;
    decltype(&snell_cairo_text_width) width = nullptr;
    std::string error;
};

CairoModule open_cairo() {
    CairoModule result;
    const content::LoadedModule module = content::load_module("snell_cairo.so", "Cairo");
    result.error = module.error;
    if (!module.error.empty()) return result;
    decltype(&snell_cairo_api_version) version = nullptr;
    const bool fits = module.find("snell_cairo_api_version", version) && version() == snell_cairo_version &&
                      module.find("snell_cairo_draw", result.draw) &&
                      module.find("snell_cairo_text_width", result.width);
    if (!fits) result.error = module.path + " is from another version of snell";
    return result;
}

const CairoModule& cairo_module() {
    static const CairoModule module = open_cairo();
    return module;
}

SnellCairoShape for_module(const SlideShape& shape) {
    constexpr std::array kinds{snell_cairo_line, snell_cairo_box, snell_cairo_disc, snell_cairo_text,
                               snell_cairo_image};  // as ShapeKind
    SnellCairoShape result{};
    result.kind = kinds[static_cast<std::size_t>(shape.kind)];
    result.x0 = shape.at.x0;
    result.y0 = shape.kind == ShapeKind::text ? shape.at.y0 + ascent * shape.size : shape.at.y0;
    result.x1 = shape.at.x1;
    result.y1 = shape.at.y1;
    result.color = shape.color;
    result.stroke = shape.stroke;
    result.size = shape.size;
    result.bold = shape.bold ? 1 : 0;
    result.text = shape.text.c_str();
    result.pixels = shape.picture.rgb.data();
    result.width = shape.picture.width;
    result.height = shape.picture.height;
    return result;
}

// Cairo numbers the ids of an SVG file on from those of the file before. Here they are numbered from 1, with a name
// that no other element of a page has.
std::string renumbered(const std::string& svg) {
    std::map<std::string, std::string> names;
    for (std::size_t at = 0; (at = svg.find("id=\"", at)) != std::string::npos;) {
        const std::size_t begin = at + 4, end = svg.find('"', begin);
        names.try_emplace(svg.substr(begin, end - begin), "slide-" + std::to_string(names.size() + 1));
        at = end;
    }
    std::string out;
    std::size_t done = 0;
    // Ids occur as id="…", "#…" and url(#…).
    for (std::size_t at = 0; (at = svg.find_first_of("\"#", at)) != std::string::npos;) {
        const bool is_id = svg[at] == '#' || (at >= 3 && svg.compare(at - 3, 3, "id=") == 0);
        const std::size_t begin = ++at;
        if (!is_id) continue;
        const std::size_t end = svg.find_first_of("\")", begin);
        const auto name = names.find(svg.substr(begin, end - begin));
        if (name == names.end()) continue;
        out += svg.substr(done, begin - done) + name->second;
        done = at = end;
    }
    return out + svg.substr(done);
}

}  // namespace

SlideFile draw_slide(const Slide& slide, SlideFormat format) {
    SlideFile file;
    const CairoModule& module = cairo_module();
    file.error = module.error;
    if (!file.error.empty()) return file;
    const std::vector<SlideShape> shapes = slide_shapes(slide, [&](const std::string& text, double size, bool bold) {
        return module.width(text.c_str(), size, bold ? 1 : 0);
    });
    std::vector<SnellCairoShape> plain;
    for (const SlideShape& shape : shapes) plain.push_back(for_module(shape));
    constexpr std::array formats{snell_cairo_png, snell_cairo_svg, snell_cairo_pdf};  // as SlideFormat
    const auto write = [](void* to, const unsigned char* bytes, unsigned int count) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    };
    std::array<char, 256> message{};
    if (module.draw(formats[static_cast<std::size_t>(format)], slide_width, slide_height, plain.data(), plain.size(),
                    write, &file.bytes, message.data(), message.size()) != 0)
        return {{}, message.data()};
    if (format == SlideFormat::svg) file.bytes = renumbered(file.bytes);
    return file;
}

std::string slide_element(const Slide& slide, std::string& error) {
    if (slide.points.empty() && slide.columns.empty()) return {};
    const SlideFile file = draw_slide(slide, SlideFormat::svg);
    error = file.error;
    const std::size_t begin = file.bytes.find("<svg"), sizes = file.bytes.find("width=", begin),
                      view = file.bytes.find("viewBox=", begin);
    if (view == std::string::npos || sizes > view) return {};
    // As wide as the page, not as the file.
    return file.bytes.substr(begin, sizes - begin) +
           "class=\"slide\" role=\"img\" aria-label=\"Error against time, and where the pictures differ most\" " +
           file.bytes.substr(view);
}

}  // namespace snell::accuracy
