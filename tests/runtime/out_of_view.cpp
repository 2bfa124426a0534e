// Draws out of view are not handed to the driver, and no picture shows the difference.
#include <random>

#include "tests/harness/plain.h"

namespace snell::test {
namespace {

class OutOfView : public PlainTest {
protected:
    struct Seen {
        Counters counters;  // of one frame
        Picture picture;
    };
    // Of a frame that must look as if everything was drawn.
    Seen seen(Document& lean, Document& full, const Look& look) {
        const std::uint64_t culled = lean.runtime->counters().draws_culled, draws = lean.runtime->counters().draws;
        Seen result{{}, draw(lean, look)};
        EXPECT_TRUE(result.picture == draw(full, look));
        EXPECT_EQ(full.runtime->counters().draws_culled, 0U);
        result.counters.draws_culled = lean.runtime->counters().draws_culled - culled;
        result.counters.draws = lean.runtime->counters().draws - draws;
        return result;
    }
    std::unique_ptr<Document> open_full() {
        RuntimeOptions options;
        options.savings = false;
        return open_document(folder.path("scene.glib"), caps, nullptr, nullptr, options);
    }
    Seen seen(const std::string& scene, const Look& look = {}) {
        auto lean = open(scene);
        expect_clean(*lean);
        return seen(*lean, *open_full(), look);
    }
    std::uint64_t culled(const std::string& scene, const Look& look = {}) {
        return seen(scene, look).counters.draws_culled;
    }
};

// Looks along -Z, with planes through x = ±z and y = ±z.
std::string looking(const std::string& rest) {
    return "Perspective 90\nLookAt 0 0 0  0 0 -1  0 1 0\nBackground 0 0 0\n" + rest;
}

std::string ball(double x, double y, double z) {
    return "PushMatrix\nTranslate " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) +
           "\nSphere 1 12 12\nPopMatrix\n";
}

TEST_F(OutOfView, ABallThatReachesIntoACornerIsDrawn) {
    // A ball touches the plane x = z where its middle is the square root of 2 outside of it.
    for (const double side : {-1., 1.}) {
        const Seen in = seen(looking(ball(side * 11.3, side * 11.3, -10)), {.width = 256, .height = 256});
        EXPECT_EQ(in.counters.draws_culled, 0U);
        EXPECT_GT(
            seen(looking(ball(side * 11.0, side * 11.0, -10)), {.width = 256, .height = 256}).picture.count(white), 0);
        EXPECT_EQ(culled(looking(ball(side * 13, 0, -10)), {.width = 256, .height = 256}), 1U);
        EXPECT_EQ(culled(looking(ball(0, side * 13, -10)), {.width = 256, .height = 256}), 1U);
    }
}

TEST_F(OutOfView, WhatIsBehindTheEyeIsNotDrawn) {
    EXPECT_EQ(culled(looking(ball(0, 0, 2))), 1U);
    EXPECT_EQ(culled(looking(ball(0, 0, 0))), 0U) << "around the eye";
    EXPECT_EQ(culled("Ortho -1 1 -1 1\n" + ball(0, 0, 2)), 0U) << "no eye";
    EXPECT_EQ(culled("Ortho -1 1 -1 1\n" + ball(0, 0, 1002)), 1U);
    EXPECT_EQ(culled("Ortho -1 1 -1 1\n" + ball(3, 0, 0)), 1U);
}

// The planes are fitted to what is there, so a far one cuts nothing off before 1000.
TEST_F(OutOfView, WhatIsTooFarIsNotDrawn) {
    EXPECT_EQ(culled(looking(ball(0, 0, -990) + ball(0, 0, -5))), 0U);
    EXPECT_EQ(culled(looking(ball(0, 0, -1010) + ball(0, 0, -5))), 1U);
}

TEST_F(OutOfView, WhatTurnsOutOfViewIsNotDrawn) {
    std::string scene;
    for (int i = 0; i < 8; ++i) scene += ball(i - 3.5, 0, -10 - i);
    Look look;
    auto lean = open(looking(scene));
    const auto full = open_full();
    EXPECT_EQ(seen(*lean, *full, look).counters.draws_culled, 0U) << "all is in view";
    look.view.eye.rotate_y = 180;
    const Seen away = seen(*lean, *full, look);
    EXPECT_EQ(away.counters.draws_culled, 8U);
    EXPECT_EQ(away.counters.draws, 0U);
    look.view.eye.rotate_y = 0;
    EXPECT_EQ(seen(*lean, *full, look).counters.draws_culled, 0U);
    look.view.objects[3].x = 100;
    EXPECT_EQ(seen(*lean, *full, look).counters.draws_culled, 1U) << "one was dragged away";
    look.view.objects.clear();
    look.view.scene.x = 100;
    EXPECT_EQ(seen(*lean, *full, look).counters.draws_culled, 8U);
}

TEST_F(OutOfView, OfInstancesOnlyThoseInViewAreDrawn) {
    std::string scene;
    for (int i = 0; i < 40; ++i) scene += ball(0, 0, i < 20 ? -5 - i : 5 + i);
    const Seen half = seen(looking(scene));
    EXPECT_EQ(half.counters.draws_culled, 20U);
    EXPECT_EQ(half.counters.draws, 1U);
    Look look;
    look.view.eye.x = 1000;
    const Seen nothing = seen(looking(scene), look);
    EXPECT_EQ(nothing.counters.draws_culled, 40U);
    EXPECT_EQ(nothing.counters.draws, 0U);
}

// Six balls along the axes: each face of the cube shows one.
TEST_F(OutOfView, EachFaceOfACubeDrawsWhatItShows) {
    folder.write("cube.vert",
                 "out vec3 vDir;\nvoid main() { vDir = gl_Vertex.xyz + vec3(0., 0., .3); gl_Position = "
                 "gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("cube.frag",
                 "uniform samplerCube uCube;\nin vec3 vDir;\nvoid main() { gl_FragColor = texture(uCube, vDir); }\n");
    const std::string scene = "CubeMap 7 16\nRenderToCube 7\n" + ball(5, 0, 0) + ball(-5, 0, 0) + ball(0, 5, 0) +
                              ball(0, -5, 0) + ball(0, 0, 5) + ball(0, 0, -5) +
                              "RenderToTexture\nVertex cube.vert\nFragment cube.frag\nProgram Show uCube 7\n"
                              "Ortho -1 1 -1 1\nQuadXY\n";
    const Seen faces = seen(scene);
    EXPECT_EQ(faces.counters.draws, 7U) << "six balls and the window's quad";
    EXPECT_EQ(faces.counters.draws_culled, 30U);
}

// A shader that moves its vertices may put them anywhere.
TEST_F(OutOfView, WhatAShaderPlacesIsDrawn) {
    folder.write("moved.vert", "void main() { gl_Position = vec4(gl_Vertex.xy, 0., 1.); }\n");
    folder.write("kept.vert", "void main() { gl_Position = ftransform(); }\n");
    folder.write("named.vert",
                 "#version 330\nuniform mat4 PVM;\nin vec4 position;\nvoid main() { gl_Position = PVM * position; }\n");
    const auto scene = [&](const std::string& vertex, const std::string& uniforms = "") {
        return looking("Vertex " + vertex + "\nFragment color.frag\nProgram P uColor <1. 0. 0. 1.> " + uniforms + "\n" +
                       ball(0, 0, 9));
    };
    EXPECT_EQ(culled(scene("moved.vert")), 0U);
    EXPECT_EQ(culled(scene("kept.vert")), 1U);
    EXPECT_EQ(culled(scene("named.vert")), 1U);
    const Seen own = seen(scene("named.vert", "PVM <.1 0. 0. 0. 0. .1 0. 0. 0. 0. .1 0. 0. 0. 0. 1.>"));
    EXPECT_EQ(own.counters.draws_culled, 0U) << "the scene has its own matrix";
}

TEST_F(OutOfView, LinesAndPointsHaveAWidth) {
    const auto line = [&](double x, const std::string& state) {
        const std::string at = std::to_string(x);
        return "Ortho -1 1 -1 1\n" + state + "glBegin gl_lines\nglVertex " + at + " -1 0\nglVertex " + at +
               " 1 0\nglEnd\n";
    };
    const std::string state = "LineWidth 8\n";
    EXPECT_EQ(culled(line(1.1, state)), 0U) << "3 pixels outside of 64";
    EXPECT_EQ(culled(line(2, state)), 1U);
}

TEST_F(OutOfView, AFrameThatIsShiftedIsWhole) {
    auto lean = open(looking(ball(0, 0, 5) + ball(0, 0, -5)));
    const gl::Target target = gl::make_target(32, 32, 1);
    const View view;
    for (const double shift : {0., .5, 40.}) {
        const std::uint64_t before = lean->runtime->counters().draws_culled;
        lean->runtime->draw({.time = 0, .view = view, .controls = lean->controls, .shift = {shift, 0}},
                            {target.framebuffer.get(), 32, 32});
        EXPECT_EQ(lean->runtime->counters().draws_culled - before, shift < 1 ? 1U : 0U) << shift;
    }
}

// Random places, sizes and views: mostly at the edges of the picture.
TEST_F(OutOfView, NoPictureShowsIt) {
    std::mt19937 random(7);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.;
    };
    const auto text = [&](double low, double high) { return std::to_string(number(low, high)) + " "; };
    std::uint64_t away = 0, drawn = 0;
    for (const std::string& camera : {std::string("Perspective 60\nLookAt 0 0 5  0 0 0  0 1 0\n"),
                                      std::string("Ortho -2 2 -2 2\nLookAt 1 1 1  0 0 0  0 1 0\n"),
                                      std::string("Perspective 120\nLookAt 0 0 0  1 0 0  0 1 0\n")}) {
        std::string scene = camera;
        for (const char* shape :
             {"Sphere 1 8 8", "QuadXY 0 1", "Cone 1 1 6 3", "WireSphere 1 6 6", "Box 1 2 .5", "Torus .3 1 6 8",
              "LineWidth 5\nWireCube 1\nLineWidth 1", "Wireframe on\nSphere 1 6 6\nWireframe off"})
            for (int i = 0; i < 3; ++i)
                scene += "Color " + text(0, 1) + text(0, 1) + text(0, 1) + text(.3, 1.5) + "\nPushMatrix\nTranslate " +
                         text(-6, 6) + text(-6, 6) + text(-6, 6) + "\nRotate " + text(0, 360) + ".3 1 .2\nScale " +
                         text(.1, 1.5) + text(.1, 1.5) + text(.1, 1.5) + "\n" + shape + "\nPopMatrix\n";
        auto lean = open(scene);
        expect_clean(*lean);
        const auto full = open_full();
        for (int round = 0; round < 60; ++round) {
            Look look{.width = 24 + round % 9, .height = 24 + round % 7, .samples = round % 5 == 0 ? 4 : 1};
            look.view.scene.rotate_x = number(-180, 180);
            look.view.scene.rotate_y = number(-180, 180);
            look.view.eye.rotate_y = round % 3 == 0 ? number(-180, 180) : 0;
            look.view.scene.scale = std::exp(number(-1, 2));
            look.view.eye.z = number(-3, 3);
            if (round % 4 == 0) look.view.projection = Projection::ortho;
            if (round % 4 == 1) look.view.objects[static_cast<unsigned>(round % 24)].x = number(-5, 5);
            const Seen one = seen(*lean, *full, look);
            away += one.counters.draws_culled;
            drawn += one.counters.draws;
        }
    }
    EXPECT_GT(away, 500U);
    EXPECT_GT(drawn, 500U);
}

}  // namespace
}  // namespace snell::test
