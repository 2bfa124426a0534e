// The file that the window's page goes to.
#include "src/app/window/saver.h"

#include <gtest/gtest.h>

#include "tests/scratch.h"

namespace snell {
namespace {

TEST(PageMaker, APageEndsWithHtml) {
    EXPECT_EQ(page_file("a/room"), "a/room.html");
    EXPECT_EQ(page_file("a/version 1.2"), "a/version 1.2.html");
    EXPECT_EQ(page_file("room.glib"), "room.glib.html");
    EXPECT_EQ(page_file("a.b/room"), "a.b/room.html");
    for (const char* whole : {"room.html", "room.HTML", "a/room.htm"}) EXPECT_EQ(page_file(whole), whole);
}

TEST(PageMaker, AFileIsReplacedOnlyIfItIsNamedInFull) {
    const Scratch folder;
    folder.write("version 1.2.html", "mine");
    PageMaker maker;
    EXPECT_NE(maker.start(folder.path() + "/version 1.2", {}).find("version 1.2.html exists"), std::string::npos);
    EXPECT_FALSE(maker.busy());
}

}  // namespace
}  // namespace snell
