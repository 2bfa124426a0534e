// What a runtime has done, and how far it is with loading.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace snell {

// Since the runtime was made; exact, always on. Sums, but for gpu_bytes.
struct Counters {
    // Loading.
    std::uint64_t files_opened = 0, bytes_read = 0;       // by this scene, its text and shaders included
    std::uint64_t images_decoded = 0, bytes_decoded = 0;  // of pixels
    std::uint64_t bytes_uploaded = 0;
    std::uint64_t textures = 0, mip_chains = 0, noise_bytes = 0;
    std::uint64_t meshes = 0, buffers = 0, trees = 0;  // trees: that rays in shaders go through
    std::uint64_t programs_compiled = 0, shaders_compiled = 0;
    std::uint64_t variants = 0;       // of these programs, those that are another form of one before
    std::uint64_t specialised = 0;    // of these programs, those with settled uniforms as constants
    std::uint64_t specialise_us = 0;  // microseconds that they took
    std::uint64_t images_spared = 0;  // files of images that were not opened because of values
    std::uint64_t targets = 0;        // off-screen
    // Drawing.
    std::uint64_t frames = 0, frames_skipped = 0;  // skipped: the last picture still stood
    std::uint64_t passes = 0, draws = 0, triangles = 0, lines = 0, points = 0;
    std::uint64_t blended_draws = 0;
    std::uint64_t specialised_draws = 0;  // by programs with settled uniforms as constants
    std::uint64_t draws_culled = 0;       // of the scene, out of view: not handed to the driver
    std::uint64_t uniform_uploads = 0, state_changes = 0;
    // By vertex shaders that stand for other stages.
    std::uint64_t stage_reads = 0;  // captures that the processor read: of counts, or levels
    std::uint64_t captured_primitives = 0, captured_bytes = 0;
    std::uint64_t cube_faces = 0;    // drawn by RenderToCube
    std::uint64_t convolutions = 0;  // irradiance maps, prefiltered chains and sets of harmonics computed
    std::uint64_t gpu_bytes = 0;     // estimated, of what is held now
};

// The counters by name, for reports. `three`: what three.js's renderer.info calls the same; "" where it has no such.
struct CounterName {
    std::string_view name, three;
    std::uint64_t Counters::*value;
};
std::span<const CounterName> counter_names();

// How far loading is. It begins with {programs, 0 of …}, ends with {draws, n of n}, and each of its stages goes from 0
// to all that it has to do.
struct LoadProgress {
    enum class Stage : std::uint8_t { programs, files, draws };  // files: images, meshes, noise
    Stage stage = Stage::programs;
    std::string_view what;  // a program or a file that is not done yet; "": none
    std::size_t done = 0, of = 0;
};
using Watcher = std::function<void(const LoadProgress& progress)>;

}  // namespace snell

namespace snell::runtime {

// Wall time since it was made.
class Stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began_).count();
    }

private:
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace snell::runtime
