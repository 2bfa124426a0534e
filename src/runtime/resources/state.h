// The GL state that draws set; only differences reach the driver.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "parser/scene.h"
#include "src/gl/caps.h"
#include "src/gl/handle.h"

namespace snell::runtime {

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

}  // namespace snell::runtime
