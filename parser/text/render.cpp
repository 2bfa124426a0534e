// Diagnostics as text for people.
#include <algorithm>
#include <string>

#include "parser/text/diagnostic.h"
#include "parser/text/finding.h"
#include "parser/text/ranges.h"
#include "parser/text/utf8.h"

namespace snell {
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
