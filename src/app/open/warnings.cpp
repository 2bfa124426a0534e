#include "src/app/open/warnings.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/gl/target.h"
#include "src/glsl/read/lexer.h"
#include "src/lint/lint.h"
#include "src/plan/setup.h"
#include "src/plan/texts.h"
#include "src/plan/view.h"

namespace snell::app {

namespace {

constexpr int longest_side = 128;  // pixels, of the pictures that are tried

// Returns the first view that shows something, as the value of --view; "" if none does.
std::string view_that_shows(Runtime& runtime, const Frame& frame, const Runtime::Drawn& drawn, int width, int height) {
    const double scale = std::min(1., static_cast<double>(longest_side) / std::max(width, height));
    const int w = std::max(1, static_cast<int>(width * scale)), h = std::max(1, static_cast<int>(height * scale));
    const gl::Target target = gl::make_target(w, h, 1);
    if (!target.framebuffer) return {};
    for (const View& view : views_to_try(drawn.boxes, drawn.camera, frame.view)) {
        bool reached = false;
        Frame tried{
            .time = frame.time, .view = view, .controls = frame.controls, .standing = true, .reached = &reached};
        runtime.draw(tried, {.framebuffer = target.framebuffer.get(), .width = w, .height = h});
        if (reached) return view_text(view);
    }
    return {};
}

}  // namespace

Diagnostics nothing_in_view(Document& document, const Frame& frame, int width, int height) {
    Diagnostics result;
    Runtime& runtime = *document.runtime;
    const Runtime::Drawn drawn = runtime.drawn(frame);
    if (drawn.first == none) {
        if (document.diagnostics.has_errors()) return result;  // the errors say why
        const bool elsewhere = !runtime.scene().draws.empty();
        result.warning("nothing-drawn", elsewhere ? "nothing is drawn to the window" : "the scene draws nothing",
                       elsewhere ? "'RenderToTexture' without arguments returns to the window"
                                 : "a command such as 'Sphere 1' draws with the Program before it");
        return result;
    }
    const std::string view = view_that_shows(runtime, frame, drawn, width, height);
    const bool at_origin = !drawn.camera.look_at;
    std::string help = "what is drawn lies outside of the picture or is discarded, culled or hidden";
    if (!view.empty()) help = fmt::format("'--view {}' shows it", view);
    if (!view.empty() && at_origin)
        help +=
            "; the scene has no LookAt, so the eye is at the origin and looks to -Z: 'LookAt' or 'Translate' places it";
    result.warning("nothing-in-view", runtime.scene().draws[drawn.first].span,
                   "nothing is in view: no fragment of any draw reached the picture", help);
    return result;
}

}  // namespace snell::app

namespace snell {

namespace {

// A text that includes a file counts, because the file may have a loop.
bool has_loop(std::string_view text) {
    return glsl::has_word(text, "for") || glsl::has_word(text, "while") || text.find("include \"") != text.npos;
}

Diagnostics lints(const Plan& plan, Document& document, lint::Rule rule) {
    Diagnostics of_rule;
    const Diagnostics found = lint::check(plan, document.sources, shader_includes(*document.files));
    for (const Diagnostic& diagnostic : found.items())
        if (diagnostic.code == lint::facts(rule).code) of_rule.add(diagnostic);
    return of_rule;
}

}  // namespace

bool may_go_round(const Plan& plan, const Document& document, const gl::Caps& caps) {
    if (caps.renderer.find("llvmpipe") == std::string::npos) return false;
    return ranges::any_of(plan.programs, [&](const PlannedProgram& program) {
        return ranges::any_of(
            program.stages, [&](const glsl::StageInput& stage) { return has_loop(document.sources.text(stage.file)); });
    });
}

Diagnostics too_many_rounds(const Plan& plan, Document& document) {
    return lints(plan, document, lint::Rule::many_rounds);
}

Diagnostics misread_rungs(const Plan& plan, Document& document) {
    if (ranges::none_of(plan.scene.ladders, &Ladder::numeric)) return {};
    return lints(plan, document, lint::Rule::rung_number);
}

void Reach::add(const Controls& controls) {
    for (std::size_t i = 0; i < controls.items.size(); ++i)
        for (std::size_t k = 0; k < controls.items[i].value.size(); ++k) {
            const double value = controls.items[i].value[k];
            double &low = low_.items[i].value[k], &high = high_.items[i].value[k];
            low = std::min(low, value);
            high = std::max(high, value);
        }
}

void Reach::narrow(Plan& plan) const {
    for (std::size_t i = 0; i < low_.items.size(); ++i) {
        const Control& control = low_.items[i];
        if (control.value.size() != 1 || control.type == ValueType::sampler) continue;
        std::vector<UniformValue>& uniforms = plan.scene.programs[control.program].uniforms;
        const double low = control.value[0], high = high_.items[i].value[0];
        auto uniform = ranges::find(uniforms, control.name, &UniformValue::name);
        if (uniform == uniforms.end()) uniform = uniforms.insert(uniform, UniformValue{.name = control.name});
        uniform->kind = UniformValue::Kind::range;
        uniform->values = {low, low, high};
    }
}

}  // namespace snell
