// Scenes as a whole: planned, opened, drawn; and what a process of snell's takes.
#include <filesystem>
#include <optional>

#include "src/document/document.h"
#include "src/gl/target.h"
#include "src/plan/plan.h"
#include "tests/bench/bounds.h"
#include "tests/bench/context.h"
#include "tests/bench/drawing.h"
#include "tests/bench/timing.h"
#include "tests/scratch.h"

namespace snell::bench {
namespace {

struct Typical {
    const char *name, *path;
};
constexpr std::array<Typical, 5> typical{{{"refraction room", "scenes/refraction-room/refraction-room.glib"},
                                          {"ambient light", "scenes/light/ambient/ambient.glib"},
                                          {"mirror", "scenes/light/mirror/mirror.glib"},
                                          {"transparency", "scenes/light/transparency/transparency.glib"},
                                          {"carousel", "scenes/light/carousel/carousel.glib"}}};
constexpr std::array<std::array<int, 2>, 3> sizes{{{512, 512}, {1280, 720}, {1920, 1080}}};

void plan(benchmark::State& state, const char* path) {
    std::size_t bytes = 0;
    for (auto _ : state) {
        Files files(scene_folder(path));
        Sources sources;
        Diagnostics diagnostics;
        const auto made = read_plan(path, files, sources, diagnostics);
        if (!made) return state.SkipWithError("can't be read");
        benchmark::DoNotOptimize(made->meshes.data());
        bytes = files.counters().bytes;
    }
    beside_copy(state, bytes);
}

// From the scene's name to its first picture, in a context that is there; the driver has seen the programs before.
void first_picture(benchmark::State& state, const char* path) {
    const gl::Caps* caps = graphics();
    if (!caps) return state.SkipWithError("no graphics");
    const gl::Target target = gl::make_target(512, 512, 1);
    std::size_t bytes = 0;
    for (auto _ : state) {
        const auto document = open_document(path, *caps);
        if (document->diagnostics.has_errors()) return state.SkipWithError("the scene has errors");
        draw_frame(*document, target);
        const Counters& counters = document->runtime->counters();
        bytes = counters.bytes_read + counters.bytes_decoded + counters.bytes_uploaded;
    }
    beside_copy(state, bytes);
}

void frame(benchmark::State& state, const char* path, int width, int height) {
    const gl::Caps* caps = graphics();
    if (!caps) return state.SkipWithError("no graphics");
    const auto document = open_document(path, *caps);
    if (document->diagnostics.has_errors()) return state.SkipWithError("the scene has errors");
    const gl::Target target = gl::make_target(width, height, 1);
    time_frames(state, *document, target);
    beside_clear(state, width, height);
}

// ---- whole processes, from start to end ------------------------------------------------------------------

// Beside this program.
std::string snell_binary() { return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "snell"; }

constexpr const char* trivial = "Perspective 60\nLookAt 0 0 4  0 0 0  0 1 0\nColor 1 .5 0\nSphere 1 30 30\n";

// `pictures`: among which the time is shared.
void process(benchmark::State& state, std::vector<std::string> arguments, int pictures) {
    arguments.insert(arguments.begin(), snell_binary());
    try {
        measure_process(arguments);
        double cpu = 0;
        for (auto _ : state) {
            const Times times = measure_process(arguments);
            state.SetIterationTime(times.wall / 1e3);
            cpu += times.cpu;
        }
        state.counters["process_cpu_ms"] = cpu / static_cast<double>(state.iterations());
    } catch (const std::exception& problem) {
        return state.SkipWithError(problem.what());
    }
    state.counters["pictures"] = pictures;
    state.counters["pictures_per_second"] = benchmark::Counter(pictures, benchmark::Counter::kIsIterationInvariantRate);
}

std::vector<std::string> trivial_arguments(const Scratch& scratch, int count) {
    std::vector<std::string> arguments{"render"};
    for (int i = 0; i < count; ++i) arguments.push_back(scratch.write(std::to_string(i) + ".glib", trivial));
    arguments.insert(arguments.end(), {"--size", "256x256", "-q", "-o", scratch.path("{stem}.png")});
    return arguments;
}

void one_trivial(benchmark::State& state) {
    const Scratch scratch;
    process(state, trivial_arguments(scratch, 1), 1);
}

void hundred_trivial(benchmark::State& state) {
    const Scratch scratch;
    process(state, trivial_arguments(scratch, 100), 100);
}

void sweep_of_hundred(benchmark::State& state) {
    const Scratch scratch;
    process(state,
            {"sweep", typical[0].path, "--over", "uIndex=1:2.5:10", "--over", "uMix=0:1:10", "--size", "512x512",
             "--samples", "1", "-q", "-o", scratch.path("{index}.png")},
            100);
}

BENCHMARK(one_trivial)->Name("process/a trivial scene, 256 x 256")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(hundred_trivial)
    ->Name("process/100 trivial scenes, 256 x 256")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(sweep_of_hundred)
    ->Name("process/sweep of 100 pictures, 512 x 512")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

[[maybe_unused]] const bool registered = [] {
    const auto add = [](const std::string& name, auto function) {
        benchmark::RegisterBenchmark(name.c_str(), function)
            ->MeasureProcessCPUTime()
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    };
    for (const Typical& scene : typical) {
        const std::string name = scene.name;
        add("plan/" + name, [scene](benchmark::State& state) { plan(state, scene.path); });
        add("first picture/" + name, [scene](benchmark::State& state) { first_picture(state, scene.path); });
        for (const auto& [width, height] : sizes)
            add("frame/" + name + ", " + std::to_string(width) + " x " + std::to_string(height),
                [scene, width = width, height = height](benchmark::State& state) {
                    frame(state, scene.path, width, height);
                });
    }
    return true;
}();

}  // namespace
}  // namespace snell::bench
