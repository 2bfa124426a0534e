// The page of hard cases, from what tests measured.
#include "tests/std.h"
#include "tools/stability/record.h"

namespace snell::stability {
namespace {

const Record ray{"68", "a ball far away", "units", "LibraryRay.Ball", "GL 3.3", .001, .0001, 3.};

TEST(StabilityPage, LinesReadBack) {
    const Record read = from_line(to_line(ray)).value();
    EXPECT_EQ(read.what, ray.what);
    EXPECT_EQ(read.tolerance, ray.tolerance);
    EXPECT_EQ(read.naive, ray.naive);
    Record without = ray;
    without.naive.reset();
    EXPECT_FALSE(from_line(to_line(without))->naive);
    EXPECT_FALSE(from_line("68\ta ball"));
    Record lost = ray;
    lost.naive = std::nan("");
    EXPECT_TRUE(std::isnan(from_line(to_line(lost))->naive.value()));
}

TEST(StabilityPage, ContextsShareARowWithTheWorstOfThem) {
    Record es = ray, core = ray;
    es.context = "ES 3.2";
    es.ours = .0005;
    core.context = "GL 4.5";
    core.naive = std::nan("");
    const std::string text = page({es, core, ray});
    EXPECT_NE(text.find("| 68 | a ball far away | NaN | 0.0005 | GL 3.3, GL 4.5, ES 3.2 | ≤ 0.001 units | "
                        "`LibraryRay.Ball` |\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find(row_begin(ray)), std::string::npos);
    EXPECT_NE(text.find(row_end(ray)), std::string::npos);
}

TEST(StabilityPage, CasesAreInTheirGroupsInOrder) {
    Record second = ray, ten = ray, two = ray;
    second.number = "A8";
    ten.number = "10";
    two.number = "2";
    const std::string text = page({second, ten, ray, two});
    EXPECT_LT(text.find("\n| 2 |"), text.find("\n| 10 |"));
    EXPECT_LT(text.find("\n| 10 |"), text.find("\n| 68 |"));
    EXPECT_LT(text.find("\n| 68 |"), text.find("\n| A8 |"));
    EXPECT_EQ(missing({second, ten, ray, two}).size(), 67U);
}

}  // namespace
}  // namespace snell::stability
