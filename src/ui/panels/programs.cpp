#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "src/plan/values/fit.h"
#include "src/ui/kit/numbers.h"
#include "src/ui/kit/style.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

struct Section {
    const Facts& facts;
    const Program& program;
    bool linked;
    Memory& memory;
    Layout& layout;
};

bool is_integral(ValueType type) {
    return type == ValueType::int_ || type == ValueType::uint_ || type == ValueType::sampler;
}

// Draws the name at the left, shortened if necessary, followed by `value`, and `remark` dimmed at the right if all fit.
void caption(std::string_view name, std::string_view value, std::string_view remark) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float right = width_of(remark), end = ImGui::GetCursorPosX() + width;
    Text whole = shortened(name, width - width_of(value));
    const Text text = shortened(whole.append(value).view(), width);
    const float left = width_of(text.view());
    ImGui::TextUnformatted(text.begin(), text.end());
    if (left + right + ImGui::GetStyle().ItemSpacing.x > width) {
        tip(Text("{}{}  {}", name, value, remark).view());
        return;
    }
    ImGui::SameLine();
    ImGui::SetCursorPosX(end - right);
    ImGui::TextDisabled("%.*s", static_cast<int>(remark.size()), remark.data());
}

// Formats the value as glman does: " = 1.1000".
Text value_of(const Control& control) {
    Text text;
    for (std::size_t i = 0; i < control.value.size(); ++i)
        text.append(i == 0 ? " = " : ", ")
            .append(shown(control.value[i], control.min, control.max, is_integral(control.type)));
    return text;
}

std::string key_of(const Control& control) { return fmt::format("{}.{}", control.program, control.name); }

bool is_logarithmic(const Control& control, const Section& section) {
    const std::set<std::string>& chosen = section.memory.logarithmic;
    return !chosen.empty() && control.min > 0 && chosen.contains(key_of(control));
}

// Draws the menu that a right click on a slider's name opens.
void slider_menu(Control& control, const Section& section) {
    if (!ImGui::BeginPopupContextItem("##menu")) return;
    const std::string initial = shown(control.initial[0], control.min, control.max, is_integral(control.type));
    if (ImGui::MenuItem(fmt::format("Reset to {}", initial).c_str())) control.value = control.initial;
    section.layout.note(control.name, "reset");
    bool logarithmic = is_logarithmic(control, section);
    if (ImGui::MenuItem("Logarithmic", nullptr, &logarithmic, control.min > 0)) {
        if (logarithmic)
            section.memory.logarithmic.insert(key_of(control));
        else
            section.memory.logarithmic.erase(key_of(control));
    }
    section.layout.note(control.name, "logarithmic");
    ImGui::EndPopup();
}

void note_element(const Control& control, std::size_t i, const Section& section) {
    if (control.value.size() == 1) return section.layout.note(section.program.name, control.name);
    section.layout.note(section.program.name, Text("{}[{}]", control.name, i).view());
}

void sliders(Control& control, const Section& section) {
    SliderRange range{control.min, control.max, is_integral(control.type), is_logarithmic(control, section)};
    for (std::size_t i = 0; i < control.value.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (slider("##value", control.value[i], range, control.initial[i], section.memory.slider))
            control.value[i] = fit_to_type(control.value[i], control.type);
        note_element(control, i, section);
        ImGui::PopID();
    }
    control.min = range.min;
    control.max = range.max;
}

// Draws a row of number fields for each element of an array or each column of a matrix.
void numbers(Control& control, const Section& section) {
    auto columns = static_cast<std::size_t>(control.type == ValueType::matrix && control.components > 4
                                                ? (control.components == 9 ? 3 : 4)
                                                : std::clamp(control.components, 1, 4));
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float number_width = button_width("-1.2346e+05"), most = ImGui::GetContentRegionAvail().x;
    while (columns > 1 && number_width * static_cast<float>(columns) + gap * static_cast<float>(columns - 1) > most)
        columns = (columns + 1) / 2;
    const float width =
        (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    for (std::size_t i = 0; i < control.value.size(); ++i) {
        if (i % columns != 0) ImGui::SameLine(0, gap);
        ImGui::PushID(static_cast<int>(i));
        if (number("##value", control.value[i], is_integral(control.type), control.initial[i], width))
            control.value[i] = fit_to_type(control.value[i], control.type);
        note_element(control, i, section);
        ImGui::PopID();
    }
}

void check_box(Control& control, const Section& section) {
    bool on = control.value[0] != 0;
    Text name = shortened(control.name, ImGui::GetContentRegionAvail().x - check_box_width(""));
    const bool whole = name == control.name;
    if (ImGui::Checkbox(name.append("###on").c_str(), &on)) control.value[0] = on ? 1 : 0;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) control.value[0] = control.initial[0];
    if (!whole) tip(control.name);
    section.layout.note(section.program.name, control.name);
}

// Returns why a uniform has no effect; empty if it has one.
std::string_view idle_reason(const Control& control, const Section& section) {
    if (control.active) return {};
    return section.linked ? "not used by the program" : "the program did not compile or link";
}

void explain(const Control& control, const Section& section) {
    if (control.active || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    if (section.linked)
        ImGui::SetTooltip("No shader of '%s' uses '%s', or its value\ndoes not affect the picture.",
                          section.program.name.c_str(), control.name.c_str());
    else
        ImGui::SetTooltip("'%s' did not compile or link.", section.program.name.c_str());
}

void row(Control& control, const Section& section) {
    if (control.value.empty() || control.initial.size() != control.value.size()) return;
    const std::string_view reason = idle_reason(control, section);
    ImGui::PushID(control.name.c_str());
    ImGui::BeginDisabled(!control.active);
    ImGui::BeginGroup();
    switch (control.widget) {
        case Widget::check_box:
            check_box(control, section);
            if (!reason.empty()) {
                follow(ImGui::CalcTextSize(reason.data(), reason.data() + reason.size()).x);
                ImGui::TextUnformatted(reason.data(), reason.data() + reason.size());
            }
            break;
        case Widget::color:
            caption(control.name, "", reason);
            color_row("##value", control.value.data(), control.components, control.initial.data());
            section.layout.note(section.program.name, control.name);
            break;
        case Widget::slider:
            ImGui::BeginGroup();
            caption(control.name, value_of(control).view(),
                    reason.empty() ? Text("{:g} \u2026 {:g}{}", control.min, control.max,
                                          is_logarithmic(control, section) ? " log" : "")
                                         .view()
                                   : reason);
            ImGui::EndGroup();
            section.layout.note(control.name, "name");
            slider_menu(control, section);
            sliders(control, section);
            break;
        case Widget::none:
            caption(control.name, "", reason);
            numbers(control, section);
            break;
    }
    ImGui::EndGroup();
    ImGui::EndDisabled();
    explain(control, section);
    ImGui::PopID();
}

// Large arrays and texture units are not shown in the panel.
bool is_shown(const Control& control) { return control.type != ValueType::sampler && control.value.size() <= 64; }

bool sliding(const Control& control) { return control.listed && control.widget != Widget::none; }

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

void section_of(Controls& controls, Index index, const Section& section, bool open_at_first) {
    const auto constant = [](const Control& c) { return c.listed && c.widget == Widget::none; };
    const auto unlisted = [](const Control& c) { return !c.listed; };
    show_opened();
    ImGui::PushID(static_cast<int>(index));
    ImGui::SetNextItemOpen(open_at_first, ImGuiCond_Once);
    const std::string& name = section.program.name;
    Text title =
        shortened(name.empty() ? "Program" : name, ImGui::GetContentRegionAvail().x - 2 * ImGui::GetFrameHeight());
    const bool whole = name.empty() || title == name;
    const bool open = ImGui::CollapsingHeader(title.append("###program").c_str());
    if (!whole) tip(name);
    section.layout.note(name);
    keep_in_view(open);
    if (open) {
        ImGui::Indent(ImGui::GetStyle().FramePadding.x * .5F);
        if (!section.linked) ImGui::TextColored(palette().error_text, "did not compile or link");
        rows(controls, index, section, sliding);
        if (!any(controls, index, sliding) && section.linked) ImGui::TextDisabled("no sliders");
        if (any(controls, index, constant)) {
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
        const auto moved = [](const Control& c) { return c.value != c.initial; };
        if (any(controls, index, moved)) {
            if (ImGui::SmallButton("Reset all"))
                for (Control& control : controls.items)
                    if (control.program == index) control.value = control.initial;
            section.layout.note(section.program.name, "reset");
        }
        ImGui::Unindent(ImGui::GetStyle().FramePadding.x * .5F);
    }
    ImGui::PopID();
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
    const bool open = ImGui::BeginCombo("##rung", chosen.c_str());
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
