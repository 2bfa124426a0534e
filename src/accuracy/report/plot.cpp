// Plots one sweep: error over time.
#include <cmath>

#include <fmt/format.h>

#include "src/accuracy/report/report.h"
#include "src/content/plot/plot.h"

namespace snell::accuracy {

namespace {

// Of more combinations only the important ones get labels.
constexpr std::size_t most_labels = 24;

content::PlotPoint point_of(const SweepResult& sweep, const RungResult& rung) {
    const bool front = sweep.on_front(rung);
    content::PlotPoint point{.name = rung.name,
                             .error = sweep.error(rung),
                             .milliseconds = rung.milliseconds,
                             .low = rung.low,
                             .high = rung.high,
                             .front = front,
                             .beaten = sweep.trusted() && !front,
                             .own = &rung == &sweep.rungs[sweep.sweep.current],
                             .label = front ? 0 : 1};
    point.tip = fmt::format("{}: {:.3g} ms, RMSE {:.3g} of light, {:.3g} of display values. {}", rung.name,
                            rung.milliseconds, rung.own.light.rmse, rung.own.display.rmse, notes_text(sweep, rung));
    return point;
}

// Whether they differ in one ladder by one rung, which is the more exact one in `b`.
bool next_to(const RungResult& a, const RungResult& b) {
    std::size_t moved = 0, by = 0;
    for (std::size_t i = 0; i < a.steps.size(); ++i)
        if (a.steps[i] != b.steps[i]) {
            ++moved;
            by = b.steps[i] - a.steps[i];
        }
    return moved == 1 && by == 1;
}

content::Plot plot_of(const SweepResult& sweep) {
    content::Plot plot;
    std::vector<const RungResult*> shown;
    for (std::size_t i = 0; i < sweep.rungs.size(); ++i) {
        const RungResult& rung = sweep.rungs[i];
        if (!rung.drawn || rung.rounds == 0 || plainly_visible(sweep, i) || std::isnan(sweep.error(rung))) continue;
        shown.push_back(&rung);
        plot.points.push_back(point_of(sweep, rung));
    }
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const bool special =
            plot.points[i].own || plot.points[i].front || shown[i] == &sweep.rungs[sweep.sweep.reference];
        if (shown.size() > most_labels && !special) plot.points[i].label.reset();
        for (std::size_t j = 0; j < shown.size() && sweep.sweep.kind == SweepKind::lattice; ++j)
            if (next_to(*shown[i], *shown[j])) plot.edges.emplace_back(i, j);
    }
    const bool degrees = sweep.metric == Metric::degrees;
    plot.errors = degrees ? "error of the direction, degrees (mean)" : "error of light (RMSE)";
    plot.times = fmt::format("time of a frame, ms ({})", name(sweep.clock));
    if (!sweep.trusted()) plot.stamp = sweep.cannot_say.empty() ? "too few rounds: no front" : "can't say";
    plot.floor = degrees ? 0 : sweep.residual.value_or(0);
    if (plot.floor > 0) plot.floor_words = fmt::format("reference good to {:.0f} dB", decibels(psnr(plot.floor), 0));
    return plot;
}

std::string plot_svg(const SweepResult& sweep, const content::InkColors& colors, std::string_view attributes) {
    constexpr int width = 640, height = 400;
    content::Page page;
    draw_plot(page, plot_of(sweep), {4, 4, width - 12, height - 4}, 12);
    return content::svg(page.marks, width, height, colors,
                        fmt::format("{} role=\"img\" aria-label=\"{}: error over time\"", attributes,
                                    content::escaped(sweep.sweep.name)));
}

}  // namespace

std::string plot_html(const SweepResult& sweep) {
    constexpr content::InkColors colors{"var(--text)",   "var(--weak)", "var(--back)",    "var(--line)", "var(--panel)",
                                        "var(--accent)", "var(--weak)", "var(--current)", "var(--wrong)"};
    return plot_svg(sweep, colors, "class=\"plot\"");
}

std::string svg_text(const SweepResult& sweep) { return plot_svg(sweep, content::print_colors, {}) + "\n"; }

}  // namespace snell::accuracy
