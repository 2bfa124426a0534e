// Expressions that their mean over the picture replaces: the means are those of known functions.
#include "src/accuracy/found/change.h"
#include "src/accuracy/found/search.h"
#include "tests/accuracy/gl/common.h"

namespace snell::test {
namespace {

using namespace accuracy;

class Averages : public AccuracyTest {
protected:
    // Of a square from -1 to 1 that fills the picture, wherever the eye is.
    void read_body(const std::string& body) {
        folder.write("full.vert",
                     "#version 330 compatibility\nout vec2 vP;\n"
                     "void main() { vP = gl_Vertex.xy; gl_Position = vec4(vP, 0., 1.); }\n");
        folder.write("full.frag",
                     "#version 330 compatibility\nin vec2 vP;\nuniform float uGain;\n"
                     "float wave(float x) { return sin(x) * exp(x); }\nvoid main() {\n" +
                         body + "}\n");
        bench_of_text(
            "Background 0 0 0\nVertex full.vert\nFragment full.frag\nProgram Full uGain <0. .5 1.>\nQuadXY 0 1\n", 32,
            32);
    }
    Original original() { return {folder.path("scene.glib"), read->plan, *read->files, read->sources}; }
    // "before → after" of the means.
    std::vector<std::string> means(const std::string& body) {
        read_body(body);
        changes = find_changes(read->plan, *read->files, read->sources);
        fill_averages(original(), changes, caps);
        std::vector<std::string> lines;
        for (const Change& change : changes)
            if (change.kind == ChangeKind::expression_mean && change.probes.empty()) {
                lines.push_back(change.before + " → " + change.after);
                EXPECT_EQ(change.edits.front().text, change.after);
            }
        return lines;
    }
    using Lines = std::vector<std::string>;
    std::vector<Change> changes;
};

TEST_F(Averages, AreThoseOfTheFunctions) {
    // (e - 1/e)/2, and 0 of an odd function.
    EXPECT_EQ(means("float a = exp(vP.x);\ngl_FragColor = vec4(a);\n"), Lines{"exp(vP.x) → float(1.18)"});
    EXPECT_EQ(means("vec4 a = vec4(exp(vP), 3. * exp(vP.y), .5);\ngl_FragColor = a;\n"),
              (Lines{"vec4(exp(vP), 3. * exp(vP.y), .5) → vec4(1.18, 1.18, 3.53, 0.5)", "exp(vP.y) → float(1.18)"}));
    EXPECT_EQ(means("vec3 a = mix(vec3(0.), vec3(1.), pow(abs(vP.x), 2.));\ngl_FragColor = vec4(a, 1.);\n").front(),
              "mix(vec3(0.), vec3(1.), pow(abs(vP.x), 2.)) → vec3(0.333, 0.333, 0.333)");
}

TEST_F(Averages, OfAllRoundsAndOfThePixelsThatShow) {
    // 1, e, e^2 and e^3; the value 0 of the left half counts, what is discarded does not. The middle of 75 columns is
    // at 0, so that the right half begins at -1/75.
    EXPECT_EQ(
        means("float s = 0.;\nfor (int i = 0; i < 4; ++i) s += uGain * exp(float(i));\ngl_FragColor = vec4(s);\n"),
        Lines{"exp(float(i)) → float(7.8)"});
    EXPECT_EQ(means("float a = step(0., vP.x) * exp(vP.x);\ngl_FragColor = vec4(a);\n").front(),
              "step(0., vP.x) * exp(vP.x) → float(0.866)");
    EXPECT_EQ(means("if (vP.x < 0.) discard;\nfloat a = exp(vP.x);\ngl_FragColor = vec4(a);\n").front(),
              "exp(vP.x) → float(1.71)");
}

TEST_F(Averages, WhatShowsNowhereHasNone) {
    EXPECT_EQ(means("float a = .5;\nif (uGain > 2.) { float b = exp(vP.x); a = b; }\ngl_FragColor = vec4(a);\n"),
              Lines{});
    std::string error;
    const auto number = static_cast<std::size_t>(
        std::find_if(changes.begin(), changes.end(), [](const Change& c) { return !c.probes.empty(); }) -
        changes.begin());
    ASSERT_LT(number, changes.size());
    SearchOptions options;
    options.times = false;
    Search found(original(), changes, caps, BenchSettings{32, 32, 0, {}}, options);
    while (found.step()) continue;
    EXPECT_EQ(found.result().rungs[number].outcome, Outcome::refused);
    EXPECT_NE(found.result().rungs[number].reason.find("the mean of 'exp(vP.x)' is not known"), std::string::npos)
        << found.result().rungs[number].reason;
}

TEST_F(Averages, AChangeThatIsGivenTwiceIsDrawnOnce) {
    read_body("float a = exp(vP.x), b = cos(vP.y);\ngl_FragColor = vec4(a * b);\n");
    changes = find_changes(read->plan, *read->files, read->sources);
    std::vector<Change*> given;
    for (Change& change : changes)
        if (change.kind == ChangeKind::expression_mean) given.insert(given.end(), 2, &change);
    ASSERT_EQ(given.size(), 4U);
    fill_averages(original(), given, caps);
    EXPECT_EQ(given.front()->after, "float(1.18)");
    EXPECT_EQ(given.back()->after, "float(0.841)") << "sin 1";
}

TEST_F(Averages, WhatCannotBeDrawnSaysWhy) {
    const std::string main = "float a = exp(vP.x);\ngl_FragColor = vec4(a);\n}\n";
    EXPECT_EQ(means(main + "float snellSum = 1.;\nvoid unused() {\n"), Lines{}) << "the probe has that name, too";
    complaints.clear();  // of that
    const auto unknown =
        std::find_if(changes.begin(), changes.end(), [](const Change& c) { return !c.probes.empty(); });
    ASSERT_NE(unknown, changes.end());
    std::string error;
    EXPECT_FALSE(choose_changes(std::to_string(unknown - changes.begin() + 1), changes, read->sources, error));
    EXPECT_NE(error.find("the mean of 'exp(vP.x)' is not known: it could not be drawn: line "), std::string::npos)
        << error;
}

TEST_F(Averages, OnlyWhatCostsAndDoesNothingElse) {
    EXPECT_EQ(means("float a = vP.x * 2.;\nfloat b = -vP.y;\ngl_FragColor = vec4(a + b);\n"), Lines{});
    EXPECT_EQ(means("float n = 0.;\nfloat a = exp(n += vP.x);\ngl_FragColor = vec4(a * n);\n"), Lines{}) << "it stores";
    EXPECT_EQ(means("float a = wave(vP.x);\ngl_FragColor = vec4(a);\n").back(), "wave(vP.x) → float(0.332)");
    std::string many = "float s = 0.;\n";
    for (int i = 0; i < 12; ++i) many += "s += uGain * exp(vP.x * " + std::to_string(i) + ".);\n";
    EXPECT_EQ(means(many + "gl_FragColor = vec4(s);\n").size(), 8U);
}

// The error of a constant mean is the standard deviation, here of encoded light that is linear in the place.
TEST_F(Averages, AreTriedLikeOtherChanges) {
    read_body(
        "float a = pow(.5 + .4 * vP.x, 1.);\ngl_FragColor = vec4(vec3(a <= .0031308 ? 12.92 * a : 1.055 * pow(a, 1. / "
        "2.4) - .055), 1.);\n");
    SearchOptions options;
    options.times = false;
    const FoundResult found = search(original(), caps, BenchSettings{32, 32, 0, {}}, options);
    const auto rung = std::find_if(found.rungs.begin(), found.rungs.end(), [&](const FoundRung& r) {
        const Change& change = found.changes[r.changes[0]];
        return change.kind == ChangeKind::expression_mean && change.before.starts_with("pow(.5");
    });
    ASSERT_NE(rung, found.rungs.end());
    ASSERT_EQ(rung->outcome, Outcome::tried) << rung->reason;
    EXPECT_NEAR(rung->worst()->own.light.rmse, .4 / std::sqrt(3.), 1e-3);
}

}  // namespace
}  // namespace snell::test
