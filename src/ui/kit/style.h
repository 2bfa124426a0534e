// Colours and sizes of the window: a light theme, a dark one, and one of high contrast for projectors and bright rooms.
// There are few colours, and each has one meaning.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <imgui.h>

namespace snell::ui {

// The window's themes.

enum class Theme : std::uint8_t { light, dark, contrast };
inline constexpr std::array<std::string_view, 3> theme_names{"light", "dark", "contrast"};

// Text is legible on everything that it lies on, and controls stand out by their borders: tests/ui/contrast.cpp.
struct Palette {
    ImVec4 panel, text, dim, border, rule, track, filled, accent, accent_pressed, surround;
    ImVec4 popup, hovered, pressed, header, header_hovered, header_pressed, grab;
    ImVec4 error_text, warning_text;  // for text on the panel
    // For messages over the picture. Borders and buttons are translucent.
    ImVec4 problem_background, problem_text;
    ImVec4 problem_border{1, 1, 1, .5F}, problem_button{1, 1, 1, .12F};
    ImVec4 problem_hovered{1, 1, 1, .18F}, problem_pressed{1, 1, 1, .22F};
    ImVec4 error, warning, link;
};
const Palette& palette_of(Theme theme);
// The palette of the current Dear ImGui context.
const Palette& palette();
inline ImU32 pack(ImVec4 color) { return ImGui::GetColorU32(color); }

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
