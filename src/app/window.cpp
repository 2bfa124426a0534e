#include "src/app/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "parser/utf8.h"
#include "src/app/accuracy_view.h"
#include "src/app/commands.h"
#include "src/app/frame_costs.h"
#include "src/app/keeper.h"
#include "src/app/loading_screen.h"
#include "src/app/loss.h"
#include "src/app/opener.h"
#include "src/app/picking.h"
#include "src/app/picture_saver.h"
#include "src/app/pixel_view.h"
#include "src/app/quality.h"
#include "src/app/recovery.h"
#include "src/app/session.h"
#include "src/app/window_state.h"
#include "src/gl/present.h"
#include "src/ui/gui.h"
#include "src/ui/input.h"
#include "src/ui/shell.h"

namespace snell {

namespace {

constexpr double look_at_files = .1;    // seconds between looks
constexpr double frame_time = 1. / 60;  // of an animated scene, where the screen sets no pace
constexpr int samples = 4;

// All that the last picture of the scene was drawn from: while it stays, so does the picture.
struct Drawn {
    std::uint64_t revision = 0;
    Stand stand;
    Rungs rungs;
    Index object = none;  // that is outlined

    bool operator==(const Drawn&) const = default;
};

void gather(const Controls& controls, std::vector<double>& values) {
    values.clear();
    for (const Control& control : controls.items)
        values.insert(values.end(), control.value.begin(), control.value.end());
}

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

std::string title_of(const std::string& scene) { return "snell \u2014 " + utf8::printable(scene); }

class App {
public:
    App(const WindowOptions& options, std::unique_ptr<Window> window, const Carried* carried)
        : options_(options),
          window_(std::move(window)),
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
          hang_(hang_watch(options.timeout)),
          loss_(options.lose_file) {
        view_.axes = true;
        if (carried) view_ = carried->view;
        restore(opener_.settings(), memory_);
    }

    void run() {
        report();
        if (readable()) opener_.opened(session_.path());
        window_->show(first_size());
        began_ = ticked_ = window_->now();
        last_input_ = began_;
        while (!window_->closing() && !lost_) {
            window_->wait(pause());
            if (options_.exit_after > 0 && window_->now() - began_ > options_.exit_after) break;
            step();
        }
        opener_.look(memory_);
    }

    bool readable() { return session_.document() != nullptr; }

    // The driver took the context away. carried() is for another window, once this one's run() is over.
    bool lost() const { return lost_; }
    Carried carried() {
        const PixelSize size = window_->size();
        if (Document* document = session_.document()) scatter(drawn_.stand.values, document->controls);
        std::vector<std::string> files = session_.files();
        return {session_.path(),
                after_loss(session_.salvage(), std::move(files)),
                counters_.frames > 0 ? drawn_.stand.view : view_,
                {size.width, size.height}};
    }

private:
    PixelSize size_without_scene() {
        if (options_.size) return {options_.size->first, options_.size->second};
        const double scale = window_->content_scale();
        return {static_cast<int>(1280 * scale), static_cast<int>(800 * scale)};
    }

    // The drawing area is the scene's WindowSize; who asked for none gets a comfortable one.
    PixelSize first_size() {
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

    // The scene says how large it is.
    bool own_size() {
        Document* document = session_.document();
        return document && document->scene().window_size != Scene{}.window_size;
    }

    bool held() const { return memory_.accuracy.open && memory_.accuracy.hold_time; }

    // Another frame of the same would be another picture.
    bool moving() {
        Document* document = session_.document();
        return document &&
               ((document->runtime->animated() && !held() && !memory_.clock.paused) || !document->runtime->settled());
    }

    // Seconds of the scene's own time, which the user may hold and set.
    double scene_time() {
        const double now = window_->now();
        ui::Clock& clock = memory_.clock;
        if (!held() && !clock.paused && !saver_.busy()) clock.time += (now - ticked_) * clock.speed;
        ticked_ = now;
        return clock.time;
    }

    // How long nothing will happen without input.
    double pause() {
        if (unsettled_ > 0 || saver_.busy() || ((accuracy_.busy() || frame_costs_.busy()) && visible())) return 0;
        const double now = window_->now();
        double until = next_look_;
        if (moving() && visible()) until = std::min(until, last_picture_ + frame_time);
        if (options_.exit_after > 0) until = std::min(until, began_ + options_.exit_after + 1e-3);
        return std::max(0.0, until - now);
    }

    bool visible() {
        const PixelSize pixels = window_->framebuffer();
        return pixels.width > 0 && pixels.height > 0;
    }

    void step() {
        const double now = window_->now();
        bool woken = false, repaint = false;
        if (saver_.busy()) unsettled_ = std::max(unsettled_, 1);
        saver_.step(session_.document(), session_.revision(), memory_);
        if (now >= next_look_ && !saver_.busy()) {
            next_look_ = now + look_at_files;
            if (session_.reload_if_saved()) {
                report();
                unsettled_ = 3;  // messages need a frame to be measured in
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

    // A step toward a better reference, while there is nothing else to do.
    bool refined() {
        Document* document = session_.document();
        const bool measured = document && frame_costs_.step(*document, drawn_.stand, canvas_.samples());
        if (!measured && !accuracy_.step()) return false;
        unsettled_ = std::max(unsettled_, 1);
        return true;
    }

    // The panels see the input and change controls and view; nothing is drawn yet.
    void interface_frame(std::span<const Event> events) {
        const double now = window_->now();
        const PixelSize size = window_->size(), pixels = window_->framebuffer();
        const float density = size.width > 0 ? static_cast<float>(pixels.width) / static_cast<float>(size.width) : 1.0F;
        const ui::Screen screen{static_cast<float>(size.width), static_cast<float>(size.height), density,
                                window_->content_scale() / density * memory_.zoom, memory_.theme};
        if (gui_.input(screen, now - last_input_, events)) painter_.upload_fonts();
        last_input_ = now;
        gui_.begin();
        Controls no_controls;
        Document* document = session_.document();
        if (document) picking_.follow(*document, session_.revision(), view_, memory_.hold);
        const ui::Requests requests =
            ui::shell(facts(), document ? document->controls : no_controls, view_, memory_, gui_.fonts(), layout_);
        interface_ = gui_.end();
        window_->set_cursor(gui_.cursor());
        for (const Event& event : events)
            if (event.down) memory_.notice.clear();
        if (document) {
            const Picture shown{drawn_.stand.width, drawn_.stand.height, canvas_.samples(), drawn_.stand.time, view_};
            keeper_.serve(requests, *document, shown, *window_, memory_.notice);
            saver_.serve(requests, *document, shown, *window_, memory_);
        }
        if (document) picking_.serve(requests, *document, drawn_.stand, density, memory_.hold);
        show_scene(opener_.serve(requests, session_.path(), memory_));
        if (session_.follow_rungs()) {
            report();
            unsettled_ = 3;
        }
        if (requests.measure) accuracy_.measure(memory_.accuracy);
        if (requests.measure_frame) frame_costs_.measure();
        if (requests.reload) {
            session_.reload();
            report();
            unsettled_ = 3;
        }
    }

    ui::Facts facts() {
        ui::Facts facts;
        if (named_ != session_.path()) {
            named_ = session_.path();
            file_ = utf8::printable(std::filesystem::path(named_).filename().string());
        }
        facts.file = file_;
        if (Document* document = session_.document()) {
            facts.scene = &document->scene();
            facts.animated = document->runtime->animated();
            facts.mouse = document->runtime->uses_mouse();
            linked_.clear();
            // A program without any uniform looks like one that failed; only then would there be an error.
            const bool whole = !document->diagnostics.has_errors();
            for (const auto& uniforms : document->runtime->active_uniforms())
                linked_.push_back(whole || !uniforms.empty());
            facts.linked = linked_;
        }
        facts.problems = session_.problems();
        facts.stale = session_.stale();
        facts.revision = session_.revision();
        facts.time = counters_.time;
        facts.frame_ms = counters_.frame_ms;
        facts.samples = canvas_.samples();
        facts.renderer = caps_.renderer;
        if (Document* document = session_.document(); document && memory_.costs) {
            if (explained_ != session_.revision()) explanation_ = document->runtime->explain();
            explained_ = session_.revision();
            frame_costs_.fill(explanation_);
            facts.explanation = &explanation_;
            facts.sources = &document->sources;
        }
        keeper_.tell(facts, session_.document());
        picking_.tell(facts, session_.document(), memory_.hold);
        opener_.tell(facts, session_.path(), session_.files());
        tell_measured(facts);
        return facts;
    }

    // Another scene, as if the window had been opened on it; what its looks are stays.
    void show_scene(const std::optional<std::string>& path) {
        if (!path) return;
        if (std::string wrong = session_.open(*path); !wrong.empty()) {
            memory_.notice = utf8::printable(wrong);
            return;
        }
        ui::Memory fresh;
        carry_looks(memory_, fresh);
        memory_ = std::move(fresh);
        const bool axes = view_.axes;
        view_ = {};
        view_.axes = axes;
        keeper_ = Keeper(*path);
        accuracy_ = AccuracyView(*path, caps_);
        explained_ = 0;
        opener_.opened(*path);
        window_->set_title(title_of(*path));
        report();
        unsettled_ = 3;
    }

    void tell_measured(ui::Facts& facts) {
        facts.accuracy = accuracy_.facts(memory_.accuracy);
        facts.frame_cost = frame_costs_.facts(session_.document());
        facts.pixels = pixels_.facts();
    }

    // Draws the scene if its picture would be another, and presents if anything is.
    void show(bool repaint) {
        const PixelSize pixels = window_->framebuffer();
        remember_size();
        const bool drew = draw_scene(pixels);
        if (lost_) return;
        if (Document* document = session_.document())
            accuracy_.follow(*document, session_.stale(), drawn_.stand, memory_.accuracy);
        const bool told = look_at_pixels();
        const std::uint64_t beside = accuracy_.revision(memory_.accuracy);
        if (drew || told || repaint || interface_ != presented_ || beside != presented_beside_) {
            present(pixels);
            presented_ = interface_;
            presented_beside_ = beside;
            ++counters_.presents;
        }
        if (options_.state_file.empty()) return;
        ui::Facts measured;
        tell_measured(measured);
        write_window_state(options_.state_file, counters_, session_, view_, layout_, memory_, measured, pixels);
    }

    // True: there is something else to show.
    bool look_at_pixels() {
        Document* document = session_.document();
        const Stand& stand = drawn_.stand;
        if (!document || memory_.scene.width <= 0) return false;
        const float density = static_cast<float>(stand.width) / memory_.scene.width;
        if (!pixels_.follow(*document, stand, counters_.frames, memory_.pixels, density)) return false;
        unsettled_ = std::max(unsettled_, 1);  // the panels tell of it
        return true;
    }

    // That the user gave it.
    void remember_size() {
        if (options_.size || own_size()) return;
        const PixelSize size = window_->size();
        const double scale = window_->content_scale();
        opener_.resized(static_cast<int>(std::lround(size.width / scale)),
                        static_cast<int>(std::lround(size.height / scale)));
    }

    bool draw_scene(PixelSize pixels) {
        Document* document = session_.document();
        if (!document) return false;
        const float density = static_cast<float>(pixels.width) / static_cast<float>(std::max(1, window_->size().width));
        next_.revision = session_.stale() ? drawn_.revision : session_.revision();
        Stand& stand = next_.stand;
        stand.width = std::max(1, static_cast<int>(std::lround(memory_.scene.width * density)));
        stand.height = std::max(1, static_cast<int>(std::lround(memory_.scene.height * density)));
        const double time = scene_time();
        stand.time = document->runtime->animated() ? time : 0;
        stand.view = view_;
        gather(document->controls, stand.values);
        next_.rungs = document->controls.rungs;
        next_.object = memory_.hold.object;
        if (next_ == drawn_ && document->runtime->settled()) {
            document->runtime->skip_frame();
            return false;
        }
        if (!canvas_.resize(stand.width, stand.height, samples)) return false;
        const double start = window_->now();
        frame_costs_.open(memory_.frame_cost);
        Frame frame{stand.time, view_, document->controls, true};
        frame.after = frame_costs_.begin(next_.revision);
        const Surface surface{canvas_.framebuffer(), stand.width, stand.height};
        hang_.begin("drawing a frame");
        document->runtime->draw(frame, surface);
        if (next_.object != none) document->runtime->outline(frame, surface, next_.object, std::ceil(2 * density));
        canvas_.resolve();
        gl::finish();
        hang_.rest();
        lost_ = loss_.lost();
        if (lost_) return false;
        session_.drawn_well();
        frame_costs_.end();
        last_picture_ = start;
        counters_.frame_ms = (window_->now() - start) * 1e3;
        counters_.time = stand.time;
        ++counters_.frames;
        std::swap(drawn_, next_);
        unsettled_ = std::max(unsettled_, 1);  // the panels show what it cost
        return true;
    }

    void present(PixelSize pixels) {
        const ImVec4 around = ui::palette().surround;
        gl::clear_window(pixels.width, pixels.height, around.x, around.y, around.z);
        if (session_.document()) {
            canvas_.show(0, pixels.height - drawn_.stand.height);
            accuracy_.show(pixels.height - drawn_.stand.height, memory_.accuracy);
            pixels_.show(pixels.height - drawn_.stand.height);
        }
        painter_.paint();
        window_->present();
    }

    void report() {
        std::string text = session_.problems_text();
        if (text != reported_) fmt::print(stderr, "{}", text);
        reported_ = std::move(text);
    }

    WindowOptions options_;
    std::unique_ptr<Window> window_;
    ui::Gui gui_;
    ui::Painter painter_;
    gl::Canvas canvas_;
    Drawn drawn_, next_;
    LoadingScreen loading_;
    gl::Caps caps_;
    Session session_;
    Keeper keeper_;
    AccuracyView accuracy_;
    FrameCosts frame_costs_;
    PixelView pixels_;
    Picking picking_;
    Opener opener_;
    PictureSaver saver_;
    View view_;
    ui::Memory memory_;
    ui::Layout layout_;
    std::vector<Event> events_;
    std::string file_, named_, reported_;  // the file's name, of which path; what was printed of its problems
    std::vector<char> linked_;
    WindowCounters counters_;
    Explanation explanation_;
    std::uint64_t explained_ = 0;  // the revision that it is of
    std::uint64_t interface_ = 0, presented_ = 0, presented_beside_ = 0;
    app::Deadline hang_;
    app::LossWatch loss_;
    bool lost_ = false;
    int unsettled_ = 3;
    double began_ = 0, ticked_ = 0, last_input_ = 0, last_picture_ = 0, next_look_ = 0;
};

}  // namespace

int run_window(const WindowOptions& options) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(options.scene, none)) {
        fmt::print(stderr, "snell: error: can't read '{}'\n", options.scene);
        return app::exit_input;
    }
    WindowOptions now = options;
    std::optional<Carried> carried;
    if (options.after_hang)
        carried = Carried{options.scene, after_hang(options.scene), View{}, options.size.value_or(std::pair(0, 0))};
    while (true) {
        std::string error;
        std::unique_ptr<Window> window = Window::make({.title = title_of(now.scene)}, error);
        if (!window) {
            fmt::print(stderr, "snell: error: no window: {}\n  help: 'snell render' draws without a display\n", error);
            return app::exit_graphics;
        }
        App app(now, std::move(window), carried ? &*carried : nullptr);
        app.run();
        if (!app.lost()) return app.readable() ? app::exit_fine : app::exit_input;
        const bool again = carried.has_value();
        carried = app.carried();
        fmt::print(stderr, "snell: {}", carried->recovery.problem);
        // Not even what was drawn well before: there is nothing to go on with.
        if (again && !carried->recovery.kept) return app::exit_lost;
        now.scene = carried->scene;
        now.size = carried->size;
    }
}

}  // namespace snell
