// Changes of the scene's text, with the exact text that they make.
#include "src/plan/locate.h"
#include "tests/accuracy/found_help.h"

namespace snell::accuracy {

namespace fs = std::filesystem;

const Change* Found::at(ChangeKind kind, std::size_t n) const {
    for (const Change& change : changes)
        if (change.kind == kind && n-- == 0) return &change;
    return nullptr;
}

std::vector<std::string> Found::after(ChangeKind kind) const {
    std::vector<std::string> all;
    for (const Change& change : changes)
        if (change.kind == kind) all.push_back(change.after);
    return all;
}

std::string Found::text(ChangeKind kind, std::size_t n, std::string_view file) const {
    const Change* change = at(kind, n);
    if (!change) return "";
    std::string error;  // as everybody gets the text: by the change's number
    const auto chosen = choose_changes(std::to_string(change - changes.data() + 1), changes, sources, error);
    if (!chosen) return error;
    const Change* only = &chosen->changes.front();
    for (const auto& [path, text] : changed_texts(std::span(&only, 1), sources))
        if (fs::path(path).filename() == file) return text;
    return "";
}

Found found_in(const std::string& path, Finder finder,
               std::shared_ptr<const std::map<std::string, std::string>> instead) {
    Found found;
    Access access;
    access.instead = std::move(instead);
    found.files = std::make_unique<Files>(fs::path(path).parent_path().string(), access);
    const auto include = [&](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        std::string error;
        const std::string at = found.files->resolve_beside(from, name, scene_extensions()).path;
        auto text = found.files->read(at, error);
        return text ? std::optional(IncludedText{at, *text}) : std::nullopt;
    };
    std::string error;
    const FileId file = found.sources.add(path, found.files->read(path, error).value_or(""));
    Parsed parsed = parse(file, found.sources, include);
    found.diagnostics = std::move(parsed.diagnostics);
    found.plan = make_plan(std::move(parsed.scene), *found.files, found.sources, found.diagnostics);
    if (finder) finder({found.plan, *found.files, found.sources}, found.changes);
    return found;
}

Found found_in_text(const Scratch& folder, std::string_view scene, const std::vector<NamedText>& others,
                    Finder finder) {
    for (const NamedText& other : others) folder.write(other.name, other.text);
    return found_in(folder.write("scene.glib", scene), finder);
}

std::vector<std::string> all_scenes() {
    std::vector<std::string> all;
    for (const char* folder : {"scenes", "tests/cases", "tests/bad", "tests/odd"})
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".glib") all.push_back(entry.path().string());
    std::sort(all.begin(), all.end());
    return all;
}

namespace {

void expect_sound(const std::string& path, const Found& found, const Change& change) {
    const std::string place = path + ", " + std::string(facts(change.kind).name) + ": " + change.after;
    ASSERT_FALSE(change.edits.empty()) << place;
    const Change* one = &change;
    const auto texts = changed_texts(std::span(&one, 1), found.sources);
    for (std::size_t i = 0; i < change.edits.size(); ++i) {
        const Edit& edit = change.edits[i];
        ASSERT_LE(edit.span.begin, edit.span.end) << place;
        ASSERT_LE(edit.span.end, found.sources.text(edit.span.file).size()) << place;
        ASSERT_TRUE(fs::exists(found.sources.name(edit.span.file))) << place;
        EXPECT_NE(found.sources.text(edit.span.file).substr(edit.span.begin, edit.span.end - edit.span.begin),
                  edit.text)
            << place;
        if (i == 0 || change.edits[i - 1].span.file != edit.span.file) continue;
        EXPECT_LE(change.edits[i - 1].span.end, edit.span.begin) << place;
    }
    const Found after = found_in(path, nullptr, std::make_shared<const std::map<std::string, std::string>>(texts));
    for (FileId file = 0; file < after.sources.size(); ++file)
        if (const auto text = texts.find(std::string(after.sources.name(file))); text != texts.end()) {
            EXPECT_EQ(after.sources.text(file), text->second) << place;
        }
    EXPECT_LE(after.diagnostics.errors(), found.diagnostics.errors())
        << place << "\n"
        << render(after.diagnostics, after.sources) << "\n"
        << texts.begin()->second;
}

}  // namespace

void expect_sound(Finder finder) {
    for (const std::string& path : all_scenes()) {
        const Found found = found_in(path, finder);
        std::set<std::string> texts;
        for (const Change& change : found.changes) {
            expect_sound(path, found, change);
            const Change* one = &change;
            std::string text;
            for (const auto& [name, made] : changed_texts(std::span(&one, 1), found.sources)) text += name + made;
            EXPECT_TRUE(texts.insert(text).second) << path << ": two changes are equal: " << change.after;
        }
    }
}

namespace {

using Afters = std::vector<std::string>;

constexpr std::string_view waves =
    "void main() { vec4 v = gl_Vertex; v.z = sin(v.x); gl_Position = gl_ModelViewProjectionMatrix * v; }\n";
constexpr std::string_view fragment = "void main() { gl_FragColor = vec4(1.); }\n";

class FoundScene : public testing::Test {
protected:
    Found found(std::string_view scene) {
        return found_in_text(
            folder_, scene,
            {{"a.vert", vertex}, {"waves.vert", waves}, {"a.frag", fragment}, {"n.frag", noise}, {"p.png", ""}},
            add_scene_changes);
    }
    static constexpr std::string_view noise =
        "uniform sampler3D Noise3;\nvoid main() { gl_FragColor = texture3D(Noise3, vec3(.1)); }\n";
    Scratch folder_;
};

TEST_F(FoundScene, SlicesOfRoundShapes) {
    const Found two = found("Sphere 1. 24 12 # round\nTorus\n");
    EXPECT_EQ(two.after(ChangeKind::fewer_slices),
              (Afters{"Sphere 1. 18 9", "Sphere 1. 12 6", "Sphere 1. 8 4", "Torus 1. 0.5 15 30", "Torus 1. 0.5 10 20",
                      "Torus 1. 0.5 7 13"}));
    EXPECT_EQ(two.after(ChangeKind::more_slices), (Afters{"Sphere 1. 48 24", "Torus 1. 0.5 40 80"}));
    EXPECT_EQ(two.text(ChangeKind::fewer_slices, 0, "scene.glib"), "Sphere 1. 18 9 # round\nTorus\n");
    EXPECT_EQ(two.text(ChangeKind::more_slices, 1, "scene.glib"), "Sphere 1. 24 12 # round\nTorus 1. 0.5 40 80\n");
    EXPECT_EQ(found("cone 1 2 5").after(ChangeKind::fewer_slices), (Afters{"cone 1 2 4", "cone 1 2 3"}))
        << "not below three";
    EXPECT_TRUE(found("Teapot\nBox 1 2 3\nSphere 1 2000 2000").after(ChangeKind::more_slices).empty());
}

TEST_F(FoundScene, QuadsOfAQuadBox) {
    const Found box = found("QuadBox 60\n");
    EXPECT_EQ(box.after(ChangeKind::fewer_slices), (Afters{"QuadBox 45", "QuadBox 30", "QuadBox 20"}));
    EXPECT_TRUE(box.after(ChangeKind::more_slices).empty()) << "more would be denser, not more exact";
}

TEST_F(FoundScene, CellsOfQuads) {
    const Found grid = found("Vertex waves.vert\nFragment a.frag\nProgram P\nQuadXZ -1. 5. 100 40\nQuadXY\n");
    EXPECT_EQ(grid.after(ChangeKind::fewer_cells),
              (Afters{"QuadXZ -1. 5. 75 30", "QuadXZ -1. 5. 50 20", "QuadXZ -1. 5. 25 10"}));
    EXPECT_EQ(grid.after(ChangeKind::finer_cells),
              (Afters{"QuadXZ -1. 5. 200 80", "QuadXZ -1. 5. 400 160", "QuadXY 0. 1. 2 2", "QuadXY 0. 1. 4 4"}));
    // Where the shader is linear in the vertex, more cells show nothing else.
    const Found flat = found("Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1 3 3\n");
    EXPECT_TRUE(flat.after(ChangeKind::finer_cells).empty());
    EXPECT_EQ(flat.after(ChangeKind::fewer_cells), (Afters{"QuadXY 0 1 2 2", "QuadXY 0 1 1 1"}));
    EXPECT_EQ(found("Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1 80 8\n").after(ChangeKind::fewer_cells),
              (Afters{"QuadXY 0 1 60 6", "QuadXY 0 1 40 4", "QuadXY 0 1 20 2", "QuadXY 0 1 1 1"}));
}

TEST_F(FoundScene, ContinuedStatementsAndIncludedTextsChangeAtTheirPlace) {
    const Found continued = found("Sphere 1. \\\n  # how many\n  24 \\\r\n  12\r\n");
    EXPECT_EQ(continued.text(ChangeKind::fewer_slices, 0, "scene.glib"),
              "Sphere 1. \\\n  # how many\n  18 \\\r\n  9\r\n");
    folder_.write("ball.inc", "Sphere 1 20 10\n");
    for (const std::string_view name : {"ball.inc", "ball"}) {
        const std::string include = "Include " + std::string(name) + "\n";
        const Found included = found(include + "Translate 1 0 0\n" + include);
        EXPECT_EQ(included.after(ChangeKind::more_slices), Afters{"Sphere 1 40 20"}) << "one text, one change";
        EXPECT_EQ(included.text(ChangeKind::more_slices, 0, "ball.inc"), "Sphere 1 40 20\n") << name;
    }
}

TEST_F(FoundScene, SolidsAreCulledAloneAndTogether) {
    const std::string scene = "QuadXY # floor\nSphere 2 # ball\nTranslate 1 0 0\nTorus\nDiskXY\nTeapot";
    const Found all = found(scene);
    ASSERT_EQ(all.after(ChangeKind::culled).size(), 4u);
    EXPECT_EQ(all.text(ChangeKind::culled, 0, "scene.glib"),
              "QuadXY # floor\nCullFace back\nSphere 2 # ball\nCullFace none\nTranslate 1 0 0\nTorus\nDiskXY\nTeapot");
    EXPECT_EQ(all.text(ChangeKind::culled, 2, "scene.glib"),
              "QuadXY # floor\nSphere 2 # ball\nTranslate 1 0 0\nTorus\nDiskXY\nCullFace back\nTeapot")
        << "nothing is drawn behind it";
    EXPECT_EQ(all.text(ChangeKind::culled, 3, "scene.glib"),
              "QuadXY # floor\nCullFace back\nSphere 2 # ball\nTranslate 1 0 0\nTorus\nCullFace none\nDiskXY\nCullFace "
              "back\nTeapot");
    EXPECT_EQ(found("Sphere\r\nQuadXY\r\n").text(ChangeKind::culled, 0, "scene.glib"),
              "CullFace back\r\nSphere\r\nCullFace none\r\nQuadXY\r\n");
    EXPECT_EQ(found("Sphere 2 \\\n\nQuadXY\n").text(ChangeKind::culled, 0, "scene.glib"),
              "CullFace back\nSphere 2 \\\n\nCullFace none\nQuadXY\n");
    EXPECT_EQ(found("Sphere 2 \\ # its radius\n\nQuadXY\n").text(ChangeKind::culled, 0, "scene.glib"),
              "CullFace back\nSphere 2 \\ # its radius\n\nCullFace none\nQuadXY\n");
    folder_.write("c.inc", "Box");
    const Found twice = found("Include c.inc\nQuadXY\nInclude c.inc\n");
    EXPECT_EQ(twice.after(ChangeKind::culled), Afters{"CullFace back Box CullFace none"}) << "and not all";
    EXPECT_EQ(twice.text(ChangeKind::culled, 0, "c.inc"), "CullFace back\nBox\nCullFace none") << "a quad follows";
    for (const std::string_view none : {"CullFace front\nSphere\n", "WireSphere\nQuadXY\nDiskXY\nPointCloud\n"})
        EXPECT_TRUE(found(none).after(ChangeKind::culled).empty()) << none;
}

TEST_F(FoundScene, WhatNoOneCanReadIsNotCulled) {
    const Found unread = found(
        "Sphere\nVertex a.vert\nFragment missing.frag\nProgram P\nBox\nQuadXY\nFragment a.frag\nProgram Q\nTorus\n");
    ASSERT_EQ(unread.after(ChangeKind::culled).size(), 3u);
    EXPECT_EQ(unread.text(ChangeKind::culled, 2, "scene.glib"),
              "CullFace back\nSphere\nVertex a.vert\nFragment missing.frag\nProgram P\nCullFace none\nBox\nQuadXY\n"
              "Fragment a.frag\nProgram Q\nCullFace back\nTorus\n");
}

TEST_F(FoundScene, NoiseThatIsRead) {
    const std::string program = "Vertex a.vert\nFragment n.frag\nProgram P\nBox\n";
    EXPECT_EQ(found("Noise3D 128\n" + program).after(ChangeKind::smaller_noise), (Afters{"Noise3D 64", "Noise3D 32"}));
    EXPECT_EQ(found("Noise3D\n" + program).after(ChangeKind::smaller_noise), (Afters{"Noise3D 32", "Noise3D 16"}));
    const Found unsaid = found("# noise\n" + program);
    ASSERT_EQ(unsaid.after(ChangeKind::smaller_noise).size(), 2u);
    EXPECT_EQ(unsaid.text(ChangeKind::smaller_noise, 0, "scene.glib"), "# noise\nNoise3D 32\n" + program);
    EXPECT_TRUE(
        found("Noise3D 128\nVertex a.vert\nFragment a.frag\nProgram P\nBox\n").after(ChangeKind::smaller_noise).empty())
        << "nothing reads it";
}

TEST_F(FoundScene, TexelsOfTexturesThatAreDrawnTo) {
    const auto texels = [&](const std::string& scene) { return found(scene).after(ChangeKind::fewer_texels); };
    EXPECT_EQ(texels("CubeMap 5 256\nRenderToCube 5\nBox\n"), (Afters{"CubeMap 5 128", "CubeMap 5 64"}));
    EXPECT_EQ(texels("Texture2D 3 64 20\nRenderToTexture 3\nBox\n"), (Afters{"Texture2D 3 32 10"}))
        << "a quarter would be less than eight";
    EXPECT_TRUE(texels("Texture2D 3 64 64\nTexture2D 4 p.png\nBox\n").empty()) << "nothing draws to them";
    const Found two = found("Texture2D 3 64 64 # one\nTexture2D 4 64 64\nRenderToTexture 3 4\nBox\n");
    EXPECT_EQ(two.text(ChangeKind::fewer_texels, 0, "scene.glib"),
              "Texture2D 3 32 32 # one\nTexture2D 4 32 32\nRenderToTexture 3 4\nBox\n")
        << "textures of one pass have one size";
}

TEST_F(FoundScene, FiltersByWhatTheLanguageHas) {
    EXPECT_EQ(found("Filter nearest\nTexture2D 0 p.png\n").after(ChangeKind::filtered),
              (Afters{"Filter linear", "Filter mipmap"}));
    const Found unsaid = found("Perspective 50\nTexture2D 0 p.png\n");
    EXPECT_EQ(unsaid.text(ChangeKind::filtered, 0, "scene.glib"), "Perspective 50\nFilter mipmap\nTexture2D 0 p.png\n");
    EXPECT_EQ(unsaid.text(ChangeKind::less_filtered, 0, "scene.glib"),
              "Perspective 50\nFilter nearest\nTexture2D 0 p.png\n");
    const Found anisotropic = found("Filter anisotropic 4 # fine\nTexture2D 0 p.png\n");
    EXPECT_TRUE(anisotropic.after(ChangeKind::filtered).empty());
    EXPECT_EQ(anisotropic.after(ChangeKind::less_filtered),
              (Afters{"Filter nearest", "Filter linear", "Filter mipmap"}));
    EXPECT_EQ(anisotropic.text(ChangeKind::less_filtered, 2, "scene.glib"),
              "Filter mipmap # fine\nTexture2D 0 p.png\n");
    EXPECT_EQ(found("Filter\nTexture2D 0 p.png\n").after(ChangeKind::less_filtered), Afters{"Filter nearest"});
    EXPECT_TRUE(found("Texture2D 0 64 64\n").after(ChangeKind::filtered).empty());
}

TEST_F(FoundScene, AllTexturesAreDecodedTogether) {
    const std::string_view scene =
        "# sky\nPerspective 50\nTexture2D 0 p.png\nCubeMap 6 p.png # six\nTexture2D 1 n.hdr\n";
    EXPECT_EQ(found(scene).text(ChangeKind::decoded, 0, "scene.glib"),
              "# sky\nOutput srgb\nPerspective 50\nTexture2D 0 p.png srgb\nCubeMap 6 p.png srgb # six\nTexture2D 1 "
              "n.hdr\n");
    EXPECT_EQ(found(scene).at(ChangeKind::decoded)->lint, "");
    EXPECT_EQ(found("CubeMap 6 p.png\nIrradiance 7 6\n").at(ChangeKind::decoded)->lint, "encoded-light");
    for (const std::string_view said : {"Output raw\nTexture2D 0 p.png\n", "Texture2D 0 p.png raw\nTexture2D 1 p.png\n",
                                        "Texture2D 0 64 64\n", "Texture2D 0 normals.png\n"})
        EXPECT_TRUE(found(said).after(ChangeKind::decoded).empty()) << said;
}

TEST_F(FoundScene, WhatIsNotThereIsNotChanged) {
    for (const std::string_view missing : {"Texture2D 5 missing.png\n", "Filter nearest\nTexture2D 5 missing.png\n"})
        EXPECT_TRUE(found(missing).changes.empty()) << missing;
    EXPECT_TRUE(found("Vertex a.vert\nFragment missing.frag\nProgram P\nSphere 1 40 40\n").changes.empty());
}

TEST_F(FoundScene, BrokenStatementsAreLeftAlone) {
    for (const std::string_view broken : {"Sphere [1 2] 3", "Sphere x y z", "Torus 1 2 3 4 5 6 7", "", "\\", "Include",
                                          "Include scene.glib\nSphere 1 9"})
        for (const Change& change : found(broken).changes) EXPECT_FALSE(change.after.empty()) << broken;
}

TEST(FoundSceneAll, ChangesAreSound) { expect_sound(add_scene_changes); }

// Whatever was read before: finding changes adds the texts of included shaders.
TEST(FoundSceneAll, ChangesAreTheSameASecondTime) {
    const auto list = [](const Found& found, const std::vector<Change>& changes) {
        std::vector<std::string> lines;
        for (const Change& change : changes)
            lines.push_back(std::string(found.sources.name(change.where.file)) + " " +
                            std::to_string(change.where.begin) + " " + std::string(facts(change.kind).name) + " " +
                            change.after);
        return lines;
    };
    for (const std::string& path : all_scenes()) {
        Found found = found_in(path, [](const Reading& reading, std::vector<Change>& changes) {
            changes = find_changes(reading.plan, reading.files, reading.sources);
        });
        const std::vector<Change> again = find_changes(found.plan, *found.files, found.sources);
        const std::vector<std::string> one = list(found, found.changes), other = list(found, again);
        EXPECT_EQ(one.size(), other.size()) << path;
        for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) ASSERT_EQ(one[i], other[i]) << path;
    }
}

}  // namespace
}  // namespace snell::accuracy
