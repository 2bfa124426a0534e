// Colours and sizes of the window: a light theme for projectors and bright rooms, and a dark one. There are few
// colours, and each has one meaning.
#pragma once

#include <imgui.h>

#include "src/ui/kit/theme.h"

namespace snell::ui {

struct Palette {
    ImVec4 panel, text, dim, rule, track, filled, accent, accent_pressed, surround;
    ImVec4 popup, hovered, pressed, header, header_hovered, header_pressed, grab;
    ImVec4 error_text, warning_text;                                // for text on the panel
    ImVec4 problem_background, problem_text, error, warning, link;  // for messages over the picture
};
const Palette& palette_of(Theme theme);
// The palette of the current Dear ImGui context.
const Palette& palette();

struct Fonts {
    ImFont* text = nullptr;
    ImFont* mono = nullptr;  // monospaced, so that carets are under their source
};

// Loads the fonts and replaces those of the current Dear ImGui context. `scale` is 1 at 96 dots per inch; `density` is
// pixels per window coordinate (above 1 on some systems).
Fonts load_fonts(float scale, float density);
// Sets sizes and colours of the current Dear ImGui context.
void apply_style(float scale, Theme theme);

}  // namespace snell::ui
