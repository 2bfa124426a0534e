// Better changes: the exact text that each mistake becomes.
#include "tests/accuracy/found_help.h"

namespace snell::accuracy {
namespace {

using Afters = std::vector<std::string>;

constexpr std::string_view world =
    "uniform mat4 uModelViewerMatrix;\nout vec3 vN, vE;\nvoid main() {\n    vN = gl_Normal;\n"
    "    vE = vec3(uModelViewerMatrix * gl_Vertex);\n    gl_Position = ftransform();\n}\n";

class FoundBetter : public testing::Test {
protected:
    // A fragment shader of `body` in main, with a normal and a direction from the eye in world coordinates.
    Found body(std::string_view body, std::string_view values = "", std::string_view scene = "Sphere 1",
               std::string_view outside = "", Finder finder = add_better_changes) {
        const std::string text =
            "#version 330 compatibility\nuniform samplerCube uSky;\nuniform float uEta, uX;\nin "
            "vec3 vN, vE;\n" +
            std::string(outside) + "void main() {\n" + std::string(body) + "}\n";
        return found_in_text(
            folder_,
            "LookAt 1 2 3  0 0 0  0 1 0\nCubeMap 6 p.hdr\nVertex w.vert\nFragment a.frag\nProgram P uSky 6 " +
                std::string(values) + "\n" + std::string(scene) + "\n",
            {{"w.vert", vertex_}, {"a.frag", text}, {"p.hdr", ""}}, finder);
    }
    // The line of the shader that begins with `begin`, after the n-th change of the kind.
    static std::string line(const Found& found, ChangeKind kind, std::size_t n, std::string_view begin,
                            std::string_view file = "a.frag") {
        const std::string text = found.text(kind, n, file);
        const std::size_t at = text.find(begin);
        return at == text.npos ? text : text.substr(at, text.find('\n', at) - at);
    }
    std::string_view vertex_ = world;
    Scratch folder_;
};

constexpr std::string_view unit = "vec3 n = normalize(vN), e = normalize(vE);\n";
constexpr std::string_view shows = "gl_FragColor = ";

TEST_F(FoundBetter, UnitLengthOneByOneAndTogether) {
    const Found found = body("gl_FragColor = texture(uSky, refract(vE, vN, .66));\n");
    EXPECT_EQ(found.after(ChangeKind::unit_length),
              (Afters{"normalize(vE)", "normalize(vN)", "normalize(vE); normalize(vN)"}));
    EXPECT_EQ(found.at(ChangeKind::unit_length)->lint, "unnormalised-direction");
    EXPECT_EQ(line(found, ChangeKind::unit_length, 2, shows),
              "gl_FragColor = texture(uSky, refract(normalize(vE), normalize(vN), .66));");
    EXPECT_TRUE(body(std::string(unit) + "gl_FragColor = texture(uSky, refract(e, n, .66));\n")
                    .after(ChangeKind::unit_length)
                    .empty());
}

TEST_F(FoundBetter, AMacrosUseIsNotEdited) {
    const Found found =
        body("gl_FragColor = texture(uSky, LOOK(vE));\n", "", "Sphere 1", "#define LOOK(x) reflect(x, vN)\n");
    EXPECT_TRUE(found.after(ChangeKind::unit_length).empty());
}

TEST_F(FoundBetter, TheSpaceOfACubeMap) {
    vertex_ =
        "out vec3 vN, vE;\nvoid main() {\n    vN = normalize(gl_NormalMatrix * gl_Normal);\n    vE = "
        "(gl_ModelViewMatrix * "
        "gl_Vertex).xyz;\n    gl_Position = ftransform();\n}\n";
    const Found found = body("vec3 n = normalize(vN);\ngl_FragColor = texture(uSky, reflect(vE, n));\n");
    const std::string text = found.text(ChangeKind::lint_fix, 0, "a.frag");
    EXPECT_NE(text.find("\nuniform mat4 uViewMatrixInverse;\nvoid main"), std::string::npos) << text;
    EXPECT_EQ(line(found, ChangeKind::lint_fix, 0, shows),
              "gl_FragColor = texture(uSky, mat3(uViewMatrixInverse) * reflect(vE, n));");
}

TEST_F(FoundBetter, WhereTheViewerIs) {
    vertex_ =
        "out vec3 vN, vE;\nvoid main() {\n    vN = normalize(gl_NormalMatrix * gl_Normal);\n    vE = "
        "(gl_ModelViewMatrix * "
        "gl_Vertex).xyz;\n    gl_Position = ftransform();\n}\n";
    const Found found =
        found_in_text(folder_, "CubeMap 6 p.hdr\nVertex w.vert\nFragment a.frag\nProgram P uSky 6\nSphere 1\n",
                      {{"w.vert", vertex_},
                       {"p.hdr", ""},
                       {"a.frag",
                        "uniform samplerCube uSky;\nin vec3 vN, vE;\nvoid main() {\n    vec3 r = "
                        "reflect(normalize(vE), normalize(vN));\n    gl_FragColor = texture(uSky, r);\n}\n"}},
                      add_better_changes);
    EXPECT_EQ(line(found, ChangeKind::lint_fix, 0, "    vec3 r"),
              "    vec3 r = reflect(normalize(vE - uViewerPositionEye), normalize(vN));");
}

TEST_F(FoundBetter, AnIndexIsNotARatio) {
    const Found found = body(std::string(unit) + "gl_FragColor = texture(uSky, refract(e, n, uEta));\n", "uEta 1.5");
    EXPECT_EQ(line(found, ChangeKind::lint_fix, 0, shows), "gl_FragColor = texture(uSky, refract(e, n, 1. / uEta));");
}

TEST_F(FoundBetter, TheSignInSchlicksFormula) {
    const auto sign = [&](std::string_view statements) {
        return body(std::string(unit) + "float c = dot(-e, n);\n" + std::string(statements) +
                    "gl_FragColor = texture(uSky, reflect(e, n)) * k;\n");
    };
    const auto fixed = [&](const Found& found, std::string_view begin = "float k") {
        for (std::size_t i = 0; const Change* change = found.at(ChangeKind::lint_fix, i); ++i)
            if (change->lint == "schlick-sign") return line(found, ChangeKind::lint_fix, i, begin);
        return std::string();
    };
    EXPECT_EQ(fixed(sign("float k = pow(1. + c, 5.);\n")), "float k = pow(clamp(1. - c, 0., 1.), 5.);");
    EXPECT_EQ(fixed(sign("float k = pow(c + 1., 5.);\n")), "float k = pow(clamp(1. - c, 0., 1.), 5.);");
    EXPECT_EQ(fixed(sign("float k = pow(clamp(1. + c, 0., 1.), 5.);\n")), "float k = pow(clamp(1. - c, 0., 1.), 5.);");
    EXPECT_EQ(fixed(sign("float k = pow(1. - dot(e, n), 5.);\n")), "float k = pow(clamp(1. + dot(e, n), 0., 1.), 5.);");
    EXPECT_EQ(fixed(sign("float b = 1. + c;\nfloat k = pow(b, 5.);\n"), "float b"), "float b = 1. - c;");
    EXPECT_EQ(fixed(sign("float k = .04 + .96 * (1. + c) * (1. + c);\n")),
              "float k = .04 + .96 * (1. - c) * (1. - c);");
}

TEST_F(FoundBetter, PowOfANegativeNumber) {
    const auto fixed = [&](std::string_view power) {
        return line(body(std::string(unit) + "gl_FragColor = vec4(" + std::string(power) + ");\n"),
                    ChangeKind::lint_fix, 0, shows);
    };
    EXPECT_EQ(fixed("pow(dot(n, e), 20.)"), "gl_FragColor = vec4(pow(max(dot(n, e), 0.), 20.));");
    EXPECT_EQ(fixed("pow(vN.x - vE.x, 2.)"), "gl_FragColor = vec4(pow(abs(vN.x - vE.x), 2.));");
}

TEST_F(FoundBetter, TheOrderOfColours) {
    const Found found =
        body(std::string(unit) +
                 "gl_FragColor = vec4(texture(uSky, refract(e, n, uEta)).r, texture(uSky, refract(e, n, "
                 "uEta + .01)).g, texture(uSky, refract(e, n, uEta + .02)).b, 1.);\n",
             "uEta .66");
    EXPECT_EQ(line(found, ChangeKind::lint_fix, 0, shows),
              "gl_FragColor = vec4(texture(uSky, refract(e, n, uEta + .02)).r, texture(uSky, refract(e, n, uEta + "
              ".01)).g, texture(uSky, refract(e, n, uEta)).b, 1.);");
}

TEST_F(FoundBetter, ComputedAndNotUsed) {
    const Found found =
        body(std::string(unit) +
             "float f = .04;\nfloat schlick = f + (1. - f) * pow(clamp(1. - dot(-e, n), 0., 1.), 5.);\n"
             "gl_FragColor = mix(texture(uSky, refract(e, n, .66)), texture(uSky, reflect(e, n)), f);\n");
    ASSERT_NE(found.at(ChangeKind::lint_fix), nullptr);
    EXPECT_EQ(found.at(ChangeKind::lint_fix)->lint, "never-read");
    EXPECT_EQ(line(found, ChangeKind::lint_fix, 0, shows),
              "gl_FragColor = mix(texture(uSky, refract(e, n, .66)), texture(uSky, reflect(e, n)), schlick);");
    const Found mirror = body(std::string(unit) + "vec3 r = reflect(e, n);\ngl_FragColor = texture(uSky, n);\n");
    EXPECT_EQ(line(mirror, ChangeKind::lint_fix, 0, shows), "gl_FragColor = texture(uSky, r);");
}

TEST_F(FoundBetter, DerivativesBeforeTheBranch) {
    const auto found = [&](std::string_view main) {
        return found_in_text(
            folder_,
            "Filter mipmap\nTexture2D 5 p.hdr\nVertex w.vert\nFragment a.frag\nProgram P uPicture "
            "5\nSphere 1\n",
            {{"w.vert", vertex_},
             {"p.hdr", ""},
             {"a.frag", "uniform sampler2D uPicture;\nin vec3 vN;\nvoid main() {\n" + std::string(main) + "}\n"}},
            add_better_changes);
    };
    const Found local = found(
        "    gl_FragColor = vec4(0.);\n    vec2 st = vN.xy * 2.;\n    if (vN.x > 0.)\n        gl_FragColor = "
        "texture(uPicture, st);\n");
    EXPECT_EQ(
        local.text(ChangeKind::derivatives_outside, 0, "a.frag"),
        "uniform sampler2D uPicture;\nin vec3 vN;\nvoid main() {\n    gl_FragColor = vec4(0.);\n    vec2 st = vN.xy "
        "* 2.; vec2 snellDx7 = dFdx(st), snellDy7 = dFdy(st);\n    if (vN.x > 0.)\n        gl_FragColor = "
        "textureGrad(uPicture, st, snellDx7, snellDy7);\n}\n");
    EXPECT_TRUE(
        found("    if (vN.x > 0.) {\n        vec2 st = vN.xy;\n        gl_FragColor = texture(uPicture, st);\n  "
              "  }\n")
            .after(ChangeKind::derivatives_outside)
            .empty())
        << "the coordinates are not known before the branch";
}

TEST_F(FoundBetter, FarFromTheOrigin) {
    const Found found = found_in_text(
        folder_, "LookAt 1000000 0 5  1000000 0 0  0 1 0\nVertex f.vert\nFragment a.frag\nProgram P\nSphere 1\n",
        {{"f.vert",
          "uniform mat4 M;\nuniform vec3 camWorldPos;\nout vec3 vE;\nvoid main() {\n    vE = vec3(M * gl_Vertex) "
          "- camWorldPos;\n    gl_Position = ftransform();\n}\n"},
         {"a.frag", "in vec3 vE;\nvoid main() { gl_FragColor = vec4(normalize(vE), 1.); }\n"}},
        add_better_changes);
    EXPECT_EQ(line(found, ChangeKind::lint_fix, 0, "    vE", "f.vert"),
              "    vE = vec3(uModelViewerMatrix * gl_Vertex);");
}

TEST_F(FoundBetter, ASmoothstepWithoutWidth) {
    EXPECT_EQ(line(body("gl_FragColor = vec4(smoothstep(.5, .5, vN.x));\n"), ChangeKind::lint_fix, 0, shows),
              "gl_FragColor = vec4(step(.5, vN.x));");
}

TEST_F(FoundBetter, ExactFresnelForSchlick) {
    const auto fixed = [&](std::string_view schlick, std::string_view before = "") {
        const Found found = body(std::string(unit) + "float c = clamp(dot(-e, n), 0., 1.);\n" + std::string(before) +
                                 "float k = " + std::string(schlick) + ";\ngl_FragColor = vec4(k);\n");
        const std::string text = found.text(ChangeKind::exact_fresnel, 0, "a.frag");
        if (!text.empty()) {
            EXPECT_TRUE(text.starts_with("#version 330 compatibility\n#include <snell/fresnel.glsl>\n")) << text;
        }
        return text.empty() ? "" : line(found, ChangeKind::exact_fresnel, 0, "float k");
    };
    const std::string exact = "float k = snellFresnelExact(c, 1., 1.5);";
    EXPECT_EQ(fixed(".04 + .96 * pow(1. - c, 5.)"), exact);
    EXPECT_EQ(fixed(".04 + (1. - .04) * pow(clamp(1. - c, 0., 1.), 5.)"), exact);
    EXPECT_EQ(fixed("mix(pow(1. - c, 5.), 1., .04)"), exact);
    EXPECT_EQ(fixed(".04 + .96 * p", "float p = pow(1. - c, 5.);\n"), exact);
    EXPECT_EQ(fixed("f + (1. - f) * (1. - c) * (1. - c)", "float f = .04;\n"),
              "float k = snellFresnelExact(c, 1., (1. + sqrt(f)) / (1. - sqrt(f)));");
    EXPECT_EQ(fixed(".04 + .9 * pow(1. - c, 5.)"), "") << "is another formula";
    EXPECT_EQ(fixed(".04 + .96 * pow(c, 5.)"), "");
    EXPECT_EQ(fixed("(f + (1. - f) * pow(1. - c, 5.)).r", "vec3 f = vec3(.9, .7, .3);\n"), "")
        << "a metal has a colour";
}

TEST_F(FoundBetter, PowerTwoIsNotSchlicks) {
    const auto fixed = [&](std::string_view schlick, std::string_view values = "") {
        return line(body(std::string(unit) + "float c = clamp(dot(-e, n), 0., 1.);\nfloat k = " + std::string(schlick) +
                             ";\ngl_FragColor = vec4(k);\n",
                         values),
                    ChangeKind::lint_fix, 0, "float k");
    };
    EXPECT_EQ(fixed(".04 + .96 * pow(1. - c, 2.)"), "float k = .04 + .96 * pow(1. - c, 5.);");
    EXPECT_EQ(fixed(".04 + .96 * pow(1. - c, uX)", "uX <1. 2. 9.>"), "float k = .04 + .96 * pow(1. - c, 5.);");
    EXPECT_EQ(fixed(".04 + .96 * (1. - c) * (1. - c)"),
              "float k = .04 + .96 * (1. - c) * (1. - c) * (1. - c) * (1. - c) * (1. - c);");
    EXPECT_EQ(fixed(".04 + .96 * pow(1. - c, 5.)"), "");
}

TEST_F(FoundBetter, TheMirrorGrowsTowardTheEdge) {
    const auto fixed = [&](std::string_view power, std::string_view color) {
        return line(body(std::string(unit) +
                         "vec3 r = reflect(e, n), t = refract(e, n, .66);\nvec3 mirrored = "
                         "texture(uSky, r).rgb, refracted = texture(uSky, t).rgb;\nfloat k = " +
                         std::string(power) + ";\ngl_FragColor.rgb = " + std::string(color) + ";\n"),
                    ChangeKind::lint_fix, 0, "float k");
    };
    constexpr std::string_view cosine = "pow(max(dot(n, -e), 0.), 1.55)";
    const std::string exchanged = "float k = 1. - " + std::string(cosine) + ";";
    EXPECT_EQ(fixed(cosine, "mirrored * k + refracted * (1. - k)"), exchanged);
    EXPECT_EQ(fixed(cosine, "(1. - k) * refracted + k * mirrored"), exchanged);
    EXPECT_EQ(fixed(cosine, "mix(refracted, mirrored, k)"), exchanged);
    EXPECT_EQ(fixed(cosine, "mix(mirrored, refracted, k)"), "");
    EXPECT_EQ(fixed("1. - pow(max(dot(n, -e), 0.), 1.55)", "mix(refracted, mirrored, k)"), "");
}

TEST_F(FoundBetter, LightThatLeavesABall) {
    const auto bent = [&](std::string_view statements, std::string_view shape = "Sphere 1") {
        return line(body(std::string(unit) + std::string(statements), "uEta <1. 1.5 2.>", shape),
                    ChangeKind::both_interfaces, 0, shows);
    };
    EXPECT_EQ(bent("gl_FragColor = texture(uSky, refract(e, n, 1. / uEta));\n"),
              "gl_FragColor = texture(uSky, snellRefractSphere(e, n, 1., uEta));");
    EXPECT_EQ(bent("gl_FragColor = texture(uSky, refract(e, n, .66));\n"),
              "gl_FragColor = texture(uSky, snellRefractSphere(e, n, .66, 1.));");
    EXPECT_EQ(bent("gl_FragColor = texture(uSky, refract(e, n, .66));\n", "Torus"), "") << "only balls are symmetric";
    EXPECT_EQ(bent("vec3 t = refract(e, n, .66);\ngl_FragColor = texture(uSky, refract(t, -n, 1.5));\n"), "");
    EXPECT_EQ(bent("vec3 t = refract(e, n, .66);\ngl_FragColor = texture(uSky, 2. * dot(t, e) * t - e);\n"), "");
}

TEST_F(FoundBetter, ARoomThatIsNear) {
    const std::string look = std::string(unit) + "vec3 r = reflect(e, n);\ngl_FragColor = texture(uSky, r);\n";
    const Found found = body(look, "", "Sphere 1\nBox 8 6 10");
    const std::string fragment = found.text(ChangeKind::box_projection, 0, "a.frag");
    EXPECT_TRUE(fragment.starts_with("#version 330 compatibility\n#include <snell/environment.glsl>\n")) << fragment;
    EXPECT_NE(fragment.find("\nin vec3 snellPosition;\nvoid main() {"), std::string::npos) << fragment;
    EXPECT_EQ(line(found, ChangeKind::box_projection, 0, shows),
              "gl_FragColor = texture(uSky, snellBoxDirection(snellPosition, r, vec3(4., 3., 5.), vec3(0., 0., 0.)));");
    const std::string vertex = found.text(ChangeKind::box_projection, 0, "w.vert");
    EXPECT_NE(vertex.find("\nout vec3 snellPosition;\nuniform mat4 uModelMatrix;\nvoid main() { snellPosition = "
                          "vec3(uModelMatrix * gl_Vertex);\n"),
              std::string::npos)
        << vertex;
    // Walls on each side.
    EXPECT_EQ(
        line(body(look, "", "Sphere 1\nQuadYZ -4 5\nQuadYZ 6 5\nQuadXZ -5 5\nQuadXZ 5 5\nQuadXY 5 5\nQuadXY -5 5"),
             ChangeKind::box_projection, 0, shows),
        "gl_FragColor = texture(uSky, snellBoxDirection(snellPosition, r, vec3(5., 5., 5.), vec3(1., 0., 0.)));");
    for (const std::string_view no_room : {"Sphere 1", "Sphere 1\nBox 1 1 1", "Sphere 1\nQuadYZ 5 5\nQuadYZ -5 5",
                                           "Sphere 1\nTranslate 9 0 0\nBox 8 6 10"})
        EXPECT_TRUE(body(look, "", no_room).after(ChangeKind::box_projection).empty()) << no_room;
}

TEST_F(FoundBetter, MoreRounds) {
    const auto rounds = [&](std::string_view statements, std::string_view outside = "") {
        return body(statements, "", "Sphere 1", outside, add_shader_changes);
    };
    const Found mean =
        rounds("float s = 0.;\nfor (int i = 0; i < 8; i++) s += sin(float(i) / 8.);\ngl_FragColor = vec4(s / 8.0);\n");
    ASSERT_EQ(mean.after(ChangeKind::more_rounds).size(), 2u);
    EXPECT_EQ(line(mean, ChangeKind::more_rounds, 0, "for ("),
              "for (int i = 0; i < 16; i++) s += sin(float(i) / 16.);");
    EXPECT_EQ(line(mean, ChangeKind::more_rounds, 0, shows), "gl_FragColor = vec4(s / 16.);") << "a mean stays one";
    EXPECT_EQ(line(mean, ChangeKind::more_rounds, 1, shows), "gl_FragColor = vec4(s / 32.);");
    EXPECT_EQ(rounds("for (int i = 0; i < N; i++) gl_FragColor = vec4(i);\n", "const int N = 6;\n")
                  .after(ChangeKind::more_rounds),
              (Afters{"N = 12", "N = 24"}));
    EXPECT_EQ(rounds("for (int i = 0; i < N; i++) gl_FragColor = vec4(i);\n", "#define N 6 // rounds\n")
                  .after(ChangeKind::more_rounds),
              (Afters{"#define N 12", "#define N 24"}));
    EXPECT_EQ(rounds("for (int i = 1; i <= N && uX > 0.; i++) gl_FragColor = vec4(i);\n", "const int N = 6;\n")
                  .after(ChangeKind::more_rounds),
              (Afters{"N = 12", "N = 24"}));
    const Found march = rounds("for (float t = 0.; t < 1.; t += .1) gl_FragColor += vec4(t * .1);\n");
    EXPECT_EQ(line(march, ChangeKind::more_rounds, 0, "for ("),
              "for (float t = 0.; t < 1.; t += 0.05) gl_FragColor += vec4(t * 0.05);");
    EXPECT_TRUE(rounds("vec3 a[3];\nfor (int i = 0; i < 3; i++) gl_FragColor.rgb += a[i];\n")
                    .after(ChangeKind::more_rounds)
                    .empty())
        << "the array has no more elements";
    for (const char* element : {"a[k++]", "a[k]; k += 1", "a[i + i]"})
        EXPECT_TRUE(rounds("vec3 a[8]; int k = 0;\nfor (int i = 0; i < 3; i++) { int m = i + i; gl_FragColor.rgb += " +
                           std::string(element) + "; }\n")
                        .after(ChangeKind::more_rounds)
                        .empty())
            << element;
    EXPECT_TRUE(
        rounds("for (int i = 0; i < int(uX); i++) gl_FragColor = vec4(i);\n").after(ChangeKind::more_rounds).empty());
}

TEST_F(FoundBetter, OnlyNumbersOfTheLoopFollowMoreRounds) {
    const auto more = [&](const std::string& statements) {
        return body("float s = 0., o = 1.;\n" + statements, "", "Sphere 1", "", add_shader_changes)
            .text(ChangeKind::more_rounds, 0, "a.frag");
    };
    const std::string adds = "for (int i = 0; i < 8; i++) s += uX;\n",
                      twice = "for (int i = 0; i < 16; i++) s += uX;\n";
    for (const auto& [before, after] : std::vector<std::pair<std::string, std::string>>{
             {"s /= 8.;", "s /= 16.;"},
             {"s *= 1. / 8.;", "s *= 1. / 16.;"},
             {"gl_FragColor = vec4(vN * (s / 8.), 1.);", "gl_FragColor = vec4(vN * (s / 16.), 1.);"},
             {"o = s * 2. / float(8);", "o = s * 2. / float(16);"}})
        EXPECT_NE(more(adds + before).find(twice + after), std::string::npos) << before << more(adds + before);
    for (const std::string other :
         {"o = pow(uX, 8.);", "s += pow(uX, 8.);", "o = uX / 8.;", "o = s * 8.;", "s = uX; s /= 8.;", "o = 8. / s;",
          "for (int k = 0; k < 8; k++) o += 1.;", "o = s / 2.; o += 8.;", "gl_FragColor = vec4(s, 8, 8., 1);"})
        EXPECT_NE(more(adds + other).find(twice + other), std::string::npos) << more(adds + other);
    // Within the loop: what is added, and where the counter is a share of its bound.
    for (const auto& [before, after] : std::vector<std::pair<std::string, std::string>>{
             {"s += uX * pow(uX, 8.) / 8.;", "s += uX * pow(uX, 8.) / 16.;"},
             {"o = max(o, sin(6.28 * (float(i) + .5) / 8.));", "o = max(o, sin(6.28 * (float(i) + .5) / 16.));"},
             {"float a = float(i) + .5; s += sin(a / 8.);", "float a = float(i) + .5; s += sin(a / 16.);"},
             {"o = max(o, sin(uX * float(i)) / 8.);", "o = max(o, sin(uX * float(i)) / 8.);"},
             {"s += float(i) > 8. ? 1. : .5;", "s += float(i) > 8. ? 1. : .5;"}}) {
        const std::string text = more("for (int i = 0; i < 8; i++) { " + before + " }\n");
        EXPECT_NE(text.find("for (int i = 0; i < 16; i++) { " + after + " }\n"), std::string::npos) << before << text;
    }
}

TEST_F(FoundBetter, OnlyNumbersOfTheStepFollowShorterSteps) {
    const auto more = [&](const std::string& inside, const std::string& behind) {
        return body("float s = 0., o = 1.;\nfor (float t = 0.; t < 1.; t += .1) { " + inside + " }\n" + behind + "\n",
                    "", "Sphere 1", "", add_shader_changes)
            .text(ChangeKind::more_rounds, 0, "a.frag");
    };
    for (const auto& [before, after] : std::vector<std::pair<std::string, std::string>>{
             {"s += o * uX * .1;", "s += o * uX * 0.05;"},
             {"o *= exp(-uX * .1);", "o *= exp(-uX * 0.05);"},
             {"s += o * (1. - exp(-(uX * .1)));", "s += o * (1. - exp(-(uX * 0.05)));"},
             {"float a = 1. - exp(-uX * .1); s += a;", "float a = 1. - exp(-uX * 0.05); s += a;"},
             {"s += sin(uX * .1);", "s += sin(uX * .1);"},
             {"o = min(o, uX * .1);", "o = min(o, uX * .1);"},
             {"s += uX / .1;", "s += uX / .1;"}}) {
        const std::string text = more(before, "");
        EXPECT_NE(text.find("t += 0.05) { " + after + " }\n"), std::string::npos) << before << text;
    }
    EXPECT_NE(more("s += uX;", "o = s * .1;").find("o = s * 0.05;"), std::string::npos);
    for (const std::string other : {"o = uX * .1;", "o += .1;", "gl_FragColor = vec4(s, .1, .1, 1.);", "s += .1;"})
        EXPECT_NE(more("s += uX;", other).find(other), std::string::npos) << more("s += uX;", other);
}

TEST(FoundBetterAll, ChangesAreSound) { expect_sound(add_better_changes); }

}  // namespace
}  // namespace snell::accuracy
