// The recent scenes as the file browser shows them: with names, folders and pictures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "src/gl/texture.h"
#include "src/ui/panels/state.h"

namespace snell {

class Gallery {
public:
    // The scenes with these absolute paths. Their pictures are on the GPU only while `pictures` is true; the GL context
    // must be current.
    std::span<const ui::RecentScene> show(const std::vector<std::string>& recent, bool pictures);

private:
    void load();

    std::vector<ui::RecentScene> scenes_;
    std::vector<std::string> recent_;
    std::vector<gl::Texture> textures_;
    bool loaded_ = false;
};

}  // namespace snell
