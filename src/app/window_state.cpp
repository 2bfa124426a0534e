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

}  // namespace

void write_window_state(const std::string& file, const WindowCounters& counters, Session& session, const View& view,
                        const ui::Layout& layout, const ui::Rect& scene, PixelSize size) {
    json state{{"frames", counters.frames},
               {"presents", counters.presents},
               {"time", counters.time},
               {"frame_ms", counters.frame_ms},
               {"revision", session.revision()},
               {"errors", session.errors()},
               {"problems", session.problems_text()},
               {"stale", session.stale()},
               {"view", view_of(view)},
               {"scene", rect_of(scene)},
               {"size", {size.width, size.height}},
               {"gl_errors", gl::take_errors()}};
    if (const Document* document = session.document()) {
        const Counters& drawn = document->runtime->counters();
        state["controls"] = controls_of(*document);
        for (const CounterName& counter : counter_names())
            state["counters"][std::string(counter.name)] = drawn.*counter.value;
    }
    json widgets = json::object();
    for (const ui::Placed& placed : layout.items())
        if (placed.visible) widgets[placed.name] = rect_of(placed.rect);
    state["widgets"] = std::move(widgets);
    const std::string fresh = file + ".new";
    std::ofstream(fresh) << state.dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
    std::rename(fresh.c_str(), file.c_str());
}

}  // namespace snell
