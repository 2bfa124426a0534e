// A picture drawn part by part is the picture drawn at once: but for single pixels at edges, where vertices come to lie
// between two points of the driver's grid (1/256 of a pixel) and are rounded the other way.
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

struct Parts {
    int width = 64, height = 64;
};

struct Difference {
    int pixels = 0, most = 0;
};

Difference difference(const Picture& a, const Picture& b) {
    Difference found;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const Pixel one = a.at(x, y), other = b.at(x, y);
            found.pixels += one != other;
            for (std::size_t i = 0; i < 4; ++i) found.most = std::max(found.most, std::abs(one[i] - other[i]));
        }
    return found;
}

class RuntimeParts : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("lit.vert",
                     "out vec3 vN;\nvoid main() { vN = gl_NormalMatrix * gl_Normal; gl_Position = ftransform(); }\n");
        folder.write("lit.frag", "in vec3 vN;\nvoid main() { gl_FragColor = vec4(.5 + .5 * normalize(vN), 1.); }\n");
        folder.write("screen.frag",
                     "uniform vec2 uResolution;\nvoid main() {\n  vec2 p = gl_FragCoord.xy / uResolution;\n"
                     "  float ring = sin(40. * length(p - .5));\n  gl_FragColor = vec4(p, .5 + .5 * ring, 1.);\n}\n");
    }

    Picture in_parts(Document& document, const Look& look, Parts size) {
        Picture picture{look.width, look.height, {}};
        picture.rgba.resize(static_cast<std::size_t>(look.width * look.height) * 4);
        const gl::Target target = gl::make_target(size.width, size.height, look.samples);
        for (int bottom = 0; bottom < look.height; bottom += size.height)
            for (int left = 0; left < look.width; left += size.width) {
                Surface surface{target.framebuffer.get(), look.width, look.height};
                surface.part = {left, bottom, size.width, size.height};
                document.runtime->draw({look.time, look.view, document.controls}, surface);
                const auto rows = gl::read_rgba8(target.framebuffer.get(), size.width, size.height, target.samples);
                copy(rows, size, {left, bottom}, picture);
            }
        return picture;
    }

    static void copy(const std::vector<std::byte>& rows, Parts size, std::array<int, 2> at, Picture& picture) {
        for (int y = 0; y < size.height; ++y) {
            const int row = picture.height - at[1] - size.height + y;  // from the top
            const int columns = std::min(size.width, picture.width - at[0]);
            if (row < 0) continue;
            std::memcpy(&picture.rgba[static_cast<std::size_t>(row * picture.width + at[0]) * 4],
                        &rows[static_cast<std::size_t>(y * size.width) * 4], static_cast<std::size_t>(columns) * 4);
        }
    }

    void expect_same(const std::string& scene, Look look = {.width = 250, .height = 190}) {
        auto document = open(scene);
        expect_clean(*document);
        const Picture whole = draw(*document, look);
        for (const Parts size : {Parts{64, 64}, Parts{100, 38}, Parts{250, 16}}) {
            const Difference found = difference(whole, in_parts(*document, look, size));
            EXPECT_LE(found.pixels, whole.width * whole.height / 1000)
                << size.width << "x" << size.height << ", by up to " << found.most << "\n"
                << scene;
        }
        EXPECT_EQ(difference(whole, draw(*document, look)).pixels, 0) << "and whole again";
        int other = 0;
        for (int y = 0; y < whole.height; ++y)
            for (int x = 0; x < whole.width; ++x) other += whole.at(x, y) != whole.at(0, 0);
        EXPECT_GT(other, 200) << "there is something to see\n" << scene;
    }
};

const std::string lit = "Vertex lit.vert\nFragment lit.frag\nProgram Lit\n";
const std::string perspective = "Perspective 50\nLookAt 1 1.2 3  0 0 0  0 1 0\nBackground .2 .3 .6\n";

TEST_F(RuntimeParts, Perspective) {
    expect_same(perspective + lit + "Teapot\nTranslate 1.2 0 -1\nTorus .3 .6 30 30\n");
}

TEST_F(RuntimeParts, Ortho) { expect_same("Ortho -1 1 -1 1\n" + lit + "Rotate 40 1 1 0\nBox 1 1 1\n"); }

TEST_F(RuntimeParts, ManySamples) {
    expect_same(perspective + lit + "Teapot\n", {.width = 250, .height = 190, .samples = 4});
}

TEST_F(RuntimeParts, PointSprites) {
    folder.write("point.frag",
                 "void main() { gl_FragColor = vec4(gl_PointCoord, fract(gl_FragCoord.x / 20.), 1.); }\n");
    expect_same(perspective + "PointSize 21\nVertex lit.vert\nFragment point.frag\nProgram Points\nPointCloud 5 5 5\n");
}

TEST_F(RuntimeParts, LinesWideLinesAndWireframe) {
    expect_same(perspective + lit + "WireSphere 1\n");
    expect_same(perspective + lit + "LineWidth 7\nWireTeapot\n");
    expect_same(perspective + lit + "Wireframe on\nTeapot\n");
}

TEST_F(RuntimeParts, Axes) {
    Look look{.width = 250, .height = 190};
    look.view.axes = true;
    look.view.scene.rotate_y = 30;
    expect_same(perspective + lit + "Sphere .5\n", look);
}

TEST_F(RuntimeParts, WhatAsksForItsPlaceInThePicture) {
    expect_same(perspective + "Fragment screen.frag\nProgram Screen\nSphere 1\n");
    folder.write("macro.frag",
                 "#define AT gl_FragCoord\nuniform vec2 uResolution;\nvec2 at(vec4 p) { return p.xy / uResolution; }\n"
                 "void main() { gl_FragColor = vec4(at(AT), AT.z, 1.); }\n");
    expect_same(perspective + "Fragment macro.frag\nProgram Screen\nSphere 1\n");
    folder.write(
        "upper.frag",
        "#version 330\nlayout(origin_upper_left, pixel_center_integer) in vec4 gl_FragCoord;\nout vec4 color;\n"
        "void main() { color = vec4(gl_FragCoord.xy / 256., 0., 1.); }\n");
    expect_same(perspective + "Fragment upper.frag\nProgram Screen\nSphere 1\n");
}

TEST_F(RuntimeParts, WhatIsDerivedFromNeighbours) {
    folder.write("derived.frag",
                 "in vec3 vN;\nvoid main() { gl_FragColor = vec4(40. * abs(dFdx(vN.x)), 40. * abs(dFdy(vN.y)), "
                 "fwidth(vN.z) * 20., 1.); }\n");
    expect_same(perspective + "Vertex lit.vert\nFragment derived.frag\nProgram Derived\nTeapot\n");
}

TEST_F(RuntimeParts, WhatIsRenderedToTexturesIsWhole) {
    folder.write("plain.vert", plain_vertex);
    folder.write("texture.frag", texture_fragment);
    expect_same(
        "Texture2D 5 64 64\nOrtho -1 1 -1 1\nFragment screen.frag\nProgram Screen\nRenderToTexture 5\nQuadXY 0 .8\n"
        "RenderToTexture\nVertex plain.vert\nFragment texture.frag\nProgram Show uUnit 5\nQuadXY 0 .9\n"
        "Vertex plain.vert\nFragment screen.frag\nProgram Again\nQuadXY .1 .2\n");
}

TEST_F(RuntimeParts, ManyAlike) {
    std::string scene = perspective + "Vertex lit.vert\nFragment screen.frag\nProgram Many\n";
    for (int i = 0; i < 40; ++i)
        scene += "PushMatrix\nTranslate " + std::to_string(i % 8 * .3 - 1) + " " + std::to_string(i / 8 * .3 - .7) +
                 " 0\nSphere .1\nPopMatrix\n";
    expect_same(scene);
}

// What does not ask for places is not compiled again.
TEST_F(RuntimeParts, CostNothingWhereNothingAsksForPlaces) {
    auto document = open(perspective + lit + "Sphere 1\n");
    const std::uint64_t before = document->runtime->counters().programs_compiled;
    in_parts(*document, {}, {32, 32});
    EXPECT_EQ(document->runtime->counters().programs_compiled, before);
    document = open(perspective + "Fragment screen.frag\nProgram Screen\nSphere 1\n");
    const std::uint64_t first = document->runtime->counters().programs_compiled;
    in_parts(*document, {}, {32, 32});
    EXPECT_EQ(document->runtime->counters().programs_compiled, first + 1);
    draw(*document);
    in_parts(*document, {}, {32, 32});
    EXPECT_EQ(document->runtime->counters().programs_compiled, first + 1) << "and kept";
}

TEST_F(RuntimeParts, AnotherBackground) {
    auto document = open("Background 1 0 0\nOrtho -1 1 -1 1\nColor 0 1 0\nQuadXY 0 .5\n");
    const gl::Target target = gl::make_target(32, 32, 1);
    const View view;
    document->runtime->draw({.time = 0, .view = view, .controls = document->controls, .background = Vec4{0, 0, 1, 0}},
                            {target.framebuffer.get(), 32, 32});
    Picture picture{32, 32, gl::read_rgba8(target.framebuffer.get(), 32, 32, 1)};
    EXPECT_EQ(picture.at(1, 1), (Pixel{0, 0, 255, 0}));
    EXPECT_EQ(picture.at(16, 16), (Pixel{0, 255, 0, 255}));
}

}  // namespace
}  // namespace snell::test
