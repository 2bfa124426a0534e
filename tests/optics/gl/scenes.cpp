// Every shipped scene: clean, the same at every draw, finite wherever its sliders are, and with no idle control.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "tests/harness/harness.h"

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

class ShippedScene : public GlTest, public testing::WithParamInterface<std::string> {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        document = open_file(GetParam());
        ASSERT_TRUE(document->runtime);
        target = gl::make_target(size, size, 1, gl::Pixels::rgba32f);
    }
    // Unclamped, as the shaders wrote it.
    std::vector<float> values() {
        const View view;
        document->runtime->draw({0.0, view, document->controls}, {target.framebuffer.get(), size, size});
        return gl::read_rgba32f(target.framebuffer.get(), size, size, 1);
    }
    void expect_finite(const std::string& where) {
        const std::vector<float> all = values();
        const auto bad = std::count_if(all.begin(), all.end(), [](float v) { return !std::isfinite(v); });
        EXPECT_EQ(bad, 0) << where;
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

    static constexpr int size = 32;
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
}

// Each rung once, at some place of the sliders that it has. Every control matters on some rung.
TEST_P(ShippedScene, IsFiniteOnEveryRungAndHasNoIdleControl) {
    const std::vector<Ladder>& ladders = document->scene().ladders;
    const Rungs marked = document->runtime->rungs();
    find_idle();
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
            find_idle();
        }
    for (const auto& [name, matters] : controls) EXPECT_TRUE(matters) << name << " does nothing";
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, testing::ValuesIn(shipped_scenes()), test_name);

}  // namespace
}  // namespace snell::test
