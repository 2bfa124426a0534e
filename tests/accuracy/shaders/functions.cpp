// Where polynomials are put, and what moves to the vertex shader.
#include "src/accuracy/found/shaders/shader.h"
#include "tests/accuracy/shaders/help.h"

namespace snell::accuracy::test {
namespace {

using enum ChangeKind;
using Lines = std::vector<std::string>;

std::string shader(const std::string& statement) {
    return "// A comment stays.\n#version 120\n#extension GL_EXT_gpu_shader4 : enable\nvarying vec3 vN;\nuniform float "
           "uShine;\n\nvoid main()\n{\n    " +
           statement + "\n}\n";
}

TEST_F(FoundShaders, AFunctionIsAddedAheadOfTheOneThatCallsIt) {
    Found& found = shaders(shader("gl_FragColor = vec4(pow(max(vN.x, 0.), 5.));"));
    EXPECT_EQ(found.lines(polynomial).size(), 1U);
    const Change* change = found.find(polynomial, "pow(max(vN.x, 0.), 5.)");
    ASSERT_NE(change, nullptr);
    const std::string text = found.changed(*change, "a.frag");
    const std::size_t at = shader("").find("void main");
    const std::string name = "foundPow_" + std::to_string(shader("gl_FragColor = vec4(").find("vec4(") + 5);
    EXPECT_EQ(text.substr(at, text.find("void main") - at),
              "// pow(x, 5) by multiplications: exact\nfloat " + name +
                  "(float x) { float x2 = x * x; float x4 = x2 * x2; return x * x4; }\n");
    EXPECT_NE(text.find("vec4(" + name + "(max(vN.x, 0.)));"), std::string::npos) << text;
    EXPECT_EQ(translation_errors(found, {change}), "");
}

TEST_F(FoundShaders, AllCallsOfAFunctionAreOneChangeToo) {
    Found& found = shaders(shader("gl_FragColor = vec4(sin(vN) * cos(vN.x), pow(vN.y, uShine));"));
    const std::vector<const Change*> all = found.of(polynomial);
    ASSERT_EQ(all.size(), 4U) << "three calls, and all of them";
    std::size_t most = 0;
    for (const Change* change : all) {
        most = std::max(most, change->edits.size());
        EXPECT_EQ(translation_errors(found, {change}), "");
    }
    EXPECT_EQ(most, 4U) << "one place ahead of main, three calls";
}

TEST_F(FoundShaders, CallsWithoutAPolynomialStay) {
    EXPECT_EQ(shaders(shader("gl_FragColor = vec4(tan(vN), sqrt(vN.x) + sin(.5));")).lines(polynomial), Lines{});
}

// ---- the vertex shader --------------------------------------------------------------------------------------

TEST_F(FoundShaders, WorkOnVaryingsMovesToTheVertexShader) {
    Found& found = shaders(
        "varying vec3 vN, vP;\nuniform vec3 uLight;\nvoid main() {\n    vec3 L = normalize(uLight - vP);\n"
        "    gl_FragColor = vec4(max(dot(vN, L), 0.));\n}\n");
    ASSERT_EQ(found.of(per_vertex).size(), 3U) << "two expressions, and both together";
    const Change* change = nullptr;
    for (const Change* each : found.of(per_vertex))
        if (each->before == "vec4(max(dot(vN, L), 0.))") change = each;
    ASSERT_NE(change, nullptr);
    EXPECT_TRUE(found.changed(*change, "a.vert").starts_with("varying vec3 vN, vP;\nvarying vec2 vST;\nvarying "));
    const std::string vert = found.changed(*change, "a.vert"), name = change->after;
    EXPECT_TRUE(name.starts_with("vFound_"));
    EXPECT_NE(vert.find("varying vec4 " + name + ";\n"), std::string::npos) << vert;
    EXPECT_NE(vert.find("= vec4(max(dot(vN, normalize(uLight - vP)), 0.));\n}"), std::string::npos) << vert;
    EXPECT_NE(vert.find("uniform vec3 uLight;\nvoid main"), std::string::npos) << vert;
    for (const Change* each : found.of(per_vertex)) EXPECT_EQ(translation_errors(found, {each}), "");
}

TEST_F(FoundShaders, WorkOnUniformsMovesToo) {
    Found& found =
        shaders("varying vec3 vN;\nuniform float uA;\nvoid main() { gl_FragColor = vec4(sin(uA) * vN, 1.); }\n");
    EXPECT_EQ(found.of(per_vertex).size() + found.of(per_frame).size(), 1U);
    const Found& alone = shaders(
        "varying vec3 vN;\nuniform float uA;\nvoid main() { vec3 c = vN; c *= sin(uA); gl_FragColor = vec4(c, 1.); "
        "}\n");
    ASSERT_EQ(alone.of(per_frame).size(), 1U);
    EXPECT_EQ(translation_errors(alone, alone.of(per_frame)), "");
}

TEST_F(FoundShaders, WorkStaysWhereItCannotMove) {
    const auto moved = [&](const std::string& fragment, const std::string& state = "") {
        const Found& found = shaders(fragment, "", state);
        return found.of(per_vertex).size() + found.of(per_frame).size();
    };
    const std::string work = "gl_FragColor = vec4(normalize(vN), 1.); }\n";
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { " + work), 1U);
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { " + work, "Vertex a.vert\nFragment a.frag\nProgram B\nSphere 1."),
              0U)
        << "another program has the vertex shader, too";
    EXPECT_EQ(moved("varying vec3 vN;\nvoid main() { gl_FragColor = vec4(dFdx(normalize(vN)).x) + gl_FragCoord; }\n"),
              1U)
        << "only what is within the derivative";
    EXPECT_EQ(moved("varying vec3 vM;\nvoid main() { gl_FragColor = vec4(normalize(vM), 1.); }\n"), 0U)
        << "nothing writes it";
    EXPECT_EQ(
        moved("varying vec3 vN;\nvoid main() { vec3 n = vN; n.x = 2.; gl_FragColor = vec4(normalize(n), 1.); }\n"), 0U)
        << "the variable changes";
}

}  // namespace
}  // namespace snell::accuracy::test
