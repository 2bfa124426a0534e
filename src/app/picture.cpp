#include "src/app/picture.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace snell::app {

namespace {

template <class Channel>
content::Image opaque_picture(const std::vector<Channel>& rgba, const gl::Target& target) {
    content::Image image;
    image.width = target.width;
    image.height = target.height;
    image.channels = 3;
    image.type = sizeof(Channel) == 1 ? content::PixelType::u8 : content::PixelType::f32;
    image.pixels.resize(rgba.size() / 4 * 3 * sizeof(Channel));
    for (size_t i = 0; i < rgba.size() / 4; ++i)
        std::memcpy(&image.pixels[i * 3 * sizeof(Channel)], &rgba[i * 4], 3 * sizeof(Channel));
    return image;
}

}  // namespace

bool holds_floats(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
    return extension == ".exr" || extension == ".hdr" || extension == ".pfm";
}

content::Image read_picture(const gl::Target& target, bool floats) {
    const unsigned framebuffer = target.framebuffer.get();
    if (floats)
        return opaque_picture(gl::read_rgba32f(framebuffer, target.width, target.height, target.samples), target);
    return opaque_picture(gl::read_rgba8(framebuffer, target.width, target.height, target.samples), target);
}

}  // namespace snell::app
