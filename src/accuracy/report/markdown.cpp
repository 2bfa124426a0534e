// The report as a page of Markdown.
#include <fmt/format.h>

#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/report/found.h"
#include "src/accuracy/report/plot.h"
#include "src/accuracy/report/report.h"

namespace snell::accuracy {

namespace {

std::string part(const SweepResult& sweep, const std::string& plot) {
    if (unmeasured(sweep))
        return fmt::format("\n{}: {}: not measured\n", content::escaped(sweep.scene), sweep.sweep.name);
    const bool timed = sweep.rungs[sweep.sweep.current].rounds > 0;
    std::string text =
        fmt::format("\n## {}: {}\n\n{}\n", content::escaped(sweep.scene), sweep.sweep.name, in_words(sweep));
    text += fmt::format("\nErrors {}; {}.{}\n", area_text(sweep), sweep.reference_note,
                        timed ? fmt::format(" Control: {}.", ratio_text(sweep.control.ratio)) : std::string());
    if (timed && !plot.empty()) text += fmt::format("\n![{}: error over time]({})\n", sweep.sweep.name, plot);
    return text + "\n" + content::table_markdown(rung_table(sweep));
}

}  // namespace

std::string markdown_text(const Report& report, const std::vector<std::string>& plots) {
    const Circumstances& w = report.where;
    std::string text = fmt::format(
        "# Accuracy and cost, measured\n\n{}, {} cores, {}; {} ({}); {}; {}; {} × {} pixels, up to {} rounds, other "
        "ladders as in the {}; load {:.1f} before, {:.1f} after.\n\nThe scene's rung is bold. {} The reference has all "
        "last rungs, and the finest samples, meshes and filter that the time allowed. Errors are the same on any "
        "machine, "
        "apart from rounding and the reference. Times are valid for this machine at that time.\n",
        w.cpu, w.cores, w.os, w.renderer, w.gl, w.tool, w.date, w.width, w.height, w.rounds, w.others(), w.load_before,
        w.load_after, errors_are);
    const std::vector<const SweepResult*> plotted = plots_of(report);
    const auto plot_for = [&](const SweepResult& sweep) {
        const auto at = static_cast<std::size_t>(ranges::find(plotted, &sweep) - plotted.begin());
        return at < plots.size() ? plots[at] : std::string();
    };
    for (const SweepResult& sweep : report.sweeps) text += part(sweep, plot_for(sweep));
    for (const FoundResult& found : report.found) text += found_markdown(found, plot_for(found.timed));
    return text;
}

}  // namespace snell::accuracy
