#include "src/gl/exact_target.h"

#include <cstdint>
#include <string>

#include "src/gl/beyond.h"
#include "src/gl/driver.h"
#include "src/gl/program.h"
#include "src/gl/texture.h"

namespace snell::gl {

namespace {

constexpr const char* add_fragment =
    "uniform sampler2D picture;\nuniform float weight;\nout vec4 color;\n"
    "void main() { color = weight * texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }\n";

}  // namespace

ExactTarget::ExactTarget(int width, int height, int multisample, bool es) : width_(width), height_(height) {
    const Texels empty{Pixels::rgba32f, width, height, 1, nullptr};
    const Sampling nearest{Sampling::Mode::nearest, 1, true};
    drawn_ = make_texture(GL_TEXTURE_2D, empty, nearest);
    drawn_target_ = make_texture_target({{drawn_.get(), GL_TEXTURE_2D}}, width, height);
    if (multisample > 1) multisampled_ = make_target(width, height, multisample, Pixels::rgba32f);
    if (!drawn_target_.framebuffer || (multisample > 1 && !multisampled_.framebuffer)) return;
    program_ = covering_program(es, add_fragment);
    if (!program_) return;
    nothing_ = VertexArray(make(glGenVertexArrays));
    sum_ = make_texture(GL_TEXTURE_2D, empty, nearest);
    sum_framebuffer_ = Framebuffer(make(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, sum_framebuffer_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sum_.get(), 0);
    const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!complete) sum_framebuffer_.reset();
}

unsigned ExactTarget::framebuffer() const {
    return multisampled_.framebuffer ? multisampled_.framebuffer.get() : drawn_target_.framebuffer.get();
}

void ExactTarget::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, sum_framebuffer_.get());
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    settle();
}

void ExactTarget::resolve() const {
    settle();
    if (!multisampled_.framebuffer) return;
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_.framebuffer.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, drawn_target_.framebuffer.get());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void ExactTarget::add(float weight) const {
    resolve();
    glBindFramebuffer(GL_FRAMEBUFFER, sum_framebuffer_.get());
    glViewport(0, 0, width_, height_);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    if (is_desktop()) beyond::polygon_mode(GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram(program_.get());
    glUniform1f(glGetUniformLocation(program_.get(), "weight"), weight);
    glUniform1i(glGetUniformLocation(program_.get(), "picture"), 0);
    draw_covering(drawn_.get(), nothing_.get());
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    settle();
}

std::vector<float> ExactTarget::read(bool sum) const {
    return read_rgba32f(sum ? sum_framebuffer_.get() : drawn_target_.framebuffer.get(), width_, height_, 1);
}

TimerQuery::TimerQuery() {
    if (!is_desktop() || version() < 33) return;
    GLint bits = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits > 0) query_ = Query(make(glGenQueries));
}

void TimerQuery::begin() const { glBeginQuery(GL_TIME_ELAPSED, query_.get()); }

double TimerQuery::end() const {
    glEndQuery(GL_TIME_ELAPSED);
    return static_cast<double>(beyond::nanoseconds(query_.get())) / 1e6;
}

}  // namespace snell::gl
