#include "src/app/window/picking.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "src/app/open/complain.h"
#include "src/plan/objects.h"

namespace snell {

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
