// Options that several subcommands share, and the checks of their values.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
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
inline const std::vector<std::string_view> access_options{"--limit", "--confine", "--allow", "--instead"};
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
// --view: turned and moved. `text` says how.
void add_view(CLI::App& command, std::string& view, const std::string& text);

// True if no other options than the `fitting` ones are given. Otherwise prints "WHAT excludes OPTION: WHY". For options
// that exclude most others: CLI11's excludes() would have --help print them next to every option.
bool excludes_others(const CLI::App& command, const std::vector<std::string_view>& fitting, std::string_view what,
                     std::string_view why);

// Prints an error and returns false if the size exceeds the limit on pictures.
bool size_fits(const Size& size, const Limits& most);

}  // namespace snell::app
