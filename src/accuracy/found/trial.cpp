#include "src/accuracy/found/trial.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/accuracy/found/change.h"
#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/gl/present.h"
#include "src/plan/texts.h"

namespace snell::accuracy {

namespace {

constexpr double quick_sample = 8, slow_frame = 30;  // milliseconds
constexpr int quick_pairs = 7, slower_pairs = 3;     // where a frame is a sample, few tell as much

// The messages that a runtime has for its values too, and the errors of OpenGL that were made meanwhile.
void add_problems(Bench& bench, Diagnostics& diagnostics) {
    diagnostics.append(bench.runtime().value_problems());
    diagnostics.append(bench.problems());
    for (const std::string& error : gl::take_errors()) diagnostics.warning("opengl-error", error);
}

Figures no_difference() { return {0, psnr(0), 0, 0}; }

}  // namespace

Trials::Trials(const Original& original, std::span<const Change> changes, const gl::Caps& caps,
               const BenchSettings& settings)
    : original_(original), changes_(changes), caps_(caps), settings_(settings) {
    settings_.previous = nullptr;
}

void Trials::open_scene(const PlaceOptions& options) {
    BenchSettings any = settings_;
    any.specialise = false;
    Bench probe(original_.plan, original_.files, original_.sources, caps_, any);
    const Runtime& runtime = probe.runtime();
    const Place own{settings_.view, settings_.time, settings_.sets};
    places_ = make_places(runtime.controls(), runtime.scene(), runtime.animated(), own, options);
    settings_.varying = varying(places_, own);
    settings_.previous = &runtime;
    scene_ = open({});
    if (scene_.bench) settings_.previous = &scene_.bench->runtime();
}

std::string Trials::scene_error() const {
    const auto& problems = scene_.problems.items();
    const auto error = ranges::find(problems, Severity::error, &Diagnostic::severity);
    if (error != problems.end()) return "the scene has errors, such as: " + error->message;
    return scene_.bench ? "" : scene_.refused;
}

void Trials::resize(int width, int height) {
    settings_.width = width;
    settings_.height = height;
    scene_.bench->resize(width, height);
}

Trial Trials::open(std::span<const std::size_t> changes, bool shared) {
    Trial trial;
    std::map<std::string, std::string> texts;
    if (!changes.empty()) {
        const auto chosen = choose_changes(rung_name(changes), changes_, original_.sources, trial.refused);
        if (!chosen) return trial;
        std::vector<const Change*> these;
        for (const Change& change : chosen->changes) these.push_back(&change);
        texts = changed_texts(these, original_.sources);
    }
    trial.files = std::make_unique<Files>(original_.files.folder(), original_.files.access().with(std::move(texts)));
    trial.sources = std::make_unique<Sources>();
    auto plan = read_plan(original_.path, *trial.files, *trial.sources, trial.problems);
    if (!plan) {
        trial.refused = "the scene cannot be read";
        return trial;
    }
    carry_over(original_.plan.rungs, original_.plan.scene, plan->rungs, plan->scene);
    BenchSettings settings = settings_;
    if (!shared) settings.previous = nullptr;
    gl::take_errors();
    trial.bench = std::make_unique<Bench>(std::move(*plan), *trial.files, *trial.sources, caps_, settings);
    add_problems(*trial.bench, trial.problems);
    if (scene_.bench) judge(trial);
    return trial;
}

// A change that makes an error or a warning is none that anybody should make.
void Trials::judge(Trial& trial) const {
    for (const Diagnostic& problem : trial.problems.items()) {
        // A slider that nothing reads any more is a consequence, not a mistake.
        if (problem.severity == Severity::note || problem.code == "unknown-uniform") continue;
        const bool old = ranges::any_of(scene_.problems.items(), [&](const Diagnostic& other) {
            return other.code == problem.code && other.message == problem.message;
        });
        if (old) continue;
        const std::string place =
            problem.has_span
                ? fmt::format("line {}: ", trial.sources->position(problem.span.file, problem.span.begin).line)
                : "";
        trial.refused = fmt::format("{}{}: {}", place, name(problem.severity), problem.message);
        trial.bench.reset();
        return;
    }
}

// A uniform that the changed scene does not list has no slider any more, so nobody can give it the place's value.
Place Trials::seen_by(Trial& trial, std::size_t place) const {
    Place seen = places_[place];
    const Runtime& runtime = trial.bench->runtime();
    for (const snell::Control& control : runtime.controls().items) {
        if (control.listed) continue;
        const std::string start = runtime.scene().programs[control.program].name + "." + control.name + "=";
        const auto ours = seen.sets.begin() + static_cast<std::ptrdiff_t>(settings_.sets.size());
        seen.sets.erase(
            std::remove_if(ours, seen.sets.end(), [&](const std::string& set) { return set.starts_with(start); }),
            seen.sets.end());
    }
    return seen;
}

std::optional<Picture> Trials::picture(Trial& trial, std::size_t place) {
    trial.bench->resize(settings_.width, settings_.height);
    trial.bench->at(seen_by(trial, place));
    auto picture = trial.bench->picture(variant());
    trial.bench->at(places_.front());
    if (const auto errors = gl::take_errors(); !errors.empty()) trial.refused = "OpenGL reports " + errors.front();
    return picture;
}

Trials::Key Trials::key(std::size_t place) const {
    return {place, static_cast<std::size_t>(settings_.width), static_cast<std::size_t>(settings_.height)};
}

const Picture& Trials::original(std::size_t place) {
    const auto found = pictures_.find(key(place));
    if (found != pictures_.end()) return found->second;
    scene_.bench->at(places_[place]);
    Picture& kept = pictures_[key(place)];
    kept = scene_.bench->picture(variant()).value_or(Picture{});
    scene_.bench->at(places_.front());
    return kept;
}

Difference Trials::compare(const Picture& picture, std::size_t place, bool only_changed, bool flip) {
    const Picture& reference = original(place);
    Difference difference;
    Region changed = where_different(picture, reference);
    difference.pixels_changed = count(changed);
    Region own = only_changed ? changed : region(place);
    for (std::size_t i = 0; i < own.size(); ++i) own[i] |= changed[i];
    difference.whole = accuracy::compare(picture, reference);
    difference.own = own.empty() ? difference.whole : accuracy::compare(picture, reference, own);
    if (difference.pixels_changed == 0) {
        // Where nothing changed there may be no pixel that counts.
        difference.own.light = difference.own.display = no_difference();
        difference.flip = 0;
        return difference;
    }
    if (flip) difference.flip = mean_of(flip_map(picture, reference), own);
    return difference;
}

const Region& Trials::region(std::size_t place) {
    const auto [known, fresh] = regions_.try_emplace(key(place));
    if (!fresh) return known->second;
    const Picture& whole = original(place);
    scene_.bench->at(places_[place]);
    const std::vector<bool> all(original_.plan.scene.draws.size(), true);
    if (const auto without = scene_.bench->picture(variant(), &all)) known->second = where_different(whole, *without);
    if (count(known->second) == 0) known->second.clear();
    scene_.bench->at(places_.front());
    return known->second;
}

std::array<int, 2> Trials::quick_size(std::array<int, 2> whole, ClockKind clock) {
    const auto frame = [&] { return scene().warm_up(variant(), clock).value_or(slow_frame + 1); };
    std::array<int, 2> size{settings_.width, settings_.height};
    std::vector<std::array<int, 2>> larger;
    for (auto next = whole; next[0] > size[0]; next = {next[0] / 2, next[1] / 2}) larger.push_back(next);
    for (bool fast = frame() <= slow_frame; fast && !larger.empty(); larger.pop_back()) {
        scene().resize(larger.back()[0], larger.back()[1]);
        fast = frame() <= slow_frame;
        if (fast) size = larger.back();
    }
    scene().resize(settings_.width, settings_.height);
    return size;
}

Trials::Quick Trials::quick_ratio(Trial& trial, double warm, ClockKind clock, const Stop& stop) {
    scene().resize(trial.bench->settings().width, trial.bench->settings().height);
    if (warm > slow_frame) {
        const double ratio = warm / std::max(scene().warm_up(variant(), clock).value_or(0), 1e-3);
        return {ratio, ratio};
    }
    std::vector<Entrant> entrants;
    for (Bench* bench : {trial.bench.get(), &scene()})
        entrants.push_back({[warm](ClockKind) { return warm; },  // both are
                            [bench, variant = variant()](double least) { return bench->time(variant, least); }});
    Rounds rounds(std::move(entrants), {.clock = clock,
                                        .kept = 1,
                                        .control = false,
                                        .rounds = warm > quick_sample ? slower_pairs : quick_pairs,
                                        .at_least = quick_sample,
                                        .stopped = [&] { return stop && stop(); }});
    rounds.run();
    std::vector<double> ratios = quotients(by_clock(rounds.times(0), clock), by_clock(rounds.times(1), clock));
    if (ratios.empty()) return {};
    ranges::sort(ratios);
    return {median(ratios), ratios[2 * ratios.size() / 3]};
}

Entrant Trials::entrant(Bench& bench, std::array<int, 2> size) const {
    return {[&bench, size, variant = variant()](ClockKind clock) {
                bench.resize(size[0], size[1]);
                return bench.warm_up(variant, clock);
            },
            [&bench, variant = variant()](double at_least) { return bench.time(variant, at_least); }};
}

RungResult Trials::summary(const FoundRung& rung, Trial& trial) {
    RungResult shown{.name = rung.name, .steps = rung.changes};
    take_errors(shown, rung);
    shown.picture = picture(trial, 0).value_or(Picture{});
    return shown;
}

RungResult Trials::scene_summary() {
    RungResult shown{.name = "scene", .drawn = true};
    shown.picture = original(0);
    shown.own = shown.whole = {.light = no_difference(), .display = no_difference()};
    shown.alone = no_difference();
    return shown;
}

std::int64_t Trials::saved_memory(Trial& trial) {
    return static_cast<std::int64_t>(scene().runtime().counters().gpu_bytes) -
           static_cast<std::int64_t>(trial.bench->runtime().counters().gpu_bytes);
}

Loading Trials::load(std::span<const std::size_t> changes, ClockKind clock) {
    const auto now = [&] { return clock == ClockKind::cpu ? cpu_milliseconds() : wall_milliseconds(); };
    gl::finish();
    const double begin = now();
    const Trial alone = open(changes, false);
    gl::finish();
    return {now() - begin, alone.bench ? alone.bench->runtime().counters().bytes_decoded : 0};
}

// Times of what may be on the front, and what may be left out.

namespace {

// Few rungs in many rounds: every pair that is compared widens the intervals of all.
constexpr std::size_t most_timed = 8, most_costs = 8, load_pairs = 3, spare_rounds = 20;
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
        const double sample = FrameClock::sample_milliseconds(frame, options.at_least);
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
        for (std::size_t i = 0; i < sweep.rungs.size(); ++i) take_times(sweep.rungs[i], rounds->times(i));
        again = by_clock(rounds->again(), clock);
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
