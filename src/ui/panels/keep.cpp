#include "src/ui/panels/keep.h"

#include <fmt/format.h>
#include <imgui.h>

#include "src/platform/window.h"
#include "src/ui/kit/widgets.h"

namespace snell::ui {

namespace {

bool button(const char* label, bool enabled, const char* help) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label);
    ImGui::EndDisabled();
    tip(help);
    return pressed;
}

}  // namespace

void keep_panel(const Facts& facts, Requests& requests, Layout& layout) {
    if (!facts.scene) return;
    requests.save |= button("Save values", facts.changed,
                            "Ctrl+S: saves the current values to the scene's file.\nOnly the numbers change.");
    layout.note("save");
    follow(button_width("Undo"));
    requests.undo_save |= button("Undo", facts.undoable, "Ctrl+Shift+S: restores the file as it was before saving");
    layout.note("undo save");
    follow(button_width("Copy command"));
    requests.copy_command |= button("Copy command", true, "Copies the command for this view");
    layout.note("copy command");
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
    const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, false); };
    if (io.KeyCtrl && pressed(static_cast<int>(Key::s))) (io.KeyShift ? requests.undo_save : requests.save) = true;
    for (int number = 1; number <= snapshot_count; ++number) {
        if (!pressed(static_cast<int>(Key::one) + number - 1)) continue;
        (io.KeyCtrl ? requests.store_snapshot : requests.restore_snapshot) = number;
    }
}

}  // namespace snell::ui
