// Completion in scenes.
#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/language/offers/offers.h"
#include "src/plan/locate.h"

namespace snell::language {

namespace {

// ---- commands

std::string placeholder(const Parameter& p, int number) {
    if (p.kind == ArgumentKind::choice) {
        std::string choices(p.choices);
        std::replace(choices.begin(), choices.end(), '/', ',');
        return fmt::format("${{{}|{}|}}", number, choices);
    }
    const std::string_view value = p.default_text.empty() ? p.name : p.default_text;
    if (p.kind == ArgumentKind::vec3) return fmt::format("[${{{}:{}}}]", number, "0. 0. 0.");
    return fmt::format("${{{}:{}}}", number, value);
}

std::string snippet(const Command& command, std::size_t alternative) {
    std::string text(command.name);
    if (command.name == "Program") return "Program ${1:Name}  $0";
    if (command.name == "glBegin")
        return fmt::format("glBegin ${{1|{}|}}\n$0\nglEnd", fmt::join(topology_names(), ","));
    if (command.name == "PushMatrix") return "PushMatrix\n$0\nPopMatrix";
    int number = 1;
    for (std::size_t i = 0; i < command.signature.parameter_count(alternative); ++i) {
        const Parameter& p = command.signature.parameter(alternative, i);
        if (p.is_keyword()) continue;
        text += " " + (p.kind == ArgumentKind::rest ? fmt::format("${{{}}}", number) : placeholder(p, number));
        ++number;
    }
    return text;
}

std::vector<Completion> command_completions(Span replaced) {
    std::vector<Completion> found;
    for (const Command& command : commands())
        for (std::size_t i = 0; i < command.signature.count; ++i) {
            if (command.signature.count > 1 && command.signature.parameter_count(i) == 0) continue;
            Completion& one = add_offer(found, command.name, Completion::Kind::command, replaced,
                                        command_signature(command, i).label, command_text(command));
            one.text = snippet(command, i);
            one.snippet = true;
            one.rank = 1 + static_cast<int>(i);
        }
    return found;
}

// ---- arguments

class ArgumentOffers {
public:
    ArgumentOffers(Texts& texts, const Statements& s, const SceneStatement& statement, Span replaced, std::size_t index)
        : texts_(texts), s_(s), statement_(statement), replaced_(replaced), index_(index) {}

    std::vector<Completion> run(const Token* token, std::uint32_t offset) {
        const std::string_view name = statement_.command->name;
        const bool text = token != nullptr && token->kind == TokenKind::text;
        if (!text && name == "Program") return program();
        if (!text && name == "Ladder") return ladder();
        std::set<std::string_view> done;
        for (const ArgumentPlace& place : arguments_at(s_, statement_, index_)) {
            if (place.parameter == nullptr) continue;
            // An optional word may be left out, so that what comes behind it is there already.
            offer(*place.parameter, text, token, offset);
            const std::size_t count = statement_.command->signature.parameter_count(place.alternative);
            if (place.parameter->is_keyword() && place.index + 1 < count)
                offer(statement_.command->signature.parameter(place.alternative, place.index + 1), text, token, offset);
        }
        ranges::stable_sort(found_, [](const Completion& a, const Completion& b) { return a.label < b.label; });
        found_.erase(std::unique(found_.begin(), found_.end(),
                                 [](const Completion& a, const Completion& b) { return a.label == b.label; }),
                     found_.end());
        return std::move(found_);
    }

private:
    const Scene& scene() const { return texts_.project.scene(); }

    Completion& add(std::string_view label, Completion::Kind kind, std::string detail = {}) {
        return add_offer(found_, label, kind, replaced_, std::move(detail));
    }

    void offer(const Parameter& parameter, bool text, const Token* token, std::uint32_t offset) {
        if (parameter.kind == ArgumentKind::path) return files(token, offset);
        if (text) return;
        if (parameter.kind == ArgumentKind::choice)
            for (const std::string_view choice : split(parameter.choices, '/'))
                add(choice, Completion::Kind::choice, choice == parameter.default_text ? "default" : "");
        if (parameter.kind == ArgumentKind::name && statement_.command->name == "glBegin")
            for (const std::string_view topology : topology_names()) add(topology, Completion::Kind::choice);
        if (parameter.kind == ArgumentKind::integer) units(parameter.name);
    }

    // The units of textures that the statement can use, or the next free one.
    void units(std::string_view parameter) {
        const std::string_view command = statement_.command->name;
        const bool reads = parameter == "from", targets = command.starts_with("RenderTo");
        if (parameter != "unit" && parameter != "units" && !reads) return;
        int free = 4;  // 0 to 3 are those of glman's own textures
        for (const Texture& texture : scene().textures) free = std::max(free, texture.unit + 1);
        if (!reads && !targets) {
            add(std::to_string(free), Completion::Kind::number, "the next unit that no texture has");
            return;
        }
        for (const Texture& texture : scene().textures) {
            const bool cube = texture.target == TextureTarget::cube;
            const bool empty = texture.files.empty() && texture.computed == Computed::no;
            const bool fits =
                reads ? cube && texture.computed == Computed::no : empty && cube == (command == "RenderToCube");
            const std::string unit = std::to_string(texture.unit);
            if (fits && ranges::find(found_, unit, &Completion::label) == found_.end())
                add(unit, Completion::Kind::number, cube ? "cube map" : "texture");
        }
    }

    std::vector<std::string_view> extensions() const {
        const std::string_view name = statement_.command->name;
        constexpr std::array<std::string_view, stage_count> stages{"Vertex", "TessControl", "TessEvaluation",
                                                                   "Geometry", "Fragment"};
        const auto stage = ranges::find(stages, name);
        if (stage != stages.end()) return stage_extensions(static_cast<Stage>(stage - stages.begin()));
        if (name == "Include") return scene_extensions();
        if (name == "Shp") return {"shp"};
        if (contains(name, "obj")) return {"obj"};
        return image_extensions();
    }

    void files(const Token* token, std::uint32_t offset) {
        const std::string_view written =
            token == nullptr ? std::string_view() : s_.text.substr(token->begin, offset - token->begin);
        const std::vector<std::string_view> wanted = extensions();
        const bool closed = token != nullptr && token->kind == TokenKind::text && !token->unclosed;
        for (Completion& one : file_completions(texts_.project.path_of(s_.file), written, replaced_, wanted,
                                                closed ? Quotes::closed : Quotes::added))
            found_.push_back(std::move(one));
    }

    // ---- programs

    std::vector<Completion> program() {
        const UniformPlace place = uniform_at(s_, statement_, index_);
        const Index index = program_at(texts_, s_.file, s_.span(statement_).begin);
        if (place.part == UniformPlace::Part::program || index == none) return {};
        const std::vector<UniformFact> declared = declared_uniforms(texts_, index);
        if (place.part == UniformPlace::Part::value) {
            const auto fact = ranges::find(declared, place.name, &UniformFact::name);
            value(place, fact == declared.end() ? nullptr : &*fact);
        } else {
            for (const UniformFact& fact : declared)
                if (!is_set(index, fact.name)) uniform(fact);
        }
        return std::move(found_);
    }

    // The uniform under the cursor is not one that is set already.
    bool is_set(Index index, std::string_view name) const {
        const auto elsewhere = [&](const Span& span) {
            return span.file != replaced_.file || span.begin != replaced_.begin;
        };
        for (const UniformValue& value : scene().programs[index].uniforms)
            if (base_name(value.name) == name && elsewhere(texts_.first(value.name_span))) return true;
        return ranges::any_of(written_uniforms(s_, statement_),
                              [&](const WrittenUniform& one) { return one.name == name && elsewhere(one.name_span); });
    }

    void uniform(const UniformFact& fact) {
        const ProposedValue proposed = proposed_value(scene(), fact);
        Completion& one = add(fact.name, Completion::Kind::uniform, fmt::format("{} {}", fact.type, proposed.text()));
        int number = 1;
        one.text = fmt::format("{} {}", fact.name, proposed.snippet(number));
        one.snippet = true;
        one.documentation = uniform_text(texts_, fact);
    }

    void value(const UniformPlace& place, const UniformFact* fact) {
        const bool truth = fact != nullptr && fact->type == "bool";
        if (place.bracket == '<' && truth && place.number == 0) {
            add("true", Completion::Kind::choice);
            add("false", Completion::Kind::choice);
        }
        if (place.bracket != 0 || place.number != 0 || fact == nullptr) return;
        if (truth) {
            add("<true>", Completion::Kind::choice);
            add("<false>", Completion::Kind::choice);
            return;
        }
        const ProposedValue proposed = proposed_value(scene(), *fact);
        for (const std::string& choice : proposed.choices) add(choice, Completion::Kind::number, "texture unit");
        if (!proposed.choices.empty()) return;
        int number = 1;
        Completion& one = add(proposed.text(), Completion::Kind::number, std::string(fact->type));
        one.text = proposed.snippet(number);
        one.snippet = true;
        one.documentation = uniform_text(texts_, *fact);
    }

    // ---- ladders: shaders compare LADDER with LADDER_rung

    std::vector<Completion> ladder() {
        std::set<std::string> names;
        for (const Shader& shader : texts_.project.shaders) {
            if (shader.path.empty()) continue;
            const Outline& outline = texts_.outline(shader.file);
            for (const auto& [word, uses] : outline.globals) {
                const std::size_t line = word.find('_');
                if (line == std::string_view::npos || line + 1 >= word.size()) continue;
                const std::string_view name = word.substr(0, line);
                const bool asked = ranges::any_of(outline.uses(name), [&](std::uint32_t at) {
                    return outline.tokens[at].in_directive && !outline.tokens[at].declares;
                });
                if (!asked || !outline.tokens[uses.front()].in_directive) continue;
                if (index_ == 1)
                    names.emplace(name);
                else if (name == written_ladder())
                    names.emplace(word.substr(line + 1));
            }
        }
        for (const std::string& name : names) {
            if (name == "VALUE" || taken(name)) continue;
            add(name, Completion::Kind::choice, index_ == 1 ? "shaders compare it" : "rung that shaders know");
        }
        return std::move(found_);
    }
    std::string_view written_ladder() const {
        return statement_.count > 1 ? s_.word(s_.tokens[statement_.first + 1]) : std::string_view();
    }
    bool taken(std::string_view name) const {
        if (index_ == 1)
            return ranges::any_of(scene().ladders, [&](const Ladder& ladder) {
                return ladder.name == name && !(texts_.first(ladder.name_span).begin == replaced_.begin);
            });
        return ranges::any_of(s_.tokens_of(statement_), [&](const Token& token) {
            return token.begin != replaced_.begin && s_.word(token) == name;
        });
    }

    Texts& texts_;
    const Statements& s_;
    const SceneStatement& statement_;
    Span replaced_;
    std::size_t index_;
    std::vector<Completion> found_;
};

}  // namespace

std::vector<Completion> scene_completions(Texts& texts, FileId file, std::uint32_t offset) {
    const Statements& s = texts.statements(file);
    if (s.in_comment(offset)) return {};
    // The word that is being written.
    const Token* token = s.at(offset);
    if (token != nullptr && (token->begin >= offset || token->kind == TokenKind::open ||
                             token->kind == TokenKind::close || token->kind == TokenKind::comma))
        token = nullptr;
    if (token != nullptr && token->kind == TokenKind::text && token->end == offset && !token->unclosed) return {};
    Span replaced = token != nullptr ? s.span(*token) : Span{file, offset, offset};
    if (token != nullptr && token->kind == TokenKind::text && !token->unclosed)
        replaced.end = std::max(offset, replaced.end - 1);
    const SceneStatement* statement = s.at_statement(offset);
    if (statement == nullptr) return command_completions(replaced);
    const std::span<const Token> tokens = s.tokens_of(*statement);
    const auto index = static_cast<std::size_t>(
        std::find_if(tokens.begin(), tokens.end(),
                     [&](const Token& t) { return token != nullptr ? &t == token : t.begin >= offset; }) -
        tokens.begin());
    if (index == 0)
        return token == nullptr || token->kind == TokenKind::word ? command_completions(replaced)
                                                                  : std::vector<Completion>();
    if (statement->command == nullptr) return {};
    return ArgumentOffers(texts, s, *statement, replaced, index).run(token, offset);
}

// The files that an argument may name, as they are on disk.

namespace {

constexpr std::size_t most_entries = 5000;

// Whether a scene writes the name in quotes, so that it is not several words.
bool needs_quotes(const std::string& name) {
    return name.find_first_of(" \t#;,<>[]{}\"") != std::string::npos || name.find("//") != std::string::npos;
}

}  // namespace

std::vector<Completion> file_completions(std::string_view path, std::string_view written, Span replaced,
                                         std::span<const std::string_view> extensions, Quotes quotes) {
    namespace fs = std::filesystem;
    std::vector<Completion> found;
    const bool quoted = written.starts_with('"');
    if (quoted) written.remove_prefix(1);
    const std::size_t slash = written.find_last_of("/\\");
    const std::string_view parent = slash == std::string_view::npos ? "" : written.substr(0, slash + 1);
    std::string prefix(parent);
    std::replace(prefix.begin(), prefix.end(), '\\', '/');
    std::error_code error;
    fs::directory_iterator at("." / fs::path(path).parent_path() / prefix, error);
    if (error) return found;
    std::size_t count = 0;
    for (; at != fs::directory_iterator() && count < most_entries; at.increment(error), ++count) {
        if (error) break;
        const std::string name = at->path().filename().string();
        if (name.starts_with('.') || name.find('\n') != std::string::npos) continue;
        const bool is_folder = at->is_directory(error);
        const auto ends = [&](std::string_view extension) { return has_extension(name, extension); };
        if (!is_folder && ranges::none_of(extensions, ends)) continue;
        // The folders before it stay, so that editors compare its name with what is written of it.
        Completion& one = add_offer(found, is_folder ? name + "/" : name,
                                    is_folder ? Completion::Kind::folder : Completion::Kind::file, replaced, "");
        one.replaced.begin += static_cast<std::uint32_t>(parent.size() + (quoted ? 1 : 0));
        if (quoted && !is_folder && quotes == Quotes::added) one.text += '"';
        if (!quoted && quotes == Quotes::added && needs_quotes(one.label)) {
            one.replaced = replaced;
            one.text = "\"" + std::string(parent) + one.label + (is_folder ? "" : "\"");
        }
        one.rank = is_folder ? 2 : 1;
        one.more = is_folder;
    }
    return found;
}

// The rows of the table of commands as text for editors.

Signature command_signature(const Command& command, std::size_t alternative) {
    Signature made{std::string(command.name), {}, {}};
    for (std::size_t i = 0; i < command.signature.parameter_count(alternative); ++i) {
        const Parameter& p = command.signature.parameter(alternative, i);
        const bool bare = p.optional && p.default_text.empty() && !p.repeated && p.kind != ArgumentKind::uniforms;
        std::string one(p.kind == ArgumentKind::vec3 ? fmt::format("[{}]", p.name) : std::string(p.name));
        if (p.kind == ArgumentKind::choice) one = p.choices;
        if (p.kind == ArgumentKind::uniforms) one = "uniform value …";
        if (!p.default_text.empty()) one += fmt::format("={}", p.default_text);
        if (p.repeated) one += " …";
        made.label += ' ';
        const auto begin = static_cast<std::uint32_t>(made.label.size());
        made.label += bare ? fmt::format("[{}]", one) : one;
        made.parameters.emplace_back(begin, static_cast<std::uint32_t>(made.label.size()));
    }
    return made;
}

std::string parameter_text(const Parameter& parameter) {
    constexpr std::string_view kinds[] = {
        "number", "whole number", "file", "name", "", "three numbers in brackets", "uniforms and their values",
        "words"};
    const std::string text = parameter.kind == ArgumentKind::choice
                                 ? fmt::format("{}", fmt::join(split(parameter.choices, '/'), ", "))
                                 : std::string(kinds[static_cast<std::size_t>(parameter.kind)]);
    if (!parameter.default_text.empty()) return text + "; default: " + std::string(parameter.default_text);
    if (parameter.repeated) return text + "; any number of them";
    return parameter.optional ? text + "; may be left out" : text;
}

std::string command_text(const Command& command) {
    std::string text = "```\n";
    for (std::size_t i = 0; i < command.signature.count; ++i) text += command_signature(command, i).label + "\n";
    text += "```\n" + std::string(command.doc);
    if (!command.alias.empty()) text += fmt::format("\n\n`{}` means the same.", command.alias);
    if (command.addition) text += "\n\nglman does not know this command.";
    return text;
}

std::string place_text(Texts& texts, FileId file, std::uint32_t offset) {
    std::string_view name = texts.project.sources.name(file);
    if (const std::size_t slash = name.find_last_of('/');
        slash != std::string_view::npos && !texts.project.path_of(file).empty())
        name.remove_prefix(slash + 1);
    return fmt::format("{}:{}", name, texts.project.sources.position(file, offset).line);
}

}  // namespace snell::language
