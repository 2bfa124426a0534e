// Six faces from files and layouts.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "src/content/image.h"

namespace snell::content {

// In OpenGL's order: +X -X +Y -Y +Z -Z. Each face's row 0 is its top row, which is also the first row that
// is uploaded.
using CubeFaces = std::array<Image, 6>;

enum class CubeLayout { equirectangular, cross_horizontal, cross_vertical, strip_horizontal, strip_vertical };

// nullopt when the proportions fit none.
std::optional<CubeLayout> detect_layout(int width, int height);

// `face_size` 0: chosen so that no detail is lost (equirectangular: height / 2).
CubeFaces split_cube(const Image& image, CubeLayout layout, int face_size = 0);

// The six names that `stem.ext` may stand for, one list for each naming convention, in OpenGL's order.
std::vector<std::array<std::string, 6>> face_names(std::string_view name);

// For cube maps whose faces came from six files: what is wrong with their sizes, if anything.
std::vector<ImageIssue> check_faces(const CubeFaces& faces, const std::array<std::string, 6>& names);

}  // namespace snell::content
