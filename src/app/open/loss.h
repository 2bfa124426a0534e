// Detects that the driver has reset the context.
#pragma once

#include <string>
#include <utility>

namespace snell::app {

// Asked after each frame.
class LossWatch {
public:
    LossWatch() = default;
    // For tests, whose drivers never reset: `frame` is the number of frames after which the context counts as lost (0:
    // never). It also counts as lost if `file` exists, which is then removed.
    explicit LossWatch(int frame) : left_(frame) {}
    explicit LossWatch(std::string file) : file_(std::move(file)) {}
    // Call it once per frame.
    bool lost();

private:
    int left_ = 0;
    std::string file_;
};

// The message about a reset, and its help.
inline constexpr const char* loss_message = "the graphics driver was reset, and the OpenGL context is lost";
inline constexpr const char* loss_help = "check for a shader that does not end; it may also be a driver fault";

}  // namespace snell::app
