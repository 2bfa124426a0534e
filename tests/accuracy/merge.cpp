// Reports of several machines: what holds on all of them, and what does not.
#include "src/accuracy/report/merge.h"

#include <gtest/gtest.h>

#include "src/accuracy/report/report.h"

namespace snell::accuracy {
namespace {

// A report with two rungs besides the current one, whose costs are relative to it.
NamedReport report(const std::string& name, double first, double second, bool quiet = true) {
    SweepResult sweep{.scene = "scene.glib", .sweep = {.name = "L", .reference = 2, .current = 2}};
    const double errors[]{.1, .05, 0}, costs[]{first, second, 1};
    for (std::size_t i = 0; i < 3; ++i) {
        RungResult rung{.name = std::string(1, static_cast<char>('a' + static_cast<int>(i))), .drawn = true};
        rung.own.light.rmse = errors[i];
        for (int round = 0; round < 31; ++round) rung.cpu.push_back(costs[i] * (10 + .01 * (round % 3)));
        sweep.rungs.push_back(std::move(rung));
    }
    sweep.clock = ClockKind::cpu;
    std::vector<double> again = sweep.rungs[2].cpu;
    if (!quiet)
        for (double& t : again) t *= 2;
    conclude(sweep, again, 1);
    Report result;
    result.where.renderer = name;
    result.sweeps = {sweep};
    return {name + ".json", json_text(result)};
}

// The line of the rung.
std::string line_of(const std::string& text, const std::string& rung) {
    const std::size_t at = text.find("\n  " + rung + " ");
    return at == std::string::npos ? "" : text.substr(at + 1, text.find('\n', at + 1) - at);
}

TEST(Merge, BargainThatFlipsBetweenMachinesIsNotPortable) {
    const NamedReport reports[]{report("one", .5, .8), report("two", .5, 1.3)};
    std::string error;
    const auto text = merged_text(reports, error);
    ASSERT_TRUE(text) << error;
    EXPECT_NE(text->find("A: one.json (one"), std::string::npos) << *text;
    EXPECT_EQ(line_of(*text, "a").find("not portable"), std::string::npos) << *text;
    EXPECT_NE(line_of(*text, "b").find("not portable"), std::string::npos) << *text;
    EXPECT_NE(line_of(*text, "b").find("dominated by c"), std::string::npos) << *text;
}

TEST(Merge, NoisyMachineContradictsNothing) {
    const NamedReport reports[]{report("one", .5, .8), report("two", .5, 1.3, false)};
    std::string error;
    const auto text = merged_text(reports, error);
    ASSERT_TRUE(text) << error;
    EXPECT_EQ(text->find("not portable"), std::string::npos) << *text;
    EXPECT_NE(line_of(*text, "b").find("can't say"), std::string::npos) << *text;
}

TEST(Merge, WhatIsNoReportOrSharesNothingIsAnError) {
    std::string error;
    const NamedReport bad[]{report("one", .5, .8), {"bad.json", "["}};
    EXPECT_FALSE(merged_text(bad, error));
    EXPECT_EQ(error, "'bad.json' is not a report that 'snell accuracy --json' wrote");
    const NamedReport alone[]{report("one", .5, .8)};
    EXPECT_FALSE(merged_text(alone, error));
    EXPECT_NE(error.find("more than one"), std::string::npos);
}

}  // namespace
}  // namespace snell::accuracy
