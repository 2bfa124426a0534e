#include "tests/cli/run.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "src/app/help/program.h"
#include "src/content/load_module.h"
#include "src/content/process.h"
#include "tests/sanitized.h"

namespace snell::test {

namespace {

using Words = std::vector<std::string>;

// A word that is a redirection: this, the descriptor's digit, and the file.
constexpr char redirected = '\1';

// The words of a command line; nothing where it takes a shell to read it.
std::optional<Words> words_of(const std::string& line) {
    Words words{""};
    bool inside = false;
    char quote = 0;
    const auto end_word = [&] {
        if (inside) words.emplace_back();
        inside = false;
    };
    for (const char c : line) {
        std::string& word = words.back();
        const bool file = inside && word.size() == 2 && word[0] == redirected;
        if (quote == '\''
                ? false
                : std::string_view(quote != 0 ? "$`\\" : "|&;()*?[~#$`\\\n").find(c) != std::string_view::npos)
            return std::nullopt;
        if (c == quote) {
            quote = 0;
        } else if (quote != 0) {
            word += c;
        } else if (c == '\'' || c == '"') {
            quote = c;
            inside = true;
        } else if (c == '>' || c == '<') {
            if (file) return std::nullopt;
            const char descriptor = c == '<' ? '0' : inside && word == "2" ? '2' : '1';
            if (descriptor == '2')
                word.clear();
            else
                end_word();
            words.back() = {redirected, descriptor};
            inside = true;
        } else if (c != ' ') {
            word += c;
            inside = true;
        } else if (!file) {
            end_word();
        }
    }
    if (quote != 0) return std::nullopt;
    end_word();
    words.pop_back();
    return words;
}

double seconds_of_children() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// What Mesa's software driver makes once for all, its functions of GLSL among it, lives as long as one context. This
// one is of another display than those of the program, whose threads copies would lack. Other drivers bear no copies.
void load_driver() {
    // If it is not loaded, libepoxy looks for it on the disk at each function that a copy calls for the first time.
    dlopen("libGL.so.1", RTLD_LAZY | RTLD_LOCAL);
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_query") ||
        !eglQueryDevicesEXT(devices.size(), devices.data(), &count))
        return;
    for (EGLint i = 0; i < count; ++i) {
        const EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
        const char* known = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
        if (!known || !std::strstr(known, "EGL_MESA_device_software")) continue;
        const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
        if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) continue;
        const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
        if (context == EGL_NO_CONTEXT) continue;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
        // Not by epoxy, which copies would find in a state that it can't be in.
        const auto create = reinterpret_cast<PFNGLCREATESHADERPROC>(eglGetProcAddress("glCreateShader"));
        const auto source = reinterpret_cast<PFNGLSHADERSOURCEPROC>(eglGetProcAddress("glShaderSource"));
        const auto compile = reinterpret_cast<PFNGLCOMPILESHADERPROC>(eglGetProcAddress("glCompileShader"));
        const char* text = "void main() {}";
        const GLuint shader = create(GL_VERTEX_SHADER);
        source(shader, 1, &text, nullptr);
        compile(shader);
        eglBindAPI(EGL_OPENGL_ES_API);  // as it is where a process begins, which copies believe to do
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        return;
    }
}

// In a copy: the folder, assignments, and the words of a command line.
int be_program(const Words& request) {
    if (chdir(request[0].c_str()) != 0) return -1;
    std::vector<const char*> words{"snell"};
    for (std::size_t i = 1; i < request.size(); ++i) {
        const std::string& word = request[i];
        if (word[0] == redirected) {
            const int to = word[1] - '0',
                      file = open(&word[2], to == 0 ? O_RDONLY : O_WRONLY | O_CREAT | O_TRUNC, 0666);
            if (file < 0) return -1;
            dup2(file, to);
        } else if (words.size() == 1 && word.starts_with("SNELL_")) {
            setenv(word.substr(0, word.find('=')).c_str(), &word[word.find('=') + 1], 1);
        } else {
            words.push_back(word.c_str());
        }
    }
    words.push_back(nullptr);
    return app::run(static_cast<int>(words.size()) - 1, words.data());
}

// Both ends of a pipe know how long a message is.
void send(int to, std::string_view text) {
    const std::size_t size = text.size();
    content::write_all(to, {reinterpret_cast<const char*>(&size), sizeof size});
    content::write_all(to, text);
}

bool receive(int from, char* bytes, std::size_t size) {
    for (ssize_t got = 0; size > 0; bytes += got, size -= static_cast<std::size_t>(got))
        if ((got = read(from, bytes, size)) <= 0) return false;
    return true;
}

bool receive(int from, std::string& text) {
    std::size_t size = 0;
    if (!receive(from, reinterpret_cast<char*>(&size), sizeof size)) return false;
    text.resize(size);
    return receive(from, text.data(), size);
}

// Whether a picture is read or written by OpenImageIO: loading it takes ten times as long as a small picture.
bool names_format(const Words& request) {
    return std::ranges::any_of(request, [](const std::string& word) {
        return std::ranges::any_of(std::array{".exr", ".pfm", ".hdr", ".jpg", ".tif"},
                                   [&](const char* ending) { return word.find(ending) != word.npos; });
    });
}

// A process that makes copies of itself, which are the program.
class Copies {
public:
    // Those that have loaded OpenImageIO, whose 260 libraries make each copy dearer, or the others.
    static Copies& all(bool formats) {
        static Copies plain(false), loaded(true);
        return formats ? loaded : plain;
    }

    Outcome run(const Words& request) {
        std::string text;
        for (const std::string& word : request) text += word + '\0';
        Outcome outcome;
        send(pipe_[0], text);
        if (!receive(pipe_[0], outcome.output)) throw std::runtime_error("no copy of the program can be made");
        receive(pipe_[0], reinterpret_cast<char*>(&ended_), sizeof ended_);
        outcome.status = ended_.status;
        return outcome;
    }
    double seconds() const { return ended_.seconds; }
    // Of all, so that what looks at times from outside sees those of copies.
    void end() const {
        close(pipe_[0]);
        waitpid(first_, nullptr, 0);
    }

private:
    struct Ended {
        int status = 0;
        double seconds = 0;  // of all copies
    };

    explicit Copies(bool formats) : formats_(formats) {
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pipe_.data()) != 0) return;
        std::fflush(nullptr);
        if ((first_ = fork()) != 0) {
            close(pipe_[1]);
            return;
        }
        close(pipe_[0]);
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        serve();
        _exit(0);
    }

    void serve() const {
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        bool loaded = false;
        for (std::string text; receive(pipe_[1], text);) {
            if (!std::exchange(loaded, true)) {
                load_driver();
                if (formats_) content::load_module("snell_oiio.so", "OpenImageIO");
            }
            Words request;
            for (std::size_t from = 0, to = 0; (to = text.find('\0', from)) != std::string::npos; from = to + 1)
                request.push_back(text.substr(from, to - from));
            content::Process copy;
            // What waits for ever, for example for a pipe, is ended.
            copy.start([&](std::string&) { return be_program(request); }, {.seconds = 300, .captured = true});
            const content::Ended ended = copy.wait();
            const Ended told{ended.signal != 0 ? 128 + ended.signal : ended.status, seconds_of_children()};
            send(pipe_[1], ended.output);
            content::write_all(pipe_[1], {reinterpret_cast<const char*>(&told), sizeof told});
        }
    }

    bool formats_;
    pid_t first_ = 0;
    std::array<int, 2> pipe_{};
    Ended ended_;
};

// Before any test has a context, whose threads copies would lack.
class Begun : public testing::Environment {
    void SetUp() override { Copies::all(false); }
    void TearDown() override {
        for (const bool formats : {true, false})
            Copies::all(formats).end();  // the last one holds the other's pipe, too
    }
};
[[maybe_unused]] const testing::Environment* const begun = testing::AddGlobalTestEnvironment(new Begun);

}  // namespace

Outcome run(const std::string& command) {
    Outcome outcome;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer{};
    for (size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) outcome.output.append(buffer.data(), n);
    outcome.status = WEXITSTATUS(pclose(pipe));
    return outcome;
}

Outcome snell(const std::string& arguments, const std::string& environment, const std::string& folder) {
    auto words = words_of(arguments);
    const auto before = words_of(environment);
    const bool own =
        before && std::ranges::all_of(*before, [](const auto& word) { return word.starts_with("SNELL_"); });
    // Sanitizers look at a program from its start to its end.
    if (!words || !own || patience > 1)
        return run("cd '" + folder + "' && env -u DISPLAY -u WAYLAND_DISPLAY " + environment + " " SNELL_BIN "/snell " +
                   arguments);
    words->insert(words->begin(), before->begin(), before->end());
    words->insert(words->begin(), folder);
    return Copies::all(names_format(*words)).run(*words);
}

double processor_seconds() {
    return seconds_of_children() + Copies::all(false).seconds() + Copies::all(true).seconds();
}

double cost_of(const std::string& arguments) {
    double best = 1e9;
    for (int i = 0; i < 3; ++i) {
        const double before = processor_seconds();
        snell(arguments, "MESA_SHADER_CACHE_DISABLE=true");
        best = std::min(best, processor_seconds() - before);
    }
    return best;
}

}  // namespace snell::test
