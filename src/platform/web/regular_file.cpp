// Files in memory: nothing replaces them meanwhile, and no link leads to what is open.
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

#include "src/content/files.h"
#include "src/content/mesh/mesh.h"
#include "src/content/workers.h"

namespace snell::content {

namespace fs = std::filesystem;

namespace {

// Not by a stream, which would bring a hundred kilobytes of locales into the page.
std::optional<std::string> bytes_of(const std::string& path, std::size_t size) {
    const int file = open(path.c_str(), O_RDONLY);
    if (file < 0) return std::nullopt;
    std::string bytes(size, '\0');
    const ssize_t count = read(file, bytes.data(), size);
    close(file);
    if (count != static_cast<ssize_t>(size)) return std::nullopt;
    return bytes;
}

}  // namespace

std::optional<std::string> read_regular_file(const std::string& path, std::uint64_t limit,
                                             const std::function<bool(const std::string& real_path)>& allowed,
                                             std::string& error) {
    std::error_code wrong;
    const fs::path real = fs::canonical(path, wrong);
    if (wrong) {
        error = wrong.message();
        return std::nullopt;
    }
    if (allowed && !allowed(real.string())) return std::nullopt;
    if (!fs::is_regular_file(real, wrong)) {
        error = fs::is_directory(real, wrong) ? "it is a folder" : "it is not a regular file";
        return std::nullopt;
    }
    const std::uintmax_t size = fs::file_size(real, wrong);
    if (size > limit) {
        error = larger_than(limit);
        return std::nullopt;
    }
    auto bytes = bytes_of(real.string(), static_cast<std::size_t>(size));
    if (!bytes) error = "it cannot be read";
    return bytes;
}

// A page has one thread: the caller does all.

std::size_t cores() { return 1; }

void work_beside(std::size_t, const std::function<void()>&, const std::function<void(std::size_t started)>& here) {
    here(0);
}

}  // namespace snell::content

// Parsers of meshes in a page.
namespace snell::content {

MeshResult parse_shp(std::string_view, const MeshLimits&) {
    MeshResult result;
    result.issues.push_back({true, "shp-in-a-page", "a page in a browser reads no shape files (.shp)",
                             "convert the file to .obj, or draw the scene with snell itself"});
    return result;
}

}  // namespace snell::content
