// Opens a file in the user's editor at a line, without a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/content/process.h"

namespace snell {

// Returns $VISUAL, otherwise $EDITOR, otherwise "xdg-open". Blanks separate arguments; there is no other syntax.
std::string editor_of_environment();

struct EditorCommand {
    std::vector<std::string> words;  // the program, then its arguments
    bool terminal = false;           // the editor needs a terminal
};
// Editors that are known by their program's name get the line and the column, both 1-based; others get only the file.
// `file` must not begin with '-' or '+'.
EditorCommand editor_command(std::string_view editor, const std::string& file, int line, int column);

// The outcome of starting an editor; exactly one of the texts is empty. Both are printable.
struct Started {
    std::string program;  // that opens the file
    std::string error;
};

// Starts editors without waiting for them; they stay open when the window closes.
class Editor {
public:
    explicit Editor(std::string name = editor_of_environment()) : name_(std::move(name)) {}

    // For people: xdg-open is what they never named.
    const std::string& name() const {
        static const std::string desktop = "the desktop's editor";
        return name_ == "xdg-open" ? desktop : name_;
    }
    // Empty: that of the environment.
    void set(const std::string& name) { name_ = name.empty() ? editor_of_environment() : name; }
    Started open(const std::string& file, int line, int column);
    // Call it regularly. Returns a message if an editor failed, otherwise "".
    std::string look();

private:
    struct Running {
        content::Process process;  // in a session of its own, so that Ctrl-C in snell's terminal does not end it
        std::string name;
    };
    std::string name_;
    std::vector<Running> running_;
};

}  // namespace snell
