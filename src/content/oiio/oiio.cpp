// The only file of snell that includes OpenImageIO. Loading it brings some 260 shared libraries along, so it is
// a module that is opened when a picture first needs it.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
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

// Colour and alpha only: depth, normals and the like of multi-channel files are left out.
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

// OpenImageIO gives WebP and one kind of TIFF with colours multiplied by alpha whatever is asked for. EXR too, but
// there it is how the format is meant: its values stay.
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
    if (spec.deep) return message(failed, "it is a deep image");
    const SnellOiioShape shape = shape_of(spec, input->format_name());
    void* const pixels = allocate(context, &shape);
    if (!pixels) return message(given_up, "");
    if (!input->read_image(0, 0, 0, shape.channels, type_of(shape.type), pixels)) {
        return message(broken_off, input->geterror());
    }
    if (shape.has_alpha && multiplied(*input)) divide_by_alpha(shape, pixels);
    return message(done, "");
}

int write(const char* path, const char* format, const SnellOiioShape& shape, const void* pixels,
          const Message& message) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) {
        OIIO::geterror();  // names the temporary file: the caller knows better
        return message(failed, std::string("no picture format is known by the extension '") + format + "'");
    }
    const OIIO::TypeDesc type = type_of(shape.type);
    const OIIO::stride_t pixel = static_cast<OIIO::stride_t>(type.size()) * shape.channels;
    SnellOiioShape stored = shape;
    // The WebP writer divides by alpha what was never multiplied: better without.
    if (shape.has_alpha && (!output->supports("alpha") || std::string(output->format_name()) == "webp")) {
        stored.channels = shape.channels - 1;
        stored.has_alpha = 0;
    }
    OIIO::ImageSpec spec = spec_of(stored);
    if (shape.type == snell_oiio_u8 && std::string(output->format_name()) == "openexr")
        spec.set_format(OIIO::TypeDesc::HALF);
    if (!output->open(path, spec)) return message(failed, output->geterror());
    if (!output->write_image(type, pixels, pixel) || !output->close()) return message(failed, output->geterror());
    return message(done, "");
}

int compare(const SnellOiioShape& shape, const void* a, const void* b, double threshold,
            SnellOiioDifference& difference, const Message& message) {
    const OIIO::ImageSpec spec = spec_of(shape);
    const OIIO::ImageBuf first(spec, const_cast<void*>(a)), second(spec, const_cast<void*>(b));
    const auto limit = static_cast<float>(threshold);
    OIIO::geterror();  // an older one is not ours
    const OIIO::ImageBufAlgo::CompareResults result = OIIO::ImageBufAlgo::compare(first, second, limit, limit);
    // `error` says only that the threshold was passed.
    if (OIIO::has_error()) return message(failed, OIIO::geterror());
    difference.mean = result.meanerror;
    difference.rms = result.rms_error;
    difference.psnr = result.PSNR;
    difference.max = result.maxerror;
    difference.over_threshold = result.nfail;
    return message(done, "");
}

// No exception may cross the C interface.
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

SNELL_EXPORT int snell_oiio_write(const char* path, const char* format, const SnellOiioShape* shape, const void* pixels,
                                  char* message, size_t message_size) {
    const Message say{message, message_size};
    return guarded(say, [&] { return write(path, format, *shape, pixels, say); });
}

SNELL_EXPORT int snell_oiio_compare(const SnellOiioShape* shape, const void* a, const void* b, double threshold,
                                    SnellOiioDifference* difference, char* message, size_t message_size) {
    const Message say{message, message_size};
    return guarded(say, [&] { return compare(*shape, a, b, threshold, *difference, say); });
}

SNELL_EXPORT int snell_oiio_api_version(void) { return snell_oiio_version; }
}
