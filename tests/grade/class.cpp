// A class as it is handed in: everybody has a row, with the scene that was meant and the files that were handed out.
#include "tests/grade/submissions.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class GradeClass : public GradeTest {
protected:
    void SetUp() override {
        GradeTest::SetUp();
        if (IsSkipped()) return;
        scene("s/ann");
        folder.write("r.toml", head + items);
    }
    // Names and points of all rows. What was said is in `said`.
    std::string rows(const std::string& arguments = "s") {
        fs::remove_all(at("out"));
        said = grade("r.toml " + arguments + " -o out").output;
        std::string all;
        const json made = results();
        if (!made.is_object()) return said;
        for (const json& one : made["submissions"])
            all += one["name"].get<std::string>() + ":" + std::to_string(one["points"].get<int>()) + " ";
        return all;
    }
    std::string problem(const std::string& name) const { return result(name).value("problem", ""); }
    std::string said;
    static inline const std::string items =
        "[[item]]\nno_errors = true\n[[item]]\nset = { uKd = 0 }\nexpect = \"darker\"\n";
};

TEST_F(GradeClass, NamesThatArePrintedAlikeDiffer) {
    for (const char* name : {"two\nlines", "two\\x0Alines"}) fs::create_directories(at(std::string("s/") + name));
    rows();
    const json made = results();
    ASSERT_EQ(made["submissions"].size(), 3U) << said;
    EXPECT_NE(made["submissions"][1]["name"], made["submissions"][2]["name"]) << said;
}

TEST_F(GradeClass, EveryEntryHasARow) {
    scene("s", paint, ball, "bob.glib");  // loose, with its shaders
    fs::create_directories(at("s/empty"));
    for (const char* file : {"kim.pdf", "leo.docx", "lone.frag"}) folder.write(std::string("s/") + file, "x");
    folder.write("s/zero.zip", "");
    folder.write("s/zero.glib", "");
    scene("elsewhere");
    fs::create_directory_symlink("../elsewhere", at("s/linked"));
    fs::create_directory_symlink("ann", at("s/same"));
    fs::create_symlink("nowhere", at("s/broken"));
    for (const char* junk : {".DS_Store", "Thumbs.db", "__MACOSX/ball.glib", "~$leo.docx"})
        folder.write(std::string("s/") + junk, "x");
    const std::string all =
        "ann:2 bob:2 broken:0 empty:0 kim.pdf:0 leo.docx:0 linked:2 lone.frag:0 same:0 zero.glib:0 zero.zip:0 ";
    EXPECT_EQ(rows(), all) << said;
    EXPECT_NE(problem("empty").find("there is no scene"), std::string::npos);
    EXPECT_EQ(problem("kim.pdf"), "it is neither a folder, nor an archive, nor a scene (.glib)");
    EXPECT_EQ(problem("same"), "it is a link to 'ann', which is judged as 'ann'");
    EXPECT_EQ(problem("broken"), "it is a link to 'nowhere', which is not there");
    EXPECT_EQ(problem("zero.zip"), "it is an empty file");
    // The reasons are where a lecturer looks, and so is what has no row.
    for (const std::string reason : {"it is a link to &#39;nowhere&#39;", "it is an empty file"})
        EXPECT_NE(bytes_of(at("out/index.html")).find(reason), std::string::npos) << reason;
    for (const std::string none : {".DS_Store", "Thumbs.db", "__MACOSX", "~$leo.docx"})
        EXPECT_NE(said.find("'" + none + "' (hidden, or of the system)"), std::string::npos) << said;
    for (const std::string part : {"ball.frag", "ball.vert"})
        EXPECT_NE(said.find("'" + part + "' (named by 'bob.glib')"), std::string::npos) << said;
    // A second run keeps all of it, and so do arguments that name each.
    EXPECT_TRUE(grade("r.toml s -o out").says("11 submissions, 11 of them judged before"));
    EXPECT_EQ(rows("s/[a-km-z]* s/l[ei]*"), [&] {
        std::string named = all;  // ball.frag and ball.vert are arguments now, and lone.frag is none
        named.replace(named.find("bob:2"), 5, "ball.frag:0 ball.vert:0 bob:2");
        named.replace(named.find("lone.frag:0 "), 12, "");
        return named;
    }()) << said;
}

TEST_F(GradeClass, LooseScenesShareTheFilesNextToThem) {
    scene("flat", paint, ball, "ann.glib");
    scene("flat", paint, ball, "bob.glib");
    EXPECT_EQ(rows("flat"), "ann:2 bob:2 ") << said;
    // A shader that changes is no longer what was judged.
    folder.write("flat/ball.frag", "broken");
    ASSERT_EQ(grade("r.toml flat -o out").status, 0);
    EXPECT_EQ(result("ann")["points"], 0);
    EXPECT_EQ(result("bob")["points"], 0);
}

TEST_F(GradeClass, AFolderWithOneSceneIsOneSubmission) {
    EXPECT_EQ(rows("s/ann"), "ann:2 ");
    folder.write("s/ann/readme.txt", "x");
    folder.write("s/ann/wall.bmp", "x");
    folder.write("s/ann/parts/more.glib", "");
    folder.write("s/ann/ball.glib", ball + "Include parts/nothing.glib\n");
    folder.write("s/ann/parts/nothing.glib", "# nothing\n");
    EXPECT_EQ(said.find("warning"), std::string::npos) << said;
    // A folder with a scene is somebody's, and so is a document, whatever is next to them.
    EXPECT_EQ(rows("s/ann"), "ball:2 parts:0 readme.txt:0 wall.bmp:0 ") << said;
    fs::remove_all(at("s/ann/parts"));
    folder.write("s/ann/ball.glib", ball + "Include parts/nothing.inc\n");
    folder.write("s/ann/parts/nothing.inc", "# nothing\n");
    EXPECT_EQ(rows("s/ann"), "ann:2 ") << said;
    fs::create_directories(at("s/ann/eve"));
    EXPECT_EQ(rows("s/ann"), "ball:2 eve:0 readme.txt:0 wall.bmp:0 ") << said;
    EXPECT_NE(said.find("each is a submission [several-submissions]"), std::string::npos) << said;
    EXPECT_EQ(rows("s/ann/ball.glib"), "ball:2 ") << said;
}

TEST_F(GradeClass, HandedOutFilesAreFoundByTheirNames) {
    folder.write("objs/animals/Pig.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    folder.write("objs/lib.glsl", "float unit() { return 1.; }\n");
    std::string text = ball, fragment = paint;
    text.replace(text.find("Sphere 1"), 8, "Obj ../../objs/animals/Pig.obj");
    fragment.replace(fragment.find("in vec3 vN;"), 11, "#include \"lib.glsl\"\nin vec3 vN;");
    fragment.replace(fragment.find("vec3 n ="), 8, "vec3 n = unit() *");
    scene("reference", fragment, text);
    const auto written = [&](const std::string& name) {
        std::string other = text;
        return other.replace(other.find("../../objs/animals/Pig.obj"), 26, name);
    };
    for (const auto& [student, name] :
         {std::pair("path", "../../objs/animals/Pig.obj"), std::pair("name", "Pig.obj"), std::pair("case", "PIG.OBJ"),
          std::pair("none", "Pig"), std::pair("home", "/home/kim/animals/Pig.obj"), std::pair("wrong", "Pug.obj")}) {
        scene(std::string("s/") + student, fragment, written(name));
        ASSERT_EQ(run("cd '" + at("s") + "' && tar czf " + student + "-packed.tgz " + student).status, 0);
    }
    fs::remove_all(at("s/ann"));
    folder.write("r.toml",
                 "shared = [\"objs\"]\n" + head + items + "[[item]]\nexpect = \"reference\"\nmax_pixels = 0.1\n");
    EXPECT_EQ(rows(),
              "case:3 case-packed:3 home:3 home-packed:3 name:3 name-packed:3 none:3 none-packed:3 path:3 "
              "path-packed:3 wrong:0 wrong-packed:0 ")
        << said << bytes_of(at("out/results.json"));
    // Own files come first.
    folder.write("s/name/Pig.obj", "v 0 0 0\n");
    EXPECT_EQ(result("name")["points"], 3);
    rows();
    EXPECT_EQ(result("name")["points"], 0) << said;
}

TEST_F(GradeClass, TheSceneWithTheUniformsIsMeant) {
    const std::string plain = "##OpenGL GLIB\nSphere 1\n";
    // Next to it, above it, and by another name of the uniform.
    scene("s/bob", paint, ball, "mine.glib");
    folder.write("s/bob/test.glib", plain);
    scene("s/kim/work", paint, ball, "mine.glib");
    folder.write("s/kim/test.glib", plain);
    // Two that have all uniforms: the rubric says which.
    scene("s/eve", paint, ball, "new.glib");
    folder.write("s/eve/old.glib", ball);
    scene("s/q\"\\", paint, ball, "a'\"\n.glib");
    folder.write("s/q\"\\/old.glib", ball);
    scene("s/leo/1", paint, ball, "new.glib");
    folder.write("s/leo/1/old.glib", ball + "Torus .1 .2\n");
    ASSERT_EQ(run("cd '" + at("s") + "' && tar czf zoe.tgz -C leo/1 . && rm -r leo").status, 0);
    EXPECT_EQ(rows(), "ann:2 bob:2 eve:0 kim:2 q\"\\:0 zoe:0 ") << said;
    EXPECT_NE(said.find("of the scenes 'mine.glib', 'test.glib', 'mine.glib' is judged: it has the most of the "
                        "rubric's uniforms (uKd)"),
              std::string::npos)
        << said;
    EXPECT_EQ(result("kim")["scene"], "work/mine.glib");
    EXPECT_EQ(problem("eve"),
              "it is not clear which scene is meant: 'new.glib', 'old.glib'; the rubric settles it by a "
              "line below [scenes]: \"eve\" = \"new.glib\"");
    const std::string line = problem("q\"\\");
    folder.write("r.toml", head + items + "[scenes]\n" + line.substr(line.find("[scenes]: ") + 10) +
                               "\neve = \"old.glib\"\nzoe = \"new.glib\"\nann = \"nothere.glib\"\nevi = \"x.glib\"\n");
    EXPECT_EQ(rows(), "ann:0 bob:2 eve:2 kim:2 q\"\\:2 zoe:2 ") << said;
    EXPECT_EQ(result("eve")["scene"], "old.glib");
    EXPECT_EQ(result("zoe")["scene"], "new.glib");
    EXPECT_EQ(problem("ann").find("there is no scene 'nothere.glib', which the rubric's [scenes] names; there is "
                                  "'ball.glib'; the rubric settles it"),
              0u)
        << problem("ann");
    EXPECT_NE(said.find("[scenes] names 'evi', but there is no such submission\n   help: did you mean 'eve'?"),
              std::string::npos)
        << said;
}

TEST_F(GradeClass, AHiddenEndingIsNamedWithWhatSettlesIt) {
    scene("s/bob", paint, ball, "ball.glib.txt");
    EXPECT_EQ(rows(), "ann:2 bob:0 ") << said;
    EXPECT_EQ(problem("bob"),
              "there is no scene: no file is called *.glib; there is 'ball.glib.txt'; the rubric settles it by a line "
              "below [scenes]: \"bob\" = \"ball.glib.txt\"");
    folder.write("r.toml", head + items + "[scenes]\nbob = \"ball.glib.txt\"\n");
    EXPECT_EQ(rows(), "ann:2 bob:2 ") << said;
}

TEST_F(GradeClass, ScenesInArchivesAreCandidatesToo) {
    scene("s/bob/old", "broken");
    ASSERT_EQ(run("cd '" + at("s") +
                  "' && tar czf bob/final.tgz -C ann . && tar czf in.tgz -C ann . && "
                  "tar czf kim.tgz --transform 's,^,deep/,' in.tgz && rm in.tgz")
                  .status,
              0);
    EXPECT_EQ(rows(), "ann:2 bob:0 kim:2 ") << said;
    EXPECT_EQ(result("kim")["scene"], "deep/in.tgz/ball.glib");
    EXPECT_EQ(
        problem("bob"),
        "it is not clear which scene is meant: 'final.tgz/ball.glib', 'old/ball.glib'; the rubric settles it by a "
        "line below [scenes]: \"bob\" = \"final.tgz/ball.glib\"");
    folder.write("r.toml", head + items + "[scenes]\nbob = \"final.tgz/ball.glib\"\n");
    EXPECT_EQ(rows(), "ann:2 bob:2 kim:2 ") << said;
    folder.write("r.toml", head + items + "[scenes]\nbob = \"old/ball.glib\"\n");
    EXPECT_EQ(rows(), "ann:2 bob:0 kim:2 ") << said;
}

TEST_F(GradeClass, RunsTellHowFarTheyAreWithoutATerminal) {
    for (int i = 0; i < 19; ++i) scene("s/" + std::to_string(i), "broken");
    folder.write("r.toml", "[[item]]\nno_errors = true\n");
    const Outcome made = grade("r.toml s -o out >printed");
    for (const std::string line : {"snell: judged: 2 of 20 submissions\n", "snell: judged: 20 of 20 submissions\n"})
        EXPECT_TRUE(made.says(line)) << made.output;
    EXPECT_EQ(grade("r.toml s -o out --again -q >printed").output, "");
}

TEST_F(GradeClass, CtrlCKeepsWhatWasJudged) {
    std::string slow = paint;
    slow.replace(slow.find("float d ="), 9,
                 "float x = n.x;\n  for (int i = 0; i < 60000; ++i) for (int j = 0; j < 1000; ++j) x = fract(sin(x) * "
                 "43758.5);\n  float d = min(x, 0.) + ");
    scene("s/zoe", slow);
    folder.write("r.toml", with(head + items, "timeout = 10", "timeout = 100"));
    const auto interrupted = [&] {
        return run("cd '" + folder.path() +
                   "' && { rm -f out/students/zoe/result.json; " SNELL_BIN
                   "/snell grade r.toml s -o out --jobs 1 2>told & }; "
                   "i=0; until [ -e out/students/zoe/result.json ] || [ $i -gt 3000 ]; do sleep .01; i=$((i + 1)); "
                   "done; grep -q '\"key\": \"[0-9a-f]*\"' out/students/ann/result.json && kill -INT $!; wait $!; "
                   "echo status $?; cat told");
    };
    const Outcome stopped = interrupted();
    EXPECT_TRUE(stopped.says("status 130")) << stopped.output;
    EXPECT_TRUE(stopped.says(
        "snell: interrupted: 1 of 2 submissions are judged and kept in 'out'; the same command judges the rest\n"))
        << stopped.output;
    EXPECT_FALSE(fs::exists(at("out/index.html")));
    scene("s/zoe");
    EXPECT_TRUE(grade_by(SNELL_BIN "/snell").says("2 submissions, 1 of them judged before"));
    EXPECT_EQ(result("zoe")["points"], 2);
    // What is there is of the earlier run, and another rubric.
    scene("s/zoe", slow);
    folder.write("r.toml", with(bytes_of(at("r.toml")), "no_errors", "points = 3\nno_errors"));
    EXPECT_TRUE(
        interrupted().says("rest; 'index.html', 'results.csv' and the other pages and tables in it are of an "
                           "earlier run\n"));
}

TEST_F(GradeClass, LimitsOfSubmissionsCanBeChanged) {
    EXPECT_EQ(rows("s --limit vertices=1000"), "ann:1 ") << said;
    EXPECT_NE(page("ann").find("--limit vertices=N changes it"), std::string::npos) << page("ann");
    EXPECT_TRUE(grade("r.toml s -o out").says("0 of them judged before")) << "the limit counts";
    EXPECT_EQ(result("ann")["points"], 2);
    EXPECT_EQ(grade("r.toml s -o out --limit vertice=7").status, 2);
}

}  // namespace

}  // namespace snell::test
