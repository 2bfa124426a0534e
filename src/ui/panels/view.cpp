#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "src/plan/view.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

struct Target {
    Held held;
    const char *name, *help;
};
constexpr std::array<Target, 4> targets{{
    {Held::scene, "Scene", "Rotates the scene about its origin (changes the projection matrix)"},
    {Held::eye, "Eye", "Rotates and moves the eye (changes the model-view matrix)"},
    {Held::object, "Object", "Transforms the picked object about its own origin"},
    {Held::texture, "Texture", "gl_TextureMatrix[0]"},
}};

// Draws the choice of what the mouse and the numbers below change; a star marks what differs from its initial state.
void target_row(const View& view, HoldMemory& hold, Layout& layout) {
    for (const Target& target : targets) {
        HoldMemory other = hold;
        other.held = target.held;
        const bool changed = !(held(view, other) == Transformation{});
        const std::string text = std::string(target.name) + (changed ? "*" : "");
        if (target.held != Held::scene) follow(button_width(text));
        const bool there = target.held != Held::object || hold.object != none;
        const bool on = hold.held == target.held;
        ImGui::BeginDisabled(!there);
        if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        if (or_keys(ImGui::Button((text + "###" + target.name).c_str()))) hold.held = target.held;
        if (on) ImGui::PopStyleColor();
        ImGui::EndDisabled();
        tip(there ? target.help : "Pick an object first: press P, then click it.");
        layout.note("hold", target.name);
    }
}

struct Field {
    const char* name;
    double Transformation::*value;
    const char* help;
};

// Draws up to three fields in a row, none narrower than its number.
void fields(const char* name, std::initializer_list<Field> row, Transformation& t, Layout& layout) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, begin = 3.2F * ImGui::GetFontSize();
    const float least = button_width("-123.456");
    label(name);
    ImGui::SameLine(begin);
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::clamp(static_cast<int>((room + gap) / (least + gap)), 1, 3);
    const float width = (room - static_cast<float>(columns - 1) * gap) / static_cast<float>(columns);
    int at = 0;
    for (const Field& field : row) {
        if (at % columns != 0)
            ImGui::SameLine(0, gap);
        else if (at > 0)
            ImGui::SetCursorPosX(begin);
        ++at;
        ImGui::PushID(field.name);
        number("##value", t.*field.value, ValueType::float_, Transformation{}.*field.value, std::max(1.0F, width));
        tip(Text("{}: {}", field.name, field.help).view());
        layout.note("view", field.name);
        ImGui::PopID();
    }
}

void transformation(View& view, HoldMemory& hold, Layout& layout) {
    const Transformation before = held(view, hold);
    Transformation t = before;
    fields("turn",
           {{"rotate_x", &Transformation::rotate_x, "degrees about the horizontal"},
            {"rotate_y", &Transformation::rotate_y, "degrees about the vertical"},
            {"rotate_z", &Transformation::rotate_z, "degrees about the line of sight"}},
           t, layout);
    fields("move",
           {{"x", &Transformation::x, "to the right, in units of the scene"},
            {"y", &Transformation::y, "upwards, in units of the scene"},
            {"z", &Transformation::z, "towards the viewer, in units of the scene"}},
           t, layout);
    fields("scale", {{"scale", &Transformation::scale, "1 is as in the scene"}}, t, layout);
    t.scale = std::clamp(t.scale, 1e-3, 1e3);
    ImGui::BeginDisabled(before == Transformation{});
    if (next_button("Reset", layout, "reset held")) t = {};
    ImGui::EndDisabled();
    tip("Resets this transformation. 'Reset view' or R resets all.");
    if (!(t == before)) set_held(view, hold, t);
}

void background_row(const Scene& scene, View& view, Memory& memory, Layout& layout) {
    label("background");
    const double initial =
        std::clamp(std::max({scene.background[0], scene.background[1], scene.background[2]}), 0., 1.);
    double value = view.background.value_or(initial);
    SliderRange range{{0, 1}};
    if (slider("##background", value, range, initial, memory.slider)) {
        view.background = std::clamp(value, 0., 1.);
        if (value == initial) view.background.reset();
    }
    layout.note("background");
}

}  // namespace

void view_section(const Facts& facts, View& view, Memory& memory, Layout& layout) {
    if (!facts.scene || !section("View", "What the mouse turns, scales and moves, as numbers; the background",
                                 memory.open, layout, "view"))
        return;
    background_row(*facts.scene, view, memory, layout);
    wrapped("mouse and numbers change", true);
    target_row(view, memory.hold, layout);
    if (memory.hold.held == Held::object) {
        fitted(facts.object, ImGui::GetContentRegionAvail().x);
        layout.note("object");
    }
    transformation(view, memory.hold, layout);
}

void switch_picking(HoldMemory& hold) {
    hold.picking = !hold.picking;
    if (!hold.picking) hold_object(hold, none);
}

void view_keys(View& view, HoldMemory& hold) {
    if (plain(Key::r) || pressed(Key::home)) reset_view(view);
    if (plain(Key::p)) switch_picking(hold);
    if (!pressed(Key::escape)) return;
    if (hold.object == none) hold.picking = false;
    hold_object(hold, none);
}

namespace {

constexpr double step = 1. / 25;  // seconds per picture, the default of `snell render --frames`

}  // namespace

void clock_panel(const Facts& facts, Memory& memory, Layout& layout) {
    Clock& clock = memory.clock;
    clock.used |= memory.animating();
    if (!facts.scene || !(facts.timed || clock.used)) return;
    if (button(clock.paused ? "Play" : "Pause", layout, "play")) clock.paused = !clock.paused;
    if (next_button("Step", layout, "step")) {
        clock.paused = true;
        clock.time = (std::floor(clock.time / step + 1e-6) + 1) * step;
    }
    if (next_button("Rewind", layout, "rewind")) clock.time = 0;
    tip("Sets the time to 0");
    follow(width_of("speed") + 5 * ImGui::GetFontSize());
    label("speed");
    number("##speed", clock.speed, ValueType::float_, 1, -FLT_MIN, {-1e3, 1e3});
    layout.note("speed");

    const double period = std::max(facts.scene->timer_period, 1e-3);
    label("t =");
    const float unit = width_of("s") + ImGui::GetStyle().ItemInnerSpacing.x;
    const float field = std::min(6 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x - unit);
    if (number("##time", clock.time, ValueType::float_, 0, std::max(field, 1.0F))) clock.paused = true;
    layout.note("time");
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextUnformatted("s");
    layout.note("time.unit");
    follow(4 * ImGui::GetFontSize());
    double within = clock.time - std::floor(clock.time / period) * period;
    SliderRange range{{0, period}};
    if (slider("##scrub", within, range, within, memory.slider)) {
        clock.paused = true;
        clock.time = within;
    }
    layout.note("scrub");
}

void clock_keys(const Facts& facts, Memory& memory) {
    if ((facts.timed || memory.animating()) && !kit().focus.presses && pressed(Key::space))
        memory.clock.paused = !memory.clock.paused;
}

}  // namespace snell::ui
