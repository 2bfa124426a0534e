// What is kept of a scene when its context is lost, and shown in another one.
#include <sys/mman.h>
#include <unistd.h>

#include "src/app/window/session.h"
#include "src/app/window/survive/recovery.h"
#include "src/plan/setup.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

const Pixel red{255, 0, 0, 255}, green{0, 255, 0, 255}, half{128, 0, 0, 255};

class SessionRecovery : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        paint("vec4(uA, 0., 0., 1.)");
        folder.write("s.glib", "Ortho -1 1 -1 1\nFragment p.frag\nProgram P uA <0. 1. 1.>\nQuadXY 0. 9.\n");
    }
    void paint(const std::string& color) {
        folder.write("p.frag", "uniform float uA;\nvoid main() { gl_FragColor = " + color + "; }\n");
    }
    std::string scene() const { return folder.path("s.glib"); }
    // The context goes with all that was made in it.
    void lose_context() {
        expect_quiet();
        context.reset();
        std::string error;
        context = HeadlessContext::make(request, error);
        ASSERT_TRUE(context) << error;
    }
    Pixel shown(Session& session) { return draw(*session.document()).center(); }
};

TEST_F(SessionRecovery, WhatWasDrawnComesBackWithItsValues) {
    Recovery recovery;
    {
        Session session(scene(), caps);
        ASSERT_TRUE(session.document());
        EXPECT_TRUE(near(shown(session), red));
        session.document()->controls.find(0, "uA")->value = {.5};
        session.drawn_well();
        recovery = after_loss(session.salvage(), session.files());
        EXPECT_FALSE(session.document());
    }
    ASSERT_TRUE(recovery.kept);
    lose_context();
    Session session(scene(), caps, {}, nullptr, nullptr, &recovery);
    ASSERT_TRUE(session.document());
    EXPECT_TRUE(session.stale());
    EXPECT_EQ(session.errors(), 1U);
    EXPECT_NE(session.problems_text().find("[context-lost]"), std::string::npos);
    EXPECT_TRUE(near(shown(session), half));
    session.reload();
    EXPECT_FALSE(session.stale());
    EXPECT_EQ(session.errors(), 0U) << session.problems_text();
    EXPECT_TRUE(near(shown(session), half)) << "values carry over";
}

TEST_F(SessionRecovery, AnEditThatWasNeverDrawnIsNotWhatComesBack) {
    Recovery recovery;
    {
        Session session(scene(), caps);
        session.drawn_well();
        paint("vec4(0., 1., 0., 1.)");
        session.reload();
        EXPECT_TRUE(near(shown(session), green)) << session.problems_text();
        recovery = after_loss(session.salvage(), session.files());
    }
    ASSERT_TRUE(recovery.kept);
    EXPECT_EQ(recovery.files.size(), 2U) << "an edit of the shader is another try, too";
    lose_context();
    Session session(scene(), caps, {}, nullptr, nullptr, &recovery);
    ASSERT_TRUE(session.document());
    EXPECT_TRUE(near(shown(session), red));
    // Nothing is kept of a context that is lost again at once.
    EXPECT_FALSE(session.salvage());
}

TEST_F(SessionRecovery, WhereNothingWasDrawnNothingIsShown) {
    Recovery recovery;
    {
        Session session(scene(), caps);
        recovery = after_loss(session.salvage(), session.files());
    }
    EXPECT_FALSE(recovery.kept);
    lose_context();
    Session session(scene(), caps, {}, nullptr, nullptr, &recovery);
    EXPECT_FALSE(session.document());
    EXPECT_EQ(session.errors(), 1U);
    session.reload();
    ASSERT_TRUE(session.document());
    EXPECT_EQ(session.errors(), 0U);
    EXPECT_TRUE(near(shown(session), red));
}

TEST_F(SessionRecovery, ItsValuesWinOverThoseThatWereKept) {
    Remembered memory;
    memory = {{{"--set P.uA", "0.25"}, {"--set P.uGone", "0.75"}}, {{"--set P.uA", "1"}, {"--set P.uGone", "0.5"}}};
    Recovery recovery;
    Session session(scene(), caps, {}, nullptr, nullptr, &recovery, memory);
    session.reload();
    ASSERT_TRUE(session.document());
    EXPECT_EQ(session.document()->controls.find(0, "uA")->value[0], 1) << "it was as written";
    folder.write("p.frag", "uniform float uA, uGone;\nvoid main() { gl_FragColor = vec4(uA, uGone, 0., 1.); }\n");
    folder.write("s.glib",
                 "Ortho -1 1 -1 1\nFragment p.frag\nProgram P uA <0. 1. 1.> uGone <0. .5 1.>\nQuadXY 0. 9.\n");
    session.reload();
    EXPECT_EQ(session.document()->controls.find(0, "uA")->value[0], 1);
    EXPECT_EQ(session.document()->controls.find(0, "uGone")->value[0], .75) << "it was not in the scene";
}

// A window that was started again has the text alone.
class SessionRestart : public SessionRecovery {
protected:
    Recovery recovery(const std::string& changed) const {
        return {nullptr, {scene()}, changed, {.message = "it hung", .has_span = false}};
    }
    static std::string changed(Session& session) {
        return setup_text(changed_setup(session.document()->scene(), session.document()->controls));
    }
    static Control& control(Session& session, const std::string& name) {
        return *session.document()->controls.find(0, name);
    }
};

TEST_F(SessionRestart, WhatWasSetByHandComesBackWithTheScene) {
    std::string set;
    {
        Session session(scene(), caps);
        EXPECT_EQ(changed(session), "") << "nothing was";
        control(session, "uA").value = {1. / 3};
        set = changed(session);
    }
    const Recovery hung = recovery(set);
    Session session(scene(), caps, {}, nullptr, nullptr, &hung);
    EXPECT_FALSE(session.document());
    EXPECT_EQ(session.by_hand(), set) << "for a window that has to be started again before it is read";
    session.reload();
    ASSERT_TRUE(session.document());
    EXPECT_EQ(control(session, "uA").value, std::vector<double>{1. / 3});
    EXPECT_EQ(control(session, "uA").initial, std::vector<double>{1});
    EXPECT_EQ(session.by_hand(), "");
    control(session, "uA").value = {.25};
    session.reload();
    EXPECT_EQ(control(session, "uA").value, std::vector<double>{.25}) << "once";
}

TEST_F(SessionRestart, ABrokenEditLosesNothing) {
    const Recovery hung = recovery("--set P.uA=0.5\n");
    paint("nonsense(uA)");
    Session session(scene(), caps, {}, nullptr, nullptr, &hung);
    session.reload();
    complaints.clear();
    EXPECT_GT(session.errors(), 0U);
    EXPECT_NE(session.by_hand(), "");
    paint("vec4(uA, 0., 0., 1.)");
    session.reload();
    EXPECT_EQ(session.errors(), 0U) << session.problems_text();
    EXPECT_EQ(control(session, "uA").value, std::vector<double>{.5});
    EXPECT_TRUE(near(shown(session), half));
}

TEST_F(SessionRestart, AnotherSceneIsNotConcerned) {
    const Recovery hung = recovery("--set P.uA=0.5\n");
    folder.write("t.glib", "Ortho -1 1 -1 1\nFragment p.frag\nProgram P uA <0. 1. 1.>\nQuadXY 0. 9.\n");
    Session session(scene(), caps, {}, nullptr, nullptr, &hung);
    EXPECT_EQ(session.open(folder.path("t.glib")), "");
    EXPECT_EQ(control(session, "uA").value, std::vector<double>{1});
    EXPECT_EQ(session.by_hand(), "");
}

// The rung is chosen before its programs are compiled: only they have the uniform.
TEST_F(SessionRestart, RungsComeBackWithTheirUniforms) {
    folder.write("p.frag",
                 "uniform float uA;\nvoid main() {\n#if WAY == WAY_red\n  gl_FragColor = vec4(uA, 0., 0., 1.);\n#else\n"
                 "  gl_FragColor = vec4(0., 1., 0., 1.);\n#endif\n}\n");
    folder.write("s.glib",
                 "Ladder WAY red <green>\nOrtho -1 1 -1 1\nFragment p.frag\nProgram P uA <0. 1. 1.>\nQuadXY 0. 9.\n");
    std::string set;
    {
        Session session(scene(), caps);
        EXPECT_TRUE(near(shown(session), green)) << session.problems_text();
        session.document()->controls.rungs = {0};
        session.follow_rungs();
        control(session, "uA").value = {.5};
        EXPECT_TRUE(near(shown(session), half)) << session.problems_text();
        set = changed(session);
    }
    const Recovery hung = recovery(set);
    Session session(scene(), caps, {}, nullptr, nullptr, &hung);
    session.reload();
    ASSERT_TRUE(session.document());
    EXPECT_EQ(session.document()->controls.rungs, Rungs{0});
    EXPECT_TRUE(near(shown(session), half)) << session.problems_text();
}

// Whoever sees that the window stands still mends the scene, and does not wait for the window.
TEST(RestartedWindow, TriesAgainWhatWasSavedMeanwhile) {
    const Folder folder;
    const std::string scene = folder.write("s.glib", "Sphere\n");
    const auto begun = [&](int memory) { return Restart("hang:" + std::to_string(memory)).carried(); };
    const auto memory = [&](const std::string& text) {
        const int file = memfd_create("test", 0);  // Restart closes it
        EXPECT_EQ(write(file, text.data(), text.size()), static_cast<ssize_t>(text.size()));
        return file;
    };
    const std::string text = carried_text({scene, {nullptr, {scene}, {}, {}}, {}, {}, 0});
    usleep(20'000);  // files have a coarse clock
    const auto stands = begun(memory(text));
    ASSERT_TRUE(stands);
    EXPECT_EQ(stands->scene, scene);
    EXPECT_FALSE(stands->recovery.edited);
    EXPECT_EQ(stands->recovery.problem.code, "frame-too-long");
    const int file = memory(text);
    usleep(20'000);
    folder.write("s.glib", "Box\n");
    EXPECT_TRUE(begun(file)->recovery.edited);
    const auto tomorrow = std::filesystem::file_time_type::clock::now() + std::chrono::hours(24);
    std::filesystem::last_write_time(scene, tomorrow);
    EXPECT_FALSE(begun(memory(text))->recovery.edited) << "it would try for ever";
    EXPECT_FALSE(Restart("").carried()) << "a window that the user opened";
}

TEST(Carried, IsTextAndBack) {
    Carried carried{"odd \xE9\n.glib", {nullptr, {"a b", "\n", "c"}, "--set P.uA=0.5\n", {}}, {}, {640, 480}, .1};
    carried.reading = "much.glib";
    carried.tries = 2;
    carried.view.scene.rotate_x = 1. / 3;
    carried.view.objects[2].x = -.7;
    carried.view.axes = false;
    const Carried back = read_carried(carried_text(carried));
    EXPECT_EQ(back.scene, carried.scene);
    EXPECT_EQ(back.recovery.files, carried.recovery.files);
    EXPECT_EQ(back.recovery.values, carried.recovery.values);
    EXPECT_EQ(back.view, carried.view);
    EXPECT_EQ(back.size, carried.size);
    EXPECT_EQ(back.time, carried.time);
    EXPECT_EQ(back.reading, carried.reading);
    EXPECT_EQ(back.tries, carried.tries);
    const Carried none = read_carried("");
    EXPECT_EQ(none.scene + none.recovery.values, "");
    EXPECT_TRUE(none.view.axes) << "as in a window that is opened";
}

}  // namespace
}  // namespace snell::test
