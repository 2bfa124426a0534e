// Pixels as numbers in a real window: I held, N pressed, and what frames cost.
#include <array>
#include <cmath>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

class Pixels : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("plain.vert",
             "#version 330 compatibility\nout vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; "
             "gl_Position = ftransform(); }\n");
        // The left half is NaN, the right one above 1 but for a slider.
        save("odd.frag",
             "#version 330 compatibility\nuniform float uZero, uMost;\nin vec2 vST;\nvoid main() {\n"
             "    gl_FragColor = vST.s < .5 ? vec4(uZero / uZero, .2, .3, 1.) : vec4(.25, uMost, .75, 1.);\n}\n");
        save("scene.glib",
             "##OpenGL GLIB\nPerspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nBackground 0 0 0\nVertex plain.vert\n"
             "Fragment odd.frag\nProgram Odd uZero <0. 0. 1.> uMost <0. 2.5 5.>\nQuadXY 0. 1.\n");
    }
    void press(const char* key) {
        user(std::string("key ") + key);
        settle();
    }
    std::array<int, 2> middle(int right = 0) const {
        const json scene = state()["scene"];
        return {static_cast<int>(scene[0].get<double>() + scene[2].get<double>() / 2) + right,
                static_cast<int>(scene[1].get<double>() + scene[3].get<double>() / 2) + 20};
    }
};

TEST_F(Pixels, HoldingITellsWhatThePixelIs) {
    open("scene.glib");
    press("r");
    EXPECT_FALSE(state().contains("pixels"));
    const auto [x, y] = middle(60);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " keydown i");
    ASSERT_TRUE(wait([](const json& s) { return s.contains("pixels") && s["widgets"].contains("inspector"); }));
    settle();
    json pixels = state()["pixels"];
    EXPECT_EQ(pixels["rgba"], (json{"0.25", "2.5", "0.75", "1"}));
    EXPECT_EQ(pixels["at"], (json{x, y}));
    EXPECT_NEAR(pixels["distance"].get<double>(), 4, 1e-3) << "of the eye from the wall";
    EXPECT_EQ(pixels["statement"], "QuadXY 0. 1.");
    EXPECT_EQ(pixels["place"], "scene.glib:8");
    const auto [edge, row] = middle(1);
    user("mousemove " + std::to_string(edge) + " " + std::to_string(row));
    settle();
    keep("guide-pixels");
    EXPECT_NEAR(state()["pixels"]["distance"].get<double>(), 4, 1e-3) << "of the wall, not of the axis before it";
    const auto [left, same] = middle(-60);
    user("mousemove " + std::to_string(left) + " " + std::to_string(same));
    ASSERT_TRUE(wait([](const json& s) { return s["pixels"]["rgba"][0] == "NaN"; }));
    user("mousemove 4 4");
    ASSERT_TRUE(wait([](const json& s) { return s["pixels"].contains("place") && s["pixels"]["place"] == ""; }));
    EXPECT_EQ(state()["pixels"]["rgba"], (json{"0", "0", "0", "1"})) << "the background";
    user("keyup i");
    ASSERT_TRUE(wait([](const json& s) { return !s.contains("pixels"); }));
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

TEST_F(Pixels, NPaintsWhatIsNoColor) {
    open("scene.glib");
    settle();
    const json before = state();
    EXPECT_EQ(frames_of(before), before["frames"]) << "off, nothing is drawn for it";
    press("n");
    const json flags = state()["pixels"]["flags"];
    const Pixel nan = scene_pixel(-60, 20), above = scene_pixel(60, 20), none = scene_pixel(-60, -380);
    EXPECT_EQ(nan, (Pixel{255, 0, 220}));
    EXPECT_EQ(above, (Pixel{255, 106, 0}));
    EXPECT_EQ(none.red, none.green);
    EXPECT_EQ(flags["NaN"].get<int>() > 5000, true) << flags;
    EXPECT_NEAR(flags["NaN"].get<double>(), flags["above 1"].get<double>(), 1200) << "halves of a wall";
    EXPECT_EQ(flags["infinite"], 0);
    EXPECT_EQ(flags["negative"], 0);
    // A drag of a slider paints anew.
    drag(on("Odd.uMost", .5), on("Odd.uMost", .1));
    settle();
    EXPECT_EQ(state()["pixels"]["flags"]["above 1"], 0);
    press("n");
    EXPECT_FALSE(state().contains("pixels"));
    EXPECT_NE(scene_pixel(-60, 20), nan);
    const json off = state();
    drag(on("Odd.uMost", .1), on("Odd.uMost", .3));
    settle();
    const json after = state();
    EXPECT_EQ(frames_of(after) - frames_of(off), after["frames"].get<int>() - off["frames"].get<int>())
        << "off again, it costs nothing";
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

// Once the picture stands still: what is dragged costs nothing more, and what does not change is looked at once.
TEST_F(Pixels, NaNIsSaidWithoutBeingAskedFor) {
    open("scene.glib");
    const auto said = [&](const std::string& text, int looks) {
        EXPECT_TRUE(wait([&](const json& s) {
            return s["nan"]["looks"] == looks && s["nan"]["text"].get<std::string>().starts_with(text);
        })) << text;
        settle();
        EXPECT_EQ(state()["nan"]["looks"], looks);
        EXPECT_EQ(state()["widgets"].contains("status.nan"), !text.empty());
        return state()["nan"]["text"].get<std::string>();
    };
    const std::string text = said("NaN in ", 1);
    keep("nan");
    const int told = std::stoi(text.substr(7));
    const std::array<double, 4> area = state()["scene"];
    press("n");
    EXPECT_NEAR(told, 100 * state()["pixels"]["flags"]["NaN"].get<double>() / (area[2] * area[3]), 1.5) << text;
    EXPECT_FALSE(state()["widgets"].contains("status.nan")) << "the marks tell it";
    press("n");
    said("NaN in ", 1);
    EXPECT_TRUE(idle());
    said("NaN in ", 1);
    const auto [x, y] = on("Odd.uZero", .1);
    user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " mousedown 1 mousemove_relative 9 0 sleep .8");
    said("", 1);
    EXPECT_EQ(state()["nan"]["text"], "") << "nothing is said of an older picture";
    user("mouseup 1");
    EXPECT_TRUE(idle());
    said("", 2);
    EXPECT_EQ(state()["nan"]["text"], "") << "mended";
    save("odd.frag",
         "#version 330 compatibility\nuniform float uZero, uMost;\nin vec2 vST;\n"
         "void main() { gl_FragColor = vec4(sqrt(vST.s > .99 ? -1. - uMost : 1.), uZero, 0., 1.); }\n");
    said("NaN in under 1 %:", 3);
    save("odd.frag",
         "#version 330 compatibility\nuniform float uZero, uMost;\nin vec2 vST;\n"
         "void main() { float none = 0. * uMost;\n"
         "gl_FragColor = vec4(vST.s > .99 ? none / none : vST.t > .5 ? 1. / none : 1., uZero, 0., 1.); }\n");
    const std::string both = said("NaN in under 1 %, infinite in ", 4);
    press("n");
    EXPECT_NEAR(std::stoi(both.substr(29)),
                100 * state()["pixels"]["flags"]["infinite"].get<double>() / (area[2] * area[3]), 1.5)
        << both;
    press("n");
    user("key s");
    said("NaN in under 1 %, infinite in ", 5);
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

TEST_F(Pixels, FramesHaveTheirCost) {
    open("scene.glib");
    EXPECT_FALSE(state().contains("frame_cost"));
    const int pictures = state()["frames"];
    click("tools");
    click("frame cost");
    settle();
    EXPECT_EQ(state()["frame_cost"]["pictures"], 2) << "a still scene: the picture that is shown, and one more";
    EXPECT_GT(state()["frame_cost"]["last"].get<double>(), 0);
    EXPECT_EQ(state()["frames"], pictures + 1);
    click("controls");
    drag(on("Odd.uMost", .3), on("Odd.uMost", .9));
    settle();
    click("tools");
    json cost = state()["frame_cost"];
    EXPECT_GE(cost["pictures"].get<int>(), 2);
    EXPECT_GT(cost["median"].get<double>(), 0);
    EXPECT_GE(cost["high"].get<double>(), cost["median"].get<double>());
    click("frame cost.measure");
    ASSERT_TRUE(wait([](const json& s) { return s["frame_cost"]["apart"].size() >= 2; }));
    settle();
    cost = state()["frame_cost"];
    EXPECT_EQ(cost["apart"][0]["name"], "window");
    EXPECT_EQ(cost["apart"][1]["name"], "QuadXY 0. 1.");
    EXPECT_TRUE(cost["apart"][1]["draw"].get<bool>());
    EXPECT_LE(cost["apart"][1]["milliseconds"].get<double>(), cost["apart"][0]["milliseconds"].get<double>());
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

// A raw texture of 2 x 2 texels, the row of t = 0 first.
std::string four(const std::vector<std::array<int, 3>>& texels) {
    std::string bytes{2, 0, 0, 0, 2, 0, 0, 0};
    for (const auto& [red, green, blue] : texels)
        for (const int value : {red, green, blue, 255}) bytes += static_cast<char>(value);
    return bytes;
}

// A file of known texels, a render target that follows a slider, and a file that nothing reads.
TEST_F(Pixels, TexturesAreLookedAtTexelByTexel) {
    save("four.tex", four({{0, 0, 255}, {51, 102, 153}, {255, 0, 0}, {0, 255, 0}}));
    save("blue.frag",
         "#version 330 compatibility\nuniform float uBlue;\nvoid main() { gl_FragColor = vec4(0., 1., uBlue, 1.); }\n");
    save("both.frag",
         "#version 330 compatibility\nuniform sampler2D uFile, uDrawn;\nin vec2 vST;\n"
         "void main() { gl_FragColor = texture(uFile, vST) + texture(uDrawn, vST); }\n");
    save("textures.glib",
         "##OpenGL GLIB\nTexture2D 5 four.tex\nTexture2D 6 8 8\nTexture2D 7 missing.bmp\nOrtho -1 1 -1 1\n"
         "Vertex plain.vert\nFragment blue.frag\nProgram Blue uBlue <0. .2 1.>\nRenderToTexture 6\nQuadXY 0. 1.\n"
         "RenderToTexture\nFragment both.frag\nProgram Both uFile 5 uDrawn 6\nQuadXY 0. 1.\n");
    save("missing.bmp", "this is not a picture, and nothing may find out");
    open("textures.glib", {"--size", "900x1000"});
    settle();
    EXPECT_FALSE(state().contains("textures"));
    const int pictures = state()["frames"];
    click("tools");
    click("textures");
    ASSERT_TRUE(wait([](const json& s) { return s.contains("textures") && s["textures"]["drawn"] >= 1; }));
    settle();
    json textures = state()["textures"];
    ASSERT_EQ(textures["rows"].size(), 3U);
    EXPECT_EQ(textures["rows"][0]["name"], "Texture2D 5 four.tex");
    EXPECT_EQ(textures["rows"][1]["why"], "read by uDrawn of Both");
    EXPECT_FALSE(textures["rows"][2]["loaded"].get<bool>());
    EXPECT_EQ(textures["read"], 0) << "nothing is read back to be shown";
    // The upper left texel fills the upper left of the picture, and so on.
    const auto [x, y] = on("textures.picture");
    const Picture screen = look();
    EXPECT_EQ(screen.at(x - 40, y - 40), (Pixel{255, 0, 0}));
    EXPECT_EQ(screen.at(x + 40, y - 40), (Pixel{0, 255, 0}));
    EXPECT_EQ(screen.at(x - 40, y + 40), (Pixel{0, 0, 255}));
    EXPECT_EQ(screen.at(x + 40, y + 40), (Pixel{51, 102, 153}));
    user("mousemove " + std::to_string(x + 40) + " " + std::to_string(y - 40) + " keydown i");
    ASSERT_TRUE(wait([](const json& s) { return s["textures"]["texel"].contains("rgba"); }));
    EXPECT_EQ(state()["textures"]["texel"]["rgba"], (json{"0", "1", "0", "1"}));
    EXPECT_EQ(state()["textures"]["texel"]["statement"], "s, t = 0.75, 0.75");
    keep("textures-inspector");
    user("keyup i");
    settle();
    EXPECT_EQ(state()["frames"], pictures) << "the scene's picture is not drawn for it";
    // Idle, it draws nothing.
    const json before = state();
    EXPECT_TRUE(idle());
    // What a pass draws follows the slider.
    click("textures.row.Texture2D 6", .2);
    settle();
    EXPECT_EQ(look().at(x, y), (Pixel{0, 255, 51}));
    click("controls");
    click("Blue.uBlue", .999);
    click("tools");
    const double blue = state()["controls"]["Blue.uBlue"][0];
    EXPECT_NE(blue, .2);
    EXPECT_EQ(look().at(x, y).blue, std::lround(255 * blue));
    // A saved file is another texture.
    click("textures.row.Texture2D 5 four.tex", .2);
    save("four.tex", four({{7, 8, 9}, {10, 11, 12}, {1, 2, 3}, {4, 5, 6}}));
    ASSERT_TRUE(wait([&](const json& s) { return s["revision"] > before["revision"]; }));
    settle();
    EXPECT_EQ(look().at(x - 40, y - 40), (Pixel{1, 2, 3}));
    click("textures");
    settle();
    EXPECT_FALSE(state().contains("textures"));
    EXPECT_EQ(state()["gl_errors"].size(), 0U);
}

}  // namespace
}  // namespace snell::test
