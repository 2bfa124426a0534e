// Calls functions of the GLSL library with thousands of arguments, on each kind of context.
#pragma once

#include <glm/glm.hpp>

#include "src/gl/context.h"
#include "src/gl/handle.h"
#include "src/gl/texture.h"
#include "src/platform/headless.h"
#include "tests/std.h"

namespace snell::test {

struct Dialect {
    const char* name;
    ContextRequest request;
    const char* version;  // the directive
};
void PrintTo(const Dialect& dialect, std::ostream* out);

// Core 3.3, core 4.5, OpenGL ES 3.2.
extern const std::array<Dialect, 3> dialects;

// A file of the library with its includes put in their places, as the runtime does.
std::string expand(std::string_view text);

// One call's arguments; a function reads what it needs of them.
struct Arguments {
    glm::vec4 a{0}, b{0}, c{0};
};

// Cube map of one float colour for each direction, nearest or linear.
using Colors = std::function<glm::vec3(const glm::dvec3& direction)>;

class LibraryTest : public testing::TestWithParam<Dialect> {
protected:
    void SetUp() override;
    void TearDown() override;
    static void TearDownTestSuite() { contexts.clear(); }

    // `body` is a function body over vec4 a, b, c, with `samplerCube cube`, that returns a vec4. `before` is GLSL
    // outside of it, with #include.
    std::vector<glm::vec4> run(std::string_view before, std::string_view body, const std::vector<Arguments>& arguments);
    // What else bodies read: called with the program in use. Texture units from 4 on are free.
    virtual void bind(GLuint) {}
    // For `cube` in bodies.
    void set_cube(const Colors& colors, int size);
    // Whether a fragment shader of this text (after the version line and precisions) compiles.
    testing::AssertionResult compiles(std::string_view version, std::string_view text);

    // Whether the text that run() draws compiles in the dialects that this context knows beside its own.
    void expect_compiles_in_others(std::string_view before, std::string_view body);

    // By dialect; one for all tests of a suite.
    static inline std::map<std::string, std::unique_ptr<HeadlessContext>> contexts;
    HeadlessContext* context = nullptr;
    std::vector<std::string> complaints;
    gl::MessageReport report = [this](const char* message) { complaints.emplace_back(message); };
    gl::Texture cube;
};

// One compiler reads all dialects, and makes code that takes most of the time: of what is dear, the first dialect alone
// is drawn, and all are compiled.
#define SNELL_IN_THE_FIRST_DIALECT(Suite)                                           \
    INSTANTIATE_TEST_SUITE_P(All, Suite, testing::Values(snell::test::dialects[0]), \
                             [](const auto& dialect) { return std::string(dialect.param.name); })
#define SNELL_IN_ALL_DIALECTS(Suite)                                               \
    INSTANTIATE_TEST_SUITE_P(All, Suite, testing::ValuesIn(snell::test::dialects), \
                             [](const auto& dialect) { return std::string(dialect.param.name); })

inline glm::dvec3 vec(const glm::vec4& v) { return {v.x, v.y, v.z}; }
bool finite(const glm::vec4& v);
// The larger of two errors; NaN if one is, which then fails wherever it is compared.
inline double worse(double a, double b) { return std::isnan(a) || b <= a ? a : b; }

// Fails with the first calls of `body` whose results are not good.
void expect_each(const std::vector<glm::vec4>& results, const std::vector<Arguments>& arguments, std::string_view body,
                 const std::function<bool(const glm::vec4&)>& good);

// Values that break naive code: zeros, denormals, the ends of the range, infinities, NaN, neighbours of 1, indices.
const std::vector<float>& special_values();
// `count` arguments of special values drawn at random, the same for every call.
std::vector<Arguments> special_arguments(int count);

// Unit vectors, the same for every call.
std::vector<glm::dvec3> unit_vectors(int count);

}  // namespace snell::test
