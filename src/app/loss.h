// A context that its driver took away.
#pragma once

#include <string>
#include <utility>

namespace snell::app {

// What is asked after each frame.
class LossWatch {
public:
    LossWatch() = default;
    // For tests, which have no driver that resets: lost from that frame on, if it is not 0; lost when that file is
    // there, which is then removed.
    explicit LossWatch(int frame) : left_(frame) {}
    explicit LossWatch(std::string file) : file_(std::move(file)) {}
    // Call it once a frame.
    bool lost();

private:
    int left_ = 0;
    std::string file_;
};

// "the graphics driver …", and what may be done.
inline constexpr const char* loss_message = "the graphics driver reset itself and took the OpenGL context away";
inline constexpr const char* loss_help = "a shader may not end, or the driver has a fault";

}  // namespace snell::app
