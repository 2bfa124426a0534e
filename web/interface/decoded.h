// Images that were decoded elsewhere: by another thread of the page, or by the native program.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace snell::web {

// Decodes the bytes of an image file into the form that every decoder of the page takes in place of the file. Returns
// nothing, and sets `error`, if the file is no image that a page reads.
std::vector<std::byte> decoded(const std::string& name, std::string_view bytes, std::string& error);

}  // namespace snell::web
