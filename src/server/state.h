// What the server knows between two messages.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/plan/files.h"
#include "src/server/documents.h"
#include "src/server/wire/messages.h"

namespace snell::server {

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
