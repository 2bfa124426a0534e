// What the report says of found rungs, for results made by hand.
#include "src/accuracy/report/report.h"

#include <nlohmann/json.hpp>

#include "src/accuracy/found/search.h"
#include "tests/std.h"

namespace snell::accuracy {
namespace {

FoundRung tried(const std::string& name, std::vector<std::size_t> changes, Aim aim = Aim::cheaper) {
    FoundRung rung;
    rung.name = name;
    rung.changes = std::move(changes);
    rung.aim = aim;
    rung.outcome = Outcome::tried;
    rung.at.resize(1);
    return rung;
}

FoundResult of_two() {
    FoundResult found;
    for (const ChangeKind kind : {ChangeKind::fewer_rounds, ChangeKind::more_rounds}) {
        found.changes.push_back({kind, {}, "before", "after", {}});
        found.positions.emplace_back("a.frag:1:1");
    }
    found.places.resize(2);
    found.searched = 1;
    return found;
}

FoundRung& tried_at_two_places(FoundResult& found) {
    found.rungs = {tried("1", {0})};
    found.rungs[0].at.resize(2);
    return found.rungs[0];
}

// Lines of a terminal are broken at blanks.
std::string on_one_line(const std::string& text) {
    std::string line;
    for (const char c : text)
        if ((c != ' ' && c != '\n') || (!line.empty() && line.back() != ' ')) line += c == '\n' ? ' ' : c;
    return line;
}

bool says(const FoundResult& found, std::string_view words) {
    return on_one_line(found_text(found)).find(words) != std::string::npos;
}

// "1+2" alone would not say what it changes.
TEST(FoundReport, PartsOfACombinationAreListedWithIt) {
    FoundResult found = of_two();
    found.changes[1].kind = ChangeKind::culled;
    found.changes[1].before = "Sphere";
    found.rungs = {tried("1", {0}), tried("2", {1})};
    EXPECT_FALSE(says(found, "a.frag:1: Sphere → after"));
    found.rungs.push_back(tried("1+2", {0, 1}));
    found.rungs.back().only_where_tried = true;
    EXPECT_TRUE(says(found, "after, Sphere culled (1+2)")) << found_text(found);
    EXPECT_TRUE(says(found, "Sphere culled (2) a.frag:1: Sphere → after")) << found_text(found);
    EXPECT_TRUE(says(found, "after (1) a.frag:1: before → after"));
}

TEST(FoundReport, ErrorsAsTheSceneOpensAreNextToTheWorst) {
    FoundResult found = of_two();
    FoundRung& rung = tried_at_two_places(found);
    rung.at[0].own.light.rmse = .001;
    rung.at[0].flip = .002;
    rung.at[1].own.light.rmse = .03;
    rung.at[1].own.display.rmse = .04;
    rung.at[1].flip = .05;
    rung.worst_held_out = 1;
    rung.held_out = rung.only_where_tried = true;
    EXPECT_TRUE(says(found, " 0.0020 0.0500 0.03 ")) << found_text(found);
    EXPECT_TRUE(found_html(found).find(">0.0020</td><td class=\"number\">0.0500</td><td class=\"number\">0.03</td>") !=
                std::string::npos);
}

TEST(FoundReport, APlaceThatDoesNotChangeIsNoFlipOfTheWorst) {
    FoundResult found = of_two();
    FoundRung& rung = tried_at_two_places(found);
    rung.at[0].flip = 0;
    rung.at[1].own.light.rmse = .6;
    rung.worst_searched = 1;
    EXPECT_EQ(rung.flip(), std::nullopt);
    rung.at[1].flip = .7;
    EXPECT_EQ(rung.flip(), .7);
}

TEST(FoundReport, NothingIsSaidOfTimesThatWereNotTaken) {
    FoundResult found = of_two();
    found.rungs = {tried("1", {0}), tried("2", {1}, Aim::better)};
    found.interrupted = true;
    EXPECT_TRUE(says(found, "No cheaper change was timed.")) << found_text(found);
    EXPECT_FALSE(says(found, "saves time"));
    EXPECT_EQ(standing_of(found, found.rungs[0]), "not timed") << "it may save time";
    EXPECT_EQ(standing_of(found, found.rungs[1]), "stopped before it was tried at other places");
    FoundRung omission = tried("1", {0}, Aim::unused);
    EXPECT_EQ(standing_of(found, omission), "stopped before it was tried at other places");
    omission.held_out = true;
    EXPECT_EQ(standing_of(found, omission), "changes 0 pixels");
    omission.pixels_changed = 1;
    EXPECT_EQ(standing_of(found, omission), "changes pixels");
    found.interrupted = false;
    EXPECT_EQ(standing_of(found, found.rungs[1]), "not held out: the time was up");

    found.rungs[0].quick_ratio = 1.1;
    EXPECT_TRUE(says(found, "None of them saves time.")) << found_text(found);
    found.rungs.push_back(tried("3", {0}));
    EXPECT_TRUE(says(found, "None of those that were timed saves time.")) << found_text(found);
    found.rungs[0].quick_ratio = .5;
    EXPECT_TRUE(says(found, "None of those that were timed saves time.")) << "half of its frames took longer";
    EXPECT_EQ(standing_of(found, found.rungs[0]), "saves no time");
    found.rungs[0].saves = true;
    EXPECT_EQ(standing_of(found, found.rungs[0]), "another one saves more");
    EXPECT_TRUE(says(found, "before those that save time were timed in full")) << found_text(found);
}

TEST(FoundReport, WhatIsExactAndSavesNothingIsNotOnTheFront) {
    FoundResult found = of_two();
    found.rungs = {tried("1", {0})};
    found.rungs[0].timed = 0;
    SweepResult& sweep = found.timed;
    sweep.sweep = {.kind = SweepKind::found, .name = "found rungs", .reference = 1, .current = 1};
    sweep.residual = 0;
    sweep.clock = ClockKind::cpu;
    sweep.rungs = {{.name = "1", .drawn = true}, {.name = "scene", .drawn = true}};
    for (const double cost : {1., .8}) {
        for (RungResult& rung : sweep.rungs) rung.cpu.clear();
        for (int round = 0; round < 31; ++round) {
            sweep.rungs[0].cpu.push_back(cost * (10 + .1 * ((round + 1) % 3)));
            sweep.rungs[1].cpu.push_back(10 + .1 * (round % 3));
        }
        conclude(sweep, std::vector<double>(sweep.rungs[1].cpu));
        ASSERT_TRUE(sweep.trusted());
        EXPECT_EQ(found.front().size(), cost < 1 ? 1u : 0u);
        EXPECT_EQ(standing_of(found, found.rungs[0]), cost < 1 ? "front" : "no saving: scene");
        Report report;
        report.found = {found};
        EXPECT_EQ(csv_text(report).find(",1,front,") != std::string::npos, cost < 1) << csv_text(report);
        report.found[0].rungs[0].outcome = Outcome::not_tried;
        report.found[0].rungs[0].reason = "the time was up";
        EXPECT_NE(csv_text(report).find(",0,not tried: the time was up,"), std::string::npos) << csv_text(report);
    }
}

// Where a few bright pixels make the RMSE, it is not the picture that looks most different.
TEST(FoundReport, TheLargestFlipIsShownWhereverTheRmseIsLargest) {
    FoundResult found = of_two();
    FoundRung& rung = tried_at_two_places(found);
    rung.at[0].own.light.rmse = .04;
    rung.at[0].flip = .0664;
    rung.at[1].own.light.rmse = 1.6;
    rung.at[1].flip = .0159;
    rung.worst_searched = 1;
    EXPECT_EQ(rung.flip(), .0664);
    EXPECT_EQ(found_json(found)["rungs"][0]["error"]["flip_mean"], .0664);
    EXPECT_EQ(found_json(found)["rungs"][0]["error"]["own"]["light"]["rmse"], 1.6);
    EXPECT_EQ(found_json(found)["rungs"][0]["at"][1]["flip_mean"], .0159);
}

TEST(FoundReport, TextsOfShadersStayWithinTheirCells) {
    FoundResult found = of_two();
    found.rungs = {tried("1", {0})};
    found.changes[0].before = "a || b";
    found.rungs[0].outcome = Outcome::refused;
    found.rungs[0].reason = "error: a | <b>";
    const std::string page = found_markdown(found, "");
    const std::size_t row = page.find("| after, no. 1 (1) | ");
    ASSERT_NE(row, std::string::npos) << page;
    EXPECT_EQ(std::count(page.begin() + static_cast<std::ptrdiff_t>(row), page.end(), '|'), 5) << page;
    EXPECT_NE(page.find("a &#124;&#124; b"), std::string::npos) << page;
    EXPECT_NE(page.find("error: a &#124; &lt;b&gt;"), std::string::npos) << page;
}

TEST(FoundReport, AMeanThatIsNotKnownIsNoMistakeOfTheShader) {
    FoundResult found = of_two();
    found.rungs = {tried("1", {0}), tried("2", {1})};
    for (FoundRung& rung : found.rungs) rung.outcome = Outcome::refused;
    found.changes[1].probes = {{}};
    EXPECT_TRUE(says(found, " 1 would not compile, make another error or warning, or leave out what --set gives."))
        << found_text(found);
    EXPECT_TRUE(says(found, " 1 would need a mean that is not known.")) << found_text(found);
}

// Slow scenes are timed in smaller pictures than those that are compared, or than other rungs.
TEST(FoundReport, SizesAreThoseOfThePictures) {
    FoundResult found = of_two();
    found.rungs = {tried("1", {0}), tried("2", {1}, Aim::better)};
    found.width = found.height = 512;
    found.timed_size = {256, 256};
    found.costs_size = {128, 128};
    for (FoundRung& rung : found.rungs) {
        rung.timed = 0;
        rung.width = rung.height = 64;
    }
    for (const auto& [sweep, rung] : {std::pair{&found.timed, "1"}, {&found.costs, "2"}})
        for (const char* name : {rung, "scene"}) {
            sweep->rungs.push_back({.name = name, .drawn = true, .cpu = {1}, .wall = {1}});
            sweep->rungs.back().rounds = 1;
        }
    EXPECT_TRUE(says(found, "Times are of pictures of 256 × 256")) << found_text(found);
    EXPECT_TRUE(says(found, "What better changes cost, and what changes no pixel, is of pictures of 128 × 128"));
    EXPECT_EQ(found_json(found)["costs_size"][0], 128);
    const std::string csv = csv_text({.where = {.width = 512, .height = 512}, .found = {found}});
    EXPECT_TRUE(csv.substr(0, csv.find('\n')).ends_with(",ms_width,ms_height")) << csv;
    EXPECT_NE(csv.find(",256,256\n"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",128,128\n"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",64,64,"), std::string::npos) << csv;
    EXPECT_EQ(csv.find("512"), std::string::npos) << csv;
    EXPECT_FALSE(says(found, "'About'"));
    found.rungs.push_back(tried("3", {0}));
    found.rungs.back().quick_ratio = .5;
    found.quick_size = {128, 128};
    EXPECT_TRUE(says(found, "'About' is of a few frames of 128 × 128")) << found_text(found);
    found.quick_size = {512, 512};
    EXPECT_FALSE(says(found, "'About'"));
    found.costs_size = found.timed_size;
    EXPECT_FALSE(says(found, "What better changes cost"));
}

TEST(FoundReport, CombinationsAreNotCountedAmongChanges) {
    FoundResult found = of_two();
    found.rungs = {tried("1", {0}), tried("2", {1}), tried("1+2", {0, 1})};
    EXPECT_TRUE(says(found, "2 changes were found; 2 were tried alone, and 1 combination, at 2 places"))
        << found_text(found);
}

TEST(FoundReport, ATimeThatIsNotMeasurableIsNoCost) {
    FoundResult found = of_two();
    found.rungs = {tried("1", {0}, Aim::unused)};
    found.rungs[0].held_out = true;
    found.rungs[0].timed = 0;
    RungResult without{.name = "1"}, scene{.name = "scene"};
    without.rounds = scene.rounds = 9;
    without.milliseconds = 4;
    without.ratio = {.97, .98, 1.01};
    scene.milliseconds = 4.1;
    found.costs.rungs = {without, scene};
    EXPECT_TRUE(says(found, "costs less time than can be measured")) << found_text(found);
    found.costs.rungs[0].ratio = {.97, .98, .99};
    EXPECT_TRUE(says(found, "costs 0.1 ms of 4.1")) << found_text(found);
    found.costs.rungs[0].ratio = {.992, .995, .998};
    EXPECT_TRUE(says(found, "costs less time than can be measured")) << found_text(found);
    found.rungs[0].load_ms = 0;  // less than can be measured
    EXPECT_TRUE(says(found, "costs less time than can be measured")) << found_text(found);
    found.rungs[0].load_ms = 286.2;
    found.rungs[0].gpu_bytes = 2'000'000;
    EXPECT_TRUE(says(found, "costs less time than can be measured, 286 ms of loading, 2 MB of GPU memory"));
    found.rungs[0].timed.reset();
    EXPECT_TRUE(says(found, "costs 286 ms of loading, 2 MB of GPU memory")) << found_text(found);
    EXPECT_EQ(found_json(found)["rungs"][0]["saves"]["load_ms"], 286.2);
}

}  // namespace
}  // namespace snell::accuracy
