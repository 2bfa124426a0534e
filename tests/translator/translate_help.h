// What the tests of the translator share: one call that translates texts, and the reference compiler's verdict.
#pragma once

#include "src/glsl/glsl.h"
#include "tests/std.h"

namespace snell::glsl::test {

inline constexpr Target core450{450, false, true}, core330{330, false, true}, core410{410, false, true};
inline constexpr Target es300{300, true, false}, es320{320, true, false};

struct Translated {
    Translation translation;
    Sources sources;
    Diagnostics diagnostics;

    const std::string& text(Stage stage) const;
    bool has(Stage stage, std::string_view part) const { return text(stage).find(part) != std::string::npos; }
    // Diagnostics of that code.
    int count(std::string_view code) const;
    bool uniform_default(std::string_view name, const std::vector<double>& values) const;
};

using Texts = std::vector<std::pair<Stage, std::string>>;
void translate_texts(Translated& out, const Texts& texts, const Options& options);
Translated translated(const Texts& texts, const Target& target = core450);
Translated fragment(const std::string& text, const Target& target = core450);
Translated vertex(const std::string& text, const Target& target = core450);

// The user's line that the driver will name for `part`; 0 if it is not there.
int line_of(const std::string& text, std::string_view part);

// glslangValidator compiles all stages, when every test has ended, and links them now if asked to. Nothing is tried
// where it is not installed.
void expect_accepted(const Translation& translation, bool link = false);
// Translates for each target and asks the reference compiler, which links several stages for the first target: whether
// they fit together does not depend on it. Then a second translation changes nothing.
void expect_valid(const Texts& texts, const std::vector<Target>& targets = {core450, core330, es320});

}  // namespace snell::glsl::test
