// The themes' colours as WCAG 2 judges them: text of 4.5 : 1, in the theme of high contrast 7 : 1, on everything that
// it lies on; borders, knobs and marks of 3 : 1.
#include <cmath>
#include <set>
#include <vector>

#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

double linear(float v) { return v <= .04045F ? v / 12.92 : std::pow((v + .055) / 1.055, 2.4); }

double luminance(const ImVec4& c) { return .2126 * linear(c.x) + .7152 * linear(c.y) + .0722 * linear(c.z); }

double ratio(const ImVec4& a, const ImVec4& b) {
    const double x = luminance(a) + .05, y = luminance(b) + .05;
    return std::max(x, y) / std::min(x, y);
}

ImVec4 over(const ImVec4& color, const ImVec4& under, float alpha = 1) {
    const float a = color.w * alpha;
    return {color.x * a + under.x * (1 - a), color.y * a + under.y * (1 - a), color.z * a + under.z * (1 - a), 1};
}

class Contrast : public UiTest, public ::testing::WithParamInterface<Theme> {
protected:
    Contrast() {
        screen_.theme = GetParam();
        frame();
    }
    double of_text() const { return GetParam() == Theme::contrast ? 7 : 4.5; }

    using P = Palette;
    const std::vector<ImVec4 P::*> grounds_{&P::panel,          &P::popup,          &P::track,
                                            &P::hovered,        &P::pressed,        &P::header,
                                            &P::header_hovered, &P::header_pressed, &P::filled};
};

TEST_P(Contrast, OfTextIsHigh) {
    for (std::size_t i = 0; i < grounds_.size(); ++i)
        for (const auto text : {&P::text, &P::dim, &P::error_text, &P::warning_text})
            EXPECT_GE(ratio(palette().*text, palette().*grounds_[i]), of_text()) << i;
    // Selected text, and text that is disabled.
    const ImGuiStyle& style = ImGui::GetStyle();
    const Palette& p = palette();
    EXPECT_GE(ratio(p.text, over(style.Colors[ImGuiCol_TextSelectedBg], p.track)), of_text());
    for (const ImVec4& under : {p.panel, p.popup})
        EXPECT_GE(ratio(over(p.text, under, style.DisabledAlpha), under), of_text());
}

TEST_P(Contrast, OfControlsIsVisible) {
    const Palette& p = palette();
    for (const ImVec4& under : {p.panel, p.popup, p.track, p.header, p.header_hovered, p.header_pressed})
        EXPECT_GE(ratio(p.border, under), 3) << "the borders of all controls";
    for (const ImVec4& knob : {p.accent, p.accent_pressed})
        for (const ImVec4& under : {p.panel, p.popup, p.track, p.hovered, p.pressed, p.filled, p.header})
            EXPECT_GE(ratio(knob, under), 3) << "knobs, check marks, dots and the focus";
    EXPECT_GE(ratio(p.grab, p.panel), 3) << "the scroll bar";
    EXPECT_GT(ImGui::GetStyle().FrameBorderSize, 0) << "fills alone are too faint";
    EXPECT_GT(ImGui::GetStyle().TabBorderSize, 0);
    EXPECT_GT(ImGui::GetStyle().PopupBorderSize, 0);
    // Lines between sections only structure, and the surround is only seen where a picture is not.
    EXPECT_GT(ratio(p.rule, p.panel), 1.15);
    EXPECT_NE(luminance(p.surround), luminance(p.text));
}

TEST_P(Contrast, OfMessagesDoesNotDependOnThePicture) {
    const Palette& p = palette();
    for (const float picture : {0.F, 1.F}) {
        const ImVec4 ground = over(p.problem_background, {picture, picture, picture, 1});
        for (const ImVec4& text : {p.problem_text, p.error, p.warning, p.link})
            EXPECT_GE(ratio(text, ground), of_text());
        for (const ImVec4& button : {p.problem_button, p.problem_hovered, p.problem_pressed})
            EXPECT_GE(ratio(p.problem_text, over(button, ground)), of_text());
        EXPECT_GE(ratio(over(p.problem_border, ground), ground), 3);
    }
}

// Every colour that Dear ImGui draws with is one of the palette, so that the tests above are about it.
TEST_P(Contrast, CoversEveryColorOfTheStyle) {
    const Palette& p = palette();
    const std::vector<ImVec4> own{p.panel,          p.text,           p.dim,   p.border,        p.rule,    p.track,
                                  p.filled,         p.accent,         p.popup, p.hovered,       p.pressed, p.header,
                                  p.header_hovered, p.header_pressed, p.grab,  p.accent_pressed};
    // These appear only while a window is moved or resized, docked, dropped on, or controlled with a gamepad.
    const std::set<int> unused{ImGuiCol_MenuBarBg,         ImGuiCol_ResizeGrip,       ImGuiCol_ResizeGripHovered,
                               ImGuiCol_ResizeGripActive,  ImGuiCol_DragDropTarget,   ImGuiCol_NavWindowingHighlight,
                               ImGuiCol_NavWindowingDimBg, ImGuiCol_ModalWindowDimBg, ImGuiCol_TitleBgCollapsed,
                               ImGuiCol_TableRowBg,        ImGuiCol_TableRowBgAlt};
    const auto same = [](const ImVec4& a, const ImVec4& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
    for (int i = 0; i < ImGuiCol_COUNT; ++i) {
        if (unused.contains(i)) continue;
        const ImVec4& color = ImGui::GetStyle().Colors[i];
        EXPECT_TRUE(std::ranges::any_of(own, [&](const ImVec4& mine) { return same(mine, color); }))
            << ImGui::GetStyleColorName(i);
    }
    // 16 here, the surround, the texts of errors and warnings, and 9 of messages: a new colour needs a line above.
    EXPECT_EQ(sizeof(Palette) / sizeof(ImVec4), own.size() + 1 + 2 + 9);
}

INSTANTIATE_TEST_SUITE_P(Themes, Contrast, ::testing::Values(Theme::light, Theme::dark, Theme::contrast),
                         [](const auto& row) { return std::string(theme_names[static_cast<std::size_t>(row.param)]); });

}  // namespace
}  // namespace snell::ui
