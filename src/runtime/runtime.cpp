#include "src/runtime/runtime.h"

#include "src/runtime/impl.h"

namespace snell {

Runtime::Runtime(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, Diagnostics& diagnostics)
    : impl_(std::make_unique<Impl>(std::move(plan), files, sources, caps, diagnostics)) {}
Runtime::~Runtime() = default;
Runtime::Runtime(Runtime&&) noexcept = default;
Runtime& Runtime::operator=(Runtime&&) noexcept = default;

const Scene& Runtime::scene() const { return impl_->plan.scene; }
const std::vector<std::vector<ActiveUniform>>& Runtime::active_uniforms() const { return impl_->active; }
bool Runtime::animated() const { return impl_->animated; }
bool Runtime::uses_mouse() const { return impl_->mouse; }
bool Runtime::choose(const Rungs& rungs) { return impl_->choose(rungs); }
const Rungs& Runtime::rungs() const { return impl_->plan.rungs; }
const Diagnostics& Runtime::ladder_problems() const { return impl_->problems; }
void Runtime::draw(const Frame& frame, const Surface& surface) {
    impl_->choose(frame.controls.rungs);
    impl_->draw(frame, surface);
}
bool Runtime::settled() const { return impl_->settled; }
const Counters& Runtime::counters() const { return impl_->counters; }

}  // namespace snell
