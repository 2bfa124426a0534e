// What the values of uniforms switch off, of what a runtime has.
#pragma once

#include <vector>

#include "src/runtime/explain.h"
#include "src/runtime/runtime.h"

namespace snell::runtime {

// Without what it saves. Values count alone where Runtime::find_switched_off has tried them.
std::vector<Explanation::SwitchedOff> switched_off(const Runtime::Impl& impl);

}  // namespace snell::runtime
