#include "src/server/server.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

#include "src/content/process.h"
#include "src/server/checks.h"
#include "src/server/session.h"

namespace snell::server {

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
