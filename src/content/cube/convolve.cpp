// Integrates the light of a cube map over the lobes of rough surfaces. For each direction it walks a tree over the
// cube's texels.
#include "src/content/cube/convolve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

#include "src/content/workers.h"

namespace snell::content {
namespace {

constexpr int smallest_level = 8;  // enough for roughness 1 (error below .4 % of the mean with seamless filtering)
// Irradiance is summed over 16 texels per side. The direction of each one's light is computed from 4 · 4 finer texels.
constexpr int irradiance_source = 64;
constexpr std::size_t irradiance_levels = 5;

// A texel of some level of the tree, and the light from it.
struct Node {
    float x = 0, y = 0, z = 0;  // unit vector to the centroid of its light
    float solid_angle = 0;
    float red = 0, green = 0, blue = 0;  // radiance · solid angle
    float reach = 0;                     // maximum distance from that vector to any part of the texel
};

// Interleaves the bits of column and row (Morton order): the four texels of a quarter are consecutive on every level,
// so the children of texel i are 4i to 4i + 3.
std::size_t interleave(int column, int row) {
    std::size_t result = 0;
    for (int bit = 0; bit < 15; ++bit)
        result |= static_cast<std::size_t>((column >> bit & 1) | (row >> bit & 1) << 1) << (2 * bit);
    return result;
}

// A pyramid of cubes of 1, 2, 4 … texels per side, up to the light's own size, which must be a power of two.
class Tree {
public:
    // Keeps only the `most` coarsest levels.
    explicit Tree(const CubeLight& light, std::size_t most = 32)
        : finest_(std::countr_zero(static_cast<unsigned>(light.size))) {
        levels_.resize(static_cast<std::size_t>(finest_) + 1);
        fill_finest(light);
        for (auto level = static_cast<std::size_t>(finest_); level-- > 0;) {
            levels_[level].resize(levels_[level + 1].size() / 4);
            for (std::size_t i = 0; i < levels_[level].size(); ++i)
                levels_[level][i] = parent(&levels_[level + 1][4 * i]);
        }
        if (levels_.size() > most) levels_.resize(most);
    }

    // Mean light in the lobes around four nearby directions. A texel is used as a whole if its solid angle is at most
    // `detail` times the square of the distance over which the lobe changes; with `detail` 0 only texels of the finest
    // level are used.
    void lobes(const std::array<std::array<double, 3>, 4>& directions, double alpha, double detail,
               std::array<std::array<float, 3>, 4>& means) const {
        Lobes lobes;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [x, y, z] = directions[i];
            const double length = std::sqrt(x * x + y * y + z * z);
            lobes.x[i] = static_cast<float>(x / length);
            lobes.y[i] = static_cast<float>(y / length);
            lobes.z[i] = static_cast<float>(z / length);
        }
        lobes.alpha2 = static_cast<float>(alpha * alpha);
        lobes.detail = static_cast<float>(detail);
        for (std::size_t face = 0; face < 6; ++face) gather(lobes, 0, face);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::array<double, 3> sum{lobes.red[i], lobes.green[i], lobes.blue[i]};
            for (std::size_t c = 0; c < 3; ++c) means[i][c] = static_cast<float>(sum[c] / lobes.weight[i]);
        }
    }

private:
    struct Lobes {
        std::array<float, 4> x{}, y{}, z{};
        std::array<double, 4> red{}, green{}, blue{}, weight{};
        float alpha2 = 1, detail = 0;
    };

    void fill_finest(const CubeLight& light) {
        const int size = light.size;
        std::vector<Node>& nodes = levels_.back();
        nodes.resize(light.texels.size());
        const std::size_t faces = nodes.size() / 6;
        for (int face = 0; face < 6; ++face)
            for (int row = 0; row < size; ++row)
                for (int column = 0; column < size; ++column) {
                    const double s = static_cast<double>(column) / size, t = static_cast<double>(row) / size;
                    const auto angle = static_cast<float>(solid_angle(s, t, s + 1.0 / size, t + 1.0 / size));
                    const auto [x, y, z] = face_direction(face, s + .5 / size, t + .5 / size);
                    const double length = std::sqrt(x * x + y * y + z * z);
                    const auto& [red, green, blue] = light.at(face, column, row);
                    nodes[static_cast<std::size_t>(face) * faces + interleave(column, row)] = {
                        static_cast<float>(x / length),
                        static_cast<float>(y / length),
                        static_cast<float>(z / length),
                        angle,
                        red * angle,
                        green * angle,
                        blue * angle,
                        std::sqrt(angle)};
                }
    }

    static Node parent(const Node* children) {
        Node sum;
        for (int i = 0; i < 4; ++i) {
            const Node& child = children[i];
            // The direction of a node is weighted by light, so that a lamp in a corner of its area stays in that
            // corner.
            const float light = std::max(child.red + child.green + child.blue, 0.0F) + 1e-6F * child.solid_angle;
            sum.x += child.x * light;
            sum.y += child.y * light;
            sum.z += child.z * light;
            sum.solid_angle += child.solid_angle;
            sum.red += child.red;
            sum.green += child.green;
            sum.blue += child.blue;
        }
        const float length = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
        sum.x /= length, sum.y /= length, sum.z /= length;
        sum.reach = 2 * std::sqrt(sum.solid_angle);
        return sum;
    }

    void gather(Lobes& lobes, std::size_t level, std::size_t index) const {
        const Node& node = levels_[level][index];
        std::array<float, 4> cosine;
        for (std::size_t i = 0; i < 4; ++i) cosine[i] = lobes.x[i] * node.x + lobes.y[i] * node.y + lobes.z[i] * node.z;
        const float nearest = std::max(std::max(cosine[0], cosine[1]), std::max(cosine[2], cosine[3]));
        if (nearest < -node.reach) return;  // the whole texel is behind the surface
        const float size2 = lobes.alpha2 + .5F - .5F * nearest;
        if (level + 1 < levels_.size() && node.solid_angle > lobes.detail * size2) {
            for (std::size_t child = 4 * index; child < 4 * index + 4; ++child) gather(lobes, level + 1, child);
            return;
        }
        const float slope = .5F * (1 - lobes.alpha2);
        std::array<float, 4> weight;
        for (std::size_t i = 0; i < 4; ++i) {
            const float spread = lobes.alpha2 + slope * (1 - cosine[i]);
            weight[i] = std::max(cosine[i], 0.0F) / (spread * spread);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            lobes.red[i] += static_cast<double>(weight[i] * node.red);
            lobes.green[i] += static_cast<double>(weight[i] * node.green);
            lobes.blue[i] += static_cast<double>(weight[i] * node.blue);
            lobes.weight[i] += static_cast<double>(weight[i] * node.solid_angle);
        }
    }

    int finest_;
    std::vector<std::vector<Node>> levels_;  // 6 · 4^level nodes each
};

// Texels are computed in squares of four, which share most of the tree walk.
CubeLight convolved(const Tree& tree, int size, double alpha, double detail) {
    CubeLight result;
    result.size = size;
    const auto rows = static_cast<std::size_t>(size), squares = (rows + 1) / 2;
    result.texels.resize(6 * rows * rows);
    parallel_blocks(6 * squares * squares, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t face = i / (squares * squares), top = i / squares % squares * 2, left = i % squares * 2;
            std::array<std::array<double, 3>, 4> directions;
            std::array<std::array<float, 3>, 4> means;
            std::array<std::size_t, 4> places;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t column = std::min(left + k % 2, rows - 1), row = std::min(top + k / 2, rows - 1);
                places[k] = (face * rows + row) * rows + column;
                directions[k] = face_direction(static_cast<int>(face), (static_cast<double>(column) + .5) / size,
                                               (static_cast<double>(row) + .5) / size);
            }
            tree.lobes(directions, alpha, detail, means);
            for (std::size_t k = 0; k < 4; ++k) result.texels[places[k]] = means[k];
        }
    });
    return result;
}

}  // namespace

CubeLight irradiance(const CubeLight& light, int size) {
    return convolved(Tree(resized(light, irradiance_source), irradiance_levels), size, 1, 0);
}

int prefilter_levels(int size) {
    int levels = 1;
    for (; size > smallest_level; size /= 2) ++levels;
    return levels;
}

std::vector<CubeLight> prefiltered(const CubeLight& light, int size) {
    // Small levels are cheap enough for more detail.
    const auto detail = [](int texels) { return texels > 16 ? .08 : .02; };
    std::vector<CubeLight> levels{resized(light, size)};
    const Tree tree(levels[0]);
    const int count = prefilter_levels(size);
    for (int level = 1; level < count; ++level) {
        const double roughness = static_cast<double>(level) / (count - 1);
        levels.push_back(convolved(tree, size >> level, roughness * roughness, detail(size >> level)));
    }
    return levels;
}

// Cube maps as light: resizing, means and spherical harmonics, weighted by solid angle.
namespace {

using std::numbers::pi;
constexpr float half_max = 65504.0f;

std::size_t texel_index(int size, int face, int column, int row) {
    return static_cast<std::size_t>((face * size + row) * size + column);
}

// The solid angle between the face's centre and (s, t), with a sign.
double corner(double s, double t) {
    const double u = 2 * s - 1, v = 2 * t - 1;
    return std::atan2(u * v, std::sqrt(u * u + v * v + 1));
}

// All six faces have the same solid angles, so one table is enough.
std::vector<double> solid_angles(int size) {
    std::vector<double> above, angles;
    for (int column = 0; column <= size; ++column) above.push_back(corner(static_cast<double>(column) / size, 0));
    for (int row = 1; row <= size; ++row) {
        std::vector<double> below;
        for (int column = 0; column <= size; ++column)
            below.push_back(corner(static_cast<double>(column) / size, static_cast<double>(row) / size));
        for (std::size_t i = 0; i + 1 < below.size(); ++i)
            angles.push_back(below[i + 1] - below[i] - above[i + 1] + above[i]);
        above = std::move(below);
    }
    return angles;
}

}  // namespace

const std::array<float, 3>& CubeLight::at(int face, int column, int row) const {
    return texels[texel_index(size, face, column, row)];
}

double solid_angle(double s0, double t0, double s1, double t1) {
    return corner(s1, t1) - corner(s0, t1) - corner(s1, t0) + corner(s0, t0);
}

CubeLight cube_light(const CubeFaces& faces) {
    CubeLight light;
    light.size = faces[0].width;
    const auto count = static_cast<std::size_t>(light.size) * static_cast<std::size_t>(light.size);
    light.texels.resize(6 * count);
    parallel_blocks(6, [&](std::size_t first, std::size_t last) {
        for (std::size_t face = first; face < last; ++face) {
            const auto channels = static_cast<std::size_t>(faces[face].channels);
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < 3; ++c) {
                    const float value = value_at(faces[face], i * channels + (channels >= 3 ? c : 0));
                    light.texels[face * count + i][c] = std::isfinite(value) ? value : 0;
                }
        }
    });
    return light;
}

CubeFaces half_faces(const CubeLight& light) {
    CubeFaces faces;
    const auto count = static_cast<std::size_t>(light.size) * static_cast<std::size_t>(light.size);
    const std::uint16_t one = float_to_half(1);
    for (std::size_t face = 0; face < 6; ++face) {
        Image& image = faces[face];
        image.width = image.height = light.size;
        image.type = PixelType::f16;
        image.pixels.resize(image.bytes());
        for (std::size_t i = 0; i < count; ++i) {
            std::array<std::uint16_t, 4> texel{0, 0, 0, one};
            for (std::size_t c = 0; c < 3; ++c)
                texel[c] = float_to_half(std::clamp(light.texels[face * count + i][c], -half_max, half_max));
            std::memcpy(image.pixels.data() + i * sizeof texel, texel.data(), sizeof texel);
        }
    }
    return faces;
}

CubeLight resized(const CubeLight& light, int size) {
    if (size == light.size) return light;
    CubeLight result;
    result.size = size;
    result.texels.resize(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const double scale = static_cast<double>(light.size) / size;
    const bool whole_texels = light.size % size == 0;
    const std::vector<double> angles = whole_texels ? solid_angles(light.size) : std::vector<double>();
    const auto part = [&](int x, int y, double left, double top) {
        if (whole_texels) return angles[texel_index(light.size, 0, x, y)];
        const double n = light.size;
        return solid_angle(std::max<double>(x, left) / n, std::max<double>(y, top) / n,
                           std::min(x + 1.0, left + scale) / n, std::min(y + 1.0, top + scale) / n);
    };
    const auto texel = [&](int face, int column, int row) {
        std::array<double, 3> sum{};
        double whole = 0;
        const double left = column * scale, right = left + scale, top = row * scale, bottom = top + scale;
        for (int y = static_cast<int>(top); y < light.size && y < bottom; ++y)
            for (int x = static_cast<int>(left); x < light.size && x < right; ++x) {
                const double weight = part(x, y, left, top);
                const auto& value = light.at(face, x, y);
                for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * static_cast<double>(value[c]);
                whole += weight;
            }
        std::array<float, 3> mean{};
        for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<float>(whole > 0 ? sum[c] / whole : 0);
        return mean;
    };
    const auto rows = static_cast<std::size_t>(size);
    parallel_blocks(6 * rows, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            for (int column = 0; column < size; ++column)
                result.texels[i * rows + static_cast<std::size_t>(column)] =
                    texel(static_cast<int>(i / rows), column, static_cast<int>(i % rows));
    });
    return result;
}

Harmonics harmonics(const CubeLight& light) {
    const double c1 = std::sqrt(3 / (4 * pi)), c2 = std::sqrt(15 / (4 * pi));
    const std::vector<double> angles = solid_angles(light.size);
    std::array<std::array<double, 3>, 9> sums{};
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < light.size; ++row)
            for (int column = 0; column < light.size; ++column) {
                auto [x, y, z] = face_direction(face, (column + .5) / light.size, (row + .5) / light.size);
                const double length = std::sqrt(x * x + y * y + z * z);
                x /= length, y /= length, z /= length;
                const double basis[9]{std::sqrt(1 / (4 * pi)),
                                      c1 * y,
                                      c1 * z,
                                      c1 * x,
                                      c2 * x * y,
                                      c2 * y * z,
                                      std::sqrt(5 / (16 * pi)) * (3 * z * z - 1),
                                      c2 * x * z,
                                      .5 * c2 * (x - y) * (x + y)};
                const double angle = angles[texel_index(light.size, 0, column, row)];
                for (std::size_t i = 0; i < 9; ++i)
                    for (std::size_t c = 0; c < 3; ++c)
                        sums[i][c] += angle * basis[i] * static_cast<double>(light.at(face, column, row)[c]);
            }
    Harmonics result{};
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t c = 0; c < 3; ++c) result[i][c] = static_cast<float>(sums[i][c]);
    return result;
}

int prefilter_size(int source_size, int largest) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(source_size, 16, largest))));
}

}  // namespace snell::content
