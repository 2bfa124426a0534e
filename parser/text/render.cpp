// Diagnostics as text for people.
#include <algorithm>
#include <string>

#include "parser/text/diagnostic.h"
#include "parser/text/utf8.h"

namespace snell {
namespace {

constexpr int tab_stop = 4;
constexpr int widest = 120;  // columns of source shown; longer lines are cut around the span

// A line as it is shown, and the columns at which a range of its bytes stands there.
struct Shown {
    std::string text;
    int begin = 0, end = 0;
};

// Only the part of the line that can be seen is looked at: a line may be the whole file.
Shown show(std::string_view line, std::size_t begin, std::size_t end) {
    Shown shown;
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

std::string right(int number, std::size_t width) {
    std::string text = std::to_string(number);
    if (text.size() < width) text.insert(0, width - text.size(), ' ');
    return text;
}

void place(std::string& out, Span span, const Sources& sources, Severity severity, const std::string& message,
           const std::string& code) {
    const Position at = sources.position(span.file, span.begin);
    out += utf8::printable(sources.name(span.file)) + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
           ": " + name(severity) + ": " + utf8::printable(message);
    if (!code.empty()) out += " [" + code + "]";
    out += "\n";
    const std::string_view text = sources.text(span.file);
    const std::string_view line = sources.line(span.file, at.line);
    if (line.data() == nullptr || text.empty()) return;
    const auto base = static_cast<std::size_t>(line.data() - text.data());
    const std::size_t begin = std::min<std::size_t>(span.begin < base ? 0 : span.begin - base, line.size());
    const std::size_t end = std::clamp<std::size_t>(span.end < base ? 0 : span.end - base, begin, line.size());
    const Shown shown = show(line, begin, end);
    const std::string number = right(at.line, 5);
    out += number + " | " + shown.text + "\n";
    out.append(number.size(), ' ');
    out += " | ";
    out.append(static_cast<std::size_t>(shown.begin), ' ');
    out += '^';
    out.append(static_cast<std::size_t>(std::max(0, shown.end - shown.begin - 1)), '~');
    out += "\n";
}

// "also on lines 12, 14 and 88 others"; nothing where all places are on the line that is shown.
std::string other_lines(const Diagnostic& diagnostic, const Sources& sources) {
    constexpr std::size_t most = 6;
    std::vector<int> lines;
    for (const Span& span : diagnostic.also) lines.push_back(sources.position(span.file, span.begin).line);
    std::ranges::sort(lines);
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
    return "   " + text + "\n";
}

}  // namespace

std::string render(const Diagnostic& diagnostic, const Sources& sources) {
    std::string out;
    if (diagnostic.has_span && diagnostic.span.file < sources.size()) {
        place(out, diagnostic.span, sources, diagnostic.severity, diagnostic.message, diagnostic.code);
    } else {
        out = std::string(name(diagnostic.severity)) + ": " + utf8::printable(diagnostic.message);
        if (!diagnostic.code.empty()) out += " [" + diagnostic.code + "]";
        out += "\n";
    }
    if (!diagnostic.also.empty()) out += other_lines(diagnostic, sources);
    if (!diagnostic.help.empty()) out += "   help: " + utf8::printable(diagnostic.help) + "\n";
    for (const Note& note : diagnostic.notes) place(out, note.span, sources, Severity::note, note.message, "");
    return out;
}

std::string render(const Diagnostics& diagnostics, const Sources& sources) {
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics.items()) out += render(diagnostic, sources);
    return out;
}

}  // namespace snell
