// Every service at every place of all scenes and shaders of the repository, whole and cut off: spans lie in their
// texts.
#include "tests/language/help.h"
#include "tests/sanitized.h"
#include "tests/torture/mutate.h"

namespace snell::language {
namespace {

namespace fs = std::filesystem;

class Sweep {
public:
    explicit Sweep(const Project& project) : project_(project) {}

    void check(const Span& span) const {
        const std::size_t size = project_.sources.text(span.file).size();
        ASSERT_LE(span.begin, span.end);
        ASSERT_LE(span.end, size);
    }

    void at(FileId file, std::uint32_t offset) const {
        for (const Completion& one : completions(project_, file, offset)) {
            check(one.replaced);
            ASSERT_LE(one.replaced.begin, offset);
            ASSERT_GE(one.replaced.end, offset);
            for (const Edit& edit : one.also) check(edit.span);
        }
        if (const auto found = hover(project_, file, offset)) {
            check(found->span);
            ASSERT_LE(found->span.begin, offset);
            ASSERT_GE(found->span.end, offset);
        }
        if (const auto help = signature_help(project_, file, offset)) {
            ASSERT_LT(help->signature, help->signatures.size());
            for (const Signature& one : help->signatures)
                for (const auto& [begin, end] : one.parameters) ASSERT_LE(end, one.label.size()) << begin;
        }
    }

    void names_at(FileId file, std::uint32_t offset) const {
        for (const Span& span : definition(project_, file, offset)) check(span);
        for (const Span& span : references(project_, file, offset)) check(span);
        Span last{};
        for (const Edit& edit : rename(project_, file, offset, "uFreshName").edits) {
            check(edit.span);
            ASSERT_TRUE(edit.span.file != last.file || edit.span.begin >= last.end);
            last = edit.span;
        }
    }

    void whole(FileId file) const {
        check_symbols(symbols(project_, file),
                      {file, 0, static_cast<std::uint32_t>(project_.sources.text(file).size())});
        for (const Color& color : colors(project_, file)) {
            check(color.span);
            for (const Edit& edit : color_edits(project_, color.span, {.1, .2, .3, .4})) check(edit.span);
        }
    }

private:
    void check_symbols(const std::vector<Symbol>& all, const Span& within) const {
        for (const Symbol& symbol : all) {
            check(symbol.span);
            ASSERT_GE(symbol.span.begin, within.begin) << symbol.name;
            ASSERT_LE(symbol.span.end, within.end) << symbol.name;
            ASSERT_GE(symbol.name_span.begin, symbol.span.begin) << symbol.name;
            ASSERT_LE(symbol.name_span.end, symbol.span.end) << symbol.name;
            check_symbols(symbol.children, symbol.span);
        }
    }

    const Project& project_;
};

std::vector<std::string> scenes(std::initializer_list<const char*> folders) {
    std::vector<std::string> found;
    for (const char* folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".glib") found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    return found;
}

TEST(LanguageSweep, EveryTextAsAWhole) {
    for (const std::string& path : scenes({"scenes", "tests/odd", "tests/bad", "tests/cases"})) {
        SCOPED_TRACE(path);
        const Project project = read_project(path, {}, Depth::plan);
        const Sweep sweep(project);
        sweep.whole(project.scene_file);
        for (const Shader& shader : project.shaders) sweep.whole(shader.file);
        if (testing::Test::HasFatalFailure()) return;
    }
}

// A prime step visits other places of each text.
TEST(LanguageSweep, ManyPlaces) {
    std::uint32_t next = 0;
    for (const std::string& path : scenes({"scenes", "tests/odd", "tests/bad"})) {
        SCOPED_TRACE(path);
        const Project project = read_project(path, {}, Depth::plan);
        const Sweep sweep(project);
        std::vector<FileId> files{project.scene_file};
        for (const Shader& shader : project.shaders) files.push_back(shader.file);
        for (const FileId file : files) {
            const auto size = static_cast<std::uint32_t>(project.sources.text(file).size());
            for (std::uint32_t at = next % 97; at <= size; at += size < 200 ? 3 : 2003) sweep.at(file, at);
            for (std::uint32_t at = next % 97; at <= size; at += size < 200 ? 17 : 6007) sweep.names_at(file, at);
            ++next;
        }
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(LanguageSweep, CutOffTexts) {
    const Scratch scratch;
    const std::string scene = bytes_of("scenes/light/glass/glass.glib");
    const std::string shader = bytes_of("scenes/light/glass/glass.frag");
    for (std::size_t cut = 0; cut < std::max(scene.size(), shader.size()); cut += 263) {
        SCOPED_TRACE(cut);
        scratch.write("glass.frag", shader.substr(0, cut));
        const bool whole = cut > scene.size();
        const std::string path = scratch.write(
            "glass.glib", whole ? "Fragment glass.frag\nProgram Glass uIndex 1\nSphere\n" : scene.substr(0, cut));
        const Project project = read_project(path, {}, Depth::plan);
        const Sweep sweep(project);
        sweep.whole(project.scene_file);
        const auto end = static_cast<std::uint32_t>(project.sources.text(project.scene_file).size());
        sweep.at(project.scene_file, end);
        sweep.names_at(project.scene_file, end);
        for (const Shader& one : project.shaders) {
            sweep.whole(one.file);
            const auto last = static_cast<std::uint32_t>(project.sources.text(one.file).size());
            sweep.at(one.file, last);
            sweep.names_at(one.file, last);
        }
        if (testing::Test::HasFatalFailure()) return;
    }
}

// Of the processor, which other programs share.
double milliseconds(const std::function<void()>& work, int runs = 3) {
    double best = 1e9;
    for (int i = 0; i < runs; ++i) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

TEST(LanguageSweep, DamagedTexts) {
    const Scratch scratch;
    torture::Random random(7);
    torture::Dictionary dictionary;
    const std::string scene = bytes_of("scenes/light/workshop/workshop.glib");
    const std::string shader = bytes_of("scenes/light/workshop/things.frag");
    torture::learn(dictionary, torture::Language::scene, scene);
    torture::learn(dictionary, torture::Language::shader, shader);
    const std::string begin = "Vertex a.vert\nFragment a.frag\nProgram Damaged uKa <0. .2 1.>\n";
    scratch.write("a.vert", vertex);
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE(round);
        std::string damaged_scene = scene, damaged_shader = shader;
        for (int i = 0; i <= round % 5; ++i) {
            torture::damage(damaged_scene, torture::Language::scene, dictionary, random);
            torture::damage(damaged_shader, torture::Language::shader, dictionary, random);
        }
        scratch.write("a.frag", damaged_shader);
        const Project project = read_project(scratch.write("a.glib", begin + damaged_scene), {}, Depth::plan);
        const Sweep sweep(project);
        std::vector<FileId> files{project.scene_file};
        for (const Shader& one : project.shaders) files.push_back(one.file);
        for (const FileId file : files) {
            sweep.whole(file);
            const std::size_t size = project.sources.text(file).size();
            for (int i = 0; i < 4; ++i) {
                const auto at = static_cast<std::uint32_t>(torture::below(random, size + 1));
                sweep.at(file, at);
                sweep.names_at(file, at);
            }
        }
        if (testing::Test::HasFatalFailure()) return;
    }
}

// Texts that make careless readers take the square of their length.
TEST(LanguageSweep, OddTextsTakeNoLongerThanOthers) {
    for (const std::string part :
         {"a]", "{", "in a{", "(", "x.", "#if\n", "struct s{", "for(", "float x;{", "layout(", "/*/", "a,"}) {
        std::string text = "uniform float uKa;\nvoid main() {\n";
        while (text.size() < 60'000) text += part;
        const Editor editor("Fragment a.frag\nProgram A uKa 1.\n", {{"a.frag", text}});
        const Project& project = editor.project();
        const FileId file = editor.file("a.frag");
        const auto end = static_cast<std::uint32_t>(text.size());
        const auto ask = [&] {
            completions(project, file, end);
            symbols(project, file);
        };
        const double took = milliseconds(ask, 1);
        EXPECT_LT(took, 400 * patience) << part;
    }
}

TEST(LanguageSweep, LongTextsAreAnsweredSoon) {
    std::string scene = "Fragment long.frag\nProgram Long uKa <0. .2 1.>\n", shader = "uniform float uKa, uKd;\n";
    for (int i = 0; i < 20'000; ++i) scene += "Sphere 1 " + std::to_string(i % 90 + 3) + " 30 # a sphere\n";
    for (int i = 0; i < 5'000; ++i) {
        const std::string n = std::to_string(i);
        shader += "float f" + n + "(float a) {\n    float b" + n + " = a * uKa;\n    return b" + n + ";\n}\n";
    }
    shader += "void main() { gl_FragColor = vec4(@); }\n";
    const Editor editor(scene, {{"long.frag", shader}});
    const Project& project = editor.project();
    const auto middle = static_cast<std::uint32_t>(scene.size() / 2);
    const double most = 50 * patience;
    const auto expect_soon = [&](const char* what, const std::function<void()>& work) {
        const double took = milliseconds(work);
        std::printf("%-28s %6.1f ms\n", what, took);
        EXPECT_LT(took, most) << what;
    };
    expect_soon("scene: completion", [&] { completions(project, project.scene_file, middle); });
    expect_soon("scene: hover", [&] { hover(project, project.scene_file, middle); });
    expect_soon("scene: symbols", [&] { symbols(project, project.scene_file); });
    expect_soon("scene: colours", [&] { colors(project, project.scene_file); });
    expect_soon("shader: completion", [&] { completions(project, editor.file(), editor.offset()); });
    expect_soon("shader: hover", [&] { hover(project, editor.file(), editor.offset() - 6); });
    expect_soon("shader: symbols", [&] { symbols(project, editor.file()); });
    expect_soon("shader: references", [&] { references(project, editor.file(), 15); });
    expect_soon("shader: rename", [&] { rename(project, editor.file(), 15, "uFresh"); });
}

}  // namespace
}  // namespace snell::language
