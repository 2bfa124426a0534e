// What the words of a scene mean.
#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/language/offers/offers.h"

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

}  // namespace snell::language
