// The command line: what to do with which scene.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "parser/utf8.h"
#include "src/app/advice.h"
#include "src/app/commands.h"
#include "src/app/headless.h"
#include "src/app/shots.h"
#include "src/app/view_text.h"
#include "src/app/window.h"

namespace {

using namespace snell;

constexpr const char* examples = R"(Examples: (in the folder of the repository)
  snell scenes/light/glass/glass.glib                        # open a scene in a window
  snell render scenes/light/glass/glass.glib -o glass.png    # draw a picture, without a display
  snell render scenes/light/glass/glass.glib -o glass.png --set uIndex=1.33 --ladder BEND=single
  snell render scenes/light/glass/glass.glib -o glass.exr --size 1920x1080 --time 2.5 --samples 4
  snell sweep scenes/light/glass/glass.glib --over uIndex=1:2.5:16 -o 'glass-{uIndex}.png' --sheet all.png
  snell accuracy scenes/light/glass/glass.glib -o report.html --ladders all    # error and cost of each rung
  snell explain scenes/light/glass/glass.glib                # what the scene costs, and why
  snell check scenes/light/glass/glass.glib                  # report errors and warnings
  snell commands                                             # list the commands of the language

Exit status: 0 fine, 1 errors in the input, 2 wrong usage, 3 no graphics,
4 timeout, 5 the graphics driver reset itself.)";

bool parse_size(const std::string& text, std::pair<int, int>& size) {
    int end = 0;
    return std::sscanf(text.c_str(), "%5dx%5d%n", &size.first, &size.second, &end) == 2 &&
           static_cast<size_t>(end) == text.size() && size.first > 0 && size.second > 0;
}

std::string check_size(const std::string& text) {
    std::pair<int, int> size;
    return parse_size(text, size) ? "" : "'" + text + "' is not WIDTHxHEIGHT, such as 800x600";
}

std::string check_context(const std::string& text) {
    ContextRequest request;
    return app::parse_context(text, request) ? "" : "'" + text + "' is not a version such as 3.3, 4.5 or es3.2";
}

// CLI11 reads "nan" and "inf" too.
std::string check_finite(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return *end == '\0' && std::isfinite(value) ? "" : "'" + text + "' is not a finite number";
}

std::string check_rate(const std::string& text) {
    const std::string error = check_finite(text);
    return !error.empty() || std::strtod(text.c_str(), nullptr) > 0 ? error : "'" + text + "' is not more than 0";
}

std::string check_milliseconds(const std::string& text) {
    return app::parse_milliseconds(text) ? "" : "'" + text + "' is not a time such as 16ms";
}

std::string check_view(const std::string& text) {
    View view;
    return parse_view(text, view);
}

std::string check_shard(const std::string& text) {
    return app::parse_shard(text) ? "" : "'" + text + "' is not I/N, such as 0/8, 1/8 … 7/8";
}

std::string check_limit(const std::string& text) {
    Limits limits;
    std::string error;
    return set_limit(limits, text, error) ? "" : error;
}

// On whatever thread: exceptions would have to pass through drivers and libraries. Files are written whole or not at
// all.
void out_of_memory() {
    constexpr std::string_view text =
        "snell: error: out of memory [out-of-memory]\n   help: the scene asks for more than there is; --limit and "
        "--size ask for less\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    _exit(app::exit_input);
}

struct CommandLine {
    CLI::App app{"snell runs .glib scenes: GLSL programs with sliders, in a window or to a picture."};
    WindowOptions window;
    std::string window_size, render_size;
    app::RenderOptions render;
    app::CheckOptions check;
    app::SaveOptions save;
    app::AccuracyOptions accuracy;
    app::ExplainOptions explain;
    std::string explain_size;
    std::string accuracy_size, accuracy_within;
    std::vector<std::string> limits;
    std::string confine;
    bool commands_json = false;
    app::InfoOptions info;
    CLI::App *explain_command = nullptr, *accuracy_command = nullptr, *render_command = nullptr,
             *check_command = nullptr, *commands_command = nullptr, *info_command = nullptr, *sweep_command = nullptr,
             *save_command = nullptr;

    CommandLine() {
        app.footer(examples);
        app.set_version_flag("--version", std::string("snell ") + SNELL_VERSION);
        app.require_subcommand(0, 1);
        app.add_option("SCENE", window.scene, "the scene to open in a window");
        app.add_option("--size", window_size, "size of the window, WIDTHxHEIGHT")->check(check_size);
        add_repeated(app, "--ladder", window.ladders, "ladder=rung to begin with; may be repeated");
        app.add_option("--quality", window.quality, "rungs as `snell accuracy --save-quality` found them")
            ->check(CLI::IsMember({"fast", "balanced", "exact"}));
        // For tests of the window: not for users.
        app.add_option("--state", window.state_file)->group("");
        app.add_option("--exit-after", window.exit_after)->group("");
        app.add_option("--lose-file", window.lose_file)->group("");
        app.add_option("--after", window.after)->group("");  // said by a window that starts itself again
        add_timeout(app, window.timeout, "a frame; then the scene waits for another edit");
        add_access(app);
        add_render();
        add_sweep();
        add_check();
        add_save();
        add_accuracy();
        add_explain();
        commands_command = app.add_subcommand("commands", "list the commands of the language");
        commands_command->add_flag("--json", commands_json, "as JSON");
        info_command = app.add_subcommand("info", "say what OpenGL there is");
        add_timeout(*info_command, info.timeout, "the driver to answer");
        info_command->add_option("--context", info.context, "ask for this version: 3.3, 4.5, es3.2")
            ->check(check_context);
    }

    // An option that may be given again and again, with one value each time.
    static CLI::Option* add_repeated(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                                     const std::string& text) {
        return command.add_option(name, values, text)
            ->expected(1)
            ->allow_extra_args(false)  // else it takes the scene's name where an option follows that
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }

    // What a scene may read, and how much.
    void add_access(CLI::App& command) {
        add_repeated(command, "--limit", limits, "NAME=VALUE of docs/limits.md; may be repeated")->check(check_limit);
        command.add_option("--confine", confine, "read nothing outside of this folder")->check(CLI::ExistingDirectory);
    }

    static void add_grade(CLI::App& command, bool& grade) {
        command.add_flag("--grade", grade, "for scenes of strangers: read nothing outside of each scene's folder");
    }

    static void add_timeout(CLI::App& command, double& seconds, const std::string& what) {
        command.add_option("--timeout", seconds, "seconds for " + what + "; 0: no end")
            ->check(check_finite)
            ->check(CLI::Range(0., 1e6));
    }

    // What render and sweep have in common.
    void add_drawing(CLI::App& command) {
        add_access(command);
        add_grade(command, render.grade);
        add_timeout(command, render.timeout, "a frame, or for reading a scene");
        command.footer(examples);
        command.add_option("--lose-after", render.lose_after)->group("");  // for tests
        command.add_option("--size", render_size, "WIDTHxHEIGHT (default: the scene's)")->check(check_size);
        command.add_option("--time", render.time, "seconds since the scene began")->check(check_finite);
        add_repeated(command, "--set", render.sets, "uniform=value or Program.uniform=value; may be repeated");
        add_repeated(command, "--ladder", render.ladders, "ladder=rung; may be repeated");
        command.add_option("--quality", render.quality, "rungs as `snell accuracy --save-quality` found them")
            ->check(CLI::IsMember({"fast", "balanced", "exact"}));
        command.add_option("--samples", render.samples, "samples a pixel")->check(CLI::Range(1, 64));
        command.add_flag("--transparent", render.transparent, "without the background: PNG and EXR");
        command.add_option("--tile", render.tile, "draw at most so many pixels along a side at once")
            ->check(CLI::Range(64, 65536));
        command.add_option("--shard", render.shard, "I/N: draw only the pictures of part I of N, 0/N to N-1/N")
            ->check(check_shard);
        command.add_flag("--skip-existing", render.skip_existing, "draw only the pictures that are not there yet");
        command.add_option("--json", render.json, "write what each picture is, with its hash, as JSON");
        command.add_option("--sheet", render.sheet, "write all pictures on one");
        command.add_flag("!--no-labels", render.labels, "write no values below the pictures of the sheet");
        command.add_option("--stats", render.stats, "write timings and counters of the one scene as JSON");
        command
            .add_option(
                "--view", render.view,
                "turned and moved: rotate_x=30,rotate_y=-45,scale=1.2,x=.5,eye.z=1,object0.x=.5,projection=ortho")
            ->check(check_view);
        command.add_flag("--axes", render.axes, "draw the axes");
        command.add_flag("--count-non-finite", render.count_non_finite,
                         "say how many pixels are NaN or infinite before they are clamped");
        command.add_flag("-q,--quiet", render.quiet, "print errors only, no warnings");
        command.add_option("--context", render.context, "ask for an OpenGL version: 3.3, 4.5, es3.2")
            ->check(check_context);
    }

    void add_render() {
        render_command = app.add_subcommand("render", "draw scenes to pictures, without a display");
        render_command->add_option("SCENE", render.scenes)->required();
        render_command
            ->add_option("-o,--output", render.output,
                         "the picture; its extension says the format; {stem} is the scene's name, {frame:04} the "
                         "frame's number")
            ->required();
        render_command
            ->add_option("--frames", render.frames, "draw so many pictures, named NAME-0000 and so on without {frame}")
            ->check(CLI::Range(1, static_cast<int>(app::max_pictures)));
        render_command->add_option("--fps", render.fps, "pictures a second: picture k is at TIME + k / FPS")
            ->check(check_rate);
        add_drawing(*render_command);
    }

    void add_sweep() {
        sweep_command = app.add_subcommand("sweep", "draw a scene for many values of what can be set");
        sweep_command->add_option("SCENE", render.scenes)->required()->expected(1);
        add_repeated(*sweep_command, "--over", render.over,
                     "NAME=FIRST:LAST:COUNT or NAME=A,B,C, of a uniform, a ladder or time; may be repeated: every "
                     "combination is drawn")
            ->required();
        sweep_command
            ->add_option("-o,--output", render.output, "the pictures: {NAME}, {NAME:.2f}, {index:04} and {stem} in it")
            ->required();
        add_drawing(*sweep_command);
    }

    void add_check() {
        check_command = app.add_subcommand("check", "say all that is wrong with scenes");
        check_command->add_option("SCENE", check.scenes)->required();
        add_access(*check_command);
        add_grade(*check_command, check.grade);
        add_timeout(*check_command, check.timeout, "each scene");
        check_command->add_flag("--json", check.json, "as JSON");
        check_command->add_flag("!--no-lint", check.lint,
                                "leave out what is allowed and probably not meant (docs/lints.md)");
        check_command->add_option("--dump", check.dump, "print one stage of the reading")
            ->check(CLI::IsMember({"tokens", "statements", "scene", "plan"}));
    }

    void add_save() {
        save_command = app.add_subcommand("save", "write values into a scene: only its numbers change");
        save_command->add_option("SCENE", save.scene)->required();
        add_access(*save_command);
        add_timeout(*save_command, save.timeout, "reading the scene");
        add_repeated(*save_command, "--set", save.sets, "uniform=value or Program.uniform=value; may be repeated");
        add_repeated(*save_command, "--ladder", save.ladders, "ladder=rung, which is then the marked one");
        save_command->add_option("-o,--output", save.output, "another file than the scene's own");
        save_command->add_option("--context", save.context, "ask for an OpenGL version: 3.3, 4.5, es3.2")
            ->check(check_context);
    }

    void add_accuracy() {
        CLI::App& command = *app.add_subcommand("accuracy", "measure what each rung is off by and what it costs");
        accuracy_command = &command;
        add_access(command);
        add_timeout(command, accuracy.timeout, "one step of the measurement, or for reading a scene");
        command.footer(
            "Times are of this machine, now. Ctrl-C ends the measurement; what was measured is written. A second one "
            "ends the program at once.");
        command.add_option("SCENE", accuracy.scenes, "one report of all of them")->required();
        command.add_option("--ladders", accuracy.ladders, "only these, such as FRESNEL,REFRACT; all: and no knobs")
            ->delimiter(',');
        command.add_option("--knobs", accuracy.knobs, "samples,tessellation,filter,cube-size,cube-precision")
            ->delimiter(',');
        command
            .add_option("--from", accuracy.from,
                        "where the other ladders stand: reference, scene; or lattice: all combinations")
            ->check(CLI::IsMember({"reference", "scene", "lattice"}));
        command.add_option("--size", accuracy_size, "WIDTHxHEIGHT (default: the scene's)")->check(check_size);
        command.add_option("--reps", accuracy.rounds, "rounds, in each of which every rung is timed once")
            ->check(CLI::Range(3, 10000));
        command.add_option("--budget", accuracy.budget, "seconds for all of it; dear rungs sit rounds out")
            ->check(CLI::Range(1.0, 1e6));
        CLI::Option* untimed = command.add_flag("--no-time", accuracy.no_time, "errors only");
        command.add_option("--within", accuracy_within, "the most exact combination that takes no longer: 16ms")
            ->check(check_milliseconds)
            ->excludes(untimed);
        command.add_option("--error", accuracy.error, "the cheapest combination with no more RMSE")
            ->check(CLI::NonNegativeNumber)
            ->excludes(untimed);
        command.add_flag("--save-quality", accuracy.save_quality, "find presets for --quality, kept beside the scene")
            ->excludes(untimed);
        command.add_option("--time", accuracy.time, "seconds since the scene began")->check(check_finite);
        add_repeated(command, "--set", accuracy.sets, "uniform=value or Program.uniform=value; may be repeated");
        add_repeated(command, "--ladder", accuracy.choices, "ladder=rung, where the scene stands; may be repeated");
        command.add_option("-o,--output", accuracy.html, "the report, one HTML file");
        command.add_option("--svg", accuracy.svg, "the plots for a paper: FILE.svg, FILE-2.svg …");
        command.add_option("--json", accuracy.json, "the numbers as JSON");
        command.add_option("--markdown", accuracy.markdown, "the numbers as a page, with the plots of --svg");
        command.add_option("--csv", accuracy.csv, "the numbers as CSV, a row for each rung");
        command.add_option("--context", accuracy.context, "ask for an OpenGL version: 3.3, 4.5, es3.2")
            ->check(check_context);
    }

    void add_explain() {
        CLI::App& command = *app.add_subcommand("explain", "say what a scene pays for, why, and what it costs");
        explain_command = &command;
        add_access(command);
        add_timeout(command, explain.timeout, "all of it; expensive frames are timed in fewer rounds");
        command.footer("Times are of this machine, now; those of passes are by difference.");
        command.add_option("SCENE", explain.scene)->required();
        command.add_flag("--json", explain.json, "as JSON");
        command.add_flag("--no-time", explain.no_time, "don't time frames");
        command.add_option("--reps", explain.rounds, "rounds, in each of which every pass is left out once")
            ->check(CLI::Range(3, 10000));
        command.add_option("--size", explain_size, "WIDTHxHEIGHT (default: the scene's)")->check(check_size);
        command.add_option("--time", explain.time, "seconds since the scene began")->check(check_finite);
        add_repeated(command, "--set", explain.sets, "uniform=value or Program.uniform=value; may be repeated");
        add_repeated(command, "--ladder", explain.ladders, "ladder=rung; may be repeated");
        command.add_option("--context", explain.context, "ask for an OpenGL version: 3.3, 4.5, es3.2")
            ->check(check_context);
    }

    Access access() const {
        Access access;
        std::string checked;
        for (const std::string& limit : limits) set_limit(access.limits, limit, checked);
        if (!confine.empty()) access.confine = confine;
        return access;
    }

    bool sizes_fit(const Limits& most) const {
        for (const auto& size : {render.size, window.size, accuracy.size, explain.size}) {
            if (!size || static_cast<std::uint64_t>(std::max(size->first, size->second)) <= most.output_side) continue;
            fmt::print(stderr, "snell: error: {}x{} is too large\n   help: {}\n", size->first, size->second,
                       limit_help(most, &Limits::output_side));
            return false;
        }
        return true;
    }

    int run() {
        if (!render_size.empty()) parse_size(render_size, render.size.emplace());
        if (!window_size.empty()) parse_size(window_size, window.size.emplace());
        if (!accuracy_within.empty()) accuracy.within = app::parse_milliseconds(accuracy_within);
        if (!accuracy_size.empty()) parse_size(accuracy_size, accuracy.size.emplace());
        if (!explain_size.empty()) parse_size(explain_size, explain.size.emplace());
        window.access = render.access = check.access = accuracy.access = explain.access = save.access = access();
        if (!sizes_fit(render.access.limits)) return app::exit_usage;
        if (explain_command->parsed()) return app::explain(explain);
        if (accuracy_command->parsed()) return app::accuracy(accuracy);
        if (render_command->parsed() || sweep_command->parsed()) return app::render(render);
        if (save_command->parsed()) return app::save(save);
        if (check_command->parsed()) return app::check(check);
        if (commands_command->parsed()) return app::print_commands(commands_json);
        if (info_command->parsed()) return app::print_info(info);
        if (window.scene.empty()) {
            fmt::print(stderr, "snell: error: no scene is named\n\n{}\n", app.help());
            return app::exit_usage;
        }
        return run_window(window);
    }
};

// A full disk may be where standard output goes.
int printed(int status) {
    const int wrong = std::fflush(stdout) != 0 ? errno : std::ferror(stdout) ? EIO : 0;
    if (wrong == 0) return status;
    fmt::print(stderr, "snell: error: can't write what was to be printed: {}\n", std::strerror(wrong));
    return std::max<int>(status, app::exit_input);
}

}  // namespace

int main(int argc, char** argv) {
    // A file that grows beyond what is allowed is an error as a full disk is, not the end of the process.
    std::signal(SIGXFSZ, SIG_IGN);
    std::set_new_handler(out_of_memory);
    CommandLine line;
    try {
        line.app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked = error.get_exit_code() == 0;  // --help, --version
        line.app.exit(error);
        return asked ? app::exit_fine : app::exit_usage;
    }
    try {
        return printed(line.run());
    } catch (const std::exception& error) {
        fmt::print(stderr, "snell: error: {}\n", utf8::printable(error.what()));
        return app::exit_input;
    }
}
