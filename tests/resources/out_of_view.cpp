// Draws out of view are not handed to the driver, and no picture shows the difference.
#include "src/runtime/resources/mesh.h"
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

// The bounds of a mesh are those of its finite positions.
TEST_F(OutOfView, AMeshMayHaveNoBounds) {
    content::Mesh mesh;
    mesh.positions = {{3, 0, 0}, {3, 1, 0}, {2, .5F, 0}};
    mesh.indices = {0, 1, 2};
    EXPECT_TRUE(runtime::upload(mesh).bounded);
    for (const float odd : {INFINITY, -INFINITY, NAN}) {
        mesh.positions[2][1] = odd;
        EXPECT_FALSE(runtime::upload(mesh).bounded);
    }
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
    const auto point = [](double x) {
        return "Ortho -1 1 -1 1\nPointSize 20\nglBegin gl_points\nglVertex " + std::to_string(x) + " 0 0\nglEnd\n";
    };
    EXPECT_EQ(culled(point(1.3)), 0U) << "9.6 pixels outside of 64";
    EXPECT_EQ(culled(point(2)), 1U);
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

class PassesOutOfView : public OutOfView {
protected:
    void SetUp() override {
        OutOfView::SetUp();
        folder.write("clock.frag",
                     "#version 330 compatibility\nuniform float uTime;\nvoid main() { gl_FragColor = "
                     "vec4(fract(uTime * vec3(.1, .3, .7)), 1.); }\n");
        folder.write("cube.vert",
                     "out vec3 vDir;\nvoid main() { vDir = gl_Vertex.xyz; gl_Position = ftransform(); }\n");
        folder.write(
            "cube.frag",
            "uniform samplerCube uCube;\nin vec3 vDir;\nvoid main() { gl_FragColor = texture(uCube, vDir); }\n");
    }
    // What the pass draws changes with the time.
    static std::string pass(int unit, const std::string& what) {
        return "RenderToTexture " + std::to_string(unit) + "\nOrtho -1 1 -1 1\n" + what + "RenderToTexture\n";
    }
    static std::string clock() { return "Vertex plain.vert\nFragment clock.frag\nProgram Clock\nQuadXY\n"; }
    static std::string show(int unit) {
        return "Vertex plain.vert\nFragment texture.frag\nProgram Show uUnit " + std::to_string(unit) + "\n";
    }
    static std::string mirror(int unit) {
        return looking(show(unit) + "PushMatrix\nTranslate 0 0 -3\nQuadXY 0 1\nPopMatrix\n");
    }
    static Look turned(double time, double degrees = 180) {
        Look look{.time = time};
        look.view.eye.rotate_y = degrees;
        return look;
    }
};

TEST_F(PassesOutOfView, AreNotDrawnUntilSomethingInViewReadsThem) {
    auto lean = open("Texture2D 5 8 8\n" + pass(5, clock()) + mirror(5));
    expect_clean(*lean);
    const auto full = open_full();
    EXPECT_EQ(seen(*lean, *full, {.time = 1}).counters.draws, 2U);
    EXPECT_EQ(seen(*lean, *full, turned(2)).counters.draws, 0U);
    EXPECT_EQ(seen(*lean, *full, turned(3)).counters.draws, 0U);
    EXPECT_EQ(seen(*lean, *full, {.time = 4}).counters.draws, 2U)
        << "as of now, not of the time when it was last drawn";
    EXPECT_EQ(seen(*lean, *full, turned(4)).counters.draws, 0U);
}

TEST_F(PassesOutOfView, AreThoseThatOthersOutOfViewRead) {
    auto lean =
        open("Texture2D 5 8 8\nTexture2D 6 8 8\n" + pass(5, clock()) + pass(6, show(5) + "QuadXY\n") + mirror(6));
    expect_clean(*lean);
    const auto full = open_full();
    EXPECT_EQ(seen(*lean, *full, {.time = 1}).counters.draws, 3U);
    EXPECT_EQ(seen(*lean, *full, turned(2)).counters.draws, 0U);
    EXPECT_EQ(seen(*lean, *full, {.time = 3}).counters.draws, 3U);
}

// A pass reads what a later one left in the frame before, so that one must be drawn in each frame.
TEST_F(PassesOutOfView, AreDrawnWhereTheNextFrameMayReadThem) {
    const std::string later = show(6) + "QuadXY\n";
    auto lean = open("Texture2D 5 8 8\nTexture2D 6 8 8\n" + pass(5, later) + pass(6, clock()) + mirror(5));
    expect_clean(*lean);
    const auto full = open_full();
    seen(*lean, *full, {.time = 1});
    for (const double time : {2., 3.}) EXPECT_EQ(seen(*lean, *full, turned(time)).counters.draws, 1U);
    seen(*lean, *full, {.time = 4});
}

TEST_F(PassesOutOfView, AreDrawnWhereTwoDrawToATexture) {
    auto lean = open("Texture2D 5 8 8\n" + pass(5, clock()) +
                     pass(5, "Program\nColor 1 0 0\nQuadXY 0 .5\nColor 1 1 1\n") + mirror(5));
    expect_clean(*lean);
    const auto full = open_full();
    seen(*lean, *full, {.time = 1});
    EXPECT_EQ(seen(*lean, *full, turned(2)).counters.draws, 2U);
    seen(*lean, *full, {.time = 3});
}

// In such a frame off-screen passes are not drawn again; those that were not drawn at all are.
TEST_F(PassesOutOfView, AreDrawnInAStandingFrameThatShowsThem) {
    auto lean = open("Texture2D 5 8 8\n" + pass(5, clock()) + mirror(5));
    expect_clean(*lean);
    const auto full = open_full();
    draw(*lean, {.time = 1});
    draw(*lean, turned(2));
    const gl::Target target = gl::make_target(64, 64, 1);
    const View view;
    std::uint64_t draws = lean->runtime->counters().draws;
    for (const unsigned now : {2U, 1U}) {
        lean->runtime->draw({.time = 2, .view = view, .controls = lean->controls, .standing = true},
                            {target.framebuffer.get(), 64, 64});
        EXPECT_EQ(lean->runtime->counters().draws - draws, now);
        draws = lean->runtime->counters().draws;
        const auto pixels = gl::read_rgba8(target.framebuffer.get(), 64, 64, target.samples, target.pixels);
        EXPECT_TRUE(pixels == draw(*full, {.time = 2}).rgba);
    }
}

// Paced frames draw one face each, but never show faces of before the ball was out of view.
TEST_F(PassesOutOfView, OfACubeAreWholeWhenTheyAreInViewAgain) {
    auto lean = open(
        "CubeMap 7 8\nRenderToCube 7 0 0 0 1\nVertex plain.vert\nFragment clock.frag\nProgram Clock\nSphere 5\n"
        "RenderToTexture\n" +
        looking("Vertex cube.vert\nFragment cube.frag\nProgram Show uCube 7\nPushMatrix\nTranslate 0 0 -3\n"
                "Sphere 1\nPopMatrix\n"));
    expect_clean(*lean);
    const gl::Target target = gl::make_target(32, 32, 1);
    const auto faces = [&](const Look& look) {
        const std::uint64_t before = lean->runtime->counters().cube_faces;
        lean->runtime->draw({.time = look.time, .view = look.view, .controls = lean->controls, .paced = true},
                            {target.framebuffer.get(), 32, 32});
        return lean->runtime->counters().cube_faces - before;
    };
    EXPECT_EQ(faces({.time = 1}), 6U);
    EXPECT_EQ(faces({.time = 2}), 1U);
    EXPECT_EQ(faces(turned(3)), 0U);
    EXPECT_TRUE(lean->runtime->settled());
    EXPECT_EQ(faces({.time = 4}), 6U);
    EXPECT_EQ(faces({.time = 5}), 1U);
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
