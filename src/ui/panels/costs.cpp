// What a scene costs: the times of its frames, and what it keeps on the GPU.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <set>
#include <utility>

#include "src/plan/values/numbers.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/accuracy.h"
#include "src/ui/panels/panels.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

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

// Median and percentile of fewer pictures say nothing, least of all while programs are being compiled.
bool plotted(const FrameCostFacts& facts) { return facts.frames.size() > 2; }

// What stands in the place of the plot until then. Where something moves, pictures come by themselves.
Text not_plotted(const FrameCostFacts& facts, bool moves) {
    return facts.coarse > 0 ? Text("The next sharp pictures are plotted here.")
           : moves          ? Text("Measuring: {} of 3 pictures", facts.frames.size())
                            : Text("The next pictures are plotted here.");
}

// Plots the last frames from left to right, with lines for the median and the 95th percentile.
void plot(const FrameCostFacts& facts, bool moves, Layout& layout) {
    const Palette& colors = palette();
    const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x, height = 5 * em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("##frames", {std::max(width, 1.0F), height});
    layout.note("frame cost.plot");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // Single frames may be far longer; the scale shows the typical ones.
    const double top = round_up(1.3 * std::max<double>(facts.high, facts.median));
    list.AddRectFilled(at, {at.x + width, at.y + height}, pack(colors.track), ImGui::GetStyle().FrameRounding);
    if (!plotted(facts)) {
        const Text none = shortened(not_plotted(facts, moves).view(), width - em);
        const ImVec2 corner(at.x + (width - width_of(none.view())) / 2, at.y + (height - em) / 2);
        layout.place("frame cost.not plotted", {corner.x, corner.y, width_of(none.view()), em});
        return put(list, corner, colors.dim, none);
    }
    Text text;
    text.add("{:g} ms", top);
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
    text.add("{:.3f} ms", cost.milliseconds);
    const float left = ImGui::GetCursorPosX(), taken = width_of(text.view());
    ImGui::SetCursorPosX(left + indent);
    fitted(cost.name, width - indent - taken - em * .5F);
    if (!cost.place.empty()) tip(Text("{}\n{}", cost.name, cost.place).view());
    layout.note("frame cost", cost.name);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + width - taken);
    ImGui::TextUnformatted(text.begin(), text.end());
    layout.note("frame cost.time", cost.name);
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
    memory.frame_cost =
        section("Frame cost", "How long pictures take, and their passes and draws", memory.open, layout, "frame cost");
    if (!memory.frame_cost || !facts.frame_cost) return false;
    const FrameCostFacts& cost = *facts.frame_cost;
    last_picture(facts, layout);
    if (plotted(cost)) {
        const Text high("95 %: {:.1f} ms", cost.high);
        ImGui::TextDisabled("%s", Text("median {:.1f} ms", cost.median).c_str());
        follow(width_of(high.view()), ImGui::GetFontSize());
        ImGui::TextDisabled("%s", high.c_str());
    }
    plot(cost, facts.animated || memory.animating(), layout);
    if (cost.coarse > 0) {
        wrapped(Text("of sharp pictures; {}", counted(cost.coarse, "coarse one") + " left out").view(), true);
        layout.note("frame cost.coarse");
    }
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
        if (cost.older) {
            wrapped("Values or view have changed: the times are of the older ones.", true);
            layout.note("frame cost.older");
        }
        if (!cost.reduced.empty()) {
            wrapped(cost.reduced, true);
            layout.note("frame cost.reduced");
        }
        ImGui::PushID("apart");
        const double all = rows(cost.apart, layout);
        ImGui::PopID();
        wrapped(Text("sum {:.1f}\u00A0ms; the same frame in one go {:.1f}\u00A0ms", all, cost.apart_plain).view());
        layout.note("frame cost.sum");
    }
    return chosen;
}

namespace {

using Kind = Explanation::Kind;
using Paid = Explanation::Paid;

// Draws a text that ends at `right`, on the line of the last item.
void right_text(const std::string& text, float right) {
    if (text.empty()) return;
    ImGui::SameLine();
    ImGui::SetCursorPosX(right - width_of(text));
    ImGui::TextDisabled("%s", text.c_str());
}

// Draws a line of two columns. The tooltip has the full text, `why`, and the place in the files.
void line(const Facts& facts, const std::string& name, const std::string& amount, const std::string& why,
          const std::optional<Span>& span, Layout& layout) {
    const float width = ImGui::GetContentRegionAvail().x, right = ImGui::GetCursorPosX() + width;
    const float taken = amount.empty() ? 0 : width_of(amount) + ImGui::GetStyle().ItemSpacing.x;
    ImGui::BeginGroup();
    fitted(name, width - taken);
    right_text(amount, right);
    if (!amount.empty()) layout.note("costs.amount", amount);
    ImGui::EndGroup();
    const ImGuiID id = ImGui::GetID(name.c_str());
    or_keys(false, id);
    layout.note("costs.row", name);
    const bool focused = kit().focus.at == id;
    if (!focused && !ImGui::IsItemHovered()) return;
    std::string place;
    if (span && facts.sources) {
        const std::string_view file = facts.sources->name(span->file);
        place = fmt::format("\n{}:{}", file.substr(file.rfind('/') + 1),
                            facts.sources->position(span->file, span->begin).line);
    }
    tip(Text("{}\n{}{}", name, why, place).view(), focused);
}

std::string amount_of(const Paid& paid) {
    if (paid.frame) {
        const FrameCost& cost = *paid.frame;
        return milliseconds_text(cost.gpu ? *cost.gpu : std::max(cost.cpu, cost.wall)) + " a frame";
    }
    if (paid.kind == Kind::pass) return paid.kept ? "kept" : counted(paid.draws.size(), "draw");
    return paid.bytes > 0 ? bytes_text(paid.bytes) : std::string();
}

// `more`: what follows the number.
bool branch(const char* name, std::size_t count, const std::string& amount, Layout& layout,
            std::string_view more = {}) {
    const float right = ImGui::GetContentRegionMax().x;
    const Text title("{}: {}{}", name, count, more);
    const float taken = amount.empty() ? 0 : width_of(amount) + ImGui::GetStyle().ItemSpacing.x;
    const Text shown = shortened(
        title.view(), std::max(1.0F, ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing() - taken));
    const bool open = ImGui::TreeNodeEx(name, ImGuiTreeNodeFlags_SpanAvailWidth, "%s", shown.c_str());
    toggled_by_keys(open);
    if (!(shown == title.view())) tip(title.view());
    layout.note("costs", name);
    layout.note("costs.title", title.view());
    right_text(amount, right);
    return open;
}

void paid_for(const Facts& facts, Layout& layout) {
    constexpr std::array<std::pair<Kind, const char*>, 10> kinds{{{Kind::image, "Images"},
                                                                  {Kind::cube_map, "Cube maps"},
                                                                  {Kind::empty_texture, "Render targets (textures)"},
                                                                  {Kind::computed, "Computed cube maps"},
                                                                  {Kind::noise, "Noise"},
                                                                  {Kind::mesh, "Meshes"},
                                                                  {Kind::tree, "Bounding volume hierarchies"},
                                                                  {Kind::program, "Programs"},
                                                                  {Kind::target, "Targets"},
                                                                  {Kind::pass, "Passes"}}};
    for (const auto& [kind, title] : kinds) {
        std::size_t count = 0;
        std::uint64_t bytes = 0;
        std::set<Index> programs;
        for (const Paid& paid : facts.explanation->paid)
            if (paid.kind == kind) {
                ++count;
                bytes += paid.bytes;
                programs.insert(paid.programs.begin(), paid.programs.end());
            }
        std::string more;  // some programs have several forms, others share one
        if (!programs.empty() && count > programs.size()) more = fmt::format(", in {} forms", count);
        if (count < programs.size()) more = fmt::format(", {} compiled", count);
        if (!programs.empty()) count = programs.size();
        if (count == 0 || !branch(title, count, bytes > 0 ? bytes_text(bytes) : "", layout, more)) continue;
        for (const Paid& paid : facts.explanation->paid)
            if (paid.kind == kind) {
                const std::string loaded =
                    paid.load_ms ? fmt::format("\nloading time: {}", milliseconds_text(*paid.load_ms)) : "";
                const std::size_t others = std::max<std::size_t>(paid.programs.size(), 1) - 1;
                const std::string name = others > 0 ? fmt::format("{} and {} more", paid.name, others) : paid.name;
                line(facts, name, amount_of(paid), paid.why + loaded, paid.span, layout);
            }
        ImGui::TreePop();
    }
}

void switched_off(const Facts& facts, Layout& layout) {
    const auto& rows = facts.explanation->switched_off;
    if (rows.empty() || !branch("Switched off by values", rows.size(), "", layout)) return;
    for (const Explanation::SwitchedOff& row : rows) {
        const std::string by = row.uniform.empty() ? fmt::format("values of {} together", row.program_name)
                                                   : fmt::format("{} = {}", row.uniform, row.value);
        std::string what = "program " + row.program_name;
        for (const auto& part : row.parts)
            what += "\n" + (part.functions.empty() ? fmt::format("{} {}", name(part.kind), part.name)
                                                   : fmt::format("{}, {}", part.name, fmt::join(part.functions, ", ")));
        line(facts, by, counted(row.parts.size(), "item"), what, row.span, layout);
    }
    ImGui::TreePop();
}

void not_paid_for(const Facts& facts, Layout& layout) {
    const Explanation& explanation = *facts.explanation;
    if (!explanation.unpaid.empty() && branch("Not loaded", explanation.unpaid.size(), "", layout)) {
        for (const Explanation::Unpaid& unpaid : explanation.unpaid)
            line(facts, unpaid.name, "", unpaid.why, {}, layout);
        ImGui::TreePop();
    }
    if (!explanation.unused.empty() && branch("Declared but unused", explanation.unused.size(), "", layout)) {
        for (const Explanation::Unused& unused : explanation.unused)
            line(facts, unused.name, "", unused.why, unused.span, layout);
        ImGui::TreePop();
    }
}

}  // namespace

std::string bytes_text(std::uint64_t bytes) {
    const auto count = static_cast<double>(bytes);
    if (bytes < 1000) return fmt::format("{} B", bytes);
    if (count < 999.5e3) return fmt::format("{:.{}f} kB", count / 1e3, count < 9.95e3 ? 1 : 0);
    return fmt::format("{:.{}f} MB", count / 1e6, count < 9.95e6 ? 1 : 0);
}

void costs_section(const Facts& facts, Memory& memory, Layout& layout) {
    memory.costs = section("Costs", "What the scene keeps in memory and why, and what it never uses", memory.open,
                           layout, "costs");
    if (!memory.costs || !facts.explanation) return;
    std::uint64_t bytes = 0;
    for (const Paid& paid : facts.explanation->paid) bytes += paid.bytes;
    fitted(bytes_text(bytes) + " of GPU memory", ImGui::GetContentRegionAvail().x);
    wrapped("redrawn " + facts.explanation->redraw, true);
    paid_for(facts, layout);
    switched_off(facts, layout);
    not_paid_for(facts, layout);
}

}  // namespace snell::ui
