// What explanations call statements of the scene.
#pragma once

#include <string>
#include <string_view>

#include "src/runtime/explain.h"

namespace snell::runtime {

std::string statement_of(const Texture& texture);
// The statement with its first file.
std::string title_of(const Texture& texture);
Explanation::Kind kind_of(const Texture& texture);
std::string name_of(const Pass& pass);
std::string plural(std::size_t count, std::string_view what);

}  // namespace snell::runtime
