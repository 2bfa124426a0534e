// The window's side of objects that are picked and moved: nothing at all until one is.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "src/app/document.h"
#include "src/app/refine.h"
#include "src/ui/state.h"

namespace snell {

class Picking {
public:
    // Before the panels see the view. After another reading of the scene the objects are other numbers, or gone.
    void follow(Document& shown, std::uint64_t revision, View& view, ui::HoldMemory& hold);
    // What is at the click, in the picture that `stand` tells of; `density`: pixels for one window coordinate.
    void serve(const ui::Requests& requests, Document& shown, const Stand& stand, float density, ui::HoldMemory& hold);
    void tell(ui::Facts& facts, const Document* shown, const ui::HoldMemory& hold);

private:
    std::uint64_t revision_ = 0;
    std::vector<std::string> names_;  // of the objects, by Scene::draws; empty: none was ever held
    std::string told_;
    std::pair<std::uint64_t, Index> told_of_{0, none};  // the revision and the object
};

// The statement, and where it is.
std::string object_text(const Document& document, Index object);

}  // namespace snell
