#include "src/content/cube/cubemap.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "src/content/workers.h"

namespace snell::content {
namespace {

using Pixel = std::array<float, 4>;

// An image as floats, with bilinear lookup.
class Sampler {
public:
    explicit Sampler(const Image& image)
        : width_(image.width), height_(image.height), channels_(static_cast<std::size_t>(image.channels)) {
        values_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * channels_);
        const std::size_t row = static_cast<std::size_t>(width_) * channels_;
        parallel_blocks(static_cast<std::size_t>(height_), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first * row; i < last * row; ++i) values_[i] = value_at(image, i);
        });
    }

    int width() const { return width_; }
    int height() const { return height_; }

    // x and y are in texels, with centres at halves. `texel(x, y)` maps whole coordinates, up to one outside of the
    // image, to the index of a texel: each layout continues differently beyond its edges.
    template <class Texel>
    Pixel bilinear(double x, double y, const Texel& texel) const {
        const double left = std::floor(x - .5), top = std::floor(y - .5);
        const auto fx = static_cast<float>(x - .5 - left), fy = static_cast<float>(y - .5 - top);
        const int u = static_cast<int>(left), v = static_cast<int>(top);
        const float* const a = values_.data() + texel(u, v) * channels_;
        const float* const b = values_.data() + texel(u + 1, v) * channels_;
        const float* const c = values_.data() + texel(u, v + 1) * channels_;
        const float* const d = values_.data() + texel(u + 1, v + 1) * channels_;
        Pixel result{};
        for (std::size_t i = 0; i < channels_; ++i) {
            const float above = a[i] + fx * (b[i] - a[i]), below = c[i] + fx * (d[i] - c[i]);
            result[i] = above + fy * (below - above);
        }
        return result;
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

private:
    int width_, height_;
    std::size_t channels_;
    std::vector<float> values_;
};

void store(Image& image, std::size_t index, float value) {
    std::byte* const out = image.pixels.data();
    if (image.type == PixelType::u8) {
        out[index] = static_cast<std::byte>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
    } else if (image.type == PixelType::f16) {
        const std::uint16_t half = float_to_half(value);
        std::memcpy(out + 2 * index, &half, 2);
    } else {
        std::memcpy(out + 4 * index, &value, 4);
    }
}

// Fills faces with the mean of grid x grid evenly spread samples for each texel, by sample(face, s, t).
template <class Sample>
CubeFaces fill_faces(const Image& like, int size, int grid, const Sample& sample) {
    CubeFaces faces;
    for (Image& face : faces) {
        face.width = face.height = size;
        face.channels = like.channels;
        face.type = like.srgb ? PixelType::f16 : like.type;  // samples are light
        face.pixels.resize(face.bytes());
    }
    const auto channels = static_cast<std::size_t>(like.channels), rows = static_cast<std::size_t>(size);
    const double step = 1.0 / (static_cast<double>(size) * grid);
    const auto texel = [&](int face, int x, int y) {
        std::array<double, 4> sum{};
        for (int k = 0; k < grid * grid; ++k) {
            const int column = x * grid + k % grid, row = y * grid + k / grid;
            const double s = (column + .5) * step, t = (row + .5) * step;
            const Pixel pixel = sample(face, s, t);
            for (std::size_t c = 0; c < channels; ++c) sum[c] += static_cast<double>(pixel[c]);
        }
        return sum;
    };
    parallel_blocks(6 * rows, [&](std::size_t first, std::size_t last) {
        for (std::size_t row = first; row < last; ++row) {
            const std::size_t face = row / rows, y = row % rows;
            for (std::size_t x = 0; x < rows; ++x) {
                const auto sum = texel(static_cast<int>(face), static_cast<int>(x), static_cast<int>(y));
                for (std::size_t c = 0; c < channels; ++c)
                    store(faces[face], (y * rows + x) * channels + c, static_cast<float>(sum[c] / (grid * grid)));
            }
        }
    });
    return faces;
}

// The number of samples along a texel's side, for an image that is `ratio` times finer than the faces.
int grid_for(double ratio) { return std::clamp(static_cast<int>(std::lround(ratio)), 1, 64); }

CubeFaces from_equirectangular(const Image& image, int face_size) {
    const Sampler sampler(image);
    const int width = sampler.width(), height = sampler.height();
    // Longitude wraps around. Beyond a pole, the image continues half a turn away.
    const auto texel = [&](int x, int y) {
        if (y < 0 || y >= height) {
            y = y < 0 ? 0 : height - 1;
            x += width / 2;
        }
        if (x < 0) x += width;
        return sampler.index(x % width, y);
    };
    // Rows per radian relative to face texels per radian at a face's centre. 1.5 times as many samples ensure that no
    // small lamp falls between them: the total light is preserved within .3 %, otherwise within 1.6 %.
    const double ratio = height / std::acos(-1.0) / (face_size / 2.0);
    return fill_faces(image, face_size, grid_for(1.5 * ratio), [&](int face, double s, double t) {
        const auto [u, v] = equirectangular_position(face_direction(face, s, t));
        return sampler.bilinear(u * width, v * height, texel);
    });
}

struct Cell {
    int column = 0, row = 0;
    bool turned = false;  // by 180 degrees
};

// How an image of a layout is divided, and where its faces are; in the order of CubeLayout.
struct Grid {
    int columns = 0, rows = 0;
    std::array<Cell, 6> cells{};
};
constexpr std::array<Grid, 5> grids{{{1, 2},  // a panorama has no cells
                                     {4, 3, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}},
                                     {3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}}},
                                     {6, 1, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}},
                                     {1, 6, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}}}};
const Grid& grid_of(CubeLayout layout) { return grids[static_cast<std::size_t>(layout)]; }

int cell_size(const Image& image, CubeLayout layout) {
    const Grid& grid = grid_of(layout);
    return std::min(image.width / grid.columns, image.height / grid.rows);
}

Image cut(const Image& image, const Cell& cell, int size) {
    Image face = image;
    face.width = face.height = size;
    face.pixels.resize(face.bytes());
    const std::size_t pixel = image.pixel_bytes();
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const int u = cell.column * size + (cell.turned ? size - 1 - x : x);
            const int v = cell.row * size + (cell.turned ? size - 1 - y : y);
            const std::size_t to =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
            const std::size_t from =
                static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(u);
            std::memcpy(face.pixels.data() + to * pixel, image.pixels.data() + from * pixel, pixel);
        }
    }
    return face;
}

CubeFaces from_cells(const Image& image, CubeLayout layout, int face_size) {
    const int size = cell_size(image, layout);
    CubeFaces faces;
    if (face_size == size) {
        for (std::size_t face = 0; face < 6; ++face) faces[face] = cut(image, grid_of(layout).cells[face], size);
        return faces;
    }
    const Sampler sampler(image);
    return fill_faces(
        image, face_size, grid_for(static_cast<double>(size) / face_size), [&](int face, double s, double t) {
            const Cell cell = grid_of(layout).cells[static_cast<std::size_t>(face)];
            const int left = cell.column * size, top = cell.row * size;
            const auto texel = [&](int x, int y) {
                return sampler.index(std::clamp(x, left, left + size - 1), std::clamp(y, top, top + size - 1));
            };
            const double x = cell.turned ? 1 - s : s, y = cell.turned ? 1 - t : t;
            return sampler.bilinear(left + x * size, top + y * size, texel);
        });
}

}  // namespace

std::optional<CubeLayout> detect_layout(int width, int height) {
    const auto proportions = [&](int columns, int rows) {
        return width > 0 && width % columns == 0 && height % rows == 0 && width / columns == height / rows;
    };
    if (proportions(4, 3)) return CubeLayout::cross_horizontal;
    if (proportions(3, 4)) return CubeLayout::cross_vertical;
    if (proportions(6, 1)) return CubeLayout::strip_horizontal;
    if (proportions(1, 6)) return CubeLayout::strip_vertical;
    const std::int64_t off = std::abs(std::int64_t{width} - 2 * std::int64_t{height});
    if (width > 1 && height > 0 && off * 100 <= width) return CubeLayout::equirectangular;
    return std::nullopt;
}

CubeFaces split_cube(const Image& image, CubeLayout layout, int face_size) {
    if (image.bottom_first) return split_cube(flipped(image), layout, face_size);
    if (face_size <= 0) face_size = std::max(cell_size(image, layout), 1);
    return layout == CubeLayout::equirectangular ? from_equirectangular(image, face_size)
                                                 : from_cells(image, layout, face_size);
}

std::array<double, 3> face_direction(int face, double s, double t) {
    const double u = 2 * s - 1, v = 2 * t - 1;
    const std::array<std::array<double, 3>, 6> directions{
        {{1, -v, -u}, {-1, -v, u}, {u, 1, v}, {u, -1, -v}, {u, -v, 1}, {-u, -v, -1}}};
    return directions[static_cast<std::size_t>(face)];
}

std::array<double, 2> equirectangular_position(const std::array<double, 3>& direction) {
    const auto [x, y, z] = direction;
    const double level = std::hypot(x, z);
    const double longitude = level > 0 ? std::atan2(x, -z) : 0;
    return {.5 + longitude / (2 * std::numbers::pi), .5 - std::atan2(y, level) / std::numbers::pi};
}

// Cube maps from six files: names, sizes and decoding.
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
            for (std::size_t i = 0; i < 6; ++i)
                names[i] = stem + std::string(separator) + std::string(words[i]) + extension;
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
