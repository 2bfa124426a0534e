// Scenes that are made to mislead: whatever is said of them is true, or nothing is said.
#include "src/accuracy/advice.h"
#include "src/accuracy/measure.h"
#include "src/accuracy/report/report.h"
#include "src/content/image/image.h"
#include "tests/accuracy/gl/common.h"
#include "tests/sanitized.h"

namespace snell::test {
namespace {

using namespace accuracy;

class Misleading : public AccuracyTest {
protected:
    // A quad over a quarter of the picture, whose colour `body` computes.
    void read_scene(const std::string& ladders, const std::string& body, const std::string& draw = "QuadXY 0 .5\n") {
        folder.write("plain.vert",
                     "#version 330 compatibility\nvoid main() { gl_Position = gl_ModelViewProjectionMatrix * "
                     "gl_Vertex; }\n");
        folder.write("body.frag",
                     "#version 330 compatibility\nuniform float uZero;\nvoid main() {\n vec3 c = vec3(.5);\n" + body +
                         "\n gl_FragColor = vec4(c, 1.);\n}\n");
        bench_of_text("Background 0 0 0\n" + ladders +
                          "Ortho -1 1 -1 1\nVertex plain.vert\nFragment body.frag\nProgram P uZero <0. 0. 1.>\n" + draw,
                      32, 32);
    }
    SweepResult sweep_of(const std::string& ladders, const std::string& body, std::size_t which = 0,
                         const std::string& draw = "QuadXY 0 .5\n") {
        read_scene(ladders, body, draw);
        Diagnostics problems;
        const auto sweeps = ladder_sweeps(plan().scene, plan().rungs, {}, From::reference, problems);
        MeasureOptions options;
        options.rounds = 9;
        options.seconds = 5;
        options.at_least = .1;
        return measure(*bench, sweeps.at(which), options);
    }
    static std::optional<std::size_t> advised(const SweepResult& sweep, const Wish& wish) {
        return choose(sweep, wish);
    }
};

TEST_F(Misleading, RungOfNothingButNanIsLastAndNeverAdvised) {
    for (const char* odd : {"sqrt(uZero - 1.)", "1. / uZero"}) {
        const SweepResult result =
            sweep_of("Ladder L <broken> rough exact\n", std::string("#if L == L_broken\n c = vec3(") + odd +
                                                            ");\n#elif L == L_rough\n c = vec3(.4);\n#endif");
        EXPECT_TRUE(std::isinf(result.rungs[0].own.light.rmse));
        EXPECT_TRUE(std::isinf(result.error(result.rungs[0])));
        EXPECT_EQ(result.rungs[0].own.nonfinite, 256U);
        EXPECT_GT(result.rungs[0].flip, .9);
        for (const Wish& wish : {Wish{}, Wish{.error = .001}, Wish{.alone = .5}, Wish{.milliseconds = 1e4}})
            EXPECT_NE(advised(result, wish), 0U);
        EXPECT_NE(advised(result, {.error = .001}), 1U);
        EXPECT_EQ(in_words(result).find("'broken' is cheaper"), std::string::npos) << in_words(result);
        EXPECT_NE(notes_text(result, result.rungs[0]).find("256 pixels NaN or infinite"), std::string::npos);
    }
}

TEST_F(Misleading, ReferenceThatIsNotFiniteSaysNothingAndNamesItsPixels) {
    const SweepResult result =
        sweep_of("Ladder L rough <exact>\n",
                 "#if L == L_exact\n if (gl_FragCoord.x > 20.) c /= uZero;\n#else\n c = vec3(.4);\n"
                 "#endif");
    EXPECT_TRUE(result.broken);
    EXPECT_FALSE(result.trusted());
    // Columns 20 to 23 of the quad, whose top row is 8.
    EXPECT_EQ(result.cannot_say,
              "the reference is NaN or infinite in 64 pixels, the first at (20, 8) from the top left");
    for (const Wish& wish : {Wish{}, Wish{.error = 1}, Wish{.milliseconds = 1e4}})
        EXPECT_EQ(advised(result, wish), std::nullopt);
    EXPECT_EQ(table_text(result).find("equal"), std::string::npos) << table_text(result);
    for (const RungResult& rung : result.rungs) EXPECT_TRUE(std::isnan(rung.flip)) << rung.name;
    EXPECT_TRUE(std::isnan(result.rungs[1].own.light.rmse));
    EXPECT_EQ(result.rungs[1].own.nonfinite, 64U);
    EXPECT_TRUE(in_words(result).starts_with("Can't say: ")) << in_words(result);
}

TEST_F(Misleading, OutputThatIsLightIsNotDecodedOnceMore) {
    const std::string ladder = "Ladder L rough <exact>\n", body = "#if L == L_rough\n c = vec3(.4);\n#endif";
    const SweepResult light = sweep_of("Output srgb\n" + ladder, body);
    EXPECT_NEAR(light.rungs[0].own.light.rmse, .1, 1e-5);
    EXPECT_NEAR(light.rungs[0].own.display.rmse, content::srgb_of_light(.5) - content::srgb_of_light(.4), 1e-5);
    const SweepResult numbers = sweep_of(ladder, body);
    EXPECT_NEAR(numbers.rungs[0].own.display.rmse, .1, 1e-5);
    EXPECT_NEAR(numbers.rungs[0].own.light.rmse, content::light_of_srgb(.5) - content::light_of_srgb(.4), 1e-5);
}

TEST_F(Misleading, DrawsThatCoverNoPixelSayNothing) {
    const SweepResult result = sweep_of("Ladder L rough <exact>\n", "#if L == L_rough\n c = vec3(.4);\n#endif", 0,
                                        "Translate 9 0 0\nQuadXY 0 .5\n");
    EXPECT_EQ(result.cannot_say, "the ladder's draws cover no pixel");
    EXPECT_TRUE(std::isnan(result.rungs[1].whole.light.psnr)) << "no number stands beside what is unknown";
    EXPECT_TRUE(std::isnan(result.rungs[1].flip));
    EXPECT_EQ(table_text(result).find("nan"), std::string::npos) << table_text(result);
    EXPECT_FALSE(result.broken);
    EXPECT_FALSE(result.trusted());
    EXPECT_EQ(advised(result, {}), std::nullopt);
}

// The quad has 16 x 16 pixels. The last rung draws the left quarter of them; what another rung draws beside it is an
// error there, of the light of .5 against black.
TEST_F(Misleading, RungThatDrawsWhatTheReferenceDiscardsIsWrongThere) {
    const double light = content::light_of_srgb(.5);
    const SweepResult result = sweep_of("Ladder CUT none half <exact>\n",
                                        "#if CUT == CUT_exact\n if (gl_FragCoord.x > 12.) discard;\n"
                                        "#elif CUT == CUT_half\n if (gl_FragCoord.x > 16.) discard;\n#endif");
    EXPECT_EQ(result.own_pixels, 256U);
    EXPECT_NEAR(result.rungs[0].own.light.rmse, light * std::sqrt(.75), 1e-5);
    EXPECT_NEAR(result.rungs[0].alone.rmse, light * std::sqrt(.75), 1e-5);
    EXPECT_NEAR(result.rungs[1].own.light.rmse, light * std::sqrt(.25), 1e-5) << "over the same pixels";
    EXPECT_NEAR(result.rungs[2].own.light.rmse, 0, 1e-6);
    EXPECT_FALSE(result.rungs[0].below_residual);
    EXPECT_EQ(in_words(result).find("not told apart"), std::string::npos) << in_words(result);
    for (const Wish& wish : {Wish{.error = .001}, Wish{.alone = .001}}) EXPECT_EQ(advised(result, wish), 2U);
}

TEST_F(Misleading, ReferenceThatDiscardsEverythingIsComparedWhereOthersDraw) {
    const SweepResult result =
        sweep_of("Ladder CUT none <all>\n", "#if CUT == CUT_all\n if (uZero < 1.) discard;\n#endif");
    EXPECT_EQ(result.cannot_say, "");
    EXPECT_EQ(result.own_pixels, 256U);
    EXPECT_NEAR(result.rungs[0].own.light.rmse, content::light_of_srgb(.5), 1e-5);
}

// Where the scene stands, OTHER discards nothing, so the mistake of CUT is visible there alone.
TEST_F(Misleading, MistakeElsewhereCountsWhereTheReferenceDrawsNothing) {
    const SweepResult result = sweep_of("Ladder CUT wrong <right>\nLadder OTHER <keep> cut\n",
                                        "#if OTHER == OTHER_cut\n if (gl_FragCoord.x > 12.) discard;\n#endif\n"
                                        "#if CUT == CUT_wrong\n if (gl_FragCoord.x > 12.) c = vec3(.9);\n#endif");
    EXPECT_EQ(result.own_pixels, 256U);
    EXPECT_NEAR(result.rungs[0].own.light.rmse, 0, 1e-6);
    ASSERT_TRUE(result.rungs[0].elsewhere);
    EXPECT_NEAR(result.rungs[0].elsewhere->rmse,
                (content::light_of_srgb(.9) - content::light_of_srgb(.5)) * std::sqrt(.75), 1e-5);
    EXPECT_TRUE(result.rungs[0].hidden());
}

TEST_F(Misleading, RungThatIsNanBesideTheReferenceIsLastAndNeverAdvised) {
    const SweepResult result =
        sweep_of("Ladder CUT broken <exact>\n",
                 "#if CUT == CUT_exact\n if (gl_FragCoord.x > 12.) discard;\n float x = gl_FragCoord.x;\n"
                 "for (int i = 0; i < 4000; ++i) x = x * .999 + uZero * sin(x);\nc += 1e-30 * x;\n"
                 "#else\n if (gl_FragCoord.x > 12.) c = vec3(sqrt(uZero - 1.));\n#endif");
    const RungResult& broken = result.rungs[0];
    EXPECT_EQ(broken.own.nonfinite, 192U);
    EXPECT_TRUE(std::isinf(result.error(broken)));
    EXPECT_FALSE(broken.below_residual);
    EXPECT_NE(broken.verdict.standing, Standing::front) << "although it is the cheaper one";
    EXPECT_EQ(notes_text(result, broken).find("front"), std::string::npos) << notes_text(result, broken);
    for (const Wish& wish : {Wish{}, Wish{.error = .001}, Wish{.alone = 1}, Wish{.milliseconds = 1e4}})
        EXPECT_NE(advised(result, wish), 0U);
}

// The last rung of BEND overwrites what SHARE computed, so a mistake has no error with the others at the reference.
TEST_F(Misleading, RungThatTheReferenceHidesIsFlaggedAndNotAdvised) {
    const std::string ladders = "Ladder SHARE wrong <right>\nLadder BEND <one> all\n";
    const std::string body =
        "#if SHARE == SHARE_wrong\n c = vec3(.9);\n#endif\n#if BEND == BEND_all\n c = vec3(.3);\n#endif";
    const SweepResult result = sweep_of(ladders, body);
    EXPECT_NEAR(result.rungs[0].own.light.rmse, 0, 1e-6);
    ASSERT_TRUE(result.rungs[0].elsewhere);
    EXPECT_NEAR(result.rungs[0].elsewhere->rmse, content::light_of_srgb(.9) - content::light_of_srgb(.5), 1e-5);
    EXPECT_TRUE(result.rungs[0].hidden());
    EXPECT_FALSE(result.rungs[1].hidden());
    EXPECT_NE(in_words(result).find("'wrong' is hidden by another ladder's rung"), std::string::npos)
        << in_words(result);
    const Wish wish{.error = .004};
    MeasureOptions options;
    options.rounds = 15;
    options.seconds = 20;
    options.at_least = .1;
    const Counsel counsel = advise(*bench, plan().rungs, {&wish, 1}, options);
    const Advice& advice = counsel.advice.at(0);
    const SweepResult& all = counsel.sweeps.at(advice.sweep);
    if (all.trusted()) {
        EXPECT_EQ(all.rungs.at(advice.rung).name, "right all");
    }
}

// In this scene the last rung of BEND once overwrote what FRESNEL had computed.
TEST_F(Misleading, CrystalHidesNoMistakeOfItsFresnel) {
    Bench& b = bench_of(SNELL_ROOT "/scenes/light/crystal/crystal.glib", 20, 20);
    Rungs rungs = last_rungs(plan().scene);
    const auto last = b.picture({rungs, {}});
    rungs.at(0) = 0;
    ASSERT_EQ(plan().scene.ladders.at(0).rungs.at(0), "swapped");
    const auto swapped = b.picture({rungs, {}});
    ASSERT_TRUE(last && swapped);
    EXPECT_GT(compare(*swapped, *last, where_different(*swapped, *last)).light.rmse, .05);
}

TEST_F(Misleading, RungsThatDoNothingAreTiesThatTheLastOneWins) {
    const SweepResult result = sweep_of("Ladder L <a> b c\n", "#if L == 99\n c = vec3(0.);\n#endif");
    for (const RungResult& rung : result.rungs) {
        EXPECT_NEAR(rung.own.light.rmse, 0, 1e-6);
        EXPECT_TRUE(rung.below_residual);
        EXPECT_EQ(notes_text(result, rung).find("exact"), std::string::npos);
    }
    EXPECT_EQ(in_words(result).find("best value"), std::string::npos) << in_words(result);
}

// Only the facets of a coarse ball are seen: 'fine' and 'finer' differ by less than the reference is wrong.
TEST_F(Misleading, NothingIsRankedBelowTheResidualOfTheReference) {
    folder.write("shade.vert",
                 "#version 330 compatibility\nout vec3 vN;\nvoid main() { vN = gl_Normal; gl_Position = "
                 "gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("shade.frag", R"(#version 330 compatibility
in vec3 vN;
void main() {
    float c = .5 + .4 * sin(40. * vN.x);
#if L == L_close
    c += .0005;
#elif L == L_far
    c += .2;
#endif
    gl_FragColor = vec4(vec3(c), 1.);
}
)");
    bench_of_text(
        "Background 0 0 0\nLadder L far close <last>\nPerspective 40\nLookAt 0 0 3 0 0 0 0 1 0\nVertex "
        "shade.vert\nFragment shade.frag\nProgram S\nSphere 1 20 20\n",
        64, 64);
    Diagnostics problems;
    const auto sweeps = ladder_sweeps(plan().scene, plan().rungs, {}, From::reference, problems);
    MeasureOptions options;
    options.times = false;
    References coarse(0);  // seconds: the scene's own samples, and no finer ones to compare with
    options.references = &coarse;
    const SweepResult unknown = measure(*bench, sweeps.at(0), options);
    EXPECT_FALSE(unknown.residual);
    EXPECT_NE(unknown.reference_note.find("not known how good"), std::string::npos);
    options.references = nullptr;
    const SweepResult result = measure(*bench, sweeps.at(0), options);
    ASSERT_TRUE(result.residual);
    EXPECT_GT(*result.residual, 0);
    // All pixels where the two references differ are counted, so it is no less in total.
    ASSERT_TRUE(result.whole_residual);
    const auto pixels = static_cast<double>(result.reference.pixels());
    ASSERT_EQ(result.reference.pixels(), result.rungs[0].picture.pixels());
    const auto own = static_cast<double>(result.own_pixels > 0 ? result.own_pixels : result.reference.pixels());
    EXPECT_GE(*result.whole_residual * std::sqrt(pixels), *result.residual * std::sqrt(own) * (1 - 1e-9));
    for (const RungResult& rung : result.rungs)
        EXPECT_EQ(compare(rung.picture, result.reference).light.rmse, rung.whole.light.rmse) << rung.name;
    EXPECT_GE(result.finest.grid, 4);
    EXPECT_TRUE(result.reference_note.starts_with("reference good to ")) << result.reference_note;
    const RungResult &far = result.rungs[0], &close = result.rungs[1], &last = result.rungs[2];
    EXPECT_LT(close.alone.rmse, .001);
    EXPECT_GT(last.own.light.rmse, 5 * *result.residual) << "facets and one sample a pixel";
    EXPECT_NEAR(close.own.light.rmse, last.own.light.rmse, .02 * last.own.light.rmse);
    EXPECT_GT(far.own.light.rmse, 2 * last.own.light.rmse);
    for (const RungResult& rung : result.rungs) EXPECT_GE(result.error(rung), *result.residual);
    EXPECT_EQ(table_text(result).find("exact"), std::string::npos) << table_text(result);
}

// An edge that is antialiased only where a pixel's centre is inside: the samples of the reference see it.
TEST_F(Misleading, RimIsJudgedByTheSamplesOfTheReference) {
    const SweepResult result = sweep_of("Ladder L <centre> covered\n", "", 0, "Rotate 20 0 0 1\nQuadXY 0 .5\n");
    EXPECT_GT(result.rungs[1].own.light.rmse, .01) << "the last rung, which is not 'exact'";
    EXPECT_EQ(result.rungs[1].alone.rmse, 0);
}

TEST_F(Misleading, FirstDrawnIsNotTheDearest) {
    // Every rung costs the same; the order in which they are measured is the only difference.
    int claims = 0;
    const SweepResult result =
        sweep_of("Ladder L a b c d <e>\n",
                 "float x = gl_FragCoord.x;\nfor (int i = 0; i < 400; ++i) x = x * .999 + uZero * "
                 "sin(x);\nc += 1e-30 * x;\n#if L == L_a\n c += .1;\n#endif");
    for (const RungResult& rung : result.rungs)
        claims += rung.verdict.standing == Standing::dominated && result.trusted();
    EXPECT_EQ(claims, 0) << table_text(result);
}

TEST_F(Misleading, BudgetHoldsWithinAFactorOfTwo) {
    const std::string body =
        "float x = gl_FragCoord.x;\nfor (int i = 0; i < 800; ++i) x = x * .999 + uZero * sin(x);\n"
        "c += 1e-30 * x;";
    read_scene("Ladder L a b <c>\n", body, "Sphere 1 30 30\n");
    Diagnostics problems;
    std::vector<Sweep> sweeps = ladder_sweeps(plan().scene, plan().rungs, {}, From::reference, problems);
    for (Sweep& sweep :
         knob_sweeps(plan().scene, plan().rungs, {"samples", "tessellation"}, From::reference, true, problems))
        sweeps.push_back(std::move(sweep));
    const auto start = std::chrono::steady_clock::now();
    References references(.2);
    for (const Sweep& sweep : sweeps) {
        MeasureOptions options;
        options.seconds = .2;
        options.references = &references;
        measure(*bench, sweep, options);
    }
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_LT(took, 2 * (.2 + .2 * static_cast<double>(sweeps.size())) * patience);
}

}  // namespace
}  // namespace snell::test
