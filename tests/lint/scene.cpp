// Lints of a scene and of what stands on its units; and those that must be silent.
#include "parser/read/parse.h"
#include "src/plan/plan.h"
#include "tests/lint/help.h"
#include "tests/scratch.h"

namespace snell::lint {

std::vector<std::string> Linted::at(std::string_view code) const {
    std::vector<std::string> places;
    for (const Diagnostic& d : found.items())
        if (d.code == code)
            places.emplace_back(sources.text(d.span.file).substr(d.span.begin, d.span.end - d.span.begin));
    return places;
}

std::string Linted::place(std::string_view code) const {
    for (const Diagnostic& d : found.items()) {
        if (d.code != code) continue;
        const Position at = sources.position(d.span.file, d.span.begin);
        return std::filesystem::path(sources.name(d.span.file)).filename().string() + ":" + std::to_string(at.line) +
               ":" + std::to_string(at.column);
    }
    return "";
}

Linted lint_file(const std::string& path, const std::vector<std::string_view>& rungs) {
    Linted result;
    Files files(std::filesystem::path(path).parent_path().string());
    std::string error;
    const FileId id = result.sources.add(path, files.read(path, error).value_or(""));
    const auto included = [&](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        const std::string at = files.resolve_beside(from, name, {"glib"}).path;
        auto text = files.read(at, error);
        return text ? std::optional(IncludedText{at, *text}) : std::nullopt;
    };
    Parsed parsed = parse(id, result.sources, included);
    Diagnostics others;
    Plan plan = make_plan(std::move(parsed.scene), files, result.sources, others);
    for (const std::string_view rung : rungs) EXPECT_TRUE(choose_rung(plan.rungs, plan.scene, rung, others)) << rung;
    const auto include = [&](std::string_view from, std::string_view name, bool angle) {
        const std::string at =
            angle ? SNELL_ROOT "/shaders/" + std::string(name) : files.resolve_beside(from, name).path;
        auto text = files.read(at, error);
        return text ? std::optional(glsl::IncludeText{angle ? std::string(name) : at, *text}) : std::nullopt;
    };
    result.found = check(plan, result.sources, include);
    return result;
}

Linted lint(std::string_view scene, const std::vector<File>& files) {
    const Scratch folder;
    for (const File& file : files) folder.write(file.name, file.text);
    return lint_file(folder.write("scene.glib", scene));
}

Linted lint_fragment(std::string_view fragment, std::string_view values, std::string_view state) {
    const std::string scene =
        std::string(state) + "\nVertex a.vert\nFragment a.frag\nProgram A " + std::string(values) + "\nSphere\n";
    return lint(scene, {{"a.vert",
                         "uniform mat4 M; uniform vec3 camWorldPos; out vec3 vN, vE;\n"
                         "void main() { vN = mat3(M) * gl_Normal; vE = vec3(M * gl_Vertex) - camWorldPos;\n"
                         "gl_Position = ftransform(); }\n"},
                        {"a.frag", fragment}});
}

namespace {

constexpr std::string_view plain_vert = "void main() { gl_Position = ftransform(); }\n";
constexpr std::string_view plain_frag = "void main() { gl_FragColor = vec4(1.); }\n";

TEST(SceneLints, MeansOfEncodedNumbersAreNotOfLight) {
    const auto places = [](const std::string& scene) { return lint(scene, {}).at("encoded-light"); };
    using Places = std::vector<std::string>;
    EXPECT_EQ(places("CubeMap 6 sky.png\nIrradiance 7 6\n"), Places{"Irradiance 7 6"});
    EXPECT_EQ(places("CubeMap 6 a.jpg b.jpg c.jpg d.jpg e.jpg f.jpg\nPrefilter 8 6 64\n"), Places{"Prefilter 8 6 64"});
    for (const std::string source : {"sky.png srgb", "sky.png raw", "sky.hdr", "sky.EXR", "256"})
        EXPECT_EQ(places("CubeMap 6 " + source + "\nIrradiance 7 6\n"), Places{}) << source;
    EXPECT_EQ(places("CubeMap 6 sky.png\n"), Places{}) << "nothing is averaged";
}

TEST(LintTable, EveryRuleHasItsCodeAndItsPage) {
    const std::string page = bytes_of(SNELL_ROOT "/docs/teaching.md");
    std::vector<std::string> anchors;
    for (std::size_t at = page.find("\n#"); at != std::string::npos; at = page.find("\n#", at + 1)) {
        const std::size_t begin = page.find(' ', at) + 1;
        std::string anchor;
        for (const char c : page.substr(begin, page.find('\n', begin) - begin)) {
            if (c == ' ') anchor += '-';
            if (c >= 'A' && c <= 'Z') anchor += static_cast<char>(c + 32);
            if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-') anchor += c;
        }
        anchors.push_back(anchor);
    }
    for (const RuleFacts& rule : rules()) {
        EXPECT_NE(std::find(anchors.begin(), anchors.end(), rule.anchor), anchors.end())
            << rule.code << " points at a section that docs/teaching.md lacks: " << rule.anchor;
        EXPECT_FALSE(rule.finds.empty() || rule.instead.empty());
    }
}

TEST(LintProgram, ThatDrawsNothing) {
    const Linted bad = lint("Vertex p.vert\nFragment p.frag\nProgram Seen\nSphere\nProgram Unseen\n",
                            {{"p.vert", plain_vert}, {"p.frag", plain_frag}});
    ASSERT_EQ(bad.at("program-not-drawn").size(), 1U) << bad.text();
    EXPECT_EQ(bad.place("program-not-drawn"), "scene.glib:5:1");
    EXPECT_NE(bad.text().find("snell help program-not-drawn"), std::string::npos);
    const Linted good = lint("Vertex p.vert\nFragment p.frag\nProgram Seen\nSphere\n",
                             {{"p.vert", plain_vert}, {"p.frag", plain_frag}});
    EXPECT_TRUE(good.found.empty()) << good.text();
}

TEST(LintPosition, OfAVertexShaderThatGivesNone) {
    const std::string scene = "Vertex p.vert\nFragment p.frag\nProgram Seen\nSphere\n";
    const std::string_view nowhere = "varying vec3 vN;\nvoid main() { vN = gl_Normal; }\n";
    const Linted bad = lint(scene, {{"p.vert", nowhere}, {"p.frag", plain_frag}});
    EXPECT_EQ(bad.place("position-not-written"), "p.vert:2:6") << bad.text();
    // A macro, a function, or a stage behind it may do so.
    for (const std::string_view somewhere :
         {"#define PLACE gl_Position\nvoid main() { PLACE = ftransform(); }\n",
          "void place() { gl_Position = ftransform(); }\nvoid main() { place(); }\n"})
        EXPECT_FALSE(lint(scene, {{"p.vert", somewhere}, {"p.frag", plain_frag}}).has(Rule::position_not_written));
    EXPECT_FALSE(lint("Vertex p.vert\nGeometry p.geom\nFragment p.frag\nProgram Seen\nSphere\n",
                      {{"p.vert", nowhere}, {"p.geom", "void main() { }\n"}, {"p.frag", plain_frag}})
                     .has(Rule::position_not_written));
}

TEST(LintPointSize, OfAShaderWhereTheSceneDecides) {
    const std::string_view sized = "void main() {\n    gl_Position = ftransform();\n    gl_PointSize = 9.;\n}\n";
    const std::string_view points =
        "layout(points) in;\nlayout(points, max_vertices = 1) out;\nvoid main() {\n"
        "    gl_Position = gl_in[0].gl_Position;\n    gl_PointSize = 3.;\n    EmitVertex();\n}\n";
    const auto places = [&](const std::string& draws, std::string_view vertex, std::string_view stages = "") {
        return lint("Vertex p.vert\nFragment p.frag\n" + std::string(stages) + "Program Seen\n" + draws,
                    {{"p.vert", vertex}, {"p.geom", points}, {"p.frag", plain_frag}})
            .place("point-size-unused");
    };
    const std::string list = "glBegin gl_points\nglVertex 0 0 0\nglEnd\n";
    EXPECT_EQ(places("PointCloud 2 2 2\n", sized), "p.vert:3:5");
    EXPECT_EQ(places("JitterCloud\n", sized), "p.vert:3:5");
    EXPECT_EQ(places("PointSize 4\nPointSizeMode 1\nPointSizeMode 0\n" + list, sized), "p.vert:3:5");
    EXPECT_EQ(places(list, plain_vert, "Geometry p.geom\n"), "p.geom:5:5");
    EXPECT_EQ(places("PointSizeMode 1\n" + list, plain_vert, "Geometry p.geom\n"), "");
    EXPECT_EQ(places("PointSizeMode 1\nPointCloud\n", sized), "");
    EXPECT_EQ(places("PointCloud\nPointSizeMode 1\nPointCloud\n", sized), "") << "one draw takes it";
    EXPECT_EQ(places("Sphere\n", sized), "") << "nothing of it is a point";
    EXPECT_EQ(places("PointCloud\n", plain_vert), "");
    EXPECT_EQ(places("PointCloud\n", "void main() { gl_Position = ftransform() * float(gl_PointSize == 1.); }\n"), "");
}

constexpr std::string_view cube_frag =
    "uniform samplerCube uSky;\nuniform sampler2D uWood;\nvarying vec3 vD;\n"
    "void main() { gl_FragColor = textureCube(uSky, vD) + texture2D(uWood, vD.xy); }\n";

TEST(LintSampler, OnAUnitOfAnotherKind) {
    const std::vector<File> files = {
        {"p.vert", "varying vec3 vD; void main() { vD = gl_Normal; gl_Position = ftransform(); }"},
        {"p.frag", cube_frag}};
    const std::string scene = "Texture2D 5 wood.png\nCubeMap 6 sky.hdr\nVertex p.vert\nFragment p.frag\n";
    const Linted bad = lint(scene + "Program P uSky 5 uWood 6\nSphere\n", files);
    EXPECT_EQ(bad.at("sampler-kind"), (std::vector<std::string>{"uSky 5", "uWood 6"})) << bad.text();
    EXPECT_EQ(bad.place("sampler-kind"), "scene.glib:5:11");
    const Linted good = lint(scene + "Program P uSky 6 uWood 5\nSphere\n", files);
    EXPECT_TRUE(good.found.empty()) << good.text();
}

TEST(LintSampler, OfTwoKindsOnOneUnit) {
    const std::vector<File> files = {
        {"p.vert", "varying vec3 vD; void main() { vD = gl_Normal; gl_Position = ftransform(); }"},
        {"p.frag", cube_frag}};
    const std::string scene = "Texture2D 6 wood.png\nCubeMap 6 sky.hdr\nVertex p.vert\nFragment p.frag\n";
    const Linted bad = lint(scene + "Program P uSky 6 uWood 6\nSphere\n", files);
    ASSERT_EQ(bad.at("samplers-share-unit").size(), 1U) << bad.text();
    EXPECT_EQ(bad.at("samplers-share-unit")[0], "uWood 6");
    EXPECT_FALSE(bad.has(Rule::sampler_kind)) << "each finds its texture";
    // Two programs may each use the unit in their own way.
    const Linted good = lint(
        scene + "Program P uSky 6\nSphere\nVertex p.vert\nFragment q.frag\nProgram Q uWood 6\nSphere\n",
        {files[0],
         {"p.frag", "uniform samplerCube uSky; varying vec3 vD; void main() { gl_FragColor = textureCube(uSky, vD); }"},
         {"q.frag",
          "uniform sampler2D uWood; varying vec3 vD; void main() { gl_FragColor = texture2D(uWood, vD.xy); }"}});
    EXPECT_TRUE(good.found.empty()) << good.text();
}

constexpr std::string_view eye_vert =
    "out vec3 vDir, vN;\nvoid main() {\n    vec3 p = (gl_ModelViewMatrix * gl_Vertex).xyz;\n    vDir = p;\n"
    "    vN = gl_NormalMatrix * gl_Normal;\n    gl_Position = ftransform();\n}\n";
constexpr std::string_view eye_frag =
    "in vec3 vDir, vN;\nuniform samplerCube uSky;\nvoid main() {\n"
    "    vec3 r = reflect(normalize(vDir), normalize(vN));\n    gl_FragColor = texture(uSky, r);\n}\n";

TEST(LintSpace, EyeCoordinatesIntoACubeMap) {
    const std::vector<File> files = {{"e.vert", eye_vert}, {"e.frag", eye_frag}};
    const std::string rest = "CubeMap 6 sky.hdr\nVertex e.vert\nFragment e.frag\nProgram E uSky 6\nSphere\n";
    const Linted bad = lint("LookAt 5. 0. 0. 0. 0. 0. 0. 1. 0.\n" + rest, files);
    EXPECT_EQ(bad.at("eye-space-lookup"), std::vector<std::string>{"r"}) << bad.text();
    EXPECT_EQ(bad.place("eye-space-lookup"), "e.frag:5:34");
    EXPECT_NE(bad.text().find("90 degrees"), std::string::npos);
    // An eye that is only moved looks along the world's axes.
    EXPECT_FALSE(lint("LookAt 0. 0. 5. 0. 0. 0. 0. 1. 0.\n" + rest, files).has(Rule::eye_space_lookup));
    const Linted turned_back =
        lint("LookAt 5. 0. 0. 0. 0. 0. 0. 1. 0.\n" + rest,
             {files[0],
              {"e.frag",
               "in vec3 vDir, vN;\nuniform samplerCube uSky;\nuniform mat4 uViewMatrixInverse;\nvoid main() {\n"
               "    vec3 r = reflect(normalize(vDir), normalize(vN));\n"
               "    gl_FragColor = texture(uSky, mat3(uViewMatrixInverse) * r);\n}\n"}});
    EXPECT_TRUE(turned_back.found.empty()) << turned_back.text();
}

TEST(LintSpace, TheViewerIsNotTheOrigin) {
    const std::string scene =
        "CubeMap 6 sky.hdr\nVertex e.vert\nFragment e.frag\nProgram E uSky 6\nTranslate 0 0 -4\nSphere\n";
    const Linted bad = lint(scene, {{"e.vert", eye_vert}, {"e.frag", eye_frag}});
    EXPECT_EQ(bad.at("viewer-not-at-origin"), std::vector<std::string>{"r"}) << bad.text();
    EXPECT_EQ(bad.found.warnings(), 0U) << "a note, for it is right until the scene is dragged";
    std::string vert(eye_vert);
    vert.replace(vert.find("vDir = p;"), 9, "vDir = p - uViewerPositionEye;");
    const Linted good = lint(scene, {{"e.vert", "uniform vec3 uViewerPositionEye;\n" + vert}, {"e.frag", eye_frag}});
    EXPECT_TRUE(good.found.empty()) << good.text();
}

TEST(LintBranch, LookupOfATextureWithMipmaps) {
    const auto scene = [](std::string_view filter) {
        return lint_fragment(
            "in vec3 vN, vE;\nuniform samplerCube uSky;\nvoid main() {\n    vec3 d = normalize(vN);\n"
            "    if (d.x > 0.) gl_FragColor = texture(uSky, d);\n    else gl_FragColor = vec4(1.);\n}\n",
            "uSky 6", std::string(filter) + "\nCubeMap 6 sky.hdr");
    };
    const Linted bad = scene("Filter mipmap");
    EXPECT_EQ(bad.at("lookup-in-branch"), std::vector<std::string>{"texture(uSky, d)"}) << bad.text();
    EXPECT_TRUE(scene("Filter linear").found.empty()) << "no level is chosen";
    const Linted uniform = lint_fragment(
        "in vec3 vN;\nuniform samplerCube uSky;\nuniform bool uOn;\nvoid main() {\n    gl_FragColor = vec4(1.);\n"
        "    if (uOn) gl_FragColor = texture(uSky, vN);\n}\n",
        "uSky 6 uOn <true>", "Filter mipmap\nCubeMap 6 sky.hdr");
    EXPECT_TRUE(uniform.found.empty()) << uniform.text();
}

// ---- what must be silent, and what must not ---------------------------------------------------------------

std::vector<std::string> scenes_under(const std::string& folder) {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(SNELL_ROOT "/" + folder))
        if (entry.path().extension() == ".glib") found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    return found;
}

TEST(LintSilence, OurScenesAreRight) {
    std::size_t count = 0;
    for (const std::string folder : {"scenes", "tests/cases"})
        for (const std::string& path : scenes_under(folder)) {
            if (path.find("/files/", sizeof SNELL_ROOT) != path.npos) continue;       // parts of scenes
            if (path.find("/end-to-end/", sizeof SNELL_ROOT) != path.npos) continue;  // computes as others printed it
            ++count;
            EXPECT_TRUE(lint_file(path).found.empty()) << lint_file(path).text();
        }
    EXPECT_GT(count, 80U);
}

// The scenes of light have mistakes as rungs, and are right as they stand.
TEST(LintRungs, AMistakeThatIsChosenIsFound) {
    const std::string mirror = SNELL_ROOT "/scenes/light/mirror/mirror.glib";
    EXPECT_TRUE(lint_file(mirror, {"NORMAL=interpolated"}).has(Rule::unnormalised_direction));
    EXPECT_TRUE(lint_file(mirror, {"SPACE=eye", "LOCALITY=infinite"}).has(Rule::eye_space_lookup));
    EXPECT_TRUE(
        lint_file(SNELL_ROOT "/scenes/light/glass/glass.glib", {"LENGTHS=any"}).has(Rule::unnormalised_direction));
}

// Every stage of the small programs of the dialects, each with its like.
TEST(LintSilence, ShadersOfEveryDialect) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(SNELL_ROOT "/tests/glsl"))
        if (entry.path().extension() != ".glsl") names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    std::string scene;
    for (const std::string& name : names) {
        constexpr std::pair<std::string_view, std::string_view> commands[] = {{".vert", "Vertex"},
                                                                              {".tcs", "TessControl"},
                                                                              {".tes", "TessEvaluation"},
                                                                              {".geom", "Geometry"},
                                                                              {".frag", "Fragment"}};
        const std::string stem = name.substr(0, name.rfind('.'));
        if (name.ends_with(".frag") && std::count(names.begin(), names.end(), stem + ".vert")) continue;
        scene.clear();
        for (const auto& [extension, command] : commands)
            if (std::count(names.begin(), names.end(), stem + std::string(extension)))
                scene += std::string(command) + " " SNELL_ROOT "/tests/glsl/" + stem + std::string(extension) + "\n";
        const Linted linted = lint(scene + "Program P\nPointSizeMode 1\nSphere\n", {});
        EXPECT_TRUE(linted.found.empty()) << linted.text();
    }
    EXPECT_GT(names.size(), 140U);
}

struct Printed {
    std::string_view vertex, fragment, values;
    std::vector<Rule> finds;
};

TEST(LintPrinted, TheMistakesOfTheSources) {
    const std::filesystem::path corpus = SNELL_ROOT "/../shared/corpus";
    if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "no corpus beside the project";
    using enum Rule;
    const Printed all[] = {
        {"bailey/refract.vert",
         "bailey/refract.frag",
         "uReflectUnit 5 uRefractUnit 6 uEta <.1 1.1 5.> uMix <0. 0. 1.>",
         {unnormalised_direction, index_as_ratio, eye_space_lookup}},
        {"bailey/reflect.vert", "bailey/reflect.frag", "uReflectUnit 6", {unnormalised_direction, eye_space_lookup}},
        {"bailey/world.vert", "bailey/world.frag", "uTexUnit 6", {}},
        {"orange/envmap.vert", "orange/envmap.frag", "EnvMap 6", {eye_space_lookup}},
        {"ramires/reflect.vert", "ramires/reflect.frag", "texUnit 6", {}},
        {"ramires/reflect.vert", "ramires/fresnel.frag", "texUnit 6", {shadowed_uniform, schlick_sign, never_read}},
        {"ramires/reflect.vert",
         "ramires/dispersion.frag",
         "texUnit 6",
         {shadowed_uniform, dispersion_order, pow_of_negative, never_read}},
    };
    for (const Printed& p : all) {
        const std::string scene = "LookAt 3 1 3  0 0 0  0 1 0\nCubeMap 5 a.hdr\nCubeMap 6 a.hdr\nVertex " +
                                  (corpus / p.vertex).string() + "\nFragment " + (corpus / p.fragment).string() +
                                  "\nProgram P " + std::string(p.values) + "\nSphere\n";
        const Linted linted = lint(scene, {});
        for (const Rule rule : p.finds) EXPECT_TRUE(linted.has(rule)) << p.fragment << ": " << facts(rule).code;
        for (const RuleFacts& rule : rules())
            if (std::count(p.finds.begin(), p.finds.end(), rule.rule) == 0 && rule.rule != pow_of_negative) {
                EXPECT_FALSE(linted.has(rule.rule)) << p.fragment << "\n" << linted.text();
            }
    }
    const Linted scene = lint_file(corpus / "bailey/cubemap.glib");
    EXPECT_EQ(scene.at("program-not-drawn").size(), 1U) << scene.text();
}

}  // namespace
}  // namespace snell::lint
