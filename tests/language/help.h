// Scenes and shaders from text, with a cursor: the place of '@' in the text that has one.
#pragma once

#include "src/language/services.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::language {

class Editor {
public:
    // The scene is "scene.glib". '@' marks the cursor and is not written. `links` are symbolic, by name.
    Editor(std::string_view scene, const std::map<std::string, std::string>& others = {},
           const std::map<std::string, std::string>& links = {});

    const Project& project() const { return project_; }
    FileId file() const { return file_; }
    std::uint32_t offset() const { return offset_; }
    FileId file(std::string_view name) const;
    std::string text(std::string_view name) const { return std::string(project_.sources.text(file(name))); }
    std::string text(const Span& span) const;
    // "scene.glib:2 uKa"
    std::string place(const Span& span) const;
    std::vector<std::string> places(const std::vector<Span>& spans) const;

    std::vector<Completion> completions() const { return language::completions(project_, file_, offset_); }
    std::string hover() const;
    SignatureHelp signature() const { return signature_help(project_, file_, offset_).value_or(SignatureHelp()); }
    std::vector<std::string> definition() const { return places(language::definition(project_, file_, offset_)); }
    std::vector<std::string> references() const { return places(language::references(project_, file_, offset_)); }
    Rename rename(std::string_view name) const { return language::rename(project_, file_, offset_, name); }
    // The text of a file after the rename.
    std::string renamed(std::string_view name, std::string_view file_name) const;

private:
    std::string written(std::string_view name, std::string_view text);

    Scratch folder_;
    std::string cursor_;
    std::uint32_t offset_ = 0;
    Project project_;
    FileId file_ = 0;
};

std::vector<std::string> labels(const std::vector<Completion>& all);
const Completion* find(const std::vector<Completion>& all, std::string_view label);
// What is inserted for the label; empty if it is not offered.
std::string inserted(const std::vector<Completion>& all, std::string_view label);
// The text with what the completion writes.
std::string completed(const Editor& editor, std::string_view label);

// A vertex shader that hands on vN.
inline constexpr std::string_view vertex =
    "#version 330 compatibility\nout vec3 vN;\nvoid main() {\n    vN = gl_NormalMatrix * gl_Normal;\n"
    "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n";
inline constexpr std::string_view fragment =
    "#version 330 compatibility\nuniform float uKa, uKd;\nuniform vec4 uColor;\nuniform bool uOn;\n"
    "uniform sampler2D uPicture; // the stripes\nin vec3 vN;\n\nvec3 shade(vec3 n, float k) { return n * k; }\n\n"
    "void main() {\n    float uKd = uKa;  // hides the uniform\n    gl_FragColor = vec4(shade(vN, uKd) * uKa, 1.) * "
    "uColor;\n}\n";
inline std::map<std::string, std::string> shaders() {
    return {{"a.vert", std::string(vertex)}, {"a.frag", std::string(fragment)}};
}

}  // namespace snell::language
