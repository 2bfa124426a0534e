// Hard cases of frames and drivers, in each kind of context.
#include <epoxy/egl.h>

#include "src/app/picture/non_finite.h"
#include "src/gl/program.h"
#include "src/runtime/resources/uniforms.h"
#include "tests/hard_case.h"
#include "tests/oracle/optics/refraction.h"
#include "tests/runtime/hard_frames.h"
#include "tests/std.h"

namespace snell::test {
namespace {

class HardScenes : public HardFrames {};

constexpr std::string_view flat = "Ortho -1 1 -1 1\nBackground 0 0 0\n";

// Pixels where the far one of two walls shows, that are 1e-3 apart and both lean.
double fighting(const Picture& picture) { return picture.count({0, 255, 0, 255}); }

TEST_P(HardScenes, WallsThatNearlyTouchDoNotFight) {
    folder.write("placed.vert",
                 "void main() { gl_Position = gl_ModelViewProjectionMatrix * vec4(gl_Vertex.xyz, gl_Vertex.w); }\n");
    const auto walls = [](const std::string& vertex) {
        return "Perspective 10\nBackground 0 0 0\nLookAt 0 0 50 0 0 0 0 1 0\nVertex " + vertex +
               "\nFragment color.frag\nProgram Near uColor {1. 0. 0. 1.}\nRotate 50 0 1 0\nQuadXY 0 5\n"
               "Program Far uColor {0. 1. 0. 1.}\nQuadXY -.001 5\n";
    };
    const Picture ours = draw(walls("plain.vert"), {.width = 200, .height = 200});
    const Picture usual = draw(walls("placed.vert"), {.width = 200, .height = 200});
    EXPECT_GT(ours.count({255, 0, 0, 255}), 5000);
    hard_case({"34", "two walls 1e-3 apart at distance 50; naive: near .1, far 1000 in 24 bits", "pixels that fight", 0,
               fighting(ours), fighting(usual)});
}

// In a drag the window's pictures have half or a quarter of the pixels.
TEST_P(HardScenes, LinesAndPointsAreAsThickInCoarsePictures) {
    folder.write("line.geom",
                 "#version 330 compatibility\nlayout(points) in;\nlayout(line_strip, max_vertices = 2) out;\n"
                 "void main() {\n    for (int i = 0; i < 2; ++i) {\n"
                 "        gl_Position = vec4(float(2 * i - 1), .3, 0., 1.);\n        EmitVertex();\n    }\n"
                 "    EndPrimitive();\n}\n");
    const std::string paint = std::string(flat) + "Vertex plain.vert\nFragment color.frag\n",
                      program = "Program P uColor {1. 1. 1. 1.}\n";
    const std::string scenes[]{
        paint + "LineWidth 24\nGeometry line.geom\n" + program + "PointCloud 1 1 1\n",
        paint + "LineWidth 24\n" + program + "glBegin gl_lines\nglVertex -1 0 0\nglVertex 1 0 0\nglEnd\n",
        paint + "PointSize 32\n" + program + "glBegin gl_points\nglVertex 0 0 0\nglEnd\n",
    };
    for (const std::string& scene : scenes) {
        const double fine = draw(scene, {.width = 256, .height = 256}).count({255, 255, 255, 255});
        EXPECT_GT(fine, 800) << scene;
        for (const int divide : {2, 4}) {
            const Look look{.width = 256 / divide, .height = 256 / divide, .enlarged = divide};
            EXPECT_NEAR(divide * divide * draw(scene, look).count({255, 255, 255, 255}) / fine, 1, .1)
                << scene << divide;
        }
    }
}

// Where vertices go elsewhere than their mesh says, the planes stay where they were: nothing is cut off.
TEST_P(HardScenes, WhatAShaderMovesIsNotCutOff) {
    folder.write("moved.vert",
                 "void main() { gl_Position = gl_ModelViewProjectionMatrix * (gl_Vertex + vec4(0., 0., 30., 0.)); }\n");
    const Picture moved = draw(
        "Perspective 60\nBackground 0 0 0\nLookAt 0 0 50 0 0 0 0 1 0\nVertex moved.vert\nFragment color.frag\n"
        "Program Moved uColor {1. 0. 0. 1.}\nQuadXY 0 9\n");
    EXPECT_TRUE(near(moved.center(), {255, 0, 0, 255}));
    folder.write("far.frag", "void main() { gl_FragColor = vec4(vec3(gl_FragCoord.z), 1.); }\n");
    const Picture depth = draw(
        "Perspective 60\nLookAt 0 0 50 0 0 0 0 1 0\nVertex plain.vert\nFragment far.frag\nProgram Depth\nQuadXY 0 "
        "40\n");
    EXPECT_TRUE(near(depth.center(), {254, 254, 254, 255}, 1)) << "who reads depth reads that of the usual planes";
}

TEST_P(HardScenes, ColoursOutsideOfZeroAndOne) {
    const auto all =
        values(std::string(flat) + "Vertex plain.vert\nFragment color.frag\nProgram C uColor {2. -1. .5 1.}\nQuadXY\n");
    const std::array<double, 3> given{2, -1, .5};
    double worst = 0, clamped = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(static_cast<double>(all[c]) - given[c]));
        clamped = std::max(clamped, std::abs(std::clamp(given[c], 0., 1.) - given[c]));
    }
    hard_case(
        {"47", "a colour of 2 -1 .5 reaches the shader as it is; naive: clamped to 0..1", "off", 0, worst, clamped});
}

TEST_P(HardScenes, PicturesAreTheShadersValues) {
    folder.write("ramp.frag", "in vec2 vST;\nvoid main() { gl_FragColor = vec4(vec3(vST.s), 1.); }\n");
    const std::string scene = std::string(flat) + "Vertex plain.vert\nFragment ramp.frag\nProgram R\nQuadXY\n";
    auto document = open(scene);
    const auto exact = values(*document);
    const Picture bytes = draw(*document);
    double worst = 0, encoded = 0;
    for (std::size_t i = 0; i < exact.size(); i += 4) {
        const double v = static_cast<double>(exact[i]), byte = std::to_integer<int>(bytes.rgba[i]);
        worst = std::max(worst, std::abs(byte - 255 * v));
        const double srgb = v <= .0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - .055;
        encoded = std::max(encoded, std::abs(srgb * 255 - 255 * v));
    }
    hard_case({"48", "pictures hold the shader's values, as glman's did; naive: encoded as sRGB", "of 255", .51, worst,
               encoded});
}

TEST_P(HardScenes, AFrameIsTheSameHoweverItWasReached) {
    folder.write("timer.frag",
                 "uniform float Timer;\nvoid main() { gl_FragColor = vec4(vec3(fract(Timer * 97.)), 1.); }\n");
    const std::string scene =
        "Timer 7\nVertex plain.vert\nFragment timer.frag\nProgram T\nLookAt 0 0 4 0 0 0 0 1 0\nSphere\n";
    auto document = open(scene);
    // The clock of a loop that adds the duration of each frame, for an hour at 60 frames a second.
    float summed = 0;
    for (int i = 0; i < 216'000; ++i) summed += 1 / 60.F;
    const Picture added = draw(*document, {.time = static_cast<double>(summed)});
    for (const double time : {0., 100., 2.5}) draw(*document, {.time = time});
    const Picture reached = draw(*document, {.time = 3600}), fresh = draw(scene, {.time = 3600});
    const auto differing = [](const Picture& a, const Picture& b) {
        int count = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i) count += a.rgba[i] != b.rgba[i];
        return static_cast<double>(count);
    };
    hard_case({"53",
               "the frame at 3600 s, drawn at once or after others; naive: a float that adds up sixtieths of a second",
               "bytes that differ", 0, differing(reached, fresh), differing(added, fresh)});
}

TEST_P(HardScenes, NotANumberIsCounted) {
    folder.write("nan.frag",
                 "in vec2 vST;\nvoid main() { gl_FragColor = vec4(vST.s < .25 ? sqrt(vST.s - 1.) : vST.s < .5 ? 1. / "
                 "(vST.s - vST.s) : .5, 0., 0., 1.); }\n");
    auto document = open(std::string(flat) + "Vertex plain.vert\nFragment nan.frag\nProgram N\nQuadXY\n");
    const View view;
    const auto found = app::count_non_finite(*document->runtime, {0, view, document->controls}, 64, 64);
    ASSERT_TRUE(found);
    constexpr double there = 64 * 32;
    hard_case({"55", "NaN and infinity are counted before they are clamped to 0 or 255", "of 2048 pixels unseen", 0,
               std::abs(there - static_cast<double>(found->nan + found->infinite)), std::nullopt});
}

TEST_P(HardScenes, MipmapsAreChosenWhereNeighboursAreDiscarded) {
    std::vector<std::array<int, 3>> texels;
    for (int i = 0; i < 64 * 64; ++i)
        texels.push_back(i / 64 % 2 == i % 2 ? std::array{255, 255, 255} : std::array{0, 0, 0});
    folder.write("checks.bmp", bmp(64, 64, texels));
    const auto with = [&](std::string_view discard) {
        folder.write("t.frag",
                     "uniform sampler2D uUnit;\nin vec2 vST;\nvoid main() { vec4 c = texture(uUnit, 3. * vST); " +
                         std::string(discard) + " gl_FragColor = c; }\n");
        return draw(std::string(flat) +
                    "Filter mipmap\nTexture2D 5 checks.bmp\nVertex plain.vert\nFragment t.frag\nProgram T uUnit "
                    "5\nQuadXY\n");
    };
    const Picture all = with(""),
                  some = with("if (mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 2.) > .5) discard;");
    int worst = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = (y + 1) % 2; x < 64; x += 2) worst = std::max(worst, std::abs(all.at(x, y)[0] - some.at(x, y)[0]));
    hard_case({"56", "mipmaps next to discarded pixels: looked up before the discard", "of 255", 1,
               static_cast<double>(worst), std::nullopt});
}

TEST_P(HardScenes, EdgesOfBrightThingsAreSmooth) {
    const auto scene = [](const char* color) {
        return std::string(flat) + "Vertex plain.vert\nFragment color.frag\nProgram C uColor {" + color +
               "}\nRotate 20 0 0 1\nQuadXY 0 .5\n";
    };
    const Look look{.samples = 4};
    const Picture one = draw(scene("1. 1. 1. 1."), look), bright = draw(scene("100. 100. 100. 1."), look);
    auto document = open(scene("100. 100. 100. 1."));
    const auto resolved = values(*document, 64, 64, {}, 4);
    double worst = 0, late = 0;
    for (std::size_t i = 0; i < one.rgba.size(); i += 4) {
        const int right = std::to_integer<int>(one.rgba[i]);
        worst = std::max(worst, std::abs(std::to_integer<int>(bright.rgba[i]) - right) + 0.0);
        late = std::max(late, std::abs(255 * std::clamp(static_cast<double>(resolved[i]), 0., 1.) - right));
    }
    hard_case(
        {"57",
         "multisampled edges of a colour of 100 are those of white; naive: clamped after the samples are averaged",
         "of 255", 1, worst, late});
}

TEST_P(HardScenes, WhatIsLargerThanTheDriverTakes) {
    caps.max_texture = 16;
    folder.write("large.bmp", bmp(32, 32, std::vector<std::array<int, 3>>(32 * 32, {255, 0, 0})));
    const auto textured =
        open(std::string(flat) +
             "Texture2D 5 large.bmp\nVertex plain.vert\nFragment texture.frag\nProgram T uUnit 5\nQuadXY\n");
    draw(*textured);
    hard_case({"58", "a texture of more texels than the driver takes is an error that says so", "not said", 0,
               has(*textured, "texture-too-large") ? 0. : 1., std::nullopt});
    folder.write("array.frag",
                 "uniform int uAt;\nuniform vec4 uBig[300000];\nvoid main() { gl_FragColor = uBig[uAt]; }\n");
    const auto array =
        open(std::string(flat) +
             "Vertex plain.vert\nFragment array.frag\nProgram A\nQuadXY\nProgram\nColor 0 1 0\nQuadXY 0 .5\n");
    const Picture rest = draw(*array);
    const bool said = array->diagnostics.has_errors() && near(rest.center(), {0, 255, 0, 255});
    hard_case({"60", "a uniform array larger than the driver takes: an error at its program, and the rest is drawn",
               "not said or drawn", 0, said ? 0. : 1., std::nullopt});
    complaints.clear();  // the driver's own about the array
}

TEST_P(HardScenes, LinesWiderThanTheDriverDraws) {
    caps.max_line_width = 1;
    const auto off = [&](const char* width) {
        const Picture line = draw(
            std::string(flat) + "LineWidth " + width + "\nglBegin gl_lines\nglVertex -1 0 0\nglVertex 1 0 0\nglEnd\n",
            {.width = 101, .height = 101});
        int rows = 0;
        for (int y = 0; y < 101; ++y) rows += near(line.at(50, y), {255, 255, 255, 255});
        return std::abs(rows - 9.);
    };
    hard_case({"59", "a line of 9 pixels where the driver draws 1; naive: the driver's line", "pixels off", 0, off("9"),
               off("1")});
}

TEST_P(HardScenes, OddSizes) {
    folder.write("place.frag",
                 "uniform vec2 uResolution;\nvoid main() { vec2 p = floor(gl_FragCoord.xy);\n"
                 "gl_FragColor = vec4(mod(p, 256.) / 255., p.x < uResolution.x && p.y < uResolution.y, 1.); }\n");
    int wrong = 0;
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 777), std::pair(16384, 1)}) {
        if (width > caps.max_texture) continue;
        auto document = open(std::string(flat) + "Vertex plain.vert\nFragment place.frag\nProgram P\nQuadXY 0 1e5\n");
        const Picture picture = draw(*document, {.width = width, .height = height});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                wrong += picture.at(x, y) != Pixel{x % 256, (height - 1 - y) % 256, 255, 255};
    }
    hard_case({"63", "pictures of 1 × 1, 3 × 777, 16384 × 1: each pixel is drawn at its place", "pixels wrong", 0,
               static_cast<double>(wrong), std::nullopt});
}

TEST_P(HardScenes, TexturesThatGlLeavesBlack) {
    folder.write("red.bmp", bmp(4, 4, std::vector<std::array<int, 3>>(16, {255, 0, 0})));
    const Picture mipmapped = draw(std::string(flat) +
                                   "Filter mipmap\nTexture2D 5 red.bmp\nVertex plain.vert\nFragment texture.frag\n"
                                   "Program T uUnit 5\nQuadXY\n");
    hard_case({"A17", "a texture that is asked to be mipmapped has its levels; naive: GL samples black",
               "pixels not red", 0, 64. * 64 - mipmapped.count({255, 0, 0, 255}), std::nullopt});
    folder.write("both.frag",
                 "uniform sampler2D uPicture;\nuniform samplerCube uCube;\nin vec2 vST;\nvoid main() { gl_FragColor = "
                 "texture(uPicture, vST) + texture(uCube, vec3(vST, 1.)); }\n");
    folder.write("blue.bmp", bmp(4, 4, std::vector<std::array<int, 3>>(16, {0, 0, 255})));
    std::string faces;
    for (int i = 0; i < 6; ++i) faces += " blue.bmp";
    const Picture both = draw(std::string(flat) + "Texture2D 6 red.bmp\nCubeMap 6" + faces +
                              "\nVertex plain.vert\nFragment both.frag\nProgram B uPicture 6 uCube 6\nQuadXY\n");
    hard_case({"A18", "a picture and a cube map on one unit in one program; naive: GL refuses to draw", "pixels wrong",
               0, 64. * 64 - both.count({255, 0, 255, 255}), std::nullopt});
}

TEST_P(HardScenes, ShadersWithoutAVersion) {
    const std::string vertex = "out vec2 vPlace;\nvoid main() { vPlace = gl_Vertex.xy; gl_Position = ftransform(); }\n";
    const std::string fragment = "in vec2 vPlace;\nvoid main() { gl_FragColor = vec4(0., 1., 0., 1.); }\n";
    folder.write("old.vert", vertex);
    folder.write("old.frag", fragment);
    const Picture picture = draw(std::string(flat) + "Vertex old.vert\nFragment old.frag\nProgram O\nQuadXY\n");
    const double refused =
        !gl::compile(GL_VERTEX_SHADER, vertex).shader + !gl::compile(GL_FRAGMENT_SHADER, fragment).shader;
    complaints.clear();  // the driver's own about these
    hard_case({"A4",
               "shaders without #version that mix old and new words; naive: the driver, which takes them for 1.10",
               "of 2 refused", 0, near(picture.center(), {0, 255, 0, 255}) ? 0. : 2., refused});
    folder.write("unread.frag", "uniform float Timer;\nvoid main() { gl_FragColor = vec4(1., 0., 0., 1.); }\n");
    auto document = open(std::string(flat) + "Fragment unread.frag\nProgram T Timer <0. 0. 1.>\nQuadXY\n");
    hard_case({"A33", "a Timer that a shader declares and does not read asks for no frames", "of 1 animated", 0,
               document->runtime->animated() ? 1. : 0., std::nullopt});
}

TEST_P(HardScenes, TwoProgramsOfOneUniformName) {
    const Picture picture = draw(std::string(flat) +
                                 "Vertex plain.vert\nFragment color.frag\nProgram A uColor {1. 0. 0. 1.}\nQuadXY\n"
                                 "Program B uColor {0. 0. 1. 1.}\nQuadXY .5 .5\n");
    int wrong = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool inner = x >= 16 && x < 48 && y >= 16 && y < 48;
            wrong += !near(picture.at(x, y), inner ? Pixel{0, 0, 255, 255} : Pixel{255, 0, 0, 255});
        }
    hard_case({"64", "two programs with a uniform of one name keep their own values", "pixels of another colour", 0,
               static_cast<double>(wrong), std::nullopt});
}

TEST_P(HardScenes, AContextWithoutADisplay) {
    GLint major = 0, minor = 0, mask = 0, profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    profile = GetParam().es ? 1 : 0;
    if (!GetParam().es) {
        glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
        profile = mask & GL_CONTEXT_CORE_PROFILE_BIT;
    }
    const bool right = profile != 0 && major * 10 + minor >= GetParam().version;
    EGLint count = 0;
    const EGLint defaults[] = {EGL_NONE};
    EGLConfig config = nullptr;
    eglChooseConfig(eglGetCurrentDisplay(), defaults, &config, 1, &count);
    hard_case({"66",
               "a context without a display, of the profile and version asked for; naive: EGL's default attributes",
               "of 1 not made", 0, right ? 0. : 1., count == 0 ? std::optional(1.) : std::nullopt});
}

TEST_P(HardScenes, TheEyeThatLooksThroughTheSceneTransformation) {
    folder.write("eye.vert",
                 "uniform vec3 uViewerPositionEye;\nout vec3 vTrue, vNaive;\nvoid main() {\n"
                 "vec3 p = (gl_ModelViewMatrix * gl_Vertex).xyz;\nvTrue = p - uViewerPositionEye;\nvNaive = p;\n"
                 "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("eye.frag",
                 "uniform bool uTrue;\nin vec3 vTrue, vNaive;\nvoid main() { gl_FragColor = vec4(uTrue ? vTrue : "
                 "vNaive, 1.); }\n");
    View view;
    view.scene.rotate_y = 40;
    view.scene.x = .3;
    const auto direction = [&](const char* flag) {
        auto document = open("LookAt 0 0 5 0 0 0 0 1 0\nVertex eye.vert\nFragment eye.frag\nProgram E uTrue " +
                             std::string(flag) + "\nQuadXY 0 3\n");
        expect_clean(*document);
        const auto all = values(*document, 65, 65, view);
        const std::size_t at = (32 * 65 + 32) * 4;
        return glm::dvec3(all[at], all[at + 1], all[at + 2]);
    };
    // The middle of the picture is seen along -Z; the scene turned by 40 degrees sees that ray turned back.
    const double turn = glm::radians(40.);
    const glm::dvec3 truth(std::sin(turn), 0, -std::cos(turn));
    hard_case(
        {"67",
         "the ray of the viewer in a scene that was turned by hand, by uViewerPositionEye; naive: from the origin",
         "rad", 1e-5, optics::angle_between(direction("<true>"), truth),
         optics::angle_between(direction("<false>"), truth)});
}

SNELL_IN_ALL_CONTEXTS(HardScenes);

// ---- Hard cases of time: what a clock of floats makes of it beside ours.

float timer(double time, double period) { return static_cast<float>(runtime::timer_value(time, period)); }

bool is_phase(float value) { return value >= 0 && value < 1; }

TEST(HardTime, AfterTenDays) {
    float clock = 0;
    constexpr int frames = 10 * 86400 * 60;
    for (int i = 0; i < frames; ++i) clock += 1 / 60.F;
    const double time = 864000.125;
    hard_case({"49", "the Timer after ten days; naive: a float that adds up sixtieths", "s", 1e-6,
               std::abs(static_cast<double>(timer(time, 10)) * 10 - .125),
               std::abs(static_cast<double>(clock) - 864000.)});
}

TEST(HardTime, TheSawtoothStaysBelowOne) {
    int ours = 0, naive = 0;
    for (const double time : {9.9999999999, 20 - 1e-9, 1e9 - 1e-6, 10.0}) {
        ours += !is_phase(timer(time, 10));
        naive += !is_phase(static_cast<float>(std::fmod(time, 10) / 10));
    }
    hard_case({"50", "the Timer just before its period ends; naive: fmod, then float", "of 4 that reach 1", 0,
               static_cast<double>(ours), static_cast<double>(naive)});
    const double edge = 10 - 1e-9;
    hard_case({"A39", "a nanosecond before the period ends the Timer is the largest float below 1", "from it", 0,
               static_cast<double>(std::abs(std::nextafter(1.F, 0.F) - timer(edge, 10))), std::nullopt});
}

TEST(HardTime, PeriodsAndClocksOfEveryKind) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    int ours = 0, naive = 0, back = 0, back_naive = 0;
    for (const double period : {0., -1., 1e-9, 1e9, nan}) {
        ours += !is_phase(timer(12.5, period));
        naive += !is_phase(static_cast<float>(std::fmod(12.5, period) / period));
    }
    hard_case({"51", "periods of 0, -1, 1e-9, 1e9, NaN; naive: fmod", "of 5 outside of [0,1)", 0,
               static_cast<double>(ours), static_cast<double>(naive)});
    // A clock that was set back, or slept for a year.
    for (const double time : {-1e-12, -3., -1e9, 3.2e7, HUGE_VAL}) {
        back += !is_phase(timer(time, 10));
        back_naive += !is_phase(static_cast<float>(std::fmod(time, 10) / 10));
    }
    hard_case({"52", "a clock that goes back, or jumps by a year; naive: fmod", "of 5 outside of [0,1)", 0,
               static_cast<double>(back), static_cast<double>(back_naive)});
}

TEST(HardTime, FramesAtAnOddRate) {
    float sum = 0;
    constexpr int frames = 10'000;
    for (int i = 0; i < frames; ++i) sum += 1 / 29.97F;
    hard_case({"54", "frame 10,000 at 29.97 a second is at 10,000 / 29.97 s; naive: a float that adds up", "s", 1e-9,
               std::abs(runtime::frame_time(frames, 29.97) - frames / 29.97),
               std::abs(static_cast<double>(sum) - frames / 29.97)});
}

}  // namespace
}  // namespace snell::test
