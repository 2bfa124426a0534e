// Pages that `snell web` makes, with a template of a few lines in the place of the browser's part.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace snell::test {

class WebTest : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        if (IsSkipped()) return;
        const std::string page =
            "<!DOCTYPE html><html><head><meta charset=\"utf-8\"><title>snell</title></head><body>\n"
            "<script type=\"application/json\" id=\"scene\">null</script>\n"
            "<script type=\"text/plain\" id=\"archive\"></script>\n";
        folder.write("web/page.html", page + "<script type=\"text/plain\" id=\"runtime\">UlVO</script>\n");
        folder.write("web/gallery.html", page + "<script src=\"runtime.js\"></script>\n");
        folder.write("web/runtime.js", "// runtime\n");
        folder.write("paint.frag",
                     "uniform float uRed;\nuniform sampler2D uWood;\n"
                     "void main() { gl_FragColor = vec4(uRed, texture2D(uWood, vec2(.5)).gb, 1.); }\n");
        folder.write("wood.bmp", bytes_of(SNELL_ROOT "/tests/cases/files/letter.bmp"));
    }
    Outcome web(const std::string& arguments, const std::string& environment = "") const {
        return snell("web " + arguments, "SNELL_WEB=web " + environment, folder.path());
    }
    // Unpacks the page by Python, and returns its data.
    nlohmann::json unpack(const std::string& page, const std::string& to) const {
        std::filesystem::create_directories(at(to));
        const Outcome outcome =
            run("python3 " SNELL_ROOT "/tests/commands/unpack_page.py '" + at(page) + "' '" + at(to) + "'");
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return nlohmann::json::parse(bytes_of(at(to + "/page.json")), nullptr, false);
    }
    // The picture of a scene, which must have neither errors nor warnings that `quiet` forbids.
    content::Image drawn(const std::string& scene, const std::string& arguments = "") const {
        const Outcome outcome =
            snell("render '" + scene + "' -o drawn.png --size 32x24 " + arguments, "", folder.path());
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return picture("drawn.png");
    }
    bool there(const std::string& name) const { return std::filesystem::exists(at(name)); }

    const std::string plain =
        "##OpenGL GLIB\nTexture2D 6 wood.bmp\nFragment paint.frag\nProgram Paint uRed <0. .25 1.> uWood 6\nQuadXY 0. "
        "1.\n";
};

}  // namespace snell::test
