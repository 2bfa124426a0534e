// A window makes programs for its values while nothing is touched. Neither the first picture by them nor the first one
// of a drag, which leaves them, takes longer than its neighbours.
#include "src/accuracy/timing.h"
#include "src/gl/present.h"
#include "tests/harness/plain.h"

namespace snell::test {
namespace {

class Drag : public PlainTest {
protected:
    static constexpr int size = 96;

    double frame(Document& document, double gain, double turn) {
        document.controls.find(0, "uGain")->value = {gain};
        view.scene.rotate_y = turn;
        // Of the processor, which other programs share; compiling takes it, too.
        const double begin = accuracy::cpu_milliseconds();
        document.runtime->draw({0, view, document.controls, true}, {target.framebuffer.get(), size, size});
        gl::finish();
        return accuracy::cpu_milliseconds() - begin;
    }
    void rest(Document& document) {
        while (
            document.runtime->specialise({0, view, document.controls, true}, {target.framebuffer.get(), size, size})) {
        }
    }
    // The longest of these frames, as a multiple of their median.
    static double worst(std::vector<double> times) {
        std::ranges::sort(times);
        return times.back() / times[times.size() / 2];
    }

    View view;
    gl::Target target;
};

TEST_F(Drag, HasNoFrameThatIsSlowBecauseOfPrograms) {
    folder.write(
        "heavy.frag",
        "#version 330 compatibility\nuniform float uGain, uStep;\nin vec2 vST;\nvoid main() {\n"
        "float x = vST.x;\nfor (int i = 0; i < 400; ++i)\nif (uGain > .5) x = x * .999 + uStep * sin(x) * uGain;\n"
        "gl_FragColor = vec4(x * .1, 0., 0., 1.);\n}\n");
    target = gl::make_target(size, size, 1);
    double best_taken = 99, best_left = 99;
    for (int attempt = 0; attempt < 5 && std::max(best_taken, best_left) > 1.2; ++attempt) {
        auto document = open(
            "Perspective 40\nLookAt 0 0 3  0 0 0  0 1 0\nVertex plain.vert\nFragment heavy.frag\n"
            "Program P uGain <0. 1. 2.> uStep <0. .01 1.>\nSphere 1 60 60\n");
        expect_clean(*document);
        for (int i = 0; i < 3; ++i) frame(*document, 1, 0);
        rest(*document);
        std::vector<double> taken, left;
        for (int i = 0; i < 12; ++i) taken.push_back(frame(*document, 1, .02 * i));
        EXPECT_EQ(document->runtime->counters().specialised_draws, 12U);
        for (int i = 0; i < 12; ++i) left.push_back(frame(*document, 1 + .01 * (i + 1), .24));
        EXPECT_EQ(document->runtime->counters().specialised_draws, 12U);
        best_taken = std::min(best_taken, worst(taken));
        best_left = std::min(best_left, worst(left));
    }
    EXPECT_LE(best_taken, 1.2);
    EXPECT_LE(best_left, 1.2);
}

}  // namespace
}  // namespace snell::test
