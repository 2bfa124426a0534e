// Shaders in the names of gstap.h and in the built-in ones are the same picture.
#include "tests/harness/harness.h"
#include "tests/pattern.h"

namespace snell::test {
namespace {

class Gstap : public GlTest, public testing::WithParamInterface<ContextRequest> {
protected:
    Gstap() { request = GetParam(); }

    static std::string in_built_in_names(std::string text) {
        text = replaced(text, R"(\bu(\w+Matrix(Inverse)?)\b)", "gl_$");
        text = replaced(text, "\\baTexCoord([0-9])", "gl_MultiTexCoord$");
        return replaced(text, R"(\ba(Vertex|Normal|Color)\b)", "gl_$");
    }
    struct Shaders {
        std::string vertex, fragment, geometry;
    };
    // Draws the scene with the shaders as they are and in gl_ names; the picture of both.
    Picture expect_same(const std::string& scene, const Shaders& s, const Look& look = {}) {
        Picture first;
        std::uint64_t draws = 0;
        for (const bool gstap : {true, false}) {
            const auto text = [&](const std::string& t) { return gstap ? t : in_built_in_names(t); };
            folder.write("p.vert", text(s.vertex));
            folder.write("p.frag", text(s.fragment));
            std::string program = "Vertex p.vert\nFragment p.frag\n";
            if (!s.geometry.empty()) {
                folder.write("p.geom", text(s.geometry));
                program += "Geometry p.geom\n";
            }
            auto document = open("Perspective 60\nLookAt 0 .5 4 0 0 0 0 1 0\n" + program + "Program P\n" + scene);
            expect_clean(*document);
            EXPECT_TRUE(document->diagnostics.empty()) << render(document->diagnostics, document->sources);
            const Picture picture = draw(*document, look);
            if (gstap) {
                first = picture;
                draws = document->runtime->counters().draws;
                EXPECT_LT(picture.count(picture.at(0, 0)), 64 * 64 - 60) << "something is drawn";
                continue;
            }
            EXPECT_TRUE(first == picture);
            EXPECT_EQ(document->runtime->counters().draws, draws);
        }
        return first;
    }
};

const std::string white_fragment = "void main() { gl_FragColor = vec4(1.); }\n";

TEST_P(Gstap, TheShortestShaderThereIs) {
    const std::string vertex = "void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n";
    const Picture plain = expect_same("Teapot\n", {vertex, white_fragment, {}});
    EXPECT_TRUE(expect_same("GSTAP\nTeapot\n", {vertex, white_fragment, {}}) == plain);
    EXPECT_TRUE(expect_same("Teapot\n", {"#include \"gstap.h\"\n" + vertex, white_fragment, {}}) == plain);
}

const std::string lit_vertex =
    "varying vec3 vN, vE;\nvarying vec4 vColor;\nvarying vec2 vST;\nvoid main() {\n"
    "    vN = normalize(uNormalMatrix * aNormal);\n    vE = (uModelViewMatrix * aVertex).xyz;\n"
    "    vColor = aColor;\n    vST = aTexCoord0.st + .1 * aTexCoord3.ts;\n"
    "    gl_Position = uProjectionMatrix * uModelViewMatrix * aVertex;\n}\n";
const std::string lit_fragment =
    "varying vec3 vN, vE;\nvarying vec4 vColor;\nvarying vec2 vST;\nvoid main() {\n"
    "    vec3 o = (uModelViewMatrixInverse * vec4(vE, 1.)).xyz;\n"
    "    gl_FragColor = vec4(.5 + .5 * vN, 1.) * vColor + vec4(.1 * o.xy, .3 * vST.s, 0.);\n}\n";

TEST_P(Gstap, MatricesAttributesAndTheCurrentColour) {
    const std::string scene =
        "Color .9 .4 .7\nTranslate .3 .2 -.5\nRotate 35 1 2 0\nScale 1 .6 1.4\nTeapot\nColor .2 .8 1\nPointSize 5\n"
        "PointCloud 3 3 3\nTranslate -1 0 0\nSphere .5 20 20\n";
    Look look;
    look.view.scene.rotate_y = 30;
    look.view.objects[0].x = .4;
    expect_same(scene, {lit_vertex, lit_fragment, {}}, look);
    for (const char* version : {"#version 120\n", "#version 330 compatibility\n", "#version 400 compatibility\n"})
        expect_same(scene, {version + lit_vertex, version + lit_fragment, {}}, look);
    const Picture red =
        expect_same("Color 1 0 0\nSphere 1\n", {"varying vec4 c;\nvoid main() { c = aColor; gl_Position = "
                                                "uModelViewProjectionMatrix * aVertex; }\n",
                                                "varying vec4 c;\nvoid main() { gl_FragColor = c; }\n",
                                                {}});
    EXPECT_TRUE(near(red.center(), {255, 0, 0, 255}));
}

TEST_P(Gstap, GeometryShadersHaveTheMatrices) {
    if (!caps.geometry) GTEST_SKIP() << "no geometry shaders here";
    expect_same("Teapot\n",
                {"void main() { gl_Position = uModelViewMatrix * aVertex; }\n", white_fragment,
                 "#version 330 compatibility\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
                 "void main() {\n    for (int n = 0; n < 3; ++n) {\n        vec4 p = gl_in[n].gl_Position;\n"
                 "        p.xyz += .1 * uNormalMatrix * vec3(1.);\n        gl_Position = uProjectionMatrix * p;\n"
                 "        EmitVertex();\n    }\n    EndPrimitive();\n}\n"});
}

TEST_P(Gstap, DeclaredAndUndeclaredAreTheSame) {
    const std::string undeclared = "void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n";
    const Picture a = expect_same("Teapot\n", {undeclared, white_fragment, {}});
    folder.write("p.vert", "uniform mat4 uModelViewProjectionMatrix;\nattribute vec4 aVertex;\n" + undeclared);
    EXPECT_TRUE(draw(*open_file(folder.path("scene.glib"))) == a);
}

INSTANTIATE_TEST_SUITE_P(Contexts, Gstap, all_contexts, context_name);

}  // namespace
}  // namespace snell::test
