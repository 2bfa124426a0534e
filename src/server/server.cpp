#include "src/server/server.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include "parser/text/ranges.h"
#include "src/content/text_forms.h"

namespace snell::server {

namespace {

std::string failure_text(const Json& id, int code, const std::string& message) {
    return text_of({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}});
}

bool is_id(const Json& json) { return json.is_string() || json.is_number(); }

const Json& member(const Json& json, const char* key) {
    static const Json nothing;
    if (!json.is_object()) return nothing;
    const auto found = json.find(key);
    return found == json.end() ? nothing : *found;
}

// Values are copied and printed by functions that call themselves.
bool too_deep(std::string_view json) {
    constexpr int deepest = 100;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size() && depth <= deepest; ++i) {
        const char c = json[i];
        if (quoted && c == '\\') ++i;
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    }
    return depth > deepest;
}

// Replaces halves of characters of UTF-16, such as "\ud83d" without the other half, by U+FFFD: editors write them to
// files so. Returns whether there were any.
bool mend_halves(std::string& json) {
    const auto unit = [&](std::size_t at) {
        unsigned value = 0;
        if (json.compare(at, 2, "\\u") != 0 || at + 6 > json.size()) return 0u;
        const char* const end = json.data() + at + 6;
        return std::from_chars(json.data() + at + 2, end, value, 16).ptr == end ? value : 0u;
    };
    bool any = false;
    for (std::size_t at = json.find('\\'); at != json.npos; at = json.find('\\', at)) {
        const unsigned first = unit(at) & 0xFC00, second = first == 0xD800 ? unit(at + 6) & 0xFC00 : 0;
        const bool half = first == 0xDC00 || (first == 0xD800 && second != 0xDC00);
        if (half) json.replace(at + 2, 4, "fffd");
        any = any || half;
        at += first == 0xD800 && !half ? 12 : 2;
    }
    return any;
}

// The members of a broken message that stand in it all the same: "id" and "method" of the outermost object, and "uri".
Json salvaged(std::string_view json) {
    Json found = Json::object();
    constexpr std::string_view blanks = " \t\r\n";
    int depth = 0;
    std::string_view key;  // before the value that begins
    for (std::size_t at = 0; at < json.size();) {
        const char c = json[at];
        std::size_t end = at + 1;
        if (c == '"') {
            while (end < json.size() && json[end] != '"') end += json[end] == '\\' ? 2 : 1;
            end = std::min(end + 1, json.size());
        } else if (blanks.find(c) == blanks.npos && std::string_view("{}[]:,").find(c) == std::string_view::npos) {
            end = std::min(json.find_first_of("{}[]:,\" \t\r\n", at), json.size());
        }
        const std::string_view word = json.substr(at, end - at);
        const std::size_t next = std::min(json.find_first_not_of(blanks, end), json.size());
        if (c == '"' && json.substr(next, 1) == ":") {
            key = word;
            end = next + 1;
        } else if (blanks.find(c) == blanks.npos) {
            const bool wanted = (depth == 1 && (key == "\"id\"" || key == "\"method\"")) || key == "\"uri\"";
            if (Json value = wanted ? content::parse_json(word) : Json(); value.is_string() || value.is_number())
                found.emplace(key.substr(1, key.size() - 2), std::move(value));
            depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
            key = {};
        }
        at = end;
    }
    return found;
}

std::string method_of(const Json& message) {
    const Json& method = member(message, "method");
    return method.is_string() ? method.get<std::string>() : "";
}

// Whether the notification may have changed a text; all may, whose method is not known.
bool changes_texts(const std::string& method) { return method.empty() || method.starts_with("textDocument/did"); }

// The text that the notification is about; nullopt: it is not known.
std::optional<std::string> changed_uri(const State& state, const Json& uri) {
    if (!uri.is_string() || !state.documents.all().contains(uri.get<std::string>())) return std::nullopt;
    return uri.get<std::string>();
}

}  // namespace

void Session::receive(Arrived arrived) {
    if (!arrived.wrong.empty()) return queue_.push_back({{}, std::move(arrived.wrong)});
    const bool halves = mend_halves(arrived.body);
    if (too_deep(arrived.body)) return queue_.push_back({salvaged(arrived.body), "the message is nested too deeply"});
    Json message = content::parse_json(arrived.body);
    if (message.is_discarded()) return queue_.push_back({salvaged(arrived.body), "the message is not JSON"});
    if (method_of(message) != "$/cancelRequest") return queue_.push_back({std::move(message), {}, false, halves});
    const Json& id = member(member(message, "params"), "id");
    for (Waiting& waiting : queue_)
        if (is_id(id) && member(waiting.message, "id") == id && !method_of(waiting.message).empty())
            waiting.cancelled = true;
}

void Session::step() {
    const Waiting first = std::move(queue_.front());
    queue_.pop_front();
    if (!first.broken.empty()) return refuse(first);
    const Json& message = first.message;
    state_.halves = first.halves;
    if (const auto reply = message.is_array() ? answer_all(message) : answer(message, first.cancelled))
        state_.send(*reply);
}

void Session::refuse(const Waiting& broken) {
    const Json& id = member(broken.message, "id");
    const std::string method = method_of(broken.message);
    const bool request = !id.is_null() && !method.empty();
    state_.send(failure_text(request ? id : Json(), Failure::parse_error, broken.broken));
    if (!request && changes_texts(method))
        lose(state_, changed_uri(state_, member(broken.message, "uri")), broken.broken);
}

std::optional<std::string> Session::answer_all(const Json& batch) {
    if (batch.empty()) return failure_text({}, Failure::invalid_request, "the batch is empty");
    std::string replies;
    for (const Json& message : batch)
        if (const auto reply = answer(message, false)) replies += (replies.empty() ? "" : ",") + *reply;
    return replies.empty() ? std::nullopt : std::optional("[" + replies + "]");
}

std::optional<std::string> Session::answer(const Json& message, bool cancelled) {
    const Json& id = member(message, "id");
    const std::string method = method_of(message);
    if (method.empty()) {
        const bool reply = message.is_object() && (message.contains("result") || message.contains("error"));
        if (reply) return std::nullopt;  // to what the server asked
        return failure_text(is_id(id) ? id : Json(), Failure::invalid_request, "the message is no request");
    }
    const bool request = message.contains("id");
    const auto wrong = [&](int code, const std::string& why) {
        if (request) return std::optional(failure_text(id, code, why));
        if (changes_texts(method))
            lose(state_, changed_uri(state_, member(member(member(message, "params"), "textDocument"), "uri")), why);
        return std::optional<std::string>();
    };
    try {
        const Json& params = member(message, "params");
        if (!request) {
            heed(method, params);
            return std::nullopt;
        }
        if (cancelled) throw Failure{Failure::cancelled, "the request was cancelled"};
        if (outdated(method, params)) throw Failure{Failure::content_modified, "the text has been changed since"};
        return fmt::format(R"({{"jsonrpc":"2.0","id":{},"result":{}}})", text_of(id), result_of(method, params));
    } catch (const Failure& failure) {
        return request ? std::optional(failure_text(id, failure.code, failure.message)) : std::nullopt;
    } catch (const Json::exception&) {
        return wrong(Failure::invalid_params, fmt::format("the parameters of '{}' have another form", method));
    } catch (const std::exception& error) {
        return wrong(Failure::internal_error, error.what());
    }
}

// An answer about a text that the editor has already changed would be about the wrong one.
bool Session::outdated(const std::string& method, const Json& params) const {
    if (!method.starts_with("textDocument/")) return false;
    const Json& uri = member(member(params, "textDocument"), "uri");
    return ranges::any_of(queue_, [&](const Waiting& later) {
        return method_of(later.message) == "textDocument/didChange" &&
               member(member(member(later.message, "params"), "textDocument"), "uri") == uri;
    });
}

Json Session::initialize(const Json& params) {
    if (life_ != Life::fresh) throw Failure{Failure::invalid_request, "the server is initialized already"};
    if (!params.is_object()) throw Failure{Failure::invalid_params, "initialize has no params"};
    state_.client = member(params, "capabilities");
    if (member(member(params, "initializationOptions"), "driver") == false) state_.services.driver = nullptr;
    const Json& encodings = member(member(state_.client, "general"), "positionEncodings");
    state_.encoding = chosen_encoding(encodings);
    if (const Json& editor = member(params, "processId"); editor.is_number_integer()) editor_ = editor.get<pid_t>();
    life_ = Life::running;
    return {{"capabilities", capabilities(state_.encoding)},
            {"serverInfo", {{"name", "snell"}, {"version", state_.services.version}}}};
}

bool Session::editor_is_gone() const { return editor_ > 0 && kill(editor_, 0) != 0 && errno == ESRCH; }

std::string Session::result_of(const std::string& method, const Json& params) {
    if (method == "initialize") return text_of(initialize(params));
    if (life_ == Life::fresh) throw Failure{Failure::not_initialized, "the server is not initialized"};
    if (life_ == Life::shut) throw Failure{Failure::invalid_request, "the server is shut down"};
    if (method == "shutdown") {
        life_ = Life::shut;
        return "null";
    }
    if (auto result = feature(state_, method, params)) return std::move(*result);
    throw Failure{Failure::method_not_found, fmt::format("there is no method '{}'", method)};
}

void Session::heed(const std::string& method, const Json& params) {
    if (method == "exit")
        over_ = status_at_end();
    else if (life_ == Life::running)
        notice(state_, method, params);
}

Encoding chosen_encoding(const Json& offered) {
    if (offered.is_array() && std::find(offered.begin(), offered.end(), "utf-8") != offered.end())
        return Encoding::utf8;
    return Encoding::utf16;
}

Json capabilities(Encoding encoding) {
    return {{"positionEncoding", encoding == Encoding::utf8 ? "utf-8" : "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", {{"includeText", true}}}}},
            {"codeActionProvider", {{"codeActionKinds", Json::array({"quickfix"})}}},
            {"completionProvider", {{"triggerCharacters", {".", "<", "\"", "/", "#", "{"}}}},
            {"hoverProvider", true},
            {"signatureHelpProvider", {{"triggerCharacters", {"(", ",", " "}}}},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"documentHighlightProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"documentSymbolProvider", true},
            {"colorProvider", true},
            {"documentFormattingProvider", true},
            {"documentRangeFormattingProvider", true}};
}

Json watched_files() {
    return {{"registrations",
             {{{"id", "files"},
               {"method", "workspace/didChangeWatchedFiles"},
               {"registerOptions", {{"watchers", {{{"globPattern", "**/*"}}}}}}}}}};
}

namespace {

class Server {
public:
    Server(Services services, int in, int out)
        : in_(in), session_(std::move(services), [this, out](const std::string& message) {
              if (!content::write_all(out, framed(message)).empty()) ended_ = true;
          }) {}

    int run() {
        while (!ended_ && !session_.over() && !session_.editor_is_gone()) {
            wait();
            // What has arrived meanwhile may cancel what waits.
            while (!session_.idle() && !session_.over()) {
                session_.step();
                read_what_is_there();
            }
            checks_.go_on();
        }
        return session_.over().value_or(session_.status_at_end());
    }

private:
    // Until a message, a result or a deadline.
    void wait() {
        const auto due = checks_.due();
        int most = 3'000;  // nothing else tells that the editor is gone
        if (due != Clock::time_point::max()) {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(due - Clock::now()).count();
            most = static_cast<int>(std::clamp<std::int64_t>(left, 0, most));
        }
        std::array<pollfd, 2> ends{{{in_, POLLIN, 0}, {checks_.descriptor(), POLLIN, 0}}};
        ::poll(ends.data(), ends.size(), most);
        if (ends[0].revents != 0) read_some();
    }

    void read_what_is_there() {
        pollfd end{in_, POLLIN, 0};
        while (!ended_ && ::poll(&end, 1, 0) > 0) read_some();
    }

    void read_some() {
        const ssize_t got = read(in_, bytes_.data(), bytes_.size());
        if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) ended_ = true;
        if (got > 0) inbox_.feed({bytes_.data(), static_cast<std::size_t>(got)});
        while (!inbox_.empty()) session_.receive(inbox_.take());
    }

    int in_;
    bool ended_ = false;
    Inbox inbox_;
    std::array<char, 1 << 16> bytes_{};
    Session session_;
    Checks checks_{session_.state()};
};

}  // namespace

int serve(Services services, int in, int out) {
    std::signal(SIGPIPE, SIG_IGN);  // an editor that is gone is seen when writing fails
    return Server(std::move(services), in, out).run();
}

}  // namespace snell::server
