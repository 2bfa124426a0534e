// `snell explain`: its JSON has its keys, and says of a scene what is true of it.
#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "src/app/commands/explain/explain.h"
#include "tests/cli/command.h"
#include "tests/sanitized.h"

namespace snell::test {
namespace {

using nlohmann::json;

class Explain : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        if (IsSkipped()) return;
        folder.write("plain.vert", plain_vertex);
        folder.write("texture.frag", texture_fragment);
        folder.write("clock.frag", "uniform float Timer;\nvoid main() { gl_FragColor = vec4(Timer, 0., 0., 1.); }\n");
        for (int i = 0; i < 20; ++i)
            folder.write("t" + std::to_string(i) + ".bmp", bmp(8, 4, std::vector<std::array<int, 3>>(32, {i, 90, 30})));
    }
    json explain(const std::string& scene, const std::string& flags = "--no-time") {
        folder.write("scene.glib", scene);
        const Outcome outcome = snell("explain " + folder.path("scene.glib") + " --json --size 32x32 " + flags);
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        return json::parse(outcome.output, nullptr, false);
    }
    static std::vector<json> of_kind(const json& report, const std::string& kind) {
        std::vector<json> result;
        for (const json& paid : report["pays"])
            if (paid["kind"] == kind) result.push_back(paid);
        return result;
    }
    static bool has(const json& list, const std::string& name) {
        return std::ranges::any_of(list, [&](const json& entry) { return entry["name"] == name; });
    }
};

const std::string two_of_twenty = [] {
    std::string scene;
    for (int i = 0; i < 20; ++i) scene += "Texture2D " + std::to_string(i) + " t" + std::to_string(i) + ".bmp\n";
    return scene +
           "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nProgram A uUnit 4 uGone 3\n"
           "QuadXY\nProgram B uUnit 9\nQuadXY\n";
}();

TEST_F(Explain, SaysWhichProgramsAreCompiledOnce) {
    std::string scene = "Ortho -1 1 -1 1\nVertex plain.vert\nFragment clock.frag\n";
    for (const char* name : {"A", "B", "C"}) scene += std::string("Program ") + name + "\nQuadXY\n";
    const auto programs = of_kind(explain(scene), "program");
    ASSERT_EQ(programs.size(), 1U);
    EXPECT_TRUE(programs[0]["why"].get<std::string>().starts_with("3 draws; compiled once for A, B, C")) << programs[0];
}

// A sphere far to the side is in no view; the other one is, and so is the value of its colour.
TEST_F(Explain, SaysWhatChangesNoPixelFirst) {
    folder.write("p.frag",
                 "uniform float uRed;\nvoid main() {\n  float gone = sin(gl_FragCoord.x);\n  gone = gone * 2.;\n"
                 "  gl_FragColor = vec4(uRed, .2, 0., 1.);\n}\n");
    const std::string scene =
        "Ortho -1.5 1.5 -1.5 1.5\nLookAt 0 0 3 0 0 0 0 1 0\nVertex plain.vert\nFragment p.frag\n"
        "Program P uRed <0. .5 1.>\nSphere 1 30 30\nPushMatrix\nTranslate 500 0 0\nSphere 1 200 200\nPopMatrix\n";
    const json report = explain(scene, "--no-time --without-effect --timeout 100");
    const json& found = report["without_effect"];
    EXPECT_EQ(found["late"], false);
    EXPECT_GE(found["places"], 8);
    EXPECT_GE(found["held_out"], 4);
    std::map<std::string, json> rows;
    for (const json& row : found["rows"]) rows[row["what"]] = row;
    ASSERT_TRUE(rows.contains("Sphere 1 200 200")) << found;
    EXPECT_EQ(found["rows"][0]["what"], "Sphere 1 200 200") << "the largest is first";
    EXPECT_GT(rows["Sphere 1 200 200"]["gpu_bytes"], 2'000'000);
    EXPECT_TRUE(rows["Sphere 1 200 200"]["place"].get<std::string>().ends_with("scene.glib:9:1"));
    EXPECT_TRUE(rows.contains("gone = gone * 2."));
    EXPECT_EQ(rows.size(), 2u) << "nothing that can be seen, nor what would leave an output unwritten: " << found;
    EXPECT_FALSE(explain(scene).contains("without_effect"));
    const std::string text =
        snell("explain " + folder.path("scene.glib") + " --size 32x32 --without-effect --no-time").output;
    EXPECT_LT(text.find("CHANGES 0 PIXELS"), text.find("PAYS FOR"));
    // Its number is that of the list, and what is written without it is the same picture.
    const std::string rung = rows["Sphere 1 200 200"]["rung"];
    ASSERT_EQ(snell("accuracy " + folder.path("scene.glib") + " --apply " + rung + " -o " + folder.path("less")).status,
              0);
    for (const char* name : {"scene.glib", "less/scene.glib"})
        EXPECT_EQ(snell("render " + folder.path(name) + " --size 32x32 -o " + folder.path(name) + ".png").status, 0);
    EXPECT_EQ(bytes_of(folder.path("scene.glib.png")), bytes_of(folder.path("less/scene.glib.png")));
    const std::string less = bytes_of(folder.path("less/scene.glib"));
    EXPECT_EQ(less.find("Sphere"), less.rfind("Sphere")) << "it is gone, and not only coarser:\n" << less;
}

TEST_F(Explain, OfASceneThatIsNotFiniteNothingIsLeftOut) {
    folder.write("nan.frag", "uniform float uRed;\nvoid main() { gl_FragColor = vec4(sqrt(uRed - 2.)); }\n");
    const std::string scene =
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment nan.frag\nProgram P uRed <0. .5 1.>\nQuadXY\nSphere 1 9 9\n";
    const json found = explain(scene, "--no-time --without-effect")["without_effect"];
    EXPECT_NE(found["cannot_say"].get<std::string>().find("NaN or infinite"), std::string::npos) << found;
    EXPECT_EQ(found["tried"], 0);
    EXPECT_TRUE(found["rows"].empty());
    const Outcome text = snell("explain " + folder.path("scene.glib") + " --size 32x32 --no-time --without-effect");
    EXPECT_TRUE(text.says("can't say: the scene itself is NaN or infinite in ")) << text.output;
    EXPECT_FALSE(text.says("that were left out")) << text.output;
}

// What shaders of strangers say does not reach a terminal as it is.
TEST_F(Explain, TextIsPrintable) {
    folder.write("p.frag",
                 "void main() {\n  float gone = sin(gl_FragCoord.x);\n  gone = gone /*\x1b[31m*/ * 2.;\n"
                 "  gl_FragColor = vec4(.2);\n}\n");
    folder.write("scene.glib", "Ortho -1 1 -1 1\nVertex plain.vert\nFragment p.frag\nProgram P\nQuadXY\n");
    const Outcome outcome = snell("explain " + folder.path("scene.glib") + " --size 8x8 --no-time --without-effect");
    EXPECT_TRUE(outcome.says("gone = gone /*\\x1B[31m*/ * 2.")) << outcome.output;
    EXPECT_EQ(outcome.output.find('\x1b'), std::string::npos);
}

TEST_F(Explain, SaysWhatIsPaidForAndWhy) {
    const json report = explain(two_of_twenty);
    const std::vector<json> images = of_kind(report, "image");
    ASSERT_EQ(images.size(), 2U);
    EXPECT_EQ(images[0]["name"], "Texture2D 4 t4.bmp 8x4");
    EXPECT_EQ(images[0]["why"], "read by uUnit of A");
    EXPECT_EQ(images[0]["at"]["line"], 5);
    EXPECT_EQ(images[0]["bytes"], 8 * 4 * 4);
    EXPECT_EQ(images[1]["at"]["line"], 10);
    const json alike = explain(
        "Texture2D 4 t4.bmp\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\n"
        "Program A uUnit 4\nQuadXY\nProgram A uUnit 4 uGone 3\nQuadXY\n");
    EXPECT_EQ(of_kind(alike, "image")[0]["why"], "read by uUnit of A, uUnit of A#2");
    EXPECT_TRUE(has(alike["unused"], "uGone of A#2"));
    EXPECT_EQ(of_kind(report, "program").size(), 2U);
    EXPECT_EQ(of_kind(report, "mesh").size(), 1U) << "one quad for both draws";
    ASSERT_EQ(of_kind(report, "pass").size(), 1U);
    EXPECT_EQ(of_kind(report, "pass")[0]["draws"], 2);
    EXPECT_EQ(report["unused"].size(), 18U + 1U);
    EXPECT_TRUE(has(report["unused"], "uGone of A"));
    for (const char* name : {"Timer", "Noise2, Noise3", "mipmaps", "off-screen targets"})
        EXPECT_TRUE(has(report["not_paid"], name)) << name;
    EXPECT_FALSE(has(report["not_paid"], "blending")) << "the images might have alpha";
    EXPECT_TRUE(has(explain("Ortho -1 1 -1 1\nQuadXY\n")["not_paid"], "blending"));
    EXPECT_EQ(report["counters"]["load"]["images_decoded"], 2);
    EXPECT_EQ(report["counters"]["frame"]["draws"], 2);
    EXPECT_EQ(report["counters"]["frame"]["uniform_uploads"], 0);
}

TEST_F(Explain, WhatIsCalledForIsNotSaidToBeSaved) {
    const std::string scene =
        "Texture2D 5 8 8\nFilter mipmap\nTexture2D 6 t1.bmp\nOrtho -1 1 -1 1\nRenderToTexture 5\n"
        "Color 1 0 0 .5\nQuadXY\nRenderToTexture\nVertex plain.vert\nFragment texture.frag\n"
        "Program A uUnit 5\nQuadXY\nProgram B uUnit 6\nQuadXY\nFragment clock.frag\nProgram C\n"
        "QuadXY\n";
    const json report = explain(scene);
    for (const char* name : {"Timer", "mipmaps", "blending", "off-screen targets"})
        EXPECT_FALSE(has(report["not_paid"], name)) << name;
    EXPECT_EQ(report["redraw"], "all the time: C read the clock");
    EXPECT_EQ(of_kind(report, "target").size(), 1U);
    EXPECT_EQ(of_kind(report, "pass").size(), 2U);
}

TEST_F(Explain, SaysWhatIsOutOfView) {
    const std::string pass =
        "Texture2D 4 8 8\nRenderToTexture 4\nOrtho -1 1 -1 1\nQuadXY\nRenderToTexture\n"
        "Perspective 60\nLookAt 0 0 0  0 0 -1  0 1 0\nVertex plain.vert\nFragment texture.frag\nProgram A uUnit 4\n";
    const json behind = explain(pass + "Translate 0 0 9\nCone 1 2 8 3\nProgram\nTranslate 0 0 -19\nSphere 1\n");
    EXPECT_TRUE(has(behind["not_paid"], "draws out of view"));
    EXPECT_TRUE(has(behind["not_paid"], "passes out of view"));
    EXPECT_EQ(behind["counters"]["frame"]["draws_culled"], 1);
    EXPECT_EQ(behind["counters"]["frame"]["draws"], 1);
    const std::string text = behind["not_paid"].dump();
    EXPECT_NE(text.find("1 of 2, outside of the picture or of a face of a cube map: Cone"), std::string::npos) << text;
    EXPECT_EQ(text.find("Sphere"), std::string::npos) << text;
    const json before = explain(pass + "Translate 0 0 -9\nCone 1 2 8 3\n");
    EXPECT_FALSE(has(before["not_paid"], "draws out of view"));
    EXPECT_FALSE(has(before["not_paid"], "passes out of view"));
    EXPECT_EQ(before["counters"]["frame"]["draws_culled"], 0);
}

// Every key that others may rely on, with its type.
TEST_F(Explain, ItsJsonHasItsKeys) {
    const json report = explain(two_of_twenty, "--reps 3");
    EXPECT_EQ(report["schema"], 1);
    for (const char* key : {"scene", "renderer", "gl", "clock", "redraw"}) EXPECT_TRUE(report[key].is_string()) << key;
    EXPECT_EQ(report["size"], json::array({32, 32}));
    EXPECT_EQ(report["rounds"], 3);
    for (const char* key : {"cpu_ms", "wall_ms", "spread_ms"}) EXPECT_TRUE(report["frame"][key].is_number()) << key;
    EXPECT_TRUE(report["frame"].contains("gpu_ms"));
    for (const json& paid : report["pays"]) {
        for (const char* key : {"kind", "name", "why"}) EXPECT_TRUE(paid[key].is_string()) << paid;
        EXPECT_TRUE(paid["bytes"].is_number_unsigned()) << paid;
        EXPECT_TRUE(paid["load_ms"].is_number() || paid["load_ms"].is_null()) << paid;
        EXPECT_TRUE(paid["frame"].is_object() || paid["frame"].is_null()) << paid;
        EXPECT_TRUE(paid["at"].is_null() || (paid["at"]["file"].is_string() && paid["at"]["line"].is_number())) << paid;
    }
    EXPECT_TRUE(of_kind(report, "pass").at(0)["frame"]["cpu_ms"].is_number());
    for (const char* key : {"not_paid", "switched_off", "unused", "lints"}) EXPECT_TRUE(report[key].is_array()) << key;
    for (const char* when : {"load", "frame"})
        for (const CounterName& counter : counter_names())
            EXPECT_TRUE(report["counters"][when][std::string(counter.name)].is_number_unsigned()) << counter.name;
    EXPECT_TRUE(explain(two_of_twenty)["clock"].is_null()) << "not timed";
}

TEST_F(Explain, TextSaysTheSame) {
    folder.write("scene.glib", two_of_twenty);
    const Outcome outcome = snell("explain " + folder.path("scene.glib") + " --reps 3 --size 32x32");
    EXPECT_EQ(outcome.status, 0);
    for (const char* words : {"PAYS FOR", "Texture2D 4 t4.bmp 8x4", "scene.glib:5: read by uUnit of A", "NOT PAID FOR",
                              "DECLARED BUT UNUSED", "no draw samples it", "0.1 kB"})
        EXPECT_TRUE(outcome.says(words)) << words << "\n" << outcome.output;
    EXPECT_FALSE(outcome.says("KiB")) << "the same unit as everywhere";
    EXPECT_EQ(snell("explain " + folder.path("nothing.glib")).status, 1);
}

class SwitchedOffCommand : public Explain {
protected:
    void SetUp() override {
        Explain::SetUp();
        if (IsSkipped()) return;
        for (int i = 0; i < 12; ++i)  // faces of cubes are square
            folder.write("t" + std::to_string(i) + ".bmp",
                         bmp(4, 4, std::vector<std::array<int, 3>>(16, {20 * i, 90, 30})));
        folder.write("weight.frag",
                     "#version 330 compatibility\nuniform samplerCube uBent, uMirrored;\nuniform float uMix;\nin vec2 "
                     "vST;\nvoid main() { vec3 d = vec3(vST - .5, 1.); gl_FragColor = vec4(mix(texture(uBent, d).rgb, "
                     "texture(uMirrored, d).rgb, uMix), 1.); }\n");
        folder.write("scene.glib", scene_text);
    }
    const std::string scene_text =
        "CubeMap 5 t0.bmp t1.bmp t2.bmp t3.bmp t4.bmp t5.bmp\nCubeMap 6 t6.bmp t7.bmp t8.bmp t9.bmp t10.bmp t11.bmp\n"
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment weight.frag\nProgram P uBent 5 uMirrored 6 uMix <0. 0. 1.>\n"
        "QuadXY\n";
};

TEST_F(SwitchedOffCommand, IsAKeyOfTheJson) {
    const json rows = explain(scene_text, "--reps 3")["switched_off"];
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0]["uniform"], "uMix");
    EXPECT_EQ(rows[0]["program"], "P");
    EXPECT_EQ(rows[0]["value"], "0");
    EXPECT_EQ(rows[0]["at"]["line"], 6);
    EXPECT_EQ(rows[0]["at"]["column"], 31);
    EXPECT_TRUE(rows[0]["saves"]["cpu_ms"].is_number());
    const json& off = rows[0]["off"];
    ASSERT_EQ(off.size(), 2U);
    EXPECT_EQ(off[0]["kind"], "sampler");
    EXPECT_EQ(off[0]["name"], "samplerCube uMirrored");
    EXPECT_EQ(off[0]["functions"], json::array({"main (fragment)"}));
    EXPECT_EQ(off[1]["kind"], "cube map");
    EXPECT_EQ(off[1]["files"].size(), 6U);
    EXPECT_EQ(off[1]["bytes"], 6 * bytes_of(folder.path("t6.bmp")).size());
    EXPECT_EQ(off[1]["at"]["line"], 2);
    EXPECT_TRUE(rows[1]["uniform"].is_null()) << "all values together";
    EXPECT_TRUE(rows[1]["saves"]["cpu_ms"].is_number());
    EXPECT_FALSE(has(explain(scene_text)["unused"], "CubeMap 6"));
}

TEST_F(SwitchedOffCommand, IsEmptyWithoutTimesOrConstants) {
    const json untimed = explain(scene_text, "--no-time")["switched_off"];
    ASSERT_EQ(untimed.size(), 1U);
    EXPECT_TRUE(untimed[0]["saves"].is_null());
    EXPECT_EQ(explain(scene_text, "--no-time --no-specialise")["switched_off"], json::array());
    EXPECT_EQ(explain(scene_text, "--no-time --set uMix=.5")["switched_off"], json::array());
    EXPECT_EQ(explain(scene_text, "--no-time --no-specialise")["counters"]["load"]["images_decoded"], 12);
    EXPECT_EQ(untimed[0]["off"][1]["files"].size(), 6U);
}

// The programs for other values read a texture a few hundred times, which the value of zero leaves out.
TEST_F(SwitchedOffCommand, SavesWhatIsMeasured) {
    folder.write(
        "weight.frag",
        "#version 330 compatibility\nuniform samplerCube uBent, uMirrored;\nuniform float uMix;\nin vec2 vST;\n"
        "void main() { vec3 d = vec3(vST - .5, 1.), c = texture(uBent, d).rgb;\nfor (int i = 0; i < 300; ++i) "
        "c += uMix * texture(uMirrored, d + float(i)).rgb;\ngl_FragColor = vec4(c, 1.); }\n");
    const json report = explain(scene_text, "--reps 7");
    const json& rows = report["switched_off"];
    ASSERT_EQ(rows.size(), 2U);
    for (const json& row : rows)
        EXPECT_GT(row["saves"]["cpu_ms"].get<double>(), report["frame"]["cpu_ms"].get<double>()) << row;
}

TEST_F(SwitchedOffCommand, IsASectionOfTheText) {
    const auto text = [&](const std::string& flags) {
        return snell("explain " + folder.path("scene.glib") + " --size 32x32 " + flags).output;
    };
    const std::string timed = text("--reps 3");
    for (const char* words : {"SWITCHED OFF", "by uMix = 0 of P", "scene.glib:6:31", "samplerCube uMirrored",
                              "CubeMap 6 t6.bmp, 6 files not opened", "in all, against programs for any values"})
        EXPECT_NE(timed.find(words), std::string::npos) << words << "\n" << timed;
    EXPECT_EQ(timed.find("no draw samples it"), std::string::npos) << timed;
    EXPECT_EQ(text("--no-time").find("in all,"), std::string::npos);
    for (const char* flags : {"--no-time --no-specialise", "--no-time --set uMix=.5"})
        EXPECT_EQ(text(flags).find("SWITCHED OFF"), std::string::npos) << flags;
}

// All rounds would take minutes. Where the machine is so busy that there is no time for a frame, it is ended.
TEST_F(Explain, TheWholeOfItEndsInTime) {
    const auto start = std::chrono::steady_clock::now();
    folder.write("scene.glib", two_of_twenty + "Sphere 1 200 200\n");
    const Outcome outcome =
        snell("explain " + folder.path("scene.glib") + " --json --size 32x32 --reps 10000 --timeout 1.5");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10) * patience);
    if (outcome.status == 4) GTEST_SKIP() << "this machine is busy: " << outcome.output;
    const json report = json::parse(outcome.output, nullptr, false);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_GE(report["rounds"], 1) << outcome.output;
    EXPECT_LT(report["rounds"], 10000);
}

class FramesInTime : public GlTest {};

TEST_F(FramesInTime, AreFewerWhereTheyAreExpensive) {
    auto document = open("Ortho -1 1 -1 1\nQuadXY\nSphere .5\n");
    const gl::Target target = gl::make_target(32, 32, 1);
    const View view;
    const Frame frame{.time = 0, .view = view, .controls = document->controls};
    const Surface surface{target.framebuffer.get(), 32, 32};
    document->runtime->draw(frame, surface);
    app::ExplainReport report;
    report.caps = caps;
    report.explanation = document->runtime->explain();
    const auto time = [&](const app::Timing& timing) {
        app::time_frames(report, *document->runtime, frame, surface, timing);
    };
    const auto timed_parts = [&] {
        return std::ranges::count_if(report.explanation.paid, [](const auto& paid) { return paid.frame.has_value(); });
    };
    time({31, 1000, 2000, nullptr});
    EXPECT_EQ(report.clock, "") << "a frame takes longer than there is time";
    // The first frame takes all of it.
    int told = 0;
    const auto slow = [&](int, double) {
        ++told;
        std::this_thread::sleep_for(std::chrono::milliseconds(600));
    };
    time({31, 500, 0, slow});
    EXPECT_EQ(told, 1);
    EXPECT_EQ(report.rounds, 1);
    EXPECT_GT(report.frame.wall, 0);
    EXPECT_EQ(timed_parts(), 0);
    EXPECT_NE(app::explain_text(report, document->sources).find("1 rounds of 31: time was up"), std::string::npos);
    time({3, 20e3, 0, nullptr});
    EXPECT_EQ(report.rounds, 3);
    EXPECT_GT(timed_parts(), 0);
}

}  // namespace
}  // namespace snell::test
