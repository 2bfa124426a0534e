// The OpenImageIO module: found and opened on first need. Inside src/content only.
#pragma once

#include <string>

#include "src/content/image.h"
#include "src/content/oiio/api.h"

namespace snell::content {

struct OiioModule {
    decltype(&snell_oiio_read) read = nullptr;
    decltype(&snell_oiio_begin) begin = nullptr;
    decltype(&snell_oiio_rows) rows = nullptr;
    decltype(&snell_oiio_end) end = nullptr;
    std::string error;  // why it can't be used; empty: it can
};

// Looked for beside the executable, then in ../lib/snell. Thread-safe; stays open.
const OiioModule& oiio_module();

SnellOiioShape module_shape(const Image& image);

}  // namespace snell::content
