// How the window looks: light, for projectors and bright rooms, or dark; few colours, each with one meaning.
#pragma once

#include <imgui.h>

#include "src/ui/theme.h"

namespace snell::ui {

struct Palette {
    ImVec4 panel, text, dim, rule, track, filled, accent, accent_pressed, surround;
    ImVec4 popup, hovered, pressed, header, header_hovered, header_pressed, grab;
    ImVec4 error_text, warning_text;                                // on the panel
    ImVec4 problem_background, problem_text, error, warning, link;  // over the picture
};
const Palette& palette_of(Theme theme);
// Of the current Dear ImGui context.
const Palette& palette();

struct Fonts {
    ImFont* text = nullptr;
    ImFont* mono = nullptr;  // carets under source lines need one
};

// `scale`: 1 at 96 dots per inch; `density`: pixels for one window coordinate (more than 1 on some systems).
// Replaces the fonts of the current Dear ImGui context.
Fonts load_fonts(float scale, float density);
// Sizes and colours of the current Dear ImGui context.
void apply_style(float scale, Theme theme);

}  // namespace snell::ui
