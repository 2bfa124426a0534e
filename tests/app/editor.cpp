// Editors are started with the words that they understand, and never through a shell.
#include <chrono>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

#include "src/app/desktop/editor.h"
#include "tests/scratch.h"

namespace snell {
namespace {

using Words = std::vector<std::string>;

TEST(EditorCommand, TellsEachEditorTheLineAsItWantsIt) {
    const auto words = [](const char* editor) { return editor_command(editor, "/s/a b.frag", 12, 3).words; };
    EXPECT_EQ(words("vim"), (Words{"vim", "+12", "/s/a b.frag"}));
    EXPECT_EQ(words("/usr/bin/vi"), (Words{"/usr/bin/vi", "+12", "/s/a b.frag"}));
    EXPECT_EQ(words("nano"), (Words{"nano", "+12,3", "/s/a b.frag"}));
    EXPECT_EQ(words("emacs"), (Words{"emacs", "+12:3", "/s/a b.frag"}));
    EXPECT_EQ(words("code"), (Words{"code", "--goto", "/s/a b.frag:12:3"}));
    EXPECT_EQ(words("subl"), (Words{"subl", "/s/a b.frag:12:3"}));
    EXPECT_EQ(words("kate"), (Words{"kate", "--line", "12", "/s/a b.frag"}));
    EXPECT_EQ(words("xdg-open"), (Words{"xdg-open", "/s/a b.frag"})) << "it opens files, not lines";
    EXPECT_EQ(words("myedit"), (Words{"myedit", "/s/a b.frag"})) << "what is not known gets nothing to stumble over";
    EXPECT_TRUE(words("  ").empty());
}

TEST(EditorCommand, ItsOwnArgumentsStandBeforeOurs) {
    EXPECT_EQ(editor_command(" code  --wait\t-n ", "/f", 1, 1).words,
              (Words{"code", "--wait", "-n", "--goto", "/f:1:1"}));
    // To a shell these would be two commands and a substitution.
    EXPECT_EQ(editor_command("gvim;rm $(x) '-f", "/f", 1, 1).words, (Words{"gvim;rm", "$(x)", "'-f", "/f"}));
}

TEST(EditorCommand, KnowsWhichDrawIntoATerminal) {
    EXPECT_TRUE(editor_command("vim", "/f", 1, 1).terminal);
    EXPECT_FALSE(editor_command("gvim", "/f", 1, 1).terminal);
    EXPECT_FALSE(editor_command("emacs", "/f", 1, 1).terminal);
    EXPECT_TRUE(editor_command("emacs -nw", "/f", 1, 1).terminal);
}

TEST(EditorCommand, VisualGoesBeforeEditor) {
    setenv("VISUAL", "code --wait", 1);
    setenv("EDITOR", "vi", 1);
    EXPECT_EQ(editor_of_environment(), "code --wait");
    setenv("VISUAL", " ", 1);
    EXPECT_EQ(editor_of_environment(), "vi");
    unsetenv("EDITOR");
    EXPECT_EQ(editor_of_environment(), "xdg-open");
    unsetenv("VISUAL");
}

template <typename Condition>
bool soon(Condition condition) {
    for (int i = 0; i < 500; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

// A program of this name that writes its arguments into "told", one a line, and ends with `status`.
std::string script(const Scratch& folder, const std::string& name, int status = 0) {
    const std::string path = folder.write(name, "#!/bin/sh\nprintf '%s\\n' \"$@\" >'" + folder.path("told.new") +
                                                    "'\nmv '" + folder.path("told.new") + "' '" + folder.path("told") +
                                                    "'\nexit " + std::to_string(status) + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
}

TEST(Editor, StartsBesideTheWindowWithNamesThatAShellWouldTakeForCommands) {
    const Scratch folder;
    const std::string file = folder.write("$(touch made);`touch made` & *.frag", "void main() {}\n");
    Editor editor(script(folder, "code") + " --wait");
    const Started started = editor.open(file, 7, 1);
    EXPECT_EQ(started.error, "");
    EXPECT_EQ(started.program, folder.path("code"));
    ASSERT_TRUE(soon([&] { return std::filesystem::exists(folder.path("told")); }));
    EXPECT_EQ(bytes_of(folder.path("told")), "--wait\n--goto\n" + file + ":7:1\n");
    EXPECT_FALSE(std::filesystem::exists("made"));
}

TEST(Editor, SaysWhatWentWrong) {
    const Scratch folder;
    const std::string file = folder.write("a.frag", "");
    const Started nowhere = Editor("/none/there").open(file, 1, 1);
    EXPECT_NE(nowhere.error.find("cannot start /none/there"), std::string::npos) << nowhere.error;
    EXPECT_EQ(nowhere.program, "");
    const Started missing = Editor("true").open(folder.path("none.frag"), 1, 1);
    EXPECT_NE(missing.error.find("there is no file"), std::string::npos) << missing.error;
    Editor failing(script(folder, "failing", 3));
    failing.open(file, 1, 1);
    std::string said;
    EXPECT_TRUE(soon([&] { return !(said = failing.look()).empty(); }));
    EXPECT_NE(said.find("status 3"), std::string::npos) << said;
    EXPECT_EQ(failing.look(), "") << "once";
    EXPECT_EQ(failing.name(), folder.path("failing"));
    const std::string_view unnamed = Editor("xdg-open").name();
    EXPECT_EQ(unnamed, "the desktop's editor") << "it outlives the call";
}

TEST(Editor, ShowsNoControlCharacters) {
    const Scratch folder;
    const std::string said = Editor("true").open(folder.path("a\x1B[31m\n.frag"), 1, 1).error;
    EXPECT_EQ(said.find('\x1B'), std::string::npos);
    EXPECT_EQ(said.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace snell
