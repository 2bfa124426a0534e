// The loop: waits for what happens, and does it.
#include "src/app/window/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "parser/text/utf8.h"
#include "src/app/open/exit_status.h"
#include "src/app/open/quality.h"
#include "src/app/open/snapshots.h"
#include "src/app/window/app.h"
#include "src/ui/kit/input.h"

namespace snell {

namespace {

constexpr double look_at_files = .1;    // seconds between looks
constexpr double frame_time = 1. / 60;  // of an animated scene, where the screen sets no pace

void scatter(const std::vector<double>& values, Controls& controls) {
    auto next = values.begin();
    for (Control& control : controls.items)
        for (double& value : control.value)
            if (next != values.end()) value = *next++;
}

FirstRungs first_rungs(const WindowOptions& options) {
    return [options](const Scene& scene, Rungs& rungs, Diagnostics& diagnostics) {
        if (!options.quality.empty()) app::choose_quality(options.scene, options.quality, scene, rungs, diagnostics);
        for (const std::string& ladder : options.ladders) choose_rung(rungs, scene, ladder, diagnostics);
    };
}

void begin_with(Carried& carried, WindowOptions& options) {
    if (carried.scene.empty()) {  // nothing was drawn before
        carried.scene = options.scene;
        carried.recovery.files = {options.scene};
        return;
    }
    if (carried.scene != options.scene) {
        options.quality.clear();  // that was for the other one
        options.ladders.clear();
    }
    options.scene = carried.scene;
    options.size = carried.size;
}

}  // namespace

std::string title_of(const std::string& scene) { return "snell \u2014 " + utf8::printable(scene); }

App::App(const WindowOptions& options, std::unique_ptr<Window> window, Restart& restart, const Carried* carried)
    : options_(options),
      window_(std::move(window)),
      restart_(restart),
      gui_(window_.get()),
      loading_(*window_, gui_, painter_,
               [this](PixelSize pixels) { canvas_.show(0, pixels.height - drawn_.stand.height); }),
      caps_(gl::query_caps()),
      session_(options.scene, caps_, options.access, first_rungs(options), loading_.watcher(size_without_scene()),
               carried ? &carried->recovery : nullptr),
      keeper_(options.scene),
      accuracy_(options.scene, caps_),
      frame_costs_(caps_),
      opener_(settings_file()),
      saver_(caps_, options.access.limits),
      layout_(!options.state_file.empty()),
      hang_(restart.hang_watch(options.timeout)),
      loss_(options.lose_file) {
    view_.axes = true;
    restore(opener_.settings(), memory_);
    if (!carried) return;
    view_ = carried->view;
    edited_ = carried->recovery.edited;
    memory_.clock.time = carried->time;
}

void App::run() {
    report();
    if (readable()) opener_.opened(session_.path());
    window_->show(first_size());
    if (edited_) reload();
    began_ = ticked_ = window_->now();
    last_input_ = began_;
    while (!window_->closing() && !lost_) {
        window_->wait(pause());
        if (options_.exit_after > 0 && window_->now() - began_ > options_.exit_after) break;
        step();
    }
    opener_.look(memory_);
}

Carried App::carried() {
    if (Document* document = session_.document()) scatter(drawn_.stand.values, document->controls);
    std::vector<std::string> files = session_.files();
    Recovery recovery = after_loss(session_.salvage(), std::move(files));
    if (!recovery.kept) recovery.values = session_.by_hand();
    return carry(std::move(recovery));
}

PixelSize App::size_without_scene() {
    if (options_.size) return {options_.size->first, options_.size->second};
    const double scale = window_->content_scale();
    return {static_cast<int>(1280 * scale), static_cast<int>(800 * scale)};
}

PixelSize App::first_size() {
    if (options_.size) return {options_.size->first, options_.size->second};
    const double scale = window_->content_scale();
    const Settings& kept = opener_.settings();
    PixelSize size{1280, 800};
    if (own_size()) {
        const auto [width, height] = session_.document()->scene().window_size;
        const double letters = 16 * memory_.zoom;  // the panel's and the last line's
        size = {width + static_cast<int>(memory_.panel ? memory_.panel_width * letters : 0),
                height + static_cast<int>(1.5 * letters)};
    } else if (kept.width > 0 && kept.height > 0) {
        size = {kept.width, kept.height};
    }
    return {static_cast<int>(std::clamp(size.width * scale, 320.0, 16384.0)),
            static_cast<int>(std::clamp(size.height * scale, 240.0, 16384.0))};
}

bool App::own_size() {
    Document* document = session_.document();
    return document && document->scene().window_size != Scene{}.window_size;
}

bool App::moving() {
    Document* document = session_.document();
    return document &&
           ((document->runtime->animated() && !held() && !memory_.clock.paused) || !document->runtime->settled());
}

double App::scene_time() {
    const double now = window_->now();
    ui::Clock& clock = memory_.clock;
    if (!held() && !clock.paused && !saver_.busy()) clock.time += (now - ticked_) * clock.speed;
    ticked_ = now;
    return clock.time;
}

Carried App::carry(Recovery recovery) {
    const PixelSize size = window_->size();
    return {session_.path(),
            std::move(recovery),
            counters_.frames > 0 ? drawn_.stand.view : view_,
            {size.width, size.height},
            memory_.clock.time};
}

void App::keep_by_hand() {
    const Document* document = session_.document();
    if (!document || kept_frame_ == counters_.frames) return;
    gather(document->controls, next_.stand.values);
    if (next_.stand.values != drawn_.stand.values || document->controls.rungs != drawn_.rungs) return;
    kept_frame_ = counters_.frames;
    restart_.keep(carry({nullptr, session_.files(), changed_text(*document), {}}));
}

void App::reload() {
    restart_.trying();
    session_.reload();
    report();
    unsettled_ = 3;  // messages need a frame to be measured in
}

double App::pause() {
    if (unsettled_ > 0 || saver_.busy() || ((accuracy_.busy() || frame_costs_.busy()) && visible())) return 0;
    const double now = window_->now();
    double until = next_look_;
    if (moving() && visible()) until = std::min(until, last_picture_ + frame_time);
    if (options_.exit_after > 0) until = std::min(until, began_ + options_.exit_after + 1e-3);
    return std::max(0.0, until - now);
}

bool App::visible() {
    const PixelSize pixels = window_->framebuffer();
    return pixels.width > 0 && pixels.height > 0;
}

void App::step() {
    const double now = window_->now();
    bool woken = false, repaint = false;
    if (saver_.busy()) {
        unsettled_ = std::max(unsettled_, 1);
        hang_.begin("drawing a part");
    }
    saver_.step(session_.document(), session_.revision(), memory_);
    hang_.rest();
    if (now >= next_look_ && !saver_.busy()) {
        next_look_ = now + look_at_files;
        keep_by_hand();
        if (session_.saved()) {
            reload();
            woken = true;
        }
        woken |= opener_.look(memory_);
    }
    window_->take_events(events_);
    for (const Event& event : events_)
        repaint |= event.kind == Event::Kind::refresh || event.kind == Event::Kind::resize;
    if (const std::vector<std::string> dropped = window_->take_dropped(); !dropped.empty())
        show_scene(opener_.serve_dropped(dropped, memory_));
    woken |= !events_.empty() || unsettled_ > 0 || (moving() && now >= last_picture_ + frame_time);
    if (!visible()) {
        unsettled_ = 0;  // all is drawn again when the window comes back: that is an event
        return;
    }
    if (!woken && !refined()) return;
    // Dear ImGui answers some input one frame late: go on until two frames are equal.
    if (!events_.empty()) unsettled_ = 3;
    std::span<const Event> rest(events_);
    do {
        const std::size_t count = ui::batch(rest);
        interface_frame(rest.first(count));
        rest = rest.subspan(count);
    } while (!rest.empty());
    unsettled_ = std::max(0, unsettled_ - 1);
    show(repaint);
}

bool App::refined() {
    if (!accuracy_.busy() && !frame_costs_.busy()) return false;
    Document* document = session_.document();
    hang_.begin("measuring");
    const bool refined =
        (document && frame_costs_.step(*document, drawn_.stand, canvas_.samples())) || accuracy_.step();
    hang_.rest();
    if (!refined) return false;
    unsettled_ = std::max(unsettled_, 1);
    return true;
}

int run_window(const WindowOptions& options) {
    Restart restart(options.after);
    WindowOptions now = options;
    std::optional<Carried> carried = restart.carried();
    if (carried) begin_with(*carried, now);
    std::error_code none;
    if (!carried && !std::filesystem::is_regular_file(now.scene, none)) {
        fmt::print(stderr, "snell: error: cannot read '{}'\n", options.scene);
        return app::exit_input;
    }
    while (true) {
        std::string error;
        std::unique_ptr<Window> window = Window::make({.title = title_of(now.scene)}, error);
        if (!window) {
            fmt::print(stderr, "snell: error: no window: {}\n  help: 'snell render' draws without a display\n", error);
            return app::exit_graphics;
        }
        App app(now, std::move(window), restart, carried ? &*carried : nullptr);
        app.run();
        if (!app.lost()) return app.readable() ? app::exit_fine : app::exit_input;
        const bool again = carried.has_value();
        carried = app.carried();
        fmt::print(stderr, "snell: {}", render(carried->recovery.problem, {}));
        // Not even what was drawn well before: there is nothing to go on with.
        if (again && !carried->recovery.kept) return app::exit_lost;
        begin_with(*carried, now);
    }
}

}  // namespace snell
