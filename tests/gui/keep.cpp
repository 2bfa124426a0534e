// Values that are kept: in the scene, in snapshots, as a command, in a page; time and labels.
#include <cmath>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

const std::string scene =
    "##OpenGL GLIB\r\nPerspective 50\r\nLookAt 0 0 4  0 0 0  0 1 0\r\nBackground 0 0 0\r\nVertex paint.vert\r\n"
    "Fragment paint.frag\r\nProgram Paint\tuRed <0. .2 1.>  \\  # caf\xE9\r\n   uGreen <.1 .4 1.>\r\nQuadXY 0. 1.";

class Keep : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib", scene);
        save("paint.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
        save("paint.frag",
             "#version 330 compatibility\nuniform float uRed, uGreen;\n"
             "void main() { gl_FragColor = vec4(uRed, uGreen, .2, 1.); }\n");
    }

    double red() const { return state()["controls"]["Paint.uRed"][0]; }
    void expect_red(double value) const { EXPECT_NEAR(scene_pixel(20, 20).red, std::lround(255 * value), 1); }
};

TEST_F(Keep, SavedValuesChangeOnlyTheirNumbersAndAreUndoneAlone) {
    open("scene.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    const double slid = red();
    ASSERT_NE(slid, .2);
    choose("save", "save");
    const std::string after = bytes("scene.glib");
    const std::size_t at = scene.find(".2 1.>");
    ASSERT_GT(after.size(), scene.size() - 6);
    EXPECT_EQ(after.substr(0, at), scene.substr(0, at));
    const std::size_t end = after.find(" 1.>", at);
    EXPECT_EQ(std::stod(after.substr(at, end - at)), slid) << after;
    EXPECT_LE(end - at, 6u) << "as short as it is shown";
    EXPECT_EQ(after.substr(end), scene.substr(scene.find(" 1.>", at)));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; })) << "what was saved is read";
    settle();
    EXPECT_EQ(red(), slid);
    expect_red(slid);
    EXPECT_EQ(state()["errors"], 0);
    user("key ctrl+z");
    ASSERT_TRUE(wait([](const json& s) { return s["notice"] == "undo: save to scene.glib"; })) << state()["notice"];
    EXPECT_EQ(bytes("scene.glib"), scene);
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 3; })) << "the file of before is read";
    settle();
    EXPECT_EQ(red(), slid) << "the slider stays";
    expect_red(slid);
    user("key ctrl+y");
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 4; })) << "and is saved again";
    EXPECT_EQ(bytes("scene.glib"), after);
    settle();
    user("key ctrl+z");
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 5; }));
    settle();
    user("key ctrl+z");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] == .2; })) << "what was before the save";
    EXPECT_EQ(bytes("scene.glib"), scene);
}

TEST_F(Keep, OfASceneThatIsGoneTheSaveIsNotUndoneAndItIsSavedAsAnother) {
    open("scene.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    choose("save", "save");
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    std::filesystem::remove(file("scene.glib"));
    ASSERT_TRUE(wait([](const json& s) { return s["stale"] == true; }));
    settle();
    user("key ctrl+z");
    ASSERT_TRUE(wait([](const json& s) { return s["failure"] != ""; }));
    EXPECT_EQ(state()["failure"], "not undone: scene.glib is gone");
    click("failure.save as");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save as save"); }));
    user("key Return");
    ASSERT_TRUE(wait([](const json& s) { return s["stale"] == false && s["failure"] == ""; }));
    EXPECT_NE(bytes("scene.glib"), "");
}

TEST_F(Keep, AnEditAfterASaveIsNotUndoneWithIt) {
    open("scene.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    const double slid = red();
    choose("save", "save");
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    const std::string edited = bytes("scene.glib") + "\n# edited";
    save("scene.glib", edited);
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 3; }));
    settle();
    user("key ctrl+z");
    ASSERT_TRUE(wait([](const json& s) { return s["failure"].get<std::string>().find("not undone: ") == 0; }))
        << state()["failure"];
    EXPECT_EQ(state()["failure"], "not undone: scene.glib was changed meanwhile: it is left as it is")
        << "not its path";
    EXPECT_TRUE(wait([](const json& s) { return s["widgets"].contains("failure.ok"); }));
    EXPECT_FALSE(state()["widgets"].contains("failure.reload")) << "it is read already";
    EXPECT_FALSE(state()["widgets"].contains("failure.save as"));
    EXPECT_EQ(bytes("scene.glib"), edited);
    EXPECT_EQ(red(), slid);
    // Values follow the next edit of the text, as if nothing had been undone.
    std::string text = edited;
    const std::size_t at = text.find("uGreen <.1 .4");
    save("scene.glib", text.replace(at, 13, "uGreen <.1 .7"));
    EXPECT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uGreen"][0] == .7; }));
    settle();
    user("key ctrl+z");
    ASSERT_TRUE(wait([](const json& s) { return s["controls"]["Paint.uRed"][0] == .2; })) << "past the save";
    settle();
    const std::string notice = state()["notice"];
    EXPECT_NE(notice.find("; save to scene.glib is not undone"), notice.npos) << notice;
    EXPECT_EQ(state()["failure"].get<std::string>().find("not undone: "), 0U) << "true still, and not answered";
}

TEST_F(Keep, SnapshotsAreStoredAndRestoredByKeys) {
    open("scene.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    const double slid = red();
    user("key ctrl+1");
    settle();
    const json file = json::parse(bytes("scene.snapshots.json"), nullptr, false);
    const std::string options = file["1"]["options"];
    EXPECT_NE(options.find("--set Paint.uRed=" + json(slid).dump() + "\n"), options.npos) << options;
    drag(on("Paint.uRed", .75), on("Paint.uRed", .1));
    EXPECT_NE(red(), slid);
    user("key 1");
    ASSERT_TRUE(wait([&](const json& s) { return s["controls"]["Paint.uRed"][0] == slid; }));
    settle();
    expect_red(slid);
    EXPECT_EQ(bytes("scene.glib"), scene);
    // What no longer fits is left out.
    save("scene.snapshots.json",
         R"({"1": {"options": "--set Paint.uRed=0.5\n--set Paint.uGone=1\n--set Paint.uGreen=x"}})");
    click("snapshot 1");
    ASSERT_TRUE(wait([&](const json& s) { return s["controls"]["Paint.uRed"][0] == .5; }));
    EXPECT_EQ(state()["controls"]["Paint.uGreen"][0], .4);
    // Its menu deletes it, and Ctrl+Z brings the file back.
    const std::string before = bytes("scene.snapshots.json");
    click("snapshot 1", .5, 3);
    click("snapshot 1.delete");
    settle();
    EXPECT_EQ(json::parse(bytes("scene.snapshots.json"), nullptr, false), json::object());
    EXPECT_FALSE(state()["widgets"].contains("snapshot 1.stored"));
    user("key ctrl+z");
    settle();
    EXPECT_EQ(bytes("scene.snapshots.json"), before);
    EXPECT_TRUE(state()["widgets"].contains("snapshot 1.stored"));
}

TEST_F(Keep, TheCopiedCommandDrawsThePictureOfTheWindow) {
    open("scene.glib");
    drag(on("Paint.uRed", .2), on("Paint.uRed", .75));
    const std::array<double, 4> area = state()["scene"];
    const std::array<int, 2> middle{static_cast<int>(area[2] / 2), static_cast<int>(area[3] / 2)};
    drag(middle, {middle[0] + 60, middle[1] + 30});
    choose("save", "copy command");
    const std::string copied = state()["notice"];
    ASSERT_EQ(copied.rfind("copied: ", 0), 0u) << copied;
    const std::string command = copied.substr(8);
    EXPECT_EQ(command.rfind("snell render ", 0), 0u) << command;
    ASSERT_EQ(shell(command), 0) << command;
    const Picture window = look(), drawn = read_picture("scene.png");
    ASSERT_EQ(drawn.width, static_cast<int>(area[2])) << command;
    ASSERT_EQ(drawn.height, static_cast<int>(area[3]));
    int different = 0;
    for (int y = 0; y < drawn.height; ++y)
        for (int x = 0; x < drawn.width; ++x) different += !(drawn.at(x, y) == window.at(x, y));
    EXPECT_EQ(different, 0) << command;
}

TEST_F(Keep, AltAndShiftDragFinely) {
    open("scene.glib");
    double before = .2;
    for (const std::string key : {"Alt_L", "Shift_L"}) {
        user("keydown " + key);
        drag(on("Paint.uRed", .5), on("Paint.uRed", .9));
        user("keyup " + key);
        EXPECT_GT(red(), before) << key;
        EXPECT_LT(red(), before + .05) << "a twentieth of the way";
        expect_red(red());
        before = red();
    }
}

TEST_F(Keep, ValuesOverThePicture) {
    open("scene.glib");
    const auto white = [&] {
        const Picture picture = look();
        const std::array<double, 4> area = state()["scene"];
        int count = 0;
        for (int y = static_cast<int>(area[3]) - 60; y < static_cast<int>(area[3]); ++y)
            for (int x = 0; x < 200; ++x) count += picture.at(x, y).red > 200;
        return count;
    };
    EXPECT_EQ(white(), 0);
    choose("view", "labels");
    EXPECT_GT(white(), 100);
    // On a light picture, they are on a dark plate.
    save("scene.glib",
         scene.substr(0, scene.find("Background 0 0 0")) + "Background 1 1 1" + scene.substr(scene.find("\r\nVertex")));
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    settle();
    const std::array<double, 4> area = state()["scene"];
    const Picture picture = look();
    int dark = 0;
    for (int y = static_cast<int>(area[3]) - 60; y < static_cast<int>(area[3]); ++y)
        for (int x = 0; x < 200; ++x) dark += picture.at(x, y).red < 128;
    EXPECT_GT(dark, 2000);
}

TEST_F(Keep, TheControlsOfTimeStayWhenNoValueNeedsThem) {
    // Slow enough to be drawn by a program for its values.
    save("paint.frag",
         "#version 330 compatibility\nuniform float Timer, uRed, uGreen;\nvoid main() {\nfloat sum = 0.;\n"
         "for (int i = 0; i < 100; ++i) sum += sin(float(i) * gl_FragCoord.x);\n"
         "gl_FragColor = vec4(uRed + 1e-9 * sum, uGreen > .5 ? Timer : .1, .2, 1.);\n}\n");
    open("scene.glib");
    click("play");
    const auto made = [&](const json&) {
        settle();  // programs are made while nothing is told
        return state()["counters"]["specialised"] > 0;
    };
    ASSERT_TRUE(wait(made)) << "there is a program without";
    user("mousemove 100 100");
    settle();
    EXPECT_FALSE(state()["widgets"].contains("status.time")) << "it does not read the time";
    EXPECT_TRUE(state()["widgets"].contains("play"));
    user("key ctrl+s");
    settle();
    EXPECT_EQ(state()["notice"], "nothing to save");
}

TEST_F(Keep, TimeIsHeldSteppedAndScrubbed) {
    save("paint.frag",
         "#version 330 compatibility\nuniform float Timer, uRed, uGreen;\n"
         "void main() { gl_FragColor = vec4(Timer, uGreen, uRed, 1.); }\n");
    open("scene.glib");
    user("key space");
    settle();
    const json held = state();
    EXPECT_FALSE(wait([&](const json& s) { return s["frames"] != held["frames"]; }, .3))
        << "no frames while it is held";
    click("rewind");
    EXPECT_EQ(state()["time"], 0);
    click("step");
    EXPECT_NEAR(state()["time"].get<double>(), .04, 1e-12);
    click("scrub");
    const double time = state()["time"];
    EXPECT_NEAR(time, 5, .2);
    expect_red(time / 10);
    user("key ctrl+shift+s");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save as save"); }));
    type("save as file", "other.glib", Field::text);
    ASSERT_TRUE(wait([](const json& s) { return s["file"].get<std::string>().ends_with("other.glib"); }));
    settle();
    EXPECT_EQ(state()["time"], time) << "it is the same scene under another name";
}

// Pages for browsers hold the values, too.
class SavedPage : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("page.html",
             "<title>snell</title><script type=\"application/json\" id=\"scene\">null</script>"
             "<script type=\"text/plain\" id=\"archive\"></script>");
        setenv("SNELL_WEB", file("").c_str(), 1);
        save("scene.glib", "Fragment paint.frag\nProgram Paint uRed <0. .25 1.>\nSphere 1\n");
        save("paint.frag", "uniform float uRed;\nvoid main() { gl_FragColor = vec4(uRed, .5, 0., 1.); }\n");
    }
    void TearDown() override {
        unsetenv("SNELL_WEB");
        Desk::TearDown();
    }
    void save_page() {
        choose("save", "page");
        EXPECT_TRUE(wait([](const json& s) { return s["widgets"].contains("save page folder"); }));
        click("save page save");
    }
    bool says(const std::string& text) {
        return wait([&](const json& s) {
            return s["notice"].get<std::string>().find(text) == 0 || s["failure"].get<std::string>().find(text) == 0;
        });
    }
};

TEST_F(SavedPage, HoldsTheCurrentValues) {
    open("scene.glib", {"--size", "640x480"});
    drag(on("Paint.uRed", .25), on("Paint.uRed", .75));
    drag({150, 200}, {220, 230});
    save_page();
    ASSERT_TRUE(says("saved scene.html: ")) << state()["notice"];
    EXPECT_NE(state()["notice"].get<std::string>().find("redistributes 2 files"), std::string::npos) << state();
    const std::string page = bytes("scene.html");
    const std::string begin = "id=\"scene\">";
    const std::size_t at = page.find(begin) + begin.size();
    const json data = json::parse(page.substr(at, page.find("</script>", at) - at));
    EXPECT_EQ(data["scene"], "scene.glib");
    const double red = state()["controls"]["Paint.uRed"][0];
    EXPECT_NE(red, .25);
    ASSERT_EQ(data["values"].size(), 1u);
    const std::string value = data["values"][0];
    EXPECT_EQ(value.rfind("Paint.uRed=", 0), 0u) << value;
    EXPECT_EQ(std::stod(value.substr(11)), red);
    EXPECT_EQ(data["view"], state()["view"]["text"]);
    EXPECT_NE(data["view"], "");
    // What is there is replaced only when asked.
    choose("save", "page");
    click("save page save");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save page save"); }));
    click("save page save");
    ASSERT_TRUE(says("saved scene.html: ")) << state()["notice"];
    EXPECT_TRUE(alive());
}

TEST_F(SavedPage, WithoutThePagesPartTheWayOutIsNamedUntilAPageIsSaved) {
    const std::string part = bytes("page.html");
    std::filesystem::remove(file("page.html"));
    open("scene.glib", {"--size", "640x480"});
    choose("save", "page");
    ASSERT_TRUE(says("no page can be saved: ")) << state();
    EXPECT_FALSE(state()["widgets"].contains("save page save")) << "and no name is asked for";
    EXPECT_NE(state()["failure"].get<std::string>().find("'./dev web' in the folder of snell's sources builds it"),
              std::string::npos)
        << state()["failure"];
    save("page.html", part);
    choose("save", "page");
    EXPECT_TRUE(wait([](const json& s) { return s["widgets"].contains("save page folder"); }));
    user("type --delay 20 other");  // in place of the whole name
    user("key Return");
    ASSERT_TRUE(says("saved other.html: ")) << state()["notice"];
    EXPECT_EQ(state()["failure"], "") << "over the next success";
    EXPECT_TRUE(alive());
}

TEST_F(SavedPage, WhatBrowsersLackIsSaid) {
    save("paint.frag",
         "#version 400 compatibility\nuniform float uRed;\nuniform samplerBuffer uList;\n"
         "void main() { gl_FragColor = vec4(uRed, texelFetch(uList, 0).gb, 1.); }\n");
    open("scene.glib", {"--size", "640x480"});
    save_page();
    ASSERT_TRUE(says("scene.html is not saved: ")) << state()["failure"];
    EXPECT_NE(state()["failure"].get<std::string>().find("samplerBuffer"), std::string::npos) << state()["failure"];
    EXPECT_EQ(bytes("scene.html"), "");
    EXPECT_TRUE(alive());
}

}  // namespace
}  // namespace snell::test
