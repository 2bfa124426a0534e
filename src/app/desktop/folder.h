// Lists a folder for the file browser, and keeps or makes small pictures of its scenes.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/content/image/image.h"
#include "src/content/process.h"
#include "src/ui/panels/browser.h"

namespace snell {

// Lists folders, then scenes (with `all`, every regular file), each sorted by name without regard to case and with
// numbers by value. Hidden entries are left out. `folder` may begin with ~. If the folder cannot be read, the listing
// has an error and the absolute path.
ui::Listing list_folder(const std::string& folder, bool all);

bool is_folder(const std::string& path);

// The scene of a folder that has exactly one directly in it, as of `snell new`; otherwise the path itself.
std::string only_scene(const std::string& path);

// Replaces a leading "~" or "~/" by the home folder.
std::string without_tilde(const std::string& path);

// Replaces a leading home folder by "~".
std::string with_tilde(const std::string& path);
// Replaces the folder, wherever a path in the text begins with it, by nothing, and the home folder by "~". Neither ends
// with a slash.
std::string near_names(const std::string& text, const std::string& folder);

// The order in which names are sorted for the user: "room2" before "Room10".
bool before(std::string_view a, std::string_view b);

// Small pictures of recent scenes, which the file browser shows. They are kept in the user's cache folder.

// Returns $XDG_CACHE_HOME/snell/thumbnails, with ~/.cache as the default of the variable; "" if there is no home
// folder.
std::string thumbnails_folder();

// The file of the picture of a scene, whose path is absolute.
std::string thumbnail_file(const std::string& folder, const std::string& scene);

inline constexpr std::size_t most_thumbnails = 400;
// Writes the picture of a scene, and removes the oldest of more. Errors are ignored, because only comfort is lost.
void keep_thumbnail(const std::string& folder, const std::string& scene, const content::Image& picture);

// Returns the picture of a scene as RGBA bytes; nullopt if there is none, or if its file is damaged.
std::optional<content::Image> read_thumbnail(const std::string& folder, const std::string& scene);

// Small pictures of scenes that were never open: made one after another by `snell render` in a process of its own,
// while somebody looks for a scene.

// The path of this program.
std::string own_program();

class ScenePictures {
public:
    // `folder` is that of the pictures; without one, none are made. `program` makes them.
    explicit ScenePictures(std::string folder, std::string program = own_program())
        : folder_(std::move(folder)), program_(std::move(program)) {}
    // Makes the pictures of these scenes that have none, or one that is older than a file of the scene, in this order.
    // What is being made for others is finished, and no more.
    void want(std::vector<std::string> scenes) { wanted_ = std::move(scenes); }
    // Call it regularly. Returns the scene whose picture is new, or could not be made, or "".
    std::string look();
    // Why the scene has no picture; empty if it may still get one. It stays until the scene is tried again, after one
    // of its files was written.
    std::string_view why(const std::string& scene) const;

private:
    using Time = std::chrono::nanoseconds;  // since 1970
    // When the scene, or a file that it reads, was written last. Which these are is read from the texts again if one of
    // them was written, for one scene at each look; `reads`: for this one.
    std::optional<Time> written(const std::string& scene, bool& reads);

    std::string folder_, program_;
    std::vector<std::string> wanted_;
    struct Read {
        std::vector<std::string> files;
        Time written;
    };
    std::map<std::string, Read> read_;
    struct Tried {
        Time written;     // the scene, as it was tried
        std::string why;  // it has none
    };
    std::map<std::string, Tried> tried_;
    std::string making_;
    content::Process process_;
};

// Scenes that come with the program: those of the folder of scenes, and the handouts of lessons, each by its path. The
// folders are found from the program's, installed or as it was built.
struct SampleScenes {
    std::vector<std::string> scenes, lessons;
};
SampleScenes sample_scenes();

}  // namespace snell
