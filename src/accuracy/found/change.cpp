#include "src/accuracy/found/change.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/found/search.h"
#include "src/glsl/read/lexer.h"

namespace snell::accuracy {

namespace {

constexpr std::array<KindFacts, static_cast<std::size_t>(ChangeKind::count)> table{{
    {ChangeKind::fewer_rounds, Aim::cheaper, "fewer-rounds", "a loop goes round less often"},
    {ChangeKind::without_term, Aim::cheaper, "without-term", "a term of a sum or a blend is left out"},
    {ChangeKind::lookup_mean, Aim::cheaper, "lookup-mean", "a texture lookup is replaced by the texture's mean"},
    {ChangeKind::expression_mean, Aim::cheaper, "expression-mean", "an expression is replaced by its mean"},
    {ChangeKind::polynomial, Aim::cheaper, "polynomial", "a function is replaced by a polynomial with a bound"},
    {ChangeKind::per_vertex, Aim::cheaper, "per-vertex", "work moves from the fragment to the vertex shader"},
    {ChangeKind::per_frame, Aim::cheaper, "per-frame", "work on uniforms alone is done once for each vertex"},
    {ChangeKind::lower_levels, Aim::cheaper, "lower-levels", "patches are tessellated less"},
    {ChangeKind::smaller_noise, Aim::cheaper, "smaller-noise", "the noise texture has fewer texels"},
    {ChangeKind::fewer_texels, Aim::cheaper, "fewer-texels", "textures that are drawn to have fewer texels"},
    {ChangeKind::fewer_cells, Aim::cheaper, "fewer-cells", "a grid of quads has fewer cells"},
    {ChangeKind::fewer_slices, Aim::cheaper, "fewer-slices", "a round shape has fewer slices and stacks"},
    {ChangeKind::culled, Aim::cheaper, "culled", "faces of a solid that face away are culled"},
    {ChangeKind::less_filtered, Aim::cheaper, "less-filtered", "a texture is filtered less"},
    {ChangeKind::unit_length, Aim::better, "unit-length", "a direction gets unit length"},
    {ChangeKind::derivatives_outside, Aim::better, "derivatives-outside",
     "a lookup in a branch gets its level outside"},
    {ChangeKind::more_rounds, Aim::better, "more-rounds", "a loop goes round more often"},
    {ChangeKind::exact_fresnel, Aim::better, "exact-fresnel", "the exact Fresnel equations for Schlick's formula"},
    {ChangeKind::both_interfaces, Aim::better, "both-interfaces", "light is bent where it leaves, too"},
    {ChangeKind::box_projection, Aim::better, "box-projection", "the room of the cube map is near, not infinitely far"},
    {ChangeKind::lint_fix, Aim::better, "lint-fix", "what a lint advises"},
    {ChangeKind::finer_cells, Aim::better, "finer-cells", "a grid of quads has more cells"},
    {ChangeKind::more_slices, Aim::better, "more-slices", "a round shape has more slices and stacks"},
    {ChangeKind::filtered, Aim::better, "filtered", "a texture is filtered instead of nearest"},
    {ChangeKind::decoded, Aim::better, "decoded", "textures are decoded to light before they are used"},
    {ChangeKind::no_draw, Aim::unused, "no-draw", "a draw is left out"},
    {ChangeKind::no_texture, Aim::unused, "no-texture", "a texture is left out"},
    {ChangeKind::no_uniform, Aim::unused, "no-uniform", "a uniform of the Program line is left out"},
    {ChangeKind::no_statement, Aim::unused, "no-statement", "a statement of a shader is left out"},
}};

constexpr bool in_order() {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (static_cast<std::size_t>(table[i].kind) != i) return false;
    return true;
}
static_assert(in_order(), "facts() looks the rows up by their kind");

bool touch(const Span& a, const Span& b) {
    if (a.file != b.file) return false;
    // Two insertions at one place, or one at the edge of a replacement, would depend on their order.
    return a.begin <= b.end && b.begin <= a.end;
}

}  // namespace

const KindFacts& facts(ChangeKind kind) { return table[static_cast<std::size_t>(kind)]; }

bool compatible(const Change& a, const Change& b) {
    return ranges::none_of(a.edits, [&](const Edit& one) {
        return ranges::any_of(b.edits, [&](const Edit& other) { return touch(one.span, other.span); });
    });
}

std::map<std::string, std::string> changed_texts(std::span<const Change* const> changes, const Sources& sources) {
    std::map<std::string_view, std::vector<Edit>> by_name;  // a text that was read twice has two numbers
    for (const Change* change : changes)
        for (const Edit& edit : change->edits) by_name[sources.name(edit.span.file)].push_back(edit);
    std::map<std::string, std::string> texts;
    for (auto& [name, edits] : by_name) {
        const FileId file = edits.front().span.file;
        for (Edit& edit : edits) edit.span.file = file;
        ranges::stable_sort(edits, {}, [](const Edit& edit) { return std::pair(edit.span.begin, edit.span.end); });
        texts.emplace(name, with_edits(sources.text(file), file, edits));
    }
    return texts;
}

std::string real_literal(double value, int digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    if (text.find_first_of(".e") == std::string::npos) text += '.';
    return text;
}

std::string excerpt(std::string_view text, std::size_t most) {
    std::string line;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
        if (!blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    if (line.size() <= most) return line;
    std::size_t head = most / 2 - 1, tail = line.size() - most / 2 + 2;
    const auto inside = [&](std::size_t at) { return (static_cast<unsigned char>(line[at]) & 0xC0u) == 0x80u; };
    while (head > 0 && inside(head)) --head;
    while (tail < line.size() && inside(tail)) ++tail;
    return line.substr(0, head) + "…" + line.substr(tail);
}

namespace {

constexpr std::size_t most_words = 28;

std::string short_text(std::string_view text) { return excerpt(text, most_words); }

std::string first_name(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size() &&
           (!glsl::identifier_part(text[at]) || std::isdigit(static_cast<unsigned char>(text[at])) != 0))
        ++at;
    std::size_t end = at;
    while (end < text.size() && glsl::identifier_part(text[end])) ++end;
    return std::string(text.substr(at, end - at));
}

std::vector<std::string> words_in(std::string_view text) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" ;", at), text.size());
        if (end > at) all.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
    return all;
}

// The numbers that a statement has after the change and not before: "18 × 12", "18" for two that are equal.
std::string new_numbers(const Change& change, bool each) {
    const std::vector<std::string> before = words_in(change.before), after = words_in(change.after);
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < after.size(); ++i)
        if (after[i].find_first_not_of("0123456789") == std::string::npos &&
            (i >= before.size() || before[i] != after[i]))
            numbers.push_back(after[i]);
    if (!each && ranges::all_of(numbers, [&](const std::string& n) { return n == numbers.front(); }))
        numbers.resize(std::min<std::size_t>(numbers.size(), 1));
    std::string text;
    for (const std::string& number : numbers) text += (text.empty() ? "" : " × ") + number;
    return text;
}

// What a text loses between its beginning and its end; empty if it loses nothing alone.
std::string lost(std::string_view before, std::string_view after) {
    std::size_t head = 0, tail = 0;
    while (head < after.size() && head < before.size() && before[head] == after[head]) ++head;
    while (tail < after.size() - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
    if (head + tail < after.size() || head + tail >= before.size()) return {};
    std::string_view gone = before.substr(head, before.size() - tail - head);
    constexpr std::string_view around = " +-*;";
    gone.remove_prefix(std::min(gone.find_first_not_of(around), gone.size()));
    gone.remove_suffix(gone.size() - std::min(gone.find_last_not_of(around) + 1, gone.size()));
    return std::string(gone);
}

// The condition of a loop's header, or the number that is changed.
std::string bound_words(std::string_view after) {
    constexpr std::string_view define = "#define ";
    if (after.starts_with(define)) return short_text(after.substr(define.size()));
    if (const std::size_t first = after.find(';'); after.starts_with("for") && first != after.npos)
        after = after.substr(first + 1, std::min(after.find(';', first + 1), after.size()) - first - 1);
    const std::string text = short_text(after);
    return text.find_first_of("<>") == text.npos ? text : "loop to " + text;
}

// "uRoom" of "texture( uRoom, look )".
std::string looked_up(std::string_view call) { return first_name(call.substr(std::min(call.find('('), call.size()))); }

// Functions by name, other expressions as they are.
std::string expression_words(std::string_view text) {
    const std::string name = first_name(text);
    const bool call = !name.empty() && text.starts_with(name) && text.substr(name.size()).starts_with('(') &&
                      text.find(')') == text.size() - 1;
    return call ? name : short_text(text);
}

// "polynomials for 4 sin and cos" where several calls change together.
std::string polynomial_words(const Change& change) {
    constexpr std::string_view prefix = "found";  // of the functions that it adds, ahead of those that they replace
    std::size_t calls = 0;
    std::vector<std::string> functions;
    for (const Edit& edit : change.edits) {
        if (edit.span.begin == edit.span.end || !edit.text.starts_with(prefix)) continue;
        std::string function = lowered(edit.text.substr(prefix.size(), edit.text.find('_') - prefix.size()));
        ++calls;
        if (ranges::find(functions, function) == functions.end()) functions.push_back(std::move(function));
    }
    if (calls < 2) return "polynomial for " + expression_words(change.before);
    std::string names;
    for (std::size_t i = 0; i < functions.size(); ++i)
        names += (i == 0 ? "" : i + 1 < functions.size() ? ", " : " and ") + functions[i];
    return fmt::format("polynomials for {} {}", calls, functions.size() > 3 ? "calls" : names);
}

// "\n" in `text` as `line_end`; line ends that are there already stay.
std::string with_line_ends(std::string_view text, std::string_view line_end) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool bare = text[i] == '\n' && (i == 0 || text[i - 1] != '\r');
        if (bare)
            result += line_end;
        else
            result += text[i];
    }
    return result;
}

Change in_one_text(Change change, const Sources& sources) {
    for (Edit& edit : change.edits) {
        edit.span.file = first_reading(edit.span.file, sources);
        edit.text = with_line_ends(edit.text, line_end_of(sources.text(edit.span.file)));
    }
    std::stable_sort(change.edits.begin(), change.edits.end(), [](const Edit& a, const Edit& b) {
        return std::pair(a.span.file, a.span.begin) < std::pair(b.span.file, b.span.begin);
    });
    change.edits.erase(std::unique(change.edits.begin(), change.edits.end()), change.edits.end());
    return change;
}

// A text that is cut to one line, if there is any.
std::string shown(std::string_view text) { return text.empty() ? "(nothing)" : utf8::printable(excerpt(text)); }

}  // namespace

std::string_view name(Aim aim) {
    constexpr std::array<std::string_view, 3> names{"cheaper", "better", "unused"};
    return names[static_cast<std::size_t>(aim)];
}

std::string words(const Change& change) {
    const std::string_view before = change.before, after = change.after;
    const std::string kind(facts(change.kind).name);
    switch (change.kind) {
        case ChangeKind::fewer_slices:
        case ChangeKind::more_slices:
            return new_numbers(change, false) + (before.starts_with("QuadBox") ? " quads" : " slices");
        case ChangeKind::fewer_cells:
        case ChangeKind::finer_cells:
            return new_numbers(change, true) + " cells";
        case ChangeKind::fewer_texels:
            return new_numbers(change, false) + " texels";
        case ChangeKind::smaller_noise:
            return "noise of " + new_numbers(change, false);
        case ChangeKind::less_filtered:
        case ChangeKind::filtered:
            return words_in(after).empty() ? kind : words_in(after).back();
        case ChangeKind::culled:
            return before.empty() ? "solids culled" : first_name(before) + " culled";
        case ChangeKind::fewer_rounds:
        case ChangeKind::more_rounds:
            return bound_words(after);
        case ChangeKind::without_term:
            if (const std::string gone = lost(before, after); !gone.empty()) return "without " + short_text(gone);
            return "only " + short_text(after);
        case ChangeKind::lookup_mean:
            return looked_up(before) + " as its mean";
        case ChangeKind::expression_mean:
            return expression_words(before) + " as its mean";
        case ChangeKind::polynomial:
            return polynomial_words(change);
        case ChangeKind::per_vertex:
            return expression_words(before) + " per vertex";
        case ChangeKind::per_frame:
            return expression_words(before) + " per frame";
        case ChangeKind::unit_length:
            return short_text(after);
        case ChangeKind::lint_fix:
            return change.lint.empty() ? short_text(after) : change.lint;
        case ChangeKind::no_uniform:
            return "without " + first_name(before);
        case ChangeKind::no_draw:
        case ChangeKind::no_texture:
        case ChangeKind::no_statement:
            return "without " + short_text(before);
        default: {
            std::string name = kind;
            std::replace(name.begin(), name.end(), '-', ' ');
            return name;
        }
    }
}

FileId first_reading(FileId file, const Sources& sources) {
    for (FileId other = 0; other < file; ++other)
        if (sources.name(other) == sources.name(file) && sources.text(other) == sources.text(file)) return other;
    return file;
}

std::optional<Chosen> choose_changes(std::string_view name, std::span<const Change> changes, const Sources& sources,
                                     std::string& error) {
    error = changes.empty() ? "snell finds nothing to change in this scene" : "";
    if (!error.empty()) return std::nullopt;
    const auto indices = parse_rung(name, changes, error);
    if (!indices) return std::nullopt;
    Chosen chosen;
    for (const std::size_t index : *indices) {
        if (!changes[index].probes.empty()) {
            const std::string& refused = changes[index].refused;
            error = fmt::format("the mean of '{}' is not known: {}", changes[index].before,
                                refused.empty() ? "it shows in no pixel, or there was no time to draw it"
                                                : "it could not be drawn: " + refused);
            return std::nullopt;
        }
        chosen.numbers.push_back(index + 1);
        chosen.changes.push_back(in_one_text(changes[index], sources));
    }
    for (std::size_t b = 1; b < chosen.changes.size(); ++b)
        for (std::size_t a = 0; a < b; ++a)
            if (!compatible(chosen.changes[a], chosen.changes[b])) {
                error = fmt::format("{} and {} change the same text", chosen.numbers[a], chosen.numbers[b]);
                return std::nullopt;
            }
    return chosen;
}

std::string change_place(const Change& change, const Sources& sources) {
    const Position at = sources.position(change.where.file, change.where.begin);
    return fmt::format("{}:{}:{}", utf8::printable(sources.name(change.where.file)), at.line, at.column);
}

std::vector<std::string> other_edits(const Change& change, const Sources& sources) {
    std::vector<std::string> lines;
    for (const Edit& edit : change.edits) {
        const Span &where = change.where, &at = edit.span;
        if (at.file == where.file && where.begin <= at.begin && at.end <= where.end) continue;
        const Position place = sources.position(at.file, at.begin);
        lines.push_back(fmt::format("{}:{}:{}: {} → {}", utf8::printable(sources.name(at.file)), place.line,
                                    place.column, shown(sources.text(at.file).substr(at.begin, at.end - at.begin)),
                                    shown(edit.text)));
    }
    return lines;
}

std::string change_line(const Change& change, const Sources& sources) {
    std::string line =
        fmt::format("{}: {} → {}", change_place(change, sources), shown(change.before), shown(change.after));
    for (const std::string& other : other_edits(change, sources)) line += "\n    and " + other;
    return line;
}

std::string_view line_end_of(std::string_view text) {
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos || text[end] == '\n') return "\n";
    return text.substr(end).starts_with("\r\n") ? "\r\n" : "\r";
}

}  // namespace snell::accuracy
