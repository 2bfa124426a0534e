#include "src/app/desktop/editor.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> split_command(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; (begin = text.find_first_not_of(" \t", begin)) != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
        words.emplace_back(text.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

// How a line is passed to some programs.
struct Known {
    std::string_view programs;                  // separated by blanks
    std::array<std::string_view, 2> arguments;  // with {file}, {line} and {column}; without {file} it comes last
    bool terminal = false;
};

constexpr std::string_view plus = "+{line}", plus_colon = "+{line}:{column}", colon = "{file}:{line}:{column}";
constexpr std::array known{
    Known{"vi vim nvim view pico joe jed mg ne", {plus}, true},
    Known{"nano", {"+{line},{column}"}, true},
    Known{"micro kak", {plus_colon}, true},
    Known{"hx helix", {colon}, true},
    Known{"gvim gedit pluma xed nedit geany", {plus}},
    Known{"emacs emacsclient", {plus_colon}},
    Known{"mousepad kate kwrite idea clion", {"--line", "{line}"}},
    Known{"code code-insiders codium vscodium cursor", {"--goto", colon}},
    Known{"subl sublime_text zed zeditor", {colon}},
};

void replace(std::string& text, std::string_view what, const std::string& by) {
    if (const std::size_t at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
}

bool runnable(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::string_view folders = path ? path : "/usr/local/bin:/usr/bin:/bin";
    while (!folders.empty()) {
        const std::string_view folder = folders.substr(0, folders.find(':'));
        folders.remove_prefix(std::min(folder.size() + 1, folders.size()));
        if (access(std::string(folder).append("/").append(program).c_str(), X_OK) == 0) return true;
    }
    return false;
}

}  // namespace

std::string editor_of_environment() {
    for (const char* name : {"VISUAL", "EDITOR"})
        if (const char* value = std::getenv(name); value && !split_command(value).empty()) return value;
    return "xdg-open";
}

EditorCommand editor_command(std::string_view editor, const std::string& file, int line, int column) {
    EditorCommand command{split_command(editor)};
    if (command.words.empty()) return command;
    const std::string program = fs::path(command.words[0]).filename().string();
    const auto found = ranges::find_if(
        known, [&](const Known& row) { return ranges::count(split_command(row.programs), program) > 0; });
    bool named = false;
    if (found != known.end()) {
        command.terminal = found->terminal;
        for (const std::string_view argument : found->arguments) {
            if (argument.empty()) break;
            std::string word(argument);
            replace(word, "{line}", std::to_string(line));
            replace(word, "{column}", std::to_string(column));
            named |= word.find("{file}") != std::string::npos;
            replace(word, "{file}", file);
            command.words.push_back(std::move(word));
        }
    }
    if (program == "emacs" || program == "emacsclient")
        command.terminal = ranges::any_of(
            command.words, [](const std::string& word) { return word == "-nw" || word == "-t" || word == "-tty"; });
    if (!named) command.words.push_back(file);
    return command;
}

Started Editor::open(const std::string& file, int line, int column) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return {{}, "there is no file " + utf8::printable(file)};
    const fs::path whole = fs::absolute(file, error);  // begins with '/'
    EditorCommand command = editor_command(name_, error ? file : whole.lexically_normal().string(), line, column);
    if (command.words.empty()) return {{}, "no editor is named"};
    const std::string name = utf8::printable(command.words[0]);
    if (command.terminal) {
        const std::string terminal = runnable("x-terminal-emulator") ? "x-terminal-emulator" : "xterm";
        if (!runnable(terminal))
            return {{}, name + " needs a terminal, and x-terminal-emulator and xterm are not there"};
        command.words.insert(command.words.begin(), {terminal, "-e"});
    }
    running_.push_back({{}, name});
    const std::string wrong = running_.back().process.start(command.words, {.stays = true});
    if (wrong.empty()) return {name, {}};
    running_.pop_back();
    return {{}, fmt::format("cannot start {}: {} (set VISUAL to an editor)", name, wrong)};
}

std::string Editor::look() {
    std::string said;
    std::erase_if(running_, [&](Running& editor) {
        const auto ended = editor.process.poll();
        if (ended && ended->status > 0)
            said = editor.name == "xdg-open"
                       ? fmt::format("no editor is set, and xdg-open ended with status {}", ended->status)
                       : fmt::format("{} ended with status {}", editor.name, ended->status);
        return ended.has_value();
    });
    return said;
}

}  // namespace snell
