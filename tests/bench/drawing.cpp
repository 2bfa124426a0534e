#include "tests/bench/drawing.h"

#include "src/gl/present.h"

namespace snell::bench {

void draw_frame(Document& document, const gl::Target& target) {
    const View view;
    document.runtime->draw({0, view, document.controls}, {target.framebuffer.get(), target.width, target.height});
    gl::finish();
}

void time_frames(benchmark::State& state, Document& document, const gl::Target& target) {
    draw_frame(document, target);
    const std::uint64_t before = document.runtime->counters().draws;
    draw_frame(document, target);
    state.counters["draws"] = static_cast<double>(document.runtime->counters().draws - before);
    for (auto _ : state) draw_frame(document, target);
}

}  // namespace snell::bench
