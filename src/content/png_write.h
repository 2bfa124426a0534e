// PNG out, row by row. Inside src/content only.
#pragma once

#include <png.h>

#include <functional>
#include <string>
#include <string_view>

#include "src/content/image.h"

namespace snell::content {

class PngEncoder {
public:
    // Takes the file's bytes; false: they can't be kept.
    using Sink = std::function<bool(std::string_view)>;
    explicit PngEncoder(Sink sink) : sink_(std::move(sink)) {}
    ~PngEncoder() { png_destroy_write_struct(&png_, &info_); }
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    // All false when something went wrong, which error() tells. Bytes only (PixelType::u8).
    bool begin(const Image& shape);
    bool rows(const std::byte* rows, std::size_t count);
    bool end();
    const std::string& error() const { return error_; }

private:
    static void on_error(png_structp png, png_const_charp message);
    static void on_write(png_structp png, png_bytep data, png_size_t count);

    Sink sink_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::size_t row_ = 0;  // bytes
    std::string error_;
};

}  // namespace snell::content
