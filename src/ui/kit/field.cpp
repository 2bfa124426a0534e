#include "src/ui/kit/field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "src/plan/hand/gesture.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/numbers.h"
#include "src/ui/kit/widgets.h"

namespace snell::ui {

namespace {

// Values behind a modal dialog, and disabled ones, are out of reach.
bool reachable() {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    const ImGuiWindow* modal = ImGui::GetTopMostPopupModal();
    if (modal && g.CurrentWindow->RootWindow != modal) return false;
    return (g.CurrentItemFlags & ImGuiItemFlags_Disabled) == 0;
}

void say(const ImRect& box, std::string_view what) {
    const ImVec2 size = box.GetSize();
    Tip& remark = kit().remark;
    remark.item = remark.window = {box.Min.x, box.Min.y, size.x, size.y};
    remark.text.assign(what);
    remark.shown = true;
}

void close() {
    kit().typing.id = 0;
    kit().remark.shown = false;
}

bool apply(double& value, double entered) {
    close();
    const bool changed = value != entered;
    value = entered;
    return changed;
}

}  // namespace

bool focusable(const ImRect& box, ImGuiID id) {
    Focus& focus = kit().focus;
    if (!reachable()) return false;
    if (focus.passed && focus.after == 0) focus.after = id;
    if (focus.first == 0) focus.first = id;
    if (focus.at == id) {
        focus.before = focus.last;
        focus.passed = true;
        if (focus.tabbed) ImGui::ScrollToRect(ImGui::GetCurrentWindow(), box);
    }
    focus.last = id;
    return focus.at == id;
}

void take_focus(ImGuiID id) {
    kit().focus.at = id;
    kit().focus.taken = true;
}

void draw_focus(const ImRect& box, ImGuiID id) {
    if (kit().focus.at != id) return;
    const float width = std::max(1.F, std::round(ImGui::GetFontSize() / 8)), gap = width;
    ImGui::GetWindowDrawList()->AddRect({box.Min.x - gap, box.Min.y}, box.Max, ImGui::GetColorU32(palette().accent),
                                        ImGui::GetStyle().FrameRounding, 0, width);
}

double key_steps(ImGuiID id) {
    const ImGuiIO& io = ImGui::GetIO();
    if (kit().focus.at != id || !kit().focus.passed || io.WantTextInput || io.KeyCtrl || io.KeyAlt) return 0;
    const auto way = [](Key up, Key down) { return int{pressed(up, true)} - int{pressed(down, true)}; };
    const int arrows = way(Key::right, Key::left) + way(Key::up, Key::down);
    return arrows * (io.KeyShift ? .1 : 1) + 10 * way(Key::page_up, Key::page_down);
}

void type_number(ImGuiID id, double value) {
    Typing& typing = kit().typing;
    typing.id = id;
    typing.fresh = typing.selected = typing.drawn = true;
    typing.text = {};
    fmt::format_to_n(typing.text.data(), typing.text.size() - 1, "{}", value);
    take_focus(id);
    kit().focus.opens = false;
}

bool is_typed(ImGuiID id) {
    const Focus& focus = kit().focus;
    if (kit().typing.id == id) return true;
    if (focus.at != id || !focus.passed) return false;
    return focus.opens || (!ImGui::GetIO().WantTextInput && (pressed(Key::enter) || pressed(Key::keypad_enter)));
}

bool typed_field(const ImRect& box, ImGuiID id, const char* label, double& value, bool integral) {
    Typing& typing = kit().typing;
    if (typing.id != id) type_number(id, value);
    typing.drawn = true;
    const bool fresh = typing.fresh;
    bool left = !fresh && ImGui::GetActiveID() != id;  // another widget was pressed
    if (!left) {
        ImGuiContext& g = *ImGui::GetCurrentContext();
        if (fresh) {
            g.NavActivateInputId = id;
            g.NavActivateFlags = typing.selected ? ImGuiActivateFlags_None : ImGuiActivateFlags_TryToPreserveState;
        }
        if (ImGui::TempInputText(box, id, label, typing.text.data(), static_cast<int>(typing.text.size()),
                                 typing.selected ? ImGuiInputTextFlags_AutoSelectAll : ImGuiInputTextFlags_None))
            kit().remark.shown = false;
        g.NavActivateInputId = 0;
        typing.fresh = false;
        if (fresh) return false;
        if (pressed(Key::escape)) {
            take(Key::escape);
            close();
            return false;
        }
    }
    const bool tab = pressed(Key::tab, true), enter = pressed(Key::enter) || pressed(Key::keypad_enter);
    left = left || ImGui::GetActiveID() != id;
    if (!left && !tab && !enter) return false;
    const std::string_view text = typing.text.data();
    if (const std::optional<double> entered = typed(text, integral)) return apply(value, *entered);
    if (tab || enter) {
        typing.fresh = true;
        typing.selected = false;
        kit().focus.refused = true;
        say(box, "not a number");
    } else {
        const std::string remark = fmt::format("'{}' is not a number", text);
        close();
        say(box, remark);
    }
    return false;
}

namespace {

// Returns the value that the mouse or the keyboard has moved the number to.
double moved(double value, ImGuiID id, const NumberStyle& style, bool held) {
    const ImGuiIO& io = ImGui::GetIO();
    double& exact = kit().dragged;
    if (!held || io.MouseClicked[0]) exact = value;
    const double before = exact;
    if (held) exact += style.speed * io.MouseDelta.x * (io.KeyAlt ? .05 : io.KeyShift ? 10 : 1);
    if (const double steps = key_steps(id); steps != 0)
        exact += style.integral ? std::copysign(std::max(1., std::abs(steps)), steps) : steps * style.speed;
    if (exact == before) return value;
    return style.integral ? std::round(exact) : tidy_step(exact, style.speed);
}

void draw_number(const ImRect& box, double value, const NumberStyle& style, bool hovered, bool held) {
    const ImGuiCol fill = held ? ImGuiCol_FrameBgActive : hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg;
    ImGui::RenderFrame(box.Min, box.Max, ImGui::GetColorU32(fill), true, ImGui::GetStyle().FrameRounding);
    const Text text = style.integral ? Text("{:.0f}", value) : Text("{:.{}g}", value, style.digits);
    ImGui::RenderTextClipped(box.Min, box.Max, text.begin(), text.end(), nullptr, {.5F, .5F});
}

}  // namespace

bool number_field(const char* label, double& value, double initial, float width, const NumberStyle& style) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    if (window->SkipItems) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const ImGuiID id = window->GetID(label);
    ImGui::SetNextItemWidth(width);
    const ImVec2 size(ImGui::CalcItemWidth(), ImGui::GetFrameHeight());
    const ImVec2 at = window->DC.CursorPos;
    const ImRect box(at.x, at.y, at.x + size.x, at.y + size.y);
    focusable(box, id);
    ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(box, id, &box) && !is_typed(id)) return false;
    ImGui::GetCurrentContext()->NextItemData.ClearFlags();
    if (is_typed(id)) return typed_field(box, id, label, value, style.integral);

    bool hovered = false, held = false;
    const bool clicked = ImGui::ButtonBehavior(box, id, &hovered, &held);
    const bool dragged = io.MouseDragMaxDistanceSqr[0] > io.MouseDragThreshold * io.MouseDragThreshold;
    if (held) take_focus(id);
    if ((clicked && !dragged) || (held && io.MouseClicked[0] && io.KeyCtrl)) type_number(id, value);
    double edited = moved(value, id, style, held && dragged);
    if (hovered && io.MouseClicked[1]) edited = initial;
    draw_number(box, value, style, hovered, held);
    draw_focus(box, id);
    if (edited == value) return false;
    const std::optional<double> valid = fitting(edited, style.integral);
    if (!valid || *valid == value) return false;
    value = *valid;
    return true;
}

bool number(const char* label, double& value, bool integral, double initial, float width) {
    const double speed = integral ? .1 : std::clamp(std::abs(value) * .01, 1e-3, 1e30);
    return number_field(label, value, initial, width, {speed, integral});
}

}  // namespace snell::ui
