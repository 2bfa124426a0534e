// The reflecting and refracting ball, pixel by pixel against double precision.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/optics/gl/common.h"
#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::test {
namespace {

using optics::Camera;

constexpr int picture_size = 160;

// What a pixel of the ball is made of.
struct Sample {
    int x, y;
    glm::dvec3 from_eye;  // to the surface, not of unit length
    Surface3 surface;
};

// About `wanted` pixels spread over the ball, away from the edges of its triangles and from its rim.
std::vector<Sample> samples_on(const content::Mesh& mesh, const Camera& camera, std::size_t wanted) {
    std::vector<Sample> found;
    for (int step = 9; step >= 2 && found.size() < wanted; --step) {
        found.clear();
        for (int y = step / 2; y < picture_size; y += step)
            for (int x = step / 2; x < picture_size; x += step) {
                const optics::Ray ray = optics::camera_ray(camera, x + 0.5, y + 0.5, picture_size, picture_size);
                if (!optics::cross_sphere(ray, {0, 0, 0}, 1)) continue;
                const auto surface = meet_mesh(mesh, ray);
                if (!surface || surface->margin < 0.02 ||
                    -glm::dot(ray.direction, *optics::unit(surface->normal)) < 0.15)
                    continue;
                found.push_back({x, y, surface->position - camera.eye, *surface});
            }
    }
    return found;
}

struct Agreement {
    int compared = 0, within = 0;
    double worst = 0;
};
Agreement compare(const Picture& picture, const std::vector<Sample>& samples,
                  const std::function<glm::dvec3(const Sample&)>& color) {
    Agreement result;
    for (const Sample& s : samples) {
        const double off = difference(picture.at(s.x, s.y), color(s));
        ++result.compared;
        result.within += off <= 2;
        result.worst = std::max(result.worst, off);
    }
    return result;
}

class Ball : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        document = open_file(SNELL_ROOT "/scenes/refraction-room/refraction-room.glib");
        expect_clean(*document);
        samples = samples_on(sphere_mesh(1, 160, 160), camera_of(*document), 100);
        ASSERT_GE(samples.size(), 100U);
    }
    // The shipped scene, with values set from what the file says.
    Picture refraction_room(std::vector<std::string> sets, const View& view = {}) {
        for (Control& control : document->controls.items) control.value = control.initial;
        Look with = square(picture_size, std::move(sets));
        with.view = view;
        return draw(*document, with);
    }
    // Through both surfaces of the ball, n = 1.5, to where the walls are.
    glm::dvec3 glass(const Sample& s) const {
        const glm::dvec3 p = s.surface.position;
        const auto m = *optics::meet(s.from_eye, s.surface.normal, 1.0, 1.5);
        const glm::dvec3 exit = p - 2.0 * glm::dot(p, m.transmitted) * m.transmitted;
        const glm::dvec3 out = optics::leave_sphere(*optics::unit(s.from_eye), m.transmitted);
        return glm::mix(look_from(exit, out), look_from(p, m.reflected), optics::fresnel(m.cos_incident, 1.0, 1.5));
    }
    glm::dvec3 look(const glm::dvec3& d) const { return optics::sample_cube(room.faces(), d); }
    glm::dvec3 look_from(const glm::dvec3& p, const glm::dvec3& d) const {
        return look(*optics::room_hit({p, d}, glm::dvec3(5)));
    }

    RoomPictures room;
    std::unique_ptr<Document> document;
    std::vector<Sample> samples;
};

TEST_F(Ball, RefractsAndReflectsAsOneSurfaceInAnInfinitelyLargeRoom) {
    for (double n : {1.0, 1.33, 1.5, 2.42}) {
        const Picture picture =
            refraction_room({"uBothSides=false", "uNearWalls=false", "uIndex=" + std::to_string(n)});
        const Agreement a = compare(picture, samples, [&](const Sample& s) {
            const auto m = *optics::meet(s.from_eye, s.surface.normal, 1.0, n);
            return glm::mix(look(m.transmitted), look(m.reflected), optics::fresnel(m.cos_incident, 1.0, n));
        });
        EXPECT_EQ(a.within, a.compared) << "n = " << n << ", worst " << a.worst;
    }
}

TEST_F(Ball, RefractsTwiceAndSeesTheWallsWhereTheyAre) {
    const Agreement a = compare(refraction_room({}), samples, [&](const Sample& s) { return glass(s); });
    EXPECT_EQ(a.within, a.compared) << "worst " << a.worst;
}

// Turning the scene goes into the projection; to the ball it is the eye that went around it.
TEST_F(Ball, FollowsTheMouse) {
    View view;
    view.scene.rotate_x = 15;
    view.scene.rotate_y = -40;
    const Camera still = camera_of(*document);
    const glm::dmat4 to_eye = glm::lookAt(still.eye, still.centre, still.up);
    const glm::dvec3 origin(to_eye * glm::dvec4(0, 0, 0, 1));
    const glm::dvec3 vertical(to_eye * glm::dvec4(still.up, 0));
    glm::dmat4 turn = glm::translate(glm::dmat4(1), origin);
    turn = glm::rotate(turn, glm::radians(view.scene.rotate_x), {1, 0, 0});
    turn = glm::rotate(turn, glm::radians(view.scene.rotate_y), vertical);
    turn = glm::translate(turn, -origin);
    const glm::dmat4 from_eye = glm::inverse(turn * to_eye);
    const glm::dvec3 eye(from_eye[3]), forward(-from_eye[2]), up(from_eye[1]);
    const auto turned = samples_on(sphere_mesh(1, 160, 160), {eye, eye + forward, up, still.fov_y}, 100);
    ASSERT_GE(turned.size(), 100U);
    const Agreement a = compare(refraction_room({}, view), turned, [&](const Sample& s) { return glass(s); });
    EXPECT_EQ(a.within, a.compared) << "worst " << a.worst;
}

TEST_F(Ball, BecomesAMirrorAsTheMixGrows) {
    const auto mirrored = [&](const Sample& s) { return look(*optics::mirror(s.from_eye, s.surface.normal)); };
    const Agreement a = compare(refraction_room({"uMix=1", "uNearWalls=false"}), samples, mirrored);
    EXPECT_EQ(a.within, a.compared) << "worst " << a.worst;
    const Agreement glass = compare(refraction_room({"uNearWalls=false"}), samples, mirrored);
    EXPECT_LT(glass.within, glass.compared / 2);
}

// ---- the slides' own shader, mistakes included -------------------------------------------------------------

class Slides : public Ball {
protected:
    void SetUp() override {
        Ball::SetUp();
        if (IsSkipped()) return;
        const std::string corpus = SNELL_ROOT "/../shared/corpus/bailey/";
        if (!std::filesystem::exists(corpus + "refract.frag"))
            GTEST_SKIP() << "the slides' shaders are not at " << corpus;
        for (const char* name : {"refract.vert", "refract.frag"}) {
            std::ifstream in(corpus + name, std::ios::binary);
            folder.write(name, std::string{std::istreambuf_iterator<char>(in), {}});
        }
    }
    Picture slides(const Camera& camera, double eta, double mix) {
        return draw(
            camera_statements(camera) + cube_statements() +
                "Vertex refract.vert\nFragment refract.frag\nProgram Refract uReflectUnit 6 uRefractUnit 6 uEta " +
                std::to_string(eta) + " uMix " + std::to_string(mix) + "\nSphere 1 60 60\n",
            square(picture_size));
    }
    // The shader's formula in eye coordinates; `unit` says whether the vectors are given length 1 first.
    glm::dvec3 formula(const Camera& camera, const Sample& s, double eta, double mix, bool unit) const {
        const glm::dmat3 to_eye(glm::lookAt(camera.eye, camera.centre, camera.up));
        glm::dvec3 incident = to_eye * s.from_eye, normal = to_eye * s.surface.normal;
        if (unit) incident = *optics::unit(incident), normal = *optics::unit(normal);
        const glm::dvec3 mirrored = look(optics::glsl_reflect(incident, normal));
        const glm::dvec3 bent = optics::glsl_refract(incident, normal, eta);
        return glm::mix(bent == glm::dvec3(0) ? mirrored : look(bent), mirrored, mix);
    }
};

TEST_F(Slides, VectorsOfTheWrongLengthBendTheLightWrongly) {
    const content::Mesh mesh = sphere_mesh(1, 60, 60);
    for (const Camera& camera :
         {Camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 50}, Camera{{2, 1.5, 3}, {0, 0, 0}, {0, 1, 0}, 50}}) {
        const auto pixels = samples_on(mesh, camera, 100);
        ASSERT_GE(pixels.size(), 100U);
        for (double eta : {0.66, 1.1}) {
            const Picture picture = slides(camera, eta, 0.25);
            const Agreement as_printed =
                compare(picture, pixels, [&](const Sample& s) { return formula(camera, s, eta, 0.25, false); });
            EXPECT_EQ(as_printed.within, as_printed.compared) << "eta = " << eta << ", worst " << as_printed.worst;
            const Agreement as_meant =
                compare(picture, pixels, [&](const Sample& s) { return formula(camera, s, eta, 0.25, true); });
            EXPECT_LT(as_meant.within, as_meant.compared / 2) << "eta = " << eta;
        }
    }
}

// The same test finds no such mistake in the scene that is right.
TEST_F(Slides, TheCorrectedSceneDoesNotRepeatThem) {
    const Picture picture = refraction_room({"uBothSides=false", "uNearWalls=false"});
    const Agreement mistaken = compare(picture, samples, [&](const Sample& s) {
        const glm::dvec3 mirrored = look(optics::glsl_reflect(s.from_eye, s.surface.normal));
        const glm::dvec3 bent = optics::glsl_refract(s.from_eye, s.surface.normal, 1 / 1.5);
        const double c = optics::meet(s.from_eye, s.surface.normal, 1, 1.5)->cos_incident;
        return glm::mix(look(bent), mirrored, optics::fresnel(c, 1, 1.5));
    });
    EXPECT_LT(mistaken.within, mistaken.compared / 2);
}

}  // namespace
}  // namespace snell::test
