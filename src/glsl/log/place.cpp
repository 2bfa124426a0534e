// From the place that a driver names in the translated text to the user's own.
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/log/log.h"

namespace snell::glsl::log {
namespace {

// A line of the translation, as #line numbers it.
struct Row {
    std::string_view text;
    int string = 0, line = 0;  // line 0: it is a #line itself
};

bool is_numbering(std::string_view row) {
    row.remove_prefix(std::min(row.find_first_not_of(" \t"), row.size()));
    return row.starts_with("#line ");
}

std::vector<Row> rows_of(std::string_view text) {
    std::vector<Row> rows;
    int at_string = 0, at_line = 1;
    for (const std::string_view row : split(text, '\n')) {
        if (!is_numbering(row)) {
            rows.push_back({row, at_string, at_line++});
            continue;
        }
        rows.push_back({row, at_string, 0});
        char* rest = nullptr;
        const std::string numbers(row.substr(row.find("#line ") + 6));
        at_line = static_cast<int>(std::strtol(numbers.c_str(), &rest, 10));
        char* after = rest;
        const long number = std::strtol(rest, &after, 10);
        if (after != rest) at_string = static_cast<int>(number);
    }
    return rows;
}

// The physical lines of the translation that #line numbers as `line` of source string `string`.
std::vector<std::string_view> translated_lines(std::string_view text, int string, int line) {
    std::vector<std::string_view> found;
    for (const Row& row : rows_of(text))
        if (row.line > 0 && row.string == string && row.line == line) found.push_back(row.text);
    return found;
}

// The column (1-based) at which Mesa's preprocessor leaves a byte of a line: runs of blanks become one.
int squeezed_column(std::string_view line, std::size_t offset) {
    int column = 1;
    for (std::size_t i = 0; i < offset && i < line.size(); ++i) {
        const bool blank = line[i] == ' ' || line[i] == '\t';
        const bool more = i + 1 < line.size() && (line[i + 1] == ' ' || line[i + 1] == '\t');
        if (!blank || !more) ++column;
    }
    return column;
}

struct Aim {
    std::string word;         // in the user's words
    std::size_t ordinal = 0;  // how many equal words stand before it on the line
};

int driver_column(const Entry& entry, std::string_view row, const Word& word) {
    return entry.driver == Driver::mesa ? squeezed_column(row, word.begin) : static_cast<int>(word.begin) + 1;
}

// The word of one translated line that the entry means: the one it quotes, nearest to its column, or else the
// one at its column.
std::optional<Aim> aim(const Entry& entry, std::string_view row, std::string_view quoted, std::string_view user) {
    const std::vector<Word> all = words(row);
    std::optional<std::size_t> best;
    int best_distance = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!quoted.empty() && user_name(text_of(row, all[i]), user) != quoted) continue;
        const int distance = entry.column > 0 ? std::abs(driver_column(entry, row, all[i]) - entry.column) : 0;
        if (best && distance >= best_distance) continue;
        best = i;
        best_distance = distance;
    }
    if (!best || (quoted.empty() && best_distance > 0)) return std::nullopt;
    Aim result{.word = user_name(text_of(row, all[*best]), user), .ordinal = 0};
    for (std::size_t i = 0; i < *best; ++i)
        if (user_name(text_of(row, all[i]), user) == result.word) ++result.ordinal;
    return result;
}

bool names_something(Kind kind) {
    return kind == Kind::undeclared || kind == Kind::no_function || kind == Kind::no_overload;
}

// Macros may name those below them: each pass goes one deeper.
constexpr int deepest_macro = 8;

// The macro on the line that brings in `name`, itself or by the macros in its text.
std::optional<Word> macro_with(std::string_view name, std::span<const Word> on_line, std::string_view text,
                               const Context& context) {
    std::set<std::string_view> bringing{name};
    std::size_t before = 0;
    for (int pass = 0; pass < deepest_macro && before != bringing.size(); ++pass) {
        before = bringing.size();
        for (const FileId file : context.stage->files) {
            const std::string_view of = context.sources.text(file);
            std::string_view macro;
            for (const Word& w : context.texts.words(file)) {
                const std::string_view t = text_of(of, w);
                if (!w.directive || t == "#") {
                    macro = {};
                } else if (t == "define") {
                    macro = t;
                } else if (macro == "define") {
                    macro = t;
                } else if (!macro.empty() && bringing.contains(t)) {
                    bringing.insert(macro);
                }
            }
        }
    }
    for (const Word& w : on_line)
        if (!w.directive && bringing.contains(text_of(text, w))) return w;
    return std::nullopt;
}

void place_on_line(const Entry& entry, const Context& context, Place& found) {
    const std::string_view text = context.sources.text(found.file);
    const std::string_view line = context.sources.line(found.file, found.line);
    found.span = context.sources.line_span(found.file, found.line);
    found.known = true;
    const std::span<const Word> on_line = context.texts.on_line(found.file, found.line);
    if (on_line.empty()) return;

    const std::string quoted = user_name(entry.a, line);
    const auto quoted_here = [&](const Word& w) { return text_of(text, w) == quoted; };
    const bool use_quoted = !quoted.empty() && std::any_of(on_line.begin(), on_line.end(), quoted_here);
    if (!use_quoted && !quoted.empty() && names_something(entry.kind)) {
        if (const auto macro = macro_with(quoted, on_line, text, context)) {
            found.span = {found.file, macro->begin, macro->end};
            return;
        }
    }
    const std::vector<std::string_view> rows = translated_lines(context.stage->text, entry.string, entry.line);
    const auto aimed = [&](const std::string& word) -> std::optional<Word> {
        Aim target{.word = word, .ordinal = 0};
        for (const std::string_view row : rows)
            if (const auto better = aim(entry, row, word, line)) {
                target = *better;
                break;
            }
        std::optional<Word> last;
        std::size_t seen = 0;
        for (const Word& w : on_line)
            if (text_of(text, w) == target.word && seen++ <= target.ordinal) last = w;
        return last;
    };
    std::optional<Word> word = aimed(use_quoted ? quoted : std::string());
    // A conversion's type need not be written in the statement that lacks it.
    if (word && use_quoted && entry.kind == Kind::convert && entry.column > 0)
        if (const auto begin = aimed(""); begin && begin->begin < word->begin &&
                                          text.substr(begin->end, word->begin - begin->end).find(';') != text.npos)
            word = begin;
    if (word) found.span = {found.file, word->begin, word->end};
}

bool fits_link(const Entry& entry, const Declared& d, Stage stage) {
    if (entry.stage && *entry.stage != stage && entry.kind != Kind::types_differ) return false;
    if (entry.kind == Kind::not_written) return d.qualifier == "in" || d.qualifier == "varying";
    return true;
}

// A link log names variables but not places, so their declaration is searched for.
Place place_of_name(const Entry& entry, const Context& context) {
    Place found{.file = context.where.file, .span = context.where};
    const auto& stages = context.translation.stages;
    for (auto it = stages.rbegin(); it != stages.rend(); ++it) {
        for (const FileId file : it->files) {
            const std::string_view text = context.sources.text(file);
            const std::string name = user_name(entry.a, text);
            for (const Declared& d : context.texts.declared(file)) {
                if (name.empty() || d.name != name || !fits_link(entry, d, it->stage)) continue;
                found.file = file;
                found.span = {file, d.begin, d.end};
                found.line = d.line;
                found.known = true;
                return found;
            }
        }
    }
    return found;
}

// Whether only directives stand between the place and an #include, or the beginning of an included text.
bool follows_include(const Entry& entry, const Place& found, const Context& context) {
    const std::string_view text = context.sources.text(found.file);
    bool follows = entry.string > 0;
    for (const Word& word : context.texts.words(found.file)) {
        if (word.begin >= found.span.begin) break;
        follows = word.directive && (follows || text_of(text, word) == "include");
    }
    return follows;
}

// Drivers blame what follows a text that is not finished: such an entry becomes one about the end of that text.
void blame_unfinished(Entry& entry, Place& found, const Context& context) {
    const auto file_of = [&](int string) { return context.stage->files[static_cast<std::size_t>(string)]; };
    std::map<int, int> before;  // the texts that begin before the entry, and the last line of each before it
    int last = -1;
    const std::vector<Row> rows = rows_of(context.stage->text);
    const auto numbering = ranges::find(rows, 0, &Row::line);
    // What comes before the first number of the text is the translation's own.
    bool numbered = numbering != rows.end() && std::next(numbering) != rows.end() && std::next(numbering)->string > 0;
    for (const Row& row : rows) {
        numbered = numbered || row.line == 0;
        if (!numbered || row.line == 0 || words(row.text).empty()) continue;
        if (row.string == entry.string && row.line == entry.line && entry.kind != Kind::end_of_file) break;
        if (static_cast<std::size_t>(row.string) >= context.stage->files.size()) continue;
        before[row.string] = row.line;
        if (row.string != entry.string) last = row.string;
    }
    const auto end_of = [&](int string) {
        const Word* end = nullptr;
        for (const Word& word : context.texts.words(file_of(string)))
            if (!word.directive && word.line <= before[string]) end = &word;
        return end;
    };
    const Word* end = last >= 0 && follows_include(entry, found, context) ? end_of(last) : nullptr;
    if (end && finished(context.sources.text(file_of(last)), context.texts.words(file_of(last)), end->end))
        end = nullptr;
    if (unclosed_brace(context.stage->text) != std::string_view::npos)
        for (const auto& [string, line] : before)
            if (string > 0 && unclosed_brace(context.sources.text(file_of(string))) != std::string_view::npos)
                end = end_of(last = string);
    if (!end) return;
    const FileId file = file_of(last);
    entry.kind = Kind::end_of_file;
    found = {.file = file, .line = end->line, .span = {file, end->begin, end->end}, .known = true};
}

}  // namespace

void number(Entry& entry, std::string_view text) {
    const std::vector<Row> rows = rows_of(text);
    if (entry.string < 0 || entry.line < 1 || rows.empty()) return;
    std::size_t at = std::min(static_cast<std::size_t>(entry.line), rows.size()) - 1;
    while (rows[at].line == 0 && at + 1 < rows.size()) ++at;
    while (rows[at].line == 0 && at > 0) --at;  // nothing comes behind the last #include
    entry.string = rows[at].string;
    entry.line = rows[at].line;
}

Place place(Entry& entry, const Context& context) {
    if (!context.stage || entry.string < 0 || entry.line < 1) return place_of_name(entry, context);
    Place found{.file = context.where.file, .span = context.where};
    if (static_cast<std::size_t>(entry.string) >= context.stage->files.size()) return found;
    const FileId file = context.stage->files[static_cast<std::size_t>(entry.string)];
    const std::vector<Word>& all = context.texts.words(file);
    found.file = file;
    found.line = entry.line;
    // The end of the text often has no word, so the last word is used.
    if (entry.kind == Kind::end_of_file || all.empty() || entry.line > all.back().line) {
        const Word last = all.empty() ? Word{} : all.back();
        found.span = {file, last.begin, last.end};
        found.line = last.line;
        found.known = true;
    } else {
        place_on_line(entry, context, found);
    }
    if (entry.kind == Kind::syntax || entry.kind == Kind::end_of_file || entry.kind == Kind::not_global)
        blame_unfinished(entry, found, context);
    return found;
}

}  // namespace snell::glsl::log

namespace snell::glsl {

std::string unnumbered(std::string_view text) {
    std::string out;
    for (const log::Row& row : log::rows_of(text)) {
        if (row.line > 0) out += row.text;
        out += '\n';
    }
    return out;
}

}  // namespace snell::glsl
