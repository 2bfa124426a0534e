// Pictures out.
#include <png.h>

#include <cmath>
#include <csetjmp>
#include <filesystem>

#include "src/content/compare.h"
#include "src/content/formats.h"
#include "src/content/module.h"
#include "src/content/replace.h"

namespace snell::content {
namespace {

namespace fs = std::filesystem;

struct PngOut {
    std::string bytes, error;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<png_bytep> rows;

    ~PngOut() { png_destroy_write_struct(&png, &info); }
};

void on_error(png_structp png, png_const_charp message) {
    static_cast<PngOut*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_write(png_structp png, png_bytep data, png_size_t count) {
    static_cast<PngOut*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(data), count);
}

void on_flush(png_structp) {}

bool encode(PngOut& out, const Image& image) {
    constexpr std::array<int, 4> colors{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                        PNG_COLOR_TYPE_RGB_ALPHA};
    out.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &out, on_error, on_warning);
    out.info = out.png ? png_create_info_struct(out.png) : nullptr;
    if (!out.info) return false;
    if (setjmp(png_jmpbuf(out.png))) return false;
    png_set_write_fn(out.png, &out, on_write, on_flush);
    // The picture's own limit is the file format's.
    png_set_user_limits(out.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(out.png, out.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 colors[static_cast<std::size_t>(image.channels - 1)], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    // Of zlib's levels the second: files grow by 15 % against the default, and are written in a fifth of the time.
    png_set_compression_level(out.png, 2);
    // Trying every filter on every row takes half of the rest, for 5 %.
    png_set_filter(out.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_write_info(out.png, out.info);
    png_write_image(out.png, out.rows.data());
    png_write_end(out.png, out.info);
    return true;
}

// What went wrong, or nothing; the bytes are in `out`.
std::string encode_rows(PngOut& out, const Image& picture) {
    Image image = to_bytes(picture);
    const std::size_t row = image.row_bytes();
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
        out.rows.push_back(reinterpret_cast<png_bytep>(image.pixels.data() + y * row));
    }
    if (!encode(out, image)) return out.error.empty() ? "out of memory" : out.error;
    return {};
}

std::string write_png(const fs::path& path, const Image& picture) {
    PngOut out;
    const std::string wrong = encode_rows(out, picture);
    return wrong.empty() ? write_file(path, out.bytes) : wrong;
}

std::string write_by_module(const fs::path& path, const std::string& extension, const Image& image) {
    const OiioModule& module = oiio_module();
    if (!module.error.empty()) return module.error + "; only PNG can be written without it";
    const SnellOiioShape shape = module_shape(image);
    std::array<char, 1024> message{};
    if (module.write(path.c_str(), extension.c_str(), &shape, image.pixels.data(), message.data(), message.size()) == 0)
        return {};
    return message[0] ? message.data() : "the picture can't be written in this format";
}

}  // namespace

Image to_bytes(const Image& image) {
    if (image.type == PixelType::u8) return image;
    Image result = image;
    result.type = PixelType::u8;
    result.pixels.resize(result.bytes());
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        const float value = value_at(image, i);
        const float clamped = value > 0 ? std::min(value, 1.0f) : 0.0f;
        result.pixels[i] = static_cast<std::byte>(std::lround(clamped * 255.0f));
    }
    return result;
}

std::string encode_png(const Image& image) {
    if (image.width <= 0 || image.height <= 0 || image.pixels.size() != image.bytes()) return {};
    PngOut out;
    return encode_rows(out, image.bottom_first ? flipped(image) : image).empty() ? std::move(out.bytes) : "";
}

bool writes_without_module(std::string_view path) { return extension_of(path) == "png"; }

std::string write_image(const std::string& path, const Image& image) {
    const std::string extension = extension_of(path);
    if (extension.empty()) return path + " has no extension that says in which format to write, such as .png or .exr";
    if (image.width <= 0 || image.height <= 0 || image.channels < 1 || image.channels > 4 ||
        image.pixels.size() != image.bytes()) {
        return "there are no pixels to write";
    }
    if (image.depth > 1) return "a volume can't be written as a picture";
    Replacement file(path);
    if (std::string wrong = file.check(); !wrong.empty()) return wrong;

    const Image& top_first = image.bottom_first ? flipped(image) : image;
    const std::string wrong = writes_without_module(path) ? write_png(file.path(), top_first)
                                                          : write_by_module(file.path(), extension, top_first);
    return wrong.empty() ? file.take_place() : path + ": " + wrong;
}

}  // namespace snell::content
