// The tests that draw would see what the driver complains of.
#include <gtest/gtest-spi.h>

#include <epoxy/gl.h>

#include "tests/harness/harness.h"

namespace snell::test {
namespace {

using Harness = GlTest;

TEST_F(Harness, AskedForADebugContext) {
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    EXPECT_TRUE(flags & GL_CONTEXT_FLAG_DEBUG_BIT);
}

TEST_F(Harness, AnErrorOfOpenGlFailsATest) {
    expect_quiet();
    glEnable(GL_TEXTURE_WRAP_S);  // nothing that can be enabled
    EXPECT_EQ(complaints.size(), 1U) << "the driver does not say what is wrong";
    complaints.clear();  // what glGetError tells is enough to fail
    EXPECT_NONFATAL_FAILURE(expect_quiet(), "GL_INVALID_ENUM");
    expect_quiet();
}

TEST_F(Harness, AComplaintOfTheDriverFailsATest) {
    const auto insert = [](GLenum type, GLenum severity, const char* text) {
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, type, 1, severity, -1, text);
    };
    insert(GL_DEBUG_TYPE_PERFORMANCE, GL_DEBUG_SEVERITY_MEDIUM, "slow");
    expect_quiet();
    insert(GL_DEBUG_TYPE_ERROR, GL_DEBUG_SEVERITY_MEDIUM, "an error");
    EXPECT_NONFATAL_FAILURE(expect_quiet(), "an error");
    insert(GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, GL_DEBUG_SEVERITY_MEDIUM, "undefined");
    EXPECT_NONFATAL_FAILURE(expect_quiet(), "undefined");
    insert(GL_DEBUG_TYPE_OTHER, GL_DEBUG_SEVERITY_HIGH, "out of something");
    EXPECT_NONFATAL_FAILURE(expect_quiet(), "out of something");
    expect_quiet();
}

}  // namespace
}  // namespace snell::test
