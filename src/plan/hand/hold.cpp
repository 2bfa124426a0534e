#include "src/plan/hand/hold.h"

#include <utility>

namespace snell {

void hold_object(HoldMemory& hold, Index object) {
    hold.object = object;
    if (object != none)
        hold.held = Held::object;
    else if (hold.held == Held::object)
        hold.held = Held::scene;
}

namespace {

// Returns the member of View, or null for the transformation of an object.
Transformation View::*part(Held held) {
    switch (held) {
        case Held::scene:
            return &View::scene;
        case Held::eye:
            return &View::eye;
        case Held::texture:
            return &View::texture;
        case Held::object:
            break;
    }
    return nullptr;
}

}  // namespace

Transformation held(const View& view, const HoldMemory& hold) {
    if (const auto member = part(hold.held)) return view.*member;
    const auto object = view.objects.find(hold.object);
    return object == view.objects.end() ? Transformation{} : object->second;
}

void set_held(View& view, const HoldMemory& hold, const Transformation& transformation) {
    if (const auto member = part(hold.held))
        view.*member = transformation;
    else if (hold.object != none && transformation == Transformation{})
        view.objects.erase(hold.object);
    else if (hold.object != none)
        view.objects[hold.object] = transformation;
}

void reset_view(View& view) {
    View fresh;
    fresh.axes = view.axes;
    fresh.mouse_x = view.mouse_x;
    fresh.mouse_y = view.mouse_y;
    view = std::move(fresh);
}

}  // namespace snell
