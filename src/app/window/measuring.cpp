#include "src/app/window/measuring.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parser/text/ranges.h"

namespace snell {

Measuring::Measuring(const std::string& scene, const gl::Caps& caps)
    : caps_(caps), accuracy_(scene, caps), found_(scene, caps), states_(caps), frame_costs_(caps), textures_(caps.es) {}

void Measuring::begin_scene(const std::string& scene) {
    accuracy_ = AccuracyView(scene, caps_);
    found_ = FoundView(scene, caps_);
    states_ = StatesView(caps_);
    explained_ = {};
}

void Measuring::leave(ui::AccuracyMemory& memory) {
    accuracy_.leave();
    found_.leave();
    follow_rung(memory);
}

// What a rung was compared with the scene by ends with it, or else two states would be shown that nobody asked for.
void Measuring::follow_rung(ui::AccuracyMemory& memory) {
    using Show = ui::AccuracyMemory::Show;
    const bool before = std::exchange(of_rung_, found_.rung() != nullptr);
    if (!before) alone_ = memory.show == Show::picture;
    if (before && !of_rung_ && alone_) memory.show = Show::picture;
}

// What it takes is known roughly only, and a picture of another size is measured from the beginning. Rungs that were
// measured at a size have shown how long it takes, so another rung or a second state changes nothing about it.
const Stand& Measuring::measured(const Display& display) {
    constexpr int smallest = 16;  // a divisor
    const bool sharp = display.drawn().grain == 0 && display.sharp_share() == 0;
    double lasts = display.lasts() > 0 && sharp ? display.counters().frame_ms : display.lasts();
    // The reference may take longer than the picture. What was reduced for it stays so if it takes a little less.
    if (accuracy_.lasts() > Coarseness::patience / (measured_.enlarged > 1 ? 4 : 1))
        lasts = std::max(lasts, accuracy_.lasts());
    int divide = lasts > 0 ? std::max(measured_.enlarged, 1) : 1;
    while (divide < smallest && lasts / divide / divide > 2 * Strips::aim) divide *= 2;
    while (divide > 1 && lasts / divide / divide < Strips::aim / 2) divide /= 2;
    const Stand& stand = display.drawn().stand;
    if (const int kept = accuracy_.kept_size(stand); kept > 0) divide = kept;
    measured_ = smaller(stand, divide);
    samples_ = display.samples();
    return measured_;
}

bool Measuring::watches(const Document& scene, const Display& display, const ui::Memory& memory, double now) const {
    return watch_.due(now) && display.drawn().grain == 0 && !memory.pixels.flags && !heat(memory) &&
           !scene.diagnostics.has_errors();
}

void Measuring::look_for_nan(Document& scene, const Display& display) {
    std::vector<Document*> halves{half(scene, false)};
    if (beside(scene)) halves.push_back(half(scene, true));
    watch_.look(halves, display.drawn().stand, display.counters().frame_ms);
}

Document* Measuring::half(Document& scene, bool right) {
    if (!found_.rung() && !states_.shows(right)) return nullptr;
    return right ? beside(scene) : &shown(scene);
}

bool Measuring::follow(Document& scene, const Session& session, const Display& display, bool still,
                       const ui::Memory& memory, double now) {
    const Stand& stand = display.drawn().stand;
    Drawn lasting{.revision = display.drawn().revision, .stand = circumstances(stand)};
    if (still) lasting.stand.time = stand.time;
    lasting.rungs = display.drawn().rungs;
    lasting.showing = display.drawn().showing;
    watch_.follow(lasting, now);
    // Of a scene that never was without errors, the picture is incomplete.
    const bool stale = session.stale() || scene.diagnostics.has_errors();
    const std::string& failed = session.failed_rungs();
    const Stand& measure = measured(display);
    const bool found = found_.follow(scene, stale || !failed.empty(), stand, still, memory.accuracy);
    AccuracyView::Pair pair;
    if (found_.rung() || (states_.active() && comparable() && !states_.with_reference()))
        pair = {&shown(scene), found_.rung() ? &scene : &states_.right(scene), showing()};
    accuracy_.follow(scene, stale, failed, measure, memory.accuracy, pair);
    Document& document = shown(scene);
    const bool sharp = display.drawn().grain == 0;
    const bool opened =
        frame_costs_.open(memory.frame_cost, display.drawn().revision, sharp ? display.counters().frame_ms : 0);
    const bool nan = watch_.tell(divider(watch_.width(), memory.accuracy), heat(memory));
    if (memory.scene.width <= 0) return opened || found || nan;
    const float density = static_cast<float>(stand.width) / memory.scene.width;
    const bool texels =
        textures_.follow(document, display.drawn().revision, display.counters().frames, memory, density);
    PixelView::Sight sight{
        .heat = heat(memory), .stand = stand, .picture = display.counters().frames, .density = density};
    sight.lasts = display.lasts();
    sight.sharp = sharp && display.sharp_share() == 0;
    const std::optional<int> column = divider(stand.width, memory.accuracy);
    const auto add = [&](bool right, const std::string& rung) {
        const std::string name = !found_.rung() ? states_.text(right) : rung;
        sight.halves.push_back({half(scene, right), column || sight.heat ? (right ? "right: " : "left: ") + name : ""});
    };
    add(false, found_text());
    if (column) add(true, "the scene as it is");
    sight.divider = column.value_or(0);
    bool pixels = pixels_.follow(sight, memory.pixels);
    const Inspection* const inspected = sight.heat && comparable() ? pixels_.inspection() : nullptr;
    pixels |= pixels_.set_difference(inspected ? accuracy_.difference(inspected->x, inspected->y, memory.accuracy)
                                               : std::nullopt);
    return pixels || opened || texels || found || nan;
}

bool Measuring::step(Document* document, const std::function<void()>& alive) {
    linking_ = linking_ && document;
    if (linking_) {
        linking_ = document->runtime->find_switched_off();
        if (!linking_) explanation_ = document->runtime->explain();
        return !linking_;
    }
    if (frame_costs_.busy()) return document && frame_costs_.step(shown(*document), measured_, samples_);
    return accuracy_.busy() ? accuracy_.step() : found_.step(alive);
}

std::string Measuring::serve(const ui::Requests& requests, Document* document, ui::Memory& memory) {
    if (requests.measure) accuracy_.measure(memory.accuracy);
    if (requests.measure_frame) frame_costs_.measure();
    if (requests.store_snapshot > 0 || requests.delete_snapshot > 0) states_.reread_snapshots();
    if (requests.find_rungs || requests.show_rung) accuracy_.leave_pair();
    if (document) found_.serve(requests, *document, measured_, memory);
    follow_rung(memory.accuracy);
    return requests.copy_rung ? found_.command() : "";
}

// What is on the left in place of a state; empty if nothing is.
std::string Measuring::found_text() const { return found_.rung() ? ui::found_text(*found_.facts()) : ""; }

std::optional<int> Measuring::divider(int width, const ui::AccuracyMemory& memory) const {
    if (!states_.active() || memory.show != ui::AccuracyMemory::Show::split) return std::nullopt;
    return std::clamp(static_cast<int>(std::lround(memory.divider * static_cast<float>(width))), 1, std::max(width, 1));
}

void Measuring::tell(ui::Facts& facts, Document* document, const Session& session, const ui::Memory& memory) {
    std::string stale;
    if (session.stale() || !session.failed_rungs().empty()) {
        const auto error = ranges::find(session.problems(), Severity::error,
                                        [](const ui::Problem& problem) { return problem.finding.severity; });
        stale = error != session.problems().end() ? error->finding.message : "the files have changed";
    }
    facts.states =
        document ? states_.facts(*document, session.earlier(), facts.snapshots, stale, found_text()) : nullptr;
    facts.accuracy = accuracy_.facts(memory.accuracy);
    facts.found = document && memory.accuracy.open ? found_.facts() : nullptr;
    facts.frame_cost = frame_costs_.facts(document, measured_);
    facts.pixels = pixels_.facts();
    facts.textures = textures_.facts();
    facts.nan = memory.pixels.flags ? std::string_view() : watch_.text();
    facts.nan_looks = watch_.looks();
}

void Measuring::explain(ui::Facts& facts, const Document& document, const ui::Memory& memory) {
    if (!memory.costs) {
        explained_ = {};
        linking_ = false;
        return;
    }
    const std::pair now{facts.revision, document.runtime->form()};
    if (explained_ != now) {
        explanation_ = document.runtime->explain();
        linking_ = document.runtime->form() != 0;
    }
    explained_ = now;
    frame_costs_.fill(explanation_);
    facts.explanation = &explanation_;
    facts.sources = &document.sources;
}

bool Measuring::outdated(const Document& document) const {
    return explained_.first != 0 && explained_.second != document.runtime->form();
}

void Measuring::show(int y, const ui::Memory& memory) {
    if (comparable()) accuracy_.show(y, memory.accuracy);
    pixels_.show(y, divider(pixels_.width(), memory.accuracy));
}

}  // namespace snell
