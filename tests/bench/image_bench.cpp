// Pictures: what a scene waits for before its first frame.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "src/content/cube/cubemap.h"
#include "src/content/image/noise.h"
#include "src/content/workers.h"
#include "tests/bench/bounds.h"

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

void noise(benchmark::State& state, int dimensions, int size) {
    std::size_t bytes = 0;
    for (auto _ : state) bytes = make_noise(dimensions, size).bytes();
    bench::beside_copy(state, bytes);
}
void on_all_cores(benchmark::internal::Benchmark* benchmark) {
    benchmark->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(noise, n2_64, 2, 64)->Name("noise/2D, 64")->Apply(on_all_cores);
BENCHMARK_CAPTURE(noise, n2_512, 2, 512)->Name("noise/2D, 512")->Apply(on_all_cores);
BENCHMARK_CAPTURE(noise, n3_64, 3, 64)->Name("noise/3D, 64")->Apply(on_all_cores);
BENCHMARK_CAPTURE(noise, n3_128, 3, 128)->Name("noise/3D, 128")->Apply(on_all_cores);
BENCHMARK_CAPTURE(noise, n3_256, 3, 256)->Name("noise/3D, 256")->Apply(on_all_cores);

void one_image(benchmark::State& state, const std::string& extension) {
    const Image image = picture(1024, 1024, 3);
    const std::string bytes = encoded(image, extension);
    for (auto _ : state) benchmark::DoNotOptimize(decode_image("picture." + extension, bytes));
    bench::beside_copy(state, image.bytes());
}
BENCHMARK_CAPTURE(one_image, bmp, std::string("bmp"))->Name("images/BMP, 1024 x 1024")->Apply(on_all_cores);
BENCHMARK_CAPTURE(one_image, png, std::string("png"))->Name("images/PNG, 1024 x 1024")->Apply(on_all_cores);

void six_faces(benchmark::State& state, const std::string& extension) {
    const Image image = picture(1024, 1024, 3);
    const std::string bytes = encoded(image, extension);
    for (auto _ : state)
        parallel_blocks(6, [&](std::size_t first, std::size_t last) {
            for (std::size_t face = first; face < last; ++face)
                benchmark::DoNotOptimize(decode_image("face." + extension, bytes));
        });
    bench::beside_copy(state, 6 * image.bytes());
}
BENCHMARK_CAPTURE(six_faces, bmp, std::string("bmp"))->Name("cube maps/six BMP, 1024 x 1024")->Apply(on_all_cores);
BENCHMARK_CAPTURE(six_faces, png, std::string("png"))->Name("cube maps/six PNG, 1024 x 1024")->Apply(on_all_cores);

void panorama(benchmark::State& state, int width) {
    const Image image = picture(width, width / 2, 3);
    for (auto _ : state) benchmark::DoNotOptimize(split_cube(image, CubeLayout::equirectangular));
    bench::beside_copy(state, image.bytes());
}
BENCHMARK_CAPTURE(panorama, small, 1024)->Name("cube maps/panorama, 1024 x 512")->Apply(on_all_cores);
BENCHMARK_CAPTURE(panorama, large, 4096)->Name("cube maps/panorama, 4096 x 2048")->Apply(on_all_cores);

void write_png(benchmark::State& state, int size) {
    const Image image = picture(size, size, 4);
    for (auto _ : state) benchmark::DoNotOptimize(encoded(image, "png"));
    bench::beside_copy(state, image.bytes());
}
BENCHMARK_CAPTURE(write_png, small, 256)->Name("images/write PNG, 256 x 256")->Apply(on_all_cores);
BENCHMARK_CAPTURE(write_png, large, 1024)->Name("images/write PNG, 1024 x 1024")->Apply(on_all_cores);

}  // namespace
}  // namespace snell::content
