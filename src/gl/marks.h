// Times on the GPU's own clock, by timestamp queries.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "src/gl/handle.h"

namespace snell::gl {

class Marks {
public:
    // True if the context has timestamp queries. Software renderers have them, but their times are wrong.
    bool available();
    // Records the time at which the GPU has finished all commands issued so far. Does not wait.
    void mark();
    std::size_t count() const { return used_; }
    // Returns the milliseconds between consecutive marks, one value fewer than there are marks, and clears the marks.
    // Waits for the GPU.
    std::span<const double> take();

private:
    enum class Known { not_yet, yes, no };
    Known known_ = Known::not_yet;
    std::vector<Query> queries_;
    std::size_t used_ = 0;
    std::vector<double> times_;
};

}  // namespace snell::gl
