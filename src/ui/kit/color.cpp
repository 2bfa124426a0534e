#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "src/ui/kit/field.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/numbers.h"
#include "src/ui/kit/widgets.h"

namespace snell::ui {

namespace {

constexpr double color_speed = .004;  // per point of a drag: about one byte

bool in_bytes(double value) { return value >= 0 && value <= 1; }
double byte(double value) { return std::round(255 * value); }

// Only the components that were picked change: the others keep the precision that the picker lacks.
void pick(double* value, std::size_t count, const double* initial) {
    std::array<float, 4> edited{0, 0, 0, 1}, original{0, 0, 0, 1};
    std::transform(value, value + count, edited.begin(), [](double v) { return static_cast<float>(v); });
    std::transform(initial, initial + count, original.begin(), [](double v) { return static_cast<float>(v); });
    const std::array<float, 4> before = edited;
    ImGuiColorEditFlags flags = ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions |
                                ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_AlphaBar |
                                ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_AlphaPreviewHalf;
    if (count < 4) flags |= ImGuiColorEditFlags_NoAlpha;
    ImGui::SetNextItemWidth(16 * ImGui::GetFontSize());
    if (!ImGui::ColorPicker4("##color", edited.data(), flags, original.data())) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(edited[i]) || edited[i] == before[i]) continue;
        const double now = edited[i];
        if (!in_bytes(now) || !in_bytes(value[i]) || byte(now) != byte(value[i])) value[i] = tidy_color(now);
    }
}

// Draws the colour as a button that opens the picker.
void swatch(double* value, std::size_t count, const double* initial) {
    const auto part = [&](std::size_t i) { return i < count ? static_cast<float>(value[i]) : 1; };
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFrameHeight();
    if (ImGui::ColorButton("##swatch", {part(0), part(1), part(2), part(3)},
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop |
                               ImGuiColorEditFlags_AlphaPreviewHalf | (count < 4 ? ImGuiColorEditFlags_NoAlpha : 0),
                           {side, side}))
        ImGui::OpenPopup("picker");
    tip("Click to pick a colour");
    ImGui::SetNextWindowPos({at.x, at.y + side + ImGui::GetStyle().ItemSpacing.y}, ImGuiCond_Appearing);
    const bool open = ImGui::BeginPopup("picker");
    note_opener({at.x, at.y, side, side}, open);
    if (!open) return;
    pick(value, count, initial);
    ImGui::EndPopup();
}

}  // namespace

bool color_row(const char* id, double* value, int components, const double* initial) {
    const auto count = static_cast<std::size_t>(components);
    std::array<double, 4> before{};
    std::copy_n(value, count, before.begin());
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x * .5F, side = ImGui::GetFrameHeight() + gap;
    const float width = (ImGui::GetContentRegionAvail().x - side) / static_cast<float>(components) - gap;
    bool restored = false;
    ImGui::PushID(id);
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < count; ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool entered = is_typed(ImGui::GetID("##component"));
        const double old = value[i];
        if (number_field("##component", value[i], initial[i], width, {.speed = color_speed, .digits = 3}) && !entered)
            value[i] = tidy_color(value[i]);
        restored |= value[i] != old && value[i] == initial[i] && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
        ImGui::SameLine(0, gap);
        ImGui::PopID();
    }
    swatch(value, count, initial);
    ImGui::EndGroup();
    ImGui::PopID();
    if (restored || (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)))
        std::copy_n(initial, count, value);
    return !std::equal(value, value + count, before.begin());
}

}  // namespace snell::ui
