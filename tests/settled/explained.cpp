// What values switch off is said with the uniform that does it.
#include "tests/settled/settled.h"

namespace snell::test {
namespace {

class Explained : public ImagesTest {
protected:
    using Row = Explanation::SwitchedOff;
    using Kind = Explanation::Kind;

    static Explanation explain(Document& document) {
        while (document.runtime->find_switched_off()) continue;
        return document.runtime->explain();
    }
    static std::vector<std::string> names(const Row& row, Kind kind) {
        std::vector<std::string> found;
        for (const Row::Part& part : row.parts)
            if (part.kind == kind) found.push_back(part.name);
        return found;
    }
    static bool unused(const Explanation& explanation, std::string_view name) {
        return std::ranges::any_of(explanation.unused, [&](const auto& one) { return one.name.starts_with(name); });
    }
    using Names = std::vector<std::string>;
};

TEST_F(Explained, AWeightOfZeroIsNamedWithTheFilesThatItSpares) {
    const std::string scene =
        "CubeMap 5 t0.bmp t1.bmp t2.bmp t3.bmp t4.bmp t5.bmp\n"
        "CubeMap 6 t6.bmp t7.bmp t8.bmp t9.bmp t10.bmp t11.bmp\n" +
        quad(
            "uniform samplerCube uBent, uMirrored;\nuniform float uMix;\nvec3 mirrored(vec3 d) { return "
            "texture(uMirrored, d).rgb; }",
            "vec3 d = vec3(vST - .5, 1.);\ngl_FragColor = vec4(mix(texture(uBent, d).rgb, mirrored(d), uMix), 1.);",
            "uBent 5 uMirrored 6 uMix <0. 0. 1.>");
    auto document = settle(scene);
    EXPECT_EQ(document->runtime->explain().switched_off.size(), 1U) << "all that is known so far: together";
    const std::uint64_t compiled = document->runtime->counters().programs_compiled;
    const Explanation explanation = explain(*document);
    EXPECT_EQ(document->runtime->counters().programs_compiled, compiled) << "nothing is drawn with these";
    ASSERT_EQ(explanation.switched_off.size(), 1U);
    const Row& row = explanation.switched_off[0];
    EXPECT_EQ(row.uniform, "uMix");
    EXPECT_EQ(row.program_name, "P");
    EXPECT_EQ(row.value, "0");
    ASSERT_TRUE(row.span);
    EXPECT_EQ(document->sources.text(row.span->file).substr(row.span->begin, 4), "uMix");
    EXPECT_EQ(names(row, Kind::sampler), Names{"samplerCube uMirrored"});
    EXPECT_EQ(row.parts[0].functions, Names{"mirrored (fragment)"});
    ASSERT_EQ(names(row, Kind::cube_map), Names{"CubeMap 6 t6.bmp"});
    EXPECT_EQ(row.parts[1].files, (Names{"t6.bmp", "t7.bmp", "t8.bmp", "t9.bmp", "t10.bmp", "t11.bmp"}));
    EXPECT_EQ(row.parts[1].bytes, 6 * std::filesystem::file_size(folder.path("t6.bmp")));
    EXPECT_FALSE(unused(explanation, "CubeMap 6")) << "it is used, for other values";
    auto half = settle(scene, {"uMix=.5"});
    EXPECT_TRUE(explain(*half).switched_off.empty());
    auto general = open(scene);
    EXPECT_FALSE(general->runtime->find_switched_off());
    EXPECT_TRUE(general->runtime->explain().switched_off.empty());
}

TEST_F(Explained, WhatOnlySeveralValuesSwitchOffIsARowOfItsOwn) {
    auto document = settle("Texture2D 5 t1.bmp\nTexture2D 6 t2.bmp\n" +
                           quad("uniform sampler2D uBoth, uOwn;\nuniform float uA, uB, uC;",
                                "vec3 c = vec3(.5);\nif (uA > 0. || uB > 0.) c += texture(uBoth, vST).rgb;\n"
                                "if (uC > 0.) c += texture(uOwn, vST).rgb;\ngl_FragColor = vec4(c, 1.);",
                                "uBoth 5 uOwn 6 uA <0. 0. 1.> uB <0. 0. 1.> uC <0. 0. 1.>"));
    const Explanation explanation = explain(*document);
    ASSERT_EQ(explanation.switched_off.size(), 2U);
    EXPECT_EQ(explanation.switched_off[0].uniform, "uC");
    EXPECT_EQ(names(explanation.switched_off[0], Kind::sampler), Names{"sampler2D uOwn"});
    EXPECT_EQ(names(explanation.switched_off[0], Kind::image), Names{"Texture2D 6 t2.bmp"});
    EXPECT_EQ(explanation.switched_off[1].uniform, "");
    EXPECT_EQ(names(explanation.switched_off[1], Kind::sampler), Names{"sampler2D uBoth"});
    EXPECT_EQ(names(explanation.switched_off[1], Kind::image), Names{"Texture2D 5 t1.bmp"});
}

// That the other factors are finite is known by the values of other uniforms, which switch nothing off themselves.
TEST_F(Explained, OtherValuesSayHowLargeAFactorIs) {
    auto document = settle("Texture2D 5 t1.bmp\n" +
                           quad("uniform sampler2D uOwn;\nuniform float uMix, uGain;\nuniform vec3 uTint;",
                                "gl_FragColor = vec4(vec3(.5) + uMix * (uGain * uTint * texture(uOwn, vST).rgb), 1.);",
                                "uOwn 5 uMix <0. 0. 1.> uGain <0. 2. 4.> uTint {1. .5 .5}"));
    const Explanation explanation = explain(*document);
    ASSERT_EQ(explanation.switched_off.size(), 1U);
    EXPECT_EQ(explanation.switched_off[0].uniform, "uMix");
    EXPECT_EQ(names(explanation.switched_off[0], Kind::sampler), Names{"sampler2D uOwn"});
    EXPECT_EQ(names(explanation.switched_off[0], Kind::image), Names{"Texture2D 5 t1.bmp"});
}

TEST_F(Explained, WhatNothingNeedsAnywayIsSwitchedOffByNoValue) {
    auto document =
        settle("Texture2D 5 t1.bmp\n" + quad("uniform sampler2D uOwn;\nuniform float uMix, uDead;",
                                             "float dead = uDead * vST.t;\nvec3 c = vec3(.5);\n"
                                             "if (uMix > 0.) c += texture(uOwn, vST).rgb;\ngl_FragColor = vec4(c, 1.);",
                                             "uOwn 5 uMix <0. 0. 1.> uDead <0. .5 1.>"));
    const Explanation explanation = explain(*document);
    ASSERT_EQ(explanation.switched_off.size(), 1U);
    EXPECT_EQ(explanation.switched_off[0].uniform, "uMix");
    EXPECT_EQ(names(explanation.switched_off[0], Kind::uniform), Names{});
    EXPECT_EQ(names(explanation.switched_off[0], Kind::sampler), Names{"sampler2D uOwn"});
    EXPECT_TRUE(unused(explanation, "uDead of P"));
    EXPECT_FALSE(unused(explanation, "uOwn") || unused(explanation, "uMix"));
}

// Another row for each value that alone switches it off, and for the other uniforms that nothing reads then.
TEST_F(Explained, NoiseAndUniformsAreNamed) {
    auto document =
        settle("Noise3D 16\n" + quad("uniform sampler3D Noise3;\nuniform float uAmp, uFreq;\nuniform bool uOn;",
                                     "float n = 0.;\nif (uOn) n = uAmp * texture(Noise3, uFreq * vec3(vST, "
                                     ".5)).r;\ngl_FragColor = vec4(vec3(.5 + n), 1.);",
                                     "uAmp <0. 0. 1.> uFreq <0. 3. 9.> uOn <false>"));
    const Explanation explanation = explain(*document);
    ASSERT_EQ(explanation.switched_off.size(), 2U);
    const Row& amp = explanation.switched_off[0];
    EXPECT_EQ(amp.uniform, "uAmp");
    EXPECT_EQ(names(amp, Kind::noise), Names{"Noise3"});
    EXPECT_EQ(names(amp, Kind::uniform), Names{"float uFreq"});
    const Row& on = explanation.switched_off[1];
    EXPECT_EQ(on.uniform, "uOn");
    EXPECT_EQ(on.value, "false");
    EXPECT_EQ(names(on, Kind::uniform), (Names{"float uAmp", "float uFreq"}));
}

// A pass that is not drawn because of a value, with the image that only its draws read.
TEST_F(Explained, PassesComeWithWhatOnlyTheyRead) {
    const std::string pass =
        "Vertex plain.vert\nFragment texture.frag\nOrtho -1 1 -1 1\nTexture2D 7 16 16\nTexture2D 8 t3.bmp\n"
        "RenderToTexture 7\nProgram Inner uUnit 8\nQuadXY\nRenderToTexture\n" +
        quad("uniform sampler2D uPicture;\nuniform bool uShow;",
             "gl_FragColor = vec4(0., 0., 1., 1.);\nif (uShow) gl_FragColor = texture(uPicture, vST);",
             "uPicture 7 uShow <false>");
    auto hidden = settle(pass);
    expect_clean(*hidden);
    const Explanation explanation = explain(*hidden);
    ASSERT_EQ(explanation.switched_off.size(), 1U);
    const Row& row = explanation.switched_off[0];
    EXPECT_EQ(row.uniform, "uShow");
    EXPECT_EQ(names(row, Kind::pass), Names{"RenderToTexture"});
    EXPECT_EQ(names(row, Kind::empty_texture), Names{"Texture2D 7"});
    EXPECT_EQ(names(row, Kind::image), Names{"Texture2D 8 t3.bmp"});
    for (const char* name : {"RenderTo", "Texture2D"}) EXPECT_FALSE(unused(explanation, name)) << name;
    EXPECT_EQ(hidden->runtime->counters().images_spared, 1U);
    EXPECT_TRUE(hidden->runtime->sampled(1)) << "by other values";
}

// Harmonics are no sampler, but they are computed from a cube map.
TEST_F(Explained, HarmonicsComeWithTheirCubeMap) {
    const std::string body = quad("uniform vec3 uHarmonics[9];\nuniform float uLight;",
                                  "gl_FragColor = vec4(vec3(.5) + uLight * uHarmonics[0], 1.);", "uLight <0. 0. 1.>");
    const std::string faces = "CubeMap 6 t6.bmp t7.bmp t8.bmp t9.bmp t10.bmp ";
    auto document = settle(faces + "t11.bmp\nIrradiance 7 6\n" + body);
    expect_clean(*document);
    EXPECT_EQ(document->runtime->counters().convolutions, 0U);
    EXPECT_EQ(document->runtime->counters().images_spared, 6U);
    const Explanation explanation = explain(*document);
    ASSERT_EQ(explanation.switched_off.size(), 1U);
    EXPECT_EQ(names(explanation.switched_off[0], Kind::uniform), Names{"vec3 uHarmonics"});
    EXPECT_EQ(names(explanation.switched_off[0], Kind::cube_map), Names{"CubeMap 6 t6.bmp"});
    EXPECT_FALSE(unused(explanation, "CubeMap 6"));
    const auto said = [](const Document& one) { return render(one.diagnostics, one.sources); };
    for (const std::string& scene : {faces + "missing.bmp\nIrradiance 7 6\n" + body, body}) {
        const std::string as_ever = said(*open(scene));
        EXPECT_NE(as_ever, "");
        EXPECT_EQ(said(*settle(scene)), as_ever) << "whatever the value is";
    }
}

// The map itself is not sampled, but what is computed from it is.
TEST_F(Explained, ASourceThatOtherValuesSampleIsNotUnused) {
    auto document = settle("CubeMap 6 t0.bmp t1.bmp t2.bmp t3.bmp t4.bmp t5.bmp\nIrradiance 7 6\n" +
                           quad("uniform samplerCube uSharp, uSoft;\nuniform float uMix;",
                                "vec3 d = vec3(vST - .5, 1.);\n"
                                "gl_FragColor = vec4(mix(texture(uSoft, d).rgb, texture(uSharp, d).rgb, uMix), 1.);",
                                "uSharp 6 uSoft 7 uMix <0. 0. 1.>"));
    expect_clean(*document);
    EXPECT_FALSE(unused(explain(*document), "CubeMap 6"));
}

TEST_F(Explained, FormsOfOtherValuesSayNothing) {
    auto document =
        settle("Texture2D 5 t1.bmp\n" + quad("uniform sampler2D uA;\nuniform float uMix;",
                                             "gl_FragColor = vec4(vec3(.5) + uMix * texture(uA, vST).rgb, 1.);",
                                             "uA 5 uMix <0. 0. 1.>"));
    EXPECT_NE(document->runtime->form(), 0);
    EXPECT_EQ(explain(*document).switched_off.size(), 1U);
    draw(*document, {.sets = {"uMix=.5"}});
    EXPECT_EQ(document->runtime->form(), 0) << "programs for any values";
    EXPECT_TRUE(explain(*document).switched_off.empty());
}

}  // namespace
}  // namespace snell::test
