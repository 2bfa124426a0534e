// What the translator says of the uniforms that a program declares: only what is certain.
#include <map>

#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

using Use = DeclaredUniform::Use;

std::string uses_of(const Texts& texts) {
    std::string line;
    for (const DeclaredUniform& d : translated(texts).translation.declared)
        line += (line.empty() ? "" : " ") + d.name + (d.use == Use::none ? "-" : d.use == Use::sure ? "+" : "?");
    return line;
}

struct Row {
    std::string uses, text;  // `uses`: each uniform with + (sure), - (none) or ? (unsure)
};

class FragmentUses : public testing::TestWithParam<Row> {};

TEST_P(FragmentUses, AreAsTheTextSays) {
    EXPECT_EQ(uses_of({{Stage::fragment, GetParam().text}}), GetParam().uses) << GetParam().text;
}

std::string in_main(const std::string& declarations, const std::string& body) {
    return "#version 120\n" + declarations + "\nvoid main() { " + body + " }\n";
}

const std::string a = "uniform float uA; uniform float uB;", color = "gl_FragColor = vec4(1.);";

const Row rows[] = {
    // Never named where code runs.
    {"uA- uB-", in_main(a, color)},
    {"uA- uB+", in_main(a + "float f() { return uA; }", "gl_FragColor = vec4(uB);")},
    {"uA- uB-", in_main(a + "float f() { return uA; } float g() { return f() + uB; }", color)},
    {"uA+ uB-", in_main(a + "float f() { return uA; } float g() { return f(); }", "gl_FragColor = vec4(g());")},
    {"uA- uB-", in_main(a, "float uA = 1., uB = 2.; gl_FragColor = vec4(uA, uB, 1., 1.);")},
    // Named without an effect.
    {"uA? uB?", in_main(a, "float x = uA; x = 1. + 0. * uB; gl_FragColor = vec4(x);")},
    {"uA? uB?", in_main(a, "vec4 c = vec4(uA); c = vec4(1.); if (false) c.r = uB; gl_FragColor = c;")},
    {"uA? uB+", in_main(a, "vec4 c = vec4(uA, uB, 0., 1.); gl_FragColor = c.ggga;")},
    {"uA? uB?", in_main(a, "gl_FragColor = vec4(uA - uA, uB / uB, pow(2., 0. * uA), 1.);")},
    {"uA? uB+", in_main(a, "for (int i = 0; i < 0; ++i) gl_FragColor.r += uA; gl_FragColor = vec4(uB);")},
    {"uA? uB?", in_main(a, "gl_FragColor = mix(vec4(1.), vec4(uA), step(1., .5)); float y = clamp(uB, 0., 1.);")},
    {"uA? uB?",
     in_main(a + "float f(float x, float k) { return x * k; }", "gl_FragColor = vec4(f(uA, 0.) + f(0., uB));")},
    {"uA? uB+", in_main(a, "gl_FragColor = vec4(uB); return; gl_FragColor = vec4(uA);")},
    {"uA? uB?", in_main(a, "if (uA > 0.) gl_FragColor = vec4(1.); else gl_FragColor = vec4(1.); dFdx(uB);")},
    {"uA? uB?", in_main(a, "gl_FragColor = vec4(dFdx(uA), fwidth(uB), 0., 1.);")},
    {"uA? uB+", in_main(a, "gl_FragColor = vec4(uB, fwidth(gl_FragCoord.x * gl_FragCoord.y) + dFdx(uA), 0., 1.);")},
    // What GLSL leaves undefined says nothing.
    {"uA? uB+", in_main(a, "gl_FragColor = vec4(sqrt(-1. - uA * uA), uB, 1., 1.);")},
    {"uA? uB?", in_main(a, "gl_FragColor = vec4(uA, uB, 1., 1.) / 0.;")},
    {"uA? uB?", in_main(a, "gl_FragColor = vec4(normalize(vec3(0.)) * uA, uB * log(0.));")},
    {"uA? uB+", in_main(a + "float g;", "gl_FragColor = vec4(uA * g, uB, g + uA, 1.);")},
    {"uA? uB+", in_main(a + "\n#define LOCAL float x\n", "LOCAL; gl_FragColor = vec4(uA + x, uB, 1., 1.);")},
    {"uA? uB+", in_main(a + "float f() { if (uB > 9.) return 1.; }", "gl_FragColor = vec4(f() + uA, uB, 1., 1.);")},
    // With an effect.
    {"uA+ uB+", in_main(a, "gl_FragColor = vec4(uA, 0., 0., 1.); gl_FragColor.g = uB;")},
    {"uA+ uB+", in_main(a, "gl_FragColor = mix(vec4(1.), vec4(0.), uA); if (uB < .3) discard;")},
    {"uA+ uB+", in_main(a, "float x = uA; x += 2.; for (int i = 0; i < 3; ++i) x *= uB; gl_FragColor = vec4(x);")},
    {"uOn+ uN+", in_main("uniform bool uOn; uniform int uN;",
                         "float s = 0.; for (int i = 0; i < uN; i++) s += .1; gl_FragColor = vec4(s); "
                         "if (uOn) gl_FragColor.r = 1.;")},
    {"uMode+ uA+ uB+", in_main("uniform int uMode;" + a,
                               "float x = 0.; switch (uMode) { case 0: x = uA; break; case 1: case 2: x = uB; break; "
                               "default: x = 1.; } gl_FragColor = vec4(x);")},
    {"uA+ uB+", in_main(a + "void f(inout float x, out float y) { x *= uA; y = x + uB; }",
                        "float x = 1., y; f(x, y); gl_FragColor = vec4(x, y, 0., 1.);")},
    {"uA+ uB+", in_main(a + "struct S { float k[2]; vec3 v; };",
                        "S s; s.k[0] = 1.; s.k[1] = uA; s.v = vec3(0.); s.v.yz += uB; "
                        "gl_FragColor = vec4(s.v, s.k[1]);")},
    {"uA+ uB+",
     in_main(a, "mat3 m = mat3(uA); m[1] = vec3(uB, 0., 1.); gl_FragColor = vec4(m * vec3(1., 2., 3.), 1.);")},
    {"uA+ uB+",
     in_main(a + "const float k = 2.; float g = uA * k;", "gl_FragColor = vec4(g, uB > .5 ? 1. : 0., 0., 1.);")},
    {"uM+ uV+ uS+", in_main("uniform mat4 uM; uniform ivec2 uV; uniform sampler2D uS;",
                            "gl_FragColor = uM * texture2D(uS, vec2(uV) * .1);")},
    {"uL+ uC+", in_main("struct L { vec3 d; float i; }; uniform L uL; uniform vec3 uC[3];",
                        "gl_FragColor = vec4(uL.d * uL.i + uC[2], 1.);")},
    {"uA+ uB+", in_main(a,
                        "float s = 0.; int i = 0; do { i++; if (i == 2) continue; if (i > 4) break; s += uA; } "
                        "while (i < 9); while (s < uB * 9.) s += 1.; gl_FragColor = vec4(s);")},
};
INSTANTIATE_TEST_SUITE_P(Rows, FragmentUses, testing::ValuesIn(rows));

const std::string ads =
    "uniform float uKa, uKd, uKs, uShininess; uniform vec4 uColor, uSpecularColor; varying vec3 vN, vL, vE;\n"
    "void main() { vec3 n = normalize(vN), l = normalize(vL), e = normalize(vE);\n"
    "vec4 ambient = uKa * uColor; float d = max(dot(n, l), 0.); vec4 diffuse = uKd * d * uColor; float s = 0.;\n"
    "if (dot(n, l) > 0.) { vec3 r = normalize(reflect(-l, n)); s = pow(max(dot(e, r), 0.), uShininess); }\n"
    "vec4 specular = uKs * s * uSpecularColor; gl_FragColor = vec4(ambient.rgb + diffuse.rgb + specular.rgb, 1.); }";

TEST(Uses, OfTheUsualLighting) {
    EXPECT_EQ(
        uses_of({{Stage::vertex,
                  "uniform float uAmp, uFreq, uUnused; uniform vec3 uLight; varying vec3 vN, vL, vE;\n"
                  "void main() { vec4 v = gl_Vertex; v.z += uAmp * sin(uFreq * v.x); vec4 ec = gl_ModelViewMatrix * "
                  "v;\nvN = normalize(gl_NormalMatrix * gl_Normal); vL = uLight - ec.xyz; vE = vec3(0.) - ec.xyz; "
                  "gl_Position = gl_ModelViewProjectionMatrix * v; }"},
                 {Stage::fragment, ads}}),
        "uAmp+ uFreq+ uUnused- uLight+ uKa+ uKd+ uKs+ uShininess+ uColor+ uSpecularColor+");
}

TEST(Uses, GoThroughVaryingsThatAreRead) {
    const std::string vertex =
        "uniform float uA, uB, uC; varying float vA, vB; varying vec2 vC; void main() { vA = uA; vB = uB; vC = "
        "vec2(uC, "
        "1.); gl_Position = ftransform(); }";
    EXPECT_EQ(uses_of({{Stage::vertex, vertex},
                       {Stage::fragment,
                        "varying float vA, vB; varying vec2 vC; void main() { gl_FragColor = vec4(vA, "
                        "vB * 0., vC.y, 1.); }"}}),
              "uA+ uB? uC?");
}

TEST(Uses, OfAConstantVaryingThatHidesAUniform) {
    EXPECT_EQ(uses_of({{Stage::vertex, "varying float vK; void main() { vK = 0.; gl_Position = ftransform(); }"},
                       {Stage::fragment,
                        "uniform float uA; varying float vK; void main() { gl_FragColor = vec4(vK * uA); }"}}),
              "uA?");
}

TEST(Uses, OfStructuresThatHoldThemselvesAreNotCounted) {
    EXPECT_EQ(uses_of({{Stage::fragment,
                        in_main("struct S { float f; S s; }; uniform S uS;", "gl_FragColor = vec4(uS.f);")}}),
              "uS?");
}

TEST(Uses, SayTypeSizeAndInitialValue) {
    const auto declared =
        fragment(
            "#version 330\nuniform vec3 uV = vec3(1., 2., 3.); uniform float uF[3]; uniform B { vec2 m; } "
            "b; out vec4 c; void main() { c = vec4(uV, uF[1] + b.m.x); }")
            .translation.declared;
    ASSERT_EQ(declared.size(), 3u);
    EXPECT_EQ(declared[0].name + declared[0].glsl_type, "uVvec3");
    EXPECT_EQ(declared[0].initial, (std::vector<double>{1, 2, 3}));
    EXPECT_TRUE(declared[0].simple);
    EXPECT_EQ(declared[1].array_size, 3);
    EXPECT_FALSE(declared[1].simple);
    EXPECT_EQ(declared[2].name, "B.m");
    EXPECT_FALSE(declared[2].simple);
}

}  // namespace
}  // namespace snell::glsl::test
