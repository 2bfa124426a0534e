// Writes PNG row by row. Internal to src/content.
// Writes an image row by row, so that it never has to be in memory as a whole.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <png.h>

#include "src/content/image/image.h"

namespace snell::content {

class PngEncoder {
public:
    // Receives the bytes of the file; returns false if they cannot be stored.
    using Sink = std::function<bool(std::string_view)>;
    explicit PngEncoder(Sink sink) : sink_(std::move(sink)) {}
    ~PngEncoder() { png_destroy_write_struct(&png_, &info_); }
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    // begin(), rows() and end() return false after an error, which error() describes. Only PixelType::u8 is supported.
    bool begin(const Image& shape);
    // Appends `count` whole rows, top first.
    bool rows(const std::byte* rows, std::size_t count);
    bool end();
    const std::string& error() const { return error_; }

private:
    static void on_error(png_structp png, png_const_charp message);
    static void on_write(png_structp png, png_bytep data, png_size_t count);

    Sink sink_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::size_t row_ = 0;  // bytes per row
    std::string error_;
};

class RowWriter {
public:
    // The format is that of the extension, as for write_image. Only size, channels and type of `shape` are used. After
    // an error, all calls return it and the file stays unchanged.
    RowWriter(const std::string& path, const Image& shape);
    ~RowWriter();
    RowWriter(const RowWriter&) = delete;
    RowWriter& operator=(const RowWriter&) = delete;

    // Appends whole rows, top first. Returns "" or the error.
    std::string add(std::span<const std::byte> rows);
    // Call it after the last row: the file appears in its place. Returns "" or the error.
    std::string finish();

private:
    struct File;
    std::unique_ptr<File> file_;
    std::string wrong_;
};

}  // namespace snell::content
