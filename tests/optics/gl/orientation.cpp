// Which way round the walls and the faces of a cube map are.
#include "tests/optics/gl/common.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::test {
namespace {

using optics::Camera;

class Orientation : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        write_wall_shaders(folder);
        folder.write("world.vert",
                     "#version 330 compatibility\nout vec3 vPosition;\nvoid main() { vPosition = gl_Vertex.xyz;\n"
                     "  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n");
        folder.write("lookup.frag",
                     "#version 330 compatibility\nuniform samplerCube uRoom;\nin vec3 vPosition;\n"
                     "void main() { gl_FragColor = vec4(texture(uRoom, vPosition).rgb, 1.); }\n");
    }
    Picture walls(const Camera& camera, int size) {
        return draw(camera_statements(camera) + wall_statements(), square(size));
    }
    // The cube map, looked up in the direction of every pixel.
    Picture cube(const Camera& camera, int size) {
        return draw(camera_statements(camera) + cube_statements() +
                        "Vertex world.vert\nFragment lookup.frag\nProgram Lookup uRoom 6\nSphere 2.\n",
                    square(size));
    }
    RoomPictures room;
};

// Looking along an axis from the middle; up so that the picture's top is the face's top.
Camera toward_face(int face) {
    glm::dvec3 forward(0), up(0, 1, 0);
    forward[face / 2] = face % 2 ? -1 : 1;
    if (face == 2) up = {0, 0, -1};
    if (face == 3) up = {0, 0, 1};
    return {{0, 0, 0}, forward, up, 90};
}

// The faces of a cube map are drawn as if seen from outside the cube; from inside, left and right are exchanged.
TEST_F(Orientation, ALookAlongEachAxisShowsThatWallTexelByTexel) {
    for (int face = 0; face < 6; ++face) {
        const optics::Texels& image = room.faces()[static_cast<std::size_t>(face)];
        const Picture picture = walls(toward_face(face), 256);
        int wrong = 0, mirrored = 0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
                wrong += difference(picture.at(x, y), image.at(255 - x, y)) > 2;
                mirrored += difference(picture.at(x, y), image.at(x, y)) > 2;
            }
        EXPECT_EQ(wrong, 0) << "face " << face;
        EXPECT_GT(mirrored, 256 * 256 / 4) << "face " << face << " is so symmetric that it proves nothing";
    }
}

TEST_F(Orientation, TheCubeMapShowsTheSameAlongEachAxis) {
    for (int face = 0; face < 6; ++face) {
        const Picture a = walls(toward_face(face), 256), b = cube(toward_face(face), 256);
        int wrong = 0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) wrong += !near(a.at(x, y), b.at(x, y), 2);
        EXPECT_EQ(wrong, 0) << "face " << face;
    }
}

// Toward the middles of the 12 edges and the 8 corners, so that most pixels are near two or three faces.
std::vector<Camera> toward_edges_and_corners(double fov) {
    std::vector<Camera> cameras;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (std::abs(x) + std::abs(y) + std::abs(z) > 1)
                    cameras.push_back(
                        {{0, 0, 0}, {x * 1., y * 1., z * 1.}, x || z ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), fov});
    return cameras;
}

// How near a direction is to the edge of its face, in texels.
double texels_to_edge(const glm::dvec3& direction, int size) {
    const optics::CubePoint p = *optics::cube_point(direction);
    return size * std::min({p.s, 1 - p.s, p.t, 1 - p.t});
}

TEST_F(Orientation, WallsAndCubeMapAgreeWithTheRayFromTheCentreAtEdgesAndCorners) {
    constexpr int size = 24;
    int compared = 0, at_edges = 0;
    for (const Camera& camera : toward_edges_and_corners(5)) {
        const Picture a = walls(camera, size), b = cube(camera, size);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const glm::dvec3 d = optics::camera_ray(camera, x + 0.5, y + 0.5, size, size).direction;
                const glm::dvec3 hit = *optics::room_hit({{0, 0, 0}, d}, glm::dvec3(5));
                const double edge = texels_to_edge(d, 256);
                if (edge < 1e-3) continue;  // the rasteriser decides which wall is drawn
                const optics::CubePoint p = *optics::wall_point(hit);
                const auto face = static_cast<std::size_t>(p.face);
                const glm::dvec3 wall = optics::sample_2d(room.faces()[face], p.s, p.t);
                EXPECT_LE(difference(a.at(x, y), wall), 2) << "wall " << p.face << " at " << x << ' ' << y;
                const glm::dvec3 looked_up = optics::sample_cube(room.faces(), d);
                EXPECT_LE(difference(b.at(x, y), looked_up), 2) << "cube face " << p.face << " at " << x << ' ' << y;
                ++compared, at_edges += edge < 0.5;
                if (edge < 0.5) continue;  // one wall ends there; the cube map goes on
                EXPECT_TRUE(near(a.at(x, y), b.at(x, y), 3)) << x << ' ' << y;
            }
    }
    EXPECT_GT(compared, 10000);
    EXPECT_GT(at_edges, 200);
}

}  // namespace
}  // namespace snell::test
