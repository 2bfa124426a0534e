// The accuracy panel's side of the window: nothing at all while the panel is closed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "src/app/refine.h"
#include "src/gl/still.h"
#include "src/ui/accuracy.h"

namespace snell {

class AccuracyView {
public:
    // Needs the GL context of `caps` to be current, for all of its life.
    AccuracyView(std::string path, const gl::Caps& caps) : path_(std::move(path)), caps_(caps) {}

    // After the picture was drawn, or was found to stand; see Refinement::follow. What is shown beside the picture is
    // of the same moment.
    void follow(Document& shown, bool stale, const Stand& stand, const ui::AccuracyMemory& memory);
    bool busy() const { return refinement_ && refinement_->busy(); }
    // True: the panel or the picture changed.
    bool step() { return refinement_ && refinement_->step(); }
    void measure(const ui::AccuracyMemory& memory);
    // Null while closed. Stands until the next call.
    const ui::AccuracyFacts* facts(const ui::AccuracyMemory& memory);
    // Over the window's picture, whose bottom left is at pixel (0, y).
    void show(int y, const ui::AccuracyMemory& memory);
    // Changes when show() would show something else.
    std::uint64_t revision(const ui::AccuracyMemory& memory) const;

private:
    std::string path_;
    gl::Caps caps_;
    std::unique_ptr<Refinement> refinement_;
    ui::AccuracyFacts facts_;
    gl::Still still_;
    std::uint64_t uploaded_ = 0;  // revision()
};

}  // namespace snell
