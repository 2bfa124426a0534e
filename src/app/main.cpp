// The command line: what to do with which scene.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>

#include "src/app/commands.h"
#include "src/app/headless.h"
#include "src/app/window.h"

namespace {

using namespace snell;

constexpr const char* examples = R"(Examples:
  snell scenes/refraction-room/refraction-room.glib                   open a scene in a window
  snell render room.glib -o room.png                       draw it to a picture, without a display
  snell render room.glib -o room.png --set uEta=1.5        … with a slider moved
  snell render room.glib -o room.exr --size 1920x1080 --time 2.5 --samples 4
  snell check room.glib                                    say all that is wrong with it
  snell commands                                           list the commands of the language

Exit status: 0 fine, 1 errors in the input, 2 wrong usage, 3 no graphics.)";

bool parse_size(const std::string& text, std::pair<int, int>& size) {
    int end = 0;
    return std::sscanf(text.c_str(), "%5dx%5d%n", &size.first, &size.second, &end) == 2 &&
           static_cast<size_t>(end) == text.size() && size.first > 0 && size.second > 0 && size.first <= 16384 &&
           size.second <= 16384;
}

std::string check_size(const std::string& text) {
    std::pair<int, int> size;
    return parse_size(text, size) ? "" : "'" + text + "' is not WIDTHxHEIGHT, such as 800x600 (at most 16384x16384)";
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

struct CommandLine {
    CLI::App app{"snell runs .glib scenes: GLSL programs with sliders, in a window or to a picture."};
    WindowOptions window;
    std::string window_size, render_size;
    app::RenderOptions render;
    app::CheckOptions check;
    bool commands_json = false;
    std::string info_context;
    CLI::App *render_command = nullptr, *check_command = nullptr, *commands_command = nullptr, *info_command = nullptr;

    CommandLine() {
        app.footer(examples);
        app.set_version_flag("--version", std::string("snell ") + SNELL_VERSION);
        app.require_subcommand(0, 1);
        app.add_option("SCENE", window.scene, "the scene to open in a window");
        app.add_option("--size", window_size, "size of the window, WIDTHxHEIGHT")->check(check_size);
        // For tests of the window: not for users.
        app.add_option("--state", window.state_file)->group("");
        app.add_option("--exit-after", window.exit_after)->group("");
        add_render();
        add_check();
        commands_command = app.add_subcommand("commands", "list the commands of the language");
        commands_command->add_flag("--json", commands_json, "as JSON");
        info_command = app.add_subcommand("info", "say what OpenGL there is");
        info_command->add_option("--context", info_context, "ask for this version: 3.3, 4.5, es3.2")
            ->check(check_context);
    }

    void add_render() {
        render_command = app.add_subcommand("render", "draw a scene to a picture, without a display");
        render_command->footer(examples);
        render_command->add_option("SCENE", render.scene)->required();
        render_command->add_option("-o,--output", render.output, "the picture; its extension says the format")
            ->required();
        render_command->add_option("--size", render_size, "WIDTHxHEIGHT (default: the scene's)")->check(check_size);
        render_command->add_option("--time", render.time, "seconds since the scene began")->check(check_finite);
        render_command->add_option("--set", render.sets, "uniform=value or Program.uniform=value; may be repeated")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        render_command->add_option("--ladder", render.ladders, "ladder=rung; may be repeated")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        render_command->add_option("--samples", render.samples, "samples a pixel")->check(CLI::Range(1, 64));
        render_command->add_option("--stats", render.stats, "write timings and counters as JSON");
        render_command->add_flag("--axes", render.axes, "draw the axes");
        render_command->add_flag("-q,--quiet", render.quiet, "print errors only, no warnings");
        render_command->add_option("--context", render.context, "ask for an OpenGL version: 3.3, 4.5, es3.2")
            ->check(check_context);
    }

    void add_check() {
        check_command = app.add_subcommand("check", "say all that is wrong with scenes");
        check_command->add_option("SCENE", check.scenes)->required();
        check_command->add_flag("--json", check.json, "as JSON");
        check_command->add_flag("!--no-lint", check.lint,
                                "leave out what is allowed and probably not meant (docs/lints.md)");
        check_command->add_option("--dump", check.dump, "print one stage of the reading")
            ->check(CLI::IsMember({"tokens", "statements", "scene", "plan"}));
    }

    int run() {
        if (!render_size.empty()) parse_size(render_size, render.size.emplace());
        if (!window_size.empty()) parse_size(window_size, window.size.emplace());
        if (render_command->parsed()) return app::render(render);
        if (check_command->parsed()) return app::check(check);
        if (commands_command->parsed()) return app::print_commands(commands_json);
        if (info_command->parsed()) return app::print_info(info_context);
        if (window.scene.empty()) {
            fmt::print(stderr, "snell: error: no scene is named\n\n{}\n", app.help());
            return app::exit_usage;
        }
        return run_window(window);
    }
};

}  // namespace

int main(int argc, char** argv) {
    CommandLine line;
    try {
        line.app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked = error.get_exit_code() == 0;  // --help, --version
        line.app.exit(error);
        return asked ? app::exit_fine : app::exit_usage;
    }
    try {
        return line.run();
    } catch (const std::exception& error) {
        fmt::print(stderr, "snell: error: {}\n", error.what());
        return app::exit_input;
    }
}
