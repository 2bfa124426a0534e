#include "tests/accuracy/gl/common.h"

namespace snell::test {

accuracy::Bench& AccuracyTest::bench_of(const std::string& path, int width, int height) {
    bench.reset();
    read = std::make_unique<Read>();
    read->files = std::make_unique<Files>(scene_folder(path));
    if (auto plan = read_plan(path, *read->files, read->sources, read->diagnostics)) read->plan = std::move(*plan);
    EXPECT_FALSE(read->diagnostics.has_errors()) << render(read->diagnostics, read->sources);
    bench = std::make_unique<accuracy::Bench>(read->plan, *read->files, read->sources, caps,
                                              accuracy::BenchSettings{width, height, 0, {}});
    return *bench;
}

accuracy::Bench& AccuracyTest::bench_of_text(std::string_view scene, int width, int height) {
    return bench_of(folder.write("scene.glib", scene), width, height);
}

void AccuracyTest::TearDown() {
    bench.reset();
    GlTest::TearDown();
}

accuracy::Change AccuracyTest::change(accuracy::ChangeKind kind, std::string_view before,
                                      std::string_view after) const {
    for (FileId file = 0; file < read->sources.size(); ++file)
        if (const std::size_t at = read->sources.text(file).find(before); at != std::string_view::npos) {
            const Span span{file, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + before.size())};
            return {kind, span, std::string(before), std::string(after), {{span, std::string(after)}}};
        }
    ADD_FAILURE() << "no text has " << before;
    return {};
}

void AccuracyTest::write_full(std::string_view fragment) const {
    folder.write("full.vert",
                 "#version 330 compatibility\nvoid main() { gl_Position = vec4(gl_Vertex.xy, 0., 1.); }\n");
    folder.write("full.frag", "#version 330 compatibility\n" + std::string(fragment));
}

}  // namespace snell::test
