#include "tools/environments/faces.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "src/optics/cube.h"

namespace snell::environments {
namespace {

// Shoulder for the bright parts (Hable-like rational curve, Narkowicz 2015), then sRGB's transfer function.
double display(double linear) {
    const double x = std::max(linear, 0.0);
    const double toned = std::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
    return toned <= 0.0031308 ? 12.92 * toned : 1.055 * std::pow(toned, 1.0 / 2.4) - 0.055;
}

Colour texel(const Radiance& radiance, int face, int column, int row, int size, int samples) {
    Colour sum(0);
    for (int i = 0; i < samples * samples; ++i) {
        const int across = i % samples, down = i / samples;
        const double x = column + (across + 0.5) / samples, y = row + (down + 0.5) / samples;
        const Colour seen = radiance(optics::cube_direction({face, x / size, y / size}));
        sum += Colour(display(seen.r), display(seen.g), display(seen.b));
    }
    return sum / static_cast<double>(samples * samples);
}

Face render_face(const Radiance& radiance, int face, int size, int samples) {
    Face result{size, {}};
    result.rgb.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 3);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const Colour c = texel(radiance, face, column, row, size, samples);
            for (int channel = 0; channel < 3; ++channel)
                result.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0 * c[channel])));
        }
    return result;
}

void put(std::string& out, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

}  // namespace

Faces render_faces(const Radiance& radiance, int size, int samples) {
    Faces faces;
    const auto work = [&](int first) {
        for (int face = first; face < 6; face += 2)
            faces[static_cast<std::size_t>(face)] = render_face(radiance, face, size, samples);
    };
    std::thread odd(work, 1);
    work(0);
    odd.join();
    return faces;
}

std::string encode_bmp(const Face& face) {
    const auto size = static_cast<std::uint32_t>(face.size);
    const std::uint32_t row_bytes = (size * 3 + 3) / 4 * 4, header_bytes = 54;
    std::string out = "BM";
    put(out, header_bytes + row_bytes * size, 4), put(out, 0, 4), put(out, header_bytes, 4);
    put(out, 40, 4), put(out, size, 4), put(out, size, 4), put(out, 1, 2), put(out, 24, 2), put(out, 0, 4);
    put(out, row_bytes * size, 4), put(out, 2835, 4), put(out, 2835, 4), put(out, 0, 4), put(out, 0, 4);
    for (std::uint32_t row = size; row-- > 0;) {
        for (std::uint32_t column = 0; column < size; ++column) {
            const std::uint8_t* texel = &face.rgb[(std::size_t{row} * size + column) * 3];
            for (int channel : {2, 1, 0}) out.push_back(static_cast<char>(texel[channel]));
        }
        out.append(row_bytes - size * 3, '\0');
    }
    return out;
}

}  // namespace snell::environments
