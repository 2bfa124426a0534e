// Scenes and shaders from text, linted as `snell check` does.
#pragma once

#include "src/lint/lint.h"
#include "tests/std.h"

namespace snell::lint {

struct File {
    std::string_view name, text;
};

struct Linted {
    Diagnostics found;
    Sources sources;

    // What the diagnostics of that code point at, in the user's text, in order.
    std::vector<std::string> at(std::string_view code) const;
    // "file:line:column" of the first of that code.
    std::string place(std::string_view code) const;
    bool has(Rule rule) const { return !at(facts(rule).code).empty(); }
    std::string text() const { return render(found, sources); }
};

// "scene.glib" is added from `scene`; all files are in one folder.
Linted lint(std::string_view scene, const std::vector<File>& files);
// A scene on disk; `rungs` as "NORMAL=interpolated".
Linted lint_file(const std::string& path, const std::vector<std::string_view>& rungs = {});
// `fragment` behind a vertex shader that hands on vN (normal), vE (from the eye) in world coordinates, drawn by a
// sphere; `values` go on the Program line.
Linted lint_fragment(std::string_view fragment, std::string_view values = "", std::string_view state = "");
// The same, for the statements of a main() that sums to x, with uniforms uN, uM (int) and uX.
inline Linted looping(const std::string& statements, std::string_view values = "",
                      const std::string& declarations = "") {
    return lint_fragment("uniform int uN, uM;\nuniform float uX;\n" + declarations + "void main() {\nfloat x = 0.;\n" +
                             statements + "\ngl_FragColor = vec4(x);\n}\n",
                         values);
}

}  // namespace snell::lint
