// What is kept of a scene when its context is lost, and shown in another one.
#include "src/app/recovery.h"
#include "src/app/session.h"
#include "tests/gl/harness.h"

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

}  // namespace
}  // namespace snell::test
