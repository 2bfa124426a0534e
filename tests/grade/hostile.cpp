// Submissions that are broken, odd or hostile: each is reported, none ends the others, and nothing escapes.
#include <array>
#include <chrono>
#include <set>

#include "tests/grade/submissions.h"
#include "tests/sanitized.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// What is said of a submission. "": nothing is wrong with it, and it has all points.
struct Verdict {
    std::string name, reason;
    double points = 0;
    bool everywhere = false;  // where a lecturer looks: on the terminal, in the table of all, in what programs read
};

class HostileSubmission : public GradeTest {
protected:
    void SetUp() override {
        GradeTest::SetUp();
        if (IsSkipped()) return;
        scene("s/ann");
        folder.write("r.toml",
                     with(head, "timeout = 10", "timeout = " + std::to_string(static_cast<int>(10 * patience))) +
                         "[[item]]\nno_errors = true\n[[item]]\nset = { uKd = 0 }\nexpect = \"darker\"\n"
                         "[[item]]\nno_lints = [\"never-read\"]\n[[item]]\nuniforms = { uKd = \"float\" }\n"
                         "[[item]]\nexpect = \"reference\"\nmax_rmse = 0.9\n[[item]]\nforbids = [\"Torus\"]\n"
                         "[[item]]\nset = { uRed = 0 }\nthan = { uRed = 0, uKd = 0.1 }\n"
                         "expect = \"different\"\n");
    }
    // An archive with entries of these names, in Python's words. Python starts once for all.
    void zip(const std::string& file, const std::string& statements) {
        archives += "z = zipfile.ZipFile('" + file + "', 'w', zipfile.ZIP_DEFLATED, compresslevel=1)\n" + statements +
                    "\nz.close()\n";
    }
    void make_archives() const {
        const Outcome made = python(
            "import tarfile, zipfile\ndef whole(folder=''):\n"
            "  for f in ('ball.glib', 'ball.vert', 'ball.frag'): z.write('reference/' + f, folder + f)\n" +
            archives);
        ASSERT_EQ(made.status, 0) << made.output;
        fs::remove(at("make.py"));
    }
    // As it is in the report: those that are only printed alike have their ids behind it.
    std::string named(const std::string& name) const {
        const json all = results();
        for (const json& one : all["submissions"])
            if (one["name"].get<std::string>().starts_with(name + " (")) return one["name"];
        return name;
    }
    void expect_judged(const std::vector<Verdict>& verdicts) const {
        const std::array<std::string, 3> pages{bytes_of(at("out/index.html")), bytes_of(at("out/results.csv")),
                                               bytes_of(at("out/results.json"))};
        for (const Verdict& verdict : verdicts) {
            const std::string name = named(verdict.name);
            const json one = result(name);
            EXPECT_TRUE(one.is_object()) << verdict.name << " is not judged";
            if (!one.is_object()) continue;
            EXPECT_EQ(one["points"], verdict.points) << verdict.name << one.dump(1);
            EXPECT_NE(page(name).find(verdict.reason), std::string::npos) << verdict.name << one.dump(1);
            if (!verdict.everywhere) continue;
            EXPECT_NE(said.find(verdict.reason), std::string::npos) << said;
            for (const std::string& text : pages) EXPECT_NE(text.find(verdict.reason), std::string::npos) << text;
        }
    }

    // Each makes submissions, and says what is to be said of them.
    std::vector<Verdict> archives_and_folders();
    std::vector<Verdict> archives_that_lead_out();
    std::vector<Verdict> archives_without_end();
    std::vector<Verdict> links();
    std::vector<Verdict> scenes_to_choose_from();
    std::vector<Verdict> scenes_that_are_none();
    std::vector<Verdict> names();
    void expect_no_markup() const;
    void expect_folders_of_their_own() const;

    const std::string markup = "<img src=x onerror=alert(1)>&\"'";
    static constexpr double all = 7;
    std::string said, archives;
};

std::vector<Verdict> HostileSubmission::archives_and_folders() {
    zip("s/zipped.zip", "whole('a/b/c/')\nz.writestr('__MACOSX/a/._ball.glib', 'x')");
    fs::create_directories(at("s/Bob_123_file"));
    zip("s/Bob_123_file/work.zip", "whole()");
    scene("s/deep/1/2/3/4/5");
    EXPECT_EQ(
        run("cd '" + at("") + "' && for f in tarred.tgz Kim.Lee.tar.gz; do tar czf s/$f -C reference .; done").status,
        0);
    return {
        {"zipped", "", all}, {"Bob_123_file", "", all}, {"deep", "", all}, {"tarred", "", all}, {"Kim.Lee", "", all}};
}

std::vector<Verdict> HostileSubmission::archives_that_lead_out() {
    folder.write("secret.txt", "s");
    zip("s/bad.zip",
        "whole()\nfor n in ('../../evil', '/tmp/snell-evil-absolute', 'a/../../../evil', 'C:/evil', '..\\\\evil'): "
        "z.writestr(n, 'x')\n"
        "i = zipfile.ZipInfo('link'); i.create_system = 3; i.external_attr = 0o120777 << 16\nz.writestr(i, "
        "'/etc/passwd')");
    archives +=
        "t = tarfile.open('s/links.tar', 'w')\nfor f in ('ball.glib', 'ball.vert', 'ball.frag'):\n"
        "  t.add('reference/' + f, f)\ni = tarfile.TarInfo('out'); i.type = tarfile.SYMTYPE; i.linkname = '/tmp'\n"
        "t.addfile(i)\ni = tarfile.TarInfo('out/snell-evil-link'); t.addfile(i)\n"
        "i = tarfile.TarInfo('hard'); i.type = tarfile.LNKTYPE; i.linkname = '../../../secret.txt'; "
        "t.addfile(i)\nt.close()\n";
    // libarchive would run `lrzip` to read it.
    folder.write("s/other.tar.gz", std::string("LRZI\0\6\0\0\0\0", 10) + std::string(4096, '\0'));
    folder.write("bin/lrzip", "#!/bin/sh\ntouch '" + at("ran") + "'\n");
    fs::permissions(at("bin/lrzip"), fs::perms::owner_all);
    return {{"bad", "leads out of the archive", all},
            {"links", "is a link or a device", all, true},
            {"other", "other.tar.gz was not unpacked to its end", 0, true}};
}

std::vector<Verdict> HostileSubmission::archives_without_end() {
    zip("s/bomb.zip",
        "with z.open('zeros', 'w', force_zip64=True) as f:\n  for i in range(300): f.write(bytes(1 << 20))");
    archives += "open('s/torn.zip', 'wb').write(open('s/bomb.zip', 'rb').read(500))\n";
    zip("s/flipped.zip", "z.writestr(zipfile.ZipInfo('a'), 'QQQQ'); whole()");  // its sum is not that of its bytes
    archives +=
        "b = open('s/flipped.zip', 'rb').read()\nopen('s/flipped.zip', 'wb').write(b.replace(b'QQQQ', b'QQRQ'))\n";
    folder.write("s/none.zip", "no archive at all");
    fs::create_directories(at("s/many"));
    for (int i = 0; i < 5; ++i)
        zip("s/many/" + std::to_string(i) + ".zip", i == 4 ? "whole()" : "z.writestr('a', 'x')");
    zip("s/odd.zip", "whole()\nz.writestr('a/' * 40 + 'deep', 'x')\nz.writestr('n' * 300, 'x')");
    return {{"bomb", "bomb.zip was not unpacked to its end: it holds more than 256 MB; there is no scene", 0, true},
            {"torn", "torn.zip was not unpacked to its end", 0, true},
            {"flipped", "flipped.zip was not unpacked to its end", 0, true},
            {"none", "none.zip was not unpacked to its end", 0, true},
            {"many", "only 4 of 5 archives are unpacked", 0, true},
            {"odd", "it is more than 32 folders deep", all, true},
            {"odd", "it has a name of more than 240 bytes", all, true}};
}

std::vector<Verdict> HostileSubmission::links() {
    folder.write("other/ball.frag", paint);
    scene("s/eve");
    fs::remove(at("s/eve/ball.frag"));
    fs::create_symlink(at("other/ball.frag"), at("s/eve/ball.frag"));
    scene("s/kim", "#include \"own.frag\"\n");
    fs::create_symlink("/etc/passwd", at("s/kim/own.frag"));
    fs::create_directories(at("s/leo"));
    fs::create_directory_symlink(at("reference"), at("s/leo/all"));
    fs::create_directory_symlink("..", at("s/leo/round"));
    scene("s/lee", paint, with(ball, "ball.frag", "../../other/ball.frag"));
    fs::remove(at("s/lee/ball.frag"));
    write_too_many("tree");
    fs::create_directory_symlink(at("tree"), at("s/large"));
    return {{"eve", ""},
            {"kim", ""},
            {"leo", "there is no scene"},
            {"lee", ""},
            {"large", "it holds more than 20000 files and folders", 0, true}};
}

std::vector<Verdict> HostileSubmission::scenes_to_choose_from() {
    fs::create_directories(at("s/empty"));
    scene("s/two", paint, ball, "one.glib");
    scene("s/two", paint, ball, "other.glib");
    scene("s/named", paint, ball, "old.glib");
    scene("s/named");  // the reference's name
    scene("s/near", paint, ball, "near.glib");
    scene("s/near/backup", "broken", ball, "far.glib");
    folder.write("s/macos/__MACOSX/ball.glib", ball);
    folder.write("s/macos/._ball.glib", "x");
    return {{"empty", "there is no scene"}, {"two", "one.glib"},        {"two", "other.glib"},
            {"named", "ball.glib", all},    {"near", "near.glib", all}, {"macos", "there is no scene"}};
}

std::vector<Verdict> HostileSubmission::scenes_that_are_none() {
    std::string passes = "##OpenGL GLIB\n";
    for (int i = 0; i < 10'000; ++i) passes += "RenderToTexture " + std::to_string(i) + " 64 64\nSphere 1\n";
    scene("s/passes", paint, passes);
    scene("s/huge", paint, "Sphere 1 100000 100000\nObj nothere.obj\nTexture2D 1 ball.frag\n");
    folder.write("s/binary/x.glib", std::string(100'000, '\0') + "\xff\xfe");
    scene("s/bare", paint, "##OpenGL GLIB\n");
    scene("s/no-shader");
    fs::remove(at("s/no-shader/ball.frag"));
    scene("s/undefined", with(paint, "(uRed,", "(uRed / uRed * uRed,"));
    // By what its text says: without a GPU, Mesa ends the loop, and shows what it had by then.
    scene("s/endless",
          "uniform float uKd, uRed, uSide;\nvoid main() {\n  float x = uKd;\n"
          "  for (int i = 0; i < 9; --i) x += .1 * uRed;\n  gl_FragColor = vec4(x);\n}\n");
    return {{"passes", ""},
            {"huge", "vertices are too many", 2},
            {"binary", ""},
            {"bare", ""},
            {"no-shader", "there is no file"},
            {"undefined", "NaN, whose colour is undefined", all - 1},
            {"endless", "for ever"}};
}

std::vector<Verdict> HostileSubmission::names() {
    scene("s/" + markup, "void main() { <script>alert(2)</script> = oops; }",
          "##OpenGL GLIB\nMessageBox \"<b>\"\nSphre <i>\n" + ball, "<u>.glib");
    scene("s/=1+2");
    scene("s/two\nlines\x1b[31m");
    scene("s/Jos\xe9");      // Latin-1
    scene("s/Jos\xc3\xa9");  // UTF-8
    scene("s/Jos\xc3\xa8");
    zip("s/latin.zip", "whole('r\\u00e9sum\\u00e9/')");
    scene("t/ann");
    return {{markup, "&lt;script&gt;alert"}, {"=1+2", "", all},  {"Jos\u00e9", "", all},
            {"Jos\u00e8", "", all},          {"latin", "", all}, {"ann", "", all}};
}

void HostileSubmission::expect_no_markup() const {
    for (const auto& entry : fs::recursive_directory_iterator(at("out"))) {
        if (entry.path().extension() != ".html" && entry.path().extension() != ".xml") continue;
        const std::string text = bytes_of(entry.path());
        for (const std::string some : {"<img src=x", "<script>alert", "<b>\"", "<i>", "<u>", "\x1b", "root:"})
            EXPECT_EQ(text.find(some), std::string::npos) << entry.path() << ": " << some;
        EXPECT_NE(entry.path().filename(), "<u>");
    }
    EXPECT_NE(bytes_of(at("out/results.csv")).find("\n'=1+2,"), std::string::npos) << "no formula";
    EXPECT_EQ(said.find('\x1b'), std::string::npos);
    const Outcome parsed = python(
        "import xml.dom.minidom, csv\nxml.dom.minidom.parse('out/junit.xml')\n"
        "assert len(set(len(r) for r in csv.reader(open('out/results.csv')))) == 1\n");
    EXPECT_EQ(parsed.status, 0) << parsed.output;
}

void HostileSubmission::expect_folders_of_their_own() const {
    const json submissions = results()["submissions"];
    std::set<std::string> folders;
    for (const json& one : submissions) folders.insert(one["folder"].get<std::string>());
    EXPECT_EQ(folders.size(), submissions.size());
    const std::string table = bytes_of(at("out/results.csv"));
    for (const std::string& one : folders) EXPECT_NE(table.find("," + one + "\n"), table.npos) << table;
}

TEST_F(HostileSubmission, EachOfAClassIsReportedAndNoneEndsTheOthers) {
    std::vector<Verdict> verdicts{{"ann", "", all}};
    for (const std::vector<Verdict>& some : {archives_and_folders(), archives_that_lead_out(), archives_without_end(),
                                             links(), scenes_to_choose_from(), scenes_that_are_none(), names()})
        verdicts.insert(verdicts.end(), some.begin(), some.end());
    make_archives();
    const std::size_t before = folder.entries();
    const auto begun = std::chrono::steady_clock::now();
    const Outcome made =
        run("cd '" + at("") + "' && PATH=\"$PWD/bin:$PATH\" " SNELL_BIN "/snell grade r.toml s/* t/ann -o out");
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), 60 * patience);
    said = made.output;
    ASSERT_EQ(made.status, 0) << said;
    expect_judged(verdicts);
    EXPECT_EQ(result("links")["notes"].size(), 2u) << result("links").dump(1);
    EXPECT_EQ(result("named")["scene"], "ball.glib");
    EXPECT_EQ(result("near")["scene"], "near.glib");
    for (const std::string name : {"leo", "bomb", "torn", "none", "two", "empty"})
        EXPECT_NE(result(name)["problem"], "") << name;
    expect_no_markup();
    expect_folders_of_their_own();
    for (const std::string name :
         {"ran", "evil", "../evil", "s/evil", "out/evil", "out/students/evil", "out/.unpacked"})
        EXPECT_FALSE(fs::exists(at(name))) << name;
    EXPECT_FALSE(fs::exists("/tmp/snell-evil-absolute"));
    EXPECT_FALSE(fs::exists("/tmp/snell-evil-link"));
    fs::remove_all(at("out"));
    fs::remove(at("make.py"));
    EXPECT_EQ(folder.entries(), before);
}

TEST_F(HostileSubmission, TheRubricSharesFoldersAndNamesScenes) {
    folder.write("shared/ball.frag", paint);
    scene("s/eve", paint, with(ball, "ball.frag", "../../shared/ball.frag"));
    fs::remove(at("s/eve/ball.frag"));
    scene("s/kim", paint, ball, "old.glib");
    scene("s/kim");
    folder.write("r.toml", "shared = \"shared\"\n" + bytes_of(at("r.toml")));
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    EXPECT_EQ(result("eve")["points"], all) << page("eve");
    EXPECT_EQ(result("kim")["scene"], "ball.glib");
    folder.write("r.toml", "scene = \"o*.glib\"\n" + bytes_of(at("r.toml")));
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    EXPECT_EQ(result("kim")["scene"], "old.glib");
    EXPECT_EQ(result("ann")["points"], 0);
}

TEST_F(HostileSubmission, AShaderThatTakesForeverIsStopped) {
    std::string loops;
    for (int i = 0; i < 8; ++i) loops += "  for (int i = 0; i < 60000; ++i) x = fract(sin(x + uKd) * 43758.5);\n";
    scene("s/slow", "uniform float uKd, uRed, uSide;\nvoid main() {\n  float x = gl_FragCoord.x;\n" + loops +
                        "  gl_FragColor = vec4(x);\n}\n");
    fs::remove_all(at("s/ann"));
    folder.write("r.toml", with(with(head, "timeout = 10", "timeout = 1"), "64x48", "512x512") +
                               "[[item]]\nno_errors = true\n[[item]]\nset = { uKd = 0 }\nexpect = \"darker\"\n");
    const Outcome made = grade("r.toml s -o out");
    ASSERT_EQ(made.status, 0) << made.output;
    EXPECT_NE(result("slow")["problem"].get<std::string>().find("takes longer than 1 second"), std::string::npos);
    EXPECT_NE(result("slow")["problem"].get<std::string>().find(": its picture takes"), std::string::npos);
    EXPECT_EQ(result("slow")["points"], 0) << "its shaders count as unread";
    EXPECT_NE(page("slow").find("its shaders count as unread"), std::string::npos);
    EXPECT_NE(page("slow").find("takes longer than 1 second"), std::string::npos);
}

// Each shape and each texture is within its limits, but not all of them together.
TEST_F(HostileSubmission, OneThatAllocatesWithoutEndIsReported) {
    constexpr int targets = 12;
    std::string shapes = ball, passes = "##OpenGL GLIB\nVertex ball.vert\nFragment ball.frag\nProgram Plain uRed 1.\n";
    std::string units, samplers, sum;
    for (int i = 1; i <= targets; ++i) {
        const std::string n = std::to_string(i);
        shapes += "Sphere 1 " + std::to_string(1000 + i) + " 1000\n";
        passes += "Texture2D " + n + " 4096 4096\nRenderToTexture " + n + "\nSphere 1\n";
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
    fs::remove_all(at("s/ann"));
    const Outcome made = grade("r.toml s -o out --memory .3");
    ASSERT_EQ(made.status, 0) << made.output;
    for (const std::string name : {"shapes", "targets"})
        EXPECT_EQ(result(name)["problem"], "it takes more than 0.3 GB of memory") << name;
}

TEST_F(HostileSubmission, AClassIsGradedInTime) {
    for (int i = 0; i < 6; ++i)
        scene("s/student " + std::to_string(i),
              i == 4 ? "void main() { oops }" : paint + "// " + std::to_string(i) + "\n");
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
    timed(3);
    EXPECT_EQ(results()["submissions"].size(), 7u);
    timed(1);
}

}  // namespace

}  // namespace snell::test
