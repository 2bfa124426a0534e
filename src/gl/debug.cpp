#include "src/gl/debug.h"

#include <utility>

#include "src/gl/driver.h"

namespace snell::gl {

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
