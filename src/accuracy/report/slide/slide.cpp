#include "src/accuracy/report/slide/slide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "parser/text/ranges.h"
#include "src/accuracy/report/slide/choose.h"
#include "src/accuracy/report/slide/crops.h"

namespace snell::accuracy {

namespace {

constexpr int window_width = 96, window_height = 64, whole_side = 380;

bool has_errors(const SweepResult& sweep) {
    return sweep.cannot_say.empty() && ranges::any_of(sweep.rungs, [](const RungResult& rung) {
               return rung.drawn && !std::isnan(rung.whole.light.rmse);
           });
}

// Combinations, then ladders, then knobs; of these the one in which most can be gained.
const SweepResult* main_sweep(const Report& report) {
    const auto rank = [](const SweepResult& sweep) {
        const RungResult& own = sweep.rungs[sweep.sweep.current];
        const double error = own.drawn && std::isfinite(own.whole.light.rmse) ? own.whole.light.rmse : -1;
        const int kind = sweep.sweep.kind == SweepKind::lattice ? 2 : sweep.sweep.kind == SweepKind::ladder ? 1 : 0;
        return std::pair(kind, error);
    };
    const SweepResult* best = nullptr;
    for (const SweepResult& sweep : report.sweeps)
        if (has_errors(sweep) && (!best || rank(sweep) > rank(*best))) best = &sweep;
    return best;
}

// Their errors are on one scale, and so are their times.
bool comparable(const SweepResult& a, const SweepResult& b) {
    return a.scene == b.scene && a.clock == b.clock && a.reference == b.reference;
}

bool same_picture(const RungResult& a, const RungResult& b) {
    return !a.picture.rgba.empty() && a.picture == b.picture;
}

// The same combination occurs in several sweeps, such as the last rungs of all ladders.
bool already_there(const std::vector<SlideRung>& rungs, const SweepResult& sweep, std::size_t rung) {
    const auto drawn_as = [](const SweepResult& of, std::size_t i) -> const Variant& {
        return of.sweep.rungs[i].variant;
    };
    const Variant& variant = drawn_as(sweep, rung);
    return ranges::any_of(rungs, [&](const SlideRung& other) {
        const Variant& known = drawn_as(*other.sweep, other.rung);
        return other.sweep != &sweep && known.rungs == variant.rungs && known.knobs == variant.knobs &&
               same_picture(other.result(), sweep.rungs[rung]);
    });
}

std::vector<SlideRung> rungs_of(const std::vector<const SweepResult*>& sweeps, double floor) {
    std::vector<SlideRung> result;
    for (const SweepResult* sweep : sweeps)
        for (std::size_t i = 0; i < sweep->rungs.size(); ++i) {
            const RungResult& rung = sweep->rungs[i];
            const double error = rung.whole.light.rmse;
            if (!rung.drawn || std::isnan(error) || already_there(result, *sweep, i)) continue;
            SlideRung entry{sweep, i, {}};
            entry.point.name = sweeps.size() > 1 ? sweep->sweep.name + " " + rung.name : rung.name;
            entry.point.error = std::max(error, floor);
            entry.point.own = sweep == sweeps.front() && i == sweep->sweep.current;
            if (rung.rounds > 0) {
                entry.point.milliseconds = rung.milliseconds;
                entry.point.low = rung.low;
                entry.point.high = rung.high;
            }
            result.push_back(std::move(entry));
        }
    const std::vector<bool> front = common_front(result);
    for (std::size_t i = 0; i < result.size(); ++i) result[i].point.front = front[i];
    return result;
}

// The next of 1, 2 and 5 times a power of ten that is not below what all but the largest fiftieth of the values reach.
double scale_for(std::vector<float> values) {
    constexpr double least = .01;
    if (values.empty()) return least;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 49 / 50);
    std::nth_element(values.begin(), at, values.end());
    const double wanted = std::max(static_cast<double>(*at), least);
    const double power = std::pow(10, std::floor(std::log10(wanted) + 1e-9));
    for (double step : {1., 2., 5.})
        if (wanted <= step * power * 1.0001) return step * power;
    return 10 * power;
}

Window scaled(const Window& window, const Picture& from, const Raster& to) {
    const auto at = [](int value, int all, int of) {
        return static_cast<int>(std::lround(static_cast<double>(value) * of / all));
    };
    return {at(window.x, from.width, to.width), at(window.y, from.height, to.height),
            std::max(at(window.width, from.width, to.width), 1),
            std::max(at(window.height, from.height, to.height), 1)};
}

// The pictures of the columns, their maps, and where they are from.
void add_pictures(Slide& slide, const std::vector<const Picture*>& pictures, const Picture& reference) {
    slide.whole = reduced(reference, whole_side, whole_side);
    if (pictures.empty()) return;
    std::vector<float> differences = disagreement(pictures, reference);
    if (ranges::none_of(differences, [](float d) { return d > 0; }))
        differences = disagreement(std::span(pictures).first(1), reference);
    const Window window = largest_window(differences, reference.width, reference.height, window_width, window_height);
    slide.window = scaled(window, reference, slide.whole);
    slide.reference = crop(reference, window);
    std::vector<std::vector<float>> maps;
    std::vector<float> all;
    for (const Picture* picture : pictures) {
        maps.push_back(flip_in(*picture, reference, window));
        all.insert(all.end(), maps.back().begin(), maps.back().end());
    }
    slide.scale = scale_for(std::move(all));
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        slide.columns[i].picture = crop(*pictures[i], window);
        slide.columns[i].map = colored(maps[i], window, slide.scale);
    }
}

void add_columns(Slide& slide, std::vector<SlideRung>& rungs, const SweepResult& main) {
    const Picture& reference = main.reference.rgba.empty() ? main.rungs[main.sweep.reference].picture : main.reference;
    if (reference.rgba.empty()) return;
    const auto own = ranges::find_if(rungs, [](const SlideRung& rung) { return rung.point.own; });
    std::vector<const Picture*> pictures;
    for (const ColumnChoice& choice : choose_columns(rungs, static_cast<std::size_t>(own - rungs.begin()))) {
        SlidePoint& point = rungs[choice.rung].point;
        const Picture& picture = rungs[choice.rung].result().picture;
        if (picture.width != reference.width || picture.height != reference.height) continue;
        point.column = slide.columns.size();
        slide.columns.push_back(
            {point.name, point.error, point.milliseconds, point.own, choice.equal_time, choice.equal_error, {}, {}});
        pictures.push_back(&picture);
    }
    add_pictures(slide, pictures, reference);
}

}  // namespace

Slide slide_of(const Report& report) {
    Slide slide;
    const SweepResult* const main = main_sweep(report);
    if (!main) return slide;
    std::vector<const SweepResult*> sweeps{main};
    for (const SweepResult& sweep : report.sweeps)
        if (&sweep != main && has_errors(sweep) && comparable(sweep, *main)) sweeps.push_back(&sweep);
    for (const SweepResult* sweep : sweeps) slide.floor = std::max(slide.floor, sweep->whole_residual.value_or(0));
    std::vector<SlideRung> rungs = rungs_of(sweeps, slide.floor);
    add_columns(slide, rungs, *main);
    for (SlideRung& rung : rungs)
        if (rung.timed()) slide.points.push_back(std::move(rung.point));
    slide.title = std::filesystem::path(main->scene).stem().string();
    slide.note = fmt::format("{} × {}, {}", report.where.width, report.where.height, report.where.renderer);
    slide.clock = name(main->clock);
    if (ranges::none_of(slide.points, &SlidePoint::front))
        slide.stamp = slide.points.empty() ? "no times were measured"
                      : main->few_rounds   ? "too few rounds: no front"
                                           : "too noisy: no front";
    return slide;
}

std::optional<SlideFormat> slide_format(std::string_view path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (ending == ".png") return SlideFormat::png;
    if (ending == ".svg") return SlideFormat::svg;
    if (ending == ".pdf") return SlideFormat::pdf;
    return std::nullopt;
}

}  // namespace snell::accuracy
