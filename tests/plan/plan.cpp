// What a scene and its files come to before anything is drawn.
#include "src/plan/plan.h"
#include "src/plan/texts.h"
#include "tests/plan/uniforms.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

Span span_at(std::uint32_t begin) { return {0, begin, begin + 5}; }

// A scene in a folder of its own, made by hand.
class Planning : public testing::Test {
protected:
    Index draw(Shape shape, bool wire = false) {
        Draw made;
        made.shape = shape;
        made.wire = wire;
        made.span = span_at(static_cast<std::uint32_t>(100 + scene.draws.size()));
        scene.draws.push_back(made);
        return static_cast<Index>(scene.draws.size() - 1);
    }
    Shape obj(const std::string& name, ObjAs as = ObjAs::triangles) {
        scene.files.push_back({name, span_at(static_cast<std::uint32_t>(1000 + scene.files.size()))});
        return ObjFile{static_cast<Index>(scene.files.size() - 1), as};
    }
    Index texture(int unit, TextureTarget target, const std::vector<std::string>& names) {
        Texture made;
        made.unit = unit;
        made.target = target;
        made.span = span_at(static_cast<std::uint32_t>(2000 + 100 * scene.textures.size()));
        for (const std::string& name : names) {
            made.files.push_back({name, span_at(made.span.begin + 10 * static_cast<std::uint32_t>(made.files.size()))});
        }
        scene.textures.push_back(made);
        return static_cast<Index>(scene.textures.size() - 1);
    }
    void program(const std::string& name, const std::string& vertex, const std::string& fragment) {
        Program made;
        made.name = name;
        made.span = span_at(static_cast<std::uint32_t>(5000 + 100 * scene.programs.size()));
        const auto set = [&](Stage stage, const std::string& file, std::uint32_t at) {
            if (!file.empty()) made.stages[static_cast<std::size_t>(stage)] = FileName{file, span_at(at)};
        };
        set(Stage::vertex, vertex, made.span.begin + 10);
        set(Stage::fragment, fragment, made.span.begin + 20);
        scene.programs.push_back(made);
    }
    Plan plan() {
        if (sources.size() == 0) sources.add("scene.glib", std::string(8000, ' '));
        return make_plan(scene, files, sources, diagnostics);
    }

    Scratch folder;
    Files files{folder.path()};
    Sources sources;
    Diagnostics diagnostics;
    Scene scene;
};

TEST_F(Planning, EqualMeshesAreOne) {
    folder.write("cow.obj", "x");
    for (int i = 0; i < 400; ++i) draw(obj("cow.obj"));
    draw(Sphere{1, 60, 60});
    draw(Sphere{2, 60, 60});
    draw(Sphere{1, 60, 60});
    draw(Sphere{1, 60, 60}, true);
    draw(obj("cow.obj", ObjAs::adjacency));
    draw(Cone{1, 1, 60, 1});
    draw(Cylinder{1, 1, 60, 1});
    draw(VertexList{0});
    draw(VertexList{1});
    const Plan made = plan();
    EXPECT_EQ(made.meshes.size(), 9U);
    ASSERT_EQ(made.draw_mesh.size(), scene.draws.size());
    EXPECT_EQ(made.draw_mesh[0], made.draw_mesh[399]);
    EXPECT_EQ(made.draw_mesh[400], made.draw_mesh[402]);
    EXPECT_NE(made.draw_mesh[400], made.draw_mesh[401]);
    EXPECT_NE(made.draw_mesh[400], made.draw_mesh[403]);
    EXPECT_EQ(made.meshes[made.draw_mesh[400]].span, scene.draws[400].span);
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(files.counters().opened, 0U) << "meshes are read when drawn";
}

TEST_F(Planning, SharedShaderIsReadOnce) {
    folder.write("a.vert", "void main() {}");
    folder.write("a.frag", "one");
    folder.write("b.frag", "two");
    program("A", "a.vert", "a.frag");
    program("B", "a.vert", "b.frag");
    program("C", "A.vert", "b.frag");
    const Plan made = plan();
    ASSERT_EQ(made.programs.size(), 3U);
    EXPECT_EQ(files.counters().opened, 3U);
    EXPECT_EQ(sources.size(), 4U);
    EXPECT_EQ(made.programs[0].stages.at(0).file, made.programs[2].stages.at(0).file);
    EXPECT_EQ(sources.text(made.programs[0].stages.at(1).file), "one");
    EXPECT_EQ(sources.name(made.programs[0].stages.at(0).file), folder.path("a.vert"));
    EXPECT_EQ(made.programs[0].stages.at(1).stage, Stage::fragment);
    EXPECT_EQ(made.programs[1].stages.at(1).reference, scene.programs[1].stages[4]->span);
    for (const PlannedProgram& planned : made.programs) EXPECT_TRUE(planned.readable);
    ASSERT_EQ(codes_of(diagnostics), Codes{"file-inexact"});
    EXPECT_EQ(diagnostics.items()[0].severity, Severity::warning);
    EXPECT_EQ(diagnostics.items()[0].span, scene.programs[2].stages[0]->span);
}

TEST_F(Planning, UsualExtensionsOfTheStage) {
    folder.write("light.vert", "v");
    folder.write("light.frag", "f");
    program("A", "light", "light");
    const Plan made = plan();
    EXPECT_EQ(sources.text(made.programs[0].stages.at(0).file), "v");
    EXPECT_EQ(sources.text(made.programs[0].stages.at(1).file), "f");
    EXPECT_EQ(codes_of(diagnostics), (Codes{"file-inexact", "file-inexact"}));
}

// Every line of them would be an error, and the window would show them in place of the scene that is open.
TEST_F(Planning, AFileOfAnotherKindIsOneError) {
    using std::string_literals::operator""s;
    const std::pair<std::string, const char*> kinds[] = {
        {"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s, "a picture (PNG)"},
        {"\xff\xd8\xff\xe0\0\x10JFIF"s, "a picture (JPEG)"},
        {"PK\x03\x04\x14\0\0\0"s, "an archive (ZIP)"},
        {"# Blender\n\nmtllib a.mtl\no Cube\nv 1 2 3\n", "a model (OBJ)"},
        {"#\nv 1 2 3\nf 1 1 1\n", "a model (OBJ)"},
        {"<!DOCTYPE html>\n<title>404</title>\n", "a web page (HTML)"},
        {"\x7f"
         "ELF\2\1\1\0\0\0\0\0\0\0\0\0\3"s,
         "a binary file"},
    };
    for (const auto& [bytes, kind] : kinds) {
        folder.write("s.glib", bytes);
        Diagnostics found;
        EXPECT_FALSE(parse_document(folder.path("s.glib"), files, sources, found)) << kind;
        ASSERT_EQ(found.items().size(), 1U) << kind;
        EXPECT_EQ(found.items()[0].code, "scene-unreadable");
        EXPECT_TRUE(found.items()[0].message.ends_with("': it is "s + kind + ", not a scene"))
            << found.items()[0].message;
        folder.write("sky.png", bytes);
        folder.write("s.glib", "Include sky.png\nSphere 1\n");
        Diagnostics included;
        EXPECT_TRUE(parse_document(folder.path("s.glib"), files, sources, included)) << "the rest is drawn";
        ASSERT_EQ(included.items().size(), 1U) << kind;
        EXPECT_NE(included.items()[0].message.find(kind), std::string::npos) << included.items()[0].message;
    }
    // A mistake in a scene, and what has an error of its own.
    for (const std::string& text : {""s, "Sphere 1\nBox foo\0\n"s, "\xff\xfeS\0p\0h\0e\0r\0e\0"s, "s\n"s, "# v\n"s}) {
        folder.write("s.glib", text);
        Diagnostics found;
        EXPECT_TRUE(parse_document(folder.path("s.glib"), files, sources, found)) << text;
    }
}

TEST_F(Planning, AnIncludedSceneOfAnotherNameIsSaidLikeAnyFile) {
    folder.write("parts/b.inc", "Include C.inc\nInclude D.inc\nSphere 1\n");
    folder.write("d.inc", "");  // next to the scene
    folder.write("parts/c.inc", "Torus\n");
    const std::string text = "Include parts/B.inc\nInclude parts/b\nInclude parts/c.inc\n";
    folder.write("s.glib", text);
    const auto parsed = parse_document(folder.path("s.glib"), files, sources, diagnostics);
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->scene.draws.size(), 5U);
    std::vector<std::string> said;
    for (const Diagnostic& one : diagnostics.items()) {
        EXPECT_EQ(one.code, "file-inexact") << one.message;
        EXPECT_EQ(one.severity, Severity::warning);
        ASSERT_EQ(one.fixes.size(), 1U);
        EXPECT_EQ(one.fixes[0].span, one.span);
        const std::string_view written = sources.text(one.span.file);
        said.push_back(std::string(written.substr(one.span.begin, one.span.end - one.span.begin)) + " " +
                       one.fixes[0].text);
    }
    std::sort(said.begin(), said.end());
    EXPECT_EQ(said, (std::vector<std::string>{"C.inc c.inc", "D.inc d.inc", "parts/B.inc parts/b.inc",
                                              "parts/b parts/b.inc"}))
        << "once, however often the text that says it is included";
    // The same words as of any other file.
    program("A", "parts/B.inc", "");
    Diagnostics of_shader;
    make_plan(scene, files, sources, of_shader);
    ASSERT_EQ(of_shader.items().size(), 1U);
    const auto same = [&](const Diagnostic& one) {
        return one.message == of_shader.items()[0].message && one.help == of_shader.items()[0].help;
    };
    EXPECT_TRUE(std::any_of(diagnostics.items().begin(), diagnostics.items().end(), same));
}

TEST_F(Planning, MissingShaderIsSaidOnceAtItsPlace) {
    folder.write("reflect.vert", "v");
    program("A", "reflct.vert", "no.frag");
    scene.programs.push_back(scene.programs[0]);  // the stages stay current for later programs
    const Plan made = plan();
    EXPECT_FALSE(made.programs[0].readable);
    EXPECT_FALSE(made.programs[1].readable);
    ASSERT_EQ(codes_of(diagnostics), (Codes{"file-not-found", "file-not-found"}));
    EXPECT_TRUE(diagnostics.has_errors());
    EXPECT_EQ(diagnostics.items()[0].span, scene.programs[0].stages[0]->span);
    EXPECT_NE(diagnostics.items()[0].help.find("'reflect.vert'"), std::string::npos);
}

TEST_F(Planning, ProgramWithoutShaders) {
    program("A", "", "");
    const Plan made = plan();
    EXPECT_TRUE(made.programs[0].readable);
    EXPECT_TRUE(made.programs[0].stages.empty());
    EXPECT_EQ(codes_of(diagnostics), Codes{"program-without-shaders"});
    EXPECT_EQ(diagnostics.items()[0].span, scene.programs[0].span);
}

TEST_F(Planning, TexturesAreOnlyLookedFor) {
    folder.write("wall.bmp", "not read");
    for (const char* end : {"posx", "negx", "posy", "negy", "posz", "negz"}) {
        folder.write(std::string("room_") + end + ".bmp", "not read");
    }
    texture(6, TextureTarget::d2, {"wall.bmp"});
    texture(7, TextureTarget::d2, {"Wall.bmp"});
    texture(6, TextureTarget::cube, {"room.bmp"});
    texture(8, TextureTarget::d2, {});
    texture(9, TextureTarget::d2, {"wal.bmp"});
    texture(5, TextureTarget::d1, {"wall.bmp"});
    const Plan made = plan();
    EXPECT_EQ(files.counters().opened, 0U);
    EXPECT_EQ(codes_of(diagnostics), (Codes{"file-inexact", "file-not-found"}));
    EXPECT_EQ(diagnostics.items()[1].span, scene.textures[4].files[0].span);
    EXPECT_EQ(diagnostics.items()[1].severity, Severity::error);
    EXPECT_EQ(made.same_pixels, (std::vector<Index>{0, 0, 2, 3, 4, 5})) << "1D and 2D are not the same texture";
}

TEST_F(Planning, MissingFaceIsNamed) {
    for (const char* end : {"posx", "negx", "posy", "posz", "negz"}) {
        folder.write(std::string("room_") + end + ".bmp", "x");
    }
    texture(6, TextureTarget::cube, {"room.bmp"});
    plan();
    ASSERT_EQ(codes_of(diagnostics), Codes{"file-not-found"});
    EXPECT_NE(diagnostics.items()[0].message.find("room_negy.bmp"), std::string::npos);
}

TEST_F(Planning, MissingMeshFileIsSaidOnce) {
    for (int i = 0; i < 20; ++i) draw(obj("cow.obj"));
    const Plan made = plan();
    EXPECT_EQ(codes_of(diagnostics), Codes{"file-not-found"});
    EXPECT_TRUE(load_mesh(made, 0, files, diagnostics).positions.empty());
    EXPECT_EQ(diagnostics.errors(), 1U) << "loading does not repeat it";
}

// 36 balls without their image are one mistake.
TEST_F(Planning, AMissingFileOfManyStatementsIsOneError) {
    const FileId text = sources.add("s.glib", "a b\na b\na b\na b\n");
    const auto at = [&](std::uint32_t line, bool mesh) {
        const std::uint32_t begin = 4 * line + (mesh ? 0 : 2);
        return Span{text, begin, begin + 1};
    };
    for (const std::uint32_t line : {2U, 0U, 3U}) {
        draw(obj("cow.obj"));
        scene.files.back().span = at(line, true);
        texture(static_cast<int>(line), TextureTarget::d2, {"cow.bmp"});
        scene.textures.back().files[0].span = at(line, false);
    }
    const Plan made = plan();
    ASSERT_EQ(codes_of(diagnostics), (Codes{"file-not-found", "file-not-found"}));
    for (const Diagnostic& d : diagnostics.items()) {
        EXPECT_EQ(sources.position(text, d.span.begin).line, 1) << "at the first place";
        EXPECT_NE(render(d, sources).find("also on lines 3 and 4\n"), std::string::npos) << render(d, sources);
    }
    for (Index i = 0; i < 3; ++i) {
        load_mesh(made, made.draw_mesh[i], files, diagnostics);
        load_texture(made.scene, i, files, diagnostics);
    }
    EXPECT_EQ(diagnostics.errors(), 2U) << "loading repeats none of the places";
}

// A face that is missing was not meant to be the one beside it.
TEST_F(Planning, TheOtherFacesAreNotSuggested) {
    for (const char* end : {"posx", "negx", "posy", "posz", "negz"}) folder.write(std::string(end) + ".bmp", "x");
    texture(6, TextureTarget::cube, {"posx.bmp", "negx.bmp", "posy.bmp", "negy.bmp", "posz.bmp", "negz.bmp"});
    plan();
    ASSERT_EQ(codes_of(diagnostics), Codes{"file-not-found"});
    EXPECT_EQ(diagnostics.items()[0].help, "");
}

TEST_F(Planning, AFaceAloneIsNoSlipForAnother) {
    for (const char* end : {"posx", "negx", "posz", "sky-front"}) folder.write(std::string(end) + ".png", "x");
    for (const char* asked : {"posy.png", "negz.png", "sky-back.png"}) {
        SCOPED_TRACE(asked);
        diagnostics = {};
        scene = {};
        texture(6, TextureTarget::d2, {asked});
        plan();
        ASSERT_EQ(codes_of(diagnostics), Codes{"file-not-found"});
        EXPECT_EQ(diagnostics.items()[0].help, "");
    }
    diagnostics = {};
    scene = {};
    texture(6, TextureTarget::d2, {"possx.png"});
    plan();
    EXPECT_EQ(diagnostics.items().at(0).help, "did you mean 'posx.png'?");
}

TEST_F(Planning, MissingFacesAreOneError) {
    const std::vector<std::string> six{"px.bmp", "nx.bmp", "py.bmp", "ny.bmp", "pz.bmp", "nz.bmp"};
    folder.write("px.bmp", "x");
    folder.write("sky/ny.bmp", "x");
    const Index sky = texture(6, TextureTarget::cube, six);
    const Plan made = plan();
    ASSERT_EQ(codes_of(diagnostics), Codes{"file-not-found"});
    const Diagnostic& said = diagnostics.items()[0];
    EXPECT_EQ(said.message,
              "there are no files 'nx.bmp', 'py.bmp', 'ny.bmp', 'pz.bmp', 'nz.bmp' for faces of the cube map");
    EXPECT_EQ(said.help, "did you mean 'sky/ny.bmp' and so on?");
    EXPECT_EQ(said.span, scene.textures[sky].files[1].span);
    load_cube(made.scene, sky, files, diagnostics);
    const auto codes = codes_of(diagnostics);
    EXPECT_EQ(std::count(codes.begin(), codes.end(), "file-not-found"), 1) << "loading repeats none of the faces";
    texture(7, TextureTarget::cube, {"px.bmp", "wall.bmp", "px.bmp", "px.bmp", "px.bmp", "px.bmp"});
    diagnostics = {};
    plan();
    EXPECT_EQ(diagnostics.items().back().message, "there is no file 'wall.bmp'");
}

// glman leaves its noise beside scenes, and some name it.
TEST_F(Planning, NoiseThatAFileWouldHoldIsMade) {
    const Index deep = texture(6, TextureTarget::d3, {"noise3d.016.tex"});
    const Index flat = texture(7, TextureTarget::d2, {"textures\\Noise2D.032.tex"});
    texture(8, TextureTarget::d2, {"noise3d.016.tex"});
    texture(9, TextureTarget::d3, {"noise3d.9999.tex"});
    const Plan made = plan();
    EXPECT_EQ(codes_of(diagnostics), (Codes{"file-not-found", "file-not-found"})) << "of another kind, and too large";
    diagnostics = {};
    EXPECT_EQ(load_texture(made.scene, deep, files, diagnostics).pixels, load_noise(3, 16, files, diagnostics).pixels);
    EXPECT_EQ(load_texture(made.scene, flat, files, diagnostics).pixels, load_noise(2, 32, files, diagnostics).pixels);
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_NE(texture_identity(made.scene, deep, files).key, "");
    EXPECT_NE(texture_identity(made.scene, deep, files).key, texture_identity(made.scene, flat, files).key);
}

TEST_F(Planning, DisplayListFindsTextureOfLaterStatements) {
    const Index first = texture(6, TextureTarget::d2, {"a"}), second = texture(6, TextureTarget::d2, {"b"});
    const Index cube = texture(6, TextureTarget::cube, {"c"});
    scene.bindings = {{}, {{{6, TextureTarget::d2, first}}}};
    Draw bare, bound;
    bare.bindings = 0;
    bound.bindings = 1;
    EXPECT_EQ(find_texture(scene, bare, 6, TextureTarget::d2), second) << "the last one, as when drawn again";
    EXPECT_EQ(find_texture(scene, bound, 6, TextureTarget::d2), first);
    EXPECT_EQ(find_texture(scene, bound, 6, TextureTarget::cube), cube) << "both stand on one unit";
    EXPECT_EQ(find_texture(scene, bound, 5, TextureTarget::d2), none);
    EXPECT_EQ(find_texture(scene, Draw{}, 6, TextureTarget::d3), none);
}

TEST_F(Planning, FeedbackNamesBothStatements) {
    const Index target = texture(6, TextureTarget::d2, {}), other = texture(7, TextureTarget::d2, {});
    const Index index = draw(Sphere{});
    scene.passes.resize(2);
    scene.passes[1].kind = Pass::Kind::textures;
    scene.passes[1].textures = {target};
    scene.passes[1].span = span_at(700);
    EXPECT_FALSE(feedback_error(scene, 1, index, other));
    EXPECT_FALSE(feedback_error(scene, 0, index, target));
    EXPECT_FALSE(feedback_error(scene, 9, index, target));
    const auto error = feedback_error(scene, 1, index, target);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->severity, Severity::error);
    EXPECT_EQ(error->span, scene.draws[index].span);
    ASSERT_FALSE(error->notes.empty());
    EXPECT_EQ(error->notes[0].span, scene.passes[1].span);
}

TEST_F(Planning, DumpNamesEverything) {
    folder.write("a.vert", "v");
    folder.write("a.frag", "f");
    program("Glass Ball", "a.vert", "a.frag");
    draw(Sphere{1.5, 20, 10});
    draw(Torus{}, true);
    draw(Quad{Plane::xz, -5, 5, 2, 3});
    scene.draws[0].program = 0;
    texture(6, TextureTarget::cube, {"room.bmp"});
    scene.passes.resize(1);
    for (Index i = 0; i < 3; ++i) scene.passes[0].items.push_back({Item::Kind::draw, i});
    scene.passes[0].items.push_back({Item::Kind::clear, 0});
    const std::string text = dump_plan(plan(), sources);
    for (const char* part : {"Glass Ball", "a.frag", "Sphere 1.5 20 10", "WireTorus 1. 0.5", "QuadXZ -5. 5. 2 3",
                             "room.bmp", "pass 0 to window", "draw 1 mesh 1 program built-in", "clear"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    }
}

}  // namespace
}  // namespace snell
