#include "src/app/window/window_state.h"

#include <nlohmann/json.hpp>

#include "src/content/replace.h"
#include "src/gl/context.h"
#include "src/plan/setup.h"
#include "src/runtime/inspect.h"

namespace snell {

namespace {

using nlohmann::json;

json rect_of(const ui::Rect& rect) { return json::array({rect.x, rect.y, rect.width, rect.height}); }

json controls_of(const Document& document) {
    json controls = json::object();
    const std::vector<std::string> names = control_names(document.scene(), document.controls);
    for (std::size_t i = 0; i < names.size(); ++i) controls[names[i]] = document.controls.items[i].value;
    return controls;
}

json view_of(const View& view, const HoldMemory& hold) {
    const Transformation& t = view.scene;
    return {{"rotate_y", t.rotate_y},
            {"scale", t.scale},
            {"x", t.x},
            {"y", t.y},
            {"z", t.z},
            {"axes", view.axes},
            {"text", view_text(view)},
            {"object", hold.object == none ? json() : json(hold.object)}};
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
    return {{"note", facts.note},
            {"samples", facts.samples},
            {"wanted", facts.wanted},
            {"error", facts.error},
            {"measuring", facts.measured.has_value()},
            {"remark", facts.remark},
            {"divider", memory.divider},
            {"points", std::move(points)}};
}

json found_of(const ui::FoundFacts& facts) {
    json rows = json::array();
    for (const ui::FoundRow& row : facts.rows) {
        rows.push_back({{"name", row.name},
                        {"group", static_cast<int>(row.group)},
                        {"kind", row.kind},
                        {"where", row.where},
                        {"ratio", row.ratio},
                        {"front", row.front},
                        {"remark", row.remark}});
        if (row.error) rows.back()["error"] = *row.error;
    }
    return {{"rows", std::move(rows)},  {"searching", facts.progress.has_value()},
            {"waiting", facts.waiting}, {"older", facts.older},
            {"stale", facts.stale},     {"remark", facts.remark},
            {"shown", facts.shown}};
}

// Values are written as text, because JSON has neither NaN nor infinity.
json pixels_of(const ui::PixelFacts& facts) {
    json pixels{{"title", facts.half.empty() ? facts.at : facts.at + ", " + facts.half}};
    if (facts.drawn) pixels["drawn"] = *facts.drawn;
    for (const auto& [half, counts] : facts.flags) {
        json& flags = half.empty() ? pixels["flags"] : pixels["flags"][half];
        for (const Flag flag : {Flag::nan, Flag::infinite, Flag::negative, Flag::above_one})
            flags[std::string(name(flag))] = counts[flag];
    }
    if (!facts.inspection) return pixels;
    const Inspection& found = *facts.inspection;
    pixels["at"] = {found.x, found.y};
    for (const float value : found.pixel()) pixels["rgba"].push_back(ui::value_text(value).view());
    if (found.distance) pixels["distance"] = *found.distance;
    if (facts.difference) pixels["difference"] = *facts.difference;
    pixels["statement"] = facts.statement;
    pixels["place"] = facts.place;
    return pixels;
}

json frame_cost_of(const ui::FrameCostFacts& facts) {
    json apart = json::array();
    for (const ui::CostRow& cost : facts.apart)
        apart.push_back({{"name", cost.name}, {"milliseconds", cost.milliseconds}, {"draw", cost.draw}});
    return {{"pictures", facts.frames.size()}, {"last", facts.frames.empty() ? 0 : facts.frames.back()},
            {"median", facts.median},          {"high", facts.high},
            {"apart", std::move(apart)},       {"measuring", facts.measuring.has_value()},
            {"coarse", facts.coarse}};
}

json textures_of(const ui::TextureFacts& facts) {
    json textures{{"rows", json::array()}, {"drawn", facts.drawn}, {"read", facts.read}};
    for (const ui::TextureRow& row : facts.rows)
        textures["rows"].push_back({{"name", row.name}, {"loaded", row.loaded}, {"why", row.why}});
    textures["texel"] = pixels_of(facts.texel);
    return textures;
}

}  // namespace

void write_window_state(const std::string& file, const std::string& answered, const WindowCounters& counters,
                        Workspace& workspace, const View& view, const ui::Layout& layout, const ui::Memory& memory,
                        const ui::Facts& measured, PixelSize size) {
    Session& session = workspace.session();
    json state{{"frames", counters.frames},
               {"coarse", counters.coarse},
               {"strips", counters.strips},
               {"answered", answered},
               {"undo", workspace.past().steps()},
               {"presents", counters.presents},
               {"time", counters.time},
               {"grain", counters.grain},
               {"ms", {counters.frame_ms, counters.interface_ms, counters.present_ms}},
               {"revision", session.revision()},
               {"errors", session.errors()},
               {"problems", session.problems_text()},
               {"stale", session.stale()},
               {"view", view_of(view, memory.hold)},
               {"notice", memory.notice},
               {"picture_error", memory.picture.error},
               {"failure", memory.failures.open.empty() ? std::string() : memory.failures.open.back().text},
               {"file", session.path()},
               {"files", session.files()},
               {"theme", ui::theme_names[static_cast<std::size_t>(memory.theme)]},
               {"zoom", memory.zoom},
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
    if (measured.accuracy) state["accuracy"] = accuracy_of(memory.accuracy, *measured.accuracy);
    if (measured.states)
        for (const ui::StateFacts::Side& side : measured.states->sides) state["states"].push_back(side.label);
    if (measured.found && measured.found->asked) state["found"] = found_of(*measured.found);
    if (measured.pixels) state["pixels"] = pixels_of(*measured.pixels);
    state["nan"] = {{"text", measured.nan}, {"looks", measured.nan_looks}};
    if (measured.textures) state["textures"] = textures_of(*measured.textures);
    if (measured.frame_cost) state["frame_cost"] = frame_cost_of(*measured.frame_cost);
    json widgets = json::object();
    for (const ui::Placed& placed : layout.items())
        if (placed.visible) widgets[placed.name] = rect_of(placed.rect);
    state["widgets"] = std::move(widgets);
    content::replace_file(file, state.dump(-1, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace snell
