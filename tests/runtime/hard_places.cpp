// Hard cases of places, times and shaders that the language leaves undefined, in each kind of context.
#include <fmt/format.h>

#include "tests/hard_case.h"
#include "tests/oracle/optics/cube.h"
#include "tests/oracle/optics/refraction.h"
#include "tests/runtime/hard_frames.h"

namespace snell::test {
namespace {

class HardPlaces : public HardFrames {
protected:
    // Six pictures of the colour 128 + 100 times the direction; returns their names.
    std::string write_directions(int size) {
        std::string names;
        for (int face = 0; face < 6; ++face) {
            std::vector<std::array<int, 3>> texels;
            for (int row = 0; row < size; ++row)
                for (int column = 0; column < size; ++column) {
                    const optics::CubePoint at{face, (column + .5) / size, (row + .5) / size};
                    const glm::dvec3 d = 128. + 100. * *optics::unit(optics::cube_direction(at));
                    texels.push_back({static_cast<int>(std::lround(d.x)), static_cast<int>(std::lround(d.y)),
                                      static_cast<int>(std::lround(d.z))});
                }
            folder.write("face" + std::to_string(face) + ".bmp", bmp(size, size, texels));
            names += " face" + std::to_string(face) + ".bmp";
        }
        return names;
    }
    // A ball at (far, far, far), drawn by these shaders and seen from near it.
    std::vector<float> ball(std::string_view vertex, std::string_view fragment, double far) {
        return values(
            fmt::format("Perspective 42\nLookAt {} {} {}  {} {} {}  0 1 0\nVertex {}\nFragment {}\nProgram P\n"
                        "Translate {} {} {}\nRotate 30 0 1 0\nSphere 1 40 40\n",
                        far + 1.3, far + .75, far + 3.5, far, far, far, vertex, fragment, far, far, far));
    }
};

// The largest angle between the directions of two pictures, where both have one.
double turned(const std::vector<float>& a, const std::vector<float>& b) {
    double worst = 0;
    int both = 0;
    for (std::size_t i = 0; i + 3 < a.size(); i += 4) {
        const glm::dvec3 one(a[i], a[i + 1], a[i + 2]), other(b[i], b[i + 1], b[i + 2]);
        if (glm::length(one) < .5 || glm::length(other) < .5) continue;  // the background
        ++both;
        worst = std::max(worst, optics::angle_between(one, other));
    }
    EXPECT_GT(both, 1000);
    return worst;
}

TEST_P(HardPlaces, MirrorsAMillionUnitsAway) {
    const auto fragment = [](const char* from_eye, const char* normal) {
        return std::string("#version 330\nin vec3 ") + from_eye + ", " + normal + ";\nout vec4 color;\nvoid main() { " +
               "color = vec4(reflect(normalize(" + from_eye + "), normalize(" + normal + ")), 1.); }\n";
    };
    folder.write("direction.frag", fragment("vFromEye", "vNormal"));
    folder.write("underscored.frag", fragment("v_fromEye", "v_normal"));
    folder.write("naive.vert",
                 "#version 330\nuniform mat4 PVM, M;\nuniform vec3 camWorldPos;\nin vec4 position, normal;\n"
                 "out vec3 vFromEye, vNormal;\nvoid main() { vNormal = vec3(M * normal);\n"
                 "vFromEye = vec3(M * position) - camWorldPos; gl_Position = PVM * position; }\n");
    const std::string light = SNELL_ROOT "/scenes/light/";
    double worst = 0;
    for (const auto& [vertex, drawn] : {std::pair<std::string, const char*>{"world.vert", "direction.frag"},
                                        {"crystal/crystal.vert", "underscored.frag"},
                                        {"reflectivity/reflectivity.vert", "underscored.frag"}})
        worst = std::max(worst, turned(ball(light + vertex, drawn, 0), ball(light + vertex, drawn, 1e6)));
    hard_case({"A42", "mirrors a million units away, by the shipped scenes' shaders; naive: M * position - camWorldPos",
               "rad", 1e-5, worst,
               turned(ball("naive.vert", "direction.frag", 0), ball("naive.vert", "direction.frag", 1e6))});
}

// The room's centre is the ball's, as in scenes/light.
TEST_P(HardPlaces, ARoomAMillionUnitsAway) {
    const auto vertex = [](const char* in_room, const char* from_eye) {
        return std::string(
                   "#version 330\nuniform mat4 PVM, M, uModelViewerMatrix;\nuniform vec3 camWorldPos;\n"
                   "in vec4 position, normal;\nout vec3 vInRoom, vFromEye, vNormal;\nvoid main() {\n"
                   "vNormal = vec3(M * normal); vInRoom = ") +
               in_room + "; vFromEye = " + from_eye + "; gl_Position = PVM * position; }\n";
    };
    folder.write("ours.vert", vertex("mat3(M) * position.xyz", "vec3(uModelViewerMatrix * position)"));
    folder.write("naive.vert", vertex("vec3(M * position)", "vec3(M * position) - camWorldPos"));
    const auto fragment = [](const char* centre) {
        return std::string(
                   "#version 330\n#include <snell/environment.glsl>\nuniform mat4 M;\nin vec3 vInRoom, vFromEye, "
                   "vNormal;\n"
                   "out vec4 color;\nvoid main() { vec3 d = reflect(normalize(vFromEye), normalize(vNormal));\n"
                   "color = vec4(snellBoxDirection(vInRoom, d, vec3(5.), ") +
               centre + "), 1.); }\n";
    };
    folder.write("ours.frag", fragment("vec3(0.)"));
    folder.write("naive.frag", fragment("M[3].xyz"));
    hard_case({"A43", "walls of a room a million units away, by box projection; naive: in world coordinates", "rad",
               1e-5, turned(ball("ours.vert", "ours.frag", 0), ball("ours.vert", "ours.frag", 1e6)),
               turned(ball("naive.vert", "naive.frag", 0), ball("naive.vert", "naive.frag", 1e6))});
}

// The scene transformation is multiplied into the projection, so that it moves the viewer in the world.
TEST_P(HardPlaces, TheViewerInTheWorldOfATurnedScene) {
    folder.write("eye.vert",
                 "uniform mat4 M, uModelViewerMatrix;\nuniform vec3 camWorldPos;\nuniform int uBy;\nout vec3 vRay;\n"
                 "void main() { vec3 p = vec3(M * gl_Vertex);\nvRay = uBy == 0 ? vec3(uModelViewerMatrix * gl_Vertex) "
                 ": uBy == 1 ? p - camWorldPos : p - vec3(0., 0., 5.);\n"
                 "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("eye.frag", "in vec3 vRay;\nvoid main() { gl_FragColor = vec4(vRay, 1.); }\n");
    View view;
    view.scene.rotate_y = 40;
    view.scene.x = .3;
    // The middle of the picture is seen along -Z; the scene turned by 40 degrees sees that ray turned back.
    const double turn = glm::radians(40.);
    const glm::dvec3 truth(std::sin(turn), 0, -std::cos(turn));
    const auto off = [&](const char* by) {
        auto document = open("LookAt 0 0 5 0 0 0 0 1 0\nVertex eye.vert\nFragment eye.frag\nProgram E uBy " +
                             std::string(by) + "\nTranslate .2 .1 0\nQuadXY 0 3\n");
        expect_clean(*document);
        const auto all = values(*document, 65, 65, view);
        const std::size_t at = (32 * 65 + 32) * 4;
        return optics::angle_between({all[at], all[at + 1], all[at + 2]}, truth);
    };
    hard_case({"A44",
               "the viewer in the world of a scene that was turned in the window: camWorldPos, uModelViewerMatrix; "
               "naive: the eye of LookAt",
               "rad", 1e-5, std::max(off("0"), off("1")), off("2")});
}

// A step is meant; OpenGL's formula divides 0 by 0 where x is the edge.
TEST_P(HardPlaces, ASmoothstepWithoutWidthIsAStep) {
    const auto wrong = [&](const char* body) {
        folder.write("step.frag",
                     std::string("uniform float uA, uB;\n"
                                 "float formula(float a, float b, float x) {\n"
                                 "float t = clamp((x - a) / (b - a), 0., 1.); return t * t * (3. - 2. * t); }\n"
                                 "void main() { float x = floor(gl_FragCoord.x) / 64.;\n") +
                         body + " gl_FragColor = vec4(r, 1.); }\n");
        const auto all =
            values(std::string("Ortho -1 1 -1 1\nVertex plain.vert\nFragment step.frag\n"
                               "Program S uA .5 uB .5\nQuadXY\n"));
        int count = 0;
        for (std::size_t i = 0; i < all.size(); i += 4) {
            const float truth = i / 4 % 64 >= 32 ? 1 : 0;
            for (std::size_t c = 0; c < 3; ++c) count += !(all[i + c] == truth);
        }
        return static_cast<double>(count);
    };
    double ours = 0;
    for (const char* body :
         {"vec3 r = vec3(smoothstep(uA, uB, x));", "vec3 r = smoothstep(uA, uB, vec3(x));",
          "vec3 r = smoothstep(vec3(uA), vec3(uB), vec3(x));", "vec3 r = vec3(smoothstep(.5, .5, x));"})
        ours += wrong(body);
    hard_case({"A45", "smoothstep(a, a, x), which OpenGL leaves undefined, is a step; naive: its formula",
               "values wrong", 0, ours, wrong("vec3 r = vec3(formula(uA, uB, x));")});
}

// The same phase long after the start, and before it.
TEST_P(HardPlaces, TimesOfAnySizeAndSign) {
    folder.write("phase.frag",
                 "uniform float Timer, uTime;\nuniform bool uNaive;\nvoid main() {\n"
                 "gl_FragColor = vec4(vec3(uNaive ? mod(uTime, 10.) / 10. : Timer), 1.); }\n");
    const auto worst = [&](const char* naive) {
        auto document = open("Ortho -1 1 -1 1\nVertex plain.vert\nFragment phase.frag\nProgram P uNaive " +
                             std::string(naive) + "\nQuadXY\n");
        double off = 0;
        for (const auto& [time, phase] : {std::pair{1e9 + 2.5, .25}, {-5., .5}, {-1e9 - 2.5, .75}, {1e12 + 7., .7}})
            off = std::max(off, std::abs(static_cast<double>(values(*document, 8, 8, {}, 1, time)[0]) - phase));
        return off;
    };
    hard_case({"A46", "times of 1e9, 1e12, -5 and -1e9 s have their phase; naive: mod() of the time in a shader",
               "of the period", 1e-6, worst("<false>"), worst("<true>")});
}

// Otherwise it would read the texture that the program before it left on the unit.
TEST_P(HardPlaces, SamplersWithoutATextureReadBlack) {
    folder.write("red.bmp", bmp(4, 4, std::vector<std::array<int, 3>>(16, {255, 0, 0})));
    const Picture unbound = draw(
        "Ortho -1 1 -1 1\nVertex plain.vert\nFragment texture.frag\nTexture2D 5 red.bmp\nProgram Bound uUnit "
        "5\nQuadXY\n"
        "Program Unbound uUnit 7\nQuadXY .5 .5\n");
    EXPECT_TRUE(near(unbound.at(2, 2), {255, 0, 0, 255}));
    hard_case({"A57", "a sampler on a unit without a texture reads black, whatever the program before it read",
               "pixels not black", 0,
               64. * 64 - unbound.count({0, 0, 0, 255}) - unbound.count({255, 0, 0, 255}) +
                   (near(unbound.center(), {0, 0, 0, 255}) ? 0 : 1),
               std::nullopt});
}

// On both sides of an edge, and in a corner, a scene's cube map has one colour.
TEST_P(HardPlaces, EdgesOfACubeMapAreNoSteps) {
    const std::string files = write_directions(8);
    folder.write(
        "edge.frag",
        "uniform samplerCube uCube;\nvec3 turn(vec3 v, int n) { return n == 0 ? v : n == 1 ? v.yzx : v.zxy; }\n"
        "void main() { ivec2 p = ivec2(gl_FragCoord.xy);\n"
        "float x = (p.y & 1) == 0 ? 1. : -1., y = (p.y & 2) == 0 ? 1. : -1., z = float(p.x) / 31.5 - 1.;\n"
        "int n = p.y / 4 % 3;\n"
        "vec4 one = textureLod(uCube, turn(vec3(1.00001 * x, y, z), n), 0.);\n"
        "vec4 other = textureLod(uCube, turn(vec3(x, 1.00001 * y, z), n), 0.);\n"
        "gl_FragColor = vec4(abs(one - other).rgb, 1.); }\n");
    const auto steps = values("Ortho -1 1 -1 1\nCubeMap 5" + files +
                              "\nVertex plain.vert\nFragment edge.frag\nProgram E uCube 5\nQuadXY\n");
    float worst = 0;
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (i % 4 < 3) worst = std::max(worst, steps[i]);
    hard_case({"16", "edges and corners of a scene's cube map: the same colour from either face", "of 1", 1 / 255.,
               static_cast<double>(worst), std::nullopt});
}

// Across an edge, with rows that are compressed more than columns, so that footprints are long.
TEST_P(HardPlaces, CubeMapsAreSmoothUnderAnisotropicFilters) {
    const std::string files = write_directions(64);
    folder.write("around.frag",
                 "uniform samplerCube uCube;\nvoid main() { vec2 p = gl_FragCoord.xy / 64.; float a = .2853982 + p.x;\n"
                 "vec3 d = normalize(vec3(cos(a), 2. * p.y - 1., sin(a)));\n"
                 "gl_FragColor = vec4(abs(texture(uCube, d).rgb - (128. + 100. * d) / 255.), 1.); }\n");
    const auto worst = [&] {
        auto document = open("Ortho -1 1 -1 1\nFilter anisotropic 8\nCubeMap 5" + files +
                             "\nVertex plain.vert\nFragment around.frag\nProgram A uCube 5\nQuadXY\n");
        EXPECT_EQ(has(*document, "cube-anisotropy"), caps.software);
        const auto off = values(*document);
        float most = 0;
        for (std::size_t i = 0; i < off.size(); ++i)
            if (i % 4 < 3) most = std::max(most, off[i]);
        return static_cast<double>(most);
    };
    const double ours = worst();
    const bool software = caps.software;
    caps.software = false;
    const double driver = worst();
    hard_case({"A59", "a smooth cube map by `Filter anisotropic`: as smooth as it is; naive: the driver's filter",
               "of 1", .03, ours, software ? std::optional(driver) : std::nullopt});
}

SNELL_IN_ALL_CONTEXTS(HardPlaces);

}  // namespace
}  // namespace snell::test
