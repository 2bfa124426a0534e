#include "src/content/plot/page.h"

#include <fmt/format.h>

#include "parser/text/words.h"
#include "src/content/table.h"
#include "src/content/text_forms.h"

namespace snell::content {

double estimated_width(const std::string& text, double size, bool bold) {
    double letters = 0;
    for (std::size_t at = 0; at < text.size();) {
        const utf8::Char c = utf8::decode(text, at);
        letters += utf8::width(c.code);
        at += c.length;
    }
    return letters * size * (bold ? .68 : .61);
}

void Page::line(double x0, double y0, double x1, double y1, double stroke, Ink ink) {
    marks.push_back({MarkKind::line, {x0, y0, x1, y1}, ink, stroke});
}
void Page::box(const Area& at, double stroke, Ink ink, std::string tip) {
    marks.push_back({.at = at, .ink = ink, .stroke = stroke, .text = std::move(tip)});
}
void Page::dot(double x, double y, double radius, bool square, double stroke, Ink ink, std::string tip) {
    box({x - radius, y - radius, x + radius, y + radius}, stroke, ink, std::move(tip));
    if (!square) marks.back().kind = MarkKind::disc;
}
void Page::image(const Area& at, Image picture) {
    marks.push_back({.kind = MarkKind::image, .at = at, .picture = std::move(picture)});
}
Area Page::text(double x, double top, std::string_view words, double size, Ink ink, double part, bool bold) {
    std::string shown = utf8::printable(words);
    const double wide = width_(shown, size, bold), left = x - part * wide;
    const Area at{left, top, left + wide, top + line_height * size};
    if (!shown.empty()) marks.push_back({MarkKind::text, at, ink, 0, size, bold, std::move(shown), {}, part});
    return at;
}

double Page::width(std::string_view words, double size, bool bold) const {
    return width_(utf8::printable(words), size, bold);
}

std::string Page::cut(std::string_view words, double most, double size, bool bold) const {
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

std::vector<std::string> Page::lines(std::string_view words, double most, std::size_t count, double size) const {
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

namespace {

std::string svg_mark(const Mark& mark, std::string_view color) {
    const Area& a = mark.at;
    const std::string paint =
        mark.stroke > 0 ? fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:.3g}\"", color, mark.stroke)
                        : fmt::format("fill=\"{}\"", color);
    const std::string end = mark.text.empty() ? "/>" : "><title>" + escaped(utf8::printable(mark.text)) + "</title>";
    const auto closed = [&](std::string_view element) {
        return mark.text.empty() ? "" : fmt::format("</{}>", element);
    };
    switch (mark.kind) {
        case MarkKind::line:
            return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>", a.x0, a.y0, a.x1,
                               a.y1, paint);
        case MarkKind::box:
            return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}{}{}", a.x0, a.y0,
                               a.width(), a.height(), paint, end, closed("rect"));
        case MarkKind::disc:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}{}{}", (a.x0 + a.x1) / 2,
                               (a.y0 + a.y1) / 2, a.width() / 2, paint, end, closed("circle"));
        case MarkKind::text:  // whose letters may be narrower in another font
            return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\" text-anchor=\"{}\"{} {}>{}</text>",
                               a.x0 + mark.part * a.width(), a.y0 + ascent * mark.size, mark.size,
                               mark.part == 0   ? "start"
                               : mark.part == 1 ? "end"
                                                : "middle",
                               mark.bold ? " font-weight=\"bold\"" : "", paint, escaped(mark.text));
        case MarkKind::image:
            return fmt::format(
                "<image x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" preserveAspectRatio=\"none\" "
                "image-rendering=\"pixelated\" href=\"data:image/png;base64,{}\"/>",
                a.x0, a.y0, a.width(), a.height(), base64(encode_png(mark.picture)));
    }
    return {};
}

}  // namespace

std::string svg(const std::vector<Mark>& marks, int width, int height, const InkColors& colors,
                std::string_view attributes) {
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"'DejaVu Sans',sans-serif\" {}>",
        width, height, attributes);
    for (const Mark& mark : marks) text += svg_mark(mark, colors[static_cast<std::size_t>(mark.ink)]);
    return text + "</svg>";
}

}  // namespace snell::content
