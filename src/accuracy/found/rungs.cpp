#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <tuple>

#include <fmt/format.h>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "src/accuracy/found/change.h"
#include "src/accuracy/found/search.h"
#include "src/accuracy/found/trial.h"
#include "src/runtime/resources/counters.h"

namespace snell::accuracy {

namespace {

// Mean FLIP: invisible, visible for someone who looks for it, visible, plain to see, another picture.
constexpr std::array<double, 5> error_limits{.005, .02, .06, .2, .5};

constexpr double most_for_averages = .1;  // of the search's time

}  // namespace

std::size_t FoundRung::worst_place() const {
    return held_out && at[worst_searched] < at[worst_held_out] ? worst_held_out : worst_searched;
}

const Difference* FoundRung::worst() const { return at.empty() ? nullptr : &at[worst_place()]; }

std::optional<double> FoundRung::flip() const {
    std::optional<double> largest;
    // Where nothing changes it is 0 without computing, which says nothing about the worst place.
    if (at.empty() || !worst()->flip) return largest;
    for (const Difference& difference : at)
        if (difference.flip) largest = std::max(largest.value_or(0), *difference.flip);
    return largest;
}

void take_errors(RungResult& shown, const FoundRung& rung) {
    shown.drawn = !rung.at.empty();
    if (!shown.drawn) return;
    shown.own = rung.worst()->own;
    shown.whole = rung.worst()->whole;
    shown.alone = shown.own.light;
    shown.flip = rung.flip().value_or(std::nan(""));
}

const RungResult* FoundResult::times(const FoundRung& rung) const {
    if (!rung.timed) return nullptr;
    const RungResult& result = sweep_of(rung).rungs[*rung.timed];
    return result.rounds > 0 ? &result : nullptr;
}

const FoundRung* FoundResult::find(std::string_view name) const {
    const auto found = ranges::find(rungs, name, &FoundRung::name);
    return found == rungs.end() ? nullptr : &*found;
}

std::vector<const FoundRung*> FoundResult::front() const {
    std::vector<const FoundRung*> members;
    for (const FoundRung& rung : rungs)
        if (const RungResult* of = times(rung); rung.aim == Aim::cheaper && of && timed.on_front(*of))
            members.push_back(&rung);
    ranges::stable_sort(members, {}, [&](const FoundRung* rung) { return times(*rung)->ratio.middle; });
    return members;
}

std::vector<const FoundRung*> FoundResult::without_effect() const {
    std::vector<const FoundRung*> found;
    for (const FoundRung& rung : rungs)
        if (rung.aim == Aim::unused && rung.outcome == Outcome::tried && rung.held_out && rung.pixels_changed == 0)
            found.push_back(&rung);
    return found;
}

std::string FoundResult::words(std::span<const std::size_t> of) const {
    const auto place = [&](std::size_t i) { return i < positions.size() ? near_place(positions[i]) : std::string(); };
    std::string text;
    for (const std::size_t i : of) {
        const std::string own = accuracy::words(changes[i]);
        bool alike = false, there = false;  // at another place, at the same place
        for (std::size_t other = 0; other < changes.size(); ++other) {
            if (other == i || accuracy::words(changes[other]) != own) continue;
            (place(other) == place(i) ? there : alike) = true;
        }
        text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", own, alike ? fmt::format(" at {}", place(i)) : "",
                            there ? fmt::format(", no. {}", i + 1) : "");
    }
    return text;
}

void FoundResult::refuse_all(const std::string& reason) {
    cannot_say = reason;
    for (FoundRung& rung : rungs) {
        rung.outcome = Outcome::refused;
        rung.reason = reason;
    }
}

std::string FoundResult::broken_words() const {
    const auto& [place, pixels] = *broken;
    return fmt::format("the scene itself is {}{}", text_of(pixels),
                       place == 0 ? "" : ", with " + place_text(places[place], places[0]));
}

FoundResult untried(const Original& original, std::vector<Change> changes, const BenchSettings& settings,
                    const SearchOptions& options) {
    FoundResult result;
    result.scene = original.path;
    result.seed = options.places.seed;
    result.with_times = options.times;
    result.changes = std::move(changes);
    for (std::size_t i = 0; i < result.changes.size(); ++i) {
        const Change& change = result.changes[i];
        result.positions.push_back(change_place(change, original.sources));
        result.others.push_back(other_edits(change, original.sources));
        result.rungs.push_back({.name = std::to_string(i + 1), .changes = {i}, .aim = facts(change.kind).aim});
    }
    int width = result.width = settings.width, height = result.height = settings.height;
    while (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > options.pixels &&
           std::min(width, height) > 16) {
        width /= 2;
        height /= 2;
    }
    result.search_width = width;
    result.search_height = height;
    return result;
}

FoundResult search(const Original& original, const gl::Caps& caps, const BenchSettings& settings,
                   const SearchOptions& options) {
    const runtime::Stopwatch watch;
    std::vector<Change> changes = find_changes(original.plan, original.files, original.sources);
    if (options.report) options.report({"found rungs", "drawing means of expressions", 0, options.seconds});
    fill_averages(original, changes, caps, [&] {
        return 1e-3 * watch.milliseconds() > most_for_averages * options.seconds || (options.stop && options.stop());
    });
    SearchOptions rest = options;
    rest.seconds = std::max(options.seconds - 1e-3 * watch.milliseconds(), 0.);
    Search search(original, std::move(changes), caps, settings, std::move(rest));
    while (search.step()) continue;
    return search.take();
}

std::string near_place(std::string_view position) {
    const std::size_t name = position.find_last_of('/') + 1;
    return std::string(position.substr(name, std::max(position.rfind(':'), name) - name));
}

std::string rung_name(std::span<const std::size_t> changes) {
    std::string name;
    for (const std::size_t change : changes) name += fmt::format("{}{}", name.empty() ? "" : "+", change + 1);
    return name;
}

std::optional<std::vector<std::size_t>> parse_rung(std::string_view name, std::span<const Change> changes,
                                                   std::string& wrong) {
    std::vector<std::size_t> numbers;
    for (std::size_t at = 0; at <= name.size();) {
        const std::size_t end = std::min(name.find('+', at), name.size());
        const auto number = read_whole<std::size_t>(name.substr(at, end - at));
        if (!number || *number < 1 || *number > changes.size()) {
            wrong = fmt::format(
                "'{}' is not the number of a found rung; they go from 1 to {}, and combinations are written as 3+7",
                name.substr(at, end - at), changes.size());
            return std::nullopt;
        }
        numbers.push_back(*number - 1);
        at = end + 1;
    }
    ranges::sort(numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (!compatible(changes[numbers[i]], changes[numbers[j]])) {
                wrong = fmt::format("{} and {} change the same text", numbers[j] + 1, numbers[i] + 1);
                return std::nullopt;
            }
    return numbers;
}

Climbs::Climbs(std::vector<Single> singles, std::span<const Change> changes, std::uint64_t seed) : changes_(changes) {
    std::mt19937_64 random(seed);
    const auto climb = [&](bool visible, auto order) {
        for (const double limit : error_limits) {
            if ((limit > most_flip) != visible) continue;
            climbs_.push_back({limit, {}});
            ranges::copy_if(singles, std::back_inserter(climbs_.back().order),
                            [&](const Single& single) { return single.error <= limit; });
            order(climbs_.back().order);
        }
    };
    for (const bool visible : {false, true}) {
        climb(visible, [](std::vector<Single>& order) { ranges::stable_sort(order, {}, &Single::error); });
        climb(visible, [](std::vector<Single>& order) { ranges::stable_sort(order, {}, &Single::ratio); });
        climb(visible, [&](std::vector<Single>& order) {
            for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random() % k]);
        });
    }
}

bool Climbs::fits(std::size_t change) const {
    return ranges::all_of(chosen_, [&](std::size_t other) { return compatible(changes_[change], changes_[other]); });
}

std::optional<std::vector<std::size_t>> Climbs::next() {
    for (; climb_ < climbs_.size(); ++climb_, step_ = 0, chosen_.clear()) {
        const Climb& climb = climbs_[climb_];
        for (; step_ < climb.order.size(); ++step_) {
            const std::size_t change = climb.order[step_].change;
            if (!fits(change)) continue;
            std::vector<std::size_t> more = chosen_;
            more.insert(std::upper_bound(more.begin(), more.end(), change), change);
            const auto known = ranges::find(known_, more, &std::pair<std::vector<std::size_t>, double>::first);
            if (more.size() > 1 && known == known_.end()) return more;
            if (more.size() == 1 || known->second <= climb.limit) chosen_ = std::move(more);
        }
    }
    return std::nullopt;
}

void Climbs::tell(double error) {
    std::vector<std::size_t> more = chosen_;
    const std::size_t change = climbs_[climb_].order[step_].change;
    more.insert(std::upper_bound(more.begin(), more.end(), change), change);
    known_.emplace_back(std::move(more), error);
}

std::vector<std::size_t> spread(const std::vector<std::size_t>& all, std::size_t most) {
    if (all.size() <= most) return all;
    std::vector<std::size_t> some;
    for (std::size_t i = 0; i < most; ++i)
        some.push_back(all[i * (all.size() - 1) / std::max<std::size_t>(most - 1, 1)]);
    return some;
}

std::vector<std::size_t> in_layers(const FoundResult& found, std::vector<std::size_t> rungs, std::size_t most) {
    constexpr double margin = .05;  // of the quick times
    constexpr std::size_t enough = 3;
    const auto error = [&](std::size_t i) { return found.rungs[i].worst()->own.light.rmse; };
    const auto quick = [&](std::size_t i) { return found.rungs[i].quick_ratio; };
    const auto surpasses = [&](std::size_t by, std::size_t i) {
        return std::tuple(error(by), quick(by), by) < std::tuple(error(i), quick(i), i) &&
               quick(by) < quick(i) * (1 + margin);
    };
    const auto nobody_takes = std::stable_partition(rungs.begin(), rungs.end(),
                                                    [&](std::size_t i) { return !plainly_visible(found.rungs[i]); });
    std::vector<std::size_t> some, others(nobody_takes, rungs.end());
    rungs.erase(nobody_takes, rungs.end());
    while (some.size() < most) {
        if (rungs.empty() && some.size() < enough) std::swap(rungs, others);
        if (rungs.empty()) break;
        std::vector<std::size_t> layer, rest;
        for (const std::size_t i : rungs)
            (ranges::any_of(rungs, [&](std::size_t by) { return surpasses(by, i); }) ? rest : layer).push_back(i);
        ranges::stable_sort(layer, {}, error);
        layer = spread(layer, most - some.size());
        some.insert(some.end(), layer.begin(), layer.end());
        rungs = std::move(rest);
    }
    return some;
}

namespace {

constexpr std::size_t most_pixels = 16384;

BenchSettings small_picture(const Scene& scene) {
    BenchSettings settings;
    settings.width = std::max(scene.window_size[0], 1);
    settings.height = std::max(scene.window_size[1], 1);
    while (static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height) > most_pixels &&
           std::min(settings.width, settings.height) > 16) {
        settings.width /= 2;
        settings.height /= 2;
    }
    return settings;
}

// The means of the two components that a probe draws; nothing if they are not known. `refused`: why it is not drawn.
std::optional<std::array<double, 2>> drawn_means(Trials& trials, std::size_t probe, std::size_t places,
                                                 std::string& refused) {
    Trial trial = trials.open(std::vector{probe});
    std::array<double, 2> sum{};
    std::size_t count = 0;
    for (std::size_t place = 0; place < places && trial.refused.empty(); ++place) {
        const auto picture = trials.picture(trial, place);
        for (std::size_t i = 0; picture && i < picture->rgba.size(); i += 4) {
            const float* pixel = &picture->rgba[i];
            if (pixel[2] != static_cast<float>(probe_mark) || !std::isfinite(pixel[0]) || !std::isfinite(pixel[1]))
                continue;
            ++count;
            for (std::size_t c = 0; c < 2; ++c) sum[c] += static_cast<double>(pixel[c]);
        }
    }
    refused = trial.refused;
    if (!refused.empty() || count == 0) return std::nullopt;
    for (double& value : sum) value /= static_cast<double>(count);
    return sum;
}

}  // namespace

void fill_averages(const Original& original, std::span<Change*> changes, const gl::Caps& caps, const Stop& stop) {
    std::vector<Change> probes;
    std::vector<Change*> once;
    for (Change* change : changes)
        if (ranges::find(once, change) == once.end()) once.push_back(change);
    for (const Change* change : once)
        for (const std::vector<Edit>& edits : change->probes)
            probes.push_back({change->kind, change->where, {}, {}, edits});
    if (probes.empty()) return;
    const PlaceOptions places;
    Trials trials(original, probes, caps, small_picture(original.plan.scene));
    trials.open_scene(places);
    if (!trials.scene_error().empty()) return;
    std::size_t next = 0;
    for (Change* change : once) {
        std::vector<double> means;
        for (std::size_t i = 0; i < change->probes.size(); ++i, ++next) {
            if (stop && stop()) return;
            std::string refused;
            if (const auto two = drawn_means(trials, next, std::min(places.searched, trials.places().size()), refused))
                means.insert(means.end(), two->begin(), two->end());
            if (!refused.empty()) change->refused = refused;
        }
        if (means.empty() || means.size() != 2 * change->probes.size()) continue;
        std::string& text = change->edits.front().text;
        const std::string type = text.substr(0, text.find('('));
        means.resize(type == "float" ? 1 : static_cast<std::size_t>(type.back() - '0'));
        std::vector<std::string> numbers;
        for (const double mean : means) numbers.push_back(real_literal(std::abs(mean) < 1e-30 ? 0 : mean, 3));
        text = fmt::format("{}({})", type, fmt::join(numbers, ", "));
        change->after = excerpt(text);
        change->probes.clear();
    }
}

void fill_averages(const Original& original, std::vector<Change>& changes, const gl::Caps& caps, const Stop& stop) {
    std::vector<Change*> all;
    for (Change& change : changes) all.push_back(&change);
    fill_averages(original, all, caps, stop);
}

}  // namespace snell::accuracy
