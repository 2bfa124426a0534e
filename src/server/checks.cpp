#include "src/server/checks.h"

#include <utility>

#include "parser/text/ranges.h"
#include "src/content/json.h"
#include "src/server/published.h"
#include "src/server/trial.h"

namespace snell::server {

namespace {

using namespace std::chrono_literals;

constexpr auto typing_rest = 30ms, driver_rest = 300ms;
constexpr auto most_time = 10s, most_driver_time = 30s;

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

Clock::time_point Checks::due() const { return background_.busy() ? background_.deadline() : next().at; }

void Checks::go_on() {
    // What was said of scenes that are closed is taken back.
    if (const std::size_t open = state_.workspace.scenes().size(); std::exchange(open_, open) > open) publish();
    if (background_.busy()) {
        const Scene* scene = current();
        const Next waiting = next();
        const bool preceded = driver_ && waiting.scene && !waiting.driver;
        if (!scene || scene->changed > began_ || preceded)
            background_.end();
        else if (const auto result = background_.poll())
            take(*result);
    }
    if (background_.busy()) return;
    if (const Next waiting = next(); waiting.scene && waiting.at <= Clock::now()) begin(waiting);
}

void Checks::begin(const Next& next) {
    path_ = next.scene->path;
    driver_ = next.driver;
    began_ = Clock::now();
    const auto work = [&] { return checked(state_, *next.scene, next.driver); };
    if (!background_.start(work, next.driver ? most_driver_time : most_time)) take("");
}

void Checks::take(const std::string& result) {
    Scene* scene = current();
    if (!scene) return;
    (driver_ ? scene->driver : scene->check) = false;
    Json said = content::parse_json(result);
    if (!said.is_array()) return;
    scene->said = std::move(said);
    publish();
}

// A text that several scenes have is said of as in the one that was used last.
void Checks::publish() {
    std::map<std::string, Json> now;
    for (const Scene& scene : state_.workspace.scenes())
        for (const Json& file : scene.said) now.insert_or_assign(string_at(file, "uri"), file);
    for (auto& [uri, file] : now) {
        const Document* document = state_.documents.find(uri);
        const auto version = file.find("version");
        if (document && (version == file.end() || *version != document->version)) continue;  // it is checked again
        if (!document && version != file.end()) file.erase("version");
        const auto before = sent_.find(uri);
        if (before == sent_.end() ? !document && file.at("diagnostics").empty() : before->second == file) continue;
        state_.notify("textDocument/publishDiagnostics", file);
        sent_.insert_or_assign(uri, file);
    }
    for (auto before = sent_.begin(); before != sent_.end();) {
        if (now.contains(before->first)) {
            ++before;
            continue;
        }
        state_.notify("textDocument/publishDiagnostics", {{"uri", before->first}, {"diagnostics", Json::array()}});
        before = sent_.erase(before);
    }
}

}  // namespace snell::server
