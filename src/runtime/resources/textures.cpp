#include "src/runtime/resources/textures.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/content/image/image.h"
#include "src/content/image/noise.h"
#include "src/content/workers.h"

namespace snell::runtime {

namespace {

constexpr auto between_looks = std::chrono::milliseconds(50);

// Records which jobs are done, and wakes the thread that waits for them.
class Board {
public:
    explicit Board(const std::vector<Job>& jobs) : jobs_(jobs), done_(jobs.size(), false) {}

    // Does jobs until none is left. Any number of threads may call it.
    void work() {
        for (std::size_t i = next_++; i < jobs_.size(); i = next_++) {
            jobs_[i].work();
            const std::scoped_lock lock(mutex_);
            done_[i] = true;
            ++count_;
            change_.notify_one();
        }
    }

    void watch(const Watcher& watcher) {
        std::size_t told = 0;
        std::unique_lock lock(mutex_);
        while (true) {
            // The first one is told even if all are done by now, as on a busy machine.
            const auto first = told == 0 ? done_.begin() : ranges::find(done_, false);
            const std::string_view name =
                first == done_.end() ? ""
                                     : std::string_view(jobs_[static_cast<std::size_t>(first - done_.begin())].name);
            lock.unlock();
            watcher({LoadProgress::Stage::files, name, told, jobs_.size()});
            lock.lock();
            if (told == jobs_.size()) return;
            change_.wait_for(lock, between_looks, [&] { return count_ > told; });
            if (count_ > told) ++told;
        }
    }

private:
    const std::vector<Job>& jobs_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;
    std::condition_variable change_;
    std::vector<bool> done_;
    std::size_t count_ = 0;
};

void work_alone(const std::vector<Job>& jobs, const Watcher& watcher) {
    for (std::size_t done = 0; done < jobs.size(); ++done) {
        watcher({LoadProgress::Stage::files, jobs[done].name, done, jobs.size()});
        jobs[done].work();
    }
    watcher({LoadProgress::Stage::files, "", jobs.size(), jobs.size()});
}

}  // namespace

void say_once(const Diagnostics& said, Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : said.items())
        if (ranges::none_of(diagnostics.items(),
                            [&](const Diagnostic& other) { return other.is_at(diagnostic.code, diagnostic.span); }))
            diagnostics.add(diagnostic);
}

void run(const std::vector<Job>& jobs, const Watcher& watcher) {
    if (jobs.empty()) {
        if (watcher) watcher({LoadProgress::Stage::files, "", 0, 0});
        return;
    }
    Board board(jobs);
    const std::size_t count = std::min(content::cores(), jobs.size());
    // The thread that reports progress does no jobs, unless no other thread could be started.
    content::work_beside(
        watcher ? count : count - 1, [&] { board.work(); },
        [&](std::size_t started) {
            if (!watcher)
                board.work();
            else if (started > 0)
                board.watch(watcher);
            else
                work_alone(jobs, watcher);
        });
}

void TextureReader::read(const PictureKey& key, ReadPicture& into) {
    const Stopwatch watch;
    if (key.noise != 0)
        into.image = load_noise(key.noise, noise_size(key.noise), *files_, into.said,
                                scene_->noise_spans[key.noise == 3 ? 1 : 0]);
    else if (scene_->textures[key.texture].target == TextureTarget::cube)
        into.faces = load_cube(*scene_, key.texture, *files_, into.said, &images_);
    else
        into.image = load_texture(*scene_, key.texture, *files_, into.said, &images_);
    into.milliseconds = watch.milliseconds();
}

void TextureReader::preload(const PictureKey& key, std::vector<Job>& jobs) {
    const auto [into, fresh] = preloaded_.try_emplace(key);
    if (!fresh) return;
    const std::string name = key.noise != 0 ? content::noise_file_name(key.noise, noise_size(key.noise))
                                            : scene_->textures[key.texture].files[0].name;
    jobs.push_back({name, [this, key, picture = &into->second] { read(key, *picture); }});
}

ReadPicture TextureReader::take(const PictureKey& key, Diagnostics& diagnostics) {
    auto found = preloaded_.extract(key);
    ReadPicture picture;
    if (found.empty())
        read(key, picture);
    else
        picture = std::move(found.mapped());
    say_once(picture.said, diagnostics);
    return picture;
}

double TextureReader::milliseconds(const PictureKey& key) const {
    const auto found = preloaded_.find(key);
    return found == preloaded_.end() ? 0 : found->second.milliseconds;
}

const content::CubeFaces& TextureReader::faces(Index texture, Diagnostics& diagnostics) {
    const auto [found, fresh] = faces_.try_emplace(texture);
    if (fresh) found->second = take({texture}, diagnostics).faces;
    return found->second;
}

ImageCache::Stats TextureReader::forget() {
    const ImageCache::Stats stats = images_.stats();
    images_.clear();
    preloaded_.clear();
    faces_.clear();
    return stats;
}

namespace {

gl::Sampling sampling(const Filter& filter, bool clamp) {
    using Mode = gl::Sampling::Mode;
    constexpr std::array modes{Mode::nearest, Mode::linear, Mode::mipmap, Mode::anisotropic};  // as Filter::Mode
    return {modes[static_cast<std::size_t>(filter.mode)], static_cast<float>(filter.anisotropy), clamp};
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

// The texture itself only needs the right number of levels; sampler objects decide about filters and wrapping.
gl::Sampling storage(const Texture& declared, const GpuTexture& gpu) {
    gl::Sampling result = sampling(declared.filter, declared.target == TextureTarget::cube);
    if (gpu.mipmapped && !mipmapped(declared.filter)) result.mode = gl::Sampling::Mode::mipmap;
    return result;
}

gl::Pixels pixels(const content::Image& image) {
    if (image.srgb && image.type == content::PixelType::u8) return gl::Pixels::srgb8;
    constexpr std::array types{gl::Pixels::rgba8, gl::Pixels::rgba16f, gl::Pixels::rgba32f};  // as content::PixelType
    return types[static_cast<std::size_t>(image.type)];
}

gl::Texels texels(const content::Image& rgba) {
    return {pixels(rgba), rgba.width, rgba.height, rgba.depth, rgba.pixels.data()};
}

std::array<gl::Texels, 6> face_texels(const content::CubeFaces& faces) {
    std::array<gl::Texels, 6> result;
    for (size_t face = 0; face < 6; ++face) result[face] = texels(faces[face]);
    return result;
}

GLenum gl_target(TextureTarget target, const gl::Caps& caps) {
    if (target == TextureTarget::d1 && caps.es) return GL_TEXTURE_2D;
    constexpr std::array targets{GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};  // as TextureTarget
    return static_cast<GLenum>(targets[static_cast<std::size_t>(target)]);
}

bool same_declaration(const Texture& a, const Texture& b) {
    return a.target == b.target && a.computed == b.computed && a.filter == b.filter && a.size == b.size &&
           a.source == b.source && (a.encoding == Encoding::srgb) == (b.encoding == Encoding::srgb) &&
           ranges::equal(a.files, b.files, {}, &FileName::name, &FileName::name);
}

// The smaller levels add a third.
std::size_t with_levels(std::size_t bytes, bool levels) { return levels ? bytes * 4 / 3 : bytes; }

// A map of a file is computed once, but a map of something drawn perhaps for every frame.
constexpr int largest_by_default = 128, largest_drawn_by_default = 64;

CubeLevels levels_of(const std::vector<content::CubeLight>& lights) {
    CubeLevels result;
    for (const content::CubeLight& light : lights) result.faces.push_back(content::half_faces(light));
    for (const content::CubeFaces& faces : result.faces) {
        auto& level = result.texels.emplace_back();
        for (std::size_t face = 0; face < 6; ++face) {
            level[face] = {gl::Pixels::rgba16f, faces[face].width, faces[face].height, 1, faces[face].pixels.data()};
            result.bytes += faces[face].bytes();
        }
    }
    return result;
}

content::CubeLight black(int size) {
    content::CubeLight light;
    light.size = size;
    light.texels.resize(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    return light;
}

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
      reader_(scene, files),
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
            ranges::find_if(others, [&](Index other) { return same_declaration(scene.textures[other], texture); });
        if (twin != others.end())
            same_[i] = *twin;
        else
            others.push_back(i);
    }
}

void Textures::preload(const std::vector<Index>& wanted, const std::set<int>& noise, std::vector<Job>& jobs) {
    for (const int dimensions : noise) {
        const Identity identity = noise_identity(dimensions, reader_.noise_size(dimensions), *files_);
        if (!find_noise(dimensions) && !store_->textures.has(identity.key)) reader_.preload({none, dimensions}, jobs);
    }
    std::set<Index> textures;
    for (const Index index : wanted) {
        Index texture = same_[index];
        if (const Index source = scene_->textures[texture].source; source != none) {
            if (textures_[texture] || store_->textures.has(key_of(texture).key)) continue;
            texture = same_[source];  // what it is computed from
        }
        if (textures_[texture] || scene_->textures[texture].files.empty()) continue;
        if (!store_->textures.has(key_of(texture).key)) textures.insert(texture);
    }
    for (const Index texture : textures) reader_.preload({texture}, jobs);
}

void Textures::finish() {
    forget_pictures();
    diagnostics_ = nullptr;
}

void Textures::forget_pictures() {
    const ImageCache::Stats stats = reader_.forget();
    counters_->images_decoded += stats.images;
    counters_->bytes_decoded += stats.bytes;
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
    const Index first = same_[texture];
    auto& slot = textures_[first];
    if (!slot) {
        const double read = reader_.milliseconds({first});
        slot = take_or_make(
            key_of(first), places(first), [&] { return make(first); }, read);
    }
    return slot->texture ? slot.get() : nullptr;
}

// Returns the places that messages about the texture may point to.
std::vector<Span> Textures::places(Index texture) const {
    const Texture& declared = scene_->textures[texture];
    std::vector<Span> result{declared.span};
    if (declared.computed != Computed::no) result = places(declared.source);
    for (const FileName& file : declared.files) result.push_back(file.span);
    return result;
}

// Returns an empty key if the texture belongs to this runtime alone.
Identity Textures::key_of(Index texture) const {
    const Texture& declared = scene_->textures[texture];
    const bool own = drawn_to_[texture] || (declared.source != none && drawn_to_[declared.source]);
    if (!savings_ || own) return {};
    Identity identity = texture_identity(*scene_, texture, *files_);
    if (!identity.key.empty()) identity.key += mipmapped(declared.filter) ? 'm' : '-';
    return identity;
}

template <class Make>
std::shared_ptr<GpuTexture> Textures::take_or_make(const Identity& identity, const std::vector<Span>& at,
                                                   const Make& make, double read_ms) {
    if (auto known = store_->textures.take(identity.key, at, *diagnostics_)) {
        for (const std::string& path : identity.files) files_->keep(path);
        counters_->gpu_bytes += known->bytes;
        return known;
    }
    const std::size_t said = diagnostics_->items().size();
    const Stopwatch watch;
    auto made = std::make_shared<GpuTexture>(make());
    made->load_ms = read_ms + watch.milliseconds();
    store_->textures.put(identity.key, made, at, *diagnostics_, said);
    if (!savings_) forget_pictures();
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
    const int largest = ranges::max(size);
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
    const content::Image image = reader_.take({texture}, *diagnostics_).image;
    gpu.size = {image.width, image.height, image.depth};
    if (!fits(declared, gpu.size)) return gpu;
    gpu.target = gl_target(declared.target, *caps_);
    gpu.pixels = pixels(image);
    gpu.mipmapped = mipmapped(declared.filter) || !savings_;
    gpu.texture = gl::make_texture(gpu.target, texels(image), storage(declared, gpu));
    gpu.bytes = with_levels(image.bytes(), gpu.mipmapped);
    count(gpu, true);
    return gpu;
}

GpuTexture Textures::make_cube(const Texture& declared, Index texture) {
    GpuTexture gpu;
    const content::CubeFaces& all = reader_.faces(texture, *diagnostics_);
    const auto uploads = face_texels(all);
    std::size_t bytes = 0;
    for (const content::Image& face : all) bytes += face.bytes();
    gpu.size = {all[0].width, all[0].height, 1};
    if (!fits(declared, gpu.size)) return gpu;
    gpu.target = GL_TEXTURE_CUBE_MAP;
    gpu.pixels = pixels(all[0]);
    gpu.mipmapped = mipmapped(declared.filter) || !savings_;
    gpu.texture = gl::make_texture(GL_TEXTURE_CUBE_MAP, uploads, storage(declared, gpu));
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
    // The texels are set to zero, because texels that were never written would show old memory.
    gpu.pixels = declared.bits == 16 ? gl::Pixels::rgba16f : gl::Pixels::rgba8;
    const std::size_t bytes = gl::texel_bytes(gpu.pixels) * static_cast<std::size_t>(gpu.size[0]) *
                              static_cast<std::size_t>(gpu.size[1]) * static_cast<std::size_t>(gpu.size[2]);
    const std::vector<std::byte> zeros(bytes);
    const std::vector<gl::Texels> images(cube ? 6 : 1,
                                         {gpu.pixels, gpu.size[0], gpu.size[1], gpu.size[2], zeros.data()});
    gpu.texture = gl::make_texture(gpu.target, images, storage(declared, gpu));
    gpu.bytes = with_levels(bytes * (cube ? 6 : 1), gpu.mipmapped);
    count(gpu, false);
    return gpu;
}

GpuTexture Textures::make_computed(const Texture& declared) {
    GpuTexture gpu;
    const Texture& source = scene_->textures[declared.source];
    CubeLevels levels;
    if (source.files.empty()) {  // black until something is drawn there
        levels = black_levels(declared.computed, computed_size(*scene_, declared, std::max(1, source.size[0])));
    } else {
        const auto light = content::cube_light(reader_.faces(same_[declared.source], *diagnostics_));
        levels = computed_levels(declared.computed, light, computed_size(*scene_, declared, light.size));
        ++counters_->convolutions;
    }
    gpu.size = {levels.size(), levels.size(), 1};
    if (!fits(declared, gpu.size)) return gpu;
    gpu.target = GL_TEXTURE_CUBE_MAP;
    gpu.pixels = levels.texels[0][0].type;
    gpu.levels = static_cast<int>(levels.texels.size());
    gpu.texture = gl::make_cube_levels(levels.texels);
    gpu.bytes = levels.bytes;
    count(gpu, true);
    return gpu;
}

const GpuTexture* Textures::noise(int dimensions) {
    auto& slot = noise_[dimensions];
    if (slot) return slot.get();
    Identity identity;
    if (savings_) identity = noise_identity(dimensions, reader_.noise_size(dimensions), *files_);
    const double read = reader_.milliseconds({none, dimensions});
    slot = take_or_make(
        identity, {}, [&] { return make_noise(dimensions); }, read);
    return slot.get();
}

GpuTexture Textures::make_noise(int dimensions) {
    GpuTexture gpu;
    const content::Image image = reader_.take({none, dimensions}, *diagnostics_).image;
    gpu.target = dimensions == 3 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
    gpu.size = {image.width, image.height, image.depth};
    gpu.pixels = pixels(image);
    gpu.texture = gl::make_texture(gpu.target, texels(image), {});
    gpu.bytes = image.bytes();
    counters_->noise_bytes += gpu.bytes;
    count(gpu, true);
    return gpu;
}

const content::Harmonics* Textures::harmonics(Index texture) {
    const Index source = same_[texture];
    auto& harmonics = harmonics_[source];
    if (harmonics) return harmonics.get();
    Identity identity;
    if (savings_ && !drawn_to_[source]) identity = texture_identity(*scene_, source, *files_);
    if (!identity.key.empty()) identity.key += 'h';
    const std::vector<Span> at = places(source);
    if ((harmonics = store_->harmonics.take(identity.key, at, *diagnostics_))) {
        for (const std::string& path : identity.files) files_->keep(path);
        return harmonics.get();
    }
    const std::size_t said = diagnostics_->items().size();
    harmonics = std::make_shared<content::Harmonics>();
    if (!scene_->textures[source].files.empty()) {
        *harmonics = content::harmonics(content::cube_light(reader_.faces(source, *diagnostics_)));
        ++counters_->convolutions;
    }
    store_->harmonics.put(identity.key, harmonics, at, *diagnostics_, said);
    return harmonics.get();
}

void Textures::refresh(Index source) {
    const GpuTexture* cube = find(source);
    if (!cube) return;
    std::optional<content::CubeLight> light;
    const auto now = [&]() -> const content::CubeLight& {
        if (!light) light = read_light(cube->texture.get(), cube->size[0]);
        return *light;
    };
    for (Index i = 0; i < textures_.size(); ++i) {
        const Texture& declared = scene_->textures[i];
        if (declared.computed == Computed::no || declared.source != source || !textures_[i] || !textures_[i]->texture)
            continue;
        const int size = computed_size(*scene_, declared, now().size);
        const CubeLevels levels = computed_levels(declared.computed, now(), size);
        gl::replace_cube_levels(textures_[i]->texture.get(), levels.texels);
        counters_->bytes_uploaded += levels.bytes;
        ++counters_->convolutions;
    }
    if (const auto found = harmonics_.find(source); found != harmonics_.end()) {
        *found->second = content::harmonics(now());
        ++counters_->convolutions;
    }
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

content::CubeLight read_light(GLuint cube, int size) {
    auto rows = gl::read_cube(cube, size);
    content::CubeFaces faces;
    for (std::size_t face = 0; face < 6; ++face) {
        faces[face].width = faces[face].height = size;
        faces[face].pixels = std::move(rows[face]);
    }
    return content::cube_light(faces);
}

int computed_size(const Scene& scene, const Texture& declared, int source_size) {
    if (declared.size[0] > 0) return declared.size[0];
    const bool drawn = scene.textures[declared.source].files.empty();
    return content::prefilter_size(source_size, drawn ? largest_drawn_by_default : largest_by_default);
}

CubeLevels computed_levels(Computed computed, const content::CubeLight& light, int size) {
    if (computed == Computed::irradiance) return levels_of({content::irradiance(light, size)});
    return levels_of(content::prefiltered(light, size));
}

CubeLevels black_levels(Computed computed, int size) {
    std::vector<content::CubeLight> lights;
    const int levels = computed == Computed::irradiance ? 1 : content::prefilter_levels(size);
    for (int level = 0; level < levels; ++level) lights.push_back(black(size >> level));
    return levels_of(lights);
}

}  // namespace snell::runtime
