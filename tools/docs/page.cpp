// web/page/editor/words.json: what the page's editor highlights and completes.
#include <algorithm>
#include <set>

#include "parser/commands/commands.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/glsl/glsl.h"
#include "src/language/shader/builtins.h"
#include "tools/docs/generate.h"

namespace snell::docs {

std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

namespace {

// A few entries a line: these lists seldom change.
std::string rows(std::vector<std::string_view> words) {
    std::sort(words.begin(), words.end());
    std::string out;
    std::size_t width = 0;
    for (const std::string_view word : words) {
        const std::string entry = json_text(word);
        const bool full = out.empty() || width + entry.size() > 110;
        out += (out.empty() ? "" : ",") + std::string(full ? "\n" : " ") + entry;
        width = (full ? 0 : width) + entry.size() + 2;
    }
    return "[" + out + "\n]";
}

// One entry a line, so that a change of the table is a short difference.
std::string lines(const std::vector<std::string>& entries) {
    std::string out;
    for (const std::string& entry : entries) out += (out.empty() ? "\n" : ",\n") + entry;
    return "[" + out + "\n]";
}

std::vector<std::string> command_entries() {
    std::vector<std::string> out;
    for (const Command& c : commands()) {
        std::string entry = "{\"name\": " + json_text(c.name);
        if (!c.alias.empty()) entry += ", \"alias\": " + json_text(c.alias);
        out.push_back(entry + ", \"signature\": " + json_text(c.signature.text) + ", \"doc\": " + json_text(c.doc) +
                      "}");
    }
    return out;
}

std::string choice_rows() {
    std::set<std::string_view> words;
    for (const Command& c : commands())
        for (const Parameter& p : c.signature.parameters)
            for (const std::string_view word : split(p.choices, '/')) words.insert(word);
    for (const std::string_view name : topology_names()) words.insert(name);
    return rows({words.begin(), words.end()});
}

template <typename Facts>
std::string variable(std::string_view name, const Facts& facts) {
    return "{\"name\": " + json_text(name) + ", \"type\": " + json_text(facts.type) +
           ", \"doc\": " + json_text(facts.doc) + "}";
}

std::vector<std::string> variable_entries() {
    std::vector<std::string> out;
    for (const glsl::SystemFacts& facts : glsl::system_facts())
        for (const glsl::SystemName& name : glsl::system_names())
            if (name.system == facts.system && !written(name.name).empty())
                out.push_back(variable(written(name.name), facts));
    for (const glsl::AttributeFacts& facts : glsl::attribute_facts())
        for (const glsl::AttributeName& name : glsl::attribute_names())
            if (name.attribute == facts.attribute && !written(name.name).empty())
                out.push_back(variable(written(name.name), facts));
    return out;
}

}  // namespace

std::string page_words() {
    return "{\"commands\": " + lines(command_entries()) + ",\n\"choices\": " + choice_rows() +
           ",\n\"variables\": " + lines(variable_entries()) + ",\n\"keywords\": " + rows(language::keywords()) +
           ",\n\"types\": " + rows(language::type_names()) +
           ",\n\"functions\": " + rows(language::function_names(true)) + "}\n";
}

}  // namespace snell::docs
