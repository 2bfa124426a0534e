// How long geometry takes: an .obj of 100,000 triangles is to be ready in a quarter of a second.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>

#include "src/content/mesh/mesh.h"
#include "src/content/mesh/obj.h"
#include "tests/bench/bounds.h"

namespace snell::content {
namespace {

// A torus of 2 x n x n triangles with positions, texture coordinates and normals, or positions alone.
std::string torus_obj(int n, bool attributes) {
    const Mesh m = make_shape(Torus{1, .5, n, n}, false).mesh;
    std::string text;
    char line[128];
    const auto print = [&](auto... values) {
        text.append(line, static_cast<std::size_t>(std::snprintf(line, sizeof line, values...)));
    };
    for (const Float3& p : m.positions) print("v %.6f %.6f %.6f\n", p[0], p[1], p[2]);
    if (attributes)
        for (const Float3& t : m.texcoords) print("vt %.6f %.6f\n", t[0], t[1]);
    if (attributes)
        for (const Float3& v : m.normals) print("vn %.6f %.6f %.6f\n", v[0], v[1], v[2]);
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
        const auto a = m.indices[i] + 1, b = m.indices[i + 1] + 1, c = m.indices[i + 2] + 1;
        if (attributes)
            print("f %u/%u/%u %u/%u/%u %u/%u/%u\n", a, a, a, b, b, b, c, c, c);
        else
            print("f %u %u %u\n", a, b, c);
    }
    return text;
}

void parse(benchmark::State& state, ObjAs as, bool wire, bool attributes) {
    const std::string text = torus_obj(224, attributes);
    std::size_t triangles = 0;
    for (auto _ : state) {
        const MeshResult r = parse_obj(text, as, wire);
        triangles = r.mesh.indices.size() / 3;
        benchmark::DoNotOptimize(r.mesh.positions.data());
    }
    bench::beside_copy(state, text.size());
    state.counters["triangles"] = static_cast<double>(triangles);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

// What of it is tinyobjloader's and the checks of each line.
void read_only(benchmark::State& state) {
    const std::string text = torus_obj(224, true);
    for (auto _ : state) {
        std::vector<MeshIssue> issues;
        benchmark::DoNotOptimize(read_obj(text, {}, issues));
    }
    bench::beside_copy(state, text.size());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void shape(benchmark::State& state, const Shape& shape) {
    const Mesh made = make_shape(shape, false).mesh;
    for (auto _ : state) benchmark::DoNotOptimize(make_shape(shape, false));
    bench::beside_copy(state, (made.positions.size() + made.normals.size() + made.texcoords.size()) * sizeof(Float3) +
                                  made.indices.size() * sizeof(made.indices[0]));
}

constexpr auto triangles = ObjAs::triangles;
BENCHMARK_CAPTURE(parse, plain, triangles, false, true)->Name("OBJ/100,000 triangles")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(parse, bare, triangles, false, false)
    ->Name("OBJ/100,000 triangles without normals")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(parse, adjacency, ObjAs::adjacency, false, true)
    ->Name("OBJ/100,000 triangles with adjacency")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(parse, wire, triangles, true, true)
    ->Name("OBJ/100,000 triangles as wires")
    ->Unit(benchmark::kMillisecond);
BENCHMARK(read_only)->Name("OBJ/100,000 triangles, the reading alone")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shape, ball, Sphere{})->Name("shapes/Sphere 60 x 60")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shape, fine_ball, Sphere{1, 1000, 1000})
    ->Name("shapes/Sphere 1000 x 1000")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shape, teapot, Teapot{})->Name("shapes/Teapot")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shape, soccerball, Soccerball{})->Name("shapes/Soccerball")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace snell::content
