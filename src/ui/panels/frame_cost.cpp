#include "src/ui/panels/frame_cost.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "src/ui/panels/accuracy.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

ImU32 pack(ImVec4 color) { return ImGui::GetColorU32(color); }

// Rounds up to 1, 2 or 5 times a power of ten.
double round_up(double value) {
    const double power = std::pow(10, std::floor(std::log10(std::max(value, 1e-3))));
    for (const double digit : {1., 2., 5.})
        if (value <= digit * power) return digit * power;
    return 10 * power;
}

void put(ImDrawList& list, ImVec2 at, ImVec4 color, const Text& text) {
    list.AddText(at, pack(color), text.begin(), text.end());
}

// Plots the last frames from left to right, with lines for the median and the 95th percentile.
void plot(const FrameCostFacts& facts, Layout& layout) {
    const Palette& colors = palette();
    const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x, height = 5 * em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("##frames", {std::max(width, 1.0F), height});
    layout.note("frame cost.plot");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // Single frames may be far longer; the scale shows the typical ones.
    const double top = round_up(1.3 * std::max<double>(facts.high, facts.median));
    Text text;
    text.add("{:g} ms", top);
    list.AddRectFilled(at, {at.x + width, at.y + height}, pack(colors.track), ImGui::GetStyle().FrameRounding);
    const auto y = [&](double value) {
        return at.y + height * (1 - static_cast<float>(std::clamp(value / top, 0.0, 1.0)));
    };
    constexpr std::size_t most = 240;
    const float step = width / (most - 1);
    const std::size_t count = facts.frames.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const float x = at.x + width - step * static_cast<float>(count - 1 - i);
        list.AddLine({x, y(facts.frames[i])}, {x + step, y(facts.frames[i + 1])}, pack(colors.accent), 1.5F);
    }
    list.AddLine({at.x, y(facts.median)}, {at.x + width, y(facts.median)}, pack(colors.text));
    list.AddLine({at.x, y(facts.high)}, {at.x + width, y(facts.high)}, pack(colors.dim));
    put(list, {at.x + em * .3F, at.y + em * .1F}, colors.dim, text);
    tip(Text("the last {} pictures\nlines: median and 95th percentile", count).view());
}

// Draws name and milliseconds over a bar that shows its share of `all`.
void row(const CostRow& cost, double all, Layout& layout) {
    const float em = ImGui::GetFontSize(), indent = cost.draw ? em : 0;
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float part = all > 0 ? static_cast<float>(std::clamp(cost.milliseconds / all, 0.0, 1.0)) : 0;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x + indent, at.y},
                                              {at.x + indent + (width - indent) * part, at.y + em * 1.1F},
                                              pack(cost.draw ? palette().track : palette().filled), 2);
    Text text;
    text.add("{:.3f}", cost.milliseconds);
    const float left = ImGui::GetCursorPosX(), taken = width_of(text.view());
    ImGui::SetCursorPosX(left + indent);
    fitted(cost.name, width - indent - taken - em * .5F);
    if (!cost.place.empty()) tip(Text("{}\n{}", cost.name, cost.place).view());
    layout.note("frame cost", cost.name);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + width - taken);
    ImGui::TextUnformatted(text.begin(), text.end());
}

// Returns the sum of the passes.
double rows(std::span<const CostRow> costs, Layout& layout) {
    double all = 0;
    for (const CostRow& cost : costs) all += cost.draw ? 0 : cost.milliseconds;
    for (std::size_t i = 0; i < costs.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        row(costs[i], all, layout);
        ImGui::PopID();
    }
    return all;
}

}  // namespace

void last_picture(const Facts& facts, Layout& layout) {
    ImGui::TextUnformatted(Text("last picture {:.1f} ms", facts.frame_ms).c_str());
    tip("The time from the start of drawing the window's picture to its end, which is also\nin the status line; the "
        "first after a load or a change of rungs waits\nfor the driver's compiler.");
    layout.note("last picture");
}

bool frame_cost_section(const Facts& facts, Memory& memory, Layout& layout) {
    memory.frame_cost = section("Frame cost", memory.open, layout, "frame cost");
    if (!memory.frame_cost || !facts.frame_cost) return false;
    const FrameCostFacts& cost = *facts.frame_cost;
    last_picture(facts, layout);
    if (cost.frames.size() > 2) wrapped(Text("median {:.1f} ms, 95 %: {:.1f} ms", cost.median, cost.high).view(), true);
    plot(cost, layout);
    if (!cost.passes.empty()) {
        wrapped("GPU time of each pass, by timer queries", true);
        ImGui::PushID("live");
        rows(cost.passes, layout);
        ImGui::PopID();
    }
    const bool chosen = button(cost.measuring ? "Stop" : "Measure passes and draws", layout, "frame cost.measure");
    tip("Draws 22 additional frames that are not shown,\nand times every draw in half of them.");
    if (cost.measuring)
        ImGui::ProgressBar(static_cast<float>(*cost.measuring), {-FLT_MIN, ImGui::GetFontSize() * .4F}, "");
    if (!cost.apart.empty()) {
        wrapped(cost.apart_clock, true);
        ImGui::PushID("apart");
        const double all = rows(cost.apart, layout);
        ImGui::PopID();
        wrapped(Text("sum {:.1f} ms; the same frame in one go {:.1f} ms", all, cost.apart_plain).view());
        layout.note("frame cost.sum");
    }
    return chosen;
}

}  // namespace snell::ui
