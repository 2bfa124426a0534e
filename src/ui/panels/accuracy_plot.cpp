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

void draw(const std::vector<AccuracyPoint>& points, std::array<float, 3> at, float em, AccuracyPlot& drawn) {
    drawn = {.points = points, .at = at, .letters = em, .marks = {}, .shown = {}, .places = {}};
    content::Plot plot{.points = {}, .errors = "error (1 is white)", .times = "ms/sample", .decades = .5};
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].milliseconds > 0 && !std::isnan(points[i].error)) {  // an error that is unknown has no place
            drawn.shown.push_back(i);
            plot.points.push_back(plotted(points[i]));
        }
    content::Page page([](const std::string& text, double letters, bool) {
        return static_cast<double>(
            ImGui::GetFont()->CalcTextSizeA(static_cast<float>(letters), FLT_MAX, 0, text.c_str()).x);
    });
    drawn.places = draw_plot(page, plot, {at[0], at[1], at[0] + at[2] - .2F * em, at[1] + 12 * em}, em);
    drawn.marks = std::move(page.marks);
}

}  // namespace

void accuracy_plot(const std::vector<AccuracyPoint>& points, AccuracyPlot& plot, Layout& layout) {
    const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("##plot", {width, 12 * em});
    layout.note("accuracy.plot");
    const std::array at{corner.x, corner.y, width};
    if (plot.marks.empty() || plot.at != at || plot.letters != em || plot.points != points) draw(points, at, em, plot);
    for (const Mark& mark : plot.marks) paint(*ImGui::GetWindowDrawList(), mark);
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto distance = [&](const std::pair<double, double>& place) {
        return std::hypot(place.first - mouse.x, place.second - mouse.y);
    };
    const auto nearest = ranges::min_element(plot.places, {}, distance);
    if (nearest == plot.places.end() || distance(*nearest) >= em) return;
    const AccuracyPoint& point = points[plot.shown[static_cast<std::size_t>(nearest - plot.places.begin())]];
    tip(Text("{}: {}, error {} of white{}{}", label_of(point), milliseconds_text(point.milliseconds),
             error_text(point.error), point.standing == Standing::visited ? "" : "\n", standing_text(point))
            .view());
}

}  // namespace snell::ui
