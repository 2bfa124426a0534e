// Input at random: mouse, keys, wheel, sizes of the window, and files that are damaged and mended. The window must
// survive, and undo must lead back to the first picture.
//
//   SNELL_RANDOM_ROUNDS   rounds of 120 actions each (1); one takes about 5 s
//   SNELL_RANDOM_SEED     of the series (1)
#include <random>

#include "tests/gui/desk.h"
#include "tests/torture/campaign/campaign.h"

namespace snell::test {
namespace {

using nlohmann::json;

constexpr const char* random_scene =
    "##OpenGL GLIB\nPerspective 50\nLookAt 0 1 4  0 0 0  0 1 0\nBackground .1 .2 .1\nTexture2D 5 wall.bmp\n"
    "Vertex paint.vert\nFragment paint.frag\n"
    "Program Paint  uRed <0. .2 1.>  uBand [.2 .5 .8]  uTint {.2 .4 .6}  uOn <true>  uCount <1 3 9>  uWall 5\n"
    "QuadXY 0. 1. 8 8\nTranslate 1.2 0 0\nSphere .4 20 20\n";
constexpr const char* random_fragment =
    "#version 330 compatibility\nuniform float uRed;\nuniform vec3 uBand, uTint;\nuniform bool uOn;\n"
    "uniform int uCount;\nuniform sampler2D uWall;\nin vec3 vPlace;\nvoid main()\n{\n"
    "    float green = fract(float(uCount) * vPlace.x) < uBand.y ? uBand.x : uBand.z;\n"
    "    gl_FragColor = vec4(uRed, uOn ? green : 0., .2, 1.) * .5 + .4 * vec4(uTint, 1.) + .1 * texture(uWall, "
    "vPlace.xy);\n}\n";

class RandomInput : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("scene.glib", random_scene);
        save("paint.vert",
             "#version 330 compatibility\nout vec3 vPlace;\nvoid main()\n{\n    vPlace = gl_Vertex.xyz;\n"
             "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n");
        save("paint.frag", random_fragment);
        save("wall.bmp", std::string("BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18\0", 30) +
                             std::string(24, '\0') + std::string("\x10\x80\xf0\0", 4));
        setenv("VISUAL", "true", 1);
        std::seed_seq seeds{torture::number_of("SNELL_RANDOM_SEED", 1)};
        random_.seed(seeds);
    }

    int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
    template <class T>
    T one_of(std::initializer_list<T> list) {
        return list.begin()[below(static_cast<int>(list.size()))];
    }
    // A place in the window: mostly on one of its widgets.
    std::string place() {
        const json now = state();
        int x = below(800), y = below(600);
        if (now.contains("widgets") && !now["widgets"].empty() && below(4) > 0) {
            const json& widgets = now["widgets"];
            const std::array<double, 4> rect = *std::next(widgets.begin(), below(static_cast<int>(widgets.size())));
            x = static_cast<int>(rect[0] + rect[2] * below(100) / 100);
            y = static_cast<int>(rect[1] + rect[3] * below(100) / 100);
        }
        return "mousemove " + std::to_string(std::max(0, x)) + " " + std::to_string(std::max(0, y));
    }
    std::string press(const std::string& button) {
        std::string words = place() + " mousedown " + button;
        for (int i = below(4); i >= 0; --i) words += " sleep .01 " + place();
        if (below(3) == 0) words += std::string(" key ") + one_of<const char*>({"ctrl+z", "ctrl+y"}) + " " + place();
        return words + " mouseup " + button;
    }
    // Words of xdotool. No key opens another scene, saves the scene or closes the window.
    std::string action() {
        switch (below(9)) {
            case 0:
            case 1:
                return press("1");
            case 2:
                return press(one_of<const char*>({"2", "3"}));
            case 3:
                return place() + " click " + one_of<const char*>({"1", "1", "1", "3", "4", "5"});
            case 4:
                return place() + " click --repeat 2 --delay 20 1 type --delay 2 " +
                       one_of<const char*>({"0,7", "1/3", "500", "nan", "(0-1e300)", "a", "((", "1e", "2*pi", "-"});
            case 5:
                return std::string("key ") +
                       one_of<const char*>({"Return", "Escape", "Tab", "shift+Tab", "Left", "Right", "Up", "Down",
                                            "Page_Up", "Page_Down", "Home", "End", "BackSpace", "Delete", "space"});
            case 6:
                return std::string("key ") +
                       one_of<const char*>({"r", "p", "n", "h", "a", "i", "F1", "F11", "1", "2", "ctrl+1", "ctrl+2",
                                            "F5", "ctrl+z", "ctrl+y", "ctrl+shift+z", "ctrl+plus", "ctrl+minus"});
            case 7:
                return "keydown " + std::string(one_of<const char*>({"shift", "ctrl", "alt"})) + " " + press("1") +
                       " keyup shift keyup ctrl keyup alt";
            default:
                return "sleep .02";
        }
    }
    void damage() {
        std::string text = below(2) ? random_scene : random_fragment;
        const std::string name = text == random_scene ? "scene.glib" : "paint.frag";
        const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size())));
        if (below(2))
            text.resize(at);
        else
            text.insert(at, one_of<const char*>({"<", "\xff", "1e999", "}", "\n\n#", "uRed"}));
        save(name, text, below(2));
    }
    void mend() {
        save("scene.glib", random_scene);
        save("paint.frag", random_fragment);
        wait([](const json& s) { return s["errors"] == 0 && !s["stale"]; });
    }
    void resize() {
        user("search --onlyvisible --name snell windowsize " + std::to_string(300 + below(700)) + " " +
             std::to_string(200 + below(500)));
    }
    static json standing(const json& s) { return {{"controls", s["controls"]}, {"view", s["view"]["text"]}}; }

    std::mt19937 random_;
};

TEST_F(RandomInput, NeitherEndsTheWindowNorTheWayBack) {
    const unsigned rounds = torture::number_of("SNELL_RANDOM_ROUNDS", 1);
    open("scene.glib", {"--exit-after", std::to_string(60 + 60 * rounds)});
    user("mousemove 5 5");
    settle();
    const json first = standing(state());
    const Picture picture = look();
    for (unsigned round = 0; round < rounds && !HasFailure(); ++round) {
        std::string done;
        for (int i = 0; i < 120; ++i) {
            const std::string words = action();
            SCOPED_TRACE("round " + std::to_string(round) + ", action " + std::to_string(i) + ": " + words);
            user(below(4) == 0 ? "key Escape " + words : words);
            const bool damages = below(20) == 0, mends = below(20) == 0;
            if (damages) damage();
            if (mends) mend();
            const json now = state();
            done += words + (damages ? " damaged" : "") + (mends ? " mended" : "") + ": " + now["undo"].dump() + " " +
                    now["notice"].dump() + " " + now["controls"].dump() + "\n";
            if (below(25) == 0) resize();
            ASSERT_TRUE(alive());
        }
        mend();
        for (int i = 0; i < 5; ++i) user("key Escape");
        settle();
        ASSERT_EQ(state()["gl_errors"], json::array());
        const json steps = state()["undo"];
        std::printf("%d steps\n", steps.get<int>());
        EXPECT_GT(steps, 5);
        for (int i = 0; i < 300 && state()["undo"] != 0; ++i) user("key ctrl+z");
        user("key ctrl+z");  // for a slider that moves by itself
        settle();
        EXPECT_EQ(state()["undo"], 0);
        EXPECT_EQ(standing(state()), first) << done;
        EXPECT_EQ(state()["errors"], 0) << state()["problems"];
    }
    EXPECT_EQ(bytes("out/errors").find("imgui"), std::string::npos) << bytes("out/errors");
    end_window();
    std::filesystem::remove(file("state/snell/window.json"));  // the panel may be hidden
    open("scene.glib");
    user("mousemove 5 5");
    settle();
    EXPECT_EQ(standing(state()), first);
    const std::array<double, 4> scene = state()["scene"];
    const Picture now = look();
    for (int y = 0; y < static_cast<int>(scene[3]); ++y)
        for (int x = 0; x < static_cast<int>(scene[2]); ++x) ASSERT_EQ(picture.at(x, y), now.at(x, y)) << x << ' ' << y;
}

}  // namespace
}  // namespace snell::test
