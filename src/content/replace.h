// Files that appear whole or not at all: they are written under a temporary name in the same folder and then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace snell::content {

// Follows the link that `path` may be to the file that would be written, which need not exist yet. Returns a link if
// links lead in a circle.
std::filesystem::path without_links(const std::filesystem::path& path);

// A file that will replace another one. If the path is a link, the file that it points to is replaced.
class Replacement {
public:
    explicit Replacement(const std::string& path);
    // Removes the temporary file unless it has replaced the target.
    ~Replacement();
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    // Checks before any work whether the target can be replaced; returns "" or what prevents it.
    std::string check() const;
    // The temporary file, to write to.
    const std::filesystem::path& path() const { return path_; }
    // Replaces the target and keeps its permissions. Returns "" or what went wrong.
    std::string take_place();
    // Writes the same bytes into the target itself. Returns "" or what went wrong, after which the target has its old
    // bytes again. Where those cannot be written either, the temporary file stays.
    std::string write_through(std::string_view bytes);

private:
    std::filesystem::path target_, path_;
    bool kept_ = false;
};

// Removes the temporary files of all replacements that are not in place, and lets no other begin: for a process that
// is about to end while its threads go on.
void abandon_replacements();

// A new file that is written piece by piece. After an error, every call returns that first error.
class PartFile {
public:
    explicit PartFile(const std::filesystem::path& path);
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    // Both return "" or the error. Writing is buffered, so an error may only appear at close().
    std::string write(std::string_view bytes);
    std::string close();

private:
    int file_;
    std::string pending_, wrong_;
};

// Writes a file; returns "" or the error.
std::string write_file(const std::filesystem::path& path, std::string_view bytes);

// Replaces a file by one with these bytes; returns "", or the error, after which the file is unchanged. Pipes,
// devices and open files, such as /dev/stdout, are written to directly.
std::string replace_file(const std::string& path, std::string_view bytes);

// As replace_file(), for files that are edited: one that has several names (hard links) keeps them, because it is
// written in place.
std::string rewrite_file(const std::string& path, std::string_view bytes);

// Checks, before any work, whether replace_file() could write there, by making its temporary file. Returns an empty
// string, or why not.
std::string check_place(const std::string& path);

// True for devices, pipes and open files, which are written to directly, so that nothing in them is lost.
bool is_stream(const std::string& path);

}  // namespace snell::content
