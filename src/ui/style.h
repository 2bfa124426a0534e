// How the window looks: light, for projectors and bright rooms; few colours, each with one meaning.
#pragma once

#include <imgui.h>

namespace snell::ui {

struct Palette {
    ImVec4 panel, text, dim, rule, track, filled, accent, accent_pressed, surround;
    ImVec4 problem_background, problem_text, error, warning;
};
const Palette& palette();

struct Fonts {
    ImFont* text = nullptr;
    ImFont* mono = nullptr;  // carets under source lines need one
};

// `scale`: 1 at 96 dots per inch; `density`: pixels for one window coordinate (more than 1 on some systems).
// Replaces the fonts of the current Dear ImGui context.
Fonts apply_style(float scale, float density);

}  // namespace snell::ui
