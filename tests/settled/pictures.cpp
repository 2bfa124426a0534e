// Every scene, with programs for its values and with programs for any: the same pictures, messages and controls.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "tests/settled/settled.h"

namespace snell::test {
namespace {

class SettledPictures : public SettledTest {
protected:
    static std::vector<std::string> scenes(std::initializer_list<const char*> roots) {
        std::vector<std::string> found;
        for (const char* root : roots)
            for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
                if (entry.path().extension() == ".glib") found.push_back(entry.path().string());
        std::ranges::sort(found);
        return found;
    }
    static std::string said(const Document& document) { return render(document.diagnostics, document.sources); }
    // Each slider at its minimum, its maximum or between, as the seed says.
    static std::vector<std::string> moved(const Document& document, std::mt19937& random) {
        std::vector<std::string> sets;
        for (const Control& control : document.controls.items) {
            if (control.widget != Widget::slider) continue;
            const double where[]{0, 1, static_cast<double>(random() % 1000) / 1000};
            double value = control.min + where[random() % 3] * (control.max - control.min);
            if (control.type == ValueType::int_ || control.type == ValueType::uint_) value = std::floor(value);
            sets.push_back(document.scene().programs[control.program].name + "." + control.name + "=" +
                           std::to_string(value));
        }
        return sets;
    }
};

const Look small{.width = 40, .height = 40, .time = 1.25};

TEST_F(SettledPictures, AreThoseOfUniforms) {
    std::size_t specialised = 0;
    for (const std::string& path : scenes({"scenes", "tests/cases", "tests/odd", "tests/bad"})) {
        auto general = open_file(path), settled = open_settled(path);
        EXPECT_EQ(said(*settled), said(*general)) << path;
        if (!general->runtime) continue;
        EXPECT_TRUE(same_uniforms(settled->controls, general->controls)) << path;
        EXPECT_LE(difference(draw(*settled, small), draw(*general, small)), 1) << path;
        specialised += settled->runtime->counters().specialised_draws > 0;
    }
    EXPECT_GT(specialised, 25U);
}

TEST_F(SettledPictures, AreThoseOfUniformsAtOtherValues) {
    for (const std::string& path : scenes({"scenes"})) {
        auto general = open_file(path);
        std::mt19937 random(11);
        Look look = small;
        look.sets = moved(*general, random);
        auto settled = open_settled(path, look.sets);
        EXPECT_LE(difference(draw(*settled, look), draw(*general, look)), 1) << path;
    }
}

}  // namespace
}  // namespace snell::test
