// Colours of messages on a terminal.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

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
