// The functions that the page calls (web/page/wasm.ts). All that crosses is JSON, numbers, and the bytes of pictures.
#include <emscripten.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/content/image/image.h"
#include "src/content/text_forms.h"
#include "src/document/document.h"
#include "src/lint/lint.h"
#include "src/plan/plan.h"
#include "src/plan/setup.h"
#include "src/plan/texts.h"
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
    std::string canvas;
    HoldMemory hold;
    std::string answer;            // of the last call that returned a text
    std::vector<std::byte> bytes;  // of the last picture

    bool draws() { return scene.document() && scene.document()->runtime && drawing.ready(); }
    Control* control(int index) {
        if (!scene.document() || index < 0) return nullptr;
        std::vector<Control>& items = scene.document()->controls.items;
        return static_cast<std::size_t>(index) < items.size() ? &items[static_cast<std::size_t>(index)] : nullptr;
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
    if (engine.draws()) json["shown"] = shown_json(*engine.scene.document());
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
    const Reading reading = engine->scene.open(scene, settings_of(settings), engine->drawing.caps());
    const Document& read = reading.shown ? *engine->scene.document() : *reading.refused;
    Diagnostics found = read.diagnostics;
    found.append(reading.settings);
    return engine->tell(opened_json(*engine, reading.shown, found, read.sources, began));
}

EMSCRIPTEN_KEEPALIVE const char* snell_check(Engine* engine, const char* scene) {
    const Document document = checked(scene);
    return engine->tell(problems_json(document.diagnostics, document.sources));
}

EMSCRIPTEN_KEEPALIVE void snell_set(Engine* engine, int index, int component, double value) {
    Control* control = engine->control(index);
    if (control && std::isfinite(value) && component >= 0 &&
        static_cast<std::size_t>(component) < control->value.size())
        control->value[static_cast<std::size_t>(component)] = value;
}

EMSCRIPTEN_KEEPALIVE void snell_range(Engine* engine, int index, double min, double max) {
    Control* control = engine->control(index);
    if (!control || !(min <= max)) return;
    control->min = min;
    control->max = max;
}

// A negative index resets the values of all.
EMSCRIPTEN_KEEPALIVE void snell_reset(Engine* engine, int index) {
    if (Control* control = engine->control(index)) reset(*control);
    if (index >= 0 || !engine->scene.document()) return;
    for (Control& control : engine->scene.document()->controls.items) reset(control);
}

EMSCRIPTEN_KEEPALIVE const char* snell_choose(Engine* engine, int ladder, int rung) {
    const double began = emscripten_get_now();
    if (!engine->draws()) return engine->tell(Json{{"ok", false}, {"problems", Json::array()}, {"milliseconds", 0}});
    const Diagnostics& found = engine->scene.choose(static_cast<std::size_t>(ladder), static_cast<std::size_t>(rung));
    return engine->tell(opened_json(*engine, !found.has_errors(), found, engine->scene.document()->sources, began));
}

// What differs from the scene's text.
EMSCRIPTEN_KEEPALIVE const char* snell_state(Engine* engine) {
    Json json{{"values", Json::array()}, {"rungs", Json::array()}, {"view", view_text(engine->scene.view)}};
    if (engine->draws()) {
        const Document& document = *engine->scene.document();
        json["values"] = set_arguments(document.scene(), document.controls);
        json["rungs"] = arguments_of(changed_setup(document.scene(), {{}, document.runtime->rungs()}), ladder_option);
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
    if (!engine->draws()) return;
    const Scene& scene = engine->scene.document()->scene();
    if (begins) engine->hold.flipped = upside_down(engine->scene.view.scene, scene);
    apply({.turn = {dx, dy}}, scene, 1, engine->scene.view, engine->hold);
}

// In CSS pixels, on a picture of that size; `toward`: to the viewer.
EMSCRIPTEN_KEEPALIVE void snell_move(Engine* engine, double dx, double dy, double width, double height, double toward) {
    if (!engine->draws()) return;
    const double shorter = std::max(1., std::min(width, height));
    apply({.move = {dx, -dy, toward}}, engine->scene.document()->scene(), shorter, engine->scene.view, engine->hold);
}

EMSCRIPTEN_KEEPALIVE void snell_zoom(Engine* engine, double factor) {
    if (engine->draws())
        apply({.scale = factor}, engine->scene.document()->scene(), 1, engine->scene.view, engine->hold);
}

// Returns "" or what the picture was found to cost, once.
EMSCRIPTEN_KEEPALIVE const char* snell_draw(Engine* engine, double time, int width, int height, double split,
                                            double mouse_x, double mouse_y) {
    if (!engine->draws()) return engine->say("");
    engine->drawing.draw(engine->scene, {time, width, height, split, mouse_x, mouse_y});
    Document& document = *engine->scene.document();
    const Diagnostics costs = document.runtime->take_costs();
    return costs.empty() ? engine->say("") : engine->tell(problems_json(costs, document.sources));
}

EMSCRIPTEN_KEEPALIVE int snell_settle(Engine* engine, double time, int width, int height, double split, double mouse_x,
                                      double mouse_y) {
    return engine->draws() && engine->drawing.settle(engine->scene, {time, width, height, split, mouse_x, mouse_y});
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

// A picture of another scene, as it is written, without a trace in the one that is shown. Returns "" or why there is
// none; snell_bytes has it.
EMSCRIPTEN_KEEPALIVE const char* snell_preview(Engine* engine, const char* path, int width, int height) {
    if (!engine->drawing.ready()) return engine->say("there are no graphics");
    OpenScene scene;
    const Reading reading = scene.open(path, {}, engine->drawing.caps());
    const Diagnostics& found = reading.shown ? scene.document()->diagnostics : reading.refused->diagnostics;
    std::string error;
    if (const Diagnostic* const first = first_error(found)) error = first->message;
    if (error.empty() && lint::may_not_end(found)) error = "it has loops that may not end";
    if (error.empty()) engine->bytes = engine->drawing.picture(scene, {0, width, height, 1, 0, 0}, 4, error);
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
    if (!engine->draws()) return engine->tell(json);
    const Saved saved = saved_values(*engine->scene.document());
    json["error"] = saved.error;
    for (const SavedFile& file : saved.files)
        json["files"].push_back({{"name", file.path}, {"bytes", characters(file.after)}});
    for (const Unwritten& value : saved.unwritten) json["unwritten"].push_back(value.name + ": " + value.reason);
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
