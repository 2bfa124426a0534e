#include "src/app/grade/rubric/table.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell::app {

namespace {

using Kind = TomlValue::Kind;

std::string_view words_of(Kind kind) {
    constexpr std::array<std::string_view, 6> words{"a text in quotes",     "a number",
                                                    "true or false",        "a list in brackets",
                                                    "a table in braces {}", "something else"};
    return words[static_cast<std::size_t>(kind)];
}

}  // namespace

// Comparisons with NaN are false, so that it never fits.
const Allowed from_0{"a number from 0", [](double number) { return number >= 0; }};
const Allowed above_0{"a number more than 0 and at most 1000000",
                      [](double number) { return number > 0 && number <= 1e6; }};
const Allowed seconds_above_0{"a number of seconds, more than 0 and at most 1000000",
                              [](double number) { return number > 0 && number <= 1e6; }};
const Allowed from_0_to_1{"a number from 0 to 1", [](double number) { return number >= 0 && number <= 1; }};
const Allowed below_1{"a number from 0 that is less than 1", [](double number) { return number >= 0 && number < 1; }};
const Allowed below_100{"a number from 0 that is less than 100",
                        [](double number) { return number >= 0 && number < 100; }};
const Allowed samples_of_a_pixel{"a whole number from 1 to 64", [](double number) {
                                     return number >= 1 && number <= 64 && number == std::floor(number);
                                 }};

const TomlValue* RubricTable::find(std::string_view name, std::optional<Kind> kind) {
    known_.push_back(name);
    for (const TomlValue::Member& member : table_.members) {
        if (member.name != name) continue;
        if (!kind || member.value.kind == *kind) return &member.value;
        wrong_value(diagnostics_, member.value.span,
                    fmt::format("'{}' is {}, not {}", name, words_of(*kind), words_of(member.value.kind)));
    }
    return nullptr;
}

void RubricTable::read(std::string_view name, std::string& text) {
    if (const TomlValue* value = find(name, Kind::text)) text = value->text;
}

void RubricTable::read(std::string_view name, std::optional<double>& number, const Allowed& allowed) {
    const TomlValue* value = find(name, Kind::number);
    if (!value) return;
    if (std::isfinite(value->number) && allowed.fits(value->number))
        number = value->number;
    else
        wrong_value(diagnostics_, value->span, fmt::format("'{}' is {}", name, allowed.words));
}

void RubricTable::read(std::string_view name, double& number, const Allowed& allowed) {
    std::optional<double> found;
    read(name, found, allowed);
    number = found.value_or(number);
}

std::vector<std::string> RubricTable::texts(std::string_view name) {
    std::vector<std::string> texts;
    const TomlValue* list = find(name);
    if (list && list->kind == Kind::text) return {list->text};
    if (list && list->kind != Kind::list)
        wrong_value(diagnostics_, list->span, fmt::format("'{}' is a list of texts", name));
    for (const TomlValue& part : list ? list->list : std::vector<TomlValue>{})
        if (part.kind == Kind::text)
            texts.push_back(part.text);
        else
            wrong_value(diagnostics_, part.span, fmt::format("'{}' is a list of texts", name));
    return texts;
}

void RubricTable::done() {
    for (const TomlValue::Member& member : table_.members) {
        if (ranges::find(known_, std::string_view(member.name)) != known_.end()) continue;
        const std::string_view near = nearest(member.name, known_);
        diagnostics_.error("rubric-key", member.span, fmt::format("a rubric has no '{}' here", member.name),
                           near.empty() ? fmt::format("possible: {}", fmt::join(known_, ", "))
                                        : fmt::format("did you mean '{}'?", near));
    }
}

void wrong_value(Diagnostics& diagnostics, Span span, std::string message, std::string help) {
    diagnostics.error("rubric-value", span, std::move(message), std::move(help));
}

void wrong_name(Diagnostics& diagnostics, Span span, std::string_view what, std::string_view name,
                const std::vector<std::string_view>& names) {
    const std::string_view near = nearest(name, names);
    wrong_value(diagnostics, span, fmt::format("there is no {} '{}'", what, name),
                near.empty() ? "" : fmt::format("did you mean '{}'?", near));
}

std::string toml_text(std::string_view text) {
    std::string result = "\"";
    for (const char c : utf8::printable(text))
        result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
    return result + "\"";
}

std::optional<std::string> assigned_text(const TomlValue& value) {
    if (value.kind == Kind::truth) return value.truth ? "true" : "false";
    if (value.kind == Kind::number && std::isfinite(value.number)) return fmt::format("{}", value.number);
    if (value.kind != Kind::list || value.list.empty()) return std::nullopt;
    std::string text;
    for (const TomlValue& part : value.list) {
        const auto one = part.kind == Kind::list ? std::nullopt : assigned_text(part);
        if (!one) return std::nullopt;
        text += (text.empty() ? "" : ",") + *one;
    }
    return text;
}

namespace {

// The only user of toml++, whose templates are slow to compile.
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
