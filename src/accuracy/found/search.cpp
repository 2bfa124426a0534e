#include "src/accuracy/found/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/accuracy/found/trial.h"

namespace snell::accuracy {

namespace {

constexpr double visible_error = .016;  // RMSE of light, for someone who looks for it
constexpr double least_saving = .97;    // ratio of times, by a few frames: less is noise
constexpr double least_saving_more = .98;
// What most often saves much is tried first: there may be no time for the rest.
constexpr std::array promising{ChangeKind::culled,       ChangeKind::fewer_cells,   ChangeKind::fewer_slices,
                               ChangeKind::lower_levels, ChangeKind::fewer_rounds,  ChangeKind::smaller_noise,
                               ChangeKind::fewer_texels, ChangeKind::less_filtered, ChangeKind::expression_mean,
                               ChangeKind::lookup_mean,  ChangeKind::per_frame,     ChangeKind::per_vertex,
                               ChangeKind::without_term, ChangeKind::polynomial};
constexpr std::size_t most_held_out = 16, most_kept = 32;

}  // namespace

Search::Impl::Impl(const Original& scene, std::vector<Change> changes, const gl::Caps& caps, const BenchSettings& how,
                   SearchOptions wanted)
    : original(scene), options(std::move(wanted)), settings(how) {
    result = untried(scene, std::move(changes), how, options);
    trials.emplace(original, result.changes, caps, settings);
    plan();
}

// ---- the order of things ------------------------------------------------------------------------------------

void Search::Impl::plan() {
    std::vector<std::size_t> order(result.changes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    ranges::stable_sort(order, {}, [&](std::size_t i) { return ranges::find(promising, result.changes[i].kind); });
    const auto of_aim = [&](Aim aim, auto task) {
        for (const std::size_t i : order)
            if (result.rungs[i].aim == aim) tasks.emplace_back([i, task] { task(i); });
    };
    const auto single = [this](std::size_t i) { try_rung(i, singles_end, [] {}); };
    tasks.emplace_back([this] { open(); });
    of_aim(Aim::cheaper, single);
    of_aim(Aim::better, single);
    tasks.emplace_back([this] { begin_combinations(); });
    tasks.emplace_back([this] { combine(); });
    tasks.emplace_back([this] { begin_hold_out(); });
    tasks.emplace_back([this] { begin_times(); });
    of_aim(Aim::unused, [this](std::size_t i) { omission(i); });
    tasks.emplace_back([this] { begin_costs(); });
}

// Only steps take time: a window may rest between them.
bool Search::Impl::step() {
    entered = {};
    const bool more = advance();
    before = spent();
    return more;
}

bool Search::Impl::advance() {
    if (rounds) {
        if (!rounds->step()) end_rounds();
        return true;
    }
    if (tasks.empty()) return false;
    const auto task = std::move(tasks.front());
    tasks.pop_front();
    const auto all = static_cast<double>(result.rungs.size() + result.places.size() + 8);
    say(doing, std::max(1 - static_cast<double>(tasks.size()) / all, 0.0));
    task();
    return true;
}

double Search::Impl::spent() const { return before + 1e-3 * entered.milliseconds(); }

bool Search::Impl::stopped() {
    if (!result.interrupted && options.stop && options.stop()) result.interrupted = true;
    return result.interrupted;
}

void Search::Impl::say(std::string_view what, double done) {
    if (options.report) options.report({"found rungs", what, done, std::max(left(1), 0.0)});
}

// True, with the reason, if the rung can't be tried any more.
bool Search::Impl::skipped(FoundRung& rung, double part) {
    if (!over(part)) return false;
    rung.reason = out_of_time();
    result.late = result.late || !result.interrupted;
    return true;
}

// ---- pictures -----------------------------------------------------------------------------------------------

void Search::Impl::open() {
    doing = "trying changes";
    trials->open_scene(options.places);
    if (const std::string wrong = trials->scene_error(); !wrong.empty()) return give_up(wrong);
    result.places = trials->places();
    result.searched = std::min(std::max<std::size_t>(options.places.searched, 1), result.places.size());
    for (std::size_t place = result.places.size(); place-- > 0;)
        soon([this, place] {
            // Elsewhere, as at the end of a slider, these pixels are left out, and the report says so.
            if (!over(singles_end) && is_broken(place) && place == 0) give_up(result.broken_words());
        });
    soon([this] {
        Bench& scene = trials->scene();
        if (options.times) clock = scene.choose_clock(trials->variant());
        small();
        scene.warm_up(trials->variant(), clock);
        if (options.times) result.quick_size = trials->quick_size({settings.width, settings.height}, clock);
    });
}

// What is wrong with the scene as it is, is wrong with every change of it.
void Search::Impl::give_up(const std::string& reason) {
    tasks.clear();
    result.refuse_all(reason);
}

// In pictures of the present size.
bool Search::Impl::is_broken(std::size_t place) {
    const NonFinite pixels = non_finite(trials->original(place));
    if (pixels.count > 0 && !result.broken) result.broken = {place, pixels};
    return pixels.count > 0;
}

void Search::Impl::try_places(Trial trial, std::size_t rung, std::size_t to, std::function<void(Attempt&)> then) {
    result.rungs[rung].width = trials->scene().settings().width;
    result.rungs[rung].height = trials->scene().settings().height;
    const auto attempt = std::make_shared<Attempt>(Attempt{std::move(trial), rung, to, std::move(then)});
    soon([this, attempt] { draw_on(attempt); });
}

void Search::Impl::draw_on(const std::shared_ptr<Attempt>& attempt) {
    FoundRung& rung = rung_of(*attempt);
    // Of what is left out, one changed pixel says enough.
    const bool enough = rung.aim == Aim::unused && rung.pixels_changed > 0;
    if (std::string& refused = attempt->trial.refused; !refused.empty()) {
        rung.at.clear();
        rung.outcome = Outcome::refused;
        rung.reason = refused;
    } else if (rung.at.size() < attempt->to && !enough && !stopped()) {
        draw_next(*attempt);
        return soon([this, attempt] { draw_on(attempt); });
    }
    attempt->then(*attempt);
}

void Search::Impl::draw_next(Attempt& attempt) {
    FoundRung& rung = rung_of(attempt);
    const std::size_t place = rung.at.size();
    std::string& refused = attempt.trial.refused;
    const auto picture = trials->picture(attempt.trial, place);
    if (!picture && refused.empty()) refused = "this OpenGL cannot draw it";
    if (picture && is_broken(place) && place == 0) refused = result.broken_words();
    if (!refused.empty()) return;
    // Of what is left out, only the pixels that differ count.
    const bool unused = rung.aim == Aim::unused;
    rung.at.push_back(trials->compare(*picture, place, unused, false));
    rung.pixels_changed += rung.at.back().pixels_changed;
    std::size_t& worst = place < result.searched ? rung.worst_searched : rung.worst_held_out;
    if (place == result.searched || rung.at[worst] < rung.at.back()) worst = place;
}

void Search::Impl::try_rung(std::size_t i, double part, std::function<void()> then) {
    if (skipped(result.rungs[i], part)) return then();
    try_places(trials->open(result.rungs[i].changes), i, result.searched, [this, then](Attempt& tried) {
        FoundRung& rung = rung_of(tried);
        if (rung.outcome == Outcome::refused) return then();
        if (rung.at.size() < result.searched) {
            rung.reason = "the search was stopped";
            rung.at.clear();
            return then();
        }
        rung.outcome = Outcome::tried;
        const bool timed = options.times && rung.aim == Aim::cheaper;
        const auto trial = std::make_shared<Trial>(std::move(tried.trial));
        soon([this, i = tried.rung, trial, then, timed] {
            if (timed) trial->bench->resize(result.quick_size[0], result.quick_size[1]);
            const auto warm = timed ? trial->bench->warm_up(trials->variant(), clock) : std::nullopt;
            soon([this, i, trial, then, warm] {
                FoundRung& done = result.rungs[i];
                if (warm) {
                    const auto quick = trials->quick_ratio(*trial, *warm, clock, [this] { return stopped(); });
                    small();
                    trial->bench->resize(result.search_width, result.search_height);
                    done.quick_ratio = quick.middle;
                    done.saves = done.quicker = quick.middle > 0 && quick.middle < least_saving && quick.high < 1;
                }
                for (const std::size_t place : {std::size_t{0}, done.worst_searched})
                    if (useful(done)) find_flip(*trial, done, place);
                // What compiled once need not compile again, as long as there are few of them.
                if (kept.size() < most_kept && useful(done)) kept.emplace(i, std::move(*trial));
                then();
            });
        });
    });
}

// ---- combinations -------------------------------------------------------------------------------------------

// Cheaper, drawn, with an error that is a number; and it saves time, as far as that is known.
bool Search::Impl::useful(const FoundRung& rung) const {
    return rung.aim == Aim::cheaper && rung.outcome == Outcome::tried && std::isfinite(rmse_of(rung)) &&
           (!options.times || rung.saves);
}

void Search::Impl::begin_combinations() {
    doing = "trying combinations";
    std::vector<Climbs::Single> singles;
    for (std::size_t i = 0; i < result.rungs.size() && options.times; ++i)
        if (const FoundRung& rung = result.rungs[i]; useful(rung))
            singles.push_back({i, flip_of(rung), rung.quick_ratio});
    climbs.emplace(std::move(singles), result.changes, options.places.seed);
}

void Search::Impl::combine() {
    const bool enough = result.rungs.size() >= result.changes.size() + options.combinations;
    if (enough || over(combinations_end)) return;
    auto changes = climbs->next();
    if (!changes) return;
    const std::size_t i = result.rungs.size();
    result.rungs.push_back({.name = rung_name(*changes), .changes = std::move(*changes)});
    try_rung(i, combinations_end, [this, i] {
        FoundRung& rung = result.rungs[i];
        // A change that adds an error and saves nothing more is none to go on with.
        const std::string less = rung_name(climbs->before());
        rung.saves = rung.saves && rung.quick_ratio < least_saving_more * result.find(less)->quick_ratio;
        climbs->tell(useful(rung) ? flip_of(rung) : std::numeric_limits<double>::infinity());
        soon([this] { combine(); });
    });
}

// ---- places that were held out ------------------------------------------------------------------------------

void Search::Impl::begin_hold_out() {
    doing = "places that were held out";
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < result.rungs.size(); ++i)
        if (useful(result.rungs[i])) order.push_back(i);
    if (options.times) order = in_layers(result, std::move(order), most_held_out);
    for (std::size_t i = 0; i < result.changes.size(); ++i)
        if (result.rungs[i].aim == Aim::better && result.rungs[i].outcome == Outcome::tried) order.push_back(i);
    for (auto i = order.rbegin(); i != order.rend(); ++i) soon([this, rung = *i] { hold_out(rung); });
}

void Search::Impl::hold_out(std::size_t i) {
    // Without a few of them, there is nothing to time.
    const double end = !options.times || finalists.size() < few_finalists ? times_end : held_out_end;
    if (over(end)) {
        result.rungs[i].reason = out_of_time();
        return;
    }
    auto known = kept.extract(i);
    Trial trial = known ? std::move(known.mapped()) : trials->open(result.rungs[i].changes);
    try_places(std::move(trial), i, result.places.size(), [this, end](Attempt& drawn) {
        FoundRung& rung = rung_of(drawn);
        if (rung.at.size() < result.places.size()) return;
        rung.held_out = result.places.size() > result.searched;
        const double seen = rung.searched()->own.light.rmse;
        const double unseen = rung.held_out ? rung.unseen()->own.light.rmse : seen;
        rung.only_where_tried =
            rung.aim == Aim::cheaper && seen <= visible_error && !(unseen <= visible_error) && !(unseen <= 2 * seen);
        const auto held = std::make_shared<Attempt>(std::move(drawn));
        soon([this, held] { finalists.emplace(held->rung, std::move(held->trial)); });
        for (const std::size_t place : {rung.worst_place(), std::size_t{0}})
            soon([this, held, place, end] {
                if (!over(end)) find_flip(held->trial, rung_of(*held), place);
            });
    });
}

void Search::Impl::find_flip(Trial& trial, FoundRung& rung, std::size_t place) {
    if (rung.at[place].flip) return;
    if (const auto picture = trials->picture(trial, place))
        rung.at[place].flip = trials->compare(*picture, place, false, true).flip;
}

Search::Search(const Original& original, std::vector<Change> changes, const gl::Caps& caps,
               const BenchSettings& settings, SearchOptions options)
    : impl_(std::make_unique<Impl>(original, std::move(changes), caps, settings, std::move(options))) {}

Search::~Search() = default;
Search::Search(Search&&) noexcept = default;

bool Search::step() { return impl_->step(); }

const FoundResult& Search::result() const { return impl_->result; }

FoundResult Search::take() { return std::move(impl_->result); }

}  // namespace snell::accuracy
