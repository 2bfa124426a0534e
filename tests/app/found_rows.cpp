// What the window's list of found rungs says, for results made by hand.
#include "src/app/window/measure/found_view.h"

#include <gtest/gtest.h>

#include "src/accuracy/report/report.h"

namespace snell {
namespace {

struct OneRung {
    explicit OneRung(accuracy::Aim aim) {
        const FileId file = sources.add("a.frag", "i < 8");
        result.changes = {
            {.kind = accuracy::ChangeKind::fewer_rounds, .where = {file, 0, 5}, .before = "i < 8", .after = "i < 4"}};
        result.positions = {"a.frag:1:1"};
        result.places.resize(8);
        result.searched = 4;
        accuracy::FoundRung rung;
        rung.name = "1";
        rung.changes = {0};
        rung.aim = aim;
        rung.outcome = accuracy::Outcome::tried;
        rung.at.resize(4);
        result.rungs = {rung};
    }
    std::string remark(bool searching) const { return found_rows(result, sources, searching).at(0).remark; }
    std::string report() const { return accuracy::standing_of(result, result.rungs[0]); }

    accuracy::FoundResult result;
    Sources sources;
};

TEST(FoundRows, PlacesThatAreHeldOutAreToldAsInTheReport) {
    OneRung better(accuracy::Aim::better);
    EXPECT_EQ(better.remark(true), "") << "it may still be tried there";
    EXPECT_EQ(better.remark(false), "not held out: the time was up");
    EXPECT_EQ(better.remark(false), better.report());
    better.result.rungs[0].held_out = true;
    EXPECT_EQ(better.remark(false), "");
    OneRung cheaper(accuracy::Aim::cheaper);
    cheaper.result.rungs[0].held_out = cheaper.result.rungs[0].only_where_tried = true;
    EXPECT_EQ(cheaper.remark(true), "at other views and values its error is more than twice as large");
    EXPECT_EQ(cheaper.remark(true), cheaper.report());
}

TEST(FoundRows, WhatIsLoadedForNothingIsPassedOn) {
    OneRung unused(accuracy::Aim::unused);
    unused.result.rungs[0].held_out = true;
    unused.result.rungs[0].load_ms = 286;
    EXPECT_EQ(found_rows(unused.result, unused.sources, false).at(0).loading, 286);
}

TEST(FoundRows, ARungIsWhereItsTimePutsIt) {
    using Group = ui::FoundRow::Group;
    for (const auto& [ratio, group] :
         {std::pair(.9, Group::cheaper), {.99, Group::cheaper}, {.998, Group::dearer}, {1.01, Group::dearer}}) {
        OneRung found(accuracy::Aim::cheaper);
        found.result.rungs[0].quick_ratio = ratio;
        found.result.rungs[0].saves = found.result.rungs[0].quicker = true;  // as far as the first frames told
        EXPECT_EQ(found_rows(found.result, found.sources, false).at(0).group, group) << ratio;
        found.result.rungs[0].quicker = false;
        for (const bool searching : {true, false})
            EXPECT_EQ(found_rows(found.result, found.sources, searching).at(0).group, Group::dearer) << ratio;
    }
}

TEST(FoundRows, TwoOfALineAreToldApart) {
    OneRung found(accuracy::Aim::cheaper);
    const FileId file = found.sources.add("b.frag", "i < 8; j < 8;");
    for (const std::uint32_t at : {0U, 7U}) {
        found.result.changes.push_back(
            {.kind = accuracy::ChangeKind::fewer_rounds, .where = {file, at, at + 5}, .before = "", .after = ""});
        found.result.positions.push_back("b.frag:1:" + std::to_string(at + 1));
        found.result.rungs.push_back(found.result.rungs[0]);
        found.result.rungs.back().changes = {found.result.changes.size() - 1};
        found.result.rungs.back().name = std::to_string(found.result.changes.size());
    }
    std::vector<std::string> places;
    for (const ui::FoundRow& row : found_rows(found.result, found.sources, false)) places.push_back(row.where);
    EXPECT_EQ(places, (std::vector<std::string>{"a.frag:1", "b.frag:1:1", "b.frag:1:8"}));
}

}  // namespace
}  // namespace snell
