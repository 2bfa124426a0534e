#include "src/ui/help.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "src/ui/kit/widgets.h"

namespace snell::ui {

std::span<const KeyRow> key_rows() {
    static constexpr KeyRow rows[]{
        {"drag", "rotate the scene, or what is selected under *View*", "Picture"},
        {"right drag or Shift drag", "move it in the plane of the screen"},
        {"wheel, middle drag or Ctrl drag", "scale it"},
        {"Shift wheel or Ctrl Shift drag", "move it towards the viewer"},
        {"R or Home", "reset the view"},
        {"P", "turn picking of objects on or off"},
        {"Esc", "deselect the picked object; end picking; leave full screen"},
        {"hold I", "magnify the pixel under the pointer and show its values"},
        {"N", "mark pixels that are NaN, infinite or outside of 0 to 1"},
        {"space bar", "pause or resume time"},
        {"1 to 9; with Ctrl", "restore a snapshot; store one", "Scene and window"},
        {"Ctrl S; with Shift", "save the values to the scene; save as another scene"},
        {"Ctrl O", "open another scene"},
        {"F5", "reload the files"},
        {"H", "hide or show everything but the picture"},
        {"F11", "full screen"},
        {"A", "show or close Accuracy (scenes with ladders)"},
        {"Ctrl +, Ctrl - and Ctrl 0", "larger, smaller, default text size"},
        {"F1", "show this list"},
        {"slider: double click or Ctrl click", "type a number", "Values"},
        {"slider: right click; Alt drag", "reset to the scene's value; fine adjustment"},
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

// How the table is laid out: columns of rows side by side, and in each the keys, beside or above what they do.
struct Table {
    int columns = 1;
    float keys = 0, what = 0;  // widths; the texts are wrapped in them
    bool beside = true;
    float height = 0;
};

float row_height(const KeyRow& row, const Table& table) {
    const float keys = ImGui::CalcTextSize(row.keys, nullptr, false, table.keys).y;
    const float what = ImGui::CalcTextSize(shown(row.what).c_str(), nullptr, false, table.what).y;
    return (table.beside ? std::max(keys, what) : keys + what) + ImGui::GetStyle().ItemSpacing.y;
}

// Height of the rows from `first` up to `last`; a heading is a row too.
float height_of(std::size_t first, std::size_t last, const Table& table) {
    float height = 0;
    for (std::size_t i = first; i < last; ++i)
        height += row_height(key_rows()[i], table) + (key_rows()[i].group ? ImGui::GetTextLineHeightWithSpacing() : 0);
    return height;
}

// The rows from which the second column begins, so that both are about as high.
std::size_t half(const Table& table) {
    const std::size_t all = key_rows().size();
    if (table.columns == 1) return all;
    std::size_t best = all;
    for (std::size_t i = 1; i < all; ++i) {
        const auto higher = [&](std::size_t at) {
            return std::max(height_of(0, at, table), height_of(at, all, table));
        };
        if (higher(i) < higher(best)) best = i;
    }
    return best;
}

Table table_of(int columns, bool beside, const ImVec2& room) {
    const float em = ImGui::GetFontSize();
    float keys = 0, what = 0;
    for (const KeyRow& row : key_rows()) {
        keys = std::max(keys, ImGui::CalcTextSize(row.keys).x);
        what = std::max(what, ImGui::CalcTextSize(shown(row.what).c_str()).x);
    }
    const float column = (room.x - static_cast<float>(columns - 1) * 2 * em) / static_cast<float>(columns);
    Table table{
        .columns = columns, .keys = std::min(keys, column), .what = std::min(what, column - em), .beside = beside};
    if (beside && keys + em + what > column) {
        table.keys = std::min(keys, column * .38F);
        table.what = column - em - table.keys;
    }
    const std::size_t split = half(table), all = key_rows().size();
    table.height = std::max(height_of(0, split, table), height_of(split, all, table));
    return table;
}

// The first layout that needs no scroll bar; otherwise the lowest.
Table fitting(const ImVec2& room) {
    Table best;
    for (const auto& [columns, beside] : {std::pair(1, true), {2, true}, {2, false}, {1, false}}) {
        const Table table = table_of(columns, beside, room);
        if (table.height <= room.y) return table;
        if (best.height == 0 || table.height < best.height) best = table;
    }
    return best;
}

void draw(const Table& table) {
    const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.y;
    const ImVec2 begin = ImGui::GetCursorPos();
    const std::size_t split = half(table);
    float x = begin.x, y = begin.y;
    for (std::size_t i = 0; i < key_rows().size(); ++i) {
        const KeyRow& row = key_rows()[i];
        if (i == split) {
            x += table.keys * (table.beside ? 1.0F : 0.0F) + table.what + 3 * em;
            y = begin.y;
        }
        if (row.group) {
            ImGui::SetCursorPos({x, y});
            ImGui::TextColored(palette().accent, "%s", row.group);
            y += ImGui::GetTextLineHeight() + gap;
        }
        const auto put = [&](const std::string& text, float left, float top, float width, bool dim) {
            ImGui::SetCursorPos({left, top});
            ImGui::PushTextWrapPos(left + width + 1);
            ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(dim ? ImGuiCol_TextDisabled : ImGuiCol_Text));
            ImGui::TextUnformatted(text.c_str());
            ImGui::PopStyleColor();
            ImGui::PopTextWrapPos();
        };
        const float keys = ImGui::CalcTextSize(row.keys, nullptr, false, table.keys).y;
        put(row.keys, x, y, table.keys, true);
        if (table.beside)
            put(shown(row.what), x + table.keys + em, y, table.what, false);
        else
            put(shown(row.what), x + em, y + keys, table.what, false);
        y += row_height(row, table);
    }
}

}  // namespace

bool help_panel(Layout& layout) {
    bool closed = false;
    const float em = ImGui::GetFontSize();
    const ImVec2 all = ImGui::GetIO().DisplaySize, margin(std::round(em), std::round(em * .8F));
    ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, 0, {.5F, .5F});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {std::max(em, all.x - em), std::max(em, all.y - em)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, margin);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, std::round(em * .2F)});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("Keys", nullptr, flags)) {
        closed = button("Close", layout, "close keys");
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("F1");
        const ImVec2 room(all.x - em - 2 * margin.x, all.y - em - 2 * margin.y - ImGui::GetCursorPosY() + margin.y);
        const Table table = fitting(room);
        draw(table.height <= room.y ? table : fitting({room.x - ImGui::GetStyle().ScrollbarSize, room.y}));
        layout.place_window("keys");
        if (ImGui::GetScrollMaxY() > 0) layout.place("keys.scrolls", {});
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
    return closed;
}

}  // namespace snell::ui
