// Cube maps from six image files, or from one image in a known layout.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/content/image/image.h"

namespace snell::content {

// The faces in OpenGL's order: +X -X +Y -Y +Z -Z. Row 0 of each face is its top row, which is also the row that is
// uploaded first.
using CubeFaces = std::array<Image, 6>;

// equirectangular: longitude along the rows, latitude down the columns, seen from inside. The image's centre is -Z
//   (the initial viewing direction), +X is a quarter of the width to its right, the top row is +Y.
// cross_horizontal (4 x 3 faces):  .  +Y  .   .        cross_vertical (3 x 4):  .  +Y  .
//                                 -X  +Z +X  -Z                                -X  +Z +X
//                                  .  -Y  .   .                                 .  -Y  .
//                                                        -Z turned by 180°:     .  -Z  .
//   Adjacent faces of a cross share their edges in OpenGL's orientation of faces.
// strips: +X -X +Y -Y +Z -Z, from the left or from the top.
enum class CubeLayout { equirectangular, cross_horizontal, cross_vertical, strip_horizontal, strip_vertical };

// Recognises a layout by its proportions; returns nullopt if they fit none. Panoramas may deviate from 2:1 by 1 %.
std::optional<CubeLayout> detect_layout(int width, int height);

// Converts an image of a layout to six faces, on all cores. With `face_size` 0, the size is chosen so that no detail is
// lost (equirectangular: height / 2). Faces keep the image's type and channels. The lookup is bilinear; if the image is
// finer than the faces, several samples are averaged.
CubeFaces split_cube(const Image& image, CubeLayout layout, int face_size = 0);

// The direction of a point on a face, by OpenGL's table (specification 4.6, table 8.19); not of unit length: the
// largest component is ±1. s and t are 0..1, t from the first row.
std::array<double, 3> face_direction(int face, double s, double t);

// The position u, v (0..1, v from the top) of a direction in an equirectangular image. At the poles u is 1/2.
std::array<double, 2> equirectangular_position(const std::array<double, 3>& direction);

// The names of the six faces that "stem.ext" can stand for, in OpenGL's order: one list for each naming convention.
std::vector<std::array<std::string, 6>> face_names(std::string_view name);

// The pictures of a cube map whose faces come from six files; null for one that could not be read.
using FacePictures = std::array<const Image*, 6>;

// The side that most faces have; if two are equally frequent, that of the earlier face. 0 if none is square.
int common_side(const FacePictures& faces);

// Checks the sizes of the faces that could be read.
std::vector<ImageIssue> check_faces(const FacePictures& faces, const std::array<std::string, 6>& names);

}  // namespace snell::content
