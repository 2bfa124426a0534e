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

struct SaveAsWords {
    const char *title, *label, *tip;
    std::string name;  // of the widgets
};

bool save_as_answers(SaveAs& dialog, bool entered, const std::string& name, Layout& layout) {
    const bool asks = !dialog.there.empty() && dialog.there == dialog.file.data();
    if (asks)
        ImGui::TextWrapped("%s exists. Replace it?", shortened(dialog.existing, 30 * ImGui::GetFontSize()).c_str());
    if (!dialog.error.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette().error_text);
        ImGui::TextWrapped("%s", dialog.error.c_str());
        ImGui::PopStyleColor();
        layout.note(name + " error");
    }
    const bool now = button(asks ? "Replace" : "Save", layout, name + " save") || entered;
    if (next_button("Cancel", layout, name + " cancel") || pressed(Key::escape)) dialog.open = false;
    return now;
}

// Returns true when the user confirms the name.
bool save_as_window(SaveAs& dialog, const SaveAsWords& words, Layout& layout) {
    if (!dialog.open) return false;
    const bool fresh = !ImGui::IsPopupOpen(words.title);
    if (fresh) ImGui::OpenPopup(words.title);
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {.5F, .5F});
    ImGui::SetNextWindowSize({std::min(30 * em, all.x - em), 0});
    if (!ImGui::BeginPopupModal(words.title, nullptr,
                                ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize))
        return false;
    ImGui::TextUnformatted(words.label);
    if (fresh) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-FLT_MIN);
    const bool entered = ImGui::InputText("##name", dialog.file.data(), dialog.file.size(),
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    layout.note(words.name + " file");
    tip(words.tip);
    ImGui::Spacing();
    const bool now = save_as_answers(dialog, entered, words.name, layout);
    if (!dialog.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return now;
}

}  // namespace

void open_save_as(SaveAs& dialog, const std::string& name) {
    dialog = {};
    dialog.open = true;
    name.copy(dialog.file.data(), dialog.file.size() - 1);
}

void save_as_windows(Memory& memory, Requests& requests, Layout& layout) {
    static const SaveAsWords scene{"Save scene as", "Save the scene with these values as",
                                   "In the scene's folder, where the scene finds its files", "save as"};
    static const SaveAsWords page{"Save page", "Save a page for browsers, with these values, as",
                                  "One file that holds all files of the scene.\nRelative to the scene's folder",
                                  "save page"};
    static const SaveAsWords rung{"Write rung", "Write the scene with this rung into the folder",
                                  "Relative to the scene's folder", "write rung"};
    requests.save_as_now = save_as_window(memory.save_as, scene, layout);
    requests.save_page_now = save_as_window(memory.save_page, page, layout);
    requests.write_rung_now = save_as_window(memory.write_rung, rung, layout);
}

}  // namespace snell::ui
