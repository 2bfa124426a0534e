// Changes of shaders, drawn: the driver takes them, and the pictures change as much as the changes say.
#include "src/accuracy/found/shaders/shader.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

using accuracy::Change;
using accuracy::ChangeKind;

class FoundShadersGl : public GlTest {
protected:
    // Opens the scene and finds its changes.
    std::unique_ptr<Document> find(const std::string& path) {
        changes.clear();
        return open_document(path, caps, nullptr, [&](const Plan& plan, Document& document) {
            accuracy::add_shader_changes({plan, *document.files, document.sources}, changes);
        });
    }
    // Opens it again with changes.
    std::unique_ptr<Document> changed(const Document& document, const std::vector<const Change*>& made) {
        Access access;
        access.instead =
            std::make_shared<const std::map<std::string, std::string>>(accuracy::changed_texts(made, document.sources));
        return open_document(document.path, caps, nullptr, nullptr, {}, access);
    }
    std::string scene(const std::string& vertex, const std::string& fragment, const std::string& values = "") {
        folder.write("a.vert", vertex);
        folder.write("a.frag", fragment);
        return folder.write(
            "a.glib", "Ortho -1. 1. -1. 1.\nVertex a.vert\nFragment a.frag\nProgram A " + values + "\nQuadXY 0. 1.\n");
    }
    // The largest difference of a channel that a change of the kind makes; -1: there is none.
    int difference(const std::string& path, ChangeKind kind, const std::string& before) {
        const auto document = find(path);
        expect_clean(*document);
        const auto change = std::find_if(changes.begin(), changes.end(), [&](const Change& c) {
            return c.kind == kind && c.before.find(before) != std::string::npos;
        });
        if (change == changes.end()) return -1;
        const auto with = changed(*document, {&*change});
        expect_clean(*with);
        const Picture a = draw(*document), b = draw(*with);
        int most = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i)
            most = std::max(most, std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i])));
        return most;
    }
    std::vector<Change> changes;
};

const std::string vertex =
    "varying vec3 vP;\nvarying vec2 vST;\nvoid main() {\n    vP = gl_Vertex.xyz;\n    vST = gl_MultiTexCoord0.st;\n"
    "    gl_Position = ftransform();\n}\n";

TEST_F(FoundShadersGl, LinearWorkMovesToTheVertexShaderWithoutChange) {
    const std::string path =
        scene(vertex,
              "varying vec3 vP;\nuniform mat3 uM;\nuniform float uA;\nvoid main() {\n"
              "    vec3 c = .5 + uA * (.3 * vP + .2 * vP.zxy * uA);\n    gl_FragColor = vec4(c, 1.);\n}\n",
              "uA <0. 1. 2.>");
    EXPECT_EQ(difference(path, ChangeKind::per_vertex, "vP.zxy"), 0);
}

TEST_F(FoundShadersGl, CurvedWorkChangesBetweenTheVertices) {
    EXPECT_GT(
        difference(scene(vertex, "varying vec3 vP;\nvoid main() { gl_FragColor = vec4(vec3(length(vP)), 1.); }\n"),
                   ChangeKind::per_vertex, "length"),
        50);
}

TEST_F(FoundShadersGl, WorkOnUniformsIsTheSameAtEveryVertex) {
    EXPECT_EQ(difference(scene(vertex,
                               "varying vec3 vP;\nuniform float uA;\nvoid main() { vec3 c = vP; c *= sin(uA); "
                               "gl_FragColor = vec4(abs(c), 1.); }\n",
                               "uA <0. 1. 2.>"),
                         ChangeKind::per_frame, "sin(uA)"),
              0);
}

TEST_F(FoundShadersGl, PolynomialsAreAsExactAsTheySay) {
    for (const std::string call : {"sin(9. * vP.x)", "cos(9. * vP)", "exp(-vP.x - 1.)", "acos(vP.y) / 3.2",
                                   "asin(vP) * .5", "atan(3. * vP.x) * .5", "atan(vP.y, vP.x) / 3.2", "pow(vST.x, 2.2)",
                                   "pow(abs(vP), vec3(.4545))", "pow(vST.x, uShine)", "pow(vST, vec2(7.))"}) {
        const std::string shader =
            "varying vec3 vP;\nvarying vec2 vST;\nuniform float uShine;\nvoid main() { gl_FragColor = "
            "vec4(vec3(length(" +
            call + ")), 1.); }\n";
        const int most =
            difference(scene(vertex, shader, "uShine 20."), ChangeKind::polynomial, call.substr(0, call.find(')')));
        EXPECT_GE(most, 0) << call;
        EXPECT_LE(most, call.find("uShine") == std::string::npos ? 1 : 6) << call;
    }
}

TEST_F(FoundShadersGl, AMeanOfFewerSamplesOfOneValueIsTheSame) {
    const std::string path =
        scene(vertex,
              "varying vec3 vP;\nvoid main() {\n    vec3 c = vec3(0.);\n    for (int i = 0; i < 16; ++i)\n"
              "        c += abs(vP);\n    gl_FragColor = vec4(c / 16., 1.);\n}\n");
    EXPECT_EQ(difference(path, ChangeKind::fewer_rounds, "i < 16"), 0);
}

// All changes of some scenes compile, in sets that can be made together.
TEST_F(FoundShadersGl, TheDriverTakesWhatIsOffered) {
    for (const std::string name : {"light/globe/globe", "light/glass/glass", "light/spectrum/spectrum",
                                   "light/crystal/crystal", "refraction-room/refraction-room"}) {
        const auto document = find(SNELL_ROOT "/scenes/" + name + ".glib");
        std::vector<std::vector<const Change*>> sets;
        for (const Change& change : changes) {
            const auto fits = [&](const std::vector<const Change*>& set) {
                return std::all_of(set.begin(), set.end(), [&](const Change* c) { return compatible(*c, change); });
            };
            const auto set = std::find_if(sets.begin(), sets.end(), fits);
            (set == sets.end() ? sets.emplace_back() : *set).push_back(&change);
        }
        EXPECT_GE(changes.size(), 10U) << name;
        for (const auto& set : sets) expect_clean(*changed(*document, set));
    }
}

}  // namespace
}  // namespace snell::test
