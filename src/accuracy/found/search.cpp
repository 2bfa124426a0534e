#include "src/accuracy/found/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <map>

#include "parser/text/ranges.h"
#include "src/accuracy/found/apply.h"
#include "src/accuracy/found/climb.h"
#include "src/accuracy/found/trial.h"
#include "src/accuracy/rounds.h"

namespace snell::accuracy {

namespace {

constexpr double visible_error = 1 / 255.0;
constexpr double saves = .97;  // of the scene's time, by a few frames: less is noise
constexpr std::size_t most_held_out = 16, most_timed = 12, most_costs = 10, most_kept = 32, few_finalists = 4;
// When each part of the search must end, as parts of its time: what is left over goes to the next.
constexpr double singles_end = .45, combinations_end = .55, held_out_end = .65, times_end = .82, unused_end = .92;

double rmse_of(const FoundRung& rung) { return rung.worst()->own.light.rmse; }

}  // namespace

struct Search::Impl {
    Impl(const Original& scene, std::vector<Change> changes, const gl::Caps& caps, const BenchSettings& how,
         SearchOptions wanted)
        : original(scene), options(std::move(wanted)), settings(how) {
        result = untried(scene, std::move(changes), how, options);
        trials.emplace(original, result.changes, caps, settings);
        plan();
    }

    // ---- the order of things ---------------------------------------------------------------------------------

    void plan() {
        const auto of_aim = [&](Aim aim, auto task) {
            for (std::size_t i = 0; i < result.changes.size(); ++i)
                if (result.rungs[i].aim == aim) tasks.emplace_back([this, i, task] { (this->*task)(i); });
        };
        tasks.emplace_back([this] { open(); });
        of_aim(Aim::cheaper, &Impl::single);
        of_aim(Aim::better, &Impl::single);
        tasks.emplace_back([this] { begin_combinations(); });
        tasks.emplace_back([this] { combine(); });
        tasks.emplace_back([this] { begin_hold_out(); });
        tasks.emplace_back([this] { begin_times(); });
        of_aim(Aim::unused, &Impl::omission);
        tasks.emplace_back([this] { begin_costs(); });
    }

    // Only steps take time: a window may rest between them.
    bool step() {
        entered = std::chrono::steady_clock::now();
        const bool more = advance();
        before = spent();
        return more;
    }

    bool advance() {
        if (rounds) {
            if (!rounds->step()) end_rounds();
            return true;
        }
        if (tasks.empty()) return false;
        const auto task = std::move(tasks.front());
        tasks.pop_front();
        say(doing, 1 - static_cast<double>(tasks.size()) /
                           static_cast<double>(result.rungs.size() + result.places.size() + 8));
        task();
        return true;
    }

    double spent() const {
        return before + std::chrono::duration<double>(std::chrono::steady_clock::now() - entered).count();
    }
    double left(double part) const { return part * options.seconds - spent(); }
    bool stopped() {
        if (!result.interrupted && options.stop && options.stop()) result.interrupted = true;
        return result.interrupted;
    }
    bool over(double part) { return stopped() || left(part) <= 0; }
    void say(std::string_view what, double done) {
        if (options.report) options.report({"found rungs", what, done, std::max(left(1), 0.0)});
    }
    const char* out_of_time() const { return result.interrupted ? "the search was stopped" : "the time was up"; }
    // True, with the reason, if the rung can't be tried any more.
    bool skipped(FoundRung& rung, double part) {
        if (!over(part)) return false;
        rung.reason = out_of_time();
        result.late = result.late || !result.interrupted;
        return true;
    }

    // ---- pictures --------------------------------------------------------------------------------------------

    void open() {
        doing = "trying changes";
        trials->open_scene(options.places);
        if (const std::string wrong = trials->scene_error(); !wrong.empty()) return give_up(wrong);
        result.places = trials->places();
        result.searched = std::min(std::max<std::size_t>(options.places.searched, 1), result.places.size());
        Bench& scene = trials->scene();
        if (options.times) clock = scene.choose_clock(trials->variant());
        small();
        scene.warm_up(trials->variant(), clock);
        for (std::size_t place = result.places.size(); place-- > 0;)
            tasks.emplace_front([this, place] {
                // Elsewhere, as at the end of a slider, these pixels are left out, and the report says so.
                if (!over(singles_end) && is_broken(place) && place == 0) give_up(result.broken_words());
            });
    }

    // What is wrong with the scene as it is, is wrong with every change of it.
    void give_up(const std::string& reason) {
        tasks.clear();
        result.refuse_all(reason);
    }

    // In pictures of the present size.
    bool is_broken(std::size_t place) {
        const NonFinite pixels = non_finite(trials->original(place));
        if (pixels.count > 0 && !result.broken) result.broken = {place, pixels};
        return pixels.count > 0;
    }

    void small() { trials->resize(result.search_width, result.search_height); }
    void whole() { trials->resize(settings.width, settings.height); }

    // Draws the rung at these places. False: it is refused.
    bool draw(FoundRung& rung, Trial& trial, std::size_t from, std::size_t to) {
        rung.width = trials->scene().settings().width;
        rung.height = trials->scene().settings().height;
        for (std::size_t place = from; place < to && !stopped(); ++place) {
            const auto picture = trial.refused.empty() ? trials->picture(trial, place) : std::nullopt;
            if (picture && is_broken(place) && place == 0) trial.refused = result.broken_words();
            if (!picture || !trial.refused.empty()) return refuse(rung, trial);
            rung.at.push_back(trials->compare(*picture, place, rung.changes, false));
            rung.pixels_changed += rung.at.back().pixels_changed;
            std::size_t& worst = place < result.searched ? rung.worst_searched : rung.worst_held_out;
            if (place == result.searched || rung.at[worst] < rung.at.back()) worst = place;
        }
        return true;
    }

    static bool refuse(FoundRung& rung, const Trial& trial) {
        rung.at.clear();
        rung.outcome = Outcome::refused;
        rung.reason = trial.refused.empty() ? "this OpenGL cannot draw it" : trial.refused;
        return false;
    }

    void single(std::size_t i) {
        auto trial = try_rung(result.rungs[i], singles_end);
        keep(i, std::move(trial));
    }

    // What compiled once need not compile again, as long as there are few of them.
    void keep(std::size_t i, std::optional<Trial> trial) {
        if (trial && kept.size() < most_kept && useful(result.rungs[i])) kept.emplace(i, std::move(*trial));
    }
    Trial reopen(std::size_t i) {
        const auto found = kept.find(i);
        if (found == kept.end()) return trials->open(result.rungs[i].changes);
        Trial trial = std::move(found->second);
        kept.erase(found);
        return trial;
    }

    std::optional<Trial> try_rung(FoundRung& rung, double part) {
        if (skipped(rung, part)) return std::nullopt;
        Trial trial = trials->open(rung.changes);
        if (!draw(rung, trial, 0, result.searched)) return std::nullopt;
        if (rung.at.size() < result.searched) {
            rung.reason = "the search was stopped";
            rung.at.clear();
            return std::nullopt;
        }
        rung.outcome = Outcome::tried;
        if (options.times && rung.aim == Aim::cheaper)
            rung.quick_ratio = trials->quick_ratio(trial, clock, [this] { return stopped(); });
        return trial;
    }

    // ---- combinations ----------------------------------------------------------------------------------------

    // Cheaper, drawn, with an error that is a number; and it saves time, as far as that is known.
    bool useful(const FoundRung& rung) const {
        return rung.aim == Aim::cheaper && rung.outcome == Outcome::tried && std::isfinite(rmse_of(rung)) &&
               (!options.times || (rung.quick_ratio > 0 && rung.quick_ratio < saves));
    }

    void begin_combinations() {
        doing = "trying combinations";
        std::vector<Climbs::Single> singles;
        for (std::size_t i = 0; i < result.rungs.size() && options.times; ++i)
            if (useful(result.rungs[i])) singles.push_back({i, rmse_of(result.rungs[i])});
        climbs.emplace(std::move(singles), result.changes, options.places.seed);
    }

    void combine() {
        const bool enough = result.rungs.size() >= result.changes.size() + options.combinations;
        if (enough || over(combinations_end)) return;
        auto changes = climbs->next();
        if (!changes) return;
        FoundRung rung{.name = rung_name(*changes), .changes = std::move(*changes)};
        auto trial = try_rung(rung, combinations_end);
        const bool drawn = rung.outcome == Outcome::tried;
        climbs->tell(drawn ? rmse_of(rung) : std::numeric_limits<double>::infinity());
        result.rungs.push_back(std::move(rung));
        keep(result.rungs.size() - 1, std::move(trial));
        tasks.emplace_front([this] { combine(); });
    }

    // ---- places that were held out ---------------------------------------------------------------------------

    std::vector<std::size_t> promising() const {
        std::vector<std::size_t> some;
        for (std::size_t i = 0; i < result.rungs.size(); ++i)
            if (useful(result.rungs[i])) some.push_back(i);
        return options.times ? in_layers(result, std::move(some), most_held_out) : some;
    }

    void begin_hold_out() {
        doing = "places that were held out";
        std::vector<std::size_t> order = promising();
        for (std::size_t i = 0; i < result.changes.size(); ++i)
            if (result.rungs[i].aim == Aim::better && result.rungs[i].outcome == Outcome::tried) order.push_back(i);
        for (auto i = order.rbegin(); i != order.rend(); ++i)
            tasks.emplace_front([this, rung = *i] { hold_out(rung); });
    }

    void hold_out(std::size_t i) {
        FoundRung& rung = result.rungs[i];
        // Without a few of them, there is nothing to time.
        const double end = !options.times || finalists.size() < few_finalists ? times_end : held_out_end;
        if (over(end)) {
            rung.reason = out_of_time();
            return;
        }
        Trial trial = reopen(i);
        if (!draw(rung, trial, result.searched, result.places.size()) || rung.at.size() < result.places.size()) return;
        rung.held_out = result.places.size() > result.searched;
        const double seen = rung.searched()->own.light.rmse;
        const double unseen = rung.held_out ? rung.unseen()->own.light.rmse : seen;
        rung.only_where_tried = rung.aim == Aim::cheaper && !(unseen <= 2 * seen) && !(unseen <= visible_error);
        for (const std::size_t place : {std::size_t{0}, rung.worst_place()})
            if (!rung.at[place].flip && !over(end))
                if (const auto picture = trials->picture(trial, place))
                    rung.at[place].flip = trials->compare(*picture, place, rung.changes, true).flip;
        if (!rung.only_where_tried) finalists.emplace(i, std::move(trial));
    }

    // ---- times -----------------------------------------------------------------------------------------------

    void begin_times() {
        kept.clear();
        std::vector<std::size_t> cheaper;
        for (const auto& [i, trial] : finalists)
            if (result.rungs[i].aim == Aim::cheaper) cheaper.push_back(i);
        ranges::stable_sort(cheaper, {}, [&](std::size_t i) { return rmse_of(result.rungs[i]); });
        const std::size_t most = fitting(std::min(most_timed, cheaper.size()), times_end, result.timed_size);
        begin_rounds(result.timed, spread(cheaper, most), times_end, result.timed_size);
    }

    // How many rungs can be timed in as many rounds as a front needs: in smaller pictures if frames are slow, and fewer
    // if that does not suffice.
    std::size_t fitting(std::size_t most, double part, std::array<int, 2>& size) {
        size = {settings.width, settings.height};
        std::size_t n = most;
        double frame = 0;
        const auto seconds = [&](std::size_t rungs) {
            const double sample = frame > 500 ? frame : frame + std::max(frame, options.at_least);
            const auto needed = static_cast<double>(std::max<std::size_t>(rounds_for(rungs + 1), 7));
            const auto entrants = static_cast<double>(rungs + 2);
            return entrants * (sample * needed + 3 * frame) / 1e3;
        };
        while (options.times && !stopped()) {
            trials->scene().resize(size[0], size[1]);
            frame = trials->scene().warm_up(trials->variant(), ClockKind::wall).value_or(1);
            if (seconds(most) <= left(part) || size[0] / 2 < result.search_width) break;
            size = {size[0] / 2, size[1] / 2};
        }
        small();
        while (options.times && n > 3 && seconds(n) > left(part)) --n;
        return n;
    }

    // The scene is the last entrant.
    void begin_rounds(SweepResult& sweep, const std::vector<std::size_t>& of, double part, std::array<int, 2> size) {
        sweep = {};
        sweep.scene = result.scene;
        sweep.sweep = {.kind = SweepKind::found, .name = "found rungs"};
        sweep.residual = 0;
        sweep.clock = clock;
        whole();
        std::vector<Entrant> entrants;
        for (const std::size_t i : of) {
            result.rungs[i].timed = sweep.rungs.size();
            sweep.rungs.push_back(trials->summary(result.rungs[i], finalists.at(i)));
            entrants.push_back(trials->entrant(*finalists.at(i).bench, size));
        }
        sweep.rungs.push_back(trials->scene_summary());
        entrants.push_back(trials->entrant(trials->scene(), size));
        sweep.sweep.reference = sweep.sweep.current = entrants.size() - 1;
        for (const RungResult& rung : sweep.rungs)
            sweep.sweep.rungs.push_back({.name = rung.name, .variant = {}, .steps = {}, .elsewhere = {}});
        timing = &sweep;
        if (!options.times || of.empty()) return end_rounds();
        rounds.emplace(std::move(entrants),
                       RoundOptions{.clock = clock,
                                    .base = sweep.sweep.current,
                                    .rounds = options.rounds,
                                    .at_least = options.at_least,
                                    .seed = options.places.seed,
                                    .seconds_left = [this, part] { return left(part); },
                                    .over = [this, part] { return over(part); },
                                    .stopped = [this, part] { return over(part); },
                                    .report = [this](std::string_view what, double done) { say(what, done); }});
    }

    void end_rounds() {
        SweepResult& sweep = *timing;
        std::vector<double> again;
        if (rounds) {
            for (std::size_t i = 0; i < sweep.rungs.size(); ++i) take_times(sweep.rungs[i], rounds->times()[i]);
            again = rounds->again();
        }
        sweep.interrupted = result.interrupted;
        conclude(sweep, again, options.places.seed);
        rounds.reset();
        timing = nullptr;
        small();
    }

    // ---- what may be left out --------------------------------------------------------------------------------

    void omission(std::size_t i) {
        doing = "leaving things out";
        FoundRung& rung = result.rungs[i];
        if (skipped(rung, unused_end)) return;
        whole();
        Trial trial = trials->open(rung.changes);
        for (std::size_t place = 0; place < result.places.size() && rung.pixels_changed == 0 && !stopped(); ++place)
            if (!draw(rung, trial, place, place + 1)) return small();
        small();
        rung.outcome = Outcome::tried;
        rung.held_out = rung.at.size() == result.places.size();
        if (!rung.held_out || rung.pixels_changed > 0) return;
        trials->find_savings(rung, trial);
        finalists.emplace(i, std::move(trial));
    }

    void begin_costs() {
        std::vector<std::size_t> of;
        for (const Aim aim : {Aim::unused, Aim::better})
            for (const auto& [i, trial] : finalists)
                if (result.rungs[i].aim == aim) of.push_back(i);
        of.resize(std::min(of.size(), fitting(std::min(of.size(), most_costs), 1, result.costs_size)));
        begin_rounds(result.costs, of, 1, result.costs_size);
    }

    Original original;
    SearchOptions options;
    BenchSettings settings;
    FoundResult result;
    std::optional<Trials> trials;
    std::optional<Climbs> climbs;
    std::map<std::size_t, Trial> kept, finalists;  // by index into result.rungs
    std::optional<Rounds> rounds;
    SweepResult* timing = nullptr;
    ClockKind clock = ClockKind::wall;
    std::string_view doing = "opening the scene";
    std::deque<std::function<void()>> tasks;
    double before = 0;  // seconds of the steps before this one
    std::chrono::steady_clock::time_point entered;
};

Search::Search(const Original& original, std::vector<Change> changes, const gl::Caps& caps,
               const BenchSettings& settings, SearchOptions options)
    : impl_(std::make_unique<Impl>(original, std::move(changes), caps, settings, std::move(options))) {}

Search::~Search() = default;
Search::Search(Search&&) noexcept = default;

bool Search::step() { return impl_->step(); }

const FoundResult& Search::result() const { return impl_->result; }

FoundResult Search::take() { return std::move(impl_->result); }

}  // namespace snell::accuracy
