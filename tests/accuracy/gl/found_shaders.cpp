// Changes of shaders, drawn: the driver takes them, and the pictures change as much as the changes say.
#include <fmt/format.h>

#include "src/accuracy/found/change.h"
#include "src/accuracy/found/search.h"
#include "src/accuracy/found/shaders/shader.h"
#include "src/gl/program.h"
#include "tests/accuracy/gl/common.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

using accuracy::Change;
using accuracy::ChangeKind;

class FoundShadersGl : public GlTest {
protected:
    // Opens the scene and finds its changes.
    std::unique_ptr<Document> find(const std::string& path) {
        changes.clear();
        return open_document(path, caps, nullptr, [&](const Plan& plan, Document& document) {
            accuracy::add_shader_changes({plan, *document.files, document.sources}, changes);
        });
    }
    // Opens it again with changes.
    std::unique_ptr<Document> changed(const Document& document, const std::vector<const Change*>& made) {
        Access access;
        access.instead =
            std::make_shared<const std::map<std::string, std::string>>(accuracy::changed_texts(made, document.sources));
        return open_document(document.path, caps, nullptr, nullptr, {}, access);
    }
    std::string scene(const std::string& vertex, const std::string& fragment, const std::string& values = "") {
        folder.write("a.vert", vertex);
        folder.write("a.frag", fragment);
        return folder.write(
            "a.glib", "Ortho -1. 1. -1. 1.\nVertex a.vert\nFragment a.frag\nProgram A " + values + "\nQuadXY 0. 1.\n");
    }
    // The largest difference of a channel that a change of the kind makes; -1: there is none.
    int difference(const std::string& path, ChangeKind kind, const std::string& before) {
        const auto document = find(path);
        expect_clean(*document);
        const auto change = std::find_if(changes.begin(), changes.end(), [&](const Change& c) {
            return c.kind == kind && c.before.find(before) != std::string::npos;
        });
        if (change == changes.end()) return -1;
        const auto with = changed(*document, {&*change});
        expect_clean(*with);
        const Picture a = draw(*document), b = draw(*with);
        int most = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i)
            most = std::max(most, std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i])));
        return most;
    }
    std::vector<Change> changes;
};

const std::string vertex =
    "varying vec3 vP;\nvarying vec2 vST;\nvoid main() {\n    vP = gl_Vertex.xyz;\n    vST = gl_MultiTexCoord0.st;\n"
    "    gl_Position = ftransform();\n}\n";

TEST_F(FoundShadersGl, LinearWorkMovesToTheVertexShaderWithoutChange) {
    const std::string path =
        scene(vertex,
              "varying vec3 vP;\nuniform mat3 uM;\nuniform float uA;\nvoid main() {\n"
              "    vec3 c = .5 + uA * (.3 * vP + .2 * vP.zxy * uA);\n    gl_FragColor = vec4(c, 1.);\n}\n",
              "uA <0. 1. 2.>");
    EXPECT_EQ(difference(path, ChangeKind::per_vertex, "vP.zxy"), 0);
}

TEST_F(FoundShadersGl, CurvedWorkChangesBetweenTheVertices) {
    EXPECT_GT(
        difference(scene(vertex, "varying vec3 vP;\nvoid main() { gl_FragColor = vec4(vec3(length(vP)), 1.); }\n"),
                   ChangeKind::per_vertex, "length"),
        50);
}

TEST_F(FoundShadersGl, WorkOnUniformsIsTheSameAtEveryVertex) {
    EXPECT_EQ(difference(scene(vertex,
                               "varying vec3 vP;\nuniform float uA;\nvoid main() { vec3 c = vP; c *= sin(uA); "
                               "gl_FragColor = vec4(abs(c), 1.); }\n",
                               "uA <0. 1. 2.>"),
                         ChangeKind::per_frame, "sin(uA)"),
              0);
}

TEST_F(FoundShadersGl, PolynomialsAreAsExactAsTheySay) {
    for (const std::string call : {"sin(9. * vP.x)", "cos(9. * vP)", "exp(-vP.x - 1.)", "acos(vP.y) / 3.2",
                                   "asin(vP) * .5", "atan(3. * vP.x) * .5", "atan(vP.y, vP.x) / 3.2", "pow(vST.x, 2.2)",
                                   "pow(abs(vP), vec3(.4545))", "pow(vST.x, uShine)", "pow(vST, vec2(7.))"}) {
        const std::string shader =
            "varying vec3 vP;\nvarying vec2 vST;\nuniform float uShine;\nvoid main() { gl_FragColor = "
            "vec4(vec3(length(" +
            call + ")), 1.); }\n";
        const int most =
            difference(scene(vertex, shader, "uShine 20."), ChangeKind::polynomial, call.substr(0, call.find(')')));
        EXPECT_GE(most, 0) << call;
        EXPECT_LE(most, call.find("uShine") == std::string::npos ? 1 : 6) << call;
    }
}

TEST_F(FoundShadersGl, AMeanOfFewerSamplesOfOneValueIsTheSame) {
    const std::string path =
        scene(vertex,
              "varying vec3 vP;\nvoid main() {\n    vec3 c = vec3(0.);\n    for (int i = 0; i < 16; ++i)\n"
              "        c += abs(vP);\n    gl_FragColor = vec4(c / 16., 1.);\n}\n");
    EXPECT_EQ(difference(path, ChangeKind::fewer_rounds, "i < 16"), 0);
}

// All changes of some scenes compile, in sets that can be made together.
TEST_F(FoundShadersGl, TheDriverTakesWhatIsOffered) {
    for (const std::string name : {"light/globe/globe", "light/glass/glass", "light/spectrum/spectrum",
                                   "light/crystal/crystal", "refraction-room/refraction-room"}) {
        const auto document = find(SNELL_ROOT "/scenes/" + name + ".glib");
        std::vector<std::vector<const Change*>> sets;
        for (const Change& change : changes) {
            const auto fits = [&](const std::vector<const Change*>& set) {
                return std::all_of(set.begin(), set.end(), [&](const Change* c) { return compatible(*c, change); });
            };
            const auto set = std::find_if(sets.begin(), sets.end(), fits);
            (set == sets.end() ? sets.emplace_back() : *set).push_back(&change);
        }
        EXPECT_GE(changes.size(), 10U) << name;
        for (const auto& set : sets) expect_clean(*changed(*document, set));
    }
}

// ---- Polynomials in place of functions, as the driver computes them, against double precision.

using accuracy::polynomial_text;
using accuracy::Power;
using accuracy::power_text;

constexpr float rounding = 2e-5F;  // of the floats that a polynomial adds and multiplies

// The function f of one or two floats, with what it is given.
struct Evaluated {
    float x = 0, y = 0, result = 0;
};

class FoundPolynomials : public GlTest {
protected:
    // For x as GLSL makes it of t, which goes from 0 to 1 in 4000 steps, and for each y.
    std::vector<Evaluated> evaluate(std::string_view function, bool two, const std::string& x,
                                    const std::vector<float>& ys) {
        constexpr int width = 4001;
        const auto height = static_cast<int>(ys.size());
        const gl::Compiled vertex = gl::compile(GL_VERTEX_SHADER,
                                                "#version 330 core\nvoid main() { gl_Position = vec4(gl_VertexID == 1 "
                                                "? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.); }\n");
        const gl::Compiled fragment =
            gl::compile(GL_FRAGMENT_SHADER, fmt::format("#version 330 core\nuniform float ys[{}];\nout vec4 result;\n{}"
                                                        "void main() {{ float t = (gl_FragCoord.x - .5) / 4000.;\n"
                                                        "float x = {}, y = ys[int(gl_FragCoord.y)];\n"
                                                        "result = vec4(x, y, f({}), 0.); }}\n",
                                                        height, function, x, two ? "x, y" : "x"));
        EXPECT_TRUE(fragment.shader) << fragment.log << function;
        const gl::Linked linked = gl::link({&vertex.shader, &fragment.shader}, {});
        EXPECT_TRUE(linked.program) << linked.log;
        const gl::Target target = gl::make_target(width, height, 1, gl::Pixels::rgba32f);
        const gl::VertexArray vertices(gl::make(glGenVertexArrays));
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
        glViewport(0, 0, width, height);
        glUseProgram(linked.program.get());
        glUniform1fv(glGetUniformLocation(linked.program.get(), "ys"), height, ys.data());
        glBindVertexArray(vertices.get());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        const std::vector<float> pixels = gl::read_rgba32f(target.framebuffer.get(), width, height, 1);
        std::vector<Evaluated> all;
        for (std::size_t i = 0; i < pixels.size(); i += 4) all.push_back({pixels[i], pixels[i + 1], pixels[i + 2]});
        return all;
    }
    // The largest error; NaN counts as infinite.
    template <class Exact>
    static double worst(const std::vector<Evaluated>& all, const Exact& exact) {
        double most = 0;
        for (const Evaluated& one : all) {
            const double error = std::abs(one.result - exact(one.x, one.y));
            most = std::max(most, std::isnan(error) ? std::numeric_limits<double>::infinity() : error);
        }
        return most;
    }
};

double exact(std::string_view function, double x, double y) {
    if (function == "sin") return std::sin(x);
    if (function == "cos") return std::cos(x);
    if (function == "exp") return std::exp(x);
    if (function == "acos") return std::acos(x);
    if (function == "asin") return std::asin(x);
    if (function == "atan") return std::atan(x);
    return std::atan2(x, y);
}

TEST_F(FoundPolynomials, ErrorsAreBelowTheirBoundsAndNotFarBelow) {
    for (const accuracy::Polynomial& p : accuracy::polynomials()) {
        if (p.function == "half") continue;
        const bool two = p.function == "atan2";
        // Denser near 0, where arguments are.
        const std::string x = p.function == "exp"
                                  ? "-1000. * t * t * t"
                                  : fmt::format("{:#} * pow(abs(2. * t - 1.), 3.) * sign(t - .5)", p.to);
        const std::vector<float> ys = two ? std::vector<float>{-3, -1, -.01F, .2F, 1, 7} : std::vector<float>{0};
        const double error =
            worst(evaluate(polynomial_text(p.function, "f", "float"), two, x, ys),
                  [&](double at, double y) { return exact(p.function, std::clamp(at, p.from, p.to), y); });
        EXPECT_LT(error, p.bound) << p.function;
        EXPECT_GT(error, p.bound / 3) << p.function << ": a bound that is far too large says nothing";
    }
}

TEST_F(FoundPolynomials, PowersWithConstantExponents) {
    for (const double exponent :
         {.1, .25, .4545, .5, .7, 1.2, 1.5, 1.55, 2., 2.2, 2.4, 3., 3.5, 5., 10., 64., 100., 256.}) {
        const Power power = power_text(exponent, "f", "float");
        if (power.text.empty()) {
            EXPECT_EQ(exponent, .1) << "too steep at 0";
            continue;
        }
        const double error = worst(evaluate(power.text, false, "t * t * t", {0}),
                                   [&](double x, double) { return std::pow(x, exponent); });
        EXPECT_LE(error, power.bound + rounding) << exponent << "\n" << power.text;
        EXPECT_LT(power.bound, .012) << exponent;
    }
    for (const double none : {0., 1., -2., 257., 4.5, 1e30}) EXPECT_EQ(power_text(none, "f", "float").text, "") << none;
}

TEST_F(FoundPolynomials, PowersWithAnyExponentFromEight) {
    const Power power = power_text(std::nullopt, "f", "float");
    const double error = worst(evaluate(power.text, true, "1. - t * t * t", {8, 9.5F, 16, 20, 50, 128, 1000}),
                               [](double x, double y) { return std::pow(x, y); });
    EXPECT_LT(error, power.bound);
    EXPECT_GT(error, power.bound / 2);
}

// ---- Expressions that their mean over the picture replaces: the means are those of known functions.

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
