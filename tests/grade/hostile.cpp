// Submissions that are broken, odd or hostile: each is reported, none ends the others, and nothing escapes.
#include <chrono>

#include "tests/grade/submissions.h"
#include "tests/sanitized.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class HostileSubmission : public GradeTest {
protected:
    void SetUp() override {
        GradeTest::SetUp();
        if (IsSkipped()) return;
        scene("s/ann");
        folder.write("r.toml", head + "[[item]]\nno_errors = true\n[[item]]\nset = { uKd = 0 }\nexpect = \"darker\"\n");
    }
    // Grades all, of which ann's is as ever.
    void grade_all(const std::string& arguments = "") {
        const Outcome made = grade("r.toml s -o out " + arguments);
        ASSERT_EQ(made.status, 0) << made.output;
        EXPECT_EQ(result("ann")["points"], 2) << made.output;
        said = made.output;
    }
    // An archive with entries of these names, in Python's words.
    void zip(const std::string& file, const std::string& statements) {
        const Outcome made =
            python("import zipfile\nz = zipfile.ZipFile('" + file +
                   "', 'w', zipfile.ZIP_DEFLATED, compresslevel=1)\n"
                   "def whole(folder=''):\n"
                   "  for f in ('ball.glib', 'ball.vert', 'ball.frag'): z.write('reference/' + f, folder + f)\n" +
                   statements + "\nz.close()\n");
        ASSERT_EQ(made.status, 0) << made.output;
    }
    // A reason is where a lecturer looks for it: on the terminal, in the table of all, and in what programs read.
    void told_everywhere(const std::string& reason) const {
        EXPECT_NE(said.find(reason), std::string::npos) << said;
        for (const std::string file : {"index.html", "results.csv", "results.json"})
            EXPECT_NE(bytes_of(at("out/" + file)).find(reason), std::string::npos) << file << ": " << reason;
    }
    std::string said;
};

TEST_F(HostileSubmission, ArchivesAndFoldersOfAnyDepth) {
    zip("s/zipped.zip", "whole('a/b/c/')\nz.writestr('__MACOSX/a/._ball.glib', 'x')");
    fs::create_directories(at("s/Bob_123_file"));
    zip("s/Bob_123_file/work.zip", "whole()");
    scene("s/deep/1/2/3/4/5");
    ASSERT_EQ(
        run("cd '" + at("") + "' && for f in tarred.tgz Kim.Lee.tar.gz; do tar czf s/$f -C reference .; done").status,
        0);
    grade_all();
    for (const std::string name : {"zipped", "Bob_123_file", "deep", "tarred", "Kim.Lee"})
        EXPECT_EQ(result(name)["points"], 2) << name << result(name).dump(1);
    EXPECT_FALSE(fs::exists(at("out/.unpacked")));
}

TEST_F(HostileSubmission, NothingLeavesTheArchivesFolder) {
    folder.write("secret.txt", "s");
    zip("s/bad.zip",
        "whole()\nfor n in ('../../evil', '/tmp/snell-evil-absolute', 'a/../../../evil', 'C:/evil', '..\\\\evil'): "
        "z.writestr(n, 'x')\n"
        "i = zipfile.ZipInfo('link'); i.create_system = 3; i.external_attr = 0o120777 << 16\nz.writestr(i, "
        "'/etc/passwd')");
    ASSERT_EQ(
        python(
            "import tarfile\nt = tarfile.open('s/links.tar', 'w')\nfor f in ('ball.glib', 'ball.vert', 'ball.frag'):\n"
            "  t.add('reference/' + f, f)\ni = tarfile.TarInfo('out'); i.type = tarfile.SYMTYPE; i.linkname = '/tmp'\n"
            "t.addfile(i)\ni = tarfile.TarInfo('out/snell-evil-link'); t.addfile(i)\n"
            "i = tarfile.TarInfo('hard'); i.type = tarfile.LNKTYPE; i.linkname = '../../../secret.txt'; "
            "t.addfile(i)\nt.close()\n")
            .status,
        0);
    const std::size_t before = folder.entries();
    grade_all();
    EXPECT_EQ(result("bad")["points"], 2);
    EXPECT_EQ(result("links")["points"], 2);
    EXPECT_NE(page("bad").find("leads out of the archive"), std::string::npos);
    EXPECT_NE(page("links").find("is a link or a device"), std::string::npos);
    EXPECT_EQ(result("links")["notes"].size(), 2u) << result("links").dump(1);
    told_everywhere("is a link or a device");
    for (const std::string name : {"evil", "../evil", "s/evil", "out/evil", "out/students/evil", "out/.unpacked"})
        EXPECT_FALSE(fs::exists(at(name))) << name;
    EXPECT_FALSE(fs::exists("/tmp/snell-evil-absolute"));
    EXPECT_FALSE(fs::exists("/tmp/snell-evil-link"));
    fs::remove_all(at("out"));
    EXPECT_EQ(folder.entries(), before);
}

TEST_F(HostileSubmission, AnArchiveOfZerosIsNotUnpackedToItsEnd) {
    zip("s/bomb.zip",
        "with z.open('zeros', 'w', force_zip64=True) as f:\n  for i in range(300): f.write(bytes(1 << 20))");
    folder.write("s/torn.zip", bytes_of(at("s/bomb.zip")).substr(0, 500));
    folder.write("s/none.zip", "no archive at all");
    grade_all();
    EXPECT_NE(page("bomb").find("it holds more than 256 MB"), std::string::npos) << page("bomb");
    told_everywhere("bomb.zip was not unpacked to its end: it holds more than 256 MB; there is no scene");
    told_everywhere("torn.zip was not unpacked to its end");
    told_everywhere("none.zip was not unpacked to its end");
    for (const std::string name : {"bomb", "torn", "none"}) {
        EXPECT_EQ(result(name)["points"], 0) << name;
        EXPECT_NE(result(name)["problem"].get<std::string>().find("not unpacked"), std::string::npos) << name;
    }
    EXPECT_FALSE(fs::exists(at("out/.unpacked")));
}

TEST_F(HostileSubmission, AnArchiveStartsNoProgram) {
    // libarchive would run `lrzip` to read it.
    const std::string lrzip("LRZI\0\6\0\0\0\0", 10);
    folder.write("s/other.tar.gz", lrzip + std::string(4096, '\0'));
    folder.write("bin/lrzip", "#!/bin/sh\ntouch '" + at("ran") + "'\n");
    fs::permissions(at("bin/lrzip"), fs::perms::owner_all);
    const Outcome made =
        run("cd '" + at("") + "' && PATH=\"$PWD/bin:$PATH\" " SNELL_BIN "/snell grade r.toml s -o out");
    ASSERT_EQ(made.status, 0) << made.output;
    EXPECT_TRUE(made.says("other.tar.gz was not unpacked to its end")) << made.output;
    EXPECT_FALSE(fs::exists(at("ran")));
}

TEST_F(HostileSubmission, WhyAnEntryIsLeftOut) {
    fs::create_directories(at("s/many"));
    for (int i = 0; i < 5; ++i)
        zip("s/many/" + std::to_string(i) + ".zip", i == 4 ? "whole()" : "z.writestr('a', 'x')");
    zip("s/odd.zip", "whole()\nz.writestr('a/' * 40 + 'deep', 'x')\nz.writestr('n' * 300, 'x')");
    grade_all();
    EXPECT_EQ(result("odd")["points"], 2);
    told_everywhere("it is more than 32 folders deep");
    told_everywhere("it has a name of more than 240 bytes");
    told_everywhere("only 4 of 5 archives are unpacked");
}

TEST_F(HostileSubmission, LinksOfFoldersAreNotFollowed) {
    scene("s/eve");
    scene("s/kim", "#include \"own.frag\"\n");
    folder.write("other/ball.frag", paint);
    fs::remove(at("s/eve/ball.frag"));
    fs::create_symlink(at("other/ball.frag"), at("s/eve/ball.frag"));
    fs::create_symlink("/etc/passwd", at("s/kim/own.frag"));
    fs::create_directories(at("s/leo"));
    fs::create_directory_symlink(at("reference"), at("s/leo/all"));
    fs::create_directory_symlink("..", at("s/leo/round"));
    grade_all();
    for (const std::string name : {"eve", "kim", "leo"}) {
        EXPECT_EQ(result(name)["points"], 0) << name;
        EXPECT_EQ(page(name).find("root:"), std::string::npos);
    }
    EXPECT_FALSE(result("leo")["problem"].get<std::string>().empty());
}

TEST_F(HostileSubmission, SharedFoldersMayBeRead) {
    folder.write("shared/ball.frag", paint);
    std::string text = ball;
    text.replace(text.find("ball.frag"), 9, "../../shared/ball.frag");
    scene("s/eve", paint, text);
    fs::remove(at("s/eve/ball.frag"));
    grade_all();
    EXPECT_EQ(result("eve")["points"], 0);
    folder.write("r.toml", "shared = \"shared\"\n" + bytes_of(at("r.toml")));
    grade_all();
    EXPECT_EQ(result("eve")["points"], 2) << page("eve");
}

TEST_F(HostileSubmission, AShaderThatTakesForeverIsStopped) {
    std::string loops;
    for (int i = 0; i < 8; ++i) loops += "  for (int i = 0; i < 60000; ++i) x = fract(sin(x + uKd) * 43758.5);\n";
    scene("s/slow", "uniform float uKd, uRed, uSide;\nvoid main() {\n  float x = gl_FragCoord.x;\n" + loops +
                        "  gl_FragColor = vec4(x);\n}\n");
    std::string rubric = bytes_of(at("r.toml"));
    rubric.replace(rubric.find("timeout = 10"), 12, "timeout = 2");
    rubric.replace(rubric.find("64x48"), 5, "512x512");
    folder.write("r.toml", rubric);
    const Outcome made = grade("r.toml s -o out");
    ASSERT_EQ(made.status, 0) << made.output;
    EXPECT_NE(result("slow")["problem"].get<std::string>().find("takes longer than 2 seconds"), std::string::npos);
    EXPECT_NE(result("slow")["problem"].get<std::string>().find(": its picture takes"), std::string::npos);
    EXPECT_EQ(result("slow")["points"], 0) << "its shaders count as unread";
    EXPECT_NE(page("slow").find("its shaders count as unread"), std::string::npos);
    EXPECT_NE(page("slow").find("takes longer than 2 seconds"), std::string::npos);
}

// By what its text says: without a GPU, Mesa ends the loop, and shows what it had by then.
TEST_F(HostileSubmission, AShaderThatNeverEndsEarnsNothing) {
    scene("s/eve",
          "uniform float uKd, uRed, uSide;\nvoid main() {\n  float x = uKd;\n"
          "  for (int i = 0; i < 9; --i) x += .1 * uRed;\n  gl_FragColor = vec4(x);\n}\n");
    folder.write("r.toml", bytes_of(at("r.toml")) +
                               "[[item]]\nno_lints = [\"never-read\"]\n[[item]]\nuniforms = { uKd = \"float\" }\n"
                               "[[item]]\nexpect = \"reference\"\nmax_rmse = 0.9\n[[item]]\nforbids = [\"Torus\"]\n");
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    EXPECT_EQ(result("ann")["points"], 6) << result("ann").dump(1);
    EXPECT_EQ(result("eve")["points"], 0) << result("eve").dump(1);
    EXPECT_NE(page("eve").find("for ever"), std::string::npos) << page("eve");
}

TEST_F(HostileSubmission, LinksToLargeTreesAreNamedAndNotRead) {
    for (int i = 0; i < 21; ++i)
        for (int k = 0; k < 1000; ++k)
            fs::create_directories(at("tree/" + std::to_string(i) + "/" + std::to_string(k)));
    fs::create_directory_symlink(at("tree"), at("s/eve"));
    const auto begun = std::chrono::steady_clock::now();
    grade_all();
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), 10 * patience);
    told_everywhere("it holds more than 20000 files and folders");
    EXPECT_EQ(result("eve")["points"], 0);
}

// Each shape and each texture is within its limits, but not all of them together.
TEST_F(HostileSubmission, OneThatAllocatesWithoutEndIsReported) {
    constexpr int targets = 12;
    std::string shapes = ball, passes = "##OpenGL GLIB\nVertex ball.vert\nFragment ball.frag\nProgram Plain uRed 1.\n";
    std::string units, samplers, sum;
    for (int i = 1; i <= targets; ++i) {
        const std::string n = std::to_string(i);
        shapes += "Sphere 1 " + std::to_string(1500 + i) + " 1500\n";
        passes += "Texture2D " + n + " 8192 8192\nRenderToTexture " + n + "\nSphere 1\n";
        units += " uT" + n + " " + n;
        samplers += "uniform sampler2D uT" + n + ";\n";
        sum += " + texture2D(uT" + n + ", vec2(uKd))";
    }
    scene("s/shapes", paint, shapes);
    scene("s/targets", paint,
          passes + "RenderToTexture\nVertex ball.vert\nFragment sum.frag\nProgram Sum uKd <0. .7 1.>" + units +
              "\nSphere 1\n");
    folder.write("s/targets/sum.frag",
                 samplers + "uniform float uKd;\nvoid main() { gl_FragColor = vec4(0.)" + sum + "; }\n");
    std::string rubric = bytes_of(at("r.toml"));
    folder.write("r.toml", rubric.replace(rubric.find("timeout = 10"), 12, "timeout = 60"));
    grade_all("--memory 1");
    for (const std::string name : {"shapes", "targets"})
        EXPECT_EQ(result(name)["problem"], "it takes more than 1 GB of memory") << name;
    told_everywhere("it takes more than 1 GB of memory");
}

TEST_F(HostileSubmission, ASceneOfTenThousandPasses) {
    std::string passes = "##OpenGL GLIB\n";
    for (int i = 0; i < 10'000; ++i) passes += "RenderToTexture " + std::to_string(i) + " 64 64\nSphere 1\n";
    scene("s/many", paint, passes);
    scene("s/large", paint, "Sphere 1 100000 100000\nObj nothere.obj\nTexture2D 1 ball.frag\n");
    folder.write("s/binary/x.glib", std::string(100'000, '\0') + "\xff\xfe");
    grade_all();
    for (const std::string name : {"many", "large"}) EXPECT_EQ(result(name)["points"], 0) << result(name).dump(1);
}

TEST_F(HostileSubmission, NothingInNamesAndMessagesIsHtml) {
    const std::string name = "<img src=x onerror=alert(1)>&\"'";
    scene("s/" + name, "void main() { <script>alert(2)</script> = oops; }",
          "##OpenGL GLIB\nMessageBox \"<b>\"\nSphre <i>\n" + ball, "<u>.glib");
    scene("s/=1+2");
    scene("s/two\nlines\x1b[31m");
    grade_all();
    for (const auto& entry : fs::recursive_directory_iterator(at("out"))) {
        if (entry.path().extension() != ".html" && entry.path().extension() != ".xml") continue;
        const std::string text = bytes_of(entry.path());
        for (const std::string markup : {"<img src=x", "<script>alert", "<b>\"", "<i>", "<u>", "\x1b"})
            EXPECT_EQ(text.find(markup), std::string::npos) << entry.path() << ": " << markup;
        EXPECT_NE(entry.path().filename(), "<u>");
    }
    EXPECT_NE(page(name).find("&lt;script&gt;alert"), std::string::npos);
    EXPECT_NE(bytes_of(at("out/results.csv")).find("\n'=1+2,"), std::string::npos) << "no formula";
    EXPECT_EQ(said.find('\x1b'), std::string::npos);
    const Outcome parsed = python(
        "import xml.dom.minidom, csv\nxml.dom.minidom.parse('out/junit.xml')\n"
        "assert len(set(len(r) for r in csv.reader(open('out/results.csv')))) == 1\n");
    EXPECT_EQ(parsed.status, 0) << parsed.output;
}

TEST_F(HostileSubmission, NamesInAnyEncodingAndTwoOfOneName) {
    scene("s/Jos\xe9");      // Latin-1
    scene("s/Jos\xc3\xa9");  // UTF-8
    scene("s/Jos\xc3\xa8");
    zip("s/latin.zip", "whole('r\\u00e9sum\\u00e9/')");
    scene("t/ann");
    const Outcome made = grade("r.toml s/* t/ann -o out");
    ASSERT_EQ(made.status, 0) << made.output;
    const json all = results()["submissions"];
    std::set<std::string> folders, names;
    for (const json& one : all) {
        EXPECT_EQ(one["points"], 2) << one.dump(1);
        folders.insert(one["folder"].get<std::string>());
        names.insert(one["name"].get<std::string>());
    }
    EXPECT_EQ(all.size(), 6u);
    EXPECT_EQ(folders.size(), 6u);
    EXPECT_TRUE(names.contains("Jos\u00e9"));
    const std::string table = bytes_of(at("out/results.csv"));
    for (const std::string& one : folders) EXPECT_NE(table.find("," + one + "\n"), table.npos) << table;
}

TEST_F(HostileSubmission, WhichSceneIsMeant) {
    fs::create_directories(at("s/empty"));
    scene("s/two", paint, ball, "one.glib");
    scene("s/two", paint, ball, "other.glib");
    scene("s/named", paint, ball, "old.glib");
    scene("s/named");  // the reference's name
    scene("s/near", paint, ball, "near.glib");
    scene("s/near/backup", "broken", ball, "far.glib");
    folder.write("s/macos/__MACOSX/ball.glib", ball);
    folder.write("s/macos/._ball.glib", "x");
    grade_all();
    EXPECT_NE(result("empty")["problem"].get<std::string>().find("there is no scene"), std::string::npos);
    EXPECT_NE(result("two")["problem"].get<std::string>().find("'one.glib', 'other.glib'"), std::string::npos);
    EXPECT_EQ(result("named")["scene"], "ball.glib");
    EXPECT_EQ(result("near")["scene"], "near.glib");
    EXPECT_EQ(result("macos")["points"], 0);
    folder.write("r.toml", "scene = \"o*.glib\"\n" + bytes_of(at("r.toml")));
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    EXPECT_EQ(result("named")["scene"], "old.glib");
    EXPECT_EQ(result("ann")["points"], 0);
}

TEST_F(HostileSubmission, NaNAndEmptyScenesGetNoPoints) {
    folder.write("r.toml",
                 head +
                     "[[item]]\nno_errors = true\n[[item]]\nno_lints = [\"never-read\"]\n[[item]]\n"
                     "forbids = [\"Torus\"]\n[[item]]\nset = { uKd = 0 }\nexpect = \"darker\"\n"
                     "[[item]]\nset = { uRed = 0 }\nthan = { uRed = 0, uKd = 0.1 }\nexpect = \"different\"\n");
    scene("s/eve", paint, "##OpenGL GLIB\n");
    scene("s/kim");
    fs::remove(at("s/kim/ball.frag"));
    std::string undefined = paint;
    undefined.replace(undefined.find("(uRed,"), 6, "(uRed / uRed * uRed,");
    scene("s/zoe", undefined);
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    EXPECT_EQ(result("ann")["points"], 5) << result("ann").dump(1);
    EXPECT_EQ(result("eve")["points"], 0) << result("eve").dump(1);
    EXPECT_EQ(result("kim")["items"][1]["points"], 0) << result("kim").dump(1);
    EXPECT_EQ(result("zoe")["points"], 4) << result("zoe").dump(1);
    EXPECT_NE(page("zoe").find("NaN, whose colour is undefined"), std::string::npos) << page("zoe");
}

TEST_F(HostileSubmission, TwelveAreGradedInTime) {
    for (int i = 0; i < 12; ++i)
        scene("s/student " + std::to_string(i),
              i % 6 == 4 ? "void main() { oops }" : paint + "// " + std::to_string(i) + "\n");
    folder.write("r.toml", bytes_of(at("r.toml")) + "[[item]]\nexpect = \"reference\"\n[[item]]\nslower = 9\n");
    const auto timed = [&](double most) {
        const double before = processor_seconds();
        const auto begun = std::chrono::steady_clock::now();
        const Outcome made = grade("r.toml s -o out -q");
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begun;
        EXPECT_EQ(made.status, 0) << made.output;
        EXPECT_LT(processor_seconds() - before, most * patience);
        EXPECT_LT(wall.count(), 10 * most * patience) << "it waits for something, even on a busy machine";
    };
    timed(5);
    EXPECT_EQ(results()["submissions"].size(), 13u);
    timed(1);
}

}  // namespace

}  // namespace snell::test
