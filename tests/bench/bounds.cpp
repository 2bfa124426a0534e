#include "tests/bench/bounds.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "src/accuracy/costs.h"
#include "src/gl/target.h"
#include "tests/bench/timing.h"

namespace snell::bench {
namespace {

// Milliseconds of CPU and of the wall, medians of several tries of at least a millisecond each.
Times typical(const std::function<void()>& work) {
    work();
    const double once = std::max(measure(work).wall, 1e-4);
    const int times = std::clamp(static_cast<int>(1 / once), 1, 10000);
    std::vector<double> cpu, wall;
    for (int i = 0; i < 9; ++i) {
        const Times all = measure([&] {
            for (int k = 0; k < times; ++k) work();
        });
        cpu.push_back(all.cpu / times);
        wall.push_back(all.wall / times);
    }
    return {accuracy::median(cpu), accuracy::median(wall)};
}

template <typename Key, typename Make>
Times once(std::map<Key, Times>& known, const Key& key, Make make) {
    const auto found = known.find(key);
    return found != known.end() ? found->second : known.emplace(key, typical(make())).first->second;
}

void report(benchmark::State& state, const Times& bound) {
    state.counters["bound_cpu_ms"] = bound.cpu;
    state.counters["bound_wall_ms"] = bound.wall;
}

}  // namespace

void beside_copy(benchmark::State& state, std::size_t bytes) {
    static std::map<std::size_t, Times> known;
    state.counters["bytes"] = static_cast<double>(bytes);
    report(state, once(known, bytes, [bytes] {
               return [from = std::vector<char>(bytes, 1), to = std::vector<char>(bytes)]() mutable {
                   std::memcpy(to.data(), from.data(), from.size());
                   benchmark::DoNotOptimize(to.data());
                   benchmark::ClobberMemory();
               };
           }));
}

void beside_clear(benchmark::State& state, int width, int height) {
    static std::map<std::pair<int, int>, Times> known;
    const gl::Target target = gl::make_target(width, height, 1);
    state.counters["pixels"] = static_cast<double>(width) * height;
    report(state, once(known, std::pair(width, height), [&] {
               return [&] {
                   glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
                   glViewport(0, 0, width, height);
                   glClearColor(.1F, .2F, .3F, 1);
                   glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                   glFinish();
               };
           }));
}

}  // namespace snell::bench
