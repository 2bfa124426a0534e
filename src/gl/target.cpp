#include "src/gl/target.h"

#include <algorithm>
#include <cstring>

#include "src/gl/driver.h"
#include "src/gl/program.h"

namespace snell::gl {

namespace {

Renderbuffer make_renderbuffer(GLenum format, int width, int height, int samples) {
    Renderbuffer buffer(make(glGenRenderbuffers));
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.get());
    if (samples > 1)
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    else
        glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return buffer;
}

// The most samples that the context takes in a renderbuffer of the format. Some have fewer for floats than for bytes.
int most_samples(GLenum format) {
    GLint most = 1;
    if (is_desktop())
        glGetIntegerv(GL_MAX_SAMPLES, &most);
    else  // the largest comes first
        glGetInternalformativ(GL_RENDERBUFFER, format, GL_SAMPLES, 1, &most);
    return std::max(1, most);
}

// A target that is only read back needs no depth.
Target make_color_target(int width, int height, Pixels type) {
    Target target;
    target.width = width;
    target.height = height;
    target.color = make_renderbuffer(internal_format(type), width, height, 1);
    target.framebuffer = Framebuffer(make(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.color.get());
    return target;
}

// Reverses the order of the rows: GL's first row is the bottom one.
template <typename Component>
void flip(std::vector<Component>& rows, size_t row) {
    std::vector<Component> one(row);
    const size_t bytes = row * sizeof(Component);
    for (size_t top = 0, bottom = rows.size() / row; top + 1 < bottom; ++top) {
        Component *a = rows.data() + top * row, *b = rows.data() + --bottom * row;
        std::memcpy(one.data(), a, bytes);
        std::memcpy(a, b, bytes);
        std::memcpy(b, one.data(), bytes);
    }
}

template <typename Component>
std::vector<Component> read_rows(GLuint framebuffer, int width, int height, int samples, Pixels pixels, GLenum type,
                                 size_t row) {
    Target resolved;
    if (samples > 1) {
        settle();
        resolved = make_color_target(width, height, pixels);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved.framebuffer.get());
        const Encoded encoded(pixels == Pixels::srgb8);
        glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        framebuffer = resolved.framebuffer.get();
    }
    settle();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    std::vector<Component> rows(row * static_cast<size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, type, rows.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    flip(rows, row);
    return rows;
}

constexpr const char* add_fragment =
    "uniform sampler2D picture;\nuniform float weight;\nout vec4 color;\n"
    "void main() { color = weight * texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }\n";

}  // namespace

Target make_target(int width, int height, int samples, Pixels type) {
    Target target;
    target.width = width;
    target.height = height;
    target.samples =
        std::clamp(samples, 1, std::min(most_samples(internal_format(type)), most_samples(GL_DEPTH_COMPONENT24)));
    target.pixels = type;
    target.color = make_renderbuffer(internal_format(type), width, height, target.samples);
    target.depth = make_renderbuffer(GL_DEPTH_COMPONENT24, width, height, target.samples);
    target.framebuffer = Framebuffer(make(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.color.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.get());
    const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!complete) target.framebuffer.reset();
    return target;
}

TextureTarget make_texture_target(const std::vector<Attachment>& attachments, int width, int height) {
    TextureTarget target;
    target.depth = make_renderbuffer(GL_DEPTH_COMPONENT24, width, height, 1);
    target.framebuffer = Framebuffer(make(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
    std::vector<GLenum> buffers;
    for (const Attachment& attachment : attachments) {
        const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
        glFramebufferTexture2D(GL_FRAMEBUFFER, point, attachment.target, attachment.texture, 0);
        buffers.push_back(point);
    }
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.get());
    const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!complete) target.framebuffer.reset();
    return target;
}

void settle() {
    const GLsync drawn = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glWaitSync(drawn, 0, GL_TIMEOUT_IGNORED);
    glDeleteSync(drawn);
}

Encoded::Encoded(bool on) : on_(on && is_desktop()) {
    if (on_) glEnable(GL_FRAMEBUFFER_SRGB);
}

Encoded::~Encoded() {
    if (on_) glDisable(GL_FRAMEBUFFER_SRGB);
}

std::vector<std::byte> read_rgba8(GLuint framebuffer, int width, int height, int samples, Pixels pixels) {
    return read_rows<std::byte>(framebuffer, width, height, samples, pixels, GL_UNSIGNED_BYTE,
                                static_cast<size_t>(width) * 4);
}

std::vector<float> read_rgba32f(GLuint framebuffer, int width, int height, int samples) {
    return read_rows<float>(framebuffer, width, height, samples, Pixels::rgba32f, GL_FLOAT,
                            static_cast<size_t>(width) * 4);
}

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

bool Marks::available() {
    if (known_ == Known::not_yet) {
        GLint bits = 0;
        if (is_desktop() && version() >= 33) glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
        known_ = bits > 0 ? Known::yes : Known::no;
    }
    return known_ == Known::yes;
}

void Marks::mark() {
    if (used_ == queries_.size()) queries_.emplace_back(make(glGenQueries));
    beyond::mark_time(queries_[used_++].get());
}

std::span<const double> Marks::take() {
    times_.clear();
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < used_; ++i) {
        const std::uint64_t now = beyond::nanoseconds(queries_[i].get());
        if (i > 0) times_.push_back(now > before ? static_cast<double>(now - before) / 1e6 : 0);
        before = now;
    }
    used_ = 0;
    return times_;
}

}  // namespace snell::gl
