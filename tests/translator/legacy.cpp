// Built-in variables and functions of old versions.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

TEST(GlslLegacy, DeclaresOnlyWhatIsUsed) {
    const Translated t = vertex("void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    EXPECT_TRUE(t.has(Stage::vertex, "uniform mat4 snell_ModelViewProjectionMatrix;"));
    EXPECT_TRUE(t.has(Stage::vertex, "in vec4 snell_Vertex;"));
    EXPECT_FALSE(t.has(Stage::vertex, "snell_Normal"));
    EXPECT_FALSE(t.has(Stage::vertex, "snell_ModelViewMatrix;"));
    EXPECT_FALSE(t.has(Stage::vertex, "gl_Vertex"));
}

TEST(GlslLegacy, ModernShaderStaysButForItsVersion) {
    const std::string text =
        "#version 330 core\n// a comment\nin vec3 vN;\nout vec4 color;\nuniform float uK;\n"
        "#ifdef SHINY\nfloat s = 2.;\n#endif\nvoid main() { color = vec4(normalize(vN) * uK, 1.); }\n";
    const Translated t = translated({{Stage::vertex,
                                      "#version 330 core\nin vec3 aVertex;\nout vec3 vN;\n"
                                      "void main() { vN = aVertex; gl_Position = vec4(aVertex, 1.); }\n"},
                                     {Stage::fragment, text}});
    std::string expected = "#version 450 core" + text.substr(text.find('\n'));
    expected.insert(expected.find("color = vec4(n"), "color = vec4(0.0); ");  // a directive may hide what is written
    EXPECT_EQ(t.text(Stage::fragment), expected);
    EXPECT_TRUE(t.diagnostics.empty());
}

TEST(GlslLegacy, FixedFunctionTransformEqualsTheProduct) {
    const Translated t = vertex("void main() { gl_Position = ftransform(); }");
    EXPECT_TRUE(t.has(Stage::vertex, "gl_Position = (snell_ModelViewProjectionMatrix * snell_Vertex);"));
}

TEST(GlslLegacy, EveryUniformOfTheFixedFunction) {
    const std::string text =
        "varying vec4 c;\nvoid main() {\n"
        "c = gl_LightSource[1].diffuse + gl_FrontMaterial.ambient + gl_BackMaterial.specular + gl_LightModel.ambient\n"
        "+ gl_FrontLightModelProduct.sceneColor + gl_BackLightProduct[2].diffuse + gl_Fog.color + gl_ClipPlane[0]\n"
        "+ gl_TextureEnvColor[1] + gl_EyePlaneS[0] + gl_ObjectPlaneQ[3] + vec4(gl_Point.size + gl_NormalScale);\n"
        "c += gl_ModelViewMatrixInverse[0] + gl_ProjectionMatrixTranspose[1] + gl_TextureMatrixInverse[2][0]\n"
        "+ gl_ModelViewProjectionMatrixInverseTranspose[3] + vec4(gl_NormalMatrix[0], gl_MaxLights);\n"
        "gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;\ngl_Position = ftransform(); }\n";
    expect_valid({{Stage::vertex, text}, {Stage::fragment, "varying vec4 c; void main() { gl_FragColor = c; }"}});
    // Everything declared is something the runtime sets, or has a documented value.
    const Translated t = vertex(text);
    for (const UniformDefault& d : fixed_function_defaults()) EXPECT_FALSE(d.values.empty()) << d.name;
    EXPECT_TRUE(t.has(Stage::vertex, "uniform snell_LightSourceParameters snell_LightSource[8];"));
}

TEST(GlslLegacy, TextureFunctions) {
    const Translated t = fragment(
        "uniform sampler2D a; uniform samplerCube b; uniform sampler3D c; uniform sampler2DShadow s;\n"
        "void main() { gl_FragColor = texture2D(a, vec2(0.)) + textureCube(b, vec3(1.)) + texture3D(c, vec3(0.))\n"
        "+ texture2DProj(a, vec3(1.)) + texture2DLod(a, vec2(0.), 1.) + shadow2D(s, vec3(.5)); }");
    EXPECT_TRUE(t.has(Stage::fragment, "texture(a, vec2(0.)) + texture(b, vec3(1.)) + texture(c, vec3(0.))"));
    EXPECT_TRUE(t.has(Stage::fragment, "textureProj(a, vec3(1.)) + textureLod(a, vec2(0.), 1.)"));
    EXPECT_TRUE(t.has(Stage::fragment, "vec4(texture(s, vec3(.5)))"));
}

// `return(x)` has no blank for what is written between the two.
TEST(GlslLegacy, WordsStayApart) {
    const std::string text =
        "varying float vX;\nfloat f(float x) { if (x > .5) return(1); return(float)0; }\nbool g(int x) { return(x); }\n"
        "int h(float x) { return(x); }\nvoid main() { gl_FragColor = vec4(f(vX), g(h(vX)) ? 1. : 0., 0., 1.); }\n";
    expect_valid({{Stage::fragment, text}});
    EXPECT_TRUE(fragment(text, es300).has(Stage::fragment, "return float("));
}

TEST(GlslLegacy, OwnFunctionOfThatNameStays) {
    const Translated t =
        fragment("vec4 texture2D(float x) { return vec4(x); } void main() { gl_FragColor = texture2D(.5); }");
    EXPECT_TRUE(t.has(Stage::fragment, "texture2D(.5)"));
}

TEST(GlslLegacy, ColorsPassFromStageToStage) {
    const Texts texts = {
        {Stage::vertex,
         "void main() { gl_FrontColor = gl_Color; gl_TexCoord[2] = gl_MultiTexCoord0;\n"
         "gl_FogFragCoord = 1.; gl_Position = ftransform(); }"},
        {Stage::fragment, "void main() { gl_FragColor = gl_Color + gl_TexCoord[2] + gl_FogFragCoord; }"}};
    const Translated t = translated(texts);
    EXPECT_TRUE(t.has(Stage::vertex, "out vec4 snell_TexCoord[3];"));
    EXPECT_TRUE(t.has(Stage::fragment, "in vec4 snell_TexCoord[3];"));
    // The fixed function clamps colours at the vertex.
    EXPECT_TRUE(t.has(Stage::vertex, "snell_FrontColor = clamp(snell_FrontColor, 0.0, 1.0);"));
    EXPECT_FALSE(t.has(Stage::fragment, "gl_FrontFacing"));
    expect_valid(texts);
}

TEST(GlslLegacy, TwoSidedOnlyIfTheBackIsWritten) {
    const Texts texts = {
        {Stage::vertex,
         "void main() { gl_FrontColor = vec4(1.); gl_BackColor = vec4(0.); gl_Position = ftransform(); }"},
        {Stage::fragment, "void main() { gl_FragColor = gl_Color; }"}};
    EXPECT_TRUE(translated(texts).has(Stage::fragment, "gl_FrontFacing ? snell_FrontColor : snell_BackColor"));
    expect_valid(texts);
}

TEST(GlslLegacy, FragmentOutputs) {
    EXPECT_TRUE(fragment("void main() { gl_FragData[2] = vec4(1.); gl_FragData[0] = vec4(0.); }")
                    .has(Stage::fragment, "layout(location = 0) out vec4 snell_FragData[3];"));
    const Translated both =
        fragment("#version 330\nout vec4 mine;\nvoid main() { mine = vec4(1.); gl_FragColor = vec4(.5); }");
    EXPECT_TRUE(both.has(Stage::fragment, "layout(location = 0) out vec4 snell_FragColor;"));
    EXPECT_TRUE(both.has(Stage::fragment, "layout(location = 1) out vec4 mine;"));
    // Three components: alpha would be undefined.
    EXPECT_TRUE(
        fragment("#version 330\nout vec3 c;\nvoid main() { c = vec3(.5); }").has(Stage::fragment, "= vec4(c, 1.0);"));
}

TEST(GlslLegacy, NoiseFunctionsAreOurs) {
    const Texts texts = {
        {Stage::fragment,
         "varying vec3 p; void main() { gl_FragColor = vec4(noise1(p.x), noise2(p), noise3(p.xy).z)\n"
         "+ noise4(vec4(p, 1.)); }"},
        {Stage::vertex, "varying vec3 p; void main() { p = gl_Vertex.xyz; gl_Position = ftransform(); }"}};
    expect_valid(texts);
    EXPECT_TRUE(translated(texts).has(Stage::fragment, "snell_noise3(p.xy)"));
}

// OpenGL leaves smoothstep(a, a, x) undefined. Doubles keep the driver's, and a user's function is the user's.
TEST(GlslLegacy, SmoothstepIsOurs) {
    const auto program = [](std::string_view statements, std::string_view before = "") {
        return Texts{{Stage::fragment, "#version 400 compatibility\n" + std::string(before) + "void main() { " +
                                           std::string(statements) + " }"},
                     {Stage::vertex, "void main() { gl_Position = ftransform(); }"}};
    };
    const Texts ours = program(
        "gl_FragColor = smoothstep(0., 1., vec4(.5)) + smoothstep(vec4(0.), vec4(1.), vec4(.5)) * "
        "smoothstep(0, 1, .5) * smoothstep(vec2(0), vec2(1), vec2(.5)).x;");
    expect_valid(ours);
    EXPECT_TRUE(translated(ours).has(Stage::fragment, "snell_smoothstep(0., 1., vec4(.5))"));
    const Texts doubles = program("double x = smoothstep(0.lf, 1.lf, .5lf); gl_FragColor = vec4(float(x));");
    expect_valid(doubles);
    EXPECT_FALSE(translated(doubles).has(Stage::fragment, "snell_smoothstep"));
    const Texts own = program("gl_FragColor = vec4(smoothstep(.5));", "float smoothstep(float x) { return x; }\n");
    expect_valid(own);
    EXPECT_FALSE(translated(own).has(Stage::fragment, "step(a, x)"));
}

// OpenGL ES has it since version 3.2.
TEST(GlslLegacy, PreciseIsLeftOutWhereItIsUnknown) {
    const Texts texts = {
        {Stage::vertex,
         "#version 400 compatibility\nprecise gl_Position;\nprecise out vec4 a;\nout vec4 b;\n"
         "invariant a, gl_Position;\nprecise a, b;\nvoid main() { precise vec4 c = gl_Vertex * 2.; "
         "a = b = c; gl_Position = ftransform(); }"},
        {Stage::fragment, "#version 400 compatibility\nin vec4 a, b;\nvoid main() { gl_FragColor = a + b; }"}};
    expect_valid(texts, {core450, core410, es320, es300});
    EXPECT_TRUE(translated(texts).has(Stage::vertex, "precise gl_Position;"));
    EXPECT_FALSE(translated(texts, es300).has(Stage::vertex, "precise"));
}

TEST(GlslLegacy, InvariantAndPreciseOfTheSameNamesAreTwoStatements) {
    const Texts texts = {
        {Stage::vertex,
         "#version 420 compatibility\nout vec4 a;\ninvariant precise gl_Position, a;\n"
         "void main() { a = gl_Vertex; gl_Position = ftransform(); }"},
        {Stage::fragment, "#version 420 compatibility\nin vec4 a;\nvoid main() { gl_FragColor = a; }"}};
    expect_valid(texts, {core450, core410, es320, es300});
    EXPECT_TRUE(translated(texts).has(Stage::vertex, "invariant gl_Position, a;precise gl_Position, a;"));
    EXPECT_FALSE(translated(texts, es300).has(Stage::vertex, "precise"));
}

TEST(GlslLegacy, RedeclaredBuiltInsAreDropped) {
    expect_valid(
        {{Stage::vertex,
          "varying vec4 gl_TexCoord[2]; void main() { gl_TexCoord[1] = gl_Vertex; gl_Position = ftransform(); }"},
         {Stage::fragment,
          "varying vec4 gl_TexCoord[2]; out vec4 gl_FragColor; void main() { gl_FragColor = gl_TexCoord[1]; }"}});
}

}  // namespace
}  // namespace snell::glsl::test
