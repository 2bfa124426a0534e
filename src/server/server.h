// The life of a connection: messages in their order, and their answers.
// The language server: JSON-RPC through two file descriptors, until the editor is done.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include <sys/types.h>

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

}  // namespace snell::server
