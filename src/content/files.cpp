#include "src/content/files.h"

#include <fstream>
#include <utility>
#include <vector>

namespace snell::content {

namespace fs = std::filesystem;

// Not by recursive_directory_iterator: any error ends it.
std::error_code walk(const fs::path& folder, const Visit& visit) {
    std::error_code first;
    std::vector<std::pair<fs::path, int>> open{{folder, 0}};
    while (!open.empty()) {
        const auto [path, depth] = std::move(open.back());
        open.pop_back();
        std::error_code error, unknown;
        fs::directory_iterator entry(path, error), end;
        if (path == folder) first = error;
        for (; !error && entry != end; entry.increment(error)) {
            const fs::file_status status = entry->symlink_status(unknown);
            const Walk next = visit(entry->path(), status, depth);
            if (next == Walk::end) return first;
            if (next == Walk::on && fs::is_directory(status)) open.emplace_back(entry->path(), depth + 1);
        }
    }
    return first;
}

std::string whole_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text;
    for (std::size_t more = 1 << 16; file; more *= 2) {
        const std::size_t size = text.size();
        text.resize(size + more);
        file.read(&text[size], static_cast<std::streamsize>(more));
        text.resize(size + static_cast<std::size_t>(file.gcount()));
    }
    return text;
}

}  // namespace snell::content
