// Slow pictures are drawn coarser while something is dragged, and sharp afterwards.
#include <algorithm>
#include <chrono>

#include "tests/gui/desk.h"
#include "tests/sanitized.h"

namespace snell::test {
namespace {

using nlohmann::json;

class SlowDrag : public Desk {
protected:
    SlowDrag() : Desk("1280x800x24") {}
    void SetUp() override {
        Desk::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        std::filesystem::create_directory_symlink(SNELL_ROOT "/scenes/refraction-room", file("room"));
    }
    void open_room(bool always_sharp) {
        std::filesystem::create_directories(file("state/snell"));
        save("state/snell/window.json", always_sharp ? "{\"always_sharp\": true}" : "{}");
        open("room/refraction-room.glib", {"--size", "1192x624"});
    }
    // Pictures per second while a slider is dragged to and fro for two seconds; the coarsest of them in `grain`.
    double rate(int& grain) {
        const auto [left, y] = on("Glass.uIndex", .2);
        const int right = on("Glass.uIndex", .8)[0];
        const auto to = [&, y = y](int x) { return "mousemove " + std::to_string(x) + " " + std::to_string(y); };
        EXPECT_EQ(state()["scene"], json({0, 0, 840, 600}));
        user(to(left) + " mousedown 1 sleep .3 " + to(left + 3) + " sleep .1 " + to(left + 6) + " sleep .1");
        const json before = state();
        const auto begun = std::chrono::steady_clock::now();
        grain = 0;
        // In parts: on a busy machine the mouse may rest long enough at the end for a sharp picture.
        for (int part = 0; part < 10; ++part) {
            std::string words;
            for (int i = 20 * part; i < 20 * part + 20; ++i)
                words += to(left + (i < 100 ? i : 199 - i) * (right - left) / 100) + " sleep .01 ";
            user(words);
            grain = std::max(grain, state()["grain"].get<int>());
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        const json after = state();
        user("mouseup 1");
        return (after["frames"].get<double>() - before["frames"].get<double>()) / seconds;
    }
};

TEST_F(SlowDrag, OfTheRoomHasTwentyFivePicturesASecond) {
    if (sanitized) GTEST_SKIP() << "sanitizers take their time";
    open_room(false);
    double best = 0;
    int grain = 0;
    for (int attempt = 0; attempt < 3 && best < 25; ++attempt) best = std::max(best, rate(grain));
    RecordProperty("pictures_per_second", std::to_string(best));
    std::printf("%.1f pictures a second\n", best);
    if (best >= 25) return;
    // A machine of less than two free processors: the gain tells.
    end_window();
    open_room(true);
    EXPECT_GE(best, 2.2 * rate(grain));
    EXPECT_EQ(grain, 0) << "switched off with one setting";
}

TEST_F(SlowDrag, EndsWithTheSharpPictureOfTheValues) {
    open_room(false);
    int grain = 0;
    const double pictures = rate(grain);
    EXPECT_TRUE(grain > 0 || pictures > 30) << pictures << " a second; a fast machine draws them sharp";
    EXPECT_TRUE(wait([](const json& s) { return s["grain"] == 0; })) << "sharp without another event";
    settle();
    const double value = state()["controls"]["Glass.uIndex"][0];
    const Picture dragged = look();
    end_window();
    // The same value, which is kept, in a window that is always sharp.
    open_room(true);
    user("mousemove 5 5");
    settle();
    EXPECT_EQ(state()["controls"]["Glass.uIndex"][0], value);
    const std::array<double, 4> scene = state()["scene"];
    const Picture kept = look();
    for (int row = 0; row < static_cast<int>(scene[3]); row += 7)
        for (int column = 0; column < static_cast<int>(scene[2]); column += 7)
            ASSERT_EQ(dragged.at(column, row), kept.at(column, row)) << column << ' ' << row;
}

}  // namespace
}  // namespace snell::test
