// Fields for numbers: what sliders, numbers and colours have in common.
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <span>
#include <string_view>

#include "src/plan/values/controls.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/widgets.h"

namespace snell::ui {

// Adds a value, or what keys only press, to the order of Tab. Call it for each in the order on screen, also while it is
// scrolled out of view. Returns true if it has the keyboard's focus.
bool focusable(const ImRect& box, ImGuiID id, Focus::Kind kind = Focus::Kind::value);
void take_focus(ImGuiID id);
// Draws a ring around the widget if it has the focus.
void draw_focus(const ImRect& box, ImGuiID id);
// The steps that the keyboard asks for, if the value has the focus: 1 for an arrow key, .1 with Shift, 10 for a Page
// key.
double key_steps(ImGuiID id);

// Opens the field of this value in this frame.
void type_number(ImGuiID id, double value);
bool is_typed(ImGuiID id);
// Draws the field in place of the widget. Returns true if the user entered another number: with Enter, with Tab, or by
// leaving the field. A text that is not a number, or one beyond the limits, keeps the field open, or leaves the value
// as it was, and is refused in red.
bool typed_field(const ImRect& box, ImGuiID id, const char* label, double& value, ValueType type,
                 const NumberLimits& limits = {});

// Says in red below a field why its text is not taken.
void say(const ImRect& box, std::string_view what);

// Draws a field for text, with `hint` while it is empty, as wide as ImGui::SetNextItemWidth says. It opens when Tab
// reaches it. Returns what ImGui::InputText does.
bool text_field(const char* id, const char* hint, std::span<char> text, ImGuiInputTextFlags flags = 0);

struct NumberStyle {
    double speed = .01;  // per point of a drag, and per press of an arrow key
    ValueType type = ValueType::float_;
    int digits = 5;
    NumberLimits limits = {};
};
// Draws a field to type a number into, or to drag; see number().
bool number_field(const char* label, double& value, double initial, float width, const NumberStyle& style);

}  // namespace snell::ui
