#include "src/content/image/module.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "src/content/image/formats.h"
#include "src/content/image/open_module.h"
#include "src/content/load_module.h"

namespace snell::content {
namespace {

constexpr const char* module_name = "snell_oiio.so";
constexpr std::size_t message_size = 1024;

OiioModule open_module() {
    OiioModule result;
    const LoadedModule module = load_module(module_name, "OpenImageIO");
    result.error = module.error;
    if (!module.error.empty()) return result;
    decltype(&snell_oiio_api_version) version = nullptr;
    const bool fits = module.find("snell_oiio_api_version", version) && version() == snell_oiio_version &&
                      module.find("snell_oiio_read", result.read) && module.find("snell_oiio_begin", result.begin) &&
                      module.find("snell_oiio_rows", result.rows) && module.find("snell_oiio_end", result.end);
    if (!fits) result.error = module.path + " is from another version of snell";
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
    return module;
}

void open_image_module() { oiio_module(); }

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

}  // namespace snell::content
