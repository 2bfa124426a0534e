// snell_piglit FOLDER EXCEPTIONS: the shaders of piglit that say whether a compiler must take them, through the
// translator, the driver's compiler and its linker. Prints what fails; 1 if anything fails that EXCEPTIONS does not
// name.
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <epoxy/gl.h>

#include "src/gl/context.h"
#include "src/gl/program.h"
#include "src/glsl/glsl.h"
#include "src/platform/headless.h"

namespace snell::piglit {
namespace {

namespace fs = std::filesystem;

struct Test {
    std::string path;  // below FOLDER
    Stage stage = Stage::vertex;
    std::string text;
    bool must_compile = false;
    bool whole = false;  // it is to be linked, too
    double version = 0;
    std::vector<std::string> extensions;

    bool generated() const { return path.starts_with("generated_tests/"); }
    bool of_two_stages() const { return stage == Stage::vertex || stage == Stage::fragment; }
};

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

std::optional<Stage> stage_of(const fs::path& file) {
    static const std::map<fs::path, Stage> stages = {{".vert", Stage::vertex},
                                                     {".frag", Stage::fragment},
                                                     {".geom", Stage::geometry},
                                                     {".tesc", Stage::tess_control},
                                                     {".tese", Stage::tess_evaluation}};
    const auto found = stages.find(file.extension());
    if (found == stages.end()) return std::nullopt;
    return found->second;
}

std::vector<std::string> words(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

// What a shader says of itself between [config] and [end config], in lines such as "// expect_result: pass".
std::optional<Test> read_test(const fs::path& folder, const fs::path& file) {
    const auto stage = stage_of(file);
    if (!stage) return std::nullopt;
    Test test{fs::relative(file, folder).string(), *stage, read(file), false, false, 0, {}};
    const std::size_t begin = test.text.find("[config]"), end = test.text.find("[end config]");
    if (begin == std::string::npos || end == std::string::npos) return std::nullopt;
    std::istringstream lines(test.text.substr(begin, end - begin));
    bool expects = false;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(':'), name = line.find_first_not_of(" */");
        if (colon == std::string::npos || name >= colon) continue;
        const std::string key = line.substr(name, colon - name), value = line.substr(colon + 1);
        const std::vector<std::string> values = words(value);
        if (values.empty()) continue;
        if (key == "expect_result") expects = true, test.must_compile = values[0] == "pass";
        if (key == "check_link") test.whole = values[0] == "true";
        if (key == "glsl_version") std::from_chars(values[0].data(), values[0].data() + values[0].size(), test.version);
        if (key == "require_extensions") test.extensions = values;
    }
    if (!expects) return std::nullopt;
    return test;
}

std::vector<Test> read_tests(const fs::path& folder) {
    std::vector<Test> tests;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (auto test = read_test(folder, entry.path())) tests.push_back(std::move(*test));
    std::ranges::sort(tests, {}, &Test::path);
    return tests;
}

GLenum gl_stage(Stage stage) {
    constexpr GLenum stages[] = {GL_VERTEX_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER,
                                 GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER};
    return stages[static_cast<std::size_t>(stage)];
}

// Why it can't be drawn with, in one line; empty if it can.
std::string refusal(const Test& test, const gl::Caps& caps) {
    Sources sources;
    Diagnostics diagnostics;
    glsl::Options options;
    options.target = {caps.glsl, caps.es, caps.fp64};
    const FileId file = sources.add(test.path, test.text);
    const glsl::Translation translation =
        glsl::translate({{test.stage, file, Span{file, 0, 1}}}, sources, options, diagnostics);
    if (!translation.ok) {
        const auto error = std::ranges::find(diagnostics.items(), Severity::error, &Diagnostic::severity);
        return "translation: " + error->message;
    }
    std::vector<gl::Shader> shaders;
    for (const glsl::StageOutput& stage : translation.stages) {
        gl::Compiled compiled = gl::compile(gl_stage(stage.stage), stage.text);
        if (!compiled.shader) return "compiler: " + compiled.log;
        shaders.push_back(std::move(compiled.shader));
    }
    // Parts of a program, to be linked with others that have main.
    if (test.text.find("main") == std::string::npos) return {};
    std::vector<const gl::Shader*> parts;
    for (const gl::Shader& shader : shaders) parts.push_back(&shader);
    gl::Linked linked = gl::link(parts, {});
    // So do these, unless they say that they are whole.
    const bool part = !test.whole && linked.log.find("unresolved reference to function") != std::string::npos;
    return linked.program || part ? std::string() : "linker: " + linked.log;
}

constexpr std::string_view skipped = "skipped";

std::set<std::string> extensions_there() {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    std::set<std::string> names;
    for (GLint n = 0; n < count; ++n)
        names.emplace(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(n))));
    return names;
}

std::string one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text.substr(0, 300);
}

// Writes a line for each test from `from` on: its refusal. A process of its own, since drivers may die.
[[noreturn]] void work(const std::vector<Test>& tests, std::size_t from, std::FILE* out) {
    std::string error;
    const auto context = HeadlessContext::make({.version = 45}, error);
    if (!context) {
        fmt::print(stderr, "no OpenGL 4.5 here: {}\n", error);
        _exit(3);
    }
    const gl::Caps caps = gl::query_caps();
    const std::set<std::string> extensions = extensions_there();
    for (std::size_t i = from; i < tests.size(); ++i) {
        alarm(60);
        const bool can = std::ranges::all_of(tests[i].extensions, [&](const std::string& name) {
            return name.starts_with('!') ? !extensions.contains(name.substr(1)) : extensions.contains(name);
        });
        fmt::print(out, "{}\n", can ? one_line(refusal(tests[i], caps)) : std::string(skipped));
        std::fflush(out);
    }
    _exit(0);
}

std::optional<std::vector<std::string>> run(const std::vector<Test>& tests) {
    std::vector<std::string> results;
    while (results.size() < tests.size()) {
        int ends[2];
        if (pipe(ends) != 0) return std::nullopt;
        const pid_t child = fork();
        if (child == 0) {
            close(ends[0]);
            work(tests, results.size(), fdopen(ends[1], "w"));
        }
        close(ends[1]);
        std::string all;
        char buffer[65536];
        for (ssize_t n = 0; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;)
            all.append(buffer, static_cast<std::size_t>(n));
        close(ends[0]);
        std::istringstream lines(all);
        for (std::string line; std::getline(lines, line);) results.push_back(line);
        int status = 0;
        waitpid(child, &status, 0);
        if (WIFEXITED(status) && WEXITSTATUS(status) != 0) return std::nullopt;
        if (WIFSIGNALED(status)) results.push_back(fmt::format("driver: signal {}", WTERMSIG(status)));
    }
    return results;
}

// Lines of "PATH: REASON"; a PATH that ends in * stands for all that begin so.
std::map<std::string, std::string> read_exceptions(const fs::path& file) {
    std::map<std::string, std::string> exceptions;
    std::istringstream lines(read(file));
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t colon = line.find(": "); !line.starts_with('#') && colon != std::string::npos)
            exceptions.emplace(line.substr(0, colon), line.substr(colon + 2));
    return exceptions;
}

struct Group {
    int tried = 0, taken = 0, excepted = 0;
};

std::string group_of(const Test& test) {
    return fmt::format("{}, {}{}{}", test.must_compile ? "must compile" : "must not compile",
                       test.generated() ? "generated" : "written",
                       test.of_two_stages() ? "" : ", geometry and tessellation",
                       test.extensions.empty() ? "" : ", with extensions");
}

// What is wrong with the results, to standard output; all that is other than expected, to the report.
class Judge {
public:
    Judge(const fs::path& exceptions, const fs::path& report)
        : exceptions_(read_exceptions(exceptions)), report_(report) {}

    void judge(const Test& test, const std::string& refusal) {
        if (refusal == skipped) return;
        Group& group = groups_[group_of(test)];
        ++group.tried;
        group.taken += refusal.empty() ? 1 : 0;
        if (refusal.empty() != test.must_compile)
            report_ << group_of(test) << ": " << test.path << ": " << refusal << "\n";
        if (refusal.empty() || !test.must_compile) return;
        if (const std::string name = exception(test.path); !name.empty()) {
            used_.insert(name);
            ++group.excepted;
        } else if (test.extensions.empty()) {  // extensions beyond OpenGL are nobody's duty
            fmt::print("{}: {}\n", test.path, refusal);
            ++failures_;
        }
    }

    int sum_up() {
        for (const auto& [name, reason] : exceptions_) {
            if (used_.contains(name)) continue;
            fmt::print("{}: is named as an exception and does not fail\n", name);
            ++failures_;
        }
        for (const auto& [name, group] : groups_)
            fmt::print("{}: {} of {} accepted{}\n", name, group.taken, group.tried,
                       group.excepted > 0 ? fmt::format(", {} named exceptions", group.excepted) : "");
        return failures_ == 0 ? 0 : 1;
    }

private:
    std::string exception(const std::string& path) const {
        const auto named = std::ranges::find_if(exceptions_, [&](const auto& e) {
            const std::string_view name = e.first;
            return name == path || (name.ends_with('*') && path.starts_with(name.substr(0, name.size() - 1)));
        });
        return named == exceptions_.end() ? std::string() : named->first;
    }

    std::map<std::string, std::string> exceptions_;
    std::set<std::string> used_;
    std::map<std::string, Group> groups_;
    std::ofstream report_;
    int failures_ = 0;
};

int check(const fs::path& folder, const fs::path& exceptions, const fs::path& report) {
    std::vector<Test> tests = read_tests(folder);
    std::erase_if(tests, [](const Test& t) { return t.version > 4.5; });
    if (tests.empty()) {
        fmt::print(stderr, "no shaders of piglit in {}\n", folder.string());
        return 3;
    }
    const auto results = run(tests);
    if (!results) return 3;
    Judge judge(exceptions, report);
    for (std::size_t i = 0; i < tests.size(); ++i) judge.judge(tests[i], (*results)[i]);
    return judge.sum_up();
}

}  // namespace
}  // namespace snell::piglit

int main(int argc, char** argv) {
    if (argc == 4) return snell::piglit::check(argv[1], argv[2], argv[3]);
    std::fprintf(stderr, "usage: snell_piglit FOLDER EXCEPTIONS REPORT\n");
    return 2;
}
