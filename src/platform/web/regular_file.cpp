// Files in memory: nothing replaces them meanwhile, and no link leads to what is open.
#include "src/content/regular_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace snell::content {

namespace fs = std::filesystem;

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
    if (fs::file_size(real, wrong) > limit) {
        error = larger_than(limit);
        return std::nullopt;
    }
    std::ifstream file(real, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace snell::content
