#include "src/app/window/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "parser/text/words.h"
#include "src/app/desktop/folder.h"
#include "src/app/desktop/settings.h"
#include "src/app/desktop/watch.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/window/display.h"
#include "src/app/window/interface.h"
#include "src/app/window/measuring.h"
#include "src/app/window/survive/recovery.h"
#include "src/app/window/window_state.h"
#include "src/app/window/workspace.h"
#include "src/content/files.h"
#include "src/ui/kit/input.h"

namespace snell {

namespace {

// The window's loop: it waits for events, hands them from part to part, and shows what changed.
class App {
public:
    App(const WindowOptions& options, std::unique_ptr<Window> window, Restart& restart, const Carried* carried,
        Past& past);
    // Returns when the window is closed or the context is lost. `edited`: a file was saved before the window was open.
    void run(bool edited);
    // False if the scene could not be read; a window without a scene is fine.
    bool readable() { return workspace_.document() != nullptr || workspace_.session().path().empty(); }
    // True if the driver reset the context. Once run() has returned, carried() has the state for a new window.
    bool lost() const { return display_.lost(); }
    Carried carried();

private:
    // Shows the progress of loading. A window that is still hidden is shown first.
    void loading(const LoadProgress& progress);
    // The size of the drawing area: the scene's WindowSize, or a comfortable default if it has none.
    PixelSize first_size();
    // True if the scene sets its size.
    bool own_size();
    // Stores the window's size as the one that the user chose, unless it is still that of a scene before.
    void remember_size();
    // The state of the picture that was drawn last.
    Carried carry(Recovery recovery);
    // Stores the state for a window that may have to replace this one: the last state that was drawn without problems,
    // because the current one may be their cause.
    void keep_by_hand();
    // The same before the first picture of a scene, which may end this window as well.
    void keep_first();

    // The document whose picture the window shows: the scene's, or that of a found rung. Null: there is no scene.
    Document* shown_document();
    // True if the next frame would be another picture even without input.
    bool moving();
    // When more of what is shown can be drawn without input, by the clock of the window: a sharp picture or a strip of
    // something; infinite if all is there.
    double due() const;
    // True if time or values change by themselves.
    bool running();
    bool visible();
    // Seconds to sleep if there is no input.
    double pause();
    // For tests, with a state file: takes the question from FILE.ask. Returns true if it is a new one.
    bool listen();
    // Returns true, and has the state name the question as answered, if all input and all saved files from before it
    // are handled and seen.
    bool answer();
    // Draws at least that many more frames, even without input.
    void settle(int frames);
    void step();
    // Looks for saved files and ended editors. Returns true if there is something new to show.
    bool look();
    // Draws the next part of a picture that is being saved.
    void save();
    // Looks for NaN, if the picture has not changed for a while. Returns true if there is something new to show.
    bool look_for_nan();
    // Compiles programs for the values as they are, if nothing was touched for a while. Returns true if there was
    // something to do.
    bool specialise();
    // Draws a picture to measure it, if nothing else is to be done. Returns true if there is something new to show.
    bool measure();
    // Keeps a picture of the open scene for the file browser.
    void keep_picture();
    void reload();
    // Shows another scene, as if the window had been opened with it; the appearance of the window stays.
    void show_scene(const std::optional<std::string>& path);
    // Passes the input to the panels, which change controls and view, and does what they ask for. Draws nothing yet.
    void interface_frame(std::span<const Event> events);
    ui::Facts facts();
    void serve(const ui::Requests& requests);
    // Draws the scene if its picture would change, and presents the window if anything in it changed.
    void show(bool repaint);
    // True if no picture of the scene was begun yet. Nobody knows how long it takes: the panels are shown before, and
    // what is waited for.
    bool first_picture();
    void show_before_first(bool repaint);
    // Draws the scene if its picture would change. Where that takes long and nothing shows that it is at work, the
    // status line says so before.
    bool draw_told();
    // What the window shows: the last picture, what is measured over it, and the panels.
    void show_all();
    // Draws the panels over what the window shows, and presents it.
    void paint();
    bool draw_scene();
    // Says that the sharp picture took too long.
    void give_up(const Document& shown);
    void write_state();

    WindowOptions options_;
    std::unique_ptr<Window> window_;
    Restart& restart_;
    Interface interface_;
    Display display_;
    gl::Caps caps_;
    Patience patience_;
    bool shown_ = false;     // whether the window was shown
    PixelSize scenes_size_;  // of the window as the scene that it began with has set it
    Workspace workspace_;
    Measuring measuring_;
    Picking picking_;
    app::Deadline hang_;
    std::vector<Event> events_;
    std::uint64_t kept_frame_ = 0;              // the frame whose state Restart has
    std::uint64_t opened_at_ = 0;               // the number of frames before the scene was opened
    std::array<std::uint64_t, 2> presented_{};  // the panels, and what lies over the picture, as last presented
    int unsettled_ = 3;                         // number of frames to draw even without input
    // Number of frames to present even if nothing changed: some drivers learn a new size with the next picture.
    int repaints_ = 3;
    double began_ = 0, next_look_ = 0;  // by the clock of the window
    double touched_ = 0;                // when there was input last
    std::string begun_;                 // the scene of which a picture was begun
    std::string pictured_;              // the scene of which a picture was kept
    std::string question_, answered_;   // see listen()
    int steps_ = 0;                     // since the question, without rest
    bool tells_ = false;                // the picture that is drawn next takes long, and the status line says so
    bool specialised_ = false;          // nothing more can be compiled for the values as they are
};

constexpr double look_at_files = .1;    // seconds between looks
constexpr double until_placed = 1;      // seconds in which screens give a new window its size
constexpr double frame_time = 1. / 60;  // seconds; for animated scenes if the screen sets no pace
constexpr double until_still = .5;      // seconds without input, after which programs are compiled for the values
constexpr int until_equal = 3;          // frames: Dear ImGui answers some input, and measures messages, a frame late
constexpr int until_seen = 10;  // frames: of a window that is never at rest, until it surely shows what was done
constexpr PixelSize comfortable{1280, 800};

PixelSize scaled(PixelSize size, double scale) {
    return {static_cast<int>(std::clamp(size.width * scale, 320.0, 16384.0)),
            static_cast<int>(std::clamp(size.height * scale, 240.0, 16384.0))};
}

App::App(const WindowOptions& options, std::unique_ptr<Window> window, Restart& restart, const Carried* carried,
         Past& past)
    : options_(options),
      window_(std::move(window)),
      restart_(restart),
      interface_(*window_, !options.state_file.empty()),
      display_(*window_, app::LossWatch(options.lose_file), options.timeout),
      caps_(gl::query_caps()),
      workspace_(
          options, caps_, [this](const LoadProgress& progress) { loading(progress); },
          carried ? &carried->recovery : nullptr, past),
      measuring_(options.scene, caps_),
      hang_(restart.hang_watch(options.timeout)) {
    restore(workspace_.settings(), options.scene, interface_.memory());
    interface_.memory().failures.scene = whole_path(options.scene);
    if (!carried) {
        workspace_.begin(interface_.view(), interface_.memory());
        return;
    }
    interface_.view() = carried->view;
    workspace_.continue_with(carried->view, interface_.memory());
    ui::Memory& memory = interface_.memory();
    memory.clock.time = carried->time;
    memory.failures = carried->failures;
    memory.failures.scene = whole_path(options.scene);
    memory.revision = workspace_.session().revision();  // nothing was read again that would answer them
}

void App::run(bool edited) {
    workspace_.report();
    workspace_.remember_scene();
    window_->show(first_size());
    shown_ = true;
    if (workspace_.session().path().empty() && !edited) workspace_.browse(options_.scene, interface_.memory());
    if (edited) reload();
    interface_.start();
    began_ = window_->now();
    while (!window_->closing() && !lost()) {
        window_->wait(listen() ? 0 : pause());
        if (options_.exit_after > 0 && window_->now() - began_ > options_.exit_after) break;
        step();
    }
    keep_picture();
    workspace_.finish(interface_.view(), lost());
    workspace_.look(interface_.view(), interface_.memory());
}

// Events wait for the frame after loading, because there is nothing yet that they could change.
void App::loading(const LoadProgress& progress) {
    if (!patience_.due(progress) || Patience::ends(progress)) return;
    if (!std::exchange(shown_, true))
        window_->show(options_.size ? PixelSize{options_.size->first, options_.size->second}
                                    : scaled(comfortable, window_->content_scale()));
    window_->wait(0);
    if (!visible()) return;
    interface_.loading(progress);
    display_.show(window_->framebuffer(), std::nullopt);
    interface_.paint();
    window_->present();
}

PixelSize App::first_size() {
    if (options_.size) return {options_.size->first, options_.size->second};
    const ui::Memory& memory = interface_.memory();
    const Settings& kept = workspace_.settings();
    PixelSize size = comfortable;
    if (own_size()) {
        const auto [width, height] = workspace_.document()->scene().window_size;
        const double letters = 16 * memory.zoom;  // the height of text, in the panel and in the status line
        size = {width + static_cast<int>(memory.panel ? memory.panel_width * letters : 0),
                height + static_cast<int>(1.5 * letters)};
    } else if (kept.width > 0 && kept.height > 0) {
        size = {kept.width, kept.height};
    }
    return scaled(size, window_->content_scale());
}

bool App::own_size() {
    const Document* document = workspace_.document();
    return document && document->scene().window_size != Scene{}.window_size;
}

void App::remember_size() {
    if (options_.size || window_->full_screen()) return;
    const PixelSize size = window_->size();
    if (own_size() && window_->now() < began_ + until_placed) scenes_size_ = size;
    if (size == scenes_size_) return;
    const double scale = window_->content_scale();
    workspace_.resized(static_cast<int>(std::lround(size.width / scale)),
                       static_cast<int>(std::lround(size.height / scale)));
}

Carried App::carried() {
    Session& session = workspace_.session();
    if (Document* document = session.document()) set_values(document->controls, display_.drawn().stand.values);
    std::vector<std::string> files = session.files();
    Recovery recovery = after_loss(session.salvage(), std::move(files));
    if (!recovery.kept) recovery.values = session.by_hand();
    return carry(std::move(recovery));
}

Carried App::carry(Recovery recovery) {
    const PixelSize size = window_->size();
    View view = display_.counters().frames > opened_at_ ? display_.drawn().stand.view : interface_.view();
    view.axes = interface_.view().axes;  // they are not drawn while everything is hidden
    return {workspace_.session().path(),    std::move(recovery),         std::move(view), {size.width, size.height},
            interface_.memory().clock.time, interface_.memory().failures};
}

void App::keep_by_hand() {
    const Document* document = workspace_.document();
    const Drawn& drawn = display_.drawn();
    if (!document || kept_frame_ == display_.counters().frames) return;
    if (values_of(document->controls) != drawn.stand.values || document->controls.rungs != drawn.rungs) return;
    kept_frame_ = display_.counters().frames;
    restart_.keep(carry(
        {nullptr, workspace_.session().files(), setup_text(changed_setup(document->scene(), document->controls)), {}}));
}

void App::keep_first() {
    const Document& document = *workspace_.document();
    restart_.keep(carry({nullptr,
                         workspace_.session().files(),
                         setup_text(changed_setup(document.scene(), document.controls)),
                         {}}),
                  display_.counters().frames > 0);
}

Document* App::shown_document() {
    Document* document = workspace_.document();
    return document ? &measuring_.shown(*document) : nullptr;
}

bool App::running() {
    const Document* document = workspace_.document();
    const ui::Memory& memory = interface_.memory();
    const bool timed = document && (document->runtime->animated() || memory.animating());
    return timed && !interface_.held() && !memory.clock.paused;
}

bool App::moving() {
    const Document* document = shown_document();
    return document && (running() || !document->runtime->settled());
}

double App::due() const { return measuring_.draws() ? 0 : display_.sharp_due(); }

bool App::visible() {
    const PixelSize pixels = window_->framebuffer();
    return pixels.width > 0 && pixels.height > 0;
}

double App::pause() {
    if (unsettled_ > 0 || workspace_.saving() || (measuring_.busy() && visible())) return 0;
    double until = std::min(next_look_, interface_.due());
    if (!specialised_ && options_.specialise) until = std::min(until, touched_ + until_still);
    if (interface_.fading() && visible()) until = std::min(until, window_->now() + frame_time);
    if (moving() && visible()) until = std::min(until, display_.last_picture() + frame_time);
    if (visible()) until = std::min(until, due());
    if (options_.exit_after > 0) until = std::min(until, began_ + options_.exit_after + 1e-3);
    return std::max(0.0, until - window_->now());
}

bool App::listen() {
    if (options_.state_file.empty()) return false;
    std::string question;
    std::getline(std::ifstream(options_.state_file + ".ask"), question);
    if (question == question_) return false;
    question_ = std::move(question);
    steps_ = 0;
    return true;
}

bool App::answer() {
    if (question_ == answered_ || !events_.empty() || !std::isinf(due())) return false;
    if (unsettled_ > 0 && ++steps_ < until_seen) return false;
    answered_ = question_;
    return true;
}

void App::settle(int frames) { unsettled_ = std::max(unsettled_, frames); }

void App::step() {
    const double now = window_->now();
    save();
    if (question_ != answered_) next_look_ = now;
    bool woken = look();
    window_->take_events(events_);
    for (const Event& event : events_)
        if (event.kind == Event::Kind::refresh || event.kind == Event::Kind::resize) repaints_ = until_equal;
    if (const std::vector<std::string> dropped = window_->take_dropped(); !dropped.empty())
        show_scene(workspace_.serve_dropped(dropped, interface_.memory()));
    if (now >= interface_.due()) settle(until_equal);
    woken |= now >= due() || !events_.empty() || unsettled_ > 0 || interface_.fading() ||
             (moving() && now >= display_.last_picture() + frame_time);
    if (answer() && !woken) write_state();
    if (!visible()) {
        unsettled_ = 0;  // everything is drawn again when the window comes back, which is an event
        return;
    }
    if (!events_.empty() || unsettled_ > 0) {
        touched_ = now;
        specialised_ = false;
    }
    // First, for programs for these values would be compiled for this, too.
    woken |= look_for_nan();
    const bool compiled = specialise();
    if (!woken && (compiled || !measure())) return;
    if (!events_.empty()) settle(until_equal);
    std::span<const Event> rest(events_);
    do {
        const std::size_t count = ui::batch(rest);
        interface_frame(rest.first(count));
        rest = rest.subspan(count);
    } while (!rest.empty());
    unsettled_ = std::max(0, unsettled_ - 1);
    show(std::exchange(repaints_, std::max(0, repaints_ - 1)) > 0);
}

void App::save() {
    if (workspace_.saving()) {
        settle(1);
        hang_.begin("drawing a part");
    }
    workspace_.step(interface_.memory());
    hang_.rest();
}

bool App::look() {
    const double now = window_->now();
    if (now < next_look_ || workspace_.saving()) return false;
    next_look_ = now + look_at_files;
    keep_by_hand();
    if (pictured_ != workspace_.session().path() && display_.counters().frames > 0 && now > touched_ + until_still)
        keep_picture();
    const bool saved = workspace_.session().saved();
    if (saved) reload();
    const bool linted = now > touched_ + until_still && workspace_.session().lint();
    return workspace_.look(interface_.view(), interface_.memory()) || saved || linted;
}

bool App::look_for_nan() {
    Document* document = workspace_.document();
    if (!document || interface_.pressed() || !std::isinf(due()) || workspace_.saving() || first_picture()) return false;
    if (!measuring_.watches(*document, display_, interface_.memory(), window_->now())) return false;
    hang_.begin("looking for NaN");
    measuring_.look_for_nan(*document, display_);
    hang_.rest();
    return true;
}

bool App::specialise() {
    Document* document = shown_document();
    if (interface_.memory().animating() || !std::isinf(due())) return false;  // they are not seen yet
    if (specialised_ || !options_.specialise || !document || window_->now() < touched_ + until_still) return false;
    hang_.begin("compiling programs for the values as they are");
    specialised_ = !display_.specialise(*document);
    hang_.rest();
    if (specialised_ && measuring_.outdated(*workspace_.document())) settle(1);
    return !specialised_;
}

bool App::measure() {
    if (!measuring_.busy()) return false;
    const auto alive = [this] { hang_.begin("measuring"); };
    alive();
    const bool measured = measuring_.step(workspace_.document(), alive);
    hang_.rest();
    if (measured) settle(1);
    return measured;
}

void App::keep_picture() {
    if (!workspace_.document()) return;
    pictured_ = workspace_.session().path();
    if (!workspace_.document()->diagnostics.has_errors()) workspace_.keep_picture(display_.thumbnail());
}

void App::reload() {
    restart_.trying(workspace_.session().path());
    workspace_.reload(interface_.view(), interface_.memory());
    kept_frame_ = 0;  // where nothing new is shown, that is kept as before
    measuring_.leave(interface_.memory().accuracy);
    settle(until_equal);
}

void App::show_scene(const std::optional<std::string>& path) {
    if (!path) return;
    keep_picture();
    restart_.trying(*path);
    if (const std::string problem = workspace_.open(*path, interface_.view()); !problem.empty()) {
        kept_frame_ = 0;
        // What was typed stays to be corrected.
        if (ui::Browser& browser = interface_.memory().browser; std::exchange(browser.asked, false)) {
            browser.error = utf8::printable(problem);
            browser.open = browser.focus = true;
            return;
        }
        interface_.memory().failed({utf8::printable(problem), ui::Failure::Remedy::open, {*path, 1, 1}});
        return;
    }
    opened_at_ = kept_frame_ = display_.counters().frames;
    interface_.begin_scene(*path, workspace_.is_saved_as());
    workspace_.begin(interface_.view(), interface_.memory());
    picking_ = {};
    measuring_.begin_scene(*path);
    settle(until_equal);
}

void App::interface_frame(std::span<const Event> events) {
    Controls no_controls;
    Document* document = workspace_.document();
    if (document)
        picking_.follow(*document, workspace_.session().revision(), interface_.view(), interface_.memory().hold);
    Past& past = workspace_.past();
    past.hear(events);
    const ui::Requests requests = interface_.frame(events, facts(), document ? document->controls : no_controls);
    std::vector<Animated>& moving = interface_.memory().animated;
    const bool undone = requests.undo && past.undoes_motion();
    if (undone) moving.clear();
    if (requests.take_back) past.take_back(moving.size());
    past.follow(workspace_.session(), interface_.view(), interface_.busy(), moving, window_->now(), undone);
    serve(requests);
    if (const auto title = workspace_.new_title()) window_->set_title(*title);
}

ui::Facts App::facts() {
    const ui::Memory& memory = interface_.memory();
    const Document* document = workspace_.document();
    ui::Facts facts;
    facts.time = display_.counters().time;
    facts.frame_ms = display_.counters().frame_ms;
    facts.samples = display_.samples();
    facts.grain = grains[static_cast<std::size_t>(display_.drawn().grain)].text;
    if (tells_) facts.grain = "drawing\u2026";
    // In steps, because the panels are drawn again for each.
    const auto percent = [](double share) { return static_cast<int>(20 * share) * 5; };
    if (const double share = display_.sharp_share(); share > 0)
        facts.grain = fmt::format("drawing sharp: {} %", percent(share));
    else if (const auto flagged = measuring_.flagged())
        facts.grain = fmt::format("marks: {} %", percent(*flagged));
    facts.renderer = caps_.renderer;
    facts.first_picture = first_picture();
    facts.longest_picture = options_.timeout;
    workspace_.tell(facts, memory);
    facts.full_screen = window_->full_screen();
    picking_.tell(facts, document, memory.hold);
    if (document) measuring_.explain(facts, *document, memory);
    measuring_.tell(facts, workspace_.document(), workspace_.session(), memory);
    return facts;
}

void App::serve(const ui::Requests& requests) {
    ui::Memory& memory = interface_.memory();
    const Stand& stand = display_.drawn().stand;
    const Picture shown{stand.width, stand.height, display_.samples(), stand.time, interface_.view()};
    if (Document* document = workspace_.document())
        picking_.serve(requests, *document, stand, interface_.density(), memory.hold);
    if (requests.save && workspace_.session().awaits_own()) reload();  // its last save, which this one is based on
    show_scene(workspace_.serve(requests, shown, *window_, interface_.view(), memory));
    if (workspace_.follow_rungs()) settle(until_equal);
    if (workspace_.session().outdated()) reload();
    if (const std::string command = measuring_.serve(requests, workspace_.document(), memory); !command.empty()) {
        window_->set_clipboard(command);
        memory.notice = "copied: " + command;
    }
    if (requests.write_rung) memory.write_rung.folder = workspace_.folder();
    if (requests.reload) reload();
    if (requests.full_screen) window_->set_full_screen(!window_->full_screen());
}

void App::show(bool repaint) {
    const ui::Memory& memory = interface_.memory();
    remember_size();
    const bool first = first_picture();
    if (first) show_before_first(repaint);
    Document* document = workspace_.document();
    const bool drew = document && draw_told();
    if (lost()) return;
    document = workspace_.document();
    if (first) interface_frame({});
    const bool told = document && measuring_.follow(*document, workspace_.session(), display_,
                                                    !running() && !interface_.pressed(), memory, window_->now());
    if (drew || told) settle(told ? until_equal : 1);  // the panels show the new cost and values
    // The divider is in the interface's picture.
    const std::array now{interface_.picture(), measuring_.revision(memory)};
    if (drew || told || repaint || now != presented_) {
        show_all();
        presented_ = now;
    }
    if (!options_.state_file.empty()) write_state();
}

void App::show_all() {
    const PixelSize pixels = window_->framebuffer();
    const ui::Memory& memory = interface_.memory();
    display_.show(pixels, measuring_.divider(display_.drawn().stand.width, memory.accuracy));
    if (workspace_.document()) measuring_.show(display_.bottom(pixels), memory);
    paint();
}

bool App::draw_told() {
    const bool drew = draw_scene();
    if (!tells_) return drew;
    interface_frame({});
    show_all();
    if (!options_.state_file.empty()) write_state();
    const bool drawn = workspace_.document() && draw_scene();
    tells_ = false;
    return drawn;
}

bool App::first_picture() { return workspace_.document() && begun_ != workspace_.session().path(); }

void App::show_before_first(bool repaint) {
    interface_frame({});  // the last one may be that which opened the scene
    for (int i = 0; i < (repaint ? 2 : 1); ++i) {
        display_.show(window_->framebuffer(), std::nullopt);
        paint();
    }
    begun_ = workspace_.session().path();
    keep_first();
}

void App::paint() {
    const double start = window_->now();
    interface_.paint();
    if (!options_.state_file.empty()) gl::finish();  // so that each part has its own time
    display_.present((window_->now() - start) * 1e3);
}

void App::write_state() {
    const ui::Memory& memory = interface_.memory();
    ui::Facts measured;
    measuring_.tell(measured, workspace_.document(), workspace_.session(), memory);
    write_window_state(options_.state_file, answered_, display_.counters(), workspace_, interface_.view(),
                       interface_.layout(), memory, measured, window_->framebuffer());
}

bool App::draw_scene() {
    Document& document = *workspace_.document();
    Session& session = workspace_.session();
    ui::Memory& memory = interface_.memory();
    const float density = interface_.density();
    const auto in_pixels = [&](float length) { return std::max(1, static_cast<int>(std::lround(length * density))); };
    const double time = interface_.time(workspace_.saving());
    animate(document.controls, memory.animated, time);
    const std::uint64_t revision = session.stale() ? display_.drawn().revision : session.revision();
    View view = interface_.view();
    view.axes = view.axes && memory.panel;
    const Stand stand{in_pixels(memory.scene.width), in_pixels(memory.scene.height),
                      document.runtime->animated() ? time : 0, std::move(view), values_of(document.controls)};
    const bool held = interface_.pressed();
    const Wanted wanted{held, memory.always_sharp, memory.animating() && !held, measuring_.wants_picture(display_)};
    measuring_.prepare(document, session, memory.accuracy);
    Document& shown = measuring_.shown(document);
    const std::uint64_t showing = measuring_.showing();
    // Objects are those of the scene: a found rung may have others.
    const Index object = shown.scene().draws.size() == document.scene().draws.size() ? memory.hold.object : none;
    Half left{{revision, stand, document.controls.rungs, showing, object}, &shown};
    std::optional<Half> right;
    Document* const beside = measuring_.beside(document);
    if (beside) {
        right = Half{{revision, stand, beside->controls.rungs, showing}, beside};
        right->next.stand.values = values_of(beside->controls);
    }
    if (!display_.prepare(std::move(left), std::move(right), wanted)) return false;
    if (!display_.given_up()) memory.failures.done(ui::Failure::Remedy::sharp);
    tells_ = !tells_ && display_.slow();
    if (tells_) return false;
    hang_.begin("drawing a frame of " + workspace_.name(), display_.spent());
    const bool drew = display_.draw(measuring_.begin_picture(revision + (showing << 32U), display_), density);
    hang_.rest();
    if (!drew) {
        if (display_.given_up()) give_up(shown);
        return false;
    }
    measuring_.end_picture(display_);
    if (&shown == &document || beside == &document) session.drawn_well();
    return true;
}

void App::give_up(const Document& shown) {
    const Index program = shown.runtime->long_program(shown.controls);
    const std::string loops =
        program == none ? "" : fmt::format(": a loop of '{}' may not end", shown.scene().programs[program].name);
    interface_.memory().failed(
        {utf8::printable(
             fmt::format("the sharp picture of {} took longer than {:g} seconds and was stopped{}. The coarse "
                         "one stays; F5 or a change tries again, --timeout SECONDS waits longer",
                         workspace_.name(), options_.timeout, loops)),
         ui::Failure::Remedy::sharp});
    settle(until_equal);
}

void begin_with(Carried& carried, WindowOptions& options) {
    if (carried.scene.empty()) {  // nothing was drawn before
        carried.scene = options.scene;
        carried.recovery.files = {options.scene};
        return;
    }
    if (carried.scene != options.scene) {
        options.quality.clear();  // the options were for the first scene
        options.ladders.clear();
    }
    options.scene = carried.scene;
    options.size = carried.size;
}

}  // namespace

int run_window(const WindowOptions& options) {
    Restart restart(options.after);
    WindowOptions now = options;
    now.scene = only_scene(now.scene);
    std::optional<Carried> carried = restart.carried();
    if (carried) begin_with(*carried, now);
    std::string unreadable;
    if (!carried && !now.scene.empty() && !is_folder(now.scene) &&
        !content::read_regular_file(now.scene, now.access.limits.file_bytes, {}, unreadable))
        return complain(app::exit_input, fmt::format("cannot read '{}': {}", options.scene, unreadable));
    // What is saved while one context is shown holds for the next, too.
    const GivenTexts given(now.access);
    Past past(kept_folder(settings_file()));
    while (true) {
        std::string error;
        std::unique_ptr<Window> window = Window::make({.title = title_of(now.scene)}, error);
        if (!window && now.scene.empty())
            return complain(app::exit_usage, "no scene given, and no window to choose one in: " + error);
        if (!window)
            return complain(app::exit_graphics, "no window: " + error, "'snell render' draws without a display");
        given.remove_saved(now.access);
        App app(now, std::move(window), restart, carried ? &*carried : nullptr, past);
        app.run(carried && carried->recovery.edited);
        if (!app.lost()) return app.readable() ? app::exit_fine : app::exit_input;
        const bool again = carried.has_value();
        carried = app.carried();
        fmt::print(stderr, "snell: {}", render(carried->recovery.problem, {}));
        // The window ends if the context was lost twice without a good picture in between.
        if (again && !carried->recovery.kept) return app::exit_lost;
        begin_with(*carried, now);
    }
}

}  // namespace snell
