#include "src/server/checks.h"

#include <map>
#include <utility>
#include <vector>

#include "parser/text/ranges.h"
#include "src/content/text_forms.h"
#include "src/server/actions.h"
#include "src/server/published.h"

namespace snell::server {

namespace {

using namespace std::chrono_literals;

constexpr auto typing_rest = 30ms, driver_rest = 300ms;
constexpr double most_seconds = 60;  // on a busy machine, too

Checked without_driver(const Scene& scene, const Access& access) {
    language::Project project =
        scene.alone ? language::read_shader(scene.path, access) : language::read_project(scene.path, access);
    return {std::move(project.sources), std::move(project.diagnostics)};
}

// The result is empty if there is no driver.
std::string checked(const State& state, const Scene& scene, bool driver) {
    const Access access = state.documents.access();
    Services::Checker with_driver = driver ? state.services.driver() : nullptr;
    if (driver && !with_driver) return {};
    const auto check = [&](const Access& with) {
        return driver ? with_driver(scene.path, with) : without_driver(scene, with);
    };
    Checked result = check(access);
    keep_good_fixes(result, access, check);
    return text_of(
        published(result.diagnostics, result.sources, scene.path, state.documents, state.services, state.encoding));
}

}  // namespace

Checks::Next Checks::next() const {
    Next first;
    for (Scene& scene : state_.workspace.scenes()) {
        const bool driver = !scene.check;
        if (driver && (!scene.driver || scene.alone || !state_.services.driver)) continue;
        const auto at = scene.changed + (driver ? driver_rest : typing_rest);
        // What needs no driver is done first, whatever is due.
        if (!first.scene || (first.driver && !driver) || (first.driver == driver && at < first.at))
            first = {&scene, driver, at};
    }
    return first;
}

Scene* Checks::current() const {
    auto& scenes = state_.workspace.scenes();
    const auto found = ranges::find(scenes, path_, &Scene::path);
    return found == scenes.end() ? nullptr : &*found;
}

Clock::time_point Checks::due() const { return background_.running() ? background_.deadline() : next().at; }

void Checks::go_on() {
    if (next().at <= Clock::now()) state_.workspace.arrange();
    if (state_.workspace.dropped()) publish();
    if (background_.running()) {
        const Scene* scene = current();
        const Next waiting = next();
        const bool preceded = driver_ && waiting.scene && !waiting.driver;
        if (!scene || scene->changed > began_ || preceded)
            background_.end();
        else if (const auto ended = background_.poll())
            take(ended->status == 0 ? ended->output : "");
    }
    if (background_.running()) return;
    if (const Next waiting = next(); waiting.scene && waiting.at <= Clock::now()) begin(waiting);
}

void Checks::begin(const Next& next) {
    path_ = next.scene->path;
    driver_ = next.driver;
    began_ = Clock::now();
    const auto work = [&](std::string& result) {
        result = checked(state_, *next.scene, next.driver);
        return 0;
    };
    if (!background_.start(work, {.seconds = most_seconds, .background = true}).empty()) take("");
}

void Checks::take(const std::string& result) {
    Scene* scene = current();
    if (!scene) return;
    Json said = content::parse_json(result);
    // A check that gave nothing is tried once more: a busy machine may have had no process, memory or time for it.
    if (!said.is_array() && !std::exchange(scene->failed, true)) return;
    (driver_ ? scene->driver : scene->check) = false;
    if (!said.is_array() && driver_) return;
    if (!said.is_array()) said = Json::array();  // what is not known is not said
    scene->said = std::move(said);
    publish();
}

namespace {

// Adds what another scene says of the same text. A fix is offered if all scenes that report the problem have it.
void add_said(Json& all, const Json& more) {
    for (const Json& one : more) {
        const auto same = [&](const Json& other) {
            return other.at("range") == one.at("range") && other.at("code") == one.at("code") &&
                   other.at("message") == one.at("message");
        };
        const auto known = ranges::find_if(all, same);
        if (known == all.end())
            all.push_back(one);
        else if (!one.contains("data"))
            known->erase("data");
    }
}

}  // namespace

// All that the scenes of a text say of it, in an order of their own: which one was asked about last does not matter.
void Checks::publish() {
    std::vector<const Scene*> scenes;
    for (const Scene& scene : state_.workspace.scenes()) scenes.push_back(&scene);
    ranges::sort(scenes, {}, &Scene::path);
    std::map<std::string, Json> now;  // by URI; null: it is checked again
    for (const Scene* scene : scenes)
        for (const Json& file : scene->said) {
            const std::string uri = string_at(file, "uri");
            const Document* document = state_.documents.find(uri);
            Json& all = now[uri];
            if (document && document->lost)  // what is said is of the file
                all = {{"uri", uri}, {"diagnostics", Json::array()}};
            else if (document && file.value("version", document->version - 1) != document->version)
                continue;
            else if (all.is_null()) {
                all = file;
                if (!document) all.erase("version");
            } else {
                add_said(all.at("diagnostics"), file.at("diagnostics"));
            }
        }
    auto& published = state_.published;
    for (auto& [uri, file] : now) {
        const auto before = published.find(uri);
        const bool known = before != published.end();
        if (file.is_null() || (known && before->second == file)) continue;
        if (!known && file.at("diagnostics").empty() && !state_.documents.find(uri)) continue;
        state_.notify("textDocument/publishDiagnostics", file);
        published.insert_or_assign(uri, file);
    }
    for (auto before = published.begin(); before != published.end();) {
        if (now.contains(before->first)) {
            ++before;
            continue;
        }
        state_.notify("textDocument/publishDiagnostics", {{"uri", before->first}, {"diagnostics", Json::array()}});
        before = published.erase(before);
    }
}

}  // namespace snell::server
