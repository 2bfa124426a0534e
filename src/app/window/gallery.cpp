#include "src/app/window/gallery.h"

#include "parser/text/utf8.h"
#include "src/app/desktop/folder.h"
#include "src/app/desktop/thumbnails.h"

namespace snell {

std::span<const ui::RecentScene> Gallery::show(const std::vector<std::string>& recent, bool pictures) {
    const bool same = recent == recent_ && scenes_.size() == recent.size();
    if (same && pictures == loaded_) return scenes_;
    scenes_.clear();
    textures_.clear();
    recent_ = recent;
    loaded_ = pictures;
    for (const std::string& path : recent) {
        const std::size_t slash = path.rfind('/') + 1;
        const std::string folder = path.substr(0, slash > 1 ? slash - 1 : slash);
        scenes_.push_back({utf8::printable(path.substr(slash)), utf8::printable(with_tilde(folder)), path});
    }
    if (pictures) load();
    return scenes_;
}

void Gallery::load() {
    const std::string folder = thumbnails_folder();
    for (ui::RecentScene& scene : scenes_) {
        const std::optional<content::Image> image = read_thumbnail(folder, scene.path);
        if (!image || image->width < 1 || image->height < 1) continue;
        const gl::Texels texels{gl::Pixels::rgba8, image->width, image->height, 1, image->pixels.data()};
        textures_.push_back(gl::make_texture(GL_TEXTURE_2D, texels, {.clamp = true}));
        scene.picture = textures_.back().get();
        scene.shape = static_cast<float>(image->width) / static_cast<float>(image->height);
    }
}

}  // namespace snell
