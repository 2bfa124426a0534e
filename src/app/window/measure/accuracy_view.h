// The accuracy panel within the window. It does nothing while the panel is closed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "src/app/window/measure/refine.h"
#include "src/gl/present.h"
#include "src/ui/panels/accuracy.h"

namespace snell {

class AccuracyView {
public:
    // The GL context of `caps` must be current during the object's whole life.
    AccuracyView(std::string path, const gl::Caps& caps) : path_(std::move(path)), caps_(caps) {}

    // Call it after each frame, whether the picture was drawn or is unchanged; see Refinement::follow. Uploads the
    // comparison picture, so that both halves show the same moment. `rung`, if it is not null, is the document of a
    // found rung, which is shown in place of the scene and compared with it.
    void follow(Document& scene, bool stale, const Stand& stand, const ui::AccuracyMemory& memory, Document* rung);
    // Call it before the document of the rung, or of the scene, is destroyed.
    void leave_rung() { beside_.reset(); }
    void leave();
    bool busy() const { return now() && now()->busy(); }
    // Returns true if the panel or the picture changed.
    bool step() { return now() && now()->step(); }
    // Starts measuring all rungs of the plotted ladder, or stops it.
    void measure(const ui::AccuracyMemory& memory);
    // Null while the panel is closed, and where there is nothing to compare with. Valid until the next call.
    const ui::AccuracyFacts* facts(const ui::AccuracyMemory& memory);
    // Draws the reference or the heat map over the window's picture, whose bottom left is at pixel (0, y).
    void show(int y, const ui::AccuracyMemory& memory);
    // Changes whenever show() would draw something else.
    std::uint64_t revision(const ui::AccuracyMemory& memory) const;

private:
    // What is compared with the picture in the window.
    Refinement* now() const { return beside_ ? beside_.get() : refinement_.get(); }

    std::string path_;
    gl::Caps caps_;
    std::unique_ptr<Refinement> refinement_, beside_;  // of the scene, if it has ladders; of a found rung
    ui::AccuracyFacts facts_;
    gl::Still still_;
    std::uint64_t uploaded_ = 0;  // revision() of what still_ shows
};

}  // namespace snell
