// The life of a connection: messages in their order, and their answers.
#pragma once

#include <sys/types.h>

#include <deque>
#include <optional>
#include <string>

#include "src/server/state.h"
#include "src/server/wire/inbox.h"

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

}  // namespace snell::server
