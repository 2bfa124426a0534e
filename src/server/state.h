// What the server knows between two messages.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/language/project.h"
#include "src/plan/files.h"
#include "src/server/wire/messages.h"

namespace snell::server {

// The texts that an editor has open, the scenes that they belong to, as they were read last, and what was said of them.

struct Document {
    std::string uri;   // as the editor writes it
    std::string path;  // on disk; of a text that was never written, its URI
    std::string language;
    std::int64_t version = 0;
    std::string text;
    // Somewhere in the text is half a character of UTF-16, read as U+FFFD. Two halves that come together would be one.
    bool halves = false;
    bool lost = false;  // a change could not be read: the editor has another text

    bool is_scene() const;
};

struct Change {
    struct Range {
        Place begin, end;
    };
    std::optional<Range> range;  // nullopt: the whole text
    std::string text;
    bool halves = false;  // as Document::halves
};

// Applies the changes in order: each counts in the text that the one before has left. A whole text finds a document
// again that was lost.
void apply(Document& document, const std::vector<Change>& changes, Encoding encoding);

class Documents {
public:
    Document& open(Document document);
    void close(std::string_view uri);
    Document* find(std::string_view uri);
    const Document* with_path(std::string_view path) const;
    const std::map<std::string, Document, std::less<>>& all() const { return all_; }
    // A change of the text `uri` could not be read; nullopt: of any of them. Returns how many are lost that were not.
    int lose(const std::optional<std::string>& uri);
    // What is read instead of files: the texts that are not lost.
    Access access() const;

private:
    std::map<std::string, Document, std::less<>> all_;  // by URI
};

// The path without links and "..", if it exists; otherwise the path.
std::string real_path(const std::string& path);

using Clock = std::chrono::steady_clock;

// A scene, or a shader without one.
struct Scene {
    std::string path;
    bool alone = false;                        // a shader
    std::optional<language::Project> project;  // nullopt: it must be read again
    Json said = Json::array();                 // as published() has it
    bool check = true, driver = true;          // what is still to be done
    bool failed = false;                       // a check gave nothing since the texts changed
    Clock::time_point changed = Clock::now();
};

class Workspace {
public:
    explicit Workspace(const Documents& documents) : documents_(documents) {}

    // The scene of a text; a shader of several scenes is asked about in the one that was used last.
    Scene& scene_of(const Document& document);
    const language::Project& project_of(const Document& document);
    // Reads the scene if it has changed since.
    const language::Project& read(Scene& scene);
    // A text, or a file on disk, is another one now.
    void changed(const std::string& path);
    // Which files there are is another now: shaders may belong to other scenes.
    void rearranged();
    // Keeps the scenes of the texts that are open, and no others: the scenes among them, for shaders that those do not
    // have one on disk, and shaders without any scene alone. Which these are is a function of the texts and the files,
    // not of what was asked before.
    void arrange();
    // Whether arrange() has dropped a scene since this was asked last.
    bool dropped() { return std::exchange(dropped_, false); }

    std::list<Scene>& scenes() { return scenes_; }  // the one that was used last is last

private:
    Scene& open(const std::string& path, bool alone);
    bool has(Scene& scene, const Document& document);
    const std::string& scene_on_disk(const Document& document);

    const Documents& documents_;
    std::list<Scene> scenes_;
    std::map<std::string, std::string> found_;  // by the path of a shader: a scene on disk, "" if there is none
    bool arranged_ = false, dropped_ = false;
};

// What the server is given by the program around it.

struct Checked {
    Sources sources;
    Diagnostics diagnostics;
};

struct Services {
    // Returns the errors and warnings of a scene.
    using Checker = std::function<Checked(const std::string& scene, const Access& access)>;
    // A checker that asks the driver too; null if there is none. It is called in a process of its own.
    std::function<Checker()> driver = nullptr;
    // The URI of the page that explains a diagnostic's code; empty if it is not installed.
    std::function<std::string(std::string_view code)> page_of = nullptr;
    // The path of a file in docs/, such as "images/light-glass.jpg"; empty if it is not installed.
    std::function<std::string(std::string_view name)> doc_file = nullptr;
    std::string version;
};

// The answer to a request that failed. The codes are those of JSON-RPC and of the protocol.
struct Failure {
    enum Code {
        parse_error = -32700,
        invalid_request = -32600,
        method_not_found = -32601,
        invalid_params = -32602,
        internal_error = -32603,
        not_initialized = -32002,
        request_failed = -32803,
        content_modified = -32801,
        cancelled = -32800,
    };
    int code;
    std::string message;
};

struct State {
    Services services;
    std::function<void(const std::string& message)> send;
    Documents documents = {};
    Workspace workspace{documents};
    std::map<std::string, Json> published = {};  // by URI: what was said of it last
    Encoding encoding = Encoding::utf16;
    Json client = Json::object();  // the capabilities of the editor
    bool halves = false;           // the message that is answered has half a character of UTF-16 (Document::halves)
    int asked = 0;                 // how many requests the server sent to the editor

    State(Services given, std::function<void(const std::string&)> out)
        : services(std::move(given)), send(std::move(out)) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    // Whether the editor says that it can; `capability` is a path in JSON.
    bool can(const char* capability) const {
        const Json::json_pointer at(capability);
        return client.contains(at) && client[at] == true;
    }
    void notify(std::string_view method, Json params) {
        send(text_of({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}}));
    }
    void ask(std::string_view method, Json params) {
        send(text_of({{"jsonrpc", "2.0"},
                      {"id", "snell-" + std::to_string(++asked)},
                      {"method", method},
                      {"params", std::move(params)}}));
    }
    // Throws a Failure if the text is not open.
    Document& document(const Json& params) {
        const std::string uri = string_at(params.at("textDocument"), "uri");
        if (Document* found = documents.find(uri)) return *found;
        throw Failure{Failure::invalid_params, "'" + uri + "' is not open"};
    }
    // Throws one, too, if the editor has another text.
    Document& known_document(const Json& params) {
        Document& found = document(params);
        if (found.lost) throw lost(found);
        return found;
    }
    static Failure lost(const Document& document) {
        return {Failure::content_modified, "a change of '" + document.uri + "' could not be read"};
    }
};

}  // namespace snell::server
