#include "src/ui/panels/save_as.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "src/ui/kit/input.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

constexpr const char* save_as_title = "Save scene as";

void save_as_answers(SaveAs& dialog, bool entered, Requests& requests, Layout& layout) {
    const bool asks = !dialog.there.empty() && dialog.there == dialog.file.data();
    if (asks)
        ImGui::TextWrapped("%s exists. Replace it?", shortened(dialog.existing, 30 * ImGui::GetFontSize()).c_str());
    if (!dialog.error.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette().error_text);
        ImGui::TextWrapped("%s", dialog.error.c_str());
        ImGui::PopStyleColor();
        layout.note("save as error");
    }
    requests.save_as_now = button(asks ? "Replace" : "Save", layout, "save as save") || entered;
    if (next_button("Cancel", layout, "save as cancel") || pressed(Key::escape)) dialog.open = false;
}

}  // namespace

void open_save_as(SaveAs& dialog, const std::string& name) {
    dialog = {};
    dialog.open = true;
    name.copy(dialog.file.data(), dialog.file.size() - 1);
}

void save_as_window(Memory& memory, Requests& requests, Layout& layout) {
    SaveAs& dialog = memory.save_as;
    if (!dialog.open) return;
    const bool fresh = !ImGui::IsPopupOpen(save_as_title);
    if (fresh) ImGui::OpenPopup(save_as_title);
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {.5F, .5F});
    ImGui::SetNextWindowSize({std::min(30 * em, all.x - em), 0});
    if (!ImGui::BeginPopupModal(save_as_title, nullptr,
                                ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize))
        return;
    ImGui::TextUnformatted("Save the scene with these values as");
    if (fresh) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-FLT_MIN);
    const bool entered = ImGui::InputText("##scene", dialog.file.data(), dialog.file.size(),
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    layout.note("save as file");
    tip("In the scene's folder, where the scene finds its files");
    ImGui::Spacing();
    save_as_answers(dialog, entered, requests, layout);
    if (!dialog.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace snell::ui
