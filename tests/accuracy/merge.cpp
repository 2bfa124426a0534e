// Reports of several machines: what holds on all of them, and what does not.
#include "src/accuracy/report/report.h"

#include <nlohmann/json.hpp>

#include "tests/std.h"

namespace snell::accuracy {
namespace {

// A report with two rungs besides the current one, whose costs are relative to it.
NamedReport report(const std::string& name, double first, double second, bool quiet = true,
                   const std::string& scene = "scene.glib", int side = 64) {
    SweepResult sweep{.scene = scene, .sweep = {.name = "L", .reference = 2, .current = 2}};
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
    conclude(sweep, again);
    Report result;
    result.where.renderer = name;
    result.where.width = result.where.height = side;
    result.sweeps = {sweep};
    return {name + ".json", json_text(result)};
}

// A report with one found rung, whose number depends on the machine.
NamedReport found_report(const std::string& name, double cost, const std::string& number, const std::string& after) {
    FoundResult found;
    found.scene = "scene.glib";
    found.changes = {{.kind = ChangeKind::fewer_rounds, .where = {}, .before = "i < 8", .after = after, .edits = {}}};
    found.positions = {name + "/a.frag:3:5"};
    FoundRung rung{.name = number, .changes = {0}, .outcome = Outcome::tried, .at = {{}}};
    rung.timed = 0;
    found.rungs = {rung};
    found.timed_size = {64, 64};
    SweepResult& sweep = found.timed;
    sweep.sweep = {.kind = SweepKind::found, .name = "found rungs", .reference = 1, .current = 1};
    sweep.residual = 0;
    for (const double one : {cost, 1.}) {
        RungResult timed{.name = one == 1 ? "scene" : number, .drawn = true};
        timed.own.light.rmse = one == 1 ? 0 : .1;
        for (int round = 0; round < 31; ++round) timed.cpu.push_back(one * (10 + .01 * (round % 3)));
        sweep.rungs.push_back(std::move(timed));
    }
    sweep.clock = ClockKind::cpu;
    conclude(sweep, std::vector<double>(sweep.rungs[1].cpu));
    Report result;
    result.where.renderer = name;
    result.found = {found};
    return {name + ".json", json_text(result)};
}

// The report with every `from` replaced.
NamedReport changed(NamedReport report, const std::string& from, const std::string& to) {
    for (std::size_t at = report.json.find(from); at != std::string::npos; at = report.json.find(from, at + to.size()))
        report.json.replace(at, from.size(), to);
    return report;
}

std::string merged(std::initializer_list<NamedReport> reports) {
    std::string error;
    const auto text = merged_text(std::vector<NamedReport>(reports), error);
    EXPECT_TRUE(text) << error;
    return text.value_or("");
}

// The rows of the rung, one for each machine, with single blanks.
std::string rows_of(const std::string& text, const std::string& rung) {
    std::size_t end = text.find("\n  " + rung + " "), begin = end;
    if (begin == std::string::npos) return "";
    do end = std::min(text.find('\n', end + 1), text.size());
    while (text.compare(end, 4, "\n   ") == 0);
    std::string rows;
    for (const char c : text.substr(begin, end - begin))
        if (c != ' ' || !rows.ends_with(' ')) rows += c;
    return rows;
}

TEST(Merge, BargainThatFlipsBetweenMachinesIsNotPortable) {
    const NamedReport reports[]{report("one", .5, .8), report("two", .5, 1.3)};
    std::string error;
    const auto text = merged_text(reports, error);
    ASSERT_TRUE(text) << error;
    EXPECT_NE(text->find("A: one.json (one"), std::string::npos) << *text;
    EXPECT_EQ(rows_of(*text, "a").find("not portable"), std::string::npos) << *text;
    EXPECT_NE(rows_of(*text, "b").find("not portable"), std::string::npos) << *text;
    EXPECT_NE(rows_of(*text, "b").find("dominated by c"), std::string::npos) << *text;
}

TEST(Merge, FitsATerminal) {
    const std::string path = "/home/somebody/with/a/long/folder/name/and/another/long/folder/name/in/it/scene.glib";
    const std::string long_name(90, 'n');
    std::vector<NamedReport> reports;
    for (const char* name : {"one", "two", "three", "four"})
        reports.push_back(changed(report(name + std::string(100, 'x'), .5, 1.3, true, path + "/" + name + "/s.glib"),
                                  "\"b\"", '"' + long_name + '"'));
    std::string error, text = merged_text(reports, error).value_or(error);
    EXPECT_NE(text.find("dominated by c"), std::string::npos) << text;
    for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
        end = std::min(text.find('\n', at), text.size());
        EXPECT_LE(end - at, content::page_columns) << text.substr(at, end - at);
    }
}

// Of few rounds there is no interval.
TEST(Merge, RatiosWithoutAnIntervalAreListed) {
    NamedReport few = report("few", .5, .8);
    auto json = nlohmann::ordered_json::parse(few.json);
    json["ladders"][0]["rungs"][1]["ratio_to_current"] = {{"median", .75}, {"lo95", nullptr}, {"hi95", nullptr}};
    few.json = json.dump();
    const std::string text = merged({report("one", .5, .8), few});
    EXPECT_NE(rows_of(text, "b").find(" B 0.75 "), std::string::npos) << text;
}

TEST(Merge, NoisyMachineContradictsNothing) {
    const NamedReport reports[]{report("one", .5, .8), report("two", .5, 1.3, false)};
    std::string error;
    const auto text = merged_text(reports, error);
    ASSERT_TRUE(text) << error;
    EXPECT_EQ(text->find("not portable"), std::string::npos) << *text;
    EXPECT_NE(rows_of(*text, "b").find("can't say"), std::string::npos) << *text;
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

TEST(Merge, ScenesAreMatchedByTheirFilesNames) {
    const std::string text =
        merged({report("one", .5, .8, true, "/home/a/scene.glib"), report("two", .5, 1.3, true, "scene.glib")});
    EXPECT_NE(rows_of(text, "b").find("not portable"), std::string::npos) << text;
    EXPECT_NE(text.find("matched by the file's name: A: /home/a/scene.glib, B: scene.glib"), std::string::npos) << text;
    EXPECT_EQ(merged({report("one", .5, .8), report("two", .5, .8)}).find("matched by"), std::string::npos);
}

// Two scenes of one name in one report are told apart by their paths.
TEST(Merge, ScenesOfOneNameInOneReportAreNotMixed) {
    NamedReport both = report("one", .5, .8, true, "x/scene.glib");
    const std::string ladders = "\"ladders\": [", other = report("one", .5, 1.3, true, "y/scene.glib").json;
    const std::size_t from = other.find(ladders) + ladders.size();
    const std::size_t end = other.rfind(']', other.find("\"found\": ["));
    both.json.insert(both.json.find(ladders) + ladders.size(), other.substr(from, end - from) + ",");
    const std::string text = merged({both, report("two", .5, .8, true, "x/scene.glib")});
    EXPECT_NE(text.find("\nx/scene.glib: L\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("not portable"), std::string::npos) << text;
    std::string error;
    const NamedReport apart[]{both, report("two", .5, .8, true, "z/scene.glib")};
    EXPECT_FALSE(merged_text(apart, error));
    EXPECT_NE(error.find("several scenes named 'scene.glib'"), std::string::npos) << error;
}

TEST(Merge, PicturesOfDifferentSizesAreNotCompared) {
    const std::string text = merged({report("one", .5, .8), report("two", .5, 1.3, true, "scene.glib", 32)});
    EXPECT_NE(text.find("not comparable: A: 64 x 64, B: 32 x 32"), std::string::npos) << text;
    EXPECT_EQ(text.find("not portable"), std::string::npos) << text;
    EXPECT_NE(rows_of(text, "b").find("can't say"), std::string::npos) << text;
}

TEST(Merge, RungsOfAnyReportAreListed) {
    const std::string text = merged({report("one", .5, .8), changed(report("two", .5, .8), "\"b\"", "\"new\"")});
    EXPECT_NE(rows_of(text, "new").find(" A -"), std::string::npos) << text;
    EXPECT_NE(rows_of(text, "new").find(" B 0.8"), std::string::npos) << text;
    EXPECT_NE(rows_of(text, "b").find(" A 0.8"), std::string::npos) << text;
}

TEST(Merge, FoundRungsAreMatchedByWhatTheyChange) {
    const std::string same = merged({found_report("one", .5, "3", "i < 4"), found_report("two", .6, "7", "i < 4")});
    EXPECT_NE(same.find("\nscene.glib: found rungs\n"), std::string::npos) << same;
    EXPECT_NE(rows_of(same, "a.frag:3:5: i < 8 → i < 4").find(" B 0.6"), std::string::npos) << same;
    EXPECT_EQ(same.find("not portable"), std::string::npos) << same;
    const std::string flips = merged({found_report("one", .5, "3", "i < 4"), found_report("two", 1.5, "3", "i < 4")});
    EXPECT_NE(rows_of(flips, "a.frag:3:5: i < 8 → i < 4").find("not portable"), std::string::npos) << flips;
    const std::string other = merged({found_report("one", .5, "3", "i < 4"), found_report("two", .5, "3", "i < 2")});
    EXPECT_NE(rows_of(other, "a.frag:3:5: i < 8 → i < 4").find("can't say"), std::string::npos) << other;
}

TEST(Merge, DamagedNumbersAndOtherSchemasAreErrors) {
    const NamedReport good = report("one", .5, .8);
    for (const auto& [from, to, message] :
         {std::array{"\"median\": ", "\"median\": \"x\", \"was\": ", "is not a report"},
          std::array{"\"schema\": 3", "\"schema\": 2", "another version of snell"}}) {
        const NamedReport reports[]{good, changed(good, from, to)};
        std::string error;
        EXPECT_FALSE(merged_text(reports, error)) << from;
        EXPECT_NE(error.find(message), std::string::npos) << error;
    }
}

TEST(Merge, NoEscapeSequenceIsPrinted) {
    const std::string sequence = "\\u001b[31m";
    const NamedReport sent = changed(changed(report("two", .5, .8), "\"b\"", "\"b" + sequence + "\""), "\"cpu\": \"",
                                     "\"cpu\": \"" + sequence);
    const std::string text = merged({report("one", .5, .8), sent});
    EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
    EXPECT_NE(text.find("b\\x1B[31m"), std::string::npos) << text;
    EXPECT_NE(text.find("(two, \\x1B[31m"), std::string::npos) << text;
}

}  // namespace
}  // namespace snell::accuracy
