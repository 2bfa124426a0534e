// Gradient noise (Perlin, "An Image Synthesizer", 1985) on a lattice that repeats with the texture. The fade is the
// cubic polynomial of that paper, which fits the rows of glman's own textures better than the quintic of "Improving
// Noise" (2002).
#include "src/content/image/noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "parser/text/words.h"
#include "src/content/workers.h"

namespace snell::content {
namespace {

// Standard deviations of r, g, b, a that scenes are tuned to, in units where 255 is 1.
constexpr std::array<std::array<double, 4>, 2> deviations{{{.074, .024, .014, .0070}, {.066, .032, .017, .0075}}};
constexpr int centre = 127;

using Gradient = std::array<float, 3>;

std::uint64_t mixed(std::uint64_t x) {  // the finaliser of splitmix64
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

// A uniformly distributed unit vector; in 2D, z is 0.
Gradient random_direction(int dimensions, std::uint64_t key) {
    const double two_pi = 2 * std::acos(-1.0);
    const std::uint64_t bits = mixed(key);
    const double angle = static_cast<double>(bits >> 32) / 0x1p32 * two_pi;
    const double z = dimensions == 3 ? static_cast<double>(bits & 0xffffffffu) / 0x1p32 * 2 - 1 : 0;
    const double r = std::sqrt(1 - z * z);
    return {static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)), static_cast<float>(z)};
}

// The position of a texel in its lattice cell. It is computed from integers, so that the noise at lattice points is
// exactly zero.
struct Place {
    int cell = 0, next = 0;
    float offset = 0, fade = 0;  // 0..1 from the cell's lower corner
};

std::vector<Place> places(int size, int cells) {
    std::vector<Place> result(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
        const std::int64_t position = std::int64_t{i} * cells;
        Place& p = result[static_cast<std::size_t>(i)];
        p.cell = static_cast<int>(position / size);
        p.next = (p.cell + 1) % cells;
        const double t = static_cast<double>(position % size) / size;
        p.offset = static_cast<float>(t);
        p.fade = static_cast<float>(t * t * (3 - 2 * t));
    }
    return result;
}

// One octave, which is one channel of the texture.
class Octave {
public:
    Octave(int dimensions, int size, int channel)
        // If the texture is too small for the octave, a cell has two texels: with one, all values would be zero.
        : cells_(std::clamp(size / 2, 1, 4 << channel)),
          layers_(dimensions == 3 ? cells_ : 1),
          places_(places(size, cells_)) {
        for (int z = 0; z < layers_; ++z) {
            for (int y = 0; y < cells_; ++y) {
                for (int x = 0; x < cells_; ++x) {
                    const auto key = static_cast<std::uint64_t>(((channel * 64 + z) * 64 + y) * 64 + x + 1);
                    gradients_.push_back(random_direction(dimensions, key * 0x9e3779b97f4a7c15u));
                }
            }
        }
    }

    // Computes the row of texels at (y, z), written `step` floats apart. Along a row the contribution of each lattice
    // column is linear in x, so the four corners of a column become two numbers for each cell boundary.
    void row(int y, int z, float* out, std::size_t step) const {
        std::array<float, 32> at_zero{}, slope{};
        const Place& py = places_[static_cast<std::size_t>(y)];
        const Place pz = layers_ > 1 ? places_[static_cast<std::size_t>(z)] : Place{};
        for (int x = 0; x < cells_; ++x) {
            const auto i = static_cast<std::size_t>(x);
            for (int corner = 0; corner < (layers_ > 1 ? 4 : 2); ++corner) {
                const bool up = corner % 2 != 0, far = corner / 2 != 0;
                const Gradient& g = gradient(x, up ? py.next : py.cell, far ? pz.next : pz.cell);
                const float weight = (up ? py.fade : 1 - py.fade) * (far ? pz.fade : 1 - pz.fade);
                at_zero[i] +=
                    weight * (g[1] * (py.offset - (up ? 1.0f : 0.0f)) + g[2] * (pz.offset - (far ? 1.0f : 0.0f)));
                slope[i] += weight * g[0];
            }
        }
        for (const Place& p : places_) {
            const auto a = static_cast<std::size_t>(p.cell), b = static_cast<std::size_t>(p.next);
            const float left = at_zero[a] + slope[a] * p.offset, right = at_zero[b] + slope[b] * (p.offset - 1);
            *out = left + p.fade * (right - left);
            out += step;
        }
    }

private:
    const Gradient& gradient(int x, int y, int z) const {
        return gradients_[static_cast<std::size_t>((z * cells_ + y) * cells_ + x)];
    }

    int cells_, layers_;
    std::vector<Place> places_;
    std::vector<Gradient> gradients_;
};

// The factor from noise to texel values that gives the wanted deviation, including that of rounding (a variance of
// 1/12).
float amplitude(double wanted, double square_sum, std::size_t count) {
    const double variance = square_sum / static_cast<double>(count);
    if (variance < 1e-12) return 0;
    return static_cast<float>(std::sqrt(std::max(wanted * wanted * 255 * 255 - 1.0 / 12, 0.0) / variance));
}

}  // namespace

Image make_noise(int dimensions, int size) {
    Image image;
    size = std::clamp(size, 1, 512);
    image.width = image.height = size;
    image.depth = dimensions == 3 ? size : 1;
    image.bottom_first = true;
    image.pixels.resize(image.bytes());
    const auto rows = static_cast<std::size_t>(size), slices = static_cast<std::size_t>(image.depth);
    const std::vector<Octave> octaves{
        {dimensions, size, 0}, {dimensions, size, 1}, {dimensions, size, 2}, {dimensions, size, 3}};

    const auto fill_row = [&](std::size_t row, std::vector<float>& out) {
        for (std::size_t c = 0; c < 4; ++c)
            octaves[c].row(static_cast<int>(row % rows), static_cast<int>(row / rows), out.data() + c, 4);
    };
    // The sum of each row is stored separately, so that the total does not depend on the number of threads.
    std::vector<std::array<double, 4>> squares(rows * slices);
    parallel_blocks(rows * slices, [&](std::size_t first, std::size_t last) {
        std::vector<float> values(rows * 4);
        for (std::size_t row = first; row < last; ++row) {
            fill_row(row, values);
            for (std::size_t i = 0; i < values.size(); ++i)
                squares[row][i % 4] += static_cast<double>(values[i]) * static_cast<double>(values[i]);
        }
    });
    std::array<float, 4> scale{};
    for (std::size_t c = 0; c < 4; ++c) {
        const double sum =
            std::accumulate(squares.begin(), squares.end(), 0.0, [c](double s, const auto& row) { return s + row[c]; });
        scale[c] = amplitude(deviations[dimensions == 3 ? 1 : 0][c], sum, rows * rows * slices);
    }
    parallel_blocks(rows * slices, [&](std::size_t first, std::size_t last) {
        std::vector<float> values(rows * 4);
        for (std::size_t row = first; row < last; ++row) {
            fill_row(row, values);
            std::byte* const out = image.pixels.data() + row * image.row_bytes();
            for (std::size_t i = 0; i < values.size(); ++i) {
                const float value = std::floor(values[i] * scale[i % 4] + (centre + 0.5f));
                out[i] = static_cast<std::byte>(std::clamp(value, 0.0f, 255.0f));
            }
        }
    });
    return image;
}

std::string noise_file_name(int dimensions, int size) {
    std::string digits = std::to_string(size);
    if (digits.size() < 3) digits.insert(0, 3 - digits.size(), '0');
    return "noise" + std::to_string(dimensions) + "d." + digits + ".tex";
}

int noise_file_size(int dimensions, std::string_view name) {
    constexpr std::size_t digits = std::string_view("noise3d.").size();
    if (name.size() < digits) return 0;
    const int size = std::atoi(std::string(name.substr(digits, 6)).c_str());
    return size > 0 && same_word(name, noise_file_name(dimensions, size)) ? size : 0;
}

}  // namespace snell::content
