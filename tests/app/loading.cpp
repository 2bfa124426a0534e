// Everything that scenes load, many at a time: the same as one after the other. The thread sanitizer looks on.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "src/app/picture/outputs.h"
#include "src/content/image/noise.h"
#include "src/plan/plan.h"
#include "src/runtime/resources/textures.h"
#include "tests/no_more_threads.h"
#include "tests/scratch.h"

namespace snell {
namespace {

struct Loaded {
    std::vector<content::Image> images;  // one, or the faces of a cube map
    content::Mesh mesh;
    Diagnostics said;
};

// Textures and meshes that share files with each other, and files that are missing or no pictures.
class LoadingAtOnce : public testing::Test {
protected:
    void SetUp() override {
        for (int i = 0; i < 6; ++i) {
            content::Image picture = content::checkerboard(32);
            for (std::byte& byte : picture.pixels) byte ^= static_cast<std::byte>(i);
            const std::string name = "p" + std::to_string(i) + ".png";
            ASSERT_EQ(content::write_image(folder_.path(name), picture), "");
            texture(TextureTarget::d2, {name});
        }
        folder_.write("junk.bmp", "\x01\x02\x03");
        folder_.write("grid.obj", grid(24));
        for (const char* name : {"p0.png", "P0.PNG", "junk.bmp", "none.bmp"}) texture(TextureTarget::d2, {name});
        for (int turn = 0; turn < 3; ++turn)
            texture(TextureTarget::cube, {"p0.png", "p1.png", "p2.png", "p3.png", "p4.png", "p5.png"});
        texture(TextureTarget::cube, {"p0.png", "junk.bmp", "p2.png", "none.bmp", "p4.png", "p5.png"});
        plan_.scene.files.push_back({"grid.obj", {0, 10, 18}});
        plan_.scene.files.push_back({"Grid", {0, 20, 24}});
        for (const Index file : {0U, 1U, 0U})
            plan_.meshes.push_back({ObjFile{file, ObjAs::triangles}, file == 1, {0, 30, 40}});
    }

    static std::string grid(int side) {
        std::string text;
        for (int i = 0; i < side * side; ++i)
            text +=
                "v " + std::to_string(i % side) + " " + std::to_string(i / side) + " " + std::to_string(i % 7) + "\n";
        for (int y = 1; y < side; ++y)
            for (int x = 1; x < side; ++x) {
                const int at = y * side + x;
                text +=
                    "f " + std::to_string(at + 1) + " " + std::to_string(at) + " " + std::to_string(at - side) + "\n";
            }
        return text;
    }

    void texture(TextureTarget target, const std::vector<std::string>& names) {
        Texture made;
        made.target = target;
        made.span = {0, 100, 200};
        for (const std::string& name : names) made.files.push_back({name, {0, 110, 115}});
        plan_.scene.textures.push_back(made);
    }

    std::size_t count() const { return plan_.scene.textures.size() + plan_.meshes.size() + 2; }
    void load(std::size_t index, Files& files, ImageCache& cache, Loaded& into) const {
        const auto& textures = plan_.scene.textures;
        if (index < textures.size()) {
            const auto texture = static_cast<Index>(index);
            if (textures[texture].target == TextureTarget::cube) {
                const content::CubeFaces faces = load_cube(plan_.scene, texture, files, into.said, &cache);
                into.images.assign(faces.begin(), faces.end());
            } else {
                into.images = {load_texture(plan_.scene, texture, files, into.said, &cache)};
            }
        } else if (index -= textures.size(); index < plan_.meshes.size()) {
            into.mesh = load_mesh(plan_, static_cast<Index>(index), files, into.said);
        } else {
            const bool flat = index == plan_.meshes.size();
            into.images = {load_noise(flat ? 2 : 3, flat ? 64 : 16, files, into.said)};
        }
    }
    // All of them once, by `work`, which calls its argument for 0..count() from wherever it likes.
    template <class Work>
    std::vector<Loaded> load_all(const Work& work) {
        Files files(folder_.path());
        ImageCache cache;
        std::vector<Loaded> loaded(count());
        work([&](std::size_t i) { load(i, files, cache, loaded[i]); });
        // Each picture is read and decoded once, whoever came first.
        EXPECT_EQ(files.counters().opened, 6U + 1U + plan_.meshes.size());
        EXPECT_EQ(cache.stats().images, 6U);
        return loaded;
    }
    std::vector<Loaded> one_by_one() {
        return load_all([&](const auto& load) {
            for (std::size_t i = 0; i < count(); ++i) load(i);
        });
    }

    static void expect_same(const std::vector<Loaded>& a, const std::vector<Loaded>& b) {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            ASSERT_EQ(a[i].images.size(), b[i].images.size()) << i;
            for (std::size_t k = 0; k < a[i].images.size(); ++k) {
                EXPECT_EQ(a[i].images[k].width, b[i].images[k].width) << i;
                EXPECT_TRUE(a[i].images[k].pixels == b[i].images[k].pixels) << i;
            }
            EXPECT_EQ(a[i].mesh.positions, b[i].mesh.positions) << i;
            EXPECT_EQ(a[i].mesh.indices, b[i].mesh.indices) << i;
            const auto said = std::span(a[i].said.items()), other = std::span(b[i].said.items());
            EXPECT_TRUE(std::ranges::equal(said, other, {}, &Diagnostic::message, &Diagnostic::message)) << i;
        }
    }

    const Scratch folder_;
    Plan plan_;
};

TEST_F(LoadingAtOnce, AsTheRuntimeLoads) {
    const std::vector<Loaded> expected = one_by_one();
    EXPECT_FALSE(expected[0].images[0].pixels.empty());
    EXPECT_EQ(expected.at(plan_.scene.textures.size()).mesh.positions.size(), 24U * 24U - 1)
        << "one corner is in no face";
    std::size_t looks = 0, done = 0;
    for (const Watcher& watcher : {Watcher{}, Watcher{[&](const LoadProgress& now) { ++looks, done = now.done; }}})
        expect_same(expected, load_all([&](const auto& load) {
                        std::vector<runtime::Job> jobs;
                        for (std::size_t i = 0; i < count(); ++i) jobs.push_back({"one", [&load, i] { load(i); }});
                        runtime::run(jobs, watcher);
                    }));
    EXPECT_GT(looks, count());
    EXPECT_EQ(done, count());
}

// As in a browser: progress is reported before each job, and at the end.
TEST(Jobs, AreDoneAndWatchedWithoutThreads) {
    const NoMoreThreads here;
    std::vector<std::string> seen;
    std::vector<runtime::Job> jobs;
    for (const char* name : {"a", "b", "c"}) jobs.push_back({name, [&seen, name] { seen.push_back(name); }});
    runtime::run(jobs, nullptr);
    EXPECT_EQ(seen, (std::vector<std::string>{"a", "b", "c"}));
    seen.clear();
    runtime::run(jobs, [&](const LoadProgress& now) {
        seen.push_back(std::to_string(now.done) + "/" + std::to_string(now.of) + std::string(now.what));
    });
    EXPECT_EQ(seen, (std::vector<std::string>{"0/3a", "a", "1/3b", "b", "2/3c", "c", "3/3"}));
}

// However few cores there are.
TEST_F(LoadingAtOnce, ByEightThreadsThatBeginTogether) {
    const std::vector<Loaded> expected = one_by_one();
    expect_same(expected, load_all([&](const auto& load) {
                    std::atomic<std::size_t> next = 0, here = 0;
                    std::vector<std::jthread> threads;
                    for (int t = 0; t < 8; ++t)
                        threads.emplace_back([&] {
                            for (++here; here < 8;) std::this_thread::yield();
                            for (std::size_t i = next++; i < count(); i = next++) load(i);
                        });
                }));
}

// Pictures that are written while the next ones are made; one can't be.
TEST(WritingAtOnce, EveryPictureIsThereInItsPlace) {
    const Scratch folder;
    app::Writer writer({.hash = true, .tile = true});
    constexpr int pictures = 24;
    const auto name = [&](int i) { return folder.path((i == 7 ? "none/" : "w") + std::to_string(i) + ".png"); };
    for (int i = 0; i < pictures; ++i) writer.add(name(i), content::checkerboard(8 + i));
    const auto& written = writer.finish();
    ASSERT_EQ(written.size(), static_cast<std::size_t>(pictures));
    for (int i = 0; i < pictures; ++i) {
        const app::Written& one = written[static_cast<std::size_t>(i)];
        EXPECT_EQ(one.error.empty(), i != 7) << i << one.error;
        if (i == 7) continue;
        EXPECT_EQ(one.bytes, std::filesystem::file_size(name(i))) << i;
        EXPECT_EQ(one.sha256.size(), 64U) << i;
        for (int k = 0; k < i; ++k) EXPECT_NE(one.sha256, written[static_cast<std::size_t>(k)].sha256);
    }
    EXPECT_EQ(folder.entries(), static_cast<std::size_t>(pictures) - 1);
}

}  // namespace
}  // namespace snell
