// Files that appear whole or not at all: written beside their place and then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace snell::content {

// A file that will take the place of another. A link stays one: what it leads to is replaced.
class Replacement {
public:
    explicit Replacement(const std::string& path);
    // Removes what was written unless it took its place.
    ~Replacement();
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    // What is wrong with the place itself, asked before any work; "" if nothing.
    std::string check() const;
    // Where to write.
    const std::filesystem::path& path() const { return path_; }
    // "" when done. The file keeps the permissions of the one that it replaces.
    std::string take_place();

private:
    std::filesystem::path target_, path_;
    bool kept_ = false;
};

// A new file that is written piece by piece. What went wrong first is said by all that follows.
class PartFile {
public:
    explicit PartFile(const std::filesystem::path& path);
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    // "" or why not: at the latest close() says it.
    std::string write(std::string_view bytes);
    std::string close();

private:
    int file_;
    std::string pending_, wrong_;
};

// "" or why not.
std::string write_file(const std::filesystem::path& path, std::string_view bytes);

// All of it: "" when the file has these bytes, else why it is as it was. Pipes, terminals and what is in /dev, such as
// /dev/stdout, are written to as they are.
std::string replace_file(const std::string& path, std::string_view bytes);

// Whether replace_file() would find its place as it should be, asked before any work: "" or why not.
std::string check_place(const std::string& path);

// It is written to as it is, so nothing that was there is lost.
bool is_stream(const std::string& path);

// Its bytes as they are now; none where it can't be read.
std::string whole_file(const std::string& path);

}  // namespace snell::content
