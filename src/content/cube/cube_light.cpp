// Cube maps as light: resizing, means and spherical harmonics, weighted by solid angle.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "src/content/cube/convolve.h"
#include "src/content/parallel.h"

namespace snell::content {
namespace {

const double pi = std::acos(-1.0);
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
