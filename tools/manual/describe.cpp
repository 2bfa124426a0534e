// The command line as plain values.
#include <CLI/CLI.hpp>
#include <map>

#include "parser/commands/commands.h"
#include "parser/text/limits.h"
#include "parser/text/words.h"
#include "tools/manual/manual.h"

namespace snell::manual {

namespace {

// "TEXT:{fast,exact}" has choices.
std::vector<std::string> choices_in(const std::string& type) {
    const std::size_t open = type.find('{'), close = type.find('}');
    if (open == type.npos || close == type.npos) return {};
    std::vector<std::string> out;
    for (const std::string_view word : split(std::string_view(type).substr(open + 1, close - open - 1), ','))
        out.emplace_back(word);
    return out;
}

std::vector<std::string> limit_names() {
    std::vector<std::string> out;
    for (const LimitFacts& limit : limit_table()) out.push_back(std::string(limit.name) + "=");
    return out;
}

std::vector<std::string> language() {
    std::vector<std::string> out;
    for (const snell::Command& row : commands()) out.emplace_back(row.name);
    return out;
}

void add_value(Option& option, const CLI::Option& source, const std::string& command) {
    static const std::map<std::string, Value> by_name{{"FILE", Value::file},       {"FOLDER", Value::folder},
                                                      {"SCENE", Value::scene},     {"UNIFORM=VALUE", Value::uniform},
                                                      {"UNIFORM", Value::uniform}, {"LADDER=RUNG", Value::rung},
                                                      {"LADDER,…", Value::ladder}, {"NAME=VALUES", Value::axis}};
    const std::string type = source.get_type_name();
    option.argument = type.substr(0, type.find(':'));
    if (source.get_positional()) option.argument = source.get_name(true, false);
    const auto known = by_name.find(option.argument);
    option.value = known == by_name.end() ? Value::text : known->second;
    option.choices = choices_in(type);
    if (option.argument == "LIMIT=VALUE") option.choices = limit_names();
    if (option.argument == "NAME" && command == "commands") option.choices = language();
    if (!option.choices.empty()) option.value = Value::choice;
    if (option.argument == "NAME" && command == "help") option.value = Value::name;
}

Option described(const CLI::Option& source, const std::string& command) {
    Option option;
    for (const std::string& name : source.get_snames()) option.short_names.push_back("-" + name);
    for (const std::string& name : source.get_lnames()) option.long_names.push_back("--" + name);
    option.doc = source.get_description();
    option.repeated =
        source.get_items_expected_max() > 1 || source.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (source.get_positional() || !source.get_type_name().empty()) add_value(option, source, command);
    return option;
}

Command described(const CLI::App& source, const std::string& name) {
    Command command{.name = name, .doc = source.get_description(), .notes = source.get_footer()};
    command.synopsis = name.empty() ? "snell" : "snell " + name;
    command.synopsis += " [OPTIONS]";
    for (const CLI::Option* option : source.get_options()) {
        if (option->get_positional()) {
            command.positionals.push_back(described(*option, name));
            std::string word = command.positionals.back().argument;
            if (option->get_items_expected_max() > 1) word += "...";
            command.synopsis += option->get_required() ? " " + word : " [" + word + "]";
        } else if (!option->get_group().empty()) {
            command.options.push_back(described(*option, name));
        }
    }
    return command;
}

}  // namespace

std::vector<Command> described(const CLI::App& program) {
    std::vector<Command> commands{described(program, "")};
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        if (!command->get_group().empty()) commands.push_back(described(*command, command->get_name()));
    return commands;
}

}  // namespace snell::manual
