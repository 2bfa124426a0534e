#include "src/app/grade/processes.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include "parser/text/words.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/content/image/open_module.h"

namespace snell::app {

namespace {

struct Running {
    std::size_t index = 0;
    bool again = false;
    content::Process process;
};

// It writes no endless file, and draws on one core, because there is a process for each.
void settle_in() {
    const rlimit file{rlim_t{512} << 20, rlim_t{512} << 20}, core{0, 0};
    setrlimit(RLIMIT_FSIZE, &file);
    setrlimit(RLIMIT_CORE, &core);
    setenv("LP_NUM_THREADS", "0", 0);
}

// The first line of what it printed about itself.
std::string said(const EndedProcess& ended) {
    const std::size_t at = ended.output.find("snell: error: ");
    if (at == std::string::npos) return {};
    const std::string_view line = std::string_view(ended.output).substr(at + 14);
    return fmt::format(": {}", utf8::printable(line.substr(0, line.find('\n'))));
}

// What a submission prints may contain the mark, too: only a process that ends for want of memory has this status.
bool out_of_memory(const EndedProcess& ended) {
    return ended.status == exit_input && ended.output.find("[out-of-memory]") != std::string::npos;
}

}  // namespace

void run_apart(std::size_t count, const Apart& how, const std::function<int(std::size_t)>& work,
               const std::function<void(std::size_t, const EndedProcess&)>& done) {
    std::deque<std::pair<std::size_t, bool>> waiting;
    for (std::size_t i = 0; i < count; ++i) waiting.emplace_back(i, false);
    std::vector<Running> running;
    while (!waiting.empty() || !running.empty()) {
        if (how.stop && how.stop()) return;
        while (!waiting.empty() && running.size() < std::max<std::size_t>(how.at_once, 1)) {
            const auto [index, again] = waiting.front();
            waiting.pop_front();
            running.push_back({index, again, {}});
            const auto alone = [&work, k = index](std::string&) {
                settle_in();
                return status_of([&] { return work(k); });
            };
            content::open_image_module_as_copies_do();
            if (running.back().process.start(alone, how.limits).empty()) continue;
            running.pop_back();
            done(index, {});  // no process could be made
        }
        std::erase_if(running, [&](Running& one) {
            auto ended = one.process.poll();
            if (!ended) return false;
            if (ended->signal != 0 && !ended->too_long && !one.again)
                waiting.emplace_back(one.index, true);
            else
                done(one.index, {std::move(*ended), one.again});
            return true;
        });
        if (!running.empty()) usleep(2000);
    }
}

std::string why_ended(const EndedProcess& ended, double timeout, double gigabytes) {
    if (ended.too_long || ended.status == exit_timeout)
        return fmt::format("it takes longer than {} seconds{}", timeout, said(ended));
    if (out_of_memory(ended))
        return gigabytes > 0 ? fmt::format("it takes more than {:.3g} GB of memory", gigabytes)
                             : "it takes more memory than there is";
    if (ended.signal != 0) {
        // Drivers abort where they get no memory.
        const std::string limit =
            ended.signal == SIGABRT && gigabytes > 0
                ? fmt::format("; the cause may be the limit of {:.3g} GB of memory, which --memory changes", gigabytes)
                : "";
        return fmt::format("it ends the program that draws it, twice, by signal {} ({}){}", ended.signal,
                           strsignal(ended.signal), limit);
    }
    return ended.status == exit_fine ? "" : fmt::format("it ends the program that draws it{}", said(ended));
}

}  // namespace snell::app
