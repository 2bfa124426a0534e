// Six faces from files and layouts.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/content/image.h"

namespace snell::content {

// In OpenGL's order: +X -X +Y -Y +Z -Z. Each face's row 0 is its top row, which is also the first row that
// is uploaded.
using CubeFaces = std::array<Image, 6>;

// equirectangular: longitude along the rows, latitude down the columns, a view from inside: the picture's centre
//   is -Z (where a camera looks at first), a quarter to the right of it +X, its top row +Y.
// cross_horizontal (4 x 3 faces):  .  +Y  .   .        cross_vertical (3 x 4):  .  +Y  .
//                                 -X  +Z +X  -Z                                -X  +Z +X
//                                  .  -Y  .   .                                 .  -Y  .
//                                                        -Z turned by 180°:     .  -Z  .
//   so that touching faces share their edges in OpenGL's orientation of faces.
// strips: +X -X +Y -Y +Z -Z, from the left or from the top.
enum class CubeLayout { equirectangular, cross_horizontal, cross_vertical, strip_horizontal, strip_vertical };

// nullopt when the proportions fit none. Panoramas may miss 2:1 by 1 %.
std::optional<CubeLayout> detect_layout(int width, int height);

// `face_size` 0: chosen so that no detail is lost (equirectangular: height / 2). Faces keep the picture's type
// and channels. Runs on all cores. Bilinear; where the picture is finer than the faces, texels are averaged.
CubeFaces split_cube(const Image& image, CubeLayout layout, int face_size = 0);

// The direction (not of unit length: the largest component is ±1) of a point on a face, by OpenGL's table
// (specification 4.6, table 8.19); s and t run 0..1, t from the first row.
std::array<double, 3> face_direction(int face, double s, double t);

// Where an equirectangular picture shows a direction: u, v in 0..1, v from the top. At the poles u is 1/2.
std::array<double, 2> equirectangular_position(const std::array<double, 3>& direction);

// The six names that `stem.ext` may stand for, one list for each naming convention, in OpenGL's order.
std::vector<std::array<std::string, 6>> face_names(std::string_view name);

// Six pictures of their own, for a cube map; null for one that could not be read.
using FacePictures = std::array<const Image*, 6>;

// The side that most faces have; of equally frequent ones, that of the first face. 0 when none is square.
int common_side(const FacePictures& faces);

// What is wrong with the sizes of those that could be read.
std::vector<ImageIssue> check_faces(const FacePictures& faces, const std::array<std::string, 6>& names);

}  // namespace snell::content
