// What statements mean: the display list.
#include "parser/commands/commands.h"
#include "parser/text_of.h"
#include "tests/parser/support.h"
#include "tests/std.h"

namespace snell::test {
namespace {

constexpr Mat4 identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Vec3 transformed(const Mat4& m, const Vec3& p) {
    Vec3 out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i];
    return out;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-14) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

const UniformValue& uniform(const Read& r, std::size_t i) { return r.scene().programs.at(0).uniforms.at(i); }

TEST(Scene, AnEmptyTextHasOnePassAndTheDefaults) {
    const Read r = read("");
    EXPECT_EQ(r.scene().passes.size(), 1u);
    EXPECT_EQ(r.scene().passes[0].kind, Pass::Kind::window);
    EXPECT_EQ(r.scene().window_size, (std::array{600, 600}));
    EXPECT_EQ(r.scene().timer_period, 10);
    EXPECT_TRUE(r.diagnostics().empty());
}

TEST(Scene, WallsShareAUnitOneAfterTheOther) {
    const Read r = read(
        "CubeMap 6 a b c d e f\nTexture2D 6 one.bmp\nQuadYZ 5. 5. 10 10\nTexture2D 6 two.bmp\nQuadYZ -5. 5. 10 10\n");
    const Scene& s = r.scene();
    ASSERT_EQ(s.draws.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& entries = s.bindings[s.draws[i].bindings].entries;
        ASSERT_EQ(entries.size(), 2u) << "a unit holds one texture of each target";
        EXPECT_EQ(entries[0].target, TextureTarget::d2);
        EXPECT_EQ(s.textures[entries[0].texture].files[0].name, i == 0 ? "one.bmp" : "two.bmp");
        EXPECT_EQ(entries[1].target, TextureTarget::cube);
    }
    EXPECT_EQ(std::get<Quad>(s.draws[1].shape).offset, -5);
    EXPECT_EQ(std::get<Quad>(s.draws[1].shape).plane, Plane::yz);
}

TEST(Scene, EqualStatesAreKeptOnce) {
    std::string text;
    for (int i = 0; i < 400; ++i) text += "PushMatrix\nTranslate 1 0 0\nObj tree.obj\nPopMatrix\nColor 1 0 0\n";
    const Read r = read(text);
    EXPECT_EQ(r.scene().draws.size(), 400u);
    EXPECT_EQ(r.scene().matrices.size(), 1u);
    EXPECT_EQ(r.scene().colors.size(), 2u);
    EXPECT_EQ(r.scene().rasters.size(), 1u);
    EXPECT_EQ(r.scene().cameras.size(), 1u);
    EXPECT_EQ(r.scene().bindings.size(), 1u);
    EXPECT_EQ(r.scene().files.size(), 1u);
}

TEST(Scene, TransformationsActLastListedFirst) {
    const Read r = read("Translate 1 2 3\nRotate 90 0 0 1\nScale 2 3 4\nSphere\n");
    expect_near(transformed(r.matrix(0), {1, 0, 0}), {1, 4, 3});
    expect_near(transformed(r.matrix(0), {0, 1, 0}), {-2, 2, 3});
    expect_near(transformed(r.matrix(0), {0, 0, 1}), {1, 2, 7});
}

TEST(Scene, QuarterTurnsAreExact) {
    for (const int angle : {90, -270, 450, 90 + 360 * 1000}) {
        const Read r = read("Rotate " + std::to_string(angle) + " 0 1 0\nSphere\n");
        EXPECT_EQ(transformed(r.matrix(0), {1, 0, 0}), (Vec3{0, 0, -1})) << angle;
    }
    EXPECT_EQ(read("Rotate 90 0 0 5\nRotate 180 0 0 1\nRotate -270 0 0 1\nSphere\n").matrix(0), identity);
}

TEST(Scene, LargeAnglesKeepTheirDigits) {
    const Mat4 large = read("Rotate 1e9 0 0 1\nSphere\n").matrix(0);
    const Mat4 small = read("Rotate 280. 0 0 1\nSphere\n").matrix(0);  // 1e9 mod 360
    EXPECT_EQ(large, small);
}

TEST(Scene, AxesOfAnyLengthAreNormalised) {
    const Mat4 unit = read("Rotate 30 0.6 0.8 0\nSphere\n").matrix(0);
    for (const char* axis : {"6e-31 8e-31 0", "6e30 8e30 0", "3 4 0"}) {
        const Mat4 m = read("Rotate 30 " + std::string(axis) + "\nSphere\n").matrix(0);
        for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(m[i], unit[i], 1e-15) << axis;
    }
    const Read zero = read("Rotate 30 0 0 0\nSphere\n");
    EXPECT_EQ(zero.codes(), Codes{"1:1 zero-axis"});
    EXPECT_EQ(zero.matrix(0), identity);
}

TEST(Scene, FarTranslationsComeBack) {
    const Mat4 m = read("Translate 1e6 0 0\nTranslate .1 0 0\nTranslate -1e6 0 0\nSphere\n").matrix(0);
    EXPECT_NEAR(m[12], .1, 1e-9);
}

TEST(Scene, TransformationsOutsideTheRangeAreRefused) {
    std::string text;
    for (int i = 0; i < 3; ++i) text += "Scale 1e30\n";
    const Read r = read(text + "Sphere\n");
    EXPECT_EQ(r.codes(), (Codes{"2:1 matrix-overflow", "3:1 matrix-overflow"}));
    EXPECT_EQ(r.matrix(0)[0], 1e30);
}

TEST(Scene, TransformationsPersistOverPassesAndPrograms) {
    const Read r = read(
        "Texture2D 6 64 64\nRenderToTexture 6\nPushMatrix\nScale 2\nSphere\nProgram "
        "Foo\nRenderToTexture\nSphere\nPopMatrix\nSphere\n");
    EXPECT_EQ(r.matrix(0)[0], 2);
    EXPECT_EQ(r.matrix(1)[0], 2);
    EXPECT_EQ(r.matrix(2)[0], 1);
    ASSERT_EQ(r.scene().passes.size(), 3u);
    EXPECT_EQ(r.scene().passes[1].units, std::vector<int>{6});
    EXPECT_EQ(r.scene().passes[1].textures, std::vector<Index>{0});
    EXPECT_EQ(r.scene().passes[1].items.size(), 1u);
}

TEST(Scene, RenderToTextureMeansWhatStandsOnTheUnitThen) {
    const Read r = read("Texture2D 6 64 64\nRenderToTexture 6\nTexture2D 6 32 32\nRenderToTexture 6\n");
    EXPECT_EQ(r.scene().passes[1].textures, std::vector<Index>{0});
    EXPECT_EQ(r.scene().passes[2].textures, std::vector<Index>{1});
}

TEST(Scene, RenderToCubeHasACentre) {
    const Read r = read("CubeMap 6 256\nRenderToCube 6 1 2 3\nSphere\nRenderToTexture\nRenderToCube 6\n");
    EXPECT_TRUE(r.diagnostics().empty());
    EXPECT_EQ(r.scene().passes[1].kind, Pass::Kind::cube);
    EXPECT_EQ(r.scene().passes[1].center, (Vec3{1, 2, 3}));
    EXPECT_EQ(r.scene().passes[3].center, (Vec3{0, 0, 0}));
}

TEST(Scene, BackgroundBelongsToItsTarget) {
    const Read r =
        read("Background .5 .5 .5\nTexture2D 6 64 64\nRenderToTexture 6\nBackground 1 0 0 .5\nClear\nSphere\n");
    EXPECT_EQ(r.scene().background, (Vec4{.5, .5, .5, 1}));
    EXPECT_EQ(r.scene().passes[1].background, (Vec4{1, 0, 0, .5}));
    ASSERT_EQ(r.scene().passes[1].items.size(), 2u);
    EXPECT_EQ(r.scene().passes[1].items[0].kind, Item::Kind::clear);
}

TEST(Scene, DrawsUseTheCameraThatStoodThen) {
    const Read r = read(
        "Perspective 70\nSphere\nLookAt 0 0 5 0 0 0 0 1 0\nSphere\nOrtho -1 1 -2 2\nSphere\nLookAt 1 0 0 0 0 0 0 1 "
        "0\nSphere\n");
    const Scene& s = r.scene();
    const auto camera = [&](std::size_t i) { return s.cameras[s.draws[i].camera]; };
    EXPECT_EQ(camera(0).fov, 70);
    EXPECT_FALSE(camera(0).look_at);
    EXPECT_EQ((*camera(1).look_at)[0], (Vec3{0, 0, 5}));
    EXPECT_FALSE(camera(2).perspective);
    EXPECT_EQ(camera(2).ortho, (std::array<double, 4>{-1, 1, -2, 2}));
    EXPECT_EQ((*camera(3).look_at)[0], (Vec3{1, 0, 0})) << "LookAt replaces the one before";
    EXPECT_EQ(r.matrix(3), identity) << "the viewing matrix is not in the model's";
}

TEST(Scene, WrongCamerasFallBackToTheDefault) {
    for (const char* fov : {"0", "-10", "180", "1e30"}) {
        const Read r = read("Perspective " + std::string(fov) + "\nSphere\n");
        EXPECT_EQ(r.codes(), Codes{"1:13 field-of-view-out-of-range"}) << fov;
        EXPECT_EQ(r.scene().cameras[0].fov, 50);
    }
    EXPECT_EQ(read("Perspective .0001\nSphere\n").scene().cameras[0].fov, .0001);
    EXPECT_TRUE(read("Ortho 1 -1 1 -1\nSphere\n").diagnostics().empty()) << "mirrored is allowed";
}

TEST(Scene, ProgramsKeepTheStagesOfTheirTime) {
    const Read r = read(
        "Vertex a.vert\nFragment a.frag\nProgram A\nGeometry g.geom\nFragment b.frag\nProgram B\nGeometry\nProgram "
        "C\n");
    const auto& p = r.scene().programs;
    ASSERT_EQ(p.size(), 3u);
    const auto name = [&](std::size_t i, Stage s) {
        const auto& f = p[i].stages[static_cast<std::size_t>(s)];
        return f ? f->name : "none";
    };
    EXPECT_EQ(name(0, Stage::fragment), "a.frag");
    EXPECT_EQ(name(0, Stage::geometry), "none");
    EXPECT_EQ(name(1, Stage::fragment), "b.frag");
    EXPECT_EQ(name(1, Stage::geometry), "g.geom");
    EXPECT_EQ(name(2, Stage::geometry), "none");
    EXPECT_EQ(name(2, Stage::vertex), "a.vert");
}

TEST(Scene, ChoicesAreSpeltAsInTheTable) {
    const Read r =
        read("GeometryInput GL_TRIANGLES\nGeometryOutput gl_triangle_strip\nProgram P\nGeometryInput\nProgram Q\n");
    EXPECT_TRUE(r.diagnostics().empty());
    EXPECT_EQ(r.scene().programs[0].geometry_input, "gl_triangles");
    EXPECT_EQ(r.scene().programs[0].geometry_output, "gl_triangle_strip");
    EXPECT_EQ(r.scene().programs[1].geometry_input, "");
}

TEST(Scene, UniformsOfEveryKind) {
    const Read r =
        read("Program Foo uA 4 uB [1. 0. 0.] uC <0 5 10> uD <true> uE <0> uF {1 .5 0} uG {1. .5 0. .5} uH <2.5>\n");
    using K = UniformValue::Kind;
    const std::pair<K, std::vector<double>> expected[] = {
        {K::scalar, {4}},  {K::array, {1, 0, 0}},  {K::range, {0, 5, 10}},     {K::boolean, {1}},
        {K::boolean, {0}}, {K::color, {1, .5, 0}}, {K::color, {1, .5, 0, .5}}, {K::scalar, {2.5}}};
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(uniform(r, i).kind, expected[i].first) << i;
        EXPECT_EQ(uniform(r, i).values, expected[i].second) << i;
    }
    EXPECT_TRUE(uniform(r, 0).integral);
    EXPECT_FALSE(uniform(r, 1).integral);
    EXPECT_TRUE(uniform(r, 2).integral);
}

TEST(Scene, SpansOfValuesCoverTheNumbersAlone) {
    const Read r = read("Program Foo uEta<.1 1.1 5.>uMix [ 0., 1. ]\n");
    EXPECT_EQ(r.under(uniform(r, 0).name_span), "uEta");
    EXPECT_EQ(r.under(uniform(r, 0).span), "uEta<.1 1.1 5.>");
    ASSERT_EQ(uniform(r, 0).value_spans.size(), 3u);
    EXPECT_EQ(r.under(uniform(r, 0).value_spans[1]), "1.1");
    EXPECT_EQ(r.under(uniform(r, 1).value_spans[1]), "1.");
}

TEST(Scene, AUniformThatLostItsProgramIsTakenForIt) {
    const Read r = read("Program Magnifier uTexUnit 5\n    uSc <0. .5 1.>\nSphere\n");
    EXPECT_EQ(r.codes(), Codes{"2:5 unknown-command"});
    EXPECT_EQ(r.diagnostics()[0].help, "'Program' on line 1 is not continued: end line 1 with '\\'");
    EXPECT_EQ(uniform(r, 1).name, "uSc");
    EXPECT_EQ(uniform(r, 1).values, (std::vector{0., .5, 1.}));
}

TEST(Scene, WithoutAProgramThereIsNothingToTakeItFor) {
    const Read r = read("uSc <0. .5 1.>\nSphere\n");
    EXPECT_EQ(r.codes(), Codes{"1:1 unknown-command"});
    EXPECT_TRUE(r.scene().programs.empty());
    EXPECT_EQ(r.scene().draws.size(), 1u);
}

TEST(Scene, ElementsOfArraysOfUniforms) {
    const Read r = read("Program Foo uLight[1] [1 2 3] uOther [4]\n");
    EXPECT_TRUE(r.diagnostics().empty());
    EXPECT_EQ(uniform(r, 0).name, "uLight[1]");
    EXPECT_EQ(uniform(r, 0).values, (std::vector{1., 2., 3.}));
    EXPECT_EQ(uniform(r, 1).values, std::vector{4.});
}

TEST(Scene, TwoStageNumbersGiveTheRangeItsEnds) {
    const Read r = read("Program Foo uA <.25 1.>\n");
    EXPECT_EQ(uniform(r, 0).values, (std::vector{.25, .25, 1.}));
    const Span missing = uniform(r, 0).value_spans[1];
    EXPECT_EQ(missing.begin, missing.end) << "a number that is not in the text has an empty span";
}

TEST(Scene, TorusIsListedAsItIsWritten) {
    const Read r = read("Torus .2 1. 12 30\nTorus 1. .2\n");
    EXPECT_EQ(text_of::shape(r.scene(), r.scene().draws[0].shape, false), "Torus 0.2 1. 12 30");
    EXPECT_EQ(text_of::shape(r.scene(), r.scene().draws[1].shape, false), "Torus 1. 0.2 20 40");
}

TEST(Scene, TrianglesHaveTheNormalOfTheirPlane) {
    const Read r = read("Triangles [0 0 0] [2e-20 0 0] [0 0 2e-20]\nTriangles [0 0 0] [0 0 0] [1 1 1]\n");
    EXPECT_EQ(r.scene().vertex_lists[0].vertices[0].normal, (Vec3{0, -1, 0}));
    EXPECT_EQ(r.scene().vertex_lists[1].vertices[0].normal, (Vec3{0, 0, 1}));
}

TEST(Scene, VertexListsHaveTheStateOfEachVertex) {
    const Read r = read(
        "Color 1 0 0\nNumPatchVertices 4\nglBegin gl_patches\nglVertex 1 2\nglNormal 0 1 0\nglColor 0 1 0\nglTexCoord "
        ".5 .25\nglVertex 1 2 3 4\nglEnd\nSphere\n");
    EXPECT_TRUE(r.diagnostics().empty());
    const VertexListData& list = r.scene().vertex_lists.at(0);
    EXPECT_EQ(list.topology, Topology::patches);
    EXPECT_EQ(list.patch_vertices, 4);
    EXPECT_TRUE(list.has_color);
    ASSERT_EQ(list.vertices.size(), 2u);
    EXPECT_EQ(list.vertices[0].position, (Vec4{1, 2, 0, 1}));
    EXPECT_EQ(list.vertices[0].color, (Vec4{1, 0, 0, 1})) << "what stood at glBegin";
    EXPECT_EQ(list.vertices[1].position, (Vec4{1, 2, 3, 4}));
    EXPECT_EQ(list.vertices[1].normal, (Vec3{0, 1, 0}));
    EXPECT_EQ(list.vertices[1].texcoord, (Vec3{.5, .25, 0}));
    EXPECT_EQ(r.scene().colors[r.scene().draws[1].color], (Vec4{0, 1, 0, 1})) << "glColor outlives its list";
}

TEST(Scene, RasterStateIsThatOfTheStatement) {
    const Read r = read(
        "Sphere\nBlend one zero\nCullFace back\nDepthTest off\nDepthWrite off\nWireframe "
        "on\nFlat\nClamp\nPointSizeMode 1\nLineWidth 3\nPointSize 4\nSphere\nBlend off\nSmooth\nSphere\n");
    EXPECT_TRUE(r.diagnostics().empty());
    const auto raster = [&](std::size_t i) { return r.scene().rasters[r.scene().draws[i].raster]; };
    EXPECT_EQ(raster(0), RasterState{});
    RasterState all;
    all.src = BlendFactor::one;
    all.dst = BlendFactor::zero;
    all.cull = CullFace::back;
    all.depth_test = all.depth_write = false;
    all.wireframe = all.flat = all.clamp = all.point_size_mode = true;
    all.line_width = 3;
    all.point_size = 4;
    EXPECT_EQ(raster(1), all);
    EXPECT_FALSE(raster(2).blend);
    EXPECT_FALSE(raster(2).flat);
}

TEST(Scene, FiltersHoldForTexturesNamedAfterThem) {
    const Read r = read("Texture2D 5 a.bmp\nFilter anisotropic 8\nTexture2D 6 b.bmp\nFilter nearest\nCubeMap 7 64\n");
    EXPECT_EQ(r.scene().textures[0].filter, Filter{});
    EXPECT_EQ(r.scene().textures[1].filter, (Filter{Filter::Mode::anisotropic, 8}));
    EXPECT_EQ(r.scene().textures[2].filter, (Filter{Filter::Mode::nearest, 1}));
}

TEST(Scene, FileNamesUseSlashes) {
    const Read r = read(
        "Vertex \"my shaders\\a b.vert\"\nTexture2D 5 tex\\\\wall.bmp\nTexture2D 6 a,b[1].bmp\nProgram P\nObj "
        "dir\\x.obj\n");
    EXPECT_EQ(r.scene().programs[0].stages[0]->name, "my shaders/a b.vert");
    EXPECT_EQ(r.scene().textures[0].files[0].name, "tex/wall.bmp");
    EXPECT_EQ(r.scene().textures[1].files[0].name, "a,b[1].bmp");
    EXPECT_EQ(r.scene().files[0].name, "dir/x.obj");
}

TEST(Scene, MessagesAreUtf8) {
    const Read r = read("MessageBox sch\xF6n, \"ja\"\nMessageBox \"two words\"\nMessageBox one \\\n two\nMessageBox\n");
    ASSERT_EQ(r.scene().messages.size(), 4u);
    EXPECT_EQ(r.scene().messages[0].text, "sch\xC3\xB6n, \"ja\"");
    EXPECT_EQ(r.scene().messages[1].text, "two words");
    EXPECT_EQ(r.scene().messages[2].text, "one two");
    EXPECT_EQ(r.scene().messages[3].text, "");
}

TEST(Scene, FileNamesSayWhichIncludedSceneNamesThem) {
    const IncludeReader reader = [](std::string_view, std::string_view) -> std::optional<IncludedText> {
        return IncludedText{"far/room.glib", "Vertex a.vert\nTexture2D 5 a.png\nObj a.obj\nProgram P\n"};
    };
    Sources sources;
    const FileId file = sources.add("main.glib", "Include room\nTexture2D 6 a.png\nObj a.obj\n");
    const Scene scene = parse(file, sources, reader).scene;
    EXPECT_EQ(scene.programs.at(0).stages[0]->from, "far/room.glib");
    EXPECT_EQ(scene.textures.at(0).files.at(0).from, "far/room.glib");
    EXPECT_EQ(scene.textures.at(1).files.at(0).from, "");
    ASSERT_EQ(scene.files.size(), 2U) << "one name, two files";
    EXPECT_EQ(scene.files[0].from, "far/room.glib");
    EXPECT_EQ(scene.files[1].from, "");
}

TEST(Scene, StateGoesIntoIncludedTextAndBack) {
    const IncludeReader reader = [](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        if (name == "missing.glib") return std::nullopt;
        if (name == "loop.glib") return IncludedText{"loop.glib", "Include loop.glib\nTeapot\n"};
        EXPECT_EQ(from, "scene.glib");
        return IncludedText{"dir/" + std::string(name), "Sphere\nTranslate 1 0 0\nFoo\n"};
    };
    const Read r = read("Scale 2\nInclude part.glib\nBox\nInclude missing.glib\nInclude loop.glib\n", reader);
    ASSERT_EQ(r.scene().draws.size(), 3u);
    EXPECT_EQ(r.matrix(0)[0], 2);
    EXPECT_EQ(r.matrix(1)[12], 2);
    EXPECT_EQ(r.codes(), (Codes{"4:1 include-not-found", "3:1 unknown-command", "1:1 include-cycle"}));
    EXPECT_EQ(r.sources.name(r.diagnostics()[1].span.file), "dir/part.glib");
}

TEST(Scene, AFaultyTextThatIsIncludedAgainIsFaultyOnce) {
    const IncludeReader reader = [](std::string_view, std::string_view name) {
        return IncludedText{std::string(name), "Foo\nSphere 1 2 3 4\nFoo\n"};
    };
    const Read r = read("Include a.inc\nInclude b.inc\nInclude a.inc\n", reader);
    EXPECT_EQ(r.scene().draws.size(), 3u) << "it is drawn each time";
    const Codes one{"1:1 unknown-command", "2:14 surplus-arguments", "3:1 unknown-command"};
    Codes both = one;
    both.insert(both.end(), one.begin(), one.end());
    EXPECT_EQ(r.codes(), both) << "once of each file";
}

TEST(Scene, IncludesAreLimitedInDepth) {
    int count = 0;
    const IncludeReader reader = [&](std::string_view, std::string_view) {
        return IncludedText{"file" + std::to_string(++count), "Include next\n"};
    };
    const Read r = read("Include first\n", reader);
    ASSERT_EQ(r.diagnostics().size(), 1u);
    EXPECT_EQ(r.diagnostics()[0].code, "include-too-deep");
    EXPECT_EQ(count, Limits{}.include_depth);
}

TEST(Scene, AnErrorHidesNoOther) {
    const Read r = read("Foo\nSphere nan\nBar\nRotate 1 0 0 0\nObj\nProgram P uA <?> uB <nan 0 1>\nSphere\n");
    EXPECT_EQ(r.codes(), (Codes{"1:1 unknown-command", "2:8 not-finite", "3:1 unknown-command", "4:1 zero-axis",
                                "5:1 missing-argument", "6:14 unfilled-template", "6:22 not-finite"}));
    EXPECT_EQ(r.scene().draws.size(), 1u);
}

}  // namespace
}  // namespace snell::test
