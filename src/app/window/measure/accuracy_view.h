// The accuracy panel within the window. It does nothing while the panel is closed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "src/app/window/measure/refine.h"
#include "src/gl/still.h"
#include "src/ui/panels/accuracy.h"

namespace snell {

class AccuracyView {
public:
    // The GL context of `caps` must be current during the object's whole life.
    AccuracyView(std::string path, const gl::Caps& caps) : path_(std::move(path)), caps_(caps) {}

    // Call it after each frame, whether the picture was drawn or is unchanged; see Refinement::follow. Uploads the
    // comparison picture, so that both halves show the same moment.
    void follow(Document& shown, bool stale, const Stand& stand, const ui::AccuracyMemory& memory);
    bool busy() const { return refinement_ && refinement_->busy(); }
    // Returns true if the panel or the picture changed.
    bool step() { return refinement_ && refinement_->step(); }
    // Starts measuring all rungs of the plotted ladder, or stops it.
    void measure(const ui::AccuracyMemory& memory);
    // Null while the panel is closed. Valid until the next call.
    const ui::AccuracyFacts* facts(const ui::AccuracyMemory& memory);
    // Draws the reference or the heat map over the window's picture, whose bottom left is at pixel (0, y).
    void show(int y, const ui::AccuracyMemory& memory);
    // Changes whenever show() would draw something else.
    std::uint64_t revision(const ui::AccuracyMemory& memory) const;

private:
    std::string path_;
    gl::Caps caps_;
    std::unique_ptr<Refinement> refinement_;
    ui::AccuracyFacts facts_;
    gl::Still still_;
    std::uint64_t uploaded_ = 0;  // revision() of what still_ shows
};

}  // namespace snell
