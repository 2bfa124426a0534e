// Lints of shaders: each fires where it must, at the right place, and is silent where nothing is known to be wrong.
#include "tests/lint/help.h"

namespace snell::lint {
namespace {

using Places = std::vector<std::string>;

// A fragment shader of `body` in main, with the varyings, a cube map and some uniforms.
Linted body(std::string_view statements, std::string_view values = "", std::string_view declarations = "") {
    return lint_fragment("in vec3 vN, vE;\nuniform samplerCube uSky;\nuniform float uEta, uX;\n" +
                             std::string(declarations) + "void main() {\n" + std::string(statements) + "\n}\n",
                         "uSky 6 " + std::string(values), "CubeMap 6 sky.hdr");
}

constexpr std::string_view unit_vectors = "vec3 n = normalize(vN), e = normalize(vE);\n";

void expect_silent(const Linted& linted) { EXPECT_TRUE(linted.found.empty()) << linted.text(); }

TEST(LintUnit, InterpolatedVectors) {
    const Linted bad = body("gl_FragColor = texture(uSky, refract(vE, vN, .66));");
    EXPECT_EQ(bad.at("unnormalised-direction"), (Places{"vE", "vN"})) << bad.text();
    EXPECT_EQ(bad.place("unnormalised-direction"), "a.frag:5:38");
    EXPECT_NE(bad.text().find("snell help unnormalised-direction"), std::string::npos);
    expect_silent(body("gl_FragColor = texture(uSky, refract(normalize(vE), normalize(vN), .66));"));
}

TEST(LintUnit, ByWayOfVariablesAndFunctions) {
    EXPECT_EQ(body("vec3 n = vN; n = -n;\ngl_FragColor = texture(uSky, reflect(normalize(vE), n));")
                  .at("unnormalised-direction"),
              Places{"n"});
    const std::string_view helper = "vec3 look(vec3 d, vec3 m) { return texture(uSky, reflect(d, m)).rgb; }\n";
    EXPECT_EQ(body("gl_FragColor.rgb = look(vE, vN);", "", helper).at("unnormalised-direction"), Places{"m"});
    expect_silent(body("gl_FragColor.rgb = look(vE, normalize(vN));", "", helper));
    expect_silent(body("vec3 n = vN; n = normalize(n);\ngl_FragColor = texture(uSky, reflect(vE, n));"));
}

TEST(LintUnit, TheOverloadThatACallMeans) {
    const std::string_view both =
        "vec3 turned(vec3 d, float k) { return normalize(d + k); }\n"
        "vec3 turned(vec3 d, vec3 k);\n";
    const std::string_view later = "\nvec3 turned(vec3 d, vec3 k) { return vN; }\n";
    const auto shader = [&](std::string_view by) {
        return lint_fragment("in vec3 vN, vE;\nuniform samplerCube uSky;\nuniform float uEta;\n" + std::string(both) +
                                 "void main() { gl_FragColor = texture(uSky, reflect(vE, turned(vN, " +
                                 std::string(by) + "))); }" + std::string(later),
                             "uSky 6", "CubeMap 6 sky.hdr");
    };
    expect_silent(shader("uEta"));
    expect_silent(shader("dot(vN, vE)"));
    EXPECT_EQ(shader("vec3(uEta)").at("unnormalised-direction"), Places{"turned(vN, vec3(uEta))"});
}

// A text with conditionals is read a second time.
TEST(LintUnit, TheOverloadInATextWithConditionals) {
    const Linted bad = lint_fragment(
        "#ifdef NOWHERE\n#endif\nin vec3 vN, vE;\nvec3 turned(vec3 v) { return reflect(v, vN); }\nvec2 turned(vec2 v) "
        "{ return v; }\n"
        "void main() { gl_FragColor = vec4(turned(vE), 1.); }\n");
    EXPECT_EQ(bad.at("unnormalised-direction"), Places{"vN"}) << bad.text();
}

TEST(LintUnit, SumsOfVectors) {
    EXPECT_EQ(body("vec3 n = normalize(vN) + vec3(.1, 0., 0.);\ngl_FragColor = texture(uSky, reflect(vE, n));")
                  .at("unnormalised-direction"),
              Places{"n"});
    // The mirror's own formula has unit length, and a uniform may have it.
    expect_silent(
        body("vec3 n = normalize(vN), e = normalize(vE);\nvec3 r = e - 2. * dot(e, n) * n;\n"
             "gl_FragColor = texture(uSky, refract(r, n, .66));"));
    expect_silent(body("gl_FragColor = texture(uSky, reflect(vE, uAxis));", "uAxis 0. 1. 0.", "uniform vec3 uAxis;\n"));
}

TEST(LintUnit, UnknownWhereBranchesDiffer) {
    expect_silent(body("vec3 n = vN; if (uX > 0.) n = normalize(vN);\ngl_FragColor = texture(uSky, reflect(vE, n));"));
    expect_silent(
        body("vec3 n = vN; for (int i = 0; i < 2; ++i) n = normalize(n);\n"
             "gl_FragColor = texture(uSky, reflect(vE, n));"));
    EXPECT_EQ(body("vec3 n = vN; if (!gl_FrontFacing) n = -n;\ngl_FragColor = texture(uSky, reflect(vE, n));")
                  .at("unnormalised-direction"),
              Places{"n"});
}

TEST(LintRatio, AnIndexForEta) {
    const std::string lit = std::string(unit_vectors) + "gl_FragColor = texture(uSky, refract(e, n, uEta));";
    const Linted bad = body(lit, "uEta <.1 1.5 5.>");
    EXPECT_EQ(bad.at("index-as-ratio"), Places{"uEta"}) << bad.text();
    EXPECT_EQ(bad.place("index-as-ratio"), "a.frag:6:44");
    expect_silent(body(lit, "uEta <.1 .66 5.>"));
    expect_silent(body(std::string(unit_vectors) + "gl_FragColor = texture(uSky, refract(e, n, 1. / uEta));",
                       "uEta <1. 1.5 5.>"));
    EXPECT_EQ(
        body(std::string(unit_vectors) + "const float IOR = 1.5;\ngl_FragColor = texture(uSky, refract(e, n, IOR));")
            .at("index-as-ratio"),
        Places{"IOR"});
}

TEST(LintRatio, LightThatLeavesIsRight) {
    expect_silent(body(std::string(unit_vectors) +
                           "vec3 t = refract(e, n, 1. / uEta);\nvec3 o = refract(t, -n, uEta);\n"
                           "gl_FragColor = texture(uSky, o);",
                       "uEta <1. 1.5 5.>"));
}

TEST(LintShadow, ALocalOfAUniformsName) {
    const Linted bad = body("float uX = 1.;\ngl_FragColor = vec4(uX);", "uX <0. .5 1.>");
    EXPECT_EQ(bad.at("shadowed-uniform"), Places{"uX"}) << bad.text();
    EXPECT_EQ(bad.place("shadowed-uniform"), "a.frag:5:7");
    expect_silent(body("gl_FragColor = vec4(half(2.));", "", "float half(float uX) { return .5 * uX; }\n"));
    expect_silent(body("float x = uX;\ngl_FragColor = vec4(x);"));
}

TEST(LintPow, OfANegativeBase) {
    EXPECT_EQ(body(std::string(unit_vectors) + "gl_FragColor = vec4(pow(dot(n, e), 8.));").at("pow-of-negative"),
              Places{"dot(n, e)"});
    EXPECT_EQ(body("gl_FragColor = vec4(pow(sin(vN.x), 2.));").at("pow-of-negative"), Places{"sin(vN.x)"});
    EXPECT_EQ(body("gl_FragColor = vec4(pow(uX, 2.));", "uX <-1. .5 1.>").at("pow-of-negative"), Places{"uX"});
    EXPECT_EQ(body("gl_FragColor = vec4(pow(vN.x - uX, 2.));").at("pow-of-negative"), Places{"vN.x - uX"});
    EXPECT_EQ(body("gl_FragColor = vec4(pow((vN.x - uX) / uEta, 2.));").at("pow-of-negative"),
              Places{"(vN.x - uX) / uEta"});
    EXPECT_EQ(body("float d = vN.x - uX;\nd *= uEta;\nfloat e = 2. * d / .3;\ngl_FragColor = vec4(pow(e, 2.));")
                  .at("pow-of-negative"),
              Places{"e"});
    EXPECT_EQ(body("gl_FragColor = vec4(square((vN.xy - vec2(uX, .5)).y / uEta));", "",
                   "float square(float x) { return pow(x, 2.); }\n")
                  .at("pow-of-negative"),
              Places{"x"});
}

TEST(LintPow, OfANormalAlongAnAxis) {
    const Linted bad = body("gl_FragColor = vec4(pow(dot(normalize(vN), vec3(1., 0., 0.)), 2.5));");
    EXPECT_EQ(bad.at("pow-of-negative"), Places{"dot(normalize(vN), vec3(1., 0., 0.))"}) << bad.text();
    EXPECT_EQ(body("vec3 n = normalize(vN);\ngl_FragColor = vec4(pow(dot(vec3(0., .5, -.5), n), uX));", "uX <1. 2. 8.>")
                  .at("pow-of-negative"),
              Places{"dot(vec3(0., .5, -.5), n)"});
    const Linted half = body("gl_FragColor = vec4(pow(.5 + .5 * dot(normalize(vN), vec3(0., 1., 0.)), 2.));");
    EXPECT_NE(half.text().find("by rounding"), std::string::npos) << half.text();
    expect_silent(body("gl_FragColor = vec4(pow(.6 + .5 * dot(normalize(vN), vec3(0., 1., 0.)), 2.));"));
    expect_silent(body("gl_FragColor = vec4(pow(max(dot(normalize(vN), vec3(0., 1., 0.)), 0.), 2.));"));
    // Weights of a colour; a colour of any kind may be given unit length.
    expect_silent(body("gl_FragColor = vec4(pow(dot(texture(uSky, vN).rgb, vec3(.2126, .7152, .0722)), 2.));"));
    expect_silent(body("gl_FragColor = vec4(pow(dot(normalize(texture(uSky, vN).rgb), vec3(1.)), 2.));"));
}

// One mistake, whether the middle is a slider or a number of the text.
TEST(LintPow, OfWhatIsLeftOrRightOfThePicturesMiddle) {
    const auto shader = [](std::string_view statements) {
        return lint("Vertex a.vert\nFragment a.frag\nProgram P uAd <.01 .1 .5>\nQuadXY\n",
                    {{"a.vert",
                      "varying vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; gl_Position = "
                      "gl_ModelViewProjectionMatrix * gl_Vertex; }\n"},
                     {"a.frag", "varying vec2 vST;\nuniform float uAd;\nvoid main() {\nfloat r = uAd;\n" +
                                    std::string(statements) + "\ngl_FragColor = vec4(r);\n}\n"}});
    };
    for (const std::string_view d : {"vST.s - uAd", "vST.s - .5", "2. * vST.s - 1.", "(vST.t - .5) / uAd",
                                     "2. * (vST.s - uAd) + .1", "-vST.s - .1", "fract(8. * vST.s) - .5"}) {
        const std::string ds = "float ds = " + std::string(d) + ";\n";
        EXPECT_EQ(shader(ds + "r += pow(ds, 2.);").at("pow-of-negative"), Places{"ds"}) << d;
        for (const std::string_view guard :
             {"if (ds >= 0.) r = pow(ds, 2.);", "bool right = ds >= 0.;\nif (right) r = pow(ds, 2.);",
              "bool right = false;\nright = right || ds > 0.;\nr = right ? pow(ds, 2.) : 0.;",
              "if (vST.s > .5 && vST.t > .5) r = pow(ds, 2.);", "r = pow(abs(ds), 2.);"})
            expect_silent(shader(ds + std::string(guard)));
    }
    expect_silent(shader("r = pow(1. - vST.s, 5.) + pow(vST.t, 2.) + pow(.6 - .5 * vST.s, 2.);"));
    expect_silent(shader("r = pow(vST.s * uAd, 2.) + pow(fract(vST.s) + .1, 2.);"));
}

TEST(LintPow, OfAQuotientOfSliders) {
    const std::string_view f0 = "gl_FragColor = vec4(pow((1. - uEta) / (1. + uEta), 2.));";
    EXPECT_EQ(body(f0, "uEta <.1 1.1 5.>").at("pow-of-negative"), Places{"(1. - uEta) / (1. + uEta)"});
    expect_silent(body(f0, "uEta <.1 .66 1.>"));
    expect_silent(body("float r = (1. - uEta) / (1. + uEta);\ngl_FragColor = vec4(r * r);", "uEta <.1 1.1 5.>"));
}

// Two unit vectors' product exceeds 1 by a rounding: not a number in a pixel here and there.
TEST(LintPow, ByRounding) {
    const Linted bad = body(std::string(unit_vectors) + "gl_FragColor = vec4(pow(1. - max(dot(n, -e), 0.), 5.));");
    EXPECT_EQ(bad.at("pow-of-negative").size(), 1U) << bad.text();
    EXPECT_NE(bad.text().find("by rounding"), std::string::npos);
    expect_silent(body(std::string(unit_vectors) + "gl_FragColor = vec4(pow(clamp(1. - dot(n, -e), 0., 1.), 5.));"));
    expect_silent(body(std::string(unit_vectors) + "gl_FragColor = vec4(pow(1. - clamp(dot(n, -e), 0., 1.), 5.));"));
}

TEST(LintPow, OfWhatIsBoundedOrUnknown) {
    expect_silent(body(std::string(unit_vectors) + "gl_FragColor = vec4(pow(max(dot(n, e), 0.), 8.));"));
    expect_silent(body("gl_FragColor = pow(texture(uSky, vN), vec4(1. / 2.2));"));
    // Of one sign by a condition, by a choice, or by what they are multiplied with.
    const std::string_view guards[] = {"if (d < 0.) d = -d;",     "if (d < 0.) d = 0.;",
                                       "d = d < 0. ? -d : d;",    "d = vN.x > uX ? vN.x - uX : uX - vN.x;",
                                       "if (vN.x < uX) discard;", "d = abs(d);",
                                       "d *= step(uX, vN.x);",    "d *= d;",
                                       "d /= uX - vN.y;"};
    for (const std::string_view guard : guards)
        expect_silent(
            body("float d = (vN.x - uX) / uEta;\n" + std::string(guard) + "\ngl_FragColor = vec4(pow(d, 2.));"));
    expect_silent(body("gl_FragColor = vec4(pow(sin(vN.x) * .5 + .5, 2.));"));
    expect_silent(body("gl_FragColor = vec4(pow(length(vN), uX));", "uX <0. 1. 5.>"));
    expect_silent(body(std::string(unit_vectors) +
                       "float d = dot(n, e); float s = 0.;\nif (d > 0.) s = pow(d, 8.);\ngl_FragColor = vec4(s);"));
    expect_silent(
        body(std::string(unit_vectors) + "float d = dot(n, e);\ngl_FragColor = vec4(d > 0. ? pow(d, 8.) : 0.);"));
    expect_silent(body(std::string(unit_vectors) +
                       "float d = dot(n, e);\nif (d < 0.) discard;\ngl_FragColor = vec4(pow(d, 8.));"));
}

TEST(LintSchlick, TheSign) {
    const auto shader = [](std::string_view base) {
        return body(std::string(unit_vectors) + "float c = clamp(" + std::string(base) +
                    ", 0., 2.);\ngl_FragColor = mix(texture(uSky, refract(e, n, .66)), texture(uSky, reflect(e, n)), "
                    "pow(c, 5.));");
    };
    EXPECT_EQ(shader("1. + dot(-e, n)").at("schlick-sign"), Places{"pow(c, 5.)"});
    EXPECT_EQ(shader("1. - dot(n, e)").at("schlick-sign"), Places{"pow(c, 5.)"});
    expect_silent(shader("1. - dot(-e, n)"));
    expect_silent(shader("1. + dot(e, n)"));
}

TEST(LintSchlick, TheSignInAPowerByMultiplication) {
    const auto shader = [](std::string_view power) {
        return body(std::string(unit_vectors) + "float c = clamp(dot(-e, n), 0., 1.);\nfloat k = .04 + .96 * " +
                    std::string(power) + ";\ngl_FragColor = texture(uSky, reflect(e, n)) * k;");
    };
    EXPECT_EQ(shader("(1. + c) * (1. + c)").at("schlick-sign"), Places{"(1. + c) * (1. + c)"});
    EXPECT_EQ(shader("(1. + c) * (1. + c) * (c + 1.)").at("schlick-sign"), Places{"(1. + c) * (1. + c) * (c + 1.)"});
    expect_silent(shader("(1. - c) * (1. - c)"));
    expect_silent(shader("(1. + c) * .5 + (1. + c)"));
    expect_silent(shader("(1. + c) * (1. + uX)"));
}

TEST(LintDispersion, TheOrderOfColours) {
    const auto shader = [](std::string_view red, std::string_view blue) {
        return body(std::string(unit_vectors) + "vec3 r = refract(e, n, uEta" + std::string(red) +
                        "), b = refract(e, n, uEta" + std::string(blue) +
                        ");\ngl_FragColor = vec4(texture(uSky, r).r, 0., texture(uSky, b).b, 1.);",
                    "uEta <.1 .66 1.>");
    };
    const Linted wrong = shader("", " + .02");
    ASSERT_EQ(wrong.at("dispersion-order").size(), 1u) << wrong.text();
    const std::vector<Note>& notes = wrong.found.items().front().notes;
    ASSERT_EQ(notes.size(), 2u);
    const auto text = [&](const Note& note) {
        return wrong.sources.text(note.span.file).substr(note.span.begin, note.span.end - note.span.begin);
    };
    EXPECT_EQ(text(notes[0]), "uEta") << "red's";
    EXPECT_EQ(text(notes[1]), "uEta + .02") << "blue's";
    EXPECT_TRUE(shader(" - .02", " + .02").has(Rule::dispersion_order));
    expect_silent(shader(" + .02", " - .02"));
    expect_silent(shader("", ""));
}

TEST(LintUnread, AComputedReflectance) {
    const Linted bad = body(std::string(unit_vectors) +
                            "float schlick = .04 + .96 * pow(clamp(1. - dot(-e, n), 0., 1.), 5.);\n"
                            "gl_FragColor = texture(uSky, reflect(e, n)) * .04;");
    EXPECT_EQ(bad.at("never-read"), Places{"schlick"}) << bad.text();
    EXPECT_EQ(bad.place("never-read"), "a.frag:6:7");
    // Another setting of the macro reads it.
    expect_silent(body("float s = pow(uX, 5.);\n#ifdef SHOW\ngl_FragColor = vec4(s);\n#endif\n", "uX <0. .5 1.>"));
}

TEST(LintFar, PositionsFarFromTheOrigin) {
    const auto seen_from = [](std::string_view eye) {
        return lint_fragment("in vec3 vN, vE;\nvoid main() { gl_FragColor = vec4(normalize(vE), 1.); }\n", "",
                             "LookAt " + std::string(eye) + "  0 1 0\n");
    };
    const Linted bad = seen_from("1000000 0 5  1000000 0 0");
    EXPECT_EQ(bad.at("far-from-origin"), Places{"vec3(M * gl_Vertex) - camWorldPos"}) << bad.text();
    EXPECT_EQ(bad.place("far-from-origin"), "a.vert:2:46");
    EXPECT_NE(bad.text().find("1.4 degrees"), std::string::npos) << bad.text();
    EXPECT_TRUE(seen_from("0 0 10000  0 0 9999").has(Rule::far_from_origin)) << "near what it looks at";
    expect_silent(seen_from("0 0 5  0 0 0"));
    expect_silent(seen_from("1000000 0 0  0 0 0"));  // what is far away is as exact as its distance
    expect_silent(lint("LookAt 1000000 0 5  1000000 0 0  0 1 0\nVertex a.vert\nFragment a.frag\nProgram A\nSphere\n",
                       {{"a.vert",
                         "uniform mat4 uModelViewerMatrix; out vec3 vE;\nvoid main() { vE = vec3(uModelViewerMatrix * "
                         "gl_Vertex);\ngl_Position = ftransform(); }\n"},
                        {"a.frag", "in vec3 vE;\nvoid main() { gl_FragColor = vec4(normalize(vE), 1.); }\n"}}));
}

TEST(LintRungs, TheNumberOfARungForTheRungsOwn) {
    using Places = std::vector<std::string>;
    struct {
        std::string_view statements;
        Places found;
        std::string_view ladder = "Ladder N 1 3 <8> 16 64";
    } const rows[]{
        {"for (int i = 0; i < N; i++) x += 1.;", {"N"}},
        {"for (int i = 0; N > i; i++) x += 1.; x /= float(N);", {"N", "N"}},
        {"x = 1. / float(N * 2);", {"N"}},
        {"float weights[N]; weights[0] = x;", {"N"}},
        {"int samples = N; for (int i = 0; i < samples; i++) x += 1.;", {"N"}},
        {"if (N == 8) x = 1.;", {"N"}},
        {"for (int i = 0; i + 1 < N; i++) x += 1.;", {"N"}},
        {"for (int i = 0; i < N_VALUE; i++) x += 1.;", {}},
        {"if (N == N_8 || N_16 <= N) x = 1.;\n#if N > 1\nx = 2.;\n#endif", {}},
        {"if (N > 0) x = 1.;", {}},
        {"switch (N) { case N_8: x = 1.; break; default: x = 2.; }", {}},
        {"int method = N; if (method == N_8) x = 1.;", {}},
        {"vec4 offsets = vec4(0.); x = offsets[N];", {}},
        {"for (int i = 0; i < N; i++) x += 1.;", {}, "Ladder N a <b> c"},
        {"for (int i = 0; i < N; i++) x += 1.;", {}, "Ladder N 0 1 <2>"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(lint_fragment(
                      "void main() {\nfloat x = 0.;\n" + std::string(row.statements) + "\ngl_FragColor = vec4(x);\n}\n",
                      "", row.ladder)
                      .at("rung-number"),
                  row.found)
            << row.ladder << "\n"
            << row.statements;
    const Linted found = lint_fragment("void main() { gl_FragColor = vec4(float(N)); }\n", "", "Ladder N 3 <8> 16");
    EXPECT_EQ(found.place("rung-number"), "a.frag:1:41");
    EXPECT_NE(found.text().find("use N_VALUE"), std::string::npos) << found.text();
}

TEST(LintSmoothstep, WithoutWidth) {
    const Linted bad = body("gl_FragColor = vec4(smoothstep(.5, .5, uX));");
    EXPECT_EQ(bad.at("smoothstep-without-width"), Places{"smoothstep(.5, .5, uX)"}) << bad.text();
    EXPECT_TRUE(body("gl_FragColor = vec4(smoothstep(.5, uEta, uX));", "uEta .5").has(Rule::smoothstep_without_width));
    expect_silent(body("gl_FragColor = vec4(smoothstep(.5, .6, uX));"));
    expect_silent(body("gl_FragColor = vec4(smoothstep(.5, uEta, uX));", "uEta <0. .5 1.>"));
    expect_silent(body("gl_FragColor = vec4(smoothstep(uX, uX + uEta, .5));", "uX <0. .5 1.>  uEta <0. .1 1.>"));
}

TEST(LintPlaces, InIncludedFilesAndNotInTheLibrary) {
    const std::string_view vert = "out vec3 vN; void main() { vN = gl_Normal; gl_Position = ftransform(); }\n";
    const Linted own =
        lint("Vertex a.vert\nFragment a.frag\nProgram A\nSphere\n",
             {{"a.vert", vert},
              {"a.frag", "in vec3 vN;\n#include \"mine.glsl\"\nvoid main() { gl_FragColor = vec4(f(vN), 1.); }\n"},
              {"mine.glsl", "// mine\nvec3 f(vec3 n) { return reflect(vec3(0., 0., 1.), n); }\n"}});
    EXPECT_EQ(own.place("unnormalised-direction"), "mine.glsl:2:51") << own.text();
    const Linted library =
        body("gl_FragColor = texture(uSky, snellReflect(vE, vN)) * snellFresnelSchlick(dot(vN, vE), 1., 1.5);", "",
             "#include <snell/core.glsl>\n#include <snell/fresnel.glsl>\n");
    expect_silent(library);
}

TEST(LintTotal, StandsAnything) {
    for (const std::string_view text :
         {"void main() { if (", "void main() { for (;;", "void main() { x = y[", "void main() { f(f(f(",
          "void main() { do", "void main() { do {", "void main() { do { } while (",
          "void main() { float x = 0.; do x += 0.; while (x < 1.", "float f() { return f(); }\nvoid main() { f(); }",
          "void main() { pow(; }", "#define A A\nvoid main() { A; }", "void main() { reflect(vN); }", "void", "}{", ""})
        (void)lint_fragment(text).text();
}

}  // namespace
}  // namespace snell::lint
