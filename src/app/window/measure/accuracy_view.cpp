#include "src/app/window/measure/accuracy_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "parser/text/ranges.h"
#include "src/content/image/reduced.h"

namespace snell {

namespace {

using Show = ui::AccuracyMemory::Show;

std::byte byte_of(float value) {
    return static_cast<std::byte>(std::lround(255 * (value >= 0 ? std::min(value, 1.0F) : 0.0F)));
}

// As the screen shows it.
std::vector<std::byte> bytes_of(const accuracy::Picture& picture) {
    std::vector<std::byte> bytes(picture.rgba.size());
    ranges::transform(picture.rgba, bytes.begin(), byte_of);
    return bytes;
}

std::vector<std::byte> heat_of(const std::vector<float>& differences) {
    std::vector<std::byte> bytes;
    bytes.reserve(differences.size() * 4);
    for (const float difference : differences) {
        const double power = difference > 0 ? std::log10(difference) : difference == 0 ? ui::coldest : NAN;
        const auto [red, green, blue] = content::heat((power - ui::coldest) / (ui::hottest - ui::coldest));
        bytes.insert(bytes.end(), {byte_of(red), byte_of(green), byte_of(blue), std::byte{255}});
    }
    return bytes;
}

}  // namespace

void AccuracyView::follow(Document& scene, bool stale, const Stand& stand, const ui::AccuracyMemory& memory,
                          Document* rung) {
    const bool wanted = memory.open && stand.width > 0, ladders = wanted && !scene.scene().ladders.empty();
    if (!ladders) refinement_.reset();
    if (!wanted || !rung) beside_.reset();
    if (!wanted || (!ladders && !rung)) {
        still_ = {};
        uploaded_ = 0;
        return;
    }
    if (ladders && !refinement_) refinement_ = std::make_unique<Refinement>(path_, caps_);
    if (rung && !beside_) beside_ = std::make_unique<Refinement>(path_, caps_);
    if (rung)
        beside_->follow(*rung, false, stand, &scene);
    else
        refinement_->follow(scene, stale, stand);
    if (memory.show == Show::picture) return;
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
    if (beside_ && refinement_) facts_.points = refinement_->facts(memory.ladder).points;
    return &facts_;
}

std::uint64_t AccuracyView::revision(const ui::AccuracyMemory& memory) const {
    if (!now() || memory.show == Show::picture) return 0;
    return 4 * now()->revision() + (beside_ ? std::uint64_t{1} << 62U : 0) + static_cast<std::uint64_t>(memory.show);
}

void AccuracyView::show(int y, const ui::AccuracyMemory& memory) {
    const accuracy::Picture* reference = now() ? now()->reference() : nullptr;
    if (!reference || memory.show == Show::picture) return;
    if (uploaded_ != revision(memory)) {
        uploaded_ = revision(memory);
        still_.set(reference->width, reference->height,
                   memory.show == Show::split ? bytes_of(*reference) : heat_of(now()->differences()));
    }
    const double left = memory.show == Show::split ? memory.divider * reference->width : 0;
    still_.show(0, y, static_cast<int>(std::lround(left)));
}

}  // namespace snell
