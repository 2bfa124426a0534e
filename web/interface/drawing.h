// The canvas of the page, and pictures of a scene in it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "src/document/coarseness.h"
#include "src/gl/context.h"
#include "src/gl/present.h"
#include "src/gl/target.h"
#include "src/platform/web/canvas.h"
#include "web/interface/open_scene.h"

namespace snell::web {

// What a picture shows besides the scene and its values.
struct Moment {
    double time = 0;  // in seconds
    int width = 0, height = 0;
    double split = 1;                 // share of the width that shows the chosen rungs; the rest shows the references
    double mouse_x = 0, mouse_y = 0;  // in pixels from the bottom left
};

class Drawing {
public:
    // Returns "" or why the page has no graphics. Also takes the canvas up again after the context was lost: call
    // OpenScene::release before.
    std::string start(const std::string& canvas);
    bool ready() const { return context_ && !context_->lost(); }
    const gl::Caps& caps() const { return caps_; }

    // These must not be called unless ready().
    // `dragged`: the user's hand changed the picture since the last one. It may be coarser, then.
    // `small`: the user keeps it small, because it takes long: with 1 sample per pixel, as foresee() takes.
    void draw(OpenScene& scene, const Moment& moment, bool dragged, bool small);
    // Tells how long the graphics took for it. Returns in how many milliseconds a sharp picture is due if nothing
    // moves; infinity if it was sharp.
    double drew(double milliseconds);
    // Does one piece of work for which there is time when nothing changes. Returns false if nothing is left to do.
    bool settle(OpenScene& scene, const Moment& moment);
    // See snell::foresee; 0: no loop of it is long; negative: a smaller picture would take as long.
    double foresee(OpenScene& scene, const Moment& moment, double enough);
    // RGBA bytes, the top row first; empty, with an error, if the size is beyond the limits.
    std::vector<std::byte> picture(OpenScene& scene, const Moment& moment, int samples, std::string& error);

private:
    std::unique_ptr<CanvasContext> context_;
    gl::Caps caps_;
    gl::Canvas canvas_;
    gl::Target ahead_;  // of pictures that are only timed
    Coarseness coarseness_;
    // Of the last picture.
    const Document* drawn_ = nullptr;
    Rungs rungs_;
    // Of the last look ahead.
    struct {
        const Document* document = nullptr;
        int reading = 0;
        Rungs rungs = {};
        std::vector<double> values = {};
        Foresight known;
        double whole = 0;  // in milliseconds
        double again = 0;  // when another view is looked at again
    } looked_;
};

}  // namespace snell::web
