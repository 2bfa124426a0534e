// Small pictures of scenes that were never open: made one after another by `snell render` in a process of its own,
// while somebody looks for a scene.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "src/content/process.h"

namespace snell {

class ScenePictures {
public:
    // `folder` is that of the pictures; without one, none are made.
    explicit ScenePictures(std::string folder) : folder_(std::move(folder)) {}
    // Makes the pictures of these scenes that have none, or one that is older than the scene, in this order. What is
    // being made for others is finished, and no more.
    void want(std::vector<std::string> scenes) { wanted_ = std::move(scenes); }
    // Call it regularly. Returns the scene whose picture is new, or "".
    std::string look();

private:
    std::string folder_;
    std::vector<std::string> wanted_;
    std::set<std::string> tried_;
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
