// Two states of a scene side by side, and what is said of them.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "src/content/image/image.h"
#include "tests/gui/desk.h"
#include "tests/screens.h"

namespace snell::test {
namespace {

using nlohmann::json;

class States : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib",
             "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nBackground 0 0 0\nVertex paint.vert\nFragment paint.frag\n"
             "Ladder TINT dark <light>\nProgram Paint uRed <0. .2 1.> uGreen <0. .4 1.>\nQuadXY 0. 1. 2 2\n");
        save("paint.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
        save("paint.frag", fragment("0."));
        open("scene.glib", {"--size", "1000x700"});
    }
    static std::string fragment(const std::string& more) {
        return "#version 330 compatibility\nuniform float uRed, uGreen;\n"
               "void main() { gl_FragColor = vec4(uRed, uGreen + " +
               more + ", float(TINT) * .5, 1.); }\n";
    }
    // Red, green and blue left and right of the middle.
    void expect(std::array<double, 3> left, std::array<double, 3> right, const char* what) const {
        const Pixel l = scene_pixel(-25, 20), r = scene_pixel(25, 20);
        const std::array<int, 3> lefts{l.red, l.green, l.blue}, rights{r.red, r.green, r.blue};
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(lefts[i], std::lround(255 * left[i]), 1) << what << " left " << i;
            EXPECT_NEAR(rights[i], std::lround(255 * right[i]), 1) << what << " right " << i;
        }
    }
    void choose_state(const std::string& side, const std::string& name) const {
        click("accuracy." + side);
        click(side + "." + name);
        settle();
    }
    std::string label(int side) const { return state()["states"][static_cast<std::size_t>(side)]; }
};

TEST_F(States, AreShownSideBySideAndSlidersActOnWhatIsNow) {
    user("key ctrl+1");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    const double slid = state()["controls"]["Paint.uRed"][0];
    user("key s");
    settle();
    expect({slid, .4, .5}, {slid, .4, .5}, "the reference is the same");
    EXPECT_EQ(label(0), "now");
    EXPECT_EQ(label(1), "reference: the same");
    choose_state("right", "saved");
    expect({slid, .4, .5}, {.2, .4, .5}, "as saved");
    EXPECT_EQ(label(0), "now: uRed " + fmt::format("{:.4g}", slid));
    EXPECT_EQ(label(1), "as saved: 0.2");
    choose_state("right", "TINT=dark");
    expect({slid, .4, .5}, {slid, .4, 0}, "a rung");
    EXPECT_EQ(label(1), "TINT dark");
    click("accuracy.right");
    click("right.settings");
    user("type --delay 8 uGreen=0.9");
    user("key Return");
    settle();
    expect({slid, .4, .5}, {slid, .9, .5}, "typed values");
    drag(on("Paint.uRed", slid), on("Paint.uRed", .5));
    const double now = state()["controls"]["Paint.uRed"][0];
    expect({now, .4, .5}, {now, .9, .5}, "what follows the scene follows its sliders");
    EXPECT_EQ(label(0), "now: uGreen 0.4");
    EXPECT_EQ(label(1), "uGreen 0.9") << "as typed";
    click("accuracy.swap");
    settle();
    expect({now, .9, .5}, {now, .4, .5}, "swapped");
    choose_state("left", "snapshot 1");
    expect({.2, .4, .5}, {now, .4, .5}, "a snapshot");
    drag(on("Paint.uRed", now), on("Paint.uRed", .9));
    const double last = state()["controls"]["Paint.uRed"][0];
    expect({.2, .4, .5}, {last, .4, .5}, "a snapshot stays");
    EXPECT_EQ(state()["gl_errors"], json::array());
    EXPECT_EQ(state()["errors"], 0);
}

TEST_F(States, OfWhichNeitherFollowsTheSlidersSayIt) {
    user("key ctrl+1");
    settle();
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    user("key ctrl+2");
    settle();
    user("key s");
    settle();
    const auto said = [&] { return state()["widgets"].contains("accuracy.fixed"); };
    choose_state("right", "snapshot 1");
    EXPECT_FALSE(said()) << "the left side is as it is now";
    choose_state("left", "snapshot 2");
    EXPECT_TRUE(said());
    choose_state("left", "TINT=dark");
    EXPECT_FALSE(said()) << "it has the sliders' values";
}

TEST_F(States, PixelsWithoutANumberHaveAColourAndAWordOfTheirOwn) {
    user("key s");
    settle();
    click("accuracy.other");
    settle();
    EXPECT_FALSE(state()["widgets"].contains("accuracy.no number"));
    save("paint.frag", fragment("sqrt(-1. - uRed)"));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    settle();
    EXPECT_TRUE(wait([](const json& s) { return s["widgets"].contains("accuracy.no number"); }));
    const Pixel pixel = scene_pixel(20, 20);
    EXPECT_GT(pixel.blue, 200);
    EXPECT_LT(pixel.red, 60) << "not the yellow of large differences";
    keep("heat-no-number");
}

// What a picture of bytes can't show is NaN on the left, above 1 on the right.
TEST_F(States, AreMarkedEachByItsOwnValues) {
    save("paint.frag", fragment("(uRed > .5 ? sqrt(-uRed) : 1.)"));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    constexpr Pixel nan{255, 0, 220}, above{255, 106, 0};
    const std::array<double, 4> area = state()["scene"];
    const auto column = [&] { return long{on("accuracy.divider")[0]} - std::lround(area[0]); };
    // In the rows of the wall, where no legend covers it.
    const auto marked = [&](const Pixel& color, bool right) {
        const Picture screen = look();
        double count = 0;
        const auto [from, to] = right ? std::pair(column(), std::lround(area[2])) : std::pair(0L, column());
        for (long x = from; x < to; ++x)
            for (double y = area[3] * .2; y < area[3] * .8; ++y) count += screen.at(area[0] + x, area[1] + y) == color;
        return count;
    };
    // The divider covers a few columns of what is counted.
    const auto expect_marks = [&](const Pixel& left, const Pixel& right, const char* what) {
        const json flags = state()["pixels"]["flags"];
        for (const bool side : {false, true}) {
            const Pixel& color = side ? right : left;
            std::string name;
            for (const auto& [key, value] : flags.items())
                if (key.starts_with(side ? "right: " : "left: ")) name = key;
            ASSERT_FALSE(name.empty()) << what << " " << flags;
            EXPECT_EQ(scene_pixel(side ? 40 : -130, 20), color) << what << " " << name;
            const double said = flags[name][color == nan ? "NaN" : "above 1"];
            EXPECT_NEAR(said, marked(color, side), 4 * area[3]) << what << " " << name;
            EXPECT_GT(said, 9000) << what << " " << name;
            EXPECT_EQ(flags[name][color == nan ? "above 1" : "NaN"], 0) << what << " " << name;
        }
    };
    user("key s");
    settle();
    for (const std::string side : {"left", "right"}) {
        click("accuracy." + side);
        click(side + ".settings");
        user("type --delay 8 uRed=" + std::string(side == "left" ? "0.9" : "0.2"));
        user("key Return");
        settle();
    }
    // What is said without marks is of what is seen, too.
    const auto told = [&] {
        EXPECT_TRUE(wait([](const json& s) { return s["nan"]["text"] != ""; }));
        return std::stoi(state()["nan"]["text"].get<std::string>().substr(7));
    };
    const int before = told(), looks = state()["nan"]["looks"];
    const auto [x, y] = on("accuracy.divider");
    drag({x, y + 90}, {x - 90, y + 90});
    const int less = told();
    EXPECT_LT(less, before * 3 / 4) << "of the left side less is seen";
    EXPECT_EQ(state()["nan"]["looks"], looks);
    click("accuracy.other");
    settle();
    EXPECT_EQ(state()["nan"]["text"], "") << "the heat map has no marks";
    click("accuracy.other");
    settle();
    EXPECT_EQ(told(), less);
    drag({x - 90, y + 90}, {x, y + 90});
    user("key n");
    settle();
    double nans = 0;
    const json flags = state()["pixels"]["flags"];
    for (const json& counts : flags) nans += counts["NaN"].get<double>();
    EXPECT_NEAR(before, 100 * nans / (area[2] * area[3]), 1.5);
    // Wherever the pointer is.
    for (const int off : {-60, 60}) {
        user(fmt::format("mousemove {} {}", area[0] + area[2] / 2 + off, area[1] + area[3] / 2 + 40));
        settle();
        expect_marks(nan, above, off < 0 ? "pointer on the left" : "pointer on the right");
    }
    keep("states-marks");
    const int frames = state()["counters"]["frames"];
    drag({x, y + 90}, {x - 90, y + 90});
    EXPECT_NEAR(static_cast<double>(column()), area[2] / 2 - 90, 3);
    expect_marks(nan, above, "the divider was moved");
    EXPECT_EQ(state()["counters"]["frames"], frames) << "nothing was drawn for it";
    click("accuracy.swap");
    settle();
    expect_marks(above, nan, "swapped");
    click("accuracy.other");
    settle();
    EXPECT_FALSE(state()["pixels"].contains("flags")) << "the heat map is of both";
    EXPECT_GT(scene_pixel(40, 20).blue, 200) << "no number";
    EXPECT_NE(scene_pixel(40, 20), nan);
    click("accuracy.other");
    settle();
    expect_marks(above, nan, "side by side again");
    user("key s");
    settle();
    EXPECT_EQ(state()["pixels"]["flags"].value("NaN", -1), 0) << "of a single picture";
    EXPECT_EQ(scene_pixel(-40, 20), above);
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(States, OfTheTextAreThereToo) {
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    const double slid = state()["controls"]["Paint.uRed"][0];
    save("paint.frag", fragment(".3"));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    user("key s");
    settle();
    choose_state("right", "edit");
    expect({slid, .7, .5}, {slid, .4, .5}, "before the last edit");
    EXPECT_EQ(label(0), "now");
    EXPECT_EQ(label(1), "before the last edit: paint.frag as it was") << "no value differs";
    choose_state("right", "opened");
    expect({slid, .7, .5}, {.2, .4, .5}, "as opened");
    EXPECT_TRUE(label(0).starts_with("now: uRed ")) << label(0);
    EXPECT_EQ(label(1), "as opened: 0.2, paint.frag as it was");
    choose_state("left", "edit");
    EXPECT_TRUE(label(0).starts_with("before the last edit: uRed ") && !label(0).ends_with("was"))
        << "these two have the same texts: " << label(0);
    EXPECT_EQ(label(1), "as opened: 0.2");
    choose_state("left", "now");
    // The magnifier shows the half under the pointer.
    const std::array<double, 4> area = state()["scene"];
    for (const int off : {-30, 30}) {
        user("mousemove " + std::to_string(static_cast<int>(area[2] / 2) + off) + " " +
             std::to_string(static_cast<int>(area[3] / 2) + 20) + " keydown i");
        ASSERT_TRUE(wait([](const json& s) { return s.contains("pixels") && s["pixels"].contains("rgba"); }));
        settle();
        const std::string red = state()["pixels"]["rgba"][0], title = state()["pixels"]["title"];
        EXPECT_NEAR(std::stod(red), off < 0 ? slid : .2, 1e-6);
        EXPECT_TRUE(title.ends_with(off < 0 ? ", left: now" : ", right: as opened")) << title;
        user("keyup i");
        settle();
    }
    // The heat map is of the same two.
    click("accuracy.other");
    settle();
    const Pixel hot = scene_pixel(30, 20);
    // Of light, as its legend says, in red and green.
    const auto light = [](double value) { return std::pow((value + .055) / 1.055, 2.4); };
    const double apart = std::hypot(light(slid) - light(.2), light(.7) - light(.4)) / std::sqrt(3);
    const auto heat = content::heat(1 + std::log10(apart) / 3);
    EXPECT_NEAR(hot.red, 255 * heat[0], 2);
    EXPECT_NEAR(hot.green, 255 * heat[1], 2);
    user("mousemove " + std::to_string(static_cast<int>(area[2] / 2) + 30) + " " +
         std::to_string(static_cast<int>(area[3] / 2) + 20) + " keydown i");
    EXPECT_TRUE(wait([](const json& s) { return s.contains("pixels") && s["pixels"].contains("difference"); }));
    const json pixels = state()["pixels"];
    EXPECT_NEAR(pixels.value("difference", 0.), apart, 1e-3);
    EXPECT_TRUE(pixels.value("title", "").ends_with(", left: now")) << pixels;
    user("keyup i");
    settle();
    user("key s");
    settle();
    expect({slid, .7, .5}, {slid, .7, .5}, "the picture");
    EXPECT_EQ(state()["gl_errors"], json::array());
}

TEST_F(States, OfTheTextNeedNoFileOfToday) {
    user("key s");
    settle();
    std::filesystem::remove(file("paint.frag"));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    settle();
    choose_state("right", "opened");
    expect({.2, .4, .5}, {.2, .4, .5}, "as it was opened, with the shader that is gone");
    EXPECT_EQ(label(1), "as opened: the same");
}

TEST_F(States, KeepTheirLastPictureOrSayThatThereIsNone) {
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    const double slid = state()["controls"]["Paint.uRed"][0];
    user("key s");
    settle();
    choose_state("right", "saved");
    const auto right_is_blank = [&](const char* what) {
        const Pixel near = scene_pixel(25, 20), far = scene_pixel(60, -150);
        EXPECT_EQ(near, far) << what;
        EXPECT_GT(near.red + near.green + near.blue, 600) << what << ": the panel's colour";
        EXPECT_NEAR(scene_pixel(-25, 20).red, std::lround(255 * slid), 1) << what;
    };
    save("paint.frag", "this is no shader\n");
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    settle();
    expect({slid, .4, .5}, {.2, .4, .5}, "after a broken edit, both as they were");
    EXPECT_TRUE(label(1).starts_with("as saved: 0.2, last good picture: ")) << label(1);
    EXPECT_TRUE(label(0).starts_with("now: uRed " + fmt::format("{:.4g}", slid) + ", last good picture: ")) << label(0);
    for (const bool swapped : {true, false}) {
        click("accuracy.swap");
        settle();
        const std::array<double, 3> left{swapped ? .2 : slid, .4, .5}, right{swapped ? slid : .2, .4, .5};
        expect(left, right, "swapped");
        EXPECT_TRUE(label(swapped ? 0 : 1).starts_with("as saved: ")) << label(swapped ? 0 : 1);
        EXPECT_NE(label(swapped ? 0 : 1).find(", last good picture: "), std::string::npos) << label(swapped ? 0 : 1);
    }
    user("key s");
    settle();
    EXPECT_TRUE(state()["widgets"].contains("status.stale")) << "so does the line below a single picture";
    save("paint.frag", "this is no shader either\n");
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 3; }));
    user("key s");
    settle();
    expect({slid, .4, .5}, {.2, .4, .5}, "one picture and two again");
    EXPECT_TRUE(label(1).starts_with("as saved: 0.2, last good picture: ")) << label(1);
    choose_state("right", "TINT=dark");
    right_is_blank("a rung that could never be made");
    EXPECT_TRUE(label(1).starts_with("TINT=dark: ")) << label(1);
    std::filesystem::remove(file("paint.frag"));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 4; }));
    settle();
    right_is_blank("a deleted shader");
    save("paint.frag", fragment("0."));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] >= 5 && s["errors"] == 0; }));
    settle();
    expect({slid, .4, .5}, {slid, .4, 0}, "made as soon as it can be");
    EXPECT_EQ(label(1), "TINT dark");
    click("accuracy.right");
    click("right.settings");
    user("type --delay 8 uReed=0.9");
    user("key Return");
    settle();
    right_is_blank("a uniform that is not there");
    EXPECT_EQ(label(1), "uReed=0.9: there is no uniform 'uReed'; did you mean 'uRed'?");
    EXPECT_TRUE(state()["widgets"].contains("right.settings")) << "the list stays open, for a better text";
    user("key Escape");
    settle();
    EXPECT_FALSE(state()["widgets"].contains("right.settings")) << "one press closes the list with its field";
    // There is nothing to magnify.
    const std::array<double, 4> area = state()["scene"];
    user("mousemove " + std::to_string(static_cast<int>(area[2] / 2) + 30) + " " +
         std::to_string(static_cast<int>(area[3] / 2) + 20) + " keydown i");
    settle();
    EXPECT_FALSE(state().contains("pixels") && state()["pixels"].contains("rgba")) << state()["pixels"];
    user("keyup i");
    // A snapshot that is stored again is shown as it is now.
    user("key ctrl+1");
    settle();
    choose_state("right", "snapshot 1");
    expect({slid, .4, .5}, {slid, .4, .5}, "a snapshot");
    drag(on("Paint.uRed", slid), on("Paint.uRed", .5));
    const double later = state()["controls"]["Paint.uRed"][0];
    user("key ctrl+1");
    settle();
    expect({later, .4, .5}, {later, .4, .5}, "stored again");
    EXPECT_EQ(state()["gl_errors"], json::array());
}

// For README: the index of water beside that of diamond, while the view turns.
class RoomStates : public Desk {
protected:
    RoomStates() : Desk("1280x720x24") {}
};

// It has no picture to compare with another, nor any cost.
TEST_F(RoomStates, OfASceneThatNeverWasWithoutErrors) {
    save("scene.glib", "Vertex paint.vert\nFragment paint.frag\nLadder TINT dark <light>\nProgram Paint\nQuadXY\n");
    save("paint.vert", "void main() { gl_Position = ftransform(); }\n");
    save("paint.frag", "bad\n");
    open("scene.glib", {"--size", "1000x700"});
    user("key s");
    settle();
    for (const std::size_t side : {0, 1}) {
        const std::string label = state()["states"][side];
        EXPECT_NE(label.find("incomplete, for it has errors"), std::string::npos) << label;
    }
    user("key a");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("accuracy"); }));
    settle();
    EXPECT_FALSE(state()["widgets"].contains("accuracy.error")) << "an error of nothing";
    save("paint.frag", "void main() { gl_FragColor = vec4(1.); }\n");
    ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0 && s["widgets"].contains("accuracy.error"); }));
}

TEST_F(RoomStates, WaterBesideDiamondTurnsAsOne) {
    std::filesystem::create_directory_symlink(SNELL_ROOT "/scenes", file("scenes"));
    open("scenes/refraction-room/refraction-room.glib", {"--size", "1280x720"});
    user("key s");
    settle();
    for (const std::string side : {"left", "right"}) {
        click("accuracy." + side);
        click(side + ".settings");
        user(std::string("type --delay 8 uIndex=") + (side == "left" ? "1.33" : "2.42"));
        user("key Return");
        settle();
    }
    EXPECT_EQ(state()["states"][0], "uIndex 1.33");
    EXPECT_EQ(state()["states"][1], "uIndex 2.42");
    user("mousemove 5 5");
    settle();
    const Picture before = look();
    drag({200, 200}, {290, 220});
    EXPECT_TRUE(wait([](const json& s) { return s["grain"] == 0; }));
    user("mousemove 5 5");
    settle();
    const Picture after = look();
    const std::array<double, 4> area = state()["scene"];
    const auto changed = [&](double from, double to) {
        int count = 0;
        for (double x = area[2] * from; x < area[2] * to; x += 7)
            for (double y = 9; y < area[3] * .8; y += 7) count += !(before.at(x, y) == after.at(x, y));
        return count;
    };
    EXPECT_GT(changed(0, .48), 500);
    EXPECT_GT(changed(.52, 1), 500) << "both are live";
    keep("guide-states-window");
    EXPECT_EQ(state()["gl_errors"], json::array());
}

// For docs/window.md: what one bend in a ball of glass lacks, and what it costs.
TEST_F(RoomStates, ARungBesideTheReferenceWithItsErrorAndTime) {
    std::filesystem::create_directory_symlink(SNELL_ROOT "/scenes", file("scenes"));
    open("scenes/light/glass/glass.glib", {"--size", "1280x720"});
    click("BEND");
    click("BEND.single");
    settle();
    user("key s a");
    settle();
    EXPECT_EQ(state()["states"][0], "now: BEND single");
    EXPECT_TRUE(wait([](const json& s) { return s["accuracy"]["samples"] > 0; }));
    if (!screens_folder().empty()) {
        click("accuracy.measure");
        EXPECT_TRUE(wait([](const json& s) { return s["accuracy"]["points"].size() == 4; }, 60));
        EXPECT_TRUE(wait([](const json& s) { return !s["accuracy"]["measuring"].get<bool>(); }, 60));
    }
    user("mousemove 5 5");
    settle();
    keep("guide-accuracy-window");
    const double error = state()["accuracy"]["error"];
    EXPECT_GT(error, .01) << "one bend is not what two are";
    EXPECT_EQ(state()["gl_errors"], json::array());
}

}  // namespace
}  // namespace snell::test
