#include "src/ui/kit/layout.h"

#include <imgui.h>

namespace snell::ui {

void Layout::note(std::string_view name) {
    if (!listening_) return;
    const ImVec2 min = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    items_.push_back({std::string(name), {min.x, min.y, size.x, size.y}, ImGui::IsItemVisible()});
}

void Layout::note(std::string_view first, std::string_view second) {
    if (listening_) note(std::string(first).append(".").append(second));
}

void Layout::place_window(std::string_view name) {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    place(name, {at.x, at.y, size.x, size.y});
}

void Layout::place(std::string_view name, const Rect& rect) {
    if (listening_) items_.push_back({std::string(name), rect, true});
}

}  // namespace snell::ui
