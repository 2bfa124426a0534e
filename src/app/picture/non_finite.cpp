#include "src/app/picture/non_finite.h"

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/runtime/inspect.h"

namespace snell::app {

std::optional<NonFinite> count_non_finite(Runtime& runtime, const Frame& frame, int width, int height) {
    FloatPicture picture;
    if (!picture.resize(width, height)) return std::nullopt;
    std::vector<float> rgba;
    picture.draw(runtime, frame, rgba);
    const FlagCounts counts = count_flags(rgba);
    return NonFinite{counts[Flag::nan], counts[Flag::infinite]};
}

namespace {

constexpr int small = 128;

// Comments may count: then a picture is drawn for nothing.
bool may_give_nan(std::string_view text) {
    constexpr std::string_view words[] = {"pow",  "sqrt", "log",  "normalize", "refract",
                                          "acos", "asin", "atan", "mod",       "smoothstep"};
    const auto names = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
    for (std::size_t at = text.find('/'); at != std::string_view::npos; at = text.find('/', at + 2))
        if (at + 1 < text.size() && text[at + 1] != '/' && text[at + 1] != '*' && (at == 0 || text[at - 1] != '*'))
            return true;
    return ranges::any_of(words, names);
}

}  // namespace

bool may_give_nan(const Plan& plan, const Sources& sources) {
    return ranges::any_of(plan.programs, [&](const PlannedProgram& program) {
        return ranges::any_of(program.stages,
                              [&](const glsl::StageInput& stage) { return may_give_nan(sources.text(stage.file)); });
    });
}

void warn_of_nan(Document& document) {
    if (!document.runtime || document.diagnostics.has_errors()) return;
    // What may never end is not begun.
    if (ranges::count(document.diagnostics.items(), "many-rounds", &Diagnostic::code) > 0) return;
    const View view;
    Frame frame{0, view, document.controls};
    const auto all = count_non_finite(*document.runtime, frame, small, small);
    if (!all || all->nan == 0) return;
    const Scene& scene = document.scene();
    for (Index program = 0; program < scene.programs.size(); ++program) {
        std::vector<bool> hidden;
        for (const Draw& draw : scene.draws) hidden.push_back(draw.program != program);
        frame.hidden = &hidden;
        const auto own = count_non_finite(*document.runtime, frame, small, small);
        if (!own || own->nan == 0) continue;
        document.diagnostics.warning(
            "non-finite", scene.programs[program].span,
            fmt::format("program '{}' computes NaN (not a number) in {} of the {} pixels of a small picture, with the "
                        "scene's values: these pixels have no colour, and most drivers show nothing there",
                        scene.programs[program].name, own->nan, small * small),
            "look for 0. / 0., and for pow, sqrt, log, acos or normalize of numbers for which they are not defined; in "
            "the "
            "window, N marks these pixels");
    }
}

}  // namespace snell::app
