#include "src/app/window/measure/accuracy_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/metrics.h"
#include "src/accuracy/report/report.h"
#include "src/accuracy/timing.h"
#include "src/content/image/image.h"
#include "src/runtime/resources/counters.h"

namespace snell {

namespace {

constexpr int most_rounds = 21;
constexpr double budget = 6;                        // seconds of all rounds, where the fewest are not dearer
constexpr double shortest = 4;                      // milliseconds of a sample: quicker frames are drawn several times
constexpr double errors_part = .3, warm_part = .1;  // of the progress
constexpr std::size_t most_rung_times = 15;

using Standing = ui::AccuracyPoint::Standing;

Standing shown(accuracy::Standing standing) {
    switch (standing) {
        case accuracy::Standing::front:
            return Standing::front;
        case accuracy::Standing::dominated:
            return Standing::dominated;
        case accuracy::Standing::saves_none:
            return Standing::saves_none;
        case accuracy::Standing::unsure:
            return Standing::unsure;
        case accuracy::Standing::unknown:
            break;
    }
    return Standing::visited;
}

// "exact", or all rungs that differ from the chosen ones: "exact, box".
std::string name_of(const Scene& scene, const Rungs& rungs, std::size_t ladder, const Rungs& chosen) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < rungs.size(); ++i)
        if (i == ladder || rungs[i] != chosen[i]) names.emplace_back(scene.ladders[i].rungs[rungs[i]]);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

struct RungCosts::Job {
    std::vector<std::string> names;  // of the ladder's rungs
    std::size_t chosen = 0;          // index into `names`
    std::vector<Rungs> rungs;        // in the order of `names`, and so are the errors
    std::vector<double> errors = {};
    std::string left_out = {};  // what is said of rungs with errors
    std::optional<accuracy::SampleMean> mean = {};
    std::optional<accuracy::Rounds> rounds = {};
    double done = 0;
    double spent = 0;  // seconds of the steps of rounds
    // Of the present step.
    Runtime* runtime = nullptr;
    const Frame* frame = nullptr;

    Controls controls(std::size_t rung) const {
        Controls controls = frame->controls;
        controls.rungs = rungs[rung];
        return controls;
    }
};

RungCosts::RungCosts() = default;
RungCosts::~RungCosts() = default;

void RungCosts::forget() {
    known_.clear();
    job_.reset();
    compared_ = false;
    remark_.clear();
}

void RungCosts::visit(const Rungs& rungs, double error, std::span<const double> times) {
    Known& known = known_[rungs];
    known.error = error;
    if (known.standing != Standing::visited) return;  // of rounds that others took part in: better
    known.times.assign(times.end() - static_cast<std::ptrdiff_t>(std::min(times.size(), most_rung_times)), times.end());
}

void RungCosts::begin(std::size_t ladder, const Scene& scene, const Rungs& chosen) {
    const std::vector<std::string>& names = scene.ladders[ladder].rungs;
    job_ = std::make_unique<Job>(
        Job{.names = names, .chosen = chosen[ladder], .rungs = std::vector<Rungs>(names.size(), chosen)});
    for (std::size_t i = 0; i < names.size(); ++i) job_->rungs[i][ladder] = i;
    remark_.clear();
}

void RungCosts::stop() { job_.reset(); }

double RungCosts::done() const { return job_ ? job_->done : 0; }

bool RungCosts::step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples,
                     const accuracy::FrameClock& clock, bool es) {
    if (!job_) return false;
    Job& job = *job_;
    if (!job.mean) job.mean.emplace(reference.width, reference.height, es);
    if (!job.mean->valid()) {
        stop();
        return true;
    }
    job.runtime = &runtime;
    job.frame = &frame;
    if (job.errors.size() < job.rungs.size()) return error_step(reference, samples, clock);
    if (!job.rounds) begin_rounds(clock);
    const runtime::Stopwatch watch;
    const double before = job.done;
    const bool more = job.rounds->step();
    job.spent += 1e-3 * watch.milliseconds();
    if (!more) conclude(clock.plain());
    return !more || job.done != before;
}

bool RungCosts::error_step(const accuracy::Picture& reference, int samples, const accuracy::FrameClock& clock) {
    Job& job = *job_;
    const Controls controls = job.controls(job.errors.size());
    if (job.mean->samples() == samples) job.mean->restart();
    job.mean->add(
        *job.runtime,
        {.time = job.frame->time, .view = job.frame->view, .controls = controls, .enlarged = job.frame->enlarged},
        clock);
    if (job.mean->samples() < samples) return false;
    if (job.runtime->ladder_problems().has_errors()) {  // it was drawn as another rung
        leave_out(job.errors.size());
        return true;
    }
    job.errors.push_back(accuracy::compare(job.mean->picture(*job.runtime), reference).light.rmse);
    job.done = errors_part * static_cast<double>(job.errors.size()) / static_cast<double>(job.rungs.size());
    return true;
}

void RungCosts::leave_out(std::size_t rung) {
    Job& job = *job_;
    const auto at = static_cast<std::ptrdiff_t>(rung);
    job.left_out += fmt::format("'{}' has errors, and is not measured. ", job.names[rung]);
    known_.erase(job.rungs[rung]);
    job.names.erase(job.names.begin() + at);
    job.rungs.erase(job.rungs.begin() + at);
    if (job.chosen > rung) {
        --job.chosen;
    } else if (job.chosen == rung) {  // there is nothing to compare with
        remark_ = std::move(job.left_out);
        stop();
    }
}

void RungCosts::begin_rounds(const accuracy::FrameClock& clock) {
    Job& job = *job_;
    std::vector<accuracy::Entrant> entrants;
    for (std::size_t i = 0; i < job.rungs.size(); ++i) {
        const auto timed = [&job, i](const auto& by) {
            const Controls controls = job.controls(i);
            const Frame frame{.time = job.frame->time,
                              .view = job.frame->view,
                              .controls = controls,
                              .enlarged = job.frame->enlarged};
            return by([&] { job.runtime->draw(frame, job.mean->surface()); });
        };
        entrants.push_back(
            {[=, &clock](accuracy::ClockKind kind) {
                 return std::optional(timed([&](const auto& draw) { return clock.warm_up(draw, kind); }));
             },
             [=, &clock](double least) { return timed([&](const auto& draw) { return clock.sample(draw, least); }); }});
    }
    job.rounds.emplace(std::move(entrants),
                       accuracy::RoundOptions{.clock = clock.plain(),
                                              .base = job.chosen,
                                              .kept = job.chosen,
                                              .everyone = true,
                                              .rounds = most_rounds,
                                              .at_least = shortest,
                                              .seconds_left = [&job] { return budget - job.spent; },
                                              .report =
                                                  [&job](std::string_view doing, double done) {
                                                      constexpr double warm = errors_part + warm_part;
                                                      job.done = doing == "timing" ? warm + (1 - warm) * done
                                                                                   : errors_part + warm_part * done;
                                                  }});
}

void RungCosts::conclude(accuracy::ClockKind clock) {
    const std::unique_ptr<Job> job = std::move(job_);
    const auto times = [&](const std::vector<accuracy::Times>& rounds) { return accuracy::by_clock(rounds, clock); };
    const accuracy::Control control =
        accuracy::control(times(job->rounds->times(job->chosen)), times(job->rounds->again()));
    std::vector<accuracy::Point> points;
    for (std::size_t i = 0; i < job->errors.size(); ++i)
        points.push_back({job->errors[i], times(job->rounds->times(i))});
    const auto verdicts = accuracy::pareto_front(points, accuracy::costs_of(points, control.noise));
    for (std::size_t i = 0; i < points.size(); ++i) {
        Known& known = known_[job->rungs[i]];
        known = {points[i].error, points[i].times, shown(verdicts[i].standing), {}};
        if (verdicts[i].by < job->names.size()) known.by = job->names[verdicts[i].by];
    }
    compared_ = true;
    remark_ = job->left_out + accuracy::noise_sentence(control);
}

std::vector<ui::AccuracyPoint> RungCosts::points(const Scene& scene, std::size_t ladder, const Rungs& chosen) const {
    std::vector<ui::AccuracyPoint> points;
    for (const auto& [rungs, known] : known_) {
        if (rungs.size() != scene.ladders.size() || ladder >= rungs.size()) continue;
        ui::AccuracyPoint point;
        point.name = name_of(scene, rungs, ladder, chosen);
        Rungs others = rungs;
        others[ladder] = chosen[ladder];
        if (others == chosen) point.rung = rungs[ladder];
        point.chosen = rungs == chosen;
        point.reference = ranges::equal(
            rungs, scene.ladders, {}, [](std::size_t rung) { return rung + 1; },
            [](const Ladder& each) { return each.rungs.size(); });
        point.error = known.error;
        if (!known.times.empty()) {
            const accuracy::Interval interval = accuracy::median_interval(known.times);
            point.milliseconds = interval.middle;
            point.low = interval.low;
            point.high = interval.high;
        }
        point.standing = known.standing;
        point.by = known.by;
        points.push_back(std::move(point));
    }
    return points;
}

namespace {

constexpr std::size_t most_times = 15;

void choose_last(const Scene& scene, Rungs& rungs) {
    for (std::size_t i = 0; i < rungs.size(); ++i) rungs[i] = scene.ladders[i].rungs.size() - 1;
}

}  // namespace

Stand smaller(Stand stand, int divide) {
    stand.width = (stand.width + divide - 1) / divide;
    stand.height = (stand.height + divide - 1) / divide;
    stand.view.mouse_x /= divide;
    stand.view.mouse_y /= divide;
    stand.enlarged *= divide;
    return stand;
}

Stand circumstances(Stand stand) {
    stand.width = stand.height = 0;
    stand.enlarged = 1;
    stand.time = 0;
    stand.view.axes = false;
    stand.view.mouse_x = stand.view.mouse_y = 0;
    return stand;
}

std::string reduced_text(const Stand& stand) {
    if (stand.enlarged == 1) return "";
    return fmt::format("Measured at {} x {}: a picture of full size takes too long.", stand.width, stand.height);
}

Refinement::Refinement(std::string path, const gl::Caps& caps)
    : path_(std::move(path)), caps_(caps), clock_(caps.software) {}

std::size_t Refinement::level(int samples) {
    return static_cast<std::size_t>(ranges::find(levels, samples) - levels.begin());
}

void Refinement::open_reference() {
    reference_.reset();
    note_.clear();
    if (scene_) return;
    if (stale_) {
        note_ = "The files have errors: there is nothing to compare with.";
        return;
    }
    RuntimeOptions options;
    options.previous = &*shown_->runtime;
    reference_ = open_document(path_, caps_, choose_last, nullptr, options, shown_->files->access());
    if (!reference_->runtime || reference_->scene().ladders.size() != shown_->scene().ladders.size())
        note_ = "The scene cannot be read.";
    else if (const Diagnostic* const error = first_error(reference_->diagnostics);
             error && reference_->diagnostics.errors() > shown_->diagnostics.errors())
        note_ = "With the last rung of every ladder: " + error->message;
}

std::string Refinement::note() const {
    return failed_.empty() ? note_ : failed_ + " has errors.";  // short, so that the table below it stays in place
}

void Refinement::follow(Document& shown, bool stale, const std::string& failed, const Stand& stand, Document* scene) {
    const bool another = shown_ != &shown || scene_ != scene || stale != stale_;
    if (!another && stand == stand_ && shown.controls.rungs == controls_.rungs && failed == failed_) return;
    const bool resized = stand.width != stand_.width || stand.height != stand_.height;
    const bool elsewhere = another || stand != stand_;
    if (another || resized || shown.controls.rungs != controls_.rungs) {
        times_.clear();
        cold_ = true;
    }
    shown_ = &shown;
    scene_ = scene;
    stale_ = stale;
    failed_ = failed;
    stand_ = stand;
    controls_ = shown.controls;
    if (another) open_reference();
    if (resized || !means_) means_ = std::make_unique<Means>(stand.width, stand.height, caps_.es);
    if (note_.empty() && !(means_->chosen.valid() && means_->reference.valid()))
        note_ = "There is not enough memory for pictures in floats.";
    means_->chosen.restart();
    samples_ = 0;
    ++revision_;
    costs_.stop();
    if (!elsewhere) return;
    means_->reference.restart();
    reference_samples_ = 0;
    costs_.forget();
}

bool Refinement::busy() const {
    if (!means_ || !means_->chosen.valid()) return false;
    return means_->chosen.samples() < levels.back() ||
           (comparable() && (reference_samples_ < levels.back() || costs_.measuring()));
}

bool Refinement::step() {
    if (!busy()) return false;
    const bool behind = means_->reference.samples() <= means_->chosen.samples();
    const bool more = means_->reference.samples() < levels.back();
    const bool other = comparable() && more && behind;
    const runtime::Stopwatch watch;
    const bool new_facts = other                                      ? reference_step()
                           : means_->chosen.samples() < levels.back() ? chosen_step()
                                                                      : cost_step();
    if (other) lasts_ = watch.milliseconds() * stand_.enlarged * stand_.enlarged;
    if (new_facts) ++revision_;
    return new_facts;
}

bool Refinement::reference_step() {
    Document& reference = reference_document();
    Controls last = scene_ ? scene_->controls : controls_;
    if (!scene_) last.rungs = reference.runtime->rungs();
    if (!scene_) choose_last(reference.scene(), last.rungs);
    const View view = without_axes();
    means_->reference.add(*reference.runtime,
                          {.time = stand_.time, .view = view, .controls = last, .enlarged = stand_.enlarged}, clock_);
    const std::size_t reached = level(means_->reference.samples());
    if (reached == levels.size()) return false;
    references_[reached] = means_->reference.picture(*reference.runtime);
    reference_samples_ = levels[reached];
    return false;  // until there is something to compare with it
}

bool Refinement::chosen_step() {
    const View view = without_axes();
    const accuracy::Times took = means_->chosen.add(
        *shown_->runtime, {.time = stand_.time, .view = view, .controls = controls_, .enlarged = stand_.enlarged},
        clock_);
    if (!std::exchange(cold_, false)) {
        if (times_.size() == most_times) times_.erase(times_.begin());
        times_.push_back(chosen(took, clock_.plain()));
    }
    const std::size_t reached = level(means_->chosen.samples());
    if (reached == levels.size()) return false;
    if (!comparable()) return true;
    chosen_ = means_->chosen.picture(*shown_->runtime);
    samples_ = levels[reached];
    error_ = accuracy::compare(chosen_, references_[reached]);
    costs_.visit(controls_.rungs, error_.light.rmse, times_);
    return true;
}

bool Refinement::cost_step() {
    const View view = without_axes();
    return costs_.step(*reference_->runtime,
                       {.time = stand_.time, .view = view, .controls = controls_, .enlarged = stand_.enlarged},
                       references_.back(), levels.back(), clock_, caps_.es);
}

void Refinement::measure(std::size_t ladder) {
    if (costs_.measuring() || !comparable() || !shown_)
        costs_.stop();
    else
        costs_.begin(ladder, shown_->scene(), controls_.rungs);
    ++revision_;
}

View Refinement::without_axes() const {
    View view = stand_.view;
    view.axes = false;
    return view;
}

const accuracy::Picture* Refinement::reference() const {
    return samples_ > 0 ? &references_[level(reference_samples_)] : nullptr;
}

namespace {

double difference_of(std::span<const float> a, std::span<const float> b) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        if (a[c] == b[c]) continue;
        const double difference =
            content::light_of_srgb(static_cast<double>(a[c])) - content::light_of_srgb(static_cast<double>(b[c]));
        sum += difference * difference;
    }
    return std::sqrt(sum / 3);
}

}  // namespace

std::vector<float> Refinement::differences() const {
    std::vector<float> differences;
    if (samples_ == 0) return differences;
    const std::span<const float> a = chosen_.rgba, b = references_[level(samples_)].rgba;
    differences.reserve(a.size() / 4);
    for (std::size_t i = 0; i + 3 < a.size(); i += 4)
        differences.push_back(static_cast<float>(difference_of(a.subspan(i, 3), b.subspan(i, 3))));
    return differences;
}

std::optional<double> Refinement::difference(int x, int y) const {
    x /= stand_.enlarged;
    y /= stand_.enlarged;
    if (samples_ == 0 || x < 0 || y < 0 || x >= chosen_.width || y >= chosen_.height) return std::nullopt;
    const std::size_t i =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(chosen_.width) + static_cast<std::size_t>(x));
    const std::span<const float> a = chosen_.rgba, b = references_[level(samples_)].rgba;
    return difference_of(a.subspan(i, 3), b.subspan(i, 3));
}

ui::AccuracyFacts Refinement::facts(std::size_t ladder) const {
    ui::AccuracyFacts facts;
    facts.note = note();
    facts.reduced = reduced_text(stand_);
    facts.of_scene = scene_ != nullptr;
    facts.samples = samples_;
    facts.wanted = levels.back();
    facts.clock = accuracy::name(clock_.plain());
    facts.error = error_.light.rmse;
    facts.psnr = accuracy::decibels(error_.light.psnr, 1);
    facts.largest = error_.light.max;
    facts.of_display = error_.display.rmse;
    facts.nonfinite = error_.nonfinite;
    if (shown_ && ladder < shown_->scene().ladders.size())
        facts.points = costs_.points(shown_->scene(), ladder, controls_.rungs);
    if (costs_.measuring()) facts.measured = costs_.done();
    facts.remark = costs_.remark();
    return facts;
}

namespace {

using Show = ui::AccuracyMemory::Show;

std::byte byte_of(float value) {
    return static_cast<std::byte>(std::lround(255 * (value >= 0 ? std::min(value, 1.0F) : 0.0F)));
}

std::vector<std::byte> heat_of(const std::vector<float>& differences) {
    std::vector<std::byte> bytes;
    bytes.reserve(differences.size() * 4);
    for (const float difference : differences) {
        const double power = difference > 0 ? std::log10(difference) : ui::coldest;
        const auto [red, green, blue] = std::isfinite(difference)
                                            ? content::heat((power - ui::coldest) / (ui::hottest - ui::coldest))
                                            : ui::no_number;
        bytes.insert(bytes.end(), {byte_of(red), byte_of(green), byte_of(blue), std::byte{255}});
    }
    return bytes;
}

}  // namespace

void AccuracyView::follow(Document& scene, bool stale, const std::string& failed, const Stand& stand,
                          const ui::AccuracyMemory& memory, const Pair& pair) {
    const bool wanted = (memory.open || memory.show == Show::heat) && stand.width > 0;
    const bool ladders = wanted && !scene.scene().ladders.empty();
    if (!ladders) refinement_.reset();
    if (!wanted || !pair.left || showing_ != pair.showing) beside_.reset();
    showing_ = pair.showing;
    if (!wanted || (!ladders && !pair.left)) {
        still_ = {};
        uploaded_ = 0;
        return;
    }
    if (ladders && !refinement_) refinement_ = std::make_unique<Refinement>(path_, caps_);
    if (pair.left && !beside_) beside_ = std::make_unique<Refinement>(path_, caps_);
    if (pair.left)
        beside_->follow(*pair.left, false, pair.left == &scene || pair.right == &scene ? failed : "", stand,
                        pair.right);
    else
        refinement_->follow(scene, stale, failed, stand);
    if (memory.show != Show::heat) return;
    while (!now()->reference() && now()->busy() && now()->comparable()) now()->step();
}

void AccuracyView::leave() {
    beside_.reset();
    if (refinement_) refinement_->leave();
}

void AccuracyView::measure(const ui::AccuracyMemory& memory) {
    if (refinement_) refinement_->measure(memory.ladder);
}

const ui::AccuracyFacts* AccuracyView::facts(const ui::AccuracyMemory& memory) {
    if (!now()) return nullptr;
    facts_ = now()->facts(memory.ladder);
    if (const std::uint64_t now_at = revision(memory); now_at != compared_) {
        compared_ = now_at;
        unknown_ = now_at != 0 &&
                   ranges::any_of(now()->differences(), [](float difference) { return !std::isfinite(difference); });
    }
    facts_.unknown = unknown_;
    if (beside_ && refinement_) facts_.points = refinement_->facts(memory.ladder).points;
    return &facts_;
}

std::uint64_t AccuracyView::revision(const ui::AccuracyMemory& memory) const {
    if (!now() || memory.show != Show::heat) return 0;
    return 4 * now()->revision() + (beside_ ? std::uint64_t{1} << 62U : 0) + static_cast<std::uint64_t>(memory.show);
}

std::optional<double> AccuracyView::difference(int x, int y, const ui::AccuracyMemory& memory) const {
    return now() && memory.show == Show::heat ? now()->difference(x, y) : std::nullopt;
}

void AccuracyView::show(int y, const ui::AccuracyMemory& memory) {
    const accuracy::Picture* reference = now() ? now()->reference() : nullptr;
    if (!reference || memory.show != Show::heat) return;
    if (uploaded_ != revision(memory)) {
        uploaded_ = revision(memory);
        still_.set(reference->width, reference->height, heat_of(now()->differences()));
    }
    still_.show(0, y, now()->enlarged());
}

}  // namespace snell
