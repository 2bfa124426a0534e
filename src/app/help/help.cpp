#include "src/app/help/help.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <filesystem>
#include <memory>

#include "parser/commands/commands.h"
#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "src/app/help/pages.h"
#include "src/app/help/program.h"
#include "src/app/open/complain.h"
#include "src/app/open/exit_status.h"
#include "src/lint/lint.h"

namespace snell::app {

namespace {

struct Heading {
    std::size_t begin = 0;  // offset of its line
    std::size_t level = 0;
    std::string_view text;
};

std::vector<Heading> headings(std::string_view page) {
    std::vector<Heading> found;
    bool code = false;
    for (std::size_t at = 0; at < page.size();) {
        const std::size_t end = std::min(page.find('\n', at), page.size());
        const std::string_view line = page.substr(at, end - at);
        if (line.starts_with("```")) code = !code;
        const std::size_t level = std::min(line.find_first_not_of('#'), line.size());
        if (!code && level > 0 && level < line.size() && line[level] == ' ')
            found.push_back({at, level, line.substr(level + 1)});
        at = end + 1;
    }
    return found;
}

std::string anchor_of(std::string_view heading) {
    std::string anchor;
    for (const char c : heading)
        if (c == ' ')
            anchor += '-';
        else if (c == '-' || c == '_' || std::isalnum(static_cast<unsigned char>(c)))
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return anchor;
}

const lint::RuleFacts* rule_of(std::string_view code) {
    const auto rules = lint::rules();
    const auto found = ranges::find(rules, code, &lint::RuleFacts::code);
    return found == rules.end() ? nullptr : &*found;
}

const CLI::App* subcommand(const CLI::App& program, const std::string& name) {
    const auto found = program.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
    return found.empty() ? nullptr : found.front();
}

// Prints what is known under this name; returns false if nothing is.
bool print_help(const CLI::App& program, const std::string& name) {
    if (name.empty()) {
        // Not program.help(), which prints the help of the subcommand that was parsed: of this one.
        const auto formatter = program.get_formatter();
        fmt::print("{}", formatter->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal));
    } else if (const CLI::App* command = subcommand(program, name)) {
        fmt::print("{}", command->help("snell"));
    } else if (const std::string text = explanation(name); !text.empty()) {
        fmt::print("{}", text);
    } else if (const Command* row = find_command(name)) {
        fmt::print("{}\n", described(*row));
    } else {
        return false;
    }
    return true;
}

Exit help(const CLI::App& program, const std::string& name) {
    if (print_help(program, name)) return exit_fine;
    std::vector<std::string_view> known = subcommand_names();
    for (const auto& more : {explained_codes(), command_names()}) known.insert(known.end(), more.begin(), more.end());
    const std::string_view near = nearest(name, known);
    return complain(exit_usage, fmt::format("there is no subcommand, command of the language or code '{}'", name),
                    near.empty() ? "'snell help' lists the subcommands, 'snell commands' the language"
                                 : fmt::format("did you mean '{}'?", near));
}

}  // namespace

std::string_view section(std::string_view page, std::string_view anchor) {
    const std::vector<Heading> all = headings(page);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (anchor_of(all[i].text) != anchor) continue;
        std::size_t next = i + 1;
        while (next < all.size() && all[next].level > all[i].level) ++next;
        const std::size_t end = next < all.size() ? all[next].begin : page.size();
        return page.substr(all[i].begin, end - all[i].begin);
    }
    return {};
}

std::string explanation(std::string_view code) {
    if (const lint::RuleFacts* rule = rule_of(code))
        return fmt::format("# {}\n\nFinds {}. Instead, {}.\n\n{}", rule->code, rule->finds, rule->instead,
                           section(embedded_page("teaching.md"), rule->anchor));
    return std::string(section(embedded_page("diagnostics.md"), code));
}

std::vector<std::string_view> explained_codes() {
    std::vector<std::string_view> codes;
    for (const lint::RuleFacts& rule : lint::rules()) codes.push_back(rule.code);
    for (const Heading& heading : headings(embedded_page("diagnostics.md")))
        if (heading.level == 3) codes.push_back(heading.text);
    return codes;
}

std::string_view meant_subcommand(std::string_view word) {
    if (word.empty() || word.starts_with('-') || word.find_first_of("./") != word.npos) return {};
    const std::vector<std::string_view> names = subcommand_names();
    std::error_code none;
    if (ranges::find(names, word) != names.end() || word == "complete" || std::filesystem::exists(word, none))
        return {};
    return nearest(word, names);
}

Run add_help(CLI::App& command) {
    auto name = std::make_shared<std::string>();
    command.add_option("NAME", *name, "a subcommand, the code of a message, or a command of the language");
    return [name, &command] { return help(*command.get_parent(), *name); };
}

}  // namespace snell::app
