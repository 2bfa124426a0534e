// Edits that break a scene or its shaders, at random, while the window shows it: the picture stays every time.
//
//   SNELL_TORTURE_EDITS   how many (3)
//   SNELL_TORTURE_SEED    of the series (9)
#include <algorithm>
#include <map>

#include "tests/gui/desk.h"
#include "tests/torture/campaign/campaign.h"
#include "tests/torture/mutate.h"

namespace snell::test {
namespace {

using nlohmann::json;
using torture::Language;

class Torture : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        std::filesystem::create_directory(file("trial"));
        for (const auto& [name, text] : good_) {
            torture::learn(dictionary_, language_of(name), text);
            save(name, text);
        }
        save("tint.glsl", tint(0));
    }

    static Language language_of(const std::string& name) {
        return name.ends_with(".glib") || name.ends_with(".inc") ? Language::scene : Language::shader;
    }
    static std::string tint(unsigned k) { return "float tint() { return " + std::to_string(k % 17 / 16.) + "; }\n"; }
    static int blue(unsigned k) { return static_cast<int>(k % 17 * 255. / 16. + .5); }

    // The damaged text of one file, such that a process that never saw the good one finds errors in the scene.
    std::pair<std::string, std::string> broken(torture::Random& random, std::string& how) {
        while (true) {
            const auto& [name, text] =
                *std::next(good_.begin(), static_cast<long>(torture::below(random, good_.size())));
            std::string damaged = text;
            how = name;
            for (std::size_t left = 1 + torture::below(random, 3); left > 0; --left)
                how += "; " + torture::damage(damaged, language_of(name), dictionary_, random);
            for (const auto& [other, whole] : good_) save("trial/" + other, other == name ? damaged : whole);
            save("trial/tint.glsl", tint(0));
            if (run({"render", "-q", "--size", "64x64", file("trial/scene.glib"), "-o", file("trial/o.png")}, "") == 1)
                return {name, damaged};
        }
    }

    // Down to where messages lie over the scene's area; its top where there are none.
    static double messages_end(const json& state) {
        if (!state["widgets"].contains("problems.panel")) return state["scene"][1];
        const json& widgets = state["widgets"];  // the grip lies below the panel, where there are many messages
        const std::array<double, 4> last =
            widgets[widgets.contains("problems.grip") ? "problems.grip" : "problems.panel"];
        return last[1] + last[3] + 1;
    }
    // What can be seen of the scene's area, from the bottom.
    static std::vector<Pixel> area(const Picture& screen, const json& state) {
        const std::array<double, 4> scene = state["scene"];
        std::vector<Pixel> pixels;
        for (double y = scene[1] + scene[3] - 1; y >= messages_end(state); --y)
            for (double x = scene[0]; x < scene[0] + scene[2]; ++x) pixels.push_back(screen.at(x, y));
        return pixels;
    }
    // Messages cover some of the other.
    static bool same(const std::vector<Pixel>& whole, const std::vector<Pixel>& part) {
        return part.size() > whole.size() / 10 && part.size() <= whole.size() &&
               std::equal(part.begin(), part.end(), whole.begin());
    }

    const std::map<std::string, std::string> good_{
        {"scene.glib",
         "##OpenGL GLIB\nPerspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nBackground .1 .2 .1\nVertex paint.vert\n"
         "Fragment paint.frag\nProgram Paint  uRed <0. .2 1.>  uBand [.2 .5 .8]\nQuadXY 0. 1. 8 8\n"
         "Translate 1.2 0 0\nSphere .4 20 20\nInclude part.inc\n"},
        {"part.inc", "Translate -2.4 0 0\nRotate 30 1 1 0\nBox .6 .6 .6\n"},
        {"paint.vert",
         "#version 330 compatibility\nout vec3 vPlace;\nvoid main()\n{\n    vPlace = gl_Vertex.xyz;\n"
         "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n"},
        {"paint.frag",
         "#version 330 compatibility\n#include \"tint.glsl\"\nuniform float uRed;\nuniform vec3 uBand;\n"
         "in vec3 vPlace;\nvoid main()\n{\n    float green = fract(4. * vPlace.x) < uBand.y ? uBand.x : uBand.z;\n"
         "    gl_FragColor = vec4(uRed, green, tint(), 1.);\n}\n"}};
    torture::Dictionary dictionary_;
};

TEST_F(Torture, NoBrokenEditTakesThePictureAway) {
    const unsigned count = torture::number_of("SNELL_TORTURE_EDITS", 3);
    std::seed_seq seeds{torture::number_of("SNELL_TORTURE_SEED", 9)};
    torture::Random random(seeds);
    open("scene.glib", {"--exit-after", std::to_string(60 + 20 * count)});
    drag(on("Paint.uRed", .2), on("Paint.uRed", .5));
    const double red = state()["controls"]["Paint.uRed"][0];
    for (unsigned k = 1; k <= count; ++k) {
        std::string how;
        const auto [name, damaged] = broken(random, how);
        SCOPED_TRACE("edit " + std::to_string(k) + ": " + how + "\n" + damaged);
        const json before = state();
        ASSERT_EQ(before["errors"], 0) << before["problems"];
        const std::vector<Pixel> picture = area(look(), before);

        save(name, damaged, k % 3 == 0);
        ASSERT_TRUE(wait([&](const json& s) { return s["revision"] > before["revision"] && s["errors"] > 0; }));
        settle();
        const json after = state();
        EXPECT_TRUE(after["stale"]);
        ASSERT_TRUE(after["widgets"].contains("problems.panel")) << "nothing is said";
        EXPECT_TRUE(same(picture, area(look(), after)));
        EXPECT_EQ(after["controls"], before["controls"]);
        if (k % 8 == 1) keep("torture-" + std::to_string(k));
        // Below many messages, and now and then below few.
        if (k % 8 == 1 || messages_end(after) > after["scene"][3].get<double>() / 4) {
            const auto [x, y] = on("problems.hide");
            user("mousemove " + std::to_string(x) + " " + std::to_string(y) + " click 1");
            ASSERT_TRUE(wait([](const json& s) { return !s["widgets"].contains("problems.panel"); }));
            settle();
            EXPECT_TRUE(area(look(), state()) == picture) << "what was below the messages";
        }

        save("tint.glsl", tint(k));
        save(name, good_.at(name));
        ASSERT_TRUE(wait([](const json& s) { return s["errors"] == 0 && s["stale"] == false; }));
        ASSERT_TRUE(wait([&](const json&) { return scene_pixel(20, 20).blue == blue(k); })) << "it goes on";
        settle();
        EXPECT_EQ(state()["controls"]["Paint.uRed"][0], red);
        EXPECT_EQ(state()["gl_errors"], json::array());
        ASSERT_TRUE(alive());
        if (HasFailure()) break;
    }
}

}  // namespace
}  // namespace snell::test
