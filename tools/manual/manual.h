// Manual pages and completions, from the command line as CLI11 knows it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace snell::manual {

struct File {
    std::string path, text;
};

// How the value of an option is completed.
enum class Value {
    none,     // a flag
    text,     // cannot be completed
    choice,   // one of `choices`
    file,     // any file
    folder,   // any folder
    scene,    // a .glib file, or a folder on the way to one
    uniform,  // the rest are asked of `snell complete`, with the scene on the line
    rung,
    ladder,
    axis,
    name,  // what `snell help` explains
};

struct Option {
    std::vector<std::string> short_names, long_names;  // with their dashes
    std::string argument;                              // in the manual: "UNIFORM=VALUE"
    std::string doc;
    Value value = Value::none;
    std::vector<std::string> choices;
    bool repeated = false;
};

struct Command {
    std::string name;  // empty: the program itself
    std::string doc, synopsis, notes;
    std::vector<Option> options, positionals;
};

// The program itself, and every subcommand that users see.
std::vector<Command> described(const CLI::App& program);

std::vector<File> pages(const std::vector<Command>& commands, const std::string& version, const std::string& date);
// The functions that a shell needs apart from the tables: "functions.bash" or "functions.zsh".
std::string_view shell_functions(std::string_view path);

std::string bash(const std::vector<Command>& commands);
std::string zsh(const std::vector<Command>& commands);
std::string fish(const std::vector<Command>& commands);

}  // namespace snell::manual
