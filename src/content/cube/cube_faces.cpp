// Cube maps from six files: names, sizes and decoding.
#include <algorithm>
#include <cstring>

#include "src/content/cube/cubemap.h"

namespace snell::content {
namespace {

using Words = std::array<std::string_view, 6>;

constexpr Words conventions[] = {
    {"posx", "negx", "posy", "negy", "posz", "negz"},
    {"px", "nx", "py", "ny", "pz", "nz"},
    {"right", "left", "top", "bottom", "front", "back"},
    {"rt", "lf", "up", "dn", "ft", "bk"},
    {"right", "left", "up", "down", "front", "back"},
    {"PositiveX", "NegativeX", "PositiveY", "NegativeY", "PositiveZ", "NegativeZ"},
    {"+x", "-x", "+y", "-y", "+z", "-z"},
    {"xp", "xn", "yp", "yn", "zp", "zn"},
    {"0", "1", "2", "3", "4", "5"},
    {"1", "2", "3", "4", "5", "6"},
};

constexpr std::string_view separators[] = {"_", "", "-", "."};

constexpr Words face_titles{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

std::string size_text(const Image& image) { return std::to_string(image.width) + " x " + std::to_string(image.height); }

}  // namespace

std::vector<std::array<std::string, 6>> face_names(std::string_view name) {
    const std::size_t start = name.find_last_of("/\\") + 1;
    std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot < start) dot = name.size();
    const std::string stem(name.substr(0, dot)), extension(name.substr(dot));
    std::vector<std::array<std::string, 6>> result;
    for (const Words& words : conventions) {
        for (const std::string_view separator : separators) {
            auto& names = result.emplace_back();
            for (std::size_t i = 0; i < 6; ++i) {
                names[i] = stem + std::string(separator) + std::string(words[i]) + extension;
            }
        }
    }
    return result;
}

int common_side(const FacePictures& faces) {
    const auto square = [](const Image* face) { return face && face->width == face->height && face->depth == 1; };
    int best = 0;
    std::ptrdiff_t most = 0;
    for (const Image* face : faces) {
        if (!square(face)) continue;
        const auto same = std::count_if(faces.begin(), faces.end(), [&](const Image* other) {
            return square(other) && other->width == face->width;
        });
        if (same > most) {
            most = same;
            best = face->width;
        }
    }
    return best;
}

std::vector<ImageIssue> check_faces(const FacePictures& faces, const std::array<std::string, 6>& names) {
    std::vector<ImageIssue> issues;
    const int side = common_side(faces);
    const std::string wanted = side > 0 ? std::to_string(side) + " x " + std::to_string(side) : "square";
    for (std::size_t i = 0; i < 6; ++i) {
        if (!faces[i]) continue;
        const Image& face = *faces[i];
        const std::string which = "face " + std::string(face_titles[i]) + " (" + names[i] + ") is " + size_text(face);
        const std::string help = "make all six faces " + (side > 0 ? wanted : "square and equal in size");
        if (face.width != face.height || face.depth != 1) {
            issues.push_back({true, "cube-face-not-square", which + "; the faces of a cube map must be square", help});
        } else if (face.width != side) {
            issues.push_back({true, "cube-faces-unequal", which + ", but the other faces are " + wanted, help});
        }
    }
    return issues;
}

}  // namespace snell::content
