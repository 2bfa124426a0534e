// Pictures that are not drawn.
#pragma once

#include "src/accuracy/metrics.h"

namespace snell::test {

inline accuracy::Picture flat(int width, int height, float value) {
    return {width, height, std::vector<float>(4 * static_cast<std::size_t>(width * height), value)};
}

// No two parts of it are alike.
inline accuracy::Picture noise(int width, int height, unsigned seed) {
    accuracy::Picture picture = flat(width, height, 1);
    for (float& value : picture.rgba) {
        seed = seed * 1664525U + 1013904223U;
        value = static_cast<float>(seed >> 8) / static_cast<float>(1U << 24U);
    }
    return picture;
}

}  // namespace snell::test
