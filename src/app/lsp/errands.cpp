#include "src/app/lsp/errands.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "parser/text/utf8.h"
#include "src/app/desktop/named_by.h"
#include "src/app/open/exit_status.h"
#include "src/content/json.h"
#include "src/content/pipes.h"

extern char** environ;

namespace snell::app {

namespace {

using Json = nlohmann::ordered_json;

// Starts snell with these arguments, its output in `out` and its messages in `err`. Returns 0 or the error.
int spawn(pid_t& process, std::vector<std::string> arguments, int out, int err, short flags) {
    std::string program = "/proc/self/exe";
    std::vector<char*> words{program.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, flags);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, err, STDERR_FILENO);
    const int error = posix_spawn(&process, program.c_str(), &files, &how, words.data(), environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

struct Said {
    int status = -1;
    std::string output;
};

// With `messages`, also what is said of errors.
Said said_by(const std::vector<std::string>& arguments, bool messages) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return {};
    pid_t process = 0;
    const int error = spawn(process, arguments, ends[1], messages ? ends[1] : STDERR_FILENO, 0);
    close(ends[1]);
    Said said;
    if (error == 0) {
        said.output = content::read_all(ends[0]);
        int status = 0;
        while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        if (WIFEXITED(status)) said.status = WEXITSTATUS(status);
    }
    close(ends[0]);
    return said;
}

// The texts that are open, in a file without a name that the processes inherit.
class OpenTexts {
public:
    explicit OpenTexts(const Access& access) : file_(memfd_create("texts", 0)) {
        if (file_ < 0) return;
        Json texts = Json::object();
        if (access.instead)
            for (const auto& [path, text] : *access.instead) texts[path] = text;
        content::write_all(file_, content::json_text(texts));
    }
    ~OpenTexts() {
        if (file_ >= 0) close(file_);
    }
    OpenTexts(const OpenTexts&) = delete;
    OpenTexts& operator=(const OpenTexts&) = delete;

    // "" or why there is no such file.
    std::string error() const { return file_ < 0 ? "its texts could not be handed over" : ""; }
    std::string option() const { return fmt::format("--instead=/proc/self/fd/{}", file_); }

private:
    int file_;
};

// A window's process, and what it says of errors, in a file without a name.
class WindowProcess {
public:
    WindowProcess(std::string scene, const OpenTexts& texts)
        : scene_(std::move(scene)), messages_(memfd_create("messages", MFD_CLOEXEC)) {
        if (messages_ < 0) wrong_ = std::strerror(errno);
        if (wrong_.empty()) wrong_ = texts.error();
        if (!wrong_.empty()) return;
        const int error = spawn(process_, {texts.option(), "--", scene_}, messages_, messages_, POSIX_SPAWN_SETSID);
        if (error != 0) wrong_ = std::strerror(error);
    }
    ~WindowProcess() {
        if (messages_ >= 0) close(messages_);
    }
    WindowProcess(const WindowProcess&) = delete;
    WindowProcess& operator=(const WindowProcess&) = delete;

    // As server::Window.
    std::optional<std::string> look() {
        if (!wrong_.empty()) return failure(wrong_);
        int status = 0;
        const pid_t ended = waitpid(process_, &status, WNOHANG);
        pass_on();
        if (ended == 0) return std::nullopt;
        if (WIFSIGNALED(status)) return failure(fmt::format("signal {} ended it", WTERMSIG(status)));
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begun_;
        const std::string why = failure_of_window(WEXITSTATUS(status), seconds.count(), said_);
        return why.empty() ? why : failure(why);
    }

private:
    std::string failure(const std::string& why) const {
        return fmt::format("The window of {} failed: {}",
                           utf8::printable(std::filesystem::path(scene_).filename().string()), why);
    }

    // To the editor's log. What was read is removed from the file, and only its end is kept here.
    void pass_on() {
        constexpr std::size_t most = 1 << 14;
        std::array<char, 1 << 12> some{};
        for (;;) {
            const ssize_t got = pread(messages_, some.data(), some.size(), read_);
            if (got <= 0) return;
            const std::string_view part(some.data(), static_cast<std::size_t>(got));
            content::write_all(STDERR_FILENO, part);
            said_ += part;
            if (said_.size() > 2 * most) said_.erase(0, said_.size() - most);
            read_ += got;
            fallocate(messages_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, 0, read_);
        }
    }

    std::string scene_, said_, wrong_;
    int messages_;
    off_t read_ = 0;  // bytes of the messages
    pid_t process_ = 0;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

server::Outcome failed(std::string message) { return {{}, std::move(message), true}; }

// A folder of this user for pictures; empty if there is none. Others could have made one of that name.
std::string pictures_folder() {
    std::error_code none;
    const std::string folder =
        (std::filesystem::temp_directory_path(none) / fmt::format("snell-{}", getuid())).string();
    mkdir(folder.c_str(), 0700);
    struct stat status {};
    const bool own = lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == getuid();
    return own && chmod(folder.c_str(), 0700) == 0 ? folder : std::string();
}

server::Outcome render(const std::string& scene, const OpenTexts& texts) {
    const std::string folder = pictures_folder();
    if (folder.empty()) return failed("The scene was not drawn: there is no folder for its picture.");
    const std::string picture = named_by(folder, scene, "png");
    const Said said = said_by({"render", scene, "-o", picture, "--color", "never", texts.option()}, true);
    if (said.status == 0) return {picture, "The picture is in " + picture, false};
    const std::size_t at = said.output.find("error: ");
    const std::string line = at == said.output.npos ? "" : said.output.substr(at, said.output.find('\n', at) - at);
    return failed("The scene was not drawn" + (line.empty() ? std::string() : ": " + utf8::printable(line)));
}

std::string milliseconds(const Json& frame) {
    if (!frame.is_object()) return {};
    for (const char* clock : {"gpu_ms", "wall_ms", "cpu_ms"})
        if (frame.contains(clock) && frame[clock].is_number())
            return fmt::format("{:.2f} ms", frame[clock].get<double>());
    return {};
}

std::string bytes_text(const Json& bytes) {
    const double value = bytes.is_number() ? bytes.get<double>() : 0;
    return value > 0 ? fmt::format("{:.1f} kB", value / 1e3) : "";
}

// One sentence for each thing that is paid at the line, or for the frame.
std::string costs(const Json& report, int line) {
    std::string text;
    for (const Json& paid : report.value("pays", Json::array())) {
        const Json at = paid.value("at", Json());
        if (line >= 0 && !(at.is_object() && at.value("line", 0) == line + 1)) continue;
        if (line < 0 && paid.value("kind", "") != "pass") continue;
        std::string parts;
        const std::string time = milliseconds(paid.value("frame", Json()));
        for (const std::string& part :
             {time.empty() ? time : time + " of each frame", bytes_text(paid.value("bytes", Json())),
              paid.contains("triangles") ? fmt::format("{} triangles", paid["triangles"].dump()) : std::string()})
            if (!part.empty()) parts += (parts.empty() ? "" : ", ") + part;
        text += fmt::format("{} {}: {}. ", paid.value("kind", ""), paid.value("name", ""),
                            parts.empty() ? "less than can be measured" : parts);
    }
    if (line >= 0 && text.empty()) text = "This statement costs nothing by itself. ";
    const std::string frame = milliseconds(report.value("frame", Json()));
    return text + (frame.empty() ? "Frames were not timed." : fmt::format("A frame takes {}.", frame));
}

server::Outcome cost(const std::string& scene, int line, const OpenTexts& texts) {
    const Said said = said_by({"explain", scene, "--json", "--timeout", "6", "--reps", "7", texts.option()}, false);
    const Json report = content::parse_json(said.output);
    if (!report.is_object()) return failed("The scene was not drawn: its errors come first.");
    return {{}, costs(report, line), false};
}

}  // namespace

// Later, an error of the scene may be the last one printed, and the status that of a scene which cannot be read.
std::string failure_of_window(int status, double seconds, std::string_view printed) {
    constexpr double start = 5;
    constexpr std::string_view begin = "snell: error: ";
    const bool own = status == exit_usage || status == exit_graphics || status == exit_lost || seconds < start;
    const std::size_t at = printed.rfind(begin);
    if (status == exit_fine || !own || at == printed.npos) return "";
    const std::string_view rest = printed.substr(at + begin.size());
    return utf8::printable(rest.substr(0, rest.find('\n')));
}

server::Window open_window(const std::string& scene, const Access& access) {
    const auto window = std::make_shared<WindowProcess>(scene, OpenTexts(access));
    return [window] { return window->look(); };
}

server::Outcome run_errand(const server::Errand& errand, const Access& access) {
    const OpenTexts texts(access);
    if (const std::string wrong = texts.error(); !wrong.empty()) return failed("The scene was not drawn: " + wrong);
    return errand.kind == server::Errand::Kind::render ? render(errand.scene, texts)
                                                       : cost(errand.scene, errand.line, texts);
}

}  // namespace snell::app
