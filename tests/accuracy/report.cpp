// What reports say of results that are written here by hand, and what is concluded from such results.
#include "src/accuracy/report/report.h"

#include <nlohmann/json.hpp>

#include "tests/std.h"

namespace snell::test {
namespace {

using namespace accuracy;

SweepResult sweep_of_two_rungs() {
    SweepResult result;
    result.scene = "a<b>&c.glib";
    result.own_pixels = 1;
    for (const char* name : {"rough", "exact"}) {
        result.sweep.rungs.push_back({name, {}, {}, {}});
        result.rungs.push_back({.name = name, .drawn = true});
    }
    result.sweep.reference = 1;
    return result;
}

TEST(Report, OnePixelIsSingular) {
    SweepResult sweep = sweep_of_two_rungs();
    sweep.rungs[0].own.nonfinite = 1;
    EXPECT_NE(notes_text(sweep, sweep.rungs[0]).find("1 pixel NaN"), std::string::npos);
    for (const std::string& text :
         {table_text(sweep), html_text({{}, {sweep}, {}}), markdown_text({{}, {sweep}, {}}, {})})
        EXPECT_EQ(text.find("1 pixels"), std::string::npos) << text;
}

// A lattice varies some of them; the others are at their last rungs.
TEST(Report, OtherLaddersAreNotAsInALattice) {
    for (const char* from : {"reference", "scene", "lattice"}) {
        const Report report{.where = {.from = from}, .sweeps = {sweep_of_two_rungs()}};
        const std::string words =
            std::string("ther ladders are as in the ") + (from == std::string("scene") ? "scene" : "reference");
        std::string header = header_text(report);
        std::replace(header.begin(), header.end(), '\n', ' ');
        EXPECT_NE(header.find(words), std::string::npos) << header;
        for (const std::string& text : {html_text(report), markdown_text(report, {})})
            EXPECT_EQ(text.find("as in the lattice"), std::string::npos);
    }
}

TEST(Report, PageShowsTheNameOfTheScene) {
    const std::string page = markdown_text({{}, {sweep_of_two_rungs()}, {}}, {});
    EXPECT_NE(page.find("## a&lt;b&gt;&amp;c.glib: "), std::string::npos) << page;
}

// The errors next to them are from the reference, which has finer samples than any rung.
TEST(Report, DifferencesAreThoseFromTheReference) {
    SweepResult sweep = sweep_of_two_rungs();
    sweep.sweep.kind = SweepKind::ladder;
    for (RungResult& rung : sweep.rungs) rung.picture = {1, 1, {.25, .25, .25, 1}};
    const auto shown = [&] {
        const std::string page = html_text({{}, {sweep}, {}});
        const auto source_before = [&](std::string_view alt) {
            const std::size_t end = page.find(alt), begin = page.rfind("src=", end);
            return end == std::string::npos ? "" : page.substr(begin, end - begin);
        };
        const std::string off = source_before("\" alt=\"difference of exact from the reference");
        EXPECT_FALSE(off.empty());
        return off;
    };
    const std::string none = shown();
    sweep.reference = {1, 1, {.75, .75, .75, 1}};
    EXPECT_NE(shown(), none);
}

TEST(Report, PicturesOfAnyShapeAreShown) {
    for (const auto& [width, height] : {std::pair{600, 1}, {1, 600}, {3, 3}}) {
        SweepResult sweep = sweep_of_two_rungs();
        for (RungResult& rung : sweep.rungs)
            rung.picture = {width, height, std::vector<float>(static_cast<std::size_t>(4 * width * height), .5F)};
        const std::string page = html_text({{}, {sweep}, {}});
        EXPECT_NE(page.find("base64,iVBOR"), std::string::npos) << width;
        EXPECT_EQ(page.find("base64,\""), std::string::npos) << width;
    }
}

TEST(Report, TooFewRoundsHaveNoInterval) {
    SweepResult sweep{.scene = "a, \"b\".glib", .sweep = {.name = "L"}, .clock = ClockKind::cpu};
    for (const double time : {1.5, 3.}) {
        sweep.rungs.push_back({.name = "=rung", .drawn = true, .cpu = {time, time, time}});
        sweep.sweep.rungs.push_back({.name = "=rung"});
    }
    conclude(sweep, sweep.rungs[0].cpu);
    EXPECT_EQ(time_text(sweep.rungs[0]), "1.5 ms (from 3 rounds, too few for an interval)");
    EXPECT_EQ(noise_sentence(sweep.control), "There are too few rounds to compare costs.");
    const Report report{.sweeps = {sweep}};
    const auto ladder = nlohmann::json::parse(json_text(report))["ladders"][0];
    for (const auto& of : {ladder["aa_control"], ladder["rungs"][1]["ms"], ladder["rungs"][1]["ratio_to_current"]})
        EXPECT_TRUE(of["lo95"].is_null() && of["hi95"].is_null()) << of;
    EXPECT_EQ(ladder["rungs"][1]["ratio_to_current"]["median"], 2);
    const std::string csv = csv_text(report), first = "\n\"a, \"\"b\"\".glib\",L,'=rung,1,1,";
    EXPECT_NE(csv.find(first), std::string::npos) << csv;
    EXPECT_NE(csv.find(",3,process CPU time,3,0,,,2,,,3,,,0,"), std::string::npos) << csv;
}

TEST(Report, WhatWasNotTimedHasNoClock) {
    SweepResult sweep = sweep_of_two_rungs();
    sweep.rungs[0].cpu = sweep.rungs[0].wall = std::vector<double>(31, 2.);
    sweep.clock = ClockKind::cpu;
    conclude(sweep, sweep.rungs[0].cpu);
    std::istringstream lines(csv_text({.sweeps = {sweep}}));
    std::vector<std::map<std::string, std::string>> rows;
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        std::vector<std::string> row;
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        if (names.empty()) {
            names = row;
            continue;
        }
        rows.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i) rows.back()[names[i]] = row[i];
    }
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0]["clock"], "process CPU time");
    EXPECT_EQ(rows[0]["aa_control_ratio"], "1");
    EXPECT_EQ(rows[0]["noisy"], "0");
    for (const auto& [name, value] : rows[1]) {
        const bool of_time = name == "clock" || name == "noisy" || name.starts_with("aa_control") ||
                             name.starts_with("ms_") || name.starts_with("cpu_");
        EXPECT_TRUE(!of_time || value.empty()) << name << " is " << value;
    }
}

TEST(Report, UnknownNumbersAreQuestionMarks) {
    SweepResult sweep = sweep_of_two_rungs();
    RungResult& rung = sweep.rungs[0];
    rung.own.light = rung.own.display = rung.whole.light = rung.alone = unknown_figures;
    rung.flip = std::nan("");
    for (const std::string& text :
         {table_text(sweep), html_text({{}, {sweep}, {}}), markdown_text({{}, {sweep}, {}}, {})})
        EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

// ---- conclusions from errors and times that are written here ----------------------------------------------------

SweepResult ladder_of(std::initializer_list<const char*> names) {
    SweepResult result;
    result.own_pixels = 1;
    for (const char* name : names) {
        result.sweep.rungs.push_back({name, {}, {}, {}});
        result.rungs.push_back({.name = name, .drawn = true});
    }
    result.sweep.reference = names.size() - 1;
    return result;
}

// A rung that looks nothing up has no direction, which is no angle of 0.
TEST(Conclusions, ARungWithoutDirectionsIsNotTheMostExact) {
    SweepResult result = ladder_of({"none", "far", "exact"});
    result.rungs[0].own.light.rmse = .3;
    result.rungs[0].degrees = Degrees{std::nan(""), std::nan(""), std::nan(""), 0};
    result.rungs[1].own.light.rmse = .1;
    result.rungs[1].degrees = Degrees{20, 20, 20, 5};
    result.rungs[2].degrees = Degrees{0, 0, 0, 5};
    conclude(result, {});
    EXPECT_EQ(result.metric, Metric::rmse) << "angles don't rank all of them";
    EXPECT_GT(result.error(result.rungs[0]), result.error(result.rungs[1]));
    EXPECT_TRUE(result.rungs[1].saturated);
    for (const std::string& text :
         {table_text(result), html_text({{}, {result}, {}}), markdown_text({{}, {result}, {}}, {})})
        EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

// Six rungs make 15 pairs, which need ten rounds. Where the last round was cut short, some have only nine.
TEST(Conclusions, ARoundThatWasCutShortCountsForNone) {
    for (const std::size_t rounds : {rounds_for(6) - 1, rounds_for(6)}) {
        SweepResult result = ladder_of({"1", "2", "3", "4", "5", "6"});
        result.sweep.current = 0;
        result.clock = ClockKind::cpu;
        for (std::size_t i = 0; i < 6; ++i) {
            result.rungs[i].alone.rmse = 1. - .1 * static_cast<double>(i);
            result.rungs[i].cpu.assign(rounds_for(6), 1. + static_cast<double>(i));
            if (i > 2 && rounds < rounds_for(6)) result.rungs[i].cpu.back() = 0;
        }
        conclude(result, result.rungs[0].cpu);
        EXPECT_EQ(result.few_rounds, rounds < rounds_for(6));
    }
}

// Counts that were not drawn may be as wrong as any.
TEST(Conclusions, WhatCountsLeaveIsNotKnownWithoutTheLastOnes) {
    for (const std::size_t missing : {std::size_t{4}, std::size_t{2}, std::size_t{1}}) {
        SweepResult result = ladder_of({"1", "2", "4", "8"});
        result.sweep.numeric = true;
        result.residual = 1e-4;
        for (std::size_t i = 0; i < 3; ++i) result.rungs[i].alone.rmse = .1 * std::exp2(-static_cast<double>(i));
        if (missing < 4) result.rungs[missing] = {.name = "missing"};
        conclude(result, {});
        EXPECT_EQ(result.residual.has_value(), missing == 4) << missing << ": " << result.reference_note;
        EXPECT_EQ(result.reference_note.find("not known") != std::string::npos, missing < 4) << result.reference_note;
    }
}

}  // namespace
}  // namespace snell::test
