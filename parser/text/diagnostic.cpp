#include "parser/text/diagnostic.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "parser/text/words.h"

namespace snell {
namespace {

// No suggestion is made for longer words, which bounds the cost of hostile input.
constexpr std::size_t longest_word = 64;

// Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours, each once.
int distance(std::string_view a, std::string_view b) {
    using Row = std::array<int, longest_word + 1>;
    Row before{}, previous{}, current{};
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const char x = lower(a[i - 1]), y = lower(b[j - 1]);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (x == y ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && x == lower(b[j - 2]) && y == lower(a[i - 2]);
            if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
        }
        before = previous;
        previous = current;
    }
    return previous[b.size()];
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    return std::max(a.size(), b.size()) > longest_word ? static_cast<int>(longest_word) : distance(a, b);
}

const char* name(Severity severity) {
    constexpr const char* names[] = {"note", "warning", "error"};
    return names[static_cast<std::size_t>(severity)];
}

Diagnostic& Diagnostics::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::error) ++errors_;
    if (diagnostic.severity == Severity::warning) ++warnings_;
    if (diagnostic.message.size() > longest_) diagnostic.message.resize(longest_);
    if (diagnostic.help.size() > longest_) diagnostic.help.resize(longest_);
    if (items_.size() >= most_) {
        if (items_.size() == most_) {
            ++errors_;
            items_.push_back({Severity::error,
                              "too-many-diagnostics",
                              {},
                              "what else is wrong is left out",
                              limit_help(most_, &Limits::diagnostics),
                              {},
                              false});
        }
        return nowhere_ = std::move(diagnostic);
    }
    return items_.emplace_back(std::move(diagnostic));
}

Diagnostic& Diagnostics::error(std::string_view code, Span span, std::string message, std::string help) {
    return add({Severity::error, std::string(code), span, std::move(message), std::move(help), {}, true});
}

Diagnostic& Diagnostics::warning(std::string_view code, Span span, std::string message, std::string help) {
    return add({Severity::warning, std::string(code), span, std::move(message), std::move(help), {}, true});
}

Diagnostic& Diagnostics::error(std::string_view code, std::string message, std::string help) {
    return add({Severity::error, std::string(code), {}, std::move(message), std::move(help), {}, false});
}

Diagnostic& Diagnostics::warning(std::string_view code, std::string message, std::string help) {
    return add({Severity::warning, std::string(code), {}, std::move(message), std::move(help), {}, false});
}

void Diagnostics::add_once(Diagnostic diagnostic) {
    const auto same = ranges::find_if(items_, [&](const Diagnostic& d) {
        return d.has_span && d.span.file == diagnostic.span.file && d.code == diagnostic.code &&
               d.message == diagnostic.message && d.help == diagnostic.help;
    });
    if (same == items_.end()) {
        add(std::move(diagnostic));
    } else if (!same->is_at(diagnostic.code, diagnostic.span)) {
        if (diagnostic.span.begin < same->span.begin) std::swap(diagnostic.span, same->span);
        same->fixes.insert(same->fixes.end(), diagnostic.fixes.begin(), diagnostic.fixes.end());
        same->also.push_back(diagnostic.span);
    }
}

void Diagnostics::append(const Diagnostics& others) {
    const std::size_t count = others.items_.size();  // `others` may be this
    for (std::size_t i = 0; i < count; ++i) add(Diagnostic(others.items_[i]));
}

void Diagnostics::sort() {
    std::stable_sort(items_.begin(), items_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        if (a.has_span != b.has_span) return a.has_span;
        if (!a.has_span) return false;
        return a.span.file != b.span.file ? a.span.file < b.span.file : a.span.begin < b.span.begin;
    });
}

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
    if (word.empty() || word.size() > longest_word) return {};
    const int allowed = word.size() <= 3 ? 1 : std::min(3, static_cast<int>(word.size() + 2) / 3);
    std::string_view best;
    int best_distance = allowed + 1;
    for (const std::string_view candidate : candidates) {
        if (candidate.size() > longest_word) continue;
        if (std::abs(static_cast<int>(candidate.size()) - static_cast<int>(word.size())) >= best_distance) continue;
        const int d = distance(word, candidate);
        // A candidate that shares no letter with the word is not what the user meant.
        if (d < best_distance && d < static_cast<int>(std::max(word.size(), candidate.size()))) {
            best = candidate;
            best_distance = d;
        }
    }
    return best;
}

Diagnostic& Collector::add(Severity severity, std::string_view code, Span span, std::string message, std::string help) {
    if (!full())
        return diagnostics_.add({severity, std::string(code), span, std::move(message), std::move(help), {}, true});
    if (left_out_++ == 0) first_left_out_ = span;
    nowhere_ = {};
    return nowhere_;
}

Diagnostics Collector::take() {
    diagnostics_.sort();
    if (left_out_ > 0)
        diagnostics_.error("too-many-diagnostics", first_left_out_,
                           "from here on " + std::to_string(left_out_) + " more diagnostics are left out",
                           "--limit diagnostics=N changes how many are kept");
    return std::move(diagnostics_);
}

// Diagnostics as text for people.
namespace {

constexpr int tab_stop = 4;
constexpr int widest = 120;  // columns of source shown; longer lines are cut around the span

// Marks a range of the line's bytes. Only the visible part of the line is read, because a line may be the whole file.
MarkedLine mark(std::string_view line, std::size_t begin, std::size_t end) {
    MarkedLine shown;
    const std::size_t context = 48;
    std::size_t i = line.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    const bool cut_left = begin > widest - context && line.size() > widest;
    if (cut_left) {
        i = begin - context;
        while (i < begin && (static_cast<unsigned char>(line[i]) & 0xC0) == 0x80) ++i;
        shown.text = "...";
    }
    int column = static_cast<int>(shown.text.size());
    shown.begin = shown.end = column;
    while (i < line.size()) {
        if (i <= begin) shown.begin = column;
        if (i <= end) shown.end = column;
        if (column >= widest) {
            shown.text += "...";
            shown.begin = std::min(shown.begin, widest);
            shown.end = std::min(shown.end, widest);
            return shown;
        }
        const utf8::Char c = utf8::decode(line, i);
        const std::string_view bytes = line.substr(i, c.length);
        i += c.length;
        if (c.code == '\t') {
            const int blanks = tab_stop - column % tab_stop;
            shown.text.append(static_cast<std::size_t>(blanks), ' ');
            column += blanks;
        } else if (utf8::hidden(c.code)) {
            const std::string escape = utf8::printable(bytes);
            shown.text += escape;
            column += static_cast<int>(escape.size());
        } else {
            utf8::append(shown.text, c.code);
            column += utf8::width(c.code);
        }
    }
    if (begin >= line.size()) shown.begin = column;
    if (end >= line.size()) shown.end = column;
    return shown;
}

Finding found(Severity severity, const std::string& message, const Span* span, const Sources& sources) {
    Finding finding{.severity = severity, .message = utf8::printable(message)};
    if (!span || span->file >= sources.size()) return finding;
    const Position at = sources.position(span->file, span->begin);
    finding.file = utf8::printable(sources.name(span->file));
    finding.at = at;
    const std::string_view text = sources.text(span->file);
    const std::string_view line = sources.line(span->file, at.line);
    if (line.data() == nullptr || text.empty()) return finding;
    const auto base = static_cast<std::size_t>(line.data() - text.data());
    const std::size_t begin = std::min<std::size_t>(span->begin < base ? 0 : span->begin - base, line.size());
    const std::size_t end = std::clamp<std::size_t>(span->end < base ? 0 : span->end - base, begin, line.size());
    finding.source = mark(line, begin, end);
    return finding;
}

// "also on lines 12, 14 and 88 others"; nothing where all places are on the line that is shown.
std::string other_lines(const Diagnostic& diagnostic, const Sources& sources) {
    constexpr std::size_t most = 6;
    std::vector<int> lines;
    for (const Span& span : diagnostic.also) lines.push_back(sources.position(span.file, span.begin).line);
    ranges::sort(lines);
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    std::erase(lines, sources.position(diagnostic.span.file, diagnostic.span.begin).line);
    if (lines.empty()) return {};
    const std::size_t shown = lines.size() > most ? 2 : lines.size();
    std::string text = lines.size() == 1 ? "also on line " : "also on lines ";
    for (std::size_t i = 0; i < shown; ++i) {
        if (i > 0) text += i + 1 == lines.size() ? " and " : ", ";
        text += std::to_string(lines[i]);
    }
    if (shown < lines.size()) text += " and " + std::to_string(lines.size() - shown) + " others";
    return text;
}

}  // namespace

Finding describe(const Diagnostic& diagnostic, const Sources& sources) {
    Finding finding =
        found(diagnostic.severity, diagnostic.message, diagnostic.has_span ? &diagnostic.span : nullptr, sources);
    if (!diagnostic.code.empty()) finding.message += " [" + diagnostic.code + "]";
    if (!diagnostic.also.empty()) finding.also = other_lines(diagnostic, sources);
    finding.help = utf8::printable(diagnostic.help);
    for (const Note& note : diagnostic.notes)
        finding.notes.push_back(found(Severity::note, note.message, &note.span, sources));
    return finding;
}

std::string place_text(const Finding& finding) {
    if (!finding.at) return {};
    return finding.file + ":" + std::to_string(finding.at->line) + ":" + std::to_string(finding.at->column);
}

std::string headline(const Finding& finding) {
    const std::string place = place_text(finding);
    return (place.empty() ? "" : place + ": ") + name(finding.severity) + ": " + finding.message;
}

std::string margin(int line) {
    constexpr std::size_t width = 5;
    const std::string number = std::to_string(line);
    return std::string(width - std::min(width, number.size()), ' ') + number + " | ";
}

std::string carets(const MarkedLine& line) {
    std::string text(static_cast<std::size_t>(line.begin), ' ');
    text += '^';
    return text.append(static_cast<std::size_t>(std::max(0, line.end - line.begin - 1)), '~');
}

std::string render(const Finding& finding) {
    std::string out = headline(finding) + "\n";
    if (finding.source) {
        const std::string left = margin(finding.at->line);
        out += left + finding.source->text + "\n";
        out += std::string(left.size() - 3, ' ') + " | " + carets(*finding.source) + "\n";
    }
    if (!finding.also.empty()) out += "   " + finding.also + "\n";
    if (!finding.help.empty()) out += "   help: " + finding.help + "\n";
    for (const Finding& note : finding.notes) out += render(note);
    return out;
}

std::string render(const Diagnostic& diagnostic, const Sources& sources) {
    return render(describe(diagnostic, sources));
}

std::string render(const Diagnostics& diagnostics, const Sources& sources) {
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics.items()) out += render(diagnostic, sources);
    return out;
}

}  // namespace snell
