#include "src/gl/marks.h"

#include "src/gl/driver.h"

namespace snell::gl {

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
