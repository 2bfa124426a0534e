// The report as one HTML file with inline styles, plots and pictures; the plot of one sweep also for itself.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/report/report.h"
#include "src/content/html_page.h"
#include "src/content/image/image.h"
#include "src/content/plot/plot.h"
#include "src/content/text_forms.h"

namespace snell::accuracy {

namespace {

constexpr std::string_view style = R"(
body { max-width: 1200px; } h2 { margin: 0 0 .3em; }
section{border-top:1px solid var(--line);padding:1.2rem 0}
.facts{color:var(--weak);font-size:.9rem}.words{max-width:46em}
.slide{width:100%;min-width:600px;height:auto;display:block}
.plot{width:100%;min-width:600px;max-width:760px;height:auto;display:block}
table{font-size:.85rem;font-variant-numeric:tabular-nums}
th,td{padding:.25em .5em;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}
th{color:var(--weak);font-weight:600;vertical-align:bottom}.number{text-align:right}
td.words{overflow-wrap:anywhere;min-width:7em}
tr.current td:first-child{color:var(--current);font-weight:700}
summary{cursor:pointer;color:var(--accent);margin:.6rem 0}
figure{background:var(--panel);padding:.4rem;border-radius:4px}
figure img{width:144px;height:auto;display:inline-block;image-rendering:auto;vertical-align:top}
figcaption{font-size:.8rem;max-width:292px}
@media (max-width:480px){body{padding:.6rem}figure img{width:45%}figcaption{max-width:none}figure{width:100%}}
@media print{:root{--back:#fff;--text:#000;--weak:#444;--line:#bbb;--accent:#000;--current:#a00;--panel:#fff}body{max-width:none;font-size:11px}section{break-inside:avoid}.scroll{overflow:visible}.plot{min-width:0;max-width:16cm}}
)";

constexpr int thumbnail_width = 192;

// `value` computes the three components of a pixel.
template <class Value>
std::string thumbnail(const Picture& picture, const Value& value) {
    const auto at = [&](int x, int y, std::size_t c) {
        return value(static_cast<std::size_t>(y * picture.width + x), c);
    };
    return "data:image/png;base64," + content::base64(content::encode_png(content::reduced(
                                          picture.width, picture.height, thumbnail_width, picture.height, at)));
}

// Prevents overexposure of the bright parts of the reference; dark pictures stay dark.
double exposure(const Picture& reference) {
    std::vector<float> values;
    for (std::size_t i = 0; i < reference.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            if (std::isfinite(reference.rgba[i + c])) values.push_back(reference.rgba[i + c]);
    return 1 / std::max(static_cast<double>(quantile(values, .99)), 1.);
}

// One factor for all differences of a sweep, a power of two, at which the median difference is clearly visible.
double amplification(const SweepResult& sweep) {
    std::vector<double> errors;
    for (const RungResult& rung : sweep.rungs)
        if (const double error = rung.own.display.rmse; rung.drawn && error > 0 && std::isfinite(error))
            errors.push_back(error);
    if (errors.empty()) return 1;
    return std::exp2(std::clamp(std::floor(std::log2(.3 / median(errors))), 0.0, 8.0));
}

std::string pictures(const SweepResult& sweep) {
    const Picture& reference = sweep.compared_with();
    if (reference.rgba.empty()) return {};
    const double bright = exposure(reference), factor = amplification(sweep);
    std::string out = "<div class=\"pictures\">";
    for (const RungResult& rung : sweep.rungs) {
        if (!rung.drawn) continue;
        const std::vector<float>& a = rung.picture.rgba;
        const auto finite = [](float v) { return std::isfinite(v) ? static_cast<double>(v) : 0.0; };
        const std::string shown =
            thumbnail(rung.picture, [&](std::size_t p, std::size_t c) { return bright * finite(a[4 * p + c]); });
        const std::string off = thumbnail(rung.picture, [&](std::size_t p, std::size_t c) {
            const float x = a[4 * p + c], y = reference.rgba[4 * p + c];
            return std::isfinite(x) == std::isfinite(y) ? factor * bright * std::abs(finite(x) - finite(y)) : 1;
        });
        out += fmt::format(
            "<figure><img src=\"{}\" alt=\"{}\"> <img src=\"{}\" alt=\"difference of {} from the "
            "reference\"><figcaption><b>{}</b>{}</figcaption></figure>",
            shown, content::escaped(rung.name), off, content::escaped(rung.name), content::escaped(rung.name),
            fmt::format(": {}, difference × {:g}", psnr_text(rung.own.display.psnr), factor));
    }
    return out + "</div>";
}

std::string section(const SweepResult& sweep) {
    const bool timed = sweep.timed();
    std::string out = fmt::format("<section><h2>{}</h2><p class=\"words\">{}</p>", content::escaped(sweep.sweep.name),
                                  content::escaped(in_words(sweep)));
    if (timed) out += "<div class=\"scroll\">" + plot_html(sweep) + "</div>";
    out += content::table_html(rung_table(sweep));
    out += fmt::format("<p class=\"facts\">{}, errors {}; {}.{}{}</p>", content::escaped(sweep.scene), area_text(sweep),
                       content::escaped(sweep.reference_note),
                       timed ? fmt::format(" Control (the current rung timed twice): {}; clock: {}.",
                                           ratio_text(sweep.control.ratio), name(sweep.clock))
                             : std::string(),
                       sweep.interrupted ? " The measurement was interrupted; some rounds are missing." : "");
    return out + pictures(sweep) + "</section>\n";
}

// What there was no time for, as a line that can be opened.
std::string unmeasured_html(const Report& report) {
    std::string rows;
    std::size_t count = 0;
    for (const SweepResult& sweep : report.sweeps)
        if (unmeasured(sweep)) {
            rows += fmt::format("<li>{}: {} {}</li>", content::escaped(sweep.scene), content::escaped(sweep.sweep.name),
                                content::escaped(in_words(sweep)));
            ++count;
        }
    if (rows.empty()) return {};
    return fmt::format("<section><details><summary>{} not measured</summary><ul>{}</ul></details></section>\n",
                       count == 1 ? "1 ladder or knob was" : fmt::format("{} ladders or knobs were", count), rows);
}

}  // namespace

std::string html_text(const Report& report, std::string_view slide) {
    const Circumstances& w = report.where;
    std::string out = "<h1>Accuracy and cost</h1>";
    if (!slide.empty()) out += fmt::format("<div class=\"scroll\">{}</div>", slide);
    out += fmt::format(
        "<p class=\"facts\">{} · {} × {}, up to {} rounds, other ladders as in the {} · {} · {} ({}) · {}, {} cores, "
        "{} · load {:.1f} before, {:.1f} after · {}</p>",
        content::escaped(w.scene), w.width, w.height, w.rounds, w.others(), w.date, content::escaped(w.renderer),
        content::escaped(w.gl), content::escaped(w.cpu), w.cores, content::escaped(w.os), w.load_before, w.load_after,
        content::escaped(w.tool));
    out += fmt::format(
        "<p class=\"words\">{} Differences in the pictures are of display values. Filled: on the front. Hollow: "
        "another rung is better. Square: the scene's rung. Whiskers: 95 % confidence interval of the median. All "
        "comparisons of one ladder's costs hold together at 95 %.</p>\n",
        errors_are);
    const auto sections = [&](bool knobs) {
        for (const SweepResult& sweep : report.sweeps)
            if ((sweep.sweep.kind == SweepKind::knob) == knobs && !unmeasured(sweep)) out += section(sweep);
    };
    sections(false);
    for (const FoundResult& found : report.found) out += found_html(found);
    sections(true);
    out += unmeasured_html(report);
    for (const std::string& problem : report.problems)
        out += fmt::format("<p class=\"facts\">{}</p>", content::escaped(problem));
    return content::html_page({.title = "Accuracy and cost: " + w.scene, .body = out, .style = style});
}

// Plots one sweep: error over time.

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
