#include "src/app/window/measure/refine.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "parser/text/ranges.h"

namespace snell {

namespace {

constexpr std::size_t most_times = 15;

void choose_last(const Scene& scene, Rungs& rungs) {
    for (std::size_t i = 0; i < rungs.size(); ++i) rungs[i] = scene.ladders[i].rungs.size() - 1;
}

std::string first_error(const Diagnostics& diagnostics) {
    const auto error = ranges::find(diagnostics.items(), Severity::error, &Diagnostic::severity);
    return error == diagnostics.items().end() ? std::string() : error->message;
}

}  // namespace

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
    else if (reference_->diagnostics.errors() > shown_->diagnostics.errors())
        note_ = "With the last rung of every ladder: " + first_error(reference_->diagnostics);
}

void Refinement::follow(Document& shown, bool stale, const Stand& stand, Document* scene) {
    const bool another = shown_ != &shown || scene_ != scene || stale != stale_;
    if (!another && stand == stand_ && shown.controls.rungs == controls_.rungs) return;
    const bool resized = stand.width != stand_.width || stand.height != stand_.height;
    const bool elsewhere = another || stand != stand_;
    if (another || resized || shown.controls.rungs != controls_.rungs) {
        times_.clear();
        cold_ = true;
    }
    shown_ = &shown;
    scene_ = scene;
    stale_ = stale;
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
           (note_.empty() && (reference_samples_ < levels.back() || costs_.measuring()));
}

bool Refinement::step() {
    if (!busy()) return false;
    const bool behind = means_->reference.samples() <= means_->chosen.samples();
    const bool more = means_->reference.samples() < levels.back();
    const bool new_facts = note_.empty() && more && behind            ? reference_step()
                           : means_->chosen.samples() < levels.back() ? chosen_step()
                                                                      : cost_step();
    if (new_facts) ++revision_;
    return new_facts;
}

bool Refinement::reference_step() {
    Document& reference = reference_document();
    Controls last = controls_;
    last.rungs = scene_ ? scene_->controls.rungs : reference.runtime->rungs();
    if (!scene_) choose_last(reference.scene(), last.rungs);
    const View view = without_axes();
    means_->reference.add(*reference.runtime, {.time = stand_.time, .view = view, .controls = last}, clock_);
    const std::size_t reached = level(means_->reference.samples());
    if (reached == levels.size()) return false;
    references_[reached] = means_->reference.picture(*reference.runtime);
    reference_samples_ = levels[reached];
    return false;  // until there is something to compare with it
}

bool Refinement::chosen_step() {
    const View view = without_axes();
    const accuracy::Times took =
        means_->chosen.add(*shown_->runtime, {.time = stand_.time, .view = view, .controls = controls_}, clock_);
    if (!std::exchange(cold_, false)) {
        if (times_.size() == most_times) times_.erase(times_.begin());
        times_.push_back(chosen(took, clock_.plain()));
    }
    const std::size_t reached = level(means_->chosen.samples());
    if (reached == levels.size()) return false;
    if (!note_.empty()) return true;
    chosen_ = means_->chosen.picture(*shown_->runtime);
    samples_ = levels[reached];
    error_ = accuracy::compare(chosen_, references_[reached]);
    costs_.visit(controls_.rungs, error_.light.rmse, times_);
    return true;
}

bool Refinement::cost_step() {
    const View view = without_axes();
    return costs_.step(*reference_->runtime, {.time = stand_.time, .view = view, .controls = controls_},
                       references_.back(), levels.back(), clock_, caps_.es);
}

void Refinement::measure(std::size_t ladder) {
    if (costs_.measuring() || !note_.empty() || !shown_)
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

std::vector<float> Refinement::differences() const {
    std::vector<float> differences;
    if (samples_ == 0) return differences;
    const std::vector<float>& a = chosen_.rgba;
    const std::vector<float>& b = references_[level(samples_)].rgba;
    for (std::size_t i = 0; i + 3 < a.size(); i += 4) {
        const float red = a[i] - b[i], green = a[i + 1] - b[i + 1], blue = a[i + 2] - b[i + 2];
        differences.push_back(std::sqrt((red * red + green * green + blue * blue) / 3));
    }
    return differences;
}

ui::AccuracyFacts Refinement::facts(std::size_t ladder) const {
    ui::AccuracyFacts facts;
    facts.note = note_;
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

}  // namespace snell
