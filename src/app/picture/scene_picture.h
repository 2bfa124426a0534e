// One picture of a scene, as `snell compare` draws it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/content/image/image.h"
#include "src/gl/caps.h"
#include "src/plan/files.h"

namespace snell::app {

struct ScenePicture {
    std::vector<std::string> sets, ladders;
    std::optional<std::pair<int, int>> size;  // nullopt: the scene's own
    double time = 0;
    int samples = 1;
    Access access;
    bool grade = false;
};

// Draws the scene as `snell render` does to a file of bytes, and adds its errors and warnings to `messages`, as text.
// Needs a current context. There is no image if the scene has errors or a value does not fit. NaN, which bytes cannot
// hold, is in `replaced`.
content::ImageResult scene_picture(const std::string& scene, const ScenePicture& wanted, const gl::Caps& caps,
                                   std::string& messages);

}  // namespace snell::app
