// Plan → GL resources → frames. Needs a current context; calls GL only in its own methods.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "parser/diagnostic.h"
#include "src/gl/caps.h"
#include "src/plan/controls.h"
#include "src/plan/files.h"
#include "src/plan/plan.h"
#include "src/plan/view.h"

namespace snell {

// All that may vary between frames.
struct Frame {
    double time = 0;  // seconds since the scene began
    const View& view;
    const Controls& controls;
    // The frame follows others on a screen: RenderToCube may refresh a few faces only. Else what is drawn depends on
    // nothing but the above.
    bool paced = false;
    // The window's picture is shifted by so many pixels, right and up: for pictures between the pixels.
    std::array<double, 2> shift{0, 0};
    // By Scene::draws: true for those that are left out. Shorter: the others are drawn.
    const std::vector<bool>* hidden = nullptr;
};

// All that a platform is. The framebuffer may be multisampled; row 0 of its pixels is the bottom.
struct Surface {
    unsigned framebuffer = 0;
    int width = 0, height = 0;
};

// Since the runtime was made; exact, always on.
struct Counters {
    std::uint64_t files_opened = 0, bytes_read = 0, images_decoded = 0, bytes_decoded = 0, bytes_uploaded = 0;
    std::uint64_t textures = 0, buffers = 0, trees = 0, programs_compiled = 0, targets = 0;
    std::uint64_t frames = 0, passes = 0, draws = 0, triangles = 0, uniform_uploads = 0, state_changes = 0;
    std::uint64_t cube_faces = 0;    // drawn by RenderToCube
    std::uint64_t convolutions = 0;  // irradiance maps, prefiltered chains and sets of harmonics computed
    std::uint64_t gpu_bytes = 0;     // estimated, of what is held now
};

class Runtime {
public:
    // Compiles the programs, then realises what their active uniforms and the draws call for. Problems go to
    // `diagnostics`; a draw whose program failed is left out. `files` and `sources` outlive the runtime.
    Runtime(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, Diagnostics& diagnostics);
    ~Runtime();
    Runtime(Runtime&&) noexcept;
    Runtime& operator=(Runtime&&) noexcept;

    const Scene& scene() const;
    // By Scene::programs, for the current rungs; empty for one that failed.
    const std::vector<std::vector<ActiveUniform>>& active_uniforms() const;
    // Some drawn program reads Timer or uTime: every moment is another picture.
    bool animated() const;
    bool uses_mouse() const;

    // Compiles and loads what other rungs need and what they did not need before; what they share and what they
    // had is kept. True: the programs may be others now, and with them active_uniforms(). A program that does not
    // compile stays as it was; why is in ladder_problems().
    bool choose(const Rungs& rungs);
    const Rungs& rungs() const;
    // Of the rungs that were chosen last, without what was found when the runtime was made.
    const Diagnostics& ladder_problems() const;

    // Chooses the rungs of `frame.controls` first. Uniforms that only these have get the values of controls that were
    // made from what they made active.
    void draw(const Frame& frame, const Surface& surface);
    // False after a paced frame whose cube maps still show something older: the same frame again would be another.
    bool settled() const;
    const Counters& counters() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace snell
