#include "src/gl/texels.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "src/gl/driver.h"
#include "src/gl/program.h"
#include "src/gl/texture.h"

namespace snell::gl {

namespace {

// The face in each cell of the cross, in OpenGL's order.
constexpr std::array<int, 12> faces{-1, 2, -1, -1, 1, 4, 0, 5, -1, 3, -1, -1};

struct Kind {
    GLenum target;
    const char *sampler, *texel;
};
// `texel` is what a shader reads at a place of the plane that has one.
constexpr std::array<Kind, 4> kinds_of_texture{
    {{GL_TEXTURE_1D, "sampler1D", "return texelFetch(texels, p.x, level);"},
     {GL_TEXTURE_2D, "sampler2D", "return texelFetch(texels, ivec2(p.x, size.y - 1 - p.y), level);"},
     {GL_TEXTURE_3D, "sampler3D", "return texelFetch(texels, ivec3(p.x, size.y - 1 - p.y, slice), level);"},
     // Cube maps have no texelFetch. The nearest texel to its own middle is the texel.
     {GL_TEXTURE_CUBE_MAP, "samplerCube",
      "int face = face_of(p), n = size.x / 4;\n"
      "    vec2 at = (vec2(p - p / n * n) + .5) / float(n) * 2. - 1.;\n"
      "    vec3 way = face == 0 ? vec3(1., -at.y, -at.x) : face == 1 ? vec3(-1., -at.y, at.x)\n"
      "        : face == 2 ? vec3(at.x, 1., at.y) : face == 3 ? vec3(at.x, -1., -at.y)\n"
      "        : face == 4 ? vec3(at.x, -at.y, 1.) : vec3(-at, -1.);\n"
      "    return textureLod(texels, way, float(level));"}}};

std::size_t kind_of(GLenum target) {
    const auto same = [&](const Kind& kind) { return kind.target == target; };
    return static_cast<std::size_t>(std::find_if(kinds_of_texture.begin(), kinds_of_texture.end(), same) -
                                    kinds_of_texture.begin());
}

// `size` is that of the plane.
constexpr const char* shader_head = R"(
uniform ivec2 size;
uniform int level, slice, channel, stride;
uniform vec2 corner, range;
uniform float zoom;
uniform bool exact, light, flags;
uniform vec3 marks[4];
out vec4 color;

int face_of(ivec2 p) {
    ivec2 cell = p / (size.x / 4);
    return cell.y == 1 ? (cell.x == 0 ? 1 : cell.x == 1 ? 4 : cell.x == 2 ? 0 : 5)
                       : cell.x != 1 ? -1 : cell.y == 0 ? 2 : 3;
}
)";

// Compilers may take it for granted that there are neither NaN nor infinities, so flag_of looks at the bits.
constexpr const char* shader_body = R"(
int flag_of(float value) {
    uint bits = floatBitsToUint(value) & 0x7fffffffu;
    return bits > 0x7f800000u ? 4 : bits == 0x7f800000u ? 3 : value < 0. ? 2 : value > 1. ? 1 : 0;
}
int worst_of(vec4 value) {
    int alpha = flag_of(value.a);
    return max(max(flag_of(value.r), flag_of(value.g)), max(flag_of(value.b), alpha < 3 ? 0 : alpha));
}
float encoded(float value) { return value <= .0031308 ? 12.92 * value : 1.055 * pow(value, 1. / 2.4) - .055; }

void main() {
    vec2 at = corner + (gl_FragCoord.xy - (zoom < 1. ? .5 : 0.)) / zoom;
    ivec2 first = ivec2(floor(at));
    if (exact) {
        color = inside(first) ? texel(first) : vec4(0.);
        return;
    }
    int side = max(1, int(ceil(1. / zoom - 1e-3))), worst = 0, count = 0;
    vec4 sum = vec4(0.);
    for (int y = 0; y < side; y += stride)
        for (int x = 0; x < side; x += stride) {
            if (!inside(first + ivec2(x, y))) continue;
            vec4 value = texel(first + ivec2(x, y));
            worst = max(worst, worst_of(value));
            sum += value;
            ++count;
        }
    if (count == 0) {
        color = vec4(0.);
        return;
    }
    vec4 mean = sum / float(count);
    vec3 shown = channel < 0 ? mean.rgb : vec3(channel == 0 ? mean.r : channel == 1 ? mean.g
                                             : channel == 2 ? mean.b : mean.a);
    shown = clamp((shown - range.x) / (range.y - range.x), 0., 1.);
    if (light) shown = vec3(encoded(shown.r), encoded(shown.g), encoded(shown.b));
    if (flags) shown = vec3(.43 * dot(shown, vec3(.2126, .7152, .0722)));
    if (worst >= 3 || (flags && worst > 0)) shown = marks[worst - 1];
    color = vec4(shown, 1.);
}
)";

std::string shader_of(const Kind& kind) {
    std::string text = std::string("precision highp int;\nprecision highp ") + kind.sampler + ";\nuniform " +
                       kind.sampler + " texels;\n";
    text += shader_head;
    text += "bool inside(ivec2 p) {\n    return p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y";
    if (kind.target == GL_TEXTURE_CUBE_MAP) text += " && face_of(p) >= 0";
    text += ";\n}\nvec4 texel(ivec2 p) {\n    ";
    text += kind.texel;
    return text + "\n}\n" + shader_body;
}

Sampler nearest_of_any_level() {
    GLuint id = 0;
    glGenSamplers(1, &id);
    Sampler sampler(id);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return sampler;
}

void set(GLuint program, const Plane& plane, const TexelLook& look, bool exact) {
    const auto at = [program](const char* name) { return glGetUniformLocation(program, name); };
    const auto f = [](double value) { return static_cast<float>(value); };
    glUniform1i(at("texels"), 0);
    glUniform2i(at("size"), plane.width(), plane.height());
    glUniform1i(at("level"), plane.level);
    glUniform1i(at("slice"), plane.slice);
    glUniform1i(at("channel"), look.channel);
    // What is marked must not be missed; a mean of 64 texels is good enough.
    glUniform1i(at("stride"), look.flags ? 1 : std::max(1, static_cast<int>(std::ceil(1 / look.zoom / 8))));
    glUniform2f(at("corner"), f(look.left), f(look.top));
    glUniform2f(at("range"), look.low, look.high);
    glUniform1f(at("zoom"), f(look.zoom));
    glUniform1i(at("exact"), exact);
    glUniform1i(at("light"), look.light);
    glUniform1i(at("flags"), look.flags);
    glUniform3fv(at("marks"), static_cast<GLsizei>(look.marks.size()), look.marks[0].data());
}

}  // namespace

int Plane::along(std::size_t axis) const { return std::max(1, size[axis] >> level); }

int Plane::width() const { return along(0) * (target == GL_TEXTURE_CUBE_MAP ? 4 : 1); }

int Plane::height() const {
    if (target == GL_TEXTURE_CUBE_MAP) return 3 * along(0);
    return target == GL_TEXTURE_1D ? std::max(1, along(0) / 8) : along(1);
}

std::optional<std::array<int, 3>> Plane::texel(int x, int y) const {
    if (x < 0 || y < 0 || x >= width() || y >= height()) return std::nullopt;
    if (target == GL_TEXTURE_1D) return std::array{x, 0, 0};
    if (target != GL_TEXTURE_CUBE_MAP) return std::array{x, height() - 1 - y, target == GL_TEXTURE_3D ? slice : 0};
    const int n = along(0), face = faces[static_cast<std::size_t>(y / n * 4 + x / n)];
    if (face < 0) return std::nullopt;
    return std::array{x % n, y % n, face};
}

std::array<double, 3> Plane::coordinates(const std::array<int, 3>& texel) const {
    std::array<double, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = (texel[axis] + .5) / along(axis);
    if (target != GL_TEXTURE_CUBE_MAP) return at;
    const double s = 2 * at[0] - 1, t = 2 * (texel[1] + .5) / along(0) - 1;
    const std::array<std::array<double, 3>, 6> directions{
        {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}}};
    return directions[static_cast<std::size_t>(texel[2])];
}

TexelViewer::TexelViewer(bool es)
    : es_(es), nothing_(make(glGenVertexArrays)), sampler_(nearest_of_any_level()), picture_(make(glGenTextures)) {}

bool TexelViewer::draw(const Plane& plane, const TexelLook& look, int width, int height) {
    if (width != width_ || height != height_) {
        glBindTexture(GL_TEXTURE_2D, picture_.get());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glBindTexture(GL_TEXTURE_2D, 0);
        if (!framebuffer_) framebuffer_ = Framebuffer(make(glGenFramebuffers));
        width_ = width;
        height_ = height;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_.get(), 0);
    return shoot(plane, look, false, width, height);
}

bool TexelViewer::read(const Plane& plane, int left, int top, int width, int height, std::vector<float>& rgba) {
    if (exact_.width < width || exact_.height < height) {
        exact_ = {};
        exact_ = make_target(width, height, 1, Pixels::rgba32f);
    }
    if (!exact_.framebuffer) return false;
    glBindFramebuffer(GL_FRAMEBUFFER, exact_.framebuffer.get());
    if (!shoot(plane, {.left = static_cast<double>(left), .top = static_cast<double>(top)}, true, width, height))
        return false;
    rgba.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, exact_.framebuffer.get());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
}

// Draws into the framebuffer that is bound. The first row of its pixels is the top one.
bool TexelViewer::shoot(const Plane& plane, const TexelLook& look, bool exact, int width, int height) {
    const std::size_t kind = kind_of(plane.target);
    if (kind == kinds) return false;
    Program& program = programs_[kind];
    if (!program) program = covering_program(es_, shader_of(kinds_of_texture[kind]));
    if (!program) return false;
    glViewport(0, 0, width, height);
    for (const GLenum test : {GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(test);
    if (is_desktop()) beyond::polygon_mode(GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glUseProgram(program.get());
    set(program.get(), plane, look, exact);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(plane.target, plane.texture);
    glBindSampler(0, sampler_.get());
    glBindVertexArray(nothing_.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindSampler(0, 0);
    glBindTexture(plane.target, 0);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    settle();
    return true;
}

}  // namespace snell::gl
