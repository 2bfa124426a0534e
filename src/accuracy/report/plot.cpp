#include "src/accuracy/report/plot.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/accuracy/report/found.h"
#include "src/accuracy/report/report.h"

namespace snell::accuracy {

namespace {

constexpr double width = 640, height = 400, left = 64, right = 16, top = 16, bottom = 48;
constexpr double equal_gap = 34;  // distance of the line for errors of 0 below the axis of errors

struct Box {
    double x0, y0, x1, y1;
    bool meets(const Box& b) const { return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1; }
};

struct Mark {
    std::size_t rung;
    double x, y;
};

class Plot {
public:
    explicit Plot(const SweepResult& sweep) : sweep_(sweep), x_(time_axis()), y_(error_axis()) {
        for (std::size_t i = 0; i < sweep.rungs.size(); ++i)
            if (shown(i) && !std::isnan(sweep.error(sweep.rungs[i])))
                marks_.push_back({i, x_.at(sweep.rungs[i].milliseconds), y_at(i)});
    }

    std::string svg(std::string_view style) {
        out_ = fmt::format(
            "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" "
            "aria-label=\"{}: "
            "error over time\">",
            width, height, content::escaped(sweep_.sweep.name));
        if (!style.empty()) out_ += fmt::format("<style>{}</style>", style);
        axes();
        if (sweep_.sweep.kind == SweepKind::lattice) edges();
        front_line();
        for (const Mark& mark : marks_) whisker(mark);
        for (const Mark& mark : marks_) symbol(mark);
        labels();
        if (!sweep_.trusted())
            text("stamp", width - right - 6, top + 18, "end",
                 sweep_.cannot_say.empty() ? "too few rounds: no front" : "can't say");
        return out_ + "</svg>";
    }

private:
    bool shown(std::size_t i) const {
        return sweep_.rungs[i].drawn && sweep_.rungs[i].rounds > 0 && !plainly_visible(sweep_, i);
    }
    Axis time_axis() const {
        double low = 1e30, high = 0;
        for (std::size_t i = 0; i < sweep_.rungs.size(); ++i)
            if (const RungResult& rung = sweep_.rungs[i]; shown(i)) {
                low = std::min(low, rung.low > 0 ? rung.low : rung.milliseconds);
                high = std::max(high, std::isfinite(rung.high) ? rung.high : rung.milliseconds);
            }
        return high > 0 ? Axis(low, high, left, width - right) : Axis(1, 10, left, width - right);
    }
    Axis error_axis() const {
        double low = 1e30, high = 0;
        for (std::size_t i = 0; i < sweep_.rungs.size(); ++i)
            if (const double error = sweep_.error(sweep_.rungs[i]); shown(i) && error > 0 && std::isfinite(error)) {
                low = std::min(low, error);
                high = std::max(high, error);
            }
        const double lowest = height - bottom - equal_gap;
        return high > 0 ? Axis(low, high, lowest, top) : Axis(.01, 1, lowest, top);
    }
    double y_at(std::size_t rung) const {
        const double error = sweep_.error(sweep_.rungs[rung]);
        if (std::isinf(error)) return top + 4;  // a picture with pixels that are not finite
        return error > 0 ? y_.at(error) : height - bottom - 10;
    }

    void line(std::string_view kind, double x0, double y0, double x1, double y1) {
        out_ += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>", kind, x0,
                            y0, x1, y1);
    }
    void text(std::string_view kind, double x, double y, std::string_view anchor, std::string_view words) {
        out_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", kind, x, y,
                            anchor, content::escaped(words));
    }

    void axes() {
        const double base = height - bottom;
        for (double tick : x_.ticks()) {
            line("grid", x_.at(tick), top, x_.at(tick), base);
            text("tick", x_.at(tick), base + 16, "middle", fmt::format("{:g}", tick));
        }
        for (double tick : y_.ticks()) {
            line("grid", left, y_.at(tick), width - right, y_.at(tick));
            text("tick", left - 6, y_.at(tick) + 4, "end", fmt::format("{:g}", tick));
        }
        line("axis", left, base, width - right, base);
        line("axis", left, top, left, base - equal_gap + 6);
        text("tick", left - 6, base - 6, "end", "equal");
        text("title", (left + width) / 2, height - 10, "middle", fmt::format("milliseconds ({})", name(sweep_.clock)));
        const std::string_view unit = sweep_.metric == Metric::degrees ? "mean error of the direction, degrees"
                                                                       : "root mean square error of light";
        out_ += fmt::format(
            "<text class=\"title\" transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            (top + base) / 2, unit);
        if (const double residual = sweep_.residual.value_or(0); sweep_.metric == Metric::rmse && y_.shows(residual)) {
            line("step", left, y_.at(residual), width - right, y_.at(residual));
            text("tick", width - right - 4, y_.at(residual) - 4, "end",
                 fmt::format("reference good to {:.0f} dB", decibels(psnr(residual), 0)));
        }
    }

    // Connects combinations that differ in one rung; red if the more expensive one is worse.
    void edges() {
        for (const Mark& a : marks_)
            for (const Mark& b : marks_) {
                const auto &s = sweep_.rungs[a.rung].steps, &t = sweep_.rungs[b.rung].steps;
                std::size_t moved = 0, by = 0;
                for (std::size_t i = 0; i < s.size(); ++i)
                    if (s[i] != t[i]) {
                        ++moved;
                        by = t[i] - s[i];
                    }
                if (moved != 1 || by != 1) continue;
                const bool wrong = (b.x - a.x) * (b.y - a.y) < 0 &&
                                   sweep_.error(sweep_.rungs[a.rung]) != sweep_.error(sweep_.rungs[b.rung]);
                line(wrong ? "edge wrong" : "edge", a.x, a.y, b.x, b.y);
            }
    }

    std::vector<Mark> front() const {
        std::vector<Mark> front;
        if (!sweep_.trusted()) return front;
        ranges::copy_if(marks_, std::back_inserter(front),
                        [&](const Mark& mark) { return sweep_.rungs[mark.rung].verdict.standing == Standing::front; });
        ranges::sort(front, {}, &Mark::x);
        return front;
    }

    // Draws the front as a staircase, because there are no choices between two rungs.
    void front_line() {
        std::string path;
        for (const Mark& mark : front())
            path += path.empty() ? fmt::format("M{:.1f} {:.1f}", mark.x, mark.y)
                                 : fmt::format("H{:.1f}V{:.1f}", mark.x, mark.y);
        if (!path.empty()) out_ += fmt::format("<path class=\"front\" d=\"{}\"/>", path);
    }

    void whisker(const Mark& mark) {
        const RungResult& rung = sweep_.rungs[mark.rung];
        if (!(rung.low > 0) || !std::isfinite(rung.high)) return;
        const double x0 = x_.at(rung.low), x1 = x_.at(rung.high);
        line("whisker", x0, mark.y, x1, mark.y);
        line("whisker", x0, mark.y - 3, x0, mark.y + 3);
        line("whisker", x1, mark.y - 3, x1, mark.y + 3);
    }

    void symbol(const Mark& mark) {
        const RungResult& rung = sweep_.rungs[mark.rung];
        const bool solid = !sweep_.trusted() || rung.verdict.standing == Standing::front;
        const std::string kind = std::string(solid ? "solid" : "hollow") + (rung.saturated ? " grey" : "");
        const std::string title =
            fmt::format("<title>{}: {:.3g} ms, RMSE {:.3g} of light, {:.3g} of display values. {}</title>",
                        content::escaped(rung.name), rung.milliseconds, rung.own.light.rmse, rung.own.display.rmse,
                        content::escaped(notes_text(sweep_, rung)));
        if (mark.rung == sweep_.sweep.current)
            out_ +=
                fmt::format("<rect class=\"{} current\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"11\" height=\"11\">{}</rect>",
                            kind, mark.x - 5.5, mark.y - 5.5, title);
        else if (mark.rung == sweep_.sweep.reference)
            out_ += fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}l6 6l-6 6l-6 -6z\">{}</path>", kind, mark.x,
                                mark.y - 6, title);
        else
            out_ += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\">{}</circle>", kind, mark.x,
                                mark.y, title);
    }

    // The areas that no label may cover: symbols, whiskers, and the line of the front.
    std::vector<Box> obstacles() const {
        std::vector<Box> taken;
        for (const Mark& m : marks_) {
            const RungResult& rung = sweep_.rungs[m.rung];
            taken.push_back({m.x - 7, m.y - 7, m.x + 7, m.y + 7});
            if (rung.low > 0 && std::isfinite(rung.high))
                taken.push_back({x_.at(rung.low), m.y - 3, x_.at(rung.high), m.y + 3});
        }
        const std::vector<Mark> line = front();
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Mark &a = line[i - 1], &b = line[i];
            taken.push_back({a.x, a.y - 1, b.x, a.y + 1});
            taken.push_back({b.x - 1, std::min(a.y, b.y), b.x + 1, std::max(a.y, b.y)});
        }
        return taken;
    }

    // Places each label where it covers no symbol and no other label, near its symbol if possible. Of many combinations
    // only the important ones get labels.
    void labels() {
        std::vector<Box> taken = obstacles();
        std::vector<Mark> order = marks_;
        ranges::stable_sort(
            order, {}, [&](const Mark& m) { return sweep_.rungs[m.rung].verdict.standing == Standing::front ? 0 : 1; });
        for (const Mark& m : order) {
            const RungResult& rung = sweep_.rungs[m.rung];
            const bool special = m.rung == sweep_.sweep.current || m.rung == sweep_.sweep.reference ||
                                 rung.verdict.standing == Standing::front;
            if (marks_.size() > 24 && !special) continue;
            const double w = 6.6 * static_cast<double>(rung.name.size()) + 4;
            std::optional<Box> best;
            for (double far : {0., 14., 28., 44., 62., 82., 104.}) {
                for (const auto& [dx, dy] : {std::pair{9., 0.},
                                             {-9. - w, 0.},
                                             {-w / 2, -16.},
                                             {-w / 2, 16.},
                                             {9., -12.},
                                             {9., 12.},
                                             {-9. - w, -12.},
                                             {-9. - w, 12.}}) {
                    const double x = m.x + dx, y = m.y + dy + (dy < 0 ? -far : far);
                    const Box box{x, y - 7, x + w, y + 6};
                    const bool inside =
                        box.x0 > left && box.x1 < width - 2 && box.y0 > 2 && box.y1 < height - bottom + 2;
                    if (!inside || ranges::any_of(taken, [&](const Box& other) { return box.meets(other); })) continue;
                    best = box;
                    break;
                }
                if (best) break;
            }
            if (!best) continue;
            taken.push_back(*best);
            const double x = (best->x0 + best->x1) / 2, y = (best->y0 + best->y1) / 2;
            if (std::hypot(std::clamp(m.x, best->x0, best->x1) - m.x, y - m.y) > 20)
                line("leader", m.x, m.y, std::clamp(m.x, best->x0, best->x1), y > m.y ? best->y0 : best->y1);
            text(special ? "label" : "label weak", x, y + 4, "middle", rung.name);
        }
    }

    const SweepResult& sweep_;
    Axis x_, y_;
    std::vector<Mark> marks_;
    std::string out_;
};

}  // namespace

std::string plot_svg(const SweepResult& sweep, std::string_view style) { return Plot(sweep).svg(style); }

std::string svg_text(const SweepResult& sweep) {
    return plot_svg(
               sweep,
               "text{font:11px sans-serif;fill:#000}.title{font-size:12px}.grid{stroke:#ddd}.axis,.whisker{stroke:#000}"
               ".front{fill:none;stroke:#000;stroke-width:1.5}.solid{fill:#000;stroke:#000}.hollow{fill:#fff;stroke:#"
               "000}"
               ".current{fill:#c00;stroke:#c00}.grey,.weak{opacity:.55}.edge{stroke:#bbb}.wrong{stroke:#c00}"
               ".step{stroke:#888;stroke-dasharray:4 3}.leader{stroke:#aaa}.stamp{fill:#c00;font-weight:bold}") +
           "\n";
}

Axis::Axis(double low, double high, double from, double to) : from_(from), to_(to) {
    if (!(high > low)) {
        low /= 1.5;
        high *= 1.5;
    }
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

}  // namespace snell::accuracy
