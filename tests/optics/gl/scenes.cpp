// Every shipped scene: clean, the same at every draw, finite wherever its sliders are, and with no idle control.
#include "tests/hard_case.h"
#include "tests/harness/harness.h"
#include "tests/optics/gl/common.h"
#include "tests/words.h"

namespace snell::test {
namespace {

// Those that others include are no scenes of their own.
bool is_part(const std::filesystem::path& path) {
    for (const auto& entry : std::filesystem::directory_iterator(path.parent_path())) {
        if (entry.path().extension() != ".glib") continue;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);)
            if (line == "Include " + path.filename().string()) return true;
    }
    return false;
}

std::vector<std::string> shipped_scenes() {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(SNELL_ROOT "/scenes"))
        if (entry.path().extension() == ".glib" && !is_part(entry.path())) paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

// The scenes with smaller targets: each texel of one takes as long as a pixel, and what is said of pixels holds in few.
Access small_targets() {
    std::map<std::string, std::string> texts;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(SNELL_ROOT "/scenes")) {
        if (entry.path().extension() != ".glib" && entry.path().extension() != ".inc") continue;
        std::ifstream in(entry.path());
        std::string text;
        for (std::string line; std::getline(in, line); text += line + "\n") {
            const std::vector<std::string> parts = words(line, ' ');
            if (parts.size() < 3 || parts[2].find_first_not_of("0123456789") != std::string::npos) continue;
            if (parts[0] == "CubeMap") line = "CubeMap " + parts[1] + " 64";
            if (parts[0] == "Texture2D") line = "Texture2D " + parts[1] + " 64 64";
        }
        texts[entry.path().string()] = std::move(text);
    }
    return Access{}.with(std::move(texts));
}

class ShippedScene : public GlTest, public testing::WithParamInterface<std::string> {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        document = open_document(GetParam(), caps, nullptr, nullptr, {}, small_targets());
        ASSERT_TRUE(document->runtime);
        target = gl::make_target(size, size, 1, gl::Pixels::rgba32f);
    }
    // Unclamped, as the shaders wrote it.
    std::vector<float> values() {
        const View view;
        document->runtime->draw({0.0, view, document->controls}, {target.framebuffer.get(), size, size});
        return gl::read_rgba32f(target.framebuffer.get(), size, size, 1);
    }
    static double not_finite(const std::vector<float>& all) {
        return static_cast<double>(std::ranges::count_if(all, [](float v) { return !std::isfinite(v); }));
    }
    void expect_finite(const std::string& where) { EXPECT_EQ(not_finite(values()), 0) << where; }
    std::vector<float> values(int side, int samples, const View& view, double time) {
        const gl::Target other = gl::make_target(side, side, samples, gl::Pixels::rgba32f);
        document->runtime->draw({time, view, document->controls}, {other.framebuffer.get(), side, side});
        return gl::read_rgba32f(other.framebuffer.get(), side, side, other.samples);
    }

    // What no program on the current rungs reads changes no picture.
    std::vector<std::size_t> adjustable() const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < document->controls.items.size(); ++i)
            if (const Control& c = document->controls.items[i]; c.widget != Widget::none && c.active)
                found.push_back(i);
        return found;
    }
    // Values that are not finite, over all four corners of every pair of controls, the others as the scene has them.
    // Where that is an end, pairs have corners in common: each is drawn once.
    double corners() {
        std::vector<Control>& items = document->controls.items;
        const std::vector<std::size_t> all = adjustable();
        std::set<std::vector<std::vector<double>>> drawn;
        double bad = 0;
        for (std::size_t a = 0; a < all.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                for (const unsigned corner : {0U, 1U, 2U, 3U}) {
                    const Control before[] = {items[all[a]], items[all[b]]};
                    set(items[all[a]], (corner & 1) != 0);
                    set(items[all[b]], (corner & 2) != 0);
                    std::vector<std::vector<double>> place;
                    for (const Control& control : items) place.push_back(control.value);
                    if (drawn.insert(place).second) bad += not_finite(values(16, 1, {}, 0));
                    items[all[a]] = before[0], items[all[b]] = before[1];
                }
        return bad;
    }
    // The same, all controls at their ends at once, in as few pictures as do: in picture k a control has bit k of its
    // number, which has more ones than zeros, as many as each other, and a zero in the last picture. Two such numbers
    // have each of 00, 01, 10 and 11 somewhere. Six pictures do for 10 controls.
    double ends() {
        const std::vector<std::size_t> all = adjustable();
        unsigned last = 0;
        std::vector<unsigned> numbers;
        for (; numbers.size() < all.size(); ++last) {
            numbers.clear();
            for (unsigned n = 0; n < 2U << last; ++n)
                if (std::popcount(n) == static_cast<int>(last + 1) / 2 + 1) numbers.push_back(n);
        }
        const std::vector<Control> before = document->controls.items;
        double bad = 0;
        for (unsigned picture = 0; picture <= last; ++picture) {
            for (std::size_t i = 0; i < all.size(); ++i)
                set(document->controls.items[all[i]], (numbers[i] >> picture & 1) != 0);
            bad += not_finite(values(16, 1, {}, 0));
        }
        document->controls.items = before;
        return bad;
    }

    // Anywhere in its range.
    void scatter(Control& control) {
        std::uniform_real_distribution<double> place(0, 1);
        for (double& v : control.value) {
            const double p = place(random);
            if (control.widget == Widget::slider) v = control.min + p * (control.max - control.min);
            if (control.widget == Widget::slider && control.type == ValueType::int_) v = std::round(v);
            if (control.widget == Widget::color) v = p;
            if (control.widget == Widget::check_box) v = p < 0.5;
        }
    }
    static void set(Control& control, bool high) {
        for (double& v : control.value)
            v = control.widget == Widget::slider ? (high ? control.max : control.min) : high;
    }

    // Which controls change the picture on the current rungs, of those that no rung so far has shown to.
    void find_idle() {
        for (std::size_t i = 0; i < document->controls.items.size(); ++i) {
            Control& control = document->controls.items[i];
            if (control.widget == Widget::none) continue;
            bool& matters = controls[std::to_string(control.program) + " " + control.name];
            for (int round = 0; round < 20 && !matters && control.active; ++round) {
                for (Control& other : document->controls.items) scatter(other);
                set(control, false);
                const std::vector<float> low = values();
                set(control, true);
                matters = low != values();
            }
        }
    }

    // Hard cases of the scene as it is opened.
    void look_from_hard_places() {
        const std::array<Vec3, 3> at = document->scene().cameras.back().look_at.value_or(std::array<Vec3, 3>{});
        const double distance = std::hypot(at[0][0] - at[1][0], at[0][1] - at[1][1], at[0][2] - at[1][2]);
        double bad = 0, off = 0;
        for (const double from : {0., .5, 1., 1.000001}) {  // of the ball of radius 1 that most scenes look at
            View near;
            near.eye.z = distance - from;
            bad += not_finite(values(size, 1, near, 0));
        }
        hard_case({"A47", "eyes in the middle of the ball, in it and on it, in every shipped scene",
                   "values not finite", 0, bad, std::nullopt});
        hard_case({"A51", "every shipped scene at times of 1e9 and -5 s", "values not finite", 0,
                   not_finite(values(size, 1, {}, 1e9)) + not_finite(values(size, 1, {}, -5)), std::nullopt});
        // Each sample is in the range of the light, so that the mean over the picture stays.
        const std::vector<float> one = values(size, 1, {}, 0), eight = values(size, 8, {}, 0);
        for (std::size_t i = 0; i < one.size(); ++i)
            off += static_cast<double>(eight[i] - one[i]) / static_cast<double>(one.size());
        hard_case({"A50", "eight samples a pixel in every shipped scene: the light in the picture is the same", "of 1",
                   .02, std::abs(off), std::nullopt});
    }

    // Pixels of the picture drawn in four tiles that are not those of the picture drawn at once.
    double differing_in_tiles() {
        const std::vector<float> whole = values();
        const gl::Target tile = gl::make_target(size / 2, size / 2, 1, gl::Pixels::rgba32f);
        const View view;
        double differing = 0;
        for (int bottom : {0, size / 2})
            for (int left : {0, size / 2}) {
                Surface surface{tile.framebuffer.get(), size, size};
                surface.part = {left, bottom, size / 2, size / 2};
                document->runtime->draw({0.0, view, document->controls}, surface);
                const auto part = gl::read_rgba32f(tile.framebuffer.get(), size / 2, size / 2, 1);
                for (int y = 0; y < size / 2; ++y) {
                    const int row = size - bottom - size / 2 + y;
                    for (int x = 0; x < 2 * size; ++x) {
                        const float one = whole[static_cast<std::size_t>((row * size + left) * 4 + x)];
                        differing += std::abs(one - part[static_cast<std::size_t>(y * 2 * size + x)]) > 2 / 255.F;
                    }
                }
            }
        return differing / 4;
    }

    static constexpr int size = 24;
    std::map<std::string, bool> controls;  // whether it does something
    std::unique_ptr<Document> document;
    gl::Target target;
    std::mt19937 random{1};
};

// One test of all that is drawn on the scene's own rungs: opening costs as much as drawing.
TEST_P(ShippedScene, IsCleanRepeatableAndFinite) {
    EXPECT_TRUE(document->diagnostics.items().empty()) << render(document->diagnostics, document->sources);
    const std::vector<float> first = values(), second = values();
    ASSERT_EQ(first.size(), second.size());
    EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(float)), 0) << "the same frame twice";
    for (std::size_t i = 0; i < document->controls.items.size(); ++i) {
        Control& control = document->controls.items[i];
        if (control.widget == Widget::none) continue;
        for (bool high : {false, true}) {
            set(control, high);
            expect_finite(control.name + (high ? " at its largest" : " at its smallest"));
        }
        if (control.widget == Widget::slider && control.min < 0 && control.max > 0) {
            for (double& v : control.value) v = 0;
            expect_finite(control.name + " at 0");
        }
        control.value = control.initial;
    }
    for (int round = 0; round < 50; ++round) {
        for (Control& control : document->controls.items) scatter(control);
        expect_finite("a random combination");
    }
    for (Control& control : document->controls.items) control.value = control.initial;
    hard_case({"A48", "all corners of every pair of sliders of every shipped scene", "values not finite", 0, corners(),
               std::nullopt});
    look_from_hard_places();
    hard_case({"A52", "every shipped scene drawn in tiles, but for a vertex between two points of the driver's grid",
               "pixels that differ", 2, differing_in_tiles(), std::nullopt});
}

// Each rung once, at some place of the sliders that it has. Every control matters on some rung.
TEST_P(ShippedScene, IsFiniteOnEveryRungAndHasNoIdleControl) {
    const std::vector<Ladder>& ladders = document->scene().ladders;
    const Rungs marked = document->runtime->rungs();
    find_idle();
    double bad = 0;
    for (std::size_t ladder = 0; ladder < ladders.size(); ++ladder)
        for (std::size_t rung = 0; rung < ladders[ladder].rungs.size(); ++rung) {
            if (rung == marked[ladder]) continue;
            document->controls.rungs = marked;
            document->controls.rungs[ladder] = rung;
            follow_rungs(*document);
            const std::string name = ladders[ladder].name + " " + ladders[ladder].rungs[rung];
            EXPECT_TRUE(document->runtime->ladder_problems().items().empty()) << name;
            for (Control& control : document->controls.items) scatter(control);
            expect_finite(name + ", sliders anywhere");
            bad += ends();
            EXPECT_EQ(bad, 0) << name << ", corners of sliders";
            find_idle();
        }
    hard_case({"A49", "every rung of every shipped scene with all sliders at their ends, in all corners of every pair",
               "values not finite", 0, bad, std::nullopt});
    for (const auto& [name, matters] : controls) EXPECT_TRUE(matters) << name << " does nothing";
}

class ShippedSceneEs : public ShippedScene {};

TEST_P(ShippedSceneEs, IsThatOfOpenGl) {
    const std::vector<float> core = values();
    target = {};
    document.reset();
    context.reset();
    request = {32, true, false, true};
    ShippedScene::SetUp();
    EXPECT_FALSE(document->diagnostics.has_errors()) << render(document->diagnostics, document->sources);
    const std::vector<float> es = values();
    double differing = 0;
    for (std::size_t i = 0; i < es.size(); ++i) differing += !(std::abs(es[i] - core[i]) <= 2 / 255.F);
    hard_case({"A56", "every shipped scene in OpenGL ES 3.2 is the one of OpenGL", "of the values differ", .01,
               differing / static_cast<double>(es.size()), std::nullopt});
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, testing::ValuesIn(shipped_scenes()), test_name);
INSTANTIATE_TEST_SUITE_P(Scenes, ShippedSceneEs, testing::ValuesIn(shipped_scenes()), test_name);

// ---- The scene that the slides print, as printed, with the pictures and the two-line shader that they leave out.

class PrintedScene : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        const std::string corpus = SNELL_ROOT "/../shared/corpus/bailey/";
        if (!std::filesystem::exists(corpus + "cubemap.glib")) GTEST_SKIP() << "the slides' scene is not at " << corpus;
        for (const char* name : {"refract.vert", "refract.frag"}) folder.write(name, file(corpus + name));
        for (const char* face : {"posx", "negx", "posy", "negy", "posz", "negz"})
            folder.write(std::string("nv") + face + ".bmp",
                         file(std::string(SNELL_ROOT "/scenes/environments/room/") + face + ".bmp"));
        folder.write(
            "texture.vert",
            "out vec2 vST;\n"
            "void main() { vST = gl_MultiTexCoord0.st; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
        folder.write(
            "texture.frag",
            "uniform sampler2D TexUnit; in vec2 vST;\nvoid main() { gl_FragColor = texture(TexUnit, vST); }\n");
        // The object that the shaders are for is not in the print either. Around the eye, where the print leaves us, a
        // ball would refract exactly as it reflects: straight back.
        document = open(file(corpus + "cubemap.glib") + "\nTranslate 0. 0. -3.\nSphere\n");
        expect_clean(*document);
        ASSERT_TRUE(document->runtime);
    }
    static std::string file(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    std::unique_ptr<Document> document;
};

TEST_F(PrintedScene, HasItsSliders) {
    const Index refract = static_cast<Index>(document->scene().programs.size() - 1);
    const Control* eta = document->controls.find(refract, "uEta");
    const Control* mix = document->controls.find(refract, "uMix");
    ASSERT_TRUE(eta && mix);
    EXPECT_EQ(eta->widget, Widget::slider);
    EXPECT_EQ(eta->min, 0.1);
    EXPECT_EQ(eta->value, std::vector<double>{1.1});
    EXPECT_EQ(eta->max, 5.0);
    EXPECT_EQ(mix->min, 0.0);
    EXPECT_EQ(mix->value, std::vector<double>{0.0});
    EXPECT_EQ(mix->max, 1.0);
}

TEST_F(PrintedScene, ChangesWithTheMix) {
    const Picture before = draw(*document, square(64)), after = draw(*document, square(64, {"uMix=1"}));
    EXPECT_FALSE(before == after);
}

TEST_F(PrintedScene, AMisspeltSliderIsAnErrorThatNamesTheRightOne) {
    Diagnostics problems;
    EXPECT_FALSE(set_control(document->controls, document->scene(), "uMxi=1", problems));
    ASSERT_TRUE(problems.has_errors());
    EXPECT_NE(render(problems, document->sources).find("uMix"), std::string::npos);
}

}  // namespace
}  // namespace snell::test
