// The parameters of what is being written.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/language/offers/offers.h"
#include "src/language/shader/builtins.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;

// A label whose parameters are between its parentheses.
Signature with_parameters(std::string label, std::string documentation) {
    Signature made{std::move(label), std::move(documentation), {}};
    const std::size_t open = made.label.find('(');
    if (open == std::string::npos) return made;
    std::size_t begin = open + 1;
    int depth = 0;
    for (std::size_t i = begin; i < made.label.size(); ++i) {
        const char c = made.label[i];
        if (c == '(') ++depth;
        const bool end = c == ')' && depth-- == 0;
        if (!end && !(c == ',' && depth == 0)) continue;
        while (begin < i && (made.label[begin] == ' ' || made.label[begin] == '\n')) ++begin;
        if (i > begin) made.parameters.emplace_back(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(i));
        begin = i + 1;
        if (end) break;
    }
    return made;
}

struct Call {
    const ShaderToken* name = nullptr;
    std::size_t parameter = 0;
};

// The call whose parentheses hold the offset.
Call call_at(const Outline& outline, std::uint32_t offset) {
    Call call;
    int depth = 0;
    for (std::size_t i = outline.before(offset); i-- > 0;) {
        const ShaderToken& token = outline.tokens[i];
        if (token.end > offset) continue;
        const std::string_view word = outline.word(token);
        if (word == ";" || word == "{" || word == "}" || token.role == ShaderToken::Role::directive) break;
        if (word == ")" || word == "]") ++depth;
        if (word == "," && depth == 0) ++call.parameter;
        if (word != "(" && word != "[") continue;
        if (depth-- > 0) continue;
        depth = 0;
        const bool called = word == "(" && i > 0 && outline.tokens[i - 1].kind == glsl::Kind::identifier &&
                            outline.tokens[i - 1].role == ShaderToken::Role::global;
        if (called) {
            call.name = &outline.tokens[i - 1];
            break;
        }
        call.parameter = 0;  // a group within the call, or an index
    }
    return call;
}

}  // namespace

std::optional<SignatureHelp> scene_signature(Texts& texts, FileId file, std::uint32_t offset) {
    const Statements& s = texts.statements(file);
    const SceneStatement* statement = s.at_statement(offset);
    if (statement == nullptr || statement->command == nullptr || s.in_comment(offset)) return std::nullopt;
    const std::span<const Token> tokens = s.tokens_of(*statement);
    if (offset <= tokens.front().end) return std::nullopt;
    const auto index = static_cast<std::size_t>(
        std::find_if(tokens.begin() + 1, tokens.end(), [&](const Token& token) { return token.end >= offset; }) -
        tokens.begin());
    SignatureHelp help;
    const Command& command = *statement->command;
    for (std::size_t i = 0; i < command.signature.count; ++i) {
        help.signatures.push_back(command_signature(command, i));
        help.signatures.back().documentation = command.doc;
    }
    const ArgumentPlace place = argument_at(s, *statement, index);
    help.signature = place.alternative;
    help.parameter = place.index;
    return help;
}

std::optional<SignatureHelp> shader_signature(Texts& texts, FileId file, std::uint32_t offset) {
    const Outline& outline = texts.outline(file);
    if (outline.in_comment(offset)) return std::nullopt;
    const Call call = call_at(outline, offset);
    if (call.name == nullptr || call.name->declares) return std::nullopt;
    const std::string_view name = outline.word(*call.name);
    SignatureHelp help;
    for (const DeclaredPlace& place : declarations(texts, file, name)) {
        const ShaderDeclaration& d = *place.declaration;
        const Outline& there = texts.outline(place.file);
        const bool macro = d.kind == Kind::macro && d.parameters_end > 0;
        if (d.kind != Kind::function && !macro) continue;
        std::string label = macro ? std::string(d.name) + std::string(d.type) : declaration_text(there, d);
        if (ranges::find(help.signatures, label, &Signature::label) == help.signatures.end())
            help.signatures.push_back(with_parameters(std::move(label), comment_of(there, d.begin, d.end)));
    }
    if (help.signatures.empty()) {
        const FunctionDoc* doc = function_doc(name);
        if (doc == nullptr) return std::nullopt;
        for (const std::string& label : function_signatures(name))
            help.signatures.push_back(with_parameters(label, std::string(doc->doc)));
    }
    if (help.signatures.empty()) return std::nullopt;
    help.parameter = call.parameter;
    const auto fits =
        ranges::find_if(help.signatures, [&](const Signature& one) { return one.parameters.size() > call.parameter; });
    if (fits != help.signatures.end()) help.signature = static_cast<std::size_t>(fits - help.signatures.begin());
    return help;
}

}  // namespace snell::language
