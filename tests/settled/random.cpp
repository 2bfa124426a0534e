// Random programs: those for the values of their uniforms give what those for any values give, NaN and discarded pixels
// included. SNELL_RANDOM_EXPRESSIONS says how many expressions, SNELL_RANDOM_SEED which, SNELL_RANDOM_FIRST=845 from
// which program on, SNELL_RANDOM_ES=31 on which version of OpenGL ES.
#include <fmt/format.h>

#include "tests/hard_case.h"
#include "tests/settled/settled.h"
#include "tests/settled/writer.h"

namespace snell::test {
namespace {

using namespace random_shader;

constexpr int of_one_program = 10;

int number_of(const char* variable, int otherwise) {
    const char* text = std::getenv(variable);
    return text ? std::atoi(text) : otherwise;
}

struct Values {
    std::vector<double> f, v;
    std::vector<int> i, b;
};

// 0, 1, -1, ends of ranges, and equal pairs.
Values some_values(std::mt19937& random) {
    const double of[] = {0, 0, 0, 1, 1, -1, 2, .5, 10, 100, -5, 1e-3, 3.7};
    Values values;
    for (int n = 0; n < floats; ++n)
        values.f.push_back(n > 0 && random() % 4 == 0 ? values.f[random() % values.f.size()] : of[random() % 13]);
    for (int n = 0; n < 6; ++n)
        values.v.push_back(n > 2 && random() % 2 == 0 ? values.v[static_cast<std::size_t>(n - 3)] : of[random() % 13]);
    for (int n = 0; n < ints; ++n) values.i.push_back(static_cast<int>(random() % 5) - (random() % 8 == 0 ? 1 : 0));
    for (int n = 0; n < bools; ++n) values.b.push_back(static_cast<int>(random() % 2));
    return values;
}

std::string set(const Values& values) {
    std::string text;
    for (int n = 0; n < floats; ++n) text += fmt::format(" uF{} {}", n, values.f[static_cast<std::size_t>(n)]);
    for (int n = 0; n < ints; ++n) text += fmt::format(" uI{} {}", n, values.i[static_cast<std::size_t>(n)]);
    for (int n = 0; n < bools; ++n) text += fmt::format(" uB{} {}", n, values.b[static_cast<std::size_t>(n)]);
    const auto& v = values.v;
    return text + fmt::format(" uV [{} {} {}] uW [{} {} {}]", v[0], v[1], v[2], v[3], v[4], v[5]);
}

// Finite, infinite with its sign, or NaN; a discarded pixel has the background's alpha.
bool alike(float a, float b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    if (std::isinf(a) || std::isinf(b)) return a == b;
    return std::abs(std::clamp(a, 0.F, 1.F) - std::clamp(b, 0.F, 1.F)) <= 1.F / 255;
}

// Expressions of which a pixel differs.
std::vector<std::size_t> unlike(const std::vector<float>& a, const std::vector<float>& b) {
    std::vector<std::size_t> found;
    for (std::size_t n = 0; n < of_one_program; ++n)
        for (std::size_t i = n * 4; i < a.size(); i += of_one_program * 4) {
            if (alike(a[i], b[i]) && alike(a[i + 1], b[i + 1]) && alike(a[i + 2], b[i + 2]) &&
                alike(a[i + 3], b[i + 3]))
                continue;
            found.push_back(n);
            break;
        }
    return found;
}

class RandomPrograms : public SettledTest {
protected:
    void SetUp() override {  // OpenGL ES, where a driver has nothing else
        if (const int es = number_of("SNELL_RANDOM_ES", 0)) request = {es, true, false, false};
        SettledTest::SetUp();
        folder.write("a.bmp", bmp(2, 1, {{200, 0, 0}, {10, 255, 0}}));
    }
    // `statements`: of each expression, and of the vertex shader.
    std::string scene(const std::vector<std::string>& statements, const Values& values) {
        const std::string name = "any";
        const std::string head = "#version 330 compatibility\n" + declared();
        folder.write(name + ".vert",
                     head +
                         "out vec2 vST;\nout float vK;\nvoid main() {\nvST = gl_MultiTexCoord0.st;\nvK = "
                         "0.;\nif (uB1) vK = uF1 * vST.x;\nif (uI0 > 2) vK = uF2;\ngl_Position = "
                         "vec4(gl_Vertex.xy, 0., 1.);\n}\n");  // every column of the picture
        std::string text = head + "uniform sampler2D uPicture;\nin vec2 vST;\nin float vK;\n" + std::string(functions);
        std::string cases;
        for (std::size_t n = 0; n < statements.size(); ++n) {
            text += fmt::format("vec4 e{}(vec3 live) {{\n{}{}return vec4(a, b, c, v.x + v.y);\n}}\n", n, variables,
                                statements[n]);
            cases += fmt::format("if (at == {}) gl_FragColor = e{}(live);\n", n, n);
        }
        text +=
            "void main() {\nint at = int(gl_FragCoord.x);\nvec3 live = vec3(gl_FragCoord.y - .5, gl_FragCoord.y - 2.5, "
            "vST.x - .5);\ngl_FragColor = vec4(0.);\n" +
            cases + "}\n";
        folder.write(name + ".frag", text);
        folder.write(name + ".glib", "Texture2D 5 a.bmp\nBlend off\nOrtho -1 1 -1 1\nVertex " + name +
                                         ".vert\nFragment " + name + ".frag\nProgram P uPicture 5" + set(values) +
                                         "\nQuadXY\n");
        return folder.path(name + ".glib");
    }
    // Writes the fragment shader and a scene that is covered by it, whose programs for the values of its uniforms must
    // give the pixels of those for any values, which it returns.
    std::vector<float> expect_alike(const std::string& fragment, const std::string& uniforms, std::string_view what) {
        folder.write("one.frag", "#version 330 compatibility\n" + fragment);
        const std::string path = folder.write("one.glib",
                                              "Texture2D 5 a.bmp\nBlend off\nOrtho -1 1 -1 1\nVertex plain.vert\n"
                                              "Fragment one.frag\nProgram P " +
                                                  uniforms + "\nQuadXY\n");
        auto any = open_file(path), settled = open_settled(path);
        expect_clean(*any);
        const std::vector<float> pixels = floats_of(*any);
        EXPECT_TRUE(unlike(pixels, floats_of(*settled)).empty()) << what << uniforms;
        specialised = settled->runtime->counters().specialised;
        return pixels;
    }
    std::uint64_t specialised = 0;
    std::vector<float> floats_of(Document& document) {
        constexpr int rows = 4;
        const gl::Target target = gl::make_target(of_one_program, rows, 1, gl::Pixels::rgba32f);
        const View view;
        document.runtime->draw({0, view, document.controls}, {target.framebuffer.get(), of_one_program, rows});
        return gl::read_rgba32f(target.framebuffer.get(), of_one_program, rows, 1);
    }
};

std::string shown(const std::vector<float>& pixels, std::size_t n) {
    std::string text;
    for (std::size_t i = n * 4; i < pixels.size(); i += of_one_program * 4)
        text += fmt::format("{} {} {} {}\n", pixels[i], pixels[i + 1], pixels[i + 2], pixels[i + 3]);
    return text;
}

// Where a branch stood between two constants, Mesa makes them one: docs/architecture.md says how much floats differ.
TEST_F(RandomPrograms, RoundOnceLessWhereNoBranchIs) {
    const Values values = [] {
        std::mt19937 random(1);
        return some_values(random);
    }();
    for (const char* body : {"a = vST.y + .1; if (uI0 == uI0 && uI1 > -1000) b = a * .1; else b = a; c = b * .3;\n",
                             "a = vST.y; b = uI1 > -1000 ? .1 + a : c; c = b + .7;\n"}) {
        const std::string path = scene({of_one_program, body}, values);
        auto any = open_file(path), settled = open_settled(path);
        const std::vector<float> pixels = floats_of(*any), others = floats_of(*settled);
        ASSERT_EQ(pixels.size(), others.size());
        for (std::size_t i = 0; i < pixels.size(); ++i)
            EXPECT_NEAR(pixels[i], others[i], 2.4e-7 * std::max(1.F, std::abs(pixels[i]))) << body << i;
    }
}

TEST_F(RandomPrograms, GiveWhatThoseForAnyValuesGive) {
    const int first = number_of("SNELL_RANDOM_FIRST", 0);
    const int programs = number_of("SNELL_RANDOM_EXPRESSIONS", 240) / of_one_program;
    std::size_t ours = 0, specialised = 0;
    for (int program = first; program < first + programs; ++program) {
        std::mt19937 random(static_cast<unsigned>(number_of("SNELL_RANDOM_SEED", 1) * 100000 + program));
        Writer writer(random);
        std::vector<std::string> statements;
        for (int n = 0; n < of_one_program; ++n) statements.push_back(writer.statements());
        const Values values = some_values(random);
        const std::string path = scene(statements, values);
        auto any = open_file(path), settled = open_settled(path);
        expect_clean(*any);
        expect_clean(*settled);
        if (any->diagnostics.errors() > 0) return;
        const std::vector<float> pixels = floats_of(*any), others = floats_of(*settled);
        for (const std::size_t n : unlike(pixels, others)) {
            ++ours;
            ADD_FAILURE() << "program " << program << ", expression " << n << ":" << set(values) << "\n"
                          << statements[n] << shown(pixels, n) << "for these values:\n"
                          << shown(others, n);
        }
        specialised += settled->runtime->counters().specialised_draws > 0;
    }
    EXPECT_EQ(specialised, static_cast<std::size_t>(programs));
    hard_case(
        {"A60",
         "random programs: x / 0., 0. * log(0.), pow(-2., 2.), loops and branches where values of uniforms decide: "
         "as for any values",
         "expressions that differ",
         0,
         static_cast<double>(ours),
         {}});
}

// Written in scenes of students: 0 / 0 in every pixel, which a compiler drops if it knows the value.
TEST_F(RandomPrograms, ZeroByZeroStaysWhatItIs) {
    for (const char* body :
         {"float k = uK * r; float c = sin(k) / k;", "float c = sin(r * uK) / (r * uK);",
          "float c = 0.; if (uOn) c = log(uK * r) * uK; else c = r;", "float c = pow(uK - 2., uK + 2.);",
          "float c = uK * inversesqrt(uK * r);", "vec2 v = normalize(vec2(uK)); float c = v.x * uK;"}) {
        expect_alike(
            "uniform float uK;\nuniform bool uOn;\nin vec2 vST;\nvoid main() {\nfloat r = length(vST - .5);\n" +
                std::string(body) + "\ngl_FragColor = vec4(.5 + .5 * c, 0., 0., 1.);\n}\n",
            "uK <0. 0. 1.> uOn <true>", body);
    }
}

// Divisions by what is 0 because it was multiplied by 0, and 0 divided by something, beside decisions: llvmpipe leaves
// the quotient by a 0 that it sees undefined, and takes 0 for a 0 that it sees times or by anything.
TEST_F(RandomPrograms, ZerosThatADriverFindsAreHidden) {
    for (const char* body :
         {"b = live.z / (0. * uK); for (int i = 0; i < uN; ++i) b += float(uN) / uK;",
          "v.y = float(uN) / length(uV * b); set(c, uK);", "if (uOn) c = uV.y * b; else c = -b; c /= uV.x * float(k);",
          "for (int i = 0; i < uN; ++i) b *= uV.x * v.x; b /= uV.x * float(k);",
          "a *= 0. / uV.y; v.x = 1. / a; for (int i = 0; i < uN; ++i) a += i == 0 ? 0. : live.y; if (uOn) c = 1.;",
          "v = uV * b; set(c, float(uN) / v.x); if (!uOn) { if (k > uN) v.y = 0.; }",
          "c *= 0. / uV.y; if (uOn) v.y = 1.; else v.y = live.z / c;", "a /= v.x * live.x; if (uOn) b = 1.;",
          "if (uOn) c = log2(live.y); c = exp2(c);", "if (uOn) c = log2(live.y); c = exp2(2. * c);",
          "if (uOn) c = exp2(live.y * 1e4); c = log2(c);", "if (uOn) c = sqrt(live.y); c = c * c;",
          "b = 1.; if (!uOn) { b = a; c = vST.y; } c = uV.x / (b - c);", "if (uOn) c -= c; set(c, uV.x / c);",
          "if (uOn) v.y = live.y - live.y; c = uV.x / v.y;", "c = changed(0., live.x + 1.) * (1. / b);",
          "Part p = Part(0., vec2(0.)); if (uOn) p = Part(a, vec2(a)); c = p.x * (a / uK) + p.y.x * log(b);",
          "Part p[2] = Part[2](Part(0., vec2(0.)), Part(a, vec2(1.))); if (uOn) p[0].x = a; c = p[0].x * (a / uK);"}) {
        for (const char* on : {"true", "false"}) {
            expect_alike(
                "uniform float uK;\nuniform vec3 uV;\nuniform int uN;\n"
                "uniform bool uOn;\nin vec2 vST;\nstruct Part { float x; vec2 y; };\n"
                "float changed(float x, float y) { if (uOn) x = y; return x; }\n"
                "void set(out float r, float x) { r = 0.; if (uOn) r = x; }\n"
                "void main() {\nfloat a = vST.x, b = 0., c = 1.;\nvec3 v = vec3(0., vST.y, -1.);\nint k = "
                "0;\nvec3 live = vec3(gl_FragCoord.y - .5, gl_FragCoord.y - 2.5, vST.x - .5);\n" +
                    std::string(body) + "\ngl_FragColor = vec4(a, b, c, v.x + v.y);\n}\n",
                "uK <-1. 0. 1.> uV [-5. 10. 2.] uN <0 1 5> uOn <" + std::string(on) + ">", body);
            EXPECT_EQ(specialised, 1U) << body;
        }
    }
}

// A driver that finds the determinant to be 0 by algebra leaves the quotient undefined: other bytes in every run.
TEST_F(RandomPrograms, InversesOfSingularMatricesAreNotFinite) {
    for (const char* body : {"mat2 m = inverse(mat2(uK, uK, uK, uK)); c = vec4(m[0], m[1]);",
                             "mat3 m = inverse(mat3(vec3(uK), vec3(uK), vec3(uK))); c = vec4(m[0], m[1].x);",
                             "mat4 m = inverse(mat4(vec4(uK), vec4(uK), vec4(uK), vec4(uK))); c = m[0];",
                             "c = vec4(uK) / determinant(mat3(vec3(uK), vec3(uK), vec3(uK)));"}) {
        const auto values = expect_alike("uniform float uK;\nin vec2 vST;\nvoid main() {\nvec4 c;\n" +
                                             std::string(body) + "\ngl_FragColor = c;\n}\n",
                                         "uK <0. 2. 3.>", body);
        const auto center = static_cast<std::ptrdiff_t>(4 * (of_one_program + of_one_program / 2));
        EXPECT_TRUE(std::none_of(values.begin() + center, values.begin() + center + 4, [](float value) {
            return std::isfinite(value);
        })) << body;
    }
}

// Where GLSL wants a constant, it gets one.
TEST_F(RandomPrograms, ConstantsStayConstant) {
    folder.write("constant.frag",
                 "#version 330 compatibility\nuniform bool uOn;\nin vec2 vST;\nconst float z = 2 > 1 ? .2 : 0.;\n"
                 "struct Part { float x; vec2 y; };\nconst Part part = Part(z, vec2(0., 1.));\n"
                 "const float list[2 > 1 ? 3 : 2] = float[3](1., 2., z);\nvoid main() {\nfloat a = 0.;\n"
                 "if (uOn) a = z + part.y.x;\ngl_FragColor = vec4(a, list[2], part.y.y, 1.);\n}\n");
    for (const char* on : {"true", "false"}) {
        auto document =
            settle("Blend off\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment constant.frag\nProgram P uOn <" +
                   std::string(on) + ">\nQuadXY\n");
        expect_clean(*document);
        EXPECT_EQ(draw(*document).center(), (Pixel{on[0] == 't' ? 51 : 0, 51, 255, 255}));
    }
}

// What is left without a value where a check box is off is zero in every form, and so is the sign of a zero.
TEST_F(RandomPrograms, WhatIsLeftOutIsTheSame) {
    const std::string start = "uniform float uK;\nuniform bool uOn;\nuniform sampler2D uT;\nin vec2 vST;\n";
    for (const char* body :
         {"void main() { if (uOn) gl_FragColor = vec4(.5); }",
          "void main() { if (uOn) return; if (uK > 1.) gl_FragColor = vec4(.5); gl_FragColor.g += .1; }",
          "out vec4 color;\nvoid main() { if (uOn) color = vec4(vST, .5, 1.); }",
          "vec3 c;\nvoid main() { if (uOn) c = vec3(.5); gl_FragColor = vec4(c, 1.); }",
          "vec3 f(vec2 at) { if (uOn) return vec3(at, 1.); }\nvoid main() { gl_FragColor = vec4(f(vST), 1.); }",
          "void main() { gl_FragColor = vec4(atan(uK * (texture(uT, vST).r - .5), vST.x - .5)); }",
          "void main() { gl_FragColor = vec4(1. / (uK * (texture(uT, vST).r - .5))); }",
          "void main() { gl_FragColor = vec4(mix(1. / (gl_FragCoord.y - .5), texture(uT, vST).r, uK)); }"})
        expect_alike(start + body + "\n", "uT 5 uK <0. 0. 1.> uOn <false>", body);
}

}  // namespace
}  // namespace snell::test
