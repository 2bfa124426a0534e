#include "src/app/window/measuring.h"

namespace snell {

Measuring::Measuring(const std::string& scene, const gl::Caps& caps)
    : caps_(caps), accuracy_(scene, caps), found_(scene, caps), frame_costs_(caps), textures_(caps.es) {}

void Measuring::begin_scene(const std::string& scene) {
    accuracy_ = AccuracyView(scene, caps_);
    found_ = FoundView(scene, caps_);
    explained_ = {};
}

void Measuring::leave() {
    accuracy_.leave();
    found_.leave();
}

bool Measuring::follow(Document& scene, bool stale, const Display& display, bool still, const ui::Memory& memory) {
    const Stand& stand = display.drawn().stand;
    const bool found = found_.follow(scene, stale, stand, still, memory.accuracy);
    accuracy_.follow(scene, stale, stand, memory.accuracy, found_.rung());
    Document& document = found_.shown(scene);
    const bool opened = frame_costs_.open(memory.frame_cost, display.drawn().revision, display.counters().frame_ms);
    if (memory.scene.width <= 0) return opened || found;
    const float density = static_cast<float>(stand.width) / memory.scene.width;
    const bool texels =
        textures_.follow(document, display.drawn().revision, display.counters().frames, memory, density);
    return pixels_.follow(document, stand, display.counters().frames, memory.pixels, density) || opened || texels ||
           found;
}

bool Measuring::step(Document* document, const Display& display, const std::function<void()>& alive) {
    linking_ = linking_ && document;
    if (linking_) {
        linking_ = document->runtime->find_switched_off();
        if (!linking_) explanation_ = document->runtime->explain();
        return !linking_;
    }
    if (frame_costs_.busy())
        return document && frame_costs_.step(found_.shown(*document), display.drawn().stand, display.samples());
    return accuracy_.busy() ? accuracy_.step() : found_.step(alive);
}

std::string Measuring::serve(const ui::Requests& requests, Document* document, const Display& display,
                             ui::Memory& memory) {
    if (requests.measure) accuracy_.measure(memory.accuracy);
    if (requests.measure_frame) frame_costs_.measure();
    if (requests.find_rungs || requests.show_rung) accuracy_.leave_rung();
    if (document) found_.serve(requests, *document, display.drawn().stand, memory);
    return requests.copy_rung ? found_.command() : "";
}

void Measuring::tell(ui::Facts& facts, const Document* document, const ui::Memory& memory) {
    facts.accuracy = accuracy_.facts(memory.accuracy);
    facts.found = document && memory.accuracy.open ? found_.facts() : nullptr;
    facts.frame_cost = frame_costs_.facts(document);
    facts.pixels = pixels_.facts();
    facts.textures = textures_.facts();
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
    accuracy_.show(y, memory.accuracy);
    pixels_.show(y);
}

}  // namespace snell
