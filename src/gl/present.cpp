#include "src/gl/present.h"

#include <algorithm>

#include "src/gl/driver.h"
#include "src/gl/program.h"

namespace snell::gl {

namespace {

// The scissor test is disabled because it clips blits and clears too.
void clip(int x, int y, int width, int height, int first) {
    if (first <= 0) return glDisable(GL_SCISSOR_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(x + first, y, std::max(0, width - first), height);
}

void copy(const Target& from, GLuint to, int x, int y, int width, int height, int first = 0) {
    const bool enlarged = width != from.width || height != from.height;
    clip(x, y, width, height, first);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, from.width, from.height, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT,
                      enlarged ? GL_LINEAR : GL_NEAREST);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

constexpr const char* encode_fragment =
    "uniform sampler2D light;\nuniform vec4 place;\nout vec4 color;\n"
    "void main() {\n    vec4 c = texture(light, (gl_FragCoord.xy - place.xy) / place.zw);\n"
    "    color = vec4(mix(12.92 * c.rgb, 1.055 * pow(c.rgb, vec3(1. / 2.4)) - .055, greaterThan(c.rgb, "
    "vec3(.0031308))), c.a);\n}\n";

}  // namespace

bool Canvas::resize(int width, int height, int samples, Pixels pixels) {
    if (drawn_.framebuffer && drawn_.width == width && drawn_.height == height && wanted_ == samples &&
        pixels_ == pixels)
        return true;
    // The old targets are freed first: memory may be too small for both.
    drawn_ = {};
    resolved_ = {};
    light_ = {};
    wanted_ = samples;
    pixels_ = pixels;
    drawn_ = make_target(width, height, samples, pixels);
    // A multisampled blit requires equal formats, and the default framebuffer's may differ: resolve into a target of
    // our own.
    if (pixels == Pixels::srgb8 && !is_desktop()) return make_light(width, height) && drawn_.framebuffer;
    if (drawn_.samples > 1) resolved_ = make_target(width, height, 1, pixels);
    return drawn_.framebuffer && (drawn_.samples <= 1 || resolved_.framebuffer);
}

bool Canvas::make_light(int width, int height) {
    light_ = make_texture(GL_TEXTURE_2D, {Pixels::srgb8, width, height}, {Sampling::Mode::linear, 1, true});
    TextureTarget target = make_texture_target({{light_.get(), GL_TEXTURE_2D}}, width, height);
    resolved_ = {std::move(target.framebuffer), {}, std::move(target.depth), width, height, 1, Pixels::srgb8};
    if (!encode_) encode_ = covering_program(true, encode_fragment);
    if (!nothing_) nothing_ = VertexArray(make(glGenVertexArrays));
    return resolved_.framebuffer && encode_;
}

void Canvas::encode(int x, int y, int width, int height, GLuint to, int first) const {
    const auto f = [](int value) { return static_cast<float>(value); };
    glBindFramebuffer(GL_FRAMEBUFFER, to);
    glViewport(x, y, width, height);
    for (const GLenum test : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(test);
    clip(x, y, width, height, first);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glUseProgram(encode_.get());
    glUniform1i(glGetUniformLocation(encode_.get(), "light"), 0);
    glUniform4f(glGetUniformLocation(encode_.get(), "place"), f(x), f(y), f(width), f(height));
    draw_covering(light_.get(), nothing_.get());
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Canvas::resolve() {
    if (!resolved_.framebuffer) return;
    settle();
    const Encoded encoded(pixels_ == Pixels::srgb8);
    copy(drawn_, resolved_.framebuffer.get(), 0, 0, drawn_.width, drawn_.height);
}

std::vector<std::byte> Canvas::read() const {
    const Target& shown = resolved_.framebuffer ? resolved_ : drawn_;
    if (!shown.framebuffer) return {};
    return read_rgba8(shown.framebuffer.get(), shown.width, shown.height, 1, pixels_);
}

void Canvas::show(int x, int y, int width, int height, GLuint to, int first) const {
    const Target& shown = resolved_.framebuffer ? resolved_ : drawn_;
    if (light_)
        encode(x, y, width, height, to, first);
    else if (shown.framebuffer)
        copy(shown, to, x, y, width, height, first);
}

void clear_window(int width, int height, float red, float green, float blue) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glViewport(0, 0, width, height);
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void finish() {
    settle();
    glFinish();
}

void Still::set(int width, int height, std::span<const std::byte> rgba) {
    if (rgba.size() < static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4) return;
    width_ = width;
    height_ = height;
    texture_ =
        make_texture(GL_TEXTURE_2D, {Pixels::rgba8, width, height, 1, rgba.data()}, {Sampling::Mode::nearest, 1, true});
    framebuffer_ = Framebuffer(make(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.get(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Still::show(int x, int y, int enlarged, int first) const {
    if (!framebuffer_) return;
    clip(x, y, width_ * enlarged, height_ * enlarged, first);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    // The blit flips the picture: its first row is the top one, but GL's first row is the bottom one.
    glBlitFramebuffer(0, 0, width_, height_, x, y + height_ * enlarged, x + width_ * enlarged, y, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace snell::gl
