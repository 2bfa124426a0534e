// What the names of a shader mean: declarations are told by two words in a row, the first a type, and scopes by braces.
#include "src/language/shader/outline.h"

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/read/words.h"
#include "src/language/shader/resolver.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using Role = ShaderToken::Role;

// The names of directives: macros are global, their parameters are their own.
class MacroReader {
public:
    explicit MacroReader(Outline& outline) : o_(outline) {}

    void run() {
        std::size_t token = 0;
        for (const ShaderDirective& directive : o_.directives) {
            while (token < o_.tokens.size() && o_.tokens[token].begin < directive.begin) ++token;
            const std::size_t first = token;
            while (token < o_.tokens.size() && o_.tokens[token].begin < directive.end) ++token;
            for (std::size_t i = first; i < token; ++i)
                if (o_.word(o_.tokens[i]) == "defined" && directive.word != "define") o_.tokens[i].role = Role::word;
            if (directive.word == "define" && token > first + 1) define(directive, first + 1, token);
        }
    }

private:
    void define(const ShaderDirective& directive, std::size_t first, std::size_t last) {
        ShaderToken& name = o_.tokens[first];
        if (name.kind != glsl::Kind::identifier) return;
        name.role = Role::global;
        const int macro = add(directive, first, Kind::macro, false);
        std::size_t i = first + 1;
        if (i >= last || o_.word(o_.tokens[i]) != "(" || o_.tokens[i].begin != name.end) return;
        const std::uint32_t open = o_.tokens[i].begin;
        std::vector<int> parameters;
        for (++i; i < last && o_.word(o_.tokens[i]) != ")"; ++i)
            if (o_.tokens[i].kind == glsl::Kind::identifier) {
                parameters.push_back(add(directive, i, Kind::parameter, true));
                o_.tokens[i].role = Role::local;
            }
        const std::uint32_t close = i < last ? o_.tokens[i].end : directive.end;
        ShaderDeclaration& made = o_.declarations[static_cast<std::size_t>(macro)];
        made.type = o_.text.substr(open, close - open);
        made.parameters_begin = open + 1;
        made.parameters_end = i < last ? o_.tokens[i].begin : directive.end;
        for (; i < last; ++i) {
            if (o_.tokens[i].kind != glsl::Kind::identifier) continue;
            for (const int parameter : parameters)
                if (o_.declarations[static_cast<std::size_t>(parameter)].name == o_.word(o_.tokens[i])) {
                    o_.tokens[i].role = Role::local;
                    o_.tokens[i].declaration = parameter;
                }
        }
    }

    int add(const ShaderDirective& directive, std::size_t token, Kind kind, bool local) {
        const int index = static_cast<int>(o_.declarations.size());
        ShaderToken& name = o_.tokens[token];
        ShaderDeclaration made;
        made.kind = kind;
        made.local = local;
        made.name = o_.word(name);
        made.token = static_cast<std::uint32_t>(token);
        made.begin = directive.begin;
        made.end = directive.end;
        made.visible_from = local ? name.begin : directive.end;
        made.visible_to = local ? directive.end : static_cast<std::uint32_t>(o_.text.size());
        name.declares = true;
        name.declaration = index;
        o_.declarations.push_back(made);
        return index;
    }

    Outline& o_;
};

void find_braces(Outline& outline) {
    std::vector<std::uint32_t> open;
    for (const ShaderToken& token : outline.tokens) {
        if (token.in_directive || token.end - token.begin != 1) continue;
        const char c = outline.text[token.begin];
        if (c == '{') open.push_back(token.begin);
        if (c != '}' || open.empty()) continue;
        const std::string_view within = outline.text.substr(open.back(), token.end - open.back());
        if (within.find('\n') != std::string_view::npos)
            outline.braces.push_back({outline.file, open.back(), token.end});
        open.pop_back();
    }
}

}  // namespace

Outline read_outline(FileId file, std::string_view text) {
    Outline outline;
    outline.text = text;
    outline.file = file;
    read_shader_tokens(outline);
    MacroReader(outline).run();
    resolve_names(outline);
    find_braces(outline);
    for (std::uint32_t i = 0; i < outline.tokens.size(); ++i)
        if (outline.tokens[i].role == Role::global) outline.globals[outline.word(outline.tokens[i])].push_back(i);
    return outline;
}

std::size_t Outline::before(std::uint32_t offset) const {
    const auto found = std::lower_bound(tokens.begin(), tokens.end(), offset,
                                        [](const ShaderToken& token, std::uint32_t at) { return token.begin < at; });
    return static_cast<std::size_t>(found - tokens.begin());
}

const ShaderToken* Outline::at(std::uint32_t offset) const {
    const std::size_t next = before(offset);
    const ShaderToken* left = next > 0 && tokens[next - 1].end >= offset ? &tokens[next - 1] : nullptr;
    const ShaderToken* right = next < tokens.size() && tokens[next].begin == offset ? &tokens[next] : nullptr;
    if (left != nullptr && (left->end > offset || right == nullptr)) return left;
    if (left != nullptr && right != nullptr && right->kind != glsl::Kind::identifier) return left;
    return right;
}

bool Outline::in_comment(std::uint32_t offset) const {
    const auto next = std::lower_bound(comments.begin(), comments.end(), offset,
                                       [](const Span& comment, std::uint32_t at) { return comment.begin < at; });
    if (next == comments.begin()) return false;
    const Span& comment = *std::prev(next);
    // The end of a line belongs to its comment, and so does the end of the text if nothing closes one.
    const std::string_view written = text.substr(comment.begin, comment.end - comment.begin);
    const bool closed = written.starts_with("/*") && written.size() >= 4 && written.ends_with("*/");
    return offset < comment.end || (offset == comment.end && !closed);
}

const ShaderDirective* Outline::directive_at(std::uint32_t offset) const {
    const auto next =
        std::upper_bound(directives.begin(), directives.end(), offset,
                         [](std::uint32_t at, const ShaderDirective& directive) { return at < directive.begin; });
    if (next == directives.begin()) return nullptr;
    const ShaderDirective& directive = *std::prev(next);
    return offset <= directive.end && offset > directive.begin ? &directive : nullptr;
}

bool Outline::in_body(std::uint32_t offset) const {
    return ranges::any_of(declarations, [&](const ShaderDeclaration& d) {
        return d.kind == Kind::function && d.body && offset > d.parameters_end && offset < d.visible_to &&
               offset <= d.end;
    });
}

const std::vector<std::uint32_t>& Outline::uses(std::string_view name) const {
    static const std::vector<std::uint32_t> nothing;
    const auto found = globals.find(name);
    return found == globals.end() ? nothing : found->second;
}

}  // namespace snell::language
