// Hard cases of frames, in each kind of context.
#pragma once

#include "tests/harness/harness.h"

namespace snell::test {

class HardFrames : public GlTest, public testing::WithParamInterface<ContextRequest> {
protected:
    void SetUp() override {
        request = GetParam();
        request.debug = true;
        GlTest::SetUp();
        if (GetParam().version == 33 && !GetParam().es) {  // Mesa gives more than was asked for
            caps.glsl = 330;
            caps.tessellation = caps.program_interface_query = caps.fp64 = false;
        }
        folder.write("plain.vert", plain_vertex);
        folder.write("color.frag", color_fragment);
        folder.write("texture.frag", texture_fragment);
    }
    // Unclamped, as the shaders wrote it; rows top first.
    std::vector<float> values(Document& document, int width = 64, int height = 64, const View& view = {},
                              int samples = 1, double time = 0) {
        const gl::Target target = gl::make_target(width, height, samples, gl::Pixels::rgba32f);
        document.runtime->draw({time, view, document.controls}, {target.framebuffer.get(), width, height});
        return gl::read_rgba32f(target.framebuffer.get(), width, height, target.samples);
    }
    std::vector<float> values(std::string_view scene) {
        auto document = open(scene);
        expect_clean(*document);
        return values(*document);
    }
};

#define SNELL_IN_ALL_CONTEXTS(Suite)                                                                   \
    INSTANTIATE_TEST_SUITE_P(                                                                          \
        All, Suite, testing::Values(ContextRequest{33}, ContextRequest{45}, ContextRequest{32, true}), \
        [](const auto& made) { return (made.param.es ? "Es" : "Core") + std::to_string(made.param.version); })

}  // namespace snell::test
