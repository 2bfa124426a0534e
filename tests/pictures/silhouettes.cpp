// The solids cover what geometry says they cover.
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int picture_side = 512;

class Silhouettes : public GlTest {
protected:
    // The area that one statement covers, in units of the scene, seen along -Z, or from above along -Y.
    double area(const std::string& statement, bool from_above = false) {
        const std::string view = from_above ? "LookAt 0 5 0 0 0 0 0 0 -1\n" : "LookAt 0 0 5 0 0 0 0 1 0\n";
        const Picture picture = draw("Background 0 0 0\nOrtho -2 2 -2 2\n" + view + "Color 1 1 1\n" + statement + "\n",
                                     {.width = picture_side, .height = picture_side});
        return picture.count({255, 255, 255, 255}) * 16.0 / (picture_side * picture_side);
    }
    void expect(const std::string& statement, double analytic, bool from_above = false) {
        EXPECT_NEAR(area(statement, from_above), analytic, analytic * .01) << statement;
    }
};

TEST_F(Silhouettes, Sphere) {
    expect("Sphere 1.5", pi * 1.5 * 1.5);
    expect("Sphere 1.5", pi * 1.5 * 1.5, true);
    expect("Sphere", pi);
}

TEST_F(Silhouettes, Torus) {
    expect("Torus 1.2 .4 60 120", pi * (1.6 * 1.6 - .8 * .8), true);
    // From the side: a rectangle with half discs at both ends.
    expect("Torus 1.2 .4 60 120", 2.4 * .8 + pi * .16);
    expect("Torus .4 1.2 60 120", 2.4 * .8 + pi * .16);  // either order
}

TEST_F(Silhouettes, Cone) {
    expect("Cone 1 1.8", 1.8);
    expect("Cone 1 1.8", pi, true);
}

TEST_F(Silhouettes, Cylinder) {
    expect("Cylinder .8 1.5", 1.6 * 1.5);
    expect("Cylinder .8 1.5", pi * .64, true);
}

TEST_F(Silhouettes, Box) {
    expect("Box 3 1 2", 3);
    expect("Box 3 1 2", 6, true);
    expect("Cube 3 1 2", 3);
    expect("Box", 4);
}

TEST_F(Silhouettes, QuadsAndDisk) {
    expect("QuadXY .3 1.5 4 3", 9);
    expect("QuadXZ .3 1.5 4 3", 9, true);
    expect("Rotate 90 0 1 0\nQuadYZ .3 1.5 4 3", 9);
    expect("DiskXY .2 1.5", pi * 2.25);
    expect("QuadBox 5", 4);
}

TEST_F(Silhouettes, Soccerball) { expect("Soccerball 1.5", pi * 2.25); }

// The teapot's own measure is less simple; GLUT's, from the side: between its bounding box and half of that.
TEST_F(Silhouettes, TeapotFacesItsSpoutToX) {
    const Picture picture = draw("Background 0 0 0\nOrtho -2 2 -2 2\nLookAt 0 0 5 0 0 0 0 1 0\nColor 1 1 1\nTeapot\n",
                                 {.width = picture_side, .height = picture_side});
    int left = picture_side, right = 0, top = picture_side, bottom = 0;
    for (int y = 0; y < picture_side; ++y)
        for (int x = 0; x < picture_side; ++x)
            if (picture.at(x, y)[0] == 255) {
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
    const double unit = picture_side / 4.0;
    EXPECT_NEAR((right - left) / unit, 3.2, .1);    // handle to spout
    EXPECT_NEAR((bottom - top) / unit, 1.575, .1);  // base to lid
    // The spout (on +X) reaches farther from the axis than the handle.
    EXPECT_GT(right - picture_side / 2, picture_side / 2 - left);
}

// Seen from outside every front face shows: culling back faces changes nothing, culling front faces shows the
// inside.
TEST_F(Silhouettes, FrontFacesAreOutside) {
    folder.write("facing.vert", plain_vertex);
    folder.write("facing.frag",
                 "void main() { gl_FragColor = gl_FrontFacing ? vec4(0., 1., 0., 1.) : vec4(1., 0., 0., 1.); }\n");
    for (const char* solid :
         {"Sphere", "Torus 1.2 .4", "Cone 1 1.5", "Cylinder .8 1.5", "Box", "Teapot", "Soccerball"}) {
        const Picture picture = draw(std::string("Background 0 0 0\nOrtho -2 2 -2 2\nLookAt 2 3 4 0 0 0 0 1 0\n"
                                                 "Vertex facing.vert\nFragment facing.frag\nProgram F\n") +
                                         solid + "\n",
                                     {.width = 256, .height = 256});
        EXPECT_GT(picture.count({0, 255, 0, 255}), 256 * 256 / 10) << solid;
        // Into the teapot one sees by its spout and the gap under its lid; elsewhere single pixels may fall
        // between two faces of a corner.
        const int allowed = solid == std::string_view("Teapot") ? 400 : 4;
        EXPECT_LE(picture.count({255, 0, 0, 255}), allowed) << solid;
    }
}

// A normal that points to the viewer where the surface is seen: shading by it is never negative.
TEST_F(Silhouettes, NormalsPointOutward) {
    folder.write("n.vert",
                 "out vec3 vN, vE;\nvoid main() { vN = gl_NormalMatrix * gl_Normal; vE = (gl_ModelViewMatrix * "
                 "gl_Vertex).xyz; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
    folder.write("n.frag",
                 "in vec3 vN, vE;\nvoid main() { float d = dot(normalize(vN), normalize(vE)); gl_FragColor = d < .35 ? "
                 "vec4(0., 1., 0., 1.) : vec4(1., 0., 0., 1.); }\n");
    for (const char* solid :
         {"Sphere", "Torus 1.2 .4", "Cone 1 1.5", "Cylinder .8 1.5", "Box", "Teapot", "Soccerball"}) {
        const Picture picture = draw(std::string("Background 0 0 0\nPerspective 50\nLookAt 2 3 4 0 0 0 0 1 0\n"
                                                 "Vertex n.vert\nFragment n.frag\nProgram N\n") +
                                         solid + "\n",
                                     {.width = 256, .height = 256});
        EXPECT_GT(picture.count({0, 255, 0, 255}), 256 * 256 / 20) << solid;
        EXPECT_LE(picture.count({255, 0, 0, 255}), solid == std::string_view("Teapot") ? 400 : 4) << solid;
    }
}

}  // namespace
}  // namespace snell::test
