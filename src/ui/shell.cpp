#include "src/ui/shell.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "src/ui/help.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/numbers.h"
#include "src/ui/labels.h"
#include "src/ui/panels/frame_cost.h"
#include "src/ui/panels/panels.h"
#include "src/ui/panels/picture_out.h"
#include "src/ui/panels/pixels.h"
#include "src/ui/panels/textures.h"
#include "src/ui/scene_mouse.h"

namespace snell::ui {

namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                   ImGuiWindowFlags_NoNav;

struct Areas {
    Rect scene, panel, status;
};

// Areas in whole pixels, so that the picture is copied and not resampled.
Areas areas(Memory& memory) {
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const float half = all.x * .5F;
    const float width =
        memory.panel ? std::round(std::clamp(memory.panel_width * em, std::min(12 * em, half), std::max(12 * em, half)))
                     : 0;
    const float line = std::round(ImGui::GetFrameHeight());
    Areas result;
    result.scene = {0, 0, std::max(1.0F, all.x - width), std::max(1.0F, all.y - line)};
    result.status = {0, all.y - line, std::max(1.0F, all.x - width), line};
    result.panel = {all.x - width, 0, width, all.y};
    return result;
}

void place(const Rect& rect) {
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
}

void tools(View& view, Memory& memory, Requests& requests, Layout& layout) {
    if (button("Open\u2026", layout, "open")) open_browser({}, memory, requests);
    requests.reload |= next_button("Reload", layout, "reload");
    if (next_button("Reset view", layout, "reset view")) reset_view(view);
    ImGui::Checkbox("Axes", &view.axes);
    layout.note("axes");
    follow(check_box_width("Values"), ImGui::GetFontSize());
    ImGui::Checkbox("Values", &memory.labels);
    tip("Shows name = value over the picture");
    layout.note("labels");
}

// Draws a strip over the panel's left edge; dragging it changes the panel's width.
void splitter(const Rect& panel, Memory& memory) {
    const float grip = ImGui::GetFontSize() * .35F;
    ImGui::SetCursorScreenPos({panel.x, panel.y});
    ImGui::InvisibleButton("##width", {grip, panel.height});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        ImGui::GetWindowDrawList()->AddRectFilled({panel.x, panel.y}, {panel.x + grip * .5F, panel.y + panel.height},
                                                  ImGui::GetColorU32(palette().filled));
    }
    if (ImGui::IsItemActive()) memory.panel_width = (panel.width - ImGui::GetIO().MouseDelta.x) / ImGui::GetFontSize();
}

void panel_window(const Facts& facts, const Rect& panel, Controls& controls, View& view, Memory& memory, Layout& layout,
                  Requests& requests) {
    place(panel);
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    if (ImGui::Begin("##panel", nullptr, fixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        // In a low window, the parts of the panel that are otherwise fixed scroll too.
        const bool low = panel.height < 40 * ImGui::GetFontSize();
        if (low) ImGui::BeginChild("##programs", {0, 0});
        tools(view, memory, requests, layout);
        keep_panel(facts, requests, layout);
        clock_panel(facts, memory, layout);
        ImGui::Separator();
        if (!low) ImGui::BeginChild("##programs", {0, 0});
        if (facts.scene) {
            ladders_panel(facts, controls, layout);
            requests.measure = accuracy_section(facts, controls, memory.accuracy, layout);
            programs_panel(facts, controls, memory, layout);
            view_section(facts, view, memory, layout);
            pixels_section(memory.open, memory.pixels, layout);
            textures_section(facts, memory, layout);
            requests.measure_frame = frame_cost_section(facts, memory, layout);
            costs_section(facts, memory, layout);
        } else {
            ImGui::TextDisabled("no scene");
        }
        files_section(facts, memory, requests, layout);
        look_section(memory, layout);
        ImGui::EndChild();
        splitter(panel, memory);
        ImGui::GetWindowDrawList()->AddLine({panel.x, panel.y}, {panel.x, panel.y + panel.height},
                                            ImGui::GetColorU32(palette().rule), std::max(1.0F, padding.x / 14));
    }
    ImGui::End();
}

bool has_ladders(const Facts& facts) { return facts.scene && !facts.scene->ladders.empty(); }

void problem_chip(const Facts& facts, Memory& memory, Layout& layout) {
    const auto errors = std::count_if(facts.problems.begin(), facts.problems.end(),
                                      [](const Problem& p) { return p.finding.severity == Severity::error; });
    const auto warnings = static_cast<std::ptrdiff_t>(facts.problems.size()) - errors;
    if (errors + warnings == 0) return;
    const auto count = errors > 0 ? errors : warnings;
    const std::string text = counted(static_cast<std::size_t>(count), errors > 0 ? "error" : "warning");
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, errors > 0 ? palette().error_text : palette().warning_text);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
    if (ImGui::Button(text.c_str())) {
        if (errors > 0)
            memory.problems_hidden = !memory.problems_hidden;
        else
            memory.warnings_open = !memory.warnings_open;
    }
    layout.note("problems");
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

// Shows the first line of the last request's outcome; the tooltip has all of it.
void notice(const Memory& memory, float left, float right, Layout& layout) {
    if (right <= left) return;
    ImGui::SameLine(left);
    const std::string_view line = std::string_view(memory.notice).substr(0, memory.notice.find('\n'));
    fitted(line, right - left);
    tip(memory.notice);
    layout.note("notice");
}

void status_window(const Facts& facts, const Rect& status, Memory& memory, Layout& layout) {
    place(status);
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {style.WindowPadding.x, (status.height - ImGui::GetFontSize()) * .5F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    if (ImGui::Begin("##status", nullptr, fixed | ImGuiWindowFlags_NoScrollbar)) {
        fitted(facts.file, status.width * .5F);
        problem_chip(facts, memory, layout);
        ImGui::SameLine();
        const float left = ImGui::GetCursorPosX();
        Text cost;
        if (facts.animated) cost.add("t = {:.2f} s   ", facts.time);
        if (!facts.grain.empty()) cost.add("{}   ", facts.grain);
        cost.add("{:.1f} ms", facts.frame_ms);
        const Text help("{}{}drag: turn   wheel: scale   right drag: move   R: reset   F1: keys{}", facts.object,
                        facts.object.empty() ? "" : "   ", has_ladders(facts) ? "   A: accuracy" : "");
        const float right = ImGui::GetWindowContentRegionMax().x;
        const float cost_width = ImGui::CalcTextSize("t = 1000.00 s   100.0 ms").x;
        const float help_width = ImGui::CalcTextSize(help.c_str()).x;
        if (!memory.notice.empty()) {
            notice(memory, left + ImGui::GetFontSize(), right - cost_width, layout);
        } else if (left + help_width + cost_width + ImGui::GetFontSize() < right) {
            ImGui::SameLine(left + ImGui::GetFontSize());
            ImGui::TextDisabled("%s", help.c_str());
        }
        if (left + cost_width < right) {
            ImGui::SameLine(right - ImGui::CalcTextSize(cost.c_str()).x);
            ImGui::TextDisabled("%s", cost.c_str());
            tip(Text("time to draw the last picture\n{} samples per pixel\n{}", facts.samples, facts.renderer).view());
        }
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace

Requests shell(const Facts& facts, Controls& controls, View& view, Memory& memory, const Fonts& fonts, Layout& layout) {
    layout.clear();
    Requests requests;
    if (!ImGui::GetIO().WantTextInput && !memory.browser.open && !memory.picture.open) {
        if (pressed(Key::h)) memory.panel = !memory.panel;
        requests.reload = pressed(Key::f5);
        keep_keys(facts, requests);
        clock_keys(facts, memory);
        files_keys(memory, requests);
        if (pressed(Key::f1)) memory.keys = !memory.keys;
        if (memory.keys && pressed(Key::escape))
            memory.keys = false;
        else if (facts.scene)
            view_keys(view, memory.hold);
        if (has_ladders(facts) && pressed(Key::a)) memory.accuracy.open = !memory.accuracy.open;
    }
    const Areas parts = areas(memory);
    if (memory.panel) panel_window(facts, parts.panel, controls, view, memory, layout, requests);
    status_window(facts, parts.status, memory, layout);
    problems_panel(facts, parts.scene, fonts, memory, requests, layout);
    notices(facts, parts.scene, memory, layout);
    if (facts.accuracy && facts.accuracy->note.empty() && memory.accuracy.show == AccuracyMemory::Show::split)
        accuracy_divider(facts, controls, parts.scene, memory.accuracy, layout);
    if (memory.labels) value_labels(facts, controls, parts.scene, fonts);
    pixel_keys(parts.scene, memory.pixels);
    flags_legend(facts, parts.scene, memory.pixels, layout);
    inspector(facts, parts.scene, memory.pixels, fonts, layout);
    texel_inspector(facts, memory.textures, fonts, layout);
    browser_window(facts, memory, requests, layout);
    picture_window(facts, memory, requests, layout);
    if (memory.keys && help_panel(parts.scene, layout)) memory.keys = false;
    hold_scene(facts, parts.scene, view, memory.hold, requests);
    memory.scene = parts.scene;
    return requests;
}

}  // namespace snell::ui
