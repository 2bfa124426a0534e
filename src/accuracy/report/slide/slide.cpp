#include "src/accuracy/report/slide/slide.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/content/image/image.h"

namespace snell::accuracy {

namespace {

using content::PlotPoint;

// Which rungs a slide shows, and next to which.

// A rung of the report, as a point of the slide.
struct SlideRung {
    const SweepResult* sweep;
    std::size_t rung;
    content::PlotPoint point;

    const RungResult& result() const { return sweep->rungs[rung]; }
    bool timed() const { return point.milliseconds > 0; }
};

constexpr std::size_t most_columns = 5;

// A rung in a column, as an index.
struct ColumnChoice {
    std::size_t rung = 0;
    bool equal_time = false, equal_error = false;
};

constexpr double equal_times = .25, equal_errors = 1.1, different_errors = 1.02, invisible_flip = .02;
constexpr std::size_t most_equals = 2;  // next to the scene's own rung

// Whether a rung of one sweep draws the same as one of another: the same rungs of ladders and knobs, no text changed.
bool same_variant(const SweepResult& a, std::size_t i, const SweepResult& b, std::size_t j) {
    const auto changed = [](const SweepResult& of, std::size_t rung) {
        return of.sweep.kind == SweepKind::found && rung != of.sweep.current;
    };
    // What a knob calls the scene's own may be written out, such as "nearest".
    const auto knobs = [](const SweepResult& of, std::size_t rung) {
        return rung == of.sweep.current ? Knobs{} : of.sweep.rungs[rung].variant.knobs;
    };
    return !changed(a, i) && !changed(b, j) && a.sweep.rungs[i].variant.rungs == b.sweep.rungs[j].variant.rungs &&
           knobs(a, i) == knobs(b, j);
}

Cost by_intervals(const SlideRung& a, const SlideRung& b, double within) {
    const PlotPoint &p = a.point, &q = b.point;
    if (!p.has_interval() || !q.has_interval()) return Cost::not_told;
    return compare_costs({p.low / q.high, p.milliseconds / q.milliseconds, p.high / q.low},
                         std::max(a.sweep->control.noise, b.sweep->control.noise), within);
}

bool is_base(const SlideRung& rung) { return rung.rung == rung.sweep->sweep.current; }

// What a table says, if one has both; points of several sweeps have no rounds in common but those of the scene.
Cost cost_of(const SlideRung& a, const SlideRung& b) {
    if (a.sweep == b.sweep) return a.sweep->costs.of(a.rung, b.rung);
    const bool one_base = same_variant(*a.sweep, a.sweep->sweep.current, *b.sweep, b.sweep->sweep.current);
    if (one_base && is_base(b)) return a.sweep->costs.of(a.rung, a.sweep->sweep.current);
    if (one_base && is_base(a)) return b.sweep->costs.of(b.sweep->sweep.current, b.rung);
    return by_intervals(a, b, same_cost);
}

// By which factor the larger exceeds the smaller; infinite if only one is 0.
double factor(double a, double b) {
    if (a == b) return 1;
    return std::max(a, b) / std::min(a, b);
}

bool same_time(const SlideRung& a, const SlideRung& b) { return by_intervals(a, b, equal_times) == Cost::equal; }

bool same_error(const PlotPoint& a, const PlotPoint& b) { return factor(a.error, b.error) <= equal_errors; }

// The columns that are chosen, one kind after the other.
class Chooser {
public:
    Chooser(const std::vector<SlideRung>& rungs, std::size_t own) : rungs_(rungs), own_(own) {}

    std::vector<ColumnChoice> choose() {
        std::vector<std::size_t> equal_time, equal_error, others;
        const bool has_own = own_ < rungs_.size() && shows_anything(own_);
        if (has_own) {
            shown_.push_back(own_);
            add_equal(equal_time, equal_error);
        }
        add_others(others);
        ranges::stable_sort(others, {}, [&](std::size_t i) { return point(i).milliseconds; });
        std::vector<ColumnChoice> columns;
        const auto cheaper = [&](std::size_t i) { return has_own && point(i).milliseconds < own().milliseconds; };
        for (const std::size_t i : others)
            if (cheaper(i)) columns.push_back({i});
        for (const std::size_t i : equal_time) columns.push_back({i, true, false});
        if (has_own) columns.push_back({own_, !equal_time.empty(), !equal_error.empty()});
        for (const std::size_t i : equal_error) columns.push_back({i, false, true});
        for (const std::size_t i : others)
            if (!cheaper(i)) columns.push_back({i});
        return columns;
    }

private:
    const PlotPoint& point(std::size_t i) const { return rungs_[i].point; }
    const PlotPoint& own() const { return point(own_); }

    bool shows_anything(std::size_t i) const {
        return !rungs_[i].result().picture.rgba.empty() && std::isfinite(point(i).error);
    }
    // Those with pictures that fulfil the condition, with the smallest `value` first.
    template <class Condition, class Value>
    std::vector<std::size_t> those(const Condition& condition, const Value& value) const {
        std::vector<std::size_t> result;
        for (std::size_t i = 0; i < rungs_.size(); ++i)
            if (i != own_ && shows_anything(i) && condition(rungs_[i])) result.push_back(i);
        ranges::stable_sort(result, {}, [&](std::size_t i) { return value(rungs_[i]); });
        return result;
    }
    // A picture that is shown already tells nothing again.
    void add(std::vector<std::size_t>& to, const std::vector<std::size_t>& from, std::size_t most = most_columns) {
        for (const std::size_t i : from) {
            const auto same = [&](std::size_t j) { return rungs_[i].result().picture == rungs_[j].result().picture; };
            if (to.size() >= most || shown_.size() >= most_columns || ranges::any_of(shown_, same)) continue;
            to.push_back(i);
            shown_.push_back(i);
        }
    }

    static double error(const SlideRung& rung) { return rung.point.error; }
    static double time(const SlideRung& rung) { return rung.point.milliseconds; }

    // Of equal time: the most exact; then the first rung of a ladder, or the nearest. Of equal error: the cheapest,
    // then the one with the nearest error.
    void add_equal(std::vector<std::size_t>& equal_time, std::vector<std::size_t>& equal_error) {
        const auto as_fast = [&](const SlideRung& rung) {
            return same_time(rung, rungs_[own_]) && factor(rung.point.error, own().error) > different_errors;
        };
        add(equal_time, those(as_fast, error), 1);
        add(equal_time,
            those(as_fast,
                  [&](const SlideRung& rung) {
                      const bool first = rung.rung == 0 && rung.sweep->sweep.kind == SweepKind::ladder;
                      return first ? 0 : factor(rung.point.milliseconds, own().milliseconds);
                  }),
            most_equals);
        const auto as_good = [&](const SlideRung& rung) {
            const Cost cost = cost_of(rung, rungs_[own_]);
            return (cost == Cost::cheaper || cost == Cost::dearer) && same_error(rung.point, own());
        };
        add(equal_error, those(as_good, time), 1);
        add(equal_error, those(as_good, [&](const SlideRung& rung) { return factor(rung.point.error, own().error); }),
            most_equals);
    }

    // The best bargain: the cheapest on the front that halves the error of the scene's own rung; if that has none, the
    // cheapest whose error is hardly seen. Then the ends of the main ladder, and the front.
    void add_others(std::vector<std::size_t>& others) {
        if (rungs_.empty()) return;
        const bool exact = own_ >= rungs_.size() || own().error == 0 || rungs_[own_].result().below_residual;
        auto bargains = those(
            [&](const SlideRung& rung) {
                return rung.point.front &&
                       (exact ? rung.result().flip <= invisible_flip : error(rung) <= own().error / 2);
            },
            time);
        bargains.resize(std::min<std::size_t>(bargains.size(), 1));
        add(others, bargains);
        const SweepResult* main = rungs_[own_ < rungs_.size() ? own_ : 0].sweep;
        const auto is = [&](std::size_t n) {
            return [main, n](const SlideRung& rung) { return rung.sweep == main && rung.rung == n; };
        };
        if (main->sweep.kind == SweepKind::ladder || main->sweep.kind == SweepKind::knob)
            add(others, those(is(0), time));
        add(others, those(is(main->sweep.reference), time));
        add(others, those([](const SlideRung& rung) { return rung.point.front; }, time));
        if (shown_.empty()) add(others, those([](const SlideRung&) { return true; }, error));
    }

    const std::vector<SlideRung>& rungs_;
    std::size_t own_;
    std::vector<std::size_t> shown_;
};

bool may_be_on_front(const SlideRung& rung) {
    return rung.timed() && rung.sweep->on_front(rung.result()) && std::isfinite(rung.point.error);
}

// `b` makes `a` superfluous.
bool beaten(const SlideRung& a, const SlideRung& b) {
    const Cost cost = cost_of(b, a);
    const double error = b.point.error, other = a.point.error;
    return (cost == Cost::cheaper && error <= 1.001 * other) || (cost != Cost::dearer && error < .99 * other);
}

// The columns from left to right. `own` is the index of the scene's own rung, or the number of rungs if it was not
// drawn.
//   Equal time: that of the scene's own rung, within a quarter; the errors differ.
//   Equal error: within a tenth; the times are told apart.
// Of each, at most two others. Where there are fewer, the best bargain, the first and the last rung of the scene's
// ladder and the cheapest of the front may fill the columns; only pictures that differ from those shown do.
std::vector<ColumnChoice> choose_columns(const std::vector<SlideRung>& rungs, std::size_t own) {
    return Chooser(rungs, own).choose();
}

// By the index of a rung, whether it is on the front of all of them: on that of its own sweep, and none of another
// sweep is surely cheaper and not worse, or more exact and not surely more expensive.
std::vector<bool> common_front(const std::vector<SlideRung>& rungs) {
    std::vector<bool> front;
    for (const SlideRung& rung : rungs)
        front.push_back(may_be_on_front(rung) && ranges::none_of(rungs, [&](const SlideRung& other) {
                            const bool judged = other.sweep == rung.sweep && rung.sweep->sweep.kind != SweepKind::found;
                            return &other != &rung && !judged && other.timed() && other.sweep->trusted() &&
                                   beaten(rung, other);
                        }));
    return front;
}

// What is on the slide.

constexpr int window_width = 96, window_height = 64, whole_side = 380;

bool has_errors(const SweepResult& sweep) {
    return sweep.cannot_say.empty() && ranges::any_of(sweep.rungs, [](const RungResult& rung) {
               return rung.drawn && !std::isnan(rung.whole.light.rmse);
           });
}

// Those with times; of these combinations, then ladders, then knobs; of these the one in which most can be gained.
const SweepResult* main_sweep(const Report& report) {
    const auto rank = [](const SweepResult& sweep) {
        const RungResult& own = sweep.rungs[sweep.sweep.current];
        const double error = own.drawn && std::isfinite(own.whole.light.rmse) ? own.whole.light.rmse : -1;
        const int kind = sweep.sweep.kind == SweepKind::lattice ? 2 : sweep.sweep.kind == SweepKind::ladder ? 1 : 0;
        return std::tuple(sweep.timed(), kind, error);
    };
    const SweepResult* best = nullptr;
    for (const SweepResult& sweep : report.sweeps)
        if (has_errors(sweep) && (!best || rank(sweep) > rank(*best))) best = &sweep;
    return best;
}

bool same_clock(const SweepResult& a, const SweepResult& b) { return a.clock == b.clock || !a.timed() || !b.timed(); }
// Their errors are on one scale, and so are their times.
bool comparable(const SweepResult& a, const SweepResult& b) {
    return a.scene == b.scene && a.reference == b.reference && same_clock(a, b);
}

// What is on the slide.
struct Shown {
    const FoundResult* found = nullptr;      // null: none, or not comparable
    std::vector<const SweepResult*> sweeps;  // the one with the scene's own rung first; that of `found` is timed
    const Picture* reference = nullptr;      // that the errors are from; null: there is none
    double floor = 0;

    bool is_found(const SweepResult& sweep) const { return found && &sweep == &found->timed; }
    // Found rungs were compared with the scene as it is: their errors from the reference are computed here.
    double error(const SweepResult& sweep, std::size_t rung) const {
        const RungResult& result = sweep.rungs[rung];
        if (is_found(sweep) && reference != &scene_picture()) return compare(result.picture, *reference).light.rmse;
        return result.whole.light.rmse;
    }
    const Picture& scene_picture() const { return found->timed.rungs[found->timed.sweep.current].picture; }
};

bool same_size(const Picture& a, const Picture& b) { return a.width == b.width && a.height == b.height; }

const Picture* reference_of(const SweepResult& sweep) {
    const Picture& picture = sweep.compared_with();
    return picture.rgba.empty() ? nullptr : &picture;
}

const FoundResult* found_for(const Report& report, const SweepResult* main) {
    for (const FoundResult& found : report.found) {
        const SweepResult& timed = found.timed;
        const auto measured = ranges::count_if(timed.rungs, [](const RungResult& rung) { return rung.rounds > 0; });
        // Frames of other sizes take other times.
        const bool whole = found.timed_size[0] == found.width && found.timed_size[1] == found.height;
        if (timed.rungs.size() < 2 || (main && (main->scene != found.scene || !same_clock(*main, timed)))) continue;
        if (main && main->timed() && (measured < 2 || !whole)) continue;
        const Picture* reference = main ? reference_of(*main) : reference_of(timed);
        const bool fits = reference && ranges::all_of(timed.rungs, [&](const RungResult& rung) {
                              return same_size(rung.picture, *reference);
                          });
        if (fits) return &found;
    }
    return nullptr;
}

Shown shown_of(const Report& report) {
    Shown shown;
    const SweepResult* const main = main_sweep(report);
    shown.found = found_for(report, main);
    if (shown.found) shown.sweeps.push_back(&shown.found->timed);
    if (main) shown.sweeps.push_back(main);
    if (shown.sweeps.empty()) return shown;
    for (const SweepResult& sweep : report.sweeps)
        if (main && &sweep != main && has_errors(sweep) && comparable(sweep, *main)) shown.sweeps.push_back(&sweep);
    shown.reference = reference_of(main ? *main : shown.found->timed);
    for (const SweepResult* sweep : shown.sweeps)
        shown.floor = std::max(shown.floor, sweep->whole_residual.value_or(0));
    return shown;
}

bool same_picture(const RungResult& a, const RungResult& b) {
    return !a.picture.rgba.empty() && a.picture == b.picture;
}

constexpr std::string_view the_scene = "the scene";

// The same combination occurs in several sweeps, such as the last rungs of all ladders, and the scene as it is.
SlideRung* already_there(std::vector<SlideRung>& rungs, const SweepResult& sweep, std::size_t rung) {
    const auto same = ranges::find_if(rungs, [&](const SlideRung& other) {
        return other.sweep != &sweep && same_picture(other.result(), sweep.rungs[rung]) &&
               same_variant(*other.sweep, other.rung, sweep, rung);
    });
    return same == rungs.end() ? nullptr : &*same;
}

// The scene as it is has the names of the ladders' rungs, too. It is judged by the first table that has a front.
void add_table(SlideRung& known, const SweepResult& sweep, std::size_t rung) {
    const RungResult& result = sweep.rungs[rung];
    if (sweep.sweep.kind == SweepKind::ladder && known.point.name.starts_with(the_scene))
        known.point.name += (known.point.name == the_scene ? ": " : ", ") + result.name;
    if (known.sweep->trusted() || !sweep.trusted() || !known.timed() || result.rounds == 0) return;
    known.sweep = &sweep;
    known.rung = rung;
}

// The time that the ratios of the sweep are times of. Tables are measured at different moments, so it is that of a rung
// which is placed already, if the sweep has one too; the base first.
Interval base_time(const std::vector<SlideRung>& rungs, const SweepResult& sweep) {
    const std::size_t base = sweep.sweep.current;
    const auto by = [&](std::size_t i) -> std::optional<Interval> {
        const Interval& ratio = sweep.rungs[i].ratio;
        for (const SlideRung& other : rungs)
            if (const PlotPoint& p = other.point; sweep.rungs[i].rounds > 0 && ratio.middle > 0 && other.timed() &&
                                                  same_variant(*other.sweep, other.rung, sweep, i))
                return Interval{p.low / ratio.high, p.milliseconds / ratio.middle, p.high / ratio.low};
        return std::nullopt;
    };
    const double own = sweep.rungs[base].milliseconds;
    if (rungs.empty()) return {own, own, own};
    if (const auto time = by(base)) return *time;
    for (std::size_t i = 0; i < sweep.rungs.size(); ++i)
        if (const auto time = by(i)) return *time;
    return {sweep.rungs[base].low, own, sweep.rungs[base].high};
}

// True of names such as "8x8", which say nothing without that of their sweep.
bool mere_number(std::string_view name) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    for (std::size_t i = 1; i < name.size(); ++i)
        if (letter(name[i - 1]) && letter(name[i])) return false;
    return true;
}

std::string name_of(const Shown& shown, const SweepResult& sweep, std::size_t rung) {
    return shown.is_found(sweep) && rung == sweep.sweep.current ? std::string(the_scene) : sweep.rungs[rung].name;
}

// Puts the name of the sweep before names that occur in several, or say nothing alone.
void tell_apart(std::vector<SlideRung>& rungs) {
    std::map<std::string, int> uses;
    for (const SlideRung& rung : rungs) ++uses[rung.point.name];
    for (SlideRung& rung : rungs)
        if (rung.sweep->sweep.kind != SweepKind::found && (uses[rung.point.name] > 1 || mere_number(rung.point.name)))
            rung.point.name = rung.sweep->sweep.name + " " + rung.result().name;
}

std::vector<SlideRung> rungs_of(const Shown& shown) {
    std::vector<SlideRung> result;
    for (const SweepResult* sweep : shown.sweeps) {
        const Interval time = base_time(result, *sweep);
        for (std::size_t i = 0; i < sweep->rungs.size(); ++i) {
            const RungResult& rung = sweep->rungs[i];
            if (!rung.drawn || std::isnan(rung.whole.light.rmse) || plainly_visible(*sweep, i)) continue;
            if (SlideRung* known = already_there(result, *sweep, i)) {
                add_table(*known, *sweep, i);
                continue;
            }
            SlideRung entry{sweep, i, {}};
            entry.point.name = name_of(shown, *sweep, i);
            entry.point.error = std::max(shown.error(*sweep, i), shown.floor);
            entry.point.own = sweep == shown.sweeps.front() && i == sweep->sweep.current;
            if (rung.rounds > 0 && rung.ratio.middle > 0) {
                entry.point.milliseconds = time.middle * rung.ratio.middle;
                entry.point.low = time.low * rung.ratio.low;
                entry.point.high = time.high * rung.ratio.high;
            }
            result.push_back(std::move(entry));
        }
    }
    if (shown.sweeps.size() > 1) tell_apart(result);
    const std::vector<bool> front = common_front(result);
    for (std::size_t i = 0; i < result.size(); ++i) result[i].point.beaten = !(result[i].point.front = front[i]);
    return result;
}

// The next of 1, 2 and 5 times a power of ten that is not below what all but the largest fiftieth of the values reach.
double scale_for(std::vector<float> values) {
    constexpr double least = .01;
    const double wanted = std::max(static_cast<double>(quantile(values, .98)), least);
    const double power = std::pow(10, std::floor(std::log10(wanted) + 1e-9));
    for (double step : {1., 2., 5.})
        if (wanted <= step * power * 1.0001) return step * power;
    return 10 * power;
}

Window scaled(const Window& window, const Picture& from, const content::Image& to) {
    const auto at = [](int value, int all, int of) {
        return static_cast<int>(std::lround(static_cast<double>(value) * of / all));
    };
    return {at(window.x, from.width, to.width), at(window.y, from.height, to.height),
            std::max(at(window.width, from.width, to.width), 1),
            std::max(at(window.height, from.height, to.height), 1)};
}

// The pictures of the columns, their maps, and where they are from.
void add_pictures(Slide& slide, const std::vector<const Picture*>& pictures, const Picture& reference) {
    slide.whole =
        content::reduced(reference.width, reference.height, whole_side, whole_side, [&](int x, int y, std::size_t c) {
            const float value = reference.rgba[4 * static_cast<std::size_t>(y * reference.width + x) + c];
            return std::isfinite(value) ? std::clamp(value, 0.F, 1.F) : 0.F;
        });
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

void add_columns(Slide& slide, std::vector<SlideRung>& rungs, const Picture& reference) {
    const auto own = ranges::find_if(rungs, [](const SlideRung& rung) { return rung.point.own; });
    std::vector<const Picture*> pictures;
    std::size_t others = 0;
    for (const ColumnChoice& choice : choose_columns(rungs, static_cast<std::size_t>(own - rungs.begin()))) {
        PlotPoint& point = rungs[choice.rung].point;
        const Picture& picture = rungs[choice.rung].result().picture;
        if (!same_size(picture, reference)) continue;
        point.ink = point.own ? content::Ink::own : content::series(others++);
        slide.columns.push_back({point.name, point.error, point.milliseconds, point.own, choice.equal_time,
                                 choice.equal_error, *point.ink});
        pictures.push_back(&picture);
    }
    add_pictures(slide, pictures, reference);
}

// The most important first: those with pictures, then some of the front.
void add_labels(std::vector<PlotPoint>& points) {
    constexpr std::size_t most_of_front = 4;
    std::vector<PlotPoint*> front;
    for (PlotPoint& point : points)
        if (point.ink || point.own)
            point.label = point.own ? 0 : 1;
        else if (point.front)
            front.push_back(&point);
    ranges::stable_sort(front, {}, [](const PlotPoint* p) { return p->error; });
    for (std::size_t i = 0; i < std::min(front.size(), most_of_front); ++i) front[i]->label = 2 + static_cast<int>(i);
}

// Which rungs are not among the points: those that were not timed, and those that nobody would take.
std::string left_out(const Report& report, const Shown& shown) {
    std::vector<std::string> untimed;
    std::size_t visible = 0, elsewhere = 0;
    for (const FoundResult& found : report.found)
        for (std::size_t i = 0; i < found.timed.rungs.size() && &found != shown.found; ++i)
            elsewhere += i != found.timed.sweep.current && found.timed.rungs[i].rounds > 0 ? 1 : 0;
    for (const SweepResult* sweep : shown.sweeps)
        for (std::size_t i = 0; i < sweep->rungs.size(); ++i)
            if (plainly_visible(*sweep, i))
                ++visible;
            else if (sweep->rungs[i].rounds == 0)
                untimed.push_back(sweep->rungs[i].name);
    std::string text;
    const auto add = [&](const std::string& what) { text += (text.empty() ? "left out: " : ", ") + what; };
    if (!untimed.empty() && untimed.size() <= 2) add(fmt::format("{} (not timed)", fmt::join(untimed, ", ")));
    if (untimed.size() > 2) add(fmt::format("{} not timed", untimed.size()));
    if (visible > 0) add(fmt::format("{} plainly visible", visible));
    if (elsewhere > 0) add(fmt::format("{} found in smaller pictures", elsewhere));
    return text;
}

std::string why_no_front(const Slide& slide, const Shown& shown) {
    if (slide.plot.points.empty()) return "no times were measured";
    if (ranges::any_of(slide.plot.points, &PlotPoint::front)) return {};
    const bool few =
        ranges::none_of(shown.sweeps, [](const SweepResult* of) { return of->timed() && !of->few_rounds; });
    return few ? "too few rounds: no front" : "no front";
}

}  // namespace

Slide slide_of(const Report& report) {
    Slide slide;
    const Shown shown = shown_of(report);
    if (shown.sweeps.empty()) return slide;
    slide.plot.floor = shown.floor;
    std::vector<SlideRung> rungs = rungs_of(shown);
    if (shown.reference) add_columns(slide, rungs, *shown.reference);
    for (SlideRung& rung : rungs)
        if (rung.timed()) slide.plot.points.push_back(std::move(rung.point));
    const SweepResult& main = *shown.sweeps.front();
    slide.title = std::filesystem::path(main.scene).stem().string();
    slide.note = fmt::format("{} × {}, {}", report.where.width, report.where.height, report.where.renderer);
    add_labels(slide.plot.points);
    slide.plot.errors = "error of light (RMSE)";
    slide.plot.times = fmt::format("time of a frame, ms ({})", name(main.clock));
    slide.plot.floor_words = "residual of the reference";
    slide.plot.stamp = why_no_front(slide, shown);
    if (const std::string without = left_out(report, shown); !slide.plot.points.empty() && !without.empty())
        slide.plot.stamp += (slide.plot.stamp.empty() ? "" : "; ") + without;
    return slide;
}

}  // namespace snell::accuracy
