// A shader's text to tokens, comments and directives. Directives are read, but not obeyed.
#include <algorithm>

#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"
#include "src/language/shader/outline.h"

namespace snell::language {

namespace {

using Role = ShaderToken::Role;

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

}  // namespace

void read_shader_tokens(Outline& outline) { TokenReader(outline).run(); }

}  // namespace snell::language
