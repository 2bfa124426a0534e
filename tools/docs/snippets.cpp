// editors/vscode/snippets.json: a snippet for each command, with its arguments as places to fill in.
#include <algorithm>

#include "parser/commands/commands.h"
#include "parser/text/words.h"
#include "tools/docs/generate.h"

namespace snell::docs {
namespace {

// Of several, the one that names files: it is what people write.
std::size_t chosen_alternative(const Signature& signature) {
    std::size_t longest = 0;
    for (std::size_t a = 0; a < signature.count; ++a) {
        for (std::size_t i = 0; i < signature.parameter_count(a); ++i)
            if (signature.parameter(a, i).kind == ArgumentKind::path) return a;
        if (signature.parameter_count(longest) == 0) longest = a;
    }
    return longest;
}

std::string placeholder(const Parameter& p, const std::string& number) {
    const auto place = [&](std::string_view text) { return "${" + number + ":" + std::string(text) + "}"; };
    switch (p.kind) {
        case ArgumentKind::choice: {
            std::string choices(p.choices);
            std::replace(choices.begin(), choices.end(), '/', ',');
            return "${" + number + "|" + choices + "|}";
        }
        case ArgumentKind::vec3:
            return "[" + place("0. 0. 0.") + "]";
        case ArgumentKind::uniforms:
            return place("uName <0. .5 1.>");
        default:
            return place(p.default_text.empty() ? p.name : p.default_text);
    }
}

// What may be left out and has no default is left out, but for names.
bool wanted(const Parameter& p) {
    const bool numeric = p.kind == ArgumentKind::number || p.kind == ArgumentKind::integer;
    return !p.optional || !p.default_text.empty() || p.repeated || !(numeric || p.is_keyword());
}

std::string_view end_of_block(std::string_view command) {
    if (command == "PushMatrix") return "PopMatrix";
    if (command == "glBegin") return "glEnd";
    return command.starts_with("RenderTo") ? "RenderToTexture" : "";
}

std::string body(const Command& command) {
    std::string line(command.name);
    const std::size_t alternative = chosen_alternative(command.signature);
    int number = 0;
    for (std::size_t i = 0; i < command.signature.parameter_count(alternative); ++i) {
        const Parameter& p = command.signature.parameter(alternative, i);
        if (wanted(p)) line += " " + placeholder(p, std::to_string(++number));
    }
    const std::string_view end = end_of_block(command.name);
    if (end.empty()) return json_text(line);
    return "[" + json_text(line) + ", \"\\t$0\", " + json_text(end) + "]";
}

}  // namespace

std::string snippets() {
    std::string out;
    for (const Command& c : commands())
        out += (out.empty() ? "{\n  " : ",\n  ") + json_text(c.name) + ": {\"prefix\": " + json_text(c.name) +
               ", \"body\": " + body(c) + ", \"description\": " + json_text(c.doc) + "}";
    return out + "\n}\n";
}

}  // namespace snell::docs
