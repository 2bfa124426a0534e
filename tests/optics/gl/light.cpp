// The scenes of scenes/light: what each rung is off by, and that the right ones are right by the oracle.
#include "tests/optics/gl/common.h"
#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/glass.h"
#include "tests/oracle/optics/refraction.h"
#include "tests/words.h"

namespace snell::test {
namespace {

constexpr int size = 48;

class LightScene : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (!IsSkipped()) target = gl::make_target(size, size, 1, gl::Pixels::rgba32f);
    }
    void open_light(const std::string& name) {
        document = open_file(SNELL_ROOT "/scenes/light/" + name + "/" + name + ".glib");
        ASSERT_TRUE(document->runtime);
        EXPECT_TRUE(document->diagnostics.items().empty()) << render(document->diagnostics, document->sources);
        marked = document->runtime->rungs();
    }
    // As the shaders wrote it.
    std::vector<float> values(const std::vector<std::string>& rungs, const std::vector<std::string>& sets = {}) {
        Diagnostics problems;
        document->controls.rungs = marked;
        for (const std::string& rung : rungs)
            EXPECT_TRUE(choose_rung(document->controls.rungs, document->scene(), rung, problems)) << rung;
        follow_rungs(*document);
        EXPECT_FALSE(document->runtime->ladder_problems().has_errors());
        for (Control& control : document->controls.items) control.value = control.initial;
        for (const std::string& set : sets) set_control(document->controls, document->scene(), set, problems);
        EXPECT_FALSE(problems.has_errors()) << render(problems, document->sources);
        const View view;
        document->runtime->draw({2.0, view, document->controls}, {target.framebuffer.get(), size, size});
        return gl::read_rgba32f(target.framebuffer.get(), size, size, 1);
    }
    static double rmse(const std::vector<float>& a, const std::vector<float>& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (i % 4 != 3) sum += (double(a[i]) - double(b[i])) * (double(a[i]) - double(b[i]));
        return std::sqrt(sum / (static_cast<double>(a.size()) * .75));
    }

    std::unique_ptr<Document> document;
    gl::Target target;
    Rungs marked;
};

// What choices are off by: root mean square differences over the whole picture, from wrong to right.
struct Comparison {
    const char *scene, *reference, *sets;  // rungs besides the marked ones, and values
    const char* steps;                     // each is nearer than the one before
};
void PrintTo(const Comparison& c, std::ostream* out) { *out << c.scene; }

class LightSteps : public LightScene, public testing::WithParamInterface<Comparison> {};

TEST_P(LightSteps, AreOffByWhatIsSaid) {
    const Comparison& c = GetParam();
    open_light(c.scene);
    const std::vector<std::string> sets = words(c.sets, ' ');
    const std::vector<float> reference = values(words(c.reference, ' '), sets);
    double before = 1e9;
    for (const std::string& step : words(c.steps, ';')) {
        std::vector<std::string> rungs = words(c.reference, ' ');
        double known = 0;
        std::istringstream(step) >> rungs.emplace_back() >> known;
        const double error = rmse(values(rungs, sets), reference);
        EXPECT_NEAR(error, known, .1 * known) << step;
        EXPECT_LT(error, before) << step;
        before = error;
    }
}

const Comparison comparisons[] = {
    {"mirror", "", "",
     "SPACE=eye 0.1446; LOCALITY=infinite 0.0987; NORMAL=interpolated 0.038; LOCALITY=impostor 0.00101"},
    {"glass", "", "",
     "BEND=none 0.203; RATIO=slider 0.1958; LENGTHS=any 0.178; MIRROR=constant 0.0312; BEND=both 0.0164; "
     "LOCALITY=impostor 0.000833"},
    {"glass", "", "", "BEND=single 0.1781; LOCALITY=infinite 0.1093"},
    {"globe", "", "", "BY=normal 0.1135"},
    {"varnish", "", "", "SPACE=eye 0.1060; WHERE=vertex 0.0311"},
    {"teapot", "", "", "NORMALS=model 0.0883"},
    {"transparency", "", "",
     "ORDER=glass_first 0.0355; OPACITY=constant 0.0313; SIDES=front 0.0276; SIDES=both 0.0135"},
    {"transparency", "OPACITY=by_angle SIDES=both", "", "COSINE=any 0.1838"},
    {"fresnel", "", "uView=1",
     "FRESNEL=plus_cos 0.389; FRESNEL=cg 0.3816; FRESNEL=one_minus_cos 0.2163; FRESNEL=k 0.1154; "
     "FRESNEL=power2 0.1113; FRESNEL=unused 0.0942; FRESNEL=schlick 0.00916; FRESNEL=gaussian 0.0085; "
     "FRESNEL=cg_fitted 0.005"},
    {"dispersion", "WAVELENGTHS=64", "",
     "BEND=single 0.1885; FRESNEL=cg 0.142; COLOURS=steps 0.0897; COLOURS=one 0.07; COLOURS=three 0.0229; "
     "WAVELENGTHS=4 0.0178; WAVELENGTHS=8 0.00846; WAVELENGTHS=16 0.00256"},
    {"reflectivity", "", "",
     "MAP=off 0.0994; LOCALITY=infinite 0.0551; WHERE=vertex 0.0109; LOCALITY=impostor 0.000805"},
    {"refractivity", "", "",
     "MAP=off 0.1935; BEND=single 0.1184; FRESNEL=power 0.1109; FRESNEL=away 0.0805; FRESNEL=none 0.0398; "
     "WHERE=vertex 0.00719"},
    {"spectrum", "", "", "BEND=single 0.3879; ORDER=as_told 0.1942; COLOURS=three 0.0414; WAVELENGTHS=16 0.00387"},
    {"crystal", "", "", "FRESNEL=swapped 0.0787; FRESNEL=power 0.0653; BODY=unused 0.0389; SPREAD=steps 0.0379"},
    {"ambient", "AMBIENT=quadrature", "",
     "AMBIENT=small_map 0.0804; AMBIENT=constant 0.0485; AMBIENT=harmonics 0.0026; AMBIENT=irradiance 0.00237"},
    {"carousel", "", "", "NEAR=infinite 0.0597; MAP=still 0.0107"},
    {"metals", "ROUGH=mirror", "", "FRESNEL=f0 0.00831; FRESNEL=schlick 0.00421"},
    {"workshop", "", "",
     "REFRACTION=none 0.1369; REFRACTION=single 0.0973; REFRACTION=both 0.0215; NEARBY=still 0.0112; "
     "ORDERS=2 0.0107; DISPERSION=one 0.00548; FRESNEL=schlick 0.0031"},
};

std::string comparison_name(const testing::TestParamInfo<Comparison>& info) {
    return std::string(info.param.scene) + std::to_string(info.index);
}
INSTANTIATE_TEST_SUITE_P(Scenes, LightSteps, testing::ValuesIn(comparisons), comparison_name);

// ---- against the oracle ------------------------------------------------------------------------------------

// Calls check(x, y, eye ray's direction, normal) for pixels on the ball of a scene, away from its rim.
template <class Check>
int on_ball(const Document& document, const glm::dvec3& centre, double radius, Check check) {
    const optics::Camera camera = camera_of(document);
    int count = 0;
    for (int y = 0; y < size; y += 2)
        for (int x = 0; x < size; x += 2) {
            const optics::Ray ray = optics::camera_ray(camera, x + .5, y + .5, size, size);
            const auto hit = optics::cross_sphere(ray, centre, radius);
            if (!hit) continue;
            const glm::dvec3 normal = (ray.at(hit->enter) - centre) / radius;
            if (-glm::dot(ray.direction, normal) < .25) continue;
            check(x, y, ray.direction, normal), ++count;
        }
    return count;
}
glm::dvec3 at(const std::vector<float>& values, int x, int y) {
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x));
    return {values[i], values[i + 1], values[i + 2]};
}

// What uView shows. Balls are meshes: a ray meets their flat cells a little below the sphere (3e-4 of 120 × 120 cells,
// 4e-3 of the mirror's 24 × 24), where the interpolated normal belongs to a point beside.
TEST_F(LightScene, FresnelShowsTheExactShareAndDirection) {
    open_light("fresnel");
    const auto share = values({}, {"uView=1"}), way = values({}, {"uView=4"});
    const int count = on_ball(*document, {0, 0, 0}, 1, [&](int x, int y, const glm::dvec3& I, const glm::dvec3& N) {
        EXPECT_NEAR(at(share, x, y).r, optics::fresnel(-glm::dot(I, N), 1, 1.52), 2e-3);
        const auto m = *optics::meet(I, N, 1, 1.52);
        const glm::dvec3 shown = 2.0 * at(way, x, y) - 1.0;
        EXPECT_LT(glm::degrees(optics::angle_between(shown, optics::leave_sphere(I, m.transmitted))), .3);
    });
    EXPECT_GT(count, 100);
}

TEST_F(LightScene, GlassAndMirrorShowTheRightDirections) {
    open_light("glass");
    const auto bent = values({}, {"uView=1"}), k = values({}, {"uView=2"});
    on_ball(*document, {0, 0, 0}, 1.2, [&](int x, int y, const glm::dvec3& I, const glm::dvec3& N) {
        const auto m = *optics::meet(I, N, 1, 1.5);
        EXPECT_LT(
            glm::degrees(optics::angle_between(2.0 * at(bent, x, y) - 1.0, optics::leave_sphere(I, m.transmitted))),
            .3);
        EXPECT_NEAR(at(k, x, y).r, optics::transmitted_cos2(-glm::dot(I, N), 1, 1.5), 2e-3);
    });
    open_light("mirror");
    const auto mirrored = values({}, {"uView=1"});
    const int count = on_ball(*document, {0, 0, 0}, 1.2, [&](int x, int y, const glm::dvec3& I, const glm::dvec3& N) {
        EXPECT_LT(glm::degrees(optics::angle_between(2.0 * at(mirrored, x, y) - 1.0, *optics::mirror(I, N))), 5);
    });
    EXPECT_GT(count, 100);
}

TEST_F(LightScene, MetalsShowTheSharesOfTheirIndices) {
    open_light("metals");
    const auto share = values({}, {"uView=1"});
    const double nanometres[] = {611, 549, 464};
    const glm::dvec3 centres[] = {{-.85, .85, 0}, {.85, .85, 0}, {-.85, -.85, 0}};
    for (std::size_t metal = 0; metal < 3; ++metal) {
        const int count =
            on_ball(*document, centres[metal], .75, [&](int x, int y, const glm::dvec3& I, const glm::dvec3& N) {
                for (int i = 0; i < 3; ++i) {
                    const optics::Complex index = optics::metals()[metal].index(nanometres[i]);
                    EXPECT_NEAR(at(share, x, y)[i], optics::fresnel_conductor(-glm::dot(I, N), 1, index.eta, index.k),
                                4e-3)
                        << optics::metals()[metal].name;
                }
            });
        EXPECT_GT(count, 40);
    }
}

// Numbers of a shader's array, by its name.
std::vector<double> numbers_of(const std::string& text, const std::string& array) {
    std::vector<double> numbers;
    std::size_t from = text.find("](", text.find(" " + array + "["));
    for (const char* p = text.c_str() + from + 2; *p != ';'; ++p) {
        if (std::string_view(p, 4) == "vec2" || std::string_view(p, 4) == "vec3") p += 4;
        char* end = nullptr;
        const double v = std::strtod(p, &end);
        if (end != p) numbers.push_back(v), p = end - 1;
    }
    return numbers;
}

TEST(LightMaterials, AreThoseOfTheOracle) {
    std::ifstream in(SNELL_ROOT "/scenes/light/materials.glsl");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::vector<double> glass = numbers_of(text, "GLASS"), eta = numbers_of(text, "METAL_ETA"),
                              k = numbers_of(text, "METAL_K");
    ASSERT_EQ(glass.size(), 22U);
    const char* names[] = {"air", "ice",  "water",          "Pyrex",   "window glass", "quartz",
                           "BK7", "SF11", "cubic zirconia", "diamond", "moissanite"};
    for (std::size_t i = 0; i < 11; ++i)
        for (double nm = 430; nm <= 670; nm += 10)
            EXPECT_NEAR(glass[2 * i] + glass[2 * i + 1] / (nm * nm * 1e-6), optics::find_glass(names[i])->index(nm),
                        .0026)
                << names[i] << " " << nm;
    ASSERT_EQ(eta.size(), 12U);
    ASSERT_EQ(k.size(), 12U);
    const double nanometres[] = {611, 549, 464};
    for (std::size_t metal = 0; metal < 3; ++metal)
        for (std::size_t i = 0; i < 3; ++i) {
            const optics::Complex index = optics::metals()[metal].index(nanometres[i]);
            EXPECT_NEAR(eta[3 * metal + i], index.eta, 2e-4) << optics::metals()[metal].name;
            EXPECT_NEAR(k[3 * metal + i], index.k, 2e-4) << optics::metals()[metal].name;
        }
}

}  // namespace
}  // namespace snell::test
