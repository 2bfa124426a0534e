#include "src/ui/kit/field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "src/plan/values/numbers.h"
#include "src/plan/view.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/style.h"
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

bool in_popup() { return (ImGui::GetCurrentWindow()->RootWindow->Flags & ImGuiWindowFlags_Popup) != 0; }
bool in_menu() { return in_popup() && (ImGui::GetCurrentWindow()->RootWindow->Flags & ImGuiWindowFlags_Modal) == 0; }

// Many window managers move the window by a drag with Alt.
bool fine() { return ImGui::GetIO().KeyAlt || ImGui::GetIO().KeyShift; }

// True if Escape ends the drag of this widget, which then has its value of before.
bool cancelled(ImGuiID id) {
    if (ImGui::GetActiveID() != id || !pressed(Key::escape)) return false;
    take(Key::escape);
    ImGui::ClearActiveID();
    return true;
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

void say(const ImRect& box, std::string_view what) {
    const ImVec2 size = box.GetSize();
    Tip& remark = kit().remark;
    remark.item = remark.window = {box.Min.x, box.Min.y, size.x, size.y};
    remark.text.assign(what);
    remark.shown = true;
}

bool focusable(const ImRect& box, ImGuiID id, Focus::Kind kind) {
    Focus& focus = kit().focus;
    if (!reachable()) return false;
    focus.stops.push_back({id, kind, in_menu()});
    if (focus.at != id) return false;
    focus.passed = true;
    focus.box = {box.Min.x, box.Min.y, box.GetWidth(), box.GetHeight()};
    if (focus.tabbed) ImGui::ScrollToRect(ImGui::GetCurrentWindow(), box);
    return true;
}

void take_focus(ImGuiID id) {
    kit().focus.at = id;
    kit().focus.taken = true;
    kit().focus.presses = false;
}

void draw_focus(const ImRect& box, ImGuiID id) {
    if (kit().focus.at != id) return;
    const float width = std::max(1.F, std::round(ImGui::GetFontSize() / 8)), gap = width;
    ImGui::GetWindowDrawList()->AddRect({box.Min.x - gap, box.Min.y}, box.Max, ImGui::GetColorU32(palette().accent),
                                        ImGui::GetStyle().FrameRounding, 0, width);
}

bool text_field(const char* id, const char* hint, std::span<char> text, ImGuiInputTextFlags flags) {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImRect box(at, {at.x + ImGui::CalcItemWidth(), at.y + ImGui::GetFrameHeight()});
    const ImGuiID item = ImGui::GetID(id);
    Focus& focus = kit().focus;
    const bool enter = pressed(Key::enter) || pressed(Key::keypad_enter);
    // In dialogs and menus, where letters are no keys, they go to the field: in menus, which have one, wherever the
    // focus is.
    ImVector<ImWchar> typed;
    const bool focused = focusable(box, item, Focus::Kind::text), free = !g.IO.WantTextInput;
    if ((focused || in_menu()) && free && in_popup() && !g.IO.KeyCtrl && !g.IO.KeyAlt)
        typed = g.IO.InputQueueCharacters;
    const bool letters = !typed.empty() && typed[0] > ' ';
    if (letters || (focused && (focus.opens || (free && enter)))) {
        g.NavActivateInputId = item;
        g.NavActivateFlags = letters ? ImGuiActivateFlags_TryToPreserveState : ImGuiActivateFlags_None;
        focus.opens = false;
        take(Key::enter);
        take(Key::keypad_enter);
    }
    const bool changed = ImGui::InputTextWithHint(id, hint, text.data(), text.size(), flags);
    g.NavActivateInputId = 0;
    // Dear ImGui drops what is typed in the frame in which a field becomes active.
    if (ImGuiInputTextState* state = letters ? ImGui::GetInputTextState(item) : nullptr)
        for (const ImWchar c : typed) state->OnKeyPressed(c);
    if (ImGui::IsItemActive() && focus.at != item) take_focus(item);
    if (!ImGui::IsItemActive()) draw_focus(box, item);
    return changed;
}

double key_steps(ImGuiID id) {
    const ImGuiIO& io = ImGui::GetIO();
    if (kit().focus.at != id || !kit().focus.passed || io.WantTextInput || io.KeyCtrl || io.KeyAlt) return 0;
    if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0 && !in_popup()) return 0;  // the keys are the menu's
    const auto way = [](Key up, Key down) { return int{pressed(up, true)} - int{pressed(down, true)}; };
    const int arrows = way(Key::right, Key::left) + way(Key::up, Key::down);
    return arrows * (io.KeyShift ? .1 : 1) + 10 * way(Key::page_up, Key::page_down);
}

void type_number(ImGuiID id, double value) {
    Typing& typing = kit().typing;
    if (typing.id != 0 && typing.id != id) {
        typing.next = id;
        typing.next_value = value;
        return;
    }
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

bool leave_field() {
    if (kit().typing.id == 0) return false;
    ImGui::ClearActiveID();
    return true;
}

bool refused() { return kit().remark.shown; }

bool typed_field(const ImRect& box, ImGuiID id, const char* label, double& value, ValueType type,
                 const NumberLimits& limits) {
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
    const std::optional<double> entered = typed(text, type);
    const bool fits = entered && *entered >= limits.min && *entered <= limits.max;
    if (fits) return apply(value, *entered);
    const std::optional<double> found = evaluated(text);
    const std::string wrong = entered            ? fmt::format("not from {:.10g} to {:.10g}", limits.min, limits.max)
                              : !is_number(text) ? "not a number"
                              : found && fitting(*found, type) ? "not a whole number"
                                                               : "out of the type's range";
    if (tab || enter) {
        typing.fresh = true;
        typing.selected = false;
        kit().focus.refused = true;
        say(box, wrong);
    } else {
        const std::string remark = fmt::format("'{}' is {}", text, wrong);
        close();
        say(box, remark);
    }
    return false;
}

namespace {

// Returns the value that the mouse or the keyboard has moved the number to.
double moved(double value, double initial, ImGuiID id, const NumberStyle& style, bool held) {
    const ImGuiIO& io = ImGui::GetIO();
    Drag& drag = kit().drag;
    if (!held && drag.id == id) drag.id = 0;
    if (held && drag.id != id) drag = {id, {value, initial}, value};
    if (held && cancelled(id)) return drag.before.restored(initial);
    double exact = held ? drag.exact : value;
    const double before = exact;
    if (held) exact += style.speed * io.MouseDelta.x * (fine() ? .05 : 1);
    if (const double steps = key_steps(id); steps != 0)
        exact += is_whole(style.type) ? std::copysign(std::max(1., std::abs(steps)), steps) : steps * style.speed;
    if (held) drag.exact = exact;
    if (exact == before) return value;
    return is_whole(style.type) ? std::round(exact) : tidy_step(exact, style.speed);
}

void draw_number(const ImRect& box, double value, const NumberStyle& style, bool hovered, bool held) {
    const ImGuiCol fill = held ? ImGuiCol_FrameBgActive : hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg;
    ImGui::RenderFrame(box.Min, box.Max, ImGui::GetColorU32(fill), true, ImGui::GetStyle().FrameRounding);
    Text text = is_whole(style.type) ? Text("{:.0f}", value) : Text("{:.{}g}", unsigned_zero(value), style.digits);
    for (int digits = style.digits - 1; digits > 0 && width_of(text.view()) > box.GetWidth(); --digits)
        if (!is_whole(style.type)) text = Text("{:.{}g}", unsigned_zero(value), digits);
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
    if (is_typed(id)) return typed_field(box, id, label, value, style.type, style.limits);

    bool hovered = false, held = false;
    const bool clicked = ImGui::ButtonBehavior(box, id, &hovered, &held);
    const bool dragged = io.MouseDragMaxDistanceSqr[0] > io.MouseDragThreshold * io.MouseDragThreshold;
    if (held) take_focus(id);
    if ((clicked && !dragged) || (held && io.MouseClicked[0] && io.KeyCtrl)) type_number(id, value);
    double edited = moved(value, initial, id, style, held && dragged);
    if (hovered && io.MouseClicked[1]) edited = initial;
    draw_number(box, value, style, hovered, held);
    draw_focus(box, id);
    if (edited == value) return false;
    edited = std::clamp(edited, style.limits.min, style.limits.max);
    const std::optional<double> valid = fitting(edited, style.type);
    if (!valid || *valid == value) return false;
    value = *valid;
    return true;
}

bool number(const char* label, double& value, ValueType type, double initial, float width, const NumberLimits& limits) {
    const double speed = is_whole(type) ? .1 : std::clamp(std::abs(value) * .01, 1e-3, 1e30);
    return number_field(label, value, initial, width, {.speed = speed, .type = type, .limits = limits});
}

}  // namespace snell::ui

// Dear ImGui's own sliders abort the process on infinite ranges and round values to the displayed text. Our slider
// needs internal functions, which imgui_internal.h declares.
namespace snell::ui {

namespace {

ImU32 pack(ImVec4 color) { return ImGui::GetColorU32(color); }

// Returns the value that the mouse has dragged the knob to: under the pointer, or relative to where the drag began.
double dragged_to(const ImRect& box, double value, const SliderRange& range, SliderMemory& memory) {
    const ImGuiIO& io = ImGui::GetIO();
    const float grab = ImGui::GetStyle().GrabMinSize * .5F, way = std::max(1.0F, box.GetWidth() - 2 * grab);
    if (fine() && !memory.relative) {
        memory.relative = true;
        memory.fraction = fraction_of(value, range);
    }
    if (!memory.relative) {
        const double at = (io.MousePos.x - box.Min.x - grab) / way;
        return std::isfinite(at) ? value_at(std::clamp(at, 0.0, 1.0), range, false) : value;
    }
    constexpr double slow = .05;
    const double moved = io.MouseDelta.x / way * (fine() ? slow : 1);
    if (!std::isfinite(moved) || moved == 0) return value;
    memory.fraction = std::clamp(memory.fraction + moved, 0.0, 1.0);
    return value_at(memory.fraction, range, fine());
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

// The number beside the track looks like a field, because a press edits it. Returns true if it was pressed.
bool number_beside(const ImRect& box, double value, const SliderRange& range) {
    const bool hovered = ImGui::ItemHoverable(box, ImGui::GetID("##number"));
    if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    ImGui::RenderFrame(box.Min, box.Max, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), true,
                       ImGui::GetStyle().FrameRounding);
    const float padding = ImGui::GetStyle().FramePadding.x * .5F;
    std::string text = shown(value, range.min, range.max, is_whole(range.type));
    if (width_of(text) > box.GetWidth() - 2 * padding) text = fmt::format("{:.3g}", unsigned_zero(value));
    ImGui::RenderTextClipped({box.Min.x + padding, box.Min.y}, {box.Max.x - padding, box.Max.y}, text.data(),
                             text.data() + text.size(), nullptr, {1, .5F});
    return hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

void take_back(double& value, double initial, SliderRange& range, SliderMemory& memory) {
    value = memory.before.restored(initial);
    range.taken_back = memory.taken_back = true;
}

// Begins a drag, or opens the field at the second of two clicks.
void press(ImGuiID id, double& value, double initial, SliderRange& range, SliderMemory& memory) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool twice = io.MouseDoubleClicked[0] && memory.id == id && !memory.dragged;
    if (twice)
        take_back(value, initial, range, memory);
    else
        memory = {id, {value, initial}};
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
    if (hovered && io.MouseClicked[0] && !is_typed(id)) press(id, value, initial, range, memory);
    if (is_typed(id)) {
        typed_field(whole, id, label, value, range.type);
        range.min = std::min(range.min, value);
        range.max = std::max(range.max, value);
        return value != before;
    }
    range.reset = hovered && io.MouseClicked[1];
    if (range.reset) value = initial;
    value = stepped(value, key_steps(id), range);
    if (ImGui::GetActiveID() == id) {
        const float threshold = io.MouseDragThreshold;
        memory.dragged = memory.dragged || io.MouseDragMaxDistanceSqr[0] > threshold * threshold;
        if (cancelled(id))
            take_back(value, initial, range, memory);
        else if (!io.MouseDown[0])
            ImGui::ClearActiveID();
        else if (range.min < range.max)
            value = dragged_to(box, value, range, memory);
    }
    // After what changes the value: number and knob say the same, however long the next picture takes.
    if (number_width > 0 && number_beside({{whole.Max.x - number_width, box.Min.y}, whole.Max}, value, range))
        type_number(id, value);
    draw_slider(box, id, hovered, fraction_of(value, range));
    draw_focus(whole, id);
    return value != before;
}

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
    note_opener({at.x, at.y, side, side}, open, true);
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
