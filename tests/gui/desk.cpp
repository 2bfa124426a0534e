#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "tests/gui/desk.h"
#include "tests/gui/x11.h"
#include "tests/sanitized.h"
#include "tests/screens.h"

namespace snell::test {

namespace {

using Clock = std::chrono::steady_clock;

void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

bool installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::string folders = path ? path : "/usr/bin:/bin";
    for (std::size_t begin = 0; begin <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', begin), folders.size());
        if (access((folders.substr(begin, end - begin) + "/" + program).c_str(), X_OK) == 0) return true;
        begin = end + 1;
    }
    return false;
}

// Where the child's standard streams go, if not to nowhere.
struct Streams {
    int output = -1, errors = -1;
};

pid_t start(std::vector<std::string> words, const std::string& display, Streams to = {}) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    if (display.empty())
        unsetenv("DISPLAY");
    else
        setenv("DISPLAY", display.c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
    const int nowhere = ::open("/dev/null", O_RDWR);
    dup2(to.output >= 0 ? to.output : nowhere, STDOUT_FILENO);
    dup2(to.errors >= 0 ? to.errors : nowhere, STDERR_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

int finish(pid_t child) {
    int status = 0;
    if (waitpid(child, &status, 0) != child) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void end(pid_t& child) {
    if (child <= 0) return;
    kill(child, SIGTERM);
    finish(child);
    child = 0;
}

std::string read_all(int from) {
    std::string text;
    std::array<char, 65536> part{};
    for (ssize_t size = 0; (size = read(from, part.data(), part.size())) > 0;)
        text.append(part.data(), static_cast<std::size_t>(size));
    return text;
}

struct Server {
    pid_t process = 0;
    std::string display;
};

// The window of a suite, and what it remembers; the tests' scenes are in their own folders.
struct Shared {
    std::string display;
    std::vector<std::string> options;
    Scratch folder;
    pid_t window = 0;
};

std::unique_ptr<Shared>& shared() {
    static std::unique_ptr<Shared> window;
    return window;
}

constexpr std::array own_folders{"out", "state", "cache"};

// What windows started from now on remember from run to run is in there.
void remember_in(const Scratch& folder) {
    setenv("XDG_STATE_HOME", folder.path("state").c_str(), 1);
    setenv("XDG_CACHE_HOME", folder.path("cache").c_str(), 1);
}

// One display for all tests of its size, as long as each leaves it as it was: it takes a third of what a window takes.
class Servers {
public:
    static const Server& of(const std::string& screen) {
        static Servers all;
        Server& server = all.servers_[screen];
        if (shared()) return server;
        // The last window's connection may close a moment after its process.
        for (int look = 0; look < 20 && !server.display.empty(); ++look, sleep(.01))
            if (renew(server.display)) return server;
        end(server.process);
        return server = begin(screen);
    }

private:
    ~Servers() {
        for (auto& [screen, server] : servers_) end(server.process);
    }
    static Server begin(const std::string& screen) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) return {};
        // Without -noreset it goes away for a moment while a window is replaced by another one and nobody else is
        // there.
        Server server;
        server.process =
            start({"Xvfb", "-displayfd", "1", "-screen", "0", screen, "-noreset", "-nolisten", "tcp"}, "", {ends[1]});
        ::close(ends[1]);
        std::string number;
        for (char digit = 0; read(ends[0], &digit, 1) == 1 && digit != '\n';) number += digit;
        ::close(ends[0]);
        if (!number.empty()) server.display = ":" + number;
        return server;
    }

    std::map<std::string, Server> servers_;
};

std::string output_of(const std::vector<std::string>& words, const std::string& display) {
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = start(words, display, {ends[1]});
    ::close(ends[1]);
    std::string text = read_all(ends[0]);
    ::close(ends[0]);
    finish(child);
    return text;
}

// Seconds that its threads have waited for a processor.
double waited(pid_t process) {
    double nanoseconds = 0;
    std::error_code error;
    for (const auto& thread :
         std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task", error)) {
        double ran = 0, waiting = 0;
        std::ifstream(thread.path() / "schedstat") >> ran >> waiting;
        nanoseconds += waiting;
    }
    return nanoseconds * 1e-9;
}

// Over after so many seconds; those that the processes waited for a processor don't count, since machines are shared.
// Nor is it asked for before a tenth has passed: a process whose threads were looked at in /proc keeps its parent busy
// when it ends, on a busy machine for tens of milliseconds, and most waits are short.
class Deadline {
public:
    Deadline(double seconds, pid_t window, pid_t server)
        : seconds_(seconds * patience), window_(window), server_(server) {}
    bool over() {
        const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
        if (!before_ && passed > seconds_ / 10) before_ = waited(window_) + waited(server_);
        if (passed <= seconds_) return false;
        return passed > 10 * seconds_ || passed - std::max(0., waited(window_) + waited(server_) - *before_) > seconds_;
    }

private:
    double seconds_;
    pid_t window_, server_;
    Clock::time_point start_ = Clock::now();
    std::optional<double> before_;
};

Picture picture_of(const std::string& ppm) {
    Picture picture;
    int most = 0, begin = 0;
    if (std::sscanf(ppm.c_str(), "P6 %d %d %d%n", &picture.width, &picture.height, &most, &begin) != 3 || most != 255) {
        ADD_FAILURE() << "no picture";
        return {};
    }
    picture.rgb.assign(ppm.begin() + begin + 1, ppm.end());
    return picture;
}

std::string move(double x, double y) {
    return "mousemove " + std::to_string(static_cast<int>(x)) + " " + std::to_string(static_cast<int>(y));
}

// By its button: sanitizers look for leaks when a program ends by itself.
void close_window(pid_t& window, const std::string& display) {
    if (window <= 0) return;
    close_windows(display);
    int status = 0;
    pid_t ended = 0;
    for (int look = 0; look < 1000 && ended == 0; ++look) {
        ended = waitpid(window, &status, WNOHANG);
        if (ended == 0) sleep(.02);
    }
    EXPECT_NE(ended, 0) << "the window does not close";
    if (ended == window) {
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) != finding_status);
    }
    if (ended != 0) window = 0;
}

}  // namespace

Pixel Picture::at(double x, double y) const {
    const auto index =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    if (x < 0 || y < 0 || x >= width || index + 2 >= rgb.size()) return {-1, -1, -1};
    return {rgb[index], rgb[index + 1], rgb[index + 2]};
}

void Desk::SetUp() {
    for (const char* program : {"Xvfb", "xdotool", "import"})
        if (!installed(program)) GTEST_SKIP() << program << " is not installed";
    std::filesystem::create_directory(file("out"));
    // The driver's cache stays where it is: it takes time to fill.
    const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
    if (cache || home) setenv("MESA_SHADER_CACHE_DIR", cache ? cache : (std::string(home) + "/.cache").c_str(), 0);
    remember_in(folder_);
    connect();
}

void Desk::connect() {
    const Server& server = Servers::of(screen_);
    server_ = server.process;
    display_ = server.display;
    ASSERT_FALSE(display_.empty()) << "Xvfb does not start";
}

void Desk::TearDown() {
    if (HasFailure())
        for (const char* name : {"out/state.json", "out/errors"}) std::cerr << bytes(name) << '\n';
    if (shares_ && !HasFailure()) return;
    if (shares_) shared().reset();
    if (sanitized && !HasFailure()) close_window(window_, display_);
    end(window_);
}

void Desk::end_shared() {
    if (!shared()) return;
    if (sanitized) close_window(shared()->window, shared()->display);
    end(shared()->window);
    shared().reset();
}

void Desk::save(const std::string& name, const std::string& text, bool in_place) {
    const std::string target = file(name), fresh = in_place ? target : target + "~";
    std::ofstream(fresh) << text;
    if (!in_place) std::filesystem::rename(fresh, target);
}

void Desk::open(const std::string& scene, const std::vector<std::string>& more) {
    if (shared()) {
        end_shared();
        connect();
    }
    begin(scene, more);
}

void Desk::share(const std::string& scene, const std::vector<std::string>& more) {
    if (shared() && shared()->options != more) {
        end_shared();
        connect();
    }
    const bool there = shared() != nullptr;
    if (!there) {
        shared() = std::make_unique<Shared>(display_, more);
        for (const char* name : own_folders) std::filesystem::create_directory(shared()->folder.path(name));
    }
    for (const char* name : own_folders) {
        std::filesystem::remove(file(name));
        std::filesystem::create_directory_symlink(shared()->folder.path(name), file(name));
    }
    shares_ = true;
    if (there) {
        window_ = shared()->window;
        user("mousemove 512 384");
        ASSERT_TRUE(drop_files(display_, {file(scene)}));
        ASSERT_TRUE(wait([&](const auto& s) { return s["file"] == file(scene); }));
        settle();
        return;
    }
    remember_in(shared()->folder);
    begin(scene, more);
    shared()->window = window_;
    remember_in(folder_);
}

void Desk::begin(const std::string& scene, std::vector<std::string> more) {
    // A window that is shared outlives the test's folder, and the link there.
    const std::string told = std::filesystem::canonical(file("out")) / "state.json";
    std::vector<std::string> words{SNELL_BIN "/snell", "--state", told};
    if (!scene.empty()) words.push_back(file(scene));
    const auto otherwise = [&](const char* option, const std::string& value) {
        if (std::find(more.begin(), more.end(), option) == more.end()) words.insert(words.end(), {option, value});
    };
    otherwise("--size", "800x600");
    // It outlives any wait, which counts the processor time that the window had.
    otherwise("--exit-after", std::to_string(static_cast<int>(600 * patience)));
    if (const auto none = std::find(more.begin(), more.end(), ""); none != more.end())
        more.erase(std::prev(none), std::next(none));
    words.insert(words.end(), more.begin(), more.end());
    const int errors = ::open(file("out/errors").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    window_ = start(words, display_, {-1, errors});
    ::close(errors);
    const bool pictured = !scene.empty() && !std::filesystem::is_directory(file(scene));
    const char* drawn = pictured ? "frames" : "presents";
    ASSERT_TRUE(wait([&](const auto& s) { return s[drawn] >= 1; }, 60)) << "no first picture";
    settle();
}

void Desk::end_window() {
    ASSERT_FALSE(shares_) << "the window is the suite's";
    if (running()) settle();
    if (sanitized) close_window(window_, display_);
    end(window_);
    std::filesystem::remove(file("out/state.json"));
}

int Desk::run(const std::vector<std::string>& arguments, const std::string& display) {
    std::vector<std::string> words{SNELL_BIN "/snell"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return finish(start(words, display));
}

std::string Desk::bytes(const std::string& name) const { return bytes_of(file(name)); }

int Desk::shell(const std::string& command) const {
    return std::system(("cd '" + file(".") + "' && PATH=" SNELL_BIN ":$PATH " + command).c_str());
}

void Desk::limit_memory(std::size_t more) const {
    std::size_t pages = 0;
    std::ifstream("/proc/" + std::to_string(window_) + "/statm") >> pages;
    const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more;
    const rlimit limit{most, most};
    ASSERT_EQ(prlimit(window_, RLIMIT_AS, &limit, nullptr), 0);
}

bool Desk::running() const {
    siginfo_t ended{};
    return window_ > 0 && waitid(P_PID, static_cast<id_t>(window_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == 0;
}

bool Desk::alive() const { return window_ > 0 && waitpid(window_, nullptr, WNOHANG) == 0; }

nlohmann::json Desk::state() const {
    std::ifstream in(file("out/state.json"));
    return nlohmann::json::parse(in, nullptr, false);
}

bool Desk::wait(const std::function<bool(const nlohmann::json&)>& holds, double seconds) const {
    Deadline deadline(seconds, window_, server_);
    // The last look is after the end, since this process may have waited, too.
    std::string text;
    nlohmann::json now(nlohmann::json::value_t::discarded);
    for (bool last = false;; last = deadline.over()) {
        // Reading it as JSON takes longest.
        if (std::string read = bytes("out/state.json"); read != text) {
            now = nlohmann::json::parse(read, nullptr, false);
            text = std::move(read);
        }
        if (!now.is_discarded() && holds(now)) return true;
        if (last) return false;
        sleep(.01);
    }
}

void Desk::settle() const {
    static int questions = 0;
    const std::string question = std::to_string(++questions);
    ASSERT_TRUE(tell_windows(display_, [&] {
        const std::string target = file("out/state.json.ask");
        std::ofstream(target + "~") << question << '\n';
        std::filesystem::rename(target + "~", target);
    }));
    bool there = true;
    EXPECT_TRUE(wait([&](const auto& s) { return s.value("answered", "") == question || !(there = running()); }, 60))
        << "the window does not rest";
    EXPECT_TRUE(there) << "the window is gone";
}

int Desk::frames_of(const nlohmann::json& state) {
    return state["counters"]["frames"].get<int>() - state["nan"]["looks"].get<int>();
}

bool Desk::idle() const {
    settle();
    std::string last;
    Clock::time_point since;
    return wait([&](const auto&) {
        const std::string now = bytes("out/state.json");
        if (now != last) since = Clock::now();
        last = now;
        return Clock::now() > since + std::chrono::seconds(1);
    });
}

void Desk::user(const std::string& words) const {
    std::vector<std::string> list{"xdotool"};
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t stop = std::min(words.find(' ', begin), words.size());
        list.push_back(words.substr(begin, stop - begin));
        begin = stop + 1;
    }
    ASSERT_EQ(finish(start(list, display_)), 0) << words;
}

std::array<int, 2> Desk::on(const std::string& widget, double fraction) const {
    std::array<double, 4> rect{};
    const auto placed = [&](const nlohmann::json& s) {
        if (!s["widgets"].contains(widget)) return false;
        rect = s["widgets"][widget];
        return true;
    };
    EXPECT_TRUE(wait(placed)) << "no widget " << widget;
    return {static_cast<int>(rect[0] + rect[2] * fraction), static_cast<int>(rect[1] + rect[3] / 2)};
}

void Desk::click(std::array<int, 2> at, int button) const {
    user(move(at[0], at[1]) + " click " + std::to_string(button));
    settle();
}

void Desk::click(const std::string& widget, double fraction, int button) const { click(on(widget, fraction), button); }

void Desk::choose(const std::string& menu, const std::string& item) const {
    click("menu." + menu);
    click(item, .2);
    user("mousemove 2 2");  // or the tooltip of what lay beneath the menu stands in the picture a while later
}

void Desk::type(const std::string& widget, const std::string& text, Field field) const {
    const auto [x, y] = on(widget);
    // Not by a double click, whose second press may come too late on a busy machine: tests of clicks judge these.
    user(move(x, y) + (field == Field::number ? " keydown ctrl click 1 keyup ctrl" : " click 1"));
    settle();
    user("key ctrl+a");
    user("type --delay 8 " + text);
    if (field != Field::unconfirmed) user("key Return");
    settle();
}

void Desk::drag(std::array<int, 2> from, std::array<int, 2> to, int button) const {
    std::string words = move(from[0], from[1]) + " mousedown " + std::to_string(button);
    for (double part : {.25, .5, .75, 1.})
        words += " sleep .02 " + move(from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1]));
    user(words + " mouseup " + std::to_string(button));
    settle();
}

Picture Desk::look() const {
    Picture screen = screen_of(display_);
    EXPECT_FALSE(screen.rgb.empty()) << "no picture of the screen";
    return screen;
}

Picture Desk::read_picture(const std::string& name) const {
    return picture_of(output_of({"convert", file(name), "-depth", "8", "ppm:-"}, display_));
}

void Desk::keep(const std::string& name) const {
    const std::string folder = screens_folder();
    if (folder.empty()) return;
    const std::string window = output_of({"xdotool", "search", "--onlyvisible", "--name", "snell"}, display_);
    ASSERT_EQ(finish(start({"import", "-window", window.substr(0, window.find('\n')), "-depth", "8",
                            folder + "/" + name + ".png"},
                           display_)),
              0);
}

Pixel Desk::scene_pixel(int right, int down) const {
    const std::array<double, 4> scene = state()["scene"];
    return look().at(scene[0] + scene[2] / 2 + right, scene[1] + scene[3] / 2 + down);
}

}  // namespace snell::test
