// What the words of a scene and of a shader mean, and the parameters of what is being written.
#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/language/offers/offers.h"
#include "src/language/shader/builtins.h"

namespace snell::language {

namespace {

using What = Named::What;

std::string rung_text(const Ladder& ladder, std::optional<std::size_t> rung) {
    if (!rung) return ladder_text(ladder);
    return fmt::format("{0}\n\nShaders know this rung as `{1}_{2}`: `#if {1} == {1}_{2}`.", ladder_text(ladder),
                       ladder.name, ladder.rungs[*rung]);
}

class SceneHover {
public:
    SceneHover(Texts& texts, FileId file, std::uint32_t offset)
        : texts_(texts), s_(texts.statements(file)), file_(file), offset_(offset) {}

    std::optional<Hover> run() {
        const Token* token = s_.at(offset_);
        const SceneStatement* statement = s_.at_statement(offset_);
        if (token == nullptr || statement == nullptr || s_.in_comment(offset_)) return std::nullopt;
        const Named named = named_at(texts_, file_, offset_);
        switch (named.what) {
            case What::uniform:
                return uniform(named);
            case What::ladder:
                return Hover{named.span, rung_text(texts_.project.scene().ladders[named.ladder], named.rung)};
            case What::file:
                return file(named, *statement, *token);
            default:
                break;
        }
        const auto index = static_cast<std::size_t>(token - s_.tokens_of(*statement).data());
        if (statement->command == nullptr) return std::nullopt;
        if (index == 0) {
            return Hover{s_.span(*token), command_text(*statement->command),
                         fmt::format("images/{}.png", statement->command->name)};
        }
        if (token->kind != TokenKind::word) return std::nullopt;
        if (statement->command->name == "Program") return value(*statement, *token, index);
        return argument(*statement, *token, index);
    }

private:
    std::optional<Hover> argument(const SceneStatement& statement, const Token& token, std::size_t index) const {
        const ArgumentPlace place = argument_at(s_, statement, index);
        const Command& command = *statement.command;
        if (place.parameter == nullptr)
            return Hover{s_.span(token), fmt::format("`{}` has no such argument: it is ignored.", command.name)};
        std::string text =
            fmt::format("**{}** of `{}`: {}.", place.parameter->name, command.name, parameter_text(*place.parameter));
        if (place.bracketed && place.component < 3)
            text = fmt::format("{} of **{}** of `{}`.", "xyz"[place.component], place.parameter->name, command.name);
        return Hover{s_.span(token), text + "\n\n" + std::string(command.doc)};
    }

    std::optional<Hover> value(const SceneStatement& statement, const Token& token, std::size_t index) {
        const UniformPlace place = uniform_at(s_, statement, index);
        if (place.part == UniformPlace::Part::program)
            return Hover{s_.span(token), fmt::format("Name of the program. {}", statement.command->doc)};
        if (place.part != UniformPlace::Part::value) return std::nullopt;
        constexpr std::string_view range[] = {"Minimum", "Current value", "Maximum"};
        constexpr std::string_view color[] = {"Red", "Green", "Blue", "Alpha"};
        std::string_view part = "Value";
        if (place.bracket == '<' && place.number < 3 && !truth(token)) part = range[place.number];
        if (place.bracket == '{' && place.number < 4) part = color[place.number];
        return Hover{s_.span(token), fmt::format("{} of `{}`.", part, place.name)};
    }
    bool truth(const Token& token) const {
        return same_word(s_.word(token), "true") || same_word(s_.word(token), "false");
    }

    std::optional<Hover> uniform(const Named& named) {
        std::string text;
        const std::vector<UniformFact> declared = declared_uniforms(texts_, named.program);
        const auto fact = ranges::find(declared, named.name, &UniformFact::name);
        if (fact != declared.end()) {
            text = uniform_text(texts_, *fact);
        } else {
            text = fmt::format("`{}`: no shader of this program declares it.", named.name);
        }
        const std::string set = where_set(texts_, named.name, linked(texts_, named).programs);
        return Hover{named.span, set.empty() ? text : text + "\n\n" + set};
    }

    std::optional<Hover> file(const Named& named, const SceneStatement& statement, const Token& token) const {
        const auto index = static_cast<std::size_t>(&token - s_.tokens_of(statement).data());
        const ArgumentPlace place = argument_at(s_, statement, index);
        std::string text = fmt::format("**{}** of `{}`", place.parameter->name, statement.command->name);
        const bool known = ranges::any_of(texts_.project.diagnostics.items(), [&](const Diagnostic& d) {
            return d.code == "file-not-found" && texts_.first(d.span) == named.span;
        });
        text += known ? ": there is no such file." : ".";
        return Hover{named.span, text + "\n\n" + std::string(statement.command->doc), preview(named)};
    }

    // The file itself, if it is a picture that editors show.
    std::string preview(const Named& named) const {
        constexpr std::array<std::string_view, 5> shown{".png", ".jpg", ".jpeg", ".bmp", ".gif"};
        constexpr std::uintmax_t most = 8 << 20;  // bytes
        const Project& project = texts_.project;
        if (project.files == nullptr) return {};
        const std::filesystem::path path =
            project.files->resolve_beside(project.path_of(named.span.file), named.name).path;
        const std::string extension = path.extension().string();
        std::error_code none;
        const bool fits = ranges::any_of(shown, [&](std::string_view one) { return same_word(one, extension); }) &&
                          std::filesystem::file_size(path, none) <= most;
        return fits ? std::filesystem::absolute(path, none).lexically_normal().string() : "";
    }

    Texts& texts_;
    const Statements& s_;
    FileId file_;
    std::uint32_t offset_;
};

}  // namespace

std::string ladder_text(const Ladder& ladder) {
    std::string text = fmt::format("Ladder **{}**, from cheap to exact:", ladder.name);
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i)
        text += i == ladder.current ? fmt::format(" **<{}>**", ladder.rungs[i]) : " " + ladder.rungs[i];
    return text;
}

std::string uniform_text(Texts& texts, const UniformFact& fact) {
    std::string text = fmt::format("```glsl\nuniform {} {}\n```\nDeclared at {}.", fact.type, fact.name,
                                   place_text(texts, fact.file, fact.offset));
    if (!fact.initial.empty()) text += fmt::format(" Its default is `{}`.", fact.initial);
    if (!fact.comment.empty()) text += "\n\n" + fact.comment;
    return text;
}

std::string where_set(Texts& texts, std::string_view uniform, const std::vector<Index>& programs) {
    std::string text;
    const Scene& scene = texts.project.scene();
    for (const Index index : programs) {
        if (index >= scene.programs.size()) continue;
        for (const UniformValue& value : scene.programs[index].uniforms) {
            if (base_name(value.name) != uniform) continue;
            const std::string_view source = texts.project.sources.text(value.span.file);
            std::string written(source.substr(value.name_span.end, value.span.end - value.name_span.end));
            for (char& c : written)
                if (c == '\n' || c == '\r' || c == '\t' || c == '\\') c = ' ';
            text += fmt::format("{}Program '{}' sets it at {}: `{}`", text.empty() ? "" : "  \n",
                                scene.programs[index].name, place_text(texts, value.span.file, value.span.begin),
                                written.substr(std::min(written.find_first_not_of(' '), written.size())));
        }
    }
    return text;
}

std::optional<Hover> scene_hover(Texts& texts, FileId file, std::uint32_t offset) {
    return SceneHover(texts, file, offset).run();
}

// Shaders.

namespace {

using Kind = ShaderDeclaration::Kind;

std::string function_text(std::string_view name) {
    const glsl::BuiltinFunction* doc = function_doc(name);
    if (doc == nullptr) return {};
    std::string text = "```glsl\n";
    bool generic = false;
    for (const std::string& signature : function_signatures(name)) {
        text += signature + "\n";
        generic = generic || signature.find("gen") != std::string::npos;
    }
    text += "```\n" + std::string(doc->doc);
    if (doc->name != name) text += fmt::format("\n\nToday it is called `{}`.", doc->name);
    return generic ? text + "\n\n" + std::string(generic_types) : text;
}

class ShaderHover {
public:
    ShaderHover(Texts& texts, FileId file, std::uint32_t offset)
        : texts_(texts), o_(texts.outline(file)), file_(file), offset_(offset) {
        if (const auto uses = texts.uses(file); !uses.empty()) stage_ = uses.front().stage;
    }

    std::optional<Hover> run() {
        if (o_.in_comment(offset_)) return std::nullopt;
        const Named named = named_at(texts_, file_, offset_);
        std::string text;
        switch (named.what) {
            case What::local:
                text = code(declaration_text(o_, o_.declarations[static_cast<std::size_t>(named.declaration)]));
                break;
            case What::member:
                text = member(named);
                break;
            case What::global:
                text = global(named);
                break;
            case What::ladder:
                text = ladder_text(texts_.project.scene().ladders[named.ladder]);
                break;
            case What::language:
                text = language(named.name);
                break;
            case What::file:
                if (const auto source = named_file(texts_, named))
                    text = fmt::format("{}", texts_.project.sources.name(*source));
                break;
            default:
                break;
        }
        if (text.empty()) return std::nullopt;
        return Hover{named.span, std::move(text)};
    }

private:
    static std::string code(std::string_view text) { return fmt::format("```glsl\n{}\n```", text); }

    std::string language(std::string_view name) const {
        if (std::string text = function_text(name); !text.empty()) return text;
        const VariableDoc* doc = variable_doc(stage_, name);
        if (doc == nullptr) return {};
        return code(fmt::format("{} {}", doc->type, doc->name)) + "\n" + doc->doc;
    }

    std::string member(const Named& named) {
        const std::size_t token = o_.before(named.span.begin);
        const std::string type = type_of_name(texts_, file_, token, stage_);
        return type.empty() ? std::string() : code(fmt::format("{} {}", type, named.name));
    }

    std::string global(const Named& named) {
        std::string text;
        bool uniform = false, input = false;
        for (const DeclaredPlace& place : declarations(texts_, file_, named.name)) {
            const Outline& outline = texts_.outline(place.file);
            const ShaderDeclaration& d = *place.declaration;
            if (d.kind == Kind::function && !d.body && !text.empty()) continue;
            uniform = uniform || d.kind == Kind::uniform;
            input = input || d.kind == Kind::input;
            text += (text.empty() ? "" : "\n\n") + code(declaration_text(outline, d)) + "\n" +
                    fmt::format("Declared at {}.", place_text(texts_, place.file, outline.tokens[d.token].begin));
            if (const std::string comment = comment_of(outline, d.begin, d.end); !comment.empty())
                text += "\n\n" + comment;
        }
        const std::string set = where_set(texts_, named.name, linked(texts_, named).programs);
        if (!set.empty()) text += (text.empty() ? "" : "\n\n") + set;
        if (text.empty()) return language(named.name);
        const VariableDoc* doc = variable_doc(stage_, named.name);
        if (doc != nullptr && set.empty() &&
            ((uniform && doc->qualifier == "uniform") || (input && doc->qualifier == "in")))
            text += "\n\nsnell sets it: " + doc->doc;
        return text;
    }

    Texts& texts_;
    const Outline& o_;
    FileId file_;
    std::uint32_t offset_;
    Stage stage_ = Stage::fragment;
};

}  // namespace

std::string declaration_text(const Outline& outline, const ShaderDeclaration& d) {
    const auto between = [&](std::uint32_t begin, std::uint32_t end) {
        return outline.text.substr(begin, end > begin ? end - begin : 0);
    };
    constexpr std::size_t most = 160;
    // In the order of Kind.
    constexpr std::array<std::string_view, 9> words{"uniform ", "in ", "out ", "varying ", "",
                                                    "const ",   "",    "",     "struct "};
    if (d.kind == Kind::function)
        return fmt::format("{} {}({})", d.type, d.name, between(d.parameters_begin, d.parameters_end).substr(0, most));
    if (d.kind == Kind::macro) return std::string(between(d.begin, d.end).substr(0, most));
    const auto kind = static_cast<std::size_t>(d.kind);
    return fmt::format("{}{}{}{}", kind < words.size() ? words[kind] : "", d.type, d.type.empty() ? "" : " ", d.name);
}

std::optional<Hover> shader_hover(Texts& texts, FileId file, std::uint32_t offset) {
    return ShaderHover(texts, file, offset).run();
}

// The parameters of what is being written.

namespace {

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
        const glsl::BuiltinFunction* doc = function_doc(name);
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
