#include "src/app/rounds.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "src/lint/lint.h"
#include "src/runtime/program.h"

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

// Or includes a file that may have one.
bool has_loop(std::string_view text) {
    return has_word(text, "for") || has_word(text, "while") || text.find("include \"") != text.npos;
}

}  // namespace

void warn_of_rounds(const Plan& plan, Document& document, const gl::Caps& caps) {
    if (caps.renderer.find("llvmpipe") == std::string::npos) return;
    const auto loops = [&](const PlannedProgram& program) {
        return std::ranges::any_of(
            program.stages, [&](const glsl::StageInput& stage) { return has_loop(document.sources.text(stage.file)); });
    };
    if (std::ranges::none_of(plan.programs, loops)) return;
    const Diagnostics found = lint::check(plan, document.sources, runtime::include_reader(*document.files));
    for (const Diagnostic& diagnostic : found.items())
        if (diagnostic.code == lint::facts(lint::Rule::many_rounds).code) document.diagnostics.add(diagnostic);
}

}  // namespace snell
