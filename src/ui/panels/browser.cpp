#include "src/ui/panels/browser.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/plan/locate.h"
#include "src/ui/kit/field.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/style.h"
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
        if (or_keys(ImGui::Button("\u2026"))) open_browser(all[first - 1].path, memory, requests);
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

void draw_picture(const SmallPicture& picture, ImVec2 at, ImVec2 room) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(at.x + room.x, at.y + room.y);
    list.AddRectFilled(at, end, ImGui::GetColorU32(ImGuiCol_FrameBg));
    if (picture.texture == 0) {
        list.AddRect(at, end, ImGui::GetColorU32(ImGuiCol_Border));
        const std::string_view none = picture_words(picture, room.x);
        const ImVec2 middle((at.x + end.x - width_of(none)) / 2, (at.y + end.y - ImGui::GetTextLineHeight()) / 2);
        const ImU32 color =
            picture.why.empty() ? ImGui::GetColorU32(ImGuiCol_TextDisabled) : ImGui::GetColorU32(palette().error_text);
        return list.AddText(middle, color, none.data(), none.data() + none.size());
    }
    const ImVec2 size(std::min(room.x, room.y * picture.shape), std::min(room.y, room.x / picture.shape));
    const ImVec2 from(at.x + (room.x - size.x) / 2, at.y + (room.y - size.y) / 2);
    list.AddImage(reinterpret_cast<ImTextureID>(picture.texture), from, {from.x + size.x, from.y + size.y});
}

struct Card {
    std::string_view title, below;
    const SmallPicture* picture;  // null: it has none
    int lines = 1;                // of the text below the title
};

float card_pad() { return ImGui::GetFontSize() * .4F; }
float card_width() {
    return std::max(std::min(10 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x), 3 * ImGui::GetFontSize());
}

// The lines that a text below a card's title needs.
int lines_of(std::string_view text) {
    const float room = card_width() - 2 * card_pad();
    const float height = ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, room).y;
    return static_cast<int>(std::lround(height / ImGui::GetTextLineHeight()));
}

// A card in a grid that fills the width. Returns true if it was chosen.
bool card(const Card& shown, bool first) {
    const float em = ImGui::GetFontSize(), pad = card_pad(), line = ImGui::GetTextLineHeight(), width = card_width();
    const float above = shown.picture ? .75F * (width - 2 * pad) + pad * .5F : 0;
    const ImVec2 size(width, above + line * static_cast<float>(1 + shown.lines) + 2 * pad);
    if (!first) follow(width, pad);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool chosen = selectable("##card", false, 0, size);
    if (!ImGui::IsItemVisible()) return chosen;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (shown.picture)
        draw_picture(*shown.picture, {at.x + pad, at.y + pad}, {width - 2 * pad, .75F * (width - 2 * pad)});
    else
        list.AddRect(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_Border),
                     ImGui::GetStyle().FrameRounding);
    const float top = at.y + pad + above, room = width - 2 * pad;
    list.AddText({at.x + pad, top}, ImGui::GetColorU32(ImGuiCol_Text), shortened(shown.title, room).c_str());
    const ImVec4 clip(at.x, at.y, at.x + size.x - pad, top + line * static_cast<float>(1 + shown.lines));
    const Text below = shown.lines > 1 ? Text(shown.below) : shortened(shown.below, room);
    list.AddText(ImGui::GetFont(), em, {at.x + pad, top + line}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                 below.begin(), below.end(), shown.lines > 1 ? room : 0, &clip);
    return chosen;
}

// Scenes as pictures, below a heading. Those whose names do not contain what is typed are left out.
void cards(const std::string& heading, const char* name, std::span<const SceneCard> scenes, Memory& memory,
           Requests& requests, Layout& layout) {
    bool first = true;
    ImGui::PushID(name);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const SceneCard& scene = scenes[i];
        const std::string_view typed = memory.browser.typed.data();
        if (!is_path(typed) && !contains(scene.name, typed)) continue;
        if (first) {
            fitted(heading, ImGui::GetContentRegionAvail().x, true);
            layout.note(name);
        }
        ImGui::PushID(static_cast<int>(i));
        if (card({scene.name, scene.folder, &scene.picture, scene.folder.empty() ? 0 : 1}, first)) {
            requests.open = scene.path;
            close(memory.browser);
        }
        first = false;
        if (scene.picture.why.empty())
            tip(scene.path);
        else
            tip(Text("{}\nNo picture: {}", scene.path, scene.picture.why).view());
        layout.note(name, scene.name);
        ImGui::PopID();
    }
    ImGui::PopID();
    if (!first) ImGui::Spacing();
}

void new_scenes(const Facts& facts, Memory& memory, Layout& layout) {
    if (facts.kinds.empty() || memory.browser.typed[0] != '\0') return;
    ImGui::TextDisabled("New scene");
    layout.note("browser.new scenes");
    if (std::exchange(memory.browser.to_new, false)) ImGui::SetScrollHereY(0);
    int lines = 1;
    for (const NewKind& kind : facts.kinds) lines = std::max(lines, lines_of(kind.summary));
    for (std::size_t i = 0; i < facts.kinds.size(); ++i) {
        const NewKind& kind = facts.kinds[i];
        ImGui::PushID(static_cast<int>(i));
        if (card({kind.name, kind.summary, nullptr, lines}, i == 0)) {
            memory.browser.kind = kind.name;
            open_save_as(memory.new_scene, memory.browser.kind, std::string(facts.new_folder));
        }
        tip(kind.summary);
        layout.note("browser.new", kind.name);
        ImGui::PopID();
    }
    ImGui::Spacing();
}

// The scenes of the listed folder: at first that of the open scene.
std::vector<SceneCard> scenes_in(const Listing& listing) {
    std::vector<SceneCard> scenes;
    for (const Entry& entry : listing.entries)
        if (!entry.folder && has_extension(entry.path, "glib"))
            scenes.push_back({entry.name, "", entry.path, entry.picture});
    return scenes;
}

// The first scene of the start page whose name contains the text, if there is one.
std::optional<SceneCard> first_card(const Facts& facts, const Listing& listing, std::string_view typed) {
    if (typed.empty()) return std::nullopt;
    const std::vector<SceneCard> beside = scenes_in(listing);
    for (const std::span<const SceneCard> scenes :
         {facts.recent, std::span(beside), facts.examples.scenes, facts.examples.lessons})
        for (const SceneCard& scene : scenes)
            if (contains(scene.name, typed)) return scene;
    return std::nullopt;
}

// A row of the recent scenes, so that those of the folder are in sight; all where one is sought.
std::span<const SceneCard> one_row(std::span<const SceneCard> scenes, const Browser& browser) {
    const float room = ImGui::GetContentRegionAvail().x, width = card_width(), gap = card_pad();
    const auto most = static_cast<std::size_t>(std::max(1.0F, std::floor((room + gap) / (width + gap))));
    return browser.typed[0] != '\0' ? scenes : scenes.first(std::min(most, scenes.size()));
}

void start_page(const Facts& facts, const Listing& listing, Memory& memory, Requests& requests, Layout& layout) {
    cards("Recent", "browser.recent", one_row(facts.recent, memory.browser), memory, requests, layout);
    cards("In the folder " + std::string(facts.new_folder), "browser.beside", scenes_in(listing), memory, requests,
          layout);
    new_scenes(facts, memory, layout);
    cards("Scenes", "browser.scene", facts.examples.scenes, memory, requests, layout);
    cards("Lessons", "browser.lesson", facts.examples.lessons, memory, requests, layout);
    const std::string_view typed = memory.browser.typed.data();
    if (is_path(typed)) {
        wrapped("Enter opens this path: a scene, or a folder.", true);
        layout.note("browser.path");
    }
    if (typed.empty() || is_path(typed) || first_card(facts, listing, typed)) return;
    wrapped("No scene here has this in its name. Folders (Ctrl+Tab) has other folders; a path opens any scene.", true);
    layout.note("browser.none");
}

void places(const Facts& facts, const Listing& listing, Memory& memory, Requests& requests, Layout& layout) {
    ImGui::TextDisabled("Places");
    if (selectable("Home")) open_browser(listing.home, memory, requests);
    layout.note("browser.home");
    ImGui::Spacing();
    cards("Recent", "browser.recent", facts.recent, memory, requests, layout);
}

void take(const Entry& entry, Memory& memory, Requests& requests) {
    if (entry.folder) return open_browser(entry.path, memory, requests);
    requests.open = entry.path;
    close(memory.browser);
}

// Of a row's picture.
ImVec2 picture_size() {
    const float height = std::round(2 * ImGui::GetFontSize());
    return {std::round(height * 4 / 3), height};
}

void entry_row(const Entry& entry, bool chosen, bool columns, float date_width, float size_width, Layout& layout) {
    const ImVec2 at = ImGui::GetItemRectMin();
    const float right = ImGui::GetItemRectMax().x, pad = ImGui::GetStyle().FramePadding.x;
    const float mark = picture_size().x + pad;
    const float top = at.y + (ImGui::GetItemRectSize().y - ImGui::GetTextLineHeight()) * .5F;
    const float end = columns ? right - date_width - size_width - 2 * pad : right - pad;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (!entry.folder) {
        // The row reaches into the gaps above and below it.
        const ImVec2 size = picture_size(), corner(at.x + pad, at.y + (ImGui::GetItemRectSize().y - size.y) * .5F);
        draw_picture(entry.picture, corner, size);
        layout.place("browser.picture", {corner.x, corner.y, size.x, size.y});
    }
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
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Entry& entry = listing.entries[shown[i]];
        ImGui::PushID(static_cast<int>(shown[i]));
        const bool chosen = i == browser.chosen;
        const bool clicked = ImGui::Selectable(
            "##entry", chosen, ImGuiSelectableFlags_DontClosePopups | ImGuiSelectableFlags_AllowDoubleClick,
            {0, entry.folder ? ImGui::GetTextLineHeight() : picture_size().y});
        const bool keys = or_keys(false);
        layout.note("browser.entry", entry.name);
        if (ImGui::IsItemVisible()) entry_row(entry, chosen, columns, date_width, size_width, layout);
        if (!entry.picture.why.empty())
            tip(Text("{}\nNo picture: {}", entry.name, entry.picture.why).view());
        else if (width_of(entry.name) > 20 * em)
            tip(entry.name);
        if (chosen && (came || pressed(Key::up, true) || pressed(Key::down, true))) ImGui::SetScrollHereY();
        ImGui::PopID();
        if (clicked) {
            browser.chosen = i;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return take(entry, memory, requests);
        }
        if (keys) return take(entry, memory, requests);
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

// Lists the folder as the browser is now; what is typed stays.
void list_again(const Listing& listing, Browser& browser, Requests& requests) {
    browser.start = false;
    browser.folder = listing.folder;
    browser.chosen = 0;
    browser.focus = requests.browse = true;
}

// Why the typed path could not be opened, until another is typed.
void refusal(Browser& browser, Layout& layout) {
    if (ImGui::IsItemEdited()) browser.error.clear();
    if (browser.error.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, palette().error_text);
    fitted(browser.error, ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleColor();
    tip(browser.error);
    layout.note("browser.error");
}

// Draws the name field and the buttons.
void answer_row(const Facts& facts, const Listing& listing, const std::vector<std::size_t>& shown, Memory& memory,
                Requests& requests, Layout& layout) {
    Browser& browser = memory.browser;
    const bool empty = browser.typed[0] == '\0';
    if (empty && !browser.start && pressed(Key::backspace, true) && !browser.focus) {
        const std::vector<Crumb> all = crumbs(listing.folder);
        if (all.size() > 1) return open_browser(all[all.size() - 2].path, memory, requests);
    }
    if (browser.focus) ImGui::SetKeyboardFocusHere();
    browser.focus = false;
    ImGui::SetNextItemWidth(-FLT_MIN);
    bool go = text_field("##name", "name or path", browser.typed, ImGuiInputTextFlags_EnterReturnsTrue);
    layout.note("browser.name");
    if (ImGui::IsItemEdited()) browser.chosen = 0;
    refusal(browser, layout);
    const float buttons = button_width("Cancel") + button_width("Open") + ImGui::GetStyle().ItemSpacing.x;
    if (browser.start && !facts.kinds.empty()) {
        if (button("New scene", layout, "browser.to new")) {
            browser.typed.fill('\0');
            browser.error.clear();
            browser.to_new = true;
        }
        follow(buttons);
    }
    if (!browser.start) {
        if (switch_box("All files", browser.all)) list_again(listing, browser, requests);
        layout.note("browser.all");
        follow(buttons);
    }
    to_right(buttons);
    if (button("Cancel", layout, "browser.cancel") || pressed(Key::escape)) return close(browser);
    ImGui::SameLine();
    const std::string_view typed(browser.typed.data());
    const std::optional<SceneCard> first =
        browser.start && !is_path(typed) ? first_card(facts, listing, typed) : std::nullopt;
    ImGui::BeginDisabled(browser.start ? !first && !is_path(typed) : shown.empty() && !is_path(typed));
    go |= button("Open", layout, "browser.open");
    ImGui::EndDisabled();
    go |= (pressed(Key::enter) || pressed(Key::keypad_enter)) && !ImGui::IsAnyItemActive();
    if (!go) return;
    if (is_path(typed)) {
        requests.open = typed;
        if (!requests.open.starts_with('/') && !requests.open.starts_with('~'))
            requests.open = listing.folder + "/" + requests.open;
        browser.asked = true;
        return close(browser);
    }
    if (browser.start) {
        if (first) requests.open = first->path;
        if (first) close(browser);
        browser.focus = !first;
    } else if (browser.chosen < shown.size())
        take(listing.entries[shown[browser.chosen]], memory, requests);
    else
        browser.focus = true;
}

// The two pages as tabs; Ctrl+Tab goes to the other one.
void pages(const Listing& listing, Memory& memory, Requests& requests, Layout& layout) {
    const bool keys = ImGui::GetIO().KeyCtrl && pressed(Key::tab);
    const bool start = tabs({{{"Scenes", "browser.start"}, {"Folders", "browser.folders"}}},
                            memory.browser.start != keys ? 0 : 1, layout) == 0;
    if (memory.browser.start && !start) list_again(listing, memory.browser, requests);
    memory.browser.start = start;
}

}  // namespace

void open_browser(std::string folder, Memory& memory, Requests& requests) {
    memory.browser.open = true;
    memory.browser.start = folder.empty();
    memory.browser.folder = std::move(folder);
    memory.browser.typed.fill('\0');
    memory.browser.chosen = 0;
    memory.browser.focus = true;
    memory.browser.asked = false;
    memory.browser.error.clear();
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

// Of what has none, the tooltip says why.
std::string_view picture_words(const SmallPicture& picture, float room) {
    if (picture.texture != 0) return "";
    const std::string_view words = picture.why.empty() ? "being drawn\u2026" : "no picture";
    if (width_of(words) <= room) return words;
    return picture.why.empty() ? "\u2026" : "!";
}

void browser_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    Browser& browser = memory.browser;
    if (!browser.open || !facts.listing || memory.new_scene.open) return;
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const ImVec2 size(std::min(58 * em, all.x - em), std::min(42 * em, all.y - em));
    ImGui::SetNextWindowPos({std::round((all.x - size.x) / 2), std::round((all.y - size.y) / 2)});
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal(title, nullptr,
                                ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings))
        return;
    const Listing& listing = *facts.listing;
    pages(listing, memory, requests, layout);
    if (!browser.start) path_row(listing, memory, requests, layout);
    const bool came = choose_origin(listing, browser);
    const std::vector<std::size_t> shown = matching(listing, browser.typed.data());
    choose_by_keys(browser, shown.size());
    const bool two_rows = std::max(check_box_width("All files"), button_width("New scene")) + button_width("Cancel") +
                              button_width("Open") + 2 * em >
                          size.x - 2 * em;
    const float below = ImGui::GetFrameHeightWithSpacing() * (two_rows ? 3 : 2) +
                        (browser.error.empty() ? 0 : ImGui::GetTextLineHeightWithSpacing());
    // In the lowest windows all of it scrolls; the field for the name is seen first.
    const float room = ImGui::GetContentRegionAvail().y;
    const float height = std::max(room - below, std::min(7 * em, room - ImGui::GetFrameHeightWithSpacing()));
    const float side = !browser.start && size.x > 40 * em ? 11.5F * em : 0;
    if (side > 0) {
        ImGui::BeginChild("##places", {side, height});
        places(facts, listing, memory, requests, layout);
        ImGui::EndChild();
        ImGui::SameLine();
    }
    ImGui::BeginChild(browser.start ? "##start" : "##entries", {0, height});
    if (browser.start)
        start_page(facts, listing, memory, requests, layout);
    else
        entries(listing, shown, came, memory, requests, layout);
    ImGui::EndChild();
    answer_row(facts, listing, shown, memory, requests, layout);
    ImGui::EndPopup();
}

}  // namespace snell::ui
