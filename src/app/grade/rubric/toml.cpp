// The only file that includes toml++, whose templates are slow to compile.
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <algorithm>

#include "src/app/grade/rubric/table.h"

namespace snell::app {

namespace {

class Tree {
public:
    Tree(FileId file, const Sources& sources) : file_(file), sources_(sources) {}

    Span span(const toml::source_region& at, std::size_t length = 0) const {
        Span span = sources_.line_span(file_, static_cast<int>(at.begin.line), static_cast<int>(at.begin.column));
        if (length > 0) span.end = span.begin + static_cast<std::uint32_t>(length);
        return span;
    }

    TomlValue value(const toml::node& node) const {
        using Kind = TomlValue::Kind;
        TomlValue value;
        value.span = span(node.source());
        if (node.source().end.line == node.source().begin.line && node.source().end.column > node.source().begin.column)
            value.span.end = value.span.begin + node.source().end.column - node.source().begin.column;
        if (const auto* text = node.as_string()) {
            value.kind = Kind::text;
            value.text = text->get();
        } else if (node.is_number()) {
            value.kind = Kind::number;
            value.number = node.value<double>().value_or(0);
        } else if (const auto* truth = node.as_boolean()) {
            value.kind = Kind::truth;
            value.truth = truth->get();
        } else if (const auto* list = node.as_array()) {
            value.kind = Kind::list;
            for (const toml::node& part : *list) value.list.push_back(this->value(part));
        } else if (const auto* table = node.as_table()) {
            value.kind = Kind::table;
            value.members = members(*table);
        }
        return value;
    }

    // toml++ sorts by name, but the order of a text is its author's.
    std::vector<TomlValue::Member> members(const toml::table& table) const {
        std::vector<TomlValue::Member> members;
        for (const auto& [key, node] : table)
            members.push_back({std::string(key.str()), span(key.source(), key.str().size()), value(node)});
        std::stable_sort(members.begin(), members.end(),
                         [](const auto& a, const auto& b) { return a.span.begin < b.span.begin; });
        return members;
    }

private:
    FileId file_;
    const Sources& sources_;
};

}  // namespace

std::optional<TomlValue> read_toml(FileId file, const Sources& sources, Diagnostics& diagnostics) {
    const Tree tree(file, sources);
    const toml::parse_result parsed = toml::parse(sources.text(file));
    if (!parsed) {
        diagnostics.error("rubric-syntax", tree.span(parsed.error().source()),
                          std::string(parsed.error().description()),
                          "a rubric is TOML: 'snell grade --new SCENE' writes one to start from");
        return std::nullopt;
    }
    TomlValue value = tree.value(parsed.table());
    value.span = sources.line_span(file, 1);
    return value;
}

}  // namespace snell::app
