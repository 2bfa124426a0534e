#include "src/ui/kit/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <utility>

#include "src/ui/kit/field.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/kit.h"

namespace snell::ui {

float width_of(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

float button_width(std::string_view label) { return width_of(label) + 2 * ImGui::GetStyle().FramePadding.x; }

float check_box_width(std::string_view label) {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + width_of(label);
}

void follow(float width, float gap) {
    const float before = gap < 0 ? ImGui::GetStyle().ItemSpacing.x : gap;
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + before + width <= end) ImGui::SameLine(0, gap);
}

bool has_room(const Rect& picture, float letters) { return picture.width >= letters * ImGui::GetFontSize(); }

Rect with_room(Rect picture) {
    if (!has_room(picture)) picture.width = ImGui::GetIO().DisplaySize.x - picture.x;
    return picture;
}

void to_right(float width) {
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - width));
}

namespace {

// Of the widget that has the focus.
bool pressing() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.KeyCtrl || io.KeyAlt) return false;
    for (const Key key : {Key::enter, Key::keypad_enter, Key::space}) {
        if (!pressed(key)) continue;
        take(key);
        return true;
    }
    return false;
}

}  // namespace

bool or_keys(bool clicked, unsigned id) {
    const ImRect box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    if (id == 0) id = ImGui::GetItemID();
    const bool focused = focusable(box, id, Focus::Kind::button);
    draw_focus(box, id);
    return (focused && pressing()) || clicked;
}

bool selectable(const char* text, bool chosen, int flags, const ImVec2& size) {
    const bool clicked = ImGui::Selectable(text, chosen, flags, size), pressed = or_keys(clicked);
    const bool popup = (ImGui::GetCurrentWindow()->Flags & ImGuiWindowFlags_Popup) != 0;
    if (pressed && !clicked && popup && (flags & ImGuiSelectableFlags_DontClosePopups) == 0) ImGui::CloseCurrentPopup();
    return pressed;
}

bool begin_popup(const char* name, bool above) {
    ImGuiStorage& sizes = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(name), width = id + 1, height = id + 2;
    const ImVec2 all = ImGui::GetIO().DisplaySize, from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const float wide = sizes.GetFloat(width), high = sizes.GetFloat(height);
    const float y = above ? from.y - ImGui::GetStyle().ItemSpacing.y - high : std::min(to.y, all.y - high);
    ImGui::SetNextWindowPos({std::max(0.0F, std::min(from.x, all.x - wide)), std::max(0.0F, y)});
    // Only where it must: Dear ImGui rounds what it limits, and scrolls what is less than a pixel too high.
    if (wide >= all.x || high >= all.y) ImGui::SetNextWindowSizeConstraints({0, 0}, all);
    const bool open = ImGui::BeginPopup(name);
    note_opener({from.x, from.y, to.x - from.x, to.y - from.y}, open);
    if (!open) return false;
    sizes.SetFloat(width, ImGui::GetWindowWidth());
    sizes.SetFloat(height, ImGui::GetWindowHeight());
    return true;
}

bool menu_item(const char* text, const char* keys, bool on, bool enabled) {
    const bool clicked = ImGui::MenuItem(text, keys, on, enabled), chosen = enabled ? or_keys(clicked) : clicked;
    if (chosen) ImGui::CloseCurrentPopup();
    return chosen;
}

bool button(const char* text, Layout& layout, std::string_view name) {
    const bool pressed = or_keys(ImGui::Button(text));
    layout.note(name);
    return pressed;
}

bool next_button(const char* text, Layout& layout, std::string_view name) {
    follow(button_width(text));
    return button(text, layout, name);
}

void label(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine();
}

namespace {

bool has_decimals(std::string_view text) {
    const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
        if (text[i] == '.' && digit(i - 1) && digit(i + 1)) return true;
    return false;
}

}  // namespace

std::string broken_at_blanks(std::string_view text, float width) {
    std::string lines(text);
    std::size_t begin = 0, blank = std::string::npos;
    for (std::size_t i = 0; i <= lines.size(); ++i) {
        if (i < lines.size() && lines[i] != ' ' && lines[i] != '\n') continue;
        if (blank != std::string::npos && width_of(std::string_view(lines).substr(begin, i - begin)) > width) {
            lines[blank] = '\n';
            begin = blank + 1;
        }
        blank = i;
        if (i < lines.size() && lines[i] == '\n') begin = i + 1;
        if (begin == i + 1) blank = std::string::npos;
    }
    return lines;
}

void wrapped(std::string_view text, bool dim) {
    const float width = ImGui::GetContentRegionAvail().x;
    std::string lines;
    if (width_of(text) > width && has_decimals(text)) text = lines = broken_at_blanks(text, width);
    ImGui::PushTextWrapPos(0);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(dim ? ImGuiCol_TextDisabled : ImGuiCol_Text));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
}

namespace {

// The bytes of the first or last `count` characters of the text.
std::size_t first_bytes(std::string_view text, std::size_t count) {
    std::size_t at = 0;
    while (at < text.size() && count-- > 0) do
            ++at;
        while (at < text.size() && (text[at] & 0xC0) == 0x80);
    return at;
}

std::size_t last_bytes(std::string_view text, std::size_t count) {
    std::size_t at = text.size();
    while (at > 0 && count-- > 0) do
            --at;
        while (at > 0 && (text[at] & 0xC0) == 0x80);
    return text.size() - at;
}

}  // namespace

Text shortened(std::string_view text, float width, bool at_end) {
    if (width_of(text) <= width) return Text(text);
    static constexpr std::string_view dots = "\u2026";
    const bool sentence = at_end || text.find(' ') != text.npos;
    const auto behind = [&](std::size_t kept) { return sentence ? 0 : kept / 2; };
    const auto head = [&](std::size_t kept) { return text.substr(0, first_bytes(text, kept - behind(kept))); };
    const auto tail = [&](std::size_t kept) { return text.substr(text.size() - last_bytes(text, behind(kept))); };
    const float room = width - width_of(dots);
    std::size_t least = 1, most = std::max<std::size_t>(text.size(), 1);
    while (least < most) {
        const std::size_t middle = (least + most + 1) / 2;
        if (width_of(head(middle)) + width_of(tail(middle)) <= room)
            least = middle;
        else
            most = middle - 1;
    }
    return std::move(Text(head(least)).append(dots).append(tail(least)));
}

bool fitted(std::string_view text, float width, bool dim) {
    const Text part = shortened(text, width);
    if (dim) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(part.begin(), part.end());
    if (dim) ImGui::PopStyleColor();
    if (part == text) return true;
    tip(text);
    return false;
}

bool header(const char* title, int flags) {
    const bool open = ImGui::CollapsingHeader(title, flags);
    return open != toggled_by_keys(open);
}

bool toggled_by_keys(bool open) {
    if (!or_keys(false)) return false;
    ImGui::GetStateStorage()->SetBool(ImGui::GetItemID(), !open);
    return true;
}

bool switch_box(const char* text, bool& on) {
    const std::string_view all(text), shown = all.substr(0, all.find("##"));
    const bool wraps = check_box_width(shown) > ImGui::GetContentRegionAvail().x + .5F;
    if (wraps) ImGui::BeginGroup();
    bool box = on;
    bool switched = or_keys(ImGui::Checkbox(wraps ? Text("##{}", all).c_str() : text, &box));
    if (wraps) {
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        wrapped(shown);
        switched |= ImGui::IsItemClicked();
        ImGui::EndGroup();
    }
    if (switched) on = !on;
    return switched;
}

bool section(const char* title, const char* about, Titles& open, Layout& layout, const char* name) {
    show_opened();
    const auto kept = open.find(std::string_view(title));
    ImGui::SetNextItemOpen(kept != open.end());
    const bool opened = header(title);
    tip(about);
    layout.note(name);
    keep_in_view(opened);
    if (opened && kept == open.end()) open.emplace(title);
    if (!opened && kept != open.end()) open.erase(kept);
    return opened;
}

namespace {

constexpr ImGuiID top_of_opened = 0x5EC71014;

}  // namespace

// The state is that of the window that scrolls: which header was opened, in how many more frames its contents may still
// grow, and where it is in this frame.
void keep_in_view(bool open) {
    constexpr int until_whole = 4;
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID header = ImGui::GetItemID(), before = header + 1;
    const ImGuiID opened = ImHashStr("opened"), frames = ImHashStr("frames");
    const bool was_open = kept.GetBool(before, open);
    kept.SetBool(before, open);
    if (open && !was_open) {
        kept.SetInt(opened, static_cast<int>(header));
        kept.SetInt(frames, until_whole);
    }
    const int left = kept.GetInt(frames);
    if (left == 0 || kept.GetInt(opened) != static_cast<int>(header)) return;
    kept.SetInt(frames, open ? left - 1 : 0);
    if (open) kept.SetFloat(top_of_opened, ImGui::GetItemRectMin().y - ImGui::GetWindowPos().y + ImGui::GetScrollY());
}

void show_opened() {
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const float top = kept.GetFloat(top_of_opened, -1), bottom = ImGui::GetCursorPosY(),
                height = ImGui::GetWindowHeight();
    if (top < 0) return;
    kept.SetFloat(top_of_opened, -1);
    const float scroll = ImGui::GetScrollY();
    if (top < scroll || bottom > scroll + height) ImGui::SetScrollY(std::min(top, bottom - height));
}

std::size_t tabs(const std::array<TabName, 2>& names, std::size_t chosen, Layout& layout) {
    std::array<ImRect, 2> places;
    ImGui::PushStyleColor(ImGuiCol_Button, {0, 0, 0, 0});
    ImGui::PushStyleColor(ImGuiCol_Text, {0, 0, 0, 0});  // drawn below
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, 0);
        if (button(names[i].title, layout, names[i].name)) chosen = i;
        places[i] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    }
    ImGui::PopStyleColor(2);
    // What follows is that tab's already: so is the mark.
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    for (std::size_t i = 0; i < names.size(); ++i)
        list.AddText({places[i].Min.x + padding.x, places[i].Min.y + padding.y},
                     ImGui::GetColorU32(i == chosen ? ImGuiCol_Text : ImGuiCol_TextDisabled), names[i].title);
    const ImRect& tab = places[chosen];
    const float line = std::round(ImGui::GetFontSize() * .15F);
    list.AddRectFilled({tab.Min.x, tab.Max.y - line}, tab.Max, ImGui::GetColorU32(palette().accent));
    layout.place("tab", {tab.Min.x, tab.Max.y - line, tab.GetWidth(), line});
    ImGui::Separator();
    return chosen;
}

bool begin_combo(const char* id, const char* text, std::size_t& chosen, std::size_t count) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box{at.x, at.y, ImGui::CalcItemWidth(), ImGui::GetFrameHeight()};
    const ImRect whole(at, {box.x + box.width, box.y + box.height});
    const ImGuiID item = ImGui::GetID(id);
    const bool focused = focusable(whole, item, Focus::Kind::button), toggled = focused && pressing();
    if (focused && !ImGui::GetIO().WantTextInput) {
        if ((pressed(Key::down, true) || pressed(Key::right, true)) && chosen + 1 < count) ++chosen;
        if ((pressed(Key::up, true) || pressed(Key::left, true)) && chosen > 0) --chosen;
    }
    ImGuiContext& g = *ImGui::GetCurrentContext();
    if (toggled) g.NavActivateId = g.NavActivateDownId = item;  // presses the button
    const bool open = ImGui::BeginCombo(id, text);
    if (open && !focused && ImGui::IsWindowAppearing()) take_focus(item);  // the mouse has opened it
    note_opener(box, open);
    if (open && toggled && !ImGui::IsWindowAppearing()) ImGui::CloseCurrentPopup();
    if (!open) draw_focus(whole, item);
    return open;
}

}  // namespace snell::ui
