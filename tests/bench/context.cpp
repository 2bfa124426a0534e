#include "tests/bench/context.h"

#include <optional>

#include "src/platform/headless.h"

namespace snell::bench {

const gl::Caps* graphics() {
    static std::string error;
    static const std::unique_ptr<HeadlessContext> context = HeadlessContext::make({}, error);
    static const std::optional<gl::Caps> caps = context ? std::optional(gl::query_caps()) : std::nullopt;
    return caps ? &*caps : nullptr;
}

std::string renderer() { return graphics() ? graphics()->renderer + ", OpenGL " + graphics()->version : "none"; }

}  // namespace snell::bench
