// The report as one HTML file with inline styles, plots and pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/report/found.h"
#include "src/accuracy/report/plot.h"
#include "src/accuracy/report/report.h"
#include "src/content/image/image.h"
#include "src/content/text_forms.h"

namespace snell::accuracy {

namespace {

constexpr std::string_view style = R"(
:root{color-scheme:light dark;--back:#fff;--text:#1b1f24;--weak:#59636e;--line:#d5dae0;--accent:#0b5cad;--current:#c2410c;--wrong:#b91c1c;--panel:#f6f8fa}
@media (prefers-color-scheme:dark){:root{--back:#12161b;--text:#e6e9ed;--weak:#9aa5b1;--line:#333b45;--accent:#6cb2ff;--current:#ff9a5c;--wrong:#ff7b7b;--panel:#1a2027}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:1200px;padding:1rem;font:16px/1.5 system-ui,sans-serif;background:var(--back);color:var(--text)}
h1{font-size:1.5rem;margin:.2em 0}h2{font-size:1.2rem;margin:0 0 .3em}
section{border-top:1px solid var(--line);padding:1.2rem 0}
.facts{color:var(--weak);font-size:.9rem}.words{max-width:46em}
.noisy{color:var(--wrong);font-weight:600}
.slide{width:100%;min-width:600px;height:auto;display:block}
.plot{width:100%;min-width:600px;max-width:760px;height:auto;display:block}
.plot text{font:11px system-ui,sans-serif;fill:var(--text)}.plot .tick,.plot .title{fill:var(--weak)}.plot .title{font-size:12px}
.grid,.edge{stroke:var(--line)}.axis,.whisker{stroke:var(--weak)}.leader{stroke:var(--line)}
.front{fill:none;stroke:var(--accent);stroke-width:1.6}
.solid{fill:var(--accent);stroke:var(--accent)}.hollow{fill:var(--back);stroke:var(--accent);stroke-width:1.5}
.solid.current{fill:var(--current);stroke:var(--current)}.hollow.current{stroke:var(--current)}
.grey,.weak{opacity:.6}.wrong{stroke:var(--wrong)}.step{stroke:var(--weak);stroke-dasharray:4 3}
.plot .stamp{fill:var(--wrong);font-weight:700}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-size:.85rem;font-variant-numeric:tabular-nums}
th,td{padding:.25em .5em;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}
th{color:var(--weak);font-weight:600;vertical-align:bottom}.number{text-align:right}td.number{white-space:nowrap}
td.words{overflow-wrap:anywhere;min-width:7em}
tr.current td:first-child{color:var(--current);font-weight:700}
summary{cursor:pointer;color:var(--accent);margin:.6rem 0}
.pictures{display:flex;flex-wrap:wrap;gap:.8rem;margin-top:1rem}
figure{margin:0;background:var(--panel);padding:.4rem;border-radius:4px}
figure img{width:144px;height:auto;display:inline-block;image-rendering:auto;vertical-align:top}
figcaption{font-size:.8rem;max-width:292px;overflow-wrap:anywhere}
@media (max-width:480px){body{padding:.6rem}figure img{width:45%}figcaption{max-width:none}figure{width:100%}}
@media print{:root{--back:#fff;--text:#000;--weak:#444;--line:#bbb;--accent:#000;--current:#a00;--panel:#fff}body{max-width:none;font-size:11px}section{break-inside:avoid}.scroll{overflow:visible}.plot{min-width:0;max-width:16cm}}
)";

constexpr int thumbnail_width = 192;

// Box-filters to the width of a thumbnail; `value` computes the three components of a pixel.
template <class Value>
std::string thumbnail(int width, int height, const Value& value) {
    const int step = std::max(1, (width + thumbnail_width - 1) / thumbnail_width), rows = std::min(step, height);
    content::Image image{.width = width / step, .height = std::max(1, height / step), .channels = 3};
    image.pixels.resize(image.bytes());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (int j = 0; j < rows; ++j)
                    for (int i = 0; i < step; ++i)
                        sum += value(static_cast<std::size_t>((y * step + j) * width + x * step + i), c);
                const double mean = std::clamp(sum / (step * rows), 0.0, 1.0);
                image.pixels[static_cast<std::size_t>(y * image.width + x) * 3 + c] =
                    static_cast<std::byte>(std::lround(255 * (mean > 0 ? mean : 0)));
            }
    return "data:image/png;base64," + content::base64(content::encode_png(image));
}

// Prevents overexposure of the bright parts of the reference; dark pictures stay dark.
double exposure(const Picture& reference) {
    std::vector<float> values;
    for (std::size_t i = 0; i < reference.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            if (std::isfinite(reference.rgba[i + c])) values.push_back(reference.rgba[i + c]);
    if (values.empty()) return 1;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
    std::nth_element(values.begin(), at, values.end());
    return *at > 1 ? 1 / static_cast<double>(*at) : 1;
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
        const std::string shown = thumbnail(rung.picture.width, rung.picture.height, [&](std::size_t p, std::size_t c) {
            return bright * finite(a[4 * p + c]);
        });
        const std::string off = thumbnail(rung.picture.width, rung.picture.height, [&](std::size_t p, std::size_t c) {
            const float x = a[4 * p + c], y = reference.rgba[4 * p + c];
            return std::isfinite(x) == std::isfinite(y) ? factor * bright * std::abs(finite(x) - finite(y)) : 1;
        });
        out += fmt::format(
            "<figure><img src=\"{}\" alt=\"{}\"> <img src=\"{}\" alt=\"difference of {} from the reference\">"
            "<figcaption><b>{}</b>{}</figcaption></figure>",
            shown, content::escaped(rung.name), off, content::escaped(rung.name), content::escaped(rung.name),
            fmt::format(": {}, difference × {:g}", psnr_text(rung.own.display.psnr), factor));
    }
    return out + "</div>";
}

std::string section(const SweepResult& sweep) {
    const bool timed = ranges::any_of(sweep.rungs, [](const RungResult& rung) { return rung.rounds > 0; });
    std::string out = fmt::format("<section><h2>{}</h2><p class=\"words\">{}</p>", content::escaped(sweep.sweep.name),
                                  content::escaped(in_words(sweep)));
    if (timed) out += "<div class=\"scroll\">" + plot_svg(sweep) + "</div>";
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
    std::string out = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width,initial-scale=1\"><title>Accuracy and cost: {}</title><link rel=\"icon\" "
        "href=\"data:,\"><style>{}</style></head>\n<body><h1>Accuracy and cost</h1>",
        content::escaped(w.scene), style);
    if (!slide.empty()) out += fmt::format("<div class=\"scroll\">{}</div>", slide);
    out += fmt::format(
        "<p class=\"facts\">{} · {} × {}, up to {} rounds, other ladders as in the {} · {} · {} ({}) · {}, {} cores, "
        "{} · "
        "load {:.1f} before, {:.1f} after · {}</p>",
        content::escaped(w.scene), w.width, w.height, w.rounds, w.others(), w.date, content::escaped(w.renderer),
        content::escaped(w.gl), content::escaped(w.cpu), w.cores, content::escaped(w.os), w.load_before, w.load_after,
        content::escaped(w.tool));
    out += fmt::format(
        "<p class=\"words\">{} Differences in the pictures are of display values. Filled: on the front. Hollow: "
        "another "
        "rung is better. Square: the scene's rung. Whiskers: 95 % confidence interval of the median. All comparisons "
        "of "
        "one ladder's costs hold together at 95 %.</p>\n",
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
    return out + "</body></html>\n";
}

}  // namespace snell::accuracy
