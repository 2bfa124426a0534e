// What can be left out: the exact text that stays.
#include "tests/accuracy/found_help.h"

namespace snell::accuracy {
namespace {

using Befores = std::vector<std::string>;

Befores left_out(const Found& found, ChangeKind kind) {
    Befores all;
    for (const Change& change : found.changes)
        if (change.kind == kind) all.push_back(change.before);
    return all;
}

class FoundOmissions : public testing::Test {
protected:
    Found found(std::string_view scene, std::string_view fragment = "void main() { gl_FragColor = vec4(1.); }\n") {
        return found_in_text(folder_, scene, {{"a.vert", vertex}, {"a.frag", fragment}, {"p.png", ""}}, add_omissions);
    }
    Found shader(std::string_view fragment) {
        return found("Vertex a.vert\nFragment a.frag\nProgram P\nBox\n", fragment);
    }
    Scratch folder_;
};

TEST_F(FoundOmissions, ADrawGoesAndItsCommentStays) {
    const Found two = found("Sphere 1. \\\n  # many\n  9 9 # far\nBox\n");
    EXPECT_EQ(left_out(two, ChangeKind::no_draw).size(), 2u);
    EXPECT_EQ(two.text(ChangeKind::no_draw, 0, "scene.glib"), "  # many\n # far\nBox\n");
    EXPECT_EQ(two.text(ChangeKind::no_draw, 1, "scene.glib"), "Sphere 1. \\\n  # many\n  9 9 # far\n\n");
}

TEST_F(FoundOmissions, AListOfVerticesLeavesItsStateBehind) {
    const Found list = found("glBegin gl_triangles\nglColor 1 0 0\nglVertex 0 0 0\nglVertex 1 0 0\nglEnd\nBox\n");
    EXPECT_EQ(list.text(ChangeKind::no_draw, 0, "scene.glib"), "\nglColor 1 0 0\n\n\n\nBox\n");
}

TEST_F(FoundOmissions, TexturesThatNothingElseNeeds) {
    const Found some =
        found("Texture2D 5 64 64\nTexture2D 1 p.png\nCubeMap 6 p.png\nIrradiance 7 6\nRenderToTexture 5\n");
    EXPECT_EQ(left_out(some, ChangeKind::no_texture), (Befores{"Texture2D 1 p.png", "Irradiance 7 6"}));
    EXPECT_TRUE(left_out(found("Texture2D 1 missing.png\nBox\n"), ChangeKind::no_texture).empty());
}

TEST_F(FoundOmissions, TheLastUniformOfALineWithACommentLeavesTheNextStatementAlone) {
    for (const std::string_view end : {"\n", "\r\n"}) {
        const std::string e(end);
        const Found two = found("Vertex a.vert" + e + "Fragment a.frag" + e + "Program P uA <0. 1. 2.> \\" + e +
                                "    uB 3. # what it is" + e + "Box" + e);
        EXPECT_EQ(two.text(ChangeKind::no_uniform, 1, "scene.glib"), "Vertex a.vert" + e + "Fragment a.frag" + e +
                                                                         "Program P uA <0. 1. 2.> " + e +
                                                                         "     # what it is" + e + "Box" + e);
    }
}

TEST_F(FoundOmissions, UniformsOfAProgramLine) {
    const Found two = found("Vertex a.vert\nFragment a.frag\nProgram P uA <0. 1. 2.> \\\n    uB 3.\nBox\n");
    EXPECT_EQ(left_out(two, ChangeKind::no_uniform), (Befores{"uA <0. 1. 2.>", "uB 3."}));
    EXPECT_EQ(two.text(ChangeKind::no_uniform, 1, "scene.glib"),
              "Vertex a.vert\nFragment a.frag\nProgram P uA <0. 1. 2.> \\\n    \nBox\n");
    for (std::size_t n = 0; n < 2; ++n) {
        Scratch other;
        const Found again = found_in_text(other, two.text(ChangeKind::no_uniform, n, "scene.glib"),
                                          {{"a.vert", vertex}, {"a.frag", vertex}}, nullptr);
        ASSERT_EQ(again.plan.scene.programs.size(), 1u);
        ASSERT_EQ(again.plan.scene.programs[0].uniforms.size(), 1u);
        EXPECT_EQ(again.plan.scene.programs[0].uniforms[0].name, n == 0 ? "uB" : "uA");
        EXPECT_EQ(again.plan.scene.draws.size(), 1u);
    }
}

TEST_F(FoundOmissions, StatementsOfShaders) {
    const Found some = shader(
        "void lit(inout float x) { x *= 2.; }\nvoid main() {\n    float a = 1.; float unused = 2.;\n    if (a > 0.) a "
        "+= "
        "1.; // more\n    lit(a);\n    gl_FragColor = vec4(a);\n}\n");
    EXPECT_EQ(left_out(some, ChangeKind::no_statement),
              (Befores{"x *= 2.", "float unused = 2.;", "a += 1.", "lit(a)"}));
    EXPECT_NE(some.text(ChangeKind::no_statement, 2, "a.frag").find("if (a > 0.) ; // more\n"), std::string::npos);
    EXPECT_NE(some.text(ChangeKind::no_statement, 1, "a.frag").find("float a = 1.; \n"), std::string::npos);
}

TEST_F(FoundOmissions, WhatEndsALoopStays) {
    const Found loops = shader(
        "void main() {\n    float s = 0., t = 0.;\n    for (int i = 0; i < 9; i++) { s += .1; i = i + 1; }\n"
        "    gl_FragColor = vec4(s);\n    gl_FragColor.a = 1.;\n}\n");
    EXPECT_EQ(left_out(loops, ChangeKind::no_statement), (Befores{"s += .1", "gl_FragColor.a = 1."}));
    EXPECT_TRUE(left_out(shader("void main() {\n    float t = 0.;\n    while (t < 1.) t += .1;\n    gl_FragColor = "
                                "vec4(t);\n}\n"),
                         ChangeKind::no_statement)
                    .empty());
}

// What is undefined is 0 on some drivers.
TEST_F(FoundOmissions, NothingIsLeftWithoutAValue) {
    const auto in_main = [&](std::string_view statements, std::string_view ahead = "") {
        return left_out(shader(std::string(ahead) + "void main() {\n    " + std::string(statements) +
                               "\n    gl_FragColor = vec4(1.);\n}\n"),
                        ChangeKind::no_statement);
    };
    EXPECT_EQ(in_main("vec3 r; r = vec3(0.); r += vec3(1.);"), Befores{"r += vec3(1.)"});
    EXPECT_EQ(in_main("float s; s = 0.; s = 1.;"), Befores{"s = 1."});
    EXPECT_EQ(in_main("float s; s = s; s = 1.;"), Befores{}) << "it was nothing before";
    EXPECT_EQ(in_main("float s; if (true) s = 0.; s = 1.; { s = 2.; }"), Befores{"s = 2."}) << "on every path";
    EXPECT_EQ(in_main("float s; if (true) { s = 0.; } else s = 1.;"), Befores{});
    EXPECT_EQ(in_main("float s = 1.; { float s; s = 2.; }"), Befores{}) << "another variable";
    EXPECT_EQ(in_main("int n = 1; float s; switch (n) { case 0: s = 1.; break; case 1: s = 2.; s = 3.; }"),
              Befores{"s = 3."})
        << "the first case was not run";
    EXPECT_EQ(in_main("vec3 v; v.x = 1.; v = vec3(0.); v.x = 2.;"), Befores{"v.x = 2."}) << "all of it";
    EXPECT_EQ(in_main("float a[2]; a[0] = 1.; a[1] = 2.;"), Befores{});
    EXPECT_EQ(in_main("float t = 1., s = 0.; s = t;"), Befores{"s = t"});
    EXPECT_EQ(in_main("w = 2.; u = 2.;", "float w = 1., u;\n"), Befores{"w = 2."});
    EXPECT_EQ(in_main("", "void f(in float a, inout float b, out float c) { a = 1.; b = 1.; c = 1.; c = 2.; }\n"),
              (Befores{"a = 1.", "b = 1.", "c = 2."}));
    EXPECT_EQ(in_main("float x, y = 0.; set(x); set(y);", "void set(out float c) { c = 1.; }\n"), Befores{"set(y)"});
    EXPECT_EQ(in_main("set(); gl_FragColor = vec4(0.); set();",
                      "void deep() { gl_FragColor.rgb = vec3(1.); }\nvoid set() { deep(); }\n"),
              (Befores{"set()", "gl_FragColor = vec4(1.)"}));
    EXPECT_EQ(in_main("gl_FragDepth = .5;"), Befores{"gl_FragDepth = .5"}) << "the surface has one";
}

TEST_F(FoundOmissions, OutputsOfTheVertexStageKeepAValue) {
    const Found found = found_in_text(
        folder_, "Vertex o.vert\nFragment a.frag\nProgram P\nBox\n",
        {{"o.vert",
          "varying vec4 vCol;\nvoid main() { vCol = vec4(0.); vCol = gl_Color; gl_Position = ftransform(); }\n"},
         {"a.frag", "varying vec4 vCol;\nvoid main() { gl_FragColor = vCol; }\n"}},
        add_omissions);
    EXPECT_EQ(left_out(found, ChangeKind::no_statement), Befores{"vCol = gl_Color"});
}

TEST_F(FoundOmissions, ProgramsThatCannotBeReadAreLeftAlone) {
    EXPECT_TRUE(found("Vertex a.vert\nFragment missing.frag\nProgram P uA <0. 1. 2.>\nBox\n").changes.empty());
}

TEST_F(FoundOmissions, WhatMacrosMakeIsLeftAlone) {
    EXPECT_TRUE(
        left_out(shader("#define SET(x) x = 1.;\nvoid main() {\n    float a = 0.;\n    SET(a)\n    gl_FragColor "
                        "= vec4(a);\n}\n"),
                 ChangeKind::no_statement)
            .empty());
}

TEST_F(FoundOmissions, AtMostTwoHundred) {
    std::string many;
    for (int i = 0; i < 300; ++i) many += "Box " + std::to_string(i + 1) + "\n";
    EXPECT_EQ(found(many).changes.size(), 200u);
}

void all_changes(const Reading& reading, std::vector<Change>& changes) {
    changes = find_changes(reading.plan, reading.files, reading.sources);
}

TEST_F(FoundOmissions, AStatementIsLeftOutOnce) {
    const Found both = found_in_text(
        folder_, "Vertex a.vert\nFragment a.frag\nProgram P\nBox\n",
        {{"a.vert", "varying vec3 vN;\nvoid main() { vN = gl_Normal; gl_Position = ftransform(); }\n"},
         {"a.frag",
          "varying vec3 vN;\nvoid main() {\n    vec3 c = vN;\n    c += sin(vN);\n    if (vN.x > 0.)\n        c += "
          "cos(vN);\n    gl_FragColor = vec4(c, 1.);\n}\n"}},
        all_changes);
    EXPECT_EQ(left_out(both, ChangeKind::no_statement), Befores{});
    const Befores terms = left_out(both, ChangeKind::without_term);
    EXPECT_EQ(std::count(terms.begin(), terms.end(), "c += sin(vN);"), 1);
    EXPECT_EQ(std::count(terms.begin(), terms.end(), "c += cos(vN);"), 1);
}

// Damaged scenes and shaders: nothing but edits within the texts.
TEST(FoundTotal, StandsAnything) {
    std::uint32_t seed = 7;
    const auto random = [&](std::size_t below) {
        seed = seed * 1664525u + 1013904223u;
        return (seed >> 8) % std::max<std::size_t>(below, 1);
    };
    constexpr std::string_view pieces[] = {"(",    ")",   "{", "}",  ";",    "[", "=",
                                           "for(", "if(", "?", "do", "\\\n", "<", "#if 1\n"};
    const auto damaged = [&](std::string text) {
        for (int n = 0; n < 4; ++n) {
            const std::size_t at = random(text.size()), length = random(12);
            text.replace(at, std::min(length, text.size() - at), pieces[random(std::size(pieces))]);
        }
        return text;
    };
    for (const char* path : {"scenes/light/glass/glass.glib", "scenes/light/end-to-end/end-to-end.glib",
                             "scenes/refraction-room/refraction-room.glib", "tests/cases/Ladder.glib"}) {
        const Found whole = found_in(path, all_changes);
        for (int round = 0; round < 12; ++round) {
            std::map<std::string, std::string> texts;
            for (FileId file = 0; file < whole.sources.size(); ++file)
                if (std::filesystem::exists(whole.sources.name(file)))
                    texts[std::string(whole.sources.name(file))] = damaged(std::string(whole.sources.text(file)));
            const Found found =
                found_in(path, all_changes, std::make_shared<const std::map<std::string, std::string>>(texts));
            for (const Change& change : found.changes)
                for (const Edit& edit : change.edits)
                    ASSERT_LE(edit.span.end, found.sources.text(edit.span.file).size());
        }
    }
    const std::string deep(5000, '('), sum = [] {
        std::string text = "float x = 1.";
        for (int i = 0; i < 5000; ++i) text += " + x";
        return text + ";\n";
    }();
    for (const std::string& body :
         {deep, sum, "x = " + deep + ";", std::string(5000, '{'), "if(a)" + deep, "-" + std::string(5000, '-')}) {
        Scratch folder;
        found_in_text(folder, "Vertex a.vert\nFragment a.frag\nProgram P\nBox\n",
                      {{"a.vert", vertex}, {"a.frag", "void main() {\n" + body + "\n}\n"}}, all_changes);
    }
}

TEST(FoundOmissionsAll, ChangesAreSound) { expect_sound(add_omissions); }

}  // namespace
}  // namespace snell::accuracy
