// Pages that the window saves.
#include "tests/gui/desk.h"

namespace snell::test {
namespace {

using nlohmann::json;

class SavedPage : public Desk {
protected:
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        save("web/page.html",
             "<title>snell</title><script type=\"application/json\" id=\"scene\">null</script>"
             "<script type=\"text/plain\" id=\"archive\"></script>");
        setenv("SNELL_WEB", file("web").c_str(), 1);
        save("scene.glib", "Fragment paint.frag\nProgram Paint uRed <0. .25 1.>\nSphere 1\n");
        save("paint.frag", "uniform float uRed;\nvoid main() { gl_FragColor = vec4(uRed, .5, 0., 1.); }\n");
    }
    void TearDown() override {
        unsetenv("SNELL_WEB");
        Desk::TearDown();
    }
    void save_page() {
        choose("save", "page");
        click("save page save");
    }
    bool says(const std::string& text) {
        return wait([&](const json& s) { return s["notice"].get<std::string>().find(text) == 0; }, 20);
    }
};

TEST_F(SavedPage, HoldsTheCurrentValues) {
    open("scene.glib", {"--size", "640x480"});
    drag(on("Paint.uRed", .25), on("Paint.uRed", .75));
    drag({150, 200}, {220, 230});
    save_page();
    ASSERT_TRUE(says("saved scene.html: ")) << state()["notice"];
    EXPECT_NE(state()["notice"].get<std::string>().find("redistributes 2 files"), std::string::npos) << state();
    const std::string page = bytes("scene.html");
    const std::string begin = "id=\"scene\">";
    const std::size_t at = page.find(begin) + begin.size();
    const json data = json::parse(page.substr(at, page.find("</script>", at) - at));
    EXPECT_EQ(data["scene"], "scene.glib");
    const double red = state()["controls"]["Paint.uRed"][0];
    EXPECT_NE(red, .25);
    ASSERT_EQ(data["values"].size(), 1u);
    const std::string value = data["values"][0];
    EXPECT_EQ(value.rfind("Paint.uRed=", 0), 0u) << value;
    EXPECT_EQ(std::stod(value.substr(11)), red);
    EXPECT_EQ(data["view"], state()["view"]["text"]);
    EXPECT_NE(data["view"], "");
    // What is there is replaced only when asked.
    choose("save", "page");
    click("save page save");
    ASSERT_TRUE(wait([](const json& s) { return s["widgets"].contains("save page save"); }));
    click("save page save");
    ASSERT_TRUE(says("saved scene.html: ")) << state()["notice"];
    EXPECT_TRUE(alive());
}

TEST_F(SavedPage, WhatBrowsersLackIsSaid) {
    save("scene.glib", "Geometry g.geom\nFragment paint.frag\nProgram Paint uRed <0. .25 1.>\nSphere 1\n");
    save("g.geom",
         "#version 330 compatibility\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nvoid "
         "main() {\n"
         "for (int i = 0; i < 3; ++i) { gl_Position = gl_PositionIn[i]; EmitVertex(); }\n}\n");
    open("scene.glib", {"--size", "640x480"});
    save_page();
    ASSERT_TRUE(says("scene.html is not saved: ")) << state()["notice"];
    EXPECT_NE(state()["notice"].get<std::string>().find("geometry shaders"), std::string::npos) << state()["notice"];
    EXPECT_EQ(bytes("scene.html"), "");
    EXPECT_TRUE(alive());
}

}  // namespace
}  // namespace snell::test
