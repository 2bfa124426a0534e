#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "src/ui/kit/field.h"
#include "src/ui/kit/numbers.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"

// Dear ImGui's own sliders abort the process on infinite ranges and round values to the displayed text. Our slider
// needs internal functions, which imgui_internal.h declares.
namespace snell::ui {

namespace {

ImU32 pack(ImVec4 color) { return ImGui::GetColorU32(color); }

bool by_ratio(const SliderRange& range) {
    return range.logarithmic && range.min > 0 && range.max > range.min && std::isfinite(range.max / range.min);
}

// The intermediate results cannot overflow, for any range.
double fraction_of(double value, const SliderRange& range) {
    if (by_ratio(range)) return std::clamp(std::log(value / range.min) / std::log(range.max / range.min), 0.0, 1.0);
    const double half = range.max / 2 - range.min / 2;
    if (!(half > 0) || !std::isfinite(value)) return 0;
    return std::clamp((value / 2 - range.min / 2) / half, 0.0, 1.0);
}

double value_at(double fraction, const SliderRange& range, bool fine) {
    if (fraction <= 0) return range.min;
    if (fraction >= 1) return range.max;
    const double value = by_ratio(range) ? range.min * std::pow(range.max / range.min, fraction)
                                         : range.min * (1 - fraction) + range.max * fraction;
    if (range.integral) return std::round(value);
    if (by_ratio(range)) return tidy_relative(value, range.min, range.max, fine);
    return tidy(std::clamp(value, range.min, range.max), range.min, range.max, fine);
}

// Returns the value that the mouse has dragged the knob to: under the pointer, or relative to where the drag began.
double dragged_to(const ImRect& box, double value, const SliderRange& range, SliderMemory& memory) {
    const ImGuiIO& io = ImGui::GetIO();
    const float grab = ImGui::GetStyle().GrabMinSize * .5F, way = std::max(1.0F, box.GetWidth() - 2 * grab);
    if (io.KeyAlt && !memory.relative) {
        memory.relative = true;
        memory.fraction = fraction_of(value, range);
    }
    if (!memory.relative) {
        const double at = (io.MousePos.x - box.Min.x - grab) / way;
        return std::isfinite(at) ? value_at(std::clamp(at, 0.0, 1.0), range, false) : value;
    }
    constexpr double slow = .05;
    const double moved = io.MouseDelta.x / way * (io.KeyAlt ? slow : 1);
    if (!std::isfinite(moved) || moved == 0) return value;
    memory.fraction = std::clamp(memory.fraction + moved, 0.0, 1.0);
    return value_at(memory.fraction, range, io.KeyAlt);
}

// Draws a thin track, filled up to the knob.
void draw_slider(const ImRect& box, ImGuiID id, bool hovered, double fraction) {
    const Palette& colors = palette();
    const bool held = ImGui::GetActiveID() == id;
    const float grab = ImGui::GetStyle().GrabMinSize * .5F, middle = box.GetCenter().y;
    const float half = std::round(box.GetHeight() * .16F);
    const float knob = box.Min.x + grab + static_cast<float>(fraction) * (box.GetWidth() - 2 * grab);
    const ImGuiCol track = held ? ImGuiCol_FrameBgActive : hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 min(box.Min.x, middle - half), max(box.Max.x, middle + half);
    list.AddRectFilled(min, max, ImGui::GetColorU32(track), half);
    list.AddRectFilled(min, {knob, max.y}, pack(colors.filled), half);
    list.AddRect(min, max, ImGui::GetColorU32(ImGuiCol_Border), half);
    const float reach = std::round(box.GetHeight() * .38F);
    list.AddRectFilled({knob - grab, middle - reach}, {knob + grab, middle + reach},
                       pack(held || hovered ? colors.accent_pressed : colors.accent), grab);
}

// Returns the value that the keyboard moves the knob to: by a hundredth of the range for a step, whole numbers by one.
double stepped(double value, double steps, const SliderRange& range) {
    if (steps == 0 || !(range.min < range.max)) return value;
    if (!range.integral) return value_at(fraction_of(value, range) + steps / 100, range, std::abs(steps) < 1);
    const double coarse = std::abs(steps) >= 10 ? std::round((range.max - range.min) / 10) : 1;
    return std::clamp(value + std::copysign(std::max(1., coarse), steps), range.min, range.max);
}

// The number beside the track looks like a field, because a press edits it. Returns true if it was pressed.
bool number_beside(const ImRect& box, double value, const SliderRange& range) {
    const bool hovered = ImGui::ItemHoverable(box, ImGui::GetID("##number"));
    if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    ImGui::RenderFrame(box.Min, box.Max, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), true,
                       ImGui::GetStyle().FrameRounding);
    const float padding = ImGui::GetStyle().FramePadding.x * .5F;
    std::string text = shown(value, range.min, range.max, range.integral);
    if (width_of(text) > box.GetWidth() - 2 * padding) text = fmt::format("{:.3g}", value);
    ImGui::RenderTextClipped({box.Min.x + padding, box.Min.y}, {box.Max.x - padding, box.Max.y}, text.data(),
                             text.data() + text.size(), nullptr, {1, .5F});
    return hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

// Begins a drag, or opens the field at the second of two clicks.
void press(ImGuiID id, double& value, SliderMemory& memory) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool twice = io.MouseDoubleClicked[0] && memory.id == id;
    if (twice) value = memory.before;
    memory = {id, value, false, 0};
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    ImGui::SetActiveID(id, window);
    ImGui::FocusWindow(window);
    take_focus(id);
    if (twice || io.KeyCtrl) type_number(id, value);
}

}  // namespace

bool slider(const char* label, double& value, SliderRange& range, double initial, SliderMemory& memory,
            float number_width) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    if (window->SkipItems) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImGuiID id = window->GetID(label);
    const float beside = number_width > 0 ? number_width + style.ItemInnerSpacing.x : 0;
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x - beside, 4 * style.GrabMinSize),
                      ImGui::GetFrameHeight());
    const ImVec2 at = window->DC.CursorPos;
    const ImRect box(at.x, at.y, at.x + size.x, at.y + size.y);
    const ImRect whole(box.Min, {box.Max.x + beside, box.Max.y});
    focusable(whole, id);
    ImGui::ItemSize(whole, style.FramePadding.y);
    if (!ImGui::ItemAdd(box, id, &box) && !is_typed(id)) return false;

    const double before = value;
    const bool hovered = ImGui::ItemHoverable(box, id);
    if (hovered && io.MouseClicked[0] && !is_typed(id)) press(id, value, memory);
    if (is_typed(id)) {
        typed_field(whole, id, label, value, range.integral);
        range.min = std::min(range.min, value);
        range.max = std::max(range.max, value);
        return value != before;
    }
    if (number_width > 0 && number_beside({{whole.Max.x - number_width, box.Min.y}, whole.Max}, value, range))
        type_number(id, value);
    range.reset = hovered && io.MouseClicked[1];
    if (range.reset) value = initial;
    value = stepped(value, key_steps(id), range);
    if (ImGui::GetActiveID() == id) {
        if (!io.MouseDown[0])
            ImGui::ClearActiveID();
        else if (range.min < range.max)
            value = dragged_to(box, value, range, memory);
    }
    draw_slider(box, id, hovered, fraction_of(value, range));
    draw_focus(whole, id);
    return value != before;
}

}  // namespace snell::ui
