// The report as a browser shows it: nothing wrong is said, plots are there and nothing sticks out, on light and dark
// screens, at the width of a phone and of a large screen. Skipped where chromium is not installed.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/harness/harness.h"

namespace snell::test {
namespace {

// Says what a reader would see to the page around it, which has it as its title: dumped, it can be read here.
constexpr const char* probe = R"(<script>addEventListener('load', () => {
const plots = [...document.querySelectorAll('svg.plot')];
const light = c => c.match(/\d+/g).slice(0, 3).reduce((a, b) => a + +b, 0) / 765;
const style = getComputedStyle(document.body);
const fits = plots.every(p => p.getBoundingClientRect().width >= 600 && p.querySelectorAll('text').length >= 8);
const loaded = [...document.images].every(i => i.naturalWidth > 0);
const text = Math.min(...plots.map(p => 12 * p.getBoundingClientRect().width / 640));
parent.postMessage(`probe width=${innerWidth} over=${document.documentElement.scrollWidth - innerWidth} ` +
  `plots=${plots.length} fits=${fits} images=${document.images.length} loaded=${loaded} text=${text} ` +
  `back=${light(style.backgroundColor)} ink=${light(style.color)} end`, '*');
})</script>)";

class Browser : public GlTest {
protected:
    std::string text(const std::string& name) const { return bytes_of(folder.path(name)); }
    // The page after it was loaded; what went wrong on it is in err.txt.
    std::string dumped(int width, bool dark) {
        // A window is never narrower than 500 pixels, a frame in it may be.
        folder.write("frame.html",
                     "<!doctype html><style>:root{color-scheme:light dark}</style><script>addEventListener('message', "
                     "e => document.title = e.data)</script><iframe style='border:0;height:900px;width:" +
                         std::to_string(width) + "px' src='probe.html'></iframe>");
        const std::string command =
            "timeout 60 chromium --headless --no-sandbox --disable-gpu --no-first-run --user-data-dir=" +
            folder.path("profile") +
            " --window-size=1700,1000 --enable-logging=stderr --blink-settings=preferredColorScheme=" +
            (dark ? "0" : "1") + " --dump-dom file://" + folder.path("frame.html") + " > " + folder.path("dom.txt") +
            " 2> " + folder.path("err.txt");
        EXPECT_EQ(std::system(command.c_str()), 0) << text("err.txt");
        return text("dom.txt");
    }
    static double value(const std::string& page, const std::string& key) {
        const std::size_t at = page.find(key + "=", page.find("<title>probe"));
        return at == std::string::npos ? -1 : std::atof(page.c_str() + at + key.size() + 1);
    }
};

TEST_F(Browser, ShowsTheReportOnAnyScreen) {
    if (std::system("command -v chromium > /dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
    folder.write("flat.vert", "#version 330 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n");
    folder.write("flat.frag",
                 "#version 330 compatibility\nvoid main() {\n gl_FragColor = vec4(.5);\n#if SHADE == SHADE_rough\n "
                 "gl_FragColor = vec4(.25);\n#endif\n}\n");
    const std::string scene = folder.write(
        "scene.glib", "Ladder SHADE rough <exact>\nVertex flat.vert\nFragment flat.frag\nProgram Flat\nQuadXY 0 .5\n");
    const std::string command = SNELL_BIN "/snell accuracy " + scene +
                                " --size 64x64 --reps 7 --budget 40 --ladders SHADE --knobs samples -o " +
                                folder.path("report.html") + " > " + folder.path("out.txt");
    ASSERT_EQ(std::system(command.c_str()), 0);
    // Its policy lets no other script run; styles and pictures stay under it.
    std::string report = text("report.html");
    const std::string_view policy = "default-src 'none';";
    report.replace(report.find(policy), policy.size(), "default-src 'none'; script-src 'unsafe-inline';");
    folder.write("probe.html", report + probe);
    // Places do not depend on colors, and colors not on the width.
    for (const auto& [width, dark] : {std::pair(400, true), std::pair(1600, false)}) {
        SCOPED_TRACE(std::to_string(width) + (dark ? " dark" : " light"));
        const std::string page = dumped(width, dark);
        ASSERT_NE(page.find("<title>probe"), std::string::npos);
        EXPECT_EQ(text("err.txt").find("CONSOLE"), std::string::npos) << text("err.txt");
        EXPECT_EQ(value(page, "width"), width);
        EXPECT_LE(value(page, "over"), 0) << "the page is wider than the screen";
        EXPECT_EQ(value(page, "plots"), 2);
        EXPECT_NE(page.find("fits=true"), std::string::npos);
        EXPECT_EQ(value(page, "images"), 2 * (2 + 6));
        EXPECT_NE(page.find("loaded=true"), std::string::npos);
        EXPECT_GE(value(page, "text"), 10) << "letters of the plot, in pixels";
        const double back = value(page, "back"), ink = value(page, "ink");
        EXPECT_GT(dark ? ink : back, .85);
        EXPECT_LT(dark ? back : ink, .15);
    }
}

}  // namespace
}  // namespace snell::test
