#include "src/gl/marks.h"

namespace snell::gl {

bool Marks::available() {
    if (known_ == Known::not_yet) {
        GLint bits = 0;
        if (epoxy_is_desktop_gl() && epoxy_gl_version() >= 33) glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
        known_ = bits > 0 ? Known::yes : Known::no;
    }
    return known_ == Known::yes;
}

void Marks::mark() {
    if (used_ == queries_.size()) queries_.emplace_back(make(glGenQueries));
    glQueryCounter(queries_[used_++].get(), GL_TIMESTAMP);
}

std::span<const double> Marks::take() {
    times_.clear();
    GLuint64 before = 0;
    for (std::size_t i = 0; i < used_; ++i) {
        GLuint64 now = 0;
        glGetQueryObjectui64v(queries_[i].get(), GL_QUERY_RESULT, &now);
        if (i > 0) times_.push_back(now > before ? static_cast<double>(now - before) / 1e6 : 0);
        before = now;
    }
    used_ = 0;
    return times_;
}

}  // namespace snell::gl
