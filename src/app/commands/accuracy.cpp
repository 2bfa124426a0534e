// `snell accuracy`: the error of each rung and its cost, here and now.
#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/report/report.h"
#include "src/accuracy/report/slide/slide.h"
#include "src/app/commands/advice.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/open/progress.h"
#include "src/app/open/quality.h"
#include "src/app/open/version.h"
#include "src/app/open/write_copy.h"
#include "src/app/picture/outputs.h"
#include "src/document/document.h"
#include "src/plan/texts.h"
#include "src/runtime/resources/counters.h"

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

// Adds the options that name the files.
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

// The load average over one minute; 0 if it is unknown.
double system_load() {
    double loads[1]{};
    return getloadavg(loads, 1) == 1 ? loads[0] : 0;
}

// The machine and the options, for reports.
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

// True, with a message, if there is nothing in the report because the budget was too small.
bool note_nothing_drawn(const Report& report) {
    const bool drawn = ranges::any_of(report.sweeps, [](const SweepResult& sweep) {
        return sweep.interrupted || ranges::any_of(sweep.rungs, &RungResult::drawn);
    });
    const bool tried = ranges::any_of(report.found, [](const FoundResult& found) {
        return found.interrupted || found.changes.empty() ||
               ranges::any_of(found.rungs, [](const FoundRung& rung) { return rung.outcome != Outcome::not_tried; });
    });
    if (drawn || tried || (report.sweeps.empty() && report.found.empty())) return false;
    if (!report.problems.empty()) return true;  // they have been told
    return !complain("no rung was drawn: the time was up; give more --budget, or a smaller --size");
}

// Says whether all files can be written, and are none of those that are `read`, with as many plots as are known before
// the measurement.
Exit check_reports(const AccuracyOptions& options, std::size_t sweeps, std::vector<std::string> read) {
    std::vector<std::string> files{options.html, options.slide, options.json, options.csv, options.markdown};
    for (std::size_t i = 0; i < sweeps && !options.svg.empty(); ++i) files.push_back(plot_path(options.svg, i));
    for (const std::string& scene : options.scenes)
        if (options.save_quality) files.push_back(quality_path(scene));
    read.insert(read.end(), options.scenes.begin(), options.scenes.end());
    return check_outputs(files, read);
}

// A report that can't be written is an error, and costs no other one. Returns false if there was one.
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

// Prints what the JSON reports of several machines say together.
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

// Named ladders only, named knobs only, or everything that the scene has.
std::vector<Sweep> sweeps_for(const AccuracyOptions& options, const Plan& plan, bool software,
                              Diagnostics& diagnostics) {
    if (options.from == "lattice") return lattice_sweep(plan.scene, plan.rungs, options.ladders, diagnostics);
    const From from = options.from == "scene" ? From::scene : From::reference;
    std::vector<Sweep> sweeps;
    if (asks_for_advice(options) && options.ladders.empty() && options.knobs.empty()) return sweeps;
    const bool all = options.ladders == std::vector<std::string>{"all"};
    if (!options.ladders.empty() || options.knobs.empty())
        sweeps = ladder_sweeps(plan.scene, plan.rungs, all ? std::vector<std::string>{} : options.ladders, from,
                               diagnostics);
    std::vector<std::string> knobs = options.knobs;
    if (knobs.empty() && options.ladders.empty()) knobs.assign(knob_names.begin(), knob_names.end());
    for (Sweep& sweep : knob_sweeps(plan.scene, plan.rungs, knobs, from, software, diagnostics))
        sweeps.push_back(std::move(sweep));
    return sweeps;
}

// Rungs are sought unless the options name what is measured.
bool seeks(const AccuracyOptions& options) {
    return !options.no_found && options.ladders.empty() && options.knobs.empty() && options.from != "lattice";
}

// A scene that was read, and what of it is measured.
struct Subject {
    std::string path;
    std::unique_ptr<Files> files;
    Sources sources;
    Plan plan;
    std::vector<Sweep> sweeps;
    std::vector<std::string> read;  // the files that it may read
    bool errors = false;
    bool measurable = false;

    Original original() { return {path, plan, *files, sources}; }
    std::size_t rungs() const {
        std::size_t count = 0;
        for (const Sweep& sweep : sweeps) count += sweep.rungs.size();
        return count;
    }
};

// Prints the problems of the scene. `software`: the renderer that will draw it.
std::unique_ptr<Subject> read_subject(const std::string& path, const AccuracyOptions& options, bool software) {
    auto subject = std::make_unique<Subject>();
    subject->path = path;
    subject->files = std::make_unique<Files>(scene_folder(path), options.access);
    Diagnostics diagnostics;
    if (auto plan = read_plan(path, *subject->files, subject->sources, diagnostics)) {
        subject->plan = std::move(*plan);
        subject->read = used_files(subject->plan, subject->sources, *subject->files);
        for (const std::string& choice : options.choices)
            choose_rung(subject->plan.rungs, subject->plan.scene, choice, diagnostics);
        subject->sweeps = sweeps_for(options, subject->plan, software, diagnostics);
    }
    fmt::print(stderr, "{}", snell::render(diagnostics, subject->sources));
    const bool readable = !subject->plan.rungs.empty() || !diagnostics.has_errors();
    subject->measurable = !subject->sweeps.empty() || ((asks_for_advice(options) || seeks(options)) && readable);
    subject->errors = diagnostics.has_errors() || !subject->measurable;
    if (!subject->measurable && !diagnostics.has_errors())
        complain(fmt::format("'{}' has none of these ladders and no use for these knobs", path));
    return subject;
}

// Adds an error if the reference of the sweep is broken, at the rung that the scene calls the reference.
void note_broken(const SweepResult& sweep, const Scene& scene, Diagnostics& diagnostics) {
    if (!sweep.broken) return;
    const std::string message = fmt::format("{}: {}", sweep.sweep.name, sweep.cannot_say);
    const std::string help = "no error can be measured; N in the window shows the pixels";
    if (sweep.sweep.moved.empty())
        diagnostics.error("broken-reference", message, help);
    else
        diagnostics.error("broken-reference", scene.ladders[sweep.sweep.moved.front()].rung_spans.back(), message,
                          help);
}

// What there is to do: sweeps, advice counting as one; and their rungs, to share the budget by.
struct Work {
    static constexpr std::size_t advice_rungs = 16;  // about as many combinations as it tries
    std::size_t sweeps = 0, rungs = 0;
    bool ladders = false;  // any scene has some

    // Two thirds of a scene's time are for rungs that are found, six sevenths if it has no ladders.
    static std::size_t found_rungs(std::size_t others, bool ladders) {
        return (ladders ? 2 : 6) * std::max(others, advice_rungs);
    }
    void add(const AccuracyOptions& options, std::size_t subject_sweeps, std::size_t others, bool has_ladders) {
        ladders = ladders || has_ladders;
        sweeps += subject_sweeps;
        rungs += others;
        if (asks_for_advice(options)) ++sweeps, rungs += advice_rungs;
        if (seeks(options)) ++sweeps, rungs += found_rungs(others, has_ladders);
    }
};

// Measures one sweep after another, and prints each when it is done. The budget is shared by those to come.
class Measurement {
public:
    Measurement(const AccuracyOptions& options, Work all, Deadline& deadline)
        : options_(options), all_(all), deadline_(deadline) {
        progress_.begin();
    }

    // A quarter of the budget is for the references, which the sweeps of a scene share; less if only knobs need them.
    double reference_seconds() const { return options_.budget / (all_.ladders ? 4 : 8); }
    References references() const {
        return References(reference_seconds() / static_cast<double>(options_.scenes.size()));
    }

    // Finds rungs, after the ladders and before the knobs.
    void find(Subject& subject, const gl::Caps& caps, const BenchSettings& settings, Report& report) {
        References unused = references();
        const std::size_t share = Work::found_rungs(subject.rungs(), !subject.plan.scene.ladders.empty());
        const MeasureOptions measuring = next(share, unused);
        const double per_minute = options_.budget / 60;
        SearchOptions how{.seconds = measuring.seconds, .rounds = 3 * options_.rounds, .times = measuring.times};
        how.pixels = static_cast<std::size_t>(131072 * std::clamp(per_minute, 1.0, 64.0));
        how.stop = measuring.stop;
        how.report = measuring.report;
        FoundResult found = search(subject.original(), caps, settings, how);
        print(found_text(found));
        report.found.push_back(std::move(found));
        finish(share);
    }

    void measure_all(Bench& bench, const Subject& subject, bool knobs, References& references, Report& report) {
        for (const Sweep& sweep : subject.sweeps) {
            if (Interrupt::came()) return;
            if ((sweep.kind == SweepKind::knob) != knobs) continue;
            SweepResult result = measure(bench, sweep, next(sweep.rungs.size(), references));
            result.scene = subject.path;
            print(table_text(result));
            report.sweeps.push_back(std::move(result));
            finish(sweep.rungs.size());
        }
    }

    bool advise(Bench& bench, Subject& subject, References& references, Report& report) {
        MeasureOptions measuring = next(Work::advice_rungs, references);
        measuring.spare = 0;  // many sweeps share it
        const bool told = give_advice(options_, subject.path, bench, subject.plan.rungs, measuring,
                                      seeks(options_) ? &report.found.back() : nullptr, report);
        finish(Work::advice_rungs);
        return told;
    }

private:
    // In place of the progress.
    void print(const std::string& text) {
        progress_.clear();
        fmt::print("{}", text);
        std::fflush(stdout);
    }

    MeasureOptions next(std::size_t rungs, References& references) {
        const double later_reference = done_.sweeps == 0 ? reference_seconds() : 0;
        const double left = std::max(options_.budget - 1e-3 * watch_.milliseconds() - later_reference, 0.0);
        const double share = left * static_cast<double>(rungs) / static_cast<double>(all_.rungs - done_.rungs);
        MeasureOptions measuring;
        measuring.rounds = options_.rounds;
        measuring.seconds = share;
        measuring.spare = left - share;
        measuring.references = &references;
        measuring.times = !options_.no_time;
        measuring.stop = [this] {
            deadline_.begin("drawing a rung");
            return Interrupt::came();
        };
        measuring.report = [this, later = left - share](const Progress& progress) {
            deadline_.begin(fmt::format("'{}', {}", progress.sweep, progress.doing));
            progress_.show(fmt::format("{}/{} {}: {}, about {:.0f} s left", done_.sweeps + 1, all_.sweeps,
                                       progress.sweep, progress.doing, progress.seconds_left + later),
                           progress.done);
        };
        return measuring;
    }

    void finish(std::size_t rungs) {
        ++done_.sweeps;
        done_.rungs += rungs;
    }

    const AccuracyOptions& options_;
    Work all_, done_;
    Deadline& deadline_;
    ProgressLine progress_;
    runtime::Stopwatch watch_;
};

bool note_problems(const Bench& bench, const Subject& subject, Report& report) {
    Diagnostics wrong;
    for (const SweepResult& sweep : report.sweeps) {
        Diagnostics broken;
        if (sweep.scene == subject.path) note_broken(sweep, subject.plan.scene, broken);
        for (const Diagnostic& problem : broken.items()) wrong.add_once(problem);
    }
    for (const Diagnostic& problem : bench.problems().items()) {
        report.problems.push_back(problem.message);
        if (problem.severity == Severity::error) wrong.add(problem);
    }
    fmt::print(stderr, "{}", snell::render(wrong, subject.sources));
    return wrong.has_errors();
}

// Prints what is wrong with the values of --set. Opens the scene if there are any.
bool values_fit(Bench& bench, const AccuracyOptions& options, const Sources& sources) {
    Diagnostics wrong;
    if (options.sets.empty()) return true;
    Controls controls = bench.runtime().controls();
    for (const std::string& set : options.sets) set_control(controls, bench.runtime().scene(), set, wrong);
    fmt::print(stderr, "{}", snell::render(wrong, sources));
    return !wrong.has_errors();
}

Exit accuracy(const AccuracyOptions& options) {
    Deadline deadline(options.timeout);
    deadline.begin("starting OpenGL");
    auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    const gl::Caps caps = gl::query_caps();
    bool errors = false;
    std::vector<std::unique_ptr<Subject>> subjects;
    std::vector<std::string> read;
    Work work;
    for (const std::string& path : options.scenes) {
        deadline.begin(fmt::format("reading '{}'", path));
        auto subject = read_subject(path, options, caps.software);
        errors = errors || subject->errors;
        read.insert(read.end(), subject->read.begin(), subject->read.end());
        if (!subject->measurable) continue;
        work.add(options, subject->sweeps.size(), subject->rungs(), !subject->plan.scene.ladders.empty());
        subjects.push_back(std::move(subject));
    }
    if (subjects.empty()) return exit_input;
    if (const Exit wrong = check_reports(options, std::max<std::size_t>(work.sweeps, 1), std::move(read));
        wrong != exit_fine)
        return wrong;
    const std::array<int, 2> window = subjects.front()->plan.scene.window_size;
    const auto [width, height] = options.size.value_or(std::pair(window[0], window[1]));
    const BenchSettings settings{width, height, options.time, options.sets, options.specialise};
    Report report{.where = circumstances(options, caps, settings)};
    const Interrupt noted;
    Measurement run(options, work, deadline);
    for (const auto& subject : subjects) {
        deadline.begin(fmt::format("compiling '{}'", subject->path));
        Bench bench(subject->plan, *subject->files, subject->sources, caps, settings);
        bench.runtime();  // compiles
        if (!values_fit(bench, options, subject->sources)) {
            errors = true;
            continue;
        }
        if (bench.problems().has_errors()) {  // it would be another scene that is measured
            errors = note_problems(bench, *subject, report);
            continue;
        }
        References references = run.references();
        run.measure_all(bench, *subject, false, references, report);
        if (seeks(options) && !Interrupt::came()) run.find(*subject, caps, settings, report);
        run.measure_all(bench, *subject, true, references, report);
        if (asks_for_advice(options) && !Interrupt::came())
            errors = !run.advise(bench, *subject, references, report) || errors;
        report.where.query_over_wall = bench.query_over_wall();
        errors = note_problems(bench, *subject, report) || errors;
    }
    deadline.rest();
    if (errors && report.sweeps.empty() && report.found.empty()) return exit_input;
    report.where.load_after = system_load();
    errors = note_nothing_drawn(report) || errors;
    fmt::print("\n{}", header_text(report));
    if (!write_reports(options, report)) return exit_input;
    return errors ? exit_input : exit_fine;
}

}  // namespace

Run add_accuracy(CLI::App& command) {
    auto options = std::make_shared<AccuracyOptions>();
    add_access(command, options->access);
    add_timeout(command, options->timeout, "one step of the measurement, or for reading a scene");
    command.footer(
        "Times are of this machine, now. Ctrl-C ends the measurement; what was measured is written. A second one ends "
        "the program at once.");
    command.add_option("SCENE", options->scenes, "one report of all of them");
    command.add_option("--merge", options->merge, "compare the JSON reports of several machines instead")
        ->expected(2, 26)
        ->check(CLI::ExistingFile);
    command.add_option("--ladders", options->ladders, "only these, such as FRESNEL,REFRACT; all: and no knobs")
        ->delimiter(',');
    command.add_option("--knobs", options->knobs, "samples,tessellation,filter,cube-size,cube-precision")
        ->delimiter(',');
    command
        .add_option("--from", options->from,
                    "the rungs of the other ladders: reference, scene; or lattice: all combinations")
        ->check(CLI::IsMember({"reference", "scene", "lattice"}));
    add_size(command, options->size, "WIDTHxHEIGHT (default: that of the first scene)");
    command
        .add_option("--reps", options->rounds,
                    "rounds, in each of which every rung is timed once, three times as many for found rungs; fewer if "
                    "the budget is too small")
        ->check(CLI::Range(3, 10000));
    command.add_option("--budget", options->budget, "seconds for all of it; expensive rungs are timed less often")
        ->check(CLI::Range(1.0, 1e6))
        ->check(check_finite_number);
    command.add_flag("--no-found", options->no_found, "do not look for changes of the scene's own text");
    CLI::Option* untimed = command.add_flag("--no-time", options->no_time, "errors only");
    add_advice(command, *options, *untimed);
    add_time(command, options->time);
    add_repeated(command, "--set", options->sets, "uniform=value or Program.uniform=value; may be repeated");
    add_specialise(command, options->specialise);
    add_repeated(command, "--ladder", options->choices, "ladder=rung of the scene; may be repeated");
    add_reports(command, *options);
    add_found_rungs(command, *options);
    add_context(command, options->context);
    return [options, &command] {
        if (only_texts(*options)) return write_found_rungs(*options, command);
        if (!options->merge.empty()) {
            std::vector<std::string_view> fitting = access_options;
            fitting.push_back("--merge");
            const bool fits = excludes_others(command, fitting, "--merge", "it compares reports and measures nothing");
            return fits ? merge_reports(*options) : exit_usage;
        }
        if (options->scenes.empty())
            return complain(exit_usage, "no scene given; 'snell accuracy --help' shows the options");
        return size_fits(options->size, options->access.limits) ? accuracy(*options) : exit_usage;
    };
}

}  // namespace snell::app
