// SHA-256 (FIPS 180-4), formatted as by sha256sum.
#pragma once

#include <string>
#include <string_view>

namespace snell::app {

std::string sha256(std::string_view bytes);

}  // namespace snell::app
