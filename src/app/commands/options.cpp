#include "src/app/commands/options.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "parser/text/ranges.h"
#include "src/accuracy/report/quality.h"
#include "src/app/open/complain.h"
#include "src/app/open/headless.h"
#include "src/content/files.h"
#include "src/content/text_forms.h"
#include "src/plan/setup.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

bool parse_size(const std::string& text, std::pair<int, int>& size) {
    int end = 0;
    return std::sscanf(text.c_str(), "%9dx%9d%n", &size.first, &size.second, &end) == 2 &&
           static_cast<size_t>(end) == text.size() && size.first > 0 && size.second > 0;
}

std::string check_size(const std::string& text) {
    std::pair<int, int> size;
    return parse_size(text, size) ? "" : "'" + text + "' is not WIDTHxHEIGHT in whole pixels, such as 800x600";
}

std::string check_limit(const std::string& text) {
    Limits limits;
    std::string error;
    return set_limit(limits, text, error) ? "" : error;
}

std::string check_context(const std::string& text) {
    ContextRequest request;
    return parse_context(text, request) ? "" : "'" + text + "' is not a version such as 3.3, 4.5 or es3.2";
}

CLI::Option* repeated(CLI::Option* option) {
    return option->expected(1)
        ->allow_extra_args(false)  // otherwise an option in front of the scene's name takes the name, too
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

// By the clock of files. A time in the future does not count as an edit.
bool written_between(const std::string& path, fs::file_time_type begin, fs::file_time_type end) {
    std::error_code error;
    const auto written = fs::last_write_time(path, error);
    return !error && written > begin && written <= end;
}

// Texts by path, as JSON, without those whose files were saved since it was written: a window that is started again
// reads it again.
std::shared_ptr<const std::map<std::string, std::string>> texts_in(const std::string& file) {
    auto texts = std::make_shared<std::map<std::string, std::string>>();
    const auto json = content::parse_json(content::whole_file(file));
    if (!json.is_object()) throw CLI::ValidationError("--instead", fmt::format("'{}' is not a JSON object", file));
    std::error_code error;
    const auto given = fs::last_write_time(file, error);
    const auto now = fs::file_time_type::clock::now();
    for (const auto& [path, text] : json.items())
        if (text.is_string() && (error || !written_between(path, given, now)))
            texts->emplace(path, text.get<std::string>());
    return texts;
}

}  // namespace

// CLI11 accepts "nan" and "inf" as numbers, so they are refused here.
std::string check_finite_number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return *end == '\0' && std::isfinite(value) ? "" : "'" + text + "' is not a finite number";
}

std::string check_positive(const std::string& text) {
    const std::string error = check_finite_number(text);
    return !error.empty() || std::strtod(text.c_str(), nullptr) > 0 ? error : "'" + text + "' is not more than 0";
}

std::string check_file_name(const std::string& text) { return text.empty() ? "the name of the file is empty" : ""; }

CLI::Option* add_repeated(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                          const std::string& text) {
    return repeated(command.add_option(name, values, text));
}

CLI::Option* add_size(CLI::App& command, Size& size, const std::string& text) {
    return command
        .add_option_function<std::string>(
            "--size", [&size](const std::string& value) { parse_size(value, size.emplace()); }, text)
        ->check(check_size);
}

void add_limits(CLI::App& command, Limits& limits) {
    const auto set = [&limits](const std::vector<std::string>& values) {
        std::string checked;
        for (const std::string& value : values) set_limit(limits, value, checked);
    };
    repeated(command.add_option_function<std::vector<std::string>>(
                 "--limit", set, "change a limit on what a scene may use; may be repeated"))
        ->check(check_limit);
}

void add_access(CLI::App& command, Access& access) {
    add_limits(command, access.limits);
    command
        .add_option_function<std::string>(
            "--confine", [&access](const std::string& folder) { access.confine = folder; },
            "read nothing outside of this folder")
        ->check(CLI::ExistingDirectory);
    add_repeated(command, "--allow", access.allow,
                 "with --confine or --grade: read this folder, too, where files are found by name; may be repeated")
        ->check(CLI::ExistingDirectory);
    // For editors, whose texts are not written yet (src/app/lsp).
    command
        .add_option_function<std::string>("--instead",
                                          [&access](const std::string& file) { access.instead = texts_in(file); })
        ->group("");
}

void add_grade(CLI::App& command, bool& grade) {
    command.add_flag("--grade", grade, "for scenes of strangers: read nothing outside of each scene's folder");
}

CLI::Option* add_json(CLI::App& command, std::string& file, const std::string& text) {
    return command.add_flag("--json{/dev/stdout}", file, text + "; --json=FILE writes them to a file")
        ->check(check_file_name);
}

void add_timeout(CLI::App& command, double& seconds, const std::string& what) {
    command.add_option("--timeout", seconds, "seconds for " + what + "; 0: no end")
        ->check(check_finite_number)
        ->check(CLI::Range(0., 1e6));
}

void add_specialise(CLI::App& command, bool& specialise) {
    command.add_flag("--no-specialise{false}", specialise,
                     "compile programs that take any values of their uniforms, not for the values that they have");
}

void add_values(CLI::App& command, std::vector<std::string>& sets, std::vector<std::string>& ladders) {
    add_repeated(command, "--set", sets, "uniform=value or Program.uniform=value; may be repeated");
    add_repeated(command, "--ladder", ladders, "ladder=rung; may be repeated");
}

void add_quality(CLI::App& command, std::string& quality) {
    command.add_option("--quality", quality, "rungs as `snell accuracy --save-quality` found them")
        ->check(
            CLI::IsMember(std::vector<std::string>(accuracy::quality_names.begin(), accuracy::quality_names.end())));
}

void add_context(CLI::App& command, std::string& context) {
    command.add_option("--context", context, "ask for an OpenGL version: 3.3, 4.5, es3.2")->check(check_context);
}

void add_time(CLI::App& command, double& seconds) {
    command.add_option("--time", seconds, "seconds since the scene began")->check(check_finite_number);
}

void add_view(CLI::App& command, std::string& view, const std::string& text) {
    const auto check = [](const std::string& given) {
        View parsed;
        return parse_view(given, parsed);
    };
    command.add_option("--view", view, text)->check(check);
}

bool excludes_others(const CLI::App& command, const std::vector<std::string_view>& fitting, std::string_view what,
                     std::string_view why) {
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0 && ranges::find(fitting, option->get_name()) == fitting.end())
            return complain(fmt::format("{} excludes {}: {}", what, option->get_name(), why));
    return true;
}

bool size_fits(const Size& size, const Limits& most) {
    if (!size || static_cast<std::uint64_t>(std::max(size->first, size->second)) <= most.output_side) return true;
    return complain(fmt::format("{}x{} is too large", size->first, size->second),
                    limit_help(most, &Limits::output_side));
}

}  // namespace snell::app
