// A scene whose names are all others draws the same picture.
#include "tests/harness/harness.h"
#include "tests/language/rename_all.h"

namespace snell::language {
namespace {

namespace fs = std::filesystem;

class Renamed : public test::GlTest, public testing::WithParamInterface<const char*> {};

TEST_P(Renamed, TheSamePicture) {
    fs::copy("scenes", folder.path("scenes"), fs::copy_options::recursive);
    const std::string scene = folder.path(GetParam());
    const auto draw_scene = [&] {
        auto document = open_file(scene);
        expect_clean(*document);
        return document->runtime ? draw(*document) : test::Picture();
    };
    const test::Picture before = draw_scene();
    EXPECT_GT(rename_all(scene, "xNew").size(), 25u);
    const Project project = read_project(scene, {}, Depth::plan);
    for (const Program& program : project.scene().programs)
        for (const UniformValue& uniform : program.uniforms)
            EXPECT_TRUE(uniform.name.starts_with("xNew")) << program.name << '.' << uniform.name;
    EXPECT_EQ(draw_scene(), before);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Renamed,
                         testing::Values("scenes/light/glass/glass.glib", "scenes/light/workshop/workshop.glib",
                                         "scenes/light/carousel/carousel.glib",
                                         "scenes/light/end-to-end/end-to-end.glib", "scenes/light/varnish/varnish.glib",
                                         "scenes/refraction-room/refraction-room.glib"));

}  // namespace
}  // namespace snell::language
