// Explanations for the command line: `snell help`, and what shells ask to complete a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/app/commands/subcommands.h"

namespace snell::app {

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
