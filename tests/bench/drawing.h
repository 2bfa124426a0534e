// Frames of documents, to be timed.
#pragma once

#include "src/document/document.h"
#include "src/gl/target.h"
#include "tests/bench/bounds.h"

namespace snell::bench {

// At the scene's beginning; returns when it is there.
void draw_frame(Document& document, const gl::Target& target);

// After two frames that are not timed. Says how many draws one has.
void time_frames(benchmark::State& state, Document& document, const gl::Target& target);

}  // namespace snell::bench
