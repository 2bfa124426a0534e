#include "src/ui/kit/hold.h"

#include <utility>

namespace snell::ui {

void hold_object(HoldMemory& hold, Index object) {
    hold.object = object;
    if (object != none)
        hold.held = Held::object;
    else if (hold.held == Held::object)
        hold.held = Held::scene;
}

Transformation held(const View& view, const HoldMemory& hold) {
    switch (hold.held) {
        case Held::scene:
            return view.scene;
        case Held::eye:
            return view.eye;
        case Held::texture:
            return view.texture;
        case Held::object:
            break;
    }
    const auto object = view.objects.find(hold.object);
    return object == view.objects.end() ? Transformation{} : object->second;
}

void set_held(View& view, const HoldMemory& hold, const Transformation& transformation) {
    switch (hold.held) {
        case Held::scene:
            view.scene = transformation;
            return;
        case Held::eye:
            view.eye = transformation;
            return;
        case Held::texture:
            view.texture = transformation;
            return;
        case Held::object:
            break;
    }
    if (hold.object == none) return;
    if (transformation == Transformation{})
        view.objects.erase(hold.object);
    else
        view.objects[hold.object] = transformation;
}

void reset_view(View& view) {
    View fresh;
    fresh.axes = view.axes;
    fresh.mouse_x = view.mouse_x;
    fresh.mouse_y = view.mouse_y;
    view = std::move(fresh);
}

}  // namespace snell::ui
