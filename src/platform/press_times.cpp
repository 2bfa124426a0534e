#include "src/platform/press_times.h"

#include <dlfcn.h>
#include <time.h>

#if __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>
#endif

#include <cmath>

namespace snell {

namespace {

constexpr double round_of_clock = 4294967.296;  // seconds: 32 bits of milliseconds

// Servers on the same machine count the milliseconds of this clock.
double server_now() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::fmod(static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec), round_of_clock);
}

}  // namespace

#if __has_include(<X11/Xlib.h>)

PressTimes::PressTimes(void* display) : display_(display) {
    // GLFW has loaded it.
    void* const library = display ? dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD) : nullptr;
    if (!library) return;
    queued_ = reinterpret_cast<decltype(queued_)>(dlsym(library, "XEventsQueued"));
    check_ = reinterpret_cast<decltype(check_)>(dlsym(library, "XCheckIfEvent"));
}

void PressTimes::look() {
    if (!queued_ || !check_ || queued_(display_, QueuedAfterReading) == 0) return;
    XEvent unused;
    // It is asked for each event, and takes none.
    const auto seen = [](void*, void* waiting, char* times) {
        const XEvent& event = *static_cast<const XEvent*>(waiting);
        const bool press = event.type == ButtonPress || event.type == ButtonRelease;
        if (press && event.xbutton.button <= Button3)
            reinterpret_cast<std::deque<double>*>(times)->push_back(1e-3 * static_cast<double>(event.xbutton.time));
        return 0;
    };
    check_(display_, &unused, seen, reinterpret_cast<char*>(&waiting_));
}

#else

PressTimes::PressTimes(void* display) : display_(display) {}
void PressTimes::look() {}

#endif

std::optional<double> PressTimes::next() {
    if (waiting_.empty()) return std::nullopt;
    const double ago = server_now() - waiting_.front();
    waiting_.pop_front();
    return ago < -round_of_clock / 2 ? ago + round_of_clock : ago;
}

}  // namespace snell
