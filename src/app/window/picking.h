// Picks and moves objects in the window. It does nothing until the first object is picked.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "src/app/window/measure/refine.h"
#include "src/document/document.h"
#include "src/ui/panels/state.h"

namespace snell {

class Picking {
public:
    // Call it before the panels use the view. After the scene was read again, it updates the indices of the objects and
    // drops those that are gone.
    void follow(Document& shown, std::uint64_t revision, View& view, HoldMemory& hold);
    // Picks the object at the click, in the picture that `stand` describes; `density` is pixels per window coordinate.
    void serve(const ui::Requests& requests, Document& shown, const Stand& stand, float density, HoldMemory& hold);
    // Fills in the text about the picked object.
    void tell(ui::Facts& facts, const Document* shown, const HoldMemory& hold);

private:
    std::uint64_t revision_ = 0;
    // Names of the objects, in the order of Scene::draws; empty if none was picked yet.
    std::vector<std::string> names_;
    std::string told_;
    std::pair<std::uint64_t, Index> told_of_{0, none};  // the revision and the object that told_ describes
};

}  // namespace snell
