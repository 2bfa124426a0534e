// `snell complete`: what may follow on a command line, one candidate a line, with a tab and a remark behind some. It is
// asked by the shells' completions, so it neither starts OpenGL nor reports errors.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>

#include "parser/commands/commands.h"
#include "src/app/help/help.h"
#include "src/app/help/program.h"
#include "src/app/open/exit_status.h"
#include "src/document/document.h"
#include "src/plan/plan.h"
#include "src/plan/values/declared.h"

namespace snell::app {

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
        if (auto parsed = parse_document(path, files, sources, unheard))
            plan = make_plan(std::move(parsed->scene), files, sources, unheard);
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
