// Domains divided without the driver, against the driver's: the same vertices and primitives.
#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/content/mesh/tessellate.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

using content::DividedDomain;
using content::Domain;
using content::Spacing;
using content::TessellationLevels;
using content::Tessellator;
using Place = std::array<float, 2>;

constexpr std::array domains{"triangles", "quads", "isolines"};
constexpr std::array spacings{"equal_spacing", "fractional_even_spacing", "fractional_odd_spacing"};

std::vector<Tessellator> all_tessellators() {
    std::vector<Tessellator> all;
    for (const Domain domain : {Domain::triangles, Domain::quads, Domain::isolines})
        for (const Spacing spacing : {Spacing::equal, Spacing::fractional_even, Spacing::fractional_odd})
            for (const bool clockwise : {false, true})
                for (const bool points : {false, true}) all.push_back({domain, spacing, clockwise, points});
    return all;
}

std::string layout_of(const Tessellator& how) {
    return fmt::format("layout({}, {}, {}{}) in;\n", domains[static_cast<std::size_t>(how.domain)],
                       spacings[static_cast<std::size_t>(how.spacing)], how.clockwise ? "cw" : "ccw",
                       how.points ? ", point_mode" : "");
}

// What the driver's tessellator makes of a patch.
class DriverTessellator {
public:
    explicit DriverTessellator(const Tessellator& how) : how_(how) {
        const std::string head = "#version 400 core\n";
        const gl::Compiled vertex = gl::compile(GL_VERTEX_SHADER, head + "void main() { gl_Position = vec4(0.); }\n");
        const gl::Compiled evaluation =
            gl::compile(GL_TESS_EVALUATION_SHADER,
                        head + layout_of(how) +
                            "out vec2 place; void main() { place = gl_TessCoord.xy; gl_Position = vec4(0.); }\n");
        program_ = std::move(gl::link({&vertex.shader, &evaluation.shader}, {}, {"place"}).program);
        glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer_.get());
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_DYNAMIC_READ);
    }

    std::vector<Place> primitives(const TessellationLevels& levels) {
        glUseProgram(program_.get());
        glBindVertexArray(array_.get());
        glPatchParameteri(GL_PATCH_VERTICES, 1);
        glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels.outer.data());
        glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels.inner.data());
        glEnable(GL_RASTERIZER_DISCARD);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_.get());
        glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query_.get());
        glBeginTransformFeedback(how_.points ? GL_POINTS : how_.domain == Domain::isolines ? GL_LINES : GL_TRIANGLES);
        glDrawArrays(GL_PATCHES, 0, 1);
        glEndTransformFeedback();
        glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        glDisable(GL_RASTERIZER_DISCARD);
        GLuint count = 0;
        glGetQueryObjectuiv(query_.get(), GL_QUERY_RESULT, &count);
        std::vector<Place> places(count * static_cast<std::size_t>(content::corners_of(how_)));
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(places.size() * sizeof(Place)),
                           places.data());
        return places;
    }

private:
    static constexpr GLsizeiptr bytes = GLsizeiptr{64} * 64 * 2 * 3 * 2 * sizeof(Place);
    Tessellator how_;
    gl::Program program_;
    gl::Buffer buffer_{gl::make(glGenBuffers)};
    gl::VertexArray array_{gl::make(glGenVertexArrays)};
    gl::Query query_{gl::make(glGenQueries)};
};

class Levels {
public:
    explicit Levels(unsigned seed) : random_(seed) {}
    TessellationLevels next() {
        TessellationLevels levels;
        for (float& level : levels.outer) level = one();
        for (float& level : levels.inner) level = one();
        return levels;
    }

private:
    float one() {
        static constexpr std::array special{0.F, -1.F, .5F, 1.F, 1.000004F, 2.F, 3.F, 62.5F, 63.F, 63.5F, 64.F, 1e9F};
        const float small = std::uniform_real_distribution<float>(0.1F, 8)(random_);
        switch (random_() % 8) {
            case 0:
                return random_() % 40 == 0 ? NAN : special[random_() % special.size()];
            case 1:
                return std::uniform_real_distribution<float>(1, 66)(random_);
            case 2:
                return 1;
            case 3:
                return std::ceil(small);
            default:
                return small;
        }
    }
    std::mt19937 random_;
};

class Tessellation : public GlTest {};

TEST_F(Tessellation, IsTheDriversVertexForVertex) {
    if (!caps.tessellation) GTEST_SKIP() << "no tessellation shaders";
    const char* const wanted = std::getenv("SNELL_RANDOM_LEVELS");
    const int all = wanted ? std::atoi(wanted) : 40;
    const gl::Target nowhere = gl::make_target(1, 1, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, nowhere.framebuffer.get());
    for (const Tessellator& how : all_tessellators()) {
        DriverTessellator driver(how);
        Levels levels(7);
        int discarded = 0;
        for (int i = 0; i < all; ++i) {
            const TessellationLevels given = levels.next();
            const DividedDomain made = content::divide(how, given);
            std::vector<Place> places;
            for (const std::uint32_t index : made.indices) places.push_back(made.vertices[index]);
            EXPECT_EQ(places, driver.primitives(given))
                << layout_of(how) << fmt::format("{} {}", fmt::join(given.outer, " "), fmt::join(given.inner, " "));
            discarded += places.empty() ? 1 : 0;
            if (HasFailure()) break;
        }
        EXPECT_LT(discarded, all / 2);
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace snell::test
