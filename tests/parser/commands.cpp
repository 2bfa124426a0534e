// The table: what it promises, and that a malformed row does not compile.
#include <nlohmann/json.hpp>

#include "parser/commands/commands.h"
#include "tests/oracle/scene/print.h"
#include "tests/parser/support.h"
#include "tests/scratch.h"
#include "tests/std.h"
#include "tests/words.h"

namespace snell::test {
namespace {

constexpr Signature scale = "s | sx sy sz=-.5";
static_assert(scale.count == 2 && scale.parameter_count(0) == 1 && scale.parameter_count(1) == 3);
static_assert(scale.parameter(1, 2).default_value == -.5 && scale.parameter(1, 2).optional);
static_assert(!scale.parameter(1, 1).optional);
constexpr Signature kinds = "a:int b:path c:vec3 d:on/off=off e:name? f:int...";
static_assert(kinds.parameter(0, 0).kind == ArgumentKind::integer && kinds.parameter(0, 2).kind == ArgumentKind::vec3);
static_assert(kinds.parameter(0, 3).kind == ArgumentKind::choice && kinds.parameter(0, 3).default_text == "off");
static_assert(kinds.parameter(0, 5).repeated);
static_assert(Signature(" | a").count == 2 && Signature(" | a").parameter_count(0) == 0);
static_assert(Signature("").count == 1);

// The compiler is asked: the errors must come at compile time.
TEST(Signature, MalformedOnesDoNotCompile) {
    if (std::system("c++ --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no compiler here to refuse them";
    const std::vector<std::string> bad = words(
        "a:flaot,a:int=,a=x,a=1.2.3,a=1 b,a... b,a:rest b,a a,5a,a:on/,a!,a:on/off=maybe,a:path=x,"
        "a | b | c | d,a b c d e f g h i j k l m n o p q",
        ',');
    // One a line; the first is a good one.
    std::string text = "constexpr snell::Signature s0 = \"a b:int=5 c:path?\";\n";
    for (std::size_t i = 0; i < bad.size(); ++i)
        text += "constexpr snell::Signature s" + std::to_string(i + 1) + " = \"" + bad[i] + "\";\n";
    const Scratch folder;
    folder.write("signatures.cpp", "#include \"parser/commands/commands.h\"\n#line 1 \"row\"\n" + text);
    const std::string command =
        "cd '" + folder.path() + "' && c++ -std=c++20 -fsyntax-only -I'" SNELL_ROOT "' signatures.cpp 2> errors";
    EXPECT_NE(std::system(command.c_str()), 0);
    const std::string errors = bytes_of(folder.path("errors"));
    EXPECT_EQ(errors.find("row:1:"), std::string::npos) << errors;
    for (std::size_t i = 0; i < bad.size(); ++i)
        EXPECT_NE(errors.find("row:" + std::to_string(i + 2) + ":"), std::string::npos) << bad[i];
}

TEST(Commands, EachHasANameADocumentationAndAHandler) {
    std::set<std::string> names;
    for (const Command& c : commands()) {
        EXPECT_GT(c.doc.size(), 10u) << c.name;
        EXPECT_EQ(c.doc.back(), '.') << c.name;
        EXPECT_NE(c.handler, nullptr) << c.name;
        EXPECT_TRUE(names.insert(std::string(c.name)).second) << c.name;
        EXPECT_TRUE(c.alias.empty() || names.insert(std::string(c.alias)).second) << c.alias;
    }
}

TEST(Commands, AreFoundInAnyCaseAndByAlias) {
    for (const Command& c : commands()) {
        std::string upper(c.name), lower(c.name);
        for (char& x : upper) x = static_cast<char>(std::toupper(x));
        for (char& x : lower) x = static_cast<char>(std::tolower(x));
        for (const std::string_view word :
             {c.name, c.alias.empty() ? c.name : c.alias, std::string_view(upper), std::string_view(lower)})
            EXPECT_EQ(find_command(word), &c) << word;
    }
    for (const char* none : {"", "Spher", "Spheree", "a", "#", "\x01", "glVertexglVertexglVertexglVertex"})
        EXPECT_EQ(find_command(none), nullptr) << none;
}

TEST(Commands, EveryCommandOfTheLanguageIsThere) {
    for (const std::string& name :
         words("WindowSize Ortho Perspective Persp LookAt Background Clear Translate Rotate Scale PushMatrix "
               "TransformBegin PopMatrix TransformEnd Sphere Torus Cone Cylinder Box Cube Teapot DiskXY "
               "QuadXY QuadXZ QuadYZ QuadBox Soccerball PointCloud JitterCloud Xarrow WireSphere WireTorus "
               "WireCone WireCylinder WireBox WireTeapot WireObj Obj ObjAdj ObjPatch LinesAdjacency Triangles "
               "Shp glBegin glVertex glEnd glColor glNormal glTexCoord NumPatchVertices Color LineWidth "
               "PointSize PointSizeMode Flat Smooth Texture1D Texture2D Texture3D CubeMap Noise2D Noise3D "
               "Clamp RenderToTexture Vertex TessControl TessEvaluation Geometry Fragment GeometryInput "
               "GeometryOutput Program GSTAP Timer MessageBox Verbose")) {
        ASSERT_NE(find_command(name), nullptr) << name;
        EXPECT_FALSE(find_command(name)->addition) << name;
    }
    for (const char* name : {"Blend", "Filter", "CullFace", "DepthTest", "DepthWrite", "Wireframe", "RenderToCube",
                             "Irradiance", "Prefilter", "Ladder", "Include"}) {
        ASSERT_NE(find_command(name), nullptr) << name;
        EXPECT_TRUE(find_command(name)->addition) << name;
    }
}

TEST(Commands, JsonSaysWhatTheTableSays) {
    const nlohmann::json printed = nlohmann::json::parse(commands_json()), all = printed["commands"];
    EXPECT_EQ(printed["schema"], 1);
    ASSERT_EQ(all.size(), commands().size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Command& c = commands()[i];
        EXPECT_EQ(all[i]["name"], std::string(c.name));
        EXPECT_EQ(all[i]["doc"], std::string(c.doc));
        EXPECT_EQ(all[i]["signature"], std::string(c.signature.text));
        EXPECT_EQ(all[i]["addition"], c.addition);
        EXPECT_EQ(all[i]["arguments"].size(), c.signature.count);
        EXPECT_EQ(all[i]["aliases"].size(), c.alias.empty() ? 0u : 1u);
    }
    const auto sphere = *std::find_if(all.begin(), all.end(), [](const auto& c) { return c["name"] == "Sphere"; });
    EXPECT_EQ(sphere["arguments"][0][1]["kind"], "int");
    EXPECT_EQ(sphere["arguments"][0][1]["default"], 60);
}

// An argument that any command accepts in the i-th place.
std::string sample(const Parameter& p, std::size_t i) {
    switch (p.kind) {
        case ArgumentKind::number:
            return std::to_string(i) + ".5";
        case ArgumentKind::integer:
            return "5";
        case ArgumentKind::path:
            return "file.ext";
        case ArgumentKind::name:
            return p.name == "topology" ? "gl_lines" : "Name";
        case ArgumentKind::choice:
            return std::string(p.choices.substr(0, p.choices.find('/')));
        case ArgumentKind::vec3:
            return "[1 2 3]";
        case ArgumentKind::uniforms:
            return "uA <0. .5 1.>";
        case ArgumentKind::rest:
            return "some text";
    }
    return "";
}

bool expected(const Diagnostic& d) {
    // Commands that come in pairs, or take few numbers.
    for (const char* code : {"unbalanced-pop", "unclosed-push", "unbalanced-end", "unclosed-begin", "outside-begin",
                             "include-unavailable", "faces-per-frame", "size-out-of-range", "ladder-without-rungs"})
        if (d.code == code) return true;
    return false;
}

TEST(Commands, EachIsReadInFullAndWithItsDefaults) {
    for (const Command& c : commands()) {
        for (std::size_t a = 0; a < c.signature.count; ++a) {
            std::string full(c.name), least(c.name);
            for (std::size_t i = 0; i < c.signature.parameter_count(a); ++i) {
                const Parameter& p = c.signature.parameter(a, i);
                full += " " + sample(p, i);
                if (!p.optional) least += " " + sample(p, i);
            }
            // Rotate by its defaults has no axis; what is drawn to must be there.
            if (c.name == "Rotate") least = full;
            for (const std::string& statement : {full, least}) {
                const Read r = read("Texture2D 5 64 64\nCubeMap 5 64\n" + statement + "\nSphere\n");
                for (const Diagnostic& d : r.diagnostics())
                    EXPECT_TRUE(expected(d)) << statement << "\n" << render(d, r.sources);
                EXPECT_GE(r.scene().draws.size(), 1u);
                EXPECT_EQ(difference(r.scene(), read(print_scene(r.scene())).scene()), "") << statement;
            }
        }
    }
}

TEST(Scene, LimitsHaveTheirOwnErrors) {
    Limits limits;
    limits.matrix_stack = 2;
    const Read deep = read(
        "PushMatrix\nPushMatrix\nPushMatrix\nPushMatrix\nScale 2\nPopMatrix\nPopMatrix\nSphere\nPopMatrix\nPopMatrix\n",
        {}, limits);
    EXPECT_EQ(deep.codes(), Codes{"3:1 matrix-stack-full"});
    limits = {};
    limits.statements = 3;
    const Read many = read("Sphere\nSphere\nSphere\nSphere\nSphere\n", {}, limits);
    EXPECT_EQ(many.codes(), Codes{"4:1 too-many-statements"});
    EXPECT_EQ(many.scene().draws.size(), 3u);
    limits = {};
    limits.text_bytes = 5;
    EXPECT_EQ(read("Sphere\n", {}, limits).codes(), Codes{"1:1 text-too-large"});
    limits = {};
    limits.diagnostics = 2;
    EXPECT_EQ(read("a\nb\nc\nd\n", {}, limits).codes(),
              (Codes{"1:1 unknown-command", "2:1 unknown-command", "3:1 too-many-diagnostics"}));
    const Read default_deep = read([] {
        std::string t;
        for (int i = 0; i < 100'000; ++i) t += "PushMatrix\n";
        return t;
    }());
    EXPECT_EQ(default_deep.diagnostics()[1].code, "matrix-stack-full");
}

// A word that may follow other arguments, and nothing else in its place.
TEST(Commands, EncodingsOfFilesAndOfTheOutput) {
    const auto encodings = [](const std::string& text) {
        std::string all;
        const Read r = read(text);
        for (const Texture& t : r.scene().textures)
            all += !t.encoding ? '-' : *t.encoding == Encoding::srgb ? 's' : 'r';
        return all;
    };
    EXPECT_EQ(encodings("Texture2D 5 a.png\nTexture2D 5 a.png srgb\nTexture2D 5 a.png RAW\n"), "-sr");
    EXPECT_EQ(encodings("CubeMap 6 a.hdr srgb\nCubeMap 6 a b c d e f srgb\nCubeMap 6 a b c d e f\n"), "ss-");
    EXPECT_EQ(read("Texture2D 5 srgb srgb\n").scene().textures[0].files[0].name, "srgb");
    for (const std::string comment : {"(raw)", "[srgb]", "<raw>", "raw)", "-- srgb", "raw/srgb"}) {
        EXPECT_EQ(encodings("Texture2D 5 a.png " + comment + "\n"), "-") << comment;
        EXPECT_FALSE(read("Texture2D 5 a.png " + comment + "\n").parsed.diagnostics.has_errors()) << comment;
    }
    EXPECT_EQ(read("").scene().output, Encoding::raw);
    EXPECT_EQ(read("Output srgb\n").scene().output, Encoding::srgb);
    EXPECT_EQ(read("Output srgb\nOutput raw\n").scene().output, Encoding::raw);
}

TEST(Commands, EachHasItsCaseAndItsPicture) {
    for (const Command& c : commands()) {
        EXPECT_TRUE(std::filesystem::exists(SNELL_ROOT "/tests/cases/" + std::string(c.name) + ".glib")) << c.name;
        EXPECT_TRUE(std::filesystem::exists(SNELL_ROOT "/docs/images/" + std::string(c.name) + ".png")) << c.name;
    }
}

}  // namespace
}  // namespace snell::test
