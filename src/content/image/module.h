// The OpenImageIO module, found and opened when it is first needed. Internal to src/content.
#pragma once

#include <string>

#include "src/content/image/image.h"
#include "src/content/oiio/api.h"

namespace snell::content {

struct OiioModule {
    decltype(&snell_oiio_read) read = nullptr;
    decltype(&snell_oiio_begin) begin = nullptr;
    decltype(&snell_oiio_rows) rows = nullptr;
    decltype(&snell_oiio_end) end = nullptr;
    std::string error;  // why it cannot be used; empty if it can
};

// Looks for the module in the executable's folder, then in ../lib/snell. Thread-safe; the module stays open.
const OiioModule& oiio_module();

// The size, type and channels of an image, in the form of the module's interface.
SnellOiioShape module_shape(const Image& image);

}  // namespace snell::content
