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
void Runtime::draw(const Frame& frame, const Surface& surface) { impl_->draw(frame, surface); }
const Counters& Runtime::counters() const { return impl_->counters; }

}  // namespace snell
