// Programs whose uniforms are constants: what GLSL leaves undefined is what it is at run time.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "src/gl/program.h"
#include "src/glsl/glsl.h"
#include "tests/hard_case.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

// What the constant form may give instead.
enum class Folded { same, fewer_nan, differs };

struct Row {
    std::string_view text;      // GLSL of A, B and C
    std::vector<float> values;  // of these
    Folded folded = Folded::same;
};

const std::vector<Row>& table() {
    static const std::vector<Row> rows = {
        {"A / B", {1, 0}},
        {"A / B", {-1, 0}},
        {"1. / -B", {1, 0}},
        {"exp(-A / B)", {1, 0}},
        {"A / (B - C)", {1, .3F, .3F}},
        {"clamp((A - B) / (C - B), 0., 1.)", {.5F, .3F, .3F}},
        {"vec3(A, 1., 2.) / vec3(B, C, 1.)", {1, 0, 2}},
        {"(mat2(A) / B)[0]", {1, 0}},
        {"quotient(A, B)", {1, 0}},
        {"assigned(A, B)", {1, 0}},
        {"looped(A, B)", {1, 3}},
        {"A / int(B)", {1, 0}},
        {"mod(A, B)", {1, 0}},
        {"pow(A, B)", {0, 0}},
        {"pow(A, B)", {0, -1}},
        {"pow(A, B)", {-2, 0}},
        {"pow(A, B)", {-2, 2}},
        {"pow(A, B)", {-2, 3}},
        {"pow(A, 3.)", {-2}},
        {"pow(vec2(A), vec2(B))", {-2, 2}},
        {"atan(A, B)", {0, 0}},
        {"atan(A, 0.)", {0}},
        {"atan(0., A)", {0}},
        {"atan(-A, -B)", {0, 1}},
        {"float(int(A) % int(B))", {5, 0}},
        {"float(int(A) % int(B))", {-5, 3}},
        {"float(uint(A) / uint(B))", {5, 0}},
        {"smoothstep(A, B, C)", {1, 1, 2}},
        {"smoothstep(1. - A, 1. + A, B)", {0, 1.5F}},
        {"smoothstep(0., A, B)", {0, 1}},
        {"clamp(A, B, C)", {.5F, 1, 0}},
        {"sqrt(A)", {-1}},
        {"log(A)", {0}},
        {"acos(A)", {1.5F}},
        {"float(1 << int(A))", {33}},
        // What a zero multiplies is left out, whatever it is.
        {"mix(A, exp2(B), C)", {1, 200, 0}, Folded::fewer_nan},
        {"A * exp2(B)", {0, 200}, Folded::fewer_nan},
        {"A / B", {0, 0}, Folded::fewer_nan},
        {"vec2(A) / B", {0, 0}, Folded::fewer_nan},
        {"normalize(vec3(A, B, C))", {0, 0, 0}, Folded::fewer_nan},
        // Denormals, numbers beyond the int's, angles without a digit, singular matrices, NaN in max(), and a vector of
        // exponents of which one is a number in the text.
        {"A * B * 1e38", {1e-30F, 1e-10F}, Folded::differs},
        {"float(int(A))", {1e20F}, Folded::differs},
        {"sin(A)", {1e30F}, Folded::differs},
        {"inverse(mat2(A, B, C, 1.))[0]", {0, 0, 0}, Folded::differs},
        {"max(0., sqrt(A))", {-1}, Folded::differs},
        {"pow(vec2(A), vec2(B, 2.))", {-2, 2}, Folded::differs},
    };
    return rows;
}

std::string name_of(std::size_t row, std::size_t operand) {
    return "k" + std::to_string(row) + "_" + std::to_string(operand);
}

std::string literal(float x) { return fmt::format("{:#.9g}", x); }

const std::string covering =
    "#version 330 core\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., "
    "1.); }\n";

// All rows in one fragment shader: pixel n shows row n.
std::string source(const std::vector<Row>& rows) {
    std::string declarations = "#version 330 core\n", statements;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::string text;
        for (const char c : rows[row].text)
            text += c >= 'A' && c <= 'C' ? name_of(row, static_cast<std::size_t>(c - 'A')) : std::string(1, c);
        for (std::size_t n = 0; n < rows[row].values.size(); ++n)
            declarations += "uniform float " + name_of(row, n) + ";\n";
        statements += "if (at == " + std::to_string(row) + ") result = give(" + text + ");\n";
    }
    return declarations +
           "out vec4 result;\n"
           "vec4 give(float x) { return vec4(x, 0., 0., 0.); }\nvec4 give(vec2 x) { return vec4(x, 0., 0.); }\n"
           "vec4 give(vec3 x) { return vec4(x, 0.); }\n"
           "float quotient(float a, float b) { float w = .5 * b; w *= 2.; return a / w; }\n"
           "float assigned(float a, float b) { a /= b; return a; }\n"
           "float looped(float a, float b) { for (int i = 0; i < 4; ++i) { float w = b - float(i); if (w < .5) return "
           "a / w; } return 0.; }\n"
           "void main() {\nint at = int(gl_FragCoord.x);\nresult = vec4(0.);\n" +
           statements + "}\n";
}

bool close(float a, float b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(a - b) <= std::max(1.0F / 255, 1e-5F * std::abs(a));
}

class Folding : public GlTest, public testing::WithParamInterface<ContextRequest> {
protected:
    void SetUp() override {
        request = GetParam();
        GlTest::SetUp();
        // One compiler serves all contexts, and takes its time: the others get a third of the rows.
        const bool all = GetParam().version == 45;
        for (std::size_t row = 0; row < table().size(); row += all ? 1 : 3) rows.push_back(table()[row]);
    }

    // Bit n of `constants`: operand n is written as a constant.
    std::vector<glm::vec4> drawn(unsigned constants, bool at_run_time) {
        const int width = static_cast<int>(rows.size());
        const gl::Program program = linked(constants, at_run_time);
        if (!program) return std::vector<glm::vec4>(rows.size());
        const gl::Target target = gl::make_target(width, 1, 1, gl::Pixels::rgba32f);
        const gl::VertexArray vertices(gl::make(glGenVertexArrays));
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
        glViewport(0, 0, width, 1);
        glUseProgram(program.get());
        for (std::size_t row = 0; row < rows.size(); ++row)
            for (std::size_t n = 0; n < rows[row].values.size(); ++n)
                glUniform1f(glGetUniformLocation(program.get(), name_of(row, n).c_str()), rows[row].values[n]);
        glBindVertexArray(vertices.get());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        const std::vector<float> pixels = gl::read_rgba32f(target.framebuffer.get(), width, 1, 1);
        std::vector<glm::vec4> out;
        for (std::size_t i = 0; i < pixels.size(); i += 4)
            out.emplace_back(pixels[i], pixels[i + 1], pixels[i + 2], pixels[i + 3]);
        return out;
    }

    std::vector<Row> rows;

private:
    gl::Program linked(unsigned constants, bool at_run_time) {
        Sources sources;
        Diagnostics diagnostics;
        glsl::Options options;
        options.target = {GetParam().version * 10, GetParam().es, false};
        options.undefined_at_run_time = at_run_time;
        const auto translation = glsl::translate({{Stage::vertex, sources.add("all.vert", covering), {}},
                                                  {Stage::fragment, sources.add("rows.frag", source(rows)), {}}},
                                                 sources, options, diagnostics);
        EXPECT_TRUE(translation.ok);
        std::string text = translation.stages.back().text;
        for (std::size_t row = 0; row < rows.size(); ++row)
            for (std::size_t n = 0; n < rows[row].values.size(); ++n) {
                if (!(constants >> n & 1)) continue;
                const std::string variable = "uniform float " + name_of(row, n);
                text.replace(text.find(variable), variable.size(),
                             "const float " + name_of(row, n) + " = " + literal(rows[row].values[n]));
            }
        const gl::Compiled vertex = gl::compile(GL_VERTEX_SHADER, translation.stages.front().text);
        const gl::Compiled fragment = gl::compile(GL_FRAGMENT_SHADER, text);
        EXPECT_TRUE(fragment.shader) << fragment.log;
        if (!fragment.shader) return {};
        gl::Linked program = gl::link({&vertex.shader, &fragment.shader}, {});
        EXPECT_TRUE(program.program) << program.log;
        return std::move(program.program);
    }
};

// Rows whose constant forms differ from what is computed at run time.
std::vector<std::string> differences(const std::vector<Row>& rows, const std::vector<glm::vec4>& folded,
                                     const std::vector<glm::vec4>& computed) {
    std::vector<std::string> out;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const Folded allowed = rows[row].folded;
        if (allowed == Folded::differs) continue;
        bool same = true;
        for (int c = 0; c < 4; ++c)
            same = same && (close(computed[row][c], folded[row][c]) ||
                            (allowed == Folded::fewer_nan && std::isnan(computed[row][c])));
        if (!same)
            out.push_back(fmt::format("{} of {}: {} {} {} is {} {} {}", rows[row].text,
                                      fmt::join(rows[row].values, ", "), computed[row].x, computed[row].y,
                                      computed[row].z, folded[row].x, folded[row].y, folded[row].z));
    }
    return out;
}

TEST_P(Folding, ConstantsGiveWhatUniformsGive) {
    const auto computed = drawn(0, false);
    std::set<std::string> ours;
    std::vector<unsigned> forms = {7, 2};
    if (GetParam().version == 45) forms.insert(forms.end(), {1, 6});
    for (const unsigned constants : forms)
        for (const std::string& text : differences(rows, drawn(constants, true), computed)) {
            ours.insert(text);
            ADD_FAILURE() << text << " where operands " << constants << " are constant";
        }
    const auto naive = differences(rows, drawn(7, false), computed);
    hard_case({"A60",
               "x / 0., mod(x, 0.), pow(-2., 2.), atan(0., 0.), -5 % 3 of settled values, written as constants: as at "
               "run time; naive: as the driver folds them",
               "expressions that differ", 0, static_cast<double>(ours.size()), static_cast<double>(naive.size())});
}

// ---- constants of the text --------------------------------------------------------------------------------

// How a number of the text gets into an expression.
enum class Written { uniform, literal, constant, variable, chosen };
constexpr Written in_the_text[] = {Written::literal, Written::constant, Written::variable, Written::chosen};

// K is the number that differs, L one that never does: the driver knows nothing of it.
struct TextRow {
    std::string_view text;
    float value = 0;
};

const std::vector<TextRow>& text_rows() {
    static const std::vector<TextRow> rows = {
        {"L / K"},
        {"-L / K"},
        {"vec3(L) / K"},
        {"vec2(L) / vec2(K, 2.)"},
        {"vec3(L, 1., 2.) / vec3(K, 1., K)"},
        {"L / (K * 2.)"},
        {"L / (3. - 3. - K)"},
        {"L / sqrt(K)"},
        {"L / sin(K)"},
        {"L / length(vec2(K))"},
        {"vec2(L) / vec2(K, L)"},
        {"vec3(1.) / K"},
        {"(mat2(L) / K)[0]"},
        {"assigned(L, K)"},
        {"quotient(L, K)"},
        {"L * (1. / K)"},
        {"exp(-L / K)"},
        {"clamp(L / K, -2., 2.)"},
        {"mod(L, K)"},
        {"mod(vec2(L), vec2(K, 2.))"},
        {"mod(vec2(L), K)"},
        {"atan(L, K)"},
        {"atan(K, L)"},
        {"atan(K, -L)"},
        {"pow(L, K)"},
        {"pow(K, L)"},
        {"L * inversesqrt(K)"},
        {"L * log(K)"},
        {"L * log2(K)"},
        {"L + sqrt(K)", -1},
        {"L + acos(K)", 2},
        {"smoothstep(K, K, L)"},
        {"float(int(L * 7.) / int(K))"},
        {"float(uint(L * 7.) / uint(K))"},
        {"float(int(L * 7.) % int(K))"},
    };
    return rows;
}

std::string text_source(Written how) {
    std::string declarations =
        "#version 330 core\nuniform float live, zero;\nout vec4 result;\n"
        "vec4 give(float x) { return vec4(x, 0., 0., 0.); }\nvec4 give(vec2 x) { return vec4(x, 0., 0.); }\n"
        "vec4 give(vec3 x) { return vec4(x, 0.); }\n"
        "float quotient(float a, float b) { float w = .5 * b; w *= 2.; return a / w; }\n"
        "float assigned(float a, float b) { a /= b; return a; }\n";
    std::string statements;
    for (std::size_t row = 0; row < text_rows().size(); ++row) {
        const std::string number = literal(text_rows()[row].value), name = "k" + std::to_string(row);
        if (how == Written::uniform) declarations += "uniform float " + name + ";\n";
        if (how == Written::constant) declarations += "const float " + name + " = " + number + ";\n";
        if (how == Written::variable) statements += "float " + name + " = " + number + ";\n";
        if (how == Written::chosen)
            statements += "float " + name + " = 3.;\nif (live < 2.) " + name + " = " + number + ";\n";
        std::string text;
        for (const char c : text_rows()[row].text)
            text += c == 'K'   ? (how == Written::literal ? "(" + number + ")" : name)
                    : c == 'L' ? "live"
                               : std::string(1, c);
        statements += "if (at == " + std::to_string(row) + ") result = give(" + text + ");\n";
    }
    return declarations + "void main() {\nint at = int(gl_FragCoord.x);\nresult = vec4(0.);\n" + statements + "}\n";
}

class TextFolding : public GlTest, public testing::WithParamInterface<ContextRequest> {
protected:
    void SetUp() override {
        request = GetParam();
        GlTest::SetUp();
    }

    std::vector<glm::vec4> drawn(Written how, bool mended, bool at_run_time) {
        const int width = static_cast<int>(text_rows().size());
        const gl::Program program = linked(how, mended, at_run_time);
        if (!program) return std::vector<glm::vec4>(text_rows().size());
        const gl::Target target = gl::make_target(width, 1, 1, gl::Pixels::rgba32f);
        const gl::VertexArray vertices(gl::make(glGenVertexArrays));
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
        glViewport(0, 0, width, 1);
        glUseProgram(program.get());
        glUniform1f(glGetUniformLocation(program.get(), "live"), .75F);
        for (std::size_t row = 0; row < text_rows().size(); ++row)
            glUniform1f(glGetUniformLocation(program.get(), ("k" + std::to_string(row)).c_str()),
                        text_rows()[row].value);
        glBindVertexArray(vertices.get());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        const std::vector<float> pixels = gl::read_rgba32f(target.framebuffer.get(), width, 1, 1);
        std::vector<glm::vec4> out;
        for (std::size_t i = 0; i < pixels.size(); i += 4)
            out.emplace_back(pixels[i], pixels[i + 1], pixels[i + 2], pixels[i + 3]);
        return out;
    }

    std::set<std::string> unlike(Written how, bool mended, bool at_run_time, const std::vector<glm::vec4>& computed) {
        std::set<std::string> out;
        const auto pixels = drawn(how, mended, at_run_time);
        for (std::size_t row = 0; row < pixels.size(); ++row)
            for (int c = 0; c < 4; ++c)
                if (!close(computed[row][c], pixels[row][c]))
                    out.insert(fmt::format("{} of {}, written {}: {} is {}", text_rows()[row].text,
                                           text_rows()[row].value, static_cast<int>(how), computed[row][c],
                                           pixels[row][c]));
        return out;
    }

private:
    // Not mended: the shader as it is written, for desktop contexts.
    gl::Program linked(Written how, bool mended, bool at_run_time) {
        std::string first = covering, second = text_source(how);
        if (mended) {
            Sources sources;
            Diagnostics diagnostics;
            glsl::Options options;
            options.target = {GetParam().version * 10, GetParam().es, false};
            options.undefined_at_run_time = at_run_time;
            const auto translation = glsl::translate({{Stage::vertex, sources.add("all.vert", covering), {}},
                                                      {Stage::fragment, sources.add("rows.frag", second), {}}},
                                                     sources, options, diagnostics);
            EXPECT_TRUE(translation.ok);
            first = translation.stages.front().text;
            second = translation.stages.back().text;
        }
        const gl::Compiled vertex = gl::compile(GL_VERTEX_SHADER, first);
        const gl::Compiled fragment = gl::compile(GL_FRAGMENT_SHADER, second);
        EXPECT_TRUE(fragment.shader) << fragment.log;
        if (!fragment.shader) return {};
        gl::Linked program = gl::link({&vertex.shader, &fragment.shader}, {});
        EXPECT_TRUE(program.program) << program.log;
        return std::move(program.program);
    }
};

TEST_P(TextFolding, NumbersOfTheTextGiveWhatUniformsGive) {
    const auto computed = drawn(Written::uniform, true, false);
    std::set<std::string> ours, naive;
    for (const Written how : in_the_text) {
        for (const bool at_run_time : {false, true}) ours.merge(unlike(how, true, at_run_time, computed));
        if (!GetParam().es) naive.merge(unlike(how, false, false, computed));
    }
    for (const std::string& text : ours) ADD_FAILURE() << text;
    if (GetParam().es) return;
    hard_case({"A61",
               "x / 0., mod(x, 0.), x / sqrt(0.) of numbers of the text: as where a uniform is 0; naive: as the driver "
               "folds them",
               "expressions that differ", 0, static_cast<double>(ours.size()), static_cast<double>(naive.size())});
}

INSTANTIATE_TEST_SUITE_P(All, TextFolding,
                         testing::Values(ContextRequest{33}, ContextRequest{45}, ContextRequest{30, true},
                                         ContextRequest{32, true}),
                         context_name);

INSTANTIATE_TEST_SUITE_P(All, Folding,
                         testing::Values(ContextRequest{33}, ContextRequest{45}, ContextRequest{30, true},
                                         ContextRequest{32, true}),
                         context_name);

}  // namespace
}  // namespace snell::test
