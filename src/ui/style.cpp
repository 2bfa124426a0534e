#include "src/ui/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>

namespace snell::ui {

namespace {

ImVec4 color(unsigned rgb, float alpha = 1) {
    return {static_cast<float>(rgb >> 16 & 255) / 255, static_cast<float>(rgb >> 8 & 255) / 255,
            static_cast<float>(rgb & 255) / 255, alpha};
}

// Latin, Greek, Cyrillic, punctuation, arrows, mathematics: what names and comments of scenes are written in.
constexpr std::array<ImWchar, 13> glyphs{0x0020, 0x024F, 0x0370, 0x052F, 0x2010, 0x2044, 0x2190,
                                         0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

ImFont* load(std::span<const char* const> files, float pixels) {
    ImGuiIO& io = ImGui::GetIO();
    for (const char* file : files) {
        std::error_code none;
        if (!std::filesystem::is_regular_file(file, none)) continue;
        ImFontConfig config;
        config.OversampleH = 2;
        config.OversampleV = 1;
        if (ImFont* font = io.Fonts->AddFontFromFileTTF(file, pixels, &config, glyphs.data())) return font;
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    return io.Fonts->AddFontDefault(&config);
}

void set_colors(ImGuiStyle& style) {
    const Palette& p = palette();
    const auto with_alpha = [](ImVec4 c, float alpha) { return ImVec4(c.x, c.y, c.z, alpha); };
    ImGui::StyleColorsLight(&style);
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = p.text;
    c[ImGuiCol_TextDisabled] = p.dim;
    c[ImGuiCol_WindowBg] = p.panel;
    c[ImGuiCol_ChildBg] = with_alpha(p.panel, 0);
    c[ImGuiCol_PopupBg] = color(0xFFFFFF, .98F);
    c[ImGuiCol_Border] = p.rule;
    c[ImGuiCol_FrameBg] = p.track;
    c[ImGuiCol_FrameBgHovered] = color(0xDAE1EA);
    c[ImGuiCol_FrameBgActive] = color(0xD1DAE6);
    c[ImGuiCol_ScrollbarBg] = with_alpha(p.panel, 0);
    c[ImGuiCol_ScrollbarGrab] = color(0xC5CCD5);
    c[ImGuiCol_ScrollbarGrabHovered] = color(0xAEB7C2);
    c[ImGuiCol_ScrollbarGrabActive] = p.dim;
    c[ImGuiCol_CheckMark] = p.accent;
    c[ImGuiCol_SliderGrab] = p.accent;
    c[ImGuiCol_SliderGrabActive] = p.accent_pressed;
    c[ImGuiCol_Button] = p.track;
    c[ImGuiCol_ButtonHovered] = color(0xD5DDE8);
    c[ImGuiCol_ButtonActive] = p.filled;
    c[ImGuiCol_Header] = color(0xE9ECF1);
    c[ImGuiCol_HeaderHovered] = color(0xDFE5EE);
    c[ImGuiCol_HeaderActive] = color(0xD3DCE9);
    c[ImGuiCol_Separator] = p.rule;
    c[ImGuiCol_TextSelectedBg] = with_alpha(p.accent, .3F);
    c[ImGuiCol_NavHighlight] = p.accent;
}

}  // namespace

const Palette& palette() {
    static const Palette light{
        .panel = color(0xF7F8FA),
        .text = color(0x1D2733),
        .dim = color(0x68737F),
        .rule = color(0xD8DDE4),
        .track = color(0xE3E7ED),
        .filled = color(0xB4CDF5),
        .accent = color(0x2A66D1),
        .accent_pressed = color(0x1B4AA0),
        .surround = color(0xE8EBEF),
        .problem_background = color(0x1B1E24, .93F),
        .problem_text = color(0xE8EAED),
        .error = color(0xFF7B72),
        .warning = color(0xF5CE62),
    };
    return light;
}

Fonts apply_style(float scale, float density) {
    static constexpr std::array sans{
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
        "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};
    static constexpr std::array mono{"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                                     "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
                                     "/usr/share/fonts/TTF/DejaVuSansMono.ttf",
                                     "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf"};
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    Fonts fonts;
    fonts.text = load(sans, std::round(16 * scale * density));
    fonts.mono = load(mono, std::round(14 * scale * density));
    io.FontDefault = fonts.text;
    io.FontGlobalScale = 1 / density;

    ImGuiStyle style;
    style.WindowPadding = {14, 12};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 5};
    style.ItemInnerSpacing = {8, 5};
    style.ScrollbarSize = 11;
    style.WindowRounding = 0;
    style.FrameRounding = 5;
    style.PopupRounding = 6;
    style.ScrollbarRounding = 6;
    style.GrabRounding = 4;
    style.GrabMinSize = 10;
    style.WindowBorderSize = 0;
    style.FrameBorderSize = 0;
    style.PopupBorderSize = 1;
    style.DisabledAlpha = .45F;
    style.AntiAliasedLinesUseTex = true;
    set_colors(style);
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
    return fonts;
}

}  // namespace snell::ui
