// Polynomials in place of functions, as the driver computes them, against double precision.
#include <fmt/format.h>

#include "src/accuracy/found/shaders/shader.h"
#include "src/gl/program.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

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

}  // namespace
}  // namespace snell::test
