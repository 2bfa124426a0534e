// Small pictures of scenes that were never open: made one after another by `snell render` in a process of its own,
// while somebody looks for a scene.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/content/process.h"

namespace snell {

// The path of this program.
std::string own_program();

class ScenePictures {
public:
    // `folder` is that of the pictures; without one, none are made. `program` makes them.
    explicit ScenePictures(std::string folder, std::string program = own_program())
        : folder_(std::move(folder)), program_(std::move(program)) {}
    // Makes the pictures of these scenes that have none, or one that is older than the scene, in this order. What is
    // being made for others is finished, and no more.
    void want(std::vector<std::string> scenes) { wanted_ = std::move(scenes); }
    // Call it regularly. Returns the scene whose picture is new, or could not be made, or "".
    std::string look();
    // Why the scene has no picture; empty if it may still get one. It stays as long as this object.
    std::string_view why(const std::string& scene) const;

private:
    std::string folder_, program_;
    std::vector<std::string> wanted_;
    std::map<std::string, std::string> tried_;  // why they have none
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
