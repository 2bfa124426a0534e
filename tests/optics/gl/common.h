// What the tests of orientation and optics share: the room's pictures, cameras, and the ball as it is tessellated.
#pragma once

#include "src/content/mesh/mesh.h"
#include "tests/harness/harness.h"
#include "tests/oracle/optics/cube.h"
#include "tests/oracle/optics/ray.h"

namespace snell::test {

// The six pictures of scenes/environments/room, decoded.
class RoomPictures {
public:
    RoomPictures();
    RoomPictures(const RoomPictures&) = delete;
    RoomPictures& operator=(const RoomPictures&) = delete;
    const optics::CubeTexels& faces() const { return faces_; }

private:
    std::array<content::Image, 6> images_;
    optics::CubeTexels faces_;
};

// A square picture.
Look square(int size, std::vector<std::string> sets = {});

// The camera of a scene's first draw. Precondition: it has a LookAt.
optics::Camera camera_of(const Document& document);

// Statements of a scene: the camera; six textured walls on unit 6 (shaders wall.vert, wall.frag must be there); the
// same pictures as a cube map on unit 6.
std::string camera_statements(const optics::Camera& camera);
std::string wall_statements();
std::string cube_statements();
// Writes wall.vert and wall.frag.
void write_wall_shaders(const Folder& folder);

// A triangle that a ray meets first, and where in it.
struct Surface3 {
    glm::dvec3 position{0};  // interpolated
    glm::dvec3 normal{0};    // interpolated, not of unit length
    glm::dvec3 weights{0};   // barycentric
    std::array<std::size_t, 3> vertices{};
    double margin = 0;  // smallest weight: 0 on an edge
};
// Exact in double on the mesh that is drawn, so that tessellation is no error. The nearest front.
std::optional<Surface3> meet_mesh(const content::Mesh& mesh, const optics::Ray& ray);
content::Mesh sphere_mesh(double radius, int slices, int stacks);

double difference(const Pixel& pixel, const glm::dvec3& color);  // largest of the channels, in 1/255

}  // namespace snell::test
