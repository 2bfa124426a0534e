#include "src/content/plot/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
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

namespace {

constexpr double label_width = 13, near = .95;  // in ems
constexpr double small = .875;                  // text of names that take several lines
constexpr std::size_t most_label_lines = 2;

constexpr double radius = .375, bar_end = .8 * radius, halo = .1;  // of points, in ems

Ink ink_of(const PlotPoint& p) { return p.ink ? *p.ink : p.own ? Ink::own : p.front ? Ink::front : Ink::other; }
bool has_bar(const PlotPoint& p) { return p.has_interval() && p.low < p.high; }
// It has a place on the axis of errors.
bool ranked(const PlotPoint& p) { return p.error > 0 && std::isfinite(p.error); }

class Drawing {
public:
    Drawing(Page& page, const Plot& plot, const Area& at, double em)
        : page_(page),
          plot_(plot),
          at_(at),
          em_(em),
          frame_{at.x0, at.y0 + row_ + .2 * em, at.x1, at.y1 - 2 * row_ - .2 * em},
          y_(error_axis()),
          x_(time_axis()) {}

    std::vector<std::pair<double, double>> draw() {
        band();
        axes();
        for (const auto& [a, b] : plot_.edges) edge(plot_.points[a], plot_.points[b]);
        front_lines();
        for (const PlotPoint& p : plot_.points) bar(p);
        // Those that are elsewhere on the page, too, above the others.
        for (const bool strong : {false, true})
            for (const PlotPoint& p : plot_.points)
                if (p.ink.has_value() == strong) mark(p);
        labels();
        std::vector<std::pair<double, double>> places;
        for (const PlotPoint& p : plot_.points) places.emplace_back(x_of(p), y_of(p));
        return places;
    }

private:
    bool has_zero() const {
        return ranges::any_of(plot_.points, [](const PlotPoint& p) { return p.error == 0; });
    }
    bool has_infinite() const {
        return ranges::any_of(plot_.points, [](const PlotPoint& p) { return std::isinf(p.error); });
    }

    // The floor is shown if errors come within a factor of 100 of it.
    Axis error_axis() const {
        double low = 1e30, high = 0;
        for (const PlotPoint& p : plot_.points)
            if (ranked(p)) {
                low = std::min(low, p.error);
                high = std::max(high, p.error);
            }
        if (plot_.floor > low / 100)
            low = std::min(low, plot_.floor * std::min(.75, std::pow(plot_.floor / high, .12)));
        const double from = frame_.y1 - (has_zero() ? strip_ : 0), to = frame_.y0 + (has_infinite() ? strip_ : 0);
        return high > 0 ? Axis(low, high, from, to, plot_.decades) : Axis(.001, 1, from, to);
    }
    // The numbers of errors are at the left of it.
    Axis time_axis() {
        double numbers = page_.width("0", em_);
        for (const double tick : y_.ticks()) numbers = std::max(numbers, page_.width(fmt::format("{:g}", tick), em_));
        frame_.x0 += numbers + .5 * em_;
        double low = 1e30, high = 0;
        for (const PlotPoint& p : plot_.points) {
            low = std::min(low, p.low > 0 ? p.low : p.milliseconds);
            high = std::max(high, std::isfinite(p.high) ? std::max(p.high, p.milliseconds) : p.milliseconds);
        }
        return high > 0 ? Axis(low, high, frame_.x0, frame_.x1, plot_.decades) : Axis(1, 10, frame_.x0, frame_.x1);
    }
    double x_of(const PlotPoint& p) const { return x_.at(p.milliseconds); }
    double y_of(const PlotPoint& p) const {
        if (p.error == 0) return frame_.y1 - strip_ / 2;
        return std::isinf(p.error) ? frame_.y0 + strip_ / 2 : y_.at(p.error);
    }

    // Nothing in it can be told apart from the reference.
    void band() {
        if (!(plot_.floor > 0) || !y_.shows(plot_.floor)) return;
        band_ = {frame_.x0, y_.at(plot_.floor), frame_.x1, frame_.y1};
        page_.box(*band_, 0, Ink::band);
    }

    void axes() {
        double after = frame_.x0 - 2 * em_;  // no number overlaps the one before
        for (const double tick : x_.ticks()) {
            const std::string number = fmt::format("{:g}", tick);
            const double x = x_.at(tick), half = page_.width(number, em_) / 2;
            page_.line(x, frame_.y0, x, frame_.y1, em_ / 16, Ink::grid);
            if (x - half < after + em_ / 2 || x + half > frame_.x1) continue;
            after = page_.text(x, frame_.y1 + .2 * em_, number, em_, Ink::text, .5).x1;
        }
        double above = has_zero() ? frame_.y1 - (strip_ + row_) / 2 - em_ / 8 : frame_.y1 + row_ / 2;
        const double below = has_infinite() ? frame_.y0 + (strip_ + row_) / 2 + em_ / 8 : frame_.y0 - em_ / 8;
        for (const double tick : y_.ticks()) {
            const double y = y_.at(tick);
            page_.line(frame_.x0, y, frame_.x1, y, em_ / 16, Ink::grid);
            if (y + row_ / 2 > above || y - row_ / 2 < below) continue;
            above = y - row_ / 2 - em_ / 8;
            number_at(y, fmt::format("{:g}", tick));
        }
        if (has_zero()) number_at(frame_.y1 - strip_ / 2, "0");
        if (has_infinite()) number_at(frame_.y0 + strip_ / 2, "∞");
        page_.line(frame_.x0, frame_.y0, frame_.x0, frame_.y1, em_ / 8, Ink::text);
        page_.line(frame_.x0 - em_ / 16, frame_.y1, frame_.x1, frame_.y1, em_ / 8, Ink::text);
        const double end = page_.text(at_.x0, at_.y0, plot_.errors, em_).x1 + em_;
        page_.text(frame_.x1, at_.y0, page_.cut(plot_.stamp, frame_.x1 - end, em_), em_, Ink::text, 1);
        page_.text(frame_.x1, frame_.y1 + row_ + .2 * em_, plot_.times, em_, Ink::text, 1);
    }
    void number_at(double y, const std::string& number) {
        page_.text(frame_.x0 - .4 * em_, y - row_ / 2, number, em_, Ink::text, 1);
    }

    void edge(const PlotPoint& a, const PlotPoint& b) {
        const bool wrong = (b.milliseconds - a.milliseconds) * (b.error - a.error) > 0;
        page_.line(x_of(a), y_of(a), x_of(b), y_of(b), em_ / 12, wrong ? Ink::wrong : Ink::grid);
    }

    // A staircase, because there are no choices between two rungs.
    void front_lines() {
        std::vector<const PlotPoint*> front;
        for (const PlotPoint& p : plot_.points)
            if (p.front) front.push_back(&p);
        ranges::stable_sort(front, {}, [](const PlotPoint* p) { return p->milliseconds; });
        for (std::size_t i = 1; i < front.size(); ++i) {
            const double x0 = x_of(*front[i - 1]), y0 = y_of(*front[i - 1]), x1 = x_of(*front[i]), y1 = y_of(*front[i]);
            segment(x0, y0, x1, y0);
            segment(x1, y0, x1, y1);
        }
    }
    void segment(double x0, double y0, double x1, double y1) {
        const double room = em_ / 8;
        page_.line(x0, y0, x1, y1, .19 * em_, Ink::front);
        taken_.push_back(
            {std::min(x0, x1) - room, std::min(y0, y1) - room, std::max(x0, x1) + room, std::max(y0, y1) + room});
    }

    void bar(const PlotPoint& p) {
        if (!has_bar(p)) return;
        const double x0 = x_.at(p.low), x1 = x_.at(p.high), y = y_of(p);
        draw_bar(page_, p, x0, x1, y, em_);
        taken_.push_back({x0 - radius_, y - bar_end * em_, x1 + radius_, y + bar_end * em_});
    }

    void mark(const PlotPoint& p) {
        const double x = x_of(p), y = y_of(p), size = draw_point(page_, p, x, y, em_);
        taken_.push_back({x - size, y - size, x + size, y + size});
    }

    bool free(const Area& area) const {
        return frame_.holds(area) && ranges::none_of(taken_, [&](const Area& other) { return area.meets(other); });
    }
    // Lines of text, one below the other.
    void place(const Area& area, const std::vector<std::string>& lines, Ink ink, double size) {
        double y = area.y0;
        for (const std::string& line : lines) y = page_.text(area.x0, y, line, size, ink).y1;
        texts_.push_back({area.x0 - em_ / 2, area.y0, area.x1 + em_ / 2, area.y1});
        taken_.push_back(texts_.back());
    }

    void labels() {
        std::vector<const PlotPoint*> order;
        for (const PlotPoint& p : plot_.points)
            if (p.label) order.push_back(&p);
        ranges::stable_sort(order, {}, [](const PlotPoint* p) { return *p->label; });
        for (const PlotPoint* p : order) label(*p);
        floor_label();
    }

    void label(const PlotPoint& p) {
        double size = em_;
        std::vector<std::string> lines{page_.cut(p.name, label_width * em_, size)};
        if (lines[0].ends_with("…")) {
            size = small * em_;
            lines = page_.lines(p.name, label_width * em_, most_label_lines, size);
        }
        double w = 0;
        for (const std::string& line : lines) w = std::max(w, page_.width(line, size));
        const double h = static_cast<double>(lines.size()) * line_height * size;
        const double x = x_of(p), y = y_of(p), side = radius_ + .3 * em_;
        const double right = has_bar(p) ? std::max(side, x_.at(p.high) - x + .45 * em_) : side;
        const double left = has_bar(p) ? std::max(side, x - x_.at(p.low) + .45 * em_) : side;
        for (const double far : {0., .4, .9, 1.4, 2., 2.8, 3.75})
            for (const auto& [dx, dy] : {std::pair{right, -h / 2},
                                         {-left - w, -h / 2},
                                         {-w / 2, -side - h},
                                         {-w / 2, side},
                                         {side, -h - em_ / 8},
                                         {side, em_ / 8},
                                         {-side - w, -h - em_ / 8},
                                         {-side - w, em_ / 8}}) {
                const double top = y + dy + (dy < -h / 2 ? -far : dy > -h / 2 ? far : 0) * em_;
                // Above and below, it may be shifted to stay inside the frame.
                const double first = frame_.x0 + .2 * em_;
                const double inside = std::clamp(x + dx, first, std::max(frame_.x1 - w - .2 * em_, first));
                const double from = dx == -w / 2 ? inside : x + dx;
                const Area area{from, top, from + w, top + h};
                if (!free(area) || (far > near && !lead(p, area))) continue;
                place(area, lines, Ink::text, size);
                return;
            }
    }

    // Draws a line to a label that is not next to its point; returns false if it would cross another label.
    bool lead(const PlotPoint& p, const Area& area) {
        const double x = x_of(p), y = y_of(p), middle = (area.x0 + area.x1) / 2, inset = .6 * em_;
        const double end = std::clamp(x, std::min(area.x0 + inset, middle), std::max(area.x1 - inset, middle));
        const double edge = area.y0 > y ? area.y0 : area.y1;
        const Area around{std::min(x, end), std::min(y, edge), std::max(x, end), std::max(y, edge)};
        if (ranges::any_of(texts_, [&](const Area& other) { return around.meets(other); })) return false;
        page_.line(x, y, end, edge, em_ / 11, ink_of(p));
        return true;
    }

    void floor_label() {
        if (!band_) return;
        const double w = page_.width(plot_.floor_words, em_), h = line_height * em_;
        for (const double top : {band_->y0 + em_ / 8, frame_.y1 - h - em_ / 8, band_->y0 - row_ - em_ / 16})
            for (const double part : {1., 0., .5, .75, .25}) {
                const double x = frame_.x0 + .4 * em_ + part * (frame_.width() - .8 * em_ - w);
                const Area area{x, top, x + w, top + h};
                if (!free(area)) continue;
                place(area, {plot_.floor_words}, Ink::weak, em_);
                return;
            }
    }

    Page& page_;
    const Plot& plot_;
    Area at_;
    double em_, row_ = line_height * em_, strip_ = 1.25 * em_, radius_ = radius * em_;
    Area frame_;
    Axis y_, x_;
    std::optional<Area> band_;
    std::vector<Area> taken_;  // no label may cover them
    std::vector<Area> texts_;  // of these, the labels, with some room at their sides
};

}  // namespace

bool PlotPoint::has_interval() const { return low > 0 && std::isfinite(high); }

double draw_point(Page& page, const PlotPoint& p, double x, double y, double em) {
    const bool strong = p.ink || p.front || p.own;
    const double size = (strong ? 1.1 : .8) * radius * em, around = halo * em;
    page.dot(x, y, size + around, p.own, 0, Ink::paper);
    if (p.chosen) page.dot(x, y, size + 2 * around, p.own, around, Ink::text);
    if (p.beaten && !p.ink && !p.own)
        page.dot(x, y, size - around / 2, p.own, .12 * em, ink_of(p), p.tip);
    else
        page.dot(x, y, size, p.own, 0, ink_of(p), p.tip);
    return size + around;
}

void draw_bar(Page& page, const PlotPoint& p, double low, double high, double y, double em) {
    const double end = bar_end * em, stroke = .16 * em;
    page.line(low, y, high, y, stroke, ink_of(p));
    page.line(low, y - end, low, y + end, stroke, ink_of(p));
    page.line(high, y - end, high, y + end, stroke, ink_of(p));
}

std::vector<std::pair<double, double>> draw_plot(Page& page, const Plot& plot, const Area& at, double em) {
    return Drawing(page, plot, at, em).draw();
}

Axis::Axis(double low, double high, double from, double to, double decades) : from_(from), to_(to) {
    if (!(high > low)) {
        low /= 1.5;
        high *= 1.5;
    }
    const double more = std::max(decades * std::log(10) - std::log(high / low), 0.) / 2;
    low *= std::exp(-more);
    high *= std::exp(more);
    const double room = .06 * std::log(high / low) + .02;
    low_ = std::log(low) - room;
    high_ = std::log(high) + room;
}

double Axis::at(double value) const {
    return from_ + (std::log(std::max(value, 1e-30)) - low_) / (high_ - low_) * (to_ - from_);
}

bool Axis::shows(double value) const { return value > 0 && std::log(value) >= low_ && std::log(value) <= high_; }

std::vector<double> Axis::ticks() const {
    std::vector<double> all;
    const int first = static_cast<int>(std::floor(low_ / std::log(10))),
              last = static_cast<int>(high_ / std::log(10)) + 1;
    for (int decade = first; decade <= last; ++decade)
        for (double step : {1., 2., 5.})
            if (shows(step * std::pow(10, decade)) && (step == 1 || last - first < 5))
                all.push_back(step * std::pow(10, decade));
    return all.size() >= 3 ? all : even_ticks();
}

// Three to seven even steps of 1, 2 or 5 times a power of ten.
std::vector<double> Axis::even_ticks() const {
    const double low = std::exp(low_), high = std::exp(high_);
    const double power = std::pow(10, std::floor(std::log10((high - low) / 3)));
    const double least = (high - low) / 7;
    const double step = power >= least ? power : 2 * power >= least ? 2 * power : 5 * power;
    std::vector<double> all;
    for (double i = std::ceil(low / step); i * step <= high; ++i) all.push_back(i * step);
    return all;
}

}  // namespace snell::content
