// The GL state that draws set; only differences reach the driver.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "parser/scene.h"
#include "src/content/cube/convolve.h"
#include "src/gl/context.h"
#include "src/gl/handle.h"

namespace snell::runtime {

// The GL state that draws set; only differences reach the driver.

class State {
public:
    explicit State(const gl::Caps& caps) : caps_(&caps) {}

    // Somebody else (the user interface, an upload) may have touched the context: believe nothing.
    void forget();
    // True: what is drawn blends.
    bool raster(const RasterState& wanted, bool opaque);
    void color(const Vec4& wanted);
    void program(GLuint program);
    void vertex_array(GLuint array);
    void texture(int unit, GLenum target, GLuint texture, GLuint sampler);
    std::uint64_t changes() const { return changes_; }

private:
    struct Unit {
        GLenum target = 0;
        GLuint texture = 0, sampler = 0;
        bool operator==(const Unit&) const = default;
    };
    bool blend(const RasterState& wanted, bool opaque);
    void toggle(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

    const gl::Caps* caps_;
    std::optional<RasterState> raster_;
    std::optional<bool> blending_;
    std::optional<Vec4> color_;
    std::optional<GLuint> program_, array_;
    std::vector<Unit> units_;
    std::uint64_t changes_ = 0;
};

// All that the system's uniforms are made from, in double; what a program does not read is never computed.
struct DrawContext {
    glm::dmat4 projection{1};  // clip from eye, the scene transformation included
    glm::dmat4 scene{1};       // the scene transformation, in eye space
    glm::dmat4 view{1};        // eye from world, the eye transformation included
    glm::dmat4 model{1};       // world from model
    glm::dmat4 texture{1};
    double time = 0, timer_period = 10;
    double width = 1, height = 1, mouse_x = 0, mouse_y = 0;
    double point_size = 1, line_width = 1;
    double fixed_point_size = 0;   // instead of what the shader writes; 0: the shader's
    std::array<float, 3> place{};  // of the part of the picture that is drawn: as glsl::System::place
    int face_index = 0;
    const content::Harmonics* harmonics = nullptr;  // of the cube map that the draw's last Irradiance names

    bool operator==(const DrawContext&) const = default;
};

}  // namespace snell::runtime
