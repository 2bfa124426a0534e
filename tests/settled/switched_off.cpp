// What the values of uniforms switch off is neither read nor made; what is said of the scene stays the same.
#include "tests/settled/settled.h"

namespace snell::test {
namespace {

class SwitchedOff : public ImagesTest {
protected:
    std::string two_cubes() {
        return "CubeMap 5 t0.bmp t1.bmp t2.bmp t3.bmp t4.bmp t5.bmp\n"
               "CubeMap 6 t6.bmp t7.bmp t8.bmp t9.bmp t10.bmp t11.bmp\n" +
               quad("uniform samplerCube uBent, uMirrored;\nuniform float uMix;",
                    "vec3 d = vec3(vST - .5, 1.);\n"
                    "gl_FragColor = vec4(mix(texture(uBent, d).rgb, texture(uMirrored, d).rgb, uMix), 1.);",
                    "uBent 5 uMirrored 6 uMix <0. 0. 1.>");
    }
};

TEST_F(SwitchedOff, FacesThatAWeightOfZeroDropsAreNotOpened) {
    auto without = open(two_cubes());
    expect_clean(*without);
    EXPECT_EQ(without->runtime->counters().images_decoded, 12U);
    auto off = settle(two_cubes());
    expect_clean(*off);
    EXPECT_EQ(off->runtime->counters().images_decoded, 6U);
    EXPECT_EQ(off->runtime->counters().files_opened, without->runtime->counters().files_opened - 6);
    EXPECT_EQ(off->runtime->counters().images_spared, 6U);
    EXPECT_EQ(off->runtime->counters().specialised, 1U);
    EXPECT_EQ(draw(*off), draw(*without));
    auto half = settle(two_cubes(), {"uMix=.5"});
    EXPECT_EQ(half->runtime->counters().images_decoded, 12U);
    EXPECT_EQ(half->runtime->counters().images_spared, 0U);
    EXPECT_LE(difference(draw(*half, {.sets = {"uMix=.5"}}), draw(*without, {.sets = {"uMix=.5"}})), 1);
}

// What was not loaded is loaded when a frame has another value, and the picture is that of any other runtime.
TEST_F(SwitchedOff, AnotherValueBringsEverythingBack) {
    auto document = settle(two_cubes());
    auto general = open(two_cubes());
    draw(*document);
    EXPECT_EQ(document->runtime->counters().specialised_draws, 1U);
    for (const char* value : {"uMix=1", "uMix=.25", "uMix=0"})
        EXPECT_EQ(draw(*document, {.sets = {value}}), draw(*general, {.sets = {value}})) << value;
    EXPECT_EQ(document->runtime->counters().images_decoded, 12U);
    EXPECT_EQ(document->runtime->counters().specialised_draws, 1U);
}

// 0 times a number is 0, but 0 times infinity is not: whether a factor is finite is known of some functions.
TEST_F(SwitchedOff, FactorsThatAreSurelyFinite) {
    const std::pair<const char*, bool> factors[] = {{"length(t)", true},
                                                    {"distance(t, vec3(uGain))", true},
                                                    {"cross(t, t.yzx).x", true},
                                                    {"smoothstep(.2, .4, t.r)", true},
                                                    {"smoothstep(uGain, 2., t.r)", true},
                                                    {"smoothstep(uGain, 1., t.r)", false},
                                                    {"smoothstep(0., vST.x, t.r)", false},
                                                    {"normalize(t).x", false},
                                                    {"length(t * vST.x)", false},
                                                    {"log(t.r)", false},
                                                    {"1. / t.r", false}};
    for (const auto& [factor, finite] : factors) {
        auto document = settle("Texture2D 5 t1.bmp\n" +
                               quad("uniform sampler2D uT;\nuniform float uMix, uGain;",
                                    "vec3 t = texture(uT, vST).rgb;\ngl_FragColor = vec4(vec3(.5 + uMix * " +
                                        std::string(factor) + "), 1.);",
                                    "uT 5 uMix <0. 0. 1.> uGain <0. 1. 2.>"));
        EXPECT_EQ(document->runtime->counters().images_spared, finite ? 1U : 0U) << factor;
    }
}

TEST_F(SwitchedOff, NoiseAndPassesThatOnlyDeadCodeReadsAreNotMade) {
    const std::string noise = quad("uniform sampler3D Noise3;\nuniform float uNoiseAmp;",
                                   "float n = uNoiseAmp * texture(Noise3, vec3(vST, .5)).r;\n"
                                   "gl_FragColor = vec4(vec3(.5 + n), 1.);",
                                   "uNoiseAmp <0. 0. 1.>");
    auto quiet = settle("Noise3D 16\n" + noise), loud = settle("Noise3D 16\n" + noise, {"uNoiseAmp=1"});
    EXPECT_EQ(quiet->runtime->counters().noise_bytes, 0U);
    EXPECT_EQ(loud->runtime->counters().noise_bytes, 16U * 16 * 16 * 4);
    const std::string pass =
        "Texture2D 7 16 16\nRenderToTexture 7\nOrtho -1 1 -1 1\nColor 1 0 0\nQuadXY\n"
        "RenderToTexture\n" +
        quad("uniform sampler2D uPicture;\nuniform bool uShow;",
             "gl_FragColor = vec4(0., 0., 1., 1.);\n"
             "if (uShow) gl_FragColor = texture(uPicture, vST);",
             "uPicture 7 uShow <false>");
    auto hidden = settle(pass), shown = settle(pass, {"uShow=true"});
    EXPECT_EQ(hidden->runtime->counters().targets, 0U);
    EXPECT_FALSE(has(*hidden, "unread-pass")) << "other values read it";
    EXPECT_EQ(draw(*hidden).center(), (Pixel{0, 0, 255, 255}));
    EXPECT_EQ(shown->runtime->counters().targets, 1U);
    EXPECT_EQ(draw(*shown, {.sets = {"uShow=true"}}).center(), (Pixel{255, 0, 0, 255}));
}

// A missing file stays an error although no value of now reads it, and an unbound unit a warning.
TEST_F(SwitchedOff, WhatIsSaidStaysTheSame) {
    const std::string scene =
        "Texture2D 7 missing.png\n" +
        quad("uniform sampler2D uA, uB;\nuniform float uOff, uUnused, uLeft = .5;",
             "gl_FragColor = vec4(.5 + uOff * (texture(uA, vST).rgb + texture(uB, vST).rgb + uLeft), 1.);",
             "uA 7 uB 9 uOff <0. 0. 1.> uOf 1. uUnused 2.");
    auto general = open(scene), off = settle(scene);
    const auto said = [](const Document& document) { return render(document.diagnostics, document.sources); };
    EXPECT_NE(said(*general).find("missing.png"), std::string::npos);
    EXPECT_NE(said(*general).find("texture unit 9"), std::string::npos);
    EXPECT_EQ(said(*off), said(*general));
    ASSERT_EQ(off->controls.items.size(), general->controls.items.size());
    for (std::size_t i = 0; i < off->controls.items.size(); ++i) {
        EXPECT_EQ(off->controls.items[i].name, general->controls.items[i].name);
        EXPECT_EQ(off->controls.items[i].active, general->controls.items[i].active);
        EXPECT_EQ(off->controls.items[i].value, general->controls.items[i].value);
    }
    EXPECT_EQ(draw(*off), draw(*general));
}

// A value of a uniform that nothing reads has no type: programs for values are drawn all the same.
TEST_F(SwitchedOff, UniformsThatNothingReadsDoNotMatter) {
    auto document = settle(quad("uniform float uGain;\nuniform int uIdle;",
                                "gl_FragColor = vec4(uGain > .2 ? vST.s : vST.t);", "uGain <0. .5 1.> uIdle 3.3"));
    draw(*document);
    EXPECT_EQ(document->runtime->counters().specialised_draws, 1U);
}

// A constant index that is too large would be an error.
TEST_F(SwitchedOff, AnIndexThatIsTooLargeStillCompiles) {
    auto document = settle(quad("uniform int uIndex;\nuniform float uSum;",
                                "float a[3] = float[3](vST.s, vST.t, uSum);\n"
                                "gl_FragColor = vec4(vec3(uIndex < 3 ? a[uIndex] : uSum), 1.);",
                                "uIndex <0 5 9> uSum <0. 1. 1.>"));
    expect_clean(*document);
    EXPECT_EQ(draw(*document).center(), (Pixel{255, 255, 255, 255}));
}

// Drivers need fewer elements of an array where values leave some out: the others stay where they are, and so does what
// is said of them.
TEST_F(SwitchedOff, ElementsOfArraysThatAreLeftOut) {
    const std::string scene =
        quad("uniform vec3 uColors[3];\nuniform int uCount, uDetail;\nuniform sampler2D uPictures[2];",
             "vec3 c = uColors[0];\nif (uDetail > 0) c += uColors[1];\n"
             "for (int i = 0; i < uCount; ++i) c += uColors[i];\n"
             "if (uDetail > 1) c += texture(uPictures[1], vST).rgb;\nelse c += texture(uPictures[0], vST).rgb;\n"
             "gl_FragColor = vec4(c, 1.);",
             "uColors [.1 .2 .3 .2 .1 .1 .1 .1 .2] uCount 1 uDetail <0 0 2> uPictures [5 6]");
    auto general = open(scene), off = settle(scene);
    EXPECT_EQ(render(off->diagnostics, off->sources), render(general->diagnostics, general->sources));
    EXPECT_TRUE(same_uniforms(off->controls, general->controls));
    const Picture first = draw(*general);
    EXPECT_EQ(draw(*off), first);
    EXPECT_EQ(off->runtime->counters().specialised_draws, 1U);
    const Look brighter{.sets = {"uDetail=1", "uColors=.3,.2,.1,.1,.1,.1,.2,.2,.2"}};
    EXPECT_EQ(draw(*off, brighter), draw(*general, brighter));
}

// Time, the mouse and the resolution change by themselves.
TEST_F(SwitchedOff, WhatChangesByItselfStaysAUniform) {
    auto document =
        settle(quad("uniform float uTime, uGain;\nuniform vec2 uResolution;",
                    "gl_FragColor = vec4(uGain * uTime, uResolution.x / 255., 0., 1.);", "uGain <0. 1. 2.>"));
    expect_clean(*document);
    EXPECT_TRUE(document->runtime->animated());
    EXPECT_EQ(draw(*document, {.width = 51, .time = .2}).center(), (Pixel{51, 51, 0, 255}));
    EXPECT_EQ(draw(*document, {.width = 102, .time = .4}).center(), (Pixel{102, 102, 0, 255}));
    auto still = settle(quad("uniform float uTime, uGain;", "gl_FragColor = vec4(.2 + uGain * uTime, 0., 0., 1.);",
                             "uGain <0. 0. 2.>"));
    EXPECT_FALSE(still->runtime->animated()) << "nothing that moves is seen";
}

}  // namespace
}  // namespace snell::test
