#include <fmt/format.h>
#include <imgui.h>

#include "src/ui/kit/input.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

bool keep_button(const char* text, bool enabled, const char* help, Layout& layout, const char* name) {
    ImGui::BeginDisabled(!enabled);
    const bool chosen = button(text, layout, name);
    ImGui::EndDisabled();
    tip(help);
    return chosen;
}

}  // namespace

void keep_panel(const Facts& facts, Requests& requests, Layout& layout) {
    if (!facts.scene) return;
    requests.save |=
        keep_button("Save values", facts.changed,
                    "Ctrl+S: saves the current values to the scene's file.\nOnly the numbers change.", layout, "save");
    follow(button_width("Revert save"));
    requests.revert_save |= keep_button(
        "Revert save", facts.revertible,
        "Restores the file as it was before saving.\nSliders and view stay as they are.", layout, "revert save");
    requests.copy_command |= next_button("Copy command", layout, "copy command");
    tip("Copies the command for this view");
    picture_button(requests, layout);

    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Snapshots");
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {padding.x * .6F, padding.y});
    for (int number = 1; number <= snapshot_count; ++number) {
        const bool there = facts.snapshots[static_cast<std::size_t>(number)];
        follow(button_width("9"), number == 1 ? -1 : ImGui::GetStyle().ItemInnerSpacing.x * .5F);
        ImGui::PushID(number);
        if (!there) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        if (ImGui::Button(fmt::format("{}", number).c_str())) {
            if (there && !ImGui::GetIO().KeyCtrl)
                requests.restore_snapshot = number;
            else
                requests.store_snapshot = number;
        }
        if (!there) ImGui::PopStyleColor();
        tip(there ? "Restores this snapshot. Ctrl-click to replace it." : "Stores the current values.");
        layout.note(fmt::format("snapshot {}", number));
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
}

void keep_keys(const Facts& facts, Requests& requests) {
    if (!facts.scene) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && pressed(Key::s)) (io.KeyShift ? requests.save_as : requests.save) = true;
    if (io.KeyCtrl && pressed(Key::z, true)) (io.KeyShift ? requests.redo : requests.undo) = true;
    if (io.KeyCtrl && pressed(Key::y, true)) requests.redo = true;
    for (int number = 1; number <= snapshot_count; ++number) {
        if (!pressed(static_cast<Key>(static_cast<int>(Key::one) + number - 1))) continue;
        (io.KeyCtrl ? requests.store_snapshot : requests.restore_snapshot) = number;
    }
}

}  // namespace snell::ui
