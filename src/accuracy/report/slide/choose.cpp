#include "src/accuracy/report/slide/choose.h"

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

constexpr double equal_times = .25, equal_errors = 1.1, different_errors = 1.02, invisible_flip = .02;
constexpr std::size_t most_equals = 2;  // next to the scene's own rung

Cost by_intervals(const SlideRung& a, const SlideRung& b, double within) {
    const SlidePoint &p = a.point, &q = b.point;
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

bool same_error(const SlidePoint& a, const SlidePoint& b) { return factor(a.error, b.error) <= equal_errors; }

class Chooser {
public:
    Chooser(const std::vector<SlideRung>& rungs, std::size_t own) : rungs_(rungs), own_(own) {}

    std::vector<ColumnChoice> choose() {
        if (own_ < rungs_.size() && shows_anything(own_)) {
            shown_.push_back(own_);
            add_equal_times();
            add_equal_errors();
        }
        add_others();
        return in_order();
    }

private:
    const SlidePoint& point(std::size_t i) const { return rungs_[i].point; }
    const SlidePoint& own() const { return point(own_); }

    bool shows_anything(std::size_t i) const {
        const SlideRung& rung = rungs_[i];
        return !rung.result().picture.rgba.empty() && std::isfinite(rung.point.error);
    }
    // A picture that is shown already tells nothing again.
    bool shown(std::size_t i) const {
        return ranges::any_of(
            shown_, [&](std::size_t j) { return i == j || rungs_[i].result().picture == rungs_[j].result().picture; });
    }
    void add(std::vector<std::size_t>& to, std::size_t i) {
        if (shown_.size() >= most_columns || shown(i)) return;
        to.push_back(i);
        shown_.push_back(i);
    }
    // The rungs with pictures that fulfil the condition, with the smallest `value` first.
    template <class Condition, class Value>
    std::vector<std::size_t> those(const Condition& condition, const Value& value) const {
        std::vector<std::size_t> result;
        for (std::size_t i = 0; i < rungs_.size(); ++i)
            if (i != own_ && shows_anything(i) && condition(rungs_[i])) result.push_back(i);
        ranges::stable_sort(result, {}, [&](std::size_t i) { return value(rungs_[i]); });
        return result;
    }

    static bool is_first(const SlideRung& rung) {
        return rung.rung == 0 && rung.sweep->sweep.kind == SweepKind::ladder;
    }

    // The most exact; then the first rung of a ladder, or the nearest.
    void add_equal_times() {
        const auto equal = [&](const SlideRung& rung) {
            return same_time(rung, rungs_[own_]) && factor(rung.point.error, own().error) > different_errors;
        };
        for (std::size_t i : those(equal, [](const SlideRung& rung) { return rung.point.error; }))
            if (equal_time_.empty()) add(equal_time_, i);
        const auto distance = [&](const SlideRung& rung) {
            return is_first(rung) ? 0 : factor(rung.point.milliseconds, own().milliseconds);
        };
        for (std::size_t i : those(equal, distance))
            if (equal_time_.size() < most_equals) add(equal_time_, i);
    }

    // The cheapest, then the one with the nearest error.
    void add_equal_errors() {
        const auto equal = [&](const SlideRung& rung) {
            const Cost cost = cost_of(rung, rungs_[own_]);
            return (cost == Cost::cheaper || cost == Cost::dearer) && same_error(rung.point, own());
        };
        for (std::size_t i : those(equal, [](const SlideRung& rung) { return rung.point.milliseconds; }))
            if (equal_error_.empty()) add(equal_error_, i);
        for (std::size_t i : those(equal, [&](const SlideRung& rung) { return factor(rung.point.error, own().error); }))
            if (equal_error_.size() < most_equals) add(equal_error_, i);
    }

    // The cheapest on the front that halves the error of the scene's own rung; if that has none, the cheapest whose
    // error is hardly seen.
    void add_bargain() {
        const bool exact = own_ >= rungs_.size() || own().error == 0 || rungs_[own_].result().below_residual;
        const auto good = [&](const SlideRung& rung) {
            if (!rung.point.front) return false;
            return exact ? rung.result().flip <= invisible_flip : rung.point.error <= own().error / 2;
        };
        const auto found = those(good, [](const SlideRung& rung) { return rung.point.milliseconds; });
        if (!found.empty()) add(others_, found.front());
    }

    void add_others() {
        if (rungs_.empty()) return;
        const std::size_t before = others_.size();
        add_bargain();
        const SweepResult* main = rungs_[own_ < rungs_.size() ? own_ : 0].sweep;
        const auto of_main = [&](std::size_t rung) {
            for (std::size_t i = 0; i < rungs_.size(); ++i)
                if (rungs_[i].sweep == main && rungs_[i].rung == rung && shows_anything(i)) add(others_, i);
        };
        if (main->sweep.kind == SweepKind::ladder || main->sweep.kind == SweepKind::knob) of_main(0);
        of_main(main->sweep.reference);
        for (std::size_t i : those([](const SlideRung& rung) { return rung.point.front; },
                                   [](const SlideRung& rung) { return rung.point.milliseconds; }))
            add(others_, i);
        if (others_.size() == before && shown_.empty())
            for (std::size_t i :
                 those([](const SlideRung&) { return true; }, [](const SlideRung& rung) { return rung.point.error; }))
                add(others_, i);
    }

    std::vector<ColumnChoice> in_order() const {
        std::vector<ColumnChoice> columns;
        const bool has_own = ranges::find(shown_, own_) != shown_.end();
        std::vector<std::size_t> others = others_;
        ranges::stable_sort(others, {}, [&](std::size_t i) { return point(i).milliseconds; });
        const auto cheaper = [&](std::size_t i) { return has_own && point(i).milliseconds < own().milliseconds; };
        for (std::size_t i : others)
            if (cheaper(i)) columns.push_back({i});
        for (std::size_t i : equal_time_) columns.push_back({i, true, false});
        if (has_own) columns.push_back({own_, !equal_time_.empty(), !equal_error_.empty()});
        for (std::size_t i : equal_error_) columns.push_back({i, false, true});
        for (std::size_t i : others)
            if (!cheaper(i)) columns.push_back({i});
        return columns;
    }

    const std::vector<SlideRung>& rungs_;
    std::size_t own_;
    std::vector<std::size_t> shown_, equal_time_, equal_error_, others_;
};

bool may_be_on_front(const SlideRung& rung) {
    return rung.timed() && rung.sweep->trusted() && rung.result().verdict.standing == Standing::front &&
           std::isfinite(rung.point.error);
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
