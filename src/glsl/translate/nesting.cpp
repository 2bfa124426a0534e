// Drivers walk the syntax tree of a shader by recursion: a tree that is too deep ends the process.

#include "src/glsl/translate/program.h"

#include "parser/text/ranges.h"

namespace snell::glsl {

namespace {

bool opens(std::string_view t) { return t == "(" || t == "[" || t == "{"; }
bool closes(std::string_view t) { return t == ")" || t == "]" || t == "}"; }

// What may have a tree of its own below it: operators, brackets, and statements that contain statements.
bool deepens(const Token& t) {
    constexpr std::string_view words[] = {"if", "else", "for", "while", "do", "switch"};
    if (t.kind == Kind::identifier) return ranges::find(words, t.text) != std::end(words);
    return t.kind == Kind::punct && t.text != ";" && t.text != "," && !closes(t.text);
}

}  // namespace

// The depth at a token is at most what deepens the tree since the last comma or semicolon of each open bracket. An
// `else` continues at its `if`.
void refuse_deep_nesting(const Program& program, const Unit& u) {
    struct Depth {
        std::uint64_t here = 0, at_if = 0;
    };
    const std::uint64_t most = program.options.limits.expression_depth;
    std::vector<Depth> brackets{{}};  // as they open
    Depth depth;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        const std::string_view t = u.tokens[i].text;
        if (deepens(u.tokens[i]) && ++depth.here > most) {
            program.diagnostics.error(
                "too-deep", u.span(static_cast<int>(i)),
                "this expression or statement nests too deeply, or has too many operators",
                "use several statements; " + limit_help(program.options.limits, &Limits::expression_depth));
            return;
        }
        if (t == "if") depth.at_if = depth.here;
        if (opens(t)) brackets.push_back(depth);
        if (closes(t) && brackets.size() > 1) {
            depth = brackets.back();
            brackets.pop_back();
        }
        const bool ends = t == ";" || t == "}";
        if (t == "," || ends) depth.here = ends && u.tokens[i + 1].text == "else" ? depth.at_if : brackets.back().here;
    }
}

}  // namespace snell::glsl
