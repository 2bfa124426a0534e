// When mouse buttons were pressed, by the clock of the X server: GLFW does not tell, and after a slow picture it hands
// over presses of different moments at once.
#pragma once

#include <deque>
#include <optional>

namespace snell {

class PressTimes {
public:
    // `display` is an X11 Display, or null where there is none: then nothing is known.
    explicit PressTimes(void* display);
    // Looks at the events that wait; call it right before they are handled, and forget() after.
    void look();
    void forget() { waiting_.clear(); }
    // How many seconds ago the next of them, a press or a release, happened.
    std::optional<double> next();

private:
    void* display_;
    int (*queued_)(void* display, int mode) = nullptr;
    int (*check_)(void* display, void* event, int (*wanted)(void*, void*, char*), char* argument) = nullptr;
    std::deque<double> waiting_;  // in seconds of the server's clock
};

}  // namespace snell
