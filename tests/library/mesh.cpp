// Light through meshes: what shaders find by the tree, against the oracle's path in double precision.
#include "shaders/embedded.h"
#include "src/content/mesh/tree.h"
#include "tests/hard_case.h"
#include "tests/library/common.h"
#include "tests/oracle/optics/mesh_path.h"

namespace snell::test {
namespace {

using namespace optics;

class LibraryMesh : public LibraryTest {
protected:
    void use(const content::Mesh& mesh, bool in_model_coordinates = false) {
        content::Tree tree = content::make_tree(mesh);
        if (in_model_coordinates) unframe(tree);
        parts = {upload(std::move(tree.nodes)), upload(std::move(tree.triangles)), upload(content::tree_normals(mesh))};
    }
    static gl::Texture upload(std::vector<content::Float4> texels) {
        const auto [width, height] = content::fill_rows(texels);
        return gl::make_texture(
            GL_TEXTURE_2D, {gl::Pixels::rgba32f, width, height, 1, reinterpret_cast<const std::byte*>(texels.data())},
            {gl::Sampling::Mode::nearest, 1, true});
    }
    static void unframe(content::Tree& tree) {
        const content::Float4 frame = tree.nodes.front();
        tree.nodes.front() = {0, 0, 0, 1};
        const auto move = [&frame](content::Float4& p) {
            for (std::size_t k = 0; k < 3; ++k) p[k] = frame[k] + p[k] / frame[3];
        };
        std::for_each(tree.nodes.begin() + 2, tree.nodes.end(), move);
        std::ranges::for_each(tree.triangles, move);
    }
    void use(const Shape& shape) {
        const content::Mesh mesh = content::make_shape(shape, false).mesh;
        use(mesh);
        corners.clear();
        directions.clear();
        for (const content::Float3& p : mesh.positions) corners.emplace_back(p[0], p[1], p[2]);
        for (const content::Float3& n : mesh.normals) directions.emplace_back(n[0], n[1], n[2]);
        indices = mesh.indices;
    }
    void bind(GLuint program) override {
        constexpr std::array<const char*, 3> names = {"snellMeshNodes", "snellMeshTriangles", "snellMeshNormals"};
        for (std::size_t i = 0; i < names.size(); ++i) {
            glActiveTexture(GL_TEXTURE4 + static_cast<GLenum>(i));
            glBindTexture(GL_TEXTURE_2D, parts[i].get());
            glUniform1i(glGetUniformLocation(program, names[i]), 4 + static_cast<GLint>(i));
        }
    }

    std::array<gl::Texture, 3> parts;
    std::vector<glm::dvec3> corners, directions;
    std::vector<std::uint32_t> indices;
};

constexpr std::string_view mesh_include = "#include <snell/mesh.glsl>\n";

// An eye looks at the mesh from (1, 2, 3), pixel by pixel; a = (eye, n), b = (direction, 0).
std::vector<Arguments> view(int side, float n) {
    const optics::Camera camera{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 40};
    std::vector<Arguments> out;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Ray ray = camera_ray(camera, x + 0.5, y + 0.5, side, side);
            out.push_back({{glm::vec3(ray.origin), n}, {glm::vec3(ray.direction), 0}, {}});
        }
    return out;
}

TEST_P(LibraryMesh, HitsAgreeWithTheOracle) {
    use(Teapot{});
    const MeshTracer mesh(corners, indices);
    std::mt19937 random(6);
    std::uniform_real_distribution<float> any(-1, 1);
    std::vector<Arguments> arguments;
    for (int i = 0; i < 4000; ++i)
        arguments.push_back({{2 * any(random), 2 * any(random), 2 * any(random), static_cast<float>(i % 3 - 1)},
                             {any(random), any(random), any(random), 0},
                             {}});
    const auto hits = run(mesh_include,
                          "SnellMeshHit hit; bool found = snellMeshHit(a.xyz, b.xyz, int(a.w), hit);\n"
                          "return vec4(snellMeshPoint(hit.triangle, hit.weights), found ? hit.distance : -9.);",
                          arguments);
    int found = 0, disagree = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Ray ray{vec(arguments[i].a), *unit(vec(arguments[i].b))};
        const Facing facing = arguments[i].a.w > 0 ? Facing::front : arguments[i].a.w < 0 ? Facing::back : Facing::both;
        const auto truth = mesh.nearest(ray, 0, facing);
        if (truth.has_value() != (hits[i].w != -9)) {
            ++disagree;  // by an outline
            continue;
        }
        if (!truth) continue;
        ++found;
        if (std::abs(truth->distance - hits[i].w) > 1e-5) {
            ++disagree;
            continue;
        }
        EXPECT_LT(glm::length(vec(hits[i]) - ray.at(truth->distance)), 2e-5) << i;
    }
    EXPECT_GT(found, 400);
    EXPECT_LE(disagree, 2);
}

// From inside a closed mesh every ray ends on it, exactly at corners and along edges too.
TEST_P(LibraryMesh, LetsNothingSlipThrough) {
    use(Sphere{.radius = 1, .slices = 24, .stacks = 16});
    std::vector<Arguments> arguments;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k)
            for (double t : {0.0, 0.25, 0.5, 1 / 3.0}) {
                const glm::vec3 origin(0.01F, 0.02F, 0.03F);
                const auto p = glm::vec3(glm::mix(corners[indices[i + k]], corners[indices[i + (k + 1) % 3]], t));
                arguments.push_back({{origin, 0}, {p - origin, 0}, {}});
            }
    const auto hits = run(mesh_include,
                          "SnellMeshHit hit; bool found = snellMeshHit(a.xyz, b.xyz, SNELL_BACK, hit);\n"
                          "return vec4(found ? hit.distance : -9., length(b.xyz), 0., 0.);",
                          arguments);
    for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_NEAR(hits[i].x, hits[i].y, 2e-6) << i;
}

TEST_P(LibraryMesh, NormalsAreTheMeshs) {
    use(Torus{});
    const MeshTracer mesh(corners, indices);
    const auto arguments = view(36, 1);
    const std::string found = "SnellMeshHit hit; if (!snellMeshHit(a.xyz, b.xyz, SNELL_FRONT, hit)) return vec4(0.);\n";
    const auto flat = run(mesh_include, found + "return vec4(snellMeshFaceNormal(hit.triangle), 1.);", arguments);
    const auto curved =
        run(mesh_include, found + "return vec4(snellMeshNormal(hit.triangle, hit.weights), 1.);", arguments);
    int compared = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const auto hit = mesh.nearest({vec(arguments[i].a), vec(arguments[i].b)}, 0, Facing::front);
        if (!hit || flat[i].w == 0 || std::min({hit->weights.x, hit->weights.y, hit->weights.z}) < 1e-4) continue;
        glm::dvec3 normal(0);
        for (int k = 0; k < 3; ++k)
            normal += hit->weights[k] * directions[indices[hit->triangle * 3 + static_cast<std::size_t>(k)]];
        EXPECT_LT(angle_between(vec(flat[i]), mesh.face_normal(hit->triangle)), 1e-5) << i;
        EXPECT_LT(angle_between(vec(curved[i]), normal), 1e-5) << i;
        ++compared;
    }
    EXPECT_GT(compared, 400);
}

// What the oracle says of a ray, and of how many exits in a row that is certain in floats. Three bands are not, and
// are left out: edges, where a ray within a rounding of one meets another triangle than its neighbour; the critical
// angle, where the transmitted direction turns infinitely fast; and what many bounces off curved walls have spread.
// Found by moving the ray by what rounding moves it, 3e-7 of the distance, eight times.
struct Judged {
    MeshLight light;
    std::size_t certain = 0;
};
Judged judge(const MeshTracer& mesh, const Ray& ray, double n, const MeshNormals& normals, std::size_t exits) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-3e-7, 3e-7);
    Judged out{through_mesh(mesh, ray, 1, n, normals), exits};
    for (int i = 0; i < 8; ++i) {
        const Ray moved{ray.origin, ray.direction + glm::dvec3(any(random), any(random), any(random))};
        const MeshLight light = through_mesh(mesh, moved, 1, n, normals);
        std::size_t same = 0;
        for (; same < out.certain; ++same) {
            const bool here = same < out.light.exits.size(), there = same < light.exits.size();
            if (here != there) break;
            if (!here) continue;
            const MeshExit &a = light.exits[same], &b = out.light.exits[same];
            if (angle_between(a.direction, b.direction) > 1e-4 || std::abs(a.energy - b.energy) > 1e-4) break;
        }
        out.certain = same;
    }
    return out;
}

struct MeshCase {
    const char* name;
    Shape shape;
    float n;
    bool interpolated;
    double uncertain;  // share of the pixels that meet the mesh, at most
};

TEST_P(LibraryMesh, PathsAgreeWithTheOracle) {
    constexpr std::size_t exits = 4;
    const MeshCase cases[] = {{"ball", Sphere{}, 1.5F, false, 0.02},
                              {"curved ball", Sphere{}, 1.5F, true, 0.02},
                              {"box", Box{1, 1, 1}, 1.33F, false, 0.01},
                              {"torus", Torus{}, 1.5F, false, 0.03},
                              {"teapot", Teapot{}, 1.5F, false, 0.15}};
    for (const MeshCase& test : cases) {
        SCOPED_TRACE(test.name);
        use(test.shape);
        const MeshTracer mesh(corners, indices);
        const MeshNormals normals = test.interpolated ? MeshNormals{directions, indices} : MeshNormals{};
        const auto pixels = view(36, test.n);
        std::vector<Arguments> arguments;
        for (std::size_t k = 0; k < exits; ++k)
            for (Arguments pixel : pixels) {
                pixel.c = {static_cast<float>(k), test.interpolated ? 1 : 0, 0, 0};
                arguments.push_back(pixel);
            }
        const auto out = run(mesh_include,
                             "SnellMesh s = snellMeshBegin(a.xyz, b.xyz, 1., a.w, c.y > 0.);\nfloat exits = 0.;\n"
                             "for (int i = 0; i <= int(c.x); ++i) if (snellMeshNext(s)) exits += 1.;\n"
                             "return vec4(s.direction, exits > c.x ? s.energy : -1.);",
                             arguments);
        std::size_t met = 0, certain = 0, compared = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Ray ray{vec(pixels[i].a), vec(pixels[i].b)};
            if (!mesh.nearest(ray)) continue;
            ++met;
            const Judged truth = judge(mesh, ray, test.n, normals, exits);
            certain += truth.certain;
            for (std::size_t k = 0; k < truth.certain; ++k) {
                const glm::vec4& found = out[k * pixels.size() + i];
                ASSERT_EQ(found.w >= 0, k < truth.light.exits.size()) << "pixel " << i << " exit " << k;
                if (found.w < 0) continue;
                EXPECT_LT(angle_between(vec(found), truth.light.exits[k].direction), 1e-4) << i << " exit " << k;
                EXPECT_NEAR(found.w, truth.light.exits[k].energy, 1e-4) << i << " exit " << k;
                ++compared;
            }
        }
        EXPECT_GT(compared, 1000U);
        EXPECT_GE(static_cast<double>(certain), (1 - test.uncertain) * static_cast<double>(met * exits)) << met;
    }
}

// Hard cases 11 and 15.
TEST_P(LibraryMesh, AllLightIsAccountedFor) {
    const MeshCase cases[] = {{"torus", Torus{}, 1.5F, false, 0}, {"box", Box{1, 1, 1}, 2.42F, false, 0}};
    for (const MeshCase& test : cases) {
        SCOPED_TRACE(test.name);
        use(test.shape);
        const auto sums = run(mesh_include,
                              "SnellMesh s = snellMeshBegin(a.xyz, b.xyz, 1., a.w, false);\n"
                              "float sum = 0., open = 0., count = 0.;\n"
                              "for (int i = 0; i < 200; ++i) { if (!snellMeshNext(s)) break; sum += s.energy; count += "
                              "1.; open += s.closed ? 0. : 1.; }\nreturn vec4(sum, s.inside, open, count);",
                              view(24, test.n));
        float most = 0;
        for (const glm::vec4& r : sums) {
            ASSERT_TRUE(finite(r));
            EXPECT_NEAR(r.x + r.y, 1, 3e-6);
            EXPECT_EQ(r.z, 0) << "a leak";
            most = std::max(most, r.w);
        }
        EXPECT_GT(most, 5);
        EXPECT_LE(most, 2 * 32 + 3);
    }
}

// What comes out of a glass box, wherever it lies in its model and however large it is, is what comes out of the one at
// the origin. Naive: the tree has the model's coordinates, so that the slack grows with them and areas vanish.
TEST_P(LibraryMesh, FarFromTheModelsOriginAndOfAnySize) {
    constexpr std::string_view body =
        "SnellMesh s = snellMeshBegin(a.xyz, b.xyz, 1., a.w, false);\nvec3 sum = vec3(0.);\nfloat energy = 0.;\n"
        "for (int i = 0; i < 8; ++i) if (snellMeshNext(s)) { sum += s.energy * s.direction; energy += s.energy; }\n"
        "return vec4(sum, energy);";
    const content::Mesh box = content::make_shape(Box{2, 2, 2}, false).mesh;
    const auto seen = [&](float offset, float size, bool naive) {
        content::Mesh moved = box;
        std::vector<Arguments> arguments = view(24, 1.5F);
        for (content::Float3& p : moved.positions)
            for (float& x : p) x = (x + offset) * size;
        for (Arguments& pixel : arguments)
            for (int k = 0; k < 3; ++k) pixel.a[k] = (pixel.a[k] + offset) * size;
        use(moved, naive);
        return run(mesh_include, body, arguments);
    };
    const auto at_home = seen(0, 1, false);
    const auto off = [&](float offset, float size, bool naive) {
        double worst = 0;
        const auto out = seen(offset, size, naive);
        for (std::size_t i = 0; i < out.size(); ++i) worst = worse(worst, glm::length(out[i] - at_home[i]));
        return worst;
    };
    hard_case(
        {"A41",
         "rays through a glass box 0 to 1e6 away from its model's origin; naive: a tree in the model's coordinates",
         "of the light", 1e-3, worse(off(1e3F, 1, false), off(1e6F, 1, false)), off(1e6F, 1, true)});
    hard_case({"A55", "rays through glass boxes of sizes 1e-24 and 1e24; naive: a tree in the model's coordinates",
               "of the light", 1e-3, worse(off(0, 0x1p-80F, false), off(0, 0x1p80F, false)), off(0, 0x1p-80F, true)});
}

// A box without its front, and a box with another of air in it, whose faces look inward.
TEST_P(LibraryMesh, OpenAndInnerFaces) {
    const content::Mesh box = content::make_shape(Box{2, 2, 2}, false).mesh;
    content::Mesh open = box, hollow = box;
    std::erase_if(open.indices, [n = 0](std::uint32_t) mutable { return n++ < 6; });
    const auto first = static_cast<std::uint32_t>(box.positions.size());
    for (content::Float3 p : box.positions) {
        for (float& x : p) x *= .7F;
        hollow.positions.push_back(p);
    }
    for (std::size_t i = 0; i + 2 < box.indices.size(); i += 3)
        for (const std::size_t k : {i, i + 2, i + 1}) hollow.indices.push_back(first + box.indices[k]);
    hollow.normals.clear();
    const auto lost = [&](const content::Mesh& mesh, bool leaks) {
        use(mesh);
        double worst = 0;
        int open_exits = 0;
        for (const glm::vec4& r :
             run(mesh_include,
                 "SnellMesh s = snellMeshBegin(a.xyz, b.xyz, 1., a.w, false);\n"
                 "float sum = 0., open = 0.;\nfor (int i = 0; i < 200; ++i) { if (!snellMeshNext(s)) "
                 "break; sum += s.energy; open += s.closed ? 0. : 1.; }\n"
                 "return vec4(sum, s.inside, open, 0.);",
                 view(24, 1.5F))) {
            worst = worse(worst, std::abs(static_cast<double>(r.x) + static_cast<double>(r.y) - 1));
            open_exits += r.z > 0;
        }
        return (open_exits > 0) == leaks ? worst : 1.0;
    };
    hard_case({"A53", "light through a mesh with a hole: all of it is accounted for, and the hole is told of",
               "of the light", 3e-6, lost(open, true), std::nullopt});
    hard_case({"A54", "light through a hollow mesh, whose inner faces look inward: all of it is accounted for",
               "of the light", 3e-6, lost(hollow, false), std::nullopt});
}

TEST_P(LibraryMesh, SpecialValuesGiveDirections) {
    use(Torus{.outer = 1, .inner = .5, .sides = 8, .rings = 12});
    const auto arguments = special_arguments(1000);
    const std::string body =
        "SnellMesh s = snellMeshBegin(a.xyz, b.xyz, a.w, b.w, c.x > 0.);\n"
        "float sum = 0.;\nfor (int i = 0; i < 4; ++i) if (snellMeshNext(s)) sum += s.energy;\n"
        "return vec4(s.direction, sum);";
    const auto results = run(mesh_include, body, arguments);
    expect_each(results, arguments, body, [](const glm::vec4& r) {
        return finite(r) && std::abs(glm::length(vec(r)) - 1) <= 1e-5 && r.w >= 0 && r.w <= 1.00001F;
    });
    // Degenerate meshes, and none at all.
    content::Mesh mesh;
    use(mesh);
    const std::vector<Arguments> one{{{0, 0, 5, 1}, {0.01F, 0.02F, -1, 1.5F}, {1, 0, 0, 0}}};
    EXPECT_NEAR(run(mesh_include, body, one)[0].w, 1, 1e-6) << "passes by";
    mesh.positions = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1e30F, 0, 0}, {0, 1e30F, 0}, {1e-30F, 1e-30F, 0}};
    mesh.indices = {0, 1, 2, 0, 3, 4, 0, 2, 5};
    use(mesh);
    EXPECT_TRUE(finite(run(mesh_include, body, one)[0]));
}

TEST(MeshRows, AreAsLongAsTheTexturesAreWide) {
    const std::string name = "const int SNELL_MESH_ROW = ", text(embedded_shader("snell/mesh.glsl"));
    ASSERT_NE(text.find(name), std::string::npos);
    EXPECT_EQ(std::size_t{1} << std::stoul(text.substr(text.find(name) + name.size())), content::tree_row);
}

SNELL_IN_THE_FIRST_DIALECT(LibraryMesh);

}  // namespace
}  // namespace snell::test
