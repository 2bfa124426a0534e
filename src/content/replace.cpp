#include "src/content/replace.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <set>

#include "parser/text/number.h"
#include "src/content/files.h"
#include "src/content/process.h"

namespace snell::content {

namespace fs = std::filesystem;

fs::path without_links(const fs::path& path) {
    constexpr int most = 40;  // as Linux follows
    std::error_code error;
    fs::path target = path;
    for (int links = 0; fs::is_symlink(target, error); ++links) {
        if (links == most) return path;
        target = target.parent_path() / fs::read_symlink(target, error);
    }
    return target;
}

namespace {

// What this process has begun to write.
struct Begun {
    std::mutex mutex;
    std::multiset<fs::path> files;
    bool over = false;
};

Begun& begun() {
    static Begun files;
    // A child that is forked while another thread begins a file could not begin any, and has no right to the parent's.
    static const int watched = pthread_atfork([] { begun().mutex.lock(); }, [] { begun().mutex.unlock(); },
                                              [] {
                                                  begun().files.clear();
                                                  begun().mutex.unlock();
                                              });
    static_cast<void>(watched);
    return files;
}

void forget(const fs::path& file) {
    const std::scoped_lock lock(begun().mutex);
    if (const auto found = begun().files.find(file); found != begun().files.end()) begun().files.erase(found);
}

}  // namespace

Replacement::Replacement(const std::string& path)
    : target_(without_links(path)),
      path_(target_.parent_path() / ("." + target_.filename().string() + "." + std::to_string(getpid()) + ".part")) {
    const std::scoped_lock lock(begun().mutex);
    begun().files.insert(path_);
}

Replacement::~Replacement() {
    std::error_code error;
    if (!kept_) fs::remove(path_, error);
    forget(path_);
}

void abandon_replacements() {
    const std::scoped_lock lock(begun().mutex);
    begun().over = true;
    std::error_code error;
    for (const fs::path& file : begun().files) fs::remove(file, error);
}

std::string Replacement::check() const {
    std::error_code error;
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (fs::is_symlink(target_, error)) return target_.string() + ": " + std::strerror(ELOOP);
    if (!fs::is_directory(folder, error)) return "there is no folder " + folder.string();
    if (!fs::exists(target_, error))
        return access(folder.c_str(), W_OK) == 0
                   ? ""
                   : (target_.has_parent_path() ? folder : target_).string() + ": " + std::strerror(errno);
    if (!fs::is_regular_file(target_, error)) return target_.string() + " is not a regular file";
    for (const fs::path& written : {target_, folder})  // a file is replaced, not opened
        if (access(written.c_str(), W_OK) != 0) return target_.string() + ": " + std::strerror(errno);
    return "";
}

std::string Replacement::take_place() {
    std::error_code error;
    const fs::file_status old = fs::status(target_, error);
    if (fs::is_regular_file(old)) fs::permissions(path_, old.permissions(), error);
    fs::rename(path_, target_, error);
    kept_ = !error;
    return error ? target_.string() + ": " + error.message() : "";
}

// Terminals and pipes cannot be replaced. A file that is open already, such as standard output, is written to directly
// to keep its offset.
bool is_stream(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    for (const char* descriptor : {"/dev/std", "/dev/fd/", "/proc/self/fd/"})
        if (path.rfind(descriptor, 0) == 0) return fs::exists(status);
    return fs::is_fifo(status) || fs::is_character_file(status) || fs::is_block_file(status);
}

std::string check_place(const std::string& path) {
    if (!is_stream(path)) {
        const Replacement place(path);
        if (std::string wrong = place.check(); !wrong.empty()) return wrong;
        // Not every folder takes files although its permissions allow it: /proc does not.
        const std::string wrong = write_file(place.path(), {});
        return wrong.empty() ? "" : path + ": " + wrong;
    }
    return access(path.c_str(), W_OK) == 0 ? "" : path + ": " + std::strerror(errno);
}

namespace {

// A descriptor of this process is written to where it stands, so that whoever shares it goes on behind what is written.
int open_stream(const std::string& path) {
    std::string_view number;
    if (path == "/dev/stdout") number = "1";
    if (path == "/dev/stderr") number = "2";
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"})
        if (path.starts_with(folder)) number = std::string_view(path).substr(folder.size());
    const auto descriptor = read_whole<int>(number);
    if (!descriptor) return open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    std::fflush(nullptr);  // what was printed before
    return fcntl(*descriptor, F_DUPFD_CLOEXEC, 0);
}

// A link that exists under the temporary name is removed, not followed.
int new_file(const fs::path& path) {
    const std::scoped_lock lock(begun().mutex);
    if (begun().over) return errno = ECANCELED, -1;
    unlink(path.c_str());
    return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

std::string write_and_close(int file, std::string_view bytes) {
    if (file < 0) return std::strerror(errno);
    std::string wrong = write_all(file, bytes);
    if (close(file) != 0 && wrong.empty()) wrong = std::strerror(errno);
    return wrong;
}

// True if the file system cannot reserve room ahead of time, which does not mean that there is none.
bool reserves_nothing(int error) { return error == EOPNOTSUPP || error == EINVAL || error == EBADF; }

// In place of everything that the file holds.
std::string overwrite(int file, std::string_view bytes) {
    if (lseek(file, 0, SEEK_SET) < 0) return std::strerror(errno);
    std::string wrong = write_all(file, bytes);
    if (wrong.empty() && ftruncate(file, static_cast<off_t>(bytes.size())) != 0) wrong = std::strerror(errno);
    return wrong;
}

// How new bytes get into the place of a file.
enum class Place { renamed, written };

std::string put_file(const std::string& path, std::string_view bytes, Place place) {
    if (is_stream(path)) {
        const std::string wrong = write_and_close(open_stream(path), bytes);
        return wrong.empty() ? "" : path + ": " + wrong;
    }
    Replacement replacement(path);
    if (std::string wrong = replacement.check(); !wrong.empty()) return wrong;
    if (const std::string wrong = write_file(replacement.path(), bytes); !wrong.empty()) return path + ": " + wrong;
    return place == Place::renamed ? replacement.take_place() : replacement.write_through(bytes);
}

}  // namespace

std::string Replacement::write_through(std::string_view bytes) {
    forget(path_);  // it is the only whole copy until the target is written
    // Where the file system reserves no room, the C library reads the file to do so.
    const int file = open(target_.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) return target_.string() + ": " + std::strerror(errno);
    const auto size = static_cast<off_t>(bytes.size());
    const std::string old = content::whole_file(target_.string());
    const off_t before = lseek(file, 0, SEEK_END);
    // A full disk is noticed before anything is overwritten.
    const int error = before < 0 ? errno : size > before ? posix_fallocate(file, 0, size) : 0;
    if (error != 0 && (before < 0 || !reserves_nothing(error))) {
        [[maybe_unused]] const int shortened = before < 0 ? 0 : ftruncate(file, before);
        close(file);
        return target_.string() + ": " + std::strerror(error);
    }
    std::string wrong = overwrite(file, bytes);
    const bool damaged = !wrong.empty() && (static_cast<off_t>(old.size()) != before || !overwrite(file, old).empty());
    const bool unsure = close(file) != 0;  // some file systems write only now
    if (unsure && wrong.empty()) wrong = std::strerror(errno);
    if (wrong.empty()) return "";
    kept_ = damaged || unsure;
    return target_.string() + ": " + wrong + (kept_ ? "; the new text is in " + path_.string() : "");
}

PartFile::PartFile(const fs::path& path) : file_(new_file(path)) {
    if (file_ < 0) wrong_ = std::strerror(errno);
}

PartFile::~PartFile() {
    if (file_ >= 0) ::close(file_);
}

std::string PartFile::write(std::string_view bytes) {
    constexpr std::size_t piece = std::size_t{1} << 20;
    pending_ += bytes;
    if (!wrong_.empty()) pending_.clear();
    if (pending_.size() < piece) return wrong_;
    wrong_ = write_all(file_, pending_);
    pending_.clear();
    return wrong_;
}

std::string PartFile::close() {
    if (file_ < 0) return wrong_;
    if (wrong_.empty()) wrong_ = write_all(file_, pending_);
    if (::close(file_) != 0 && wrong_.empty()) wrong_ = std::strerror(errno);
    file_ = -1;
    return wrong_;
}

std::string write_file(const fs::path& path, std::string_view bytes) { return write_and_close(new_file(path), bytes); }

std::string replace_file(const std::string& path, std::string_view bytes) {
    return put_file(path, bytes, Place::renamed);
}

std::string rewrite_file(const std::string& path, std::string_view bytes) {
    std::error_code error;
    const auto names = fs::hard_link_count(without_links(path), error);
    return put_file(path, bytes, !error && names > 1 ? Place::written : Place::renamed);
}

}  // namespace snell::content
