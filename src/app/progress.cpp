#include "src/app/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "parser/utf8.h"

namespace snell {

namespace {

std::string_view doing(LoadProgress::Stage stage) {
    switch (stage) {
        case LoadProgress::Stage::programs:
            return "compiling programs";
        case LoadProgress::Stage::files:
            return "reading files";
        case LoadProgress::Stage::draws:
            return "making ready";
    }
    return "";
}

std::size_t columns_of_terminal() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

// Whole characters of at most so many bytes.
std::string_view begin_of(std::string_view text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) --bytes;
    return text.substr(0, bytes);
}

}  // namespace

std::string words(const LoadProgress& progress) {
    std::string text = fmt::format("{}: {} of {}", doing(progress.stage), progress.done, progress.of);
    if (!progress.what.empty()) text += fmt::format(" ({})", utf8::printable(progress.what));
    return text;
}

double share(const LoadProgress& progress) {
    return progress.of == 0 ? 1 : static_cast<double>(progress.done) / static_cast<double>(progress.of);
}

bool Patience::due(const LoadProgress& progress, Clock::time_point now) {
    if (begins(progress)) next_ = now + before;
    if (now < next_) return false;
    next_ = now + between;
    return true;
}

std::string progress_line(const LoadProgress& progress, std::size_t columns) {
    constexpr std::size_t bar = 20;
    const auto filled = static_cast<std::size_t>(std::lround(share(progress) * bar));
    const std::string line =
        fmt::format("snell [{}{}] {}", std::string(filled, '#'), std::string(bar - filled, '.'), words(progress));
    return std::string(begin_of(line, std::max<std::size_t>(columns, 1) - 1));
}

Watcher ProgressLine::watcher() {
    const char* kind = std::getenv("TERM");
    if (!isatty(STDERR_FILENO) || (kind && std::string_view(kind) == "dumb")) return nullptr;
    return [this](const LoadProgress& progress) { show(progress); };
}

void ProgressLine::show(const LoadProgress& progress) {
    if (Patience::ends(progress)) return clear();
    if (!patience_.due(progress)) return;
    std::string line = progress_line(progress, columns_of_terminal());
    if (line == shown_) return;
    fmt::print(stderr, "\r\x1b[K{}", line);
    std::fflush(stderr);
    shown_ = std::move(line);
}

void ProgressLine::clear() {
    if (!shown_.empty()) fmt::print(stderr, "\r\x1b[K");
    shown_.clear();
}

}  // namespace snell
