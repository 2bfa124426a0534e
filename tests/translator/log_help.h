// A program whose shaders did not compile, for tests of explain_log.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "src/glsl/glsl.h"

namespace snell::glsl::test {

struct Program {
    Sources sources;
    Diagnostics diagnostics;
    Translation translation;
    Span where;

    Program() {
        const FileId scene = sources.add("demo.glib", "Vertex demo.vert\nFragment demo.frag\nProgram Demo\n");
        where = {scene, 36, 48};
    }

    using Included = std::vector<std::pair<std::string, std::string>>;

    // `translated` is what the driver saw; when empty, the user's own text.
    void stage(Stage stage, const std::string& name, const std::string& user, const std::string& translated,
               const Included& included) {
        StageOutput output{.stage = stage, .text = translated.empty() ? user : translated, .files = {}};
        output.files.push_back(sources.add(name, user));
        for (const auto& [file, text] : included) output.files.push_back(sources.add(file, text));
        translation.stages.push_back(output);
    }
    void vertex(const std::string& user, const std::string& translated = {}) {
        stage(Stage::vertex, "demo.vert", user, translated, {});
    }
    void fragment(const std::string& user, const std::string& translated = {}, const Included& included = {}) {
        stage(Stage::fragment, "demo.frag", user, translated, included);
    }

    void explain(std::string_view log, Stage which = Stage::fragment) {
        for (const StageOutput& s : translation.stages)
            if (s.stage == which) explain_log(log, translation, &s, where, "Demo", sources, diagnostics);
    }
    void explain_link(std::string_view log) {
        explain_log(log, translation, nullptr, where, "Demo", sources, diagnostics);
    }

    std::string show(const Span& span) const {
        const Position p = sources.position(span.file, span.begin);
        return fmt::format("{}:{}:{} {}", sources.name(span.file), p.line, p.column,
                           sources.text(span.file).substr(span.begin, span.end - span.begin));
    }
    const Diagnostic& at(std::size_t i) const { return diagnostics.items().at(i); }
    const std::string& code(std::size_t i) const { return at(i).code; }
    const std::string& message(std::size_t i) const { return at(i).message; }
    const std::string& help(std::size_t i) const { return at(i).help; }
    std::string place(std::size_t i) const { return show(at(i).span); }
    int line(std::size_t i) const { return sources.position(at(i).span.file, at(i).span.begin).line; }
    std::string note(std::size_t i, std::size_t n) const {
        const Note& note = at(i).notes.at(n);
        return show(note.span) + ": " + note.message;
    }
    bool has_note(std::size_t i, std::string_view part) const {
        for (const Note& note : at(i).notes)
            if (note.message.find(part) != std::string::npos) return true;
        return false;
    }
};

}  // namespace snell::glsl::test
