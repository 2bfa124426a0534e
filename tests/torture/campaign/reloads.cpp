// A scene that is edited again and again in one process: what was made for the readings before is given back.
//
//   SNELL_TORTURE_RELOADS   how many of each kind (24, 12)
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>

#if defined(__SANITIZE_ADDRESS__)
// GCC comes without <sanitizer/allocator_interface.h>.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

#include "src/app/window/session.h"
#include "tests/harness/harness.h"
#include "tests/sanitized.h"
#include "tests/torture/campaign/campaign.h"
#include "tests/torture/tree.h"

namespace snell::test {
namespace {

// Bytes that were asked for and not given back, by us, the driver and all libraries.
double bytes_in_use() {
#if defined(__SANITIZE_ADDRESS__)
    return static_cast<double>(__sanitizer_get_current_allocated_bytes());
#else
    const struct mallinfo2 now = mallinfo2();
    return static_cast<double>(now.uordblks + now.hblkhd);
#endif
}

// Whatever is mapped and was written to: code that the driver makes, and pages that malloc keeps.
double resident_bytes() {
    std::ifstream file("/proc/self/statm");
    double whole = 0, resident = 0, shared = 0;
    file >> whole >> resident >> shared;
    return (resident - shared) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

struct InUse {
    double bytes = 0, resident = 0;
};

constexpr std::string_view light_fragment =
    "#version 330 compatibility\n#include \"tint.glsl\"\nuniform samplerCube uLight, uSoft;\nuniform sampler3D "
    "Noise3;\n"
    "uniform sampler2D uUnit, uScreen, Noise2;\nuniform float uAmount;\nin vec2 vST;\nvoid main() {\n"
    "    vec3 d = vec3(vST, 1.);\n"
    "    gl_FragColor = uAmount * texture(uLight, d) + .2 * texture(uSoft, d) + .2 * texture(Noise3, d) +\n"
    "                   .2 * texture(Noise2, vST) + .3 * texture(uUnit, vST) + .2 * texture(uScreen, vST) + "
    "tint();\n}\n";
constexpr std::string_view mesh_fragment =
    "#version 330 compatibility\n#include <snell/mesh.glsl>\nin vec2 vST;\nvoid main() {\n"
    "    SnellMesh s = snellMeshBegin(vec3(0., 0., 3.), normalize(vec3(vST - .5, -3.)), 1., 1.5, true);\n"
    "    float seen = snellMeshNext(s) ? s.energy : 0.;\n    gl_FragColor = vec4(seen, s.direction.xy, 1.);\n}\n";

class Reloads : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        for (const auto& edit : repairs()) edit(0);
        folder.write("mesh.frag", mesh_fragment);
        folder.write("rungs.frag",
                     "#if TINT == TINT_warm\n#define C vec4(.4, .2, 0., 1.)\n#else\n#define C vec4(0., .2, "
                     ".4, 1.)\n#endif\nvoid main() { gl_FragColor = C; }\n");
    }

    // Once the driver let go of what it worked on. llvmpipe has up to 64 frames under way, and each keeps its triangles
    // until it is used again; compiled programs are written to the disk by a thread that holds them until then.
    InUse settled() {
        for (int frame = 0; frame < 130; ++frame) draw(*small_, {.width = 8, .height = 8});
        double last = bytes_in_use();
        for (int looks = 0, quiet = 0; looks < 200 && quiet < 5; ++looks) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            const double now = bytes_in_use();
            quiet = now == last ? quiet + 1 : 0;
            last = now;
        }
        return {last, resident_bytes()};
    }

    // What is in use after each round of `round` steps, the first one, which only warms up, included.
    std::vector<InUse> measure(unsigned round, unsigned rounds, const std::function<void(unsigned)>& step) {
        small_ = open_file(folder.write("small.glib", "QuadXY\n"));
        std::vector<InUse> found;
        for (unsigned k = 0; k < (rounds + 1) * round && !HasFatalFailure(); ++k) {
            step(k);
            if (k % round == round - 1) found.push_back(settled());
        }
        return found;
    }

    std::unique_ptr<Document> small_;

    using Edit = std::function<void(unsigned)>;

    // No two readings are the same.
    static std::string number(unsigned k) { return std::to_string(.1 + k % 700 * 1e-3 + k * 1e-6); }
    static std::string picture(unsigned k, int side) {
        const int red = static_cast<int>(k % 256), green = static_cast<int>(k / 3 % 256);
        return bmp(side, side,
                   std::vector<std::array<int, 3>>(static_cast<std::size_t>(side * side), {red, green, 90}));
    }
    static std::string scene(unsigned k) {
        std::string text =
            "Ladder TINT warm <cold>\nOrtho -1 1 -1 1\nTexture2D 4 a.bmp\nTexture2D 8 64 64\n"
            "CubeMap 5 face.bmp face.bmp face.bmp face.bmp face.bmp face.bmp\nIrradiance 6 5 8\nPrefilter 7 5 3\n"
            "Vertex plain.vert\nRenderToTexture 8\nFragment rungs.frag\nProgram R\nSphere .9\nRenderToTexture\n"
            "Ortho -1 1 -1 1\nNoise2D 32\nNoise3D " +
            std::string(k % 2 ? "16" : "32") +
            "\nFragment light.frag\nProgram B uLight 7 uSoft 6 uUnit 4 uScreen 8 uAmount <0. .5 1.>\nObj t.obj\n"
            "Fragment mesh.frag\nProgram M\nTeapot\nInclude part.inc\nTranslate " +
            number(k) + " 0 0\nLineWidth 5\nWireBox\n";
        for (int i = 0; i < 20; ++i) text += "Translate .01 0 0\nSphere .05 8 8\n";
        return text;
    }
    void shader(const std::string& more) { folder.write("light.frag", std::string(light_fragment) + more); }

    // Each leaves its file whole and new.
    std::vector<Edit> repairs() {
        return {
            [this](unsigned k) { shader("float unused() { return " + number(k) + "; }\n"); },
            [this](unsigned k) { folder.write("tint.glsl", "vec4 tint() { return vec4(" + number(k) + "); }\n"); },
            [this](unsigned k) {
                folder.write("plain.vert", std::string(plain_vertex) + "// " + number(k) + "\n" +
                                               "float unused() { return " + number(k) + "; }\n");
            },
            [this](unsigned k) { folder.write("a.bmp", picture(k, k % 2 ? 64 : 128)); },
            [this](unsigned k) { folder.write("face.bmp", picture(k, 32)); },
            [this](unsigned k) { folder.write("t.obj", "v -1 -1 0\nv 1 -1 0\nv 0 " + number(k) + " 0\nf 1 2 3\n"); },
            [this](unsigned k) { folder.write("part.inc", "Color .5 " + number(k) + " 0\nTorus .1 .3 20 20\n"); },
            [this](unsigned k) { folder.write("scene.glib", scene(k)); }};
    }
    // And these break the files of the same places: none is shown.
    std::vector<Edit> damages() {
        return {[this](unsigned k) { shader("float unused() { return nonsense" + std::to_string(k) + "; }\n"); },
                [this](unsigned k) { folder.write("tint.glsl", "vec4 tint( { return vec4(" + number(k) + "); }\n"); },
                [this](unsigned k) {
                    folder.write("plain.vert", "void main() { gl_Position = vec3(" + number(k) + "); }\n");
                },
                [this](unsigned k) { folder.write("a.bmp", picture(k, 64).substr(0, 20 + k % 30)); },
                [this](unsigned) { std::filesystem::remove(folder.path("face.bmp")); },
                [this](unsigned) { std::filesystem::remove(folder.path("t.obj")); },
                [this](unsigned) { std::filesystem::remove(folder.path("part.inc")); },
                [this](unsigned k) {
                    folder.write("scene.glib", scene(k) + "Nonsense" + number(k) +
                                                   " 1\nVertex none.vert\nProgram X uA 1\n"
                                                   "Sphere\nTexture2D 4 none.bmp\nglBegin\n");
                }};
    }
};

// By how much it grew over all rounds. What leaks is there in the smallest, too: that of the first half is held against
// that of the second.
double growth(const std::vector<InUse>& found, double InUse::*of) {
    const auto less = [of](const InUse& a, const InUse& b) { return a.*of < b.*of; };
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    const double first = (*std::min_element(found.begin(), middle, less)).*of;
    const double second = (*std::min_element(middle, found.end(), less)).*of;
    const auto count = static_cast<double>(found.size());
    return (second - first) * (count - 1) / (count / 2);
}

void expect_small(const std::vector<InUse>& found, double allowed, const std::string& what) {
    ASSERT_GE(found.size(), 2U);
    const double bytes = growth(found, &InUse::bytes), resident = growth(found, &InUse::resident);
    std::printf("%s: %.1f kB more in use, %.1f kB more resident\n", what.c_str(), bytes / 1e3, resident / 1e3);
    EXPECT_LT(bytes, allowed);
    // Malloc keeps pages that it may need again; a driver that keeps code would take more.
    if (!sanitized) {
        EXPECT_LT(resident, 16e6);
    }
}

// A damage, its repair, and another edit, of one file after the other.
TEST_F(Reloads, GiveBackWhatTheyTook) {
    const std::vector<Edit> good = repairs(), bad = damages();
    const auto round = static_cast<unsigned>(3 * good.size());
    const unsigned rounds = (torture::number_of("SNELL_TORTURE_RELOADS", 24) + round - 1) / round;
    Session session(folder.path("scene.glib"), caps);
    ASSERT_TRUE(session.document());
    ASSERT_EQ(session.errors(), 0U) << session.problems_text();
    Picture shown = draw(*session.document());
    unsigned changed = 0;
    const std::vector<InUse> found = measure(round, rounds, [&](unsigned k) {
        const unsigned which = k / 3 % static_cast<unsigned>(good.size());
        const bool broken = k % 3 == 0;
        (broken ? bad : good)[which](k + 1);
        session.reload();
        ASSERT_EQ(session.stale(), broken) << k << '\n' << session.problems_text();
        complaints.clear();  // of broken shaders
        Picture now = draw(*session.document());
        session.drawn_well();
        ASSERT_TRUE(!broken || now == shown) << k;
        changed += now == shown ? 0U : 1U;
        shown = std::move(now);
    });
    EXPECT_GT(changed, rounds * round / 4) << "edits are seen";
    expect_small(found, 1e6, std::to_string(rounds * round) + " reloads, a third of them refused");
}

// Every command's scene in place of the one before.
TEST_F(Reloads, OfOtherScenesGiveBackWhatTheyTook) {
    std::vector<std::string> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(SNELL_ROOT "/tests/cases"))
        if (entry.path().extension() == ".glib" && entry.path().stem() != "Verbose") scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    const unsigned wanted = torture::number_of("SNELL_TORTURE_RELOADS", 12);
    while (scenes.size() > wanted) scenes.pop_back();
    const auto round = static_cast<unsigned>(scenes.size()), rounds = (wanted + round - 1) / round;
    Session session(scenes.front(), caps);
    const std::vector<InUse> found = measure(round, rounds, [&](unsigned k) {
        ASSERT_EQ(session.open(scenes[k % round]), "");
        draw(*session.document());
        session.drawn_well();
    });
    // Scenes of many triangles: what llvmpipe keeps of them for its frames differs by megabytes from round to round.
    expect_small(found, rounds > 1 ? 8e6 : 1e6, std::to_string(rounds * round) + " scenes opened");
}

}  // namespace
}  // namespace snell::test
