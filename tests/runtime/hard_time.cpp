// Hard cases of time: what a clock of floats makes of it beside ours.
#include "src/runtime/resources/uniforms.h"
#include "tests/hard_case.h"
#include "tests/std.h"

namespace snell::test {
namespace {

float timer(double time, double period) { return static_cast<float>(runtime::timer_value(time, period)); }

bool is_phase(float value) { return value >= 0 && value < 1; }

TEST(HardTime, AfterTenDays) {
    float clock = 0;
    constexpr int frames = 10 * 86400 * 60;
    for (int i = 0; i < frames; ++i) clock += 1 / 60.F;
    const double time = 864000.125;
    hard_case({"49", "the Timer after ten days; naive: a float that adds up sixtieths", "s", 1e-6,
               std::abs(static_cast<double>(timer(time, 10)) * 10 - .125),
               std::abs(static_cast<double>(clock) - 864000.)});
}

TEST(HardTime, TheSawtoothStaysBelowOne) {
    int ours = 0, naive = 0;
    for (const double time : {9.9999999999, 20 - 1e-9, 1e9 - 1e-6, 10.0}) {
        ours += !is_phase(timer(time, 10));
        naive += !is_phase(static_cast<float>(std::fmod(time, 10) / 10));
    }
    hard_case({"50", "the Timer just before its period ends; naive: fmod, then float", "of 4 that reach 1", 0,
               static_cast<double>(ours), static_cast<double>(naive)});
    const double edge = 10 - 1e-9;
    hard_case({"A39", "a nanosecond before the period ends the Timer is the largest float below 1", "from it", 0,
               static_cast<double>(std::abs(std::nextafter(1.F, 0.F) - timer(edge, 10))), std::nullopt});
}

TEST(HardTime, PeriodsAndClocksOfEveryKind) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    int ours = 0, naive = 0, back = 0, back_naive = 0;
    for (const double period : {0., -1., 1e-9, 1e9, nan}) {
        ours += !is_phase(timer(12.5, period));
        naive += !is_phase(static_cast<float>(std::fmod(12.5, period) / period));
    }
    hard_case({"51", "periods of 0, -1, 1e-9, 1e9, NaN; naive: fmod", "of 5 outside of [0,1)", 0,
               static_cast<double>(ours), static_cast<double>(naive)});
    // A clock that was set back, or slept for a year.
    for (const double time : {-1e-12, -3., -1e9, 3.2e7, HUGE_VAL}) {
        back += !is_phase(timer(time, 10));
        back_naive += !is_phase(static_cast<float>(std::fmod(time, 10) / 10));
    }
    hard_case({"52", "a clock that goes back, or jumps by a year; naive: fmod", "of 5 outside of [0,1)", 0,
               static_cast<double>(back), static_cast<double>(back_naive)});
}

TEST(HardTime, FramesAtAnOddRate) {
    float sum = 0;
    constexpr int frames = 10'000;
    for (int i = 0; i < frames; ++i) sum += 1 / 29.97F;
    hard_case({"54", "frame 10,000 at 29.97 a second is at 10,000 / 29.97 s; naive: a float that adds up", "s", 1e-9,
               std::abs(runtime::frame_time(frames, 29.97) - frames / 29.97),
               std::abs(static_cast<double>(sum) - frames / 29.97)});
}

}  // namespace
}  // namespace snell::test
