// How the time for rounds is divided, by a clock that only the frames move.
#include "src/accuracy/costs.h"
#include "src/accuracy/timing.h"
#include "tests/std.h"

namespace snell::test {
namespace {

using namespace accuracy;

TEST(DividedTime, LeavesOutRungsInsteadOfRounds) {
    const std::vector<double> frames{60, 10, 20, 200, 30, 400};  // milliseconds
    constexpr std::size_t base = 1, kept = 0;
    std::size_t before = 0;
    for (const double seconds : {.01, 2., 4., 8., 16., 100.}) {
        double now = 0;
        std::vector<Entrant> entrants;
        for (const double frame : frames)
            entrants.push_back({[&now, frame](ClockKind) {
                                    now += 3 * frame;
                                    return std::optional(frame);
                                },
                                [&now, frame](double at_least) {
                                    now += frame + std::max(frame, at_least);
                                    return Times{frame, frame, 0};
                                }});
        const auto left = [&] { return seconds - now / 1e3; };
        Rounds rounds(std::move(entrants),
                      {.base = base, .kept = kept, .seconds_left = left, .over = [&] { return left() <= 0; }});
        rounds.run();
        std::vector<std::size_t> counts;
        for (std::size_t i = 0; i < frames.size(); ++i)
            counts.push_back(static_cast<std::size_t>(
                std::ranges::count_if(rounds.times(i), [](const Times& t) { return t.wall > 0; })));
        const auto timed = static_cast<std::size_t>(
            std::count_if(counts.begin(), counts.end(), [](std::size_t count) { return count > 0; }));
        EXPECT_GE(timed, std::max<std::size_t>(before, 2)) << seconds << " s: more time, more rungs";
        EXPECT_GE(counts[base], rounds_for(timed)) << seconds << " s: as many rounds as a front needs";
        EXPECT_GT(counts[kept], 0U) << seconds;
        if (timed > 2) {
            EXPECT_LE(now, 1050 * seconds);
        }
        before = timed;
    }
    EXPECT_EQ(before, frames.size());
}

}  // namespace
}  // namespace snell::test
