#include "src/ui/panels/browser.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "parser/text/utf8.h"
#include "parser/text/words.h"
#include "src/ui/kit/input.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

constexpr const char* title = "Open a scene";

bool contains(std::string_view text, std::string_view part) {
    return std::search(text.begin(), text.end(), part.begin(), part.end(),
                       [](char a, char b) { return lower(a) == lower(b); }) != text.end();
}

bool is_path(std::string_view typed) {
    return typed.find('/') != std::string_view::npos || typed.starts_with('~') || typed == "..";
}

void close(Browser& browser) {
    browser.open = false;
    ImGui::CloseCurrentPopup();
}

// Draws the folder's path as clickable parts; a long path shows only its last parts.
void path_row(const Listing& listing, Memory& memory, Requests& requests, Layout& layout) {
    const std::vector<Crumb> all = crumbs(listing.folder);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x * .5F;
    float room = ImGui::GetContentRegionAvail().x - button_width("\u2026") - gap;
    std::size_t first = all.size();
    while (first > 0) {
        const float width = button_width(all[first - 1].name) + gap;
        if (width > room && first < all.size()) break;
        room -= width;
        --first;
    }
    if (first > 0) {
        if (ImGui::Button("\u2026")) open_browser(all[first - 1].path, memory, requests);
        ImGui::SameLine(0, gap);
    }
    for (std::size_t i = first; i < all.size(); ++i) {
        if (i > first) ImGui::SameLine(0, gap);
        ImGui::PushID(static_cast<int>(i));
        const Text name = shortened(all[i].name, ImGui::GetContentRegionAvail().x - button_width(""));
        if (button(name.c_str(), layout, "browser.folder." + all[i].name)) open_browser(all[i].path, memory, requests);
        ImGui::PopID();
    }
}

void places(const Facts& facts, const Listing& listing, Memory& memory, Requests& requests, Layout& layout) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::TextDisabled("Places");
    if (ImGui::Selectable("Home")) open_browser(listing.home, memory, requests);
    layout.note("browser.home");
    if (facts.recent.empty()) return;
    ImGui::Spacing();
    ImGui::TextDisabled("Recent");
    for (std::size_t i = 0; i < facts.recent.size(); ++i) {
        const std::string& path = facts.recent[i];
        const std::string name = utf8::printable(path.substr(path.rfind('/') + 1));
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(shortened(name, width).c_str())) {
            requests.open = path;
            close(memory.browser);
        }
        tip(utf8::printable(path));
        layout.note("browser.recent", name);
        ImGui::PopID();
    }
}

void take(const Entry& entry, Memory& memory, Requests& requests) {
    if (entry.folder) return open_browser(entry.path, memory, requests);
    requests.open = entry.path;
    close(memory.browser);
}

void entry_row(const Entry& entry, bool chosen, bool columns, float date_width, float size_width) {
    const ImVec2 at = ImGui::GetItemRectMin();
    const float right = ImGui::GetItemRectMax().x, pad = ImGui::GetStyle().FramePadding.x;
    const float top = at.y + ImGui::GetStyle().ItemSpacing.y * .5F, mark = ImGui::GetFontSize() * 1.2F;
    const float end = columns ? right - date_width - size_width - 2 * pad : right;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text), dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    if (entry.folder) list.AddText({at.x + pad, top}, chosen ? text : dim, "\u25B8");
    list.AddText({at.x + pad + mark, top}, text, shortened(entry.name, end - at.x - pad - mark).c_str());
    if (!columns) return;
    const float size = ImGui::CalcTextSize(entry.size.c_str()).x;
    list.AddText({end + size_width - size, top}, dim, entry.size.c_str());
    list.AddText({right - date_width + pad, top}, dim, entry.date.c_str());
}

void entries(const Listing& listing, const std::vector<std::size_t>& shown, Memory& memory, Requests& requests,
             Layout& layout) {
    Browser& browser = memory.browser;
    if (!listing.error.empty()) {
        wrapped(listing.error);
        return;
    }
    if (shown.empty())
        ImGui::TextDisabled(listing.entries.empty() ? "there are no scenes or folders here" : "no matching names");
    const float em = ImGui::GetFontSize(), date_width = ImGui::CalcTextSize("2000-00-00 00:00").x + em,
                size_width = ImGui::CalcTextSize("9999.9 MB").x;
    const bool columns = ImGui::GetContentRegionAvail().x > date_width + size_width + 10 * em;
    const float height = ImGui::GetTextLineHeightWithSpacing();
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Entry& entry = listing.entries[shown[i]];
        ImGui::PushID(static_cast<int>(shown[i]));
        const bool chosen = i == browser.chosen;
        const bool clicked = ImGui::Selectable(
            "##entry", chosen, ImGuiSelectableFlags_DontClosePopups | ImGuiSelectableFlags_AllowDoubleClick,
            {0, height - ImGui::GetStyle().ItemSpacing.y});
        layout.note("browser.entry", entry.name);
        if (ImGui::IsItemVisible()) entry_row(entry, chosen, columns, date_width, size_width);
        if (width_of(entry.name) > 20 * em) tip(entry.name);
        if (chosen && (pressed(Key::up, true) || pressed(Key::down, true))) ImGui::SetScrollHereY();
        ImGui::PopID();
        if (clicked) {
            browser.chosen = i;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return take(entry, memory, requests);
        }
    }
}

void choose_by_keys(Browser& browser, std::size_t count) {
    if (pressed(Key::down, true)) ++browser.chosen;
    if (pressed(Key::up, true) && browser.chosen > 0) --browser.chosen;
    browser.chosen = std::min(browser.chosen, count > 0 ? count - 1 : 0);
}

// Draws the name field and the buttons.
void answer_row(const Listing& listing, const std::vector<std::size_t>& shown, Memory& memory, Requests& requests,
                Layout& layout) {
    Browser& browser = memory.browser;
    const bool empty = browser.typed[0] == '\0';
    if (empty && pressed(Key::backspace, true) && !browser.focus) {
        const std::vector<Crumb> all = crumbs(listing.folder);
        if (all.size() > 1) return open_browser(all[all.size() - 2].path, memory, requests);
    }
    if (browser.focus) ImGui::SetKeyboardFocusHere();
    browser.focus = false;
    ImGui::SetNextItemWidth(-FLT_MIN);
    bool go = ImGui::InputTextWithHint("##name", "name or path", browser.typed.data(), browser.typed.size(),
                                       ImGuiInputTextFlags_EnterReturnsTrue);
    layout.note("browser.name");
    if (ImGui::IsItemEdited()) browser.chosen = 0;
    if (ImGui::Checkbox("All files", &browser.all)) open_browser(listing.folder, memory, requests);
    layout.note("browser.all");
    const float buttons = button_width("Cancel") + button_width("Open") + ImGui::GetStyle().ItemSpacing.x;
    follow(buttons);
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - buttons));
    if (button("Cancel", layout, "browser.cancel") || pressed(Key::escape)) return close(browser);
    ImGui::SameLine();
    const std::string_view typed(browser.typed.data());
    ImGui::BeginDisabled(shown.empty() && !is_path(typed));
    go |= button("Open", layout, "browser.open");
    ImGui::EndDisabled();
    go |= (pressed(Key::enter) || pressed(Key::keypad_enter)) && !ImGui::IsAnyItemActive();
    if (!go) return;
    if (is_path(typed)) {
        requests.open = typed;
        if (!requests.open.starts_with('/') && !requests.open.starts_with('~'))
            requests.open = listing.folder + "/" + requests.open;
        return close(browser);
    }
    if (browser.chosen < shown.size())
        take(listing.entries[shown[browser.chosen]], memory, requests);
    else
        browser.focus = true;
}

}  // namespace

void open_browser(std::string folder, Memory& memory, Requests& requests) {
    memory.browser.open = true;
    memory.browser.folder = std::move(folder);
    memory.browser.typed.fill('\0');
    memory.browser.chosen = 0;
    memory.browser.focus = true;
    requests.browse = true;
}

std::vector<std::size_t> matching(const Listing& listing, std::string_view typed) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < listing.entries.size(); ++i)
        if (is_path(typed) || contains(listing.entries[i].name, typed)) shown.push_back(i);
    return shown;
}

std::vector<Crumb> crumbs(std::string_view folder) {
    std::vector<Crumb> found;
    if (folder.starts_with('/')) found.push_back({"/", "/"});
    for (std::size_t begin = 0; begin < folder.size();) {
        const std::size_t end = std::min(folder.find('/', begin), folder.size());
        if (end > begin)
            found.push_back({utf8::printable(folder.substr(begin, end - begin)), std::string(folder.substr(0, end))});
        begin = end + 1;
    }
    return found;
}

void browser_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    Browser& browser = memory.browser;
    if (!browser.open || !facts.listing) return;
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const ImVec2 size(std::min(48 * em, all.x - em), std::min(34 * em, all.y - em));
    ImGui::SetNextWindowPos({std::round((all.x - size.x) / 2), std::round((all.y - size.y) / 2)});
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal(title, nullptr,
                                ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar))
        return;
    const Listing& listing = *facts.listing;
    path_row(listing, memory, requests, layout);
    const std::vector<std::size_t> shown = matching(listing, browser.typed.data());
    choose_by_keys(browser, shown.size());
    const bool two_rows =
        check_box_width("All files") + button_width("Cancel") + button_width("Open") + 2 * em > size.x - 2 * em;
    const float below = ImGui::GetFrameHeightWithSpacing() * (two_rows ? 3 : 2);
    const float side = size.x > 30 * em ? 11 * em : 0;
    ImGui::BeginChild("##places", {std::max(side, 1.0F), -below});
    if (side > 0) places(facts, listing, memory, requests, layout);
    ImGui::EndChild();
    if (side > 0)
        ImGui::SameLine();
    else
        ImGui::SameLine(0, 0);
    ImGui::BeginChild("##entries", {0, -below});
    entries(listing, shown, memory, requests, layout);
    ImGui::EndChild();
    answer_row(listing, shown, memory, requests, layout);
    ImGui::EndPopup();
}

}  // namespace snell::ui
