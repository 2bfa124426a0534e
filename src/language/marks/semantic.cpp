// What each word is, for editors that colour it.
#include <algorithm>
#include <array>

#include "parser/names.h"
#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/read/words.h"
#include "src/language/names/links.h"
#include "src/language/services.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using Type = SemanticToken::Type;

// Comments of several lines become several tokens.
void add_comment(std::string_view text, const Span& comment, std::vector<SemanticToken>& found) {
    std::uint32_t begin = comment.begin;
    for (std::uint32_t i = comment.begin; i <= comment.end; ++i) {
        if (i < comment.end && text[i] != '\n' && text[i] != '\r') continue;
        if (i > begin) found.push_back({{comment.file, begin, i}, Type::comment, 0});
        begin = i + 1;
    }
}

class SceneTokens {
public:
    explicit SceneTokens(const Statements& s) : s_(s) {}

    std::vector<SemanticToken> run() {
        for (const SceneStatement& statement : s_.items) add(statement);
        for (const Span& comment : s_.comments) add_comment(s_.text, comment, found_);
        return std::move(found_);
    }

private:
    void mark(const Token& token, Type type, std::uint8_t modifiers = 0) {
        found_.push_back({s_.span(token), type, modifiers});
    }
    void mark_value(const Token& token) {
        if (token.kind == TokenKind::text) return mark(token, Type::string);
        if (token.kind != TokenKind::word) return;
        const std::string_view word = s_.word(token);
        if (plausible_number(word)) return mark(token, Type::number);
        if (same_word(word, "true") || same_word(word, "false")) mark(token, Type::enum_member);
    }

    void add(const SceneStatement& statement) {
        const std::span<const Token> tokens = s_.tokens_of(statement);
        if (statement.command == nullptr) {
            if (tokens.size() > 1) uniforms(statement, 0);
            return;
        }
        if (tokens[0].kind == TokenKind::word) mark(tokens[0], Type::keyword);
        const std::string_view name = statement.command->name;
        if (name == "Program") {
            if (tokens.size() > 1 && tokens[1].kind != TokenKind::open)
                mark(tokens[1], Type::name, SemanticToken::declaration);
            return uniforms(statement, 2);
        }
        if (name == "Ladder") {
            for (std::size_t i = 1; i < tokens.size(); ++i)
                if (tokens[i].kind == TokenKind::word)
                    mark(tokens[i], i == 1 ? Type::macro : Type::enum_member, SemanticToken::declaration);
            return;
        }
        for (std::size_t i = 1; i < tokens.size(); ++i) argument(statement, tokens[i]);
    }

    void argument(const SceneStatement& statement, const Token& token) {
        if (token.kind != TokenKind::word) return mark_value(token);
        if (plausible_number(s_.word(token))) return mark(token, Type::number);
        const Command& command = *statement.command;
        if (command.takes(ArgumentKind::path) && !is_choice(command, s_.word(token))) return mark(token, Type::string);
        if (command.takes(ArgumentKind::rest)) return mark(token, Type::string);
        mark(token, Type::enum_member);
    }
    static bool is_choice(const Command& command, std::string_view word) {
        return ranges::any_of(command.signature.parameters, [&](const Parameter& parameter) {
            return parameter.kind == ArgumentKind::choice && find_choice(parameter.choices, word) >= 0;
        });
    }

    void uniforms(const SceneStatement& statement, std::size_t from) {
        const std::span<const Token> tokens = s_.tokens_of(statement);
        const std::vector<WrittenUniform> written = written_uniforms(s_, statement);
        std::size_t next = 0;
        for (std::size_t i = from; i < tokens.size(); ++i) {
            while (next < written.size() && written[next].name_span.begin < tokens[i].begin) ++next;
            if (next < written.size() && written[next].name_span.begin == tokens[i].begin)
                mark(tokens[i], Type::property);
            else
                mark_value(tokens[i]);
        }
    }

    const Statements& s_;
    std::vector<SemanticToken> found_;
};

class ShaderTokens {
public:
    ShaderTokens(Texts& texts, FileId file) : texts_(texts), o_(texts.outline(file)) {
        for (const Ladder& ladder : texts.project.scene().ladders) ladders_.push_back(ladder.name);
    }

    std::vector<SemanticToken> run() {
        for (const ShaderToken& token : o_.tokens)
            if (const auto made = mark(token)) found_.push_back(*made);
        for (const ShaderDirective& directive : o_.directives)
            if (directive.name_end > directive.name_begin)
                found_.push_back({{o_.file, directive.name_begin, directive.name_end}, Type::string, 0});
        for (const Span& comment : o_.comments) add_comment(o_.text, comment, found_);
        return std::move(found_);
    }

private:
    struct Look {
        Type type = Type::variable;
        std::uint8_t modifiers = 0;
    };

    static Look look_of(const ShaderDeclaration& declaration) {
        const Kind kind = declaration.kind;
        // In the order of ShaderDeclaration::Kind.
        constexpr std::array types{Type::variable, Type::variable, Type::variable,  Type::variable,
                                   Type::variable, Type::variable, Type::parameter, Type::function,
                                   Type::type,     Type::property, Type::type,      Type::macro};
        const bool fixed = kind == Kind::uniform || kind == Kind::constant;
        return {types[static_cast<std::size_t>(kind)], static_cast<std::uint8_t>(fixed ? SemanticToken::readonly : 0)};
    }

    Look look_global(std::string_view name) {
        const auto known = looks_.find(name);
        if (known != looks_.end()) return known->second;
        const std::vector<DeclaredPlace> declared = declarations(texts_, o_.file, name);
        const Look look = declared.empty() ? look_of_language(name) : look_of(*declared.front().declaration);
        return looks_.emplace(name, look).first->second;
    }

    Look look_of_language(std::string_view name) const {
        if (name.starts_with("gl_")) return {Type::variable, SemanticToken::built_in};
        if (!glsl::builtin_signatures(name).empty() || !glsl::modern_texture_function(name).empty())
            return {Type::function, SemanticToken::built_in};
        for (const std::string_view ladder : ladders_)
            if (name.starts_with(ladder)) return {Type::macro, SemanticToken::built_in};
        return {};
    }

    std::optional<SemanticToken> mark(const ShaderToken& token) {
        const auto made = [&](Look look) {
            const auto modifiers =
                static_cast<std::uint8_t>(look.modifiers | (token.declares ? SemanticToken::declaration : 0));
            return SemanticToken{o_.span(token), look.type, modifiers};
        };
        if (token.kind == glsl::Kind::integer || token.kind == glsl::Kind::real) return made({Type::number, 0});
        if (token.kind != glsl::Kind::identifier) return std::nullopt;
        const std::string_view word = o_.word(token);
        switch (token.role) {
            case ShaderToken::Role::directive:
                return made({Type::macro, 0});
            case ShaderToken::Role::word:
                return made({glsl::builtin_type(word) ? Type::type : Type::keyword, 0});
            case ShaderToken::Role::member:
                return made({Type::property, 0});
            case ShaderToken::Role::local:
                return made(look_of(o_.declaration(token)));
            case ShaderToken::Role::global:
                return made(look_global(word));
            default:
                return std::nullopt;
        }
    }

    Texts& texts_;
    const Outline& o_;
    std::vector<std::string_view> ladders_;
    std::unordered_map<std::string_view, Look> looks_;
    std::vector<SemanticToken> found_;
};

}  // namespace

std::vector<SemanticToken> semantic_tokens(const Project& project, FileId file) {
    Texts texts(project);
    std::vector<SemanticToken> found =
        texts.is_scene(file) ? SceneTokens(texts.statements(file)).run() : ShaderTokens(texts, file).run();
    std::stable_sort(found.begin(), found.end(),
                     [](const SemanticToken& a, const SemanticToken& b) { return a.span.begin < b.span.begin; });
    // Overlaps would shift everything behind them in the encoding.
    std::uint32_t end = 0;
    std::erase_if(found, [&](const SemanticToken& token) {
        const bool overlaps = token.span.begin < end || token.span.begin == token.span.end;
        if (!overlaps) end = token.span.end;
        return overlaps;
    });
    return found;
}

}  // namespace snell::language
