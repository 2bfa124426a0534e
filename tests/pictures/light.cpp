// The pictures of docs/light.md: each scene of scenes/light with its variants side by side. To draw them anew:
//   SNELL_UPDATE_PICTURES=1 ./build/release/bin/pictures_tests --gtest_filter='LightPictures.*'
#include "src/content/image/image.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

constexpr int side = 184, gap = 4;

struct Panel {
    std::vector<std::string> rungs, sets;
};
struct Row {
    const char* scene;
    std::vector<Panel> panels;  // the scene as it is opened comes last
};

const Row rows[] = {
    {"mirror", {{{"SPACE=eye"}, {}}, {{"LOCALITY=infinite"}, {}}, {{"SPACE=eye", "LOCALITY=infinite"}, {"uView=2"}}}},
    {"glass",
     {{{"LENGTHS=any", "RATIO=slider", "BEND=single", "LOCALITY=infinite", "MIRROR=constant"},
       {"uIndex=1.1", "uMix=0"}},
      {{"LENGTHS=any"}, {"uView=4"}},
      {{"BEND=single"}, {}}}},
    {"globe", {{{"BY=normal"}, {}}, {{}, {"uView=1"}}}},
    {"varnish", {{{"SPACE=eye", "WHERE=vertex"}, {}}, {{"WHERE=vertex"}, {"uMixRatio=0"}}, {{}, {"uMixRatio=0"}}}},
    {"teapot", {{{"NORMALS=model"}, {}}, {{"NORMALS=model"}, {"uView=2"}}, {{}, {"uPolish=.4"}}}},
    {"transparency",
     {{{"OPACITY=constant", "SIDES=both"}, {}}, {{"ORDER=glass_first"}, {}}, {{"OPACITY=by_angle"}, {}}}},
    {"fresnel", {{{"FRESNEL=plus_cos"}, {"uView=1"}}, {{"FRESNEL=power2"}, {}}, {{}, {"uView=1"}}}},
    {"dispersion",
     {{{"COLOURS=steps", "FRESNEL=cg", "BEND=single"}, {}}, {{"COLOURS=steps"}, {}}, {{"COLOURS=three"}, {}}}},
    {"reflectivity", {{{"MAP=off"}, {}}, {{}, {"uView=2"}}, {{"LOCALITY=infinite", "WHERE=vertex"}, {}}}},
    {"refractivity", {{{"BEND=single", "FRESNEL=power"}, {}}, {{}, {"uView=3"}}, {{"MAP=off"}, {}}}},
    {"spectrum", {{{"ORDER=as_told"}, {}}, {{"COLOURS=three"}, {}}, {{}, {"uView=1"}}}},
    {"crystal",
     {{{"FRESNEL=swapped", "SPREAD=steps", "BODY=unused"}, {}},
      {{"FRESNEL=swapped"}, {"uView=1"}},
      {{"BEND=mesh"}, {"uBody=0"}}}},
    {"ambient", {{{"AMBIENT=constant"}, {}}, {{"AMBIENT=small_map"}, {}}, {{"AMBIENT=small_map"}, {"uView=2"}}}},
    {"carousel", {{{"MAP=still", "NEAR=infinite"}, {}}, {{"NEAR=infinite"}, {}}}},
    {"metals", {{{"ROUGH=mirror", "FRESNEL=f0"}, {}}, {{}, {"uView=1"}}, {{}, {"uRoughness=.45"}}}},
    {"workshop",
     {{{"REFRACTION=single", "NEARBY=still"}, {"uMaterial=4"}}, {{}, {"uMaterial=4"}}, {{}, {"uMaterial=11"}}}},
};

class LightPictures : public GlTest {
protected:
    Picture panel(Document& document, const Panel& p) {
        Diagnostics problems;
        const Rungs marked = document.controls.rungs;
        for (const std::string& rung : p.rungs)
            EXPECT_TRUE(choose_rung(document.controls.rungs, document.scene(), rung, problems)) << rung;
        follow_rungs(document);
        for (Control& control : document.controls.items) control.value = control.initial;
        Picture picture =
            draw(document, {.width = side, .height = side, .samples = 4, .time = 2, .view = {}, .sets = p.sets});
        document.controls.rungs = marked;
        follow_rungs(document);
        for (Control& control : document.controls.items) control.value = control.initial;
        return picture;
    }
};

content::Image empty_row(std::size_t panels) {
    content::Image image;
    image.width = static_cast<int>(panels) * (side + gap) - gap;
    image.height = side;
    image.channels = 3;
    image.pixels.assign(static_cast<std::size_t>(image.width * image.height) * 3, std::byte{255});
    return image;
}

std::size_t place(const content::Image& image, std::size_t panel, int x, int y) {
    return (static_cast<std::size_t>(y * image.width + x) + panel * (side + gap)) * 3;
}

TEST_F(LightPictures, ShowEachSceneAsItIsOpened) {
    const bool update = std::getenv("SNELL_UPDATE_PICTURES") != nullptr;
    const std::string page = bytes_of(SNELL_ROOT "/docs/light.md");
    for (const Row& row : rows) {
        const std::string scene = row.scene, path = SNELL_ROOT "/docs/images/light-" + scene + ".jpg";
        SCOPED_TRACE(scene);
        auto document = open_file(SNELL_ROOT "/scenes/light/" + scene + "/" + scene + ".glib");
        expect_clean(*document);
        content::Image image = empty_row(row.panels.size() + 1);
        if (update) {
            for (std::size_t i = 0; i <= row.panels.size(); ++i) {
                const Picture drawn = panel(*document, i < row.panels.size() ? row.panels[i] : Panel{});
                for (int y = 0; y < side; ++y)
                    for (int x = 0; x < side; ++x)
                        std::memcpy(&image.pixels[place(image, i, x, y)],
                                    &drawn.rgba[static_cast<std::size_t>(y * side + x) * 4], 3);
            }
            EXPECT_EQ(content::write_image(path, image), "");
            continue;
        }
        EXPECT_NE(page.find("images/light-" + scene + ".jpg"), std::string::npos) << "docs/light.md does not show it";
        EXPECT_LT(std::filesystem::file_size(path), 150u << 10);
        const auto old = content::decode_image(path, bytes_of(path));
        ASSERT_TRUE(old.image) << path;
        const content::Image stored = content::to_rgba(*old.image);
        ASSERT_EQ(stored.width, image.width);
        ASSERT_EQ(stored.height, image.height);
        const Picture drawn = panel(*document, {});
        // Brightness alone: JPEG keeps colours by blocks. Its loss is .01 to .02.
        double squares = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                double off = 0;
                for (std::size_t c = 0; c < 3; ++c)
                    off += std::to_integer<int>(stored.pixels[place(image, row.panels.size(), x, y) / 3 * 4 + c]) -
                           drawn.at(x, y)[c];
                squares += off * off / 9;
            }
        EXPECT_LE(std::sqrt(squares) / side / 255, .035);
    }
}

}  // namespace
}  // namespace snell::test
