#include "src/accuracy/report/slide/choose.h"

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

using content::PlotPoint;

constexpr double equal_times = .25, equal_errors = 1.1, different_errors = 1.02, invisible_flip = .02;
constexpr std::size_t most_equals = 2;  // next to the scene's own rung

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

}  // namespace

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

std::vector<ColumnChoice> choose_columns(const std::vector<SlideRung>& rungs, std::size_t own) {
    return Chooser(rungs, own).choose();
}

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

}  // namespace snell::accuracy
