// The functions that the page calls (web/page/wasm.ts). All that crosses is JSON, numbers, and the bytes of pictures.
#include <emscripten.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/content/image/image.h"
#include "src/content/text_forms.h"
#include "src/document/document.h"
#include "src/document/history.h"
#include "src/lint/lint.h"
#include "src/plan/plan.h"
#include "src/plan/setup.h"
#include "src/plan/texts.h"
#include "src/plan/values/numbers.h"
#include "src/plan/view.h"
#include "web/interface/drawing.h"
#include "web/interface/text.h"

namespace {

using namespace snell;
using namespace snell::web;

// The page holds one, and passes it to every function.
struct Engine {
    OpenScene scene;
    Drawing drawing;
    Sliders sliders;
    History history;
    std::uint64_t gestures = 0;
    std::string canvas;
    HoldMemory hold;
    std::string answer;            // of the last call that returned a text
    std::vector<std::byte> bytes;  // of the last picture

    // Values, rungs and the view are there without graphics, too, as while the browser has taken them away.
    bool reads() { return scene.document() && scene.document()->runtime; }
    bool draws() { return reads() && drawing.ready(); }
    Control* control(int index) {
        if (!scene.document() || index < 0) return nullptr;
        std::vector<Control>& items = scene.document()->controls.items;
        return static_cast<std::size_t>(index) < items.size() ? &items[static_cast<std::size_t>(index)] : nullptr;
    }
    // Ends a gesture: what was changed since the last one is a step.
    void follow() {
        if (!reads()) return;
        const Document& document = *scene.document();
        history.follow(document.scene(), document.controls, scene.view, {false, ++gestures, 0, sliders.moving});
    }
    // The scene was read, another one if `fresh`.
    void take(bool fresh) {
        const Document& document = *scene.document();
        if (fresh) {
            sliders = {};
            history = {};
            history.begin(document.scene(), document.controls, scene.view);
        } else {
            history.reread(document.scene(), document.controls, scene.view);
        }
    }
    // Sets a component to what `next` makes of its value.
    template <typename Next>
    void change(int index, int component, const Next& next) {
        Control* const item = control(index);
        if (!item || component < 0 || static_cast<std::size_t>(component) >= item->value.size()) return;
        stop(sliders.moving, *item, static_cast<std::size_t>(component));
        double& value = item->value[static_cast<std::size_t>(component)];
        if (const std::optional<double> fits = fitting(next(*item, value), item->type)) value = *fits;
    }
    const char* say(std::string text) {
        answer = std::move(text);
        return answer.c_str();
    }
    const char* tell(const Json& json) { return say(content::json_text(json)); }
};

Settings settings_of(const char* text) {
    const Json json = content::parse_json(text);
    Settings settings;
    if (!json.is_object()) return settings;
    settings.values = json.value("values", settings.values);
    settings.rungs = json.value("rungs", settings.rungs);
    settings.ranges = json.value("ranges", settings.ranges);
    if (json.contains("view")) settings.view = json.value("view", std::string());
    settings.fresh = json.value("fresh", false);
    settings.lints = json.value("lints", true);
    return settings;
}

// What is said of a scene without graphics, with lints. The document has no runtime.
Document checked(const std::string& path) {
    Document document;
    document.path = path;
    document.files = std::make_unique<Files>(scene_folder(path), page_access({}));
    if (const auto plan = read_plan(path, *document.files, document.sources, document.diagnostics))
        document.diagnostics.append(lint::check(*plan, document.sources, shader_includes(*document.files)));
    document.diagnostics.sort();
    return document;
}

// The bytes of an image file in the form that every decoder of the page takes in place of the file.
std::vector<std::byte> decoded(const std::string& name, std::string_view bytes, std::string& error) {
    const content::ImageResult result =
        content::decode_image(name, bytes, {.bytes = page_access({}).limits.texture_bytes});
    if (result.image) return content::decoded_file(*result.image);
    error = result.issues.empty() ? "cannot be decoded" : result.issues.front().message;
    return {};
}

// JSON has no bytes, and not every text is UTF-8: each byte crosses as the character of its number.
std::string characters(const std::string& bytes) {
    std::string text;
    for (const char each : bytes) {
        const auto byte = static_cast<unsigned char>(each);
        if (byte >= 0x80) text += static_cast<char>(0xc0 | byte >> 6);
        text += byte < 0x80 ? each : static_cast<char>(0x80 | (byte & 0x3f));
    }
    return text;
}

Json opened_json(Engine& engine, bool ok, const Diagnostics& found, const Sources& sources, double began) {
    Json json{{"ok", ok}, {"problems", problems_json(found, sources)}};
    if (engine.draws()) json["shown"] = shown_json(*engine.scene.document(), engine.sliders);
    json["milliseconds"] = emscripten_get_now() - began;
    return json;
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE Engine* snell_new() { return new Engine; }

// `canvas`: see CanvasContext. Returns "" or why there are no graphics.
EMSCRIPTEN_KEEPALIVE const char* snell_start(Engine* engine, const char* canvas) {
    engine->canvas = canvas;
    return engine->say(engine->drawing.start(canvas));
}

EMSCRIPTEN_KEEPALIVE const char* snell_driver(Engine* engine) {
    const gl::Caps& caps = engine->drawing.caps();
    return engine->tell(Json{{"renderer", caps.renderer},
                             {"vendor", caps.vendor},
                             {"version", caps.version},
                             {"maxTexture", caps.max_texture},
                             {"maxViewport", caps.max_viewport},
                             {"maxSamples", caps.max_samples},
                             {"maxPointSize", caps.max_point_size},
                             {"maxLineWidth", caps.max_line_width}});
}

EMSCRIPTEN_KEEPALIVE const char* snell_open(Engine* engine, const char* scene, const char* settings) {
    const double began = emscripten_get_now();
    if (!engine->drawing.ready())
        return engine->tell(Json{{"ok", false}, {"problems", Json::array()}, {"milliseconds", 0}});
    const Settings given = settings_of(settings);
    const std::string before = engine->scene.document() ? engine->scene.document()->path : std::string();
    engine->follow();
    const Reading reading = engine->scene.open(scene, given, engine->drawing.caps());
    if (reading.shown) engine->take(given.fresh || before != scene);
    const Document& read = reading.shown ? *engine->scene.document() : *reading.refused;
    Diagnostics found = read.diagnostics;
    found.append(reading.settings);
    return engine->tell(opened_json(*engine, reading.shown, found, read.sources, began));
}

EMSCRIPTEN_KEEPALIVE const char* snell_check(Engine* engine, const char* scene) {
    const Document document = checked(scene);
    return engine->tell(problems_json(document.diagnostics, document.sources));
}

// A value outside of the range widens it if `widens`, and else is moved into it.
EMSCRIPTEN_KEEPALIVE void snell_set(Engine* engine, int index, int component, double value, int widens) {
    engine->change(index, component, [&](Control& control, double before) {
        const std::optional<double> fits = fitting(value, control.type);
        if (!fits || control.widget != Widget::slider) return fits.value_or(before);
        if (widens) {
            control.min = std::min(control.min, *fits);
            control.max = std::max(control.max, *fits);
        }
        return std::clamp(*fits, control.min, control.max);
    });
}

// Moves a slider to a fraction of its track.
EMSCRIPTEN_KEEPALIVE void snell_slide(Engine* engine, int index, int component, double fraction, int fine) {
    engine->change(index, component, [&](const Control& control, double) {
        return value_at(fraction, engine->sliders.track_of(control), fine != 0);
    });
}

EMSCRIPTEN_KEEPALIVE void snell_step(Engine* engine, int index, int component, double steps) {
    engine->change(index, component, [&](const Control& control, double value) {
        return stepped(value, steps, engine->sliders.track_of(control));
    });
}

// Gives a colour's component a byte of a picker. It keeps the precision that the picker lacks if that is its byte.
EMSCRIPTEN_KEEPALIVE void snell_pick(Engine* engine, int index, int component, int byte) {
    engine->change(index, component, [&](const Control&, double value) {
        return std::round(255 * std::clamp(value, 0., 1.)) == byte ? value : tidy_color(byte / 255.);
    });
}

// A negative component means all of the control.
EMSCRIPTEN_KEEPALIVE void snell_reset(Engine* engine, int index, int component) {
    Control* const control = engine->control(index);
    if (!control || component >= static_cast<int>(control->value.size())) return;
    for (std::size_t part = 0; part < control->value.size(); ++part)
        if (component < 0 || part == static_cast<std::size_t>(component)) stop(engine->sliders.moving, *control, part);
    if (component < 0)
        reset(*control);
    else
        reset(*control, static_cast<std::size_t>(component));
}

EMSCRIPTEN_KEEPALIVE void snell_scale(Engine* engine, int index, int logarithmic) {
    const Control* const control = engine->control(index);
    if (!control) return;
    const std::pair key{control->program, control->name};
    if (logarithmic)
        engine->sliders.logarithmic.insert(key);
    else
        engine->sliders.logarithmic.erase(key);
    for (Animated& motion : engine->sliders.moving)
        if (motion.program == control->program && motion.name == control->name)
            motion.logarithmic = engine->sliders.track_of(*control).logarithmic;
}

// Begins or changes a slider's motion at this time of the scene, in seconds; without a period it ends.
EMSCRIPTEN_KEEPALIVE void snell_animate(Engine* engine, int index, int component, double period, double time) {
    const Control* const control = engine->control(index);
    if (!control || component < 0 || static_cast<std::size_t>(component) >= control->value.size()) return;
    const auto part = static_cast<std::size_t>(component);
    Sliders& sliders = engine->sliders;
    if (Animated* const motion = sliders.motion_of(*control, part); motion && period > 0)
        set_period(*motion, period, time);
    else if (period > 0)
        sliders.moving.push_back(animated_from(*control, part, period, time, sliders.track_of(*control).logarithmic));
    else
        stop(sliders.moving, *control, part);
}

// Moves what moves by itself to this time.
EMSCRIPTEN_KEEPALIVE void snell_advance(Engine* engine, double time) {
    if (engine->reads()) animate(engine->scene.document()->controls, engine->sliders.moving, time);
}

EMSCRIPTEN_KEEPALIVE void snell_follow(Engine* engine) { engine->follow(); }

// Goes a step of the history back, or forward again; what moves by itself stops before. "said" is what was changed, and
// if the rungs were, there is what snell_choose returns, too.
EMSCRIPTEN_KEEPALIVE const char* snell_go(Engine* engine, int forward) {
    const double began = emscripten_get_now();
    if (!engine->draws()) return engine->tell(Json{{"said", ""}});
    engine->sliders.moving.clear();
    engine->follow();
    Document& document = *engine->scene.document();
    const Diagnostics* found = nullptr;
    const UserState state{document.scene(), document.controls, engine->scene.view,
                          [&] { found = &engine->scene.follow_rungs(); }};
    Json json{{"said", forward ? engine->history.redo(state) : engine->history.undo(state)}};
    if (found) json["opened"] = opened_json(*engine, !found->has_errors(), *found, document.sources, began);
    return engine->tell(json);
}

// Returns the number that a text means for a control, or for none; NaN if it is none, infinity if it does not fit.
EMSCRIPTEN_KEEPALIVE double snell_typed(Engine* engine, int index, const char* text) {
    const Control* const control = engine->control(index);
    const double otherwise = is_number(text) ? std::numeric_limits<double>::infinity() : std::nan("");
    return typed(text, control ? control->type : ValueType::float_).value_or(otherwise);
}

EMSCRIPTEN_KEEPALIVE const char* snell_choose(Engine* engine, int ladder, int rung) {
    const double began = emscripten_get_now();
    if (!engine->draws()) return engine->tell(Json{{"ok", false}, {"problems", Json::array()}, {"milliseconds", 0}});
    Document& document = *engine->scene.document();
    const auto which = static_cast<std::size_t>(ladder), to = static_cast<std::size_t>(rung);
    if (which < document.scene().ladders.size() && to < document.scene().ladders[which].rungs.size())
        document.controls.rungs[which] = to;
    const Diagnostics& found = engine->scene.follow_rungs();
    return engine->tell(opened_json(*engine, !found.has_errors(), found, document.sources, began));
}

// The controls; what differs from the scene's text; and whether there are steps.
EMSCRIPTEN_KEEPALIVE const char* snell_state(Engine* engine) {
    Json json{{"controls", Json::array()},
              {"values", Json::array()},
              {"ranges", Json::array()},
              {"rungs", Json::array()},
              {"view", view_text(engine->scene.view)},
              {"canUndo", engine->history.done() > 0 || !engine->sliders.moving.empty()},
              {"canRedo", engine->history.done() < engine->history.size()}};
    if (engine->reads()) {
        const Document& document = *engine->scene.document();
        const Setup changed = changed_setup(document.scene(), document.controls);
        json["controls"] = controls_json(document, engine->sliders);
        json["values"] = set_arguments(document.scene(), document.controls);
        json["ranges"] = arguments_of(changed, range_option);
        json["rungs"] = arguments_of(changed, ladder_option);
    }
    return engine->tell(json);
}

EMSCRIPTEN_KEEPALIVE const char* snell_set_view(Engine* engine, const char* text) {
    View view;
    std::string wrong = parse_view(text, view);
    if (wrong.empty()) engine->scene.view = view;
    return engine->say(std::move(wrong));
}

// `begins`: another drag than before. One that begins with the scene upside down turns the other way.
EMSCRIPTEN_KEEPALIVE void snell_turn(Engine* engine, double dx, double dy, int begins) {
    if (!engine->reads()) return;
    const Scene& scene = engine->scene.document()->scene();
    if (begins) engine->hold.flipped = upside_down(engine->scene.view.scene, scene);
    apply({.turn = {dx, dy}}, scene, 1, engine->scene.view, engine->hold);
}

// In CSS pixels, on a picture of that size; `toward`: to the viewer.
EMSCRIPTEN_KEEPALIVE void snell_move(Engine* engine, double dx, double dy, double width, double height, double toward) {
    if (!engine->reads()) return;
    const double shorter = std::max(1., std::min(width, height));
    apply({.move = {dx, -dy, toward}}, engine->scene.document()->scene(), shorter, engine->scene.view, engine->hold);
}

EMSCRIPTEN_KEEPALIVE void snell_zoom(Engine* engine, double factor) {
    if (engine->reads())
        apply({.scale = factor}, engine->scene.document()->scene(), 1, engine->scene.view, engine->hold);
}

// Returns "" or what the picture was found to cost, once. `dragged`, `small`: see Drawing.
EMSCRIPTEN_KEEPALIVE const char* snell_draw(Engine* engine, double time, int width, int height, double split,
                                            double mouse_x, double mouse_y, int dragged, int small) {
    if (!engine->draws()) return engine->say("");
    engine->drawing.draw(engine->scene, {time, width, height, split, mouse_x, mouse_y}, dragged != 0, small != 0);
    Document& document = *engine->scene.document();
    const Diagnostics costs = document.runtime->take_costs();
    return costs.empty() ? engine->say("") : engine->tell(problems_json(costs, document.sources));
}

EMSCRIPTEN_KEEPALIVE double snell_drew(Engine* engine, double milliseconds) {
    return engine->drawing.drew(milliseconds);
}

EMSCRIPTEN_KEEPALIVE int snell_settle(Engine* engine, double time, int width, int height, double split, double mouse_x,
                                      double mouse_y) {
    return engine->draws() && engine->drawing.settle(engine->scene, {time, width, height, split, mouse_x, mouse_y});
}

// See Drawing::foresee.
EMSCRIPTEN_KEEPALIVE double snell_foresee(Engine* engine, double time, int width, int height, double split,
                                          double mouse_x, double mouse_y, double enough) {
    if (!engine->draws()) return 0;
    return engine->drawing.foresee(engine->scene, {time, width, height, split, mouse_x, mouse_y}, enough);
}

// Returns "" or the error; snell_bytes has the picture.
EMSCRIPTEN_KEEPALIVE const char* snell_picture(Engine* engine, double time, int width, int height, double split,
                                               double mouse_x, double mouse_y, int samples) {
    if (!engine->draws()) return engine->say("there is no picture yet");
    std::string error;
    engine->bytes =
        engine->drawing.picture(engine->scene, {time, width, height, split, mouse_x, mouse_y}, samples, error);
    return engine->say(std::move(error));
}

// Milliseconds, of a picture of which the page makes many.
constexpr double longest_preview = 1000;

// A picture of another scene, as it is written, without a trace in the one that is shown. Returns "" or why there is
// none; snell_bytes has it.
EMSCRIPTEN_KEEPALIVE const char* snell_preview(Engine* engine, const char* path, int width, int height) {
    if (!engine->drawing.ready()) return engine->say("there are no graphics");
    OpenScene scene;
    const Reading reading = scene.open(path, {}, engine->drawing.caps());
    const Diagnostics& found = reading.shown ? scene.document()->diagnostics : reading.refused->diagnostics;
    std::string error;
    if (const Diagnostic* const first = first_error(found)) error = first->message;
    const Moment moment{0, width, height, 1, 0, 0};
    if (error.empty() && scene.document()->runtime->may_have_long_loops() &&
        std::abs(engine->drawing.foresee(scene, moment, longest_preview)) > longest_preview)
        error = "a picture of it takes long";
    if (error.empty()) engine->bytes = engine->drawing.picture(scene, moment, 4, error);
    return engine->say(std::move(error));
}

// Decodes an image file, so that the page can do it on another thread. Returns "" or the error; snell_bytes has the
// decoded image.
EMSCRIPTEN_KEEPALIVE const char* snell_decode(Engine* engine, const char* name, const char* bytes, int size) {
    std::string error;
    engine->bytes = decoded(name, {bytes, static_cast<std::size_t>(size)}, error);
    return engine->say(std::move(error));
}

EMSCRIPTEN_KEEPALIVE const std::byte* snell_bytes(Engine* engine) { return engine->bytes.data(); }
EMSCRIPTEN_KEEPALIVE int snell_byte_count(Engine* engine) { return static_cast<int>(engine->bytes.size()); }
EMSCRIPTEN_KEEPALIVE void snell_free_bytes(Engine* engine) { engine->bytes = {}; }

EMSCRIPTEN_KEEPALIVE const char* snell_saved(Engine* engine) {
    Json json{{"files", Json::array()}, {"unwritten", Json::array()}, {"error", ""}};
    if (!engine->reads()) return engine->tell(json);
    const Saved saved = saved_values(*engine->scene.document(), engine->sliders.moving);
    json["error"] = saved.error;
    for (const SavedFile& file : saved.files)
        json["files"].push_back({{"name", file.path}, {"bytes", characters(file.after)}});
    for (const Unwritten& value : saved.unwritten) json["unwritten"].push_back(value.name + ": " + value.reason);
    for (const std::string& name : saved.moving) json["unwritten"].push_back(name + ": it moves; stop it first");
    return engine->tell(json);
}

// Takes the canvas up again after the browser took its context and gave it back.
EMSCRIPTEN_KEEPALIVE const char* snell_restored(Engine* engine) {
    const double began = emscripten_get_now();
    CanvasContext::forget_objects();
    engine->scene.release();
    const std::string error = engine->drawing.start(engine->canvas);
    Diagnostics found;
    if (!error.empty()) found.error("no-graphics", error);
    if (error.empty()) engine->scene.restore(engine->drawing.caps());
    return engine->tell(opened_json(*engine, error.empty(), found, {}, began));
}

}  // extern "C"
