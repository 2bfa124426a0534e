#include "src/accuracy/found/together.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "parser/text/ranges.h"
#include "src/accuracy/found/climb.h"
#include "src/accuracy/found/trial.h"
#include "src/accuracy/rounds.h"

namespace snell::accuracy {

namespace {

constexpr std::size_t most_found = 4, most_steps = 3;
constexpr int finer_samples = 4;

std::string mix_name(const Scene& scene, const Mix& mix) {
    std::string name;
    for (std::size_t i = 0; i < mix.rungs.size(); ++i) name += scene.ladders[i].rungs[mix.rungs[i]] + " ";
    if (mix.samples > 1) name += fmt::format("{} samples ", mix.samples);
    if (!mix.changes.empty()) name += "found " + rung_name(mix.changes) + " ";
    return name.empty() ? "scene" : name.substr(0, name.size() - 1);
}

class Mixer {
public:
    Mixer(const Original& original, const FoundResult& found, Bench& bench, const gl::Caps& caps,
          const BenchSettings& settings, const Wish& wish, const MixOptions& options)
        : original_(original),
          found_(found),
          bench_(bench),
          settings_(settings),
          wish_(wish),
          options_(options),
          trials_(original, found.changes, caps, settings),
          own_{original.plan.rungs, 1, {}} {
        PlaceOptions places;
        places.seed = found.seed;
        trials_.open_scene(places);
        clock_ = trials_.scene().choose_clock(trials_.variant());
        reference_ = &options.measuring.references->of(bench, last_rungs(bench.scene()), options.measuring.stop);
        rungs_ = {own_.rungs};
        const auto add = [&](const Rungs& rungs) {
            if (ranges::find(rungs_, rungs) == rungs_.end()) rungs_.push_back(rungs);
        };
        add(last_rungs(bench.scene()));
        for (const Rungs& rungs : options.rungs) add(rungs);
        changes_ = {{}};
        for (const std::size_t i : candidates()) changes_.push_back(found.rungs[i].changes);
    }

    MixAdvice run() {
        MixAdvice advice{.places = trials_.places().size()};
        if (reference_->picture.rgba.empty() || !trials_.scene_error().empty()) return advice;
        Mix centre = own_;
        std::vector<Mix> seen;
        for (std::size_t step = 0; step < most_steps && left() > 0 && !stopped(); ++step) {
            seen.push_back(centre);
            MixAdvice next = measure(around(centre), left() / 2);
            next.places = advice.places;
            if (!next.best) {
                if (!advice.best) advice.sweep.cannot_say = next.sweep.cannot_say;
                break;
            }
            advice = std::move(next);
            const Mix& best = advice.mixes[*advice.best];
            // Where it was before, it is best of all around it.
            const bool again = step > 0 && ranges::find(seen, best) != seen.end();
            advice.settled = again && advice.whole;
            if (again) break;
            centre = best;
        }
        return advice;
    }

private:
    // The found rungs, those on the front first; they are timed again.
    std::vector<std::size_t> candidates() const {
        std::vector<std::size_t> timed;
        for (std::size_t i = 0; i < found_.rungs.size(); ++i)
            if (const FoundRung& rung = found_.rungs[i]; rung.aim == Aim::cheaper && found_.times(rung))
                timed.push_back(i);
        return in_layers(found_, std::move(timed), most_found);
    }

    double left() const {
        const auto spent = std::chrono::steady_clock::now() - start_;
        return options_.measuring.seconds - std::chrono::duration<double>(spent).count();
    }
    bool stopped() const { return options_.measuring.stop && options_.measuring.stop(); }

    // The scene as it stands, `centre`, and what differs from that in one thing.
    std::vector<Mix> around(const Mix& centre) const {
        std::vector<Mix> all{own_};
        const auto add = [&](const Mix& mix) {
            if (ranges::find(all, mix) == all.end()) all.push_back(mix);
        };
        add(centre);
        // What may help most comes first: there may be no time for the others.
        const auto finer = [&] {
            for (const int samples : {1, finer_samples}) add({centre.rungs, samples, centre.changes});
        };
        if (wish_.milliseconds) finer();
        for (const auto& changes : changes_) add({centre.rungs, centre.samples, changes});
        for (const Rungs& rungs : rungs_) add({rungs, centre.samples, centre.changes});
        finer();
        return all;
    }

    Trial& trial_of(const std::vector<std::size_t>& changes) {
        const auto [known, fresh] = trials_by_changes_.try_emplace(changes);
        if (fresh) known->second = trials_.open(changes);
        return known->second;
    }
    static Variant variant_of(const Mix& mix) { return {mix.rungs, {.multisample = mix.samples}}; }

    // What pictures of a place with as many samples are compared with, and the pixels in which the scene draws; empty:
    // all.
    struct Goal {
        Picture picture;
        Region region;
    };
    const Goal& goal_at(std::size_t place, int samples) {
        const auto [known, fresh] = goals_.try_emplace({place, samples});
        Goal& goal = known->second;
        if (!fresh) return goal;
        const Variant last{last_rungs(bench_.scene()), {.multisample = samples}};
        goal.picture = trials_.picture(trial_of({}), place, last).value_or(Picture{});
        const std::vector<bool> nothing(bench_.scene().draws.size(), true);
        trials_.scene().at(trials_.places()[place]);
        const auto without = trials_.scene().picture(last, &nothing);
        trials_.scene().at(trials_.places().front());
        if (without) goal.region = where_different(goal.picture, *without);
        if (count(goal.region) == 0) goal.region.clear();
        if (place == 0) goal.picture = reference_->picture;
        return goal;
    }

    // False: it was not drawn at every place.
    bool draw(RungResult& rung, const Mix& mix) {
        Trial& trial = trial_of(mix.changes);
        for (std::size_t place = 0; place < trials_.places().size(); ++place) {
            if (!trial.refused.empty() || stopped()) return false;
            if (place == 0)
                trials_.resize(settings_.width, settings_.height);
            else
                trials_.resize(found_.search_width, found_.search_height);
            const Goal& goal = goal_at(place, place == 0 ? 1 : mix.samples);
            auto picture = trials_.picture(trial, place, variant_of(mix));
            if (!picture || goal.picture.rgba.empty()) return false;
            const Error error = compare(*picture, goal.picture, goal.region);
            if (place == 0 || !(error.light.rmse <= rung.own.light.rmse)) rung.own = error;
            if (place > 0) continue;
            rung.whole = compare(*picture, goal.picture);
            rung.alone = unknown_figures;
            rung.flip = mean_of(flip_map(*picture, goal.picture), goal.region);
            rung.picture = std::move(*picture);
        }
        trials_.resize(settings_.width, settings_.height);
        return rung.drawn = true;
    }

    void judge_reference(SweepResult& sweep) {
        trials_.resize(settings_.width, settings_.height);
        const Region& region = goal_at(0, 1).region;
        sweep.finest = reference_->knobs;
        sweep.reference = reference_->picture;
        sweep.own_pixels = region.empty() ? 0 : count(region);
        if (const NonFinite bad = non_finite(reference_->picture, region); bad.count > 0)
            sweep.cannot_say = "the reference is " + text_of(bad);
        if (reference_->half.rgba.empty()) return;
        sweep.residual = compare(reference_->half, reference_->picture, region).light.rmse;
        sweep.whole_residual = compare(reference_->half, reference_->picture).light.rmse;
    }

    Entrant entrant(const Mix& mix) {
        Bench* bench = trial_of(mix.changes).bench.get();
        return {[this, bench, mix](ClockKind clock) -> std::optional<double> {
                    if (!bench) return std::nullopt;
                    bench->resize(settings_.width, settings_.height);
                    bench->at(trials_.places().front());
                    return bench->warm_up(variant_of(mix), clock);
                },
                [bench, mix](double at_least) { return bench->time(variant_of(mix), at_least); }};
    }

    MixAdvice measure(std::vector<Mix> mixes, double seconds) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        const auto time_left = [end] {
            return std::chrono::duration<double>(end - std::chrono::steady_clock::now()).count();
        };
        MixAdvice advice;
        SweepResult& sweep = advice.sweep;
        sweep.scene = original_.path;
        sweep.sweep = {.kind = SweepKind::lattice, .name = "ladders, samples and found rungs together"};
        sweep.clock = clock_;
        judge_reference(sweep);
        std::vector<Entrant> entrants;
        bool drawn = true;
        for (const Mix& mix : mixes) {
            drawn = entrants.empty() || time_left() >= seconds / 2;
            if (!drawn) break;
            RungResult rung{.name = mix_name(bench_.scene(), mix), .steps = mix.rungs};
            rung.steps.push_back(mix.samples > 1 ? 1 : 0);
            rung.steps.push_back(mix.changes.empty() ? 1 : 0);
            // The scene itself is the first: ratios are to it.
            if (!draw(rung, mix)) {
                if (entrants.empty()) return {};
                continue;
            }
            sweep.sweep.rungs.push_back(
                {.name = rung.name, .variant = variant_of(mix), .steps = rung.steps, .elsewhere = {}});
            sweep.rungs.push_back(std::move(rung));
            advice.mixes.push_back(mix);
            entrants.push_back(entrant(mix));
        }
        Rounds rounds(std::move(entrants), {.clock = clock_,
                                            .rounds = options_.measuring.rounds,
                                            .at_least = options_.measuring.at_least,
                                            .seed = options_.measuring.seed,
                                            .seconds_left = time_left,
                                            .over = [&] { return stopped() || time_left() <= 0; },
                                            .stopped = [&] { return stopped() || time_left() <= 0; },
                                            .report = [](std::string_view, double) {}});
        while (rounds.step()) continue;
        sweep.sweep.reference = sweep.rungs.size();  // it is none of them
        for (std::size_t i = 0; i < sweep.rungs.size(); ++i) take_times(sweep.rungs[i], rounds.times()[i]);
        conclude(sweep, rounds.again(), options_.measuring.seed);
        advice.whole = drawn && !stopped() && !sweep.few_rounds;
        advice.best = choose_surely(sweep, wish_);
        advice.met = advice.best && fulfils(sweep, sweep.rungs[*advice.best], wish_);
        return advice;
    }

    Original original_;
    const FoundResult& found_;
    Bench& bench_;
    const BenchSettings& settings_;
    const Wish& wish_;
    const MixOptions& options_;
    Trials trials_;
    Mix own_;
    ClockKind clock_ = ClockKind::wall;
    const Reference* reference_ = nullptr;
    std::vector<Rungs> rungs_;                       // that are tried
    std::vector<std::vector<std::size_t>> changes_;  // the first: none
    std::map<std::vector<std::size_t>, Trial> trials_by_changes_;
    std::map<std::pair<std::size_t, int>, Goal> goals_;  // by place and samples
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

MixAdvice advise_together(const Original& original, const FoundResult& found, Bench& bench, const gl::Caps& caps,
                          const BenchSettings& settings, const Wish& wish, const MixOptions& options) {
    return Mixer(original, found, bench, caps, settings, wish, options).run();
}

std::optional<std::size_t> choose_surely(const SweepResult& sweep, const Wish& wish) {
    const auto best = choose(sweep, wish);
    const std::size_t now = sweep.sweep.current;
    if (!best || wish.milliseconds || *best == now || !fulfils(sweep, sweep.rungs[now], wish)) return best;
    if (sweep.rungs[now].rounds == 0) return std::nullopt;  // what anything saves is not known
    return sweep.rungs[*best].ratio.high < std::min(1., sweep.control.ratio.low) ? best : now;
}

}  // namespace snell::accuracy
