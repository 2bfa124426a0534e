// Plots error over time on logarithmic axes; points without error are on the lowest line.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "parser/text/ranges.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/accuracy.h"

namespace snell::ui {

namespace {

using Standing = AccuracyPoint::Standing;

// An error that is unknown has no place, least of all that of 0.
bool has_place(const AccuracyPoint& point) { return point.milliseconds > 0 && !std::isnan(point.error); }

// The range of an axis, in powers of ten.
struct Range {
    double low = 0, high = 1;
    float part(double value) const { return static_cast<float>((std::log10(value) - low) / (high - low)); }
};

// The range that contains all values with a margin; at least `span` powers of ten.
template <typename Values>
Range range_of(const std::vector<AccuracyPoint>& points, double span, Range otherwise, Values values) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const AccuracyPoint& point : points)
        for (double value : values(point))
            if (value > 0 && std::isfinite(value)) {
                low = std::min(low, std::log10(value));
                high = std::max(high, std::log10(value));
            }
    if (low > high) return otherwise;
    const double air = std::max(.08 * (high - low), (span - (high - low)) / 2);
    return {low - air, high + air};
}

struct Plot {
    ImVec2 min, max;  // corners of the area within the axes
    float floor = 0;  // y of the line for points without error
    Range time, error;

    ImVec2 place(const AccuracyPoint& point) const {
        const float x = min.x + (max.x - min.x) * time.part(point.milliseconds);
        const float y = point.error > 0 ? floor_top() - (floor_top() - min.y) * error.part(point.error) : floor;
        return {x, std::clamp(y, min.y, floor)};
    }
    float x(double milliseconds) const {
        return std::clamp(min.x + (max.x - min.x) * time.part(milliseconds), min.x, max.x);
    }
    float floor_top() const { return floor - ImGui::GetFontSize() * 1.1F; }
};

void text_at(ImDrawList& list, ImVec2 at, ImVec4 color, std::string_view text) {
    list.AddText(at, pack(color), text.data(), text.data() + text.size());
}

void axes(ImDrawList& list, const Plot& plot) {
    const Palette& colors = palette();
    const float em = ImGui::GetFontSize();
    list.AddLine({plot.min.x, plot.min.y}, {plot.min.x, plot.max.y}, pack(colors.rule));
    list.AddLine({plot.min.x, plot.max.y}, {plot.max.x, plot.max.y}, pack(colors.rule));
    float last = -HUGE_VALF;
    for (int power = static_cast<int>(std::floor(plot.time.low)); power <= plot.time.high; ++power)
        for (int digit : {1, 2, 5}) {
            const double value = digit * std::pow(10, power);
            const float part = plot.time.part(value);
            if (part < 0 || part > 1) continue;
            const float x = plot.min.x + (plot.max.x - plot.min.x) * part;
            const std::string text = fmt::format("{:g}", value);
            const float width = ImGui::CalcTextSize(text.c_str()).x;
            if (x - width / 2 < last || x + width / 2 > plot.max.x - 5.5F * em) continue;
            list.AddLine({x, plot.max.y}, {x, plot.max.y + em * .2F}, pack(colors.rule));
            text_at(list, {x - width / 2, plot.max.y + em * .15F}, colors.dim, text);
            last = x + width / 2 + em * .5F;
        }
    text_at(list, {plot.max.x - ImGui::CalcTextSize("ms/sample").x, plot.max.y + em * .15F}, colors.dim, "ms/sample");
    const bool narrow = plot.error.high - plot.error.low < 2;
    for (int power = static_cast<int>(std::floor(plot.error.low)); power <= plot.error.high; ++power)
        for (int digit : {1, 2, 5}) {
            const double value = digit * std::pow(10, power);
            const float part = plot.error.part(value);
            if ((digit > 1 && !narrow) || part < 0 || part > 1) continue;
            const float y = plot.floor_top() - (plot.floor_top() - plot.min.y) * part;
            const std::string text = error_text(value);
            list.AddLine({plot.min.x, y}, {plot.max.x, y}, pack(colors.track));
            text_at(list, {plot.min.x - ImGui::CalcTextSize(text.c_str()).x - em * .3F, y - em * .5F}, colors.dim,
                    text);
        }
    text_at(list, {plot.min.x - ImGui::CalcTextSize("0").x - em * .3F, plot.floor - em * .5F}, colors.dim, "0");
}

// Draws the front as a staircase, because there are no choices between two rungs.
void front_line(ImDrawList& list, const Plot& plot, const std::vector<AccuracyPoint>& points) {
    std::vector<ImVec2> corners;
    for (const AccuracyPoint& point : points)
        if (point.standing == Standing::front && has_place(point)) corners.push_back(plot.place(point));
    ranges::sort(corners, {}, [](const ImVec2& p) { return p.x; });
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        list.AddLine(corners[i], {corners[i + 1].x, corners[i].y}, pack(palette().filled), 2);
        list.AddLine({corners[i + 1].x, corners[i].y}, corners[i + 1], pack(palette().filled), 2);
    }
}

void mark(ImDrawList& list, const Plot& plot, const AccuracyPoint& point) {
    const Palette& colors = palette();
    const ImVec2 at = plot.place(point);
    const float radius = ImGui::GetFontSize() * (point.rung ? .28F : .18F);
    const ImU32 color = pack(point.standing == Standing::front ? colors.accent : colors.dim);
    if (point.high > point.low) list.AddLine({plot.x(point.low), at.y}, {plot.x(point.high), at.y}, color, 1.5F);
    if (point.standing == Standing::dominated || point.standing == Standing::saves_none) {
        list.AddCircleFilled(at, radius, pack(colors.panel));
        list.AddCircle(at, radius, color, 0, 1.5F);
    } else {
        list.AddCircleFilled(at, radius, color);
    }
    if (point.reference) {  // a square around it, that stands on a corner
        const float far = radius * 2.2F;
        list.AddQuad({at.x - far, at.y}, {at.x, at.y - far}, {at.x + far, at.y}, {at.x, at.y + far}, color, 1.5F);
    }
    if (point.chosen) list.AddCircle(at, radius * 1.8F, pack(colors.text), 0, 1.5F);
}

std::string label_of(const AccuracyPoint& point) { return point.name + (point.reference ? " = reference" : ""); }

// Draws names next to their points, if the place is free.
void names(ImDrawList& list, const Plot& plot, const std::vector<AccuracyPoint>& points) {
    const float em = ImGui::GetFontSize();
    std::vector<Rect> taken;
    for (const AccuracyPoint& point : points) {
        const ImVec2 at = plot.place(point);
        taken.push_back({at.x - em * .3F, at.y - em * .3F, em * .6F, em * .6F});
    }
    const auto overlap = [](const Rect& a, const Rect& b) {
        return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
    };
    for (const AccuracyPoint& point : points) {
        if (!point.rung || !has_place(point)) continue;
        const std::string name = label_of(point);
        const ImVec2 at = plot.place(point), size = ImGui::CalcTextSize(name.c_str());
        const float off = em * .65F;
        for (const ImVec2 corner :
             {ImVec2(at.x + off, at.y - size.y / 2), ImVec2(at.x - off - size.x, at.y - size.y / 2),
              ImVec2(at.x - size.x / 2, at.y - size.y - off * .6F)}) {
            const Rect box{corner.x, corner.y, size.x, size.y};
            if (box.x < plot.min.x || box.x + box.width > plot.max.x || box.y < plot.min.y - em * .5F) continue;
            if (ranges::any_of(taken, [&](const Rect& other) { return overlap(box, other); })) continue;
            text_at(list, corner, point.chosen ? palette().text : palette().dim, name);
            taken.push_back(box);
            break;
        }
    }
}

void explain_nearest(const Plot& plot, const std::vector<AccuracyPoint>& points) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const AccuracyPoint* nearest = nullptr;
    float closest = ImGui::GetFontSize();
    for (const AccuracyPoint& point : points) {
        if (!has_place(point)) continue;
        const ImVec2 at = plot.place(point);
        const float distance = std::hypot(at.x - mouse.x, at.y - mouse.y);
        if (distance >= closest) continue;
        closest = distance;
        nearest = &point;
    }
    if (!nearest) return;
    tip(Text("{}: {}, error {} of white{}{}", label_of(*nearest), milliseconds_text(nearest->milliseconds),
             error_text(nearest->error), nearest->standing == Standing::visited ? "" : "\n", standing_text(*nearest))
            .view());
}

}  // namespace

void accuracy_plot(const std::vector<AccuracyPoint>& points, Layout& layout) {
    const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorScreenPos(), size(width, 11.3F * em);
    ImGui::InvisibleButton("##plot", size);
    layout.note("accuracy.plot");
    Plot plot;
    plot.min = {at.x + 3.2F * em, at.y + em * 1.7F};
    plot.max = {at.x + size.x - em * .2F, at.y + size.y - 1.4F * em};
    plot.floor = plot.max.y - em * .5F;
    plot.time = range_of(points, .5, {0, 2}, [](const AccuracyPoint& p) {
        return std::array{p.milliseconds, p.low, p.high};
    });
    plot.error = range_of(points, 1, {-3, 0}, [](const AccuracyPoint& p) { return std::array{p.error}; });
    ImDrawList& list = *ImGui::GetWindowDrawList();
    text_at(list, {at.x, at.y - em * .1F}, palette().dim, "error (1 is white)");
    axes(list, plot);
    front_line(list, plot, points);
    for (const AccuracyPoint& point : points)
        if (has_place(point)) mark(list, plot, point);
    names(list, plot, points);
    if (ImGui::IsItemHovered()) explain_nearest(plot, points);
}

}  // namespace snell::ui
