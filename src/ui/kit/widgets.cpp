#include "src/ui/kit/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

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

bool button(const char* text, Layout& layout, std::string_view name) {
    const bool pressed = ImGui::Button(text);
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

void wrapped(std::string_view text, bool dim) {
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

Text shortened(std::string_view text, float width) {
    if (width_of(text) <= width) return Text(text);
    static constexpr std::string_view dots = "\u2026";
    const bool sentence = text.find(' ') != text.npos;
    const auto at_end = [&](std::size_t kept) { return sentence ? 0 : kept / 2; };
    const auto head = [&](std::size_t kept) { return text.substr(0, first_bytes(text, kept - at_end(kept))); };
    const auto tail = [&](std::size_t kept) { return text.substr(text.size() - last_bytes(text, at_end(kept))); };
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

bool section(const char* title, Titles& open, Layout& layout, const char* name) {
    const auto kept = open.find(std::string_view(title));
    ImGui::SetNextItemOpen(kept != open.end());
    const bool opened = ImGui::CollapsingHeader(title);
    layout.note(name);
    if (opened && kept == open.end()) open.emplace(title);
    if (!opened && kept != open.end()) open.erase(kept);
    return opened;
}

bool begin_combo(const char* id, const char* chosen) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box{at.x, at.y, ImGui::CalcItemWidth(), ImGui::GetFrameHeight()};
    const bool open = ImGui::BeginCombo(id, chosen);
    // A press on the button itself closes the list, and must not open it again.
    if (open)
        kit().opener = box;
    else if (kit().opener == box)
        kit().opener = {};
    return open;
}

}  // namespace snell::ui
