#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "src/app/commands.h"
#include "src/app/document.h"
#include "src/app/headless.h"
#include "src/content/image.h"
#include "src/gl/target.h"

namespace snell::app {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

struct Timings {
    double context = 0, load = 0, frame = 0, write = 0;
};

nlohmann::ordered_json stats_json(const Document& document, const gl::Caps& caps, const RenderOptions& options,
                                  const gl::Target& target, const Timings& timings) {
    const Counters& c = document.runtime->counters();
    nlohmann::ordered_json json;
    json["scene"] = options.scene;
    json["output"] = options.output;
    json["size"] = {target.width, target.height};
    json["samples"] = target.samples;
    json["time"] = options.time;
    json["renderer"] = caps.renderer;
    json["gl"] = caps.version;
    json["glsl"] = caps.glsl;
    json["milliseconds"] = {
        {"context", timings.context}, {"load", timings.load}, {"frame", timings.frame}, {"write", timings.write}};
    json["errors"] = document.diagnostics.errors();
    json["warnings"] = document.diagnostics.warnings();
    json["counters"] = {{"files_opened", c.files_opened},
                        {"bytes_read", c.bytes_read},
                        {"images_decoded", c.images_decoded},
                        {"bytes_decoded", c.bytes_decoded},
                        {"bytes_uploaded", c.bytes_uploaded},
                        {"textures", c.textures},
                        {"buffers", c.buffers},
                        {"programs_compiled", c.programs_compiled},
                        {"targets", c.targets},
                        {"frames", c.frames},
                        {"passes", c.passes},
                        {"draws", c.draws},
                        {"triangles", c.triangles},
                        {"trees", c.trees},
                        {"uniform_uploads", c.uniform_uploads},
                        {"state_changes", c.state_changes},
                        {"gpu_bytes", c.gpu_bytes}};
    return json;
}

// Opaque pictures have three channels: what blending left in the alpha channel is nobody's.
content::Image opaque_picture(const std::vector<std::byte>& rgba, int width, int height) {
    content::Image image;
    image.width = width;
    image.height = height;
    image.channels = 3;
    image.type = content::PixelType::u8;
    image.pixels.resize(static_cast<size_t>(width) * static_cast<size_t>(height) * 3);
    for (size_t i = 0; i < image.pixels.size() / 3; ++i) std::memcpy(&image.pixels[i * 3], &rgba[i * 4], 3);
    return image;
}

// Said before anything is drawn: a name that can't be written should not cost a rendering.
bool check_output(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
        fmt::print(stderr, "snell: error: can't write '{}': there is no folder '{}'\n", path, folder.string());
        return false;
    }
    return true;
}

void print_diagnostics(const Document& document, bool quiet) {
    const bool verbose = !quiet && document.runtime && document.scene().verbose;
    if (verbose) fmt::print(stderr, "{}", verbose_report(document));
    Diagnostics shown;
    for (const Diagnostic& diagnostic : document.diagnostics.items()) {
        const bool wanted = diagnostic.severity == Severity::note ? verbose : !quiet;
        if (diagnostic.severity == Severity::error || wanted) shown.add(diagnostic);
    }
    const std::string text = snell::render(shown, document.sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
    if (!document.runtime) return;
    for (const Message& message : document.scene().messages) fmt::print(stderr, "{}\n", message.text);
}

bool apply_sets(Document& document, const std::vector<std::string>& sets) {
    Diagnostics problems;
    for (const std::string& set : sets) set_control(document.controls, document.scene(), set, problems);
    const std::string text = snell::render(problems, document.sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
    return !problems.has_errors();
}

}  // namespace

int render(const RenderOptions& options) {
    if (!check_output(options.output)) return exit_input;
    const auto start = Clock::now();
    auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    const gl::Caps caps = gl::query_caps();
    const auto context_made = Clock::now();

    Diagnostics unknown;
    auto document = open_document(options.scene, caps, [&](const Scene& scene, Rungs& rungs) {
        for (const std::string& ladder : options.ladders) choose_rung(rungs, scene, ladder, unknown);
    });
    print_diagnostics(*document, options.quiet);
    fmt::print(stderr, "{}", snell::render(unknown, document->sources));
    if (!document->runtime || unknown.has_errors() || !apply_sets(*document, options.sets)) return exit_input;
    const auto loaded = Clock::now();

    const auto [width, height] =
        options.size.value_or(std::pair(document->scene().window_size[0], document->scene().window_size[1]));
    if (width > caps.max_texture || height > caps.max_texture) {
        fmt::print(stderr, "snell: error: {}x{} is more than this OpenGL draws ({})\n", width, height,
                   caps.max_texture);
        return exit_input;
    }
    const gl::Target target = gl::make_target(width, height, options.samples);
    if (!target.framebuffer) {
        fmt::print(stderr, "snell: error: this OpenGL gives no picture of {}x{} with {} samples\n", width, height,
                   options.samples);
        return exit_graphics;
    }
    View view;
    view.axes = options.axes;
    document->runtime->draw({options.time, view, document->controls}, {target.framebuffer.get(), width, height});
    const auto pixels = gl::read_rgba8(target.framebuffer.get(), width, height, target.samples);
    const auto drawn = Clock::now();
    if (const std::string error = content::write_image(options.output, opaque_picture(pixels, width, height));
        !error.empty()) {
        fmt::print(stderr, "snell: error: can't write '{}': {}\n", options.output, error);
        return exit_input;
    }
    if (!options.stats.empty()) {
        const Timings timings{milliseconds(start, context_made), milliseconds(context_made, loaded),
                              milliseconds(loaded, drawn), milliseconds(drawn, Clock::now())};
        std::ofstream file(options.stats);
        file << stats_json(*document, caps, options, target, timings).dump(2) << '\n';
        if (!file.flush()) {
            fmt::print(stderr, "snell: error: can't write '{}'\n", options.stats);
            return exit_input;
        }
    }
    return document->diagnostics.has_errors() ? exit_input : exit_fine;
}

}  // namespace snell::app
