#include "web/interface/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "parser/text/ranges.h"
#include "src/plan/values/controls.h"

namespace snell::web {

namespace {

const char* widget_name(Widget widget) {
    return widget == Widget::color ? "color" : widget == Widget::check_box ? "check_box" : "slider";
}

Json place_json(const Span& span, const Sources& sources) {
    const Position begin = sources.position(span.file, span.begin), end = sources.position(span.file, span.end);
    return {{"file", std::string(sources.name(span.file))},
            {"line", begin.line},
            {"column", begin.column},
            {"endLine", end.line},
            {"endColumn", end.column}};
}

Json ladders_json(const Document& document) {
    Json all = Json::array();
    const std::vector<Ladder>& ladders = document.scene().ladders;
    for (std::size_t i = 0; i < ladders.size(); ++i)
        all.push_back({{"index", i},
                       {"name", ladders[i].name},
                       {"rungs", ladders[i].rungs},
                       {"chosen", document.runtime->rungs()[i]},
                       {"marked", ladders[i].current},
                       {"reference", ladders[i].rungs.size() - 1}});
    return all;
}

bool reads_timer(const Document& document) {
    return ranges::any_of(document.runtime->active_uniforms(), [](const std::vector<ActiveUniform>& uniforms) {
        return ranges::any_of(uniforms, [](const ActiveUniform& u) { return u.system && u.name == "Timer"; });
    });
}

// A page has no command line.
std::string without_options(const std::string& help) {
    const std::size_t option = help.find("--limit");
    if (option == std::string::npos) return help;
    const std::size_t end = help.find_last_not_of("; ", option == 0 ? 0 : option - 1);
    return option == 0 ? std::string() : help.substr(0, end + 1);
}

Json counters_json(const Counters& counters) {
    Json all = Json::object();
    for (const CounterName& one : counter_names()) all[std::string(one.name)] = counters.*one.value;
    return all;
}

}  // namespace

Json problems_json(const Diagnostics& diagnostics, const Sources& sources) {
    Json all = Json::array();
    for (Diagnostic d : diagnostics.items()) {
        d.help = without_options(d.help);
        Json one{{"severity", name(d.severity)}, {"code", d.code}, {"message", d.message}, {"help", d.help}};
        if (d.has_span) one["at"] = place_json(d.span, sources);
        one["text"] = render(d, sources);
        all.push_back(std::move(one));
    }
    return all;
}

bool Sliders::can_be_logarithmic(const Control& control) const {
    return control.min > 0 && control.max > control.min && std::isfinite(control.max / control.min);
}

Track Sliders::track_of(const Control& control) const {
    return {control.min, control.max, control.type,
            logarithmic.contains({control.program, control.name}) && can_be_logarithmic(control)};
}

Animated* Sliders::motion_of(const Control& control, std::size_t component) {
    const auto found =
        ranges::find_if(moving, [&](const Animated& motion) { return motion.moves(control, component); });
    return found == moving.end() ? nullptr : &*found;
}

Json controls_json(const Document& document, Sliders& sliders) {
    Json all = Json::array();
    const std::vector<Control>& items = document.controls.items;
    const std::vector<std::string> names = control_names(document.scene(), document.controls);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Control& c = items[i];
        if (c.widget == Widget::none || !c.active) continue;
        const auto text = [&](double value) { return shown(value, c.min, c.max, is_whole(c.type)); };
        Json& json = all.emplace_back(Json{{"index", i},
                                           {"key", names[i]},
                                           {"program", document.scene().programs[c.program].name},
                                           {"name", c.name},
                                           {"widget", widget_name(c.widget)},
                                           {"min", c.min},
                                           {"max", c.max},
                                           {"value", c.value},
                                           {"initial", c.initial},
                                           {"logarithmic", sliders.logarithmic.contains({c.program, c.name})},
                                           {"canBeLogarithmic", sliders.can_be_logarithmic(c)}});
        for (const char* list : {"at", "shown", "initialShown", "periods"}) json[list] = Json::array();
        for (std::size_t part = 0; part < c.value.size(); ++part) {
            const Animated* const motion = sliders.motion_of(c, part);
            json["at"].push_back(fraction_of(c.value[part], sliders.track_of(c)));
            json["shown"].push_back(text(c.value[part]));
            json["initialShown"].push_back(text(c.initial[part]));
            json["periods"].push_back(motion ? motion->period : 0);
        }
    }
    return all;
}

Json shown_json(const Document& document, Sliders& sliders) {
    const Scene& scene = document.scene();
    const bool animated = document.runtime->animated();
    return {{"title", std::filesystem::path(document.path).stem().string()},
            {"scene", document.path},
            {"controls", controls_json(document, sliders)},
            {"ladders", ladders_json(document)},
            {"width", scene.window_size[0]},
            {"height", scene.window_size[1]},
            {"animated", animated},
            {"usesMouse", document.runtime->uses_mouse()},
            {"longLoops", document.runtime->may_have_long_loops()},
            {"period", animated && reads_timer(document) ? scene.timer_period : 0},
            {"files", document.files->read_paths()},
            {"counters", counters_json(document.runtime->counters())}};
}

}  // namespace snell::web
