// Plan → GL resources → frames. Needs a current context; calls GL only in its own methods.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "parser/text/diagnostic.h"
#include "src/gl/context.h"
#include "src/gl/texels.h"
#include "src/gl/texture.h"
#include "src/plan/files.h"
#include "src/plan/plan.h"
#include "src/plan/values/controls.h"
#include "src/plan/view.h"
#include "src/runtime/explain.h"
#include "src/runtime/resources/counters.h"

namespace snell {

// What has just been handed to the driver: a draw of a pass (Scene::draws); none: the pass is done.
struct Step {
    Index pass = none, draw = none;
};

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
    // Behind the window's picture, where it is not the scene's.
    std::optional<Vec4> background;
    // By Scene::draws: true for those that are left out. Shorter: the others are drawn.
    const std::vector<bool>* hidden = nullptr;
    // What is off-screen stands as the last frame drew it, at the same time with the same values: only the window is
    // drawn.
    bool standing = false;
    // Nothing blends in the window: its pixels are what the last fragments there wrote.
    bool unblended = false;
    // The picture is enlarged so many times on the screen: lines, points and axes are as thick there as in others.
    int enlarged = 1;
    // Becomes true when a fragment of any draw reaches the window's picture. Null if no one wants to know: the answer
    // waits for the draws.
    bool* reached = nullptr;
    // Called after each draw and each pass, for callers that time the draws.
    const std::function<void(const Step&)>* after = nullptr;
};

// Pixels of a picture, from its bottom left.
struct PixelRect {
    int left = 0, bottom = 0, width = 0, height = 0;
};

// All that a platform is. The framebuffer may be multisampled; row 0 of its pixels is the bottom.
struct Surface {
    unsigned framebuffer = 0;
    int width = 0, height = 0;  // of the picture
    // Only these of the window's pixels are drawn; nullopt: all.
    std::optional<PixelRect> region;
    // The part of the picture that the framebuffer holds; nullopt: all. Parts together give what the whole picture
    // would, if they begin at even numbers, which keep the neighbours that derivatives in shaders see.
    std::optional<PixelRect> part;
};

class Runtime;
// How a runtime goes about it; the pictures are the same.
struct RuntimeOptions {
    // Of an older reading of the scene, in the same context: what did not change is taken over from it, and still its
    // own. None: all is made.
    const Runtime* previous = nullptr;
    // False: everything that is declared is loaded, and everything is set and drawn again for every frame. For tests
    // of what the savings save.
    bool savings = true;
    // Called on the runtime's thread while it is made and when other rungs are chosen, again and again while others
    // read files. It may draw into the default framebuffer. None: nobody looks.
    Watcher progress = nullptr;
    // Sets the values that frames will have, and marks those that frames will change (Control::varies). Programs are
    // then compiled for all other values, as constants. The first frame with other values gets programs that take any,
    // and the runtime keeps to them. None, or no savings: programs take any value from the start.
    std::function<void(Controls& controls, const Scene& scene)> settle = nullptr;
};

class Runtime {
public:
    // Compiles the programs, then realises what their active uniforms and the draws call for. Problems go to
    // `diagnostics`; a draw whose program failed is left out. `files` and `sources` outlive the runtime.
    Runtime(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, Diagnostics& diagnostics,
            const RuntimeOptions& options = {});
    ~Runtime();
    Runtime(Runtime&&) noexcept;
    Runtime& operator=(Runtime&&) noexcept;

    const Scene& scene() const;
    // What a framebuffer of bytes must hold for the window's picture. One of floats gets what the shaders write.
    gl::Pixels display_pixels() const;
    // By Scene::programs, for the current rungs; empty for one that failed.
    const std::vector<std::vector<ActiveUniform>>& active_uniforms() const;
    // The values that the scene's text gives its uniforms, for the current rungs.
    const Controls& controls() const;
    // The problems of these values, which the constructor does not report.
    const Diagnostics& value_problems() const;
    // Some drawn program reads Timer or uTime: every moment is another picture.
    bool animated() const;
    // The same with other values of its uniforms, if not with these.
    bool timed() const;
    bool uses_mouse() const;
    // Loops of some program are long, as glsl::LongLoops says, with some values of its uniforms.
    bool may_have_long_loops() const;
    // How many times larger the values are than those with which all loops are short: 0 if they are short; at least 1
    // if nobody knows.
    double long_loops(const Controls& values) const;
    // The first program (Scene::programs) whose loops are not short with these values; none: there is none.
    Index long_program(const Controls& values) const;
    // Makes the values that bound loops at most so many times larger than those.
    void shorten_loops(Controls& values, double times) const;
    // Something that is drawn reads the texture (Scene::textures), directly or by what is computed from it.
    bool sampled(Index texture) const;

    // Compiles and loads what other rungs need, and keeps the rest. True: the programs may be others now, and with
    // them active_uniforms() and controls(). A program that does not compile stays as it was; why is in
    // ladder_problems().
    bool choose(const Rungs& rungs);
    const Rungs& rungs() const;
    // Of the rungs that were chosen last, without what was found when the runtime was made.
    const Diagnostics& ladder_problems() const;

    // Chooses the rungs of `frame.controls` first. Uniforms that `frame.controls` lacks have the values of controls().
    void draw(const Frame& frame, const Surface& surface);
    // While frames keep their values: compiles the next program for them, or draws with it for the first time, which is
    // when some drivers compile. Frames of these values are drawn by such programs once all are there, and all others
    // by the programs for any values. The last few values are kept. False: there was nothing to do.
    bool specialise(const Frame& frame, const Surface& surface);
    // What the frames since the last call were found to cost: once for each program, and again for other rungs.
    Diagnostics take_costs();
    // What the last frame drew still stands: counted.
    void skip_frame();
    // False after a paced frame whose cube maps still show something older: the same frame again would be another.
    bool settled() const;
    // How far in front of the eye, along its line of sight, a draw of the window (Scene::draws) is where it left
    // `depth` (0 to 1): in the units of the scene. As Frame::view holds the scene.
    double distance(Index draw, double depth, const Frame& frame, const Surface& surface) const;
    // Which draw of the window (Scene::draws) is seen at each pixel, at its middle, of a picture of that size: the last
    // one that changed it. none: the background. Of `region`, the bottom row first; as
    // much of it as lies in the picture. Empty: the context refused what it takes, which is made at the first call.
    std::vector<Index> pick(const Frame& frame, int width, int height, const PixelRect& region);
    // Over what the surface shows: a line around what that draw covers, be it hidden or not.
    void outline(const Frame& frame, const Surface& surface, Index draw, float line = 2);
    // The draws of the window that were found possible: where their meshes lie before any shader moves them, in the eye
    // space of the camera of the last one. Those through other cameras are left out.
    struct Drawn {
        std::vector<DepthBox> boxes;
        Camera camera;
        Index first = none;  // Scene::draws; none: nothing is drawn
    };
    Drawn drawn(const Frame& frame) const;
    const Counters& counters() const;
    // A texture (Scene::textures) as it is on the GPU; nullopt if it is not there.
    struct Held {
        gl::Plane plane;  // of level 0
        int levels = 1;
        gl::Pixels pixels = gl::Pixels::rgba8;
        bool changes = false;  // frames draw into it, or into what it is computed from
    };
    std::optional<Held> texture(Index texture) const;
    // Likewise, noise of 2 or 3 dimensions.
    std::optional<Held> noise(int dimensions) const;
    // Without times of frames: these are for callers that time the draws.
    Explanation explain() const;
    // Links one more program for one of its values alone, which tells explain() what this value switches off. False:
    // there is none left.
    bool find_switched_off();
    // Sliders and check boxes of controls() that are active and yet change nothing that any drawn program computes, as
    // far as the driver's code tells in about that time (src/runtime/resources/program.h).
    std::vector<const Control*> without_effect(double seconds) const;
    // Another number whenever frames are drawn by programs for other values; 0: for any values.
    int form() const;

    struct Impl;

private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace snell
