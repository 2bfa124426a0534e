#include "src/ui/kit/widgets.h"

// Dear ImGui's own sliders abort the process on infinite ranges and round values to the displayed text. Our slider
// needs internal functions, which imgui_internal.h declares.
#define IMGUI_DEFINE_MATH_OPERATORS
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "src/ui/kit/layout.h"
#include "src/ui/kit/numbers.h"
#include "src/ui/kit/style.h"

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

// Dear ImGui edits the text in place of the widget; each text that is a number is applied at once.
bool type_value(const ImRect& box, ImGuiID id, const char* label, double& value, bool integral) {
    std::array<char, 64> text{};
    const std::string now = exact(value);
    std::copy_n(now.begin(), std::min(now.size(), text.size() - 1), text.begin());
    const bool edited = ImGui::TempInputText(box, id, label, text.data(), static_cast<int>(text.size()),
                                             ImGuiInputTextFlags_AutoSelectAll);
    if (!edited) return false;
    const std::optional<double> entered = typed(text.data(), integral);
    if (!entered || *entered == value) return false;
    value = *entered;
    return true;
}

// Draws a thin track, filled up to the knob. The number is above the track, where no knob can cover it.
void draw_slider(const ImRect& box, ImGuiID id, bool hovered, double fraction) {
    const Palette& colors = palette();
    const bool held = ImGui::GetActiveID() == id;
    const float grab = ImGui::GetStyle().GrabMinSize * .5F, middle = box.GetCenter().y;
    const float half = std::round(box.GetHeight() * .16F);
    const float knob = box.Min.x + grab + static_cast<float>(fraction) * (box.GetWidth() - 2 * grab);
    const ImGuiCol track = held ? ImGuiCol_FrameBgActive : hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({box.Min.x, middle - half}, {box.Max.x, middle + half}, ImGui::GetColorU32(track), half);
    list.AddRectFilled({box.Min.x, middle - half}, {knob, middle + half}, pack(colors.filled), half);
    const float reach = std::round(box.GetHeight() * .38F);
    list.AddRectFilled({knob - grab, middle - reach}, {knob + grab, middle + reach},
                       pack(held || hovered ? colors.accent_pressed : colors.accent), grab);
}

}  // namespace

float width_of(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

float button_width(std::string_view label) { return width_of(label) + 2 * ImGui::GetStyle().FramePadding.x; }

float check_box_width(std::string_view label) {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + width_of(label);
}

void follow(float width, float gap) {
    const float before = gap < 0 ? ImGui::GetStyle().ItemSpacing.x : gap;
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + before + width <= end) ImGui::SameLine(0, gap);
}

void tip(std::string_view text) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("%.*s", static_cast<int>(text.size()), text.data());
}

bool button(const char* text, Layout& layout, std::string_view name) {
    const bool pressed = ImGui::Button(text);
    layout.note(name);
    return pressed;
}

bool next_button(const char* text, Layout& layout, std::string_view name) {
    follow(button_width(text));
    return button(text, layout, name);
}

void label(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine();
}

void wrapped(std::string_view text, bool dim) {
    ImGui::PushTextWrapPos(0);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(dim ? ImGuiCol_TextDisabled : ImGuiCol_Text));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
}

Text shortened(std::string_view text, float width) {
    if (width_of(text) <= width) return Text(text);
    static constexpr std::string_view dots = "\u2026";
    const float room = width - width_of(dots);
    std::size_t least = 0, most = text.size();
    while (least < most) {
        const std::size_t middle = (least + most + 1) / 2;
        if (width_of(text.substr(0, middle)) <= room)
            least = middle;
        else
            most = middle - 1;
    }
    const auto inside = [&](std::size_t at) { return at < text.size() && (text[at] & 0xC0) == 0x80; };
    while (least > 0 && inside(least)) --least;
    if (least == 0) do
            ++least;
        while (inside(least));
    return std::move(Text(text.substr(0, least)).append(dots));
}

bool fitted(std::string_view text, float width, bool dim) {
    const Text part = shortened(text, width);
    if (dim) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(part.begin(), part.end());
    if (dim) ImGui::PopStyleColor();
    if (part == text) return true;
    tip(text);
    return false;
}

bool section(const char* title, Titles& open, Layout& layout, const char* name) {
    show_opened();
    const auto kept = open.find(std::string_view(title));
    ImGui::SetNextItemOpen(kept != open.end());
    const bool opened = ImGui::CollapsingHeader(title);
    layout.note(name);
    keep_in_view(opened);
    if (opened && kept == open.end()) open.emplace(title);
    if (!opened && kept != open.end()) open.erase(kept);
    return opened;
}

namespace {

constexpr ImGuiID top_of_opened = 0x5EC71014;

}  // namespace

// The state is that of the window that scrolls: which header was opened, in how many more frames its contents may still
// grow, and where it is in this frame.
void keep_in_view(bool open) {
    constexpr int until_whole = 4;
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID header = ImGui::GetItemID(), before = header + 1;
    const ImGuiID opened = ImHashStr("opened"), frames = ImHashStr("frames");
    const bool was_open = kept.GetBool(before, open);
    kept.SetBool(before, open);
    if (open && !was_open) {
        kept.SetInt(opened, static_cast<int>(header));
        kept.SetInt(frames, until_whole);
    }
    const int left = kept.GetInt(frames);
    if (left == 0 || kept.GetInt(opened) != static_cast<int>(header)) return;
    kept.SetInt(frames, open ? left - 1 : 0);
    if (open) kept.SetFloat(top_of_opened, ImGui::GetItemRectMin().y - ImGui::GetWindowPos().y + ImGui::GetScrollY());
}

void show_opened() {
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const float top = kept.GetFloat(top_of_opened, -1), bottom = ImGui::GetCursorPosY(),
                height = ImGui::GetWindowHeight();
    if (top < 0) return;
    kept.SetFloat(top_of_opened, -1);
    const float scroll = ImGui::GetScrollY();
    if (top < scroll || bottom > scroll + height) ImGui::SetScrollY(std::min(top, bottom - height));
}

bool tab(const char* title, bool chosen, Layout& layout, const char* name) {
    ImGui::PushStyleColor(ImGuiCol_Button, {0, 0, 0, 0});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(chosen ? ImGuiCol_Text : ImGuiCol_TextDisabled));
    const bool pressed = button(title, layout, name);
    ImGui::PopStyleColor(2);
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const float line = std::round(ImGui::GetFontSize() * .15F);
    if (chosen) ImGui::GetWindowDrawList()->AddRectFilled({from.x, to.y - line}, to, pack(palette().accent));
    return pressed;
}

bool slider(const char* label, double& value, SliderRange& range, double initial, SliderMemory& memory) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    if (window->SkipItems) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const ImGuiID id = window->GetID(label);
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 4 * ImGui::GetStyle().GrabMinSize),
                      ImGui::GetFrameHeight());
    const ImRect box(window->DC.CursorPos, window->DC.CursorPos + size);
    ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(box, id, &box, ImGuiItemFlags_Inputable)) return false;

    const bool hovered = ImGui::ItemHoverable(box, id);
    bool typing = ImGui::TempInputIsActive(id);
    bool changed = false;
    if (hovered && !typing && io.MouseClicked[0]) {
        const bool twice = io.MouseDoubleClicked[0] && memory.id == id;
        if (twice) changed = std::exchange(value, memory.before) != memory.before;
        memory = {id, value, false, 0};
        typing = twice || io.KeyCtrl;
        ImGui::SetActiveID(id, window);
        ImGui::SetFocusID(id, window);
        ImGui::FocusWindow(window);
    }
    if (typing) {
        if (type_value(box, id, label, value, range.integral)) {
            range.min = std::min(range.min, value);
            range.max = std::max(range.max, value);
            changed = true;
        }
        return changed;
    }

    if (hovered && io.MouseClicked[1] && value != initial) {
        value = initial;
        changed = true;
    }
    if (ImGui::GetActiveID() == id) {
        if (!io.MouseDown[0]) {
            ImGui::ClearActiveID();
        } else if (range.min < range.max) {
            const double dragged = dragged_to(box, value, range, memory);
            changed |= dragged != value;
            value = dragged;
        }
    }
    ImGui::RenderNavHighlight(box, id);
    draw_slider(box, id, hovered, fraction_of(value, range));
    return changed;
}

bool number(const char* id, double& value, bool integral, double initial, float width) {
    // Dear ImGui gets only ranges and speeds that it supports.
    const double speed = integral ? .1 : std::clamp(std::abs(value) * .01, 1e-3, 1e30);
    double edited = value;
    ImGui::SetNextItemWidth(width);
    bool changed = ImGui::DragScalar(id, ImGuiDataType_Double, &edited, static_cast<float>(speed), nullptr, nullptr,
                                     integral ? "%.0f" : "%.5g", ImGuiSliderFlags_NoRoundToFormat);
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        edited = initial;
        changed = true;
    }
    if (!changed) return false;
    const std::optional<double> valid = typed(exact(edited), integral);
    if (!valid || *valid == value) return false;
    value = *valid;
    return true;
}

bool color_row(const char* id, double* value, int components, const double* initial) {
    const auto count = static_cast<std::size_t>(components);
    std::array<float, 4> edited{0, 0, 0, 1};
    std::transform(value, value + count, edited.begin(), [](double v) { return static_cast<float>(v); });
    const std::array<float, 4> before = edited;
    constexpr ImGuiColorEditFlags flags = ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions |
                                          ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR |
                                          ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_AlphaPreviewHalf;
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (components == 4)
        ImGui::ColorEdit4(id, edited.data(), flags);
    else
        ImGui::ColorEdit3(id, edited.data(), flags);
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        const bool changed = !std::equal(value, value + count, initial);
        std::copy_n(initial, count, value);
        return changed;
    }
    // Only the edited component changes: the others keep the precision that a float lacks.
    bool changed = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (edited[i] == before[i] || !std::isfinite(edited[i])) continue;
        value[i] = tidy(edited[i]);
        changed = true;
    }
    return changed;
}

}  // namespace snell::ui
