// The program itself, as a user or a grader calls it.
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace snell::test {

namespace {

class CommandLine : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        if (IsSkipped()) return;
        folder.write("plain.vert", plain_vertex);
        folder.write("mix.frag",
                     "uniform float uEta, uMix;\nvoid main() { gl_FragColor = vec4(uMix, uEta / 10., 0., 1.); }\n");
        folder.write("good.glib",
                     "##OpenGL GLIB\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment mix.frag\n"
                     "Program Mix uEta <.1 1.1 5.> uMix <0. 0. 1.>\nQuadXY\n");
        folder.write("bad.glib", "Ortho -1 1 -1 1\nSphree 1\nColor 1 0 0\nQuadXY\n");
        folder.write("broken.frag", "void main() { gl_FragColor = vec4(1.) }\n");
        folder.write("broken.glib", "Vertex plain.vert\nFragment broken.frag\nProgram Broken\nQuadXY\n");
    }
};

TEST_F(CommandLine, RendersWithoutADisplay) {
    const Outcome outcome = snell("render " + at("good.glib") + " -o " + at("o.png") + " --size 40x30");
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "");
    const content::Image image = picture("o.png");
    EXPECT_EQ(image.width, 40);
    EXPECT_EQ(image.height, 30);
}

TEST_F(CommandLine, ALadderTakesTheNamedRung) {
    folder.write("kind.frag",
                 "void main() {\n#if KIND == KIND_red\ngl_FragColor = vec4(1., 0., 0., 1.);\n#elif N == N_8\n"
                 "gl_FragColor = vec4(0., 0., 1., 1.);\n#else\nthis is no GLSL\n#endif\n}\n");
    folder.write("ladder.glib",
                 "Ladder KIND <red> other\nLadder N 4 8\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment kind.frag\n"
                 "Program P\nQuadXY\n");
    const std::string command = "render " + at("ladder.glib") + " -o " + at("o.png") + " --size 8x8";
    const auto first_pixel = [&] {
        const content::Image image = picture("o.png");
        return image.pixels.size() < 3 ? 0 : static_cast<int>(image.pixels[0]);
    };
    EXPECT_EQ(snell(command).status, 0);
    EXPECT_EQ(first_pixel(), 255);
    const Outcome other = snell(command + " --ladder KIND=other --ladder N=8");
    EXPECT_EQ(other.status, 0) << other.output;
    EXPECT_EQ(first_pixel(), 0);
    EXPECT_EQ(snell(command + " --ladder KIND=other").status, 1) << "that rung does not compile";

    const Outcome unknown = snell(command + " --ladder KINDS=other");
    EXPECT_EQ(unknown.status, 1);
    EXPECT_TRUE(unknown.says("did you mean 'KIND'?")) << unknown.output;
    const Outcome rung = snell(command + " --ladder KIND=othr");
    EXPECT_EQ(rung.status, 1);
    EXPECT_TRUE(rung.says("did you mean 'other'?")) << rung.output;
}

TEST_F(CommandLine, TheSameFrameIsTheSameBytes) {
    snell("render " + at("good.glib") + " -o " + at("a.png") + " --time 1.5");
    snell("render " + at("good.glib") + " -o " + at("b.png") + " --time 1.5");
    EXPECT_FALSE(bytes_of(at("a.png")).empty());
    EXPECT_EQ(bytes_of(at("a.png")), bytes_of(at("b.png")));
}

TEST_F(CommandLine, PixelsThatAreNoNumbersAreCountedWhenAsked) {
    folder.write(
        "nan.frag",
        "void main() { gl_FragColor = vec4(gl_FragCoord.x < 2. ? sqrt(-gl_FragCoord.x) : gl_FragCoord.x < 3. ? "
        "1. / (gl_FragCoord.x - gl_FragCoord.x) : 0., 0., 0., 1.); }\n");
    folder.write("nan.glib", "Ortho -1 1 -1 1\nVertex plain.vert\nFragment nan.frag\nProgram N\nQuadXY\n");
    const std::string command =
        "render " + at("nan.glib") + " -o " + at("o.png") + " --size 8x8 --stats " + at("s.json");
    EXPECT_EQ(snell(command).output, "");
    EXPECT_FALSE(nlohmann::json::parse(bytes_of(at("s.json"))).contains("non_finite"));
    const Outcome counted = snell(command + " --count-non-finite");
    EXPECT_EQ(counted.status, 0);
    EXPECT_TRUE(counted.says("16 pixels are NaN and 8 are infinite")) << counted.output;
    const auto stats = nlohmann::json::parse(bytes_of(at("s.json")));
    EXPECT_EQ(stats["non_finite"]["nan"], 16);
    EXPECT_EQ(stats["non_finite"]["infinite"], 8);
    EXPECT_EQ(snell(command + " --count-non-finite -q").output, "") << "the statistics have it";
    EXPECT_EQ(nlohmann::json::parse(bytes_of(at("s.json")))["non_finite"]["nan"], 16);
    const std::string good = "render " + at("good.glib") + " -o " + at("o.png") + " --size 8x8 --count-non-finite";
    EXPECT_EQ(snell(good).output, "snell: 0 pixels are NaN and 0 are infinite before they are clamped\n");
    EXPECT_EQ(snell(good + " --quiet").output, "");
}

TEST_F(CommandLine, MuchThatShadersEmitIsSaidOnceWhereOpenGlHasNoStageForIt) {
    folder.write("many.geom",
                 "#version 400 compatibility\nlayout(points) in; layout(points, max_vertices = 128) out;\n"
                 "void main() { for (int i = 0; i < 128; ++i) { gl_Position = vec4(2.); EmitVertex(); } }\n");
    std::string scene = "Geometry many.geom\nProgram Many\nglBegin gl_points\n";
    for (int i = 0; i < 2500; ++i) scene += "glVertex 0 0 0\n";
    folder.write("many.glib", scene + "glEnd\n");
    const std::string command = "render " + at("many.glib") + " -o " + at("o.png") + " --size 8x8 --frames 2";
    EXPECT_FALSE(snell(command).says("[costly-stages]"));
    const Outcome outcome = snell(command + " --without-stages");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.says("many.glib:2:1: warning: ")) << outcome.output;
    const std::size_t first = outcome.output.find("[costly-stages]");
    ASSERT_NE(first, std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.output.find("[costly-stages]", first + 1), std::string::npos) << outcome.output;
}

TEST_F(CommandLine, FramesAreAtTheirTimes) {
    folder.write("timer.frag", "uniform float Timer;\nvoid main() { gl_FragColor = vec4(Timer, 0., 0., 1.); }\n");
    folder.write("timer.glib", "Timer 1\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment timer.frag\nProgram T\nQuadXY\n");
    const std::string command = "render " + at("timer.glib") + " --size 4x4 -o ";
    EXPECT_EQ(snell(command + at("f.png") + " --frames 3 --fps 29.97 --time .25").status, 0);
    for (int k = 0; k < 3; ++k) {
        const std::string name = "f-000" + std::to_string(k) + ".png";
        EXPECT_NEAR(std::to_integer<int>(picture(name).pixels.at(0)), 255 * (.25 + k / 29.97), .51) << name;
        snell(command + at("one.png") + " --time " + std::to_string(.25 + k / 29.97));
        EXPECT_EQ(bytes_of(at("one.png")), bytes_of(at(name))) << "drawn alone";
    }
    EXPECT_FALSE(std::filesystem::exists(at("f.png")));
    EXPECT_EQ(snell(command + at("f.png") + " --frames 2 --fps 0").status, 2);
}

TEST_F(CommandLine, SettingAUniformChangesThePicture) {
    snell("render " + at("good.glib") + " -o " + at("a.png") + " --size 8x8");
    const Outcome outcome =
        snell("render " + at("good.glib") + " -o " + at("b.png") + " --size 8x8 --set uMix=1 --set Mix.uEta=5");
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(std::to_integer<int>(picture("a.png").pixels[0]), 0);
    EXPECT_EQ(std::to_integer<int>(picture("b.png").pixels[0]), 255);
    EXPECT_NEAR(std::to_integer<int>(picture("b.png").pixels[1]), 128, 1);
}

TEST_F(CommandLine, AnUnknownUniformIsAnErrorThatSuggests) {
    const Outcome outcome = snell("render " + at("good.glib") + " -o " + at("o.png") + " --set uMxi=1");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("did you mean 'uMix'?")) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(at("o.png")));
}

TEST_F(CommandLine, AnErrorInTheSceneIsSaidAndTheRestIsDrawn) {
    const Outcome outcome = snell("render " + at("bad.glib") + " -o " + at("o.png") + " --size 8x8");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("bad.glib:2:1: error:")) << outcome.output;
    EXPECT_TRUE(outcome.says("'Sphere'")) << outcome.output;
    EXPECT_EQ(std::to_integer<int>(picture("o.png").pixels[0]), 255);
}

TEST_F(CommandLine, AFailedProgramIsAnErrorAtItsLine) {
    const Outcome outcome = snell("render " + at("broken.glib") + " -o " + at("o.png") + " --size 8x8");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("broken.frag:1:")) << outcome.output;
}

TEST_F(CommandLine, ASceneThatCannotBeReadHasAReason) {
    for (const std::string command : {"", "check "}) {
        const Outcome missing = snell(command + at("none.glib"));
        EXPECT_EQ(missing.status, 1);
        EXPECT_TRUE(missing.says("cannot read '" + at("none.glib") + "': No such file or directory")) << missing.output;
    }
}

TEST_F(CommandLine, NothingThatIsNotThereIsCreated) {
    EXPECT_EQ(snell("render " + at("none.glib") + " -o " + at("o.png")).status, 1);
    EXPECT_FALSE(std::filesystem::exists(at("none.glib")));
    EXPECT_FALSE(std::filesystem::exists(at("o.png")));
    const Outcome outcome = snell("render " + at("good.glib") + " -o " + at("no/such/folder/o.png"));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("no folder")) << outcome.output;
    EXPECT_EQ(snell("render " + at("good.glib") + " -o " + at("o.nonsense")).status, 1);
    EXPECT_FALSE(std::filesystem::exists(at("o.nonsense")));
    EXPECT_EQ(snell("render " + at("good.glib") + " -o /proc/o.png").status, 1);
}

TEST_F(CommandLine, WrongUsageIsTwo) {
    for (const char* arguments :
         {"", "render", "render x.glib", "render x.glib -o o.png --size 0x5", "render x.glib -o o.png --size 99999x1",
          "render x.glib -o o.png --samples 0", "render x.glib -o o.png --time nan", "check",
          "check --dump nothing x.glib", "--nonsense"})
        EXPECT_EQ(snell(arguments).status, 2) << arguments;
    EXPECT_EQ(snell("--help").status, 0);
    EXPECT_TRUE(snell("--help").says("Examples, "));
    EXPECT_EQ(snell("--version").output, "snell 0.1.0\n");
}

// An option that may be repeated takes one value, and leaves the scene's name alone.
TEST_F(CommandLine, OptionsMayStandBeforeTheScene) {
    for (const std::string option : {"--set uA=1", "--ladder A=b", "--limit draws=5"}) {
        const Outcome outcome = snell("render " + option + " " + at("none.glib") + " -o " + at("o.png"));
        EXPECT_EQ(outcome.status, 1) << option << '\n' << outcome.output;
        EXPECT_TRUE(outcome.says("none.glib")) << option << '\n' << outcome.output;
    }
}

TEST_F(CommandLine, NoGraphicsIsThree) {
    const Outcome outcome =
        snell("render " + at("good.glib") + " -o " + at("o.png"), "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent");
    EXPECT_EQ(outcome.status, 3) << outcome.output;
    EXPECT_TRUE(outcome.says("no graphics"));
}

// Every format of the module is tried without the program (tests/image/formats.cpp).
TEST_F(CommandLine, TheExtensionIsTheFormat) {
    for (const char* extension : {"png", "jpg", "exr"}) {
        const std::string name = std::string("o.") + extension;
        EXPECT_EQ(snell("render " + at("good.glib") + " -o " + at(name) + " --size 16x8 --set uMix=1").status, 0)
            << name;
        const content::Image image = picture(name);
        EXPECT_EQ(image.width, 16) << name;
        EXPECT_EQ(image.height, 8) << name;
    }
}

TEST_F(CommandLine, PicturesOfFloatsAreExact) {
    folder.write("float.frag", "void main() { gl_FragColor = vec4(2.5, -1., 1. / 1024., 1.); }\n");
    folder.write("float.glib", "Ortho -1 1 -1 1\nVertex plain.vert\nFragment float.frag\nProgram F\nQuadXY\n");
    ASSERT_EQ(snell("render " + at("float.glib") + " -o " + at("o.exr") + " --size 8x8 --samples 4").status, 0);
    const content::Image image = picture("o.exr");
    ASSERT_EQ(image.type, content::PixelType::f16);
    for (std::size_t c = 0; c < 3; ++c) {
        std::uint16_t half = 0;
        std::memcpy(&half, &image.pixels[c * 2], 2);
        EXPECT_EQ(content::half_to_float(half), (std::array{2.5F, -1.F, 1 / 1024.F})[c]);
    }
}

TEST_F(CommandLine, MessagesAndVerboseGoToStandardError) {
    folder.write("told.glib", "MessageBox Drag the sliders.\nVerbose\n" + bytes_of(at("good.glib")));
    const Outcome outcome = snell("render " + at("told.glib") + " -o " + at("o.png"));
    EXPECT_EQ(outcome.status, 0);
    for (const char* expected : {"Drag the sliders.", "mix.frag", "program 'Mix':", "float uMix", "1 draws"})
        EXPECT_TRUE(outcome.says(expected)) << expected << " in\n" << outcome.output;
}

TEST_F(CommandLine, StatsAreJson) {
    ASSERT_EQ(snell("render " + at("good.glib") + " -o " + at("o.png") + " --stats " + at("s.json")).status, 0);
    const auto json = nlohmann::json::parse(bytes_of(at("s.json")));
    EXPECT_EQ(json["counters"]["draws"], 1);
    EXPECT_EQ(json["counters"]["programs_compiled"], 1);
    EXPECT_EQ(json["counters"]["files_opened"], 3);
    EXPECT_GT(json["milliseconds"]["frame"], 0);
}

TEST_F(CommandLine, CheckSaysAllThatIsWrong) {
    EXPECT_EQ(snell("check " + at("good.glib")).status, 0);
    const Outcome outcome = snell("check --json " + at("good.glib") + " " + at("bad.glib") + " " + at("broken.glib"));
    EXPECT_EQ(outcome.status, 1);
    const auto json = nlohmann::json::parse(outcome.output);
    ASSERT_EQ(json.size(), 3U);
    EXPECT_EQ(json[0]["errors"], 0);
    EXPECT_EQ(json[1]["diagnostics"][0]["code"], "unknown-command");
    EXPECT_EQ(json[1]["diagnostics"][0]["at"]["line"], 2);
    EXPECT_EQ(json[2]["errors"], 1);
    // A scene is no place for JSON, wherever it is.
    EXPECT_EQ(snell("check --json /proc/self/cwd/good.glib", "", folder.path()).status, 0);
}

TEST_F(CommandLine, CheckListsEveryPlaceOfOneMistake) {
    const std::string scene =
        folder.write("places.glib", "Texture2D 5 wall.bmp\nSphere 1\nTexture2D 6 wall.bmp\nTexture2D 7 wall.bmp\n");
    const Outcome outcome = snell("check --json --no-lint " + scene);
    const auto json = nlohmann::json::parse(outcome.output);
    ASSERT_EQ(json[0]["diagnostics"].size(), 1U) << outcome.output;
    const auto& also = json[0]["diagnostics"][0]["also_at"];
    ASSERT_EQ(also.size(), 2U);
    EXPECT_EQ(also[0]["line"], 3);
    EXPECT_EQ(also[1]["line"], 4);
}

TEST_F(CommandLine, EveryStageCanBeDumped) {
    for (const char* stage : {"tokens", "statements", "scene", "plan"}) {
        const Outcome outcome = snell("check --dump " + std::string(stage) + " " + at("good.glib"));
        EXPECT_EQ(outcome.status, 0);
        EXPECT_TRUE(outcome.says("Mix")) << stage << ":\n" << outcome.output;
    }
}

TEST_F(CommandLine, CommandsAreJson) {
    const auto json = nlohmann::json::parse(snell("commands --json").output);
    EXPECT_GT(json.dump().find("Sphere"), 0U);
}

// Lints need no graphics, are warnings, and are for check alone.
TEST_F(CommandLine, CheckSaysWhatIsProbablyNotMeant) {
    folder.write("n.vert", "out vec3 vN;\nvoid main() { vN = gl_Normal; gl_Position = ftransform(); }\n");
    folder.write("n.frag",
                 "in vec3 vN;\nvoid main() {\n    gl_FragColor = vec4(reflect(vec3(0., 0., 1.), vN), 1.);\n}\n");
    folder.write("n.glib", "Vertex n.vert\nFragment n.frag\nProgram N\nSphere\n");
    const std::string code = "[unnormalised-direction]";
    for (const char* environment : {"", "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent"}) {
        const Outcome found = snell("check " + at("n.glib"), environment);
        EXPECT_EQ(found.status, 0) << found.output;
        EXPECT_TRUE(found.says("n.frag:3:51: warning: ")) << found.output;
        EXPECT_TRUE(found.says(code)) << found.output;
        EXPECT_TRUE(found.says("snell help unnormalised-direction"));
    }
    EXPECT_EQ(snell("check --no-lint " + at("n.glib")).output, "");
    EXPECT_EQ(snell("render " + at("n.glib") + " -o " + at("o.png") + " --size 8x8").output, "");
}

TEST_F(CommandLine, CheckNamesSlidersWithoutEffect) {
    if (!snell("info").says("llvmpipe")) GTEST_SKIP() << "the driver may give no code";
    folder.write("e.vert", plain_vertex);
    folder.write("e.frag",
                 "uniform float uX, uY;\nuniform bool uOn;\n"
                 "void main() { gl_FragColor = vec4(max(uX, 50.) * uY * (uOn ? 1. : .5)); }\n");
    const std::string cache = "MESA_SHADER_CACHE_DIR=" + at("cache");  // without one, Mesa gives no code
    const auto check = [&](const std::string& before, const std::string& flags) {
        folder.write("e.glib", before +
                                   "Vertex e.vert\nFragment e.frag\n"
                                   "Program E uY <0 .5 1> uOn <true> uX <0 .5 1>\nQuadXY\n");
        return snell("check --timeout 600 " + flags + at("e.glib"), cache);
    };
    for (int run = 0; run < 2; ++run) {  // the driver has kept some of the programs since the first
        const Outcome found = check("", "");
        EXPECT_EQ(found.status, 0);
        EXPECT_TRUE(found.says(
            "e.glib:3:34: warning: 'uX' seems to have no effect: program 'E' computes the same for all tried "
            "values from 0 to 1 [slider-without-effect]"))
            << found.output;
        EXPECT_TRUE(found.says("snell help slider-without-effect")) << found.output;
        EXPECT_FALSE(found.says("'uY'") || found.says("'uOn'")) << found.output;
    }
    EXPECT_TRUE(check("Ladder KIND <a> b\n", "").says("'uX' seems to have no effect: with these rungs, program 'E'"));
    EXPECT_EQ(check("", "--no-lint ").output, "");
}

TEST_F(CommandLine, ATrivialSceneIsQuick) {
    const std::string picture = "render " + at("good.glib") + " --size 256x256 -o " + at("o.");
    EXPECT_LE(cost_of(picture + "png"), 5 * cost_of("info")) << "which makes a context, too, and draws nothing";
    // Loading OpenImageIO would double the time.
    const std::string loaded = "LD_DEBUG=files";
    EXPECT_FALSE(snell(picture + "png", loaded).says("OpenImageIO"));
    EXPECT_TRUE(snell(picture + "jpg", loaded).says("OpenImageIO"));
}

// The scene that the slides print, with pictures and a two-line texture shader beside it.
TEST_F(CommandLine, ThePrintedSceneRuns) {
    const std::string corpus = SNELL_ROOT "/../shared/corpus/bailey";
    if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "the corpus is not beside the project";
    for (const auto& entry : std::filesystem::directory_iterator(corpus))
        folder.write(entry.path().filename().string(), bytes_of(entry.path()));
    for (const char* face : {"posx", "negx", "posy", "negy", "posz", "negz"})
        folder.write(std::string("nv") + face + ".bmp",
                     bytes_of(std::string(SNELL_ROOT "/scenes/environments/room/") + face + ".bmp"));
    folder.write("texture.vert", plain_vertex);
    folder.write("texture.frag",
                 "uniform sampler2D TexUnit;\nin vec2 vST;\nvoid main() { gl_FragColor = texture(TexUnit, vST); }\n");
    // As printed it draws nothing with the refracting program: a sphere in front of the eye makes it visible.
    folder.write("ball.glib", bytes_of(at("cubemap.glib")) + "\nTranslate 0. 0. -3.\nSphere 1.\n");
    EXPECT_EQ(snell("check " + at("cubemap.glib")).status, 0);
    const Outcome plain = snell("render " + at("ball.glib") + " -o " + at("a.png") + " --size 128x128");
    EXPECT_EQ(plain.status, 0) << plain.output;
    EXPECT_EQ(snell("render " + at("ball.glib") + " -o " + at("b.png") + " --size 128x128 --set uMix=1").status, 0);
    EXPECT_NE(picture("a.png").pixels, picture("b.png").pixels);
    const Outcome typo = snell("render " + at("ball.glib") + " -o " + at("c.png") + " --set uMxi=1");
    EXPECT_EQ(typo.status, 1);
    EXPECT_TRUE(typo.says("'uMix'"));

    std::string error;
    auto context = HeadlessContext::make({}, error);
    auto document = open_document(at("ball.glib"), gl::query_caps());
    const Control* eta = document->controls.find(1, "uEta");
    const Control* mix = document->controls.find(1, "uMix");
    ASSERT_TRUE(eta && mix);
    EXPECT_EQ(eta->widget, Widget::slider);
    EXPECT_EQ(eta->min, .1);
    EXPECT_EQ(eta->value, std::vector<double>{1.1});
    EXPECT_EQ(eta->max, 5);
    EXPECT_EQ(mix->min, 0);
    EXPECT_EQ(mix->max, 1);
}

// The article's listing is indented with no-break spaces and has a type error in each stage.
TEST_F(CommandLine, TheArticlesErrorsAreReportedAtTheirLines) {
    const std::string corpus = SNELL_ROOT "/../shared/corpus/dykhta";
    if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "the corpus is not beside the project";
    for (const char* name : {"environment.vert", "environment.frag"}) folder.write(name, bytes_of(corpus + "/" + name));
    folder.write("d.glib", "Vertex environment.vert\nFragment environment.frag\nProgram D\nSphere\n");
    const Outcome outcome = snell("check " + at("d.glib"));
    EXPECT_EQ(outcome.status, 1);
    for (const char* expected : {"environment.vert:18:", "environment.frag:51:"})
        EXPECT_TRUE(outcome.says(expected)) << outcome.output;
    size_t warnings = 0;
    for (size_t i = 0; (i = outcome.output.find("[odd-blank]", i)) != std::string::npos; ++i) ++warnings;
    EXPECT_EQ(warnings, 2U) << "one for each file";
}

}  // namespace

}  // namespace snell::test
