#include "src/runtime/runtime.h"

#include <bit>

#include "parser/text/ranges.h"
#include "src/runtime/impl.h"

namespace snell {

namespace {

std::optional<Runtime::Held> held_of(const runtime::GpuTexture* gpu) {
    if (!gpu) return std::nullopt;
    const int longest = *ranges::max_element(gpu->size);
    const int levels = gpu->mipmapped ? std::bit_width(static_cast<unsigned>(longest)) : gpu->levels;
    return Runtime::Held{{gpu->texture.get(), gpu->target, gpu->size}, levels, gpu->pixels};
}

}  // namespace

Runtime::Runtime(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, Diagnostics& diagnostics,
                 const RuntimeOptions& options)
    : impl_(std::make_unique<Impl>(std::move(plan), files, sources, caps, diagnostics, options)) {}
Runtime::~Runtime() = default;
Runtime::Runtime(Runtime&&) noexcept = default;
Runtime& Runtime::operator=(Runtime&&) noexcept = default;

const Scene& Runtime::scene() const { return impl_->plan.scene; }
gl::Pixels Runtime::display_pixels() const {
    return scene().output == Encoding::srgb ? gl::Pixels::srgb8 : gl::Pixels::rgba8;
}
const std::vector<std::vector<ActiveUniform>>& Runtime::active_uniforms() const { return impl_->active; }
const Controls& Runtime::controls() const { return impl_->given; }
const Diagnostics& Runtime::value_problems() const { return impl_->value_problems; }
bool Runtime::animated() const { return impl_->animated; }
bool Runtime::uses_mouse() const { return impl_->mouse; }
bool Runtime::sampled(Index texture) const {
    return impl_->textures.asked(texture) || impl_->dormant_textures.contains(impl_->textures.first(texture));
}
bool Runtime::choose(const Rungs& rungs) { return impl_->choose(rungs); }
const Rungs& Runtime::rungs() const { return impl_->plan.rungs; }
const Diagnostics& Runtime::ladder_problems() const { return impl_->problems; }
void Runtime::draw(const Frame& frame, const Surface& surface) {
    impl_->take(frame.controls);
    impl_->draw(frame, surface);
}
bool Runtime::specialise(const Frame& frame, const Surface& surface) { return impl_->specialise(frame, surface); }
void Runtime::skip_frame() { ++impl_->counters.frames_skipped; }
bool Runtime::settled() const { return impl_->settled; }
double Runtime::distance(Index draw, double depth, const Frame& frame, const Surface& surface) const {
    return impl_->distance(draw, depth, frame, surface);
}
std::vector<Index> Runtime::pick(const Frame& frame, int width, int height, const PixelRect& region) {
    impl_->take(frame.controls);
    return impl_->pick(frame, width, height, region);
}
void Runtime::outline(const Frame& frame, const Surface& surface, Index draw, float line) {
    impl_->take(frame.controls);
    impl_->outline(frame, surface, draw, line);
}
std::optional<Runtime::Held> Runtime::texture(Index texture) const {
    std::optional<Held> held = held_of(impl_->textures.find(texture));
    if (!held) return held;
    const Index source = impl_->plan.scene.textures[texture].source;
    const Index drawn = source == none ? texture : source;
    held->changes = ranges::any_of(impl_->plan.scene.passes,
                                   [&](const Pass& pass) { return ranges::count(pass.textures, drawn) > 0; });
    return held;
}
std::optional<Runtime::Held> Runtime::noise(int dimensions) const {
    return held_of(impl_->textures.find_noise(dimensions));
}
Runtime::Drawn Runtime::drawn(const Frame& frame) const { return impl_->drawn(frame); }
bool Runtime::find_switched_off() { return impl_->link_alone(); }
std::vector<const Control*> Runtime::without_effect(double seconds) const { return impl_->without_effect(seconds); }
int Runtime::form() const { return impl_->settled_values; }
const Counters& Runtime::counters() const { return impl_->counters; }

}  // namespace snell
