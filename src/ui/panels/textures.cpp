#include "src/ui/panels/textures.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

constexpr double most_zoom = 64;

double fitting(const TextureMemory& memory, int width, int height) {
    return std::min<double>(memory.width / std::max(1, width), memory.height / std::max(1, height));
}

void list(std::span<const TextureRow> rows, std::size_t shown, TextureMemory& memory, Layout& layout) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float lines = static_cast<float>(std::min<std::size_t>(rows.size(), 6));
    ImGui::BeginChild("##textures", {0, line * lines + style.ItemSpacing.y});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const TextureRow& row = rows[i];
        const std::string_view remark = row.loaded ? std::string_view(row.size) : "not loaded";
        const float width = ImGui::GetContentRegionAvail().x, taken = width_of(remark) + ImGui::GetFontSize() * .5F;
        const ImVec2 at = ImGui::GetCursorPos();
        ImGui::PushID(static_cast<int>(i));
        if (selectable("##row", i == shown)) {
            if (i != shown) memory.level = memory.slice = 0;
            memory.chosen = row.name;
        }
        ImGui::PopID();
        tip(Text("{}\n{}", row.name, row.why).view());
        layout.note("textures.row", row.name);
        ImGui::SetCursorPos(at);
        fitted(row.name, std::max(width - taken, width * .4F), !row.loaded);
        const float right = at.x + width - width_of(remark);
        ImGui::SameLine();
        if (ImGui::GetCursorPosX() > right) {
            ImGui::NewLine();
            continue;
        }
        ImGui::SetCursorPosX(right);
        ImGui::TextDisabled("%.*s", static_cast<int>(remark.size()), remark.data());
    }
    ImGui::EndChild();
}

// The wheel scales about the pointer, to powers of two, and dragging moves.
void navigate(const TextureFacts& facts, ImVec2 corner, TextureMemory& memory) {
    const ImGuiIO& io = ImGui::GetIO();
    const double fit = fitting(memory, facts.width, facts.height);
    TexturePart part = texture_part(memory, facts.width, facts.height);
    const double right = (io.MousePos.x - corner.x) / part.zoom, down = (io.MousePos.y - corner.y) / part.zoom;
    const double x = part.left + right, y = part.top + down;
    memory.texel_x = static_cast<int>(std::floor(x));
    memory.texel_y = static_cast<int>(std::floor(y));
    if (memory.aimed && io.MouseWheel != 0) {
        const double power = std::log2(part.zoom) + (io.MouseWheel > 0 ? .51 : -.51);
        const double zoom = std::clamp(std::exp2(std::round(power)), fit, std::max(fit, most_zoom));
        memory.scale = zoom / fit;
        memory.x = (x + (memory.width / 2 - (io.MousePos.x - corner.x)) / zoom) / facts.width;
        memory.y = (y + (memory.height / 2 - (io.MousePos.y - corner.y)) / zoom) / facts.height;
    }
    if (ImGui::IsItemActive()) {
        memory.x -= io.MouseDelta.x / part.zoom / facts.width;
        memory.y -= io.MouseDelta.y / part.zoom / facts.height;
    }
    part = texture_part(memory, facts.width, facts.height);  // which keeps the picture full
    memory.x = (part.left + memory.width / 2 / part.zoom) / facts.width;
    memory.y = (part.top + memory.height / 2 / part.zoom) / facts.height;
}

void picture(const TextureFacts& facts, TextureMemory& memory, Layout& layout) {
    const ImGuiIO& io = ImGui::GetIO();
    const float em = ImGui::GetFontSize();
    // Not the width that is available: it changes with the scroll bar, which comes and goes with the height.
    const float bar = ImGui::GetScrollMaxY() > 0 ? 0 : ImGui::GetStyle().ScrollbarSize;
    memory.width = std::max(1.F, std::floor(ImGui::GetContentRegionAvail().x - bar));
    memory.height = std::floor(std::clamp(memory.width * .75F, 4 * em, 20 * em));
    const ImVec2 at = ImGui::GetCursorScreenPos(), end(at.x + memory.width, at.y + memory.height);
    ImGui::InvisibleButton("##texels", {memory.width, memory.height});
    memory.aimed = ImGui::IsItemHovered() && (memory.aimed || io.MouseDelta.x != 0 || io.MouseDelta.y != 0);
    if (memory.aimed) keep_wheel();
    layout.note("textures.picture");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, end, ImGui::GetColorU32(palette().track));
    if (facts.width <= 0) return;
    if (facts.picture) {
        // Dear ImGui's type of textures is a pointer, which its OpenGL painter takes as a number.
        list.AddImage(reinterpret_cast<ImTextureID>(facts.picture), at, end);  // NOLINT(performance-no-int-to-ptr)
    }
    navigate(facts, at, memory);
    memory.inspecting =
        ImGui::IsItemHovered() && !io.WantTextInput && !io.KeyCtrl && ImGui::IsKeyDown(static_cast<int>(Key::i));
}

void channel_row(TextureMemory& memory, Layout& layout) {
    constexpr std::array<const char*, 5> names{"RGB", "R", "G", "B", "A"};
    for (int i = 0; i < 5; ++i) {
        const char* name = names[static_cast<std::size_t>(i)];
        if (i > 0) follow(check_box_width(name), ImGui::GetFontSize() * .6F);
        if (or_keys(ImGui::RadioButton(name, memory.channel == i - 1))) memory.channel = i - 1;
        layout.note("textures.channel", name);
    }
}

void whole_row(const char* name, int& value, int count, Layout& layout) {
    value = std::clamp(value, 0, count - 1);
    if (count < 2) return;
    label(name);
    ImGui::SameLine(4 * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(-1);
    ImGui::PushID(name);
    ImGui::SliderInt("##value", &value, 0, count - 1, "%d", ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
    layout.note("textures", name);
}

void range_row(TextureMemory& memory, Layout& layout) {
    const float field = 4.2F * ImGui::GetFontSize();
    label("range");
    tip("The values that are shown as black and as white");
    ImGui::SameLine(4 * ImGui::GetFontSize());
    number("##low", memory.low, ValueType::float_, 0, field);
    layout.note("textures.low");
    follow(field);
    number("##high", memory.high, ValueType::float_, 1, field);
    layout.note("textures.high");
}

void zoom_row(const TextureFacts& facts, TextureMemory& memory, Layout& layout) {
    const TexturePart part = texture_part(memory, facts.width, facts.height);
    ImGui::BeginDisabled(memory.scale <= 1);
    if (button("Fit", layout, "textures.fit")) memory.scale = 1;
    ImGui::EndDisabled();
    ImGui::SameLine();
    fitted(Text("{:.{}f} % \u00b7 wheel, drag, hold I", 100 * part.zoom, part.zoom < .1 ? 1 : 0).view(),
           ImGui::GetContentRegionAvail().x, true);
}

}  // namespace

std::size_t chosen_row(std::span<const TextureRow> rows, const TextureMemory& memory) {
    const auto found = ranges::find(rows, memory.chosen, &TextureRow::name);
    return static_cast<std::size_t>((found != rows.end() ? found : ranges::find(rows, true, &TextureRow::loaded)) -
                                    rows.begin());
}

TexturePart texture_part(const TextureMemory& memory, int width, int height) {
    TexturePart part;
    part.zoom = std::max(1e-6, fitting(memory, width, height) * std::max(1., memory.scale));
    const auto begin = [&part](double middle, double room, int size) {
        const double shown = room / part.zoom;
        return shown >= size ? (size - shown) / 2 : std::clamp(middle * size - shown / 2, 0., size - shown);
    };
    part.left = begin(memory.x, memory.width, width);
    part.top = begin(memory.y, memory.height, height);
    return part;
}

void textures_section(const Facts& facts, Memory& memory, Layout& layout) {
    TextureMemory& textures = memory.textures;
    textures.inspecting = false;
    textures.open = section("Textures", "The images, cube maps and noise that shaders read, texel by texel",
                            memory.open, layout, "textures");
    if (!textures.open || !facts.textures) return;
    const TextureFacts& shown = *facts.textures;
    if (shown.rows.empty()) return wrapped("The scene has no textures.", true);
    const std::size_t at = chosen_row(shown.rows, textures);
    list(shown.rows, at, textures, layout);
    if (at == shown.rows.size()) return;
    const TextureRow& row = shown.rows[at];
    wrapped(row.loaded ? Text("{}, {}", row.format, row.why).view() : Text("Not loaded: {}", row.why).view(), true);
    layout.note("textures.about");
    if (!row.loaded) return;
    picture(shown, textures, layout);
    zoom_row(shown, textures, layout);
    if (memory.pixels.flags) flag_counts(shown.texel.flags, ImGui::GetContentRegionAvail().x);
    channel_row(textures, layout);
    whole_row("level", textures.level, shown.levels, layout);
    whole_row("slice", textures.slice, shown.slices, layout);
    if (shown.floats) range_row(textures, layout);
}

void texel_inspector(const Facts& facts, TextureMemory& memory, const Fonts& fonts, Layout& layout) {
    if (!memory.inspecting || !facts.textures) return;
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    inspector(facts.textures->texel, {0, 0, all.x, all.y}, fonts, layout);
}

}  // namespace snell::ui
