#include "src/language/shader/outline.h"

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using Role = ShaderToken::Role;

// A shader's text to tokens, comments and directives. Directives are read, but not obeyed.

class TokenReader {
public:
    explicit TokenReader(Outline& outline)
        : outline_(outline), cleaned_(glsl::clean(outline.text)), text_(cleaned_.text) {}

    void run() {
        bool line_start = true;
        for (std::size_t at = 0; at < text_.size();) {
            const char c = text_[at];
            if (c == '\n') {
                line_start = true;
                ++at;
            } else if (const std::size_t behind = behind_trivia(at, text_.size()); behind > at) {
                at = behind;
            } else if (c == '#' && line_start) {
                at = directive(at);
            } else {
                line_start = false;
                at = token(at, text_.size(), false);
            }
        }
    }

private:
    static Span span(FileId file, std::size_t begin, std::size_t end) {
        return {file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    }

    // Behind one blank, continued line end or comment; `at` if there is none.
    std::size_t behind_trivia(std::size_t at, std::size_t end) {
        const char c = text_[at], next = at + 1 < end ? text_[at + 1] : '\0';
        if (glsl::blank(c) || c == '\r') return at + 1;
        if (c == '\\' && next == '\n') return at + 2;
        if (c == '\\' && next == '\r') return std::min(at + 3, end);
        if (c != '/' || (next != '/' && next != '*')) return at;
        std::size_t close = at + 2;
        if (next == '*') {
            close = text_.find("*/", close);
            close = close == std::string_view::npos ? end : std::min(close + 2, end);
        } else {
            close = std::min(glsl::line_comment_end(text_, at), end);
        }
        outline_.comments.push_back(span(outline_.file, at, close));
        return close;
    }

    std::size_t token(std::size_t at, std::size_t end, bool in_directive) {
        const glsl::Lexeme lexeme = glsl::lex(text_, at);
        ShaderToken token;
        token.kind = lexeme.kind;
        token.in_directive = in_directive;
        token.begin = static_cast<std::uint32_t>(at);
        token.end = static_cast<std::uint32_t>(std::min(end, at + std::max<std::size_t>(lexeme.text.size(), 1)));
        if (lexeme.kind == glsl::Kind::identifier) token.role = is_word(lexeme.text) ? Role::word : Role::global;
        if (in_directive && lexeme.text == "##") outline_.pastes = true;
        if (lexeme.kind == glsl::Kind::identifier && goes_on(token.end)) outline_.splits = true;
        outline_.tokens.push_back(token);
        return token.end;
    }

    // Drivers drop a backslash with the line end behind it, even in a name.
    bool goes_on(std::size_t at) const {
        const std::size_t before = at;
        while (at < text_.size() && text_[at] == '\\') {
            at += at + 1 < text_.size() && text_[at + 1] == '\r' ? 2 : 1;
            if (at >= text_.size() || text_[at] != '\n') return false;
            ++at;
        }
        return at > before && at < text_.size() && glsl::identifier_part(text_[at]);
    }

    // Texts have few words, many times.
    bool is_word(std::string_view text) {
        const auto [known, added] = known_.try_emplace(text, false);
        if (added)
            known->second = glsl::is_qualifier(text) || glsl::is_statement_word(text) || glsl::builtin_type(text);
        return known->second;
    }

    std::size_t directive(std::size_t at) {
        const std::size_t end = glsl::directive_end(text_, at);
        std::size_t i = at + 1;
        while (i < end && glsl::blank(text_[i])) ++i;
        const std::size_t word = i;
        while (i < end && glsl::identifier_part(text_[i])) ++i;
        ShaderDirective found;
        found.begin = static_cast<std::uint32_t>(at);
        found.end = static_cast<std::uint32_t>(end);
        found.word = outline_.text.substr(word, i - word);
        std::string_view rest = outline_.text.substr(i, end - i);
        while (!rest.empty() && (glsl::blank(rest.front()))) rest.remove_prefix(1);
        while (!rest.empty() && (glsl::blank(rest.back()) || rest.back() == '\r')) rest.remove_suffix(1);
        found.rest = rest;
        if (i > word) {
            outline_.tokens.push_back({glsl::Kind::identifier, Role::directive, true, false,
                                       static_cast<std::uint32_t>(word), static_cast<std::uint32_t>(i)});
        }
        if (found.word == "include") included(found);
        outline_.directives.push_back(found);
        const bool code = found.word == "define" || found.word == "undef" || found.word == "if" ||
                          found.word == "elif" || found.word == "ifdef" || found.word == "ifndef";
        while (i < end) {
            const std::size_t behind = text_[i] == '\n' ? i + 1 : behind_trivia(i, end);
            i = behind > i ? behind : code ? token(i, end, true) : i + 1;
        }
        return std::max(end, at + 1);
    }

    void included(ShaderDirective& directive) const {
        const std::string_view rest = directive.rest;
        if (rest.empty() || (rest.front() != '"' && rest.front() != '<')) return;
        const std::size_t close = std::min(rest.find(rest.front() == '<' ? '>' : '"', 1), rest.size());
        directive.name_begin = static_cast<std::uint32_t>(rest.data() - outline_.text.data()) + 1;
        directive.name_end = directive.name_begin + static_cast<std::uint32_t>(close) - 1;
    }

    Outline& outline_;
    glsl::Cleaned cleaned_;
    std::string_view text_;
    std::unordered_map<std::string_view, bool> known_;
};

// What the names of a shader mean: declarations are told by two words in a row, the first a type, and scopes by braces.

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
    TokenReader(outline).run();
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
