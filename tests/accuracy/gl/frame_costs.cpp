// What timing pictures costs itself, and what is said of passes and draws.
#include "src/app/window/measure/frame_costs.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/timing.h"
#include "src/gl/present.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class FrameCostsTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        folder.write("plain.vert", plain_vertex);
        folder.write("texture.frag", texture_fragment);
        folder.write("waves.frag",
                     "#version 330 compatibility\nuniform float uHow;\nin vec2 vST;\nvoid main() {\n    float s = 0.;\n"
                     "    for (int i = 0; i < 40; ++i) s += sin(float(i) * vST.s * uHow) * cos(float(i) * vST.t);\n"
                     "    gl_FragColor = vec4(vec3(.5 + .02 * s), 1.);\n}\n");
        document_ = open(
            "Texture2D 5 64 64\nOrtho -1 1 -1 1\nVertex plain.vert\nFragment waves.frag\nProgram Waves uHow <1. 3. "
            "9.>\n"
            "RenderToTexture 5\nQuadXY 0. 1.\nRenderToTexture\nQuadXY 0. 1.\nFragment texture.frag\n"
            "Program Shown uUnit 5\nQuadXY .5 .2\n");
        expect_clean(*document_);
        target_ = gl::make_target(size, size, 1);
    }
    // As the window does it.
    void picture(FrameCosts& costs) {
        const double begin = accuracy::wall_milliseconds();
        Frame frame{.time = 0, .view = view_, .controls = document_->controls, .paced = true};
        frame.after = costs.begin(1, true);
        document_->runtime->draw(frame, {target_.framebuffer.get(), size, size});
        gl::finish();
        costs.end(last_ = accuracy::wall_milliseconds() - begin, true);
        costs.facts(document_.get(), {});
    }

    static constexpr int size = 384;
    std::unique_ptr<Document> document_;
    gl::Target target_;
    View view_;
    double last_ = 0;
};

// In pairs, in turns first and second; nothing is said where the machine is too noisy to tell.
TEST_F(FrameCostsTest, TimingPicturesCostsNoThreeHundredthsOfThem) {
    FrameCosts closed(caps), opened(caps);
    opened.open(true, 1, 0);
    const auto time = [&](FrameCosts& costs) {
        const double begin = accuracy::cpu_milliseconds();
        for (int i = 0; i < 3; ++i) picture(costs);
        return accuracy::cpu_milliseconds() - begin;
    };
    time(closed);
    time(opened);
    std::vector<double> without, with;
    for (int round = 0; round < 21; ++round) {
        if (round % 2) with.push_back(time(opened));
        without.push_back(time(closed));
        if (round % 2 == 0) with.push_back(time(opened));
    }
    const accuracy::Interval ratio = accuracy::paired_ratio(with, without);
    RecordProperty("ratio", std::to_string(ratio.middle));
    EXPECT_LE(std::min(ratio.middle, ratio.low), 1.03) << ratio.low << " " << ratio.middle << " " << ratio.high;
    EXPECT_EQ(opened.facts(document_.get(), {})->frames.size(), 66U);
    EXPECT_EQ(closed.facts(document_.get(), {}), nullptr);
}

TEST_F(FrameCostsTest, MedianAndNinetyFifthOfTheLastPictures) {
    FrameCosts costs(caps);
    costs.open(true, 1, 0);
    for (int i = 0; i < 20; ++i) picture(costs);
    const ui::FrameCostFacts& facts = *costs.facts(document_.get(), {});
    std::vector<float> sorted(facts.frames.begin(), facts.frames.end());
    std::ranges::sort(sorted);
    ASSERT_EQ(sorted.size(), 20U);
    EXPECT_GT(sorted.front(), 0);
    EXPECT_GE(std::ranges::count_if(sorted, [&](float f) { return f <= facts.high; }), 19);
    EXPECT_NEAR(static_cast<double>(std::ranges::count_if(sorted, [&](float f) { return f <= facts.median; })), 10.5,
                1);
    costs.open(false, 1, 0);
    costs.open(true, 1, 0);
    EXPECT_TRUE(costs.facts(document_.get(), {})->frames.empty());
}

// A still scene draws no picture when the panel opens.
TEST_F(FrameCostsTest, BeginsWithThePictureThatIsShown) {
    FrameCosts costs(caps);
    picture(costs);
    EXPECT_TRUE(costs.open(true, 1, last_));
    EXPECT_FALSE(costs.open(true, 1, last_));
    ASSERT_EQ(costs.facts(document_.get(), {})->frames.size(), 1U);
    EXPECT_EQ(costs.facts(document_.get(), {})->median, static_cast<float>(last_));
    EXPECT_TRUE(costs.wants_picture()) << "without the driver's compiler";
    picture(costs);
    EXPECT_FALSE(costs.wants_picture());
    ASSERT_EQ(costs.facts(document_.get(), {})->frames.size(), 2U);
    EXPECT_EQ(costs.facts(document_.get(), {})->frames.back(), static_cast<float>(last_));
}

TEST_F(FrameCostsTest, PassesAndDrawsAreMeasuredApart) {
    FrameCosts costs(caps);
    costs.open(true, 1, 0);
    picture(costs);
    Stand stand;
    stand.width = stand.height = size;
    std::span<const ui::CostRow> rows;
    double part = 0;  // of the whole picture and of its passes, which another process may slow down one by one
    for (int attempt = 0; attempt < 4 && (part <= .3 || part >= 1.5); ++attempt) {
        costs.measure();
        int steps = 0;
        while (costs.busy() && steps < 100) steps += costs.step(*document_, stand, 1);
        ASSERT_FALSE(costs.busy());
        rows = costs.facts(document_.get(), {})->apart;
        ASSERT_EQ(rows.size(), 5U);
        part = costs.facts(document_.get(), {})->apart_plain / (rows[0].milliseconds + rows[2].milliseconds);
    }
    EXPECT_GT(part, .3);
    EXPECT_LT(part, 1.5) << "waits make nothing cheaper";
    EXPECT_EQ(rows[0].name, "RenderToTexture 5");
    EXPECT_EQ(rows[1].name, "QuadXY 0. 1.");
    EXPECT_EQ(rows[2].name, "window");
    EXPECT_TRUE(rows[3].draw && rows[4].draw);
    EXPECT_EQ(rows[4].place, "scene.glib:12");
    EXPECT_GE(rows[2].milliseconds, .9 * std::max(rows[3].milliseconds, rows[4].milliseconds));
    // 36 times the pixels of the pass: far more work.
    EXPECT_GT(rows[3].milliseconds, 3 * rows[1].milliseconds);
    Explanation explanation = document_->runtime->explain();
    costs.fill(explanation);
    int passes = 0, programs = 0;
    for (const Explanation::Paid& paid : explanation.paid) {
        passes += paid.kind == Explanation::Kind::pass && paid.frame;
        programs += paid.kind == Explanation::Kind::program && paid.frame;
        if (paid.kind == Explanation::Kind::pass && paid.name == "window") {
            EXPECT_NEAR(std::max(paid.frame->cpu, paid.frame->wall), rows[2].milliseconds, 1e-9);
        }
    }
    EXPECT_EQ(passes, 2);
    EXPECT_EQ(programs, 2);
}

// The path of GPUs, with the clock of whatever is here: every pass has its marks.
TEST_F(FrameCostsTest, TimerQueriesTellOfEveryPass) {
    caps.software = false;
    FrameCosts costs(caps);
    costs.open(true, 1, 0);
    for (int i = 0; i < 3; ++i) picture(costs);
    const ui::FrameCostFacts& facts = *costs.facts(document_.get(), {});
    if (facts.passes.empty()) GTEST_SKIP() << "this context has no timer queries";
    EXPECT_EQ(facts.frames.size(), 3U);
    ASSERT_EQ(facts.passes.size(), 2U);
    EXPECT_EQ(facts.passes[0].name, "RenderToTexture 5");
    EXPECT_EQ(facts.passes[1].name, "window");
    costs.measure();
    Stand stand;
    stand.width = stand.height = size;
    for (int i = 0; costs.busy() && i < 100; ++i) costs.step(*document_, stand, 1);
    EXPECT_EQ(costs.facts(document_.get(), {})->apart.size(), 5U);
}

}  // namespace
}  // namespace snell::test
