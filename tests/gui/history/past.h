// Two scenes that share their shaders, and what a user does to them.
#pragma once

#include <string>

#include "tests/gui/desk.h"
#include "tests/gui/x11.h"

namespace snell::test {

class Past : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        for (const char* name : {"one.glib", "two.glib"}) save(name, scene("uRed"));
        save("paint.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
        save("paint.frag", fragment("uRed"));
    }

    // Most tests need no window of their own.
    void share(const std::string& scene) {
        Desk::share(scene);
        if (!HasFatalFailure()) shown_ = state()["revision"];
    }
    // The scene was read again so often since the test showed it.
    bool read(const nlohmann::json& state, int times) const { return state["revision"] == shown_ + times; }

    static std::string scene(const std::string& name, const std::string& end = "QuadXY 0. 1. 2 2\n") {
        return "Perspective 50\nLookAt 0 0 4  0 0 0  0 1 0\nBackground 0 0 0\nVertex paint.vert\nFragment paint.frag\n"
               "Ladder TINT <dark> light\nProgram Paint " +
               name + " <0. .2 1.> uGreen <0. .4 1.>\n" + end;
    }

    static std::string fragment(const std::string& name) {
        return "#version 330 compatibility\nuniform float " + name +
               ", uGreen;\n"
               "void main() { gl_FragColor = vec4(" +
               name + ", uGreen, float(TINT) * .5, 1.); }\n";
    }
    double red() const { return state()["controls"]["Paint.uRed"][0]; }
    std::string notice() const { return state()["notice"]; }
    std::string view() const { return state()["view"]["text"]; }
    void press(const std::string& key) const {
        user("key " + key);
        settle();
    }
    // By the menu of its name.
    void animate(const std::string& slider) const {
        click(slider + ".name", .5, 3);
        click(slider + ".animate", .1);
        user("key Escape");
    }
    void slide(double to) const { drag(on("Paint.uRed", .2), on("Paint.uRed", to)); }
    // Opens the field of the slider at .9 of its track, and leaves it as it is.
    void double_click(const std::string& slider) const {
        const auto [x, y] = on(slider, .9);
        user("mousemove " + std::to_string(x) + " " + std::to_string(y) +
             " click --repeat 2 --delay 60 1 sleep .1 key Escape");
    }
    // The uniform has this name in the shader and in the scene.
    void rename_to(const std::string& name) {
        save("paint.frag", fragment(name));
        save("one.glib", scene(name));
        ASSERT_TRUE(
            wait([&](const nlohmann::json& s) { return s["controls"].contains("Paint." + name) && s["errors"] == 0; }));
        settle();
    }
    void turn() const { drag({200, 300}, {260, 320}); }
    void show(const std::string& name) {
        ASSERT_TRUE(drop_files(display_, {file(name)}));
        ASSERT_TRUE(wait([&](const nlohmann::json& s) { return s["file"] == file(name); }));
        settle();
    }
    std::string title() const {
        shell("DISPLAY=" + display_ + " xdotool search --onlyvisible --name snell getwindowname >title");
        return bytes("title");
    }
    // Waits until what is kept is written.
    bool kept() const {
        return wait([&](const nlohmann::json&) { return std::filesystem::exists(file("state/snell/scenes")); });
    }

private:
    int shown_ = 0;
};

}  // namespace snell::test
