// A scene whose names are all others draws the same picture.
#include <filesystem>
#include <map>
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

    // Renames all that can be renamed at once, in the scene and in every shader; returns how many names that are.
    static int rename_all(const std::string& scene) {
        const Project project = read_project(scene, {}, Depth::plan);
        std::vector<FileId> files{project.scene_file};
        for (const Shader& shader : project.shaders)
            if (!shader.path.empty()) files.push_back(shader.file);
        std::map<std::pair<FileId, std::uint32_t>, Edit> edits;
        int renamed = 0;
        for (const FileId file : files)
            for (const SemanticToken& token : semantic_tokens(project, file)) {
                if (edits.contains({file, token.span.begin})) continue;
                const Rename result = rename(project, file, token.span.begin, "xNew" + std::to_string(renamed));
                for (const Edit& edit : result.edits)
                    EXPECT_TRUE(edits.emplace(std::pair(edit.span.file, edit.span.begin), edit).second)
                        << "two names claim '" << project.sources.text(file).substr(token.span.begin, 20) << "'";
                renamed += result.edits.empty() ? 0 : 1;
            }
        std::vector<Edit> all;
        for (const auto& [place, edit] : edits) all.push_back(edit);
        write(project, all);
        return renamed;
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
    EXPECT_GT(rename_all(scene), 25);
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
