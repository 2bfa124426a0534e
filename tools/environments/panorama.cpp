#include "tools/environments/panorama.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <thread>

namespace snell::environments {
namespace {

constexpr double pi = 3.14159265358979323846;

Colour texel(const Radiance& radiance, const Panorama& p, int column, int row, int samples) {
    Colour sum(0);
    for (int i = 0; i < samples * samples; ++i) {
        const double u = (column + (i % samples + 0.5) / samples) / p.width;
        const double v = (row + (i / samples + 0.5) / samples) / p.height;
        const double longitude = (2.0 * u - 1.0) * pi, latitude = (0.5 - v) * pi, level = std::cos(latitude);
        sum += radiance({level * std::sin(longitude), std::sin(latitude), -level * std::cos(longitude)});
    }
    return sum / static_cast<double>(samples * samples);
}

using Rgbe = std::array<unsigned char, 4>;

Rgbe rgbe(const Colour& c) {
    const double largest = std::max({c.r, c.g, c.b});
    if (!(largest > 1e-32)) return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(largest, &exponent);
    const double scale = std::ldexp(256.0, -exponent);
    const auto mantissa = [&](double v) { return static_cast<unsigned char>(std::min(v * scale, 255.0)); };
    return {mantissa(c.r), mantissa(c.g), mantissa(c.b), static_cast<unsigned char>(exponent + 128)};
}

// One channel of a row: a count above 128 repeats the next byte count - 128 times, one below copies as many bytes.
void put_runs(std::string& out, const std::vector<Rgbe>& row, std::size_t channel) {
    const auto run_at = [&](std::size_t at) {
        std::size_t length = 1;
        while (at + length < row.size() && length < 127 && row[at + length][channel] == row[at][channel]) ++length;
        return length;
    };
    for (std::size_t at = 0; at < row.size();) {
        if (const std::size_t run = run_at(at); run > 3) {
            out.push_back(static_cast<char>(128 + run));
            out.push_back(static_cast<char>(row[at][channel]));
            at += run;
            continue;
        }
        std::size_t end = at + 1;
        while (end < row.size() && end - at < 128 && run_at(end) <= 3) ++end;
        out.push_back(static_cast<char>(end - at));
        for (; at < end; ++at) out.push_back(static_cast<char>(row[at][channel]));
    }
}

}  // namespace

Panorama render_panorama(const Radiance& radiance, int width, int samples) {
    Panorama p{width, width / 2, {}};
    p.texels.resize(static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height));
    const auto work = [&](int first) {
        for (int row = first; row < p.height; row += 2)
            for (int column = 0; column < p.width; ++column)
                p.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(p.width) +
                         static_cast<std::size_t>(column)] = texel(radiance, p, column, row, samples);
    };
    std::thread odd(work, 1);
    work(0);
    odd.join();
    return p;
}

std::string encode_hdr(const Panorama& panorama) {
    const auto width = static_cast<std::size_t>(panorama.width);
    std::string out = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(panorama.height) + " +X " +
                      std::to_string(panorama.width) + "\n";
    std::vector<Rgbe> row(width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(panorama.height); ++y) {
        for (std::size_t x = 0; x < width; ++x) row[x] = rgbe(panorama.texels[y * width + x]);
        out += {'\2', '\2', static_cast<char>(width >> 8), static_cast<char>(width & 255)};
        for (std::size_t channel = 0; channel < 4; ++channel) put_runs(out, row, channel);
    }
    return out;
}

}  // namespace snell::environments
