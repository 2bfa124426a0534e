#include "src/app/window/opener.h"

#include <filesystem>
#include <utility>

#include "parser/text/words.h"
#include "src/app/desktop/folder.h"
#include "src/plan/locate.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) { return utf8::printable(fs::path(path).filename().string()); }

// Names files near the scene relative to the scene's folder.
std::string short_name(const std::string& path, const fs::path& folder) {
    const fs::path relative = fs::path(path).lexically_normal().lexically_relative(folder.lexically_normal());
    const bool near = !relative.empty() && !relative.string().starts_with("../../../");
    return utf8::printable(near ? relative.string() : path);
}

}  // namespace

void Opener::tell(ui::Facts& facts, const std::string& scene, const std::vector<std::string>& in_use, bool browsing) {
    if (rows_at_ != facts.revision || rows_of_ != scene) {
        const fs::path parent = fs::path(scene).parent_path();
        const fs::path folder = parent.empty() ? fs::path(".") : parent;
        rows_.clear();
        for (const std::string& path : in_use) rows_.push_back({short_name(path, folder), path});
        rows_at_ = facts.revision;
        rows_of_ = scene;
    }
    facts.files = rows_;
    facts.editor = editor_.name();
    facts.recent = gallery_.show(settings_.recent, browsing);
    facts.listing = &listing_;
}

std::optional<std::string> Opener::scene_at(const std::string& path, ui::Memory& memory) {
    const std::string whole = without_tilde(path);
    if (!is_folder(whole)) return whole;
    browse(whole, memory);
    return std::nullopt;
}

void Opener::browse(const std::string& folder, ui::Memory& memory) {
    ui::Requests requests;
    ui::open_browser(folder, memory, requests);
    listing_ = list_folder(folder, memory.browser.all);
}

void Opener::keep_picture(const std::string& scene, const content::Image& picture) {
    if (!picture.pixels.empty()) keep_thumbnail(thumbnails_folder(), whole_path(scene), picture, settings_.recent);
}

std::optional<std::string> Opener::serve(const ui::Requests& requests, const std::string& scene, ui::Memory& memory) {
    if (requests.browse) {
        std::string wanted = memory.browser.folder;
        if (wanted.empty()) wanted = scene.empty() ? listing_.folder : fs::path(scene).parent_path().string();
        listing_ = list_folder(wanted, memory.browser.all);
    }
    if (const ui::Place& place = requests.edit; !place.file.empty()) {
        const Started started = editor_.open(place.file, place.line, place.column);
        edited_ = place;
        if (started.error.empty()) {
            memory.notice = started.program + " opens " + file_name(place.file);
            if (memory.failure.remedy == ui::Failure::Remedy::editor) memory.failure = {};
        } else {
            memory.failure = {started.error, ui::Failure::Remedy::editor, place};
        }
    }
    if (requests.set_editor) ui::open_save_as(memory.set_editor, settings_.editor);
    if (requests.set_editor_now) set_editor(memory);
    return requests.open.empty() ? std::nullopt : scene_at(requests.open, memory);
}

void Opener::set_editor(ui::Memory& memory) {
    settings_.editor = memory.set_editor.file.data();
    editor_.set(settings_.editor);
    memory.set_editor.open = false;
    memory.failure = {};
    memory.notice = "the editor is " + utf8::printable(editor_.name());
    write();
}

std::optional<std::string> Opener::serve_dropped(const std::vector<std::string>& paths, ui::Memory& memory) {
    for (const std::string& path : paths)
        if (is_folder(path) || has_extension(path, "glib")) return scene_at(path, memory);
    if (!paths.empty()) memory.failure = {"no .glib scene: " + file_name(paths[0])};
    return std::nullopt;
}

void Opener::opened(const std::string& scene) {
    remember(settings_.recent, scene);
    write();
}

void Opener::resized(int width, int height) {
    settings_.width = width;
    settings_.height = height;
}

void Opener::write() {
    if (settings_ == kept_) return;
    // An error is ignored, because only comfort is lost.
    write_settings(file_, settings_);
    kept_ = settings_;
}

bool Opener::look(ui::Memory& memory) {
    gather(memory, settings_);
    write();
    std::string said = editor_.look();
    if (said.empty()) return false;
    memory.failure = {std::move(said), ui::Failure::Remedy::editor, edited_};
    return true;
}

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
