#include "src/ui/panels/browser.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/ui/kit/input.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

constexpr const char* title = "Open a scene";

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

// A recent scene as its picture, its name and its folder.
bool recent_row(const RecentScene& scene, float width) {
    const float em = ImGui::GetFontSize(), pad = ImGui::GetStyle().FramePadding.x;
    const ImVec2 picture(4 * em, 3 * em), at = ImGui::GetCursorScreenPos();
    const bool chosen = ImGui::Selectable("##recent", false, 0, {0, picture.y});
    if (!ImGui::IsItemVisible()) return chosen;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(at.x + picture.x, at.y + picture.y);
    list.AddRectFilled(at, end, ImGui::GetColorU32(ImGuiCol_FrameBg));
    if (scene.picture != 0) {
        const ImVec2 size(std::min(picture.x, picture.y * scene.shape), std::min(picture.y, picture.x / scene.shape));
        const ImVec2 from(at.x + (picture.x - size.x) / 2, at.y + (picture.y - size.y) / 2);
        list.AddImage(reinterpret_cast<ImTextureID>(scene.picture), from, {from.x + size.x, from.y + size.y});
    }
    const float left = end.x + pad, room = width - picture.x - pad, line = ImGui::GetTextLineHeightWithSpacing();
    const float top = at.y + (picture.y - 2 * line) * .5F;
    list.AddText({left, top}, ImGui::GetColorU32(ImGuiCol_Text), shortened(scene.name, room).c_str());
    list.AddText({left, top + line}, ImGui::GetColorU32(ImGuiCol_TextDisabled), shortened(scene.folder, room).c_str());
    return chosen;
}

void recent_scenes(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    if (facts.recent.empty()) return;
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::TextDisabled("Recent");
    for (std::size_t i = 0; i < facts.recent.size(); ++i) {
        const RecentScene& scene = facts.recent[i];
        ImGui::PushID(static_cast<int>(i));
        if (recent_row(scene, width)) {
            requests.open = scene.path;
            close(memory.browser);
        }
        tip(scene.path);
        layout.note("browser.recent", scene.name);
        ImGui::PopID();
    }
    ImGui::Spacing();
}

void places(const Facts& facts, const Listing& listing, Memory& memory, Requests& requests, Layout& layout) {
    recent_scenes(facts, memory, requests, layout);
    ImGui::TextDisabled("Places");
    if (ImGui::Selectable("Home")) open_browser(listing.home, memory, requests);
    layout.note("browser.home");
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
    const float end = columns ? right - date_width - size_width - 2 * pad : right - pad;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text), dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    if (entry.folder) list.AddText({at.x + pad, top}, chosen ? text : dim, "\u25B8");
    list.AddText({at.x + pad + mark, top}, text, shortened(entry.name, end - at.x - pad - mark).c_str());
    if (!columns) return;
    const float size = ImGui::CalcTextSize(entry.size.c_str()).x;
    list.AddText({end + size_width - size, top}, dim, entry.size.c_str());
    list.AddText({right - date_width + pad, top}, dim, entry.date.c_str());
}

void entries(const Listing& listing, const std::vector<std::size_t>& shown, bool came, Memory& memory,
             Requests& requests, Layout& layout) {
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
        if (chosen && (came || pressed(Key::up, true) || pressed(Key::down, true))) ImGui::SetScrollHereY();
        ImGui::PopID();
        if (clicked) {
            browser.chosen = i;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return take(entry, memory, requests);
        }
    }
}

// In a folder above the one that was listed before, chooses what leads back there. Returns true if it did.
bool choose_origin(const Listing& listing, Browser& browser) {
    if (browser.listed == listing.folder) return false;
    const std::string before = std::exchange(browser.listed, listing.folder) + "/";
    const auto leads_there = [&](const Entry& entry) { return before.starts_with(entry.path + "/"); };
    const auto origin = ranges::find_if(listing.entries, leads_there);
    if (origin == listing.entries.end()) return false;
    browser.chosen = static_cast<std::size_t>(origin - listing.entries.begin());
    return true;
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
    to_right(buttons);
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
    const bool came = choose_origin(listing, browser);
    const std::vector<std::size_t> shown = matching(listing, browser.typed.data());
    choose_by_keys(browser, shown.size());
    const bool two_rows =
        check_box_width("All files") + button_width("Cancel") + button_width("Open") + 2 * em > size.x - 2 * em;
    const float below = ImGui::GetFrameHeightWithSpacing() * (two_rows ? 3 : 2);
    const float side = size.x > 30 * em ? std::min(17 * em, size.x * .4F) : 0;
    ImGui::BeginChild("##places", {std::max(side, 1.0F), -below});
    if (side > 0) places(facts, listing, memory, requests, layout);
    ImGui::EndChild();
    if (side > 0)
        ImGui::SameLine();
    else
        ImGui::SameLine(0, 0);
    ImGui::BeginChild("##entries", {0, -below});
    if (side == 0 && !facts.scene) recent_scenes(facts, memory, requests, layout);
    entries(listing, shown, came, memory, requests, layout);
    ImGui::EndChild();
    answer_row(listing, shown, memory, requests, layout);
    ImGui::EndPopup();
}

}  // namespace snell::ui
