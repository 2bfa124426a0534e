// Replaces non-finite values of floating-point images, because filtering would spread a single NaN over the whole mip
// chain.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "parser/text/words.h"
#include "src/content/image/formats.h"

namespace snell::content {
namespace {

constexpr float half_max = 65504.0f;

// Accesses width · height · depth · channels values in place.
class Grid {
public:
    Grid(const Image& shape, const std::vector<float>& values) : shape_(shape), values_(values) {}

    // Calls each(k) for the value itself and its eight neighbours in the same slice and channel.
    template <class Each>
    void around(std::size_t i, Each each) const {
        const auto channels = static_cast<std::size_t>(shape_.channels);
        const auto width = static_cast<std::int64_t>(shape_.width), height = static_cast<std::int64_t>(shape_.height);
        const auto texel = static_cast<std::int64_t>(i / channels);
        const std::int64_t x = texel % width, y = texel / width % height, slice = texel / width / height;
        for (std::int64_t v = std::max<std::int64_t>(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
            for (std::int64_t u = std::max<std::int64_t>(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                each(static_cast<std::size_t>((slice * height + v) * width + u) * channels + i % channels);
    }

    // The mean of the finite values around it; NaN if none is finite.
    float mean_around(std::size_t i) const {
        double sum = 0;
        int count = 0;
        around(i, [&](std::size_t k) {
            if (!std::isfinite(values_[k])) return;
            sum += static_cast<double>(values_[k]);
            ++count;
        });
        return count > 0 ? static_cast<float>(sum / count) : std::nanf("");
    }

private:
    const Image& shape_;
    const std::vector<float>& values_;
};

// Fills each hole from its edge inwards, one ring per round, so that the result does not depend on the order in which
// texels are visited. What has no finite value around it becomes 0. Returns the indices of the values that were
// replaced.
std::vector<std::size_t> mend(const Image& shape, std::vector<float>& values) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i])) all.push_back(i);
    const Grid grid(shape, values);
    std::vector<std::size_t> ring = all;  // later only what is next to the last ring: a hole may be wide
    while (!ring.empty()) {
        std::vector<std::pair<std::size_t, float>> found;
        for (const std::size_t i : ring)
            if (const float mean = grid.mean_around(i); !std::isnan(mean)) found.emplace_back(i, mean);
        for (const auto& [i, mean] : found) values[i] = mean;
        ring.clear();
        for (const auto& [i, mean] : found)
            grid.around(i, [&](std::size_t k) {
                if (!std::isfinite(values[k])) ring.push_back(k);
            });
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    }
    for (const std::size_t i : all)
        if (!std::isfinite(values[i])) values[i] = 0;
    return all;
}

}  // namespace

ImageResult half_image(Image shape, std::vector<float> values) {
    ImageResult result;
    result.replaced = mend(shape, values);
    if (const std::size_t count = result.replaced.size(); count > 0) {
        result.issues.push_back(
            {false, "image-non-finite",
             counted(count, "value") + " of the image " + (count == 1 ? "is" : "are") +
                 (count == 1 ? " infinite or NaN; it is replaced by the mean of its neighbours"
                             : " infinite or NaN; they are replaced by the mean of their neighbours"),
             "save the image with finite values"});
    }
    shape.type = PixelType::f16;
    shape.pixels.resize(shape.bytes());
    std::size_t clamped = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        float value = values[i];
        if (std::abs(value) > half_max) {
            value = std::copysign(half_max, value);
            ++clamped;
        }
        const std::uint16_t half = float_to_half(value);
        std::memcpy(shape.pixels.data() + 2 * i, &half, 2);
    }
    if (clamped > 0) {
        result.issues.push_back({false, "image-clamped",
                                 counted(clamped, "value") + " of the image " +
                                     (clamped == 1 ? "exceeds 65504, the largest half float; it is clamped"
                                                   : "exceed 65504, the largest half float; they are clamped"),
                                 "scale the image's values down"});
    }
    result.image = std::move(shape);
    return result;
}

}  // namespace snell::content
