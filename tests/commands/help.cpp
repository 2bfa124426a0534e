// What the command line explains: subcommands, commands, codes, and what shells complete.
#include <gtest/gtest.h>

#include "src/app/help/program.h"
#include "tests/cli/run.h"
#include "tests/cli/terminal.h"
#include "tests/scratch.h"

namespace snell::test {
namespace {

TEST(Help, AWrongSubcommandIsAnErrorThatNamesTheRightOne) {
    for (const char* wrong : {"rendr", "rendr scenes/light/glass/glass.glib -o x.png", "Render", "swep x.glib"}) {
        const Outcome outcome = snell(wrong);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_TRUE(outcome.says(outcome.output.find("swep") == std::string::npos ? "did you mean 'render'?"
                                                                                  : "did you mean 'sweep'?"))
            << outcome.output;
    }
    EXPECT_EQ(app::meant_subcommand("tests"), "") << "a folder of that name";
    EXPECT_EQ(app::meant_subcommand("rendr.glib"), "");
    EXPECT_EQ(app::meant_subcommand("./rendr"), "");
    EXPECT_EQ(app::meant_subcommand("glassball"), "");
    EXPECT_EQ(app::meant_subcommand("render"), "");
    EXPECT_EQ(app::meant_subcommand("--rendr"), "");
}

TEST(Help, ColorsMayStandAheadOfASubcommand) {
    const Outcome outcome = snell("--color never rendr x.glib");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.says("did you mean 'render'?")) << outcome.output;
    EXPECT_EQ(snell("--color=never commands Sphere").output, snell("commands Sphere").output);
}

TEST(Help, AMisspeltOptionIsNamedAheadOfOneThatIsMissing) {
    const Outcome outcome = snell("render scenes/light/glass/glass.glib --outptu x.png");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.says("'--outptu'")) << outcome.output;
    EXPECT_TRUE(outcome.says("did you mean '--output'?")) << outcome.output;
    EXPECT_TRUE(snell("render scenes/light/glass/glass.glib --sizze=8x8 -o x.png").says("did you mean '--size'?"));
    EXPECT_TRUE(snell("render scenes/light/glass/glass.glib").says("--output")) << "the one that is missing";
}

TEST(Help, NamesThatGlslCannotHaveAreNotOffered) {
    const Scratch folder;
    const std::string scene =
        folder.write("odd.glib",
                     "Perspective 60\nVertex a\nFragment a\nProgram B ux`touch$IFS/x`y 3 uGood 4 u.A 1 2u 3 u\x1b"
                     "b 3 uB[2] 3\n");
    const std::string found = snell("complete uniforms " + scene).output;
    EXPECT_NE(found.find("uGood=\t"), std::string::npos) << found;
    EXPECT_NE(found.find("uB[2]="), std::string::npos) << found;
    for (const char* odd : {"`", "\x1b", "2u", "$"}) EXPECT_EQ(found.find(odd), std::string::npos) << found;
}

TEST(Help, LaddersAreOfferedBehindAComma) {
    const std::string scene = "scenes/light/glass/glass.glib ";
    EXPECT_EQ(snell("complete ladders " + scene + "BEND,RAT").output, "BEND,RATIO\tladder\n");
    EXPECT_EQ(snell("complete ladders " + scene + "BEND,BE").output, "") << "it is listed already";
}

TEST(Help, EverySubcommandHasAPageWithExamplesOfItsOwn) {
    for (const app::Subcommand& row : app::subcommands()) {
        const Outcome outcome = snell(std::string("help ") + row.name);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_TRUE(outcome.says(std::string("Usage: snell ") + row.name)) << outcome.output;
        EXPECT_TRUE(outcome.says(std::string("  snell ") + row.name)) << outcome.output;
        EXPECT_EQ(outcome.output, snell(std::string(row.name) + " --help").output);
    }
    EXPECT_EQ(snell("help").output, snell("--help").output);
}

TEST(Help, CodesAndCommandsAreExplained) {
    const Outcome lint = snell("help pow-of-negative");
    EXPECT_EQ(lint.status, 0);
    EXPECT_TRUE(lint.says("## Pow of a negative number")) << lint.output;
    EXPECT_TRUE(snell("help glsl-syntax").says("### glsl-syntax\n\nThe driver cannot read"));
    EXPECT_EQ(snell("help sphere").output, snell("commands Sphere").output);
    EXPECT_TRUE(snell("commands sphere").output.starts_with("Sphere ")) << "without regard to case";
    const Outcome unknown = snell("help glsl-sintax");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_TRUE(unknown.says("did you mean 'glsl-syntax'?")) << unknown.output;
    const Outcome command = snell("commands Spere");
    EXPECT_EQ(command.status, 2);
    EXPECT_TRUE(command.says("did you mean 'Sphere'?")) << command.output;
    for (const std::string_view code : app::explained_codes()) EXPECT_GT(app::explanation(code).size(), 40U) << code;
    EXPECT_GT(app::explained_codes().size(), 200U);
}

TEST(Help, ASectionEndsAtTheNextHeadingOfItsLevel) {
    const std::string page =
        "# A\n\n## The sign in Schlick's\n\ntext\n```sh\n# not a heading\n```\n### deep\nmore\n## B\nb\n";
    EXPECT_EQ(app::section(page, "the-sign-in-schlicks"),
              "## The sign in Schlick's\n\ntext\n```sh\n# not a heading\n```\n### deep\nmore\n");
    EXPECT_EQ(app::section(page, "deep"), "### deep\nmore\n");
    EXPECT_EQ(app::section(page, "b"), "## B\nb\n");
    EXPECT_EQ(app::section(page, "not-a-heading"), "");
}

TEST(Completion, KnowsTheUniformsAndRungsOfAScene) {
    Scratch folder;
    folder.write("a.vert", "void main() { gl_Position = ftransform(); }\n");
    folder.write("a.frag",
                 "uniform float uIndex, uInside; uniform vec3 uLightColor; uniform mat4 uModelViewMatrix;\n"
                 "void main() { gl_FragColor = vec4(uLightColor * uIndex * uInside, uModelViewMatrix[0][0]); }\n");
    folder.write(
        "a.glib",
        "Ladder FRESNEL schlick [exact]\nVertex a.vert\nFragment a.frag\nProgram Ball uIndex <1. 1.5 2.>\nSphere\n");
    const std::string scene = folder.path("a.glib");
    EXPECT_EQ(snell("complete uniforms " + scene).output, "uIndex=\t<1. 1.5 2.>\nuInside=\tfloat\nuLightColor=\tvec3\n")
        << "snell sets the matrix itself";
    EXPECT_EQ(snell("complete uniforms " + scene + " uL").output, "uLightColor=\tvec3\n");
    EXPECT_EQ(snell("complete rungs " + scene + " FRESNEL=e").output, "FRESNEL=exact\tas the scene says\n");
    EXPECT_EQ(snell("complete axes " + scene + " F").output, "FRESNEL=\tladder\n");
    const Outcome none = snell("complete uniforms " + folder.path("none.glib"));
    EXPECT_EQ(none.status, 0) << "a shell must not show errors";
    EXPECT_EQ(none.output, "");
}

TEST(Colors, AreOnATerminalOnly) {
    Scratch folder;
    folder.write("a.glib", "Spher 1\n");
    const std::string check = "check " + folder.path("a.glib");
    EXPECT_NE(on_terminal(check).first.find("\x1b[1;31merror:"), std::string::npos);
    EXPECT_NE(on_terminal("rendr").first.find("\x1b[1;31merror:"), std::string::npos) << "on standard error";
    EXPECT_EQ(on_terminal(check + " --color never").first.find('\x1b'), std::string::npos);
    EXPECT_EQ(on_terminal("check --json " + folder.path("a.glib")).first.find("\x1b[1"), std::string::npos);
    EXPECT_EQ(snell(check).output.find('\x1b'), std::string::npos);
    EXPECT_EQ(snell(check, "NO_COLOR=1").output, snell(check).output);
    EXPECT_TRUE(snell(check, "CLICOLOR_FORCE=1").says("\x1b[1;31merror:"));
    EXPECT_TRUE(snell(check + " --color always").says("\x1b[1;31m^~~~~"));
    EXPECT_TRUE(snell("--color always " + folder.path("none.glib")).says("\x1b[1;31merror:"));
    const Outcome full = snell(check + " --color always >/dev/full");
    EXPECT_EQ(full.status, 1);
    EXPECT_TRUE(full.says("cannot write to standard output")) << full.output;
    const std::string last = folder.write("b.glib", "Sphere 1");
    EXPECT_EQ(snell("format --color always - <" + last).output, "Sphere 1") << "without a line end";
}

TEST(Help, OnAFullDiskIsAnError) {
    for (const std::string asked : {"--help", "--version", "help", "render --help"}) {
        const Outcome full = snell(asked + " >/dev/full");
        EXPECT_EQ(full.status, 1) << asked;
        EXPECT_TRUE(full.says("cannot write to standard output")) << asked << full.output;
    }
}

}  // namespace
}  // namespace snell::test
