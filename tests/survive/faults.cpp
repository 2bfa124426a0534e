// What goes wrong outside of the scene: drivers, memory, files that change. Each has a message and a status.
#include <sys/resource.h>
#include <unistd.h>

#include "tests/cli/run.h"
#include "tests/harness/harness.h"
#include "tests/sanitized.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

class Faults : public testing::Test {
protected:
    void SetUp() override {
        std::string error;
        graphics_ = HeadlessContext::make({}, error) != nullptr;
        folder.write("s.frag", "uniform float uA;\nvoid main() { gl_FragColor = vec4(uA, 0., 0., 1.); }\n");
        folder.write("s.glib", "Fragment s.frag\nProgram P uA <0. .5 1.>\nSphere\n");
    }
    std::string at(const std::string& name) const { return folder.path(name); }
    std::string scene() const { return at("s.glib"); }

    Folder folder;
    bool graphics_ = false;
};

constexpr const char* no_bound = "sanitizers reserve more addresses than any bound leaves";

// A vendor that is not there: EGL itself is, and gives nothing.
constexpr const char* no_egl = "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent";

TEST_F(Faults, WithoutEglEveryCommandThatDrawsSaysSo) {
    for (const std::string& command : {"render --size 16x16 -o " + at("o.png"), std::string("explain"),
                                       std::string("accuracy"), "save -o " + at("o.glib")}) {
        const Outcome refused = snell(command + " " + scene(), no_egl);
        EXPECT_EQ(refused.status, 3) << command << '\n' << refused.output;
        EXPECT_TRUE(refused.says("no graphics") && refused.says("help:")) << refused.output;
    }
    EXPECT_EQ(snell("info", no_egl).status, 3);
    EXPECT_FALSE(fs::exists(at("o.png")) || fs::exists(at("o.glib")));
}

// The advice names what is missing, and nothing that is there.
TEST_F(Faults, WithoutGraphicsTheAdviceFitsTheCause) {
    if (sanitized) GTEST_SKIP() << "programs of sanitizers are linked with EGL";
    folder.write("libEGL.so.1", "");
    const Outcome none = snell("info", "LD_LIBRARY_PATH=" + at(""));
    EXPECT_EQ(none.status, 3) << none.output;
    EXPECT_TRUE(none.says("(Debian: libegl1)")) << none.output;
    if (!graphics_) GTEST_SKIP() << "no graphics";
    for (const std::string& hidden : {std::string(no_egl), std::string("LIBGL_DRIVERS_PATH=/nonexistent")}) {
        const Outcome refused = snell("info", hidden);
        EXPECT_EQ(refused.status, 3) << refused.output;
        EXPECT_TRUE(refused.says("LIBGL_DRIVERS_PATH")) << refused.output;
        EXPECT_FALSE(refused.says("(Debian:")) << refused.output;
    }
}

// What can be said without a driver is said.
TEST_F(Faults, WithoutEglScenesAreChecked) {
    const Outcome fine = snell("check " + scene(), no_egl);
    EXPECT_EQ(fine.status, 0) << fine.output;
    EXPECT_TRUE(fine.says("programs are not compiled")) << fine.output;
    folder.write("bad.glib", "Sphre\n");
    EXPECT_EQ(snell("check " + at("bad.glib"), no_egl).status, 1);
}

TEST_F(Faults, WithoutADisplayThereIsNoWindow) {
    for (const char* display : {"", "DISPLAY=:4711", "DISPLAY=nowhere:0", "DISPLAY=''"}) {
        const Outcome refused = snell(scene(), display);
        EXPECT_EQ(refused.status, 3) << display << '\n' << refused.output;
        EXPECT_TRUE(refused.says("no window") && refused.says("snell render")) << refused.output;
    }
}

TEST_F(Faults, AnOpenGlThatIsTooOldIsRefused) {
    if (!graphics_) GTEST_SKIP() << "no graphics";
    const Outcome old =
        snell("render --size 16x16 " + scene() + " -o " + at("o.png"),
              "MESA_GL_VERSION_OVERRIDE=3.0 MESA_GLSL_VERSION_OVERRIDE=130 MESA_GLES_VERSION_OVERRIDE=2.0");
    if (old.status == 0) GTEST_SKIP() << "this driver does not pretend to be an old one";
    EXPECT_EQ(old.status, 3) << old.output;
    EXPECT_TRUE(old.says("cannot create an OpenGL 3.3 core context") && old.says("help: snell needs")) << old.output;
}

// Machines of which OpenGL ES is all that there is.
TEST_F(Faults, OpenGlEsServesWhereThereIsNoOpenGl) {
    const std::string only = "MESA_GL_VERSION_OVERRIDE=2.1 MESA_GLES_VERSION_OVERRIDE=3.0";
    if (snell("info --context 3.3", only).status == 0) GTEST_SKIP() << "this driver does not pretend to be an old one";
    const Outcome info = snell("info", only);
    if (!graphics_) GTEST_SKIP() << "no graphics";
    EXPECT_EQ(info.status, 0) << info.output;
    EXPECT_TRUE(info.says("OpenGL ES 3.0")) << info.output;
    const Outcome drawn = snell("render --size 16x16 " + scene() + " -o " + at("es.png"), only);
    EXPECT_EQ(drawn.status, 0) << drawn.output;
}

// OpenGL 3.3 has geometry and no tessellation: what its programs use is found all the same. Mesa's own 3.3 is a 4.5.
TEST_F(Faults, OpenGl33DrawsGeometryAsOpenGl45Does) {
    const std::string old = "MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330";
    if (!snell("info", old).says("OpenGL     3.3")) GTEST_SKIP() << "this driver does not pretend to be an old one";
    std::string scenes;
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(SNELL_ROOT "/tests/cases")) {
        if (entry.path().extension() != ".glib") continue;
        if (bytes_of(entry.path()).find("\nGeometry ") == std::string::npos) continue;
        names.push_back(entry.path().stem().string());
        scenes += entry.path().string() + " ";
    }
    const Outcome best = snell("render -q --size 24x24 " + scenes + "-o '" + at("best-{stem}.png'"));
    const Outcome least = snell("render -q --size 24x24 " + scenes + "-o '" + at("least-{stem}.png'"), old);
    EXPECT_EQ(best.status, 0) << best.output;
    EXPECT_EQ(least.status, 0) << least.output;
    EXPECT_GE(names.size(), 3U);
    for (const std::string& name : names)
        EXPECT_EQ(bytes_of(at("best-" + name + ".png")), bytes_of(at("least-" + name + ".png"))) << name;
}

TEST_F(Faults, AStageThatOpenGlLacksIsDoneWithout) {
    const std::string old = "MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330";
    if (!snell("info", old).says("OpenGL     3.3")) GTEST_SKIP() << "this driver does not pretend to be an old one";
    const std::string render = "render --size 64x64 tests/cases/TessEvaluation.glib -o ";
    EXPECT_EQ(snell(render + at("new.png"), "").status, 0);
    const Outcome lacking = snell(render + at("old.png"), old);
    EXPECT_EQ(lacking.status, 0) << lacking.output;
    EXPECT_EQ(bytes_of(at("old.png")), bytes_of(at("new.png")));
}

TEST_F(Faults, ALostContextEndsTheRun) {
    if (!graphics_) GTEST_SKIP() << "no graphics";
    const std::string sweep = "sweep --size 16x16 --over uA=0,.5,1 " + scene() + " -o " + at("{uA}.png");
    const Outcome lost = snell(sweep + " --lose-after 2");
    EXPECT_EQ(lost.status, 5) << lost.output;
    EXPECT_TRUE(lost.says("[context-lost]") && lost.says("0.5.png")) << lost.output;
    EXPECT_TRUE(fs::exists(at("0.png"))) << "the picture before the loss is whole";
    EXPECT_FALSE(fs::exists(at("0.5.png")) || fs::exists(at("1.png"))) << "what was drawn afterwards is nothing";
    EXPECT_EQ(snell(sweep).status, 0);
}

// The limits would allow it; the machine does not.
TEST_F(Faults, WithoutMemoryItSaysSo) {
    if (sanitized) GTEST_SKIP() << no_bound;
    folder.write("large.glib", "Sphere 1 3000 3000\nSphere 2 3000 3000\nTorus .2 1 3000 3000\n");
    const Outcome out =
        run("ulimit -v 600000; timeout 60 env -u DISPLAY -u WAYLAND_DISPLAY " SNELL_BIN "/snell render --size 16x16 " +
            at("large.glib") + " -o " + at("o.png"));
    if (out.says("LLVM") || out.status == 3) GTEST_SKIP() << "the driver needs more itself: " << out.output;
    EXPECT_EQ(out.status, 1) << out.output;
    EXPECT_TRUE(out.says("out of memory") && out.says("help:")) << out.output;
    EXPECT_FALSE(fs::exists(at("o.png")));
}

// The driver itself ends by signals where it gets no memory: in its threads, in LLVM, and where it forgets to look.
TEST_F(Faults, WithLittleAddressSpaceItSaysSo) {
    if (sanitized) GTEST_SKIP() << no_bound;
    const std::string scene = "scenes/light/glass/glass.glib";
    // All commands end in one place: one of them is tried with every amount, the others with some.
    const std::pair<std::string, int> tried[]{
        {"render --size 16x16 " + scene + " -o " + at("o.png"), 40000},
        {"check " + scene, 240000},
        {"explain --no-time --size 16x16 " + scene, 240000},
        {"accuracy --no-time --no-found --budget 1 --size 16x16 tests/cases/Ladder.glib", 240000}};
    for (const auto& [command, step] : tried) {
        for (int kilobytes = 180000; kilobytes <= 660000; kilobytes += step) {
            const Outcome out = run("ulimit -c 0; ulimit -v " + std::to_string(kilobytes) +
                                    "; env -u DISPLAY -u WAYLAND_DISPLAY " SNELL_BIN "/snell " + command);
            EXPECT_TRUE(out.status == 0 || (out.status == 1 && !out.output.empty()))
                << kilobytes << ' ' << command << out.output;
        }
    }
}

// A shell's limit would earn a correct submission nothing.
TEST_F(Faults, WithLittleAddressSpaceNobodyIsGraded) {
    if (sanitized) GTEST_SKIP() << no_bound;
    const std::string lesson = "docs/teaching/01-colour/";
    const std::string grade = "/snell grade " + lesson + "rubric.toml " + lesson + "submissions -o " + at("report");
    const Outcome out = run("ulimit -v 200000; " SNELL_BIN + grade);
    EXPECT_EQ(out.status, 1);
    EXPECT_TRUE(out.says("'ulimit -v') leaves 0.2 GB")) << out.output;
    EXPECT_FALSE(fs::exists(at("report/students")));
    const Outcome check = run("ulimit -v 200000; " SNELL_BIN "/snell check scenes/light/glass/glass.glib");
    EXPECT_EQ(check.status, 1);
    EXPECT_TRUE(check.says("[out-of-memory]")) << check.output;
}

// What llvmpipe leaves out, and does not tell, is told where it is known.
TEST_F(Faults, LoopsThatTheDriverEndsAreSaid) {
    const auto loops = [&](const std::string& rounds) {
        folder.write("l.frag", "uniform float uA;\nvoid main() {\n  float n = 0.;\n  for (int i = 0; i < " + rounds +
                                   "; ++i) n += uA;\n  gl_FragColor = vec4(n > 69999. ? 1. : 0., 0., 0., 1.);\n}\n");
        folder.write("l.glib", "Fragment l.frag\nProgram P uA 1.\nQuadXY 0. 9.\n");
        return snell("check " + at("l.glib")).says("[many-rounds]");
    };
    EXPECT_FALSE(loops("60000"));
    EXPECT_FALSE(snell("render --size 2x2 " + at("l.glib") + " -o " + at("o.png")).says("many-rounds"));
    EXPECT_TRUE(loops("70000"));
    const Outcome drawn = snell("render --size 2x2 " + at("l.glib") + " -o " + at("o.png"));
    const bool llvmpipe = snell("info").says("llvmpipe");
    EXPECT_EQ(drawn.says("[many-rounds]"), llvmpipe) << drawn.output;
    EXPECT_EQ(drawn.says("l.frag:4:"), llvmpipe) << drawn.output;
    EXPECT_EQ(drawn.status, graphics_ ? 0 : 3);
}

// No slider is moved: what counts is what the command line gives, not how far the slider goes.
TEST_F(Faults, LoopsAreCountedWithTheValuesThatAreSet) {
    if (!snell("info").says("llvmpipe")) GTEST_SKIP() << "another driver ends no loops";
    folder.write("l.frag",
                 "uniform int uN;\nvoid main() {\n  float n = 0.;\n  int i = 0;\n"
                 "  while (i < uN) { n += float(i); ++i; }\n  gl_FragColor = vec4(n);\n}\n");
    folder.write("l.glib", "Fragment l.frag\nProgram P uN <1 10 100000>\nQuadXY 0. 9.\n");
    const auto drawn = [&](const std::string& command, const std::string& options) {
        const Outcome outcome = snell(command + " --size 2x2 " + at("l.glib") + " " + options);
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return outcome.says("[many-rounds]");
    };
    EXPECT_TRUE(snell("check " + at("l.glib")).says("[many-rounds]")) << "the slider goes there";
    const std::string one = "-o " + at("o.png"), all = "-o " + at("{uN}.png");
    EXPECT_FALSE(drawn("render", one));
    EXPECT_TRUE(drawn("render", one + " --set uN=70000"));
    EXPECT_TRUE(drawn("render", one + " --set P.uN=70000"));
    EXPECT_FALSE(drawn("render", one + " --set uN=60000"));
    EXPECT_FALSE(drawn("render", one + " --quiet --set uN=70000"));
    EXPECT_FALSE(drawn("sweep", all + " --over uN=1,100"));
    EXPECT_TRUE(drawn("sweep", all + " --over uN=1,70000,100"));
    folder.write("l.glib", "Fragment l.frag\nProgram P\nQuadXY 0. 9.\n");
    EXPECT_TRUE(drawn("render", one + " --set uN=70000")) << "a uniform that the scene leaves alone";
    EXPECT_FALSE(drawn("render", one));
}

TEST_F(Faults, WithoutGraphicsMemoryItSaysSo) {
    if (sanitized) GTEST_SKIP() << no_bound;
    folder.write("t.frag", "uniform sampler2D uT;\nvoid main() { gl_FragColor = texture2D(uT, vec2(.5)); }\n");
    folder.write("t.glib", "Texture2D 5 16000 16000\nFragment t.frag\nProgram P uT 5\nQuadXY 0. 9.\n");
    const std::string draw = "/snell render --size 16x16 " + at("t.glib") + " -o " + at("o.png");
    const Outcome out = run("ulimit -v 900000; timeout 60 env -u DISPLAY -u WAYLAND_DISPLAY " SNELL_BIN + draw);
    if (out.status == 0) GTEST_SKIP() << "the driver found the memory";
    EXPECT_EQ(out.status, 1) << out.output;
    EXPECT_TRUE(out.says("out-of-graphics-memory") || out.says("[out-of-memory]")) << out.output;
}

// A file that is rewritten, cut short and removed while it is read: nothing crashes, and the status tells.
TEST_F(Faults, FilesThatChangeAndVanish) {
    if (!graphics_) GTEST_SKIP() << "no graphics";
    const std::string picture = bmp(64, 64, std::vector<std::array<int, 3>>(4096, {200, 90, 30}));
    folder.write("t.frag", "uniform sampler2D uT;\nvoid main() { gl_FragColor = texture2D(uT, vec2(.5)); }\n");
    folder.write("v.glib", "Texture2D 5 t.bmp\nFragment t.frag\nProgram P uT 5\nObj o.obj\nInclude i.glib\n");
    std::atomic<bool> done = false;
    std::thread meddler([&] {
        for (int i = 0; !done; ++i) {
            folder.write("t.bmp", i % 3 ? picture : picture.substr(0, 3000));
            folder.write("o.obj", i % 2 ? "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" : "v 0 0 0\nv 1 0");
            folder.write("i.glib", i % 2 ? "Sphere\nBox\n" : "Sph");
            for (const char* name : {"t.bmp", "o.obj", "i.glib"})
                if (i % 4 == 0) fs::remove(at(name));
            usleep(300);
        }
    });
    for (int i = 0; i < 12; ++i) {
        const Outcome outcome = snell("render --size 16x16 " + at("v.glib") + " -o " + at("o.png"));
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 1) << outcome.status << '\n' << outcome.output;
        EXPECT_EQ(outcome.status == 1, outcome.says("error: ")) << outcome.output;
    }
    done = true;
    meddler.join();
}

}  // namespace
}  // namespace snell::test
