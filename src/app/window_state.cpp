#include "src/app/window_state.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "src/gl/debug.h"

namespace snell {

namespace {

using nlohmann::json;

json rect_of(const ui::Rect& rect) { return json::array({rect.x, rect.y, rect.width, rect.height}); }

json controls_of(const Document& document) {
    json controls = json::object();
    for (const Control& control : document.controls.items)
        controls[document.scene().programs[control.program].name + "." + control.name] = control.value;
    return controls;
}

json view_of(const View& view) {
    const Transformation& t = view.scene;
    return {{"rotate_x", t.rotate_x}, {"rotate_y", t.rotate_y}, {"scale", t.scale}, {"x", t.x}, {"y", t.y}, {"z", t.z},
            {"axes", view.axes}};
}

json rungs_of(const Document& document) {
    json rungs = json::object();
    const std::vector<Ladder>& ladders = document.scene().ladders;
    for (std::size_t i = 0; i < ladders.size() && i < document.controls.rungs.size(); ++i)
        rungs[ladders[i].name] = ladders[i].rungs[document.controls.rungs[i]];
    return rungs;
}

json accuracy_of(const ui::AccuracyMemory& memory, const ui::AccuracyFacts& facts) {
    json points = json::array();
    for (const ui::AccuracyPoint& point : facts.points)
        points.push_back({{"name", point.name},
                          {"milliseconds", point.milliseconds},
                          {"error", point.error},
                          {"standing", ui::standing_text(point)},
                          {"chosen", point.chosen}});
    return {{"note", facts.note},         {"samples", facts.samples},
            {"wanted", facts.wanted},     {"milliseconds", facts.milliseconds},
            {"error", facts.error},       {"measuring", facts.measured.has_value()},
            {"remark", facts.remark},     {"divider", memory.divider},
            {"points", std::move(points)}};
}

}  // namespace

void write_window_state(const std::string& file, const WindowCounters& counters, Session& session, const View& view,
                        const ui::Layout& layout, const ui::Memory& memory, const ui::AccuracyFacts* accuracy,
                        PixelSize size) {
    json state{{"frames", counters.frames},
               {"presents", counters.presents},
               {"time", counters.time},
               {"frame_ms", counters.frame_ms},
               {"revision", session.revision()},
               {"errors", session.errors()},
               {"problems", session.problems_text()},
               {"stale", session.stale()},
               {"view", view_of(view)},
               {"notice", memory.notice},
               {"scene", rect_of(memory.scene)},
               {"size", {size.width, size.height}},
               {"gl_errors", gl::take_errors()}};
    if (const Document* document = session.document()) {
        const Counters& drawn = document->runtime->counters();
        state["controls"] = controls_of(*document);
        state["rungs"] = rungs_of(*document);
        for (const CounterName& counter : counter_names())
            state["counters"][std::string(counter.name)] = drawn.*counter.value;
    }
    if (accuracy) state["accuracy"] = accuracy_of(memory.accuracy, *accuracy);
    json widgets = json::object();
    for (const ui::Placed& placed : layout.items())
        if (placed.visible) widgets[placed.name] = rect_of(placed.rect);
    state["widgets"] = std::move(widgets);
    const std::string fresh = file + ".new";
    std::ofstream(fresh) << state.dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
    std::rename(fresh.c_str(), file.c_str());
}

}  // namespace snell
