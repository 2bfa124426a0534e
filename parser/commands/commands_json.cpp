#include <cstdio>

#include "parser/commands/commands.h"
#include "parser/names.h"
#include "parser/text/words.h"
#include "parser/text_of.h"

namespace snell {
namespace {

std::string json(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
            out += escape;
        } else {
            out += c;
        }
    }
    return out + "\"";
}

std::string_view kind(ArgumentKind kind) {
    constexpr std::string_view names[] = {"number", "int", "path", "name", "choice", "vec3", "uniforms", "rest"};
    return names[static_cast<std::size_t>(kind)];
}

std::string choices(std::string_view list) {
    std::string out;
    for (const std::string_view word : split(list, '/')) out += (out.empty() ? "[" : ", ") + json(word);
    return out + "]";
}

std::string argument(const Parameter& p) {
    std::string out = "{\"name\": " + json(p.name) + ", \"kind\": " + json(kind(p.kind));
    if (p.kind == ArgumentKind::choice) out += ", \"choices\": " + choices(p.choices);
    if (!p.default_text.empty()) {
        const bool number = p.kind == ArgumentKind::number || p.kind == ArgumentKind::integer;
        // JSON has no numbers that begin or end with a point.
        std::string value = number ? text_of::number(p.default_value) : json(p.default_text);
        if (value.ends_with('.')) value.pop_back();
        out += ", \"default\": " + value;
    }
    if (p.optional) out += ", \"optional\": true";
    if (p.repeated) out += ", \"repeated\": true";
    return out + "}";
}

std::string row(const Command& c) {
    std::string out = "  {\"name\": " + json(c.name) + ", \"group\": " + json(c.group);
    out += ", \"aliases\": [" + (c.alias.empty() ? "" : json(c.alias)) + "]";
    out += std::string(", \"addition\": ") + (c.addition ? "true" : "false");
    out +=
        ",\n   \"signature\": " + json(c.signature.text) + ",\n   \"doc\": " + json(c.doc) + ",\n   \"arguments\": [";
    for (std::size_t i = 0; i < c.signature.count; ++i) {
        out += i == 0 ? "[" : ", [";
        for (std::size_t j = 0; j < c.signature.parameter_count(i); ++j)
            out += (j == 0 ? "" : ", ") + argument(c.signature.parameter(i, j));
        out += "]";
    }
    return out + "]}";
}

}  // namespace

std::string commands_json() {
    std::string rows;
    for (const Command& c : commands()) rows += (rows.empty() ? "" : ",\n") + row(c);
    return "{\"schema\": 1, \"commands\": [\n" + rows + "\n]}";
}

}  // namespace snell
