#include "src/app/open/complain.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <memory>

#include "src/content/process.h"

namespace snell {

namespace {

constexpr std::string_view bold = "\x1b[1m", plain = "\x1b[0m", cyan = "\x1b[36m";

struct Kind {
    std::string_view word, color;
};
constexpr std::array kinds{Kind{"error: ", "\x1b[1;31m"}, Kind{"warning: ", "\x1b[1;35m"},
                           Kind{"note: ", "\x1b[1;36m"}};

bool is_set(const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
}

// The length of "snell: ", "FILE:LINE:COLUMN: " or nothing, which the word of severity at `at` follows.
bool is_place(std::string_view text) {
    if (text.empty() || text == "snell: ") return true;
    if (!text.ends_with(": ")) return false;
    text.remove_suffix(2);
    for (int i = 0; i < 2; ++i) {
        const std::size_t colon = text.rfind(':');
        if (colon == text.npos || colon + 1 == text.size()) return false;
        if (text.find_first_not_of("0123456789", colon + 1) != text.npos) return false;
        text = text.substr(0, colon);
    }
    return !text.empty() && text.front() != '"' && text.front() != ' ';
}

// The number of a line and a bar, or only the bar.
bool has_margin(std::string_view line, bool number) {
    const std::size_t bar = line.find(" | ");
    if (bar == line.npos) return false;
    const std::string_view left = line.substr(0, bar);
    return left.find_first_not_of(number ? " 0123456789" : " ") == left.npos;
}

std::string in(std::string_view color, std::string_view text) { return std::string(color).append(text).append(plain); }

// A stream's lines, on their way to a file.
struct Lines {
    int file = -1;
    Painter painter;
    std::string begun;  // a line whose end has not come yet
};

ssize_t take(void* cookie, const char* bytes, std::size_t count) {
    Lines& lines = *static_cast<Lines*>(cookie);
    std::string out;
    std::string_view text(bytes, count);
    for (std::size_t end; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1)) {
        lines.begun += text.substr(0, end);
        out += lines.painter.painted(lines.begun) + "\n";
        lines.begun.clear();
    }
    lines.begun += text;
    // A bar of progress has no end of line. It is no message, and shall be seen at once.
    if (lines.begun.starts_with('\r')) {
        out += lines.begun;
        lines.begun.clear();
    }
    return content::write_all(lines.file, out).empty() ? static_cast<ssize_t>(count) : 0;
}

int finish(void* cookie) {
    const std::unique_ptr<Lines> lines(static_cast<Lines*>(cookie));
    return content::write_all(lines->file, lines->begun).empty() ? 0 : EOF;
}

}  // namespace

bool wants_color(std::string_view when, bool terminal) {
    if (when != "auto") return when == "always";
    if (is_set("NO_COLOR")) return false;
    if (is_set("CLICOLOR_FORCE") && std::string_view(std::getenv("CLICOLOR_FORCE")) != "0") return true;
    const char* kind = std::getenv("TERM");
    return terminal && kind && std::string_view(kind) != "dumb";
}

std::string Painter::painted(std::string_view line) {
    for (const Kind& kind : kinds) {
        const std::size_t at = line.find(kind.word);
        if (at == line.npos || !is_place(line.substr(0, at))) continue;
        next_ = Next::source;
        color_ = kind.color;
        const std::string_view rest = line.substr(at + kind.word.size() - 1);
        return in(bold, line.substr(0, at)) + in(color_, kind.word.substr(0, kind.word.size() - 1)) + in(bold, rest);
    }
    if (next_ == Next::source && has_margin(line, true)) {
        next_ = Next::carets;
        return std::string(line);
    }
    if (next_ == Next::carets && has_margin(line, false)) {
        next_ = Next::help;
        const std::size_t marks = std::min(line.find_first_of("^~"), line.size());
        return std::string(line.substr(0, marks)) + in(color_, line.substr(marks));
    }
    constexpr std::string_view help = "   help: ";
    if (next_ != Next::anything && line.starts_with(help))
        return in(cyan, help.substr(0, help.size() - 1)) + std::string(line.substr(help.size() - 1));
    if (!line.starts_with("   also on line")) next_ = Next::anything;
    return std::string(line);
}

void paint(std::FILE*& stream) {
    const int file = fileno(stream);
    std::fflush(stream);
    auto lines = std::make_unique<Lines>(Lines{file, {}, {}});
    const cookie_io_functions_t functions{.read = nullptr, .write = take, .seek = nullptr, .close = finish};
    std::FILE* painted = fopencookie(lines.get(), "w", functions);
    if (!painted) return;
    static_cast<void>(lines.release());  // it belongs to the stream, which lives as long as the process
    setvbuf(painted, nullptr, stream == stderr ? _IONBF : _IOLBF, BUFSIZ);  // as they were
    stream = painted;
}

}  // namespace snell
