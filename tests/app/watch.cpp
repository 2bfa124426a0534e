// Saved files are noticed: once, at rest, however they were written.
#include <gtest/gtest.h>

#include <filesystem>

#include "src/app/desktop/watch.h"
#include "tests/scratch.h"

namespace snell {
namespace {

namespace fs = std::filesystem;

class WatchTest : public ::testing::Test {
protected:
    std::string file(const std::string& name) const { return folder_.path(name); }
    void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
    // Looks until all is at rest: how often a change was told.
    int told() {
        int count = 0;
        for (int look = 0; look < 5; ++look) count += watch_.changed();
        return count;
    }

    const Scratch folder_;
    Watch watch_;
};

TEST_F(WatchTest, NothingHappenedNothingIsTold) {
    write("a", "1");
    watch_.set_paths({file("a"), file("missing"), folder_.path()});
    EXPECT_EQ(told(), 0);
}

TEST_F(WatchTest, AChangeIsToldOnceAndOnlyAtRest) {
    write("a", "1");
    watch_.set_paths({file("a")});
    write("a", "12");
    EXPECT_FALSE(watch_.changed()) << "it may still be being written";
    write("a", "123");
    EXPECT_FALSE(watch_.changed());
    EXPECT_TRUE(watch_.changed());
    EXPECT_EQ(told(), 0);
    write("a", "1234");
    EXPECT_TRUE(watch_.changed(true)) << "where nobody waits for the next poll";
    EXPECT_EQ(told(), 0);
}

TEST_F(WatchTest, RenamingOverDeletingAndAppearingAreChanges) {
    write("a", "1");
    watch_.set_paths({file("a"), file("b")});
    write("fresh", "2");
    fs::rename(file("fresh"), file("a"));
    EXPECT_EQ(told(), 1);
    fs::remove(file("a"));
    EXPECT_EQ(told(), 1);
    write("b", "");
    EXPECT_EQ(told(), 1);
}

TEST_F(WatchTest, OfAFolderOnlyItsNamesCount) {
    write("a", "1");
    watch_.set_paths({folder_.path()});
    write("a", "2");
    write("fresh", "3");
    fs::rename(file("fresh"), file("a"));  // the folder changed, its names did not
    EXPECT_EQ(told(), 0);
    write("b", "");
    EXPECT_EQ(told(), 1);
}

TEST_F(WatchTest, PathsThatStayKeepWhatIsKnownOfThem) {
    write("a", "1");
    write("b", "1");
    watch_.set_paths({file("a")});
    write("a", "12");
    watch_.set_paths({file("a"), file("b"), file("a")});
    EXPECT_EQ(told(), 1) << "saved while others were read";
}

}  // namespace
}  // namespace snell
