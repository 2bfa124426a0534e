// The program as CLI11 sees it: the table of subcommands, and what reads the command line by it. tools/manual writes
// manual pages and completions from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/app/commands/subcommands.h"

namespace snell::app {

struct Subcommand {
    const char* name;
    const char* summary;
    Run (*add)(CLI::App& command);
    const char* examples;  // lines for --help that run in a folder with scenes/; may be empty
    bool hidden = false;   // for other programs, not for users
};

std::span<const Subcommand> subcommands();

// The names of the subcommands that users see.
std::vector<std::string_view> subcommand_names();

// What the command line asks for.
struct Request {
    Run run;
    std::string color = "auto";
};

// The words of the command line as options take them. `--json` takes a file or nothing, so the file is joined to it:
// the next word if it ends with .json or is a stream, and for subcommands that write nothing else to it any name that
// is no option and no scene. A single dash for a file that is written is standard output.
std::vector<std::string> meant_words(int count, const char* const* words);

// The first word of the command line behind --color: a subcommand, if it is the name of one; "" if there is none.
std::string_view first_word(int count, const char* const* words);

// The first word that begins with -- and is no option of the subcommand, or of the window, but nearly one.
struct Misspelt {
    std::string word, meant;
};
std::optional<Misspelt> misspelt_option(CLI::App& program, std::string_view first, int count, const char* const* words);

// Adds the options of the window and the subcommands; if `first`, the first word of a command line, names one, only of
// that one. `request` must live as long as `program`.
void describe(CLI::App& program, Request& request, std::string_view first = {});

// Reads the command line, and runs what it asks for. Tests call it in copies of their process. Returns the exit status.
int run(int argc, const char* const* argv);

// Explanations: `snell help`, and what shells ask to complete a word.

Run add_help(CLI::App& command);
Run add_complete(CLI::App& command);

// Returns the section of a Markdown page with this anchor, heading included, as GitHub names anchors. Returns "" if
// there is none.
std::string_view section(std::string_view page, std::string_view anchor);

// Returns the explanation of a diagnostic's code as Markdown, "" if there is none.
std::string explanation(std::string_view code);

// Every code that has an explanation.
std::vector<std::string_view> explained_codes();

// Returns the name of a subcommand if `word` looks like a mistake for it and is not a file; "" otherwise.
std::string_view meant_subcommand(std::string_view word);

// Pages of docs/ that the program has in itself, because an installation may lack docs/.

// Returns the text of "diagnostics.md" or "teaching.md", "" for other names.
std::string_view embedded_page(std::string_view name);

}  // namespace snell::app
