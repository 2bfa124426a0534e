#include "src/plan/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "parser/diagnostic.h"

namespace snell {
namespace {

namespace fs = std::filesystem;

// Folders with more entries are not searched to the end.
constexpr std::size_t max_entries = 100'000;

bool is_regular(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

bool is_folder(const std::string& path) {
    struct stat status {};
    return stat(path.empty() ? "." : path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return result;
}

std::string join(std::string_view folder, std::string_view name) {
    if (folder.empty()) return std::string(name);
    std::string result(folder);
    if (result.back() != '/') result += '/';
    return result += name;
}

// Names in a folder, sorted so that the choice among several never depends on the file system.
std::vector<std::string> list(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator it(folder.empty() ? "." : folder, error), end; !error && it != end;
         it.increment(error)) {
        names.push_back(it->path().filename().string());
        if (names.size() == max_entries) break;
    }
    std::sort(names.begin(), names.end());
    return names;
}

// A name as a path: '/' only, no empty or "." components, no blanks or quotes around it.
std::string tidy(std::string_view name) {
    while (!name.empty() && std::isspace(static_cast<unsigned char>(name.front())) != 0) name.remove_prefix(1);
    while (!name.empty() && std::isspace(static_cast<unsigned char>(name.back())) != 0) name.remove_suffix(1);
    if (name.size() > 1 && name.front() == name.back() && (name.front() == '"' || name.front() == '\'')) {
        name = name.substr(1, name.size() - 2);
    }
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    std::string result = !slashed.empty() && slashed[0] == '/' ? "/" : "";
    for (std::size_t at = 0; at <= slashed.size();) {
        const std::size_t end = std::min(slashed.find('/', at), slashed.size());
        const std::string_view part(slashed.data() + at, end - at);
        if (!part.empty() && part != ".") result = join(result, part);
        at = end + 1;
    }
    return result;
}

bool has_drive(std::string_view name) {
    return name.size() > 1 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
}

bool is_absolute(std::string_view name) { return (!name.empty() && name[0] == '/') || has_drive(name); }

std::string_view last_component(std::string_view name) { return name.substr(name.rfind('/') + 1); }

// The file (or folder) that `rest` leads to from `folder` without regard to case; empty when there is none.
std::string match_case(const std::string& folder, std::string_view rest, bool want_folder) {
    const std::size_t slash = rest.find('/');
    const std::string part(rest.substr(0, slash));
    const bool last = slash == std::string_view::npos;
    const auto follow = [&](const std::string& entry) -> std::string {
        const std::string path = join(folder, entry);
        if (last) return (want_folder ? is_folder(path) : is_regular(path)) ? path : "";
        return is_folder(path) ? match_case(path, rest.substr(slash + 1), want_folder) : "";
    };
    if (std::string found = follow(part); !found.empty() || part == "..") return found;
    const std::string wanted = lower(part);
    for (const std::string& entry : list(folder)) {
        if (entry == part || lower(entry) != wanted) continue;
        if (std::string found = follow(entry); !found.empty()) return found;
    }
    return {};
}

// The entry of the name's folder that is most like its last component; "" when nothing is like it.
std::string most_similar(const std::string& base, const std::string& name) {
    const std::string_view file = last_component(name);
    std::string_view where(name.data(), name.size() - file.size());
    while (!where.empty() && where.back() == '/' && where.size() > 1) where.remove_suffix(1);
    const std::string folder =
        where.empty() ? base : (is_absolute(where) ? std::string(where) : match_case(base, where, true));
    if (folder.empty() && !where.empty()) return {};

    std::vector<std::string> names;
    for (std::string& entry : list(folder)) {
        if (is_regular(join(folder, entry))) names.push_back(std::move(entry));
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    std::string best(nearest(file, candidates));
    if (best.empty()) {  // the same name with another extension is worth naming, however far by letters
        const std::string stem = lower(file.substr(0, file.rfind('.')));
        const auto same = std::find_if(names.begin(), names.end(), [&](const std::string& entry) {
            return !stem.empty() && lower(entry.substr(0, entry.rfind('.'))) == stem;
        });
        if (same != names.end()) best = *same;
    }
    return best.empty() ? best : join(where, best);
}

std::string find_case(const std::string& base, const std::string& name) {
    return is_absolute(name) ? std::string() : match_case(base, name, false);
}

}  // namespace

Resolved Files::resolve(std::string_view written, const std::vector<std::string_view>& extensions) const {
    const std::string name = tidy(written);
    if (name.empty() || name.find('\0') != std::string::npos) return {};
    const auto at = [&](const std::string& relative) {
        return is_absolute(relative) && !has_drive(relative) ? relative : join(folder_, relative);
    };
    if (std::string path = at(name); is_regular(path)) return {std::move(path), false, {}};
    if (std::string path = find_case(folder_, name); !path.empty()) return {std::move(path), true, {}};
    for (const std::string_view extension : extensions) {
        const std::string longer = name + (name.back() == '.' ? "" : ".") + std::string(extension);
        if (std::string path = at(longer); is_regular(path)) return {std::move(path), true, {}};
        if (std::string path = find_case(folder_, longer); !path.empty()) return {std::move(path), true, {}};
    }
    // Written on another machine, or before the files were gathered in one folder.
    if (const std::string file(last_component(name)); file != name && file != ".." && !has_drive(file)) {
        if (Resolved here = resolve(file, extensions); !here.path.empty()) return {here.path, true, {}};
    }
    return {{}, false, most_similar(folder_, name)};
}

Resolved Files::resolve_beside(std::string_view from, std::string_view name,
                               const std::vector<std::string_view>& extensions) const {
    const std::size_t slash = from.rfind('/');
    const std::string folder(slash == std::string_view::npos ? "" : from.substr(0, slash + 1));
    Resolved beside = Files(folder).resolve(name, extensions);
    return beside.path.empty() ? resolve(name, extensions) : beside;
}

namespace {

class Descriptor {
public:
    explicit Descriptor(const std::string& path)
        : fd_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {}
    ~Descriptor() {
        if (fd_ >= 0) close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }

private:
    int fd_;
};

std::string_view kind_of(const struct stat& status) {
    if (S_ISDIR(status.st_mode)) return "it is a folder";
    if (S_ISFIFO(status.st_mode)) return "it is a pipe, not a file";
    if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return "it is a device, not a file";
    if (S_ISSOCK(status.st_mode)) return "it is a socket, not a file";
    return "it is not a regular file";
}

std::string reason(int error) { return std::generic_category().message(error); }

bool acceptable(const struct stat& status, std::string& error) {
    if (!S_ISREG(status.st_mode)) {
        error = kind_of(status);
        return false;
    }
    if (status.st_size > 0 && static_cast<std::uint64_t>(status.st_size) > Files::size_limit) {
        error = "it is larger than 2 GiB";
        return false;
    }
    return true;
}

bool read_all(int fd, std::size_t expected, std::string& bytes, std::string& error) {
    // One byte more than expected, so that the end is seen without growing.
    bytes.resize(expected + 1);
    std::size_t size = 0;
    for (;;) {
        if (size == bytes.size()) bytes.resize(bytes.size() * 2);
        const ssize_t got = ::read(fd, bytes.data() + size, bytes.size() - size);
        if (got == 0) break;
        if (got < 0) {
            if (errno == EINTR) continue;
            error = reason(errno);
            return false;
        }
        size += static_cast<std::size_t>(got);
        if (size > Files::size_limit) {
            error = "it is larger than 2 GiB";
            return false;
        }
    }
    bytes.resize(size);
    return true;
}

}  // namespace

std::optional<std::string> Files::read(const std::string& path, std::string& error) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) {
        error = reason(errno);
        return std::nullopt;
    }
    if (!acceptable(status, error)) return std::nullopt;
    const Descriptor file(path);
    if (file.get() < 0 || fstat(file.get(), &status) != 0) {
        error = reason(errno);
        return std::nullopt;
    }
    if (!acceptable(status, error)) return std::nullopt;  // it may have been exchanged meanwhile
    std::string bytes;
    if (!read_all(file.get(), static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)), bytes, error)) {
        return std::nullopt;
    }
    keep(path);
    const std::scoped_lock lock(mutex_);
    ++counters_.opened;
    counters_.bytes += bytes.size();
    return bytes;
}

void Files::keep(const std::string& path) {
    const std::scoped_lock lock(mutex_);
    if (std::find(read_paths_.begin(), read_paths_.end(), path) == read_paths_.end()) read_paths_.push_back(path);
}

FileCounters Files::counters() const {
    const std::scoped_lock lock(mutex_);
    return counters_;
}

std::vector<std::string> Files::read_paths() const {
    const std::scoped_lock lock(mutex_);
    return read_paths_;
}

}  // namespace snell
