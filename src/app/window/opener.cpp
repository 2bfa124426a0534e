#include "src/app/window/opener.h"

#include <filesystem>
#include <utility>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/desktop/folder.h"
#include "src/app/open/templates.h"
#include "src/plan/locate.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

std::span<const ui::NewKind> new_kinds() {
    static const std::vector<ui::NewKind> kinds = [] {
        std::vector<ui::NewKind> made;
        for (const app::Kind& kind : app::kinds()) made.push_back({kind.name, kind.summary});
        return made;
    }();
    return kinds;
}

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
    gallery_.browse(browsing);
    facts.recent = gallery_.recent(settings_.recent);
    facts.examples = gallery_.examples();
    gallery_.fill(listing_);
    facts.listing = &listing_;
    facts.kinds = new_kinds();
    new_folder_ = utf8::printable(with_tilde(listing_.folder));
    facts.new_folder = new_folder_;
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
    memory.browser.start = folder.empty();
    listing_ = list_folder(folder, memory.browser.all);
}

void Opener::keep_picture(const std::string& scene, const content::Image& picture) {
    if (!picture.pixels.empty()) keep_thumbnail(thumbnails_folder(), whole_path(scene), picture);
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
            memory.failures.done(ui::Failure::Remedy::editor);
        } else {
            memory.failed({started.error, ui::Failure::Remedy::editor, place});
        }
    }
    if (requests.set_editor) ui::open_save_as(memory.set_editor, settings_.editor);
    if (requests.set_editor_now) set_editor(memory);
    if (requests.new_scene_now) return make_scene(memory);
    return requests.open.empty() ? std::nullopt : scene_at(requests.open, memory);
}

std::optional<std::string> Opener::make_scene(ui::Memory& memory) const {
    ui::SaveAs& dialog = memory.new_scene;
    const fs::path folder = (fs::path(listing_.folder) / without_tilde(dialog.file.data())).lexically_normal();
    const std::string name = folder.filename().string();
    const auto kind = ranges::find(app::kinds(), memory.browser.kind, &app::Kind::name);
    std::error_code error;
    dialog.error.clear();
    if (name.empty() || name == "." || name == "..")
        dialog.error = "the scene needs a name";
    else if (fs::exists(fs::symlink_status(folder, error)))
        dialog.error = file_name(name) + " exists: choose another name";
    else if (kind != app::kinds().end())
        dialog.error = app::write_folder(folder, app::files_of(*kind, name));
    if (!dialog.error.empty()) return std::nullopt;
    dialog.open = memory.browser.open = false;
    return (folder / (name + ".glib")).string();
}

void Opener::set_editor(ui::Memory& memory) {
    settings_.editor = memory.set_editor.file.data();
    editor_.set(settings_.editor);
    memory.set_editor.open = false;
    memory.failures.done(ui::Failure::Remedy::editor);
    memory.notice = "the editor is " + utf8::printable(editor_.name());
    write();
}

std::optional<std::string> Opener::serve_dropped(const std::vector<std::string>& paths, ui::Memory& memory) {
    for (const std::string& path : paths)
        if (is_folder(path) || has_extension(path, "glib")) return scene_at(path, memory);
    if (!paths.empty())
        memory.failed({"no .glib scene: " + file_name(paths[0]), ui::Failure::Remedy::open, {paths[0], 1, 1}});
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
    const bool pictured = gallery_.look();
    std::string said = editor_.look();
    if (said.empty()) return pictured;
    memory.failed({std::move(said), ui::Failure::Remedy::editor, edited_});
    return true;
}

Gallery::Gallery() : folder_(thumbnails_folder()), maker_(folder_) {}

void Gallery::browse(bool open) {
    if (open == std::exchange(open_, open)) return;
    loaded_.clear();
    if (!open) return maker_.want({});
    if (std::exchange(sampled_, true)) return;
    const SampleScenes samples = sample_scenes();
    scenes_ = cards(samples.scenes);
    lessons_ = cards(samples.lessons);
    for (ui::SceneCard& lesson : lessons_)  // "07-glass", not "handout"
        lesson.folder = fs::path(lesson.path).parent_path().parent_path().filename().string();
    for (ui::SceneCard& scene : scenes_) scene.folder.clear();
}

bool Gallery::look() {
    if (!open_) return false;
    const std::string made = maker_.look();
    if (!made.empty()) loaded_.erase(made);
    return !made.empty();
}

std::vector<ui::SceneCard> Gallery::cards(const std::vector<std::string>& paths) {
    std::vector<ui::SceneCard> made;
    for (const std::string& path : paths) {
        const std::size_t slash = path.rfind('/') + 1;
        const std::string folder = path.substr(0, slash > 1 ? slash - 1 : slash);
        made.push_back({utf8::printable(path.substr(slash)), utf8::printable(with_tilde(folder)), path});
    }
    return made;
}

const ui::SmallPicture& Gallery::picture(const std::string& path) {
    static const ui::SmallPicture none;
    if (!open_) return none;
    const auto [place, fresh] = loaded_.try_emplace(path);
    Loaded& loaded = place->second;
    if (!fresh) return loaded.picture;
    const std::optional<content::Image> image = read_thumbnail(folder_, path);
    if (!image || image->width < 1 || image->height < 1) {
        loaded.picture.why = maker_.why(path);
        return loaded.picture;
    }
    const gl::Texels texels{gl::Pixels::rgba8, image->width, image->height, 1, image->pixels.data()};
    loaded.texture = gl::make_texture(GL_TEXTURE_2D, texels, {.clamp = true});
    loaded.picture = {loaded.texture.get(), static_cast<float>(image->width) / static_cast<float>(image->height)};
    return loaded.picture;
}

std::span<const ui::SceneCard> Gallery::recent(const std::vector<std::string>& paths) {
    if (paths != recent_paths_) recent_ = cards(paths);
    recent_paths_ = paths;
    for (ui::SceneCard& scene : recent_) scene.picture = picture(scene.path);
    return recent_;
}

ui::SampleCards Gallery::examples() {
    for (std::vector<ui::SceneCard>* scenes : {&scenes_, &lessons_})
        for (ui::SceneCard& scene : *scenes) scene.picture = picture(scene.path);
    return {scenes_, lessons_};
}

void Gallery::fill(ui::Listing& listing) {
    if (!open_) return;
    std::vector<std::string> lacking;
    for (ui::Entry& entry : listing.entries) {
        if (entry.folder || !has_extension(entry.path, "glib")) continue;
        entry.picture = picture(entry.path);
        lacking.push_back(entry.path);
    }
    for (const auto* scenes : {&recent_, &scenes_, &lessons_})
        for (const ui::SceneCard& scene : *scenes) lacking.push_back(scene.path);
    maker_.want(std::move(lacking));
}

}  // namespace snell
