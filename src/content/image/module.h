// The OpenImageIO module, found and opened when it is first needed. Internal to src/content.
#pragma once

#include <string>
#include <string_view>

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

// Checks that a picture's file was written to its end.

// Returns true if the file is of the format that the extension of `path` stands for, and is complete. A PNG must have
// all its chunks with their checksums; EXR, HDR, JPEG, TGA and BMP are decoded, and must have their end marks (JPEG,
// TGA) or their size (BMP). Returns false for all other formats, such as TIFF: a cut can't be ruled out.
bool is_whole(const std::string& path, std::string_view bytes, const ImageLimits& limits);

// Opening the OpenImageIO module early.

// Where a process starts copies of itself: opening the module takes a quarter of a second, which later copies save if
// this process opens it, too, once one of them needed it. Called before each copy is started. Starts no thread.
void open_image_module_as_copies_do();

}  // namespace snell::content
