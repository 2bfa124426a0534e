// How fast scenes are read, beside the time it takes to find the line ends of the same text.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

#include "parser/read/parse.h"
#include "tests/bench/bounds.h"

namespace {

// A scene of many objects, as programs write them: half of it geometry, the rest programs, textures, comments.
std::string make_scene(std::size_t bytes) {
    std::mt19937 random(7);
    const auto number = [&](double range) {
        char text[32];
        std::snprintf(text, sizeof text, "%.4f", (random() / 2147483648.0 - 1) * range);
        return std::string(text);
    };
    std::string out = "##OpenGL GLIB\nPerspective 70\nLookAt 0. 0. 5. 0. 0. 0. 0. 1. 0.\n";
    out.reserve(bytes + 1000);
    for (int i = 0; out.size() < bytes; ++i) {
        if (i % 50 == 0)
            out +=
                "\n# ---- the next group of objects, with a program of its own ----\nVertex pattern.vert\n"
                "Fragment pattern.frag\nProgram Pattern" +
                std::to_string(i) +
                "  uKa <0. 0.1 1.0>  uKd <0. 0.6 1.0>  uKs <0. 0.3 1.0> \\\n\tuShininess <1. 10. 100.>  "
                "uColor {1. .5 0. 1.}  uTexUnit 6\nTexture2D 6 textures/wall" +
                std::to_string(i % 7) + ".bmp\n";
        out += "PushMatrix\n\tTranslate " + number(10) + " " + number(10) + " " + number(10) + "\n";
        out += "\tRotate " + number(180) + " 0. 1. 0.\n\tScale " + number(2) + "\n";
        if (i % 3 == 0) out += "\tColor " + number(1) + " " + number(1) + " " + number(1) + "\n";
        out += i % 2 == 0 ? "\tSphere 1. 20 20\n" : "\tObj models/tree.obj   # one of many\n";
        out += "PopMatrix\n";
    }
    return out;
}

const std::string& scene() {
    static const std::string text = make_scene(20u << 20);
    return text;
}

std::size_t resident_bytes() {
    std::ifstream in("/proc/self/statm");
    std::size_t total = 0, resident = 0;
    in >> total >> resident;
    return resident * 4096;
}

void parse_scene(benchmark::State& state) {
    std::size_t draws = 0;
    double ratio = 0;
    for (auto _ : state) {
        state.PauseTiming();
        snell::Sources sources;
        std::string text = scene();
        const std::size_t before = resident_bytes();
        state.ResumeTiming();
        const snell::FileId file = sources.add("scene.glib", std::move(text));
        const snell::Parsed parsed = snell::parse(file, sources);
        draws = parsed.scene.draws.size();
        state.PauseTiming();
        ratio = static_cast<double>(resident_bytes() - before) / static_cast<double>(scene().size());
        state.ResumeTiming();
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * scene().size()));
    snell::bench::beside_copy(state, scene().size());
    state.counters["draws"] = static_cast<double>(draws);
    state.counters["scene_bytes_per_text_byte"] = ratio;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    // The benchmark itself holds the text twice.
    state.counters["peak_per_text_byte"] =
        static_cast<double>(usage.ru_maxrss) * 1024 / static_cast<double>(scene().size()) - 1;
}
BENCHMARK(parse_scene)->Name("parse/scene of 20 MB")->Unit(benchmark::kMillisecond);

void scan_lines(benchmark::State& state) {
    const std::string& text = scene();
    for (auto _ : state) {
        std::size_t lines = 0;
        for (const char* at = text.data(); (at = static_cast<const char*>(std::memchr(
                                                at, '\n', static_cast<std::size_t>(text.data() + text.size() - at))));
             ++at)
            ++lines;
        benchmark::DoNotOptimize(lines);
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}
BENCHMARK(scan_lines)->Name("parse/its line ends alone")->Unit(benchmark::kMillisecond);

}  // namespace
