#include "src/runtime/textures.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/content/image.h"
#include "src/plan/plan.h"

namespace snell::runtime {

namespace {

gl::Sampling sampling(const Filter& filter, bool clamp) {
    gl::Sampling result;
    switch (filter.mode) {
        case Filter::Mode::nearest:
            result.mode = gl::Sampling::Mode::nearest;
            break;
        case Filter::Mode::linear:
            result.mode = gl::Sampling::Mode::linear;
            break;
        case Filter::Mode::mipmap:
            result.mode = gl::Sampling::Mode::mipmap;
            break;
        case Filter::Mode::anisotropic:
            result.mode = gl::Sampling::Mode::anisotropic;
            break;
    }
    result.anisotropy = static_cast<float>(filter.anisotropy);
    result.clamp = clamp;
    return result;
}

bool mipmapped(const Filter& filter) {
    return filter.mode == Filter::Mode::mipmap || filter.mode == Filter::Mode::anisotropic;
}

gl::Pixels pixels(content::PixelType type) {
    switch (type) {
        case content::PixelType::u8:
            return gl::Pixels::rgba8;
        case content::PixelType::f16:
            return gl::Pixels::rgba16f;
        case content::PixelType::f32:
            return gl::Pixels::rgba32f;
    }
    return gl::Pixels::rgba8;
}

gl::Texels texels(const content::Image& rgba) {
    return {pixels(rgba.type), rgba.width, rgba.height, rgba.depth, rgba.pixels.data()};
}

std::array<gl::Texels, 6> face_texels(const content::CubeFaces& faces) {
    std::array<gl::Texels, 6> result;
    for (size_t face = 0; face < 6; ++face) result[face] = texels(faces[face]);
    return result;
}

GLenum gl_target(TextureTarget target, const gl::Caps& caps) {
    switch (target) {
        case TextureTarget::d1:
            return caps.es ? GL_TEXTURE_2D : GL_TEXTURE_1D;
        case TextureTarget::d2:
            return GL_TEXTURE_2D;
        case TextureTarget::d3:
            return GL_TEXTURE_3D;
        case TextureTarget::cube:
            return GL_TEXTURE_CUBE_MAP;
    }
    return GL_TEXTURE_2D;
}

bool same_declaration(const Texture& a, const Texture& b) {
    return a.target == b.target && a.computed == b.computed && a.filter == b.filter && a.size == b.size &&
           a.source == b.source && std::ranges::equal(a.files, b.files, {}, &FileName::name, &FileName::name);
}

// With mipmaps the levels below add a third.
std::size_t with_levels(std::size_t bytes, bool levels) { return levels ? bytes * 4 / 3 : bytes; }

}  // namespace

Textures::Textures(const Scene& scene, Files& files, const gl::Caps& caps, Diagnostics& diagnostics)
    : scene_(&scene), files_(&files), caps_(&caps), diagnostics_(&diagnostics), textures_(scene.textures.size()) {
    std::map<std::pair<int, std::string>, std::vector<Index>> candidates;
    for (Index i = 0; i < scene.textures.size(); ++i) {
        const Texture& texture = scene.textures[i];
        same_.push_back(i);
        const bool computed = texture.computed != Computed::no;
        if (texture.files.empty() && !computed) continue;
        auto& others = candidates[{static_cast<int>(texture.target), computed ? "" : texture.files[0].name}];
        const auto twin =
            std::ranges::find_if(others, [&](Index other) { return same_declaration(scene.textures[other], texture); });
        if (twin != others.end())
            same_[i] = *twin;
        else
            others.push_back(i);
    }
}

void Textures::finish() {
    const ImageCache::Stats stats = images_.stats();
    counters_.decoded += stats.images;
    counters_.bytes_decoded += stats.bytes;
    images_.clear();
    faces_.clear();
    files_ = nullptr;
    diagnostics_ = nullptr;
}

void Textures::resume(Files& files, Diagnostics& diagnostics) {
    files_ = &files;
    diagnostics_ = &diagnostics;
}

const GpuTexture* Textures::find(Index texture) const {
    const GpuTexture* found = texture < textures_.size() ? textures_[same_[texture]].get() : nullptr;
    return found && found->texture ? found : nullptr;
}

const GpuTexture* Textures::realise(Index texture) {
    if (texture >= textures_.size()) return nullptr;
    auto& slot = textures_[same_[texture]];
    if (!slot) slot = std::make_unique<GpuTexture>(make(same_[texture]));
    return slot->texture ? slot.get() : nullptr;
}

GpuTexture Textures::make(Index texture) {
    const Texture& declared = scene_->textures[texture];
    if (declared.computed != Computed::no) return make_computed(declared);
    if (declared.files.empty()) return make_empty(declared);
    return declared.target == TextureTarget::cube ? make_cube(declared, texture) : make_from_image(declared, texture);
}

bool Textures::fits(const Texture& declared, std::array<int, 3> size) {
    int limit = caps_->max_texture;
    if (declared.target == TextureTarget::d3) limit = caps_->max_texture_3d;
    if (declared.target == TextureTarget::cube) limit = caps_->max_cube;
    const int largest = std::ranges::max(size);
    if (largest <= limit) return true;
    diagnostics_->error(
        "texture-too-large", declared.span,
        fmt::format("a texture of {} texels a side is more than this OpenGL takes ({})", largest, limit),
        "make the image smaller");
    return false;
}

void Textures::count(const GpuTexture& texture, bool uploaded) {
    ++counters_.textures;
    counters_.gpu_bytes += texture.bytes;
    if (uploaded) counters_.bytes_uploaded += texture.bytes;
}

GpuTexture Textures::make_from_image(const Texture& declared, Index texture) {
    GpuTexture gpu;
    content::Image image = content::to_rgba(load_texture(*scene_, texture, *files_, *diagnostics_, &images_));
    if (declared.target == TextureTarget::d1) image.height = image.depth = 1;  // the first row given
    if (!image.bottom_first) image = content::flipped(image);
    gpu.size = {image.width, image.height, image.depth};
    if (!fits(declared, gpu.size)) return gpu;
    gpu.target = gl_target(declared.target, *caps_);
    gpu.mipmapped = mipmapped(declared.filter);
    gpu.texture = gl::make_texture(gpu.target, texels(image), sampling(declared.filter, false));
    gpu.bytes = with_levels(image.bytes(), gpu.mipmapped);
    count(gpu, true);
    return gpu;
}

// As they are uploaded: four channels, the top row first.
const content::CubeFaces& Textures::faces(Index texture) {
    const auto [found, fresh] = faces_.try_emplace(same_[texture]);
    if (!fresh) return found->second;
    found->second = load_cube(*scene_, same_[texture], *files_, *diagnostics_, &images_);
    for (content::Image& face : found->second) {
        face = content::to_rgba(face);
        if (face.bottom_first) face = content::flipped(face);
    }
    return found->second;
}

GpuTexture Textures::make_cube(const Texture& declared, Index texture) {
    GpuTexture gpu;
    const content::CubeFaces& all = faces(texture);
    const auto uploads = face_texels(all);
    std::size_t bytes = 0;
    for (const content::Image& face : all) bytes += face.bytes();
    gpu.size = {all[0].width, all[0].height, 1};
    if (!fits(declared, gpu.size)) return gpu;
    gpu.target = GL_TEXTURE_CUBE_MAP;
    gpu.mipmapped = mipmapped(declared.filter);
    gpu.texture = gl::make_cube(uploads, sampling(declared.filter, true));
    gpu.bytes = with_levels(bytes, gpu.mipmapped);
    count(gpu, true);
    return gpu;
}

GpuTexture Textures::make_empty(const Texture& declared) {
    GpuTexture gpu;
    const int width = std::max(1, declared.size[0]);
    const bool cube = declared.target == TextureTarget::cube;
    gpu.size = {width, cube ? width : std::max(1, declared.size[1]), std::max(1, declared.size[2])};
    if (declared.target == TextureTarget::d1) gpu.size[1] = 1;
    if (declared.target != TextureTarget::d3) gpu.size[2] = 1;
    if (!fits(declared, gpu.size)) return gpu;
    gpu.target = gl_target(declared.target, *caps_);
    gpu.mipmapped = mipmapped(declared.filter);
    // Zeros rather than nothing: reading what was never written must not show old memory.
    const std::size_t bytes = 4 * static_cast<std::size_t>(gpu.size[0]) * static_cast<std::size_t>(gpu.size[1]) *
                              static_cast<std::size_t>(gpu.size[2]);
    const std::vector<std::byte> zeros(bytes);
    gl::Texels texels{gl::Pixels::rgba8, gpu.size[0], gpu.size[1], gpu.size[2], zeros.data()};
    if (cube) {
        std::array<gl::Texels, 6> faces;
        faces.fill(texels);
        gpu.texture = gl::make_cube(faces, sampling(declared.filter, true));
    } else {
        gpu.texture = gl::make_texture(gpu.target, texels, sampling(declared.filter, false));
    }
    gpu.bytes = with_levels(bytes * (cube ? 6 : 1), gpu.mipmapped);
    count(gpu, false);
    return gpu;
}

const GpuTexture* Textures::noise(int dimensions) {
    auto found = noise_.find(dimensions);
    if (found == noise_.end()) {
        const int size = dimensions == 3 ? scene_->noise3d : scene_->noise2d;
        content::Image image = content::to_rgba(load_noise(dimensions, size, *files_, *diagnostics_));
        if (!image.bottom_first) image = content::flipped(image);
        GpuTexture gpu;
        gpu.target = dimensions == 3 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
        gpu.size = {image.width, image.height, image.depth};
        gpu.texture = gl::make_texture(gpu.target, texels(image), {});
        gpu.bytes = image.bytes();
        count(gpu, true);
        found = noise_.emplace(dimensions, std::move(gpu)).first;
    }
    return &found->second;
}

GLuint Textures::sampler(const Filter& filter, bool clamp, bool cube) {
    auto& sampler = samplers_[{static_cast<int>(filter.mode), filter.anisotropy, clamp, cube}];
    if (!sampler) sampler = gl::make_sampler(sampling(filter, clamp), cube);
    return sampler.get();
}

}  // namespace snell::runtime
