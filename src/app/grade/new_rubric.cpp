// Writes a rubric that a lecturer can change without reading a manual.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "parser/commands/commands.h"
#include "parser/text/words.h"
#include "src/accuracy/metrics.h"
#include "src/app/grade/grade.h"
#include "src/app/grade/judge.h"
#include "src/app/grade/rubric/table.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/picture/picture.h"
#include "src/content/replace.h"
#include "src/document/document.h"
#include "src/gl/target.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_sliders = 6;

// A name as a key: one with a dot, of a structure's member, would be two.
std::string toml_key(const std::string& name) {
    const auto bare = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    return std::all_of(name.begin(), name.end(), bare) ? name : toml_text(name);
}

constexpr std::string_view head = R"(# A rubric for `snell grade`. Run it with
#   snell grade {file} submissions -o report
# where `submissions` is a folder with a folder or an archive of each student.
# Lines that begin with # are comments: they change nothing.

title = {title}
reference = {reference}    # your own scene; the path is relative to this file
size = "320x320"           # of all pictures, in pixels
timeout = 10               # seconds for reading a scene, and for each picture
# scene = "project*.glib"  # name of the submissions' scenes; without this line, any *.glib
# shared = ["textures"]    # handed-out files, which every submission finds by their names
# template = ["handout"]   # what was handed out: it does not count as similarity

# Other names under which a submission may have a uniform. Nothing is guessed.
[aliases]
# uKd = ["Kd", "uDiffuse"]

# Which scene of a submission is meant, where that is not clear.
[scenes]
# "Ann Lee" = "final/project.glib"

# Each [[item]] is worth its points, and judges one thing. With `deduct` in place of `points` it costs them if it fails.
[[item]]
name = "The scene reads without errors"
points = 2
no_errors = true

# `snell help CODE` explains a code, docs/lints.md lists all. Each that is found costs `each` points.
[[item]]
points = 2
each = 0.5
no_lints = ["pow-of-negative", "never-read", "slider-without-effect"]
)";

class NewRubric {
public:
    NewRubric(const std::string& scene, const std::string& output) : scene_(scene), output_(output), deadline_(20) {}

    Exit make(std::string& text) {
        deadline_.begin(fmt::format("reading '{}'", scene_));
        context_ = headless_context("");
        if (!context_) return exit_graphics;
        document_ = open_document(scene_, gl::query_caps());
        const Diagnostics& diagnostics = document_->diagnostics;
        if (diagnostics.has_errors() || !document_->runtime) {
            fmt::print(stderr, "{}", render(diagnostics, document_->sources));
            return exit_input;
        }
        target_ = gl::make_target(side, side, 1, document_->runtime->display_pixels());
        text = begin() + uniforms() + commands() + relations() + end();
        return exit_fine;
    }

private:
    static constexpr int side = 160;

    std::string begin() const {
        std::error_code error;
        const auto folder_of = [&error](const std::string& file) {
            return fs::weakly_canonical(fs::absolute(file, error).parent_path(), error);
        };
        const fs::path reference = folder_of(scene_) / fs::path(scene_).filename();
        std::string text(head);
        const auto put = [&text](std::string_view mark, const std::string& value) {
            text.replace(text.find(mark), mark.size(), value);
        };
        put("{file}", output_.empty() ? "rubric.toml" : utf8::printable(output_));
        put("{title}", toml_text(fs::path(scene_).stem().string()));
        put("{reference}",
            toml_text(reference.lexically_relative(folder_of(output_.empty() ? "rubric.toml" : output_)).string()));
        return text;
    }

    // The sliders and check boxes of the scene, each name once.
    std::vector<const snell::Control*> sliders() const {
        std::vector<const snell::Control*> found;
        for (const snell::Control& control : document_->controls.items)
            if (control.listed && control.active && control.widget != Widget::none &&
                std::none_of(found.begin(), found.end(),
                             [&](const auto* other) { return other->name == control.name; }))
                found.push_back(&control);
        return found;
    }

    std::string uniforms() const {
        const auto all = sliders();
        if (all.empty()) return {};
        std::string text =
            "\n# Type of each, and, if it has a slider, the range that the slider must reach at least.\n[[item]]\nname "
            "= \"Uniforms\"\npoints = 2\n[item.uniforms]\n";
        for (const snell::Control* control : all) {
            std::string needed = type_of(*document_, *control);
            if (control->widget == Widget::slider) needed += fmt::format(" {}..{}", control->min, control->max);
            text += fmt::format("{} = {}\n", toml_key(control->name), toml_text(needed));
        }
        return text;
    }

    std::string commands() const {
        std::string text =
            "\n# Commands that must be used; `forbids` names those that must not.\n[[item]]\npoints = 1\nneeds = [";
        std::size_t count = 0;
        for (const Draw& draw : document_->scene().draws) {
            const std::string_view statement = document_->sources.text(draw.span.file).substr(draw.span.begin);
            const Command* command = find_command(statement.substr(0, statement.find_first_of(" \t\r\n\\#")));
            if (command && text.find(toml_text(command->name)) == text.npos)
                text += (count++ > 0 ? ", " : "") + toml_text(command->name);
        }
        return count > 0 ? text + "]\n# forbids = [\"Teapot\"]\n" : "";
    }

    accuracy::Picture picture(const snell::Control* changed, double value) {
        Controls controls = document_->controls;
        if (changed) {
            snell::Control& control = *controls.find(changed->program, changed->name);
            for (double& component : control.value) component = value;
        }
        deadline_.begin("drawing the scene");
        const View view;
        return accuracy::displayed_picture(
            draw_picture(*document_->runtime, {0, view, controls}, target_, {.width = side, .height = side}, {}),
            false);
    }

    // What is true of the reference itself when a slider is at its lower end.
    std::string relations() {
        std::string text =
            "\n# Values that students do not see. `expect` is one of: darker, brighter, different, same, mirrored, "
            "reference.\n# `than` gives the values of the other picture; without it, it has the scene's own values.\n"
            "# `by` sets how much darker (share of the light) or how different (share of the pixels) it must be.\n";
        const accuracy::Picture own = picture(nullptr, 0);
        std::size_t count = 0;
        for (const snell::Control* control : sliders()) {
            if (control->type != ValueType::float_ || control->components != 1 || count == most_sliders) continue;
            const bool at_low = control->value.front() == control->min;
            const double value = at_low ? control->max : control->min;
            const accuracy::Picture other = picture(control, value);
            const double before = accuracy::mean_light(own), now = accuracy::mean_light(other);
            const double share = accuracy::picture_difference(other, own, accuracy::one_step, false).share;
            const std::string_view expect = now <= .9 * before    ? "darker"
                                            : now >= 1.1 * before ? "brighter"
                                                                  : "different";
            if (share < .02) continue;
            ++count;
            text += fmt::format("[[item]]\npoints = 1\nset = {{ {} = {} }}\nexpect = {}\n\n", toml_key(control->name),
                                value, toml_text(expect));
        }
        return text;
    }

    static std::string end() {
        return R"(# The picture is near the reference's with the same values. Instead of max_rmse (0 to 1), or besides it: max_flip
# (0 to 1), max_pixels (per cent of pixels that differ).
[[item]]
name = "It looks like the reference"
points = 4
expect = "reference"
max_rmse = 0.05

# What a frame may take. Counters: `snell render --stats` lists them.
[[item]]
points = 1
counters = { draws = "1..100" }

# At most so many times the time of the reference.
[[item]]
points = 1
slower = 4
)";
    }

    std::string scene_, output_;
    Deadline deadline_;
    std::unique_ptr<HeadlessContext> context_;  // outlives what is made in it
    std::unique_ptr<Document> document_;
    gl::Target target_;
};

}  // namespace

Exit write_new_rubric(const std::string& scene, const std::string& output) {
    std::error_code error;
    if (!output.empty() && !content::is_stream(output) && fs::exists(output, error))
        return complain(exit_usage, fmt::format("'{}' exists, and is not replaced", output), "-o with another name");
    std::string text;
    const Exit status = NewRubric(scene, content::is_stream(output) ? "" : output).make(text);
    if (status != exit_fine) return status;
    return write_output(output.empty() ? "/dev/stdout" : output, text) ? exit_fine : exit_input;
}

}  // namespace snell::app
