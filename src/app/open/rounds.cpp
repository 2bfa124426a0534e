#include "src/app/open/rounds.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "parser/text/ranges.h"
#include "src/lint/lint.h"
#include "src/plan/read/texts.h"

namespace snell {

namespace {

bool has_word(std::string_view text, std::string_view word) {
    const auto letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !letter(text[at - 1])) && (end == text.size() || !letter(text[end]))) return true;
    }
    return false;
}

// A text that includes a file counts, because the file may have a loop.
bool has_loop(std::string_view text) {
    return has_word(text, "for") || has_word(text, "while") || text.find("include \"") != text.npos;
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
    Diagnostics rounds;
    const Diagnostics found = lint::check(plan, document.sources, shader_includes(*document.files));
    for (const Diagnostic& diagnostic : found.items())
        if (diagnostic.code == lint::facts(lint::Rule::many_rounds).code) rounds.add(diagnostic);
    return rounds;
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
