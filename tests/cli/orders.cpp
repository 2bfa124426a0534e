// What was drawn before reaches no picture: scenes in shuffled orders, in one process and in many, and what ended one.
//
//   SNELL_ORDERS   how many pictures are compared (20)
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/run.h"
#include "tests/harness/harness.h"
#include "tests/torture/campaign/campaign.h"

namespace snell::test {
namespace {

class Orders : public GlTest {
protected:
    struct Drawn {
        std::string bytes, hash;
        bool operator==(const Drawn&) const = default;
    };
    // What a context may be left with, and what reads what nobody gave it.
    void write_traps() {
        folder.write("red.bmp", bmp(2, 2, std::vector<std::array<int, 3>>(4, {255, 60, 200})));
        folder.write("plain.vert", plain_vertex);
        const auto fragment = [&](const std::string& name, const std::string& text) {
            folder.write(name, "#version 330 compatibility\nin vec2 vST;\n" + text);
        };
        fragment("maps.frag",
                 "uniform sampler2D a;\nuniform samplerCube b;\nuniform sampler3D c;\nvoid main() { "
                 "gl_FragColor = texture(a, vST) + texture(b, vec3(vST, 1.)) + texture(c, vec3(vST, 1.)); }\n");
        fragment("faces.frag",
                 "uniform int FaceIndex;\nvoid main() { gl_FragColor = vec4(vec3(float(FaceIndex) * .03), 1.); }\n");
        fragment("block.frag",
                 "layout(std140) uniform Mine { vec4 values[8]; };\nvoid main() { gl_FragColor = "
                 "vec4(values[0].rgb + values[5].rgb, 1.); }\n");
        fragment("values.frag",
                 "uniform vec4 uA;\nuniform int uI;\nvoid main() { gl_FragColor = uA + float(uI) * .1; }\n");
        const std::string view = "Ortho -1 1 -1 1\nVertex plain.vert\n";
        std::string all =
            "Background .9 .1 .7\nFilter nearest\nClamp\nTexture2D 6 red.bmp\nCubeMap 6 red.bmp red.bmp "
            "red.bmp red.bmp red.bmp red.bmp\n" +
            view +
            "Fragment maps.frag\nProgram M a 6 b 6 c 3\nQuadXY\n"
            "Fragment faces.frag\nProgram F\nSoccerball\nFragment values.frag\nProgram V uA [.3 .4 .5 .6] uI 7\n"
            "QuadXY 0 .5\nVertex\nFragment\nProgram\nLineWidth 9\nPointSize 30\nWireframe on\nSphere .7\n"
            "CullFace front\nDepthTest off\nDepthWrite off\nBlend dst_color one\nColor .2 .9 .1 .4\nQuadXY\n"
            "PointSizeMode 1\nPointCloud 3 3 3\n";
        for (int i = 0; i < 20; ++i) all += "Translate .1 0 0\nSphere .3 8 8\n";
        trap("all", all);
        for (const char* name : {"maps", "faces", "block", "values"})
            trap(name, view + "Fragment " + name + ".frag\nProgram P\nQuadXY 0 .8\n");
        // Values that a shader never gives.
        fragment("nothing.frag", "void main() { }\n");
        fragment("local.frag", "void main() { vec4 c; gl_FragColor = c; }\n");
        fragment("colors.frag", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(vST, .5, 1.); }\n");
        fragment("show.frag", "uniform sampler2D t;\nvoid main() { gl_FragColor = vec4(texture(t, vST).rgb, 1.); }\n");
        fragment("st.frag", "void main() { gl_FragColor = vec4(vST, .5, 1.); }\n");
        folder.write(
            "never.vert",
            "#version 330 compatibility\nout vec2 vST;\nvoid main() { if (gl_Vertex.x > 0.) vST.x = .4; gl_Position = "
            "gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
        for (const char* name : {"nothing", "local"})
            trap(name, view + "Fragment " + name + ".frag\nProgram P\nQuadXY 0 .8\n");
        trap("never", "Ortho -1 1 -1 1\nVertex never.vert\nFragment st.frag\nProgram P\nQuadXY 0 .8\n");
        trap("colors", "Texture2D 7 16 16\nTexture2D 8 16 16\n" + view +
                           "Fragment colors.frag\nProgram C\nRenderToTexture 7 8\n"
                           "QuadXY\nRenderToTexture\nFragment show.frag\nProgram S t 8\nQuadXY\n");
        trap("lines", "Perspective 60\nLookAt 0 0 4\nWireSphere 1\nPointCloud 3 3 3\n");
        trap("undrawn", "Texture2D 7 16 16\n" + view + "Fragment maps.frag\nProgram P a 7\nQuadXY\n");
    }
    void trap(const std::string& name, const std::string& text) { traps.push_back(folder.write(name + ".glib", text)); }

    std::vector<std::string> scenes() const {
        std::vector<std::string> found;
        for (const char* root : {"scenes", "tests/cases", "tests/odd", "tests/bad"})
            for (const auto& entry : std::filesystem::recursive_directory_iterator(SNELL_ROOT "/" + std::string(root)))
                if (entry.path().extension() == ".glib") found.push_back(entry.path().string());
        std::ranges::sort(found);
        return found;
    }
    // By scene; those that can't be drawn are left out.
    std::map<std::string, Drawn> render(const std::vector<std::string>& list, const std::string& options) const {
        std::string names;
        for (const std::string& scene : list) names += " '" + scene + "'";
        const Outcome outcome = snell("render -q" + names + " --size 64x48 " + options + " --json " +
                                      folder.path("all.json") + " -o '" + folder.path("p{index}.png") + "'");
        EXPECT_LE(outcome.status, 1) << outcome.output;
        std::map<std::string, Drawn> result;
        const auto json = nlohmann::json::parse(bytes_of(folder.path("all.json")), nullptr, false);
        if (json.is_discarded()) return result;
        for (const auto& picture : json["pictures"])
            result[picture["scene"]] = {bytes_of(picture["file"]), picture["sha256"]};
        return result;
    }
    void compare(const std::vector<std::string>& list, const std::string& options) {
        const auto drawn = render(list, options);
        for (const std::string& scene : list) {
            auto& expected = alone[options];
            if (!expected.contains(scene)) expected[scene] = render({scene}, options)[scene];
            const auto found = drawn.find(scene);
            const Drawn got = found == drawn.end() ? Drawn{} : found->second;
            EXPECT_TRUE(got.bytes == expected[scene].bytes) << scene << ' ' << options;
            EXPECT_EQ(got.hash, expected[scene].hash) << scene << ' ' << options;
            pictures += got.bytes.empty() ? 0 : 1;
        }
    }

    std::vector<std::string> traps;
    std::map<std::string, std::map<std::string, Drawn>> alone;  // by options and scene
    unsigned pictures = 0;
};

TEST_F(Orders, ChangeNoPicture) {
    const unsigned wanted = torture::number_of("SNELL_ORDERS", 20);
    write_traps();
    std::mt19937 random(7);
    const std::vector<std::string> all = scenes(),
                                   contexts{"", "--context es3.2 --samples 4", "--context 3.3 --transparent"};
    for (unsigned round = 0; pictures < wanted; ++round) {
        std::vector<std::string> list = all;
        std::shuffle(list.begin(), list.end(), random);
        if (wanted < 2 * list.size()) list.resize(std::min<std::size_t>(list.size(), wanted / 4));
        for (const std::string& one : traps) list.push_back(one);
        std::shuffle(list.begin(), list.end(), random);
        list.insert(list.begin(), traps.front());
        const std::size_t size = list.size() / (round % 4 == 3 ? 5 : 1) + 1;  // by one process, or by several
        for (std::size_t first = 0; first < list.size(); first += size)
            compare({list.begin() + static_cast<std::ptrdiff_t>(first),
                     list.begin() + static_cast<std::ptrdiff_t>(std::min(list.size(), first + size))},
                    contexts[round % contexts.size()]);
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
    RecordProperty("pictures", static_cast<int>(pictures));
}

// Constant coordinates that are NaN, which a misspelt varying makes, at every stage; nothing is bound.
TEST_F(Orders, NoConstantThatIsNaNEndsTheProcess) {
    struct Lookup {
        std::string_view sampler, value, lod;
    };
    constexpr Lookup lookups[]{{"sampler2D", "texture(t, c.xy)", "textureLod(t, c.xy, 0.)"},
                               {"samplerCube", "texture(t, c)", "textureLod(t, c, 0.)"},
                               {"sampler3D", "texture(t, c)", "textureLod(t, c, 0.)"},
                               {"sampler1D", "texture(t, c.x)", "textureLod(t, c.x, 0.)"},
                               {"isampler2D", "vec4(texture(t, c.xy))", "vec4(textureLod(t, c.xy, 0.))"},
                               {"sampler2DShadow", "vec4(texture(t, c))", "vec4(textureLod(t, c, 0.))"}};
    constexpr std::string_view sources[]{"normalize(vec3(0.))", "vec3(0. / 0.)", "vec3(sqrt(-1.), .5, .5)",
                                         "vec3(pow(-1., .5))", "normalize(vMisspelt)"};
    std::string names;
    int variants = 0;
    for (const Lookup& lookup : lookups)
        for (const std::string_view source : sources)
            for (const bool vertex : {false, true}) {
                if (vertex && source.find("vMisspelt") != std::string_view::npos) continue;
                const std::string name = "nan" + std::to_string(variants++),
                                  coordinate = "vec3 c = " + std::string(source) + "; ",
                                  sampler = "uniform " + std::string(lookup.sampler) + " t;\n";
                const std::string head = "#version 330 compatibility\n";
                folder.write(name + ".vert",
                             head + "out vec4 vColor;\n" + (vertex ? sampler : "") + "void main() { " +
                                 (vertex ? coordinate + "vColor = " + std::string(lookup.lod) : "vColor = vec4(1.)") +
                                 "; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
                folder.write(name + ".frag", head + "in vec4 vColor;\nin vec3 vMisspelt;\n" + (vertex ? "" : sampler) +
                                                 "void main() { " +
                                                 (vertex ? "gl_FragColor = vColor"
                                                         : coordinate + "gl_FragColor = " + std::string(lookup.value)) +
                                                 "; }\n");
                names += " " + folder.write(name + ".glib", "Vertex " + name + ".vert\nFragment " + name +
                                                                ".frag\nProgram P t 5\nQuadXY\n");
            }
    EXPECT_GE(variants, 30);
    // And without any vertex shader.
    folder.write("bare.frag",
                 "uniform samplerCube t;\nin vec3 vN;\nvoid main() { gl_FragColor = texture(t, normalize(vN)); }\n");
    names += " " + folder.write("bare.glib", "Fragment bare.frag\nProgram P\nSphere 1\n");
    // The others compile the same; ./dev torture has them all.
    const bool all = torture::number_of("SNELL_ORDERS", 20) > 20;
    for (const char* context : {"4.5", "es3.2", "3.3", "es3.0"}) {
        if (!all && context != std::string_view("4.5") && context != std::string_view("es3.2")) continue;
        const Outcome outcome = snell("render -q" + names + " --size 16x16 --context " + std::string(context) +
                                      " -o '" + folder.path("{stem}.png") + "'");
        EXPECT_EQ(outcome.status, 0) << context << '\n' << outcome.output;
    }
}

}  // namespace
}  // namespace snell::test
