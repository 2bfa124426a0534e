#include "src/ui/shell.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <utility>

#include "parser/text/ranges.h"
#include "src/plan/values/numbers.h"
#include "src/plan/view.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/text.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/panels.h"
#include "src/ui/panels/pixels.h"
#include "src/ui/panels/textures.h"

namespace snell::ui {

namespace {

// Returns a label such as "Glass : uEta =     1.1000", in glman's format.
Text label_of(const Scene& scene, const Control& control) {
    Text text(scene.programs[control.program].name);
    if (const std::size_t earlier = earlier_of_name(scene, control.program)) text.add("#{}", earlier + 1);
    text.add(" : {} = ", control.name);
    if (control.type == ValueType::bool_) return std::move(text.append(control.value[0] != 0 ? "true" : "false"));
    for (std::size_t i = 0; i < control.value.size(); ++i) {
        if (i > 0) text.append(", ");
        if (is_whole(control.type))
            text.add("{:10.0f}", control.value[i]);
        else if (control.widget == Widget::color)
            text.add("{:8.3f}", control.value[i]);
        else
            text.add("{:10.4f}", control.value[i]);
    }
    return text;
}

}  // namespace

std::string cut_name(const std::string& label, std::size_t columns) {
    const std::size_t equals = std::min(label.find(" = "), label.size());
    std::string value;
    for (std::size_t i = equals; i < label.size(); ++i)
        if (label[i] != ' ' || value.empty() || value.back() != ' ') value += label[i];
    if (equals + value.size() <= columns) return label.substr(0, equals) + value;
    constexpr std::size_t least = 6;
    if (value.size() + 1 > columns && columns >= least) value = value.substr(0, columns - 2) + "\u2026";
    const std::size_t kept = std::min(equals, columns > value.size() + 1 ? columns - value.size() - 1 : 0);
    const auto inside = [&](std::size_t at) { return at < equals && (label[at] & 0xC0) == 0x80; };
    std::size_t head = (kept + 1) / 2, tail = equals - kept / 2;
    while (head > 0 && inside(head)) --head;
    while (inside(tail)) ++tail;
    return label.substr(0, head) + "\u2026" + label.substr(tail, equals - tail) + value;
}

void value_labels(const Facts& facts, const Controls& controls, const Rect& scene, const Fonts& fonts) {
    if (!facts.scene) return;
    const auto labelled = [](const Control& c) { return c.listed && c.active && c.widget != Widget::none; };
    const float size = fonts.mono->FontSize, line = std::round(size * 1.25F), margin = std::round(size * .6F);
    const float room = (scene.width - 2 * margin) / fonts.mono->CalcTextSizeA(size, FLT_MAX, 0, "M").x;
    const auto count = static_cast<float>(ranges::count_if(controls.items, labelled));
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({scene.x, scene.y}, {scene.x + scene.width, scene.y + scene.height});
    float y = scene.y + scene.height - margin - count * line;
    for (const Control& control : controls.items) {
        if (!labelled(control)) continue;
        Text text = label_of(*facts.scene, control);
        if (const auto columns = static_cast<std::size_t>(room); text.view().size() > columns)
            text = Text(cut_name(std::string(text.view()), columns));
        const ImVec2 at(scene.x + margin, y);
        // A dim plate makes the white text readable on light pictures.
        const float pad = std::round(size * .3F), width = fonts.mono->CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x;
        list.AddRectFilled({at.x - pad, at.y}, {at.x + width + pad, at.y + line}, IM_COL32(0, 0, 0, 165));
        list.AddText(fonts.mono, size, at, IM_COL32_WHITE, text.c_str());
        y += line;
    }
    list.PopClipRect();
}

namespace {

// Hides or shows all but the picture. While it is hidden, a hint says for a moment how to show it.
void hide(Memory& memory) {
    memory.panel = !memory.panel;
    memory.hint = memory.panel ? 0 : hint_seconds;
}

constexpr float close_together = .3F;  // the gap between buttons of the toolbar, in multiples of the text height

bool begin_menu(const char* text, const char* name, Memory& memory, Layout& layout) {
    if (button(text, layout, name)) ImGui::OpenPopup(name);
    if (!begin_popup(name)) return false;
    if (memory.menu == Menu::closing) {
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
        return false;
    }
    memory.menu = Menu::open;
    return true;
}

struct Item {
    const char *text, *keys, *name;
    bool enabled = true, on = false;
};

// In the narrowest windows without its keys, which F1 lists.
bool item(const Item& item, Layout& layout) {
    const float em = ImGui::GetFontSize(), all = ImGui::GetIO().DisplaySize.x;
    const Text text = shortened(item.text, all - 4.5F * em);
    const bool chosen = menu_item(text.c_str(), all < 20 * em ? nullptr : item.keys, item.on, item.enabled);
    layout.note(item.name);
    return chosen;
}

void open_menu(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    if (!begin_menu("Open \u25BE", "menu.open", memory, layout)) return;
    if (item({"Open\u2026", "Ctrl+O", "open"}, layout)) open_browser({}, memory, requests);
    if (!facts.recent.empty()) ImGui::Separator();
    for (std::size_t i = 0; i < facts.recent.size(); ++i) {
        const SceneCard& scene = facts.recent[i];
        ImGui::PushID(static_cast<int>(i));
        const float em = ImGui::GetFontSize(), room = std::min(16 * em, ImGui::GetIO().DisplaySize.x - 4.5F * em);
        if (menu_item(shortened(scene.name, room).c_str())) requests.open = scene.path;
        tip(scene.folder);
        layout.note("recent", scene.name);
        ImGui::PopID();
    }
    ImGui::EndPopup();
}

void save_menu(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    if (!begin_menu("Save \u25BE", "menu.save", memory, layout)) return;
    requests.save |= item({"Save values", "Ctrl+S", "save", facts.changed}, layout);
    tip("Saves the current values to the scene's file.\nOnly the numbers change. Ctrl+Z restores the file.");
    requests.save_as |= item({"Save as\u2026", "Ctrl+Shift+S", "save as"}, layout);
    ImGui::Separator();
    const bool picture = item({"Save picture\u2026", nullptr, "picture"}, layout);
    const bool sequence =
        item({"Save sequence\u2026", nullptr, "sequence", facts.animated || memory.animating()}, layout);
    tip(facts.animated || memory.animating() ? "Saves numbered pictures of a span of time"
                                             : "Nothing moves: the scene does not use time, and no slider is animated");
    if (picture || sequence) {
        requests.picture = PictureRequest::open;
        memory.picture.sequence = sequence;
    }
    requests.save_page |= item({"Page\u2026", nullptr, "page"}, layout);
    tip("Saves the scene as one file that every browser opens,\nwith its sliders and the current values");
    ImGui::Separator();
    requests.copy_command |= item({"Copy command", nullptr, "copy command"}, layout);
    tip("Copies the command for this view");
    ImGui::EndPopup();
}

void projection_item(const Scene& scene, View& view, Layout& layout) {
    const bool own = window_camera(scene).perspective;
    const bool perspective = view.projection == Projection::scene ? own : view.projection == Projection::perspective;
    if (!item({"Perspective", nullptr, "perspective", true, perspective}, layout)) return;
    view.projection = perspective != own ? Projection::scene : own ? Projection::ortho : Projection::perspective;
}

void view_menu(const Facts& facts, View& view, Memory& memory, Requests& requests, Layout& layout) {
    if (!begin_menu("View \u25BE", "menu.view", memory, layout)) return;
    if (facts.scene) {
        if (item({"Reset view", "R", "reset view"}, layout)) reset_view(view);
        if (item({"Axes", nullptr, "axes", true, view.axes}, layout)) view.axes = !view.axes;
        if (item({"Values over the picture", nullptr, "labels", true, memory.labels}, layout))
            memory.labels = !memory.labels;
        if (item({"Pick objects", "P", "pick", true, memory.hold.picking}, layout)) switch_picking(memory.hold);
        projection_item(*facts.scene, view, layout);
        const bool split = memory.accuracy.show != AccuracyMemory::Show::picture;
        if (item({"Two states side by side", "S", "split", true, split}, layout)) switch_split(memory.accuracy);
        ImGui::Separator();
    }
    requests.full_screen |= item({"Full screen", "F11", "full screen", true, facts.full_screen}, layout);
    if (item({"Hide all", "H", "hide"}, layout)) hide(memory);
    ImGui::EndPopup();
}

// Marks the button that was drawn last: there is something to restore.
void stored_mark(const std::string& name, Layout& layout) {
    const float radius = std::round(.15F * ImGui::GetFontSize());
    const ImVec2 corner(ImGui::GetItemRectMax().x - 1.5F * radius, ImGui::GetItemRectMin().y + 1.5F * radius);
    ImGui::GetWindowDrawList()->AddCircleFilled(corner, radius, ImGui::GetColorU32(palette().accent));
    layout.place(name + ".stored", {corner.x - radius, corner.y - radius, 2 * radius, 2 * radius});
}

void snapshot_menu(int number, bool there, const std::string& name, Requests& requests, Layout& layout) {
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("menu");
    if (!begin_popup("menu")) return;
    if (menu_item(there ? "Store again" : "Store")) requests.store_snapshot = number;
    layout.note(name + ".store");
    if (menu_item("Delete", nullptr, false, there)) requests.delete_snapshot = number;
    layout.note(name + ".delete");
    ImGui::EndPopup();
}

void snapshot_row(const Facts& facts, Requests& requests, Layout& layout) {
    const float gap = close_together * ImGui::GetFontSize();
    ImGui::AlignTextToFramePadding();
    fitted("Snapshots", ImGui::GetContentRegionAvail().x);
    layout.note("snapshots");
    for (int number = 1; number <= snapshot_count; ++number) {
        const bool there = facts.snapshots[static_cast<std::size_t>(number)];
        follow(button_width("9"), number > 1 ? gap : -1);
        ImGui::PushID(number);
        if (!there) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        if (or_keys(ImGui::Button(fmt::format("{}", number).c_str()))) {
            if (there && !ImGui::GetIO().KeyCtrl)
                requests.restore_snapshot = number;
            else
                requests.store_snapshot = number;
        }
        if (!there) ImGui::PopStyleColor();
        tip(there ? "Restores this snapshot of the values; the view stays. Ctrl-click to replace it, right-click to "
                    "delete it."
                  : "Stores the current values as a snapshot, without the view.");
        const std::string name = fmt::format("snapshot {}", number);
        layout.note(name);
        if (there) stored_mark(name, layout);
        snapshot_menu(number, there, name, requests, layout);
        ImGui::PopID();
    }
}

// Draws the two rows at the top of the panel: the menus of what is opened, saved and shown, and the snapshots.
void toolbar(const Facts& facts, View& view, Memory& memory, Requests& requests, Layout& layout) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const float gap = close_together * ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {padding.x * .6F, padding.y});
    open_menu(facts, memory, requests, layout);
    follow(button_width("Reload"), gap);
    ImGui::BeginDisabled(no_scene_open(facts));
    requests.reload |= button("Reload", layout, "reload");
    tip("F5");
    ImGui::EndDisabled();
    follow(button_width("Save \u25BE"), gap);
    ImGui::BeginDisabled(!facts.scene);
    save_menu(facts, memory, requests, layout);
    ImGui::EndDisabled();
    follow(button_width("View \u25BE"), gap);
    view_menu(facts, view, memory, requests, layout);
    ImGui::BeginDisabled(!facts.scene);
    snapshot_row(facts, requests, layout);
    ImGui::EndDisabled();
    ImGui::PopStyleVar();
}

// Ctrl+S saves the values to the scene, Ctrl+Shift+S as another scene; 1 to 9 restore a snapshot, Ctrl with 1 to 9
// stores it.
void keep_keys(const Facts& facts, Requests& requests) {
    if (!facts.scene) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && pressed(Key::s)) (io.KeyShift ? requests.save_as : requests.save) = true;
    if (io.KeyCtrl && !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive()) {  // a gesture would lose its beginning
        if (pressed(Key::z, true)) (io.KeyShift ? requests.redo : requests.undo) = true;
        if (pressed(Key::y, true)) requests.redo = true;
    }
    for (int number = 1; number <= snapshot_count; ++number) {
        if (!pressed(static_cast<Key>(static_cast<int>(Key::one) + number - 1))) continue;
        (io.KeyCtrl ? requests.store_snapshot : requests.restore_snapshot) = number;
    }
}

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                   ImGuiWindowFlags_NoNav;

constexpr float least_panel = 12;  // width, in multiples of the text height

struct Areas {
    Rect scene, panel, status;
};

// Areas in whole pixels, so that the picture is copied and not resampled.
Areas areas(Memory& memory) {
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const float half = all.x * .5F;
    const float width = memory.panel ? std::round(std::clamp(memory.panel_width * em, std::min(least_panel * em, half),
                                                             std::max(least_panel * em, half)))
                                     : 0;
    const float line = memory.panel ? std::round(ImGui::GetFrameHeight()) : 0;
    Areas result;
    result.scene = {0, 0, std::max(1.0F, all.x - width), std::max(1.0F, all.y - line)};
    result.status = {0, all.y - line, std::max(1.0F, all.x - width), line};
    result.panel = {all.x - width, memory.above, width, std::max(1.0F, all.y - memory.above - memory.below)};
    return result;
}

void place(const Rect& rect) {
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
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

constexpr float words_room = 8;  // how to open a scene is said over the picture

void controls_tab(const Facts& facts, Controls& controls, Memory& memory, Layout& layout, Requests& requests) {
    if (no_scene_open(facts) && !has_room(memory.scene, words_room)) {
        if (no_scene_words(layout)) open_browser({}, memory, requests);
        return;
    }
    if (!facts.scene) {
        wrapped(no_scene_open(facts) ? "no scene" : fmt::format("{} is not drawn", facts.file), true);
        return layout.note("not drawn", facts.file);
    }
    ladders_panel(facts, controls, layout);
    programs_panel(facts, controls, memory, layout);
}

void tools_tab(const Facts& facts, Controls& controls, View& view, Memory& memory, Layout& layout, Requests& requests) {
    if (facts.scene) {
        const bool moves = facts.animated || memory.animating();
        accuracy_section(facts, controls, moves, memory.accuracy, requests, layout);
        view_section(facts, view, memory, layout);
        pixels_section(memory.open, memory.pixels, layout);
        textures_section(facts, memory, layout);
        requests.measure_frame = frame_cost_section(facts, memory, layout);
        costs_section(facts, memory, layout);
        files_section(facts, memory, requests, layout);
    }
    look_section(memory, layout);
}

void panel_window(const Facts& facts, const Rect& panel, Controls& controls, View& view, Memory& memory, Layout& layout,
                  Requests& requests) {
    place(panel);
    const float em = ImGui::GetFontSize(), padding = ImGui::GetStyle().WindowPadding.x;
    if (ImGui::Begin("##panel", nullptr, fixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        // In low windows the scene's time scrolls with what is below it, and in the lowest everything does.
        const bool low = panel.height < 40 * em, lowest = panel.height < 16 * em;
        const auto begin_child = [&] {
            ImGui::BeginChild(memory.tab == Tab::tools ? "##tools" : "##programs", {0, 0});
        };
        if (lowest) begin_child();
        toolbar(facts, view, memory, requests, layout);
        if (!low) clock_panel(facts, memory, layout);
        memory.tab = static_cast<Tab>(
            tabs({{{"Controls", "controls"}, {"Tools", "tools"}}}, static_cast<std::size_t>(memory.tab), layout));
        if (!lowest) begin_child();
        if (low) clock_panel(facts, memory, layout);
        if (memory.tab == Tab::tools)
            tools_tab(facts, controls, view, memory, layout, requests);
        else
            controls_tab(facts, controls, memory, layout, requests);
        show_opened();
        ImGui::EndChild();
        splitter(panel, memory);
        ImGui::GetWindowDrawList()->AddLine({panel.x, panel.y}, {panel.x, panel.y + panel.height},
                                            ImGui::GetColorU32(palette().rule), std::max(1.0F, padding / 14));
    }
    ImGui::End();
}

// Closes Accuracy if it is in sight, and otherwise shows it.
void switch_accuracy(Memory& memory) {
    memory.accuracy.open = !memory.accuracy_in_sight();
    if (!memory.accuracy.open) return;
    memory.tab = Tab::tools;
    if (!memory.panel) hide(memory);
}

void keys(const Facts& facts, View& view, Memory& memory, Requests& requests) {
    if (plain(Key::h)) hide(memory);
    requests.reload |= pressed(Key::f5);
    requests.full_screen = pressed(Key::f11);
    keep_keys(facts, requests);
    clock_keys(facts, memory);
    files_keys(memory, requests);
    if (pressed(Key::f1)) memory.keys = !memory.keys;
    if (memory.keys && pressed(Key::escape)) {
        memory.keys = false;
    } else if (!found_keys(facts, requests)) {
        // Full screen ends last, as it was there before anything that Escape ends. Before it, the newest notice does.
        if (pressed(Key::escape) && !memory.hold.picking && memory.hold.object == none) {
            if (memory.failures.open.empty())
                requests.full_screen |= facts.full_screen;
            else
                memory.failures.open.pop_back();
        }
        if (facts.scene) view_keys(view, memory.hold);
    }
    if (facts.scene && plain(Key::a)) switch_accuracy(memory);
    if (facts.scene && plain(Key::s)) switch_split(memory.accuracy);
}

// Shows for a moment how the panel comes back.
void hint(const Rect& scene, Memory& memory, Layout& layout) {
    memory.hint = std::max(0.0, memory.hint - ImGui::GetIO().DeltaTime);
    if (memory.hint <= 0) return;
    constexpr double fading = .7;
    constexpr const char* text = "H: show the panel";
    const float alpha = static_cast<float>(std::min(1.0, memory.hint / fading)), em = ImGui::GetFontSize();
    const ImVec2 size(width_of(text) + 2 * em, 2 * em);
    const ImVec2 at(std::round(scene.x + (scene.width - size.x) / 2), scene.y + scene.height - 2 * size.y);
    const auto faded = [&](ImVec4 color) { return ImGui::GetColorU32({color.x, color.y, color.z, color.w * alpha}); };
    ImDrawList& list = *ImGui::GetBackgroundDrawList();  // the list of keys lies over it
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, faded(palette().problem_background), em * .4F);
    list.AddText({at.x + em, at.y + em * .5F}, faded(palette().problem_text), text);
    layout.place("hint", {at.x, at.y, size.x, size.y});
}

// What lies over the picture: errors, legends, what there is instead of a picture, the names of two states, and what
// could not be done. Returns where the names begin.
float over_picture(const Facts& facts, const Rect& scene, const Fonts& fonts, Memory& memory, Requests& requests,
                   Layout& layout) {
    // Where notices and the names of the states need the panel's room, failures are answered first, so that some of the
    // panel is seen; errors are still counted below.
    const bool failed = !has_room(scene) && !memory.failures.open.empty();
    float begin = failed ? scene.y : problems_panel(facts, scene, fonts, memory, requests, layout);
    // Where both need the panel's room, errors go first.
    if (memory.panel && (begin <= scene.y || has_room(scene)))
        begin = flags_legend(facts, {scene.x, begin, scene.width, scene.height - begin}, memory.pixels, layout);
    if (no_scene_open(facts) && !memory.browser.open && has_room(scene, words_room) && no_scene(scene, layout))
        open_browser({}, memory, requests);
    first_picture(facts, scene, layout);
    blank_halves(facts, scene, memory.accuracy);
    if (facts.states && memory.accuracy.show == AccuracyMemory::Show::split)
        accuracy_divider(scene, memory.accuracy, layout);
    const float end = failed ? scene.y + scene.height : state_bar(facts, scene, memory.accuracy, layout);
    const float first = notices(facts, {scene.x, begin, scene.width, end - begin}, memory, requests, layout);
    const bool shares = memory.panel && !has_room(scene);
    memory.above = shares ? begin : 0;
    memory.below = shares && first < scene.height ? ImGui::GetIO().DisplaySize.y - first : 0;
    return end;
}

}  // namespace

float fitting_scale(float wanted, float width) {
    constexpr float letters = 16, share = 2.0F / 3;  // the text height at a scale of 1; of the panel
    return std::min(wanted, std::max(width * share / (least_panel * letters), .5F));
}

Requests shell(const Facts& facts, Controls& controls, View& view, Memory& memory, const Fonts& fonts, Layout& layout) {
    layout.clear();
    Requests requests;
    const Menu menu = std::exchange(memory.menu, Menu::none);
    const bool dialog = memory.browser.open || memory.picture.open || memory.save_as.open || memory.save_page.open ||
                        memory.write_rung.open || memory.set_editor.open || memory.new_scene.open ||
                        (menu == Menu::none && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
    const bool cancels = pressed(Key::escape) && ImGui::IsAnyMouseDown();  // what is being dragged
    // Commands take the number that is being typed, as a press beside its field does.
    const bool leaves = !dialog && ImGui::GetIO().KeyCtrl && (pressed(Key::s) || pressed(Key::o)) && leave_field();
    if (!ImGui::GetIO().WantTextInput && !dialog && !cancels) {
        keys(facts, view, memory, requests);
        const bool arrows = pressed(Key::down, true) || pressed(Key::up, true);
        const bool tabs = pressed(Key::tab, true) || pressed(Key::enter) || pressed(Key::space);
        if (menu == Menu::open && any_pressed() && !arrows && !(tabs && kit().focus.presses))
            memory.menu = Menu::closing;
    }
    const Areas parts = areas(memory);
    memory.scene = parts.scene;
    follow_ladder(controls.rungs, memory.accuracy);
    // Out of sight they cost nothing.
    if (!memory.panel || memory.tab != Tab::tools || !facts.scene)
        memory.costs = memory.textures.open = memory.textures.inspecting = false;
    if (memory.panel) {
        // In the smallest windows nothing may be left of it until errors are hidden.
        if (parts.panel.height >= 2 * ImGui::GetFontSize())
            panel_window(facts, parts.panel, controls, view, memory, layout, requests);
        status_line(facts, parts.status, memory, layout);
        if (memory.labels) value_labels(facts, controls, parts.scene, fonts);
    }
    const float end = over_picture(facts, parts.scene, fonts, memory, requests, layout);
    pixel_keys(parts.scene, memory.pixels);
    inspector(facts, parts.scene, memory.pixels, fonts, layout);
    texel_inspector(facts, memory.textures, fonts, layout);
    browser_window(facts, memory, requests, layout);
    picture_window(facts, memory, requests, layout);
    save_as_windows(memory, requests, layout);
    if (memory.keys && help_panel(layout)) memory.keys = false;
    hint({parts.scene.x, parts.scene.y, parts.scene.width, end - parts.scene.y}, memory, layout);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (memory.hold.picking && facts.scene && !ImGui::GetIO().WantCaptureMouse &&
        parts.scene.contains(mouse.x, mouse.y))
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    hold_scene(facts, parts.scene, view, memory.hold, requests);
    requests.take_back = std::exchange(memory.slider.taken_back, false);
    if (leaves && !refused()) keys(facts, view, memory, requests);
    return requests;
}

namespace {

constexpr double scale_per_step = 1.1;     // per step of the wheel
constexpr double scale_per_point = 1.006;  // per point of a drag
constexpr double points_per_step = 20;     // per step of the wheel, towards the viewer
constexpr float still = 3;                 // in points: a press that moves less is a click

// With `picks`, a press that does not move will be a click, and does not turn anything.
ViewGesture gesture(const Rect& area, bool picks) {
    const ImGuiIO& io = ImGui::GetIO();
    ViewGesture made;
    if (area.contains(io.MousePos.x, io.MousePos.y)) {
        // Some systems swap the wheel's axes while Shift is down.
        if (io.KeyShift)
            made.move.z = points_per_step * (io.MouseWheel + io.MouseWheelH);
        else
            made.scale = std::pow(scale_per_step, io.MouseWheel);
    }
    const double dx = io.MouseDelta.x, dy = io.MouseDelta.y;
    if ((dx == 0 && dy == 0) || !std::isfinite(dx) || !std::isfinite(dy)) return made;
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (left && io.KeyCtrl && io.KeyShift)
        made.move.z += dy;
    else if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && io.KeyCtrl))
        made.scale *= std::pow(scale_per_point, dx - dy);
    else if (ImGui::IsMouseDown(ImGuiMouseButton_Right) || (left && io.KeyShift))
        made.move += glm::dvec3(dx, -dy, 0);
    else if (left && !(picks && io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] <= still * still))
        made.turn = {dx, dy};
    return made;
}

std::optional<Point> clicked(const Rect& area) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left) || io.KeyShift || io.KeyCtrl ||
        io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > still * still ||
        !area.contains(io.MousePos.x, io.MousePos.y))
        return std::nullopt;
    return Point{io.MousePos.x - area.x, io.MousePos.y - area.y};
}

}  // namespace

void hold_scene(const Facts& facts, const Rect& area, View& view, HoldMemory& hold, Requests& requests) {
    if (!facts.scene) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsAnyMouseDown()) {
        hold.before.reset();
        hold.cancelled = false;
    }
    if (hold.before && pressed(Key::escape)) {
        view = *std::exchange(hold.before, std::nullopt);
        hold.cancelled = true;
    }
    if (!io.WantCaptureMouse && !hold.cancelled) {
        if (!hold.before && ImGui::IsAnyMouseDown()) hold.before = view;
        // It stays so until the button is up: the same position of the mouse gives the same view.
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) hold.flipped = upside_down(held(view, hold), *facts.scene);
        apply(gesture(area, hold.picking), *facts.scene, std::max(1.0F, std::min(area.width, area.height)), view, hold);
        if (hold.picking) requests.pick = clicked(area);
    }
    if (facts.mouse && area.contains(io.MousePos.x, io.MousePos.y)) {
        view.mouse_x = (io.MousePos.x - area.x) * io.DisplayFramebufferScale.x;
        view.mouse_y = (area.y + area.height - io.MousePos.y) * io.DisplayFramebufferScale.y;
    }
}

}  // namespace snell::ui
