// Pictures of any size, in parts, without their background.
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "src/app/picture/picture.h"
#include "tests/cli/command.h"

namespace snell::test {

namespace {

class Pictures : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("screen.frag",
                     "uniform vec2 uResolution;\nuniform float Timer;\nvoid main() {\n"
                     "  gl_FragColor = vec4(gl_FragCoord.xy / uResolution, Timer, 1.);\n}\n");
        folder.write(
            "s.glib",
            "Perspective 50\nLookAt 1 1.2 3  0 0 0  0 1 0\nBackground .2 .4 .6\nTimer 1\nFragment screen.frag\n"
            "Program S\nTeapot\nColor .9 .5 .1\nLineWidth 5\nWireSphere 1.2\n");
        folder.write("half.glib",
                     "Ortho -1 1 -1 1\nBackground .2 .4 .6\nColor 1 0 0 .5\nTranslate -.5 0 0\nQuadXY 0 .5\n"
                     "Color 0 1 0 1\nTranslate 1 0 0\nQuadXY 0 .4\n");
    }
    std::string at(const std::string& name) const { return folder.path(name); }
    content::Image picture(const std::string& name) const { return picture_of(at(name)); }
    Outcome render(const std::string& arguments) const { return snell("render " + arguments); }
    static std::array<int, 4> bytes_at(const content::Image& image, int x, int y) {
        std::array<int, 4> pixel{};
        for (int c = 0; c < image.channels; ++c)
            pixel[static_cast<std::size_t>(c)] = std::to_integer<int>(
                image.pixels[static_cast<std::size_t>((y * image.width + x) * image.channels + c)]);
        return pixel;
    }
};

TEST_F(Pictures, InPartsIsTheSameAsAtOnce) {
    for (const auto& [extension, samples] :
         {std::pair("png", "4"), std::pair("bmp", "1"), std::pair("exr", "1"), std::pair("png", "1 --context es3.2")}) {
        const std::string common = at("s.glib") + " --size 150x115 --time .3 --axes --samples " + samples + " -o ";
        const std::string whole = std::string("whole.") + extension, parts = std::string("parts.") + extension;
        ASSERT_EQ(render(common + at(whole)).status, 0);
        const Outcome outcome = render(common + at(parts) + " --tile 64");
        ASSERT_EQ(outcome.status, 0) << outcome.output;
        const content::Image a = picture(whole), b = picture(parts);
        EXPECT_EQ(b.width, 150);
        EXPECT_EQ(b.height, 115);
        ASSERT_EQ(a.pixels.size(), b.pixels.size());
        std::size_t different = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) different += a.pixels[i] != b.pixels[i];
        EXPECT_LE(different, a.pixels.size() / 1000) << extension;
    }
}

// llvmpipe leaves loops that never end after 65,535 rounds; OpenGL ES leaves them wherever it is drawn by.
TEST_F(Pictures, OfLoopsThatNeverEndAreThoseOfTheRoundsThatAreLeft) {
    folder.write("l.glib", "Ortho -1 1 -1 1\nFragment l.frag\nProgram P uNever <0. 0. 1.>\nQuadXY 0 1\n");
    const auto pixel = [&](const std::string& loop, const std::string& value, const std::string& context) {
        folder.write("l.frag", "uniform float uNever;\nvoid main() { float n = 0.; " + loop + " gl_FragColor = vec4(" +
                                   value + ", 0., 0., 1.); }\n");
        const Outcome outcome =
            render(at("l.glib") + " --size 2x2 --no-specialise -o " + at("l.png") + " --context " + context);
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return bytes_at(picture("l.png"), 1, 1)[0];
    };
    for (const char* loop :
         {"while (true) { n += 1.; if (uNever > 2.) break; }",
          "for (int i = 0; i < 9; ) { n += 1.; if (uNever > 2.) break; }", "do ++n; while (n > 0.);"})
        for (const char* context : {"4.5", "es3.0"})
            EXPECT_EQ(pixel(loop, "n / 65536.", context), 255) << loop << context;
    // The first count that is full is that of OpenGL ES, were it the lower one.
    const std::string few = "while (uNever < 2.) for (int i = 0; i < 9999; ++i) n += .0001;";
    EXPECT_EQ(pixel(few, "n / 26.", "es3.0"), pixel(few, "n / 26.", "4.5"));
}

TEST_F(Pictures, AreWholeOnBothSidesOfWhatSixteenBitsNumber) {
    std::vector<double> bytes;
    for (const int cells : {254, 255}) {
        const std::string count = std::to_string(cells) + ' ' + std::to_string(cells);
        folder.write("q.glib", "Ortho -1 1 -1 1\nColor 1 1 1\nQuadXY 0 1 " + count + '\n');
        const Outcome outcome = render(at("q.glib") + " --size 64x64 -o " + at("q.png") + " --stats " + at("q.json"));
        ASSERT_EQ(outcome.status, 0) << outcome.output;
        for (const std::byte each : picture("q.png").pixels) ASSERT_EQ(std::to_integer<int>(each), 255) << cells;
        bytes.push_back(nlohmann::json::parse(bytes_of(at("q.json")))["counters"]["gpu_bytes"]);
    }
    EXPECT_GT(bytes[1] - bytes[0], 2. * 6 * 254 * 254) << "four bytes an index instead of two";
}

TEST_F(Pictures, FramesInPartsAreAtTheirTimes) {
    ASSERT_EQ(render(at("s.glib") + " --size 130x70 --time .25 --frames 3 --fps 7 --tile 64 -o " + at("f.png")).status,
              0);
    for (int k = 0; k < 3; ++k) {
        render(at("s.glib") + " --size 130x70 --time " + std::to_string(.25 + k / 7.) + " -o " + at("one.png"));
        EXPECT_TRUE(picture("one.png").pixels == picture("f-000" + std::to_string(k) + ".png").pixels) << k;
    }
}

TEST_F(Pictures, WideOnesNeedNoMoreMemoryThanTheLimit) {
    if (caps.max_viewport < 16384) GTEST_SKIP() << "this OpenGL draws " << caps.max_viewport << " pixels at most";
    const Outcome wide = render(at("s.glib") + " --size 16384x200 --limit output-bytes=4000000 -o " + at("wide.png"));
    EXPECT_EQ(wide.status, 0) << wide.output;
    EXPECT_EQ(picture("wide.png").width, 16384);
    const Outcome small = render(at("s.glib") + " --size 100x100 --limit output-bytes=1000 -o " + at("no.png"));
    EXPECT_EQ(small.status, 1);
    EXPECT_TRUE(small.says("'output-bytes' is 1000")) << small.output;
    const Outcome side = render(at("s.glib") + " --size 100x100 --limit output-side=99 -o " + at("no.png"));
    EXPECT_EQ(side.status, 2);
    EXPECT_FALSE(std::filesystem::exists(at("no.png")));
}

TEST_F(Pictures, WithoutTheirBackground) {
    for (const char* tile : {"", " --tile 64"}) {
        ASSERT_EQ(render(at("half.glib") + " --size 200x200 --transparent -o " + at("t.png") + tile).status, 0);
        const content::Image image = picture("t.png");
        ASSERT_EQ(image.channels, 4);
        EXPECT_EQ(bytes_at(image, 100, 5)[3], 0) << "nothing";
        const auto half = bytes_at(image, 50, 100), full = bytes_at(image, 150, 100);
        EXPECT_EQ(full, (std::array<int, 4>{0, 255, 0, 255}));
        EXPECT_NEAR(half[3], 128, 1);
        EXPECT_NEAR(half[0], 255, 2) << "its own colour, not one that is mixed with the background";
        EXPECT_NEAR(half[2], 0, 1);
    }
    ASSERT_EQ(render(at("half.glib") + " --size 200x200 -o " + at("o.png")).status, 0);
    EXPECT_EQ(picture("o.png").channels, 3);
}

// PNG's alpha is a share of light.
TEST_F(Pictures, OfLightWithoutTheirBackground) {
    std::ofstream(at("light.glib")) << "Output srgb\n" << bytes_of(at("half.glib"));
    ASSERT_EQ(render(at("light.glib") + " --size 200x200 --transparent -o " + at("t.png")).status, 0);
    const auto half = bytes_at(picture("t.png"), 50, 100), full = bytes_at(picture("t.png"), 150, 100);
    EXPECT_NEAR(half[3], 128, 1);
    EXPECT_NEAR(half[0], 255, 2);
    EXPECT_NEAR(half[2], 0, 1);
    EXPECT_EQ(full, (std::array<int, 4>{0, 255, 0, 255}));
}

// Over its background a transparent picture is the picture.
TEST_F(Pictures, TransparentOnesOverTheirBackgroundAreThePicture) {
    ASSERT_EQ(render(at("s.glib") + " --size 200x160 --samples 4 -o " + at("o.png")).status, 0);
    ASSERT_EQ(render(at("s.glib") + " --size 200x160 --samples 4 --transparent -o " + at("t.png")).status, 0);
    const content::Image whole = picture("o.png"), part = picture("t.png");
    const std::array<double, 3> background{.2 * 255, .4 * 255, .6 * 255};
    int edges = 0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) {
            const auto want = bytes_at(whole, x, y), have = bytes_at(part, x, y);
            const double alpha = have[3] / 255.;
            edges += have[3] > 0 && have[3] < 255;
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(have[c] * alpha + background[c] * (1 - alpha), want[c], 2.5) << x << ' ' << y;
        }
    EXPECT_GT(edges, 50) << "edges are smooth";
}

TEST_F(Pictures, FloatsAreMultipliedByTheirAlpha) {
    ASSERT_EQ(render(at("half.glib") + " --size 64x64 --transparent -o " + at("t.exr")).status, 0);
    const content::Image image = picture("t.exr");
    ASSERT_EQ(image.channels, 4);
    ASSERT_EQ(image.type, content::PixelType::f16);
    std::array<std::uint16_t, 4> halves{};
    std::memcpy(halves.data(), &image.pixels[static_cast<std::size_t>((32 * 64 + 16) * 4 * 2)], sizeof halves);
    EXPECT_NEAR(content::half_to_float(halves[0]), .5, .002);
    EXPECT_NEAR(content::half_to_float(halves[3]), .5, .002);
    EXPECT_EQ(content::half_to_float(halves[2]), 0);
}

TEST_F(Pictures, OtherFormatsAreNotTransparent) {
    const Outcome outcome = render(at("half.glib") + " --size 8x8 --transparent -o " + at("t.bmp"));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.says("PNG and EXR")) << outcome.output;
}

TEST_F(Pictures, PartsCoverEveryPixelOnce) {
    gl::Caps small = caps;
    small.max_viewport = 20000;
    small.max_texture = 500;
    for (const app::PictureSize size :
         {app::PictureSize{1, 1}, {64, 64}, {700, 900}, {1001, 65}, {64, 2000, 16, true}}) {
        const app::Tiling tiling = app::tile(size, {}, small, 200);
        ASSERT_EQ(tiling.error, "");
        std::vector<int> times(static_cast<std::size_t>(size.width * size.height));
        int above = size.height;
        for (const PixelRect& part : app::parts_of(size, tiling)) {
            EXPECT_LE(part.bottom, above) << "from the top";
            above = part.bottom;
            EXPECT_EQ(part.left % 2 + part.bottom % 2, 0);
            for (int y = 0; y < part.height; ++y)
                for (int x = 0; x < part.width; ++x)
                    ++times[static_cast<std::size_t>((part.bottom + y) * size.width + part.left + x)];
        }
        EXPECT_TRUE(std::ranges::all_of(times, [](int n) { return n == 1; })) << size.width << "x" << size.height;
    }
    EXPECT_NE(app::tile({30000, 10}, Limits{}, small).error, "");
}

// The dialog shows it in its own words, the terminal on a line of its own.
TEST_F(Pictures, WhatIsTooLargeIsSaidInOneLineWithHelp) {
    Limits little;
    little.output_bytes = 1 << 16;
    for (const auto& [tiling, name] : {std::pair(app::tile({100'000, 100'000}, Limits{}, caps), "output-side"),
                                       {app::tile({8000, 8000, 16}, little, caps), "output-bytes"}}) {
        EXPECT_NE(tiling.error, "");
        EXPECT_EQ(tiling.error.find('\n'), std::string::npos) << tiling.error;
        EXPECT_NE(tiling.help.find(name), std::string::npos) << tiling.help;
    }
    for (const auto& [size, said] :
         {std::pair("60000x60000", "60000x60000 is too large\n   help: the limit 'output-side'"),
          {"100x999999999", "100x999999999 is too large\n   help: the limit 'output-side'"},
          {"100.5x100", "'100.5x100' is not WIDTHxHEIGHT in whole pixels"},
          {"100x9999999999", "'100x9999999999' is not WIDTHxHEIGHT in whole pixels"}}) {
        const Outcome refused = render(std::string("--size ") + size + " -o " + at("large.png") + " " + at("s.glib"));
        EXPECT_TRUE(refused.says(said)) << refused.output;
    }
}

}  // namespace

}  // namespace snell::test
