#include "src/ui/shell.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

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
        {"Esc", "show the scene again after a found rung; deselect the picked object; end picking; leave full screen"},
        {"hold I", "magnify the pixel or texel under the pointer and show its values"},
        {"N", "mark pixels and texels that are NaN, infinite or outside of 0 to 1"},
        {"space bar", "pause or resume time"},
        {"1 to 9; with Ctrl", "restore a snapshot of the values; store one", "Scene and window"},
        {"Ctrl S; with Shift", "save the values to the scene; save as another scene"},
        {"Ctrl Z; Ctrl Y or Ctrl Shift Z", "undo; redo"},
        {"Ctrl O", "open another scene"},
        {"F5", "reload the files"},
        {"H", "hide or show everything but the picture"},
        {"F11", "full screen"},
        {"A", "show or close Accuracy"},
        {"S", "show two states side by side, or one picture"},
        {"Ctrl +, Ctrl - and Ctrl 0", "larger, smaller, default text size"},
        {"F1", "show this list"},
        {"Tab; with Shift", "go to the next value, button, row or field; to the previous one", "Values"},
        {"arrow keys; with Shift; Page keys", "change that value: in steps; fine; coarse"},
        {"Enter; Esc", "type that value, switch or press it; restore the old one"},
        {"Menu key or Shift F10", "open that value's menu: reset, logarithmic scale, animation"},
        {"right click on a value's name", "open the same menu"},
        {"Esc while dragging", "restore what was before the drag"},
        {"slider: double click or Ctrl click", "type a number"},
        {"slider: right click; Shift or Alt drag", "reset to the scene's value; fine adjustment"},
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

// How the table is laid out: columns of rows side by side, and in each the keys beside what they do.
struct Table {
    float keys = 0, what = 0;  // widths; the texts are wrapped in them
    std::vector<float> rows;   // heights, with that of the heading above
    std::size_t second = 0;    // the row that the second column begins with; the number of rows if there is one column
    float height = 0;
};

float gap_between_rows() { return std::round(ImGui::GetFontSize() * .2F); }

float heading(const KeyRow& row) { return row.group ? ImGui::GetTextLineHeight() + gap_between_rows() : 0; }

Table table_of(std::size_t columns, float keys, float what) {
    Table table{.keys = keys, .what = what};
    float all = 0;
    for (const KeyRow& row : key_rows()) {
        const float height = std::max(ImGui::CalcTextSize(row.keys, nullptr, false, keys).y,
                                      ImGui::CalcTextSize(shown(row.what).c_str(), nullptr, false, what).y);
        all += table.rows.emplace_back(heading(row) + height + gap_between_rows());
    }
    table.second = table.rows.size();
    table.height = all;
    float first = 0;
    for (std::size_t i = 0; columns == 2 && i < table.rows.size(); ++i) {
        if (std::max(first, all - first) < table.height) {
            table.height = std::max(first, all - first);
            table.second = i;
        }
        first += table.rows[i];
    }
    return table;
}

// The first layout that needs no scroll bar, otherwise the lowest. Texts are wrapped where they must be.
Table fitting(const ImVec2& room) {
    const float em = ImGui::GetFontSize();
    float keys = 0, what = 0;
    for (const KeyRow& row : key_rows()) {
        keys = std::max(keys, ImGui::CalcTextSize(row.keys).x);
        what = std::max(what, ImGui::CalcTextSize(shown(row.what).c_str()).x);
    }
    Table best;
    for (const std::size_t columns : {1, 2}) {
        const float column = columns == 1 ? room.x : (room.x - 2 * em) / 2;
        const bool whole = keys + em + what <= column;
        for (const float share : {.44F, .38F, .32F, .26F}) {
            Table table = whole ? table_of(columns, keys, what)
                                : table_of(columns, std::min(keys, column * share), column * (1 - share) - em);
            if (best.rows.empty() || table.height < best.height) best = std::move(table);
            if (whole) break;
        }
        if (best.height <= room.y) break;
    }
    return best;
}

void put(const char* text, const ImVec2& at, float width, const ImVec4& color) {
    ImGui::SetCursorPos(at);
    ImGui::PushTextWrapPos(at.x + width + 1);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
}

void draw(const Table& table) {
    const float em = ImGui::GetFontSize();
    const ImVec2 begin = ImGui::GetCursorPos();
    const ImVec4 &text = palette().text, &dim = palette().dim;
    ImVec2 at = begin;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const KeyRow& row = key_rows()[i];
        if (i == table.second) at = {begin.x + table.keys + table.what + 3 * em, begin.y};
        if (row.group) put(row.group, at, table.keys + table.what, palette().accent);
        const float y = at.y + heading(row);
        put(row.keys, {at.x, y}, table.keys, dim);
        put(shown(row.what).c_str(), {at.x + table.keys + em, y}, table.what, text);
        at.y += table.rows[i];
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
    ImGui::PopStyleVar(2);
    return closed;
}

}  // namespace snell::ui
