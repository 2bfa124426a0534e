// snell_bench: all benchmarks but those of whole processes; run in the repository's folder. Takes the flags of Google
// Benchmark.
#include <benchmark/benchmark.h>

#include "tests/bench/context.h"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::AddCustomContext("renderer", snell::bench::renderer());
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
