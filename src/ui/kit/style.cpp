#include "src/ui/kit/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>

#include "src/ui/kit/kit.h"

namespace snell::ui {

namespace {

ImVec4 color(unsigned rgb, float alpha = 1) {
    return {static_cast<float>(rgb >> 16 & 255) / 255, static_cast<float>(rgb >> 8 & 255) / 255,
            static_cast<float>(rgb & 255) / 255, alpha};
}

// Latin, Greek, Cyrillic, punctuation, arrows and mathematics, which names and comments in scenes use.
constexpr std::array<ImWchar, 13> glyphs{0x0020, 0x024F, 0x0370, 0x052F, 0x2010, 0x2044, 0x2190,
                                         0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

ImFont* load(std::span<const char* const> files, float pixels) {
    ImGuiIO& io = ImGui::GetIO();
    for (const char* file : files) {
        std::error_code none;
        if (!std::filesystem::is_regular_file(file, none)) continue;
        ImFontConfig config;
        config.OversampleH = pixels < 40 ? 2 : 1;  // large letters need no oversampling, which would take much memory
        config.OversampleV = 1;
        if (ImFont* font = io.Fonts->AddFontFromFileTTF(file, pixels, &config, glyphs.data())) return font;
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    return io.Fonts->AddFontDefault(&config);
}

void set_colors(ImGuiStyle& style, Theme theme) {
    const Palette& p = palette_of(theme);
    const auto with_alpha = [](ImVec4 c, float alpha) { return ImVec4(c.x, c.y, c.z, alpha); };
    if (theme == Theme::dark)
        ImGui::StyleColorsDark(&style);
    else
        ImGui::StyleColorsLight(&style);
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = p.text;
    c[ImGuiCol_TextDisabled] = p.dim;
    c[ImGuiCol_WindowBg] = p.panel;
    c[ImGuiCol_ChildBg] = with_alpha(p.panel, 0);
    c[ImGuiCol_PopupBg] = p.popup;
    c[ImGuiCol_Border] = p.border;
    c[ImGuiCol_BorderShadow] = with_alpha(p.border, 0);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = p.header;
    c[ImGuiCol_FrameBg] = p.track;
    c[ImGuiCol_FrameBgHovered] = p.hovered;
    c[ImGuiCol_FrameBgActive] = p.pressed;
    c[ImGuiCol_ScrollbarBg] = with_alpha(p.panel, 0);
    c[ImGuiCol_ScrollbarGrab] = p.grab;
    c[ImGuiCol_ScrollbarGrabHovered] = p.dim;
    c[ImGuiCol_ScrollbarGrabActive] = p.dim;
    c[ImGuiCol_CheckMark] = p.accent;
    c[ImGuiCol_SliderGrab] = p.accent;
    c[ImGuiCol_SliderGrabActive] = p.accent_pressed;
    c[ImGuiCol_Button] = p.track;
    c[ImGuiCol_ButtonHovered] = p.hovered;
    c[ImGuiCol_ButtonActive] = p.filled;
    c[ImGuiCol_Header] = p.header;
    c[ImGuiCol_HeaderHovered] = p.header_hovered;
    c[ImGuiCol_HeaderActive] = p.header_pressed;
    c[ImGuiCol_Separator] = c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = p.rule;
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = p.accent;
    c[ImGuiCol_TableHeaderBg] = p.header;
    c[ImGuiCol_Tab] = c[ImGuiCol_TabUnfocused] = p.track;
    c[ImGuiCol_TabHovered] = p.hovered;
    c[ImGuiCol_TabActive] = c[ImGuiCol_TabUnfocusedActive] = p.filled;
    c[ImGuiCol_PlotLines] = c[ImGuiCol_PlotLinesHovered] = p.accent;
    c[ImGuiCol_PlotHistogramHovered] = p.accent_pressed;
    c[ImGuiCol_PlotHistogram] = p.accent;
    c[ImGuiCol_TextSelectedBg] = with_alpha(p.accent, .3F);
    c[ImGuiCol_NavHighlight] = p.accent;
    c[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, .35F};
}

}  // namespace

const Palette& palette_of(Theme theme) {
    static const Palette light{
        .panel = color(0xF7F8FA),
        .text = color(0x1D2733),
        .dim = color(0x4C5661),
        .border = color(0x6E7986),
        .rule = color(0xD8DDE4),
        .track = color(0xE9EDF2),
        .filled = color(0xB4CDF5),
        .accent = color(0x2459BD),
        .accent_pressed = color(0x173F8C),
        .surround = color(0xE8EBEF),
        .popup = color(0xFFFFFF),
        .hovered = color(0xDCE4EE),
        .pressed = color(0xD0DAE7),
        .header = color(0xE6EAF0),
        .header_hovered = color(0xDFE5EE),
        .header_pressed = color(0xD9E1EC),
        .grab = color(0x6E7986),
        .error_text = color(0xA5120D),
        .warning_text = color(0x6B4900),
        .problem_background = color(0x1B1E24, .93F),
        .problem_text = color(0xE8EAED),
        .error = color(0xFF9D94),
        .warning = color(0xF5CE62),
        .link = color(0x9CC4FF),
    };
    static const Palette dark{
        .panel = color(0x1D2026),
        .text = color(0xE9ECF0),
        .dim = color(0xB2BBC6),
        .border = color(0x848E9B),
        .rule = color(0x383E48),
        .track = color(0x2B3038),
        .filled = color(0x2C4A80),
        .accent = color(0x7FB0FA),
        .accent_pressed = color(0xAACBFD),
        .surround = color(0x14161A),
        .popup = color(0x22262D),
        .hovered = color(0x363D47),
        .pressed = color(0x3A424E),
        .header = color(0x292E36),
        .header_hovered = color(0x2F353F),
        .header_pressed = color(0x333B46),
        .grab = color(0x848E9B),
        .error_text = color(0xFFA69E),
        .warning_text = color(0xF0C64F),
        .problem_background = color(0x0E1014, .93F),
        .problem_text = color(0xE8EAED),
        .error = color(0xFF9D94),
        .warning = color(0xF5CE62),
        .link = color(0x9CC4FF),
    };
    static const Palette contrast{
        .panel = color(0xFFFFFF),
        .text = color(0x000000),
        .dim = color(0x2E2E2E),
        .border = color(0x303030),
        .rule = color(0x303030),
        .track = color(0xFFFFFF),
        .filled = color(0xA9CBFF),
        .accent = color(0x0038A8),
        .accent_pressed = color(0x001F66),
        .surround = color(0xE4E4E4),
        .popup = color(0xFFFFFF),
        .hovered = color(0xDCEBFF),
        .pressed = color(0xC4DDFF),
        .header = color(0xE4E4E4),
        .header_hovered = color(0xD4E4FA),
        .header_pressed = color(0xC4DDFF),
        .grab = color(0x303030),
        .error_text = color(0x700000),
        .warning_text = color(0x4A3200),
        .problem_background = color(0x000000),
        .problem_text = color(0xFFFFFF),
        .error = color(0xFFB3AC),
        .warning = color(0xFFDE80),
        .link = color(0xB5D4FF),
    };
    return theme == Theme::contrast ? contrast : theme == Theme::dark ? dark : light;
}

Fonts load_fonts(float scale, float density) {
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
    fonts.mono = load(mono, std::round(16 * scale * density));
    io.FontDefault = fonts.text;
    io.FontGlobalScale = 1 / density;
    return fonts;
}

void apply_style(float scale, Theme theme) {
    kit().palette = &palette_of(theme);
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
    style.FrameBorderSize = 1;
    style.TabBorderSize = 1;
    style.PopupBorderSize = 1;
    style.DisabledAlpha = .7F;
    style.AntiAliasedLinesUseTex = true;
    set_colors(style, theme);
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

}  // namespace snell::ui
