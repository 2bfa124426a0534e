// A scene whose names are all others draws the same picture.
#include <filesystem>
#include <set>

#include "src/language/services.h"
#include "src/plan/values/write_back.h"
#include "tests/harness/harness.h"

namespace snell::language {
namespace {

namespace fs = std::filesystem;

class Renamed : public test::GlTest, public testing::WithParamInterface<const char*> {
protected:
    // Applies the edits to the files of the project.
    static void write(const Project& project, const std::vector<Edit>& edits) {
        std::set<FileId> files;
        for (const Edit& edit : edits) files.insert(edit.span.file);
        for (const FileId file : files) {
            const std::string path(project.path_of(file));
            const std::string text = with_edits(project.sources.text(file), file, edits);
            std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
        }
    }

    // Renames the first name that can be renamed and was not renamed yet; false if there is none.
    static bool rename_one(const std::string& scene, int number, std::set<std::string>& seen) {
        const Project project = read_project(scene, {}, Depth::plan);
        std::vector<FileId> files{project.scene_file};
        for (const Shader& shader : project.shaders)
            if (!shader.path.empty()) files.push_back(shader.file);
        for (const FileId file : files)
            for (const Symbol& symbol : symbols(project, file)) {
                if (symbol.name.starts_with("xNew") || !seen.insert(std::to_string(file) + symbol.name).second)
                    continue;
                const Rename result = rename(project, file, symbol.name_span.begin, "xNew" + std::to_string(number));
                if (result.edits.empty()) continue;
                write(project, result.edits);
                return true;
            }
        return false;
    }
};

TEST_P(Renamed, TheSamePicture) {
    fs::copy("scenes", folder.path("scenes"), fs::copy_options::recursive);
    const std::string scene = folder.path(GetParam());
    const auto draw_scene = [&] {
        auto document = open_file(scene);
        expect_clean(*document);
        return document->runtime ? draw(*document) : test::Picture();
    };
    const test::Picture before = draw_scene();
    std::set<std::string> seen;
    int renamed = 0;
    while (rename_one(scene, renamed, seen)) ++renamed;
    EXPECT_GT(renamed, 8);
    const Project project = read_project(scene, {}, Depth::plan);
    for (const Program& program : project.scene().programs)
        for (const UniformValue& uniform : program.uniforms)
            EXPECT_TRUE(uniform.name.starts_with("xNew")) << program.name << '.' << uniform.name;
    EXPECT_EQ(draw_scene(), before);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Renamed,
                         testing::Values("scenes/light/glass/glass.glib", "scenes/light/workshop/workshop.glib",
                                         "scenes/light/carousel/carousel.glib", "scenes/light/varnish/varnish.glib",
                                         "scenes/refraction-room/refraction-room.glib"));

}  // namespace
}  // namespace snell::language
