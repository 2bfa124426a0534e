// The sections of the programs: a row for each uniform, with its name and what changes its value.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/plan/values/declared.h"
#include "src/plan/values/numbers.h"
#include "src/ui/kit/field.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

// What all rows of one program have in common.
struct Section {
    const Facts& facts;
    const Program& program;
    bool linked;
    Memory& memory;
    Layout& layout;
    float name_width = 0, number_width = 0;  // of the sliders' columns
};

constexpr double default_period = 4;  // seconds

std::pair<Index, std::string> key_of(const Control& control) { return {control.program, control.name}; }

bool is_logarithmic(const Control& control, const Section& section) {
    const auto& chosen = section.memory.logarithmic;
    return !chosen.empty() && control.min > 0 && chosen.contains(key_of(control));
}

// "uOffset.x" for a component of a vector.
Text name_of(const Control& control, std::size_t component) {
    Text name(control.name);
    if (control.value.size() == 1) return name;
    if (control.value.size() <= 4)
        return std::move(name.append(".").append(std::string_view("xyzw").substr(component, 1)));
    return std::move(name.add("[{}]", component));
}

Text shown_value(const Control& control, double value) {
    return Text(shown(value, control.min, control.max, is_whole(control.type)));
}

void note_element(const Control& control, std::size_t i, const Section& section) {
    if (control.value.size() == 1) return section.layout.note(section.program.name, control.name);
    section.layout.note(section.program.name, Text("{}[{}]", control.name, i).view());
}

// Returns why a uniform has no effect; empty if it has one.
std::string_view idle_reason(const Control& control, const Section& section) {
    if (control.active) return {};
    return section.linked ? "not used" : "the program did not compile or link";
}

Animated* motion_of(const Control& control, std::size_t component, Memory& memory) {
    const auto found =
        ranges::find_if(memory.animated, [&](const Animated& motion) { return motion.moves(control, component); });
    return found == memory.animated.end() ? nullptr : &*found;
}

float dot_width() { return std::round(ImGui::GetFontSize() * .8F); }

// Draws the column at the left of a row, and the next item follows at its right: a dot if the value is not the scene's,
// a square while the slider moves by itself. Returns true if it was clicked.
bool dot(bool changed, bool moving, const Text& initial) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), size(dot_width(), ImGui::GetFrameHeight());
    bool clicked = false;
    if (changed || moving) {
        clicked = ImGui::InvisibleButton("##dot", size);
        tip(moving ? Text("Click to stop").view() : Text("Click to reset to {}", initial.view()).view());
        const ImVec2 middle(std::round(at.x + size.x * .4F), at.y + size.y / 2);
        const float reach = std::round(ImGui::GetFontSize() * .25F);
        const ImU32 color = ImGui::GetColorU32(ImGui::IsItemHovered() ? palette().accent_pressed : palette().accent);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (moving)
            list.AddRectFilled({middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach}, color);
        else
            list.AddCircleFilled(middle, reach, color);
    } else {
        ImGui::Dummy(size);
    }
    ImGui::SameLine(0, 0);
    return clicked;
}

// The dot of all components.
void dot_of(Control& control, const Section& section) {
    const bool changed = control.value != control.initial;
    if (dot(changed, false, Text("the scene's value"))) reset(control);
    if (changed) section.layout.note(control.name, "dot");
}

void animate_rows(Control& control, std::size_t component, const Section& section) {
    Memory& memory = section.memory;
    Animated* motion = motion_of(control, component, memory);
    bool moving = motion != nullptr;
    if (switch_box("Animate", moving)) {
        stop(memory.animated, control, component);
        motion = nullptr;
        if (moving) {
            memory.animated.push_back(
                animated_from(control, component, default_period, memory.clock.time, is_logarithmic(control, section)));
            memory.clock.paused = false;
        }
    }
    section.layout.note(control.name, "animate");
    if (!motion) return;
    label("there and back in");
    double period = motion->period;
    if (number("##period", period, ValueType::float_, default_period, 4 * ImGui::GetFontSize(),
               {shortest_period, longest_period}))
        set_period(*motion, period, memory.clock.time);
    section.layout.note(control.name, "period");
    ImGui::SameLine();
    ImGui::TextUnformatted("s");
}

// Begins the menu that a right click within `clicks` opens, or a key while the widget has the focus, then below
// `place`. If it returns true, its entries and EndPopup() must follow.
bool begin_value_menu(const ImRect& place, ImGuiID widget, const ImRect& clicks) {
    const bool clicked = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right) &&
                         clicks.Contains(ImGui::GetIO().MousePos);
    const bool keys = kit().focus.at == widget && !ImGui::GetIO().WantTextInput &&
                      (pressed(Key::menu) || (pressed(Key::f10) && ImGui::GetIO().KeyShift));
    if (clicked || keys) ImGui::OpenPopup("##menu");
    if (keys) ImGui::SetNextWindowPos({place.Min.x, place.Max.y});
    const bool open = ImGui::BeginPopup("##menu");
    note_opener({place.Min.x, place.Min.y, 0, 0}, open);
    return open;
}

void reset_item(Control& control, std::size_t component, const Section& section) {
    const bool box = control.widget == Widget::check_box || control.type == ValueType::bool_;
    const double value = control.initial[component];
    const Text initial = box ? Text(value != 0 ? "on" : "off") : shown_value(control, value);
    if (menu_item(fmt::format("Reset to {}", initial.view()).c_str())) {
        reset(control, component);
        stop(section.memory.animated, control, component);
    }
    section.layout.note(control.name, "reset");
}

void reset_all_item(Control& control, const Section& section) {
    if (menu_item("Reset to the scene's value")) reset(control);
    section.layout.note(control.name, "reset all");
}

// Draws the menu of a number, a check box or a colour's component.
void value_menu(Control& control, std::size_t component, const Section& section, const ImRect& place, ImGuiID widget) {
    if (!begin_value_menu(place, widget, {})) return;
    reset_item(control, component, section);
    if (control.value.size() > 1) reset_all_item(control, section);
    ImGui::EndPopup();
}

// Draws the menu of all components, which a right click on the name above them opens.
void caption_menu(Control& control, const Section& section, const ImVec2& corner) {
    const ImRect line(corner, {corner.x + ImGui::GetContentRegionAvail().x, corner.y + ImGui::GetFrameHeight()});
    if (!begin_value_menu(line, 0, line)) return;
    reset_all_item(control, section);
    ImGui::EndPopup();
}

// Draws the menu that a right click left of a slider's track opens: on its name, its dot or beside them.
void slider_menu(Control& control, std::size_t component, const Section& section, const ImRect& left) {
    if (!begin_value_menu(left, ImGui::GetID("##value"), left)) return;
    reset_item(control, component, section);
    bool logarithmic = is_logarithmic(control, section);
    if (menu_item("Logarithmic", nullptr, logarithmic, control.min > 0)) {
        logarithmic = !logarithmic;
        if (logarithmic)
            section.memory.logarithmic.insert(key_of(control));
        else
            section.memory.logarithmic.erase(key_of(control));
        for (Animated& motion : section.memory.animated)
            if (motion.program == control.program && motion.name == control.name)
                set_logarithmic(motion, control, logarithmic, section.memory.clock.time);
    }
    if (!(control.min > 0)) tip("Only a range above 0 can be logarithmic");
    section.layout.note(control.name, "logarithmic");
    ImGui::Separator();
    animate_rows(control, component, section);
    ImGui::EndPopup();
}

void range_tip(const Control& control, std::size_t component, const Section& section, const char* more) {
    if (!control.active) return;
    tip(Text("{}: {:g} \u2026 {:g}{}\nscene's value: {}\n{}", name_of(control, component).view(), control.min,
             control.max, is_logarithmic(control, section) ? ", logarithmic" : "",
             shown_value(control, control.initial[component]).view(), more)
            .view());
}

// The slider that was pressed last goes on where it would be without the press.
void move_again(Memory& memory) {
    if (memory.slider.stopped) memory.animated.push_back(*std::exchange(memory.slider.stopped, {}));
}

void stop_by_hand(const Control& control, std::size_t component, Memory& memory) {
    const Animated* const motion = motion_of(control, component, memory);
    if (!motion) return;
    memory.slider.stopped = *motion;
    stop(memory.animated, control, component);
}

void track(Control& control, std::size_t component, const Section& section) {
    SliderRange range{{control.min, control.max, control.type, is_logarithmic(control, section)}};
    const bool changed = slider("##value", control.value[component], range, control.initial[component],
                                section.memory.slider, section.number_width);
    note_element(control, component, section);
    range_tip(control, component, section, "double click: type a number; right click: reset");
    control.min = range.min;
    control.max = range.max;
    if (range.taken_back)
        move_again(section.memory);
    else if (changed || range.reset)
        stop_by_hand(control, component, section.memory);
    if (changed) control.value[component] = fit_to_type(control.value[component], control.type);
    if (range.reset) reset(control, component);
}

void slider_row(Control& control, std::size_t component, const Section& section) {
    const float begin = ImGui::GetCursorPosX();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool moving = motion_of(control, component, section.memory) != nullptr;
    const bool changed = control.value[component] != control.initial[component];
    if (dot(changed, moving, shown_value(control, control.initial[component]))) {
        if (!moving) reset(control, component);
        stop(section.memory.animated, control, component);
    }
    if (changed || moving) section.layout.note(control.name, "dot");
    const bool stacked = section.name_width <= 0;
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    fitted(name_of(control, component).view(),
           stacked ? ImGui::GetContentRegionAvail().x : section.name_width - ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::EndGroup();
    range_tip(control, component, section, "right click: reset, animate, logarithmic");
    section.layout.note(control.name, "name");
    const float end =
        stacked ? ImGui::GetContentRegionAvail().x + corner.x : corner.x + dot_width() + section.name_width;
    slider_menu(control, component, section, {corner, {end, corner.y + ImGui::GetFrameHeight()}});
    if (stacked)
        ImGui::SetCursorPosX(begin + dot_width());
    else
        ImGui::SameLine(begin + dot_width() + section.name_width);
    if (control.active || !section.linked) return track(control, component, section);
    fitted(idle_reason(control, section), ImGui::GetContentRegionAvail().x);
    note_element(control, component, section);
}

// Draws the name at the left, shortened if necessary, and `remark` at the right if both fit.
void caption(std::string_view name, std::string_view remark) {
    const float width = ImGui::GetContentRegionAvail().x, end = ImGui::GetCursorPosX() + width;
    const Text text = shortened(name, width);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.begin(), text.end());
    const float right = width_of(remark);
    if (!(text == name) || width_of(name) + right + ImGui::GetStyle().ItemSpacing.x > width)
        return tip(Text("{}  {}", name, remark).view());
    if (remark.empty()) return;
    ImGui::SameLine();
    ImGui::SetCursorPosX(end - right);
    ImGui::TextUnformatted(remark.data(), remark.data() + remark.size());
}

// Draws the line above the components of a value.
void named(Control& control, const Section& section) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    dot_of(control, section);
    caption(control.name, idle_reason(control, section));
    section.layout.note(control.name, "name");
    caption_menu(control, section, corner);
}

// Draws a check box, which Enter switches, too. Returns its place.
ImRect value_box(const char* text, double& value) {
    bool on = value != 0;
    const bool clicked = ImGui::Checkbox(text, &on);
    const ImRect box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    const ImGuiID id = ImGui::GetItemID();
    if (clicked) take_focus(id);
    const bool switched = focusable(box, id) && pressed(Key::enter) && !ImGui::GetIO().WantTextInput;
    draw_focus(box, id);
    if (clicked || switched) value = on != switched ? 1 : 0;
    return box;
}

// The rows of a matrix; 0 if it is none, or not a square, of which the number of components does not tell the rows.
std::size_t square(const Control& control) {
    if (control.type != ValueType::matrix) return 0;
    return control.components == 4 ? 2 : control.components == 9 ? 3 : control.components == 16 ? 4 : 0;
}

// Draws a line for each element of an array and each row of a matrix.
void components(Control& control, const Section& section) {
    const std::size_t rows = square(control);
    std::size_t columns = rows > 0 ? rows : static_cast<std::size_t>(std::clamp(control.components, 1, 4));
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, room = ImGui::GetContentRegionAvail().x;
    const auto width = [&] { return (room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns); };
    while (columns > 1 && width() < button_width("-1.23")) columns = (columns + 1) / 2;
    for (std::size_t at = 0; at < control.value.size(); ++at) {
        // GLSL has the columns of a matrix one after the other.
        const std::size_t i = rows == 0 ? at : at / (rows * rows) * rows * rows + at % rows * rows + at / rows % rows;
        if (at % columns != 0) ImGui::SameLine(0, gap);
        ImGui::PushID(static_cast<int>(i));
        if (control.type == ValueType::bool_)
            value_box("##value", control.value[i]);
        else if (number("##value", control.value[i], control.type, control.initial[i], width()))
            control.value[i] = fit_to_type(control.value[i], control.type);
        note_element(control, i, section);
        value_menu(control, i, section, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}, ImGui::GetID("##value"));
        ImGui::PopID();
    }
}

// Draws the menus of a colour's components.
void color_menus(Control& control, const Section& section) {
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const float step = (to.x - from.x) / static_cast<float>(control.value.size() + 1);  // the last one is the picker's
    ImGui::PushID("##value");
    for (std::size_t i = 0; i < control.value.size(); ++i) {
        const ImVec2 corner(from.x + step * static_cast<float>(i), from.y);
        ImGui::PushID(static_cast<int>(i));
        value_menu(control, i, section, {corner, {corner.x + step, to.y}}, ImGui::GetID("##component"));
        ImGui::PopID();
    }
    ImGui::PopID();
}

void check_box(Control& control, const Section& section) {
    dot_of(control, section);
    Text name = shortened(control.name, ImGui::GetContentRegionAvail().x - check_box_width(""));
    const bool whole = name == control.name;
    const ImRect box = value_box(name.append("###on").c_str(), control.value[0]);
    const ImGuiID id = ImGui::GetItemID();
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) reset(control);
    if (!whole) tip(control.name);
    section.layout.note(section.program.name, control.name);
    value_menu(control, 0, section, box, id);
    const std::string_view reason = idle_reason(control, section);
    if (reason.empty()) return;
    follow(width_of(reason));
    ImGui::TextUnformatted(reason.data(), reason.data() + reason.size());
}

void explain(const Control& control, const Section& section) {
    if (control.active) return;
    if (section.linked)
        tip(Text("No shader of '{}' uses '{}', or its value\ndoes not affect the picture.", section.program.name,
                 control.name)
                .view());
    else
        tip(Text("'{}' did not compile or link.", section.program.name).view());
}

void widget(Control& control, const Section& section) {
    switch (control.widget) {
        case Widget::check_box:
            return check_box(control, section);
        case Widget::color:
            named(control, section);
            color_row("##value", control.value.data(), control.components, control.initial.data());
            section.layout.note(section.program.name, control.name);
            return color_menus(control, section);
        case Widget::slider:
            for (std::size_t i = 0; i < control.value.size(); ++i) {
                ImGui::PushID(static_cast<int>(i));
                slider_row(control, i, section);
                ImGui::PopID();
            }
            return;
        case Widget::none:
            named(control, section);
            return components(control, section);
    }
}

// True if two sliders of the program would have the same text in a column of that width.
bool ambiguous(const Controls& controls, Index program, float width) {
    std::array<std::size_t, 256> cut{};
    std::size_t count = 0;
    for (const Control& control : controls.items) {
        if (control.program != program || control.widget != Widget::slider || count == cut.size()) continue;
        if (width_of(control.name) > width)
            cut[count++] = std::hash<std::string_view>{}(shortened(control.name, width).view());
    }
    std::sort(cut.begin(), cut.begin() + count);
    return std::adjacent_find(cut.begin(), cut.begin() + count) != cut.begin() + count;
}

// Measures the columns, so that the tracks of all sliders of a program begin and end at the same places.
void measure_columns(const Controls& controls, Index program, Section& section) {
    const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
    float name = 0, number = 0;
    for (const Control& control : controls.items) {
        if (control.program != program || control.widget != Widget::slider) continue;
        const std::size_t last = control.value.empty() ? 0 : control.value.size() - 1;
        name = std::max(name, width_of(name_of(control, last).view()));
        for (const double end : {control.min, control.max})
            number = std::max(number, width_of(shown_value(control, end).view()));
    }
    // Where there is no room for the names, the track is below them.
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, column = std::min(name + gap, room * .3F);
    const bool stacked = room < 15 * em || (name + gap > column && ambiguous(controls, program, column - gap));
    section.number_width = std::min(number + ImGui::GetStyle().FramePadding.x, room * (stacked ? .5F : .35F));
    section.name_width = stacked ? 0 : column;
}

void row(Control& control, const Section& section) {
    if (control.value.empty() || control.initial.size() != control.value.size()) return;
    ImGui::PushID(control.name.c_str());
    ImGui::BeginDisabled(!control.active);
    ImGui::BeginGroup();
    widget(control, section);
    ImGui::EndGroup();
    ImGui::EndDisabled();
    explain(control, section);
    ImGui::PopID();
}

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
void reset_button(Controls& controls, Index program, const Section& section, float right, const char* text) {
    ImGui::SameLine(right);
    if (or_keys(ImGui::SmallButton(text))) {
        for (Control& control : controls.items)
            if (control.program == program) reset(control);
        stop_all(section.memory.animated, program);
    }
    section.layout.note(section.program.name, "reset");
}

bool same_file(const std::optional<FileName>& a, const std::optional<FileName>& b) {
    return a && b ? a->name == b->name : a.has_value() == b.has_value();
}

// The files of a program that others of its name lack, such as ", red.frag"; empty if no other has its name.
std::string own_files(const Scene& scene, const Program& program) {
    std::string files;
    for (std::size_t stage = 0; stage < program.stages.size(); ++stage)
        if (const auto& file = program.stages[stage]; file && ranges::any_of(scene.programs, [&](const Program& other) {
                                                          return other.name == program.name &&
                                                                 !same_file(other.stages[stage], file);
                                                      }))
            files += ", " + file->name;
    return files;
}

// Draws the title; returns whether the section is open. While a filter is set, sections are open for themselves.
bool header(Controls& controls, Index index, const Section& section, bool open_at_first, bool unfolds) {
    const bool filtered = section.memory.filter[0] != '\0';
    const std::string& name = section.program.name;
    Text label(name);  // as in `snell render --set`
    if (const std::size_t earlier = earlier_of_name(*section.facts.scene, index)) label.add("#{}", earlier + 1);
    Folds& folds = section.memory.folds;
    const auto fold = folds.find(label.view());
    const bool opens = filtered || unfolds || (fold == folds.end() ? open_at_first : fold->second);
    if (opens || fold != folds.end()) ImGui::SetNextItemOpen(opens, unfolds ? ImGuiCond_Always : ImGuiCond_Once);
    const int before = ImGui::GetStateStorage()->GetInt(ImGui::GetID("###program"), -1);
    const auto moved = [](const Control& c) { return c.value != c.initial; };
    const auto moving = [&](const Animated& motion) { return motion.program == index; };
    const bool resets = any(controls, index, moved) || ranges::any_of(section.memory.animated, moving);
    Text wanted(name.empty() ? std::string_view("Program") : std::string_view());
    wanted.append(label.view());
    wanted.append(own_files(*section.facts.scene, section.program));
    // The title has what the button leaves, which is there only where something can be reset.
    const float room = ImGui::GetContentRegionAvail().x - 2 * ImGui::GetFrameHeight();
    const char* const text = width_of(wanted.view()) + button_width("Reset all") <= room ? "Reset all" : "Reset";
    const float button = resets ? button_width(text) : 0;
    const float right = ImGui::GetContentRegionMax().x - button - ImGui::GetStyle().FramePadding.x * .5F;
    Text title = shortened(wanted.view(), room - button);
    const bool whole = title == wanted.view();
    const bool open =
        ui::header(title.append(filtered ? "###found" : "###program").c_str(), ImGuiTreeNodeFlags_AllowItemOverlap);
    if (!filtered && !unfolds && before >= 0 && open != (before != 0))
        folds.insert_or_assign(std::string(label.view()), open);
    if (!whole) tip(wanted.view());
    section.layout.note(name);
    section.layout.note("title", wanted.view());
    keep_in_view(open);
    if (resets) reset_button(controls, index, section, right, text);
    return open;
}

void section_of(Controls& controls, Index index, Section section, bool open_at_first, bool unfolds) {
    const auto kept = [&](const Control& c) { return passes(c, section.memory); };
    const auto main = [&](const Control& c) { return sliding(c) && kept(c); };
    const auto constant = [&](const Control& c) { return c.listed && c.widget == Widget::none && kept(c); };
    const auto unlisted = [&](const Control& c) { return !c.listed && kept(c); };
    const bool filtered = section.memory.filter[0] != '\0';
    if (filtered && !any(controls, index, kept)) return;
    show_opened();
    // No other scene's section is open or closed by it.
    ImGui::PushID(section.facts.files.empty() ? "" : section.facts.files[0].path.c_str());
    const std::vector<int>& numbers = section.memory.numbers.now;
    ImGui::PushID(index < numbers.size() ? numbers[index] : static_cast<int>(index));
    if (header(controls, index, section, open_at_first, unfolds)) {
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
            toggled_by_keys(unfolded);
            section.layout.note(section.program.name, "constants");
            if (unfolded) {
                rows(controls, index, section, constant);
                ImGui::TreePop();
            }
        }
        if (any(controls, index, unlisted)) {
            ImGui::Separator();
            wrapped("not on the Program line", true);
            rows(controls, index, section, unlisted);
        }
        ImGui::Unindent(indent);
        ImGui::PopStyleVar();
    }
    for (int id = 0; id < 2; ++id) ImGui::PopID();
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
    text_field("##filter", "Filter by name", memory.filter);
    if (ImGui::IsItemDeactivated() && pressed(Key::escape)) memory.filter = {};
    layout.note("filter");
    if (!filtered) return;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (button("\u00d7", layout, "filter.clear")) memory.filter = {};
    if (ranges::none_of(controls.items, [&](const Control& c) { return is_shown(c) && passes(c, memory); }))
        ImGui::TextDisabled("No name contains this text.");
}

// Draws a drop-down, with the dot and the menu of a slider; a right click resets it to the scene's rung.
void ladder_row(const Ladder& ladder, std::size_t& rung, Layout& layout) {
    if (rung >= ladder.rungs.size()) return;
    ImGui::PushID(ladder.name.c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const std::string& initial = ladder.rungs[ladder.current];
    const bool changed = rung != ladder.current;
    if (dot(changed, false, Text(initial))) rung = ladder.current;
    if (changed) layout.note(ladder.name, "dot");
    ImGui::AlignTextToFramePadding();
    const float width = ImGui::GetContentRegionAvail().x, arrow = ImGui::GetFrameHeight() + button_width("");
    fitted(ladder.name, width * .6F);
    layout.note(ladder.name, "name");
    ImGui::SameLine();
    const ImRect left(corner, {ImGui::GetCursorScreenPos().x, corner.y + ImGui::GetFrameHeight()});
    if (begin_value_menu(left, ImGui::GetID("##rung"), left)) {
        if (menu_item(Text("Reset to {}", initial).c_str())) rung = ladder.current;
        layout.note(ladder.name, "reset");
        ImGui::EndPopup();
    }
    ImGui::SetNextItemWidth(-FLT_MIN);
    const Text chosen = shortened(ladder.rungs[rung], ImGui::GetContentRegionAvail().x - arrow);
    const bool open = begin_combo("##rung", chosen.c_str(), rung, ladder.rungs.size());
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

void ProgramNumbers::carry(const std::vector<Index>& programs, std::size_t count) {
    std::vector<int> numbers(count, -1);
    for (std::size_t i = 0; i < std::min(programs.size(), now.size()); ++i)
        if (programs[i] != none) numbers[programs[i]] = now[i];
    for (int& number : numbers)
        if (number < 0) number = next++;
    now = std::move(numbers);
}

void ladders_panel(const Facts& facts, Controls& controls, Layout& layout) {
    const std::vector<Ladder>& ladders = facts.scene->ladders;
    for (std::size_t i = 0; i < ladders.size() && i < controls.rungs.size(); ++i)
        ladder_row(ladders[i], controls.rungs[i], layout);
}

void programs_panel(const Facts& facts, Controls& controls, Memory& memory, Layout& layout) {
    const std::vector<Program>& programs = facts.scene->programs;
    filter_row(controls, memory, layout);
    // At first those that have sliders are open if all fit, otherwise the first of them.
    Index first = 0;
    while (first < programs.size() && !any(controls, first, sliding)) ++first;
    const auto slides = [](const Control& control) { return is_shown(control) && sliding(control); };
    const auto rows = static_cast<std::size_t>(ranges::count_if(controls.items, slides)) + programs.size();
    const bool fit = static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing() <= ImGui::GetContentRegionAvail().y;
    // An object that is picked unfolds its program.
    int& picked = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("picked"), -1);
    const Index object = memory.hold.object;
    const bool picks = object < facts.scene->draws.size() &&
                       std::exchange(picked, static_cast<int>(object)) != static_cast<int>(object);
    if (object == none) picked = -1;
    for (Index i = 0; i < programs.size(); ++i) {
        const bool linked = i < facts.linked.size() && facts.linked[i];
        const bool at_first = i == first || (fit && any(controls, i, sliding));
        const bool unfolds = picks && facts.scene->draws[object].program == i;
        section_of(controls, i, {facts, programs[i], linked, memory, layout}, at_first, unfolds);
    }
    if (programs.empty()) ImGui::TextDisabled("The scene has no Program statement.");
}

}  // namespace snell::ui
