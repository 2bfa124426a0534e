#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "src/ui/kit/numbers.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/accuracy.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

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
          const std::optional<Span>& span) {
    const float width = ImGui::GetContentRegionAvail().x, right = ImGui::GetCursorPosX() + width;
    const float taken = amount.empty() ? 0 : width_of(amount) + ImGui::GetStyle().ItemSpacing.x;
    ImGui::BeginGroup();
    fitted(name, width - taken);
    right_text(amount, right);
    ImGui::EndGroup();
    if (!ImGui::IsItemHovered()) return;
    std::string place;
    if (span && facts.sources) {
        const std::string_view file = facts.sources->name(span->file);
        place = fmt::format("\n{}:{}", file.substr(file.rfind('/') + 1),
                            facts.sources->position(span->file, span->begin).line);
    }
    tip(Text("{}\n{}{}", name, why, place).view());
}

std::string amount_of(const Paid& paid) {
    if (paid.frame) {
        const FrameCost& cost = *paid.frame;
        return milliseconds_text(cost.gpu ? *cost.gpu : std::max(cost.cpu, cost.wall));
    }
    if (paid.kind == Kind::pass) return paid.kept ? "kept" : counted(paid.draws.size(), "draw");
    return paid.bytes > 0 ? bytes_text(paid.bytes) : std::string();
}

bool branch(const char* name, std::size_t count, const std::string& amount, Layout& layout) {
    const float right = ImGui::GetContentRegionMax().x;
    const bool open = ImGui::TreeNodeEx(name, ImGuiTreeNodeFlags_SpanAvailWidth, "%s: %zu", name, count);
    layout.note("costs", name);
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
        for (const Paid& paid : facts.explanation->paid)
            if (paid.kind == kind) {
                ++count;
                bytes += paid.bytes;
            }
        if (count == 0 || !branch(title, count, bytes > 0 ? bytes_text(bytes) : "", layout)) continue;
        for (const Paid& paid : facts.explanation->paid)
            if (paid.kind == kind) {
                const std::string loaded =
                    paid.load_ms ? fmt::format("\nloading time: {}", milliseconds_text(*paid.load_ms)) : "";
                line(facts, paid.name, amount_of(paid), paid.why + loaded, paid.span);
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
        line(facts, by, counted(row.parts.size(), "item"), what, row.span);
    }
    ImGui::TreePop();
}

void not_paid_for(const Facts& facts, Layout& layout) {
    const Explanation& explanation = *facts.explanation;
    if (!explanation.unpaid.empty() && branch("Not loaded", explanation.unpaid.size(), "", layout)) {
        for (const Explanation::Unpaid& unpaid : explanation.unpaid) line(facts, unpaid.name, "", unpaid.why, {});
        ImGui::TreePop();
    }
    if (!explanation.unused.empty() && branch("Declared but unused", explanation.unused.size(), "", layout)) {
        for (const Explanation::Unused& unused : explanation.unused)
            line(facts, unused.name, "", unused.why, unused.span);
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
    memory.costs = section("Costs", memory.open, layout, "costs");
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
