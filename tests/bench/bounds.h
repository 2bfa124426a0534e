// What each figure is shown beside: the time that the machine needs for the least that must happen.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>

namespace snell::bench {

// To copy so many bytes from one place in memory to another.
void beside_copy(benchmark::State& state, std::size_t bytes);
// To set every pixel of a picture, by a clear of colour and depth. Needs a current context.
void beside_clear(benchmark::State& state, int width, int height);

}  // namespace snell::bench
