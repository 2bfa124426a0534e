#include "tests/accuracy/gl/common.h"

namespace snell::test {

accuracy::Bench& AccuracyTest::bench_of(const std::string& path, int width, int height) {
    bench.reset();
    read = std::make_unique<Read>();
    read->files = std::make_unique<Files>(scene_folder(path));
    auto parsed = parse_document(path, *read->files, read->sources, read->diagnostics);
    if (parsed) read->plan = make_plan(std::move(parsed->scene), *read->files, read->sources, read->diagnostics);
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

}  // namespace snell::test
