// Errors of commands on standard error, colours of messages on a terminal, and the exit status of every command.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "parser/text/words.h"
#include "src/content/replace.h"

namespace snell::app {

// The exit status of every command.
enum Exit { exit_fine = 0, exit_input = 1, exit_usage = 2, exit_graphics = 3, exit_timeout = 4, exit_lost = 5 };

// Prints the error, and what to do about it on a line of its own, with hidden characters escaped. Without `help`, that
// may follow in `what`, after "\n   help: ". Returns false.
inline bool complain(std::string_view what, std::string_view help = {}) {
    constexpr std::string_view mark = "\n   help: ";
    const std::size_t at = what.find(mark);
    if (help.empty() && at != what.npos) help = what.substr(at + mark.size());
    fmt::print(stderr, "snell: error: {}\n", utf8::printable(what.substr(0, at)));
    if (!help.empty()) fmt::print(stderr, "   help: {}\n", utf8::printable(help));
    return false;
}
inline Exit complain(Exit status, std::string_view what, std::string_view help = {}) {
    complain(what, help);
    return status;
}

// `wrong`, which is why the file cannot be written, may begin with its name. Returns false.
inline bool cannot_write(std::string_view file, std::string_view wrong) {
    if (wrong.starts_with(file) && wrong.substr(file.size()).starts_with(": ")) wrong.remove_prefix(file.size() + 2);
    return complain(fmt::format("cannot write '{}': {}", file, wrong));
}

// Writes a whole file, or to a pipe or device. Prints why it cannot, and returns false then.
inline bool write_output(const std::string& file, std::string_view bytes) {
    const std::string wrong = content::replace_file(file, bytes);
    return wrong.empty() || cannot_write(file, wrong);
}

}  // namespace snell::app

namespace snell {

// Whether a stream gets colours: `when` is "auto", "always" or "never". In "auto", the environment's NO_COLOR and
// CLICOLOR_FORCE decide before `terminal` does.
bool wants_color(std::string_view when, bool terminal);

// Colours lines of text, one after another. A line that does not belong to a message stays as it is, and no line loses
// or gains a character other than escape sequences.
class Painter {
public:
    std::string painted(std::string_view line);

private:
    enum class Next { anything, source, carets, help };
    Next next_ = Next::anything;
    std::string_view color_;  // of the message whose lines follow
};

// Replaces a stream of the C library by one that colours its lines and writes them to the same file.
void paint(std::FILE*& stream);

}  // namespace snell
