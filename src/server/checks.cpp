
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "parser/text/ranges.h"
#include "src/content/text_forms.h"
#include "src/lint/lint.h"
#include "src/server/server.h"

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

namespace {

// The codes that say that something could as well be left out.
bool unnecessary(std::string_view code) {
    using enum lint::Rule;
    constexpr std::array rules{never_read, program_not_drawn, slider_without_effect};
    return ranges::any_of(rules, [&](lint::Rule rule) { return lint::facts(rule).code == code; });
}

class Publisher {
public:
    Publisher(const Sources& sources, const std::string& scene, const Documents& documents, const Services& services,
              Encoding encoding)
        : sources_(sources), scene_(scene), documents_(documents), services_(services), encoding_(encoding) {}

    void add(const Diagnostic& diagnostic) {
        const Text* text = diagnostic.has_span ? text_at(diagnostic.span.file) : nullptr;
        Span span = diagnostic.span;
        if (!text) {
            text = text_named(scene_);
            span = {};
        }
        if (!text) return;
        Json json{{"range", range_json(text->lines, span, encoding_)},
                  {"severity", 3 - static_cast<int>(diagnostic.severity)},
                  {"code", diagnostic.code},
                  {"source", "snell"},
                  {"message", diagnostic.message}};
        if (!diagnostic.help.empty()) json["message"] = diagnostic.message + "\n" + diagnostic.help;
        if (unnecessary(diagnostic.code)) json["tags"] = Json::array({1});
        const std::string page = services_.page_of ? services_.page_of(diagnostic.code) : "";
        if (!page.empty()) json["codeDescription"] = {{"href", page}};
        add_related(json, diagnostic);
        add_fixes(json, diagnostic);
        found_[text->uri].push_back(std::move(json));
    }

    // Texts about which nothing is said are listed too: what was said of them before is no longer so.
    void list_all() {
        for (FileId file = 0; file < sources_.size(); ++file)
            if (const Text* text = text_at(file)) found_[text->uri];
    }

    Json take() {
        Json all = Json::array();
        for (auto& [uri, diagnostics] : found_) {
            Json file{{"uri", uri}};
            for (const auto& [name, text] : texts_)
                if (text.uri == uri && text.version) file["version"] = *text.version;
            file["diagnostics"] = std::move(diagnostics);
            all.push_back(std::move(file));
        }
        return all;
    }

private:
    struct Text {
        std::string uri;
        Lines lines;
        std::optional<std::int64_t> version;
    };

    // Null: it is no file of the user's.
    const Text* text_at(FileId file) {
        const std::string name(sources_.name(file));
        const auto known = texts_.find(name);
        if (known != texts_.end()) return &known->second;
        const Document* document = documents_.with_path(name);
        if (!document && !name.starts_with('/')) return nullptr;
        Text text{document ? document->uri : content::uri_of_path(real_path(name)), Lines(sources_.text(file)),
                  std::nullopt};
        if (document) text.version = document->version;
        return &texts_.emplace(name, std::move(text)).first->second;
    }

    const Text* text_named(const std::string& name) {
        for (FileId file = 0; file < sources_.size(); ++file)
            if (sources_.name(file) == name) return text_at(file);
        return nullptr;
    }

    void add_related(Json& json, const Diagnostic& diagnostic) {
        const auto add = [&](const Span& span, const std::string& message) {
            if (const Text* text = text_at(span.file))
                json["relatedInformation"].push_back(
                    {{"location", {{"uri", text->uri}, {"range", range_json(text->lines, span, encoding_)}}},
                     {"message", message}});
        };
        for (const Note& note : diagnostic.notes) add(note.span, note.message);
        for (const Span& span : diagnostic.also) add(span, "the same here");
    }

    // From which actions are made (actions.h).
    void add_fixes(Json& json, const Diagnostic& diagnostic) {
        for (const Fix& fix : diagnostic.fixes) {
            const Text* text = text_at(fix.span.file);
            if (!text) continue;
            const std::string_view all = sources_.text(fix.span.file);
            json["data"]["fixes"].push_back({{"uri", text->uri},
                                             {"version", text->version ? Json(*text->version) : Json()},
                                             {"range", range_json(text->lines, fix.span, encoding_)},
                                             {"old", all.substr(fix.span.begin, fix.span.end - fix.span.begin)},
                                             {"newText", fix.text}});
        }
    }

    const Sources& sources_;
    const std::string& scene_;
    const Documents& documents_;
    const Services& services_;
    Encoding encoding_;
    std::map<std::string, Text> texts_;           // by name of the source
    std::map<std::string, Json::array_t> found_;  // by URI
};

}  // namespace

Json published(const Diagnostics& diagnostics, const Sources& sources, const std::string& scene,
               const Documents& documents, const Services& services, Encoding encoding) {
    Publisher publisher(sources, scene, documents, services, encoding);
    publisher.list_all();
    for (const Diagnostic& diagnostic : diagnostics.items()) publisher.add(diagnostic);
    return publisher.take();
}

}  // namespace snell::server
