#include "src/accuracy/found/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "parser/text/ranges.h"
#include "src/accuracy/clock.h"
#include "src/accuracy/found/apply.h"
#include "src/document/document.h"
#include "src/gl/debug.h"
#include "src/gl/present.h"
#include "src/plan/used_files.h"

namespace snell::accuracy {

namespace {

constexpr double quick_sample = 8, slow_frame = 30;  // milliseconds
constexpr int quick_pairs = 7;

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
    Access access = original_.files.access();
    if (access.instead)
        for (const auto& [path, text] : *access.instead) texts.try_emplace(path, text);
    access.instead = std::make_shared<const std::map<std::string, std::string>>(std::move(texts));
    trial.files = std::make_unique<Files>(original_.files.folder(), std::move(access));
    trial.sources = std::make_unique<Sources>();
    auto parsed = parse_document(original_.path, *trial.files, *trial.sources, trial.problems);
    if (!parsed) {
        trial.refused = "the scene cannot be read";
        return trial;
    }
    Plan plan = make_plan(std::move(parsed->scene), *trial.files, *trial.sources, trial.problems);
    carry_over(original_.plan.rungs, original_.plan.scene, plan.rungs, plan.scene);
    BenchSettings settings = settings_;
    if (!shared) settings.previous = nullptr;
    gl::take_errors();
    trial.bench = std::make_unique<Bench>(std::move(plan), *trial.files, *trial.sources, caps_, settings);
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

Trials::Quick Trials::quick_ratio(Trial& trial, double warm, ClockKind clock, const Stop& stop) {
    if (warm > slow_frame) {
        const double ratio = warm / std::max(scene().warm_up(variant(), clock).value_or(0), 1e-3);
        return {ratio, ratio};
    }
    std::vector<double> ratios;
    for (int i = 0; i < quick_pairs && !(stop && stop()); ++i) {
        const double changed = chosen(trial.bench->time(variant(), quick_sample), clock);
        const double unchanged = chosen(scene().time(variant(), quick_sample), clock);
        if (unchanged > 0) ratios.push_back(changed / unchanged);
    }
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
    const Difference& worst = *rung.worst();
    RungResult shown{.name = rung.name, .steps = rung.changes, .drawn = true};
    shown.picture = picture(trial, 0).value_or(Picture{});
    shown.whole = worst.whole;
    shown.own = worst.own;
    shown.alone = worst.own.light;
    shown.flip = rung.flip().value_or(std::nan(""));
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

}  // namespace snell::accuracy
