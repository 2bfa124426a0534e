// What the words of a shader mean.
#include <fmt/format.h>

#include <array>

#include "src/language/offers/members.h"
#include "src/language/offers/offers.h"
#include "src/language/shader/builtins.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using What = Named::What;

std::string function_text(std::string_view name) {
    const FunctionDoc* doc = function_doc(name);
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

}  // namespace snell::language
