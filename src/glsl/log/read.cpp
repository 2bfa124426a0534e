// Lines of drivers' logs → entries.
#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "parser/text/words.h"
#include "src/glsl/log/log.h"

namespace snell::glsl::log {
namespace {

// Reads a line of a log from the left.
class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    bool take(std::string_view prefix) {
        if (!rest_.starts_with(prefix)) return false;
        rest_.remove_prefix(prefix.size());
        return true;
    }

    std::optional<int> number() {
        int value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc() || value < 0) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    void blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size())); }
    std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
};

std::string_view trimmed(std::string_view text) {
    using namespace std::string_view_literals;
    return snell::trimmed(text, " \t\r\n\v\f\0"sv);
}

bool take_severity(Reader& reader, Entry& entry) {
    if (reader.take("preprocessor error:") || reader.take("fatal error") || reader.take("error") ||
        reader.take("ERROR")) {
        entry.severity = Severity::error;
        return true;
    }
    if (reader.take("preprocessor warning:") || reader.take("warning") || reader.take("WARNING")) {
        entry.severity = Severity::warning;
        return true;
    }
    return false;
}

// What follows the severity word: " C1008: ", "(#143) ", ": ".
std::string_view after_severity(Reader reader) {
    reader.blanks();
    if (reader.take("(#") && reader.number()) reader.take(")");
    Reader code = reader;
    if ((code.take("C") || code.take("L")) && code.number() && code.take(":")) reader = code;
    reader.take(":");
    return trimmed(reader.rest());
}

// `0:12(5): error: …` as Mesa writes, and PowerVR and Mali without the column.
std::optional<Entry> mesa_line(std::string_view line) {
    Reader reader(line);
    Entry entry;
    const auto string = reader.number();
    if (!string || !reader.take(":")) return std::nullopt;
    const auto row = reader.number();
    if (!row) return std::nullopt;
    if (reader.take("(")) {
        entry.column = reader.number().value_or(0);
        reader.take(")");
    }
    if (!reader.take(":")) return std::nullopt;
    reader.blanks();
    entry.driver = entry.column > 0 ? Driver::mesa : Driver::khronos;
    entry.string = *string;
    entry.line = *row;
    if (!take_severity(reader, entry)) return std::nullopt;
    reader.take(":");
    entry.text = reader.rest();  // leading blanks tell candidates apart
    return entry;
}

// `0(12) : error C1008: …`; `(0) : error C3001: …` has no place.
std::optional<Entry> nvidia_line(std::string_view line) {
    Reader reader(line);
    Entry entry;
    entry.driver = Driver::nvidia;
    const auto string = reader.number();
    if (!reader.take("(")) return std::nullopt;
    const auto row = reader.number();
    if (!row || !reader.take(")")) return std::nullopt;
    reader.blanks();
    if (!reader.take(":")) return std::nullopt;
    reader.blanks();
    if (string) {
        entry.string = *string;
        entry.line = *row;
    }
    if (!take_severity(reader, entry)) return std::nullopt;
    entry.text = after_severity(reader);
    return entry;
}

// `ERROR: 0:12: …` and entries without a place: `error: …`, `ERROR: error(#273) …`.
std::optional<Entry> khronos_line(std::string_view line) {
    Reader reader(line);
    Entry entry;
    const bool capitals = line.starts_with("ERROR") || line.starts_with("WARNING");
    entry.driver = capitals ? Driver::khronos : Driver::mesa;
    if (!take_severity(reader, entry) || !reader.take(":")) return std::nullopt;
    reader.blanks();
    Reader placed = reader;
    const auto string = placed.number();
    if (string && placed.take(":")) {
        const auto row = placed.number();
        if (row && placed.take("(")) {
            entry.column = placed.number().value_or(0);
            placed.take(")");
        }
        if (row && placed.take(":")) {
            entry.string = *string;
            entry.line = *row;
            placed.blanks();
            reader = placed;
        }
    }
    Reader again = reader;  // AMD says `ERROR: 0:12: error(#143) …`
    Entry ignored;
    if (take_severity(again, ignored) && again.rest().starts_with("(#")) {
        entry.text = after_severity(again);
    } else {
        entry.text = trimmed(reader.rest());
    }
    return entry;
}

bool same(const Entry& x, const Entry& y) {
    return x.severity == y.severity && x.string == y.string && x.line == y.line && x.text == y.text;
}

// Mesa lists the functions that a call might have meant as errors of their own, indented.
bool is_candidate(const Entry& entry) { return entry.driver == Driver::mesa && entry.text.starts_with("   "); }

std::optional<Entry> read_line(std::string_view line) {
    if (auto entry = mesa_line(line)) return entry;
    if (auto entry = nvidia_line(line)) return entry;
    return khronos_line(line);
}

}  // namespace

std::vector<Entry> read(std::string_view log) {
    std::vector<Entry> entries;
    std::string_view unread;
    std::optional<Stage> headline;
    for (std::size_t begin = 0; begin < log.size();) {
        const std::size_t end = std::min(log.find_first_of("\r\n", begin), log.size());
        std::string_view line = trimmed(log.substr(begin, end - begin));
        begin = end + 1;
        if (line.starts_with(".")) line = trimmed(line.substr(1));  // Mesa's repeated link warnings
        if (line.empty()) continue;
        auto entry = read_line(line);
        if (!entry) {
            if (unread.empty()) unread = line;
            if (const auto stage = stage_in(line)) headline = stage;
            continue;
        }
        if (is_candidate(*entry)) continue;
        entry->text = trimmed(entry->text);
        classify(*entry);
        entry->stage = stage_in(entry->text);
        if (!entry->stage) entry->stage = headline;
        const bool repeated =
            std::any_of(entries.begin(), entries.end(), [&](const Entry& e) { return same(e, *entry); });
        if (!repeated && entry->kind != Kind::noise) entries.push_back(std::move(*entry));
    }
    if (entries.empty() && !unread.empty()) {
        Entry entry;
        entry.driver = Driver::khronos;
        entry.text = unread;
        classify(entry);
        if (entry.kind != Kind::noise) entries.push_back(std::move(entry));
    }
    return entries;
}

}  // namespace snell::glsl::log
