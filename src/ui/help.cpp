#include "src/ui/help.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "src/ui/kit/widgets.h"

namespace snell::ui {

std::span<const KeyRow> key_rows() {
    static constexpr KeyRow rows[]{
        {"drag", "rotate the scene, or what is selected under *View*"},
        {"right drag or Shift drag", "move it in the plane of the screen"},
        {"wheel, middle drag or Ctrl drag", "scale it"},
        {"Shift wheel or Ctrl Shift drag", "move it towards the viewer"},
        {"R or Home", "reset the view"},
        {"P", "turn picking of objects on or off"},
        {"Esc", "deselect the picked object"},
        {"hold I", "magnify the pixel under the pointer and show its values"},
        {"N", "mark pixels that are NaN, infinite or outside of 0 to 1"},
        {"space bar", "pause or resume time"},
        {"1 to 9; with Ctrl", "restore a snapshot; store one"},
        {"Ctrl S; with Shift", "save the values to the scene; save as another scene"},
        {"Ctrl Z; Ctrl Y or Ctrl Shift Z", "undo; redo"},
        {"Ctrl O", "open another scene"},
        {"F5", "reload the files"},
        {"H", "hide or show the panel"},
        {"A", "open or close Accuracy (scenes with ladders)"},
        {"Ctrl +, Ctrl - and Ctrl 0", "larger, smaller, default text size"},
        {"F1", "show this list"},
        {"Tab; with Shift", "go to the next value; to the previous one"},
        {"arrow keys; with Shift; Page keys", "change that value: in steps; fine; coarse"},
        {"Enter; Esc", "type that value, and apply it; restore the old one"},
        {"slider: double click or Ctrl click", "type a number"},
        {"slider: right click; Alt drag", "reset to the scene's value; fine adjustment"},
        {"slider: right click on its name", "reset, logarithmic scale, animation"},
        {"ladder: right click", "reset to the scene's rung"},
    };
    return rows;
}

namespace {

// The asterisks are Markdown for docs/window.md.
std::string shown(const char* what) {
    std::string text = what;
    std::erase(text, '*');
    return text;
}

// Lists the keys in two columns, or in one if there is no room.
void list(float room) {
    const float em = ImGui::GetFontSize();
    float keys = 0, what = 0;
    for (const KeyRow& row : key_rows()) {
        keys = std::max(keys, ImGui::CalcTextSize(row.keys).x);
        what = std::max(what, ImGui::CalcTextSize(shown(row.what).c_str()).x);
    }
    const float begin = ImGui::GetCursorPosX();
    const bool beside = keys + em + what <= room;
    const float column = begin + (beside ? keys + em : em);
    for (const KeyRow& row : key_rows()) {
        ImGui::PushTextWrapPos(begin + std::min(room, beside ? keys + em + what : std::max(keys, what + em)) + 1);
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        ImGui::TextUnformatted(row.keys);
        ImGui::PopStyleColor();
        if (beside)
            ImGui::SameLine(column);
        else
            ImGui::SetCursorPosX(column);
        ImGui::TextUnformatted(shown(row.what).c_str());
        ImGui::PopTextWrapPos();
    }
}

}  // namespace

bool help_panel(const Rect& scene, Layout& layout) {
    bool closed = false;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({scene.x + scene.width / 2, scene.y + scene.height / 2}, 0, {.5F, .5F});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {std::max(em, scene.width - em), std::max(em, scene.height - em)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em, em * .8F});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("##keys", nullptr, flags)) {
        closed = button("Close", layout, "close keys");
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("F1");
        list(scene.width - 3.5F * em - ImGui::GetStyle().ScrollbarSize);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    return closed;
}

}  // namespace snell::ui
