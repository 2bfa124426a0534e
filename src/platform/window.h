// A window with an OpenGL core context. It collects input events and presents pictures, but draws nothing itself.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "src/platform/press_times.h"

struct GLFWwindow;
struct GLFWcursor;

namespace snell {

// The keys that snell uses. Typed characters come as Event::Kind::text.
enum class Key : std::uint8_t {
    other,
    tab,
    left,
    right,
    up,
    down,
    page_up,
    page_down,
    home,
    end,
    insert,
    delete_,
    backspace,
    space,
    enter,
    keypad_enter,
    escape,
    a,
    c,
    h,
    i,
    n,
    o,
    p,
    r,
    s,
    v,
    x,
    y,
    z,
    f1,
    f5,
    f10,
    f11,
    menu,
    one,  // the keys 1 to 9, consecutive
    nine = one + 8,
    plus,  // these three by the character printed on them, wherever the layout has them
    minus,
    zero,
    count_,
};

enum class MouseButton : std::uint8_t { left, right, middle };

struct Modifiers {
    bool shift = false, ctrl = false, alt = false;
};

struct Event {
    enum class Kind : std::uint8_t { move, leave, button, wheel, key, text, focus, resize, refresh };
    Kind kind = Kind::refresh;
    double x = 0, y = 0;  // move: window coordinates from the top left; wheel: number of steps
    MouseButton button = MouseButton::left;
    Key key = Key::other;
    bool down = false;  // for button, key (a repeat is another event with `down` set) and focus
    char32_t text = 0;
    Modifiers modifiers = {};
    // When it happened, in seconds of Window::now(): at the earliest, which is when events were looked for before if
    // nobody knows, and when it was seen.
    double since = 0, seen = 0;
    bool known = false;  // it happened at `since`
};

enum class Cursor : std::uint8_t { arrow, text, hand, resize_horizontal, resize_vertical, count_ };

struct WindowRequest {
    std::string title;
    bool debug = false;
};

struct PixelSize {
    int width = 0, height = 0;
    bool operator==(const PixelSize&) const = default;
};

class Window {
public:
    // Makes a hidden window and makes its context current: OpenGL 4.5, otherwise 4.1, otherwise 3.3. Returns null and
    // sets `error` if there is no display or no such context.
    static std::unique_ptr<Window> make(const WindowRequest& request, std::string& error);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Shows the window at this size, reduced to what fits the screen.
    void show(PixelSize size);
    // Fills the screen that the window's middle is on, or gives the window its size and place back.
    void set_full_screen(bool full);
    bool full_screen() const;
    // Sleeps until an event arrives, at most `seconds`. With 0 it polls and returns at once.
    void wait(double seconds);
    // Replaces the contents of `into` by the events since the last call, in order. Pass the same vector each time to
    // avoid allocations.
    void take_events(std::vector<Event>& into);
    // Returns the paths of the files dropped on the window since the last call.
    std::vector<std::string> take_dropped();
    // Swaps the buffers, which shows the picture.
    void present();

    bool closing() const;
    void close();
    PixelSize size() const;         // in the coordinates of events
    PixelSize framebuffer() const;  // in pixels; zero while minimised
    float content_scale() const;    // 1 at 96 dots per inch
    double now() const;             // in seconds, monotonic

    void set_title(const std::string& title);
    void set_cursor(Cursor cursor);
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

private:
    explicit Window(GLFWwindow* handle);
    void listen();
    void push(Event event);
    void date(Event& event);
    static Window& of(GLFWwindow* handle);

    GLFWwindow* handle_;
    GLFWcursor* cursors_[static_cast<std::size_t>(Cursor::count_)] = {};
    Cursor cursor_ = Cursor::arrow;
    int x_ = 0, y_ = 0;  // where the window was before it filled the screen
    PixelSize before_;
    std::vector<Event> events_;
    double looked_ = 0;  // when events were looked for last
    PressTimes presses_;
    std::vector<std::string> dropped_;
};

}  // namespace snell
