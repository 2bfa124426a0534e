// Opens a file in the user's editor, at a line, without a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace snell {

// $VISUAL, else $EDITOR, else "xdg-open". Blanks separate arguments; nothing else is special.
std::string editor_of_environment();

struct EditorCommand {
    std::vector<std::string> words;  // the program, then its arguments
    bool terminal = false;           // it draws into one
};
// The line and the column, 1-based, are told to editors that are known by the name of their program; others get the
// file alone. `file` must not begin with '-' or '+'.
EditorCommand editor_command(std::string_view editor, const std::string& file, int line, int column);

// Runs editors beside the window and does not wait for them; they stay when it closes.
class Editor {
public:
    explicit Editor(std::string name = editor_of_environment()) : name_(std::move(name)) {}

    const std::string& name() const { return name_; }
    // Says what became of it.
    std::string open(const std::string& file, int line, int column);
    // To be called now and then. What has to be said of one that failed; else "".
    std::string look();

private:
    struct Running {
        pid_t process = 0;
        std::string name;
    };
    std::string name_;
    std::vector<Running> running_;
};

}  // namespace snell
