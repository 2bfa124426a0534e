// Objects picked and moved in the window, and the view that a copied command draws.
#include <cmath>

#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

constexpr const char* scene = R"(##OpenGL GLIB
Ortho -2 2 -2 2
Background 0 0 .4
Vertex paint.vert
Fragment paint.frag
Program Back uColor {0. .5 0. 1.}
QuadXY -.5 1.5
Program Front uColor {.8 .1 0. 1.}
PushMatrix
Translate -.5 0 0
Scale .5
Sphere 1. 40 40
PopMatrix
)";

class PickWindow : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib", scene);
        save("paint.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
        save("paint.frag",
             "#version 330 compatibility\nuniform vec4 uColor;\nvoid main() { gl_FragColor = uColor; }\n");
    }
    // On the screen, of a point of the plane that the scene shows.
    std::array<int, 2> at(double x, double y) const {
        const std::array<double, 4> area = state()["scene"];
        const double unit = std::min(area[2], area[3]) / 4;
        return {static_cast<int>(area[0] + area[2] / 2 + x * unit), static_cast<int>(area[1] + area[3] / 2 - y * unit)};
    }
    Pixel pixel(double x, double y) const {
        const auto [right, down] = at(x, y);
        return look().at(right, down);
    }
    json object() const { return state()["view"]["object"]; }
    int outlined() const {
        const Picture picture = look();
        int count = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) count += picture.at(x, y) == Pixel{255, 158, 13};
        return count;
    }
    const Pixel red{204, 26, 0}, green{0, 128, 0};
};

TEST_F(PickWindow, AnObjectIsPickedMovedAndLetGo) {
    open("scene.glib", {"--no-specialise"});  // where frames are slow, programs for values are compiled later
    click(at(-.5, 0));
    EXPECT_TRUE(object().is_null()) << "not before it is asked for";
    EXPECT_EQ(outlined(), 0);
    const json before = state()["counters"];
    user("key p");
    settle();
    EXPECT_EQ(state()["counters"]["programs_compiled"], before["programs_compiled"]) << "nor paid for";
    EXPECT_EQ(state()["counters"]["gpu_bytes"], before["gpu_bytes"]);
    click(at(-.5, .1));
    ASSERT_EQ(object(), 1);
    EXPECT_GT(outlined(), 200);
    ASSERT_EQ(pixel(-.5, 0), red) << "the object itself is left alone";
    ASSERT_EQ(pixel(.7, .2), green);

    drag(at(-.5, 0), at(.7, .2), 3);
    EXPECT_EQ(pixel(.7, .2), red);
    EXPECT_EQ(pixel(.7 + .45, .2), red) << "its size is what it was";
    EXPECT_EQ(pixel(-.5, 0), green);
    EXPECT_EQ(pixel(-1.4, 1.4), green) << "the other stays";
    const std::string text = state()["view"]["text"];
    EXPECT_NE(text.find("object1.x=1."), std::string::npos) << text;
    EXPECT_EQ(state()["view"]["x"], 0) << "and so does the scene";

    click(at(1.8, 1.8));
    EXPECT_TRUE(object().is_null());
    EXPECT_EQ(outlined(), 0);
    EXPECT_EQ(pixel(.7, .2), red) << "let go of, it stays where it is";
    click(at(.7, .2));
    EXPECT_EQ(object(), 1) << "it is picked where it is";
    click(at(-1.4, 1.4));
    EXPECT_EQ(object(), 0);
    // A line more ahead of it: the same object is another number.
    std::string more = scene;
    more.insert(more.find("Program Back"), "Color 0 0 0\n");
    more.insert(more.find("QuadXY"), "QuadXY 1. .01\n");
    save("scene.glib", more);
    ASSERT_TRUE(wait([](const json& s) { return s["revision"] == 2; }));
    settle();
    EXPECT_NE(std::string(state()["view"]["text"]).find("object2.x=1."), std::string::npos);
    EXPECT_EQ(pixel(.7, .2), red);
    user("key r");
    settle();
    EXPECT_EQ(pixel(-.5, 0), red) << "all as the scene has it";
    EXPECT_TRUE(state()["gl_errors"].empty());
}

TEST_F(PickWindow, TheCopiedCommandDrawsMovedObjectsAxesProjectionAndBackground) {
    open("scene.glib");
    user("key p");
    click(at(-.5, 0));
    ASSERT_EQ(object(), 1);
    drag(at(-.5, 0), at(-.2, .4), 3);
    drag(at(-.2, .4), at(.1, .6));
    user("key Escape");
    settle();
    drag(at(-1.9, -1.9), at(-1.4, -1.7));
    choose("view", "perspective");
    click("tools");
    click("view");
    click("background", .7);
    choose("save", "copy command");
    const std::string copied = state()["notice"];
    ASSERT_EQ(copied.rfind("copied: ", 0), 0u) << copied;
    EXPECT_NE(copied.find("--axes"), std::string::npos);
    ASSERT_EQ(shell(copied.substr(8)), 0) << copied;
    const Picture drawn = read_picture("scene.png");
    const Picture window = look();
    int different = 0, white = 0;
    for (int v = 0; v < drawn.height; ++v)
        for (int u = 0; u < drawn.width; ++u) {
            different += !(drawn.at(u, v) == window.at(u, v));
            white += drawn.at(u, v) == Pixel{255, 255, 255};
        }
    EXPECT_EQ(different, 0) << copied;
    EXPECT_GT(white, 300) << "the axes are there";
}

}  // namespace
}  // namespace snell::test
