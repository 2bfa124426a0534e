// The texture panel in memory: what is listed and shown, and where the pointer's texel is.
#include "src/ui/panels/textures.h"

#include <cmath>

#include "src/runtime/inspect.h"
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

class UiTextures : public UiTest {
protected:
    UiTextures() {
        textures_.rows = rows_;
        textures_.width = 64;
        textures_.height = 32;
        found_.radius = 4;
        found_.rgba.assign(4 * 81, .5F);
        found_.inside.assign(81, 1);
        textures_.texel.inspection = &found_;
        textures_.texel.at = "texel 1, 2";
        facts_.textures = &textures_;
        memory_.open.emplace("Textures");
        memory_.tab = Tab::tools;
    }
    const TextureMemory& memory() { return memory_.textures; }
    TexturePart part() { return texture_part(memory(), textures_.width, textures_.height); }
    std::pair<double, double> texel_at(double x, double y) {
        const Rect at = place("textures.picture");
        return {part().left + (x - at.x) / part().zoom, part().top + (y - at.y) / part().zoom};
    }

    std::vector<TextureRow> rows_{{"Texture2D 5 gone.bmp", "", "", "no draw samples it", false},
                                  {"Texture2D 6 wall.bmp", "64 x 32", "RGBA8", "read by uWall of Glass", true},
                                  {"Noise3", "64 x 64 x 64", "RGBA8", "read by Noise3 of Glass", true}};
    TextureFacts textures_;
    Inspection found_;
};

TEST_F(UiTextures, ARowIsChosenByAClick) {
    EXPECT_TRUE(has("textures.picture"));
    EXPECT_EQ(chosen_row(rows_, memory()), 1U) << "the first that is loaded";
    EXPECT_FALSE(has("textures.level"));
    EXPECT_FALSE(has("textures.slice"));
    EXPECT_FALSE(has("textures.low")) << "bytes lie within 0 to 1";
    click(place("textures.row.Noise3"), MouseButton::left, .2);
    EXPECT_EQ(chosen_row(rows_, memory()), 2U);
    textures_.slices = 64;
    textures_.levels = 3;
    textures_.floats = true;
    for (const char* widget : {"textures.level", "textures.slice", "textures.low", "textures.high"})
        EXPECT_TRUE(has(widget)) << widget;
    click(place("textures.channel.G"));
    EXPECT_EQ(memory().channel, 1);
    click(place("textures.slice"), MouseButton::left, .9);
    EXPECT_GT(memory().slice, 50);
    click(place("textures.row.Texture2D 5 gone.bmp"), MouseButton::left, .2);
    EXPECT_EQ(memory().slice, 0);
    EXPECT_FALSE(has("textures.picture")) << "what is not loaded is not shown";
    EXPECT_TRUE(has("textures.about")) << "but why it is not";
}

// The picture's height follows its width, and the width must not follow the scroll bar.
TEST_F(UiTextures, NoHeightOfTheWindowMakesItSwing) {
    textures_.width = 64;
    textures_.height = 64;
    for (float height = 400; height < 900; height += 2) {
        screen_ = {1280, height, 1, 1};
        for (int i = 0; i < 5; ++i) frame();
        const float width = memory().width;
        frame();
        ASSERT_EQ(memory().width, width) << height;
        frame();
        ASSERT_EQ(memory().width, width) << height;
    }
}

TEST_F(UiTextures, AllOfItFitsAtFirst) {
    const Rect at = place("textures.picture");
    EXPECT_NEAR(part().zoom, std::min(at.width / 64, at.height / 32), 1e-6);
    EXPECT_NEAR(part().left + at.width / part().zoom / 2, 32, 1e-6);
    EXPECT_NEAR(part().top + at.height / part().zoom / 2, 16, 1e-6);
}

TEST_F(UiTextures, TheWheelKeepsTheTexelUnderThePointerAndADragMovesIt) {
    const Rect at = place("textures.picture");
    const double x = std::floor(at.x + at.width * .3), y = std::floor(at.y + at.height * .5);
    frame({move(x - 5, y)});
    frame({move(x, y)});
    const auto before = texel_at(x, y);
    const double fit = part().zoom;
    for (int i = 0; i < 3; ++i) frame({wheel(1)});
    EXPECT_GT(part().zoom, 3 * fit);
    EXPECT_EQ(std::log2(part().zoom), std::round(std::log2(part().zoom))) << "texels are whole pixels wide";
    EXPECT_NEAR(texel_at(x, y).first, before.first, 1e-3);
    EXPECT_NEAR(texel_at(x, y).second, before.second, 1e-3);
    EXPECT_EQ(memory().texel_x, static_cast<int>(std::floor(before.first)));
    EXPECT_EQ(memory().texel_y, static_cast<int>(std::floor(before.second)));
    frame({button(true)});
    frame({move(x - 9, y + 7)});
    frame({button(false)});
    EXPECT_NEAR(texel_at(x - 9, y + 7).first, before.first, 1e-3);
    EXPECT_NEAR(texel_at(x - 9, y + 7).second, before.second, 1e-3);
    EXPECT_EQ(view_.scene, Transformation{});
    // No further than to the edge, and out again to where all of it fits.
    frame({button(true)});
    frame({move(x + 5000, y + 5000)});
    frame({button(false)});
    EXPECT_EQ(part().left, 0);
    EXPECT_EQ(part().top, 0);
    frame({move(x, y)});
    for (int i = 0; i < 9; ++i) frame({wheel(-1)});
    EXPECT_NEAR(part().zoom, fit, 1e-6);
    for (int i = 0; i < 40; ++i) frame({wheel(1)});
    EXPECT_LE(part().zoom, 64);
    click(place("textures.fit"));
    EXPECT_NEAR(part().zoom, fit, 1e-6);
}

TEST_F(UiTextures, IIsHeldOverTheTexture) {
    const Rect at = place("textures.picture");
    frame({move(at.x + at.width / 2 + 1, at.y + at.height / 2 + 1), key(Key::i, true)});
    frame();
    EXPECT_TRUE(memory().inspecting);
    EXPECT_FALSE(memory_.pixels.inspecting) << "not over the scene";
    EXPECT_EQ(memory().texel_x, 32);
    EXPECT_EQ(memory().texel_y, 16);
    const Rect box = place("inspector");
    EXPECT_GE(box.x, 0);
    EXPECT_LE(box.x + box.width, screen_.width);
    EXPECT_FALSE(box.contains(at.x + at.width / 2 + 1, at.y + at.height / 2 + 1));
    frame({move(at.x - 50, at.y)});
    EXPECT_FALSE(memory().inspecting);
    EXPECT_TRUE(memory_.pixels.inspecting);
    frame({key(Key::i, false)});
}

TEST_F(UiTextures, IsClosedWhileItIsHidden) {
    frame();
    EXPECT_TRUE(memory().open);
    memory_.panel = false;
    frame();
    EXPECT_FALSE(memory().open) << "nothing is drawn for a hidden panel";
    memory_.panel = true;
    frame();
    EXPECT_TRUE(memory().open);
    click(place("textures"));
    EXPECT_FALSE(memory().open);
}

TEST_F(UiTextures, CountsOfMarksAreThereWhileTheyAreOn) {
    textures_.texel.flags = {{"", FlagCounts{{100, 2, 30, 4, 5}}}};
    const Rect before = place("textures.channel.RGB");
    frame({key(Key::n, true)});
    frame({key(Key::n, false)});
    EXPECT_GT(place("textures.channel.RGB").y, before.y);
}

}  // namespace
}  // namespace snell::ui
