#include "src/content/image/png_write.h"

#include <array>
#include <csetjmp>

namespace snell::content {

namespace {

void on_write_warning(png_structp, png_const_charp) {}

void on_flush(png_structp) {}

}  // namespace

void PngEncoder::on_error(png_structp png, png_const_charp message) {
    auto& encoder = *static_cast<PngEncoder*>(png_get_error_ptr(png));
    if (encoder.error_.empty()) encoder.error_ = message;
    png_longjmp(png, 1);
}

void PngEncoder::on_write(png_structp png, png_bytep data, png_size_t count) {
    const auto& encoder = *static_cast<PngEncoder*>(png_get_io_ptr(png));
    if (!encoder.sink_({reinterpret_cast<const char*>(data), count})) png_error(png, "cannot write the file");
}

bool PngEncoder::begin(const Image& shape) {
    constexpr std::array<int, 4> colors{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                        PNG_COLOR_TYPE_RGB_ALPHA};
    error_ = "out of memory";
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_write_warning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) return false;
    error_.clear();
    if (setjmp(png_jmpbuf(png_))) return false;
    row_ = shape.row_bytes();
    png_set_write_fn(png_, this, on_write, on_flush);
    // The size is limited only by the file format.
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(shape.width), static_cast<png_uint_32>(shape.height), 8,
                 colors[static_cast<std::size_t>(shape.channels - 1)], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    // Compared with zlib's default, level 2 makes files 15 % larger, but writes them in a fifth of the time.
    png_set_compression_level(png_, 2);
    // Trying every filter on every row would save 5 % in size, but take twice as long.
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_write_info(png_, info_);
    return true;
}

bool PngEncoder::rows(const std::byte* rows, std::size_t count) {
    if (setjmp(png_jmpbuf(png_))) return false;
    for (std::size_t y = 0; y < count; ++y) png_write_row(png_, reinterpret_cast<png_const_bytep>(rows + y * row_));
    return true;
}

bool PngEncoder::end() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_write_end(png_, info_);
    return true;
}

}  // namespace snell::content
