// What explanations call statements of the scene.
// What the values of uniforms switch off, of what a runtime has.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/runtime/explain.h"
#include "src/runtime/runtime.h"

namespace snell::runtime {

std::string statement_of(const Texture& texture);
// The statement with its first file.
std::string title_of(const Texture& texture);
Explanation::Kind kind_of(const Texture& texture);
std::string name_of(const Pass& pass);

// Without what it saves. Values count alone where Runtime::find_switched_off has tried them.
std::vector<Explanation::SwitchedOff> switched_off(const Runtime::Impl& impl);

}  // namespace snell::runtime
