// The only file of snell that includes OpenImageIO. Loading it loads some 260 shared libraries, so it is in a module
// that is opened when an image first needs it.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>

#include "src/content/oiio/api.h"

#define SNELL_EXPORT __attribute__((visibility("default")))

namespace {

enum Status { done = 0, failed = 1, given_up = 2, broken_off = 3 };

struct Message {
    char* text;
    std::size_t size;

    int operator()(Status status, const std::string& what) const {
        const std::size_t end = what.find_last_not_of("\r\n ");
        std::snprintf(text, size, "%s", what.substr(0, end == std::string::npos ? 0 : end + 1).c_str());
        return status;
    }
};

OIIO::TypeDesc type_of(SnellOiioType type) {
    switch (type) {
        case snell_oiio_u8:
            return OIIO::TypeDesc::UINT8;
        case snell_oiio_f16:
            return OIIO::TypeDesc::HALF;
        case snell_oiio_f32:
            return OIIO::TypeDesc::FLOAT;
    }
    return OIIO::TypeDesc::UNKNOWN;
}

OIIO::ImageSpec spec_of(const SnellOiioShape& shape) {
    OIIO::ImageSpec spec(shape.width, shape.height, shape.channels, type_of(shape.type));
    spec.depth = spec.full_depth = shape.depth;
    spec.alpha_channel = shape.has_alpha ? shape.channels - 1 : -1;
    if (shape.channels == 2 && shape.has_alpha) spec.channelnames = {"Y", "A"};
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

// Only colour and alpha are read: depth, normals and other channels are left out.
SnellOiioShape shape_of(const OIIO::ImageSpec& spec, const std::string& format) {
    SnellOiioShape shape{};
    shape.width = spec.width;
    shape.height = spec.height;
    shape.depth = std::max(spec.depth, 1);
    shape.channels = spec.nchannels;
    const bool fourth_is_alpha = spec.alpha_channel == 3 || (spec.alpha_channel < 0 && spec.z_channel != 3);
    if (spec.nchannels >= 4)
        shape.channels = fourth_is_alpha && (spec.nchannels == 4 || spec.alpha_channel == 3) ? 4 : 3;
    shape.has_alpha = shape.channels == 4 || (shape.channels == 2 && spec.alpha_channel == 1);
    // NOLINTNEXTLINE(misc-redundant-expression): it takes the two constants for one
    const bool bytes = spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::INT8;
    shape.type = bytes ? snell_oiio_u8 : snell_oiio_f32;
    shape.orientation = spec.get_int_attribute("Orientation", 1);
    std::snprintf(shape.format, sizeof shape.format, "%s", format.c_str());
    return shape;
}

// OpenImageIO multiplies the colours of WebP and one kind of TIFF by alpha, whatever is requested. EXR's colours are
// multiplied too, but by definition of the format, so they stay.
bool multiplied(const OIIO::ImageInput& input) {
    const std::string format = input.format_name();
    return (format == "webp" || format == "tiff") && input.spec().get_int_attribute("oiio:UnassociatedAlpha") == 0;
}

void divide_by_alpha(const SnellOiioShape& shape, void* pixels) {
    const OIIO::ImageBuf picture(spec_of(shape), pixels);
    OIIO::ImageBuf whole(spec_of(shape), pixels);
    OIIO::ImageBufAlgo::unpremult(whole, picture);
}

int read(const char* path, const char* format, SnellOiioAllocate allocate, void* context, const Message& message) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // values as the file stores them
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    if (format && *format) {
        input = OIIO::ImageInput::create(format);
        if (!input) return message(failed, OIIO::geterror());
        if (!input->open(path, spec, config)) return message(failed, input->geterror());
    } else {
        input = OIIO::ImageInput::open(path, &config);
        if (!input) return message(failed, OIIO::geterror());
        spec = input->spec();
    }
    if (spec.deep) return message(failed, "deep images are not supported");
    const SnellOiioShape shape = shape_of(spec, input->format_name());
    void* const pixels = allocate(context, &shape);
    if (!pixels) return message(given_up, "");
    if (!input->read_image(0, 0, 0, shape.channels, type_of(shape.type), pixels))
        return message(broken_off, input->geterror());
    if (shape.has_alpha && multiplied(*input)) divide_by_alpha(shape, pixels);
    return message(done, "");
}

// The output file. Some writers do not check whether a write succeeded, and libjpeg ends the process if it failed. So
// every write reports success to them, and the error is reported to the caller.
class OutputFile : public OIIO::Filesystem::IOProxy {
public:
    explicit OutputFile(const char* path) : IOProxy(path, Write), file_((unlink(path), open(path, flags, 0666))) {
        if (file_ < 0) error_ = errno;
    }
    ~OutputFile() override { finish(); }
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const char* proxytype() const override { return "snell"; }
    std::size_t write(const void* bytes, std::size_t size) override {
        pwrite(bytes, size, m_pos);
        m_pos += static_cast<std::int64_t>(size);
        return size;
    }
    std::size_t pwrite(const void* bytes, std::size_t size, std::int64_t offset) override {
        const char* from = static_cast<const char*>(bytes);
        for (std::size_t rest = size; rest > 0 && error_ == 0;) {
            const ssize_t count = ::pwrite(file_, from, rest, offset);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) {
                error_ = count < 0 ? errno : ENOSPC;
                break;
            }
            from += count;
            offset += count;
            rest -= static_cast<std::size_t>(count);
        }
        return size;
    }
    std::size_t read(void* bytes, std::size_t size) override {
        const std::size_t count = pread(bytes, size, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }
    std::size_t pread(void* bytes, std::size_t size, std::int64_t offset) override {
        const ssize_t count = ::pread(file_, bytes, size, offset);
        return static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    std::size_t size() const override {
        struct stat now {};
        return fstat(file_, &now) == 0 ? static_cast<std::size_t>(now.st_size) : 0;
    }
    // Returns 0, or the errno of the first error.
    int finish() {
        if (file_ >= 0 && ::close(file_) != 0 && error_ == 0) error_ = errno;
        file_ = -1;
        return error_;
    }

private:
    static constexpr int flags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    int file_, error_ = 0;
};

struct Picture {
    std::unique_ptr<OutputFile> file;  // null if the format can only write to a named file
    std::unique_ptr<OIIO::ImageOutput> output;
    SnellOiioShape shape{};
    int row = 0;
};

std::unique_ptr<Picture> begin(const char* path, const char* format, const SnellOiioShape& shape,
                               const Message& message) {
    auto picture = std::make_unique<Picture>();
    std::unique_ptr<OIIO::ImageOutput>& output = picture->output;
    output = OIIO::ImageOutput::create(format);
    if (!output) {
        OIIO::geterror();  // it names the temporary file, which means nothing to the user
        message(failed, std::string("'") + format + "' is not the extension of a supported image format");
        return nullptr;
    }
    picture->shape = shape;
    SnellOiioShape stored = shape;
    // The WebP writer divides colours by alpha although they were not multiplied, so alpha is left out.
    if (shape.has_alpha && (!output->supports("alpha") || std::string(output->format_name()) == "webp")) {
        stored.channels = shape.channels - 1;
        stored.has_alpha = 0;
    }
    OIIO::ImageSpec spec = spec_of(stored);
    if (shape.type == snell_oiio_u8 && std::string(output->format_name()) == "openexr")
        spec.set_format(OIIO::TypeDesc::HALF);
    spec.attribute("DateTime", "");  // otherwise it is now, and the same picture differs from second to second
    if (output->supports("ioproxy")) {
        picture->file = std::make_unique<OutputFile>(path);
        if (!output->set_ioproxy(picture->file.get())) picture->file.reset();
    }
    if (output->open(path, spec)) return picture;
    const int wrong = picture->file ? picture->file->finish() : 0;
    message(failed, wrong ? std::strerror(wrong) : output->geterror());
    return nullptr;
}

int rows(Picture& picture, const void* pixels, int count, const Message& message) {
    const OIIO::TypeDesc type = type_of(picture.shape.type);
    const OIIO::stride_t pixel = static_cast<OIIO::stride_t>(type.size()) * picture.shape.channels;
    const OIIO::stride_t row = pixel * picture.shape.width;
    const int end = picture.row + count;
    if (!picture.output->write_scanlines(picture.row, end, 0, type, pixels, pixel, row))
        return message(failed, picture.output->geterror());
    picture.row = end;
    return message(done, "");
}

int end(std::unique_ptr<Picture> picture, bool whole, const Message& message) {
    const bool closed = picture->output->close();
    const std::string why = closed ? "" : picture->output->geterror();
    const int wrong = picture->file ? picture->file->finish() : 0;
    if (!whole) return message(done, "");
    if (wrong) return message(failed, std::strerror(wrong));
    return closed ? message(done, "") : message(failed, why);
}

// Exceptions must not cross the C interface.
template <class Work>
int guarded(const Message& message, Work work) {
    try {
        return work();
    } catch (const std::exception& e) {
        return message(failed, e.what());
    } catch (...) {
        return message(failed, "an unknown error");
    }
}

}  // namespace

extern "C" {

SNELL_EXPORT int snell_oiio_read(const char* path, const char* format, SnellOiioAllocate allocate, void* context,
                                 char* message, size_t message_size) {
    const Message say{message, message_size};
    return guarded(say, [&] { return read(path, format, allocate, context, say); });
}

SNELL_EXPORT void* snell_oiio_begin(const char* path, const char* format, const SnellOiioShape* shape, char* message,
                                    size_t message_size) {
    const Message say{message, message_size};
    void* picture = nullptr;
    guarded(say, [&] {
        picture = begin(path, format, *shape, say).release();
        return 0;
    });
    return picture;
}

SNELL_EXPORT int snell_oiio_rows(void* picture, const void* pixels, int count, char* message, size_t message_size) {
    const Message say{message, message_size};
    return guarded(say, [&] { return rows(*static_cast<Picture*>(picture), pixels, count, say); });
}

SNELL_EXPORT int snell_oiio_end(void* picture, int whole, char* message, size_t message_size) {
    const Message say{message, message_size};
    return guarded(say, [&] { return end(std::unique_ptr<Picture>(static_cast<Picture*>(picture)), whole != 0, say); });
}

SNELL_EXPORT int snell_oiio_api_version(void) { return snell_oiio_version; }
}
