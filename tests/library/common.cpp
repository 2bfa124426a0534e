#include "tests/library/common.h"

#include <fmt/format.h>
#include <ostream>

#include "shaders/embedded.h"
#include "src/gl/context.h"
#include "src/gl/program.h"
#include "src/gl/target.h"
#include "tests/oracle/optics/cube.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::test {

const std::array<Dialect, 3> dialects = {{{"Core33", {33, false, false, true}, "#version 330 core"},
                                          {"Core45", {45, false, false, true}, "#version 450 core"},
                                          {"Es32", {32, true, false, true}, "#version 320 es"}}};

void PrintTo(const Dialect& dialect, std::ostream* out) { *out << dialect.name; }

std::string expand(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        constexpr std::string_view include = "#include <";
        if (line.starts_with(include)) {
            const std::string_view name = line.substr(include.size(), line.find('>') - include.size());
            const std::string_view file = embedded_shader(name);
            EXPECT_FALSE(file.empty()) << "no file " << name;
            out += expand(file);
        } else {
            out.append(line).append("\n");
        }
    }
    return out;
}

namespace {

constexpr int width = 256;
constexpr std::string_view precisions =
    "\n#ifdef GL_ES\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "precision highp samplerCube;\n#endif\n";

gl::Texture upload(const std::vector<glm::vec4>& values, int height) {
    return gl::make_texture(GL_TEXTURE_2D,
                            {gl::Pixels::rgba32f, width, height, 1, reinterpret_cast<const std::byte*>(values.data())},
                            {gl::Sampling::Mode::nearest, 1, true});
}

std::string fragment_text(std::string_view head, std::string_view before, std::string_view body) {
    return std::string(head) + expand(before) +
           "\nuniform sampler2D argumentA, argumentB, argumentC;\nuniform samplerCube cube;\n"
           "out vec4 result;\nvec4 function(vec4 a, vec4 b, vec4 c) {\n" +
           std::string(body) +
           "\n}\nvoid main() {\n    ivec2 at = ivec2(gl_FragCoord.xy);\n"
           "    result = function(texelFetch(argumentA, at, 0), texelFetch(argumentB, at, 0), "
           "texelFetch(argumentC, at, 0));\n}\n";
}

gl::Program build(std::string_view version, std::string_view before, std::string_view body) {
    const std::string head = std::string(version) + std::string(precisions);
    const gl::Compiled vertex = gl::compile(
        GL_VERTEX_SHADER,
        head + "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.); }");
    const gl::Compiled fragment = gl::compile(GL_FRAGMENT_SHADER, fragment_text(head, before, body));
    EXPECT_TRUE(vertex.shader) << vertex.log;
    EXPECT_TRUE(fragment.shader) << fragment.log;
    if (!vertex.shader || !fragment.shader) return {};
    gl::Linked linked = gl::link({&vertex.shader, &fragment.shader}, {});
    EXPECT_TRUE(linked.program) << linked.log;
    return std::move(linked.program);
}

}  // namespace

void LibraryTest::SetUp() {
    std::string error;
    auto& kept = contexts[GetParam().name];
    if (!kept) kept = HeadlessContext::make(GetParam().request, error);
    context = kept.get();
    if (!context || !context->make_current()) GTEST_SKIP() << "no graphics: " << error;
    const ContextRequest& request = GetParam().request;
    RecordProperty("context", std::string(request.es ? "ES " : "GL ") + std::to_string(request.version / 10) + "." +
                                  std::to_string(request.version % 10));
    gl::watch_messages(report);
}

void LibraryTest::TearDown() {
    if (!context) return;
    for (const std::string& error : gl::take_errors()) ADD_FAILURE() << error;
    for (const std::string& complaint : complaints) ADD_FAILURE() << "the driver: " << complaint;
}

void LibraryTest::set_cube(const Colors& colors, int size) {
    std::array<std::vector<glm::vec4>, 6> faces;
    std::array<gl::Texels, 6> texels;
    for (int face = 0; face < 6; ++face) {
        auto& pixels = faces[static_cast<std::size_t>(face)];
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const auto d = optics::cube_direction({face, (column + 0.5) / size, (row + 0.5) / size});
                pixels.emplace_back(colors(*optics::unit(d)), 1);
            }
        texels[static_cast<std::size_t>(face)] = {gl::Pixels::rgba32f, size, size, 1,
                                                  reinterpret_cast<const std::byte*>(pixels.data())};
    }
    cube = gl::make_texture(GL_TEXTURE_CUBE_MAP, texels, {gl::Sampling::Mode::nearest, 1, true});
}

void LibraryTest::expect_compiles_in_others(std::string_view before, std::string_view body) {
    for (const Dialect& other : dialects) {
        if (other.version == GetParam().version) continue;
        const bool known = other.request.es ? epoxy_has_gl_extension("GL_ARB_ES3_2_compatibility")
                                            : epoxy_gl_version() >= other.request.version;
        if (!known) continue;
        const gl::Compiled compiled = gl::compile(
            GL_FRAGMENT_SHADER, fragment_text(std::string(other.version) + std::string(precisions), before, body));
        EXPECT_TRUE(compiled.shader) << other.name << compiled.log;
    }
}

std::vector<glm::vec4> LibraryTest::run(std::string_view before, std::string_view body,
                                        const std::vector<Arguments>& arguments) {
    const gl::Program program = build(GetParam().version, before, body);
    std::vector<glm::vec4> results(arguments.size(), glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    if (!program) return results;
    if (!GetParam().request.es) expect_compiles_in_others(before, body);
    const int height = (static_cast<int>(arguments.size()) + width - 1) / width;
    std::array<std::vector<glm::vec4>, 3> columns;
    for (auto& column : columns) column.resize(static_cast<std::size_t>(width * height));
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        columns[0][i] = arguments[i].a;
        columns[1][i] = arguments[i].b;
        columns[2][i] = arguments[i].c;
    }
    const gl::Target target = gl::make_target(width, height, 1, gl::Pixels::rgba32f);
    EXPECT_TRUE(target.framebuffer) << "no float target";
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glViewport(0, 0, width, height);
    // A test of depth that all pass: without one, llvmpipe compiles each shader a second time, for whole tiles.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glUseProgram(program.get());
    const gl::VertexArray vertices(gl::make(glGenVertexArrays));
    glBindVertexArray(vertices.get());
    std::array<gl::Texture, 3> textures;
    constexpr std::array<const char*, 3> names = {"argumentA", "argumentB", "argumentC"};
    for (std::size_t i = 0; i < 3; ++i) textures[i] = upload(columns[i], height);
    for (std::size_t i = 0; i < 3; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_2D, textures[i].get());
        glUniform1i(glGetUniformLocation(program.get(), names[i]), static_cast<GLint>(i));
    }
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube.get());
    glUniform1i(glGetUniformLocation(program.get(), "cube"), 3);
    bind(program.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const std::vector<float> rows = gl::read_rgba32f(target.framebuffer.get(), width, height, 1);
    for (std::size_t i = 0; i < results.size(); ++i) {
        const std::size_t row = static_cast<std::size_t>(height) - 1 - i / width;
        const float* pixel = &rows[(row * width + i % width) * 4];
        results[i] = {pixel[0], pixel[1], pixel[2], pixel[3]};
    }
    return results;
}

testing::AssertionResult LibraryTest::compiles(std::string_view version, std::string_view text) {
    const gl::Compiled compiled = gl::compile(
        GL_FRAGMENT_SHADER, std::string(version) + std::string(precisions) + expand(text) + "\nvoid main() {}\n");
    if (compiled.shader) return testing::AssertionSuccess();
    return testing::AssertionFailure() << version << ": " << compiled.log;
}

bool finite(const glm::vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

void expect_each(const std::vector<glm::vec4>& results, const std::vector<Arguments>& arguments, std::string_view body,
                 const std::function<bool(const glm::vec4&)>& good) {
    int bad = 0;
    std::string first;
    const auto words = [](const glm::vec4& v) { return fmt::format("({} {} {} {})", v.x, v.y, v.z, v.w); };
    for (std::size_t i = 0; i < results.size(); ++i)
        if (!good(results[i]) && ++bad <= 3)
            first += fmt::format("  {} {} {} gives {}\n", words(arguments[i].a), words(arguments[i].b),
                                 words(arguments[i].c), words(results[i]));
    EXPECT_EQ(bad, 0) << body << "\n" << first;
}

const std::vector<float>& special_values() {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    static const std::vector<float> values = {
        0.0F,       -0.0F,      1.0F,   -1.0F,   1e-45F,  -1e-45F,    1e-38F, 1e-30F, -1e-30F, 1e-20F,
        1e-7F,      1e30F,      -1e30F, 3e38F,   -3e38F,  inf,        -inf,   nan,    0.5F,    -0.5F,
        0.6666667F, 0.9999999F, 1.1F,   1.5F,    1.0003F, 1.0000001F, 1.31F,  1.33F,  1.52F,   2.42F,
        -1.5F,      5.0F,       -5.0F,  4.9999F, 100.0F,  1e6F,       1e20F,  -1e20F, 0.1F,    3.0F};
    return values;
}

std::vector<Arguments> special_arguments(int count) {
    std::mt19937 random(17);
    const auto& values = special_values();
    std::uniform_int_distribution<std::size_t> any(0, values.size() - 1);
    const auto four = [&] {
        return glm::vec4(values[any(random)], values[any(random)], values[any(random)], values[any(random)]);
    };
    std::vector<Arguments> out;
    for (int i = 0; i < count; ++i) out.push_back({four(), four(), four()});
    return out;
}

std::vector<glm::dvec3> unit_vectors(int count) {
    std::mt19937 random(4);
    std::normal_distribution<double> any;
    std::vector<glm::dvec3> out;
    while (static_cast<int>(out.size()) < count) {
        const glm::dvec3 v(any(random), any(random), any(random));
        out.push_back(*optics::unit(v));
    }
    return out;
}

}  // namespace snell::test
