#include "tests/hard_case.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "tools/stability/record.h"

namespace snell::test {
namespace {

// GL tests say which context they have; others have none.
std::string context(const testing::TestInfo& test) {
    const testing::TestResult& result = *test.result();
    for (int i = 0; i < result.test_property_count(); ++i)
        if (std::string_view(result.GetTestProperty(i).key()) == "context") return result.GetTestProperty(i).value();
    return "CPU";
}

// "All/LibraryRay.ABallIsHitFromAfar/Core33" is the test LibraryRay.ABallIsHitFromAfar.
std::string plain_name(const testing::TestInfo& test) {
    std::string suite = test.test_suite_name(), name = test.name();
    if (const auto slash = suite.find('/'); slash != std::string::npos) suite.erase(0, slash + 1);
    if (const auto slash = name.find('/'); slash != std::string::npos) name.erase(slash);
    return suite + "." + name;
}

const std::string& page() {
    static const std::string text = [] {
        std::ifstream in(SNELL_ROOT "/docs/stability.md");
        std::stringstream all;
        all << in.rdbuf();
        return all.str();
    }();
    return text;
}

void write(const std::string& folder, const stability::Record& record) {
    const std::size_t key = std::hash<std::string>{}(record.number + record.what + record.test + record.context);
    std::ofstream out(folder + "/" + record.number + "-" + std::to_string(key) + ".tsv");
    out << stability::to_line(record) << '\n';
    ASSERT_TRUE(out.flush()) << "no record can be written to " << folder;
}

}  // namespace

void hard_case(const HardCase& measured) {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    const stability::Record record{std::string(measured.number),
                                   std::string(measured.what),
                                   std::string(measured.unit),
                                   plain_name(test),
                                   context(test),
                                   measured.tolerance,
                                   measured.ours,
                                   measured.naive};
    SCOPED_TRACE("hard case " + record.number + ": " + record.what);
    EXPECT_LE(measured.ours, measured.tolerance) << measured.unit;
    if (measured.naive) {
        EXPECT_FALSE(*measured.naive <= measured.tolerance) << "naive code does as well: " << *measured.naive;
    }
    if (const char* folder = std::getenv("SNELL_STABILITY_OUT"); folder && *folder) {
        write(folder, record);
        return;
    }
    EXPECT_NE(page().find(stability::row_begin(record)), std::string::npos)
        << "docs/stability.md has no row that begins with " << stability::row_begin(record)
        << ": make it anew by ./dev stability";
    EXPECT_NE(page().find(stability::row_end(record)), std::string::npos)
        << "docs/stability.md has no row that ends with " << stability::row_end(record)
        << ": make it anew by ./dev stability";
}

}  // namespace snell::test
