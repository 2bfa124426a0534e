#include "src/runtime/resources/textures.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/content/image/image.h"
#include "src/plan/identity.h"
#include "src/runtime/resources/stopwatch.h"

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

// Mesa's software renderers keep the samples of an anisotropic footprint within one face of a cube map, and wrap them
// around at its edges: dots with errors of up to a quarter of the range (tests/runtime/hard_places.cpp).
Filter usable(Filter filter, bool cube, const gl::Caps& caps) {
    if (cube && caps.software && filter.mode == Filter::Mode::anisotropic) filter.mode = Filter::Mode::mipmap;
    return filter;
}

// How many levels a texture has; how it is filtered and wrapped, samplers say.
gl::Sampling storage(const Texture& declared, const GpuTexture& gpu) {
    gl::Sampling result = sampling(declared.filter, declared.target == TextureTarget::cube);
    if (gpu.mipmapped && !mipmapped(declared.filter)) result.mode = gl::Sampling::Mode::mipmap;
    return result;
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

Textures::Textures(const Scene& scene, Files& files, const gl::Caps& caps, Counters& counters,
                   std::shared_ptr<Store> store, bool savings, Diagnostics& diagnostics)
    : scene_(&scene),
      files_(&files),
      caps_(&caps),
      counters_(&counters),
      store_(std::move(store)),
      savings_(savings),
      diagnostics_(&diagnostics),
      textures_(scene.textures.size()),
      drawn_to_(scene.textures.size(), false) {
    for (const Pass& pass : scene.passes)
        for (const Index texture : pass.textures)
            if (texture < drawn_to_.size()) drawn_to_[texture] = true;
    std::map<std::pair<int, std::string>, std::vector<Index>> candidates;
    for (Index i = 0; i < scene.textures.size(); ++i) {
        const Texture& texture = scene.textures[i];
        same_.push_back(i);
        const bool computed = texture.computed != Computed::no;
        if (!savings || (texture.files.empty() && !computed)) continue;
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
    empty_image_cache();
    faces_.clear();
    preloaded_.clear();
    preloaded_noise_.clear();
    files_ = nullptr;
    diagnostics_ = nullptr;
}

void Textures::empty_image_cache() {
    const ImageCache::Stats stats = images_.stats();
    counters_->images_decoded += stats.images;
    counters_->bytes_decoded += stats.bytes;
    images_.clear();
}

void Textures::resume(Files& files, Diagnostics& diagnostics) {
    files_ = &files;
    diagnostics_ = &diagnostics;
}

const GpuTexture* Textures::find(Index texture) const {
    const GpuTexture* found = texture < textures_.size() ? textures_[same_[texture]].get() : nullptr;
    return found && found->texture ? found : nullptr;
}

bool Textures::asked(Index texture) const {
    const auto reads = [&](Index other) {
        return textures_[same_[other]] &&
               (same_[other] == same_[texture] ||
                (scene_->textures[other].source != none && same_[scene_->textures[other].source] == same_[texture]));
    };
    for (Index other = 0; other < textures_.size(); ++other)
        if (reads(other)) return true;
    return harmonics_.contains(same_[texture]);
}

const GpuTexture* Textures::find_noise(int dimensions) const {
    const auto found = noise_.find(dimensions);
    return found == noise_.end() ? nullptr : found->second.get();
}

const GpuTexture* Textures::realise(Index texture) {
    if (texture >= textures_.size()) return nullptr;
    auto& slot = textures_[same_[texture]];
    if (!slot) slot = take_or_make(same_[texture]);
    return slot->texture ? slot.get() : nullptr;
}

// Where what is said of a texture may point to.
std::vector<Span> Textures::places(Index texture) const {
    const Texture& declared = scene_->textures[texture];
    std::vector<Span> result{declared.span};
    if (declared.computed != Computed::no) result = places(declared.source);
    for (const FileName& file : declared.files) result.push_back(file.span);
    return result;
}

// Empty: it is this runtime's own.
Identity Textures::key_of(Index texture) const {
    const Texture& declared = scene_->textures[texture];
    const bool own = drawn_to_[texture] || (declared.source != none && drawn_to_[declared.source]);
    if (!savings_ || own) return {};
    Identity identity = texture_identity(*scene_, texture, *files_);
    if (!identity.key.empty()) identity.key += mipmapped(declared.filter) ? 'm' : '-';
    return identity;
}

std::shared_ptr<GpuTexture> Textures::take_or_make(Index texture) {
    const Identity identity = key_of(texture);
    const std::vector<Span> at = places(texture);
    if (auto known = store_->textures.take(identity.key, at, *diagnostics_)) {
        for (const std::string& path : identity.files) files_->keep(path);
        counters_->gpu_bytes += known->bytes;
        return known;
    }
    const std::size_t said = diagnostics_->items().size();
    const auto before = preloaded_.find(texture);
    const double read = before == preloaded_.end() ? 0 : before->second.milliseconds;
    const Stopwatch watch;
    auto made = std::make_shared<GpuTexture>(make(texture));
    made->load_ms = read + watch.milliseconds();
    store_->textures.put(identity.key, made, at, *diagnostics_, said);
    if (!savings_) {
        empty_image_cache();
        faces_.clear();
    }
    return made;
}

GpuTexture Textures::make(Index texture) {
    const Texture& declared = scene_->textures[texture];
    const bool cube = declared.target == TextureTarget::cube;
    if (usable(declared.filter, cube, *caps_) != declared.filter)
        diagnostics_->warning("cube-anisotropy", declared.span,
                              "this OpenGL filters cube maps anisotropically with errors at the edges of their faces",
                              "'Filter mipmap' is used instead");
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
    ++counters_->textures;
    counters_->mip_chains += texture.mipmapped ? 1 : 0;
    counters_->gpu_bytes += texture.bytes;
    if (uploaded) counters_->bytes_uploaded += texture.bytes;
}

GpuTexture Textures::make_from_image(const Texture& declared, Index texture) {
    GpuTexture gpu;
    auto preloaded = take_preloaded(texture);
    const content::Image image = preloaded ? std::move(preloaded->image) : read_image(texture, *diagnostics_);
    gpu.size = {image.width, image.height, image.depth};
    if (!fits(declared, gpu.size)) return gpu;
    gpu.target = gl_target(declared.target, *caps_);
    gpu.mipmapped = mipmapped(declared.filter) || !savings_;
    gpu.texture = gl::make_texture(gpu.target, texels(image), storage(declared, gpu));
    gpu.bytes = with_levels(image.bytes(), gpu.mipmapped);
    count(gpu, true);
    return gpu;
}

const content::CubeFaces& Textures::faces(Index texture) {
    const auto [found, fresh] = faces_.try_emplace(same_[texture]);
    if (!fresh) return found->second;
    auto preloaded = take_preloaded(same_[texture]);
    found->second = preloaded ? std::move(preloaded->faces) : read_faces(same_[texture], *diagnostics_);
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
    gpu.mipmapped = mipmapped(declared.filter) || !savings_;
    gpu.texture = gl::make_cube(uploads, storage(declared, gpu));
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
    gpu.mipmapped = mipmapped(declared.filter) || !savings_;
    // Zeros rather than nothing: reading what was never written must not show old memory.
    const gl::Pixels pixels = declared.bits == 16 ? gl::Pixels::rgba16f : gl::Pixels::rgba8;
    const std::size_t bytes = gl::texel_bytes(pixels) * static_cast<std::size_t>(gpu.size[0]) *
                              static_cast<std::size_t>(gpu.size[1]) * static_cast<std::size_t>(gpu.size[2]);
    const std::vector<std::byte> zeros(bytes);
    gl::Texels texels{pixels, gpu.size[0], gpu.size[1], gpu.size[2], zeros.data()};
    if (cube) {
        std::array<gl::Texels, 6> faces;
        faces.fill(texels);
        gpu.texture = gl::make_cube(faces, storage(declared, gpu));
    } else {
        gpu.texture = gl::make_texture(gpu.target, texels, storage(declared, gpu));
    }
    gpu.bytes = with_levels(bytes * (cube ? 6 : 1), gpu.mipmapped);
    count(gpu, false);
    return gpu;
}

const GpuTexture* Textures::noise(int dimensions) {
    auto& slot = noise_[dimensions];
    if (slot) return slot.get();
    const Identity identity = savings_ ? noise_identity(dimensions, noise_size(dimensions), *files_) : Identity{};
    if ((slot = store_->textures.take(identity.key, {}, *diagnostics_))) {
        for (const std::string& path : identity.files) files_->keep(path);
        counters_->gpu_bytes += slot->bytes;
        return slot.get();
    }
    const std::size_t said = diagnostics_->items().size();
    const Stopwatch watch;
    slot = std::make_shared<GpuTexture>(make_noise(dimensions));
    slot->load_ms += watch.milliseconds();
    store_->textures.put(identity.key, slot, {}, *diagnostics_, said);
    return slot.get();
}

GpuTexture Textures::make_noise(int dimensions) {
    GpuTexture gpu;
    content::Image image;
    if (auto found = preloaded_noise_.extract(dimensions); !found.empty()) {
        say_once(found.mapped().said, *diagnostics_);
        image = std::move(found.mapped().image);
        gpu.load_ms = found.mapped().milliseconds;
    } else {
        image = read_noise(dimensions, *diagnostics_);
    }
    gpu.target = dimensions == 3 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
    gpu.size = {image.width, image.height, image.depth};
    gpu.texture = gl::make_texture(gpu.target, texels(image), {});
    gpu.bytes = image.bytes();
    counters_->noise_bytes += gpu.bytes;
    count(gpu, true);
    return gpu;
}

const gl::Black& Textures::nothing(std::string_view sampler) {
    const auto [found, fresh] = black_.try_emplace(sampler);
    if (fresh) found->second = gl::make_black(sampler);
    return found->second;
}

GLuint Textures::sampler(const Filter& filter, bool clamp, bool cube) {
    auto& sampler = samplers_[{static_cast<int>(filter.mode), filter.anisotropy, clamp, cube}];
    if (!sampler) sampler = gl::make_sampler(sampling(usable(filter, cube, *caps_), clamp), cube);
    return sampler.get();
}

}  // namespace snell::runtime
