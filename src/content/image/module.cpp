#include "src/content/image/module.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>

#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include "parser/text/ranges.h"
#include "src/content/image/formats.h"
#include "src/content/image/png_write.h"
#include "src/content/load_module.h"
#include "src/content/replace.h"

namespace snell::content {
namespace {

constexpr const char* module_name = "snell_oiio.so";
constexpr std::size_t message_size = 1024;

// Shared with the copies of this process: whether one of them has opened the module. Null if there are none.
std::atomic<bool>* needed = nullptr;

OiioModule open_module() {
    OiioModule result;
    result.error =
        open_functions(module_name, "OpenImageIO", "snell_oiio_api_version", snell_oiio_version,
                       std::pair{"snell_oiio_read", &result.read}, std::pair{"snell_oiio_begin", &result.begin},
                       std::pair{"snell_oiio_rows", &result.rows}, std::pair{"snell_oiio_end", &result.end});
    return result;
}

// Collects the result of one reading; the module requests memory through a C function.
struct Reading {
    const ImageLimits& limits;
    SnellOiioShape shape{};
    std::optional<ImageIssue> refused;
    std::vector<std::byte> bytes;
    std::vector<float> floats;

    // Whether anything other than zero was read before the file ended.
    bool any() const {
        return std::any_of(bytes.begin(), bytes.end(), [](std::byte b) { return b != std::byte{0}; }) ||
               std::any_of(floats.begin(), floats.end(), [](float f) { return f != 0; });
    }
};

void* allocate(void* context, const SnellOiioShape* shape) noexcept try {
    auto& reading = *static_cast<Reading*>(context);
    reading.shape = *shape;
    const auto channels = static_cast<std::size_t>(shape->channels);
    const std::size_t pixel_bytes = channels * (shape->type == snell_oiio_u8 ? 1 : 2);
    reading.refused = check_size(shape->format, shape->width, shape->height, shape->depth, pixel_bytes, reading.limits);
    if (reading.refused) return nullptr;
    const std::size_t values = channels * static_cast<std::size_t>(shape->width) *
                               static_cast<std::size_t>(shape->height) * static_cast<std::size_t>(shape->depth);
    if (shape->type == snell_oiio_u8) {
        reading.bytes.resize(values);
        return reading.bytes.data();
    }
    reading.floats.resize(values);
    return reading.floats.data();
} catch (...) {
    return nullptr;
}

// A file in memory with a path, for libraries that open files by name.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : fd_(memfd_create("picture", MFD_CLOEXEC)) {
        while (fd_ >= 0 && !bytes.empty()) {
            const ssize_t count = write(fd_, bytes.data(), bytes.size());
            if (count <= 0 && errno != EINTR) return;
            bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        }
        if (fd_ >= 0) path_ = "/proc/self/fd/" + std::to_string(fd_);
    }
    ~MemoryFile() {
        if (fd_ >= 0) close(fd_);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    const std::string& path() const { return path_; }  // empty if there was no memory
    // Removes the meaningless path from a library's message.
    std::string unnamed(std::string message) const {
        for (std::size_t at = 0; (at = message.find(path_, at)) != std::string::npos;)
            message.replace(at, path_.size(), "the file");
        return message;
    }

private:
    int fd_;
    std::string path_;
};

// Adds a third channel: two channels that are not grey and alpha are the first two of three.
template <class Value>
std::vector<Value> third_channel(const std::vector<Value>& pairs) {
    std::vector<Value> triples(pairs.size() / 2 * 3);
    for (std::size_t i = 0; i < pairs.size() / 2; ++i) {
        triples[3 * i] = pairs[2 * i];
        triples[3 * i + 1] = pairs[2 * i + 1];
    }
    return triples;
}

ImageResult finish(Reading& reading) {
    Image image;
    image.width = reading.shape.width;
    image.height = reading.shape.height;
    image.depth = reading.shape.depth;
    image.channels = reading.shape.channels;
    if (image.channels == 2 && !reading.shape.has_alpha) {
        image.channels = 3;
        reading.bytes = third_channel(reading.bytes);
        reading.floats = third_channel(reading.floats);
    }
    ImageResult result;
    if (reading.shape.type == snell_oiio_u8) {
        image.pixels.assign(reinterpret_cast<const std::byte*>(reading.bytes.data()),
                            reinterpret_cast<const std::byte*>(reading.bytes.data() + reading.bytes.size()));
        result.image = std::move(image);
    } else {
        result = half_image(std::move(image), std::move(reading.floats));
    }
    if (result.image) result.image = oriented(*result.image, reading.shape.orientation);
    return result;
}

using std::string_view_literals::operator""sv;

// Decoders of other formats, such as TIFF and GIF, also accept files that were cut off.
constexpr std::string_view provable[] = {"png", "jpeg", "openexr", "hdr", "targa", "bmp"};

// Length, name, data, checksum of name and data; nothing behind the last one.
bool has_whole_chunks(std::string_view bytes) {
    constexpr std::size_t signature = 8, around = 12;
    bool pixels = false;
    for (std::size_t at = signature; at + around <= bytes.size();) {
        const std::size_t length = read_big_u32(bytes, at);
        if (length > bytes.size() - at - around) return false;
        const std::string_view named = bytes.substr(at + 4, 4 + length);
        const auto* data = reinterpret_cast<const Bytef*>(named.data());
        if (crc32_z(0, data, named.size()) != read_big_u32(bytes, at + 8 + length)) return false;
        at += around + length;
        pixels = pixels || named.starts_with("IDAT");
        if (named == "IEND") return pixels && at == bytes.size();
    }
    return false;
}

}  // namespace

SnellOiioShape module_shape(const Image& image) {
    SnellOiioShape shape{};
    shape.width = image.width;
    shape.height = image.height;
    shape.depth = image.depth;
    shape.channels = image.channels;
    shape.has_alpha = image.channels % 2 == 0;
    constexpr std::array types{snell_oiio_u8, snell_oiio_f16, snell_oiio_f32};  // as PixelType
    shape.type = types[static_cast<std::size_t>(image.type)];
    return shape;
}

const OiioModule& oiio_module() {
    static const OiioModule module = open_module();
    if (needed) needed->store(true);
    return module;
}

void open_image_module_as_copies_do() {
    if (!needed) {
        void* shared = mmap(nullptr, sizeof(*needed), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (shared != MAP_FAILED) needed = new (shared) std::atomic<bool>(false);
    }
    if (needed && needed->load()) oiio_module();
}

ImageResult decode_other(std::string_view bytes, std::string_view format, const ImageLimits& limits) {
    const OiioModule& module = oiio_module();
    if (!module.error.empty()) {
        return image_failed(
            "image-module-missing", module.error,
            "install snell completely; without the module only BMP, PNG and raw .tex images can be read");
    }
    const MemoryFile file(bytes);
    if (file.path().empty()) return image_failed("image-unreadable", "not enough memory to read the image");
    Reading reading{limits, {}, {}, {}, {}};
    std::array<char, message_size> message{};
    const int status = module.read(file.path().c_str(), std::string(format).c_str(), allocate, &reading, message.data(),
                                   message.size());
    if (reading.refused) return {{}, {*reading.refused}};
    const std::string kind = format.empty() ? "image of unknown format" : std::string(format) + " image";
    std::string what = kind + ": " + (message[0] ? file.unnamed(message.data()) : "not enough memory");
    if (status == 0) return finish(reading);
    if (status == 3 && reading.any()) {
        ImageResult result = finish(reading);
        result.issues.push_back({false, "image-truncated", what + "; the rest of the image is empty",
                                 "copy the file again, it is incomplete"});
        return result;
    }
    return image_failed("image-unreadable", what, "save it as PNG, JPEG, BMP, HDR or EXR");
}

bool is_whole(const std::string& path, std::string_view bytes, const ImageLimits& limits) {
    const std::string_view format = format_of_extension(extension_of(path));
    if (ranges::find(provable, format) == std::end(provable)) return false;
    if (sniff(bytes) != (format == "targa" ? "" : format)) return false;  // TGA has no signature
    if (format == "png") return has_whole_chunks(bytes);
    if (format == "jpeg" && !bytes.ends_with("\xff\xd9")) return false;
    if (format == "targa" && !bytes.ends_with("TRUEVISION-XFILE.\0"sv)) return false;
    if (format == "bmp" && (bytes.size() < 6 || read_u32(bytes, 2) != bytes.size())) return false;
    const ImageResult result = decode_image(path, bytes, limits);
    return result.image && ranges::none_of(result.issues, [](const ImageIssue& issue) {
               return issue.code == "image-truncated" || issue.code == "image-damaged";
           });
}

// Writes images to files.

std::string encode_png(const Image& image) {
    if (image.width <= 0 || image.height <= 0 || image.pixels.size() != image.bytes()) return {};
    std::string bytes;
    PngEncoder png([&bytes](std::string_view more) {
        bytes += more;
        return true;
    });
    const Image top_first = to_bytes(image.bottom_first ? flipped(image) : image);
    const bool good =
        png.begin(top_first) && png.rows(top_first.pixels.data(), static_cast<std::size_t>(image.height)) && png.end();
    return good ? bytes : "";
}

bool writes_without_module(std::string_view path) { return extension_of(path) == "png"; }

std::string write_image(const std::string& path, const Image& image) {
    if (image.pixels.size() != image.bytes()) return "the picture is empty";
    if (image.depth > 1) return "cannot write a 3D texture as an image";
    // What cannot be renamed is written at once, and has no extension that would tell its format.
    if (is_stream(path) && extension_of(path).empty()) return replace_file(path, encode_png(image));
    RowWriter file(path, image);
    if (image.bottom_first)
        file.add(flipped(image).pixels);
    else
        file.add(image.pixels);
    return file.finish();
}

}  // namespace snell::content
