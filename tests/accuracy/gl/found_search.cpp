// Changes whose errors are known: what a search says of them must be that.
#include <malloc.h>

#include "src/accuracy/found/search.h"
#include "tests/accuracy/gl/common.h"

namespace snell::test {
namespace {

using namespace accuracy;

class FoundSearch : public AccuracyTest {
protected:
    void read_scene(std::string_view scene) { bench_of_text(scene, 32, 32); }

    FoundResult search(std::vector<Change> changes, bool times = false, std::uint64_t seed = 1,
                       std::vector<std::string> sets = {}) {
        SearchOptions options;
        options.places.seed = seed;
        options.times = times;
        options.rounds = 15;
        options.at_least = .5;
        return search(std::move(changes), options, {32, 32, 0, std::move(sets)});
    }
    FoundResult search(std::vector<Change> changes, const SearchOptions& options,
                       const BenchSettings& settings = {32, 32, 0, {}}) {
        Search found({folder.path("scene.glib"), read->plan, *read->files, read->sources}, std::move(changes), caps,
                     settings, options);
        while (found.step()) continue;
        return found.take();
    }
};

constexpr std::string_view full_scene =
    "Vertex full.vert\nFragment full.frag\nProgram Full uGain <1. 1. 1.>\nQuadXY 0 1\n";

// What is searched in small pictures is estimated in whole ones: a sphere of many vertices counts for less there.
TEST_F(FoundSearch, EstimatesAreOfTheScenesOwnSize) {
    mallopt(M_MMAP_THRESHOLD, 4 << 20);  // as the program does: otherwise frames with many vertices wait for pages
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    write_full(
        "void main() { float x = gl_FragCoord.x; for (int i = 0; i < 24; ++i) x = sin(x); gl_FragColor = vec4(x); }\n");
    read_scene(std::string(full_scene) + "Vertex full.vert\nProgram Full\nSphere .01 200 200\n");
    SearchOptions options;
    options.pixels = 1024;
    options.rounds = 25;
    options.at_least = 4;
    const FoundResult found =
        search({change(ChangeKind::fewer_slices, "200 200", "50 50")}, options, {256, 256, 0, {}});
    const std::array<int, 2> small{32, 32}, whole{256, 256};
    EXPECT_EQ((std::array{found.search_width, found.search_height}), small);
    EXPECT_EQ(found.quick_size, whole);
    const RungResult* times = found.times(found.rungs.at(0));
    ASSERT_TRUE(times);
    EXPECT_NEAR(found.rungs[0].quick_ratio / times->ratio.middle, 1, .25) << "in small pictures, half";
}

// Numbers of the whole picture are of it: black around a quad is alike in both.
TEST_F(FoundSearch, TheWholePictureHasFiguresOfItsOwn) {
    folder.write("part.vert", "varying vec2 vP;\nvoid main() { vP = gl_Vertex.xy; gl_Position = vec4(vP, 0., 1.); }\n");
    folder.write("part.frag", "varying vec2 vP;\nvoid main() { gl_FragColor = vec4(.7 + .2 * vP.x); }\n");
    read_scene("Background 0 0 0\nVertex part.vert\nFragment part.frag\nProgram Part\nQuadXY 0 .5\n");
    const FoundResult found = search({change(ChangeKind::fewer_rounds, "* vP.x", "* vP.y")});
    const Difference& difference = found.rungs.at(0).at.at(0);
    EXPECT_EQ(difference.whole.pixels, 32u * 32u);
    EXPECT_EQ(difference.own.pixels, 16u * 16u);
    EXPECT_NEAR(difference.own.correlation, 0, .05);
    EXPECT_GT(difference.whole.correlation, .9);
    EXPECT_NEAR(difference.whole.light.rmse, difference.own.light.rmse / 2, 1e-9) << "a quarter of the pixels";
}

TEST_F(FoundSearch, AnErrorIsTheOneThatHalfOfTheRoundsMake) {
    // Linear light: 8 rounds of 1/16 give .5, of which 4 rounds are .25; both are encoded by the curve of sRGB.
    write_full(R"(
float encoded(float x) { return x <= .0031308 ? 12.92 * x : 1.055 * pow(x, 1. / 2.4) - .055; }
void main() {
    float sum = 0.;
    for (int i = 0; i < 8; ++i) sum += 1. / 16.;
    gl_FragColor = vec4(vec3(encoded(sum)), 1.);
}
)");
    read_scene(full_scene);
    const FoundResult found = search({change(ChangeKind::fewer_rounds, "i < 8", "i < 4")});
    ASSERT_EQ(found.rungs.size(), 1u);
    const FoundRung& rung = found.rungs[0];
    ASSERT_EQ(rung.outcome, Outcome::tried) << rung.reason;
    EXPECT_EQ(rung.name, "1");
    EXPECT_TRUE(rung.held_out);
    ASSERT_EQ(rung.at.size(), 8u);
    for (const Difference& at : rung.at) EXPECT_NEAR(at.own.light.rmse, .25, 1e-5);
    EXPECT_EQ(rung.worst()->pixels_changed, 32u * 32u);
    EXPECT_NEAR(rung.worst()->own.display.rmse, 1.055 * (std::pow(.5, 1 / 2.4) - std::pow(.25, 1 / 2.4)), 1e-5);
    EXPECT_TRUE(found.positions[0].ends_with("full.frag:6:21")) << found.positions[0];
}

TEST_F(FoundSearch, FacesThatFaceAwayAreNotSeenFromOutsideAndAllThatIsSeenFromInside) {
    folder.write("a.vert", "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n");
    folder.write("a.frag",
                 "#version 330 compatibility\nvoid main() { gl_FragColor = vec4(gl_FrontFacing ? .9 : .1); }\n");
    const std::string program = "Background 0 0 0\nVertex a.vert\nFragment a.frag\nProgram A\n";
    read_scene(program + "Ortho -2 2 -2 2\nSphere 1 24 24\n");
    const auto worst = [&](const FoundResult& found) { return found.rungs[0].worst()->whole.light.rmse; };
    // At the rim, a fragment of the far side may be as near as one of the near side.
    EXPECT_LT(worst(search({change(ChangeKind::culled, "Sphere", "CullFace back\nSphere")})), .02);
    EXPECT_GT(worst(search({change(ChangeKind::culled, "Sphere", "CullFace front\nSphere")})), .02);
    read_scene(program + "Perspective 60\nLookAt 0 0 0  0 0 1  0 1 0\nSphere 9 24 24\n");
    const FoundResult inside = search({change(ChangeKind::culled, "Sphere", "CullFace back\nSphere")});
    EXPECT_EQ(inside.rungs[0].worst()->pixels_changed, 32u * 32u);
}

TEST_F(FoundSearch, WhatIsHarmlessOnlyAtTheScenesOwnValuesIsFoundOut) {
    write_full("uniform float uMix;\nvoid main() { gl_FragColor = vec4(vec3(.5 + .4 * uMix), 1.); }\n");
    read_scene("Vertex full.vert\nFragment full.frag\nProgram Full uMix <0. 0. 1.>\nQuadXY 0 1\n");
    const FoundResult found = search({change(ChangeKind::without_term, " + .4 * uMix", "")});
    const FoundRung& rung = found.rungs[0];
    EXPECT_EQ(rung.at[0].pixels_changed, 0u);
    EXPECT_GT(rung.pixels_changed, 0u);
    EXPECT_GT(rung.worst()->own.light.rmse, .05);
}

// Otherwise a harmless change of something large would make a combination more exact than its part.
TEST_F(FoundSearch, ErrorsOfAllChangesAreOverThePixelsInWhichTheSceneDraws) {
    folder.write("a.vert", "#version 330 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n");
    folder.write("a.frag", "#version 330 compatibility\nvoid main() { gl_FragColor = vec4(1.); }\n");
    folder.write("b.frag", "#version 330 compatibility\nvoid main() { gl_FragColor = vec4(.5, .5, .5, 1.); }\n");
    // A sixteenth of the picture, behind which there is a quarter.
    read_scene(
        "Background 0 0 0\nVertex a.vert\nFragment a.frag\nProgram A\nQuadXY -.5 .25\nFragment b.frag\nProgram B\n"
        "QuadXY 0 .5\n");
    const FoundResult found = search({change(ChangeKind::without_term, "vec4(1.)", "vec4(0.)"),
                                      change(ChangeKind::fewer_cells, "QuadXY 0 .5", "QuadXY 0 .5 1 1"),
                                      change(ChangeKind::culled, "QuadXY -.5 .25", "CullFace none\nQuadXY -.5 .25")});
    ASSERT_EQ(found.rungs.size(), 3u);
    for (const FoundRung& rung : found.rungs) {
        ASSERT_FALSE(rung.at.empty()) << rung.reason;
        EXPECT_EQ(rung.at.front().own.pixels, 256u) << rung.name;
    }
    EXPECT_NEAR(found.rungs[0].at.front().own.light.rmse, .5, 1e-6) << "64 of 256 pixels";
}

// A value that --set overrides has no effect here, but it has in the scene that would be written.
TEST_F(FoundSearch, AValueThatIsSetIsNotLeftOut) {
    write_full("uniform float uGain;\nvoid main() { gl_FragColor = vec4(vec3(.5 * uGain), 1.); }\n");
    read_scene(full_scene);
    const auto omission = [&](std::vector<std::string> sets) {
        return search({change(ChangeKind::no_uniform, "uGain <1. 1. 1.>", "")}, false, 1, std::move(sets)).rungs[0];
    };
    EXPECT_EQ(omission({}).outcome, Outcome::tried);
    EXPECT_GT(omission({}).pixels_changed, 0u);
    for (const char* set : {"uGain=.7", "Full.uGain=.7"}) {
        const FoundRung rung = omission({set});
        EXPECT_EQ(rung.outcome, Outcome::refused) << set;
        EXPECT_EQ(rung.reason, "--set gives it another value");
    }
}

TEST_F(FoundSearch, AnErrorThatOnlyHeldOutPlacesShowIsMarkedAndCounts) {
    // A value that the searched places do not have and a held-out one has: the places are known, so it can be chosen.
    write_full("uniform float uMix;\nvoid main() { gl_FragColor = vec4(vec3(uMix > .5 ? .9 : .1), 1.); }\n");
    read_scene("Vertex full.vert\nFragment full.frag\nProgram Full uMix <0. 0. 1.>\nQuadXY 0 1\n");
    double searched = 1, held_out = 0;
    std::uint64_t seed = 0;
    while (held_out <= searched && seed < 20) {
        const FoundResult first = search({}, false, ++seed);
        searched = held_out = 0;
        for (std::size_t i = 0; i < first.places.size(); ++i)
            for (const std::string& set : first.places[i].sets) {
                const double value = std::stod(set.substr(set.find('=') + 1));
                double& most = i < first.searched ? searched : held_out;
                most = std::max(most, value);
            }
    }
    ASSERT_GT(held_out, searched) << "another seed has such a place";
    const std::string limit = std::to_string((searched + held_out) / 2);
    folder.write("full.frag",
                 "#version 330 compatibility\nuniform float uMix;\nvoid main() { gl_FragColor = vec4(vec3(uMix > " +
                     limit + " ? .9 : .1), 1.); }\n");
    read_scene("Vertex full.vert\nFragment full.frag\nProgram Full uMix <0. 0. 1.>\nQuadXY 0 1\n");
    const FoundResult found =
        search({change(ChangeKind::without_term, "uMix > " + limit + " ? .9 : .1", ".1")}, false, seed);
    const FoundRung& rung = found.rungs[0];
    EXPECT_EQ(rung.searched()->pixels_changed, 0u);
    ASSERT_TRUE(rung.held_out);
    EXPECT_TRUE(rung.only_where_tried);
    EXPECT_GT(rung.worst()->own.light.rmse, .5);
    ASSERT_TRUE(rung.timed);
    EXPECT_EQ(found.timed.rungs[*rung.timed].own.light.rmse, rung.worst()->own.light.rmse);
}

TEST_F(FoundSearch, ANumberThatIsNoneIsAnInfiniteError) {
    write_full("uniform float uGain;\nvoid main() { gl_FragColor = vec4(vec3(.5 * uGain), 1.); }\n");
    read_scene(full_scene);
    const FoundResult found = search({change(ChangeKind::polynomial, ".5 * uGain", "sqrt(-uGain)")});
    ASSERT_EQ(found.rungs[0].outcome, Outcome::tried);
    EXPECT_TRUE(std::isinf(found.rungs[0].worst()->own.light.rmse));
    EXPECT_TRUE(std::isinf(found.rungs[0].worst()->whole.light.rmse));
    EXPECT_FALSE(found.rungs[0].timed);
}

TEST_F(FoundSearch, WhatDoesNotCompileOrWarnsIsRefusedWithTheReason) {
    write_full("void main() { gl_FragColor = vec4(.5); }\n");
    read_scene(full_scene);
    const FoundResult found = search({change(ChangeKind::polynomial, "vec4(.5)", "vec4(x)"),
                                      change(ChangeKind::no_draw, "QuadXY 0 1", "Quadxy 0 1 nonsense"),
                                      change(ChangeKind::polynomial, "vec4(.5)", "vec4(.25)")});
    EXPECT_EQ(found.rungs[0].outcome, Outcome::refused);
    EXPECT_NE(found.rungs[0].reason.find("x"), std::string::npos) << found.rungs[0].reason;
    EXPECT_EQ(found.rungs[1].outcome, Outcome::refused);
    EXPECT_EQ(found.rungs[2].outcome, Outcome::tried) << found.rungs[2].reason;
    EXPECT_TRUE(found.rungs[0].at.empty());
    complaints.clear();  // the driver refused the first
}

TEST_F(FoundSearch, AChangeMayLeaveASliderWithoutEffect) {
    write_full("uniform float uGain;\nvoid main() { gl_FragColor = vec4(vec3(.5 + .25 * uGain), 1.); }\n");
    read_scene(full_scene);
    const FoundResult found = search({change(ChangeKind::without_term, " + .25 * uGain", "")});
    EXPECT_EQ(found.rungs[0].outcome, Outcome::tried) << found.rungs[0].reason;
    EXPECT_NEAR(found.rungs[0].at[0].own.display.rmse, .25, 1e-6);
}

TEST_F(FoundSearch, TheSameSeedGivesTheSameRungsAndErrorsToTheBit) {
    write_full(
        "uniform float uGain, uHue;\nvoid main() { float s = 0.; for (int i = 0; i < 6; ++i) s += sin(uHue * float(i) "
        "+ gl_FragCoord.x);\n gl_FragColor = vec4(.5 + .05 * s, uHue, pow(uGain, 2.), 1.); }\n");
    read_scene("Vertex full.vert\nFragment full.frag\nProgram Full uGain <0. .4 1.> uHue <0. .3 1.>\nQuadXY 0 1\n");
    const std::vector<Change> changes{change(ChangeKind::fewer_rounds, "i < 6", "i < 3"),
                                      change(ChangeKind::polynomial, "pow(uGain, 2.)", "uGain * uGain"),
                                      change(ChangeKind::without_term, " + .05 * s", "")};
    const FoundResult a = search(changes), b = search(changes);
    ASSERT_EQ(a.rungs.size(), b.rungs.size());
    EXPECT_EQ(a.places, b.places);
    EXPECT_GT(a.rungs[0].worst()->own.light.rmse, 0);
    for (std::size_t i = 0; i < a.rungs.size(); ++i) {
        EXPECT_EQ(a.rungs[i].name, b.rungs[i].name);
        ASSERT_EQ(a.rungs[i].at.size(), b.rungs[i].at.size());
        for (std::size_t place = 0; place < a.rungs[i].at.size(); ++place) {
            EXPECT_EQ(a.rungs[i].at[place].own.light.rmse, b.rungs[i].at[place].own.light.rmse);
            EXPECT_EQ(a.rungs[i].at[place].pixels_changed, b.rungs[i].at[place].pixels_changed);
        }
    }
}

TEST_F(FoundSearch, ADrawOutOfSightChangesNoPixelAndTheOtherIsNotListed) {
    read_scene("LookAt 0 0 4  0 0 0  0 1 0\nSphere 1\nTranslate 0 0 60\nSphere 1\n");
    std::vector<Change> changes{change(ChangeKind::no_draw, "Sphere 1\nTranslate", "\nTranslate"),
                                change(ChangeKind::no_draw, "60\nSphere 1", "60\n")};
    const FoundResult found = search(changes);
    ASSERT_EQ(found.without_effect().size(), 1u);
    EXPECT_EQ(found.without_effect()[0]->name, "2");
    EXPECT_GT(found.without_effect()[0]->gpu_bytes, -1);
    EXPECT_EQ(found.rungs[0].at.size(), 1u) << "it ends at the first place that shows it";
}

TEST_F(FoundSearch, WhatOnlyOneModeOfASliderNeedsChangesPixels) {
    write_full(
        "uniform int uView;\nvoid main() { vec3 c = vec3(.5); if (uView == 3) c = vec3(.1); gl_FragColor = vec4(c, "
        "1.); }\n");
    read_scene("Vertex full.vert\nFragment full.frag\nProgram Full uView <0 0 3>\nQuadXY 0 1\n");
    const FoundResult found = search({change(ChangeKind::no_statement, "if (uView == 3) c = vec3(.1);", "")});
    EXPECT_TRUE(found.without_effect().empty());
    EXPECT_EQ(found.rungs[0].pixels_changed, 32u * 32u);
}

TEST_F(FoundSearch, ACheckBoxThatWorksIsNotWithoutEffect) {
    write_full("uniform bool uOn;\nvoid main() { gl_FragColor = uOn ? vec4(1., 0., 0., 1.) : vec4(.5); }\n");
    read_scene("Vertex full.vert\nFragment full.frag\nProgram Full uOn <false>\nQuadXY 0 1\n");
    const FoundResult found = search({change(ChangeKind::no_uniform, " uOn <false>", "")});
    EXPECT_TRUE(found.without_effect().empty());
    EXPECT_EQ(found.rungs[0].pixels_changed, 32u * 32u) << found.rungs[0].reason;
}

TEST_F(FoundSearch, WhereTheSceneItselfIsNaNNothingIsCompared) {
    // The left half, at the upper end of the slider, which the scene's own value is not.
    write_full(
        "uniform float uK;\nvoid main() { float s = .5; if (uK > .99 && gl_FragCoord.x < 16.) s = sqrt(-uK);\n"
        "gl_FragColor = vec4(vec3(s + .25), 1.); }\n");
    read_scene("Vertex full.vert\nFragment full.frag\nProgram Full uK <0. .5 1.>\nQuadXY 0 1\n");
    const FoundResult found = search({change(ChangeKind::without_term, " + .25", "")});
    ASSERT_TRUE(found.broken);
    EXPECT_GT(found.broken->place, 0u);
    EXPECT_EQ(found.broken->pixels.count, 512u);
    const std::string words = found.broken_words();
    EXPECT_TRUE(words.starts_with(
        "the scene itself is NaN or infinite in 512 pixels, the first at (0, 0) from the top left, with --view "))
        << words;
    EXPECT_NE(words.find("--set Full.uK=1"), std::string::npos) << words;
    EXPECT_EQ(found.rungs[0].outcome, Outcome::tried) << "an end of a slider is not the scene";
    EXPECT_EQ(found.cannot_say, "");
    // What is left of the pixels differs by a known amount.
    ASSERT_GT(found.rungs[0].at.size(), found.broken->place);
    EXPECT_EQ(found.rungs[0].at[found.broken->place].whole.nonfinite, 512u);
    EXPECT_TRUE(std::isfinite(found.rungs[0].worst()->own.light.rmse));

    const FoundResult own = search({change(ChangeKind::without_term, " + .25", "")}, false, 1, {"uK=1"});
    ASSERT_TRUE(own.broken);
    EXPECT_EQ(own.broken->place, 0u);
    EXPECT_TRUE(own.cannot_say.ends_with("(0, 0) from the top left")) << own.cannot_say;

    const FoundResult fine = search({change(ChangeKind::without_term, " + .25", "")}, false, 1, {"uK=.5"});
    EXPECT_FALSE(fine.broken);
    EXPECT_EQ(fine.rungs[0].outcome, Outcome::tried) << fine.rungs[0].reason;
}

TEST_F(FoundSearch, NothingIsSoughtInASceneWithErrors) {
    write_full("void main() { gl_FragColor = vec4(.5 + .25); }\n");
    read_scene(full_scene);
    folder.write("scene.glib", "Foo bar\n" + std::string(full_scene));
    const FoundResult found = search({change(ChangeKind::without_term, " + .25", "")});
    EXPECT_EQ(found.rungs[0].outcome, Outcome::refused);
    EXPECT_TRUE(found.cannot_say.starts_with("the scene has errors, such as: ")) << found.cannot_say;
    EXPECT_TRUE(found.rungs[0].at.empty());
}

TEST_F(FoundSearch, WithoutTimesEachRungIsHeldOutOrTellsWhyNot) {
    write_full("void main() { gl_FragColor = vec4(.5 + .25 + .125); }\n");
    read_scene(full_scene);
    const std::vector<Change> changes{change(ChangeKind::without_term, " + .25", ""),
                                      change(ChangeKind::without_term, " + .125", "")};
    const FoundResult all = search(changes);
    EXPECT_FALSE(all.with_times);
    for (const FoundRung& rung : all.rungs) EXPECT_TRUE(rung.held_out && rung.reason.empty()) << rung.reason;
    SearchOptions options;
    options.times = false;
    bool late = false;
    options.report = [&](const Progress& progress) { late = progress.doing == "places that were held out"; };
    options.stop = [&] { return late; };
    for (const FoundRung& rung : search(changes, options).rungs) {
        EXPECT_EQ(rung.outcome, Outcome::tried);
        EXPECT_FALSE(rung.held_out);
        EXPECT_EQ(rung.reason, "the search was stopped");
    }
}

TEST_F(FoundSearch, WhatIsCheaperAndHarmlessIsOnTheFrontAndCombinesWithOthers) {
    write_full(R"(
uniform float uStep;
void main() {
    float x = gl_FragCoord.x, y = x;
    for (int i = 0; i < 400; ++i) x = x * .999 + uStep * sin(x);
    for (int j = 0; j < 401; ++j) y = y * .999 + uStep * cos(y);
    gl_FragColor = vec4(vec3(.25 + .002 * step(0., x) + 1e-30 * y), 1.);
}
)");
    read_scene("Vertex full.vert\nFragment full.frag\nProgram Full uStep <.001 .001 .001>\nQuadXY 0 1\n");
    FoundResult found;
    for (int attempt = 0; attempt < 3 && found.front().empty(); ++attempt)
        found = search({change(ChangeKind::fewer_rounds, "i < 400", "i < 40"),
                        change(ChangeKind::fewer_rounds, "j < 401", "j < 40"),
                        change(ChangeKind::without_term, " + .002 * step(0., x)", "")},
                       true);
    ASSERT_FALSE(found.front().empty());
    ASSERT_NE(found.find("1+2"), nullptr);
    EXPECT_EQ(found.front()[0]->changes.size() > 1, true) << "combinations save more: " << found.front()[0]->name;
    EXPECT_LT(found.times(*found.front()[0])->ratio.high, .5);
    EXPECT_EQ(found.find("1")->pixels_changed, 0u);
    EXPECT_TRUE(found.front()[0]->held_out);
    for (const FoundRung& rung : found.rungs)
        if (rung.timed) {
            EXPECT_EQ(found.timed.rungs[*rung.timed].name, found.words(rung));
        }
}

TEST_F(FoundSearch, WithoutTimeNothingIsTriedAndThatIsSaid) {
    write_full("void main() { gl_FragColor = vec4(.5); }\n");
    read_scene(full_scene);
    SearchOptions options;
    options.seconds = 0;
    const std::vector<Change> one{change(ChangeKind::polynomial, ".5", ".4")};
    const FoundResult none = search(one, options);
    EXPECT_EQ(none.rungs[0].outcome, Outcome::not_tried);
    EXPECT_EQ(none.rungs[0].reason, "the time was up");
    EXPECT_TRUE(none.late);
    int asked = 0;
    options.seconds = 30;
    options.stop = [&] { return ++asked > 1; };
    const FoundResult stopped = search(one, options);
    EXPECT_TRUE(stopped.interrupted);
    EXPECT_EQ(stopped.rungs[0].reason, "the search was stopped");
}

TEST_F(FoundSearch, WhatPassesBetweenStepsIsNotSpent) {
    write_full("void main() { gl_FragColor = vec4(.5 + .25); }\n");
    read_scene(full_scene);
    SearchOptions options;
    options.times = false;
    options.seconds = 60;
    double left = 0;
    options.report = [&](const Progress& progress) { left = progress.seconds_left; };
    Search found({folder.path("scene.glib"), read->plan, *read->files, read->sources},
                 {change(ChangeKind::without_term, " + .25", "")}, caps, BenchSettings{32, 32, 0, {}}, options);
    ASSERT_TRUE(found.step());
    const auto began = std::chrono::steady_clock::now();
    ASSERT_TRUE(found.step());
    const double before = left;
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ASSERT_TRUE(found.step());
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
    EXPECT_LE(before - left, passed.count() - .3 + 1e-3) << "a window may wait until nothing moves";
}

TEST_F(FoundSearch, WhatIsLoadedForNothingIsToldInMilliseconds) {
    write_full("void main() { gl_FragColor = vec4(.5); }\n");
    folder.write("far.vert",
                 "#version 330 compatibility\nvoid main() { gl_Position = vec4(gl_Vertex.xy + 9., 0., 1.); }\n");
    folder.write("far.frag",
                 "#version 330 compatibility\nuniform samplerCube uLight;\nvoid main() { gl_FragColor = "
                 "texture(uLight, vec3(gl_FragCoord.xy, 99.)); }\n");
    const std::string room = std::filesystem::absolute("scenes/environments/room.hdr").string();
    read_scene("CubeMap 6 " + room + "\nPrefilter 8 6 64\n" + std::string(full_scene) +
               "Vertex far.vert\nFragment far.frag\nProgram Far uLight 8\nQuadXY 0 2\n");
    const std::vector<Change> changes{change(ChangeKind::no_draw, "QuadXY 0 2", ""),
                                      change(ChangeKind::no_uniform, "uGain <1. 1. 1.>", "")};
    const FoundResult found = search(changes, true);
    ASSERT_EQ(found.without_effect().size(), 2u) << found.cannot_say << found.rungs[0].reason << found.rungs[1].reason;
    ASSERT_TRUE(found.rungs[0].load_ms) << found.rungs[0].gpu_bytes;
    EXPECT_GT(*found.rungs[0].load_ms, 5) << "light is convolved for every texel";
    EXPECT_GT(found.rungs[0].gpu_bytes, 6 * 64 * 64 * 4);
    EXPECT_FALSE(found.rungs[1].load_ms) << "a value takes no memory";
    EXPECT_FALSE(search(changes).rungs[0].load_ms) << "times were not wanted";
}

// A window rests between the steps.
TEST_F(FoundSearch, AStepDrawsAPlaceOrTimesARung) {
    write_full("void main() { float c = .5; c += .1; gl_FragColor = vec4(vec3(c), 1.); }\n");
    read_scene(full_scene);
    SearchOptions options;
    options.rounds = 9;
    options.at_least = .5;
    Search found({folder.path("scene.glib"), read->plan, *read->files, read->sources},
                 {change(ChangeKind::without_term, "c += .1;", ";"), change(ChangeKind::no_draw, "QuadXY 0 1", "")},
                 caps, {32, 32, 0, {}}, options);
    std::size_t most = 0, drawn = 0;
    const auto places = [&] {
        std::size_t count = 0;
        for (const FoundRung& rung : found.result().rungs) count += rung.at.size();
        return count;
    };
    while (found.step()) {
        most = std::max(most, places() - std::min(places(), drawn));
        drawn = places();
    }
    EXPECT_GE(drawn, 4u);
    EXPECT_EQ(most, 1u) << "places of one rung in a step";
}

}  // namespace
}  // namespace snell::test
