#include "src/runtime/runtime.h"

#include "src/runtime/impl.h"

namespace snell {

std::span<const CounterName> counter_names() {
    static constexpr CounterName names[]{{"files_opened", "", &Counters::files_opened},
                                         {"bytes_read", "", &Counters::bytes_read},
                                         {"images_decoded", "", &Counters::images_decoded},
                                         {"bytes_decoded", "", &Counters::bytes_decoded},
                                         {"bytes_uploaded", "", &Counters::bytes_uploaded},
                                         {"textures", "memory.textures", &Counters::textures},
                                         {"mip_chains", "", &Counters::mip_chains},
                                         {"noise_bytes", "", &Counters::noise_bytes},
                                         {"meshes", "memory.geometries", &Counters::meshes},
                                         {"buffers", "", &Counters::buffers},
                                         {"trees", "", &Counters::trees},
                                         {"programs_compiled", "programs", &Counters::programs_compiled},
                                         {"shaders_compiled", "", &Counters::shaders_compiled},
                                         {"variants", "", &Counters::variants},
                                         {"targets", "", &Counters::targets},
                                         {"frames", "render.frame", &Counters::frames},
                                         {"frames_skipped", "", &Counters::frames_skipped},
                                         {"passes", "", &Counters::passes},
                                         {"draws", "render.calls", &Counters::draws},
                                         {"triangles", "render.triangles", &Counters::triangles},
                                         {"lines", "render.lines", &Counters::lines},
                                         {"points", "render.points", &Counters::points},
                                         {"blended_draws", "", &Counters::blended_draws},
                                         {"uniform_uploads", "", &Counters::uniform_uploads},
                                         {"state_changes", "", &Counters::state_changes},
                                         {"cube_faces", "", &Counters::cube_faces},
                                         {"convolutions", "", &Counters::convolutions},
                                         {"gpu_bytes", "", &Counters::gpu_bytes}};
    return names;
}

Runtime::Runtime(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, Diagnostics& diagnostics,
                 const RuntimeOptions& options)
    : impl_(std::make_unique<Impl>(std::move(plan), files, sources, caps, diagnostics, options)) {}
Runtime::~Runtime() = default;
Runtime::Runtime(Runtime&&) noexcept = default;
Runtime& Runtime::operator=(Runtime&&) noexcept = default;

const Scene& Runtime::scene() const { return impl_->plan.scene; }
const std::vector<std::vector<ActiveUniform>>& Runtime::active_uniforms() const { return impl_->active; }
bool Runtime::animated() const { return impl_->animated; }
bool Runtime::uses_mouse() const { return impl_->mouse; }
bool Runtime::sampled(Index texture) const { return impl_->textures.asked(texture); }
bool Runtime::choose(const Rungs& rungs) { return impl_->choose(rungs); }
const Rungs& Runtime::rungs() const { return impl_->plan.rungs; }
const Diagnostics& Runtime::ladder_problems() const { return impl_->problems; }
void Runtime::draw(const Frame& frame, const Surface& surface) {
    impl_->choose(frame.controls.rungs);
    impl_->draw(frame, surface);
}
void Runtime::skip_frame() { ++impl_->counters.frames_skipped; }
bool Runtime::settled() const { return impl_->settled; }
double Runtime::distance(Index draw, double depth, const Frame& frame, const Surface& surface) const {
    return impl_->distance(draw, depth, frame, surface);
}
std::vector<Index> Runtime::pick(const Frame& frame, int width, int height, const std::array<int, 4>& region) {
    impl_->choose(frame.controls.rungs);
    return impl_->pick(frame, width, height, region);
}
void Runtime::outline(const Frame& frame, const Surface& surface, Index draw, float line) {
    impl_->outline(frame, surface, draw, line);
}
Runtime::Drawn Runtime::drawn(const Frame& frame) const { return impl_->drawn(frame); }
const Counters& Runtime::counters() const { return impl_->counters; }

}  // namespace snell
