#include "tests/gui/x11.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <memory>

namespace snell::test {

namespace {

struct Closer {
    void operator()(Display* display) const { XCloseDisplay(display); }
};

class Source {
public:
    Source(Display* display, std::string uris) : display_(display), uris_(std::move(uris)) {
        window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
    }

    ::Window target() const {
        ::Window root = 0, parent = 0, *children = nullptr, found = 0;
        unsigned count = 0;
        if (!XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count)) return 0;
        for (unsigned i = 0; i < count; ++i)
            if (takes_drops(children[i])) found = children[i];
        XFree(children);
        return found;
    }

    bool drop_on(::Window target) {
        XWindowAttributes place;
        XGetWindowAttributes(display_, target, &place);
        const long at = (place.x + place.width / 2) << 16 | (place.y + place.height / 2);
        send(target, "XdndEnter", 5L << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
        send(target, "XdndPosition", 0, at, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
        if (!answer("XdndStatus")) return false;
        send(target, "XdndDrop", 0, CurrentTime, 0, 0);
        return answer("XdndFinished");
    }

private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    bool takes_drops(::Window window) const {
        Atom type = 0;
        int format = 0;
        unsigned long count = 0, rest = 0;
        unsigned char* data = nullptr;
        XGetWindowProperty(display_, window, atom("XdndAware"), 0, 1, False, AnyPropertyType, &type, &format, &count,
                           &rest, &data);
        if (data) XFree(data);
        XWindowAttributes attributes;
        return count > 0 && XGetWindowAttributes(display_, window, &attributes) && attributes.map_state == IsViewable;
    }

    void send(::Window target, const char* what, long a, long b, long c, long d) const {
        XEvent event{};
        event.xclient = {.type = ClientMessage,
                         .serial = 0,
                         .send_event = True,
                         .display = display_,
                         .window = target,
                         .message_type = atom(what),
                         .format = 32,
                         .data = {}};
        const long words[5] = {static_cast<long>(window_), a, b, c, d};
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = words[i];
        XSendEvent(display_, target, False, NoEventMask, &event);
        XFlush(display_);
    }

    // Hands the files over when asked for them.
    bool answer(const char* what) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(30);
        while (std::chrono::steady_clock::now() < until) {
            if (XPending(display_) == 0) {
                usleep(2000);
                continue;
            }
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == ClientMessage && event.xclient.message_type == atom(what)) return true;
            if (event.type != SelectionRequest) continue;
            const XSelectionRequestEvent& asked = event.xselectionrequest;
            XChangeProperty(display_, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                            reinterpret_cast<const unsigned char*>(uris_.data()), static_cast<int>(uris_.size()));
            XEvent done{};
            done.xselection = {.type = SelectionNotify,
                               .serial = 0,
                               .send_event = True,
                               .display = display_,
                               .requestor = asked.requestor,
                               .selection = asked.selection,
                               .target = asked.target,
                               .property = asked.property,
                               .time = asked.time};
            XSendEvent(display_, asked.requestor, False, NoEventMask, &done);
            XFlush(display_);
        }
        return false;
    }

    Display* display_;
    std::string uris_;
    ::Window window_ = 0;
};

}  // namespace

bool drop_files(const std::string& display, const std::vector<std::string>& paths) {
    const std::unique_ptr<Display, Closer> connection(XOpenDisplay(display.c_str()));
    if (!connection) return false;
    std::string uris;
    for (const std::string& path : paths) uris += "file://" + path + "\r\n";
    Source source(connection.get(), uris);
    const ::Window target = source.target();
    return target != 0 && source.drop_on(target);
}

namespace {

// Of the display; they may go at any time.
std::vector<::Window> windows_of(Display* display) {
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    ::Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    if (!XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count)) return {};
    const std::vector<::Window> windows(children, children + count);
    if (children) XFree(children);
    return windows;
}

}  // namespace

bool tell_windows(const std::string& display, const std::function<void()>& tell) {
    const std::unique_ptr<Display, Closer> connection(XOpenDisplay(display.c_str()));
    if (!connection) return false;
    const Atom told = XInternAtom(connection.get(), "SNELL_TOLD", False);
    XSync(connection.get(), False);
    tell();
    for (const ::Window window : windows_of(connection.get()))
        XChangeProperty(connection.get(), window, told, XA_INTEGER, 8, PropModeReplace, nullptr, 0);
    XSync(connection.get(), False);
    return true;
}

bool close_windows(const std::string& display) {
    const std::unique_ptr<Display, Closer> connection(XOpenDisplay(display.c_str()));
    if (!connection) return false;
    const Atom close = XInternAtom(connection.get(), "WM_DELETE_WINDOW", False);
    bool found = false;
    for (const ::Window window : windows_of(connection.get())) {
        Atom* protocols = nullptr;
        int protocol_count = 0;
        if (!XGetWMProtocols(connection.get(), window, &protocols, &protocol_count)) continue;
        XFree(protocols);
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = window;
        event.xclient.message_type = XInternAtom(connection.get(), "WM_PROTOCOLS", False);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(close);
        XSendEvent(connection.get(), window, False, NoEventMask, &event);
        found = true;
    }
    XSync(connection.get(), False);
    return found;
}

Picture screen_of(const std::string& display) {
    const std::unique_ptr<Display, Closer> connection(XOpenDisplay(display.c_str()));
    if (!connection) return {};
    const int number = DefaultScreen(connection.get());
    Picture picture{DisplayWidth(connection.get(), number), DisplayHeight(connection.get(), number), {}};
    XImage* image =
        XGetImage(connection.get(), DefaultRootWindow(connection.get()), 0, 0, static_cast<unsigned>(picture.width),
                  static_cast<unsigned>(picture.height), AllPlanes, ZPixmap);
    // Xvfb's screens of 24 bits: blue, green, red and a byte of nothing.
    if (!image || image->bits_per_pixel != 32 || image->red_mask != 0xFF0000 || image->byte_order != LSBFirst)
        return {};
    // By pointers: tests look at millions of pixels, and are compiled without optimisation.
    picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    unsigned char* to = picture.rgb.data();
    for (int y = 0; y < picture.height; ++y) {
        const char* from = image->data + y * image->bytes_per_line;
        for (int x = 0; x < picture.width; ++x, from += 4, to += 3) {
            to[0] = static_cast<unsigned char>(from[2]);
            to[1] = static_cast<unsigned char>(from[1]);
            to[2] = static_cast<unsigned char>(from[0]);
        }
    }
    XDestroyImage(image);
    return picture;
}

bool renew(const std::string& display) {
    const std::unique_ptr<Display, Closer> connection(XOpenDisplay(display.c_str()));
    if (!connection) return false;
    const ::Window root = DefaultRootWindow(connection.get());
    const int number = DefaultScreen(connection.get());
    ::Window on = 0, child = 0;
    int x = 0, y = 0;
    unsigned held = 0;
    std::array<char, 32> keys{};
    XQueryPointer(connection.get(), root, &on, &child, &x, &y, &x, &y, &held);
    XQueryKeymap(connection.get(), keys.data());
    if (held != 0 || keys != std::array<char, 32>{} || !windows_of(connection.get()).empty()) return false;
    XDeleteProperty(connection.get(), root, XA_RESOURCE_MANAGER);
    XWarpPointer(connection.get(), None, root, 0, 0, 0, 0, DisplayWidth(connection.get(), number) / 2,
                 DisplayHeight(connection.get(), number) / 2);
    XSync(connection.get(), False);
    return true;
}

bool set_dots_per_inch(const std::string& display, int dots) {
    const std::unique_ptr<Display, Closer> connection(XOpenDisplay(display.c_str()));
    if (!connection) return false;
    const std::string resources = "Xft.dpi:\t" + std::to_string(dots) + "\n";
    XChangeProperty(connection.get(), DefaultRootWindow(connection.get()), XA_RESOURCE_MANAGER, XA_STRING, 8,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(resources.data()),
                    static_cast<int>(resources.size()));
    // Else the display would forget it with its last client.
    XSetCloseDownMode(connection.get(), RetainPermanent);
    XSync(connection.get(), False);
    return true;
}

}  // namespace snell::test
