#include "src/app/open/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "parser/text/words.h"

namespace snell {

namespace {

std::string_view doing(LoadProgress::Stage stage) {
    constexpr std::array<std::string_view, 3> words{"compiling programs", "reading files", "making ready"};
    return words[static_cast<std::size_t>(stage)];
}

std::size_t columns_of_terminal() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

// Returns as many whole characters as fit into that number of bytes.
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

bool Patience::due(Clock::time_point now) {
    if (now < next_) return false;
    next_ = now + between;
    return true;
}

bool Patience::due(const LoadProgress& progress, Clock::time_point now) {
    if (begins(progress)) begin(now);
    return due(now);
}

std::string progress_line(std::string_view words, double share, std::size_t columns) {
    constexpr std::size_t bar = 20;
    const auto filled = static_cast<std::size_t>(std::lround(std::clamp(share, 0., 1.) * bar));
    const std::string line =
        fmt::format("snell [{}{}] {}", std::string(filled, '#'), std::string(bar - filled, '.'), words);
    return std::string(begin_of(line, std::max<std::size_t>(columns, 1) - 1));
}

std::string progress_line(const LoadProgress& progress, std::size_t columns) {
    return progress_line(words(progress), share(progress), columns);
}

bool ProgressLine::on_terminal() {
    const char* kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) && !(kind && std::string_view(kind) == "dumb");
}

Watcher ProgressLine::watcher() {
    if (!terminal_) return nullptr;
    return [this](const LoadProgress& progress) { show(progress); };
}

void ProgressLine::show(const LoadProgress& progress) {
    if (Patience::ends(progress)) return clear();
    if (patience_.due(progress)) print(progress_line(progress, columns_of_terminal()));
}

void ProgressLine::show(std::string_view words, double share) {
    if (terminal_ && patience_.due()) print(progress_line(words, share, columns_of_terminal()));
}

void ProgressLine::print(std::string line) {
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
