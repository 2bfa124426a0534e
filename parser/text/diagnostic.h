// Diagnostics: errors and warnings about the input, with their place and help. Libraries return them; only src/app
// prints.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/limits.h"
#include "parser/text/ranges.h"
#include "parser/text/source.h"

namespace snell {

// Diagnostics: errors and warnings about the input, with their place and help. Libraries return them; only src/app
// prints.

enum class Severity : std::uint8_t { note, warning, error };
// Returns "note", "warning" or "error".
const char* name(Severity severity);

struct Note {
    Span span;
    std::string message;
};

// Replaces the bytes of `span` by `text`.
struct Fix {
    Span span;
    std::string text;
    bool operator==(const Fix&) const = default;
};

struct Diagnostic {
    Severity severity = Severity::error;
    std::string code;  // stable, in kebab-case, such as "unknown-command"
    Span span;
    std::string message;  // one line, without initial capital or full stop
    std::string help;     // what the user can do about it; may be empty
    std::vector<Note> notes;
    bool has_span = true;         // false if it concerns no place in a text (no graphics, unwritable output)
    std::vector<Span> also = {};  // further places in the same text with the same defect
    std::vector<Fix> fixes = {};  // all of them together are what was certainly meant; may be empty

    bool is_at(std::string_view what, const Span& place) const {
        return has_span && code == what && (span == place || ranges::find(also, place) != also.end());
    }
};

class Diagnostics {
public:
    Diagnostics() = default;
    // Limits the number of diagnostics and the length of each. Diagnostics beyond the limit are counted and left out,
    // and an error says how many.
    explicit Diagnostics(const Limits& limits) : most_(limits.diagnostics), longest_(limits.message_bytes) {}

    // Returns a reference through which notes can be added, until the next diagnostic is added.
    Diagnostic& add(Diagnostic diagnostic);
    Diagnostic& error(std::string_view code, Span span, std::string message, std::string help = {});
    Diagnostic& warning(std::string_view code, Span span, std::string message, std::string help = {});
    // For problems without a place in a text.
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
    // Sorts by file, then offset; those without a place are last. Stable.
    void sort();

private:
    std::vector<Diagnostic> items_;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
    std::uint64_t most_ = ~std::uint64_t{0}, longest_ = most_;
    Diagnostic nowhere_;
};

// Formats as `file:line:column: error: message [code]`, followed by the source line, a caret under the span, help and
// notes. Control characters of the source are escaped.
std::string render(const Diagnostic& diagnostic, const Sources& sources);
std::string render(const Diagnostics& diagnostics, const Sources& sources);

// Returns the candidate nearest to `word` by edit distance, without regard to case; empty if none is similar enough.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

// Insertions, deletions, substitutions and swaps of neighbours from one word to another, without regard to case. Of
// words that are too long to be compared: more than any word is near.
int edit_distance(std::string_view a, std::string_view b);

// A diagnostic whose places were looked up: the parts that a reader sees, without the sources.

// A line of source with a mark under it. Control characters are escaped, and long lines are cut around the mark.
struct MarkedLine {
    std::string text;
    int begin = 0, end = 0;  // columns of the mark, from 0; an empty mark still has one caret
};

// All texts are printable.
struct Finding {
    Severity severity = Severity::error;
    std::string file;  // name of the source
    std::optional<Position> at;
    std::string message;               // one line, with the code
    std::optional<MarkedLine> source;  // the line of the place, if there is one
    std::string also;                  // further lines with the same defect; may be empty
    std::string help;                  // may be empty
    std::vector<Finding> notes;
};

Finding describe(const Diagnostic& diagnostic, const Sources& sources);
// Returns "file:line:column", or "" without a place.
std::string place_text(const Finding& finding);
// Returns the first line: place, severity and message.
std::string headline(const Finding& finding);
// Returns what precedes the source: the number of the line and a bar.
std::string margin(int line);
// Returns the carets that belong below the text of the line.
std::string carets(const MarkedLine& line);
// Formats as render(Diagnostic) does.
std::string render(const Finding& finding);

// Collects the diagnostics of the parser's stages.

// Diagnostics with a limit, so that a text full of mistakes does not exhaust the memory.
class Collector {
public:
    explicit Collector(std::size_t limit) : limit_(limit) {}

    // Returns a reference through which notes can be added. Past the limit it refers to a dummy.
    Diagnostic& error(std::string_view code, Span span, std::string message, std::string help = {}) {
        return add(Severity::error, code, span, std::move(message), std::move(help));
    }
    Diagnostic& warning(std::string_view code, Span span, std::string message, std::string help = {}) {
        return add(Severity::warning, code, span, std::move(message), std::move(help));
    }
    bool full() const { return diagnostics_.items().size() >= limit_; }
    // Moves the diagnostics out, with an error about those that were left out.
    Diagnostics take();

private:
    Diagnostic& add(Severity severity, std::string_view code, Span span, std::string message, std::string help);

    std::size_t limit_;
    std::size_t left_out_ = 0;
    Span first_left_out_;
    Diagnostics diagnostics_;
    Diagnostic nowhere_;
};

}  // namespace snell
