// Pictures: what a scene waits for before its first frame.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "src/content/cubemap.h"
#include "src/content/noise.h"

namespace snell::content {
namespace {

Image picture(int width, int height, int channels) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.pixels.resize(image.bytes());
    std::uint32_t seed = 1;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        seed = seed * 1664525u + 1013904223u;
        image.pixels[i] = static_cast<std::byte>(i * 255 / image.pixels.size() + (seed >> 28));
    }
    return image;
}

// The bytes of a picture as a file of this extension.
std::string encoded(const Image& image, const std::string& extension) {
    const auto path =
        std::filesystem::temp_directory_path() / ("snell-bench-" + std::to_string(image.width) + "." + extension);
    if (const std::string wrong = write_image(path.string(), image); !wrong.empty())
        std::fprintf(stderr, "%s\n", wrong.c_str());
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    std::filesystem::remove(path);
    return bytes.str();
}

void noise(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(make_noise(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
}
BENCHMARK(noise)->Args({2, 64})->Args({2, 512})->Args({3, 64})->Args({3, 128})->Args({3, 256})->UseRealTime()->Unit(
    benchmark::kMillisecond);

void six_faces(benchmark::State& state, const std::string& extension) {
    const std::string bytes = encoded(picture(1024, 1024, 3), extension);
    for (auto _ : state)
        benchmark::DoNotOptimize(decode_faces([&](int) { return decode_image("face." + extension, bytes); }));
}
BENCHMARK_CAPTURE(six_faces, bmp, std::string("bmp"))->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(six_faces, png, std::string("png"))->UseRealTime()->Unit(benchmark::kMillisecond);

void panorama(benchmark::State& state) {
    const Image image = picture(static_cast<int>(state.range(0)), static_cast<int>(state.range(0)) / 2, 3);
    for (auto _ : state) benchmark::DoNotOptimize(split_cube(image, CubeLayout::equirectangular));
}
BENCHMARK(panorama)->Arg(1024)->Arg(4096)->UseRealTime()->Unit(benchmark::kMillisecond);

void write_png(benchmark::State& state) {
    const Image image = picture(static_cast<int>(state.range(0)), static_cast<int>(state.range(0)), 4);
    for (auto _ : state) benchmark::DoNotOptimize(encoded(image, "png"));
}
BENCHMARK(write_png)->Arg(256)->Arg(1024)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace snell::content

BENCHMARK_MAIN();
