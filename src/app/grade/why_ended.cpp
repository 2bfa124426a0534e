#include "src/app/grade/why_ended.h"

#include <fmt/format.h>
#include <signal.h>

#include <cstring>
#include <string_view>

#include "parser/text/utf8.h"
#include "src/app/open/exit_status.h"

namespace snell::app {

namespace {

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

std::string why_ended(const EndedProcess& ended, double timeout, double gigabytes) {
    if (ended.too_long || ended.status == exit_timeout)
        return fmt::format("it takes longer than {} seconds{}", timeout, said(ended));
    if (out_of_memory(ended))
        return gigabytes > 0 ? fmt::format("it takes more than {} GB of memory", gigabytes)
                             : "it takes more memory than there is";
    if (ended.signal != 0) {
        // Drivers abort where they get no memory.
        const std::string limit =
            ended.signal == SIGABRT && gigabytes > 0
                ? fmt::format("; the cause may be the limit of {} GB of memory, which --memory changes", gigabytes)
                : "";
        return fmt::format("it ends the program that draws it, twice, by signal {} ({}){}", ended.signal,
                           strsignal(ended.signal), limit);
    }
    return ended.status == exit_fine ? "" : fmt::format("it ends the program that draws it{}", said(ended));
}

}  // namespace snell::app
