// A window with an OpenGL core context: events in, pictures out. It draws nothing itself.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;
struct GLFWcursor;

namespace snell {

// The keys that something listens to; text comes as Event::Kind::text.
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
    one,  // to nine, one after the other
    nine = one + 8,
    plus,  // by what is printed on them, wherever they are
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
    double x = 0, y = 0;  // move: window coordinates from the top left; wheel: steps
    MouseButton button = MouseButton::left;
    Key key = Key::other;
    bool down = false;  // button, key (repeats are further downs), focus
    char32_t text = 0;
    Modifiers modifiers = {};
};

enum class Cursor : std::uint8_t { arrow, text, hand, resize_horizontal, count_ };

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
    // Hidden at first, its context current: 4.5, else 4.1, else 3.3. Null, with the reason, where there is no
    // display or no such context.
    static std::unique_ptr<Window> make(const WindowRequest& request, std::string& error);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Shows it at this size, or at what the screen has room for.
    void show(PixelSize size);
    // Sleeps until something happens, at most `seconds`; 0 only looks.
    void wait(double seconds);
    // What happened since the last call, in order, instead of what `into` holds. Nothing is allocated where the same
    // vector is given each time.
    void take_events(std::vector<Event>& into);
    // The files that were dropped on it since the last call.
    std::vector<std::string> take_dropped();
    void present();

    bool closing() const;
    void close();
    PixelSize size() const;         // in the coordinates of events
    PixelSize framebuffer() const;  // in pixels; zero while minimised
    float content_scale() const;    // 1 at 96 dots per inch
    double now() const;             // seconds, monotonic

    void set_title(const std::string& title);
    void set_cursor(Cursor cursor);
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

private:
    explicit Window(GLFWwindow* handle);
    void listen();
    void push(Event event);
    static Window& of(GLFWwindow* handle);

    GLFWwindow* handle_;
    GLFWcursor* cursors_[static_cast<std::size_t>(Cursor::count_)] = {};
    Cursor cursor_ = Cursor::arrow;
    std::vector<Event> events_;
    std::vector<std::string> dropped_;
};

}  // namespace snell
