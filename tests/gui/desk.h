// A display of its own, a window on it, and a user with a mouse and an editor.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <array>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/scratch.h"

namespace snell::test {

struct Pixel {
    int red = 0, green = 0, blue = 0;
    bool operator==(const Pixel&) const = default;
};

// Rows from the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;
    Pixel at(double x, double y) const;
};

// Skips the test, with a message, where Xvfb, xdotool or ImageMagick is missing.
class Desk : public ::testing::Test {
protected:
    explicit Desk(std::string screen = "1024x768x24") : screen_(std::move(screen)) {}
    void SetUp() override;
    void TearDown() override;
    static void TearDownTestSuite() { end_shared(); }

    // Writes a file into the test's own folder, as an editor would: a new file renamed over the old one, or in
    // place.
    void save(const std::string& name, const std::string& text, bool in_place = false);
    std::string file(const std::string& name) const { return folder_.path(name); }
    std::string bytes(const std::string& name) const;
    // In the test's folder, with the program in the path; the exit status.
    int shell(const std::string& command) const;

    // Opens a window on `scene` and waits for its first picture; on a folder or "", for its panels. Of `more`, "--size"
    // with "" leaves the size to the window.
    void open(const std::string& scene, const std::vector<std::string>& more = {});
    // Shows it in the window that the last test of the suite left, if that had shared one with the same options and
    // nothing failed in it, or opens one. The scene is as new, since this folder is; what belongs to the window (its
    // size, its looks, panels, whether time stands) is as it was left.
    void share(const std::string& scene, const std::vector<std::string>& more = {});
    // Ends the window, once what it remembers is written, so that another can be opened.
    void end_window();
    // The exit status of the program with these arguments.
    int run(const std::vector<std::string>& arguments, const std::string& display);
    bool alive() const;
    // So many bytes more than the window has, and no more.
    void limit_memory(std::size_t more) const;

    nlohmann::json state() const;
    // How often the scene's document was drawn, but to look for NaN, which is done when nothing happens for a while.
    static int frames_of(const nlohmann::json& state);
    // False: not within that time.
    bool wait(const std::function<bool(const nlohmann::json&)>& holds, double seconds = 30) const;
    // Until the window has handled all input and all saved files, and shows what they lead to. What comes by itself
    // later, as tooltips, measurements and programs for values, is waited for by what it changes.
    void settle() const;

    // Waits until it has drawn nothing for a second, and its state is the same; false: it never does.
    bool idle() const;

    // xdotool's words.
    void user(const std::string& words) const;
    // The middle of a widget, once it is there, or a fraction of its width.
    std::array<int, 2> on(const std::string& widget, double fraction = .5) const;
    void click(std::array<int, 2> at, int button = 1) const;
    void click(const std::string& widget, double fraction = .5, int button = 1) const;
    // An entry of one of the toolbar's menus: "open", "save" or "view".
    void choose(const std::string& menu, const std::string& item) const;
    // Instead of the whole text that stands there, with Enter unless it is unconfirmed. A number's field opens with two
    // clicks.
    enum class Field { text, number, unconfirmed };
    void type(const std::string& widget, const std::string& text, Field field) const;
    void drag(std::array<int, 2> from, std::array<int, 2> to, int button = 1) const;
    Picture look() const;
    // Of a file of any format.
    Picture read_picture(const std::string& name) const;
    // What the screen shows, as NAME.png in the screens_folder(): for people, and for docs/guide.md.
    void keep(const std::string& name) const;
    // In the middle of the scene's area, moved by so many pixels.
    Pixel scene_pixel(int right = 0, int down = 0) const;

    std::string display_;

private:
    void connect();
    void begin(const std::string& scene, std::vector<std::string> more);
    bool running() const;
    static void end_shared();

    std::string screen_;
    Scratch folder_;
    pid_t server_ = 0, window_ = 0;
    bool shares_ = false;
};

}  // namespace snell::test
