#include "web/interface/drawing.h"

#include <emscripten.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "src/app/picture/tiles.h"
#include "src/gl/context.h"

namespace snell::web {

namespace {

View with_mouse(View view, const Moment& moment) {
    view.mouse_x = moment.mouse_x;
    view.mouse_y = moment.mouse_y;
    return view;
}

double now() { return emscripten_get_now() / 1e3; }

// As large as a coarse picture is.
Moment in_grain(Moment moment, const Grain& grain) {
    moment.width = grain.part_of(moment.width);
    moment.height = grain.part_of(moment.height);
    moment.mouse_x /= grain.divide;
    moment.mouse_y /= grain.divide;
    return moment;
}

// Draws the chosen rungs left of the split, and the references right of it. `enlarged` is that of a paced frame on the
// screen; 0: it is another one.
void draw_both(OpenScene& scene, const gl::Caps& caps, const Moment& moment, int enlarged, Surface surface) {
    Document& shown = *scene.document();
    const View view = with_mouse(scene.view, moment);
    Document* reference = moment.split < 1 ? scene.reference(caps) : nullptr;
    const int left =
        reference ? static_cast<int>(std::lround(std::max(moment.split, 0.) * moment.width)) : moment.width;
    const auto draw = [&](Document& document, int begin, int end) {
        if (begin >= end) return;
        if (reference) surface.region = PixelRect{begin, 0, end - begin, moment.height};
        document.runtime->draw({.time = moment.time,
                                .view = view,
                                .controls = document.controls,
                                .paced = enlarged > 0,
                                .enlarged = std::max(enlarged, 1)},
                               surface);
    };
    draw(shown, 0, left);
    if (reference) draw(*reference, left, moment.width);
}

}  // namespace

std::string Drawing::start(const std::string& canvas) {
    canvas_ = {};
    ahead_ = {};
    context_.reset();
    std::string error;
    context_ = CanvasContext::make(canvas, error);
    if (!context_) return error;
    caps_ = gl::query_caps();
    gl::take_errors();  // of objects that went with a lost context
    return "";
}

void Drawing::draw(OpenScene& scene, const Moment& moment, bool dragged, bool small) {
    const Document& document = *scene.document();
    if (std::exchange(drawn_, &document) != &document || rungs_ != document.controls.rungs) coarseness_ = {};
    rungs_ = document.controls.rungs;
    const Grain& grain = grains[static_cast<std::size_t>(coarseness_.next(dragged, dragged, now()))];
    const Moment part = in_grain(moment, grain);
    const int samples = small ? 1 : grain.samples;
    if (!canvas_.resize(part.width, part.height, samples, document.runtime->display_pixels())) return;
    context_->resize(moment.width, moment.height);
    draw_both(scene, caps_, part, grain.divide, {canvas_.framebuffer(), part.width, part.height});
    canvas_.resolve();
    canvas_.show(0, 0, moment.width, moment.height);
}

double Drawing::drew(double milliseconds) {
    coarseness_.drew(milliseconds);
    return std::max(0., coarseness_.due() - now()) * 1e3;
}

bool Drawing::settle(OpenScene& scene, const Moment& moment) {
    Runtime& runtime = *scene.document()->runtime;
    if (!runtime.settled()) {  // faces of a cube map are behind
        draw(scene, moment, false, false);
        return true;
    }
    if (canvas_.framebuffer() == 0) return false;
    const View view = with_mouse(scene.view, moment);
    return runtime.specialise(
        {.time = moment.time, .view = view, .controls = scene.document()->controls, .paced = true},
        {canvas_.framebuffer(), moment.width, moment.height});
}

double Drawing::foresee(OpenScene& scene, const Moment& moment, double enough) {
    constexpr double surely = 8, spent = .02;  // times less than enough; a share of the time, while only the view moves
    Document& shown = *scene.document();
    const Document* reference = moment.split < 1 ? scene.reference(caps_) : nullptr;
    const auto length = [](const Document* one) { return one ? one->runtime->long_loops(one->controls) : 0; };
    const double rounds = std::min<double>(std::max(length(&shown), length(reference)), glsl::most_rounds);
    if (rounds == 0) return 0;
    if (looked_.document != &shown || looked_.reading != scene.readings() || looked_.rungs != shown.controls.rungs)
        looked_ = {&shown, scene.readings(), shown.controls.rungs};
    std::vector<double> values = values_of(shown.controls);
    const double begun = now();
    if (values == looked_.values && looked_.whole * surely < enough && begun < looked_.again) return looked_.whole;
    looked_.values = std::move(values);
    const gl::Pixels pixels = shown.runtime->display_pixels();
    if (ahead_.pixels != pixels) ahead_ = {};
    bool pixels_tell = false, busy = true;
    const auto timed = [&](const Trial& trial) {
        pixels_tell = pixels_tell || trial.width > 1;
        Moment small = moment;
        small.width = trial.width;
        small.height = trial.height;
        Controls all = shown.controls;
        if (trial.rounds < rounds) shown.runtime->shorten_loops(shown.controls, trial.rounds);
        if (ahead_.width != trial.width || ahead_.height != trial.height)
            ahead_ = gl::make_target(trial.width, trial.height, 1, pixels);
        const auto finish = [&] { gl::read_rgba8(ahead_.framebuffer.get(), 1, 1, 1, pixels); };
        if (std::exchange(busy, false)) finish();  // with the picture before, which is not this one's time
        const double from = now();
        draw_both(scene, caps_, small, 0, {ahead_.framebuffer.get(), trial.width, trial.height});
        finish();
        const double milliseconds = (now() - from) * 1e3;
        shown.controls = std::move(all);
        return milliseconds;
    };
    looked_.whole = snell::foresee(moment.width, moment.height, rounds, enough, looked_.known, timed);
    looked_.again = now() + (now() - begun) * (1 / spent - 1);
    const bool point_tells = std::isfinite(looked_.known.point) && looked_.known.point > enough;
    return pixels_tell && !point_tells ? looked_.whole : -looked_.whole;
}

std::vector<std::byte> Drawing::picture(OpenScene& scene, const Moment& moment, int samples, std::string& error) {
    const app::PictureSize size{moment.width, moment.height, samples};
    const app::Tiling tiling = app::tile(size, scene.document()->files->limits(), caps_);
    error = tiling.error;
    if (!error.empty()) return {};
    const gl::Pixels pixels = scene.document()->runtime->display_pixels();
    const gl::Target target = gl::make_target(tiling.width, tiling.height, samples, pixels);
    if (!target.framebuffer) error = "the graphics driver has not enough memory for a picture of this size";
    if (!error.empty()) return {};
    const auto row = static_cast<std::size_t>(size.width) * 4;
    std::vector<std::byte> picture(row * static_cast<std::size_t>(size.height), std::byte{255});
    for (const PixelRect& part : app::parts_of(size, tiling)) {
        Surface surface{target.framebuffer.get(), size.width, size.height};
        if (!tiling.whole(size)) surface.part = part;
        draw_both(scene, caps_, moment, 0, surface);
        const std::vector<std::byte> read =
            gl::read_rgba8(target.framebuffer.get(), part.width, part.height, target.samples, pixels);
        for (int y = 0; y < part.height; ++y) {
            std::byte* to =
                picture.data() + static_cast<std::size_t>(size.height - part.bottom - part.height + y) * row;
            std::memcpy(to + static_cast<std::size_t>(part.left) * 4,
                        read.data() + static_cast<std::size_t>(y * part.width) * 4,
                        static_cast<std::size_t>(part.width) * 4);
        }
    }
    for (std::size_t i = 3; i < picture.size(); i += 4) picture[i] = std::byte{255};
    return picture;
}

}  // namespace snell::web
