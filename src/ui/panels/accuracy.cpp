#include "src/ui/panels/accuracy.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/image/image.h"
#include "src/plan/values/numbers.h"
#include "src/ui/kit/field.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/panels.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

constexpr const char* no_error = "none";
// Half a level of 16 bits. Sums of the same values in another order differ by less, and so does a large picture in
// which an edge falls differently in one sample of a pixel.
constexpr double equal = .5 / 65535;

constexpr const char* error_meaning =
    "The error is the root mean square difference of light from the reference\n(the last rung of every ladder) over "
    "the "
    "whole picture, where white is 1";
constexpr const char* halves_meaning =
    "The error is the root mean square difference of light between the two halves\nover the whole picture, where "
    "white is 1";
constexpr const char* worst_meaning =
    "\nWorst: the row's error, the largest of all views and values that were tried,\n"
    "over the pixels in which the scene draws";

// Draws dimmed text at the right end of the line, if there is room.
void remark(const Text& text) {
    const float right = ImGui::GetContentRegionMax().x - width_of(text.view());
    ImGui::SameLine();
    if (ImGui::GetCursorPosX() > right) return ImGui::NewLine();
    ImGui::SetCursorPosX(right);
    ImGui::TextDisabled("%s", text.c_str());
}

// Says why nothing is compared.
void note(std::string_view why, Layout& layout, const char* name) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette().error_text);
    wrapped(why);
    ImGui::PopStyleColor();
    layout.note(name);
}

void figures(const Facts& all, const AccuracyFacts& facts, Layout& layout) {
    last_picture(all, layout);
    if (!facts.note.empty()) return note(facts.note, layout, "accuracy.note");
    const FoundRow* const rung = all.found ? shown_row(*all.found) : nullptr;
    const Text line =
        facts.samples > 0 ? error_line(facts.error, rung) : Text(all.accuracy ? "\u2026" : "no rung is shown");
    fitted(line.view(), ImGui::GetContentRegionAvail().x);
    if (facts.samples > 0 && ImGui::IsItemHovered()) tip(error_tip(facts) + (rung && rung->error ? worst_meaning : ""));
    layout.note("accuracy.error");
    if (all.accuracy) remark(Text("{} of {} samples per pixel", facts.samples, facts.wanted));
    if (facts.nonfinite > 0) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette().error_text);
        fitted(
            Text("{} {} NaN or infinite", counted(facts.nonfinite, "pixel"), facts.nonfinite > 1 ? "are" : "is").view(),
            ImGui::GetContentRegionAvail().x);
        ImGui::PopStyleColor();
    }
}

void legend(const AccuracyFacts& facts, float width, Layout& layout) {
    const float height = ImGui::GetFontSize() * .6F;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    constexpr int steps = 48;
    for (int i = 0; i < steps; ++i) {
        const auto [red, green, blue] = content::heat((static_cast<float>(i) + .5F) / steps);
        list.AddRectFilled({at.x + width * static_cast<float>(i) / steps, at.y},
                           {at.x + width * static_cast<float>(i + 1) / steps, at.y + height},
                           pack({red, green, blue, 1}));
    }
    ImGui::Dummy({width, height});
    constexpr std::array<const char*, 4> ends{"\u2264 .001", ".01", ".1", "\u2265 1"};
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const float text = ImGui::CalcTextSize(ends[i]).x;
        const float middle = width * static_cast<float>(i) / static_cast<float>(ends.size() - 1);
        if (i > 0) ImGui::SameLine();
        ImGui::SetCursorScreenPos({at.x + std::clamp(middle - text / 2, 0.0F, width - text),
                                   at.y + height + ImGui::GetStyle().ItemSpacing.y});
        ImGui::TextDisabled("%s", ends[i]);
    }
    if (!facts.unknown) return;
    const ImVec2 patch = ImGui::GetCursorScreenPos();
    const float middle = patch.y + (ImGui::GetTextLineHeight() - height) / 2;
    list.AddRectFilled({patch.x, middle}, {patch.x + 2 * height, middle + height},
                       pack({no_number[0], no_number[1], no_number[2], 1}));
    ImGui::SetCursorScreenPos({patch.x + 2.5F * height, patch.y});
    fitted("NaN or infinite", width - 2.5F * height, true);
    layout.note("accuracy.no number");
}

// Why the picture is plain although the heat map was chosen; empty if it is not.
std::string no_heat(const Facts& facts) {
    if (facts.states)
        for (const StateFacts::Side& side : facts.states->sides)
            if (side.blank) return "There is nothing to compare.\n" + side.label;
    return facts.accuracy ? facts.accuracy->note : "";
}

void show_buttons(AccuracyMemory& memory, Layout& layout) {
    using Show = AccuracyMemory::Show;
    constexpr std::array<std::pair<const char*, Show>, 3> choices{
        {{"Picture", Show::picture}, {"Split", Show::split}, {"Heat map", Show::heat}}};
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i > 0) follow(check_box_width(choices[i].first), ImGui::GetFontSize() * .8F);
        if (or_keys(ImGui::RadioButton(choices[i].first, memory.show == choices[i].second)))
            memory.show = choices[i].second;
        layout.note("accuracy", choices[i].first);
    }
}

// Marks the rung that the reference has.
Text rung_text(const std::string& rung, bool reference) {
    return shortened(Text("{}{}", rung, reference ? " = reference" : "").view(), ImGui::GetContentRegionAvail().x);
}

// Returns true if the pointer is over it.
bool heading(const char* name, Layout& layout) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", shortened(name, ImGui::GetContentRegionAvail().x).c_str());
    layout.note("accuracy.heading", name);
    return ImGui::IsItemHovered();
}

// Lists the rungs with their measured values; a click chooses one.
void rung_table(const Ladder& ladder, const AccuracyFacts& facts, std::size_t& chosen, Layout& layout) {
    if (!ImGui::BeginTable("##rungs", 3, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("", 0, 2);
    ImGui::TableSetupColumn("", 0, 1.2F);
    ImGui::TableSetupColumn("", 0, 1);
    if (heading("rung", layout)) tip("A click chooses the rung.");
    if (heading("ms/sample", layout))
        tip(Text("Median {} of drawing one sample per pixel, to compare rungs.", facts.clock).view());
    if (heading("error", layout)) tip(Text("{}.", error_meaning).view());
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
        const auto point = ranges::find(facts.points, std::optional(i), &AccuracyPoint::rung);
        const bool known = point != facts.points.end();
        const bool reference = i + 1 == ladder.rungs.size();
        ImGui::TableNextColumn();
        if (selectable(rung_text(ladder.rungs[i], reference).c_str(), i == chosen, ImGuiSelectableFlags_SpanAllColumns))
            chosen = i;
        layout.note("accuracy.rung", ladder.rungs[i]);
        if (known && ImGui::IsItemHovered()) tip(standing_text(*point));
        ImGui::TableNextColumn();
        if (known && point->milliseconds > 0) {
            const std::string text = milliseconds_text(point->milliseconds);
            ImGui::TextUnformatted(text.c_str(), text.c_str() + text.rfind(' '));
        }
        ImGui::TableNextColumn();
        if (known) ImGui::TextUnformatted(error_text(point->error).c_str());
    }
    ImGui::EndTable();
}

// Draws the choice of the plotted ladder and the button that measures it. Returns true if the button was clicked.
bool plot_tools(const std::vector<Ladder>& ladders, const AccuracyFacts& facts, AccuracyMemory& memory,
                Layout& layout) {
    const char* label = facts.measured ? "Stop" : "Measure rungs";
    const float button = ImGui::CalcTextSize("Measure rungs").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
    const bool list = begin_combo("##ladder", ladders[memory.ladder].name.c_str(), memory.ladder, ladders.size());
    layout.note("accuracy.ladder");
    if (list) {
        for (std::size_t i = 0; i < ladders.size(); ++i) {
            if (ImGui::Selectable(ladders[i].name.c_str(), i == memory.ladder)) memory.ladder = i;
            layout.note("accuracy.ladder", ladders[i].name);
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(!facts.note.empty() || facts.of_scene);
    const bool pressed = or_keys(ImGui::Button(label, {button, 0}));
    ImGui::EndDisabled();
    tip(facts.of_scene ? "Rungs are measured against the reference, not while two other states are shown"
                       : "Measures error and time of every rung of this ladder");
    layout.note("accuracy.measure");
    // Its room is there all the time, so that rows do not move under the pointer.
    const float high = ImGui::GetFontSize() * .4F;
    if (facts.measured)
        ImGui::ProgressBar(static_cast<float>(*facts.measured), {-FLT_MIN, high}, "");
    else
        ImGui::Dummy({1, high});
    return pressed;
}

// Draws error over cost of the rungs of a ladder. Returns true if the user starts measuring all of them, or stops it.
bool ladder_part(const Facts& all, Controls& controls, AccuracyMemory& memory, Layout& layout) {
    const Scene& scene = *all.scene;
    const AccuracyFacts& facts = *all.accuracy;
    memory.ladder = std::min(memory.ladder, scene.ladders.size() - 1);
    ImGui::Spacing();
    const bool measure = plot_tools(scene.ladders, facts, memory, layout);
    accuracy_plot(facts.points, memory.plot, layout);
    rung_table(scene.ladders[memory.ladder], facts, controls.rungs[memory.ladder], layout);
    wrapped(basis_text(all).view(), true);
    layout.note("accuracy.basis");
    if (!facts.remark.empty()) wrapped(facts.remark, true);
    return measure;
}

// What can be on one side.
void state_menu(const StateFacts& facts, const StateFacts::Side& side, bool left, AccuracyMemory& memory,
                Layout& layout) {
    std::string& name = left ? memory.left : memory.right;
    for (const StateFacts::Choice& choice : facts.choices) {
        if (selectable(choice.text.c_str(), choice.name == side.name)) name = choice.name;
        layout.note(left ? "left" : "right", choice.name);
    }
    const float em = ImGui::GetFontSize();
    const float width = std::min(std::clamp(button_width(facts.example), 12 * em, 24 * em),
                                 std::max(ImGui::GetIO().DisplaySize.x - 2 * em, 1.0F));
    const Text hint = shortened(facts.example, width - button_width(""));
    ImGui::SetNextItemWidth(width);
    if (ImGui::IsWindowAppearing()) memory.entered = false;
    const bool known = memory.entered && side.name == memory.settings.data(), refused = known && side.failed;
    if (known) memory.entered = false;
    if (refused) kit().focus.opens = true;  // the field, in which the text stays
    if (text_field("##settings", hint.c_str(), memory.settings, ImGuiInputTextFlags_EnterReturnsTrue)) {
        memory.entered = memory.settings[0] != '\0';
        if (memory.entered) name = memory.settings.data();
    } else if (ImGui::IsItemEdited()) {
        kit().remark.shown = false;
    }
    if (refused) {
        say({ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}, side.label);
    } else if (known) {
        memory.settings.fill('\0');
        ImGui::CloseCurrentPopup();
    }
    layout.note(left ? "left.settings" : "right.settings");
}

// The name of one side as a button, within that width.
void state_button(const StateFacts& facts, std::size_t index, float width, AccuracyMemory& memory, Layout& layout) {
    const bool left = index == 0;
    const StateFacts::Side& side = facts.sides[index];
    ImGui::PushID(left ? "left" : "right");
    const float arrow = button_width(" \u25BE");
    Text text = shortened(side.label, std::max(width - arrow, 1.0F));
    if (side.failed) ImGui::PushStyleColor(ImGuiCol_Text, palette().error_text);
    if (or_keys(ImGui::Button(text.append(" \u25BE###state").c_str(), {width, 0}))) ImGui::OpenPopup("states");
    if (side.failed) ImGui::PopStyleColor();
    layout.note(left ? "accuracy.left" : "accuracy.right");
    tip(side.label);
    if (begin_popup("states", true)) {
        state_menu(facts, side, left, memory, layout);
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

}  // namespace

Text basis_text(const Facts& facts) {
    const std::string_view clock = facts.accuracy->clock;
    return Text(
        "ms/sample compares rungs: {}{} with one sample per pixel. The last picture's time is the wait for it, with {} "
        "per pixel{}.",
        clock, clock == "process CPU time" ? " of all cores" : "",
        counted(static_cast<std::size_t>(facts.samples), "sample"), facts.states ? " in both states" : "");
}

std::string milliseconds_text(double milliseconds) {
    return fmt::format("{:.{}f} ms", milliseconds, milliseconds < 9.995 ? 2 : milliseconds < 99.95 ? 1 : 0);
}

std::string error_tip(const AccuracyFacts& facts) {
    const std::string ratio = std::isfinite(facts.psnr) ? fmt::format("the signal-to-noise ratio {:.1f} dB", facts.psnr)
                              : facts.error == 0        ? "nothing differs"
                                                        : "there is no signal-to-noise ratio";
    return fmt::format("{};\nthe largest is {}, {},\nand the root mean square of display values {}.",
                       facts.of_scene ? halves_meaning : error_meaning, error_text(facts.largest), ratio,
                       error_text(facts.of_display));
}

Text error_line(double error, const FoundRow* rung) {
    const std::string here = error_text(error), worst = rung && rung->error ? error_text(*rung->error) : here;
    Text line("error {}{}", here, here == no_error ? "" : " of white");
    if (worst != here) line.add(" here, worst {}", worst);
    return line;
}

std::string error_text(double error) {
    if (error < equal) return no_error;
    if (std::isnan(error)) return "unknown";
    if (!(error >= 1e-4 && error < 1)) return fmt::format("{:.2g}", error);
    const std::string text = fmt::format("{:.2g}", error);  // drops the leading zero, as in .0031
    return text.starts_with("0.") ? text.substr(1) : text;
}

std::string standing_text(const AccuracyPoint& point) {
    switch (point.standing) {
        case AccuracyPoint::Standing::front:
            return "worth its time";
        case AccuracyPoint::Standing::saves_none:
            return "costs as much as " + point.by + ", which is more exact";
        case AccuracyPoint::Standing::unsure:
            return "not surely cheaper than " + point.by + ", which is more exact";
        case AccuracyPoint::Standing::dominated:
            return point.by + " is better and cheaper";
        case AccuracyPoint::Standing::visited:
            break;
    }
    return {};
}

void follow_ladder(const Rungs& rungs, AccuracyMemory& memory) {
    if (memory.rungs == rungs) return;
    if (memory.rungs.size() == rungs.size())
        memory.ladder = static_cast<std::size_t>(std::mismatch(rungs.begin(), rungs.end(), memory.rungs.begin()).first -
                                                 rungs.begin());
    memory.rungs = rungs;
}

void accuracy_section(const Facts& facts, Controls& controls, bool moves, AccuracyMemory& memory, Requests& requests,
                      Layout& layout) {
    ImGui::SetNextItemOpen(memory.open);
    memory.open = header("Accuracy");
    tip("Error and time of the scene's approximations, and cheaper or better ones that snell finds");
    layout.note("accuracy");
    keep_in_view(memory.open);
    if (!memory.open) return;
    const float indent = ImGui::GetStyle().FramePadding.x * .5F;
    ImGui::Indent(indent);
    if (facts.accuracy && !facts.accuracy->reduced.empty()) {
        wrapped(facts.accuracy->reduced, true);
        layout.note("accuracy.reduced");
    }
    // Found rungs are compared with the scene: the room is there before one is shown, so that their rows do not move.
    if (facts.accuracy || (facts.found && !facts.found->rows.empty())) {
        figures(facts, facts.accuracy ? *facts.accuracy : AccuracyFacts(), layout);
        show_buttons(memory, layout);
        if (facts.accuracy && memory.show == AccuracyMemory::Show::heat && no_heat(facts).empty())
            legend(*facts.accuracy, ImGui::GetContentRegionAvail().x, layout);
    }
    if (moves) {
        switch_box("Pause time", memory.hold_time);
        layout.note("accuracy.hold time");
    }
    if (facts.accuracy && !facts.scene->ladders.empty() && controls.rungs.size() == facts.scene->ladders.size())
        requests.measure = ladder_part(facts, controls, memory, layout);
    found_rungs(facts, memory.found, requests, layout);
    ImGui::Unindent(indent);
    ImGui::Spacing();
}

void switch_split(AccuracyMemory& memory) {
    using Show = AccuracyMemory::Show;
    memory.show = memory.show == Show::picture ? Show::split : Show::picture;
}

namespace {

constexpr ImGuiWindowFlags state_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

// What must be known of the two states, `width` wide: a window of its own above the buttons, so that these stay where
// they are under the mouse. Returns where it begins.
float state_remarks(const Facts& facts, bool heat, ImVec2 below, float width, bool narrow, Layout& layout) {
    const std::string plain = no_heat(facts);
    const bool legends = heat && plain.empty() && !narrow, notes = heat && !plain.empty();
    if (!facts.states->fixed && !legends && !notes) return below.y;
    ImGui::SetNextWindowPos(below, 0, {0, 1});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, FLT_MAX});
    ImGui::SetNextWindowBgAlpha(narrow ? 1.0F : .85F);
    if (ImGui::Begin("##states above", nullptr, state_window)) {
        if (facts.states->fixed) {
            wrapped("Both sides are fixed: sliders change neither. Choose \"now\" for one of them.", true);
            layout.note("accuracy.fixed");
        }
        if (notes) note(plain, layout, "accuracy.no map");
        if (legends) {
            ImGui::TextDisabled("Difference of light, where white is 1");
            legend(facts.accuracy ? *facts.accuracy : AccuracyFacts(), ImGui::GetContentRegionAvail().x, layout);
            layout.note("accuracy.legend");
        }
    }
    const float top = ImGui::GetWindowPos().y;
    ImGui::End();
    return top;
}

}  // namespace

float state_bar(const Facts& facts, const Rect& picture, AccuracyMemory& memory, Layout& layout) {
    using Show = AccuracyMemory::Show;
    const Rect scene = with_room(picture);
    if (!facts.states) return scene.y + scene.height;
    const StateFacts& states = *facts.states;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x;
    const float other = std::max(button_width("Heat map"), button_width("Split"));
    const float middle = button_width("\u21C4") + other + 2 * gap, pad = .4F * ImGui::GetFontSize();
    // In the narrowest windows the buttons have a line of their own.
    const bool two_lines = scene.width < 20 * ImGui::GetFontSize();
    // Where the buttons are depends neither on the labels, which change while somebody uses them, nor on the divider.
    const float room = std::max(scene.width - (two_lines ? 0 : middle) - gap - 4 * pad, 2.0F) / 2;
    const float left = std::min(room, 18 * ImGui::GetFontSize());
    const float all = 2 * left + (two_lines ? 0 : middle) + gap + 2 * pad;
    const float x = std::clamp(scene.x + scene.width / 2 - left - pad - gap - button_width("\u21C4") / 2, scene.x + pad,
                               std::max(scene.x + pad, scene.x + scene.width - all - pad));
    ImGui::SetNextWindowPos({std::round(x), scene.y + scene.height - pad}, 0, {0, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, style.PopupRounding);
    ImGui::SetNextWindowBgAlpha(two_lines ? 1.0F : .85F);
    if (ImGui::Begin("##states", nullptr, state_window)) {
        state_button(states, 0, left, memory, layout);
        ImGui::SameLine();
        if (two_lines) state_button(states, 1, left, memory, layout);
        if (button("\u21C4", layout, "accuracy.swap")) {
            memory.left = states.sides[1].name;
            memory.right = states.sides[0].name;
        }
        tip("Swaps the two sides");
        ImGui::SameLine();
        if (or_keys(ImGui::Button(memory.show == Show::heat ? "Split###other" : "Heat map###other", {other, 0})))
            memory.show = memory.show == Show::heat ? Show::split : Show::heat;
        layout.note("accuracy.other");
        tip(memory.show == Show::heat
                ? "Shows both side by side"
                : "Shows where they differ: black is equal, brighter is more, white is as black against white");
        if (!two_lines) {
            ImGui::SameLine();
            state_button(states, 1, left, memory, layout);
        }
    }
    const ImVec2 corner = ImGui::GetWindowPos();
    ImGui::End();
    const float top = state_remarks(facts, memory.show == Show::heat, corner, all, two_lines, layout);
    ImGui::PopStyleVar(2);
    return top;
}

void blank_halves(const Facts& facts, const Rect& scene, const AccuracyMemory& memory) {
    if (!facts.states || memory.show != AccuracyMemory::Show::split) return;
    const float middle = scene.x + std::round(scene.width * memory.divider), end = scene.x + scene.width;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float em = ImGui::GetFontSize();
    for (std::size_t i = 0; i < facts.states->sides.size(); ++i) {
        const StateFacts::Side& side = facts.states->sides[i];
        if (!side.blank) continue;
        const float from = i == 1 ? middle : scene.x, to = i == 0 ? middle : end;
        list.AddRectFilled({from, scene.y}, {to, scene.y + scene.height}, pack(palette().panel));
        const std::string text = "No picture of this state\n" + side.label;
        const float room = std::max(to - from - 2 * em, 1.0F), wrap = std::min(room, 24 * em);
        const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
        if (room < 4 * em) continue;  // the name of the state has it all the same
        list.AddText(ImGui::GetFont(), em,
                     {std::round((from + to - size.x) / 2), std::round(scene.y + (scene.height - size.y) / 3)},
                     pack(palette().error_text), text.c_str(), nullptr, wrap);
    }
}

void accuracy_divider(const Rect& scene, AccuracyMemory& memory, Layout& layout) {
    const float grip = std::round(ImGui::GetFontSize() * .9F);
    const float x = scene.x + std::round(scene.width * memory.divider);
    ImGui::SetNextWindowPos({x - std::round(grip / 2), scene.y});
    ImGui::SetNextWindowSize({grip, scene.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    constexpr ImGuiWindowFlags bare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus;
    if (ImGui::Begin("##divider", nullptr, bare)) {
        ImGui::InvisibleButton("##drag", {grip, scene.height});
        layout.note("accuracy.divider");
        const bool held = ImGui::IsItemActive();
        if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        if (ImGui::IsItemActivated()) memory.grabbed = memory.divider;
        if (held && pressed(Key::escape)) {
            memory.divider = memory.grabbed;
            ImGui::ClearActiveID();
        } else if (held)
            memory.divider =
                std::clamp((ImGui::GetIO().MousePos.x - scene.x) / std::max(1.0F, scene.width), .02F, .98F);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float middle = scene.y + scene.height / 2, knob = ImGui::GetFontSize() * .32F;
        list.AddRectFilled({x - 2, scene.y}, {x + 1, scene.y + scene.height}, IM_COL32(0, 0, 0, 110));
        list.AddRectFilled({x - 1, scene.y}, {x, scene.y + scene.height}, IM_COL32_WHITE);
        list.AddRectFilled({x - .5F - knob, middle - 3 * knob}, {x - .5F + knob, middle + 3 * knob},
                           pack(held ? palette().accent_pressed : palette().accent), knob);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

// The plot of error over time as the window paints it.

namespace {

using Standing = AccuracyPoint::Standing;
using content::Ink, content::Mark, content::MarkKind;

std::string label_of(const AccuracyPoint& point) { return point.name + (point.reference ? " = reference" : ""); }

ImVec4 color_of(Ink ink) {
    const Palette& colors = palette();
    switch (ink) {
        case Ink::paper:
            return colors.panel;
        case Ink::grid:
        case Ink::band:
            return colors.track;
        case Ink::front:
            return colors.accent;
        case Ink::wrong:
            return colors.error_text;
        default:
            return colors.dim;
    }
}

void paint(ImDrawList& list, const Mark& mark) {
    const auto place = [](double x, double y) { return ImVec2(static_cast<float>(x), static_cast<float>(y)); };
    const ImVec2 from = place(mark.at.x0, mark.at.y0), to = place(mark.at.x1, mark.at.y1),
                 middle = place((mark.at.x0 + mark.at.x1) / 2, (mark.at.y0 + mark.at.y1) / 2);
    const auto stroke = static_cast<float>(mark.stroke), radius = static_cast<float>(mark.at.width() / 2);
    const ImU32 color = pack(color_of(mark.ink));
    if (mark.kind == MarkKind::line)
        list.AddLine(from, to, color, stroke);
    else if (mark.kind == MarkKind::text)
        list.AddText(ImGui::GetFont(), static_cast<float>(mark.size), from, color, mark.text.data(),
                     mark.text.data() + mark.text.size());
    else if (mark.kind == MarkKind::disc && mark.stroke > 0)
        list.AddCircle(middle, radius, color, 0, stroke);
    else if (mark.kind == MarkKind::disc)
        list.AddCircleFilled(middle, radius, color);
    else if (mark.kind == MarkKind::box && mark.stroke > 0)
        list.AddRect(from, to, color, 0, 0, stroke);
    else if (mark.kind == MarkKind::box)
        list.AddRectFilled(from, to, color);
}

content::PlotPoint plotted(const AccuracyPoint& point) {
    return {.name = label_of(point),
            .error = point.error,
            .milliseconds = point.milliseconds,
            .low = point.low,
            .high = point.high,
            .front = point.standing == Standing::front,
            .beaten = point.standing == Standing::dominated || point.standing == Standing::saves_none,
            .chosen = point.chosen,
            .label = point.rung || point.reference ? std::optional(0) : std::nullopt};
}

// What the marks of these points mean, in rows from that height on. Returns where those of all marks would end, so that
// what is below stays in place.
double key_of(const std::vector<content::PlotPoint>& points, const std::array<float, 3>& at, double top, double em,
              content::Page& page) {
    const double row = content::line_height * em;
    double x = at[0], y = top;
    bool all = false;
    const auto entry = [&](bool occurs, const char* words, auto&& draw_at) {
        if (!occurs && !all) return;
        const double mark = 1.4 * em, width = mark + page.width(words, em);
        if (x > at[0] && x + width > at[0] + at[2]) {
            x = at[0];
            y += row;
        }
        if (!all) {
            draw_at(x + .5 * em, y + row / 2);
            page.text(x + mark, y, words, em, content::Ink::text);
        }
        x += width + em;
    };
    const auto point = [&](const content::PlotPoint& one, const char* words, auto&& is) {
        entry(ranges::any_of(points, is), words,
              [&](double left, double middle) { draw_point(page, one, left, middle, em); });
    };
    using P = content::PlotPoint;
    for (const bool each : {false, true}) {
        all = each;
        x = at[0];
        y = top;
        point({.front = true}, "worth its time", [](const P& p) { return p.front; });
        point({.beaten = true}, "another is better", [](const P& p) { return p.beaten; });
        point({}, "not compared, or unsure", [](const P& p) { return !p.front && !p.beaten; });
        point({.chosen = true}, "is shown", [](const P& p) { return p.chosen; });
        const auto timed = ranges::find_if(points, [](const P& p) { return p.low > 0 && p.low < p.high; });
        entry(timed != points.end(), "range of its time",
              [&](double left, double middle) { draw_bar(page, *timed, left - .5 * em, left + .5 * em, middle, em); });
    }
    return y + row;
}

void draw(const std::vector<AccuracyPoint>& points, std::array<float, 3> at, float em, AccuracyPlot& drawn) {
    drawn = {.points = points, .at = at, .letters = em, .height = 0, .marks = {}, .shown = {}, .places = {}};
    content::Plot plot{.points = {}, .errors = "error (1 is white)", .times = "ms/sample", .decades = .5};
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].milliseconds > 0 && !std::isnan(points[i].error)) {  // an error that is unknown has no place
            drawn.shown.push_back(i);
            plot.points.push_back(plotted(points[i]));
        }
    content::Page page([](const std::string& text, double letters, bool) {
        return static_cast<double>(
            ImGui::GetFont()->CalcTextSizeA(static_cast<float>(letters), FLT_MAX, 0, text.c_str()).x);
    });
    drawn.places = draw_plot(page, plot, {at[0], at[1], at[0] + at[2] - .2F * em, at[1] + 12 * em}, em);
    drawn.height = static_cast<float>(key_of(plot.points, at, at[1] + 12.2 * em, em, page)) - at[1];
    drawn.marks = std::move(page.marks);
}

}  // namespace

void accuracy_plot(const std::vector<AccuracyPoint>& points, AccuracyPlot& plot, Layout& layout) {
    const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const std::array at{corner.x, corner.y, width};
    if (plot.marks.empty() || plot.at != at || plot.letters != em || plot.points != points) draw(points, at, em, plot);
    ImGui::InvisibleButton("##plot", {width, plot.height});
    layout.note("accuracy.plot");
    for (const Mark& mark : plot.marks) paint(*ImGui::GetWindowDrawList(), mark);
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto distance = [&](const std::pair<double, double>& place) {
        return std::hypot(place.first - mouse.x, place.second - mouse.y);
    };
    const auto nearest = ranges::min_element(plot.places, {}, distance);
    if (nearest == plot.places.end() || distance(*nearest) >= em) return;
    const AccuracyPoint& point = points[plot.shown[static_cast<std::size_t>(nearest - plot.places.begin())]];
    tip(Text("{}: {}, error {} of white{}{}", label_of(point), milliseconds_text(point.milliseconds),
             error_text(point.error), point.standing == Standing::visited ? "" : "\n", standing_text(point))
            .view());
}

}  // namespace snell::ui
