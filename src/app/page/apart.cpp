#include "src/app/page/apart.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>

#include "src/content/pipes.h"

namespace snell::app {

Apart apart(const std::function<int(std::string& result)>& work) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return {};
    std::fflush(nullptr);  // otherwise both processes would write what is buffered
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        std::string result;
        const int status = work(result);
        content::write_all(ends[1], result);
        std::fflush(nullptr);
        _exit(status);
    }
    close(ends[1]);
    Apart ended;
    if (child > 0) ended.result = content::read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    if (child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status)) ended.status = WEXITSTATUS(status);
    return ended;
}

}  // namespace snell::app
