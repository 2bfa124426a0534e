// Times of what may be on the front, and what may be left out.
#include <algorithm>
#include <utility>

#include "parser/text/ranges.h"
#include "src/accuracy/found/steps.h"

namespace snell::accuracy {

namespace {

// Few rungs in many rounds: every pair that is compared widens the intervals of all.
constexpr std::size_t most_timed = 8, most_costs = 8, load_pairs = 3, spare_rounds = 8;
constexpr double least_loading = 1;  // milliseconds: less is noise

}  // namespace

void Search::Impl::begin_times() {
    kept.clear();
    std::vector<std::size_t> cheaper;
    for (const auto& [i, trial] : finalists)
        if (result.rungs[i].aim == Aim::cheaper) cheaper.push_back(i);
    const std::size_t most = fitting(std::min(most_timed, cheaper.size()), times_end, result.timed_size);
    cheaper = in_layers(result, std::move(cheaper), most);
    ranges::stable_sort(cheaper, {}, [&](std::size_t i) { return rmse_of(result.rungs[i]); });
    begin_rounds(result.timed, cheaper, times_end, result.timed_size);
}

// How many rungs can be timed in as many rounds as a front needs: fewer if frames are slow, and in smaller pictures
// if a few are too many.
std::size_t Search::Impl::fitting(std::size_t most, double part, std::array<int, 2>& size) {
    size = {settings.width, settings.height};
    std::size_t n = most;
    double frame = 0;
    const auto seconds = [&](std::size_t rungs) {
        const double sample = frame > 500 ? frame : frame + std::max(frame, options.at_least);
        const auto needed = static_cast<double>(rounds_for(rungs + 1) + spare_rounds);
        const auto entrants = static_cast<double>(rungs + 2);
        return entrants * (sample * needed + 3 * frame) / 1e3;
    };
    while (options.times && !stopped()) {
        trials->scene().resize(size[0], size[1]);
        frame = trials->scene().warm_up(trials->variant(), ClockKind::wall).value_or(1);
        n = most;
        while (n > few_finalists && seconds(n) > left(part)) --n;
        if (seconds(n) <= left(part) || size[0] / 2 < result.search_width) break;
        size = {size[0] / 2, size[1] / 2};
    }
    small();
    return n;
}

// The scene is the last entrant.
void Search::Impl::begin_rounds(SweepResult& sweep, const std::vector<std::size_t>& of, double part,
                                std::array<int, 2> size) {
    sweep = {};
    sweep.scene = result.scene;
    sweep.sweep = {.kind = SweepKind::found, .name = "found rungs"};
    sweep.residual = 0;
    sweep.clock = clock;
    whole();
    soon([this, &sweep, of, part, size] { start_rounds(sweep, of, part, size); });
    for (auto i = of.rbegin(); i != of.rend(); ++i)
        soon([this, &sweep, i = *i] {
            result.rungs[i].timed = sweep.rungs.size();
            sweep.rungs.push_back(trials->summary(result.rungs[i], finalists.at(i)));
            sweep.rungs.back().name = result.words(result.rungs[i]);
            sweep.sweep.rungs.push_back({.name = sweep.rungs.back().name, .variant = {}, .steps = {}, .elsewhere = {}});
        });
}

void Search::Impl::start_rounds(SweepResult& sweep, const std::vector<std::size_t>& of, double part,
                                std::array<int, 2> size) {
    std::vector<Entrant> entrants;
    for (const std::size_t i : of) entrants.push_back(trials->entrant(*finalists.at(i).bench, size));
    entrants.push_back(trials->entrant(trials->scene(), size));
    sweep.rungs.push_back(trials->scene_summary());
    sweep.sweep.rungs.push_back(
        {.name = sweep.rungs.back().name, .variant = trials->variant(), .steps = {}, .elsewhere = {}});
    sweep.sweep.reference = sweep.sweep.current = of.size();
    timing = &sweep;
    if (!options.times || of.empty()) return end_rounds();
    rounds.emplace(std::move(entrants),
                   RoundOptions{.clock = clock,
                                .base = sweep.sweep.current,
                                .kept = sweep.sweep.current,
                                .rounds = options.rounds,
                                .at_least = options.at_least,
                                .seed = options.places.seed,
                                .seconds_left = [this, part] { return left(part); },
                                .over = [this, part] { return over(part); },
                                .stopped = [this] { return over(1); },
                                .report = [this](std::string_view what, double done) { say(what, done); }});
}

void Search::Impl::end_rounds() {
    SweepResult& sweep = *timing;
    std::vector<double> again;
    if (rounds) {
        for (std::size_t i = 0; i < sweep.rungs.size(); ++i) take_times(sweep.rungs[i], rounds->times()[i]);
        again = rounds->again();
    }
    sweep.interrupted = result.interrupted;
    conclude(sweep, again);
    rounds.reset();
    timing = nullptr;
    small();
}

// ---- what may be left out -----------------------------------------------------------------------------------

void Search::Impl::omission(std::size_t i) {
    doing = "leaving things out";
    if (skipped(result.rungs[i], unused_end)) return;
    if (const Change& change = result.changes[i]; change.kind == ChangeKind::no_uniform && is_set(change)) {
        result.rungs[i].outcome = Outcome::refused;
        result.rungs[i].reason = "--set gives it another value";
        return;
    }
    whole();
    try_places(trials->open(result.rungs[i].changes), i, result.places.size(), [this](Attempt& tried) {
        small();
        if (rung_of(tried).outcome != Outcome::refused) omitted(tried);
    });
}

// Whether the value on the Program line does not count, because the scene is measured with another one.
bool Search::Impl::is_set(const Change& change) const {
    const std::string_view name = std::string_view(change.before).substr(0, change.before.find_first_of(" \t"));
    return !result.places.empty() && ranges::any_of(result.places.front().sets, [&](std::string_view set) {
        const std::string_view assigned = set.substr(0, set.find('='));
        return assigned == name || (assigned.ends_with(name) && assigned[assigned.size() - name.size() - 1] == '.');
    });
}

void Search::Impl::omitted(Attempt& attempt) {
    FoundRung& rung = rung_of(attempt);
    rung.outcome = Outcome::tried;
    rung.held_out = rung.at.size() == result.places.size();
    if (!rung.held_out || rung.pixels_changed > 0) return;
    rung.gpu_bytes = trials->saved_memory(attempt.trial);
    finalists.emplace(attempt.rung, std::move(attempt.trial));
    if (rung.gpu_bytes != 0) soon([this, i = attempt.rung] { load(i, {}, {}); });
}

// Loads the scene as it is and without something in turn, and compares the times of each pair.
void Search::Impl::load(std::size_t i, std::vector<Loading> with, std::vector<Loading> without) {
    FoundRung& rung = result.rungs[i];
    const bool next = without.size() < with.size();
    (next ? without : with).push_back(trials->load(next ? rung.changes : std::vector<std::size_t>{}, clock));
    const bool whole_pair = next && without.back().bytes_decoded <= with.back().bytes_decoded;
    if (whole_pair)
        rung.bytes_decoded = static_cast<std::int64_t>(with.back().bytes_decoded - without.back().bytes_decoded);
    const std::size_t pairs = options.times ? load_pairs : 1;
    if (without.size() < pairs && !over(unused_end))
        return soon([this, i, with = std::move(with), without = std::move(without)] { load(i, with, without); });
    if (without.size() < load_pairs) return;
    std::vector<double> saved;
    for (std::size_t k = 0; k < without.size(); ++k) saved.push_back(with[k].milliseconds - without[k].milliseconds);
    const double most = ranges::max_element(with, {}, &Loading::milliseconds)->milliseconds;
    const bool sure = ranges::all_of(saved, [&](double ms) { return ms > std::max(least_loading, .02 * most); });
    rung.load_ms = sure ? median(saved) : 0;
}

void Search::Impl::begin_costs() {
    std::vector<std::size_t> of;
    for (const Aim aim : {Aim::unused, Aim::better})
        for (const auto& [i, trial] : finalists)
            if (result.rungs[i].aim == aim) of.push_back(i);
    of.resize(std::min(of.size(), fitting(std::min(of.size(), most_costs), 1, result.costs_size)));
    begin_rounds(result.costs, of, 1, result.costs_size);
}

}  // namespace snell::accuracy
