// NaN and infinity from wherever a number comes in: an error, or replaced with a warning. One test for each entry of
// the table in docs/reliability.md.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "src/app/open/states.h"
#include "tests/cli/run.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();
// Others: SetNotFinite.*
const std::array<const char*, 3> not_finite{"nan", "-inf", "1e400"};

std::string float_bytes(const std::vector<float>& values) {
    std::string text(values.size() * sizeof(float), '\0');
    std::memcpy(text.data(), values.data(), text.size());
    return text;
}

// 4 x 4 texels of 1 with one that is not finite.
std::vector<float> texels(float wrong, int channels) {
    std::vector<float> values(static_cast<std::size_t>(16 * channels), 1);
    for (int c = 0; c < std::min(channels, 3); ++c) values[static_cast<std::size_t>(5 * channels + c)] = wrong;
    return values;
}

class NonFiniteInput : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("a.frag", "uniform float uA;\nvoid main() { gl_FragColor = vec4(uA, 0., 0., 1.); }\n");
        folder.write("t.frag",
                     "#version 330 compatibility\nuniform sampler2D uT;\nin vec2 vST;\n"
                     "void main() { gl_FragColor = texture(uT, vST); }\n");
        folder.write("v.vert", plain_vertex);
        folder.write("s.glib", settable);
    }
    std::string at(const std::string& name) const { return folder.path(name); }
    Outcome render(const std::string& arguments) const {
        return snell("render --size 16x16 --count-non-finite " + at("s.glib") + " -o " + at("o.png") + " " + arguments);
    }
    // A scene that is drawn whole, with a warning, and without one pixel that is no number.
    void expect_replaced(const std::string& text, const std::string& code) {
        folder.write("s.glib", text);
        const Outcome outcome = render("");
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        EXPECT_TRUE(outcome.says("[" + code + "]")) << outcome.output;
        EXPECT_TRUE(outcome.says("0 pixels are NaN and 0 are infinite")) << outcome.output;
    }
    // An error; the rest is drawn, and nothing of it is no number.
    void expect_refused(const std::string& text) {
        folder.write("s.glib", text);
        const Outcome outcome = render("");
        EXPECT_EQ(outcome.status, 1) << text << outcome.output;
        const bool told = outcome.says("[not-finite]") || outcome.says("[number-too-large]");
        EXPECT_TRUE(told) << text << outcome.output;
        EXPECT_TRUE(outcome.says("0 pixels are NaN and 0 are infinite")) << outcome.output;
    }

    static constexpr const char* settable = "Fragment a.frag\nProgram P uA <0. .5 1.>\nQuadXY 0. 2.\n";
    static constexpr const char* textured =
        "Vertex v.vert\nFragment t.frag\nProgram P uT 5\nOrtho -1 1 -1 1\nQuadXY 0. 1.\n";
};

TEST_F(NonFiniteInput, NumbersOfTheSceneAreErrors) {
    for (const std::string word : not_finite) {
        expect_refused("Fragment a.frag\nProgram P uA " + word + "\nQuadXY 0. 2.\n");
        expect_refused("Fragment a.frag\nProgram P uA <0. .5 " + word + ">\nQuadXY 0. 2.\n");
        expect_refused("Translate 0 0 " + word + "\nSphere\n");
        expect_refused("Color 1 " + word + " 0\nSphere\n");
    }
}

// Where NaN begins, and only where: the expressions that only go on with it are not told.
TEST_F(NonFiniteInput, CheckTellsWhereNaNBegins) {
    folder.write("s.glib", "Vertex v.vert\nFragment k.frag\nProgram P uA <0. 0. 1.>\nOrtho -1 1 -1 1\nQuadXY 0. 1.\n");
    folder.write("w.vert",
                 "#version 330 compatibility\nuniform float uA;\nout float vK;\nvoid main() {\n"
                 "vK = uA / uA;\ngl_Position = ftransform();\n}\n");
    folder.write("w.frag", "#version 330 compatibility\nin float vK;\nvoid main() { gl_FragColor = vec4(vK * 2.); }\n");
    folder.write("w.glib", "Vertex w.vert\nFragment w.frag\nProgram P uA <0. 0. 1.>\nOrtho -1 1 -1 1\nQuadXY 0. 1.\n");
    const auto check = [&](const std::string& main, const std::string& version = "#version 330 compatibility\nin") {
        folder.write("k.frag", version +
                                   " vec2 vST;\nuniform float uA;\nfloat half_of(float x) { return .5 * x; }\n"
                                   "void main() {\n" +
                                   main + "\n}\n");
        return snell("check " + at("s.glib"));
    };
    struct Row {
        std::string main, place, words;
    };
    for (const Row& row : std::initializer_list<Row>{
             {"float k = uA * length(vST);\ngl_FragColor = vec4(sin(k) / k);", "7:21", "'sin(k) / k' is NaN"},
             {"float k = uA; float x = 2. * k;\nx /= k;\ngl_FragColor = vec4(half_of(x));", "7:1", "0 is divided by 0"},
             {"gl_FragColor = vec4(\n  half_of(sqrt(uA - 1.)) + 1.);", "7:11", "square root of a negative number"},
             {"vec3 n = normalize(vec3(uA));\ngl_FragColor = vec4(n, 1.);", "6:10", "a vector of length 0"},
             {"mat2 m = inverse(mat2(uA, 1., uA, 1.));\ngl_FragColor = vec4(m[0] * uA, 0., 1.);", "6:10",
              "the matrix has no inverse"},
             {"float big = exp(100. + uA);\ngl_FragColor = vec4(big * uA);", "6:13",
              "is infinite, and NaN (not a number) is computed from it"},
             {"float far = 1. / uA;\ngl_FragColor = vec4(far * uA);", "6:13", "a number is divided by 0"},
             // NaN that does not reach the colour is not told.
             {"float lost = uA / uA;\nif (lost > 2.) discard;\ngl_FragColor = vec4(log(uA - 1.));", "8:21",
              "logarithm of a negative number"}}) {
        const Outcome told = check(row.main);
        EXPECT_EQ(told.status, 0) << "a warning";
        EXPECT_TRUE(told.says("k.frag:" + row.place + ": warning: '")) << row.main << told.output;
        EXPECT_TRUE(told.says(row.words)) << row.main << told.output;
        EXPECT_TRUE(told.says("s.glib:3:1: note: the program")) << told.output;
    }
    EXPECT_TRUE(check("gl_FragColor = vec4(vST.s + uA / uA);").says("in 16384 of the 16384 pixels"));
    EXPECT_TRUE(
        check("gl_FragColor = vec4(vST.s + uA / uA);", "varying").says("k.frag:5:29: warning: 'uA / uA' is NaN"));
    EXPECT_FALSE(check("gl_FragColor = vec4(sin(uA + 1.) / (uA + 1.));").says("NaN"));
    const Outcome before = snell("check " + at("w.glib"));
    EXPECT_TRUE(before.says("w.vert:5:6: warning: 'uA / uA' is NaN")) << before.output;
    // Neither gives a colour without the other.
    const Outcome both = check("float a = sqrt(uA - 1.), b = sqrt(vST.y - 9.);\ngl_FragColor = vec4(a, b, 0., 1.);");
    EXPECT_TRUE(both.says("s.glib:3:1: warning: program 'P' computes NaN")) << both.output;
    // Words stay apart where something is written between them.
    EXPECT_EQ(check("gl_FragColor = vec4(lit(vST.x));\n}\nfloat lit(float x) {\nif (x > uA) return(1.);\nreturn(0.);",
                    "#version 330 compatibility\nfloat lit(float x);\nin")
                  .output,
              "");
    // Several colours: the place is not certain.
    const Outcome two = check("c = d = vec4(uA / uA);", "#version 330\nout vec4 c, d; in");
    EXPECT_TRUE(two.says("s.glib:3:1: warning: program 'P' computes NaN")) << two.output;
    // Where places in the picture count, it is as large as the scene's window.
    folder.write("s.glib",
                 "WindowSize 16 12\nVertex v.vert\nFragment k.frag\nProgram P uA <0. 0. 1.>\n"
                 "Ortho -1 1 -1 1\nQuadXY 0. 1.\n");
    EXPECT_FALSE(check("gl_FragColor = vec4(sqrt(16. - gl_FragCoord.x) + uA);").says("NaN"));
    EXPECT_TRUE(check("gl_FragColor = vec4(sqrt(8. - gl_FragCoord.x) + uA);").says("square root of a negative"));
}

// What a shader that never ends would show tells nothing: only that is said.
TEST_F(NonFiniteInput, EndlessLoopsAreToldAlone) {
    folder.write("s.glib", "Vertex v.vert\nFragment k.frag\nProgram P uA <0. 0. 1.>\nOrtho -1 1 -1 1\nQuadXY 0. 1.\n");
    for (const std::string loop : {"while (true) x += uA / uA;", "for (int i = 0; i < 9; --i) x += uA / uA;",
                                   "int i = 0; while (i < 9) x += uA * 0.;"}) {
        folder.write("k.frag", "#version 330 compatibility\nuniform float uA;\nvoid main() { float x = 0.; " + loop +
                                   "\ngl_FragColor = vec4(x); }\n");
        const Outcome told = snell("check " + at("s.glib"));
        EXPECT_TRUE(told.says("for ever")) << told.output;
        EXPECT_FALSE(told.says("NaN")) << told.output;
        EXPECT_FALSE(told.says("no effect")) << told.output;
    }
}

TEST_F(NonFiniteInput, OptionsAreRefused) {
    for (const std::string word : not_finite) {
        const Outcome set = render("--set uA=" + word);
        EXPECT_EQ(set.status, 1) << word << set.output;
        EXPECT_EQ(snell("save " + at("s.glib") + " --set uA=" + word).status, 1) << word;
        for (const std::string option : {"--time ", "--view x=", "--view scale=", "--fps ", "--timeout "})
            EXPECT_EQ(render(option + word).status, 2) << option << word;
        const std::string sweep = "sweep --size 16x16 " + at("s.glib") + " -o " + at("{index}.png");
        EXPECT_NE(snell(sweep + " --over uA=0," + word).status, 0) << word;
        EXPECT_NE(snell(sweep + " --over uA=0:" + word + ":3").status, 0) << word;
    }
    EXPECT_EQ(bytes_of(at("s.glib")), settable) << "save wrote";
}

TEST_F(NonFiniteInput, RawTexturesAreMended) {
    std::array<std::int32_t, 2> sides{4, 4};
    std::string head(8, '\0');
    std::memcpy(head.data(), sides.data(), 8);
    for (const float wrong : {not_a_number, infinite, -infinite}) {
        folder.write("a.tex", head + float_bytes(texels(wrong, 4)));
        expect_replaced("Texture2D 5 a.tex\n" + std::string(textured), "image-non-finite");
    }
    folder.write("a.tex", head + float_bytes(texels(1e30F, 4)));
    expect_replaced("Texture2D 5 a.tex\n" + std::string(textured), "image-clamped");
}

TEST_F(NonFiniteInput, PfmPicturesAreMended) {
    for (const float wrong : {not_a_number, infinite, -infinite}) {
        folder.write("a.pfm", "PF\n4 4\n-1.0\n" + float_bytes(texels(wrong, 3)));
        expect_replaced("Texture2D 5 a.pfm\n" + std::string(textured), "image-non-finite");
    }
}

TEST_F(NonFiniteInput, ExrPicturesAreMended) {
    content::Image image;
    image.width = image.height = 4;
    image.channels = 3;
    image.type = content::PixelType::f32;
    const std::string pixels = float_bytes(texels(not_a_number, 3));
    image.pixels.resize(pixels.size());
    std::memcpy(image.pixels.data(), pixels.data(), pixels.size());
    ASSERT_EQ(content::write_image(at("a.exr"), image), "");
    expect_replaced("Texture2D 5 a.exr\n" + std::string(textured), "image-non-finite");
}

// RGBE can't hold NaN; its largest exponent is beyond what textures hold.
TEST_F(NonFiniteInput, HdrPicturesAreClamped) {
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 4\n";
    for (int i = 0; i < 16; ++i) file += i == 5 ? std::string("\xff\xff\xff\xff") : std::string("\x80\x80\x80\x81");
    folder.write("a.hdr", file);
    expect_replaced("Texture2D 5 a.hdr\n" + std::string(textured), "image-clamped");
}

TEST_F(NonFiniteInput, ObjFacesAreLeftOut) {
    for (const std::string word : not_finite) {
        folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 " + word + "\nf 1 2 3\nf 2 3 4\n");
        expect_replaced("Obj a.obj\n", "obj-not-a-number");
    }
}

// The window's sliders, snapshots and presets take their numbers by the same way as --set.
TEST_F(NonFiniteInput, SnapshotsAreNotTaken) {
    auto document = open_file(at("s.glib"));
    ASSERT_TRUE(document->runtime);
    Control* control = document->controls.find(0, "uA");
    ASSERT_NE(control, nullptr);
    for (const char* value : {"NaN", "Infinity", "1e400", "null", "1e39", "nan"}) {
        folder.write("s.snapshots.json", "{\"1\": {\"options\": \"--set P.uA=" + std::string(value) + "\"}}");
        const Restored restored = restore_snapshot(1, *document);
        EXPECT_TRUE(restored.lost == 1 || !restored.error.empty()) << value;
        EXPECT_EQ(control->value, (std::vector<double>{.5})) << value;
    }
    folder.write("s.snapshots.json", R"({"1": {"options": "--set P.uA=0.25"}})");
    EXPECT_EQ(restore_snapshot(1, *document).error, "");
    EXPECT_EQ(control->value, (std::vector<double>{.25}));
}

// They hold names of rungs; numbers in them are only shown.
TEST_F(NonFiniteInput, QualityFilesAreRefused) {
    folder.write("s.glib", "Ladder KIND <red> green\n" + std::string(settable));
    const auto preset = [](const std::string& value) {
        return R"({"schema": 1, "renderer": "x", "presets": {"fast": {"ladders": ["KIND=green"], "rmse": )" + value +
               R"(, "ms": 1, "ratio": "1", "settled": true, "trusted": true}}})";
    };
    folder.write("s.quality.json", preset("0.5"));
    EXPECT_EQ(render("--quality fast").status, 0) << render("--quality fast").output;
    for (const char* value : {"NaN", "Infinity", "1e400", "null"}) {
        folder.write("s.quality.json", preset(value));
        EXPECT_EQ(render("--quality fast").status, 1) << value;
    }
}

}  // namespace
}  // namespace snell::test
