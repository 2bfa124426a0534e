// Options that several subcommands share, and the checks of their values.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/plan/files.h"

namespace snell::app {

using Size = std::optional<std::pair<int, int>>;  // pixels

// Each check returns an empty string, or what is wrong with the text.
std::string check_finite_number(const std::string& text);
std::string check_positive(const std::string& text);
std::string check_file_name(const std::string& text);

// An option that may be repeated, with one value each time.
CLI::Option* add_repeated(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                          const std::string& text);
CLI::Option* add_size(CLI::App& command, Size& size, const std::string& text);
// --limit: how much a scene may take.
void add_limits(CLI::App& command, Limits& limits);
// --limit, --confine and --allow: what a scene may read, and how much.
void add_access(CLI::App& command, Access& access);
void add_grade(CLI::App& command, bool& grade);
// --json, alone or as --json=FILE: `file` is then "/dev/stdout", or the name (see meant_words in help/program.h).
CLI::Option* add_json(CLI::App& command, std::string& file, const std::string& text);
// `what` completes the sentence "seconds for …".
void add_timeout(CLI::App& command, double& seconds, const std::string& what);
void add_specialise(CLI::App& command, bool& specialise);
void add_values(CLI::App& command, std::vector<std::string>& sets, std::vector<std::string>& ladders);
void add_quality(CLI::App& command, std::string& quality);
void add_context(CLI::App& command, std::string& context);
void add_time(CLI::App& command, double& seconds);

// Prints an error and returns false if the size exceeds the limit on pictures.
bool size_fits(const Size& size, const Limits& most);

}  // namespace snell::app
