#include "src/accuracy/found/apply.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "parser/text/utf8.h"
#include "src/accuracy/found/search.h"

namespace snell::accuracy {

namespace {

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
