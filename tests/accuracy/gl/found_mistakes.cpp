// The eight mistakes of docs/teaching.md that rungs of scenes/light show, in scenes without ladders: each is found as a
// better rung, with the error that the scene has against the form that is right.
#include "src/accuracy/found/change.h"
#include "tests/accuracy/gl/common.h"

namespace snell::test {
namespace {

using namespace accuracy;

using Texts = std::map<std::string, std::string>;

constexpr std::string_view world_vertex = R"(#version 330
uniform mat4 PVM, M, uModelViewerMatrix;
in vec4 position;
in vec4 normal;
out vec3 vPosition, vNormal, vFromEye;
void main() {
    vPosition = vec3(M * position);
    vNormal = vec3(M * normal);
    vFromEye = vec3(uModelViewerMatrix * position);
    gl_Position = PVM * position;
}
)";
constexpr std::string_view eye_vertex = R"(#version 330 compatibility
out vec3 vPosition, vNormal, vFromEye;
void main() {
    vPosition = gl_Vertex.xyz;
    vNormal = normalize(gl_NormalMatrix * gl_Normal);
    vFromEye = (gl_ModelViewMatrix * gl_Vertex).xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)";

class FoundMistakes : public AccuracyTest {
protected:
    static std::string fragment(std::string_view body) {
        return "#version 330 compatibility\nuniform samplerCube uRoom;\nuniform float uIndex;\nin vec3 vPosition, "
               "vNormal, "
               "vFromEye;\nvoid main() {\n    vec3 e = normalize(vFromEye), n = normalize(vNormal);\n    vec3 "
               "color;\n" +
               std::string(body) + "    gl_FragColor = vec4(color, 1.);\n}\n";
    }

    // A ball in the furnished room; `around`: what is drawn before it.
    void write(std::string_view wrong, std::string_view vertex = world_vertex, std::string_view around = "") {
        const std::string room = SNELL_ROOT "/scenes/environments/room/";
        std::string faces;
        for (const char* face : {"posx", "negx", "posy", "negy", "posz", "negz"}) faces += " " + room + face + ".bmp";
        folder.write("ball.vert", vertex);
        folder.write("ball.frag", fragment(wrong));
        path_ = folder.write("scene.glib", "Perspective 50\nLookAt 1.6 .9 3.2  0 0 0  0 1 0\n" + std::string(around) +
                                               "CubeMap 6" + faces +
                                               " raw\nVertex ball.vert\nFragment ball.frag\nProgram "
                                               "Ball uRoom 6 uIndex <1. 1.5 2.5>\nSphere 1.2 60 60\n");
    }

    accuracy::Picture picture(const Texts& instead) {
        Access access;
        access.instead = std::make_shared<const Texts>(instead);
        Read now;
        now.files = std::make_unique<Files>(scene_folder(path_), access);
        now.plan = read_plan(path_, *now.files, now.sources, now.diagnostics).value();
        Bench drawn(now.plan, *now.files, now.sources, caps, BenchSettings{160, 160, 0, {}});
        const auto picture = drawn.picture({now.plan.rungs, {}});
        EXPECT_FALSE(drawn.problems().has_errors()) << render(drawn.problems(), now.sources);
        return picture.value_or(accuracy::Picture{});
    }

    std::vector<Change> find(Sources& sources) {
        Files files(scene_folder(path_));
        Diagnostics diagnostics;
        return find_changes(read_plan(path_, files, sources, diagnostics).value(), files, sources);
    }

    // The last of the changes that the lint advises, or of that kind: the one that makes all of its edits.
    void expect_found(ChangeKind kind, std::string_view lint, std::string_view right,
                      std::string_view vertex = world_vertex) {
        Sources sources;
        const std::vector<Change> changes = find(sources);
        const Change* found = nullptr;
        for (const Change& change : changes)
            if (change.kind == kind && change.lint == lint && (!found || change.edits.size() >= found->edits.size()))
                found = &change;
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(facts(found->kind).aim, Aim::better);
        const accuracy::Picture wrong = picture({});
        const accuracy::Picture better = picture(changed_texts(std::span(&found, 1), sources));
        const accuracy::Picture truth =
            picture({{folder.path("ball.frag"), fragment(right)}, {folder.path("ball.vert"), std::string(vertex)}});
        const double error = compare(wrong, truth).light.rmse, shown = compare(wrong, better).light.rmse;
        EXPECT_GT(error, .002);
        EXPECT_NEAR(shown, error, .1 * error) << found->after;
        EXPECT_LT(compare(better, truth).light.rmse, .1 * error) << found->after;
    }

    // Every better change of the scene compiles.
    void expect_compiled(std::size_t at_least) {
        Sources sources;
        const std::vector<Change> changes = find(sources);
        std::size_t better = 0;
        for (const Change& change : changes) {
            if (facts(change.kind).aim != Aim::better) continue;
            ++better;
            SCOPED_TRACE(change.after);
            const Change* one = &change;
            EXPECT_GT(picture(changed_texts(std::span(&one, 1), sources)).pixels(), 0u);
        }
        EXPECT_GE(better, at_least);
    }

    std::string path_;
};

constexpr std::string_view mixed =
    "    color = mix(texture(uRoom, refract(e, n, .66)).rgb, texture(uRoom, reflect(e, n)).rgb, k);\n";

std::string with_share(std::string_view share) {
    return "    float f = .04, c = clamp(-dot(e, n), 0., 1.);\n    float k = " + std::string(share) + ";\n" +
           std::string(mixed);
}

TEST_F(FoundMistakes, DirectionsOfUnitLength) {
    write("    color = texture(uRoom, refract(vFromEye, vNormal, .66)).rgb;\n");
    expect_found(ChangeKind::unit_length, "unnormalised-direction",
                 "    color = texture(uRoom, refract(e, n, .66)).rgb;\n");
}

TEST_F(FoundMistakes, TheSpaceOfACubeMap) {
    write("    color = texture(uRoom, reflect(e, n)).rgb;\n", eye_vertex);
    expect_found(ChangeKind::lint_fix, "eye-space-lookup", "    color = texture(uRoom, reflect(e, n)).rgb;\n");
}

TEST_F(FoundMistakes, ARoomIsNotInfinitelyFar) {
    write("    color = texture(uRoom, reflect(e, n)).rgb;\n", world_vertex,
          "Include " SNELL_ROOT "/scenes/environments/room.inc\n");
    expect_found(
        ChangeKind::box_projection, "",
        "    vec3 way = reflect(e, n), walls = (5. - sign(way) * vPosition) / abs(way);\n    color = texture(uRoom, "
        "vPosition + min(walls.x, min(walls.y, walls.z)) * way).rgb;\n");
}

TEST_F(FoundMistakes, AnIndexIsNotARatio) {
    write("    color = texture(uRoom, refract(e, n, uIndex)).rgb;\n");
    expect_found(ChangeKind::lint_fix, "index-as-ratio",
                 "    color = texture(uRoom, refract(e, n, 1. / uIndex)).rgb;\n");
}

TEST_F(FoundMistakes, TheSignInSchlicksFormula) {
    write(with_share("f + (1. - f) * pow(1. + dot(-e, n), 5.)"));
    expect_found(ChangeKind::lint_fix, "schlick-sign", with_share("f + (1. - f) * pow(1. - c, 5.)"));
}

TEST_F(FoundMistakes, TheSignInASquareThatIsMultiplied) {
    write(with_share("f + (1. - f) * (1. + c) * (1. + c)"));
    expect_found(ChangeKind::lint_fix, "schlick-sign", with_share("f + (1. - f) * (1. - c) * (1. - c)"));
}

TEST_F(FoundMistakes, ComputedAndNotUsed) {
    const auto mixed_by = [](std::string_view share) {
        return "    float f = .04, c = clamp(-dot(e, n), 0., 1.);\n    float schlick = f + (1. - f) * pow(1. - c, "
               "5.);\n    "
               "color = mix(texture(uRoom, refract(e, n, .66)).rgb, texture(uRoom, reflect(e, n)).rgb, " +
               std::string(share) + ");\n";
    };
    write(mixed_by("f"));
    expect_found(ChangeKind::lint_fix, "never-read", mixed_by("schlick"));
}

TEST_F(FoundMistakes, PowerTwoIsNotSchlicks) {
    write(with_share("f + (1. - f) * pow(1. - c, 2.)"));
    expect_found(ChangeKind::lint_fix, "", with_share("f + (1. - f) * pow(1. - c, 5.)"));
    // The exact equations for n = 1.5, of which f0 is .04.
    expect_found(
        ChangeKind::exact_fresnel, "",
        "    float c = clamp(-dot(e, n), 1e-4, 1.), t = sqrt(1.25 + c * c), s = (c - t) / (c + t), p = (2.25 * c - "
        "t) / (2.25 * c + t);\n    float k = .5 * (s * s + p * p);\n" +
            std::string(mixed));
}

TEST_F(FoundMistakes, BlueIsBentMost) {
    const auto split = [](std::string_view red, std::string_view blue) {
        return "    float eta = .66;\n    color.r = texture(uRoom, refract(e, n, " + std::string(red) +
               ")).r;\n    color.g = texture(uRoom, refract(e, n, eta + .01)).g;\n    color.b = texture(uRoom, "
               "refract(e, n, " +
               std::string(blue) + ")).b;\n";
    };
    write(split("eta", "eta + .02"));
    expect_found(ChangeKind::lint_fix, "dispersion-order", split("eta + .02", "eta"));
}

TEST_F(FoundMistakes, LightIsBentWhereItLeavesToo) {
    write("    vec3 inside = refract(e, n, 1. / uIndex);\n    color = texture(uRoom, inside).rgb;\n");
    expect_found(
        ChangeKind::both_interfaces, "",
        "    vec3 inside = refract(e, n, 1. / uIndex);\n    color = texture(uRoom, 2. * dot(inside, e) * inside - "
        "e).rgb;\n");
}

// Every better change of a shader with many of the mistakes draws.
TEST_F(FoundMistakes, WhatIsWrittenCompiles) {
    write(
        "    float f = .04, sum = 0.;\n    for (int i = 0; i < 4; i++) sum += pow(dot(n, -e), 3.) / 4.;\n    float k = "
        "f + (1. "
        "- f) * pow(1. - dot(n, -e), 2.) + 1e-9 * sum;\n    color = mix(texture(uRoom, refract(vFromEye, n, "
        "uIndex)).rgb, "
        "texture(uRoom, reflect(e, vNormal)).rgb, k) + smoothstep(.5, .5, k);\n",
        world_vertex, "Include " SNELL_ROOT "/scenes/environments/room.inc\n");
    expect_compiled(10);
}

// In the dialects of old shaders, too.
TEST_F(FoundMistakes, WhatIsWrittenCompilesInOldDialects) {
    for (const std::string version : {"", "#version 120\n"}) {
        SCOPED_TRACE(version);
        write("", world_vertex, "Include " SNELL_ROOT "/scenes/environments/room.inc\n");
        folder.write("ball.vert",
                     version +
                         "varying vec3 vNormal, vFromEye;\nuniform mat4 uModelViewerMatrix;\nvoid main() {\n   "
                         " vNormal = gl_Normal;\n    vFromEye = vec3(uModelViewerMatrix * gl_Vertex);\n    "
                         "gl_Position = ftransform();\n}\n");
        folder.write("ball.frag",
                     version +
                         "varying vec3 vNormal, vFromEye;\nuniform samplerCube uRoom;\nuniform float "
                         "uIndex;\nvoid main() {\n    vec3 e = normalize(vFromEye), n = normalize(vNormal);\n   "
                         " float k = .04 + .96 * pow(1. - max(dot(n, -e), 0.), 2.);\n    gl_FragColor = "
                         "mix(textureCube(uRoom, refract(e, n, uIndex)), textureCube(uRoom, reflect(vFromEye, "
                         "vNormal)), k);\n}\n");
        expect_compiled(7);
    }
}

}  // namespace
}  // namespace snell::test
