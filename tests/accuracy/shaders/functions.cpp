// Polynomials against double precision, and where they are put.
#include <bit>
#include <cmath>

#include "src/accuracy/found/shaders/shader.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/preprocess.h"
#include "src/glsl/run/machine.h"
#include "tests/accuracy/shaders/help.h"

namespace snell::accuracy::test {
namespace {

using enum ChangeKind;
using Lines = std::vector<std::string>;

// Runs the text of a function, named f, in double precision.
class Function {
public:
    explicit Function(const std::string& text, int parameters) {
        const std::string main =
            parameters == 1 ? "void main() { result = f(x); }\n" : "void main() { result = f(x, y); }\n";
        const FileId file = sources_.add("f", "uniform float x, y;\nout float result;\n" + text + main);
        glsl::Options options;
        glsl::preprocess(unit_, file, sources_, options, said_);
        glsl::Parser(unit_, options.target, said_).run();
    }
    double operator()(double x, double y = 0) {
        glsl::run::Machine machine(unit_);
        set(machine, "x", x);
        set(machine, "y", y);
        std::uint64_t alive = 1;
        int budget = 10'000;
        EXPECT_EQ(machine.run(1, -1, alive, budget), glsl::run::Machine::End::done);
        return machine.variable(variable("result")).get(0, 0);
    }

private:
    int variable(std::string_view name) const {
        for (const glsl::Global& g : unit_.globals)
            if (g.name == name) return g.variable;
        return -1;
    }
    void set(glsl::run::Machine& machine, std::string_view name, double value) {
        machine.set(variable(name), 1, [&](int, int) { return value; });
        machine.variable(variable(name)).given = true;
    }
    Sources sources_;
    Diagnostics said_;
    glsl::Unit unit_;
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

TEST(FoundPolynomials, ErrorsAreBelowTheirBoundsAndNotFarBelow) {
    for (const Polynomial& p : polynomials()) {
        if (p.function == "half") continue;
        const bool two = p.function == "atan2";
        Function f(polynomial_text(p.function, "f", "float"), two ? 2 : 1);
        double worst = 0;
        for (int i = 0; i <= 4000; ++i) {
            // Denser near 0, where arguments are.
            const double t = i / 4000.;
            const double x = p.function == "exp" ? -1000 * t * t * t : p.to * std::pow(2 * t - 1, 3);
            for (const double y : two ? std::vector<double>{-3, -1, -.01, .2, 1, 7} : std::vector<double>{0})
                worst = std::max(worst, std::abs(f(x, y) - exact(p.function, x, y)));
        }
        EXPECT_LT(worst, p.bound) << p.function;
        EXPECT_GT(worst, p.bound / 3) << p.function << ": a bound that is far too large says nothing";
    }
}

TEST(FoundPolynomials, PowersWithConstantExponents) {
    for (const double exponent :
         {.1, .25, .4545, .5, .7, 1.2, 1.5, 1.55, 2., 2.2, 2.4, 3., 3.5, 5., 10., 64., 100., 256.}) {
        const Power power = power_text(exponent, "f", "float");
        if (power.text.empty()) {
            EXPECT_EQ(exponent, .1) << "too steep at 0";
            continue;
        }
        Function f(power.text, 1);
        double worst = 0;
        for (int i = 0; i <= 2000; ++i) {
            const double x = std::pow(i / 2000., 3);
            worst = std::max(worst, std::abs(f(x) - std::pow(x, exponent)));
        }
        EXPECT_LE(worst, power.bound == 0 ? 1e-13 : power.bound) << exponent << "\n" << power.text;
        EXPECT_LT(power.bound, .012) << exponent;
    }
    for (const double none : {0., 1., -2., 257., 4.5, 1e30}) EXPECT_EQ(power_text(none, "f", "float").text, "") << none;
}

TEST(FoundPolynomials, PowersWithAnyExponentFromEight) {
    const Power power = power_text(std::nullopt, "f", "float");
    Function f(power.text, 2);
    double worst = 0;
    for (const double y : {8., 9.5, 16., 20., 50., 128., 1000.})
        for (int i = 0; i <= 1000; ++i) {
            const double x = 1 - std::pow(i / 1000., 3);
            worst = std::max(worst, std::abs(f(x, y) - std::pow(x, y)));
        }
    EXPECT_LT(worst, power.bound);
    EXPECT_GT(worst, power.bound / 2);
}

// ---- where they are put -------------------------------------------------------------------------------------

std::string shader(const std::string& statement) {
    return "// A comment stays.\n#version 120\n#extension GL_EXT_gpu_shader4 : enable\nvarying vec3 vN;\nuniform float "
           "uShine;\n\nvoid main()\n{\n    " +
           statement + "\n}\n";
}

TEST_F(FoundShaders, AFunctionIsAddedAheadOfTheOneThatCallsIt) {
    Found& found = shaders(shader("gl_FragColor = vec4(pow(max(vN.x, 0.), 5.));"));
    EXPECT_EQ(found.lines(polynomial).size(), 1U);
    const Change* change = found.find(polynomial, "pow(max(vN.x, 0.), 5.)");
    ASSERT_NE(change, nullptr);
    const std::string text = found.changed(*change, "a.frag");
    const std::size_t at = shader("").find("void main");
    const std::string name = "foundPow_" + std::to_string(shader("gl_FragColor = vec4(").find("vec4(") + 5);
    EXPECT_EQ(text.substr(at, text.find("void main") - at),
              "// pow(x, 5) by multiplications: exact\nfloat " + name +
                  "(float x) { float x2 = x * x; float x4 = x2 * x2; return x * x4; }\n");
    EXPECT_NE(text.find("vec4(" + name + "(max(vN.x, 0.)));"), std::string::npos) << text;
    EXPECT_EQ(translation_errors(found, {change}), "");
}

TEST_F(FoundShaders, AllCallsOfAFunctionAreOneChangeToo) {
    Found& found = shaders(shader("gl_FragColor = vec4(sin(vN) * cos(vN.x), pow(vN.y, uShine));"));
    const std::vector<const Change*> all = found.of(polynomial);
    ASSERT_EQ(all.size(), 4U) << "three calls, and all of them";
    std::size_t most = 0;
    for (const Change* change : all) {
        most = std::max(most, change->edits.size());
        EXPECT_EQ(translation_errors(found, {change}), "");
    }
    EXPECT_EQ(most, 4U) << "one place ahead of main, three calls";
}

TEST_F(FoundShaders, CallsWithoutAPolynomialStay) {
    EXPECT_EQ(shaders(shader("gl_FragColor = vec4(tan(vN), sqrt(vN.x) + sin(.5));")).lines(polynomial), Lines{});
}

// ---- the vertex shader --------------------------------------------------------------------------------------

TEST_F(FoundShaders, WorkOnVaryingsMovesToTheVertexShader) {
    Found& found = shaders(
        "varying vec3 vN, vP;\nuniform vec3 uLight;\nvoid main() {\n    vec3 L = normalize(uLight - vP);\n"
        "    gl_FragColor = vec4(max(dot(vN, L), 0.));\n}\n");
    ASSERT_EQ(found.of(per_vertex).size(), 3U) << "two expressions, and both together";
    const Change* change = nullptr;
    for (const Change* each : found.of(per_vertex))
        if (each->before == "vec4(max(dot(vN, L), 0.))") change = each;
    ASSERT_NE(change, nullptr);
    EXPECT_TRUE(found.changed(*change, "a.vert").starts_with("varying vec3 vN, vP;\nvarying vec2 vST;\nvarying "));
    const std::string vert = found.changed(*change, "a.vert"), name = change->after;
    EXPECT_TRUE(name.starts_with("vFound_"));
    EXPECT_NE(vert.find("varying vec4 " + name + ";\n"), std::string::npos) << vert;
    EXPECT_NE(vert.find("= vec4(max(dot(vN, normalize(uLight - vP)), 0.));\n}"), std::string::npos) << vert;
    EXPECT_NE(vert.find("uniform vec3 uLight;\nvoid main"), std::string::npos) << vert;
    for (const Change* each : found.of(per_vertex)) EXPECT_EQ(translation_errors(found, {each}), "");
}

TEST_F(FoundShaders, WorkOnUniformsMovesToo) {
    Found& found =
        shaders("varying vec3 vN;\nuniform float uA;\nvoid main() { gl_FragColor = vec4(sin(uA) * vN, 1.); }\n");
    EXPECT_EQ(found.of(per_vertex).size() + found.of(per_frame).size(), 1U);
    const Found& alone = shaders(
        "varying vec3 vN;\nuniform float uA;\nvoid main() { vec3 c = vN; c *= sin(uA); gl_FragColor = vec4(c, 1.); "
        "}\n");
    ASSERT_EQ(alone.of(per_frame).size(), 1U);
    EXPECT_EQ(translation_errors(alone, alone.of(per_frame)), "");
}

TEST_F(FoundShaders, WorkStaysWhereItCannotMove) {
    const auto moved = [&](const std::string& fragment, const std::string& state = "") {
        const Found& found = shaders(fragment, "", state);
        return found.of(per_vertex).size() + found.of(per_frame).size();
    };
    const std::string work = "gl_FragColor = vec4(normalize(vN), 1.); }\n";
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { " + work), 1U);
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { " + work, "Vertex a.vert\nFragment a.frag\nProgram B\nSphere 1."),
              0U)
        << "another program has the vertex shader, too";
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { gl_FragColor = vec4(dFdx(normalize(vN)).x) + gl_FragCoord; }\n"),
              1U)
        << "only what is within the derivative";
    EXPECT_EQ(moved("varying vec3 vM;\nvoid main() { gl_FragColor = vec4(normalize(vM), 1.); }\n"), 0U)
        << "nothing writes it";
    EXPECT_EQ(
        moved("varying vec3 vN;\nvoid main() { vec3 n = vN; n.x = 2.; gl_FragColor = vec4(normalize(n), 1.); }\n"), 0U)
        << "the variable changes";
}

}  // namespace
}  // namespace snell::accuracy::test
