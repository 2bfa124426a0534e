
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "parser/commands/commands.h"
#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "src/app/help/program.h"
#include "src/app/open/complain.h"
#include "src/document/document.h"
#include "src/lint/lint.h"
#include "src/plan/plan.h"
#include "src/plan/values/declared.h"

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

// `snell complete`: what may follow on a command line, one candidate a line, with a tab and a remark behind some. It is
// asked by the shells' completions, so it neither starts OpenGL nor reports errors.

namespace {

struct Question {
    std::string kind, scene, word;
};

struct Candidate {
    std::string text, remark;
    bool operator<(const Candidate& other) const { return text < other.text; }
};
using Candidates = std::set<Candidate>;

// A name that GLSL can have, or a part of such a variable: a[2].b. Others would only reach the command line, where a
// shell may take them for something else.
bool glsl_name(std::string_view name) {
    char before = '.';
    for (const char c : name) {
        const bool digit = c >= '0' && c <= '9', letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        const bool begins = before == '.', ends = before == ']';
        if (begins ? !letter : !letter && !digit && c != '.' && c != '[' && c != ']') return false;
        if (ends && c != '.' && c != '[') return false;
        before = c;
    }
    return before != '.' && before != '[';
}

bool has_controls(std::string_view text) {
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

// The scene as far as it can be read.
struct Reading {
    explicit Reading(const std::string& path) : files(scene_folder(path)) {
        if (auto read = read_plan(path, files, sources, unheard)) plan = std::move(*read);
    }

    Files files;
    Sources sources;
    Diagnostics unheard;
    Plan plan;
};

// "1 1.5 2.5" of <1 1.5 2.5>, as the scene writes it.
std::string written_value(const UniformValue& value, const Sources& sources) {
    const std::string_view text = sources.text(value.span.file);
    if (value.span.end > text.size() || value.name_span.end > value.span.end) return {};
    std::string remark(text.substr(value.name_span.end, value.span.end - value.name_span.end));
    for (char& c : remark)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\') c = ' ';
    remark.erase(0, std::min(remark.find_first_not_of(' '), remark.size()));
    return remark;
}

void add_uniforms(Candidates& found, Reading& reading, std::string_view end) {
    const Scene& scene = reading.plan.scene;
    const auto add = [&](const Program& program, const std::string& name, const std::string& remark) {
        if (!glsl_name(name)) return;
        found.insert({fmt::format("{}{}", name, end), remark});
        if (glsl_name(program.name) && scene.programs.size() > 1)
            found.insert({fmt::format("{}.{}{}", program.name, name, end), remark});
    };
    for (const PlannedProgram& planned : reading.plan.programs) {
        const Program& program = scene.programs[planned.program];
        for (const UniformValue& value : program.uniforms)
            add(program, value.name, written_value(value, reading.sources));
        glsl::Options options;
        options.include = shader_includes(reading.files);
        options.defines = ladder_defines(std::span(scene.ladders).first(program.ladders), reading.plan.rungs);
        const glsl::Translation translation =
            glsl::translate(planned.stages, reading.sources, options, reading.unheard);
        for (const glsl::DeclaredUniform& uniform : translation.declared)
            if (!set_by_snell(program, uniform.name, uniform.glsl_type)) add(program, uniform.name, uniform.glsl_type);
    }
}

void add_rungs(Candidates& found, const Reading& reading) {
    for (const Ladder& ladder : reading.plan.scene.ladders)
        for (const std::string& rung : ladder.rungs)
            found.insert({ladder.name + "=" + rung, rung == ladder.rungs[ladder.current] ? "as the scene says" : ""});
}

// Behind the names that the word lists already, with commas.
void add_more_ladders(Candidates& found, const Reading& reading, std::string_view word) {
    const std::string_view listed = word.substr(0, word.rfind(',') + 1);
    const std::string all = "," + std::string(listed);
    for (const Ladder& ladder : reading.plan.scene.ladders)
        if (all.find("," + ladder.name + ",") == std::string::npos)
            found.insert({fmt::format("{}{}", listed, ladder.name), "ladder"});
}

void add_ladders(Candidates& found, const Reading& reading, std::string_view end) {
    for (const Ladder& ladder : reading.plan.scene.ladders)
        found.insert({fmt::format("{}{}", ladder.name, end), "ladder"});
}

void add_help_names(Candidates& found) {
    for (const Subcommand& row : subcommands())
        if (!row.hidden) found.insert({row.name, row.summary});
    for (const std::string_view code : explained_codes()) found.insert({std::string(code), "code"});
    for (const Command& row : commands()) found.insert({std::string(row.name), "command of the language"});
}

Exit complete(const Question& question) {
    Candidates found;
    if (question.kind == "help") {
        add_help_names(found);
    } else {
        Reading reading(question.scene);
        if (question.kind == "uniforms") add_uniforms(found, reading, "=");
        if (question.kind == "rungs") add_rungs(found, reading);
        if (question.kind == "ladders") add_more_ladders(found, reading, question.word);
        if (question.kind == "axes") {
            add_uniforms(found, reading, "=");
            add_ladders(found, reading, "=");
            found.insert({"time=", "seconds"});
        }
    }
    for (const Candidate& candidate : found)
        if (candidate.text.starts_with(question.word) && !has_controls(candidate.text))
            fmt::print("{}{}{}\n", candidate.text, candidate.remark.empty() ? "" : "\t", candidate.remark);
    return exit_fine;
}

}  // namespace

Run add_complete(CLI::App& command) {
    auto question = std::make_shared<Question>();
    command.add_option("KIND", question->kind, "what is wanted: uniforms, rungs, ladders, axes of a sweep, help")
        ->required()
        ->check(CLI::IsMember({"uniforms", "rungs", "ladders", "axes", "help"}));
    command.add_option("SCENE", question->scene, "the scene");
    command.add_option("WORD", question->word, "how the candidates begin");
    return [question] { return complete(*question); };
}

}  // namespace snell::app
