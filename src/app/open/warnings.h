// What a picture is doubted for: nothing of the scene in view, and loops that Mesa's llvmpipe would silently end early.
#pragma once

#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/plan/plan.h"

namespace snell::app {

// What a picture that shows nothing of its scene should say.

// A warning for a frame of which no fragment reached the picture, with the option of --view that shows something, if
// one is found: it is drawn, small, to see whether it does. Leaves what the scene renders to as it is.
Diagnostics nothing_in_view(Document& document, const Frame& frame, int width, int height);

}  // namespace snell::app

namespace snell {

// Finds loops that Mesa's llvmpipe would silently end early.

// True if llvmpipe draws and a shader has a loop, so that a check is worthwhile.
bool may_go_round(const Plan& plan, const Document& document, const gl::Caps& caps);

// Returns the warnings that `snell check` would give. Adds the texts that shaders include to the document's sources.
Diagnostics too_many_rounds(const Plan& plan, Document& document);
// The same for the numbers of rungs in the place of the rungs themselves: what is shown of them is another thing than
// what the names of the rungs say.
Diagnostics misread_rungs(const Plan& plan, Document& document);

// The values that uniforms take in a command, where no user moves a slider.
class Reach {
public:
    explicit Reach(const Controls& controls) : low_(controls), high_(controls) {}
    // Adds other values of the same controls.
    void add(const Controls& controls);
    // Limits the plan's ranges of uniforms to these values, instead of the full ranges of their sliders.
    void narrow(Plan& plan) const;

private:
    Controls low_, high_;
};

}  // namespace snell
