// When the GPU came by: moments of its own clock, by timestamp queries.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "src/gl/handle.h"

namespace snell::gl {

inline void delete_query(GLuint id) { glDeleteQueries(1, &id); }
using Query = Handle<delete_query>;

class Marks {
public:
    // The context has such a clock. Whether it is right is another matter: those of software renderers are not.
    bool available();
    // After all that was asked for so far. Costs nothing but the call.
    void mark();
    std::size_t count() const { return used_; }
    // Milliseconds from each mark to the next one: one fewer than there are marks. Waits for the GPU, and forgets them.
    std::span<const double> take();

private:
    enum class Known { not_yet, yes, no };
    Known known_ = Known::not_yet;
    std::vector<Query> queries_;
    std::size_t used_ = 0;
    std::vector<double> times_;
};

}  // namespace snell::gl
