#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/style.h"
#include "src/ui/panels/panels.h"
#include "src/ui/panels/rows.h"

namespace snell::ui {

namespace {

// Large arrays and texture units are not shown in the panel.
bool is_shown(const Control& control) { return control.type != ValueType::sampler && control.value.size() <= 64; }

bool sliding(const Control& control) { return control.listed && control.widget != Widget::none; }

bool passes(const Control& control, const Memory& memory) { return contains(control.name, memory.filter.data()); }

template <typename Chosen>
void rows(Controls& controls, Index program, const Section& section, Chosen chosen) {
    for (Control& control : controls.items)
        if (control.program == program && is_shown(control) && chosen(control)) row(control, section);
}

template <typename Chosen>
bool any(const Controls& controls, Index program, Chosen chosen) {
    return std::any_of(controls.items.begin(), controls.items.end(), [&](const Control& control) {
        return control.program == program && is_shown(control) && chosen(control);
    });
}

// Draws "Reset all" at the right end of the header, where it moves nothing.
void reset_button(Controls& controls, Index program, const Section& section, float right) {
    ImGui::SameLine(right);
    if (ImGui::SmallButton("Reset all")) {
        for (Control& control : controls.items)
            if (control.program == program) reset(control);
        stop_all(section.memory.animated, program);
    }
    section.layout.note(section.program.name, "reset");
}

// Draws the title; returns whether the section is open. While a filter is set, sections are open for themselves.
bool header(Controls& controls, Index index, const Section& section, bool open_at_first) {
    const bool filtered = section.memory.filter[0] != '\0';
    ImGui::SetNextItemOpen(open_at_first || filtered, ImGuiCond_Once);
    const std::string& name = section.program.name;
    const float button = button_width("Reset all");
    const float right = ImGui::GetContentRegionMax().x - button - ImGui::GetStyle().FramePadding.x * .5F;
    Text title = shortened(name.empty() ? std::string_view("Program") : name,
                           ImGui::GetContentRegionAvail().x - 2 * ImGui::GetFrameHeight() - button);
    const bool whole = name.empty() || title == name;
    const bool open = ImGui::CollapsingHeader(title.append(filtered ? "###found" : "###program").c_str(),
                                              ImGuiTreeNodeFlags_AllowItemOverlap);
    if (!whole) tip(name);
    section.layout.note(name);
    keep_in_view(open);
    const auto moved = [](const Control& c) { return c.value != c.initial; };
    const auto moving = [&](const Animated& motion) { return motion.program == index; };
    if (any(controls, index, moved) || ranges::any_of(section.memory.animated, moving))
        reset_button(controls, index, section, right);
    return open;
}

void section_of(Controls& controls, Index index, Section section, bool open_at_first) {
    const auto kept = [&](const Control& c) { return passes(c, section.memory); };
    const auto main = [&](const Control& c) { return sliding(c) && kept(c); };
    const auto constant = [&](const Control& c) { return c.listed && c.widget == Widget::none && kept(c); };
    const auto unlisted = [&](const Control& c) { return !c.listed && kept(c); };
    const bool filtered = section.memory.filter[0] != '\0';
    if (filtered && !any(controls, index, kept)) return;
    show_opened();
    ImGui::PushID(static_cast<int>(index));
    if (header(controls, index, section, open_at_first)) {
        const ImGuiStyle& style = ImGui::GetStyle();
        const float indent = style.FramePadding.x * .5F;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {style.ItemSpacing.x, std::round(style.ItemSpacing.y * .8F)});
        ImGui::Indent(indent);
        measure_columns(controls, index, section);
        if (!section.linked) ImGui::TextColored(palette().error_text, "did not compile or link");
        rows(controls, index, section, main);
        if (!filtered && !any(controls, index, sliding) && section.linked) ImGui::TextDisabled("no sliders");
        if (any(controls, index, constant)) {
            if (filtered) ImGui::SetNextItemOpen(true);
            const bool unfolded = ImGui::TreeNodeEx("constants", ImGuiTreeNodeFlags_SpanAvailWidth);
            section.layout.note(section.program.name, "constants");
            if (unfolded) {
                rows(controls, index, section, constant);
                ImGui::TreePop();
            }
        }
        if (any(controls, index, unlisted)) {
            ImGui::Separator();
            ImGui::TextDisabled("not on the Program line");
            rows(controls, index, section, unlisted);
        }
        ImGui::Unindent(indent);
        ImGui::PopStyleVar();
    }
    ImGui::PopID();
}

// Draws the filter above many sliders. Escape clears it.
void filter_row(const Controls& controls, Memory& memory, Layout& layout) {
    constexpr int few = 12;
    const auto slides = [](const Control& c) { return is_shown(c) && c.widget == Widget::slider; };
    if (ranges::count_if(controls.items, slides) <= few) {
        memory.filter = {};
        return;
    }
    const bool filtered = memory.filter[0] != '\0';
    const float clear = filtered ? button_width("\u00d7") + ImGui::GetStyle().ItemInnerSpacing.x : 0;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - clear);
    ImGui::InputTextWithHint("##filter", "Filter by name", memory.filter.data(), memory.filter.size());
    if (ImGui::IsItemDeactivated() && pressed(Key::escape)) memory.filter = {};
    layout.note("filter");
    if (!filtered) return;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (button("\u00d7", layout, "filter.clear")) memory.filter = {};
    if (ranges::none_of(controls.items, [&](const Control& c) { return is_shown(c) && passes(c, memory); }))
        ImGui::TextDisabled("No name contains this text.");
}

// Draws a drop-down; a right click resets it to the scene's rung.
void ladder_row(const Ladder& ladder, std::size_t& rung, Layout& layout) {
    if (rung >= ladder.rungs.size()) return;
    ImGui::PushID(ladder.name.c_str());
    ImGui::AlignTextToFramePadding();
    const float width = ImGui::GetContentRegionAvail().x, arrow = ImGui::GetFrameHeight() + button_width("");
    fitted(ladder.name, width * .6F);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    const Text chosen = shortened(ladder.rungs[rung], ImGui::GetContentRegionAvail().x - arrow);
    const bool open = begin_combo("##rung", chosen.c_str());
    if (!open && ImGui::IsItemClicked(ImGuiMouseButton_Right)) rung = ladder.current;
    layout.note(ladder.name);
    if (open) {
        for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
            if (ImGui::Selectable(ladder.rungs[i].c_str(), i == rung)) rung = i;
            layout.note(ladder.name, ladder.rungs[i]);
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
}

}  // namespace

void ladders_panel(const Facts& facts, Controls& controls, Layout& layout) {
    const std::vector<Ladder>& ladders = facts.scene->ladders;
    for (std::size_t i = 0; i < ladders.size() && i < controls.rungs.size(); ++i)
        ladder_row(ladders[i], controls.rungs[i], layout);
}

void programs_panel(const Facts& facts, Controls& controls, Memory& memory, Layout& layout) {
    const std::vector<Program>& programs = facts.scene->programs;
    filter_row(controls, memory, layout);
    bool slides = false;  // a slider was drawn in an earlier section
    for (Index i = 0; i < programs.size(); ++i) {
        // Opens the first section, and if it has no sliders, also the first that has.
        const bool first_sliding = !slides && any(controls, i, sliding);
        slides |= first_sliding;
        const bool linked = i < facts.linked.size() && facts.linked[i];
        section_of(controls, i, {facts, programs[i], linked, memory, layout}, i == 0 || first_sliding);
    }
    if (programs.empty()) ImGui::TextDisabled("The scene has no Program statement.");
}

}  // namespace snell::ui
