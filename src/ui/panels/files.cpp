#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/ui/kit/input.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

constexpr std::array zooms{.5F, .67F, .8F, .9F, 1.0F, 1.1F, 1.25F, 1.5F, 1.75F, 2.0F, 2.5F, 3.0F};

}  // namespace

bool no_scene_words(Layout& layout) {
    wrapped("No scene is open.");
    wrapped("Press Ctrl+O, drop a .glib file on the window, or");
    return button("Open a scene\u2026", layout, "open scene");
}

bool no_scene(const Rect& scene, Layout& layout) {
    ImGui::SetNextWindowPos({scene.x + scene.width / 2, scene.y + scene.height / 2}, 0, {.5F, .5F});
    ImGui::SetNextWindowSize({std::min(scene.width, 24 * ImGui::GetFontSize()), 0});
    constexpr ImGuiWindowFlags bare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_AlwaysAutoResize;
    const bool chosen = ImGui::Begin("##no scene", nullptr, bare) && no_scene_words(layout);
    ImGui::End();
    return chosen;
}

float next_zoom(float zoom, int way) {
    constexpr float near = 1.01F;
    if (way > 0) {
        const auto next = ranges::find_if(zooms, [&](float z) { return z > zoom * near; });
        return next == zooms.end() ? zooms.back() : *next;
    }
    const auto least = std::find_if(zooms.rbegin(), zooms.rend(), [&](float z) { return z * near < zoom; });
    return least == zooms.rend() ? zooms.front() : *least;
}

bool edit_link(const Facts& facts, const Place& place, bool read_on) {
    if (place.file.empty() || !ImGui::IsItemHovered()) return false;
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    const std::string editor = utf8::printable(facts.editor);
    const Text text("{}:{}\nClick to open in {}", utf8::printable(place.file), place.line, editor);
    read_on ? tip_below_window(text.view()) : tip(text.view());
    return ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

void files_section(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    if (!section("Files", "The files that the scene reads; a click opens one in your editor", memory.open, layout,
                 "files"))
        return;
    const float width = ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < facts.files.size(); ++i) {
        const FileRow& file = facts.files[i];
        ImGui::PushID(static_cast<int>(i));
        ImGui::Selectable(shortened(file.name, width).c_str());
        Place place{file.path, 1, 1};
        const bool keys = or_keys(false);
        if (edit_link(facts, place) || keys) requests.edit = std::move(place);
        layout.note("file", file.name);
        ImGui::PopID();
    }
    fitted(fmt::format("Click a file to open it in {}", utf8::printable(facts.editor)), width, true);
}

namespace {

void letters_row(float& zoom, Layout& layout) {
    const auto percent = [](float size) { return fmt::format("{:.0f} %", std::round(size * 100)); };
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, list = width_of("300 %") + 2 * ImGui::GetFrameHeight();
    follow(width_of("Letters") + gap + list, ImGui::GetFontSize());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Letters");
    follow(list, gap);
    ImGui::SetNextItemWidth(list);
    const auto nearest = ranges::min_element(zooms, {}, [&](float size) { return std::abs(size - zoom); });
    const auto before = static_cast<std::size_t>(nearest - zooms.begin());
    std::size_t chosen = before;
    const bool open = begin_combo("##letters", percent(zoom).c_str(), chosen, zooms.size());
    layout.note("letters");
    for (std::size_t i = 0; open && i < zooms.size(); ++i) {
        if (ImGui::Selectable(percent(zooms[i]).c_str(), i == before)) chosen = i;
        layout.note("letters", percent(zooms[i]));
    }
    if (open) ImGui::EndCombo();
    if (chosen != before) zoom = zooms[chosen];
}

}  // namespace

void look_section(Memory& memory, Layout& layout) {
    if (!section("Window", "Theme and size of letters, and how slow pictures are dragged", memory.open, layout,
                 "window"))
        return;
    static constexpr std::array titles{"Light", "Dark", "Contrast"};
    for (std::size_t i = 0; i < titles.size(); ++i) {
        if (i > 0) follow(check_box_width(titles[i]));
        if (or_keys(ImGui::RadioButton(titles[i], memory.theme == static_cast<Theme>(i))))
            memory.theme = static_cast<Theme>(i);
        layout.note(theme_names[i]);
    }
    letters_row(memory.zoom, layout);
    bool coarser = !memory.always_sharp;
    if (switch_box("Coarser while dragging", coarser)) memory.always_sharp = !coarser;
    tip("Draws slow pictures with fewer samples and pixels while something is dragged");
    layout.note("coarser");
}

void files_keys(Memory& memory, Requests& requests) {
    if (!ImGui::GetIO().KeyCtrl) return;
    if (pressed(Key::o, true) && !memory.browser.open) open_browser({}, memory, requests);
    if (pressed(Key::plus, true)) memory.zoom = next_zoom(memory.zoom, 1);
    if (pressed(Key::minus, true)) memory.zoom = next_zoom(memory.zoom, -1);
    if (pressed(Key::zero, true)) memory.zoom = 1;
}

}  // namespace snell::ui
