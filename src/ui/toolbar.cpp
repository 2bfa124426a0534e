#include "src/ui/toolbar.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "src/plan/view.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

constexpr float close_together = .3F;  // the gap between buttons of the toolbar, in multiples of the text height

// A menu below its button, within the screen. The popup's size is that of the last frame.
bool begin_menu(const char* text, const char* name, Layout& layout) {
    if (button(text, layout, name)) ImGui::OpenPopup(name);
    ImGuiStorage& sizes = *ImGui::GetStateStorage();
    const ImGuiID width = ImGui::GetID("##menu width"), height = ImGui::GetID("##menu height");
    const ImVec2 all = ImGui::GetIO().DisplaySize, from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({std::max(0.0F, std::min(from.x, all.x - sizes.GetFloat(width))),
                             std::max(0.0F, std::min(to.y, all.y - sizes.GetFloat(height)))});
    const bool open = ImGui::BeginPopup(name);
    note_opener({from.x, from.y, to.x - from.x, to.y - from.y}, open);
    if (!open) return false;
    sizes.SetFloat(width, ImGui::GetWindowWidth());
    sizes.SetFloat(height, ImGui::GetWindowHeight());
    return true;
}

struct Item {
    const char *text, *keys, *name;
    bool enabled = true, on = false;
};

bool item(const Item& item, Layout& layout) {
    const bool chosen = ImGui::MenuItem(item.text, item.keys, item.on, item.enabled);
    layout.note(item.name);
    return chosen;
}

void open_menu(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    if (!begin_menu("Open \u25BE", "menu.open", layout)) return;
    if (item({"Open\u2026", "Ctrl+O", "open"}, layout)) open_browser({}, memory, requests);
    if (!facts.recent.empty()) ImGui::Separator();
    for (std::size_t i = 0; i < facts.recent.size(); ++i) {
        const RecentScene& scene = facts.recent[i];
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::MenuItem(shortened(scene.name, 16 * ImGui::GetFontSize()).c_str())) requests.open = scene.path;
        tip(scene.folder);
        layout.note("recent", scene.name);
        ImGui::PopID();
    }
    ImGui::EndPopup();
}

void save_menu(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    if (!begin_menu("Save \u25BE", "menu.save", layout)) return;
    requests.save |= item({"Save values", "Ctrl+S", "save", facts.changed}, layout);
    tip("Saves the current values to the scene's file.\nOnly the numbers change. Ctrl+Z restores the file.");
    requests.save_as |= item({"Save as\u2026", "Ctrl+Shift+S", "save as"}, layout);
    ImGui::Separator();
    const bool picture = item({"Save picture\u2026", nullptr, "picture"}, layout);
    const bool sequence =
        item({"Save sequence\u2026", nullptr, "sequence", facts.animated || memory.animating()}, layout);
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
    if (!begin_menu("View \u25BE", "menu.view", layout)) return;
    if (facts.scene) {
        if (item({"Reset view", "R", "reset view"}, layout)) reset_view(view);
        if (item({"Axes", nullptr, "axes", true, view.axes}, layout)) view.axes = !view.axes;
        if (item({"Values over the picture", nullptr, "labels", true, memory.labels}, layout))
            memory.labels = !memory.labels;
        if (item({"Pick objects", "P", "pick", true, memory.hold.picking}, layout)) switch_picking(memory.hold);
        projection_item(*facts.scene, view, layout);
        ImGui::Separator();
    }
    requests.full_screen |= item({"Full screen", "F11", "full screen", true, facts.full_screen}, layout);
    if (item({"Hide all", "H", "hide"}, layout)) hide(memory);
    ImGui::EndPopup();
}

void snapshot_row(const Facts& facts, Requests& requests, Layout& layout) {
    const float gap = close_together * ImGui::GetFontSize();
    const float all = snapshot_count * (button_width("9") + gap);
    const bool named =
        width_of("Snapshots") + ImGui::GetStyle().ItemSpacing.x + all <= ImGui::GetContentRegionAvail().x;
    if (named) label("Snapshots");
    for (int number = 1; number <= snapshot_count; ++number) {
        const bool there = facts.snapshots[static_cast<std::size_t>(number)];
        if (number > 1) follow(button_width("9"), gap);
        ImGui::PushID(number);
        if (!there) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        if (ImGui::Button(fmt::format("{}", number).c_str())) {
            if (there && !ImGui::GetIO().KeyCtrl)
                requests.restore_snapshot = number;
            else
                requests.store_snapshot = number;
        }
        if (!there) ImGui::PopStyleColor();
        tip(there ? "Restores this snapshot. Ctrl-click to replace it." : "Stores the current values as a snapshot.");
        layout.note(fmt::format("snapshot {}", number));
        ImGui::PopID();
    }
}

}  // namespace

void hide(Memory& memory) {
    memory.panel = !memory.panel;
    memory.hint = memory.panel ? 0 : hint_seconds;
}

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

}  // namespace snell::ui
