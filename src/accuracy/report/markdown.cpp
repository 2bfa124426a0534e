// The report as a page of Markdown.
#include <fmt/format.h>

#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/report/found.h"
#include "src/accuracy/report/plot.h"
#include "src/accuracy/report/report.h"

namespace snell::accuracy {

namespace {

std::string row(const SweepResult& sweep, std::size_t index, bool degrees) {
    const RungResult& rung = sweep.rungs[index];
    std::string text = fmt::format("| {}`{}`{} |", index == sweep.sweep.current ? "**" : "", rung.name,
                                   index == sweep.sweep.current ? "**" : "");
    if (!rung.drawn) return text + fmt::format(" not drawn |{}\n", degrees ? " | | | | | | |" : " | | | | | |");
    text += rung.rounds > 0 ? fmt::format(" {:.3g} | {} |", rung.milliseconds, ratio_text(rung.ratio)) : " | |";
    text += fmt::format(" {} | {} | {} | {} | {} |", known_text("{:.3g}", rung.own.light.rmse),
                        psnr_text(rung.own.light.psnr), psnr_text(rung.own.display.psnr),
                        known_text("{:.3g}", rung.alone.rmse), known_text("{:.3f}", rung.flip));
    if (degrees) text += rung.degrees ? fmt::format(" {} |", known_text("{:.3g}", rung.degrees->mean)) : " |";
    return text + fmt::format(" {} |\n", notes_text(sweep, rung));
}

std::string part(const SweepResult& sweep, const std::string& plot) {
    const bool degrees = ranges::any_of(sweep.rungs, [](const RungResult& r) { return r.degrees.has_value(); });
    const bool timed = sweep.rungs[sweep.sweep.current].rounds > 0;
    std::string text = fmt::format("\n## {}: {}\n\n{}\n", escaped(sweep.scene), sweep.sweep.name, in_words(sweep));
    text += fmt::format("\nErrors over the {}; {}.{}\n",
                        sweep.own_pixels > 0 ? pixels_text(sweep.own_pixels) + " of its draws" : "whole picture",
                        sweep.reference_note,
                        timed ? fmt::format(" Control: {}.", ratio_text(sweep.control.ratio)) : std::string());
    if (timed && !plot.empty()) text += fmt::format("\n![{}: error over time]({})\n", sweep.sweep.name, plot);
    text += fmt::format(
        "\n| rung | ms | relative to current | RMSE | PSNR, dB | PSNR of display | RMSE alone | FLIP |{} "
        "|\n|---|--:|--:|--:|--:|--:|--:|--:|{}\n",
        degrees ? " degrees |" : "", degrees ? "--:|---|" : "---|");
    for (std::size_t i = 0; i < sweep.rungs.size(); ++i) text += row(sweep, i, degrees);
    return text;
}

}  // namespace

std::string markdown_text(const Report& report, const std::vector<std::string>& plots) {
    const Circumstances& w = report.where;
    std::string text = fmt::format(
        "# Accuracy and cost, measured\n\n{}, {} cores, {}; {} ({}); {}; {}; {} × {} pixels, up to {} rounds, other "
        "ladders as in the {}; load {:.1f} before, {:.1f} after.\n\nThe scene's rung is bold. {} The reference has all "
        "last rungs, and the finest samples, meshes and filter that the time allowed. Errors are the same on any "
        "machine, "
        "apart from rounding and the reference. Times are valid for this machine at that time; they mean nothing if "
        "the "
        "control says that it was too noisy.\n",
        w.cpu, w.cores, w.os, w.renderer, w.gl, w.tool, w.date, w.width, w.height, w.rounds, w.others(), w.load_before,
        w.load_after, errors_are);
    const std::vector<const SweepResult*> plotted = plots_of(report);
    const auto plot_for = [&](const SweepResult& sweep) {
        const auto at = static_cast<std::size_t>(ranges::find(plotted, &sweep) - plotted.begin());
        return at < plots.size() ? plots[at] : std::string();
    };
    for (const FoundResult& found : report.found) text += found_markdown(found, plot_for(found.timed));
    for (const SweepResult& sweep : report.sweeps) text += part(sweep, plot_for(sweep));
    return text;
}

}  // namespace snell::accuracy
