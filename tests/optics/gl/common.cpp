#include "tests/optics/gl/common.h"

namespace snell::test {
namespace {

constexpr std::array<const char*, 6> names = {"posx", "negx", "posy", "negy", "posz", "negz"};
constexpr std::array<const char*, 6> quads = {"QuadYZ 5.",  "QuadYZ -5.", "QuadXZ 5.",
                                              "QuadXZ -5.", "QuadXY 5.",  "QuadXY -5."};

std::string picture_path(std::size_t face) {
    return std::string(SNELL_ROOT "/scenes/environments/room/") + names[face] + ".bmp";
}

glm::dvec3 vec(const content::Float3& v) { return {v[0], v[1], v[2]}; }

}  // namespace

RoomPictures::RoomPictures() {
    for (std::size_t i = 0; i < 6; ++i) {
        std::ifstream in(picture_path(i), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), {}};
        auto read = content::decode_image(picture_path(i), bytes);
        if (!read.image) throw std::runtime_error("can't read " + picture_path(i));
        images_[i] = content::to_rgba(*read.image);
        faces_[i] = {images_[i].width,
                     images_[i].height,
                     4,
                     {reinterpret_cast<const std::uint8_t*>(images_[i].pixels.data()), images_[i].pixels.size()}};
    }
}

Look square(int size, std::vector<std::string> sets) {
    Look look;
    look.width = look.height = size;
    look.sets = std::move(sets);
    return look;
}

optics::Camera camera_of(const Document& document) {
    const Camera& camera = document.scene().cameras.at(document.scene().draws.at(0).camera);
    const auto vec3 = [](const Vec3& v) { return glm::dvec3(v[0], v[1], v[2]); };
    const auto& look = camera.look_at.value();
    return {vec3(look[0]), vec3(look[1]), vec3(look[2]), camera.fov};
}

std::string camera_statements(const optics::Camera& camera) {
    const auto number = [](double v) { return std::to_string(v) + " "; };
    const auto three = [&](const glm::dvec3& v) { return number(v.x) + number(v.y) + number(v.z); };
    return "Perspective " + number(camera.fov_y) + "\nLookAt " + three(camera.eye) + three(camera.centre) +
           three(camera.up) + "\n";
}

std::string wall_statements() {
    std::string text = "Vertex wall.vert\nFragment wall.frag\nProgram Walls uPicture 6\nClamp\n";
    for (std::size_t i = 0; i < 6; ++i) text += "Texture2D 6 " + picture_path(i) + "\n" + quads[i] + " 5.\n";
    return text;
}

std::string cube_statements() {
    std::string text = "CubeMap 6";
    for (std::size_t i = 0; i < 6; ++i) text += " " + picture_path(i);
    return text + "\n";
}

void write_wall_shaders(const Folder& folder) {
    folder.write("wall.vert", plain_vertex);
    folder.write("wall.frag",
                 "#version 330 compatibility\nuniform sampler2D uPicture;\nin vec2 vST;\n"
                 "void main() { gl_FragColor = vec4(texture(uPicture, vST).rgb, 1.); }\n");
}

std::optional<Surface3> meet_mesh(const content::Mesh& mesh, const optics::Ray& ray) {
    std::optional<Surface3> best;
    double nearest = 1e300;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::array<std::size_t, 3> v = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        const glm::dvec3 a = vec(mesh.positions[v[0]]), ab = vec(mesh.positions[v[1]]) - a,
                         ac = vec(mesh.positions[v[2]]) - a;
        const glm::dvec3 face = glm::cross(ab, ac);
        const double facing = -glm::dot(ray.direction, face);
        if (facing <= 0) continue;
        const glm::dvec3 off = ray.origin - a, turned = glm::cross(off, ray.direction);
        const double distance = glm::dot(off, face) / facing;
        const double y = glm::dot(ac, turned) / facing, z = -glm::dot(ab, turned) / facing;
        const glm::dvec3 weights(1 - y - z, y, z);
        const double margin = std::min({weights.x, weights.y, weights.z});
        if (margin < 0 || distance <= 0 || distance >= nearest) continue;
        nearest = distance;
        Surface3 s{ray.at(distance), {}, weights, v, margin};
        for (int k = 0; k < 3; ++k) s.normal += weights[k] * vec(mesh.normals[v[static_cast<std::size_t>(k)]]);
        best = s;
    }
    return best;
}

content::Mesh sphere_mesh(double radius, int slices, int stacks) {
    return content::make_shape(Sphere{radius, slices, stacks}, false).mesh;
}

double difference(const Pixel& pixel, const glm::dvec3& color) {
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        worst = std::max(worst, std::abs(pixel[static_cast<std::size_t>(i)] - 255.0 * color[i]));
    return worst;
}

}  // namespace snell::test
