// The plot of a slide: error against time, both logarithmic.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "parser/text/ranges.h"
#include "src/accuracy/report/plot.h"
#include "src/accuracy/report/slide/shapes.h"

namespace snell::accuracy {

namespace {

constexpr double text_row = line_height * small_text, strip = 40, radius = 12;
constexpr double numbers_width = 150;           // of the errors at the axis
constexpr std::size_t most_front_labels = 4;    // besides those of the columns
constexpr double label_width = 420, near = 30;  // in pixels
constexpr std::size_t most_label_lines = 2;

bool has_bar(const SlidePoint& p) { return p.has_interval() && p.low < p.high; }
// It has a place on the axis of errors.
bool ranked(const SlidePoint& p) { return p.error > 0 && std::isfinite(p.error); }

class PointPlot {
public:
    PointPlot(SlidePage& page, const Slide& slide, const SlideBox& at)
        : page_(page),
          slide_(slide),
          title_top_(at.y0),
          frame_{at.x0 + numbers_width, at.y0 + text_row + 6, at.x1, at.y1 - 2 * text_row - 6},
          x_(time_axis()),
          y_(error_axis()) {}

    void draw() {
        band();
        axes();
        front_lines();
        for (const SlidePoint& p : slide_.points) bar(p);
        // Those with pictures above the others.
        for (const SlidePoint& p : slide_.points)
            if (p.column == no_column) mark(p);
        for (const SlidePoint& p : slide_.points)
            if (p.column != no_column) mark(p);
        const std::string words = page_.cut(slide_.stamp, frame_.width() - error_title_.size() * small_text * .6);
        const SlideBox stamp = page_.text_box(0, 0, words);
        page_.text(page_.text_box(frame_.x1 - stamp.width(), title_top_, words), words, ink::text);
        labels();
    }

private:
    bool any(bool (*condition)(const SlidePoint&)) const { return ranges::any_of(slide_.points, condition); }
    bool has_zero() const {
        return any([](const SlidePoint& p) { return p.error == 0; });
    }
    bool has_infinite() const {
        return any([](const SlidePoint& p) { return std::isinf(p.error); });
    }

    Axis time_axis() const {
        double low = 1e30, high = 0;
        for (const SlidePoint& p : slide_.points) {
            low = std::min(low, p.low > 0 ? p.low : p.milliseconds);
            high = std::max(high, std::isfinite(p.high) ? std::max(p.high, p.milliseconds) : p.milliseconds);
        }
        return high > 0 ? Axis(low, high, frame_.x0, frame_.x1) : Axis(1, 10, frame_.x0, frame_.x1);
    }
    // The floor is shown if errors come within a factor of 100 of it.
    Axis error_axis() const {
        double low = 1e30, high = 0;
        for (const SlidePoint& p : slide_.points)
            if (ranked(p)) {
                low = std::min(low, p.error);
                high = std::max(high, p.error);
            }
        if (slide_.floor > low / 100)
            low = std::min(low, slide_.floor * std::min(.75, std::pow(slide_.floor / high, .12)));
        const double from = frame_.y1 - (has_zero() ? strip : 0), to = frame_.y0 + (has_infinite() ? strip : 0);
        return high > 0 ? Axis(low, high, from, to) : Axis(.001, 1, from, to);
    }
    double x_of(const SlidePoint& p) const { return x_.at(p.milliseconds); }
    double y_of(const SlidePoint& p) const {
        if (p.error == 0) return frame_.y1 - strip / 2;
        return std::isinf(p.error) ? frame_.y0 + strip / 2 : y_.at(p.error);
    }

    // Nothing in it can be told apart from the reference.
    void band() {
        if (!(slide_.floor > 0) || !y_.shows(slide_.floor)) return;
        band_ = {frame_.x0, y_.at(slide_.floor), frame_.x1, frame_.y1};
        page_.box(*band_, 0, ink::band);
    }

    void axes() {
        double after = frame_.x0 - 60;  // no number overlaps the one before
        for (double tick : x_.ticks()) {
            const std::string number = fmt::format("{:g}", tick);
            const double x = x_.at(tick);
            const SlideBox size = page_.text_box(0, 0, number);
            page_.line(x, frame_.y0, x, frame_.y1, 2, ink::grid);
            const SlideBox box = page_.text_box(x - size.width() / 2, frame_.y1 + 6, number);
            if (box.x0 < after + 16 || box.x1 > frame_.x1 + 20) continue;
            after = box.x1;
            page_.text(box, number, ink::text);
        }
        double above = has_zero() ? frame_.y1 - (strip + text_row) / 2 - 4 : frame_.y1 + text_row / 2;
        const double below = has_infinite() ? frame_.y0 + (strip + text_row) / 2 + 4 : frame_.y0 - 4;
        for (double tick : y_.ticks()) {
            const double y = y_.at(tick);
            page_.line(frame_.x0, y, frame_.x1, y, 2, ink::grid);
            if (y + text_row / 2 > above || y - text_row / 2 < below) continue;
            above = y - text_row / 2 - 4;
            number_at(y, fmt::format("{:g}", tick));
        }
        if (has_zero()) number_at(frame_.y1 - strip / 2, "0");
        if (has_infinite()) number_at(frame_.y0 + strip / 2, "∞");
        page_.line(frame_.x0, frame_.y0, frame_.x0, frame_.y1, 4, ink::axis);
        page_.line(frame_.x0 - 2, frame_.y1, frame_.x1, frame_.y1, 4, ink::axis);
        const std::string error(error_title_), time = "time of a frame, ms (" + slide_.clock + ")";
        page_.text(page_.text_box(frame_.x0 - numbers_width, title_top_, error), error, ink::text);
        const SlideBox size = page_.text_box(0, 0, time);
        page_.text(page_.text_box(frame_.x1 - size.width(), frame_.y1 + text_row + 6, time), time, ink::text);
    }
    void number_at(double y, const std::string& number) {
        const SlideBox size = page_.text_box(0, 0, number);
        page_.text(page_.text_box(frame_.x0 - 14 - size.width(), y - text_row / 2, number), number, ink::text);
    }

    // A staircase, because there are no choices between two rungs.
    void front_lines() {
        std::vector<const SlidePoint*> front;
        for (const SlidePoint& p : slide_.points)
            if (p.front) front.push_back(&p);
        ranges::stable_sort(front, {}, [](const SlidePoint* p) { return p->milliseconds; });
        for (std::size_t i = 1; i < front.size(); ++i) {
            const double x0 = x_of(*front[i - 1]), y0 = y_of(*front[i - 1]), x1 = x_of(*front[i]), y1 = y_of(*front[i]);
            segment(x0, y0, x1, y0);
            segment(x1, y0, x1, y1);
        }
    }
    void segment(double x0, double y0, double x1, double y1) {
        page_.line(x0, y0, x1, y1, 6, ink::axis);
        taken_.push_back({std::min(x0, x1) - 4, std::min(y0, y1) - 4, std::max(x0, x1) + 4, std::max(y0, y1) + 4});
    }

    unsigned color(const SlidePoint& p) const {
        if (p.column != no_column) return column_color(slide_, p.column);
        return p.own ? ink::own : p.front ? ink::axis : ink::other;
    }

    void bar(const SlidePoint& p) {
        if (!has_bar(p)) return;
        const double x0 = x_.at(p.low), x1 = x_.at(p.high), y = y_of(p), end = radius - 2;
        page_.line(x0, y, x1, y, 5, color(p));
        page_.line(x0, y - end, x0, y + end, 5, color(p));
        page_.line(x1, y - end, x1, y + end, 5, color(p));
        taken_.push_back({x0 - 12, y - end, x1 + 12, y + end});
    }

    void mark(const SlidePoint& p) {
        const double x = x_of(p), y = y_of(p);
        const bool strong = p.column != no_column || p.front || p.own;
        const double size = strong ? radius + 1 : radius - 2;
        point_mark(page_, x, y, size + 3, p.own, 0, 0xffffff);
        if (strong)
            point_mark(page_, x, y, size, p.own, 0, color(p));
        else
            point_mark(page_, x, y, size - 2, p.own, 4, color(p));
        taken_.push_back({x - size - 3, y - size - 3, x + size + 3, y + size + 3});
    }

    bool free(const SlideBox& box) const {
        return frame_.holds(box) && ranges::none_of(taken_, [&](const SlideBox& other) { return box.meets(other); });
    }
    // Lines of text, one below the other.
    void place(const SlideBox& box, const std::vector<std::string>& lines, unsigned color = ink::text,
               double size = small_text) {
        double y = box.y0;
        for (const std::string& line : lines) {
            page_.text(page_.text_box(box.x0, y, line, size), line, color, size);
            y += line_height * size;
        }
        texts_.push_back({box.x0 - 16, box.y0, box.x1 + 16, box.y1});
        taken_.push_back(texts_.back());
    }

    // The important points first: those with pictures, then some of the front.
    void labels() {
        std::vector<const SlidePoint*> order, front;
        for (const SlidePoint& p : slide_.points) {
            if (p.column != no_column || p.own)
                order.push_back(&p);
            else if (p.front)
                front.push_back(&p);
        }
        ranges::stable_sort(order, {}, [](const SlidePoint* p) { return p->own ? 0 : 1; });
        for (const SlidePoint* p : order) label(*p);
        floor_label();
        ranges::stable_sort(front, {}, [](const SlidePoint* p) { return p->error; });
        front.resize(std::min(front.size(), most_front_labels));
        for (const SlidePoint* p : front) label(*p);
    }

    void label(const SlidePoint& p) {
        std::vector<std::string> lines{page_.cut(p.name, label_width)};
        const double text = lines[0].ends_with("…") ? name_text : small_text;
        if (text < small_text) lines = page_.lines(p.name, label_width, most_label_lines, text);
        double w = 0;
        for (const std::string& line : lines) w = std::max(w, page_.text_box(0, 0, line, text).width());
        const double h = static_cast<double>(lines.size()) * line_height * text;
        const double x = x_of(p), y = y_of(p), side = radius + 10;
        const double right = has_bar(p) ? std::max(side, x_.at(p.high) - x + 14) : side;
        const double left = has_bar(p) ? std::max(side, x - x_.at(p.low) + 14) : side;
        for (double far : {0., 12., 28., 46., 66., 90., 120.})
            for (const auto& [dx, dy] : {std::pair{right, -h / 2},
                                         {-left - w, -h / 2},
                                         {-w / 2, -side - h},
                                         {-w / 2, side},
                                         {side, -h - 4},
                                         {side, 4.},
                                         {-side - w, -h - 4},
                                         {-side - w, 4.}}) {
                const double top = y + dy + (dy < -h / 2 ? -far : dy > -h / 2 ? far : 0);
                // Above and below, it may be shifted to stay inside the frame.
                const double inside = std::clamp(x + dx, frame_.x0 + 6, std::max(frame_.x1 - w - 6, frame_.x0 + 6));
                const double from = dx == -w / 2 ? inside : x + dx;
                const SlideBox box{from, top, from + w, top + h};
                if (free(box) && (far <= near || lead(p, box))) {
                    place(box, lines, ink::text, text);
                    return;
                }
            }
    }

    // Draws a line to a label that is not next to its point; returns false if it would cross another label.
    bool lead(const SlidePoint& p, const SlideBox& box) {
        const double x = x_of(p), y = y_of(p), end = std::clamp(x, box.x0 + 20, box.x1 - 20);
        const double edge = box.y0 > y ? box.y0 : box.y1;
        const SlideBox around{std::min(x, end), std::min(y, edge), std::max(x, end), std::max(y, edge)};
        if (ranges::any_of(texts_, [&](const SlideBox& other) { return around.meets(other); })) return false;
        page_.line(x, y, end, edge, 3, color(p));
        return true;
    }

    void floor_label() {
        if (!band_) return;
        const std::string words = "residual of the reference";
        const SlideBox size = page_.text_box(0, 0, words);
        const double inside = band_->y0 + 4, above = band_->y0 - text_row - 2;
        for (double top : {inside, above})
            for (double part : {1., 0., .5, .75, .25}) {
                const double x = frame_.x0 + 12 + part * (frame_.width() - 24 - size.width());
                const SlideBox box = page_.text_box(x, top, words);
                if (!free(box)) continue;
                place(box, {words}, ink::weak);
                return;
            }
    }

    static constexpr std::string_view error_title_ = "error of light (RMSE)";
    SlidePage& page_;
    const Slide& slide_;
    double title_top_;
    SlideBox frame_;
    Axis x_, y_;
    std::optional<SlideBox> band_;
    std::vector<SlideBox> taken_;  // no label may cover them
    std::vector<SlideBox> texts_;  // of these, the labels, with some room at their sides
};

}  // namespace

void plot_points(SlidePage& page, const Slide& slide, const SlideBox& at) {
    if (!slide.points.empty()) {
        PointPlot(page, slide, at).draw();
        return;
    }
    const SlideBox size = page.text_box(0, 0, slide.stamp);
    page.text(page.text_box((at.x0 + at.x1 - size.width()) / 2, (at.y0 + at.y1) / 2, slide.stamp), slide.stamp,
              ink::weak);
}

}  // namespace snell::accuracy
