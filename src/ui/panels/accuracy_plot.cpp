// The plot of error over time as the window paints it.
#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cfloat>
#include <cmath>
#include <string_view>

#include "parser/text/ranges.h"
#include "src/content/plot/plot.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/accuracy.h"

namespace snell::ui {

namespace {

using Standing = AccuracyPoint::Standing;
using content::Ink, content::Mark, content::MarkKind;

std::string label_of(const AccuracyPoint& point) { return point.name + (point.reference ? " = reference" : ""); }

ImVec4 color_of(Ink ink) {
    const Palette& colors = palette();
    switch (ink) {
        case Ink::paper:
            return colors.panel;
        case Ink::grid:
        case Ink::band:
            return colors.track;
        case Ink::front:
            return colors.accent;
        case Ink::wrong:
            return colors.error_text;
        default:
            return colors.dim;
    }
}

void paint(ImDrawList& list, const Mark& mark) {
    const auto place = [](double x, double y) { return ImVec2(static_cast<float>(x), static_cast<float>(y)); };
    const ImVec2 from = place(mark.at.x0, mark.at.y0), to = place(mark.at.x1, mark.at.y1),
                 middle = place((mark.at.x0 + mark.at.x1) / 2, (mark.at.y0 + mark.at.y1) / 2);
    const auto stroke = static_cast<float>(mark.stroke), radius = static_cast<float>(mark.at.width() / 2);
    const ImU32 color = pack(color_of(mark.ink));
    if (mark.kind == MarkKind::line)
        list.AddLine(from, to, color, stroke);
    else if (mark.kind == MarkKind::text)
        list.AddText(ImGui::GetFont(), static_cast<float>(mark.size), from, color, mark.text.data(),
                     mark.text.data() + mark.text.size());
    else if (mark.kind == MarkKind::disc && mark.stroke > 0)
        list.AddCircle(middle, radius, color, 0, stroke);
    else if (mark.kind == MarkKind::disc)
        list.AddCircleFilled(middle, radius, color);
    else if (mark.kind == MarkKind::box && mark.stroke > 0)
        list.AddRect(from, to, color, 0, 0, stroke);
    else if (mark.kind == MarkKind::box)
        list.AddRectFilled(from, to, color);
}

content::PlotPoint plotted(const AccuracyPoint& point) {
    return {.name = label_of(point),
            .error = point.error,
            .milliseconds = point.milliseconds,
            .low = point.low,
            .high = point.high,
            .front = point.standing == Standing::front,
            .beaten = point.standing == Standing::dominated || point.standing == Standing::saves_none,
            .chosen = point.chosen,
            .label = point.rung ? std::optional(0) : std::nullopt};
}

}  // namespace

void accuracy_plot(const std::vector<AccuracyPoint>& points, Layout& layout) {
    const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorScreenPos(), size(width, 12 * em);
    ImGui::InvisibleButton("##plot", size);
    layout.note("accuracy.plot");
    std::vector<const AccuracyPoint*> shown;
    content::Plot plot{.points = {}, .errors = "error (1 is white)", .times = "ms/sample", .decades = .5};
    for (const AccuracyPoint& point : points)
        if (point.milliseconds > 0 && !std::isnan(point.error)) {  // an error that is unknown has no place
            shown.push_back(&point);
            plot.points.push_back(plotted(point));
        }
    content::Page page([](const std::string& text, double letters, bool) {
        return static_cast<double>(
            ImGui::GetFont()->CalcTextSizeA(static_cast<float>(letters), FLT_MAX, 0, text.c_str()).x);
    });
    const auto places = draw_plot(page, plot, {at.x, at.y, at.x + size.x - .2F * em, at.y + size.y}, em);
    for (const Mark& mark : page.marks) paint(*ImGui::GetWindowDrawList(), mark);
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto distance = [&](const std::pair<double, double>& place) {
        return std::hypot(place.first - mouse.x, place.second - mouse.y);
    };
    const auto nearest = ranges::min_element(places, {}, distance);
    if (nearest == places.end() || distance(*nearest) >= em) return;
    const AccuracyPoint& point = *shown[static_cast<std::size_t>(nearest - places.begin())];
    tip(Text("{}: {}, error {} of white{}{}", label_of(point), milliseconds_text(point.milliseconds),
             error_text(point.error), point.standing == Standing::visited ? "" : "\n", standing_text(point))
            .view());
}

}  // namespace snell::ui
