#include "src/gl/context.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "src/gl/driver.h"

namespace snell::gl {

namespace {

std::string text(GLenum name) {
    const auto* value = reinterpret_cast<const char*>(glGetString(name));
    return value ? value : "";
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

float range_end(GLenum name) {
    std::array<GLfloat, 2> range{1, 1};
    glGetFloatv(name, range.data());
    return range[1];
}

int glsl_version(int gl, bool es) {
    if (es) return gl >= 32 ? 320 : 300;
    return gl * 10;  // from 3.3 on, versions of GL and GLSL have the same number
}

}  // namespace

Caps query_caps() {
    Caps caps;
    caps.renderer = text(GL_RENDERER);
    caps.vendor = text(GL_VENDOR);
    caps.version = text(GL_VERSION);
    const int version = gl::version();
    caps.es = !is_desktop();
    caps.glsl = glsl_version(version, caps.es);
    for (std::string_view name : {"llvmpipe", "softpipe", "SwiftShader", "swrast"})
        caps.software = caps.software || caps.renderer.find(name) != std::string::npos;
    caps.fp64 = !caps.es && version >= 40;
    caps.geometry = !caps.es || version >= 32;
    caps.tessellation = caps.es ? version >= 32 : version >= 40;
    caps.program_interface_query =
        caps.es ? version >= 31 : version >= 43 || has_extension("GL_ARB_program_interface_query");
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    caps.max_viewport = std::min(viewport[0], viewport[1]);
    caps.max_texture = integer(GL_MAX_TEXTURE_SIZE);
    caps.max_texture_3d = integer(GL_MAX_3D_TEXTURE_SIZE);
    caps.max_cube = integer(GL_MAX_CUBE_MAP_TEXTURE_SIZE);
    caps.max_samples = integer(GL_MAX_SAMPLES);
    caps.max_draw_buffers = std::min(integer(GL_MAX_DRAW_BUFFERS), integer(GL_MAX_COLOR_ATTACHMENTS));
    caps.max_line_width = range_end(GL_ALIASED_LINE_WIDTH_RANGE);
    // Forward-compatible core contexts refuse widths above 1, even if the range that they report is larger.
    if (!caps.es && (integer(GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT)) caps.max_line_width = 1;
    caps.max_point_size = range_end(caps.es ? GL_ALIASED_POINT_SIZE_RANGE : GL_POINT_SIZE_RANGE);
    return caps;
}

void leave_stages(Caps& caps) {
    caps.geometry = caps.tessellation = false;
    if (caps.es) caps.glsl = 300;
}

namespace {

const char* error_name(GLenum error) {
    constexpr std::pair<GLenum, const char*> names[]{
        {GL_INVALID_ENUM, "GL_INVALID_ENUM"},
        {GL_INVALID_VALUE, "GL_INVALID_VALUE"},
        {GL_INVALID_OPERATION, "GL_INVALID_OPERATION"},
        {GL_INVALID_FRAMEBUFFER_OPERATION, "GL_INVALID_FRAMEBUFFER_OPERATION"},
        {GL_OUT_OF_MEMORY, "GL_OUT_OF_MEMORY"},
        {GL_CONTEXT_LOST, "GL_CONTEXT_LOST"}};
    for (const auto& [code, name] : names)
        if (code == error) return name;
    return "unknown GL error";
}

}  // namespace

std::vector<std::string> take_errors() {
    std::vector<std::string> errors;
    // The loop is bounded because a lost context reports the same error for ever.
    for (GLenum error; errors.size() < 16 && (error = glGetError()) != GL_NO_ERROR;)
        errors.emplace_back(error_name(error));
    return errors;
}

}  // namespace snell::gl
