// Executes the user's requests about files: opens other scenes, lists folders, starts editors.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/app/desktop/editor.h"
#include "src/app/desktop/folder.h"
#include "src/app/desktop/settings.h"
#include "src/gl/texture.h"
#include "src/ui/panels/state.h"

namespace snell {

// Scenes as the file browser shows them: with names, folders and pictures.

class Gallery {
public:
    Gallery();
    // While the browser is open, pictures are on the GPU, and those that lack are made; the GL context must be current.
    void browse(bool open);
    // Call it regularly. Returns true if there is a new picture.
    bool look();
    // The scenes with these absolute paths.
    std::span<const ui::SceneCard> recent(const std::vector<std::string>& paths);
    ui::SampleCards examples();
    // Fills in the pictures of the scenes in the folder.
    void fill(ui::Listing& listing);

private:
    struct Loaded {
        gl::Texture texture;
        ui::SmallPicture picture;
    };
    const ui::SmallPicture& picture(const std::string& path);
    void want(const ui::Listing* listing);
    static std::vector<ui::SceneCard> cards(const std::vector<std::string>& paths);

    std::string folder_;
    ScenePictures maker_;
    std::map<std::string, Loaded> loaded_;  // by the scene's path; those that have none, too
    std::vector<ui::SceneCard> recent_, scenes_, lessons_;
    std::vector<std::string> recent_paths_, listed_;
    bool open_ = false, sampled_ = false;
};

class Opener {
public:
    // `file` is the path of the settings.
    explicit Opener(std::string file) : file_(std::move(file)), kept_(read_settings(file_)), settings_(kept_) {
        editor_.set(settings_.editor);
    }

    const Settings& settings() const { return settings_; }
    // `in_use` and `revision` are those of the session; the rows are made again when the revision changes.
    void tell(ui::Facts& facts, const std::string& scene, const std::vector<std::string>& in_use, bool browsing);
    // Keeps a small picture of a scene for the browser.
    void keep_picture(const std::string& scene, const content::Image& picture);
    // Returns the path of a scene to open, if there is one. Sets `notice` to the outcome of the other requests.
    std::optional<std::string> serve(const ui::Requests& requests, const std::string& scene, ui::Memory& memory);
    // Opens the browser in a folder.
    void browse(const std::string& folder, ui::Memory& memory);
    // Handles files that were dropped on the window: opens the first scene among them, or lists a folder.
    std::optional<std::string> serve_dropped(const std::vector<std::string>& paths, ui::Memory& memory);
    // Call it regularly: it checks for ended editors and writes settings that changed, including the recent scenes.
    // Returns true if it changed `memory.notice`.
    bool look(ui::Memory& memory);
    // Records the scene as the most recent one.
    void opened(const std::string& scene);
    // The size is in the window's coordinates at zoom 1 and 96 dots per inch.
    void resized(int width, int height);
    // Writes the settings if they changed.
    void write();

private:
    std::optional<std::string> scene_at(const std::string& path, ui::Memory& memory);
    void set_editor(ui::Memory& memory);
    // Makes a new scene, and returns its path; if there is none, the dialog says why.
    std::optional<std::string> make_scene(ui::Memory& memory) const;

    std::string file_;
    Settings kept_, settings_;
    Editor editor_;
    ui::Place edited_;  // where an editor was opened last
    Gallery gallery_;
    ui::Listing listing_;
    std::string new_folder_;  // where new scenes are made, as displayed
    std::vector<ui::FileRow> rows_;
    std::string rows_of_;                        // the scene that rows_ belong to
    std::uint64_t rows_at_ = ~std::uint64_t{0};  // the revision that rows_ belong to
};

}  // namespace snell
