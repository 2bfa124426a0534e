#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/content/cube/convolve.h"
#include "src/content/image/noise.h"
#include "src/content/workers.h"
#include "src/plan/locate.h"
#include "src/plan/plan.h"

namespace snell {
namespace {

using content::CubeFaces;
using content::Image;
using content::ImageIssue;
using content::PixelType;

// Reports an issue of a loader at the place in the scene that names the file.
template <class Issue>
void report(const Issue& issue, std::string_view name, const Span& span, Diagnostics& diagnostics,
            Severity harmless = Severity::warning) {
    std::string message = name.empty() ? issue.message : fmt::format("'{}': {}", name, issue.message);
    diagnostics.add(
        {issue.error ? Severity::error : harmless, issue.code, span, std::move(message), issue.help, {}, true});
}

content::MeshLimits mesh_limits(const Files& files) {
    const Limits& limits = files.limits();
    return {limits.vertices, limits.file_bytes, limits.sub_quads};
}

content::ImageLimits image_limits(const Files& files) {
    return {static_cast<int>(files.limits().texture_side), files.limits().texture_bytes};
}

content::MeshResult read_mesh(const FileName& file, const MeshRequest& request, Files& files,
                              Diagnostics& diagnostics) {
    content::MeshResult result;
    const std::string path = locate(file, mesh_extensions(request.shape), files, diagnostics);
    if (path.empty()) return result;
    std::string reason;
    const std::optional<std::string> bytes = files.read(path, reason);
    if (!bytes) {
        report_unreadable(file, reason, diagnostics);
        return result;
    }
    const auto* obj = std::get_if<ObjFile>(&request.shape);
    const content::MeshLimits limits = mesh_limits(files);
    return obj != nullptr ? content::parse_obj(*bytes, obj->as, request.wire, limits)
                          : content::parse_shp(*bytes, limits);
}

using Picture = std::shared_ptr<const ImageCache::Entry>;

Picture decode(const std::string& path, Files& files, ImageCache& cache) {
    std::shared_ptr<ImageCache::Entry> entry = cache.entry(path);
    std::call_once(entry->once, [&] {
        std::string reason;
        if (const std::optional<std::string> bytes = files.read(path, reason)) {
            entry->result = content::decode_image(path, *bytes, image_limits(files));
        } else {
            entry->unreadable = reason.empty() ? "unknown reason" : reason;
        }
    });
    return entry;
}

// Returns the decoded image; returns null and reports an error if there is none.
const Image* usable(const Picture& picture, const TextureFile& file, Diagnostics& diagnostics) {
    if (!picture) return nullptr;  // the missing file has been reported
    if (!picture->unreadable.empty()) {
        report_unreadable({file.name, file.span}, picture->unreadable, diagnostics);
        return nullptr;
    }
    for (const ImageIssue& issue : picture->result.issues) report(issue, file.name, file.span, diagnostics);
    return picture->result.image ? &*picture->result.image : nullptr;
}

// The image as the texture's statement says that it is encoded.
Image declared(Image image, const Texture& texture, const TextureFile& file, Diagnostics& diagnostics) {
    image.srgb = texture.encoding == Encoding::srgb;
    if (!image.srgb || !image.light) return image;
    image.srgb = false;
    diagnostics.warning("light-already", file.span,
                        fmt::format("'{}' holds light, which is not encoded: it is read as it is", file.name),
                        "leave out srgb");
    return image;
}

// Returns `count` rows of the first slice, from row `first` on, in memory order.
Image some_rows(const Image& image, int first, int count) {
    Image part = image;
    part.height = count;
    part.depth = 1;
    const auto begin = image.pixels.begin() + static_cast<std::ptrdiff_t>(image.row_bytes()) * first;
    part.pixels.assign(begin, begin + static_cast<std::ptrdiff_t>(image.row_bytes()) * count);
    return part;
}

// An image with more dimensions than its texture is cut to its bottom row or its first slice, with a warning.
Image fitted(const Image& image, const Texture& texture, const TextureFile& file, Diagnostics& diagnostics) {
    const bool too_tall = texture.target == TextureTarget::d1 && image.height > 1;
    const bool too_deep = texture.target != TextureTarget::d3 && image.depth > 1;
    if (!too_tall && !too_deep) return image;
    diagnostics.warning(
        "image-cut", file.span,
        fmt::format("'{}' has {} x {} x {} pixels, but the texture has fewer dimensions; only its {} is used",
                    file.name, image.width, image.height, image.depth, too_tall ? "bottom row" : "first slice"));
    if (!too_tall) return some_rows(image, 0, image.height);
    return some_rows(image, image.bottom_first ? 0 : image.height - 1, 1);
}

// Four channels, and the row order of textures.
Image to_upload(Image image) {
    image = content::to_rgba(std::move(image));
    return image.bottom_first ? image : content::flipped(std::move(image));
}

// ---- cube maps -------------------------------------------------------------------------------------------

// Converts the faces to one format, because GL requires that all six have the same, with the top row first.
void make_alike(CubeFaces& faces) {
    const bool same_type = ranges::all_of(faces, [&](const Image& face) { return face.type == faces[0].type; });
    for (Image& face : faces) {
        face = content::to_rgba(std::move(face));
        if (!same_type || (face.srgb && face.type != PixelType::u8)) face = content::to_half(face);
        if (face.bottom_first) face = content::flipped(std::move(face));
    }
}

CubeFaces all_checks(int side) {
    CubeFaces faces;
    faces.fill(content::checkerboard(side));
    return faces;
}

// Reduces the faces to the size and the bits that were asked for, if the files have more.
void refit(CubeFaces& faces, const Texture& texture) {
    // Bytes are too coarse for light that is not encoded.
    const bool bytes = (faces[0].type == PixelType::u8 || texture.bits == 8) && texture.encoding != Encoding::srgb;
    if (texture.size[0] > 0 && texture.size[0] < faces[0].width)
        faces = content::half_faces(content::resized(content::cube_light(faces), texture.size[0]));
    if (bytes)
        for (Image& face : faces)
            if (face.type != PixelType::u8) face = content::to_bytes(face);
}

constexpr int check_side = 64;

CubeFaces six_faces(const Texture& texture, const std::vector<TextureFile>& files, const std::vector<Picture>& pictures,
                    Diagnostics& diagnostics) {
    content::FacePictures found{};
    std::array<std::string, 6> names;
    for (std::size_t i = 0; i < 6; ++i) {
        found[i] = usable(pictures[i], files[i], diagnostics);
        names[i] = files[i].name;
    }
    for (const ImageIssue& issue : content::check_faces(found, names)) report(issue, {}, texture.span, diagnostics);
    const int side = content::common_side(found);
    CubeFaces faces;
    for (std::size_t i = 0; i < 6; ++i) {
        const bool fits = found[i] && found[i]->width == side && found[i]->height == side && found[i]->depth == 1;
        faces[i] = fits ? declared(*found[i], texture, files[i], diagnostics)
                        : content::checkerboard(side > 0 ? side : check_side);
    }
    return faces;
}

CubeFaces one_file(const Texture& texture, const TextureFile& file, const Picture& picture, Diagnostics& diagnostics) {
    const Image* image = usable(picture, file, diagnostics);
    if (image == nullptr) return all_checks(check_side);
    const std::optional<content::CubeLayout> layout = content::detect_layout(image->width, image->height);
    if (!layout || image->depth != 1) {
        diagnostics.error(
            "cube-layout", file.span,
            fmt::format("'{}' with {} x {} pixels is not a cube map", file.name, image->width, image->height),
            "use a panorama (2:1), a cross (4:3 or 3:4), a strip (6:1 or 1:6) or six files");
        return all_checks(check_side);
    }
    return content::split_cube(declared(*image, texture, file, diagnostics), *layout);
}

}  // namespace

std::shared_ptr<ImageCache::Entry> ImageCache::entry(const std::string& path) {
    const std::scoped_lock lock(mutex_);
    std::shared_ptr<Entry>& entry = entries_[path];
    if (!entry) entry = std::make_shared<Entry>();
    return entry;
}

ImageCache::Stats ImageCache::stats() const {
    const std::lock_guard lock(mutex_);
    Stats stats;
    for (const auto& [path, entry] : entries_)
        if (entry->result.image) {
            ++stats.images;
            stats.bytes += entry->result.image->bytes();
        }
    return stats;
}

void ImageCache::clear() {
    const std::scoped_lock lock(mutex_);
    entries_.clear();
}

content::Mesh load_mesh(const Plan& plan, Index mesh, Files& files, Diagnostics& diagnostics) {
    if (mesh >= plan.meshes.size()) return {};
    const MeshRequest& request = plan.meshes[mesh];
    const Scene& scene = plan.scene;
    content::MeshResult result;
    std::string name;
    Span span = request.span;
    if (const Index file = file_of(request.shape); file < scene.files.size()) {
        name = scene.files[file].name;
        span = scene.files[file].span;
        result = read_mesh(scene.files[file], request, files, diagnostics);
    } else if (const auto* list = std::get_if<VertexList>(&request.shape)) {
        if (list->list < scene.vertex_lists.size()) result = content::make_vertex_list(scene.vertex_lists[list->list]);
    } else if (file == none) {
        result = content::make_shape(request.shape, request.wire, mesh_limits(files));
    }
    for (const content::MeshIssue& issue : result.issues)
        report(issue, name, span, diagnostics, issue.note ? Severity::note : Severity::warning);
    return std::move(result.mesh);
}

Image load_texture(const Scene& scene, Index index, Files& files, Diagnostics& diagnostics, ImageCache* cache) {
    if (index >= scene.textures.size() || scene.textures[index].files.empty())
        return to_upload(content::checkerboard());
    const Texture& texture = scene.textures[index];
    ImageCache own;
    const TextureFile file = locate_texture(texture, files, diagnostics).at(0);
    if (file.noise > 0) return to_upload(content::make_noise(texture.target == TextureTarget::d3 ? 3 : 2, file.noise));
    const Picture picture = file.path.empty() ? nullptr : decode(file.path, files, cache != nullptr ? *cache : own);
    const Image* image = usable(picture, file, diagnostics);
    Image result = image != nullptr ? declared(fitted(*image, texture, file, diagnostics), texture, file, diagnostics)
                                    : content::checkerboard();
    if (texture.target == TextureTarget::d1) result = some_rows(result, 0, 1);  // one row of the checkerboard, too
    if (result.srgb && result.type != PixelType::u8) result = content::to_half(result);
    return to_upload(std::move(result));
}

CubeFaces load_cube(const Scene& scene, Index index, Files& files, Diagnostics& diagnostics, ImageCache* cache) {
    if (index >= scene.textures.size()) return all_checks(check_side);
    const Texture& texture = scene.textures[index];
    ImageCache own;
    ImageCache& images = cache != nullptr ? *cache : own;
    const std::vector<TextureFile> located = locate_texture(texture, files, diagnostics);
    std::vector<Picture> pictures(located.size());
    if (!located.empty()) {
        content::parallel_blocks(located.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                if (!located[i].path.empty()) pictures[i] = decode(located[i].path, files, images);
        });
    }
    CubeFaces faces = located.size() == 6   ? six_faces(texture, located, pictures, diagnostics)
                      : located.size() == 1 ? one_file(texture, located[0], pictures[0], diagnostics)
                                            : all_checks(check_side);
    make_alike(faces);
    refit(faces, texture);
    return faces;
}

Image load_noise(int dimensions, int size, Files& files, Diagnostics& diagnostics, Span span) {
    const std::string name = content::noise_file_name(dimensions, size);
    const Resolved found = files.find(name);
    const std::string& path = found.path;
    std::string reason(found.refused);
    if (path.empty() && reason.empty()) return to_upload(content::make_noise(dimensions, size));
    if (const auto bytes = path.empty() ? std::nullopt : files.read(path, reason)) {
        content::ImageResult result = content::decode_image(path, *bytes, image_limits(files));
        const int depth = dimensions == 3 ? size : 1;
        if (result.image && result.image->width == size && result.image->height == size &&
            result.image->depth == depth) {
            for (const ImageIssue& issue : result.issues)
                diagnostics.warning(issue.code, fmt::format("'{}': {}", path, issue.message), issue.help);
            return to_upload(std::move(*result.image));
        }
        reason = fmt::format("it is not a noise texture with {} texels per side", size);
        for (const ImageIssue& issue : result.issues) {
            if (issue.error) reason = issue.message;
        }
    }
    const std::string said = fmt::format("'{}': {}; noise is generated instead", path.empty() ? name : path, reason);
    diagnostics.warning("noise-file", span, said, "remove the file, or replace it").has_span = span != Span{};
    return to_upload(content::make_noise(dimensions, size));
}

}  // namespace snell
