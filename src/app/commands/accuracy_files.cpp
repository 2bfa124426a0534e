#include "src/app/commands/accuracy_files.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/report/merge.h"
#include "src/accuracy/report/slide/slide.h"
#include "src/app/commands/options.h"
#include "src/app/open/complain.h"
#include "src/app/open/quality.h"
#include "src/app/open/version.h"
#include "src/app/picture/outputs.h"

namespace snell::app {

namespace {

using namespace snell::accuracy;

std::string cpu_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) {
            const std::size_t colon = line.find(':');
            return colon == std::string::npos ? line : line.substr(std::min(colon + 2, line.size()));
        }
    return "unknown processor";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

bool write_text(const std::string& path, const std::string& text) { return path.empty() || write_output(path, text); }

// plot.svg, plot-2.svg …
std::string plot_path(const std::string& svg, std::size_t index) {
    if (index == 0) return svg;
    const std::filesystem::path path(svg);
    return (path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), index + 1, path.extension().string()))
        .string();
}

// As a page names it that is written there.
std::string link_from(const std::string& page, const std::string& file) {
    const std::filesystem::path folder = std::filesystem::path(page).parent_path();
    std::error_code error;
    return std::filesystem::proximate(file, folder.empty() ? "." : folder, error).generic_string();
}

bool write_slide(const std::string& path, const Slide& slide) {
    if (path.empty()) return true;
    const SlideFile file = draw_slide(slide, slide_format(path).value_or(SlideFormat::png));
    if (file.error.empty()) return write_text(path, file.bytes);
    return complain(fmt::format("cannot draw '{}': {}", path, file.error));
}

std::string check_slide_name(const std::string& text) {
    return slide_format(text) ? "" : "'" + text + "' does not end in .png, .svg or .pdf";
}

}  // namespace

void add_reports(CLI::App& command, AccuracyOptions& options) {
    command.add_option("-o,--output", options.html, "write the report, one HTML file; or the folder for --apply")
        ->check(check_file_name);
    command.add_option("--svg", options.svg, "write the plots for a paper: FILE.svg, FILE-2.svg …")
        ->check(check_file_name);
    command.add_option("--slide", options.slide, "write one picture for a lecture, 1920x1080: FILE.png, .svg or .pdf")
        ->check(check_file_name)
        ->check(check_slide_name);
    command.add_option("--json", options.json, "write the numbers as JSON")->check(check_file_name);
    command.add_option("--markdown", options.markdown, "write the numbers as a page, with the plots of --svg")
        ->check(check_file_name);
    command.add_option("--csv", options.csv, "write the numbers as CSV, a row for each rung")->check(check_file_name);
}

double system_load() {
    double loads[1]{};
    return getloadavg(loads, 1) == 1 ? loads[0] : 0;
}

Circumstances circumstances(const AccuracyOptions& options, const gl::Caps& caps, const BenchSettings& settings) {
    utsname system{};
    const bool known = uname(&system) == 0;
    return {.scene = fmt::format("{}", fmt::join(options.scenes, ", ")),
            .tool = std::string("snell ") + version(),
            .date = today(),
            .cpu = cpu_name(),
            .os = known ? fmt::format("{} {}", system.sysname, system.release) : "",
            .cores = static_cast<int>(std::thread::hardware_concurrency()),
            .load_before = system_load(),
            .renderer = caps.renderer,
            .vendor = caps.vendor,
            .gl = caps.version,
            .width = settings.width,
            .height = settings.height,
            .rounds = options.rounds,
            .time = options.time,
            .from = options.from,
            .sets = options.sets};
}

bool note_nothing_drawn(const Report& report) {
    const bool drawn = ranges::any_of(report.sweeps, [](const SweepResult& sweep) {
        return sweep.interrupted || ranges::any_of(sweep.rungs, &RungResult::drawn);
    });
    const bool tried = ranges::any_of(report.found, [](const FoundResult& found) {
        return found.interrupted || found.changes.empty() ||
               ranges::any_of(found.rungs, [](const FoundRung& rung) { return rung.outcome != Outcome::not_tried; });
    });
    if (drawn || tried || (report.sweeps.empty() && report.found.empty())) return false;
    return !complain("no rung was drawn: the time was up; give more --budget, or a smaller --size");
}

Exit check_reports(const AccuracyOptions& options, std::size_t sweeps, std::vector<std::string> read) {
    std::vector<std::string> files{options.html, options.slide, options.json, options.csv, options.markdown};
    for (std::size_t i = 0; i < sweeps && !options.svg.empty(); ++i) files.push_back(plot_path(options.svg, i));
    for (const std::string& scene : options.scenes)
        if (options.save_quality) files.push_back(quality_path(scene));
    read.insert(read.end(), options.scenes.begin(), options.scenes.end());
    return check_outputs(files, read);
}

bool write_reports(const AccuracyOptions& options, const Report& report) {
    std::vector<std::string> plots;  // as the page names them
    bool written = write_text(options.csv, csv_text(report));
    written = write_text(options.json, json_text(report)) && written;
    if (!options.html.empty() || !options.slide.empty()) {
        const Slide slide = slide_of(report);
        written =
            (options.html.empty() || write_text(options.html, html_text(report, slide_element(slide)))) && written;
        written = write_slide(options.slide, slide) && written;
    }
    const std::vector<const SweepResult*> plotted = plots_of(report);
    for (std::size_t i = 0; i < plotted.size() && !options.svg.empty(); ++i) {
        const std::string path = plot_path(options.svg, i);
        written = write_text(path, svg_text(*plotted[i])) && written;
        plots.push_back(link_from(options.markdown, path));
    }
    return write_text(options.markdown, markdown_text(report, plots)) && written;
}

Exit merge_reports(const AccuracyOptions& options) {
    Files files("", options.access);
    std::vector<NamedReport> reports;
    std::string wrong;
    for (const std::string& file : options.merge) {
        auto text = files.read(file, wrong);
        if (!text) return complain(exit_input, fmt::format("cannot read '{}': {}", file, wrong));
        reports.push_back({file, std::move(*text)});
    }
    const auto text = merged_text(reports, wrong);
    if (!text) return complain(exit_input, wrong);
    fmt::print("{}", *text);
    return exit_fine;
}

}  // namespace snell::app
