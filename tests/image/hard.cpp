// Hard cases of sums over pictures.
#include "src/content/cube/convolve.h"
#include "tests/hard_case.h"
#include "tests/image/help.h"

namespace snell::content {
namespace {

TEST(HardPictures, SumsOfManyTexels) {
    CubeLight light{256, {}};
    light.texels.assign(6 * 256 * 256, {.1F, .1F, .1F});
    float sum = 0;
    for (const auto& texel : light.texels) sum += texel[0];
    const double naive = static_cast<double>(sum) / static_cast<double>(light.texels.size());
    const double value = static_cast<double>(.1F);
    double worst = 0;
    for (const auto& texel : resized(light, 1).texels)
        worst = std::max(worst, std::abs(static_cast<double>(texel[0]) / value - 1));
    test::hard_case({"A23", "the mean of a cube map of 6 · 256² equal texels: summed in double; naive: in float",
                     "relative", 1e-7, worst, std::abs(naive / value - 1)});
}

}  // namespace
}  // namespace snell::content
