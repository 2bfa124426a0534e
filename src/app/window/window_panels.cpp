// The panels beside the picture: what they are told, and what becomes of what they ask for.
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "parser/text/utf8.h"
#include "src/app/window/app.h"
#include "src/ui/shell.h"

namespace snell {

void App::interface_frame(std::span<const Event> events) {
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
    if (requests.reload) reload();
}

ui::Facts App::facts() {
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
        for (const auto& uniforms : document->runtime->active_uniforms()) linked_.push_back(whole || !uniforms.empty());
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

void App::show_scene(const std::optional<std::string>& path) {
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

void App::tell_measured(ui::Facts& facts) {
    facts.accuracy = accuracy_.facts(memory_.accuracy);
    facts.frame_cost = frame_costs_.facts(session_.document());
    facts.pixels = pixels_.facts();
}

void App::report() {
    std::string text = session_.problems_text();
    if (text != reported_) fmt::print(stderr, "{}", text);
    reported_ = std::move(text);
}

}  // namespace snell
