// Scenes of the plain shaders, which stand in the test's folder.
#pragma once

#include "tests/harness/harness.h"

namespace snell::test {

inline constexpr Pixel red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255}, white{255, 255, 255, 255};

class PlainTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("plain.vert", plain_vertex);
        folder.write("color.frag", color_fragment);
        folder.write("texture.frag", texture_fragment);
    }
};

}  // namespace snell::test
