#include "src/platform/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>

namespace snell {

namespace {

// GLFW is loaded when the first window opens: at every start, its libraries would cost 2 ms.
void* library() {
    static void* const loaded = dlopen("libglfw.so.3", RTLD_NOW | RTLD_LOCAL);
    return loaded;
}

template <class Function>
Function found(const char* name) {
    return reinterpret_cast<Function>(dlsym(library(), name));
}

// GLFW(Init) is its function glfwInit.
#define GLFW(name) found<decltype(&glfw##name)>("glfw" #name)

Key key_of(int code) {
    static constexpr std::array<std::pair<int, Key>, 34> table{{
        {GLFW_KEY_TAB, Key::tab},
        {GLFW_KEY_LEFT, Key::left},
        {GLFW_KEY_RIGHT, Key::right},
        {GLFW_KEY_UP, Key::up},
        {GLFW_KEY_DOWN, Key::down},
        {GLFW_KEY_PAGE_UP, Key::page_up},
        {GLFW_KEY_PAGE_DOWN, Key::page_down},
        {GLFW_KEY_HOME, Key::home},
        {GLFW_KEY_END, Key::end},
        {GLFW_KEY_INSERT, Key::insert},
        {GLFW_KEY_DELETE, Key::delete_},
        {GLFW_KEY_BACKSPACE, Key::backspace},
        {GLFW_KEY_SPACE, Key::space},
        {GLFW_KEY_ENTER, Key::enter},
        {GLFW_KEY_KP_ENTER, Key::keypad_enter},
        {GLFW_KEY_ESCAPE, Key::escape},
        {GLFW_KEY_A, Key::a},
        {GLFW_KEY_C, Key::c},
        {GLFW_KEY_H, Key::h},
        {GLFW_KEY_I, Key::i},
        {GLFW_KEY_N, Key::n},
        {GLFW_KEY_O, Key::o},
        {GLFW_KEY_P, Key::p},
        {GLFW_KEY_R, Key::r},
        {GLFW_KEY_S, Key::s},
        {GLFW_KEY_V, Key::v},
        {GLFW_KEY_X, Key::x},
        {GLFW_KEY_Y, Key::y},
        {GLFW_KEY_Z, Key::z},
        {GLFW_KEY_F1, Key::f1},
        {GLFW_KEY_F5, Key::f5},
        {GLFW_KEY_F10, Key::f10},
        {GLFW_KEY_F11, Key::f11},
        {GLFW_KEY_MENU, Key::menu},
    }};
    if (code >= GLFW_KEY_1 && code <= GLFW_KEY_9)
        return static_cast<Key>(static_cast<int>(Key::one) + code - GLFW_KEY_1);
    for (const auto& [glfw, key] : table)
        if (glfw == code) return key;
    return Key::other;
}

// The keyboard layout decides where plus and minus are.
Key key_of(int code, int scan_code) {
    if (code == GLFW_KEY_KP_ADD) return Key::plus;
    if (code == GLFW_KEY_KP_SUBTRACT) return Key::minus;
    if (code == GLFW_KEY_0 || code == GLFW_KEY_KP_0) return Key::zero;
    if (const Key key = key_of(code); key != Key::other) return key;
    const char* printed = GLFW(GetKeyName)(code, scan_code);
    const std::string_view name = printed ? printed : "";
    return name == "+" || name == "=" ? Key::plus : name == "-" ? Key::minus : Key::other;
}

Modifiers modifiers_of(int bits) {
    return {(bits & GLFW_MOD_SHIFT) != 0, (bits & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0,
            (bits & GLFW_MOD_ALT) != 0};
}

std::string last_error(std::string_view otherwise) {
    const char* text = nullptr;
    GLFW(GetError)(&text);
    return text ? text : std::string(otherwise);
}

// The monitor that has the point, otherwise the primary one; null if there is none.
GLFWmonitor* monitor_at(int x, int y) {
    int count = 0;
    GLFWmonitor** monitors = GLFW(GetMonitors)(&count);
    for (int i = 0; i < count; ++i) {
        int left = 0, top = 0;
        GLFW(GetMonitorPos)(monitors[i], &left, &top);
        const GLFWvidmode* mode = GLFW(GetVideoMode)(monitors[i]);
        if (mode && x >= left && y >= top && x < left + mode->width && y < top + mode->height) return monitors[i];
    }
    return GLFW(GetPrimaryMonitor)();
}

// Null on other platforms than X11.
void* display() {
    const auto get = found<void* (*)()>("glfwGetX11Display");
    return get ? get() : nullptr;
}

GLFWwindow* make_window(const WindowRequest& request) {
    constexpr std::array<std::pair<int, int>, 3> versions{{{4, 5}, {4, 1}, {3, 3}}};
    for (const auto& [major, minor] : versions) {
        GLFW(DefaultWindowHints)();
        // Asks the driver to report resets if it can; otherwise the window would stay black for ever.
        GLFW(WindowHint)(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
        GLFW(WindowHint)(GLFW_CONTEXT_VERSION_MAJOR, major);
        GLFW(WindowHint)(GLFW_CONTEXT_VERSION_MINOR, minor);
        GLFW(WindowHint)(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
#ifdef __APPLE__
        // macOS has no other core context. Elsewhere a forward-compatible one would refuse lines wider than a pixel,
        // which headless contexts draw.
        GLFW(WindowHint)(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
#endif
        GLFW(WindowHint)(GLFW_OPENGL_DEBUG_CONTEXT, request.debug ? GLFW_TRUE : GLFW_FALSE);
        GLFW(WindowHint)(GLFW_VISIBLE, GLFW_FALSE);
        GLFW(WindowHintString)(GLFW_X11_CLASS_NAME, "snell");  // by which desktops find snell.desktop and its icon
        GLFW(WindowHintString)(GLFW_X11_INSTANCE_NAME, "snell");
        GLFW(WindowHint)(GLFW_AUTO_ICONIFY, GLFW_FALSE);  // a click on another screen leaves the projector's picture
        if (GLFWwindow* handle = GLFW(CreateWindow)(1280, 800, request.title.c_str(), nullptr, nullptr)) return handle;
    }
    return nullptr;
}

}  // namespace

std::unique_ptr<Window> Window::make(const WindowRequest& request, std::string& error) {
    if (!library() || !GLFW(GetError)) {
        error = "GLFW 3.3 cannot be loaded (Debian: libglfw3)";
        return nullptr;
    }
    if (!GLFW(Init)()) {
        error = last_error("cannot open a display; set DISPLAY or WAYLAND_DISPLAY, or use 'snell render'");
        return nullptr;
    }
    GLFWwindow* handle = make_window(request);
    if (!handle) {
        error = last_error("the driver cannot create an OpenGL 3.3 core context");
        GLFW(Terminate)();
        return nullptr;
    }
    return std::unique_ptr<Window>(new Window(handle));
}

Window::Window(GLFWwindow* handle) : handle_(handle), looked_(now()), presses_(display()) {
    GLFW(SetWindowUserPointer)(handle_, this);
    GLFW(MakeContextCurrent)(handle_);
    GLFW(SwapInterval)(1);
    cursors_[static_cast<std::size_t>(Cursor::text)] = GLFW(CreateStandardCursor)(GLFW_IBEAM_CURSOR);
    cursors_[static_cast<std::size_t>(Cursor::hand)] = GLFW(CreateStandardCursor)(GLFW_HAND_CURSOR);
    cursors_[static_cast<std::size_t>(Cursor::resize_horizontal)] = GLFW(CreateStandardCursor)(GLFW_HRESIZE_CURSOR);
    cursors_[static_cast<std::size_t>(Cursor::resize_vertical)] = GLFW(CreateStandardCursor)(GLFW_VRESIZE_CURSOR);
    listen();
}

Window::~Window() {
    for (GLFWcursor* cursor : cursors_)
        if (cursor) GLFW(DestroyCursor)(cursor);
    GLFW(DestroyWindow)(handle_);
    GLFW(Terminate)();
}

Window& Window::of(GLFWwindow* handle) { return *static_cast<Window*>(GLFW(GetWindowUserPointer)(handle)); }

void Window::push(Event event) {
    event.seen = now();
    event.since = std::min(looked_, event.seen);
    if (event.kind == Event::Kind::button) date(event);
    // Only the last of several consecutive moves matters, and hundreds can gather during a slow frame.
    if (event.kind == Event::Kind::move && !events_.empty() && events_.back().kind == Event::Kind::move)
        events_.back() = event;
    else
        events_.push_back(event);
}

// The clock of a server on another machine tells something else.
void Window::date(Event& event) {
    constexpr double unsure = .02;  // seconds
    const double at = event.seen - presses_.next().value_or(1e9);
    event.known = at > event.since - unsure && at < event.seen + unsure;
    if (event.known) event.since = std::clamp(at, event.since, event.seen);
}

void Window::listen() {
    using Kind = Event::Kind;
    GLFW(SetCursorPosCallback)
    (handle_, [](GLFWwindow* w, double x, double y) { of(w).push({.kind = Kind::move, .x = x, .y = y}); });
    GLFW(SetCursorEnterCallback)
    (handle_, [](GLFWwindow* w, int entered) {
        if (!entered) of(w).push({.kind = Kind::leave});
    });
    GLFW(SetMouseButtonCallback)
    (handle_, [](GLFWwindow* w, int button, int action, int bits) {
        if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
        of(w).push({.kind = Kind::button,
                    .button = static_cast<MouseButton>(button),
                    .down = action == GLFW_PRESS,
                    .modifiers = modifiers_of(bits)});
    });
    GLFW(SetScrollCallback)
    (handle_, [](GLFWwindow* w, double x, double y) { of(w).push({.kind = Kind::wheel, .x = x, .y = y}); });
    GLFW(SetKeyCallback)
    (handle_, [](GLFWwindow* w, int code, int scan_code, int action, int bits) {
        // X11 reports the modifiers from before the event, so the pressed key itself is added.
        const bool down = action != GLFW_RELEASE;
        Modifiers modifiers = modifiers_of(bits);
        if (code == GLFW_KEY_LEFT_SHIFT || code == GLFW_KEY_RIGHT_SHIFT) modifiers.shift = down;
        if (code == GLFW_KEY_LEFT_CONTROL || code == GLFW_KEY_RIGHT_CONTROL) modifiers.ctrl = down;
        if (code == GLFW_KEY_LEFT_ALT || code == GLFW_KEY_RIGHT_ALT) modifiers.alt = down;
        of(w).push({.kind = Kind::key, .key = key_of(code, scan_code), .down = down, .modifiers = modifiers});
    });
    GLFW(SetCharCallback)
    (handle_,
     [](GLFWwindow* w, unsigned code) { of(w).push({.kind = Kind::text, .text = static_cast<char32_t>(code)}); });
    GLFW(SetDropCallback)
    (handle_, [](GLFWwindow* w, int count, const char** paths) {
        of(w).dropped_.insert(of(w).dropped_.end(), paths, paths + count);
        of(w).push({.kind = Kind::refresh});
    });
    GLFW(SetWindowFocusCallback)
    (handle_, [](GLFWwindow* w, int focused) { of(w).push({.kind = Kind::focus, .down = focused == GLFW_TRUE}); });
    GLFW(SetFramebufferSizeCallback)(handle_, [](GLFWwindow* w, int, int) { of(w).push({.kind = Kind::resize}); });
    GLFW(SetWindowContentScaleCallback)
    (handle_, [](GLFWwindow* w, float, float) { of(w).push({.kind = Kind::resize}); });
    GLFW(SetWindowIconifyCallback)(handle_, [](GLFWwindow* w, int) { of(w).push({.kind = Kind::refresh}); });
    GLFW(SetWindowRefreshCallback)(handle_, [](GLFWwindow* w) { of(w).push({.kind = Kind::refresh}); });
}

void Window::show(PixelSize size) {
    int x = 0, y = 0, width = 0, height = 0;
    if (GLFWmonitor* monitor = GLFW(GetPrimaryMonitor)()) GLFW(GetMonitorWorkarea)(monitor, &x, &y, &width, &height);
    if (width > 0 && height > 0) {
        size.width = std::min(size.width, width);
        size.height = std::min(size.height, height);
    }
    GLFW(SetWindowSize)(handle_, size.width, size.height);
    GLFW(ShowWindow)(handle_);
}

void Window::set_full_screen(bool full) {
    if (full == full_screen()) return;
    if (!full) return GLFW(SetWindowMonitor)(handle_, nullptr, x_, y_, before_.width, before_.height, GLFW_DONT_CARE);
    before_ = size();
    GLFW(GetWindowPos)(handle_, &x_, &y_);
    GLFWmonitor* monitor = monitor_at(x_ + before_.width / 2, y_ + before_.height / 2);
    if (const GLFWvidmode* mode = monitor ? GLFW(GetVideoMode)(monitor) : nullptr)
        GLFW(SetWindowMonitor)(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool Window::full_screen() const { return GLFW(GetWindowMonitor)(handle_) != nullptr; }

void Window::wait(double seconds) {
    presses_.look();
    GLFW(PollEvents)();
    presses_.forget();
    if (seconds > 0 && events_.empty() && !closing()) {
        looked_ = std::numeric_limits<double>::infinity();  // what comes now is seen at once
        GLFW(WaitEventsTimeout)(seconds);
    }
    looked_ = now();
}

void Window::take_events(std::vector<Event>& into) {
    into.clear();
    std::swap(into, events_);
}

std::vector<std::string> Window::take_dropped() { return std::exchange(dropped_, {}); }

void Window::present() { GLFW(SwapBuffers)(handle_); }

bool Window::closing() const { return GLFW(WindowShouldClose)(handle_); }
void Window::close() { GLFW(SetWindowShouldClose)(handle_, GLFW_TRUE); }

PixelSize Window::size() const {
    PixelSize size;
    GLFW(GetWindowSize)(handle_, &size.width, &size.height);
    return size;
}

PixelSize Window::framebuffer() const {
    PixelSize size;
    if (GLFW(GetWindowAttrib)(handle_, GLFW_ICONIFIED)) return size;
    GLFW(GetFramebufferSize)(handle_, &size.width, &size.height);
    return size;
}

float Window::content_scale() const {
    float x = 1, y = 1;
    GLFW(GetWindowContentScale)(handle_, &x, &y);
    return x > 0 ? x : 1;
}

double Window::now() const { return GLFW(GetTime)(); }

void Window::set_title(const std::string& title) { GLFW(SetWindowTitle)(handle_, title.c_str()); }

void Window::set_cursor(Cursor cursor) {
    if (cursor == cursor_) return;
    cursor_ = cursor;
    GLFW(SetCursor)(handle_, cursors_[static_cast<std::size_t>(cursor)]);
}

std::string Window::clipboard() const {
    const char* text = GLFW(GetClipboardString)(handle_);
    return text ? text : "";
}

void Window::set_clipboard(const std::string& text) { GLFW(SetClipboardString)(handle_, text.c_str()); }

}  // namespace snell
