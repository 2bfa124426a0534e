// Constants of the text: what GLSL leaves undefined is what it is at run time.
#include <fmt/format.h>

#include "src/gl/program.h"
#include "src/glsl/glsl.h"
#include "tests/hard_case.h"
#include "tests/harness/harness.h"
#include "tests/words.h"

namespace snell::test {
namespace {

const std::string covering =
    "#version 330 core\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., "
    "1.); }\n";

std::string literal(float x) { return fmt::format("{:#.9g}", x); }

bool close(float a, float b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(a - b) <= std::max(1.0F / 255, 1e-5F * std::abs(a));
}

// How a number of the text gets into an expression.
enum class Written { uniform, literal, constant, variable, chosen };
constexpr Written in_the_text[] = {Written::literal, Written::constant, Written::variable, Written::chosen};

// K is the number that differs, L one that never does: the driver knows nothing of it.
struct TextRow {
    std::string text;
    float value = 0;
};

const std::vector<TextRow>& text_rows() {
    static const std::vector<TextRow> rows = [] {
        std::vector<TextRow> all{{"L + sqrt(K)", -1}, {"L + acos(K)", 2}};
        for (const std::string& text :
             words("L / K;-L / K;vec3(L) / K;vec2(L) / vec2(K, 2.);vec3(L, 1., 2.) / vec3(K, 1., K);"
                   "L / (K * 2.);L / (3. - 3. - K);L / sqrt(K);L / sin(K);L / length(vec2(K));"
                   "vec2(L) / vec2(K, L);vec3(1.) / K;(mat2(L) / K)[0];assigned(L, K);quotient(L, K);"
                   "L * (1. / K);exp(-L / K);clamp(L / K, -2., 2.);mod(L, K);mod(vec2(L), vec2(K, 2.));"
                   "mod(vec2(L), K);atan(L, K);atan(K, L);atan(K, -L);pow(L, K);pow(K, L);L * inversesqrt(K);"
                   "L * log(K);L * log2(K);smoothstep(K, K, L);float(int(L * 7.) / int(K));"
                   "float(uint(L * 7.) / uint(K));float(int(L * 7.) % int(K))",
                   ';'))
            all.push_back({text});
        return all;
    }();
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

    std::vector<glm::vec4> drawn(Written how, bool mended, bool settles) {
        const int width = static_cast<int>(text_rows().size());
        const gl::Program program = linked(how, mended, settles);
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

    std::set<std::string> unlike(Written how, bool mended, bool settles, const std::vector<glm::vec4>& computed) {
        std::set<std::string> out;
        const auto pixels = drawn(how, mended, settles);
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
    gl::Program linked(Written how, bool mended, bool settles) {
        std::string first = covering, second = text_source(how);
        if (mended) {
            Sources sources;
            Diagnostics diagnostics;
            glsl::Options options;
            options.target = {GetParam().version * 10, GetParam().es, false};
            if (settles) options.settle = [](const auto&) { return std::vector<glsl::Settled>(); };
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
        for (const bool settles : {false, true}) ours.merge(unlike(how, true, settles, computed));
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

}  // namespace
}  // namespace snell::test
