// What is wrong with the input, where, and what would help. Libraries return these; only src/app prints.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "parser/limits.h"
#include "parser/source.h"

namespace snell {

enum class Severity : std::uint8_t { note, warning, error };
// "note", "warning", "error".
const char* name(Severity severity);

struct Note {
    Span span;
    std::string message;
};

struct Diagnostic {
    Severity severity = Severity::error;
    std::string code;  // stable, kebab-case: "unknown-command"
    Span span;
    std::string message;  // one line, no capital, no full stop
    std::string help;     // may be empty: what to do about it
    std::vector<Note> notes;
    bool has_span = true;         // false for what has no place in a text (no graphics, unwritable output)
    std::vector<Span> also = {};  // further places in the same text with the same defect

    bool is_at(std::string_view what, const Span& place) const {
        return has_span && code == what && (span == place || std::ranges::find(also, place) != also.end());
    }
};

class Diagnostics {
public:
    Diagnostics() = default;
    // With limits on how many there are and how long each is. What is past the first is counted and left out, with an
    // error that says so.
    explicit Diagnostics(const Limits& limits) : most_(limits.diagnostics), longest_(limits.message_bytes) {}

    // The reference is to a diagnostic that notes may be added to, until the next one.
    Diagnostic& add(Diagnostic diagnostic);
    Diagnostic& error(std::string_view code, Span span, std::string message, std::string help = {});
    Diagnostic& warning(std::string_view code, Span span, std::string message, std::string help = {});
    // Without a place in a text.
    Diagnostic& error(std::string_view code, std::string message, std::string help = {});
    Diagnostic& warning(std::string_view code, std::string message, std::string help = {});

    // The same message about several places of one text is one diagnostic: at the first place, with the others in
    // `also`.
    void add_once(Diagnostic diagnostic);

    bool has_errors() const { return errors_ > 0; }
    std::size_t errors() const { return errors_; }
    std::size_t warnings() const { return warnings_; }
    bool empty() const { return items_.empty(); }
    const std::vector<Diagnostic>& items() const { return items_; }

    void append(const Diagnostics& others);
    // Source order (file, then offset); those without a place last; stable.
    void sort();

private:
    std::vector<Diagnostic> items_;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
    std::uint64_t most_ = ~std::uint64_t{0}, longest_ = most_;
    Diagnostic nowhere_;
};

// `file:line:column: error: message [code]`, the line, a caret under the span, help and notes.
// Control characters of the source are never printed raw.
std::string render(const Diagnostic& diagnostic, const Sources& sources);
std::string render(const Diagnostics& diagnostics, const Sources& sources);

// The candidate nearest to `word` by edit distance without regard to case, if near enough to be meant;
// else empty.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

// Insertions, deletions, substitutions and swaps of neighbours from one word to another, without regard to case. Of
// words that are too long to be compared: more than any word is near.
int edit_distance(std::string_view a, std::string_view b);

}  // namespace snell
