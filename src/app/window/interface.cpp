#include "src/app/window/interface.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "src/app/desktop/settings.h"
#include "src/plan/locate.h"
#include "src/plan/view.h"
#include "src/ui/shell.h"

namespace snell {

Interface::Interface(Window& window, bool listening) : window_(window), gui_(&window), layout_(listening) {
    view_.axes = true;  // for a window that loses its context before a scene could be read
}

void Interface::begin_scene(const std::string& scene, bool same) {
    ui::Memory fresh;
    if (same) fresh.clock = memory_.clock;
    carry_looks(memory_, fresh);
    fresh.failures = std::move(memory_.failures);
    fresh.failures.enter(whole_path(scene));
    memory_ = std::move(fresh);
    view_ = {};
}

void Interface::start() { framed_ = ticked_ = window_.now(); }

float Interface::density() const {
    const int width = window_.size().width;
    return width > 0 ? static_cast<float>(window_.framebuffer().width) / static_cast<float>(width) : 1.0F;
}

void Interface::begin(double seconds, std::span<const Event> events) {
    const PixelSize size = window_.size();
    const ui::Screen screen{
        static_cast<float>(size.width), static_cast<float>(size.height), density(),
        ui::fitting_scale(window_.content_scale() / density() * memory_.zoom, static_cast<float>(size.width)),
        memory_.theme};
    if (gui_.input(screen, seconds, events)) painter_.upload_fonts();
    gui_.begin();
}

ui::Requests Interface::frame(std::span<const Event> events, const ui::Facts& facts, Controls& controls) {
    const double now = window_.now();
    begin(now - std::exchange(framed_, now), events);
    ui::Requests requests = ui::shell(facts, controls, view_, memory_, gui_.fonts(), layout_);
    picture_ = gui_.end();
    window_.set_cursor(gui_.cursor());
    for (const Event& event : events)
        if (event.down && event.kind != Event::Kind::focus) memory_.notice.clear();
    return requests;
}

void Interface::loading(const LoadProgress& progress) {
    begin(0, {});
    ui::loading(words(progress), share(progress));
    gui_.end();
}

double Interface::time(bool stopped) {
    const double now = window_.now();
    ui::Clock& clock = memory_.clock;
    // While it stands nobody may call this, so that what passed until it goes on is not known, and not added.
    const bool stands = held() || clock.paused || stopped;
    if (!std::exchange(stood_, stands) && !stands) clock.time += (now - ticked_) * clock.speed;
    ticked_ = now;
    return clock.time;
}

namespace {

// Returns the object's statement and its place in the text.
std::string object_text(const Document& document, Index object) {
    if (object >= document.scene().draws.size()) return {};
    const Span span = document.scene().draws[object].span;
    return fmt::format("{}, {}", statement_text(span, document.sources), statement_place(span, document.sources));
}

}  // namespace

void Picking::follow(Document& shown, std::uint64_t revision, View& view, HoldMemory& hold) {
    if (revision != revision_ && !names_.empty()) {
        std::vector<std::string> names = object_names(shown.scene());
        carry_objects(names_, names, view);
        if (hold.object != none) hold_object(hold, carried(names_, names, hold.object));
        names_ = std::move(names);
    }
    revision_ = revision;
    if (names_.empty() && (hold.picking || !view.objects.empty())) names_ = object_names(shown.scene());
}

void Picking::serve(const ui::Requests& requests, Document& shown, const Stand& stand, float density,
                    HoldMemory& hold) {
    if (!requests.pick) return;
    const auto pixel = [density](double at) { return static_cast<int>(std::floor(at * static_cast<double>(density))); };
    const int x = pixel(requests.pick->x), y = stand.height - 1 - pixel(requests.pick->y);
    Frame frame{stand.time, stand.view, shown.controls, true};
    frame.standing = true;
    const std::vector<Index> there = shown.runtime->pick(frame, stand.width, stand.height, {x, y, 1, 1});
    hold_object(hold, there.empty() ? none : there.front());
}

void Picking::tell(ui::Facts& facts, const Document* shown, const HoldMemory& hold) {
    if (!shown || hold.object == none) return;
    if (told_of_ != std::pair(revision_, hold.object)) told_ = object_text(*shown, hold.object);
    told_of_ = {revision_, hold.object};
    facts.object = told_;
}

}  // namespace snell
