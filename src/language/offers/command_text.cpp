// The rows of the table of commands as text for editors.
#include <fmt/format.h>

#include "parser/text/words.h"
#include "src/language/offers/offers.h"

namespace snell::language {

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
