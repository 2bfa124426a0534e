// Every scene, with programs for its values and with programs for any: the same pictures, messages and controls.
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

const Look small{.width = 24, .height = 24, .time = 1.25};

TEST_F(SettledPictures, AreThoseOfUniforms) {
    std::size_t specialised = 0;
    for (const std::string& path : scenes({"scenes", "tests/cases", "tests/odd", "tests/bad"})) {
        auto general = open_file(path);
        RuntimeOptions options = settled_for();
        // Textures and meshes of large scenes are made once; those at other values, below, make their own.
        if (path.starts_with("scenes/")) options.previous = &*general->runtime;
        auto settled = open_document(path, caps, nullptr, nullptr, options);
        EXPECT_EQ(said(*settled), said(*general)) << path;
        if (!general->runtime) continue;
        EXPECT_TRUE(same_uniforms(settled->controls, general->controls)) << path;
        EXPECT_LE(difference(draw(*settled, small), draw(*general, small)), 1) << path;
        specialised += settled->runtime->counters().specialised_draws > 0;
    }
    EXPECT_GT(specialised, 15U);
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

// Pictures of the size that people look at, as architecture.md promises: a channel differs by at most one level of 255.
TEST_F(SettledPictures, OfNoiseAndVarnishDifferByOneLevelAtMost) {
    const std::string noise = "docs/teaching/02-noise/submissions/passing/noise.glib";
    const std::string varnish = "scenes/light/varnish/varnish.glib";
    const std::tuple<std::string, std::vector<std::string>, unsigned> rows[]{
        {noise, {}, 0}, {noise, {"uNoiseAmp=0"}, 1}, {varnish, {}, 1}, {varnish, {"uView=1", "uMixRatio=0"}, 1}};
    for (const auto& [path, sets, decided] : rows) {
        const Look large{.width = 400, .height = 400, .sets = sets};
        auto general = open_file(path), settled = open_settled(path, sets);
        const Picture any = draw(*general, large), values = draw(*settled, large);
        EXPECT_EQ(settled->runtime->counters().specialised_draws, decided) << path;
        EXPECT_EQ(general->runtime->counters().specialised_draws, 0U) << path;
        EXPECT_LE(difference(values, any), 1) << path;
    }
}

// Where rounding shows: hashes, indices, and what numbers of the text and constants leave undefined together.
TEST_F(SettledPictures, AreThoseOfUniformsWhereRoundingShows) {
    const std::pair<const char*, const char*> cases[]{
        {"hash(vST * uX)", "331.3"},
        {"fract(sin(dot(vST * uX, vec2(12.9898, 78.233))) * 43758.5453)", "3.3"},
        {"fract(uX * vST.x * 4096. * vST.y)", "3.7"},
        {"fract(uX * vST.x * 100. * 437.585453)", "1.7"},
        {"fract((fract(vST.x * uX * .1031) + 33.33) * vST.y * 77.)", "331.3"},
        {"uX * vST.x * 437.585453 * 100. - float(int(uX * vST.x * 437.585453 * 100.))", "1.7"},
        {"sin(43758.5 * sin(uX * vST.x * 1.3))", "3.3"},
        {"vST.x * 1.3 * uX != uX * vST.x * 1.3 ? 1. : 0.", "3.3"},
        {"mod(vST.x * uX, 0.)", "7."},
        {"mod(uX, 0.)", "7."},
        {"float(-7 % uN) * .1 + .5", "3."},
        {"float(-7 % uN) * .1 + .5", "-3."},
        {"float(7 % uN) * .1 + .5", "0."},
        {"vec3(.1, .2, .3)[uN]", "5."},
        {"float[3](.1, .2, .3)[uN]", "3."},
    };
    for (const auto& [expression, value] : cases) {
        folder.write("one.frag",
                     "#version 330 compatibility\nuniform float uX;\nuniform int uN;\nin vec2 vST;\n"
                     "float hash(vec2 q) { vec3 p = fract(q.xyx * .1031); p += dot(p, p.yzx + 33.33);\n"
                     "return fract((p.x + p.y) * p.z); }\n"
                     "void main() { gl_FragColor = vec4(vec3(" +
                         std::string(expression) + "), 1.); }\n");
        folder.write("scene.glib", "Ortho -1 1 -1 1\nVertex plain.vert\nFragment one.frag\nProgram P uX " +
                                       std::string(value) + " uN " + std::string(value) + "\nQuadXY\n");
        auto general = open_file(folder.path("scene.glib")), settled = open_settled(folder.path("scene.glib"));
        EXPECT_LE(difference(draw(*settled), draw(*general)), 1) << expression;
    }
}

}  // namespace
}  // namespace snell::test
