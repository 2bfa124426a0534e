// The life of a connection: messages in their order, and their answers.
// The language server: JSON-RPC through two file descriptors, until the editor is done.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>

#include <sys/types.h>

#include "parser/text/diagnostic.h"
#include "src/content/process.h"
#include "src/server/state.h"
#include "src/server/wire/messages.h"

namespace snell::server {

class Session {
public:
    Session(Services services, std::function<void(const std::string&)> send)
        : state_(std::move(services), std::move(send)) {}

    // Takes a message; nothing is answered before step().
    void receive(Arrived arrived);
    bool idle() const { return queue_.empty(); }
    // Answers the message that came first.
    void step();

    // The exit status once the editor is done.
    std::optional<int> over() const { return over_; }
    // The process that the editor named has ended, whoever holds its end of the pipe.
    bool editor_is_gone() const;
    int status_at_end() const { return life_ == Life::shut ? 0 : 1; }
    State& state() { return state_; }

private:
    enum class Life { fresh, running, shut };

    struct Waiting {
        Json message;
        std::string broken;      // why there is no message; `message` has what could be read of it
        bool cancelled = false;  // by the editor
        bool halves = false;     // as State::halves
    };

    void refuse(const Waiting& broken);
    // Answers are texts: large ones are written directly.
    std::optional<std::string> answer(const Json& message, bool cancelled);
    std::optional<std::string> answer_all(const Json& batch);
    std::string result_of(const std::string& method, const Json& params);
    void heed(const std::string& method, const Json& params);
    Json initialize(const Json& params);
    bool outdated(const std::string& method, const Json& params) const;

    State state_;
    std::deque<Waiting> queue_;
    Life life_ = Life::fresh;
    std::optional<int> over_;
    pid_t editor_ = 0;  // 0: it did not say
};

// What the server says of itself when a connection begins.

// UTF-8 if the editor offers it, which costs nothing; otherwise UTF-16, which every editor knows.
Encoding chosen_encoding(const Json& offered);
Json capabilities(Encoding encoding);
// For client/registerCapability: files whose changes the editor shall report.
Json watched_files();

// Returns the exit status that the protocol asks for: 0 after "shutdown" and "exit", otherwise 1.
int serve(Services services, int in, int out);

// Requests and notices about texts.

// Returns the result as JSON, nullopt if there is no such method. Throws a Failure, or nlohmann's exceptions for params
// of a wrong shape.
std::optional<std::string> feature(State& state, const std::string& method, const Json& params);

// Notifications: the texts that are open, and what changes on disk.

// What may have changed the text `uri`, or any text, could not be read: the user is told, and nothing is said of such a
// text, or answered about it, until the editor sends it whole.
void lose(State& state, const std::optional<std::string>& uri, const std::string& why);
// Unknown ones are passed over.
void notice(State& state, const std::string& method, const Json& params);

// The actions for those of `diagnostics`, as they were published, that touch the range of a textDocument/codeAction
// request.
Json code_actions(const Json& diagnostics, const Json& params);

// Fixes are tried before they are offered.

// Takes the fixes away that do not make their diagnostic go, or that bring a new one as severe, by what `check` says of
// the texts with the fix. Fixes for which there was no time are taken away too.
void keep_good_fixes(Checked& checked, const Access& access, const std::function<Checked(const Access&)>& check);

// Diagnostics of the open scenes, in the background: first those that need no driver, after a rest the driver's too.
// Editors take them file by file.

class Checks {
public:
    explicit Checks(State& state) : state_(state) {}

    // Ends what has become needless, takes what is done, and begins what is due.
    void go_on();
    int descriptor() const { return background_.descriptor(); }
    // When go_on() has something to do, if nothing happens before.
    Clock::time_point due() const;

private:
    struct Next {
        Scene* scene = nullptr;
        bool driver = false;
        Clock::time_point at = Clock::time_point::max();
    };
    Next next() const;
    Scene* current() const;
    void begin(const Next& next);
    void take(const std::string& result);
    void publish();

    State& state_;
    content::Process background_;
    std::string path_;  // of the scene that is being checked
    bool driver_ = false;
    Clock::time_point began_;
};

// An array of {uri, version, diagnostics}, one for each file of the sources; texts that are open have a version. What
// has no place is said of the beginning of `scene`.
Json published(const Diagnostics& diagnostics, const Sources& sources, const std::string& scene,
               const Documents& documents, const Services& services, Encoding encoding);

}  // namespace snell::server
