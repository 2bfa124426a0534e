#include "src/ui/panels/pixels.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "src/content/image/image.h"
#include "src/ui/kit/input.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

constexpr ImGuiWindowFlags passive = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                     ImGuiWindowFlags_NoNav;

constexpr std::array<Flag, 4> flags{Flag::nan, Flag::infinite, Flag::negative, Flag::above_one};

ImU32 pack(const std::array<std::uint8_t, 3>& c) { return IM_COL32(c[0], c[1], c[2], 255); }

// Draws a square in the flag's colour, as an item.
void swatch(Flag flag) {
    const float em = ImGui::GetFontSize(), side = std::round(em * .65F);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y + std::round((em - side) / 2);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side}, pack(snell::color_of(flag)));
    ImGui::Dummy({side, em});
}

// Returns the colour on the screen, or that of the pixel's flag. `light`: it is encoded for the screen.
ImU32 color_of(std::span<const float, 4> rgba, bool light) {
    if (const Flag flag = flag_of(rgba); flag >= Flag::infinite) return pack(snell::color_of(flag));
    const auto byte = [light](float value) {
        if (light) value = static_cast<float>(content::srgb_of_light(static_cast<double>(value)));
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
    };
    return pack({byte(rgba[0]), byte(rgba[1]), byte(rgba[2])});
}

// Draws a square for each pixel and frames the middle one.
void magnified(const Inspection& found, float cell) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const int radius = found.radius;
    const float side = cell * static_cast<float>(2 * radius + 1);
    list.AddRectFilled(at, {at.x + side, at.y + side}, ImGui::GetColorU32(palette().surround));
    for (int down = -radius; down <= radius; ++down)
        for (int right = -radius; right <= radius; ++right) {
            if (!found.inside[found.at(right, down)]) continue;
            const float x = at.x + cell * static_cast<float>(right + radius);
            const float y = at.y + cell * static_cast<float>(down + radius);
            list.AddRectFilled({x, y}, {x + cell, y + cell}, color_of(found.pixel(right, down), found.light));
        }
    const float x = at.x + cell * static_cast<float>(radius), y = at.y + cell * static_cast<float>(radius);
    list.AddRect({x - 1, y - 1}, {x + cell + 1, y + cell + 1}, IM_COL32_BLACK);
    list.AddRect({x, y}, {x + cell, y + cell}, IM_COL32_WHITE);
    ImGui::Dummy({side, side});
}

void channels(const Inspection& found, const Fonts& fonts) {
    constexpr std::array<char, 4> names{'R', 'G', 'B', 'A'};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const float value = found.pixel()[i];
        ImGui::PushFont(fonts.mono);
        ImGui::TextUnformatted(Text("{} {:<14}", names[i], value_text(value).view()).c_str());
        ImGui::PopFont();
        Flag flag = flag_of(value);
        if (i == 3 && flag < Flag::infinite) flag = Flag::none;  // an alpha outside of 0 to 1 has no visible effect
        if (flag == Flag::none) continue;
        ImGui::SameLine();
        swatch(flag);
        ImGui::SameLine();
        ImGui::TextUnformatted(name(flag).data());
    }
}

// Returns a position where a box of that size is fully visible and does not cover the pointer: to the side of it, or
// above or below.
ImVec2 beside(ImVec2 pointer, ImVec2 size, const Rect& scene, float gap) {
    const float right = scene.x + scene.width, bottom = scene.y + scene.height;
    const float x = std::clamp(pointer.x - size.x / 2, scene.x, std::max(scene.x, right - size.x));
    const float y = std::clamp(pointer.y - size.y / 2, scene.y, std::max(scene.y, bottom - size.y));
    if (pointer.x + gap + size.x <= right) return {pointer.x + gap, y};
    if (pointer.x - gap - size.x >= scene.x) return {pointer.x - gap - size.x, y};
    if (pointer.y + gap + size.y <= bottom) return {x, pointer.y + gap};
    return {x, std::max(scene.y, pointer.y - gap - size.y)};
}

}  // namespace

Text value_text(float value) {
    if (std::isnan(value)) return Text("NaN");
    return Text("{}", value);
}

void pixel_keys(const Rect& scene, PixelMemory& memory) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool free = !io.WantTextInput && !io.KeyCtrl && !ImGui::GetTopMostPopupModal();
    if (free && pressed(Key::n)) memory.flags = !memory.flags;
    memory.inspecting =
        free && ImGui::IsKeyDown(static_cast<int>(Key::i)) && scene.contains(io.MousePos.x, io.MousePos.y);
    memory.x = io.MousePos.x - scene.x;
    memory.y = io.MousePos.y - scene.y;
}

void pixels_section(Titles& open, PixelMemory& memory, Layout& layout) {
    if (!section("Pixels", "The numbers that shaders wrote, and pixels that no picture can show", open, layout,
                 "pixels"))
        return;
    switch_box("Mark invalid values", memory.flags);
    layout.note("flags");
    tip("N: marks pixels that are NaN, infinite, below 0 or above 1 before conversion to bytes.\nThe picture is drawn "
        "a "
        "second time, into floats.");
    wrapped("Hold I over the picture to see a pixel's values.", true);
}

void flag_counts(std::span<const Flagged> halves, float room) {
    const float em = ImGui::GetFontSize();
    const bool narrow = room < 34 * em;
    for (const Flagged& half : halves) {
        if (&half != &halves.front() && narrow) ImGui::SameLine(0, em);
        ImGui::BeginGroup();
        if (!half.half.empty()) fitted(half.half, narrow ? (room - em) / 2 : room, true);
        for (const Flag flag : flags) {
            if (flag != flags.front() && !narrow) ImGui::SameLine(0, em);
            swatch(flag);
            ImGui::SameLine(0, em * .3F);
            ImGui::Text("%s %zu", name(flag).data(), half.counts[flag]);
        }
        ImGui::EndGroup();
    }
}

float flags_legend(const Facts& facts, const Rect& picture, const PixelMemory& memory, Layout& layout) {
    if (!memory.flags || !facts.pixels) return picture.y;
    const Rect scene = with_room(picture);
    const float margin = ImGui::GetStyle().WindowPadding.x, room = scene.width - 3 * margin;
    if (facts.pixels->flags.size() > 1 && room < 20 * ImGui::GetFontSize()) return picture.y;
    ImGui::SetNextWindowPos({scene.x + scene.width - margin, scene.y + margin}, 0, {1, 0});
    ImGui::SetNextWindowBgAlpha(.93F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
    if (ImGui::Begin("##legend", nullptr, passive | ImGuiWindowFlags_AlwaysAutoResize)) {
        const PixelFacts& pixels = *facts.pixels;
        if (pixels.flags.empty()) {
            const Text looking("looking\u2026 {:.0f} %", std::floor(100 * pixels.drawn.value_or(0)));
            fitted(pixels.note.empty() ? looking.view() : pixels.note, room);
        } else {
            flag_counts(pixels.flags, room);
        }
    }
    layout.place_window("flag counts");
    const float end = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
    ImGui::End();
    ImGui::PopStyleVar();
    return end;
}

void inspector(const Facts& facts, const Rect& scene, const PixelMemory& memory, const Fonts& fonts, Layout& layout) {
    if (memory.inspecting && facts.pixels) inspector(*facts.pixels, scene, fonts, layout);
}

void inspector(const PixelFacts& pixels, const Rect& scene, const Fonts& fonts, Layout& layout) {
    if (!pixels.inspection) return;
    const Inspection& found = *pixels.inspection;
    const ImVec2 padding = ImGui::GetStyle().WindowPadding, all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize(), lines = 5 + static_cast<float>(!pixels.half.empty()) +
                                                   static_cast<float>(found.depth.has_value()) +
                                                   static_cast<float>(found.distance.has_value()) +
                                                   static_cast<float>(pixels.difference.has_value());
    const float pixels_wide = static_cast<float>(2 * found.radius + 1), line = ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 inner(.9F * em * pixels_wide + 14.5F * em,
                       std::max(.9F * em * pixels_wide, line * lines) + 2.2F * line);
    // In the smallest windows its letters are smaller than all others.
    const float shrunk = std::min({1.0F, (all.x - 2 * padding.x) / inner.x, (all.y - 2 * padding.y) / inner.y});
    const float width = shrunk * inner.x, cell = std::floor(shrunk * std::round(.9F * em));
    const ImVec2 size(width + 2 * padding.x, shrunk * inner.y + 2 * padding.y);
    const bool fits = size.x <= scene.width && size.y <= scene.height;  // otherwise the box may cover the panel
    const ImVec2 at = beside(ImGui::GetIO().MousePos, size, fits ? scene : Rect{0, 0, all.x, all.y}, 1.5F * em);
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing.x * shrunk, spacing.y * shrunk});
    if (ImGui::Begin("##inspector", nullptr, passive)) {
        ImGui::SetWindowFontScale(shrunk);
        ImGui::BeginGroup();
        magnified(found, cell);
        ImGui::EndGroup();
        ImGui::SameLine();
        ImGui::BeginGroup();
        ImGui::TextDisabled("%s", pixels.at.c_str());
        if (!pixels.half.empty()) fitted(pixels.half, ImGui::GetContentRegionAvail().x, true);
        channels(found, fonts);
        if (pixels.difference && std::isnan(*pixels.difference))
            ImGui::TextUnformatted("difference of light NaN");
        else if (pixels.difference)
            ImGui::TextUnformatted(Text("difference of light {:.4g}", *pixels.difference).c_str());
        if (found.depth) {
            const Text depth("depth {:.7g} (0 near, 1 far)", *found.depth);
            ImGui::TextUnformatted(depth.c_str());
            layout.note("inspector.depth", depth.view());
            if (found.distance) {
                const Text distance("along the view axis: {:.6g}", *found.distance);
                ImGui::TextUnformatted(distance.c_str());
                layout.note("inspector.distance", distance.view());
            }
        }
        ImGui::EndGroup();
        fitted(pixels.statement.empty() ? "no object" : pixels.statement, width);
        fitted(pixels.place, width, true);
        layout.note("inspector.place");
    }
    layout.place_window("inspector");
    ImGui::End();
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor();
}

}  // namespace snell::ui
