// Grading: what items of a rubric judge, and what is kept of it.
#include "tests/grade/submissions.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Grade : public GradeTest {
protected:
    using Items = std::vector<std::string>;
    using Points = std::vector<double>;
    struct Handed {
        std::string fragment = paint, text = ball;
    };
    // Grades a class, "ann" and then "1" and so on, by items of four points each. What was said of them is in `last`.
    std::vector<Points> points_of_all(const Items& items, const std::vector<Handed>& submissions) {
        fs::remove_all(at("s"));
        fs::remove_all(at("out"));
        const auto name = [](std::size_t i) { return i == 0 ? "ann" : std::to_string(i); };
        for (std::size_t i = 0; i < submissions.size(); ++i)
            scene("s/" + name(i), submissions[i].fragment, submissions[i].text);
        std::string rubric = head;
        for (const std::string& item : items) rubric += "[[item]]\npoints = 4\n" + item;
        folder.write("r.toml", rubric);
        const Outcome made = grade("r.toml s -o out");
        EXPECT_EQ(made.status, 0) << made.output;
        last.clear();
        std::vector<Points> found(submissions.size());
        for (std::size_t k = 0; k < submissions.size(); ++k) {
            const json one = result(name(k));
            for (std::size_t i = 0; i < items.size() && !one.is_null(); ++i) {
                found[k].push_back(one["items"][i]["points"]);
                last += one["items"][i]["why"].get<std::string>() + "\n";
            }
        }
        return found;
    }
    Points points_of(const Items& items, const std::string& fragment = paint, const std::string& text = ball) {
        return points_of_all(items, {{fragment, text}})[0];
    }
    double points(const std::string& item, const std::string& fragment = paint, const std::string& text = ball) {
        const std::vector<double> found = points_of({item}, fragment, text);
        return found.empty() ? -1 : found[0];
    }
    std::string last;
};

TEST_F(Grade, ItemsWithoutPictures) {
    const Items items{"no_errors = true\n",
                      "needs = [\"Sphere\", \"perspective\"]\n",
                      "needs = [\"Sphere\", \"Teapot\"]\n",
                      "forbids = [\"Sphere\"]\n",
                      "forbids = [\"Torus\"]\n",
                      "counters = { draws = 1 }\n",
                      "counters = { draws = \"2..\" }\n"};
    // A comment uses nothing.
    EXPECT_EQ(points_of(items, paint, ball + "# Sphere Torus 1 .5\n# Torus 1 .5\n"), (Points{4, 4, 2, 0, 4, 4, 0}))
        << last;
    EXPECT_NE(last.find("draws 1, at least 2 expected"), std::string::npos) << last;
    EXPECT_EQ(points(items[0], with(paint, "float d", "float e")), 0);
}

TEST_F(Grade, UniformsHaveTypesAndRanges) {
    EXPECT_EQ(
        points_of({"uniforms = { uKd = \"float 0..1\", uRed = \"float\" }\n",
                   "uniforms = { uKd = \"float 0..2\", uRed = \"vec3\", uNone = \"float\", uSide = \"float\" }\n"}),
        (Points{4, 1}))
        << last;
    EXPECT_NE(last.find("goes from 0 to 1, not from 0 to 2"), std::string::npos) << last;
    EXPECT_NE(last.find("'uRed' is a float, not a vec3"), std::string::npos) << last;
    EXPECT_NE(last.find("no uniform 'uNone'"), std::string::npos) << last;
    // One end of the range is enough.
    EXPECT_EQ(points("uniforms = { uKd = \"float 0..\", uRed = \"float ..1\" }\n"), 4) << last;
    EXPECT_EQ(points("uniforms = { uKd = \"float -1..\", uRed = \"float ..2\" }\n"), 0);
    EXPECT_NE(last.find("goes from 0 to 1, not from -1"), std::string::npos) << last;
    EXPECT_NE(last.find("goes from 0 to 1, not to 2"), std::string::npos) << last;
}

TEST_F(Grade, LintsCostPoints) {
    const std::string negative = with(paint, "float d =", "float p = pow(vN.x - uSide, 2.);\n  float d = p * 0. +");
    const Items items{"no_lints = [\"pow-of-negative\", \"never-read\"]\neach = 1.5\n",
                      "no_lints = [\"pow-of-negative\"]\n"};
    EXPECT_EQ(points_of(items), (Points{4, 4})) << last;
    EXPECT_EQ(points_of(items, negative), (Points{2.5, 0})) << last;
}

TEST_F(Grade, RelationsBetweenPictures) {
    EXPECT_EQ(
        points_of({"set = { uKd = 0 }\nexpect = \"darker\"\n", "set = { uKd = 1 }\nexpect = \"darker\"\n",
                   "set = { uKd = 1 }\nexpect = \"brighter\"\n", "set = { uKd = 1 }\nexpect = \"brighter\"\nby = 3\n",
                   "set = { uRed = 0 }\nexpect = \"different\"\n", "set = { uRed = 0 }\nexpect = \"same\"\n",
                   // Without diffuse light, its side does not matter.
                   "set = { uKd = 0, uSide = -1 }\nthan = { uKd = 0 }\nexpect = \"same\"\n",
                   "set = { uSide = -0.3 }\nexpect = \"mirrored\"\n",
                   "set = { uSide = 0.9 }\nexpect = \"mirrored\"\n"}),
        (Points{4, 0, 4, 0, 4, 0, 4, 4, 0}))
        << last;
    EXPECT_EQ(points("expect = \"mirrored\"\n"), 0) << "one picture is compared with its own mirror image";
    EXPECT_EQ(points("expect = \"mirrored\"\n", paint, with(ball, ".3 1.", "0. 1.")), 4) << last;
    // The side makes it neither darker nor brighter, when by any amount would do.
    for (const std::string expect : {"darker", "brighter"})
        EXPECT_EQ(points("set = { uKd = 0, uSide = 1 }\nthan = { uKd = 0 }\nby = 0\nexpect = \"" + expect + "\"\n"), 0)
            << last;
    EXPECT_EQ(points("expect = \"different\"\nset = { uKd = 0 }\n", "void main() { gl_FragColor = vec4(oops); }"), 0);
}

TEST_F(Grade, AnEmptyPictureIsNotTheSame) {
    const Items items{"set = { uKd = 0 }\nexpect = \"same\"\n", "slower = 100\n"};
    EXPECT_EQ(points_of(items, paint, with(ball, "Sphere 1", "# Sphere 1")), (Points{0, 0})) << last;
    EXPECT_EQ(points_of(items), (Points{0, 4})) << last;
}

TEST_F(Grade, EmptinessIsJudgedByWhatIsDrawn) {
    // The reference is black on black without light, and nothing at all when it is cut away.
    const std::string cut = with(with(paint, "uSide;", "uSide, uCut;"), "  vec3 n",
                                 "  if (uCut > .5) discard;\n  vec3 n"),
                      text = with(with(ball, "uKd", "uCut <0. 0. 1.> uKd"), "LookAt", "Background 0 0 0\nLookAt"),
                      black = with(cut, "(.1 + uKd * d)", "uKd * d");
    scene("reference", black, text);
    const Items items{"no_errors = true\n",
                      "forbids = [\"Torus\"]\n",
                      "no_lints = [\"never-read\"]\n",
                      "uniforms = { uKd = \"float\" }\n",
                      "expect = \"reference\"\nmax_rmse = 0.9\n",
                      "set = { uKd = 0 }\nexpect = \"reference\"\n",
                      "set = { uCut = 1 }\nexpect = \"reference\"\n",
                      "set = { uCut = 1 }\nexpect = \"darker\"\n",
                      "counters = { draws = 1 }\n"};
    EXPECT_EQ(points_of(items, black, text), (Points{4, 4, 4, 4, 4, 4, 4, 4, 4})) << last;
    // Nearer to the reference than a limit is not enough.
    const std::string gone = with(black, "gl_FragColor", "if (uKd >= 0.) discard;\n  gl_FragColor");
    std::vector<Handed> nothing{{gone, text}};
    // All of it is behind the eye, in the background's colour, or wholly transparent.
    for (const std::string& moved : {with(text, "Sphere", "Translate 0 0 9\nSphere"),
                                     with(text, "Sphere", "Scale 0 0 0\nSphere"), with(text, "Sphere", "#")})
        nothing.push_back({black, moved});
    for (const std::string color : {"vec4(0.)", "vec4(0., 0., 0., 1.)", "vec4(1., 1., 1., 0.)", "vec4(0. / uCut)"})
        nothing.push_back(
            {"uniform float uKd, uRed, uSide, uCut;\nvoid main() { gl_FragColor = " + color + "; }", text});
    EXPECT_EQ(points_of_all(items, nothing), std::vector(nothing.size(), Points(9, 0))) << last;
    EXPECT_LT(last.find("nothing is seen"), last.find('\n')) << last;
    // A pixel is as good as nothing, but a small thing is something. One empty picture costs what is judged by it, and
    // no more: the reference shows something there.
    const auto within = [&](const std::string& pixels) {
        return with(black, "  vec3 n",
                    "  if (any(greaterThan(abs(gl_FragCoord.xy - vec2(32.5, 24.5)), vec2(" + pixels +
                        ")))) discard;\n  vec3 n");
    };
    const std::string dark = with(black, "uCut > .5", "uKd < .5 || uCut > .5");
    EXPECT_EQ(points_of_all(items, {{within("2.6"), text}, {within(".6"), text}, {dark, text}}),
              (std::vector<Points>{Points(9, 4), Points(9, 0), {4, 4, 4, 4, 4, 0, 4, 4, 4}}))
        << last;
    EXPECT_NE(last.find("hardly anything is seen in any of its pictures"), std::string::npos) << last;
    EXPECT_NE(last.find("nothing is seen in the picture 'uKd=0'"), std::string::npos) << last;
    // A single colour over everything shows nothing, whichever it is, and one pixel more changes nothing. What is
    // correct and small is something where the reference fills much of its picture.
    const auto painted = [](const std::string& color) {
        return "uniform float uKd, uRed, uSide, uCut;\nvoid main() { gl_FragColor = vec4(vec3(" + color +
               ") + uKd * .001, 1.);\n if (any(greaterThan(abs(gl_FragCoord.xy - vec2(32.5, 24.5)), vec2(.6)))) "
               "return;\n"
               " gl_FragColor = vec4(1., uKd, uCut, 1.);\n}";
    };
    const std::string over = with(text, "Sphere 1", "Sphere 50");
    EXPECT_EQ(points_of_all({items[4], items[5], "set = { uKd = 0 }\nexpect = \"different\"\nby = 0\n"},
                            {{painted("0."), over}, {painted(".3"), over}, {painted("1."), over}}),
              std::vector(3, Points(3, 0)))
        << last;
    scene("reference", cut, with(text, "LookAt 0 0 3", "LookAt 0 0 1.2"));
    EXPECT_EQ(points_of({"set = { uKd = 0 }\nexpect = \"darker\"\n"}, cut, with(text, "Sphere 1", "Sphere .2")),
              Points{4})
        << last;
    // A scene that fills its picture in the background's colour is there, if the reference's fills it, too.
    const std::string filled = with(with(text, "Sphere 1", "QuadXY 0 9"), "Background 0", "Background 1"),
                      plain = "uniform float uCut;\nvoid main() { gl_FragColor = vec4(1., uCut, 0., 1.); }";
    const Items wall{items[0], "set = { uCut = 1 }\nexpect = \"different\"\n"};
    EXPECT_EQ(points_of(wall, plain, filled), (Points{4, 0})) << last;
    scene("reference", plain, filled);
    EXPECT_EQ(points_of(wall, plain, filled), (Points{4, 4})) << last;
}

TEST_F(Grade, TheCauseIsToldFirst) {
    const std::string wall = with(ball, "Sphere 1", "Texture2D 5 wall.png\nSphere 1"),
                      reads =
                          "uniform sampler2D uWall;\nuniform float uKd, uRed, uSide;\nin vec3 vN;\nvoid main() {\n"
                          "  gl_FragColor = vec4(vec3(uRed, .2, .1) * (.1 + uKd * vN.z) + "
                          "texture2D(uWall, vN.xy + uSide).rgb, 1.);\n}\n";
    const Items items{"no_errors = true\n",
                      "set = { uSide = 1 }\nthan = { uSide = -1 }\nexpect = \"same\"\n",
                      "set = { uKd = 1 }\nexpect = \"darker\"\n",
                      "expect = \"reference\"\nmax_rmse = 0.0001\n",
                      "set = { uKd = 0 }\nexpect = \"darker\"\n",
                      "needs = [\"Sphere\"]\n",
                      "forbids = [\"Sphere\"]\n"};
    // Without its wall it has the same colours from any side.
    EXPECT_EQ(points_of(items, reads, with(wall, "uKd", "uWall 5 uKd")), (Points{0, 0, 0, 0, 4, 4, 0})) << last;
    const std::string missing = "ball.glib:7:13: there is no file 'wall.png' [file-not-found]; ";
    for (std::size_t at = 0, item = 0; item < 4; ++item, at = last.find('\n', at) + 1)
        EXPECT_EQ(last.find(missing, at), at) << "item " << item << '\n' << last;
    EXPECT_NE(last.find("\nit uses Sphere (ball.glib:8)\nit uses Sphere (ball.glib:8)\n"), std::string::npos) << last;
    // What nothing reads is not missing.
    EXPECT_EQ(points_of(items, paint, wall), (Points{4, 0, 0, 4, 4, 4, 0})) << last;
    // A shader with an error is not read, and what it draws is not there, although something else is seen.
    const Items broken{"no_lints = [\"never-read\"]\n", "expect = \"reference\"\nmax_rmse = 0.9\n",
                       "counters = { draws = \"..9\" }\n", "uniforms = { uKd = \"float\" }\n",
                       "forbids = [\"Torus\"]\n"};
    const std::string two = with(ball, "Vertex", "Color 0 1 0\nQuadXY -2 9\nVertex");
    EXPECT_EQ(points_of(broken, paint, two), (Points{4, 4, 4, 4, 4})) << last;
    EXPECT_EQ(points_of(broken, with(paint, "float d", "float e"), two), (Points{0, 0, 0, 0, 4})) << last;
    for (std::size_t at = 0, item = 0; item < 4; ++item, at = last.find('\n', at) + 1)
        EXPECT_EQ(last.find("ball.frag:7:", at), at) << "item " << item << '\n' << last;
    // A shader is empty because what it includes is.
    EXPECT_EQ(points("no_errors = true\n", "#version 330 compatibility\n#include \"none.inc\"\n"), 0);
    EXPECT_EQ(last.find("ball.frag:2:1: cannot read the included file 'none.inc'"), 0u) << last;
    // It is no merit that a uniform does not matter which nothing reads.
    EXPECT_EQ(points("set = { uMix = 1 }\nthan = { uMix = 0 }\nexpect = \"same\"\n", paint,
                     with(ball, "uKd", "uMix <0. 0. 1.> uKd")),
              0);
    EXPECT_NE(last.find("no shader uses 'uMix'"), std::string::npos) << last;
}

TEST_F(Grade, SmallObjectsAreDifferentByTheirOwnPixels) {
    const std::string small = with(ball, "Sphere 1", "Sphere .2"),
                      item = "set = { uRed = 0 }\nexpect = \"different\"\n";
    EXPECT_EQ(points(item + "by = 0.9\n", paint, small), 4) << last;
    EXPECT_NE(last.find(" of the pixels that are drawn on differ"), std::string::npos) << last;
    // In a part of it, which is less than a hundredth of the whole picture.
    const std::string half = with(paint, "uRed, .2", "vN.x > .4 ? uRed : .5, .2");
    EXPECT_EQ(points_of({item + "by = 0.15\n", item + "by = 0.5\n"}, half, small), (Points{4, 0})) << last;
    // What is drawn in the background's colour is drawn, too.
    const std::string text = with(small, "LookAt", "Background 0 0 0\nLookAt");
    EXPECT_EQ(points("set = { uRed = 0 }\nthan = { uRed = 1 }\nexpect = \"different\"\nby = 0.9\n",
                     "uniform float uRed;\nvoid main() { gl_FragColor = vec4(uRed, 0., 0., 1.); }", text),
              4)
        << last;
}

TEST_F(Grade, NoPixelIsNaNOrInfinite) {
    const Items items{"expect = \"finite\"\n", "set = { uKd = 0 }\nexpect = \"finite\"\n"};
    EXPECT_EQ(points_of(items), (Points{4, 4})) << last;
    EXPECT_EQ(points_of(items, with(paint, "uKd * d", "uKd * d + 1. / uKd - 1. / .7")), (Points{4, 0})) << last;
    EXPECT_NE(last.find("pixels are infinite"), std::string::npos) << last;
    const std::string centre = "all(lessThan(abs(gl_FragCoord.xy - vec2(32.5, 24.5)), vec2(.4)))";
    EXPECT_EQ(points_of(items, with(paint, "uKd * d", "uKd * d + (" + centre + " ? 1. / uKd - 1. / .7 : 0.)")),
              (Points{4, 0}));
    EXPECT_NE(last.find("1 pixel is infinite"), std::string::npos) << last;
    EXPECT_NE(bytes_of(at("out/index.html")).find("<p>1 submission, "), std::string::npos);
    EXPECT_EQ(points_of(items, with(paint, "uKd * d", "uKd * d / uKd")), (Points{4, 0})) << last;
    EXPECT_NE(last.find("pixels of the picture 'uKd=0' are NaN"), std::string::npos) << last;
}

TEST_F(Grade, OneOfSeveralIsEnough) {
    const std::string hidden = "expect = \"reference\", max_rmse = 0.001",
                      reversed = "either = [{ set = { uKd = 0.2 }, " + hidden +
                                 " },\n  { set = { uKd = 0.8 }, than = { " + "uKd = 0.2 }, " + hidden + " }]\n",
                      same = "set = { uKd = 0.8 }\nexpect = \"reference\"\n",
                      lines =
                          "[[item.either]]\nneeds = [\"Torus\", \"Cone\"]\n[[item.either]]\nneeds = [\"Sphere\", "
                          "\"Torus\"]\n";
    EXPECT_EQ(points_of({reversed, same, lines}), (Points{4, 4, 2})) << last;
    EXPECT_NE(page("ann").find("src=\"reference-"), std::string::npos);
    EXPECT_EQ(points_of({reversed, same}, with(paint, "uKd * d", "(1. - uKd) * d")), (Points{4, 0})) << last;
    EXPECT_EQ(points(reversed, with(paint, "float d", "float e")), 0);
    EXPECT_EQ(last.find("ball.frag"), 0u) << last;
    EXPECT_EQ(last.find("ball.frag", 1), std::string::npos) << "once: " << last;
    EXPECT_EQ(points(reversed, with(paint, "uKd * d", "d")), 0);
    EXPECT_NE(last.find("allowed; or: distance to the reference"), std::string::npos) << last;
    // Each picture beside the reference's that it is compared with, and with its own map.
    const std::string shown = page("ann");
    for (const std::string file : {"reference-1.png", "map-0.png", "map-1.png"}) {
        EXPECT_NE(shown.find(file), std::string::npos) << file;
        EXPECT_TRUE(fs::exists(at("out/students/ann/" + file))) << file;
    }
}

TEST_F(Grade, DeductionsCostPoints) {
    folder.write("r.toml", head +
                               "[[item]]\npoints = 4\nno_errors = true\n"
                               "[[item]]\nname = \"Handed in in time\"\ndeduct = 1.5\nexcept = [\"ann\", \"b*\", "
                               "\"zoe\", \"EVE\"]\n[[item]]\ndeduct = 1\nnamed = \"ball.glib\"\n"
                               "[[item]]\ndeduct = 9\nset = { uKd = 0 }\nexpect = \"darker\"\n");
    scene("s/ann");
    scene("s/bob", paint, ball, "mine.glib");
    scene("s/eve");
    scene("s/kim", with(paint, "uKd * d", "d"));
    const Outcome made = grade("r.toml s -o out");
    EXPECT_TRUE(made.says("warning: 'except' names 'zoe', but there is no such submission")) << made.output;
    EXPECT_TRUE(made.says("warning: 'except' names 'EVE', but there is no such submission")) << made.output;
    EXPECT_FALSE(made.says("reference-fails")) << made.output;
    EXPECT_EQ(results()["points"], 4);
    EXPECT_EQ(results()["items"][1]["points"], 0);
    EXPECT_EQ(results()["items"][1]["deducts"], 1.5);
    EXPECT_EQ(results()["items"][0]["deducts"], 0);
    for (const char* suite : {"\"bob\" tests=\"4\" failures=\"2\"", "\"eve\" tests=\"4\" failures=\"0\""})
        EXPECT_NE(bytes_of(at("out/junit.xml")).find(suite), std::string::npos) << bytes_of(at("out/junit.xml"));
    for (const auto& [name, points] : {std::pair("ann", 2.5), {"bob", 1.5}, {"eve", 4.}, {"kim", 0.}})
        EXPECT_EQ(result(name)["points"], points) << result(name).dump(1);
    EXPECT_EQ(result("bob")["items"][2]["points"], -1);
    EXPECT_EQ(result("bob")["items"][2]["why"], "the scene is called mine.glib, not ball.glib");
    EXPECT_NE(page("ann").find("<td class=\"number none\">-1.5</td>"), std::string::npos) << page("ann");
    EXPECT_NE(page("eve").find("<td class=\"number full\">0</td>"), std::string::npos) << page("eve");
    EXPECT_EQ(page("ann").find("b*"), std::string::npos) << "pages for students name nobody else";
}

TEST_F(Grade, ARubricWithoutAReferenceConfinesSubmissions) {
    folder.write("secret.frag", paint);
    scene("s/ann", "", with(ball, "ball.frag", "../../secret.frag"));
    folder.write("r.toml", "[[item]]\nno_errors = true\n");
    EXPECT_EQ(grade("r.toml s -o out").status, 0);
    EXPECT_EQ(result("ann")["points"], 0) << result("ann").dump(1);
}

TEST_F(Grade, TheReferenceHasTheSameValues) {
    const std::string hidden = "set = { uRed = 0.4, uKd = 0.5 }\nexpect = \"reference\"\n";
    EXPECT_EQ(points_of({hidden, "expect = \"reference\"\nmax_pixels = 5\nview = \"scale=.5\"\n"}), (Points{4, 4}))
        << last;
    // Other values in the scene's text do not matter where the rubric sets them.
    EXPECT_EQ(points(hidden, paint, with(ball, ".9 1.>", ".1 1.>")), 4) << last;
    EXPECT_EQ(points(hidden + "max_rmse = 0.001\n", with(paint, ".2, .1", ".2, .3")), 0);
    EXPECT_NE(last.find("RMSE"), std::string::npos);
}

TEST_F(Grade, OtherNamesAreMatchedByAliasesOnly) {
    std::string fragment = paint, text = with(ball, "uKd", "uDiffuse");
    for (int i = 0; i < 2; ++i) fragment = with(fragment, "uKd", "uDiffuse");
    const std::string item = "set = { uKd = 0 }\nexpect = \"darker\"\n",
                      uniform = "uniforms = { uKd = \"float 0..1\" }\n";
    EXPECT_EQ(points(item, fragment, text), 0);
    EXPECT_NE(last.find("uKd"), std::string::npos) << last;
    EXPECT_EQ(points_of({uniform, item + "[aliases]\nuKd = [\"kd\", \"uDiffuse\"]\n"}, fragment, text), (Points{4, 4}))
        << last;
    EXPECT_EQ(points_of({item, uniform + "[aliases]\nuKd = \"uDiffuse\"\n"}, fragment, text), (Points{4, 4})) << last;
    // A member of a structure, and a uniform of a program.
    const std::string dotted = "set = { \"uLamp.power\" = 0 }\nexpect = \"darker\"\n",
                      program = "set = { \"Ball.uKd\" = 0 }\nexpect = \"darker\"\n",
                      aliases = "[aliases]\n\"uLamp.power\" = \"uDiffuse\"\nuKd = \"uDiffuse\"\n";
    EXPECT_EQ(points_of({dotted, program + aliases}, fragment, text), (Points{4, 4})) << last;
}

TEST_F(Grade, ANewRubricGivesItsSceneAllPoints) {
    ASSERT_EQ(grade("--new reference/ball.glib -o r.toml").status, 0);
    EXPECT_EQ(grade("--new reference/ball.glib -o r.toml").status, 2) << "it is not replaced";
    scene("s/ann");
    const Outcome made = grade("r.toml s -o out");
    ASSERT_EQ(made.status, 0) << made.output;
    EXPECT_FALSE(made.says("reference-fails")) << made.output;
    const json all = results();
    EXPECT_EQ(result("ann")["points"], all["points"]) << all.dump(1);
    EXPECT_GE(all["items"].size(), 7u);
    const Outcome printed = grade("--new reference/ball.glib");
    EXPECT_TRUE(printed.says("uKd = \"float 0..1\"")) << printed.output;
    EXPECT_EQ(grade("--new reference/ball.glib -o -").output, printed.output);
    const Outcome below = snell("grade --new ball.glib -o ../up.toml", "", at("reference"));
    EXPECT_EQ(below.status, 0) << below.output;
    EXPECT_NE(bytes_of(at("up.toml")).find("reference = \"reference/ball.glib\""), std::string::npos);
    scene("broken", "oops", ball + "Teepot\n");
    EXPECT_EQ(grade("--new broken/ball.glib").status, 1);
}

TEST_F(Grade, ANewRubricNamesWhatItsSceneWrites) {
    std::string text = with(ball, "uKd", "uLight.power");
    text = with(text, "Sphere 1", "WireSphere .5\nTriangles [0 0 0] [1 0 0] [0 1 0]\nwirecube 1 1 1\nSphere 1");
    std::string fragment =
        with(paint, "uniform float uKd, ", "struct L { float power; };\nuniform L uLight;\nuniform float ");
    scene("reference", with(fragment, "uKd * d", "uLight.power * d"), text);
    scene("s/ann", with(fragment, "uKd * d", "uLight.power * d"), text);
    ASSERT_EQ(grade("--new reference/ball.glib -o r.toml").status, 0);
    const Outcome made = grade("r.toml s -o out");
    EXPECT_EQ(made.status, 0) << made.output;
    EXPECT_FALSE(made.says("reference-fails")) << made.output;
    EXPECT_EQ(result("ann")["points"], results()["points"]) << made.output << bytes_of(at("r.toml"));
    for (const std::string part :
         {"\"WireSphere\", \"Triangles\", \"WireBox\", \"Sphere\"]", "{ \"uLight.power\" = 0 }"})
        EXPECT_NE(bytes_of(at("r.toml")).find(part), std::string::npos) << part << bytes_of(at("r.toml"));
}

TEST_F(Grade, AReferenceThatFailsIsAWarning) {
    scene("s/ann");
    folder.write("r.toml", head + "[[item]]\nneeds = [\"Torus\"]\n");
    const Outcome made = grade("r.toml s -o out");
    EXPECT_EQ(made.status, 0);
    EXPECT_TRUE(made.says("the reference itself fails")) << made.output;
}

TEST_F(Grade, WhatDidNotChangeIsKept) {
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    for (const std::string name : {"ann", "bob", "eve"}) scene("s/" + name);
    EXPECT_TRUE(grade("r.toml s -o out").says("3 submissions, 0 of them judged before"));
    EXPECT_TRUE(grade("r.toml s -o out").says("3 submissions, 3 of them judged before"));
    scene("s/bob", "broken");
    EXPECT_TRUE(grade("r.toml s -o out").says("3 submissions, 2 of them judged before"));
    EXPECT_EQ(result("bob")["points"], 0);
    folder.write("s/eve/more.txt", "x");
    scene("s/zoe");
    EXPECT_TRUE(grade("r.toml s -o out").says("4 submissions, 2 of them judged before"));
    fs::remove_all(at("s/bob"));
    fs::remove_all(at("s/eve"));
    folder.write("r.toml", head + "[[item]]\nno_errors = true\npoints = 7\n");
    EXPECT_TRUE(grade("r.toml s -o out").says("0 of them judged before"));
    scene("reference", paint + "\n");
    EXPECT_TRUE(grade("r.toml s -o out").says("0 of them judged before"));
    EXPECT_TRUE(grade("r.toml s -o out --again").says("0 of them judged before"));
    // Pictures that somebody deleted are drawn again.
    folder.write("r.toml", head + "[[item]]\nexpect = \"reference\"\n");
    EXPECT_TRUE(grade("r.toml s -o out").says("2 submissions, 0 of them judged before"));
    for (const std::string file : {"picture-0.png", "reference-0.png", "map-0.png"}) {
        const std::string picture = at("out/" + result("ann")["folder"].get<std::string>() + "/" + file);
        EXPECT_TRUE(fs::remove(picture)) << picture;
        EXPECT_TRUE(grade("r.toml s -o out").says("2 submissions, 1 of them judged before")) << file;
        EXPECT_TRUE(fs::exists(picture)) << picture;
    }
    const std::string cut = at("out/" + result("ann")["folder"].get<std::string>() + "/picture-0.png");
    fs::resize_file(cut, 100);
    EXPECT_TRUE(grade("r.toml s -o out").says("2 submissions, 1 of them judged before"));
    EXPECT_GT(fs::file_size(cut), 100U);
    EXPECT_TRUE(fs::remove(at("out/reference/picture-0.png")));
    grade("r.toml s -o out");
    EXPECT_TRUE(fs::exists(at("out/reference/picture-0.png")));
}

TEST_F(Grade, ReportsAreNoSubmissionsNorParts) {
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    scene("s/ann");
    for (const std::string where : {"s/report", "s/ann/report"}) {
        EXPECT_TRUE(grade("r.toml s -o " + where).says("1 submission, 0 of them judged before")) << where;
        EXPECT_TRUE(grade("r.toml s -o " + where).says("1 submission, 1 of them judged before")) << where;
    }
    EXPECT_TRUE(grade("r.toml s -o out").says("not submissions: 'report' (a report)"));
    EXPECT_TRUE(grade("r.toml s/ann -o out").says("1 submission,"));
    // Work with a page that looks like one's is work.
    scene("s/report/students/ann");
    EXPECT_TRUE(grade("r.toml s -o out").says("2 submissions,"));
}

TEST_F(Grade, AProgramThatWasBuiltAgainKeepsNothing) {
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    scene("s/ann");
    const std::vector<std::string> parts{"snell", "snell_oiio.so", "snell_archive.so"};
    for (const std::string& part : parts) fs::copy_file(SNELL_BIN "/" + part, at(part));
    const auto by_copy = [&] { return grade_by("./snell"); };
    ASSERT_TRUE(grade_by(SNELL_BIN "/snell").says("0 of them judged before"));
    EXPECT_TRUE(by_copy().says("1 of them judged before")) << "a copy is the same program";
    for (const std::string& part : parts) {
        std::ofstream(at(part), std::ios::app) << "other";
        EXPECT_TRUE(by_copy().says("0 of them judged before")) << part;
        EXPECT_TRUE(by_copy().says("1 of them judged before")) << part;
    }
    EXPECT_TRUE(grade("r.toml s -o out --memory 5").says("0 of them judged before"));
    EXPECT_TRUE(grade("r.toml s -o out --memory 6").says("0 of them judged before")) << "more memory may help";
    for (const std::string number : {"nan", "inf", "-1", ".2"})
        EXPECT_EQ(grade("r.toml s -o out --memory=" + number).status, 2) << number;
}

TEST_F(Grade, ARunThatIsKilledKeepsNothingUnfinishedAndTwoDoNotWriteIntoOneFolder) {
    folder.write("r.toml", head + "[[item]]\nset = { uKd = 0 }\nexpect = \"darker\"\n");
    // One picture takes long enough to end the run while it is drawn.
    scene("s/ann", with(paint, "float d =",
                        "float x = n.x;\n  for (int i = 0; i < 8000; ++i) x = fract(sin(x) * 43758.5);\n"
                        "  float d = min(x, 0.) + "));
    const std::string start =
        "cd '" + folder.path() + "' && touch begun && { " SNELL_BIN "/snell grade r.toml s -o out ";
    // The record is written, again the second time, before the first picture.
    const std::string drawing =
        "i=0; while [ ! out/students/ann/result.json -nt begun ] && [ $i -lt 1000 ]; do sleep .01; "
        "i=$((i + 1)); done; ";
    const Outcome killed =
        run(start + ">first 2>&1 & }; " + drawing + "kill -KILL $!; wait $! 2>first; cat out/students/ann/result.json");
    EXPECT_TRUE(killed.says("judging ended before")) << "it was too late to kill it";
    // The other one waits a second for the folder: the first may not end in it.
    const Outcome two = run(start + ">first 2>&1 & }; " + drawing +
                            "kill -STOP $!; " SNELL_BIN
                            "/snell grade r.toml s -o out 2>&1; echo status $?; kill -CONT $!; wait; cat first");
    EXPECT_TRUE(two.says("error: another run of 'snell grade' writes into 'out'")) << two.output;
    EXPECT_TRUE(two.says("status 1")) << two.output;
    EXPECT_TRUE(two.says("1 submission, 0 of them judged before")) << two.output;
    EXPECT_EQ(result("ann")["points"], 1) << two.output;
}

TEST_F(Grade, FoldersOfStudentsKeepTheirNamesAndGoWithThem) {
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    scene("s/ann");
    scene("s/bob");
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    const auto folders = [&] {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(at("out/students"))) names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    };
    scene("t/bob", "broken");
    ASSERT_EQ(grade("r.toml s/* t/bob -o out").status, 0);
    const std::vector<std::string> three = folders();
    ASSERT_EQ(three.size(), 3u);
    EXPECT_EQ(three[1], "bob") << "another of that name renames no folder";
    EXPECT_TRUE(three[2].starts_with("bob-")) << three[2];
    ASSERT_EQ(grade("r.toml s/ann t/bob -o out").status, 0);
    EXPECT_EQ(folders(), (std::vector<std::string>{"ann", three[2]}));
    EXPECT_TRUE(grade("r.toml s/ann t/bob -o out").says("2 of them judged before"));
    // What grading did not make stays.
    folder.write("out/students/" + three[2] + "/letter.txt", "x");
    folder.write("out/students/mine/index.html", "x");
    fs::create_directory_symlink(at("out/students/ann"), at("out/students/link"));
    ASSERT_EQ(grade("r.toml s/ann -o out").status, 0);
    EXPECT_EQ(folders(), (std::vector<std::string>{"ann", three[2], "link", "mine"}));
    EXPECT_FALSE(fs::exists(at("out/students/" + three[2] + "/index.html")));
    EXPECT_TRUE(fs::exists(at("out/students/mine/index.html")));
    EXPECT_EQ(result("ann")["points"], 1);
    EXPECT_TRUE(fs::exists(at("out/students/ann/index.html")));
}

TEST_F(Grade, ASubmissionThatIsNamedTwiceIsOne) {
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    scene("s/ann");
    fs::create_directory_symlink("ann", at("s/link"));
    const Outcome made = grade("r.toml s/* s/ann s/ann/ s/../s/ann -o out");
    EXPECT_TRUE(made.says("2 submissions, 0 of them judged before")) << made.output;
    EXPECT_TRUE(made.says("it is a link to 'ann', which is judged as 'ann'")) << made.output;
    EXPECT_EQ(result("ann")["points"], 1) << made.output;
}

TEST_F(Grade, ReportsAreNotWrittenOverOtherFiles) {
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    scene("s/ann");
    folder.write("mine/letter.txt", "x");
    EXPECT_EQ(grade("r.toml s -o mine").status, 2);
    EXPECT_EQ(std::distance(fs::directory_iterator(at("mine")), fs::directory_iterator{}), 1);
}

// The folder that is meant exists, although its name leads through one that does not.
TEST_F(Grade, NoReportIsWrittenIntoASubmission) {
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    scene("s/ann");
    const Outcome made = grade("r.toml s -o s/nothere/../ann");
    EXPECT_EQ(made.status, 2) << made.output;
    EXPECT_TRUE(made.says("holds other files than a report")) << made.output;
    EXPECT_FALSE(fs::exists(at("s/ann/index.html")));
    EXPECT_EQ(grade("r.toml s -o nothere/../out").status, 0);
    EXPECT_TRUE(fs::exists(at("out/index.html")));
    EXPECT_FALSE(fs::exists(at("nothere")));
}

TEST_F(Grade, AFolderOfStudentsIsNoReport) {
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    scene("students/ann");
    for (const std::string file : {"reference/wall.png", "students/ann/wall.png", "similar/wall.png"})
        folder.write(file, "x");
    const Outcome made = grade("r.toml students -o .");
    EXPECT_EQ(made.status, 2) << made.output;
    EXPECT_TRUE(made.says("'.' holds other files than a report")) << made.output;
    for (const std::string file : {"reference/wall.png", "students/ann/wall.png", "similar/wall.png"})
        EXPECT_EQ(bytes_of(at(file)), "x") << file;
    EXPECT_FALSE(fs::exists(at(".lock")));
}

TEST_F(Grade, FilesThatALecturerAddsToAReportStay) {
    folder.write("r.toml", head + "[[item]]\nexpect = \"reference\"\n");
    scene("s/ann");
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    const std::vector<std::string> added{"out/students/ann/corrected.png", "out/reference/board.png",
                                         "out/similar/letter.txt"};
    for (const std::string& file : added) folder.write(file, "x");
    folder.write("out/students/ann/picture-7.png", "of another rubric");
    folder.write("r.toml", head + "[[item]]\npoints = 3\nexpect = \"reference\"\n");
    ASSERT_TRUE(grade("r.toml s -o out").says("0 of them judged before"));
    for (const std::string& file : added) EXPECT_EQ(bytes_of(at(file)), "x") << file;
    EXPECT_FALSE(fs::exists(at("out/students/ann/picture-7.png")));
}

TEST_F(Grade, WhatCannotBeWrittenIsTold) {
    folder.write("r.toml", head + "[[item]]\nexpect = \"reference\"\n");
    scene("s/ann");
    scene("s/bob");
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    fs::remove(at("out/students/ann/map-0.png"));
    fs::create_directories(at("out/students/ann/map-0.png/of a user"));
    fs::remove_all(at("out/students/bob"));
    folder.write("out/students/bob", "no folder");
    const Outcome made = grade("r.toml s -o out --again");
    EXPECT_TRUE(made.says("'map-0.png' cannot be written: ")) << made.output;
    EXPECT_TRUE(made.says("it ends the program that draws it: cannot write the record: ")) << made.output;
}

TEST_F(Grade, SimilarShadersAreTold) {
    const std::string long_one = with(
        paint, "  gl_FragColor",
        "  float s = 0.;\n  for (int i = 0; i < 4; ++i) { vec3 q = n * float(i) + vec3(.1, .2, .3); s += "
        "sin(q.x) * cos(q.y) + mix(q.z, q.x * q.y, .25) - smoothstep(.1, .9, q.x); }\n"
        "  if (s > .5) { d = d * .5 + step(.3, s) * fract(s * 7.); } else { d += clamp(s, 0., 1.); }\n  gl_FragColor");
    std::string renamed = long_one;
    for (std::size_t i = renamed.find("q"); i != std::string::npos; i = renamed.find("q", i + 4))
        renamed.replace(i, 1, "mine");
    const std::string other =
        with(paint, "  gl_FragColor",
             "  vec2 h = n.xy * n.yx;\n  while (h.x < .5) h.x += d;\n  mat2 m = mat2(h, h.yx);\n  d *= "
             "length(m * h) + distance(h, n.zy) / max(abs(n.x), .2);\n  gl_FragColor");
    scene("s/ann", long_one);
    scene("s/bob", "// my own\n" + renamed);
    for (const std::string name : {"c1", "c2", "c3", "c4", "c5", "c6"}) scene("s/" + name);
    scene("s/eve", other);
    folder.write("r.toml", head + "[[item]]\nno_errors = true\n");
    ASSERT_EQ(grade("r.toml s -o out").status, 0);
    // What more than eight have is no pair's, but equal submissions are told, whatever share of the class they are.
    const json similar = results()["similar"];
    ASSERT_EQ(similar.size(), 2u) << similar.dump(1);
    json six = json::array();
    for (int i = 1; i <= 6; ++i) six.push_back("students/c" + std::to_string(i));
    EXPECT_EQ(similar[0]["submissions"], six);
    EXPECT_EQ(similar[1]["submissions"], json::array({"students/ann", "students/bob"}));
    EXPECT_EQ(similar[1]["share"], 1);
    EXPECT_NE(bytes_of(at("out/similar/2.html")).find("<mark>"), std::string::npos);
    EXPECT_EQ(page("ann").find("bob"), std::string::npos) << "pages for students name nobody else";
    const auto told = [&](const std::string& words) {
        const Outcome outcome = grade("r.toml s -o out");
        const bool shown = bytes_of(at("out/index.html")).find(words) != std::string::npos;
        EXPECT_EQ(outcome.says("snell: note: "), shown) << outcome.output;
        return shown && outcome.says("snell: note: " + words);
    };
    EXPECT_TRUE(told("6 of 9 submissions are alike in all of their shaders"));
    // What was handed out explains it.
    folder.write("handout/h.frag", long_one);
    folder.write("r.toml", "template = \"handout\"\n" + head + "[[item]]\nno_errors = true\n");
    EXPECT_FALSE(told("submissions are alike"));
    EXPECT_EQ(results()["similar"].size(), 0u) << results()["similar"].dump(1);
    EXPECT_FALSE(fs::exists(at("out/similar")));
    // But not what six of nine have beyond it.
    for (int i = 1; i <= 6; ++i) scene("s/c" + std::to_string(i), i % 2 == 0 ? long_one : renamed);
    folder.write("handout/h.frag", paint);
    EXPECT_TRUE(told("8 of 9 submissions are alike in what the handout does not have"));
    EXPECT_EQ(results()["similar"].size(), 1u) << results()["similar"].dump(1);
}

}  // namespace

}  // namespace snell::test
