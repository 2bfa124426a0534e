// Loops that Mesa's llvmpipe would end early, without a word.
#pragma once

#include "src/app/document.h"
#include "src/gl/caps.h"
#include "src/plan/plan.h"

namespace snell {

// There may be some: llvmpipe draws, and a shader has a loop.
bool may_go_round(const Plan& plan, const Document& document, const gl::Caps& caps);

// As `snell check` finds them. The texts that shaders include are added to the document's.
Diagnostics too_many_rounds(const Plan& plan, Document& document);

// What uniforms are set to where nobody moves a slider.
class Reach {
public:
    explicit Reach(const Controls& controls) : low_(controls), high_(controls) {}
    // The same controls, with other values.
    void add(const Controls& controls);
    // The plan's numbers are then those, instead of the whole way of their sliders.
    void narrow(Plan& plan) const;

private:
    Controls low_, high_;
};

}  // namespace snell
