// Chains of rough mirrors, looked up by the library.
#include "src/content/cube/convolve.h"
#include "tests/library/common.h"

namespace snell::test {
namespace {

class LibraryRough : public LibraryTest {
protected:
    // Level l of the chain shows l everywhere.
    void set_numbered_chain(int size) {
        std::vector<std::vector<glm::vec4>> colors;
        std::vector<std::array<gl::Texels, 6>> levels;
        for (int level = 0; level < content::prefilter_levels(size); ++level) {
            const int side = size >> level;
            colors.emplace_back(static_cast<std::size_t>(side * side), glm::vec4(level));
            levels.emplace_back().fill(
                {gl::Pixels::rgba32f, side, side, 1, reinterpret_cast<const std::byte*>(colors.back().data())});
        }
        cube = gl::make_cube_levels(levels);
    }
    static constexpr std::string_view include = "#include <snell/environment.glsl>\n";
    static constexpr std::string_view lookup = "return vec4(snellPrefiltered(cube, a.xyz, b.x), 1.);";
};

// Roughness runs evenly through the levels, whatever their number; the shader counts them as the CPU does.
TEST_P(LibraryRough, RoughnessIsTheLevel) {
    for (const int size : {16, 64, 256}) {
        set_numbered_chain(size);
        const int last = content::prefilter_levels(size) - 1;
        std::vector<Arguments> arguments;
        const auto directions = unit_vectors(1000);
        for (std::size_t i = 0; i < directions.size(); ++i)
            arguments.push_back({{glm::vec3(directions[i]), 0}, {static_cast<float>(i) / 999, 0, 0, 0}, {}});
        const auto results = run(include, lookup, arguments);
        for (std::size_t i = 0; i < arguments.size(); ++i)
            EXPECT_NEAR(results[i].x, arguments[i].b.x * static_cast<float>(last), .01) << size;
    }
}

// Hard case 17 for chains: whatever goes in, light of some level comes out.
TEST_P(LibraryRough, NothingMeaninglessComesOut) {
    set_numbered_chain(64);
    for (const glm::vec4& r : run(include, lookup, special_arguments(3000))) {
        EXPECT_TRUE(finite(r));
        EXPECT_TRUE(r.x >= 0 && r.x <= 3) << r.x;
    }
}

SNELL_IN_ALL_DIALECTS(LibraryRough);

}  // namespace
}  // namespace snell::test
